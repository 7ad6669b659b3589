// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/GridCoordinates.h"

#include "core/grid/HeightUnits.h"
#include "raster/Words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace terrain
{
namespace
{
// Of a step: coordinates as float32 are that uneven at UTM northings.
constexpr double kLargestUnevenness = 1e-3;
// Of a step, over all of an axis: by so much places of an even grid may be off.
constexpr double kLargestDrift = 0.02;

enum class Kind
{
  None,
  Longitude,
  Latitude,
  // degrees of a rotated pole
  GridLongitude,
  GridLatitude,
  East,
  North
};

bool IsX(Kind kind)
{
  return kind == Kind::Longitude || kind == Kind::GridLongitude || kind == Kind::East;
}

bool IsY(Kind kind)
{
  return kind == Kind::Latitude || kind == Kind::GridLatitude || kind == Kind::North;
}

/// By CF's standard name or units (4.1, 4.2).
Kind KindOfAttributes(const GridAxis& axis)
{
  const std::string standard = LowerCase(axis.Get("standard_name"));
  const std::string units = LowerCase(axis.Get("units"));
  static const std::map<std::string, Kind> standards{ { "longitude", Kind::Longitude },
    { "latitude", Kind::Latitude }, { "grid_longitude", Kind::GridLongitude },
    { "grid_latitude", Kind::GridLatitude }, { "projection_x_coordinate", Kind::East },
    { "projection_y_coordinate", Kind::North } };
  const auto found = standards.find(standard);
  if (found != standards.end())
  {
    return found->second;
  }
  if (IsOneOf(
        units, { "degrees_east", "degree_east", "degrees_e", "degree_e", "degreese", "degreee" }))
  {
    return Kind::Longitude;
  }
  if (IsOneOf(
        units, { "degrees_north", "degree_north", "degrees_n", "degree_n", "degreesn", "degreen" }))
  {
    return Kind::Latitude;
  }
  return Kind::None;
}

/// By its name, where attributes say nothing.
Kind KindOfName(const GridAxis& axis)
{
  const std::string name = LowerCase(axis.Name);
  if (IsOneOf(name,
        { "lon", "longitude", "long", "lons", "xlong", "xlong_m", "nav_lon", "tlong", "tlon",
          "ulong", "lon_rho", "glamt", "nominal_longitude", "geolon", "geolon_t" }))
  {
    return Kind::Longitude;
  }
  if (IsOneOf(name,
        { "lat", "latitude", "lats", "xlat", "xlat_m", "nav_lat", "tlat", "ulat", "lat_rho",
          "gphit", "nominal_latitude", "geolat", "geolat_t" }))
  {
    return Kind::Latitude;
  }
  if (IsOneOf(name, { "rlon", "grid_longitude" }))
  {
    return Kind::GridLongitude;
  }
  if (IsOneOf(name, { "rlat", "grid_latitude" }))
  {
    return Kind::GridLatitude;
  }
  if (IsOneOf(name, { "x", "easting", "eastings", "projection_x_coordinate", "xc", "east", "e" }) ||
    LowerCase(axis.Get("axis")) == "x")
  {
    return Kind::East;
  }
  if (IsOneOf(
        name, { "y", "northing", "northings", "projection_y_coordinate", "yc", "north", "n" }) ||
    LowerCase(axis.Get("axis")) == "y")
  {
    return Kind::North;
  }
  return Kind::None;
}

Kind KindOf(const GridAxis& axis)
{
  const Kind kind = KindOfAttributes(axis);
  return kind == Kind::None ? KindOfName(axis) : kind;
}

bool IsEven(const std::vector<double>& values)
{
  const std::size_t count = values.size();
  const double step = (values.back() - values.front()) / static_cast<double>(count - 1);
  double widest = 0.0;
  double drift = 0.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    const double even = values.front() + step * static_cast<double>(k);
    drift = std::max(drift, std::abs(values[k] - even));
    widest = std::max(widest, std::abs(values[k]));
  }
  // float32 coordinates far from 0 carry the rounding of their size
  const double rounding = widest * 1.2e-7;
  return step != 0.0 &&
    drift <= std::max(kLargestUnevenness * std::abs(step),
               std::min(rounding, kLargestDrift * std::abs(step)));
}

/// Throws unless the values rise or fall all the way.
void CheckMonotonic(const GridAxis& axis, const std::vector<double>& values)
{
  const double way = values.back() - values.front();
  for (std::size_t k = 1; k < values.size(); ++k)
  {
    if (!((values[k] - values[k - 1]) * way > 0.0))
    {
      throw RasterError("the coordinates of " + axis.Name + " neither rise nor fall all the way (" +
        NumberText(values[k - 1]) + " is followed by " + NumberText(values[k]) +
        "): sort them first, or select a part in which they do");
    }
  }
}

/// Longitudes that jump by a turn at 180 degrees or Greenwich go on beyond it.
void Unwrap(std::vector<double>& longitudes)
{
  for (std::size_t k = 1; k < longitudes.size(); ++k)
  {
    const double step = longitudes[k] - longitudes[k - 1];
    if (std::abs(step) > 180.0)
    {
      longitudes[k] -= 360.0 * std::round(step / 360.0);
    }
  }
}

/// Values in metres or degrees; warns of a unit that is not known.
std::vector<double> InBaseUnit(const GridAxis& axis, Kind kind, RasterRecord& record)
{
  std::vector<double> values = axis.Values;
  const std::string units = axis.Get("units");
  double factor = 1.0;
  if (kind == Kind::East || kind == Kind::North)
  {
    const double metres = MetresOfUnit(units);
    factor = metres > 0.0 ? metres : 1.0;
    if (metres == 0.0 && !units.empty() && units != "1")
    {
      record.Warn("the unit '" + units + "' of its coordinates " + axis.Name +
        " is no length that is known; they are taken for metres");
    }
  }
  else if (LowerCase(units) == "radians" || LowerCase(units) == "radian" ||
    LowerCase(units) == "rad")
  {
    factor = 180.0 / std::acos(-1.0);
  }
  else if (IsOneOf(LowerCase(units), { "arc_minute", "arc_minutes", "arcminute", "arcminutes" }))
  {
    factor = 1.0 / 60.0;
  }
  else if (IsOneOf(LowerCase(units), { "arc_second", "arc_seconds", "arcsecond", "arcseconds" }))
  {
    factor = 1.0 / 3600.0;
  }
  std::for_each(values.begin(), values.end(), [factor](double& value) { value *= factor; });
  return values;
}

/// First coordinate and step of an axis, as corners of cells.
void FillTransform(const std::vector<double>& values, std::size_t first, double* transform)
{
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  transform[first] = values.front() - 0.5 * step;
  transform[first == 0 ? 1 : 5] = step;
}

/// The fields of longitude and latitude (or x and y), null if there are none.
std::pair<const GridAxis*, const GridAxis*> FindFields(const GridCoordinates& grid)
{
  const GridAxis* x = nullptr;
  const GridAxis* y = nullptr;
  for (const GridAxis& field : grid.Fields)
  {
    const Kind kind = KindOf(field);
    if (field.Values.size() == grid.RowCount * grid.ColumnCount)
    {
      x = !x && (kind == Kind::Longitude || kind == Kind::East) ? &field : x;
      y = !y && (kind == Kind::Latitude || kind == Kind::North) ? &field : y;
    }
  }
  if (!x || !y || (KindOf(*x) == Kind::Longitude) != (KindOf(*y) == Kind::Latitude))
  {
    return { nullptr, nullptr };
  }
  return { x, y };
}

GridPlace PlaceOfFields(const GridAxis& x, const GridAxis& y, RasterRecord& record)
{
  GridPlace place;
  place.IsField = true;
  place.IsGeographic = KindOf(x) == Kind::Longitude;
  place.X = InBaseUnit(x, KindOf(x), record);
  place.Y = InBaseUnit(y, KindOf(y), record);
  place.CoordinateSystem = place.IsGeographic ? "EPSG:4326" : "";
  record.Take(
    "place", "a longitude and a latitude for each sample", "variables " + x.Name + ", " + y.Name);
  return place;
}

/// True for numbers of samples in place of coordinates: 0, 1, 2 and so on, without a unit.
bool IsIndex(const GridAxis& axis)
{
  const std::string units = axis.Get("units");
  if (axis.Values.size() < 2 || !(units.empty() || units == "1") ||
    !axis.Get("standard_name").empty() || std::abs(axis.Values.front() - 0.5) > 0.5)
  {
    return false;
  }
  for (std::size_t k = 1; k < axis.Values.size(); ++k)
  {
    if (axis.Values[k] - axis.Values[k - 1] != 1.0)
    {
      return false;
    }
  }
  return true;
}

/// A kind for an axis that tells none, when the other one is known.
void FillInKind(Kind& kind, Kind other)
{
  if (kind != Kind::None || other == Kind::None)
  {
    return;
  }
  static const std::map<Kind, Kind> partners{ { Kind::Longitude, Kind::Latitude },
    { Kind::Latitude, Kind::Longitude }, { Kind::GridLongitude, Kind::GridLatitude },
    { Kind::GridLatitude, Kind::GridLongitude }, { Kind::East, Kind::North },
    { Kind::North, Kind::East } };
  kind = partners.at(other);
}

void CheckDegrees(
  const GridPlace& place, const GridAxis& latitude, const std::vector<double>& degrees)
{
  const auto [low, high] = std::minmax_element(degrees.begin(), degrees.end());
  if (place.IsGeographic && (*low < -91.0 || *high > 91.0))
  {
    throw RasterError("its coordinates " + latitude.Name +
      " are called latitudes, but reach from " + NumberText(*low) + " to " + NumberText(*high) +
      ": name their system (--crs EPSG:n)");
  }
}

GridPlace PlaceOfAxes(
  const GridAxis& columns, const GridAxis& rows, Kind x, Kind y, RasterRecord& record)
{
  GridPlace place;
  place.IsGeographic = x == Kind::Longitude && y == Kind::Latitude;
  place.CoordinateSystem = place.IsGeographic ? "EPSG:4326" : "";
  place.MetresPerUnit = x == Kind::East ? MetresOfUnit(columns.Get("units")) : 0.0;
  std::vector<double> alongX = InBaseUnit(columns, x, record);
  std::vector<double> alongY = InBaseUnit(rows, y, record);
  CheckDegrees(place, rows, alongY);
  if (x != Kind::East)
  {
    Unwrap(alongX);
  }
  CheckMonotonic(columns, alongX);
  CheckMonotonic(rows, alongY);
  const std::string source = "coordinates " + columns.Name + ", " + rows.Name;
  if (IsEven(alongX) && IsEven(alongY))
  {
    FillTransform(alongX, 0, place.GeoTransform.data());
    FillTransform(alongY, 3, place.GeoTransform.data());
    place.HasGeoTransform = true;
    record.Take("place",
      "cells of " + NumberText(std::abs(place.GeoTransform[1])) + " x " +
        NumberText(std::abs(place.GeoTransform[5])) + (x == Kind::East ? " m" : " degrees"),
      source);
    return place;
  }
  place.X = alongX;
  place.Y = alongY;
  record.Take("place", "unevenly spaced, resampled", source);
  return place;
}
}

