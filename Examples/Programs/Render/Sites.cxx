// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sites.h"

#include "ColorBy.h"
#include "Draping.h"
#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "PolygonLayer.h"
#include "Progress.h"
#include "Statistics.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkRenderer.h"
#include "vtkTerrainColors.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

namespace
{
std::string FileName(const std::string& path)
{
  return std::filesystem::path(path).filename().string();
}

Terrain PrepareSite(
  int site, const PlacedHeights& heights, const Options& options, ProgressBar& progress)
{
  Options own = options;
  own.Input.Part = std::to_string(site);
  Statistics unused;
  const ReadHeightsResult read = ReadHeights(own, false, progress, unused);
  PlacedHeights placed = heights;
  placed.Image = PlaceBeside(heights, read.Image, own, progress);
  placed.Colors = ReadColorSource(placed, own, unused);
  return PrepareTerrain(
    { placed.Image, nullptr }, heights.Exaggeration, placed.Colors, own, progress, unused);
}

/// One table, and one legend, for what all terrains show: over all their values, or of the classes
/// of all; nothing where each has its own.
void ShareColors(
  std::vector<Terrain>& sites, Terrain& terrain, const ColorSource& colors, const Options& options)
{
  if (options.Colors.AreOfEach())
  {
    return;
  }
  std::array<double, 2> range = { terrain.Key.Table->GetRange()[0],
    terrain.Key.Table->GetRange()[1] };
  std::vector<LegendClass>& classes = terrain.Key.Classes;
  for (const Terrain& site : sites)
  {
    const double* own = site.Key.Table->GetRange();
    range = { std::min(range[0], own[0]), std::max(range[1], own[1]) };
    for (const LegendClass& one : site.Key.Classes)
    {
      const auto known = std::find_if(classes.begin(), classes.end(),
        [&one](const LegendClass& other) { return other.Name == one.Name; });
      if (known == classes.end())
      {
        classes.push_back(one);
      }
      else
      {
        known->Count += one.Count;
      }
    }
  }
  if (!colors.AreClasses)
  {
    terrain.Key.Table = colors.Colors->MakeTable(range[0], range[1]);
  }
  terrain.Actor->SetLookupTable(terrain.Key.Table);
  for (const Terrain& site : sites)
  {
    site.Actor->SetLookupTable(terrain.Key.Table);
  }
}

/// Frames the site that covers most where the others would make a speck of it; says so.
std::string FrameOne(const ReadHeightsResult& read, const Options& options, Terrain& terrain)
{
  constexpr double kSpeck = 0.1; // of the diagonal of all
  const bool isSpeck =
    terrain.Framed.GetDiagonalLength() < kSpeck * terrain.Bounds.GetDiagonalLength();
  const bool isChosen = options.View || !options.Place.LookFrom.empty();
  if (!isSpeck || isChosen)
  {
    terrain.Framed = terrain.Bounds;
    return {};
  }
  return "; too far for one view, which shows number " + std::to_string(read.Site) +
    " (--look-from and --look-at show another, --camera all)";
}

void WarnOf(const std::string& text, const Options& options, Statistics& statistics)
{
  Warn(HeightsName(options) + ": " + text);
  statistics.AddText("warnings", text);
}
}

//------------------------------------------------------------------------------
std::vector<Terrain> PrepareSites(const ReadHeightsResult& read, PlacedHeights& heights,
  const Options& options, Terrain& terrain, ProgressBar& progress, Statistics& statistics)
{
  std::vector<Terrain> sites;
  for (int site = 1; site <= read.Sites; ++site)
  {
    if (site == read.Site)
    {
      continue;
    }
    try
    {
      sites.push_back(PrepareSite(site, heights, options, progress));
      heights.Sites.emplace_back(sites.back().Actor->GetHeights());
      sites.back().Name = "site " + std::to_string(site);
      terrain.Bounds.AddBox(sites.back().Bounds);
      std::array<double, 2> range{};
      sites.back().Actor->GetHeightRange(range.data());
      terrain.OtherHeights = { std::min(terrain.OtherHeights[0], range[0]),
        std::max(terrain.OtherHeights[1], range[1]) };
    }
    catch (const Failure& failure)
    {
      WarnOf("its site " + std::to_string(site) + " is not in the picture (--part " +
          std::to_string(site) + " draws it alone): " + failure.what(),
        options, statistics);
    }
  }
  if (read.Sites > 1)
  {
    statistics.SetCount("sites", static_cast<std::int64_t>(sites.size()) + 1);
    WarnOf("its tiles lie at " + std::to_string(read.Sites) +
        " sites far from each other, a terrain each (--part N, from 1 to " +
        std::to_string(read.Sites) + ", draws one alone)" + FrameOne(read, options, terrain),
      options, statistics);
    ShareColors(sites, terrain, heights.Colors, options);
    terrain.Name = "site " + std::to_string(read.Site);
  }
  return sites;
}

//------------------------------------------------------------------------------
std::vector<Terrain> PrepareFiner(const PlacedHeights& heights, const Options& options,
  Terrain& terrain, ProgressBar& progress, Statistics& statistics)
{
  std::vector<Terrain> finer;
  for (std::size_t k = 0; k < heights.Finer.size(); ++k)
  {
    vtkImageData* image = heights.Finer[k];
    Statistics unused;
    PlacedHeights placed = heights;
    placed.Image = image;
    placed.Colors = ReadColorSource(placed, options, unused);
    finer.push_back(PrepareTerrain(
      { placed.Image, nullptr }, heights.Exaggeration, placed.Colors, options, progress, unused));
    finer.back().Name = FileName(heights.FinerNames[k]);
    DrapePicture(finer.back(), placed, {}, options, unused);
    terrain.Bounds.AddBox(finer.back().Bounds);
    std::array<double, 2> range{};
    finer.back().Actor->GetHeightRange(range.data());
    terrain.OtherHeights = { std::min(terrain.OtherHeights[0], range[0]),
      std::max(terrain.OtherHeights[1], range[1]) };
  }
  if (!finer.empty())
  {
    statistics.SetCount("finer_rasters", static_cast<std::int64_t>(finer.size()));
    ShareColors(finer, terrain, heights.Colors, options);
    terrain.Name = FileName(HeightsName(options));
  }
  return finer;
}

//------------------------------------------------------------------------------
void AddSites(const std::vector<Terrain>& sites, vtkRenderer* renderer, const Options& options)
{
  for (const Terrain& site : sites)
  {
    renderer->AddActor(site.Actor);
    if (site.Walls)
    {
      renderer->AddActor(site.Walls);
    }
    Statistics unused;
    RefineTerrain(site, renderer, options, unused);
  }
}
