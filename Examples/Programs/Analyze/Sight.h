// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The commands profile, line-of-sight and viewshed.
 */
#ifndef terrain_analyze_Sight_h
#define terrain_analyze_Sight_h

#include "Raster.h"

#include <string>
#include <vector>

/// Two places, as vtkTerrainViewpoint reads them.
struct SightOptions
{
  std::string From;
  std::string To;
  int Count = 200;
  double Refraction = 0.13;
};

/// Who looks, at what, and how far.
struct ViewshedOptions
{
  /// X and y of each observer in the CRS of the heights, one after the other.
  std::vector<double> Observers;
  double EyeHeight = 1.75;
  double TargetHeight = 0.0;
  bool Curvature = false;
  double Refraction = 0.13;
  double Radius = 6371008.8;
  double Distance = 0.0; ///< 0: any
};

/// Writes how many observers see each sample.
void WriteViewshed(const RasterOptions& raster, const ViewshedOptions& viewshed);

/// Writes a table of distances and heights along the geodesic, with commas between them.
void WriteProfile(const RasterOptions& raster, const SightOptions& sight);
/// Prints whether one place is seen from the other, and what stands in the way.
void PrintLineOfSight(const RasterOptions& raster, const SightOptions& sight);

#endif
