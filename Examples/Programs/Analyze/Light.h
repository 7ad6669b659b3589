// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The commands horizon, skyview and sunlight.
 */
#ifndef terrain_analyze_Light_h
#define terrain_analyze_Light_h

#include "Raster.h"

#include <string>

/// From where, and over what earth.
struct LightOptions
{
  int Directions = 16;
  double EyeHeight = 0.0;
  bool Curvature = false;
  double Refraction = 0.13;
  double Radius = 6371008.8;
  std::string Date;
  double TimeStep = 10.0;
  double Turbidity = 3.0;
};

void WriteHorizon(const RasterOptions& raster, const LightOptions& light);
void WriteSkyView(const RasterOptions& raster, const LightOptions& light);
void WriteSunlight(const RasterOptions& raster, const LightOptions& light);

#endif
