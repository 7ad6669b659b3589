// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where a picked point of the terrain lies, in words.
 */
#ifndef terrain_view_Readout_h
#define terrain_view_Readout_h

#include "vtkNew.h"
#include "vtkTerrainGeoreference.h"

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
