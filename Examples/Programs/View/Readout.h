// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where a picked point of the terrain lies, in words.
 */
#ifndef terrain_view_Readout_h
#define terrain_view_Readout_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainViewpoint.h"

#include <array>
#include <string>

class vtkImageData;
class vtkTerrainPicker;

/// Knows where on earth an image of heights lies, if its field data tell (vtkTerrainRasterReader).
class Readout
{
public:
  explicit Readout(vtkImageData* heights);

  /// Of the last pick on a terrain, one or two lines: column and row, x, y and height; longitude,
  /// latitude, UTM and MGRS where these are known. Empty without a pick on a terrain.
  std::string Describe(vtkTerrainPicker* picker) const;

  /// True if the places of points are known.
  bool HasPlaces() const
  {
    return this->IsOnEarth;
  }

  /// Measures of the scene of GetGeoreference(), into which places are brought.
  vtkSmartPointer<vtkTerrainViewpoint> MakeViewpoint() const;

  /// Longitude and latitude of a point of the terrain's plane. False without places.
  bool ToPlace(const double point[2], double place[2]) const;
  /// The point of a place.
  bool FromPlace(const double place[2], double point[2]) const;

  const std::array<double, 2>& GetLayoutOrigin() const
  {
    return this->LayoutOrigin;
  }
  const std::array<double, 2>& GetLayoutScale() const
  {
    return this->LayoutScale;
  }

private:
  /// Coordinate of the file's CRS; axis 0 or 1.
  double ToFile(std::size_t axis, double coordinate) const
  {
    return this->LayoutOrigin[axis] + coordinate / this->LayoutScale[axis];
  }

  vtkNew<vtkTerrainGeoreference> Georeference;
  bool IsOnEarth = false;
  /// CRS = LayoutOrigin + (x, y) / LayoutScale
  std::array<double, 2> LayoutOrigin{ 0.0, 0.0 };
  std::array<double, 2> LayoutScale{ 1.0, 1.0 };
};

#endif
