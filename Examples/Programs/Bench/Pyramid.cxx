// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sections.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainStrips.h"

#include <algorithm>
#include <functional>

namespace
{
/// The paper's row for a side of samples: preprocessing, ours fly / walk, full mesh, mesh with LOD.
struct PaperRow
{
  int Side;
  const char* Preprocessing;
  const char* FlyWalk;
  const char* Full;
  const char* Levels;
};

constexpr std::array<PaperRow, 6> kPaper{ { { 256, "0.6", "105~115 / 66~99", "250~285", "290~340" },
  { 512, "1.8", "53~75 / 47~56", "75~83", "180~230" },
  { 1024, "4.0", "40~44 / 37~40", "19~22", "75~80" },
  { 2048, "8.1", "58~98 / 54~85", "overflow", "37~41" },
  { 4096, "17.5", "40~82 / 37~80", "overflow", "6~14" },
  { 8192, "36.0", "32~67 / 30~45", "overflow", "overflow" } } };

/// Largest side of which the full mesh is drawn.
constexpr int kLargestMesh = 4096;

/// Frames a second over a way: least and greatest. `prepare` runs before each frame and returns the
/// milliseconds that it took.
std::string FramesASecond(Stage& stage, vtkImageData* heights, Way way, int frames,
  const std::function<double(const View&)>& prepare)
{
  std::vector<double> times;
  for (int frame = 0; frame < frames; ++frame)
  {
    const View view = way(heights, frame / static_cast<double>(frames));
    const double before = prepare(view);
    stage.Look(view);
    times.push_back(before + stage.Draw());
  }
  const Times summary = Summarize(times);
  return Digits(1e3 / summary.Longest) + "~" + Digits(1e3 / summary.Shortest);
}

std::string FlyAndWalk(
  Stage& stage, vtkImageData* heights, const std::string& technique, int frames)
{
  const auto nothing = [](const View&) { return 0.0; };
  stage.Show(MakeActor(technique, heights));
  const std::string fly = FramesASecond(stage, heights, OnFlight, frames, nothing);
  return fly + " / " + FramesASecond(stage, heights, OnWalk, frames, nothing);
}

/// Strips of a pixel's tolerance, refined for each frame.
std::string FlyStrips(Stage& stage, vtkImageData* heights, int frames)
{
  const vtkNew<vtkTerrainHierarchy> hierarchy;
  if (!hierarchy->SetHeights(heights))
  {
    return hierarchy->GetErrorMessage();
  }
  const vtkNew<vtkTerrainStrips> strips;
  strips->SetHierarchy(hierarchy);
  strips->SetTolerance(1.0);
  strips->NormalsOn();
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(strips->GetOutputPort());
  const vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Show(actor);
  const vtkNew<vtkCamera> camera;
  const auto refine = [&](const View& view)
  {
    const Stopwatch watch;
    Look(camera, view);
    camera->SetClippingRange(1.0, 1e6);
    strips->SetCamera(camera);
    strips->SetViewportSize(640, 480);
    strips->Update();
    return watch.Milliseconds();
  };
  return FramesASecond(stage, heights, OnFlight, frames, refine);
}

/// From heights in memory to the first picture, by the clock, when the programs are there already:
/// what makes and uploads heights, slopes and pyramid.
double PreparationSeconds(Stage& stage, vtkImageData* heights)
{
  stage.Show(MakeActor("pyramid", heights));
  stage.Look(FixedViews(heights)[0]);
  const Stopwatch watch;
  stage.GetRenderer()->GetRenderWindow()->Render();
  return 1e-3 * watch.Milliseconds();
}

/// How many rays visited how many nodes on a way.
std::vector<double> CountNodes(Stage& stage, vtkImageData* heights, Way way, int frames)
{
  const vtkSmartPointer<vtkActor> actor = MakeActor("pyramid", heights);
  auto* mapper = vtkOpenGLTerrainMapper::SafeDownCast(actor->GetMapper());
  mapper->SetComputeMode(vtkOpenGLTerrainMapper::ComputeModes::On);
  stage.Show(actor);
  std::vector<double> counts;
  for (int frame = 0; frame < frames; ++frame)
  {
    stage.Look(way(heights, frame / static_cast<double>(frames)));
    stage.Draw();
    const vtkSmartPointer<vtkImageData> nodes = mapper->ReadCrossings();
    const vtkIdType pixels = nodes ? nodes->GetNumberOfPoints() : 0;
    const auto* values = nodes ? static_cast<const int*>(nodes->GetScalarPointer()) : nullptr;
    for (vtkIdType i = 0; i < pixels; ++i)
    {
      const auto value = static_cast<std::size_t>(std::max(values[i], 0));
      counts.resize(std::max(counts.size(), value + 1));
      counts[value] += values[i] > 0 ? 1.0 : 0.0; // others are beside the terrain
    }
  }
  return counts;
}

/// Percent of the rays that visit so many nodes at most.
Series Cumulated(const std::string& name, const std::vector<double>& counts)
{
  Series series;
  series.Name = name;
  double sum = 0.0;
  for (const double count : counts)
  {
    sum += count;
  }
  double within = 0.0;
  for (std::size_t nodes = 0; nodes < counts.size() && sum > 0.0; ++nodes)
  {
    within += counts[nodes];
    series.Points.emplace_back(static_cast<double>(nodes), 100.0 * within / sum);
  }
  return series;
}

std::string PercentWithin(const Series& series, std::size_t nodes)
{
  return series.Points.empty()
    ? "-"
    : Digits(series.Points[std::min(nodes, series.Points.size() - 1)].second);
}

void AddSpectrum(const Plan& plan, Stage& stage, Section& section)
{
  Table table;
  table.Title = "Nodes that rays visit";
  table.Caption =
    "Percent of the rays, with beams. Park and Oh (figure 13): flying, 90 % within 16; "
    "walking, 85 to 90 % within 35, 5 % over 85.";
  table.Header = { "heights", "within 16", "within 35", "within 85" };
  Plot plot;
  plot.Title = table.Title;
  plot.Caption = "Percent of the rays that visit no more.";
  plot.XLabel = "nodes";
  plot.YLabel = "percent";
  plot.IsXLogarithmic = false;
  plot.IsYLogarithmic = false;
  for (const int side : SidesOf(plan, { 1024, 4096 }))
  {
    const vtkSmartPointer<vtkImageData> heights = MakeLandscape(side);
    for (const bool walks : { false, true })
    {
      const std::string name = std::to_string(side) + "², " + (walks ? "walk" : "flight");
      const Series series = Cumulated(
        name, CountNodes(stage, heights, walks ? OnWalk : OnFlight, std::min(plan.Frames, 8)));
      table.Rows.push_back(
        { name, PercentWithin(series, 16), PercentWithin(series, 35), PercentWithin(series, 85) });
      plot.Curves.push_back(series);
    }
  }
  section.Tables.push_back(table);
  section.Plots.push_back(plot);
}

Table MeasureTable(const Plan& plan, Stage& stage)
{
  Table table;
  table.Title = "Park and Oh's table 1, and here";
  table.Caption =
    "Frames a second along a recorded flight and a recorded walk, least and greatest. Theirs: "
    "DirectX 9, ATI 2900, 2.33 GHz Intel processor. Preprocessing: seconds from heights in memory "
    "to the first picture, min-max pyramid included, programs not. Strips, of a pixel's tolerance, "
    "stand for their LOD; refined on one thread for each frame, whose clock is counted.";
  table.Header = { "heights", "prep. s", "theirs", "fly / walk", "theirs", "columns",
    "full mesh, fly", "theirs", "strips, fly", "theirs, LOD" };
  for (const int side : SidesOf(plan, { 256, 512, 1024, 2048, 4096, 8192, 16384 }))
  {
    const vtkSmartPointer<vtkImageData> heights = MakeLandscape(side);
    PaperRow paper{ side, "-", "-", "-", "-" };
    for (const PaperRow& row : kPaper)
    {
      paper = row.Side == side ? row : paper;
    }
    const int frames = 2 * plan.Frames;
    const auto nothing = [](const View&) { return 0.0; };
    std::string full = "-";
    if (side <= kLargestMesh)
    {
      stage.Show(MakeActor("full mesh", heights));
      full = FramesASecond(stage, heights, OnFlight, std::min(frames, 4), nothing);
    }
    const std::string strips = side <= kLargestMesh ? FlyStrips(stage, heights, frames) : "-";
    const std::string pyramid = FlyAndWalk(stage, heights, "pyramid", frames);
    const double seconds = PreparationSeconds(stage, heights);
    table.Rows.push_back(
      { std::to_string(side) + "²", Digits(seconds), paper.Preprocessing, pyramid, paper.FlyWalk,
        FlyAndWalk(stage, heights, "columns", frames), full, paper.Full, strips, paper.Levels });
    stage.Show(nullptr);
  }
  return table;
}
}

//------------------------------------------------------------------------------
Section MeasurePyramid(const Plan& plan)
{
  Section section;
  section.Title = "Pyramid (Park and Oh)";
  section.Text = "Sunyoung Park, Kyongsu Oh, GPU-only Terrain Rendering for Walk-through.";
  Stage stage(plan.IsSmoke ? 64 : 640, plan.IsSmoke ? 48 : 480);
  section.Tables.push_back(MeasureTable(plan, stage));
  AddSpectrum(plan, stage, section);
  return section;
}
