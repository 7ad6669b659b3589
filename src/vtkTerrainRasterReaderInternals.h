// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the files of vtkTerrainRasterReader share. Private to the module.
 */
#ifndef vtkTerrainRasterReaderInternals_h
#define vtkTerrainRasterReaderInternals_h

#include "raster/RasterFile.h"
#include "raster/RasterPiece.h"

#include "vtkType.h"

#include <string>

/// An opened file and what becomes of it.
struct vtkTerrainRasterPlan
{
  terrain::RasterFile File;
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

  explicit vtkTerrainRasterPlan(const char* fileName)
    : File(fileName)
  {
  }
};

#endif
