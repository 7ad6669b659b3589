// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/place/Ellipsoid.h"

#include "core/grid/Constants.h"

#include <GeographicLib/Geocentric.hpp>

namespace terrain
{
glm::dvec3 Ellipsoid::ToPosition(const glm::dvec3& place) const
{
  const double sine = std::sin(place.y);
  // on the axis at the poles, whatever the rounding of pi
  const double cosine = std::abs(place.y) >= 90.0 * kDegree ? 0.0 : std::cos(place.y);
  const glm::dvec2 point = this->Foot(sine, cosine) + place.z * glm::dvec2(cosine, sine);
  return { point.x * std::cos(place.x), point.x * std::sin(place.x), point.y };
}

glm::dvec3 Ellipsoid::ToPlace(const glm::dvec3& position) const
{
  glm::dvec3 place;
  GeographicLib::Geocentric(this->Equatorial, this->Flattening())
    .Reverse(position.x, position.y, position.z, place.y, place.x, place.z);
  return { place.x * kDegree, place.y * kDegree, place.z };
}
}
