// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a file of heights to an actor.
 */
#ifndef terrain_render_Terrain_h
#define terrain_render_Terrain_h

#include "Annotations.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainActor.h"

#include <array>
#include <memory>
#include <string>

class ProgressBar;
class Statistics;
class vtkImageData;
class vtkRenderWindow;
class vtkRenderer;
struct ColorSource;
struct Options;
namespace terrain
{
class TileSource;
}

/// What is drawn.
struct Terrain
{
  vtkSmartPointer<vtkTerrainActor> Actor;
  /// Walls of a block along the edge of the data; null for none.
  vtkSmartPointer<vtkActor> Walls;
  /// What its colours tell.
  LegendKey Key;
  /// What a legend of its own calls it; empty where it is alone.
  std::string Name;
  /// Of all of the terrain, in world coordinates, whatever part of it the view needs.
  vtkBoundingBox Bounds;
  /// Of what the default view frames.
  vtkBoundingBox Framed;
  /// Lowest and highest height of further sites; none if the first is above the second.
  std::array<double, 2> OtherHeights{ { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX } };
};

/// True if the technique strips draws a prepared file without reading it whole: nothing that is
/// asked for needs the samples.
bool DrawsFileAlone(const Options& options);

/// Heights, and the tiles of which they are a level; null where they are all there is.
struct ReadHeightsResult
{
  vtkSmartPointer<vtkImageData> Image;
  std::shared_ptr<terrain::TileSource> Tiles;
  /// Of a folder: how many sites far from each other it has, and which of them this is.
  int Sites = 1;
  int Site = 1;
};

/// Reads the file of heights, or raises the built-in landscape. A raster larger than a texture is
/// read at a level: a coarse one if its tiles are to be drawn. Of a file that DrawsFileAlone() the
/// image has size and place, no samples. Throws a Failure.
ReadHeightsResult ReadHeights(
  const Options& options, bool drawsTiles, ProgressBar& progress, Statistics& statistics);

/// True if the options leave it to tiles to show a raster larger than a texture.
bool CanDrawTiles(const Options& options);

/// Tells the number and size of the samples that are drawn.
void CountSamples(vtkImageData* heights, Statistics& statistics);

/// Builds what the technique draws with, with the colours of a source, at an exaggeration. Throws a
/// Failure, also if the heights have no surface at all.
Terrain PrepareTerrain(const ReadHeightsResult& read, double exaggeration,
  const ColorSource& colors, const Options& options, ProgressBar& progress, Statistics& statistics);

/// Refines strips for the camera of the renderer; the other techniques need nothing. Throws a
/// Failure.
void RefineTerrain(
  const Terrain& terrain, vtkRenderer* renderer, const Options& options, Statistics& statistics);

/// Prints what the file of heights is taken for. Throws a Failure.
void DescribeFile(const Options& options);

/// Adds the terrain's bounds (metres, as drawn), its cell with the unit of that (on a globe
/// degrees), the range of heights (metres, not exaggerated), and what it takes on the graphics
/// card, after it was drawn.
void DescribeTerrain(
  const Terrain& terrain, vtkImageData* heights, bool isGlobe, Statistics& statistics);

/// Adds the histogram of the work of all pixels' rays, nodes visited and samples taken: draws once
/// more, with a compute shader. Adds nothing for techniques without rays, and where the graphics
/// driver has no compute shaders.
void CountCrossings(const Terrain& terrain, vtkRenderWindow* window, Statistics& statistics);

#endif
