// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/globe/GlobeGrid.h"

#include "core/grid/Constants.h"

namespace terrain
{
namespace
{
/// Parts of a cell by which longitudes of files are rounded.
constexpr double kRounding = 1e-3;
}

bool GlobeGrid::IsJoined() const
{
  return std::abs((this->Columns - 1) * this->Step - kTurn) < kRounding * this->Step;
}

std::string GlobeGrid::WhyNot() const
{
  if (!(this->Body.Equatorial > 0.0) || !std::isfinite(this->Body.Equatorial) ||
    !(this->Body.Flattening() >= 0.0) || !(this->Body.Flattening() <= kMostFlattening))
  {
    return "a globe is a sphere, or an ellipsoid with a flattening of 0 to 0.1";
  }
  if (this->Columns < 2 || this->Latitudes.size() < 2)
  {
    return "a globe needs at least two meridians and two parallels of heights: draw a single one "
           "as "
           "a profile";
  }
  if (!(this->Step > 0.0) || !std::isfinite(this->West) ||
    !((this->Columns - 1) * this->Step < kTurn + kRounding * this->Step))
  {
    return "the longitudes of a globe's heights go round more than once: cut the raster to 360 "
           "degrees (gdal_translate -projwin)";
  }
  for (std::size_t row = 0; row < this->Latitudes.size(); ++row)
  {
    if (!(std::abs(this->Latitudes[row]) <= 90.0 * kDegree) ||
      (row > 0 && !(this->Latitudes[row] > this->Latitudes[row - 1])))
    {
      return "the latitudes of a globe's heights must rise within -90 to 90 degrees: cut the "
             "raster "
             "to them (gdal_translate -projwin)";
    }
  }
  return {};
}
}
