// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Points and lines of a globe on the flat grid of its heights, and back. Private to the module.
 *
 * Flat coordinates: x, y as the image of the heights has them (degrees; rows that close a pole as
 * far apart as all others), z in metres above the ellipsoid.
 */
#ifndef vtkTerrain_data_GlobePaths_h
#define vtkTerrain_data_GlobePaths_h

#include "core/globe/GlobeGrid.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstddef>

class vtkImageData;

namespace terrain::GlobePaths
{
/// Geocentric points to flat ones. A line between two points goes the shorter way round in
/// longitude and straight in longitude and latitude; points are added so that its chords, brought
/// back, are within sag metres of it. Where a line leaves the longitudes of the image on one side
/// and comes in on the other, it is cut. Polygons become lines; point data are interpolated, cell
/// data copied.
vtkSmartPointer<vtkPolyData> ToFlat(
  vtkPolyData* paths, const GlobeGrid& grid, vtkImageData* heights, double sag);

///@{
/// Points of three coordinates each, in place. Flat ones lie within half a turn of the middle of
/// the image; those that have no place become NaN.
void ToFlat(double* points, std::size_t count, const GlobeGrid& grid, vtkImageData* heights);
void FromFlat(double* points, std::size_t count, const GlobeGrid& grid, vtkImageData* heights);
///@}

/// Flat points to geocentric ones, in place.
void FromFlat(vtkPolyData* paths, const GlobeGrid& grid, vtkImageData* heights);
}

#endif
