// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A refined mesh as vtkPolyData. Private to the module.
 */
#ifndef vtkTerrain_data_StripsOutput_h
#define vtkTerrain_data_StripsOutput_h

#include "core/strips/Refinement.h"

#include <cmath>

class vtkPolyData;

namespace terrain
{
/// What the output has besides points and strip.
struct StripsOptions
{
  double Exaggeration;
  double DetailScale;
  bool Normals;
  bool TextureCoordinates;
  bool DepthColors;
  bool HeightScalars;
  bool TriangleOutput;
};

/// A mesh and what it was refined from.
struct StripsSource
{
  HierarchyView Hierarchy;
  const DetailHierarchy* Detail;

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

/// False if a drawn vertex is lower or higher than all of the hierarchy: its records are damaged.
bool AreHeightsKnown(const StripMesh& mesh, const StripsSource& source, double detailScale);

/// Fills the output of vtkTerrainStrips, which says what it has.
void FillStrips(const StripMesh& mesh, const StripsSource& source, const StripsOptions& options,
  vtkPolyData* output);
}
#endif
