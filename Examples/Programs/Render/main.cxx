// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * terrain-render: a file of heights to a picture. What it does is told by --help; its exit status
 * is 0, 2 for a wrong command line, 1 otherwise, with one line on stderr and no output left behind.
 */
#include "Annotations.h"
#include "Day.h"
#include "Draping.h"
#include "Ending.h"
#include "Failure.h"
#include "Frames.h"
#include "Messages.h"
#include "Misses.h"
#include "Options.h"
#include "Outputs.h"
#include "Placing.h"
#include "Progress.h"
#include "Statistics.h"
#include "Terrain.h"
#include "View.h"

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <new>

namespace
{
/// From the options to the files they ask for.
void Render(const Options& options)
{
  const Stopwatch watch;
  Statistics statistics;
  const bool severalSuns = options.Light.GetSuns().size() > 1;
  PendingFile picture(severalSuns ? std::string() : options.Output);
  PendingFile depth(options.Depth);
  PendingFile stats(options.Stats);

  auto progress = std::make_unique<ProgressBar>();
  ReadHeightsResult read = ReadHeights(options, CanDrawTiles(options), *progress, statistics);
  PlacedHeights heights = PlaceHeights(read.Image, options, *progress, statistics);
  if (read.Tiles && heights.Image != read.Image)
  {
    // resampled: tiles lie elsewhere, and the finest level that fits is drawn
    read = ReadHeights(options, false, *progress, statistics);
    heights = PlaceHeights(read.Image, options, *progress, statistics);
  }
  const Terrain terrain = PrepareTerrain(
    { heights.Image, read.Tiles }, heights.Exaggeration, options, *progress, statistics);
  DrapePicture(terrain, heights, options, statistics);
  progress.reset();

  const vtkSmartPointer<vtkRenderWindow> window = MakeWindow(options);
  const vtkSmartPointer<vtkRenderer> renderer = MakeRenderer(terrain, heights, options);
  window->AddRenderer(renderer);
  AddLines(renderer, heights, options, statistics);
  AddOverlay(renderer, heights, options);
  AddLegend(renderer, terrain, options);
  RefineTerrain(terrain, renderer, options, statistics);
  DrawFrames(window, renderer, options.Frames, statistics);
  DescribeTerrain(terrain, heights.Image, statistics);
  statistics.AddTime("total", watch.GetMilliseconds());

  if (severalSuns)
  {
    DrawSuns(window, renderer, heights, options);
  }
  else
  {
    WritePicture(window, picture);
  }
  CountMisses(terrain, options, window, renderer, statistics);
  if (depth.IsWanted())
  {
    WriteDepths(DrawDepths(window, renderer, terrain.Actor), depth);
  }
  if (stats.IsWanted())
  {
    CountCrossings(terrain, window, statistics);
    WriteText(statistics.ToJson(), stats);
  }
  ThrowOnError(options.Output);
  for (PendingFile* file : { &depth, &stats, &picture })
  {
    file->Commit();
  }
  if (!severalSuns)
  {
    TellName(options.Output);
  }
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
    Render(options);
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
