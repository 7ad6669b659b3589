// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/place/GridReference.h"

#include "core/place/GeographicText.h"

#include <GeographicLib/UTMUPS.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

namespace
{
bool IsOnEarth(const glm::dvec3& place)
{
  return std::abs(place.y) <= 90.0 && std::isfinite(place.x);
}
}

namespace terrain
{
GridPosition ToGridPosition(const glm::dvec3& place)
{
  GridPosition position;
  if (!IsOnEarth(place))
  {
    return position;
  }
  try
  {
    GeographicLib::UTMUPS::Forward(
      place.y, place.x, position.Zone, position.Northern, position.Easting, position.Northing);
  }
  catch (const std::exception&)
  {
    position.Zone = -1;
  }
  return position;
}

std::string ToUtmText(const glm::dvec3& place, int precision)
{
  char text[kGeographicTextSize];
  return IsOnEarth(place) && WriteUtmText(place.y, place.x, precision, text) ? text : "-";
}

std::string ToMgrs(const glm::dvec3& place, int precision)
{
  char text[kGeographicTextSize];
  const int digits = std::clamp(precision, 0, 11);
  return IsOnEarth(place) && WriteMgrs(place.y, place.x, digits, text) ? text : "-";
}

bool PlaceFromText(const std::string& text, glm::dvec3& place, std::string& message)
{
  double latitude = 0.0;
  double longitude = 0.0;
  char reason[kGeographicTextSize];
  if (!ReadGeographicText(text.c_str(), latitude, longitude, reason))
  {
    message = "'" + text + "' is no place: " + reason;
    return false;
  }
  if (!IsOnEarth({ longitude, latitude, 0.0 }))
  {
    message = "'" + text + "' is no place on earth";
    return false;
  }
  place.x = longitude;
  place.y = latitude;
  return true;
}

std::string ToDegreesText(const glm::dvec3& place, int decimals)
{
  if (!IsOnEarth(place))
  {
    return "-";
  }
  char text[80];
  const int digits = std::clamp(decimals, 0, 12);
  std::snprintf(text, sizeof(text), "%.*f%c %.*f%c", digits, std::abs(place.y),
    place.y < 0.0 ? 'S' : 'N', digits, std::abs(place.x), place.x < 0.0 ? 'W' : 'E');
  return text;
}
}
