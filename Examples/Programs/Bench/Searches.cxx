// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sections.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkImageData.h"

#include <algorithm>
#include <map>

namespace
{
/// Least and greatest of the four views.
struct Result
{
  std::vector<double> Milliseconds;
  Agreement Worst;
};

std::string SideText(int side)
{
  return std::to_string(side) + "²";
}

/// A picture's depths by the exact technique, for each view.
std::vector<vtkSmartPointer<vtkImageData>> ExactDepths(
  Stage& stage, vtkImageData* heights, const std::vector<View>& views)
{
  std::vector<vtkSmartPointer<vtkImageData>> depths;
  stage.Show(MakeActor("pyramid", heights));
  for (const View& view : views)
  {
    stage.Look(view);
    depths.push_back(stage.Depths());
  }
  return depths;
}

Result MeasureTechnique(Stage& stage, vtkImageData* heights, const std::string& technique,
  const std::vector<vtkSmartPointer<vtkImageData>>& exact, int frames)
{
  Result result;
  stage.Show(MakeActor(technique, heights));
  const std::vector<View> views = FixedViews(heights);
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    stage.Look(views[i]);
    result.Milliseconds.push_back(stage.Draw(frames).Median);
    const Agreement agreement = Compare(stage.Depths(), exact[i]);
    result.Worst.MissedPercent = std::max(result.Worst.MissedPercent, agreement.MissedPercent);
    result.Worst.WrongPercent = std::max(result.Worst.WrongPercent, agreement.WrongPercent);
  }
  return result;
}

std::vector<std::string> RowOf(int side, const std::string& technique, const Result& result)
{
  std::vector<std::string> row{ SideText(side), technique };
  for (const double milliseconds : result.Milliseconds)
  {
    row.push_back(Digits(milliseconds));
  }
  const bool searches = technique.rfind("coarse", 0) != 0;
  row.push_back(searches ? Digits(result.Worst.MissedPercent) : "-");
  row.push_back(searches ? Digits(result.Worst.WrongPercent) : "-");
  return row;
}

Table PaperTable()
{
  Table table;
  table.Title = "Fehér's table 2";
  table.Caption = "Milliseconds a frame, 640 x 480 pixels, least and greatest of four views; "
                  "equidistant steps below a coarse mesh, NVIDIA GeForce 8400 M and 8800 GT.";
  table.Header = { "heights", "mesh", "8400 M", "8800 GT" };
  table.Rows = { { "257²", "32²", "9.52 to 18.87", "0.55 to 0.80" },
    { "2049²", "32²", "9.62 to 20", "0.55 to 0.83" },
    { "2049²", "256²", "22.22 to 41.67", "3.70 to 3.82" } };
  return table;
}

const std::vector<std::string>& Techniques()
{
  static const std::vector<std::string> names{ "coarse 32", "coarse 256", "linear", "exponential",
    "equidistant", "equidistant, paper's 32", "equidistant, paper's 256", "pyramid" };
  return names;
}

Table MeasureSize(const Plan& plan, int width, int height, std::map<std::string, Series>* growth)
{
  Table table;
  table.Title = "Here, " + std::to_string(width) + " x " + std::to_string(height);
  table.Caption = "Milliseconds a frame in four views. Missed: percent of the surface's pixels "
                  "where there is none, "
                  "or one in vain; wrong: percent of them more than a thousandth of their distance "
                  "off; both in the "
                  "worst view, against the technique pyramid. coarse N: N x N quads with lights, "
                  "without search: what "
                  "drawing costs at least. The paper's N: its steps for a mesh of N x N quads. All "
                  "searches begin "
                  "where the min-max pyramid lets the surface be; so they need no mesh.";
  table.Header = { "heights", "technique", "oblique", "fly", "walk", "down", "missed %",
    "wrong %" };
  Stage stage(width, height);
  for (const int side : SidesOf(plan, { 257, 513, 1025, 2049, 4097, 8193, 16385 }))
  {
    const vtkSmartPointer<vtkImageData> heights = MakeLandscape(side);
    const auto exact = ExactDepths(stage, heights, FixedViews(heights));
    for (const std::string& technique : Techniques())
    {
      const Result result = MeasureTechnique(stage, heights, technique, exact, plan.Frames);
      const bool isListed = side == 257 || side == 2049 || side == plan.Largest || plan.IsSmoke;
      if (isListed)
      {
        table.Rows.push_back(RowOf(side, technique, result));
      }
      Series& series = (*growth)[technique];
      series.Name = technique;
      double sum = 0.0;
      for (const double milliseconds : result.Milliseconds)
      {
        sum += milliseconds;
      }
      series.Points.emplace_back(side, sum / static_cast<double>(result.Milliseconds.size()));
    }
    stage.Show(nullptr);
  }
  return table;
}
}

//------------------------------------------------------------------------------
std::vector<int> SidesOf(const Plan& plan, const std::vector<int>& sides)
{
  if (plan.IsSmoke)
  {
    return { 65, 129 };
  }
  std::vector<int> result;
  std::copy_if(sides.begin(), sides.end(), std::back_inserter(result),
    [&plan](int side) { return side <= plan.Largest; });
  return result;
}

//------------------------------------------------------------------------------
Section MeasureSearches(const Plan& plan)
{
  Section section;
  section.Title = "Searches (Fehér)";
  section.Text =
    "Zsolt Fehér, Terrain Rendering with the Combination of Mesh Simplification and "
    "Displacement Mapping. His claim: the time of a frame does not depend on the size of "
    "the heightmap.";
  section.Tables.push_back(PaperTable());
  const std::vector<std::pair<int, int>> sizes = plan.IsSmoke
    ? std::vector<std::pair<int, int>>{ { 64, 48 } }
    : std::vector<std::pair<int, int>>{ { 640, 480 }, { 1920, 1080 } };
  for (const auto& [width, height] : sizes)
  {
    std::map<std::string, Series> growth;
    section.Tables.push_back(MeasureSize(plan, width, height, &growth));
    Plot plot;
    plot.Title = "Time against samples, " + std::to_string(width) + " x " + std::to_string(height);
    plot.Caption = "Mean of the four views.";
    plot.XLabel = "samples along a side";
    plot.YLabel = "ms a frame";
    for (const std::string& technique : Techniques())
    {
      plot.Curves.push_back(growth[technique]);
    }
    section.Plots.push_back(plot);
  }
  return section;
}
