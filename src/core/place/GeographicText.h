// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Those functions of GeographicLib that take or give std::string, without std::string:
 * GeographicLib may be built for another string ABI than VTK (VTK's wheels use the old one), and
 * only its file is compiled for GeographicLib's. Latitudes and longitudes in degrees.
 */
#ifndef terrain_GeographicText_h
#define terrain_GeographicText_h

#include <cstddef>

namespace terrain
{
/// Room for any text that these functions write, its end included.
constexpr std::size_t kGeographicTextSize = 256;

/// UTM or UPS as text, precision as ToUtmText; false if the place has none.
bool WriteUtmText(
  double latitude, double longitude, int precision, char (&text)[kGeographicTextSize]);

/// MGRS reference of a place in its standard zone, precision 0 to 11; false if the place has none.
bool WriteMgrs(double latitude, double longitude, int precision, char (&text)[kGeographicTextSize]);

/// Reads MGRS, UTM, UPS or degrees (longitude first); false, with the reason in message, if the
/// text is none of these.
bool ReadGeographicText(
  const char* text, double& latitude, double& longitude, char (&message)[kGeographicTextSize]);
}

#endif
