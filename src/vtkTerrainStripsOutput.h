// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A refined mesh as vtkPolyData. Private to the module.
 */
#ifndef vtkTerrainStripsOutput_h
#define vtkTerrainStripsOutput_h

#include "core/Refinement.h"

#include <cmath>

class vtkPolyData;

/// What the output has besides points and strip.
struct vtkTerrainStripsOptions
{
  double Exaggeration;
  double DetailScale;
  bool Normals;
  bool TextureCoordinates;
  bool LevelColors;
  bool TriangleOutput;
};

/// A mesh and what it was refined from.
struct vtkTerrainStripsSource
{
  terrain::HierarchyView Hierarchy;
  const terrain::DetailHierarchy* Detail;

  int Level() const
  {
    return this->Detail ? this->Detail->Level() : 0;
  }
  /// Base cells in a column or row of the mesh.
  double Part() const
  {
    return std::ldexp(1.0, -this->Level());
  }
};

/// Fills the output of vtkTerrainStrips, which says what it has.
void vtkTerrainStripsFill(const terrain::StripMesh& mesh, const vtkTerrainStripsSource& source,
  const vtkTerrainStripsOptions& options, vtkPolyData* output);

#endif