//------------------------------------------------------------------------------
std::string GridAxis::Get(const std::string& attribute) const
{
  const auto found = this->Attributes.find(attribute);
  return found == this->Attributes.end() ? std::string() : found->second;
}

//------------------------------------------------------------------------------
int GridSideOf(const GridAxis& axis)
{
  const Kind kind = KindOf(axis);
  return IsX(kind) ? 1 : IsY(kind) ? 2 : 0;
}

//------------------------------------------------------------------------------
GridPlace FindGridPlace(const GridCoordinates& grid, RasterRecord& record)
{
  Kind rows = KindOf(grid.Rows);
  Kind columns = KindOf(grid.Columns);
  const bool known = rows != Kind::None || columns != Kind::None;
  FillInKind(rows, columns);
  FillInKind(columns, rows);
  const auto hasValues = [](const GridAxis& axis, std::size_t count)
  { return axis.Values.size() == count && count > 1; };
  const bool both =
    hasValues(grid.Rows, grid.RowCount) && hasValues(grid.Columns, grid.ColumnCount);
  const bool isRotated = columns == Kind::GridLongitude || rows == Kind::GridLongitude;
  const auto [x, y] = FindFields(grid);
  const bool areIndices = x && IsIndex(grid.Rows) && IsIndex(grid.Columns);
  const bool usable = known && both && !areIndices &&
    (!isRotated || !SystemOfGridMapping(grid.GridMapping).empty()) &&
    ((IsX(columns) && IsY(rows)) || (IsY(columns) && IsX(rows)));
  if (!usable)
  {
    if (!x && isRotated && both)
    {
      throw RasterError("its coordinates " + grid.Columns.Name + ", " + grid.Rows.Name +
        " count from a rotated pole, which it does not tell: name it (--crs), or give the grid "
        "mapping "
        "with the samples (xarray.open_dataset with decode_coords='all')");
    }
    return x ? PlaceOfFields(*x, *y, record) : GridPlace();
  }
  if (IsX(columns))
  {
    return PlaceOfAxes(grid.Columns, grid.Rows, columns, rows, record);
  }
  GridPlace place = PlaceOfAxes(grid.Rows, grid.Columns, rows, columns, record);
  place.IsTransposed = true;
  record.Take(
    "order", "the first dimension, " + grid.Rows.Name + ", runs east: turned over", "coordinates");
  return place;
}

//------------------------------------------------------------------------------
std::string SystemOfGridMapping(const std::map<std::string, std::string>& attributes)
{
  const auto get = [&attributes](const char* name)
  {
    const auto found = attributes.find(name);
    return found == attributes.end() ? std::string() : found->second;
  };
  for (const char* name : { "crs_wkt", "spatial_ref", "proj4", "proj4_params" })
  {
    if (!get(name).empty())
    {
      return get(name);
    }
  }
  if (get("grid_mapping_name") == "rotated_latitude_longitude")
  {
    const double longitude = std::atof(get("grid_north_pole_longitude").c_str());
    const double radius = std::atof(get("earth_radius").c_str());
    const std::string body = radius > 0.0 ? " +R=" + get("earth_radius") : " +datum=WGS84";
    const std::string poleLongitude = get("north_pole_grid_longitude");
    return "+proj=ob_tran +o_proj=longlat +o_lon_p=" +
      (poleLongitude.empty() ? "0" : poleLongitude) +
      " +o_lat_p=" + get("grid_north_pole_latitude") + " +lon_0=" + NumberText(longitude + 180.0) +
      body + " +no_defs +type=crs";
  }
  return {};
}
}
