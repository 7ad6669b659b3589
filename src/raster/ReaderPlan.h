// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A raster that is taken in, and the samples that vtkTerrainRasterReader makes of it. Private to
 * the module.
 */
#ifndef vtkTerrain_raster_ReaderPlan_h
#define vtkTerrain_raster_ReaderPlan_h

#include "raster/RasterFile.h"
#include "raster/RasterPiece.h"

#include "vtkType.h"

#include <memory>
#include <string>

/// An opened file and what becomes of it.
struct vtkTerrainRasterPlan
{
  std::unique_ptr<terrain::RasterFile> File;
  terrain::RasterLayout Layout;
  terrain::RasterRequest Request;
  int ScalarType = VTK_FLOAT;
  std::string Name;
  std::string VerticalUnit;
  double VerticalScale = 1.0;
  double Origin[2] = { 0.0, 0.0 };
  double Spacing[2] = { 1.0, 1.0 };
  /// Level of tiles that is read in place of the samples themselves; 0: the samples.
  int Level = 0;
};

namespace terrain
{
/// The scalars' name where the file has none.
constexpr const char* kDefaultName = "Elevation";

/// Fills in the plan of a file that is taken in: the window (four numbers, 0 for all up to the
/// edge) reduced under two limits (0 for none), scalars. Throws RasterError.
void CompletePlan(
  vtkTerrainRasterPlan& plan, const int window[4], int maximumSize, vtkIdType maximumNumber);

/// Fills in position of the south-western sample, and spacing.
void PlaceSamples(vtkTerrainRasterPlan& plan);

/// Lines that tell what a raster is taken for (vtkTerrainRasterReader::Describe).
std::string DescribePlan(const vtkTerrainRasterPlan& plan);
}
#endif
