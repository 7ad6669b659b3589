// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/SystemAxes.h"

#include "raster/GDALTable.h"
#include "raster/RasterMessages.h"

#include <cmath>
#include <cstdlib>

namespace terrain
{
namespace
{
// Degrees around the area that a CRS is for.
constexpr double kMargin = 1.0;

/// Orientation of the two axes of the CRS, in its own order.
std::array<OGRAxisOrientation, 2> OrientationOf(OGRSpatialReferenceH reference)
{
  std::array<OGRAxisOrientation, 2> orientation{ { OAO_Other, OAO_Other } };
  for (int axis = 0; axis < 2; ++axis)
  {
    OSRGetAxis(reference, nullptr, axis, &orientation[static_cast<std::size_t>(axis)]);
  }
  return orientation;
}

bool IsAlongX(OGRAxisOrientation orientation)
{
  return orientation == OAO_East || orientation == OAO_West;
}

bool IsAlongY(OGRAxisOrientation orientation)
{
  return orientation == OAO_North || orientation == OAO_South;
}

double SignOf(OGRAxisOrientation orientation)
{
  return orientation == OAO_West || orientation == OAO_South ? -1.0 : 1.0;
}

/// True if x and y are along their axes, and one of them points west or south.
bool IsTurned(const std::array<OGRAxisOrientation, 2>& orientation)
{
  const bool ordered = (IsAlongX(orientation[0]) && IsAlongY(orientation[1])) ||
    (IsAlongY(orientation[0]) && IsAlongX(orientation[1]));
  return ordered && (SignOf(orientation[0]) < 0.0 || SignOf(orientation[1]) < 0.0);
}

/// The area that a CRS is for, in degrees; that of its EPSG code where its definition has none.
bool FindArea(
  OGRSpatialReferenceH reference, double& west, double& south, double& east, double& north)
{
  if (OSRGetAreaOfUse(reference, &west, &south, &east, &north, nullptr))
  {
    return true;
  }
  const char* code =
    OSRGetAuthorityCode(reference, OSRIsProjected(reference) ? "PROJCS" : "GEOGCS");
  OGRSpatialReferenceH registered = OSRNewSpatialReference(nullptr);
  const bool found = code && OSRImportFromEPSG(registered, std::atoi(code)) == OGRERR_NONE &&
    OSRGetAreaOfUse(registered, &west, &south, &east, &north, nullptr);
  OSRRelease(registered);
  return found;
}
}

//------------------------------------------------------------------------------
bool IsInArea(OGRSpatialReferenceH reference, double x, double y)
{
  double west = 0.0;
  double south = 0.0;
  double east = 0.0;
  double north = 0.0;
  if (!FindArea(reference, west, south, east, north))
  {
    return true;
  }
  OGRSpatialReferenceH turned = OSRClone(reference);
  TurnAxes(turned);
  OGRSpatialReferenceH places = OSRNewSpatialReference(nullptr);
  OSRImportFromEPSG(places, 4326);
  OSRSetAxisMappingStrategy(places, OAMS_TRADITIONAL_GIS_ORDER);
  const GDALMessages messages;
  OGRCoordinateTransformationH transformation = OCTNewCoordinateTransformation(turned, places);
  double z = 0.0;
  int good = 0;
  const bool found = transformation && OCTTransformEx(transformation, 1, &x, &y, &z, &good) && good;
  if (transformation)
  {
    OCTDestroyCoordinateTransformation(transformation);
  }
  OSRRelease(places);
  OSRRelease(turned);
  return found && x >= west - kMargin && x <= east + kMargin && y >= south - kMargin &&
    y <= north + kMargin;
}

//------------------------------------------------------------------------------
bool TurnAxes(OGRSpatialReferenceH reference)
{
  OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER);
  if (!OSRIsProjected(reference))
  {
    return false;
  }
  const std::array<OGRAxisOrientation, 2> orientation = OrientationOf(reference);
  if (!IsTurned(orientation))
  {
    return false;
  }
  std::array<int, 3> mapping{ { 1, 2, 3 } };
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const std::size_t side = IsAlongX(orientation[axis]) ? 0 : 1;
    mapping[side] = static_cast<int>(axis + 1) * static_cast<int>(SignOf(orientation[axis]));
  }
  OSRSetDataAxisToSRSAxisMapping(reference, OSRIsCompound(reference) ? 3 : 2, mapping.data());
  return true;
}

//------------------------------------------------------------------------------
FileAxes FindFileAxes(
  OGRSpatialReferenceH reference, const std::array<double, 2>& middle, bool& isGuessed)
{
  isGuessed = false;
  if (!OSRIsProjected(reference))
  {
    return {};
  }
  const std::array<OGRAxisOrientation, 2> orientation = OrientationOf(reference);
  if (!IsTurned(orientation))
  {
    return {};
  }
  int count = 0;
  const int* mapping = OSRGetDataAxisToSRSAxisMapping(reference, &count);
  const std::size_t first =
    mapping && count >= 2 && std::abs(mapping[0]) == 2 ? std::size_t{ 1 } : std::size_t{ 0 };
  FileAxes said;
  said.IsSwapped = IsAlongY(orientation[first]);
  const std::size_t alongX = IsAlongX(orientation[0]) ? 0 : 1;
  said.Sign = { SignOf(orientation[alongX]), SignOf(orientation[1 - alongX]) };
  const FileAxes plain;
  FileAxes negative;
  negative.Sign = { -1.0, -1.0 };
  bool isFirst = true;
  for (const FileAxes& axes : { said, plain, negative })
  {
    const double x = axes.Sign[0] * middle[axes.IsSwapped ? 1 : 0];
    const double y = axes.Sign[1] * middle[axes.IsSwapped ? 0 : 1];
    if (IsInArea(reference, x, y))
    {
      isGuessed = !isFirst;
      return axes;
    }
    isFirst = false;
  }
  return said;
}
}
