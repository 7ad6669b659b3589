// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The unit of heights and whether they count up or down, from all that a raster says of it. Without
 * GDAL. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterUnits_h
#define vtkTerrain_raster_RasterUnits_h

#include "raster/RasterRecord.h"

#include <string>

namespace terrain
{
/// What a raster says; empty and 0 for what it does not.
struct HeightFacts
{
  /// What the caller says: a unit or metres per unit (core/grid/HeightUnits.h).
  std::string Option;
  std::string BandUnit;
  std::string Description;
  std::string Variable;
  /// CF's attributes of the variable.
  std::string Positive;
  std::string StandardName;
  std::string LongName;
  /// Short name of GDAL's driver.
  std::string Driver;
  /// The vertical axis of the CRS.
  std::string VerticalUnit;
  double VerticalMetres = 0.0;
  bool IsVerticalDown = false;
  /// Unit of x and y of a projected CRS.
  std::string HorizontalUnit;
  double HorizontalMetres = 0.0;
  /// Lowest and highest height that was looked at; low > high for none.
  double Low = 1.0;
  double High = -1.0;
};

/// Heights in metres are Offset + Factor times the band's (scale and offset of the band applied
/// before).
struct HeightMeaning
{
  /// Below 0 where they count down.
  double Factor = 1.0;
  /// Metres: below 0 where the band holds distances from the centre of a body.
  double Offset = 0.0;
  /// As the file names it; empty if it does not.
  std::string Unit;
};

/// Notes in the record what was taken from where, and warns of what contradicts or is guessed.
/// Throws RasterError if the caller's unit is not known.
HeightMeaning FindHeightMeaning(const HeightFacts& facts, RasterRecord& record);
}
#endif
