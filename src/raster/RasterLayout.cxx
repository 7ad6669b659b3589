// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of RasterFile that knows coordinate reference systems and units.
#include "raster/RasterFile.h"

#include "core/grid/Constants.h"
#include "raster/CoordinateSystem.h"

#include <GeographicLib/Ellipsoid.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace terrain
{
namespace
{
constexpr double kFoot = 0.3048;
constexpr double kSurveyFoot = 1200.0 / 3937.0;
// A raster sheared by less than this many cells over its whole length is not sheared.
constexpr double kShearTolerance = 0.01;
// Metres per degree of longitude are never less than this share of those at the equator.
constexpr double kPoleShare = 1e-6;

std::string ExportWKT(OGRSpatialReferenceH srs)
{
  const char* const options[] = { "FORMAT=WKT2_2019", nullptr };
  char* text = nullptr;
  std::string wkt;
  if (OSRExportToWktEx(srs, &text, options) == OGRERR_NONE && text)
  {
    wkt = text;
  }
  CPLFree(text);
  return wkt;
}

bool ReadGeoTransform(GDALDatasetH dataset, RasterLayout& layout)
{
  std::array<double, 6> transform{};
  if (GDALGetGeoTransform(dataset, transform.data()) != CE_None || transform == layout.GeoTransform)
  {
    return false; // GDAL gives the identity for none
  }
  layout.GeoTransform = transform;
  layout.HasGeoTransform = true;
  layout.NorthFirst = transform[5] < 0.0;
  layout.EastFirst = transform[1] < 0.0;
  return true;
}

void CheckAxes(const std::array<double, 6>& transform, double width, double height)
{
  const bool finite =
    std::all_of(transform.begin(), transform.end(), [](double x) { return std::isfinite(x); });
  if (!finite || (transform[1] == 0.0 && transform[2] == 0.0) ||
    (transform[5] == 0.0 && transform[4] == 0.0))
  {
    throw RasterError("its georeference is degenerate");
  }
  if (std::fabs(transform[2]) * height > kShearTolerance * std::fabs(transform[1]) ||
    std::fabs(transform[4]) * width > kShearTolerance * std::fabs(transform[5]))
  {
    throw RasterError("its rows do not run east (rotated or sheared georeference); warp "
                      "it to a north-up grid first");
  }
}

/// Degrees to metres, true at the centre of the file, which becomes x = 0, y = 0.
void LayOutDegrees(OGRSpatialReferenceH srs, double width, double height, RasterLayout& layout)
{
  const std::array<double, 6>& transform = layout.GeoTransform;
  const double degrees = OSRGetAngularUnits(srs, nullptr) / kDegree; // per unit
  layout.Origin = { { transform[0] + 0.5 * width * transform[1],
    transform[3] + 0.5 * height * transform[5] } };
  const double latitude = layout.Origin[1] * degrees;
  const double extent = std::fabs(width * transform[1]) * degrees;
  // Half a cell beyond a pole, or a repeated column, is usual in global grids.
  const double slack = std::fabs(transform[1] * degrees) + 1e-6;
  if (std::fabs(latitude) > 90.0 || extent > 360.0 + slack)
  {
    std::ostringstream text;
    text << "its CRS is in degrees, but its centre lies at latitude " << latitude << " and it is "
         << extent << " degrees wide";
    throw RasterError(text.str());
  }
  OGRErr error = OGRERR_NONE;
  const double radius = OSRGetSemiMajor(srs, &error);
  const double inverse = OSRGetInvFlattening(srs, &error);
  const GeographicLib::Ellipsoid ellipsoid(radius, inverse > 0.0 ? 1.0 / inverse : 0.0);
  const double unit = degrees * kDegree;
  layout.Scale = { { std::max(ellipsoid.CircleRadius(latitude), kPoleShare * radius) * unit,
    ellipsoid.MeridionalCurvatureRadius(latitude) * unit } };
  layout.IsGeographic = true;
}

bool IsOneOf(const std::string& name, std::initializer_list<const char*> names)
{
  return std::any_of(
    names.begin(), names.end(), [&name](const char* other) { return name == other; });
}
}

//------------------------------------------------------------------------------
void RasterFile::SetCoordinateSystem(const std::string& definition)
{
  const GDALMessages messages;
  const std::string wkt = CoordinateSystem::ToWkt(definition);
  if (wkt.empty())
  {
    throw RasterError("the coordinate system '" + definition + "' is not understood");
  }
  if (this->GivenReference)
  {
    OSRRelease(this->GivenReference);
  }
  this->GivenReference = OSRNewSpatialReference(wkt.c_str());
}

//------------------------------------------------------------------------------
OGRSpatialReferenceH RasterFile::GetSpatialReference() const
{
  return this->GivenReference ? this->GivenReference : GDALGetSpatialRef(this->Dataset);
}

//------------------------------------------------------------------------------
RasterLayout RasterFile::GetLayout() const
{
  const GDALMessages messages;
  RasterLayout layout;
  const auto width = static_cast<double>(this->GetWidth());
  const auto height = static_cast<double>(this->GetHeight());
  OGRSpatialReferenceH srs = this->GetSpatialReference();
  if (srs)
  {
    layout.CRS = ExportWKT(srs);
  }
  if (!ReadGeoTransform(this->Dataset, layout))
  {
    return layout;
  }
  CheckAxes(layout.GeoTransform, width, height);
  if (srs && OSRIsGeographic(srs))
  {
    LayOutDegrees(srs, width, height, layout);
  }
  else if (srs)
  {
    const double unit = OSRGetLinearUnits(srs, nullptr);
    layout.Scale = { { unit > 0.0 ? unit : 1.0, unit > 0.0 ? unit : 1.0 } };
  }
  return layout;
}

//------------------------------------------------------------------------------
std::string RasterFile::GetVerticalUnit() const
{
  const char* unit = GDALGetRasterUnitType(this->Band);
  if (unit && *unit)
  {
    return unit;
  }
  const GDALMessages messages;
  OGRSpatialReferenceH srs = this->GetSpatialReference();
  if (srs && (OSRIsCompound(srs) || OSRIsVertical(srs)))
  {
    char* name = nullptr;
    OSRGetTargetLinearUnits(srs, "VERT_CS", &name);
    return name ? name : "";
  }
  return {};
}

//------------------------------------------------------------------------------
double RasterFile::GetMetresPerVerticalUnit() const
{
  std::string name = this->GetVerticalUnit();
  std::transform(name.begin(), name.end(), name.begin(),
    [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  if (IsOneOf(name, { "ft", "foot", "feet", "international foot", "foot (international)" }))
  {
    return kFoot;
  }
  if (IsOneOf(name,
        { "us survey foot", "us survey feet", "us-ft", "ftus", "foot_us", "sft", "us foot",
          "foot (us survey)" }))
  {
    return kSurveyFoot;
  }
  if (IsOneOf(name, { "km", "kilometre", "kilometer", "kilometres", "kilometers" }))
  {
    return 1000.0;
  }
  if (IsOneOf(name, { "dm", "decimetre", "decimeter", "decimetres", "decimeters" }))
  {
    return 0.1;
  }
  if (IsOneOf(name, { "cm", "centimetre", "centimeter", "centimetres", "centimeters" }))
  {
    return 0.01;
  }
  return 1.0;
}
}
