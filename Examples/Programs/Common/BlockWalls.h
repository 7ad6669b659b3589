// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Walls of a block along the edge of the data. The mapper draws those along the borders of the
 * raster, in the colours of the surface; most files that were resampled have no data there. Blocks
 * with layers are made of walls and a floor alone.
 */
#ifndef terrain_common_BlockWalls_h
#define terrain_common_BlockWalls_h

#include <vtkSmartPointer.h>

#include <array>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkPolyData;
class vtkTerrainActor;

/// A layer of the ground.
struct Stratum
{
  /// Red, green, blue, 0 to 1.
  std::array<double, 3> Color{};
  /// Metres; 0 for all that is left.
  double Thickness = 0.0;
};

/// Vertical rectangles from the surface down to a height, one below each side that a cell with
/// heights at all four corners shares with one that lacks any. Their upper edges are exact: along
/// the sides of cells the surface is straight. Heights count from the image's origin, in metres;
/// the scalars of the points are their heights, or what lies so deep below the point array `colors`
/// of the samples, if the image has it.
vtkSmartPointer<vtkPolyData> MakeBlockWalls(
  vtkImageData* heights, double base, const char* colors = "PlaceHeight");

/// Walls along all of the rim, in layers that follow the surface from there down, and a floor. The
/// last layer fills what is left. Colours of the cells are bytes.
vtkSmartPointer<vtkPolyData> MakeLayeredBlock(
  vtkImageData* heights, double base, const std::vector<Stratum>& strata);

/// The walls as an actor with the colours and the place of a terrain that draws a block; null if
/// there are none. Call it when the terrain has its colours, property and exaggeration.
vtkSmartPointer<vtkActor> MakeWallActor(vtkTerrainActor* terrain, vtkImageData* heights);

/// A block of layers as such an actor; the terrain itself draws its surface alone then.
vtkSmartPointer<vtkActor> MakeLayerActor(
  vtkTerrainActor* terrain, vtkImageData* heights, const std::vector<Stratum>& strata);

#endif
