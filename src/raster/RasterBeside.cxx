// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of RasterFile that finds a place told by other means than a transform and a CRS in the
// file: units of coordinates, ground control points, rational polynomials, a .prj beside it.
#include "raster/RasterFile.h"

#include "core/grid/HeightUnits.h"
#include "raster/GDALTable.h"
#include "raster/RasterArray.h"
#include "raster/RasterReference.h"
#include "raster/RasterRepairs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace terrain
{
namespace
{
// Cells by which ground control points may be off an affine transform, and places off a spline.
constexpr double kPointTolerance = 0.01;
// Pixels by which places are off rational polynomials.
constexpr double kPolynomialTolerance = 0.001;
// Samples of a raster that is bent in memory.
constexpr std::int64_t kMostBent = std::int64_t{ 1 } << 27;

/// True if a transform maps the pixels of all points to their places.
bool FitsAll(const std::array<double, 6>& t, const GDAL_GCP* points, int count)
{
  const double cell = std::hypot(t[1], t[4]);
  return std::all_of(points, points + count,
    [&](const GDAL_GCP& point)
    {
      const double x = t[0] + point.dfGCPPixel * t[1] + point.dfGCPLine * t[2];
      const double y = t[3] + point.dfGCPPixel * t[4] + point.dfGCPLine * t[5];
      return std::hypot(x - point.dfGCPX, y - point.dfGCPY) <= kPointTolerance * cell;
    });
}

/// Longitude and latitude of the middle of each sample, of which the heights in metres are given;
/// NaN where the polynomials of a transformer of GDAL have none.
GridPlace PlacesOf(void* polynomials, std::vector<double> heights, std::int64_t width)
{
  GridPlace place;
  place.IsField = true;
  place.IsGeographic = true;
  place.X.resize(heights.size());
  place.Y.resize(heights.size());
  for (std::size_t k = 0; k < heights.size(); ++k)
  {
    const auto row = static_cast<std::int64_t>(k) / width;
    place.X[k] = static_cast<double>(static_cast<std::int64_t>(k) - row * width) + 0.5;
    place.Y[k] = static_cast<double>(row) + 0.5;
  }
  std::vector<int> done(heights.size(), 0);
  GDALRPCTransform(polynomials, FALSE, static_cast<int>(heights.size()), place.X.data(),
    place.Y.data(), heights.data(), done.data());
  for (std::size_t k = 0; k < heights.size(); ++k)
  {
    place.X[k] = done[k] != 0 ? place.X[k] : std::nan("");
    place.Y[k] = done[k] != 0 ? place.Y[k] : std::nan("");
  }
  return place;
}
}

//------------------------------------------------------------------------------
// GDAL takes the numbers of x and y as they stand, in whatever unit the CRS has.
void RasterFile::CheckUnitOfAxes()
{
  const double factor = this->FactorOfAxes(MetresOfUnit(this->Array->GetUnitOfColumns()));
  for (double& number : this->Transform)
  {
    number *= factor;
  }
}

//------------------------------------------------------------------------------
// What brings coordinates of so many metres per unit (0 for unknown) into the unit of the CRS. A
// foot for a metre, which programs often write, is the CRS's; thousands are the coordinates'.
double RasterFile::FactorOfAxes(double metres)
{
  constexpr double kSame = 1e-3;
  constexpr double kSlip = 10.0;
  const double unit = this->Reference && OSRIsProjected(this->Reference)
    ? OSRGetLinearUnits(this->Reference, nullptr)
    : 0.0;
  const double ratio = metres > 0.0 && unit > 0.0 ? metres / unit : 1.0;
  if (std::abs(ratio - 1.0) < kSame)
  {
    return 1.0;
  }
  const bool isSlip = ratio < kSlip && ratio > 1.0 / kSlip;
  this->Record.Warn("its coordinates are said to be in units of " + NumberText(metres) +
    " m, its CRS is in units of " + NumberText(unit) + " m: taken as the " +
    (isSlip ? "CRS says" : "coordinates say") + " (--crs names another CRS)");
  return isSlip ? 1.0 : ratio;
}

//------------------------------------------------------------------------------
// Points that one affine transform fits are a transform; others are not used.
void RasterFile::PlaceByPoints()
{
  if (this->HasTransform || !this->Uneven.X.empty())
  {
    return;
  }
  const int count = GDALGetGCPCount(this->Dataset);
  std::array<double, 6> transform{};
  if (count >= 3 &&
    GDALGCPsToGeoTransform(count, GDALGetGCPs(this->Dataset), transform.data(), TRUE) &&
    FitsAll(transform, GDALGetGCPs(this->Dataset), count))
  {
    // what is left of a fit is no rotation
    const double slip = kPointTolerance * std::hypot(transform[1], transform[4]);
    transform[2] *=
      std::abs(transform[2]) * static_cast<double>(this->GetHeight()) < slip ? 0.0 : 1.0;
    transform[4] *=
      std::abs(transform[4]) * static_cast<double>(this->GetWidth()) < slip ? 0.0 : 1.0;
    this->Transform = transform;
    this->HasTransform = true;
    this->Record.Take("place", "an affine transform that fits all of them",
      std::to_string(count) + " ground control points");
    this->TakeSystemOfPoints();
  }
  else if (count > 3 && this->BendToPoints(std::hypot(transform[1], transform[4])))
  {
    this->TakeSystemOfPoints();
  }
  else if (count > 0)
  {
    this->Record.Warn("it is placed by ground control points that no affine transform fits, which "
                      "are not used: warp it first (gdalwarp -dstnodata -9999 IN OUT.tif)");
  }
}

//------------------------------------------------------------------------------
void RasterFile::TakeSystemOfPoints()
{
  const std::string system = WktOf(GDALGetGCPSpatialRef(this->Dataset));
  if (!system.empty() && !this->Reference)
  {
    this->SetReference(system, "ground control points");
  }
}

//------------------------------------------------------------------------------
// Gives each sample a place of its own, by a thin plate spline through the points. False if
// there is none, or too many samples. cell: the size of one, in the unit of the points.
bool RasterFile::BendToPoints(double cell)
{
  const std::int64_t width = this->GetWidth();
  const std::int64_t height = this->GetHeight();
  const int count = GDALGetGCPCount(this->Dataset);
  if (!(cell > 0.0) || width * height > kMostBent)
  {
    return false;
  }
  const std::unique_ptr<void, void (*)(void*)> spline(
    GDALCreateTPSTransformer(count, GDALGetGCPs(this->Dataset), FALSE),
    [](void* made) { made ? GDALDestroyTPSTransformer(made) : void(); });
  const std::unique_ptr<void, void (*)(void*)> near(spline
      ? GDALCreateApproxTransformer(GDALTPSTransform, spline.get(), kPointTolerance * cell)
      : nullptr,
    [](void* made) { made ? GDALDestroyApproxTransformer(made) : void(); });
  GridPlace place;
  place.IsField = true;
  const auto columns = static_cast<std::size_t>(width);
  std::vector<double> z(columns, 0.0);
  std::vector<int> done(columns, 0);
  bool isDone = near != nullptr;
  for (std::int64_t row = 0; row < height && isDone; ++row)
  {
    for (std::int64_t column = 0; column < width; ++column)
    {
      place.X.push_back(static_cast<double>(column) + 0.5);
      place.Y.push_back(static_cast<double>(row) + 0.5);
    }
    double* x = place.X.data() + (place.X.size() - columns);
    double* y = place.Y.data() + (place.Y.size() - columns);
    isDone = GDALApproxTransform(
               near.get(), FALSE, static_cast<int>(width), x, y, z.data(), done.data()) != 0 &&
      std::all_of(x, x + columns, [](double each) { return std::isfinite(each); });
  }
  if (isDone)
  {
    this->Uneven = std::move(place);
    this->Record.Warn("no affine transform fits its " + std::to_string(count) +
      " ground control points: it is bent to them by a thin plate spline (gdalwarp "
      "-dstnodata -9999 IN OUT.tif lays a polynomial among them)");
  }
  return isDone;
}

//------------------------------------------------------------------------------
// Gives each sample the longitude and latitude that rational polynomials have for its height.
void RasterFile::PlaceByPolynomials()
{
  char** const items = GDALGetMetadata(this->Dataset, "RPC");
  GDALRPCInfoV2 polynomials{};
  if (this->HasTransform || !this->Uneven.X.empty() || !items ||
    !GDALExtractRPCInfoV2(items, &polynomials))
  {
    return;
  }
  const char* const kWarp =
    "(gdalwarp -rpc -r bilinear -t_srs EPSG:4326 -dstnodata -9999 IN OUT.tif)";
  const std::int64_t width = this->GetWidth();
  const std::int64_t count = width * this->GetHeight();
  const std::unique_ptr<void, void (*)(void*)> placed(count <= kMostBent
      ? GDALCreateRPCTransformerV2(&polynomials, FALSE, kPolynomialTolerance, nullptr)
      : nullptr,
    [](void* made) { made ? GDALDestroyRPCTransformer(made) : void(); });
  if (!placed)
  {
    this->Record.Warn(std::string("it is placed by rational polynomials (RPC), and too large to be "
                                  "resampled in memory: warp it first ") +
      kWarp);
    return;
  }
  double scale = 1.0;
  double offset = 0.0;
  this->GetScaleAndOffset(scale, offset);
  std::vector<double> heights = this->ReadHeights();
  for (double& z : heights)
  {
    z = std::isnan(z) ? polynomials.dfHEIGHT_OFF : offset + scale * z;
  }
  this->Uneven = PlacesOf(placed.get(), std::move(heights), width);
  if (this->Reference)
  {
    this->Record.Warn("the coordinate system that is given is not used: rational polynomials are "
                      "of longitude and latitude");
  }
  this->SetReference("EPSG:4326", "rational polynomials");
  this->Record.Take("place", "each sample where they put it at its height", "rational polynomials");
  this->Record.Warn(std::string("it is placed by rational polynomials (RPC): each sample is laid "
                                "where they put it at its own height, taken for one above the "
                                "ellipsoid ") +
    kWarp);
}

//------------------------------------------------------------------------------
// Of most formats GDAL does not read it.
void RasterFile::TakeSystemBeside()
{
  const std::string system =
    this->Reference || this->Coordinates ? std::string() : SystemBeside(this->Name);
  OGRSpatialReferenceH reference = MakeReference(system);
  if (reference)
  {
    OSRRelease(reference);
    this->SetReference(system, ".prj beside it");
  }
}
}
