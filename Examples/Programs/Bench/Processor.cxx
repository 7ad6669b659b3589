// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sections.h"
#include "Stage.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainDetailSource.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainMinMaxPyramid.h"
#include "vtkTerrainStrips.h"

#include <benchmark/benchmark.h>

#include <functional>
#include <map>

namespace
{
/// Keeps what Google Benchmark measures instead of printing it.
class Keeper : public benchmark::BenchmarkReporter
{
public:
  struct Kept
  {
    double Milliseconds = 0.0;
    double Items = 0.0; ///< in a second; 0 if not counted
    double Indices = 0.0;
  };

  bool ReportContext(const Context&) override
  {
    return true;
  }
  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs)
    {
      Kept& kept = this->Results[run.run_name.function_name];
      kept.Milliseconds = 1e3 * run.real_accumulated_time /
        static_cast<double>(std::max<std::int64_t>(run.iterations, 1));
      const auto items = run.counters.find("items_per_second");
      kept.Items = items == run.counters.end() ? 0.0 : items->second.value;
      const auto indices = run.counters.find("indices");
      kept.Indices = indices == run.counters.end() ? 0.0 : indices->second.value;
    }
  }

  std::map<std::string, Kept> Results;
};

std::string Named(const char* what, int side)
{
  return std::string(what) + ", " + std::to_string(side) + "²";
}

/// Registers work that is done anew each time.
void Register(const std::string& name, double seconds, const std::function<void()>& work)
{
  benchmark::RegisterBenchmark(name.c_str(),
    [work](benchmark::State& state)
    {
      for (auto _ : state)
      {
        (void)_;
        work();
      }
    })
    ->MinTime(seconds)
    ->Unit(benchmark::kMillisecond);
}

/// Registers the refinement of strips for the views of a flight: pure, or with everything.
void RegisterStrips(const std::string& name, double seconds,
  const vtkSmartPointer<vtkTerrainStrips>& strips, vtkImageData* heights)
{
  benchmark::RegisterBenchmark(name.c_str(),
    [strips, heights](benchmark::State& state)
    {
      const vtkNew<vtkCamera> camera;
      double part = 0.0;
      double triangles = 0.0;
      double indices = 0.0;
      for (auto _ : state)
      {
        (void)_;
        part += 0.01;
        Look(camera, OnFlight(heights, part));
        camera->SetClippingRange(1.0, 1e6);
        strips->SetCamera(camera);
        strips->Modified();
        strips->Update();
        triangles += static_cast<double>(strips->GetNumberOfTriangles());
        indices +=
          static_cast<double>(strips->GetOutput()->GetStrips()->GetNumberOfConnectivityIds());
      }
      state.counters["indices"] = indices / std::max(triangles, 1.0);
      state.SetItemsProcessed(static_cast<std::int64_t>(triangles));
    })
    ->MinTime(seconds)
    ->Unit(benchmark::kMillisecond);
}

vtkSmartPointer<vtkTerrainStrips> MakeStrips(
  vtkTerrainHierarchy* hierarchy, bool everything, vtkImageData* detail)
{
  auto strips = vtkSmartPointer<vtkTerrainStrips>::New();
  strips->SetHierarchy(hierarchy);
  strips->SetViewportSize(640, 480);
  strips->SetTolerance(1.0);
  strips->SetMorphing(everything);
  strips->SetCulling(
    everything ? vtkTerrainStrips::CullingMode::Nested : vtkTerrainStrips::CullingMode::Off);
  strips->SetNormals(everything);
  if (detail)
  {
    strips->SetDetailData(detail);
    strips->SetDetailCells(8);
  }
  return strips;
}

Table BaloghTable(const Keeper& keeper, int side)
{
  Table table;
  table.Title = "Balogh: triangles in a second";
  table.Caption =
    "Strips of a pixel's tolerance along the recorded flight, one thread, by the clock, with "
    "VTK's arrays filled. Balogh, section 8.5: AMD Athlon XP 1800+, 1533 MHz.";
  table.Header = { "refinement", "millions a second", "theirs", "indices a triangle" };
  const auto add = [&](const char* name, const char* theirs)
  {
    const auto found = keeper.Results.find(Named(name, side));
    if (found != keeper.Results.end())
    {
      table.Rows.push_back({ found->first, Digits(1e-6 * found->second.Items), theirs,
        Digits(found->second.Indices) });
    }
  };
  add("strips, pure refinement", "9");
  add("strips, morphed, culled, normals", "-");
  add("strips, everything and detail", "2.3");
  return table;
}

void RegisterAllStrips(const Plan& plan, int side)
{
  const vtkSmartPointer<vtkImageData> heights = MakeLandscape(side);
  const vtkNew<vtkTerrainHierarchy> hierarchy;
  hierarchy->SetHeights(heights);
  const vtkNew<vtkTerrainDetailSource> detail;
  detail->Update();
  RegisterStrips(Named("strips, pure refinement", side), plan.Seconds,
    MakeStrips(hierarchy, false, nullptr), heights);
  RegisterStrips(Named("strips, morphed, culled, normals", side), plan.Seconds,
    MakeStrips(hierarchy, true, nullptr), heights);
  RegisterStrips(Named("strips, everything and detail", side), plan.Seconds,
    MakeStrips(hierarchy, true, detail->GetOutput()), heights);
}

void RegisterPreparations(const Plan& plan, int side)
{
  const vtkSmartPointer<vtkImageData> heights = MakeLandscape(side);
  Register(Named("min-max pyramid", side), plan.Seconds,
    [heights]
    {
      const vtkNew<vtkTerrainMinMaxPyramid> pyramid;
      pyramid->SetInputData(heights);
      pyramid->Update();
    });
  Register(Named("coarse mesh", side), plan.Seconds,
    [heights]
    {
      const vtkNew<vtkTerrainCoarseMesh> mesh;
      mesh->SetInputData(heights);
      mesh->Update();
    });
  Register(Named("hierarchy of strips", side), plan.Seconds,
    [heights]
    {
      const vtkNew<vtkTerrainHierarchy> prepared;
      prepared->SetHeights(heights);
    });
}
}

//------------------------------------------------------------------------------
Section MeasureProcessor(const Plan& plan)
{
  Section section;
  section.Title = "Work of the processor (Balogh, and preparations)";
  section.Text =
    "András Balogh, Real-time Visualization of Detailed Terrain. Measured by Google Benchmark.";
  const int stripSide = SidesOf(plan, { 1025 }).back();
  RegisterAllStrips(plan, stripSide);

  const std::vector<int> sides = SidesOf(plan, { 257, 1025, 4097 });
  for (const int side : sides)
  {
    RegisterPreparations(plan, side);
  }
  Keeper keeper;
  benchmark::RunSpecifiedBenchmarks(&keeper);
  section.Tables.push_back(BaloghTable(keeper, stripSide));

  Plot plot;
  plot.Title = "Preparations";
  plot.Caption = "All threads, by the clock.";
  plot.XLabel = "samples along a side";
  plot.YLabel = "ms";
  for (const char* what : { "min-max pyramid", "coarse mesh", "hierarchy of strips" })
  {
    Series series;
    series.Name = what;
    for (const int side : sides)
    {
      series.Points.emplace_back(side, keeper.Results[Named(what, side)].Milliseconds);
    }
    plot.Curves.push_back(series);
  }
  section.Plots.push_back(plot);
  return section;
}
