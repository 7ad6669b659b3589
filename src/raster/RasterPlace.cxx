// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of RasterFile that finds where the samples lie.
#include "raster/RasterFile.h"

#include "core/grid/Constants.h"
#include "raster/CoordinateSystem.h"
#include "raster/GDALTable.h"
#include "raster/PointText.h"
#include "raster/RasterArray.h"
#include "raster/RasterReference.h"
#include "raster/RasterRepairs.h"
#include "raster/SystemAxes.h"

#include <GeographicLib/Ellipsoid.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <utility>

namespace terrain
{
namespace
{
// Samples of a sheared raster, which is resampled in memory.
constexpr std::int64_t kMostSheared = std::int64_t{ 1 } << 27;
// Metres per degree of longitude are never less than this share of those at the equator.
constexpr double kPoleShare = 1e-6;

void CheckAxes(const std::array<double, 6>& transform)
{
  const bool finite =
    std::all_of(transform.begin(), transform.end(), [](double x) { return std::isfinite(x); });
  if (!finite || transform[1] * transform[5] == transform[2] * transform[4])
  {
    throw RasterError("its georeference is degenerate (gdal_translate -a_ullr X0 Y1 X1 Y0 IN "
                      "OUT.tif places it)");
  }
}

/// True if rows do not run east.
bool IsSheared(const std::array<double, 6>& transform, double width, double height)
{
  return std::fabs(transform[2]) * height > kShearTolerance * std::fabs(transform[1]) ||
    std::fabs(transform[4]) * width > kShearTolerance * std::fabs(transform[5]);
}

/// Degrees to metres, true at the centre of the file, which becomes x = 0, y = 0.
/// remedy: what to do where they are none.
void LayOutDegrees(OGRSpatialReferenceH srs, double width, double height, const std::string& remedy,
  RasterLayout& layout)
{
  const std::array<double, 6>& transform = layout.GeoTransform;
  const double degrees = OSRGetAngularUnits(srs, nullptr) / kDegree; // per unit
  layout.Origin = { { transform[0] + 0.5 * width * transform[1],
    transform[3] + 0.5 * height * transform[5] } };
  const double latitude = layout.Origin[1] * degrees;
  const double extent = std::fabs(width * transform[1]) * degrees;
  // Half a cell beyond a pole, or repeated columns, are usual in global grids; what goes round more
  // than twice is none.
  const double slack = std::fabs(transform[1] * degrees) + 1e-6;
  if (std::fabs(latitude) > 90.0 || extent > 720.0 + slack)
  {
    std::ostringstream text;
    text << "its CRS is in degrees, but its centre lies at latitude " << latitude << " and it is "
         << extent << " degrees wide (--crs names the right one" << remedy << ")";
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

bool LooksLikeDegrees(const std::array<double, 6>& t, double width, double height)
{
  constexpr double kLargestCell = 0.5;
  const auto within = [](double a, double b, double limit)
  { return std::max(std::fabs(a), std::fabs(b)) <= limit; };
  return std::fabs(t[1]) < kLargestCell && within(t[0], t[0] + width * t[1], 360.0) &&
    within(t[3], t[3] + height * t[5], 90.01);
}

/// All samples of a raster that holds coordinates; empty if it cannot be read.
std::vector<double> ReadCoordinates(const char* name, const char* band, int width, int height)
{
  std::vector<double> values;
  GDALDatasetH dataset = name ? GDALOpen(name, GA_ReadOnly) : nullptr;
  if (!dataset)
  {
    return values;
  }
  const int columns = GDALGetRasterXSize(dataset);
  const int rows = GDALGetRasterYSize(dataset);
  if (columns == width && rows == height)
  {
    values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (GDALRasterIO(GDALGetRasterBand(dataset, band ? std::atoi(band) : 1), GF_Read, 0, 0, width,
          height, values.data(), width, height, GDT_Float64, 0, 0) != CE_None)
    {
      values.clear();
    }
  }
  GDALClose(dataset);
  return values;
}
}

//------------------------------------------------------------------------------
void RasterFile::SetReference(const std::string& definition, const std::string& source)
{
  OGRSpatialReferenceH reference = MakeReference(definition);
  if (!reference)
  {
    throw RasterError("the coordinate system '" + definition + "' is not understood");
  }
  if (this->Reference)
  {
    OSRRelease(this->Reference);
  }
  this->Reference = reference;
  this->Record.Take("CRS", NameOfSystem(definition), source);
}

//------------------------------------------------------------------------------
// True if GDAL says no place, or warned that what it says is not so.
bool RasterFile::NeedsCoordinates() const
{
  if (!this->Reference || !this->HasTransform)
  {
    return true;
  }
  const std::vector<std::string>& warnings = this->Record.GetWarnings();
  return std::any_of(warnings.begin(), warnings.end(),
    [](const std::string& warning)
    {
      return warning.find("spaced evenly") != std::string::npos ||
        warning.find("evenly spaced") != std::string::npos ||
        warning.find("is not a Lo") != std::string::npos ||
        warning.find("is not a La") != std::string::npos;
    });
}

//------------------------------------------------------------------------------
void RasterFile::TakePlace(const GridPlace& place, const std::string& system)
{
  if (!place.HasGeoTransform && place.X.empty())
  {
    return;
  }
  this->Record.Forget("dimension");
  this->Record.Forget("spaced evenly");
  this->Transform = place.GeoTransform;
  this->HasTransform = place.HasGeoTransform;
  this->Uneven = place;
  const std::string derived = place.CoordinateSystem;
  const bool isField = place.IsField && place.IsGeographic;
  if (!isField && !system.empty())
  {
    this->SetReference(system, "grid mapping");
  }
  else if (!derived.empty() && (isField || !this->Reference))
  {
    this->SetReference(derived, "longitude and latitude without a datum: taken for WGS 84");
  }
  if (place.MetresPerUnit > 0.0)
  {
    const double factor = this->FactorOfAxes(place.MetresPerUnit) / place.MetresPerUnit;
    const bool isProjected = this->Reference && OSRIsProjected(this->Reference);
    for (std::vector<double>* axis : { &this->Uneven.X, &this->Uneven.Y })
    {
      std::for_each(
        axis->begin(), axis->end(), [&](double& number) { number *= isProjected ? factor : 1.0; });
    }
    for (double& number : this->Transform)
    {
      number *= isProjected ? factor : 1.0;
    }
  }
}

//------------------------------------------------------------------------------
void RasterFile::PlaceByArray(const std::string& given)
{
  std::string file;
  std::string variable;
  SplitArrayName(this->Name, file, variable);
  const char* own = GDALGetMetadataItem(this->Band, "NETCDF_VARNAME", nullptr);
  GDALDriverH driver = GDALGetDatasetDriver(this->Dataset);
  const std::string format = driver ? GDALGetDriverShortName(driver) : "";
  if (format != "netCDF" && format != "Zarr" && format != "HDF5Image")
  {
    return;
  }
  this->Array = RasterArray::Open(file, own && variable.empty() ? own : variable);
  if (!this->Array)
  {
    return;
  }
  this->Attributes = this->Array->GetAttributes();
  const auto hint = [this](const char* name)
  {
    const char* item = GDALGetMetadataItem(this->Band, name, nullptr);
    return std::string(item ? item : "");
  };
  this->Attributes["NETCDF_VARNAME"] = own ? own : variable;
  if (const std::string missing = hint("missing_value"); !missing.empty()) // arrays keep it back
  {
    this->Attributes["missing_value"] = missing;
  }
  this->Array->SetHints(hint("coordinates"), hint("grid_mapping"));
  if (!this->NeedsCoordinates())
  {
    this->CheckUnitOfAxes();
    return;
  }
  GridCoordinates grid = this->Array->GetCoordinates();
  if (!given.empty())
  {
    grid.GridMapping = { { "crs_wkt", given } };
  }
  const GridPlace place = FindGridPlace(grid, this->Record);
  if (!place.HasGeoTransform && place.X.empty())
  {
    return;
  }
  GDALDatasetH dataset = this->Array->ToDataset(place.IsTransposed);
  this->Replaced = false;
  GDALClose(this->Dataset);
  this->Dataset = dataset;
  this->Band = GDALGetRasterBand(this->Dataset, this->BandNumber);
  if (!this->Band)
  {
    throw RasterError("its array has no layer " + std::to_string(this->BandNumber));
  }
  this->TakePlace(place, SystemOfGridMapping(grid.GridMapping));
}

//------------------------------------------------------------------------------
void RasterFile::PlaceByMemory(const std::string& given)
{
  if (!this->CoordinatesSystem.empty())
  {
    this->SetReference(this->CoordinatesSystem, "given with the samples");
  }
  if (!given.empty())
  {
    this->Coordinates->GridMapping = { { "crs_wkt", given } };
  }
  const GridPlace place = FindGridPlace(*this->Coordinates, this->Record);
  if (place.IsTransposed)
  {
    this->Replace(MakeTransposed(this->Dataset, this->BandNumber));
  }
  this->TakePlace(place,
    this->CoordinatesSystem.empty() || (place.IsField && place.IsGeographic)
      ? SystemOfGridMapping(this->Coordinates->GridMapping)
      : std::string());
}

//------------------------------------------------------------------------------
// GDAL's metadata domain of arrays of coordinates.
void RasterFile::PlaceByGeolocation()
{
  const char* const* items = GDALGetMetadata(this->Dataset, "GEOLOCATION");
  if (!items || this->HasTransform || !this->Uneven.X.empty())
  {
    return;
  }
  const auto item = [items](const char* name) { return CSLFetchNameValue(items, name); };
  const auto width = static_cast<int>(this->GetWidth());
  const auto height = static_cast<int>(this->GetHeight());
  GridPlace place;
  place.X = ReadCoordinates(item("X_DATASET"), item("X_BAND"), width, height);
  place.Y = ReadCoordinates(item("Y_DATASET"), item("Y_BAND"), width, height);
  if (place.X.empty() || place.Y.empty())
  {
    this->Record.Warn(
      "it is placed by arrays of coordinates of another size than its own, which are not "
      "used: warp it to an even grid first (gdalwarp -geoloc -dstnodata -9999 IN OUT.tif)");
    return;
  }
  place.IsField = true;
  const std::string system = item("SRS") ? item("SRS") : "EPSG:4326";
  OGRSpatialReferenceH reference = MakeReference(system);
  place.IsGeographic = !reference || OSRIsGeographic(reference);
  if (reference)
  {
    OSRRelease(reference);
  }
  this->TakePlace(place, std::string());
  this->SetReference(system, "geolocation arrays");
  this->Record.Take("place", "a longitude and a latitude for each sample", "geolocation arrays");
}

//------------------------------------------------------------------------------
// Texts of which GDAL's drivers read numbers only.
void RasterFile::PlaceByText()
{
  GDALDriverH driver = GDALGetDatasetDriver(this->Dataset);
  const std::string format = driver ? GDALGetDriverShortName(driver) : "";
  if (format == "AAIGrid" && ReadGridHeader(this->Name, this->Transform))
  {
    this->HasTransform = true;
    this->Record.Take("place", "corner along one axis, centre along the other", "header");
  }
  if (format == "XYZ")
  {
    this->PlaceByColumns(ReadColumnNames(this->Name));
  }
}

//------------------------------------------------------------------------------
// Points of a text whose first line names its columns. GDAL warns where it does not know all three,
// and takes the first three as x, y, z; where they are others, OpenPointText reads the file.
void RasterFile::PlaceByColumns(const std::vector<std::string>& names)
{
  const std::optional<PointColumns> columns = FindPointColumns(names);
  if (!columns)
  {
    return;
  }
  this->Record.Forget(kDefaultedColumns);
  if (AreDegrees(names, *columns) && !this->Reference)
  {
    this->SetReference(
      "EPSG:4326", "columns " + names[(*columns)[0]] + ", " + names[(*columns)[1]]);
  }
}

//------------------------------------------------------------------------------
// Makes x east and y north where the axes of the CRS point west or south.
void RasterFile::TurnFileAxes()
{
  if (!this->Reference || !this->HasTransform)
  {
    return;
  }
  const std::array<double, 6> t = this->Transform;
  const std::array<double, 2> middle = { t[0] + 0.5 * static_cast<double>(this->GetWidth()) * t[1],
    t[3] + 0.5 * static_cast<double>(this->GetHeight()) * t[5] };
  bool isGuessed = false;
  const FileAxes axes = FindFileAxes(this->Reference, middle, isGuessed);
  if (axes.IsSwapped)
  {
    this->Replace(MakeTransposed(this->Dataset, this->BandNumber));
    this->Transform = { axes.Sign[0] * t[3], axes.Sign[0] * t[5], axes.Sign[0] * t[4],
      axes.Sign[1] * t[0], axes.Sign[1] * t[2], axes.Sign[1] * t[1] };
  }
  else
  {
    this->Transform = { axes.Sign[0] * t[0], axes.Sign[0] * t[1], axes.Sign[0] * t[2],
      axes.Sign[1] * t[3], axes.Sign[1] * t[4], axes.Sign[1] * t[5] };
  }
  if (axes.IsSwapped || axes.Sign[0] < 0.0 || axes.Sign[1] < 0.0)
  {
    this->Turned = true;
    this->Record.Take("axes", "turned to x east, y north", "axes of the CRS point west or south");
  }
  if (isGuessed)
  {
    this->Record.Warn(
      "the axes of its CRS point west or south, by which it would lie outside of the area "
      "that the CRS is for: its coordinates are taken for east and north (--flip if that is "
      "upside down)");
  }
}

//------------------------------------------------------------------------------
// Rows that do not run east: each sample has coordinates of its own.
void RasterFile::PlaceSheared()
{
  const std::array<double, 6> t = this->Transform;
  const std::int64_t width = this->GetWidth();
  const std::int64_t height = this->GetHeight();
  if (!this->HasTransform || !IsSheared(t, static_cast<double>(width), static_cast<double>(height)))
  {
    return;
  }
  CheckAxes(t);
  if (width * height > kMostSheared)
  {
    throw RasterError("its rows do not run east (rotated or sheared georeference), and it is too "
                      "large to be resampled in memory; warp it to a north-up grid first (gdalwarp "
                      "-dstnodata -9999 IN OUT.tif)");
  }
  GridPlace place;
  place.IsField = true;
  place.IsGeographic = this->Reference && OSRIsGeographic(this->Reference);
  place.X.reserve(static_cast<std::size_t>(width * height));
  place.Y.reserve(static_cast<std::size_t>(width * height));
  for (std::int64_t row = 0; row < height; ++row)
  {
    for (std::int64_t column = 0; column < width; ++column)
    {
      const double c = static_cast<double>(column) + 0.5;
      const double r = static_cast<double>(row) + 0.5;
      place.X.push_back(t[0] + c * t[1] + r * t[2]);
      place.Y.push_back(t[3] + c * t[4] + r * t[5]);
    }
  }
  this->Uneven = std::move(place);
  this->Record.Take("rows", "do not run east: resampled", "rotated or sheared geotransform");
}

//------------------------------------------------------------------------------
// What to do where a file in degrees lies outside of the area of its CRS, but not if its longitude
// and latitude are exchanged; empty where they are not.
std::string RasterFile::FindExchanged() const
{
  const std::array<double, 6>& t = this->Transform;
  const double width = static_cast<double>(this->GetWidth()) * t[1];
  const double height = static_cast<double>(this->GetHeight()) * t[5];
  const double x = t[0] + 0.5 * width;
  const double y = t[3] + 0.5 * height;
  const double degree = OSRGetAngularUnits(this->Reference, nullptr) / kDegree;
  const auto isInside = [&](double east, double north)
  { return std::abs(north * degree) <= 90.0 && IsInArea(this->Reference, east, north); };
  if (isInside(x, y) || !isInside(y, x))
  {
    return {};
  }
  const std::string told = "; if its longitude and latitude are exchanged, ";
  if (!IsCalledPoints(this->Name))
  {
    return told +
      CPLSPrintf("gdal_translate -a_ullr %.10g %.10g %.10g %.10g IN OUT.tif puts them right", t[3],
        t[0], t[3] + width, t[0] + height);
  }
  std::vector<std::string> names = ReadColumnNames(this->Name);
  const std::string rows = names.empty() ? "cat IN" : "tail -n +2 IN";
  const PointColumns columns = FindPointColumns(names).value_or(PointColumns{ { 0, 1, 2 } });
  names.resize(std::max(names.size(), columns.size()), "");
  names[columns[0]] = "lat";
  names[columns[1]] = "lon";
  names[columns[2]] = "z";
  std::string header;
  for (const std::string& name : names)
  {
    header += (header.empty() ? "" : ",") + name;
  }
  return told + "(echo '" + header + "'; " + rows + " | tr -s ' ;\\t' ,) > OUT.csv puts them right";
}

//------------------------------------------------------------------------------
// Degrees in a projected CRS: outside of its area, or far too high for metres.
bool RasterFile::HasDegreesForMetres() const
{
  constexpr double kSteepest = 3.0;
  const double width = static_cast<double>(this->GetWidth());
  const double height = static_cast<double>(this->GetHeight());
  const std::array<double, 6>& t = this->Transform;
  if (!this->HasTransform || !this->Reference || !OSRIsProjected(this->Reference) ||
    !LooksLikeDegrees(t, width, height))
  {
    return false;
  }
  const double longest = std::max(std::abs(width * t[1]), std::abs(height * t[5]));
  return this->Holes.Seen.High - this->Holes.Seen.Low > kSteepest * longest ||
    !IsInArea(this->Reference, t[0] + 0.5 * width * t[1], t[3] + 0.5 * height * t[5]);
}

//------------------------------------------------------------------------------
void RasterFile::WarnOfPlace()
{
  const auto width = static_cast<double>(this->GetWidth());
  const auto height = static_cast<double>(this->GetHeight());
  if (this->HasDegreesForMetres())
  {
    this->Record.Warn("its CRS, " + NameOfSystem(this->Layout.CRS) +
      ", is not in degrees, but where it lies looks like degrees (--crs EPSG:4326 for longitude "
      "and "
      "latitude)");
  }
  const std::string exchanged =
    this->HasTransform && this->Reference && OSRIsGeographic(this->Reference)
    ? this->FindExchanged()
    : std::string();
  if (!exchanged.empty())
  {
    this->Record.Warn("it lies outside of the area that its CRS is for" + exchanged);
  }
  if (this->HasTransform && !this->Reference && LooksLikeDegrees(this->Transform, width, height))
  {
    this->Record.Warn(
      "it has no CRS and its coordinates look like degrees; they are taken for metres "
      "(--crs EPSG:4326 for longitude and latitude)");
  }
  if (!this->HasTransform && this->Reference)
  {
    this->Record.Warn(
      "it names a CRS, but not where in it the samples lie; they are laid 1 m apart "
      "(gdal_translate -a_ullr X0 Y1 X1 Y0 IN OUT.tif places it)");
  }
  if (!this->HasTransform)
  {
    this->Record.Take("place", "none: samples lie 1 apart", "the file names none");
  }
}

//------------------------------------------------------------------------------
void RasterFile::FindPlace(const RasterOptions& options)
{
  const GDALMessages messages;
  if (OGRSpatialReferenceH own = GDALGetSpatialRef(this->Dataset))
  {
    this->Reference = OSRClone(own);
    this->Record.Take("CRS", NameOfSystem(WktOf(own)), "file");
  }
  std::array<double, 6> transform{};
  if (GDALGetGeoTransform(this->Dataset, transform.data()) == CE_None &&
    transform != this->Transform)
  {
    this->Transform = transform; // GDAL gives the identity for none
    this->HasTransform = true;
    this->Record.Take("place",
      "cells of " + NumberText(std::abs(transform[1])) + " x " + NumberText(std::abs(transform[5])),
      "geotransform");
  }
  // GDAL gives the rows of Terragen's files from the north, and a transform that says the south.
  GDALDriverH driver = GDALGetDatasetDriver(this->Dataset);
  if (driver && EQUAL(GDALGetDriverShortName(driver), "Terragen") && this->Transform[5] > 0.0)
  {
    this->Transform[3] += this->Transform[5] * static_cast<double>(this->GetHeight());
    this->Transform[5] = -this->Transform[5];
  }
  if (this->Coordinates)
  {
    this->PlaceByMemory(options.CoordinateSystem);
  }
  else
  {
    this->PlaceByArray(options.CoordinateSystem);
    this->PlaceByText();
    this->PlaceByGeolocation();
    this->PlaceByPoints();
    this->TakeSystemBeside();
  }
  if (!options.CoordinateSystem.empty())
  {
    const bool isField = this->Uneven.IsField && this->Uneven.IsGeographic;
    if (CoordinateSystem::ToWkt(options.CoordinateSystem).empty())
    {
      throw RasterError(
        "the coordinate system '" + options.CoordinateSystem + "' is not understood");
    }
    if (isField)
    {
      this->Record.Warn(
        "the coordinate system that is given is not used: each sample has a longitude and a "
        "latitude of its own");
    }
    else
    {
      this->SetReference(options.CoordinateSystem, "given");
    }
  }
}

//------------------------------------------------------------------------------
void RasterFile::MakeLayout()
{
  const GDALMessages messages;
  const auto width = static_cast<double>(this->GetWidth());
  const auto height = static_cast<double>(this->GetHeight());
  this->Layout.CRS = WktOf(this->Reference);
  if (!this->HasTransform)
  {
    return;
  }
  this->Layout.GeoTransform = this->Transform;
  this->Layout.HasGeoTransform = true;
  this->Layout.NorthFirst = this->Transform[5] < 0.0;
  this->Layout.EastFirst = this->Transform[1] < 0.0;
  CheckAxes(this->Transform);
  if (this->Reference && OSRIsGeographic(this->Reference))
  {
    LayOutDegrees(this->Reference, width, height, this->FindExchanged(), this->Layout);
  }
  else if (this->Reference)
  {
    const double unit = OSRGetLinearUnits(this->Reference, nullptr);
    this->Layout.Scale = { { unit > 0.0 ? unit : 1.0, unit > 0.0 ? unit : 1.0 } };
  }
}
}
