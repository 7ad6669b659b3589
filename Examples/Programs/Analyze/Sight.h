// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The commands profile and line-of-sight.
 */
#ifndef terrain_analyze_Sight_h
#define terrain_analyze_Sight_h

#include "Raster.h"

#include <string>

/// Two places, as vtkTerrainViewpoint reads them.
struct SightOptions
{
  std::string From;
  std::string To;
  int Count = 200;
  double Refraction = 0.13;
};

/// Writes a table of distances and heights along the geodesic, with commas between them.
void WriteProfile(const RasterOptions& raster, const SightOptions& sight);
/// Prints whether one place is seen from the other, and what stands in the way.
void PrintLineOfSight(const RasterOptions& raster, const SightOptions& sight);

#endif
