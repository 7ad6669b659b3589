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
  bool PointArrays = false;
  bool Block = false;
  /// Height of a block's floor, in height units.
  double BlockBase = 0.0;
};

/// Fills the output of vtkTerrainMesh, and empties the mesh on the way. image: the heights, whose
/// samples the vertices are. Triangles have numbers of 32 bits.
void FillMeshOutput(vtkImageData* image, GridMesh& mesh, const GridGeometry& geometry,
  const MeshOutputOptions& options, vtkPolyData* output);
}

#endif
