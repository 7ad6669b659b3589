// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sections.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkGreedyTerrainDecimation.h"
#include "vtkImageData.h"
#include "vtkImageDataGeometryFilter.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkQuadricLODActor.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainActor.h"
#include "vtkWarpScalar.h"

#include <functional>

namespace
{
/// A window of which so many frames a second are asked, as while one moves. vtkQuadricLODActor asks
/// the interactor of its window, which it needs.
class Moving
{
public:
  Moving(vtkRenderWindow* window, double rate)
    : Window(window)
    , Before(window->GetDesiredUpdateRate())
  {
    this->Interactor->SetDesiredUpdateRate(rate);
    this->Interactor->SetRenderWindow(window);
    window->SetDesiredUpdateRate(rate);
  }
  ~Moving()
  {
    this->Window->SetInteractor(nullptr);
    this->Window->SetDesiredUpdateRate(this->Before);
  }
  Moving(const Moving&) = delete;
  Moving& operator=(const Moving&) = delete;

private:
  vtkRenderWindow* Window;
  double Before;
  vtkNew<vtkGenericRenderWindowInteractor> Interactor;
};

/// The surface as VTK's own filters make it: every cell two triangles.
vtkSmartPointer<vtkPolyData> FullMesh(vtkImageData* heights)
{
  const vtkNew<vtkImageDataGeometryFilter> geometry;
  geometry->SetInputData(heights);
  const vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(geometry->GetOutputPort());
  warp->SetNormal(0.0, 0.0, 1.0);
  warp->UseNormalOn();
  warp->Update();
  return vtkPolyData::SafeDownCast(warp->GetOutput());
}

/// Triangles within an error of heights, by vtkGreedyTerrainDecimation.
vtkSmartPointer<vtkPolyData> GreedyMesh(vtkImageData* heights, double error)
{
  const vtkNew<vtkGreedyTerrainDecimation> decimation;
  decimation->SetInputData(heights);
  decimation->SetErrorMeasureToAbsoluteError();
  decimation->SetAbsoluteError(error);
  decimation->ComputeNormalsOn();
  decimation->Update();
  return decimation->GetOutput();
}

vtkSmartPointer<vtkProp> ActorOf(vtkPolyData* mesh)
{
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

/// The full mesh with a coarse stand-in, which VTK draws where a frame has less time than it takes.
vtkSmartPointer<vtkProp> LODActorOf(vtkPolyData* mesh)
{
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkQuadricLODActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

/// Adds a row: from the heights in memory to the first picture, later frames, memory.
void AddRow(Table& table, Stage& stage, vtkImageData* heights, int frames, const std::string& name,
  const std::function<vtkSmartPointer<vtkProp>(double&)>& make)
{
  double mebibytes = 0.0;
  const Stopwatch watch;
  const vtkSmartPointer<vtkProp> prop = make(mebibytes);
  stage.Show(prop);
  const std::vector<View> views = FixedViews(heights);
  stage.Look(views[0]);
  stage.GetRenderer()->GetRenderWindow()->Render();
  const double first = watch.Milliseconds();
  std::vector<std::string> row{ name, Digits(first) };
  for (const View& view : views)
  {
    stage.Look(view);
    row.push_back(Digits(stage.Draw(frames).Median));
  }
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    if (auto* mapper = vtkOpenGLTerrainMapper::SafeDownCast(actor->GetMapper()))
    {
      mebibytes = static_cast<double>(mapper->GetTextureMemorySize()) / 1048576.0;
    }
  }
  row.push_back(Digits(mebibytes));
  table.Rows.push_back(row);
  stage.Show(nullptr);
}

double Mebibytes(vtkPolyData* mesh)
{
  return static_cast<double>(mesh->GetActualMemorySize()) / 1024.0;
}
}

//------------------------------------------------------------------------------
Section MeasureToday(const Plan& plan)
{
  Section section;
  section.Title = "VTK today";
  section.Text = "The same heights by what VTK has without this module. The error of "
                 "vtkGreedyTerrainDecimation, 5 m, is that of a pixel 4 km away, at 640 x 480. "
                 "vtkQuadricLODActor draws a coarse mesh of unknown error while one moves.";
  const int side = SidesOf(plan, { 1025 }).back();
  const vtkSmartPointer<vtkImageData> heights = MakeLandscape(side);
  Table table;
  table.Title = std::to_string(side) + "² heights";
  table.Caption =
    "First: milliseconds by the clock from the heights in memory to the first picture. "
    "Then milliseconds a frame in four views. Memory: MiB of polygons, or of textures.";
  table.Header = { "what", "first", "oblique", "fly", "walk", "down", "MiB" };
  Stage stage(plan.IsSmoke ? 64 : 640, plan.IsSmoke ? 48 : 480);
  const auto add = [&](const std::string& name, const auto& make)
  { AddRow(table, stage, heights, plan.Frames, name, make); };
  add("full mesh (vtkWarpScalar)",
    [&](double& mebibytes)
    {
      const vtkSmartPointer<vtkPolyData> mesh = FullMesh(heights);
      mebibytes = Mebibytes(mesh);
      return ActorOf(mesh);
    });
  {
    const Moving moving(stage.GetRenderer()->GetRenderWindow(), 30.0);
    add("vtkQuadricLODActor, 30 frames a second asked",
      [&](double& mebibytes)
      {
        const vtkSmartPointer<vtkPolyData> mesh = FullMesh(heights);
        mebibytes = Mebibytes(mesh);
        return LODActorOf(mesh);
      });
  }
  add("vtkGreedyTerrainDecimation, 5 m",
    [&](double& mebibytes)
    {
      const vtkSmartPointer<vtkPolyData> mesh = GreedyMesh(heights, 5.0);
      mebibytes = Mebibytes(mesh);
      return ActorOf(mesh);
    });
  add("vtkTerrainActor (pyramid)",
    [&](double&)
    {
      auto actor = vtkSmartPointer<vtkTerrainActor>::New();
      actor->SetInputData(heights);
      return vtkSmartPointer<vtkProp>(actor);
    });
  section.Tables.push_back(table);
  return section;
}

//------------------------------------------------------------------------------
Section MeasureGrowth(const Plan& plan)
{
  Section section;
  section.Title = "Growth with pixels";
  section.Text =
    "Frames of one landscape in pictures of several sizes, oblique view. Growth with samples "
    "is plotted with the searches.";
  const int side = SidesOf(plan, { 1025, 4097 }).back();
  const vtkSmartPointer<vtkImageData> heights = MakeLandscape(side);
  Plot plot;
  plot.Title = "Time against pixels, " + std::to_string(side) + "² heights";
  plot.Caption = "Oblique view.";
  plot.XLabel = "pixels";
  plot.YLabel = "ms a frame";
  for (const char* technique : { "coarse 32", "linear", "exponential", "equidistant", "pyramid" })
  {
    Series series;
    series.Name = technique;
    for (const int width : { 64, 320, 640, 1280, 1920 })
    {
      if (plan.IsSmoke && width > 64)
      {
        break;
      }
      Stage stage(width, width * 3 / 4);
      stage.Show(MakeActor(technique, heights));
      stage.Look(FixedViews(heights)[0]);
      series.Points.emplace_back(stage.GetPixels(), stage.Draw(plan.Frames).Median);
    }
    plot.Curves.push_back(series);
  }
  section.Plots.push_back(plot);
  return section;
}
