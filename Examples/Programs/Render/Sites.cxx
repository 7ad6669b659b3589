// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sites.h"

#include "Draping.h"
#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "Progress.h"
#include "Statistics.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <array>
#include <string>

namespace
{
Terrain PrepareSite(
  int site, const PlacedHeights& heights, const Options& options, ProgressBar& progress)
{
  Options own = options;
  own.Input.Part = std::to_string(site);
  Statistics unused;
  const ReadHeightsResult read = ReadHeights(own, false, progress, unused);
  const vtkSmartPointer<vtkImageData> placed = PlaceBeside(heights, read.Image, own, progress);
  return PrepareTerrain({ placed, nullptr }, heights.Exaggeration, own, progress, unused);
}

/// The colours of the first where some are asked for, else those of a relief over all heights.
void ShareColors(const std::vector<Terrain>& sites, const Terrain& terrain, const Options& options)
{
  vtkScalarsToColors* table = terrain.Actor->GetLookupTable();
  vtkSmartPointer<vtkScalarsToColors> relief;
  if (!options.Colors.IsGiven())
  {
    std::array<double, 2> range{};
    terrain.Actor->GetHeightRange(range.data());
    for (const Terrain& site : sites)
    {
      std::array<double, 2> own{};
      site.Actor->GetHeightRange(own.data());
      range = { std::min(range[0], own[0]), std::max(range[1], own[1]) };
    }
    relief = vtkTerrainActor::MakeReliefColors(range[0], range[1]);
    table = relief;
    terrain.Actor->SetLookupTable(table);
  }
  for (const Terrain& site : sites)
  {
    site.Actor->SetLookupTable(table);
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
    " (--camera shows all)";
}

void WarnOf(const std::string& text, const Options& options, Statistics& statistics)
{
  Warn(HeightsName(options) + ": " + text);
  statistics.AddText("warnings", text);
}
}

//------------------------------------------------------------------------------
std::vector<Terrain> PrepareSites(const ReadHeightsResult& read, const PlacedHeights& heights,
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
    ShareColors(sites, terrain, options);
  }
  return sites;
}

//------------------------------------------------------------------------------
std::vector<Terrain> PrepareFiner(const PlacedHeights& heights, const Options& options,
  Terrain& terrain, ProgressBar& progress, Statistics& statistics)
{
  std::vector<Terrain> finer;
  for (vtkImageData* image : heights.Finer)
  {
    Statistics unused;
    finer.push_back(
      PrepareTerrain({ image, nullptr }, heights.Exaggeration, options, progress, unused));
    PlacedHeights placed = heights;
    placed.Image = image;
    DrapePicture(finer.back(), placed, options, unused);
    terrain.Bounds.AddBox(finer.back().Bounds);
    std::array<double, 2> range{};
    finer.back().Actor->GetHeightRange(range.data());
    terrain.OtherHeights = { std::min(terrain.OtherHeights[0], range[0]),
      std::max(terrain.OtherHeights[1], range[1]) };
  }
  if (!finer.empty())
  {
    statistics.SetCount("finer_rasters", static_cast<std::int64_t>(finer.size()));
    ShareColors(finer, terrain, options);
  }
  return finer;
}

//------------------------------------------------------------------------------
void AddSites(const std::vector<Terrain>& sites, vtkRenderer* renderer, const Options& options)
{
  for (const Terrain& site : sites)
  {
    renderer->AddActor(site.Actor);
    Statistics unused;
    RefineTerrain(site, renderer, options, unused);
  }
}
