// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Places as people write them: UTM and UPS coordinates, MGRS references, degrees. A place is as in
 * SceneFrame.h. Source: GeographicLib (UTMUPS, MGRS, GeoCoords).
 */
#ifndef terrain_GridReference_h
#define terrain_GridReference_h

#include <glm/glm.hpp>

#include <string>

namespace terrain
{
/// A position in a UTM zone, or in UPS: zone 0; easting and northing in metres.
struct GridPosition
{
  int Zone = -1;
  bool Northern = true;
  double Easting = 0.0;
  double Northing = 0.0;
};

/// Position of a place in its standard zone (with the exceptions of Norway and Svalbard); zone -1
/// if the place is not on earth.
GridPosition ToGridPosition(const glm::dvec3& place);

/// UTM or UPS as text: "45n 493000 3095000", precision 0 = metres, 3 = millimetres, -3 =
/// kilometres;
/// "-" if the place is not on earth.
std::string ToUtmText(const glm::dvec3& place, int precision = 0);

/// MGRS reference of a place: precision 5 = metres, 0 = 100 km, up to 11; "-" if the place is not
/// on earth.
std::string ToMgrs(const glm::dvec3& place, int precision = 5);

/// Reads an MGRS reference (the centre of its square), UTM or UPS ("45N 493000 3095000"), or
/// degrees (longitude first unless N, S, E, W say otherwise: "86.925 27.988", "27d59'17\"N
/// 86d55'31\"E"). False, with the reason in message, if the text is none of these; the height of
/// place is kept.
bool PlaceFromText(const std::string& text, glm::dvec3& place, std::string& message);

/// Degrees with hemispheres, "27.988056N 86.925278E"; decimals 0 to 12.
std::string ToDegreesText(const glm::dvec3& place, int decimals = 6);
}

#endif
