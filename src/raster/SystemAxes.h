// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which way the axes of a projected CRS point. Private to the module.
 *
 * In this module x is east and y north in every CRS: of a system whose axes point west or south
 * (Krovak EPSG:5513, South Africa's Lo grids EPSG:2046 to 2055) the coordinates are taken
 * negative, and in that order.
 */
#ifndef vtkTerrain_raster_SystemAxes_h
#define vtkTerrain_raster_SystemAxes_h

#include <ogr_srs_api.h>

#include <array>

namespace terrain
{
/// Makes x east and y north in a CRS of one axis east or west and one north or south; others keep
/// the order of axes that GIS programs use. True if an axis points west or south.
bool TurnAxes(OGRSpatialReferenceH reference);

/// True if a point (x east, y north) lies in the area that a CRS is for, or within a degree of it;
/// also where that area is not known.
bool IsInArea(OGRSpatialReferenceH reference, double x, double y);

/// How file coordinates become x east and y north: x = Sign[0] * file[IsSwapped ? 1 : 0], y
/// likewise.
struct FileAxes
{
  bool IsSwapped = false;
  std::array<double, 2> Sign{ { 1.0, 1.0 } };
};

/// The way in which the coordinates of a file in a CRS with axes west or south are written, by the
/// order that the CRS of its dataset has; where the middle of the file lies outside the area that
/// the CRS is for, the way in which it lies inside: as x east and y north, or with both signs
/// turned. isGuessed tells that it was found by the area. Identity for other systems.
FileAxes FindFileAxes(
  OGRSpatialReferenceH reference, const std::array<double, 2>& middle, bool& isGuessed);
}
#endif
