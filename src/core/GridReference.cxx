// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/GridReference.h"

#include <GeographicLib/GeoCoords.hpp>
#include <GeographicLib/MGRS.hpp>
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
  if (!IsOnEarth(place))
  {
    return "-";
  }
  try
  {
    return GeographicLib::GeoCoords(place.y, place.x).UTMUPSRepresentation(precision);
  }
  catch (const std::exception&)
  {
    return "-";
  }
}

std::string ToMgrs(const glm::dvec3& place, int precision)
{
  if (!IsOnEarth(place))
  {
    return "-";
  }
  try
  {
    const GridPosition position = ToGridPosition(place);
    std::string text;
    GeographicLib::MGRS::Forward(position.Zone, position.Northern, position.Easting,
      position.Northing, place.y, std::clamp(precision, 0, 11), text);
    return text;
  }
  catch (const std::exception&)
  {
    return "-";
  }
}

bool PlaceFromText(const std::string& text, glm::dvec3& place, std::string& message)
{
  try
  {
    const GeographicLib::GeoCoords coordinates(text, true, true);
    if (!IsOnEarth({ coordinates.Longitude(), coordinates.Latitude(), 0.0 }))
    {
      message = "'" + text + "' is no place on earth";
      return false;
    }
    place.x = coordinates.Longitude();
    place.y = coordinates.Latitude();
    return true;
  }
  catch (const std::exception& error)
  {
    message = "'" + text + "' is no place: " + error.what();
    return false;
  }
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
