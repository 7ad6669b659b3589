// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A mesh over samples of an image, on wish closed to a block, as vtkPolyData. Private to the
 * module.
 */
#ifndef vtkTerrain_data_MeshOutput_h
#define vtkTerrain_data_MeshOutput_h

#include "core/grid/Coordinates.h"
#include "core/mesh/GreedyMesh.h"

#include <array>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace terrain
{
/// What the output has besides points and triangles; see vtkTerrainMesh.
struct MeshOutputOptions
{
  bool SinglePrecision = false;
  bool Normals = false;
  bool TextureCoordinates = false;
  /// West, east, south, north of the picture; all 0 for one pixel a sample.
  std::array<double, 4> TextureBounds{};
  bool Slopes = false;
  bool PointArrays = false;
  bool Block = false;
  /// Walls round holes, too, and not along the sides of the rectangle of samples alone.
  bool WallsOfHoles = true;
  glm::ivec2 First{ 0, 0 };
  glm::ivec2 Last{ 0, 0 };
  /// Height of a block's floor, in height units.
  double BlockBase = 0.0;
};

/// Fills the output of vtkTerrainMesh, and empties the mesh on the way. image: the heights, whose
/// samples the vertices are. Triangles have numbers of 32 bits.
void FillMeshOutput(vtkImageData* image, GridMesh& mesh, const GridGeometry& geometry,
  const MeshOutputOptions& options, vtkPolyData* output);
}

#endif
