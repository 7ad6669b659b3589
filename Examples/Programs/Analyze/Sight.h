// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The commands profile, line-of-sight and viewshed.
 */
#ifndef terrain_analyze_Sight_h
#define terrain_analyze_Sight_h

#include "Observers.h"
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
  ObserverOptions Observers;
  double Spacing = 0.0; ///< of observers along lines and in areas; 0: a cell
  double EyeHeight = 1.75;
  double TargetHeight = 0.0;
  bool Curvature = false;
  double Refraction = 0.13;
  double Radius = 6371008.8;
  /// Of what is seen; more than 1e9 is any.
  std::vector<double> Distance{ 0.0, 1e30 };
  std::vector<double> Azimuth{ 0.0, 360.0 };
  std::vector<double> Elevation{ -90.0, 90.0 };
  bool NoDataBlocks = false;
  bool Rise = false;
};

/// Writes how many observers see each sample and, if asked for, by how much it would have to rise.
void WriteViewshed(const RasterOptions& raster, const ViewshedOptions& viewshed);

/// Writes a table of distances and heights along the geodesic, with commas between them.
void WriteProfile(const RasterOptions& raster, const SightOptions& sight);
/// Prints whether one place is seen from the other, and what stands in the way.
void PrintLineOfSight(const RasterOptions& raster, const SightOptions& sight);

#endif
