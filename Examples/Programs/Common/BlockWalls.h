// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Walls of a block along the edge of the data. The mapper draws those along the borders of the
 * raster; most files that were resampled have no data there.
 */
#ifndef terrain_common_BlockWalls_h
#define terrain_common_BlockWalls_h

#include <vtkSmartPointer.h>

class vtkActor;
class vtkImageData;
class vtkPolyData;
class vtkTerrainActor;

/// Vertical rectangles from the surface down to a height, one below each side that a cell with
/// heights at all four corners shares with one that lacks any. Their upper edges are exact: along
/// the sides of cells the surface is straight. Heights count from the image's origin, in metres;
/// the scalars of the points are their heights, or what lies so deep below the point array `colors`
/// of the samples, if the image has it.
vtkSmartPointer<vtkPolyData> MakeBlockWalls(
  vtkImageData* heights, double base, const char* colors = "PlaceHeight");

/// The walls as an actor with the colours and the place of a terrain that draws a block; null if
/// there are none. Call it when the terrain has its colours, property and exaggeration.
vtkSmartPointer<vtkActor> MakeWallActor(vtkTerrainActor* terrain, vtkImageData* heights);

#endif
