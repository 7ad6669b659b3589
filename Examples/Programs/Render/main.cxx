// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * terrain-render: a file of heights to a picture. What it does is told by --help; its exit status
 * is 0, 2 for a wrong command line, 1 otherwise, with one line on stderr and no output left behind.
 */
#include "Annotations.h"
#include "Canvas.h"
#include "ColorBy.h"
#include "Day.h"
#include "Draping.h"
#include "Ending.h"
#include "Failure.h"
#include "Flight.h"
#include "Messages.h"
#include "Misses.h"
#include "Options.h"
#include "Outputs.h"
#include "Placing.h"
#include "PolygonLayer.h"
#include "Progress.h"
#include "Scenery.h"
#include "ShownHeights.h"
#include "Sites.h"
#include "Statistics.h"
#include "Terrain.h"
#include "View.h"
#include "ViewMarks.h"
#include "Water.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainActor.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace
{
/// Reads the heights and brings them into the scene, with the tiles of which they are a level.
std::pair<ReadHeightsResult, PlacedHeights> ReadAndPlace(
  Options& options, ProgressBar& progress, Statistics& statistics)
{
  ReadHeightsResult read = ReadHeights(options, CanDrawTiles(options), progress, statistics);
  PlacedHeights heights = PlaceHeights(read.Image, options, progress, statistics);
  if (!options.View && options.Place.LookFrom.empty() && !heights.IsGlobe())
  {
    options.Exaggeration.TellIfOdd(read.Image, heights.Factor);
  }
  options.Exaggeration.Text = FactorText(heights.Factor); // chosen and told once
  if (read.Tiles && heights.Image != read.Image)
  {
    // resampled: tiles lie elsewhere, and the finest level that fits is drawn
    read = ReadHeights(options, false, progress, statistics);
    heights = PlaceHeights(read.Image, options, progress, statistics);
  }
  heights.Colors = ReadColorSource(heights, options, statistics);
  options.Legend = options.Legend == kUsualLegend ? heights.Colors.Title : options.Legend;
  if (heights.Factor != 1.0 && !options.Legend.empty())
  {
    options.Legend += " (drawn \xC3\x97 " + FactorText(heights.Factor) + ")"; // the sign for times
  }
  return { read, heights };
}

/// What cannot be written is said before the work, not after it.
void CheckOutputs(const Options& options)
{
  const bool isOne = options.Light.GetSuns().size() <= 1 && !options.Flight.IsWanted();
  const std::string film = IsFilm(options.Output) ? options.Output : std::string();
  for (const std::string& path :
    { isOne ? options.Output : film, options.Depth, options.Stats, options.SaveScene })
  {
    const PendingFile file(path);
  }
}

/// The scene as it is drawn.
struct Stage
{
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  const Terrain& Ground;
  const PlacedHeights& Heights;
};

/// Draws the numbers and depths that are asked for beside a picture.
void WriteMeasures(const Stage& stage, Canvas& canvas, const Options& options,
  const PendingFile& depth, const PendingFile& stats, Statistics& statistics)
{
  CountMisses(stage.Ground, options, canvas, statistics);
  if (depth.IsWanted())
  {
    WriteDepths(canvas.DrawDepths(stage.Ground.Actor, stage.Ground.Walls), depth);
  }
  if (stats.IsWanted())
  {
    if (!canvas.IsTiled())
    {
      CountCrossings(stage.Ground, stage.Window, statistics);
    }
    WriteText(statistics.ToJson(), stats);
  }
}

/// Draws the picture or the pictures, and all other outputs.
void DrawOutputs(const Stage& stage, ViewMarks& marks, const Options& options,
  const Stopwatch& watch, Statistics& statistics)
{
  const bool severalSuns = options.Light.GetSuns().size() > 1;
  const bool isOne = !severalSuns && !options.Flight.IsWanted();
  const PendingFile picture(isOne ? options.Output : std::string());
  const PendingFile depth(options.Depth);
  const PendingFile stats(options.Stats);
  const PendingFile scene(options.SaveScene);
  Canvas canvas(stage.Window, stage.Renderer, options);
  const vtkSmartPointer<vtkImageData> drawn = canvas.DrawFrames(statistics);
  if (options.Flight.IsWanted())
  {
    DrawFlight({ stage.Renderer, canvas, marks, stage.Ground, stage.Heights }, options, statistics);
  }
  DescribeTerrain(stage.Ground, stage.Heights.Image, stage.Heights.IsGlobe(), statistics);
  statistics.AddTime("total", watch.GetMilliseconds());
  if (severalSuns)
  {
    DrawSuns(canvas, stage.Renderer, stage.Heights, options);
  }
  else if (isOne)
  {
    WritePicture(drawn, options.Dots, picture);
  }
  WriteMeasures(stage, canvas, options, depth, stats, statistics);
  if (scene.IsWanted())
  {
    WriteText(options.SceneText, scene);
  }
  ThrowOnError(options.Output);
  for (const PendingFile* file : { &depth, &stats, &scene, &picture })
  {
    file->Commit();
  }
  if (isOne)
  {
    TellName(options.Output);
  }
}

/// The box of a terrain, down to the floor of its block.
ScaledBox BoxOf(const Terrain& terrain, const PlacedHeights& heights, const Options& options)
{
  ScaledBox box;
  terrain.Bounds.GetBounds(box.Bounds.data());
  box.Heights = HeightRange(terrain.Actor, heights.Image);
  const double base = heights.Image->GetOrigin()[2];
  box.Heights = { std::min(base + box.Heights[0] - options.Surface.Block, terrain.OtherHeights[0]),
    std::max(base + box.Heights[1], terrain.OtherHeights[1]) };
  return box;
}

/// Colours of heights, where those of the terrain show something else.
vtkSmartPointer<vtkScalarsToColors> MakeReliefColors(
  const Terrain& terrain, const PlacedHeights& heights)
{
  const std::array<double, 2> range = HeightRange(terrain.Actor, heights.Image);
  return vtkTerrainActor::MakeReliefColors(range[0], range[1]);
}

/// What legends tell: of the colours of the terrains, which are one's where they share them, and of
/// marks that have a table.
std::vector<LegendKey> KeysOf(const Terrain& terrain, const std::vector<Terrain>& others,
  const std::vector<LegendKey>& ofMarks, const Options& options)
{
  std::vector<LegendKey> keys = { terrain.Key };
  keys.front().Title = options.Legend;
  if (options.Colors.AreOfEach() && !others.empty())
  {
    keys.front().Title += ": " + terrain.Name;
    for (const Terrain& other : others)
    {
      keys.push_back(other.Key);
      keys.back().Title = options.Legend + ": " + other.Name;
    }
  }
  std::copy_if(ofMarks.begin(), ofMarks.end(), std::back_inserter(keys),
    [](const LegendKey& key) { return key.Table != nullptr; });
  return keys;
}

/// From the options to the files they ask for.
void Render(Options options)
{
  const Stopwatch watch;
  Statistics statistics;
  CheckOutputs(options);
  auto progress = std::make_unique<ProgressBar>();
  auto [read, heights] = ReadAndPlace(options, *progress, statistics);
  Terrain terrain = PrepareTerrain({ heights.Image, read.Tiles }, heights.Exaggeration,
    heights.Colors, options, *progress, statistics);
  std::vector<Terrain> sites = PrepareSites(read, heights, options, terrain, *progress, statistics);
  const PolygonLayer polygons = ReadPolygonLayer(heights, options, statistics);
  for (const Terrain& site : sites)
  {
    DrapePolygons(site, polygons, options);
  }
  const std::vector<Terrain> finer = PrepareFiner(heights, options, terrain, *progress, statistics);
  sites.insert(sites.end(), finer.begin(), finer.end());
  DrapePicture(terrain, heights, polygons, options, statistics);
  progress.reset();

  const vtkSmartPointer<vtkRenderWindow> window = MakeWindow(options);
  const vtkSmartPointer<vtkRenderer> renderer = MakeRenderer(terrain, heights, options);
  window->AddRenderer(renderer);
  AddSites(sites, renderer, options);
  ViewMarks marks(renderer, heights, BoxOf(terrain, heights, options), options);
  marks.AddOutlines(polygons);
  marks.Read(statistics);
  if (options.Marks.Inset)
  {
    marks.ShowInset(
      options.ColorBy.IsGiven() ? MakeReliefColors(terrain, heights) : terrain.Key.Table);
  }
  AddWater(renderer, terrain, sites, heights, options);
  AddFog(renderer, options);
  double right = 0.0;
  if (!options.Legend.empty())
  {
    right = AddLegends(
      renderer, KeysOf(terrain, sites, { polygons.Key, marks.GetTrackKey() }, options), options);
  }
  LeaveRoom(renderer, terrain, heights, options, right);
  marks.Refresh();
  statistics.SetTexts("labels", marks.GetPlaced());
  RefineTerrain(terrain, renderer, options, statistics);
  DrawOutputs({ window, renderer, terrain, heights }, marks, options, watch, statistics);
}
}

int main(int argc, char* argv[])
{
  try
  {
    Options options;
    if (const std::optional<int> status = ParseCommandLine(argc, argv, options))
    {
      return *status;
    }
    EndOnSignals("terrain-render: stopped on request\n");
    CatchMessages("terrain-render");
    if (options.Describe)
    {
      DescribeFile(options);
      return EXIT_SUCCESS;
    }
    Render(std::move(options));
    return EXIT_SUCCESS;
  }
  catch (const Failure& failure)
  {
    std::cerr << "terrain-render: " << failure.what() << '\n';
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << "terrain-render: out of memory\n";
  }
  catch (const std::exception& error)
  {
    std::cerr << "terrain-render: " << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
