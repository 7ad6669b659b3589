// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/CoordinateSystem.h"

#include "core/grid/Constants.h"
#include "raster/GDALTable.h"
#include "raster/RasterMessages.h"
#include "raster/RasterReference.h"
#include "raster/SystemAxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <sstream>
#include <vector>

namespace terrain
{
namespace
{
using Reference = std::unique_ptr<void, void (*)(void*)>;

// Points transformed by one call of OGR.
constexpr std::int64_t kBatch = 1024;
// No system has coordinates beyond, in any unit. OGR brings those of EPSG:3857 to one turn by
// taking a turn off at a time, which does not end for large numbers (GDAL 3.6).
constexpr double kFarthest = 1e12;

Reference NewReference()
{
  Reference reference(OSRNewSpatialReference(nullptr), OSRRelease);
  OSRSetAxisMappingStrategy(reference.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

std::string Wkt(OGRSpatialReferenceH reference)
{
  char* text = nullptr;
  const char* const options[] = { "FORMAT=WKT2_2018", nullptr };
  std::string result;
  if (OSRExportToWktEx(reference, &text, options) == OGRERR_NONE && text)
  {
    result = text;
  }
  CPLFree(text);
  return result;
}

std::string Attribute(OGRSpatialReferenceH reference, const char* name)
{
  const char* value = OSRGetAttrValue(reference, name, 0);
  return value ? value : "";
}

/// True if the ellipsoid is none of the earth: a planet's or a moon's.
bool IsOfOtherWorld(OGRSpatialReferenceH reference)
{
  constexpr double kEarth = 6378137.0;
  constexpr double kSame = 0.01; // ellipsoids and spheres of the earth differ by 0.4 % at most
  OGRErr error = OGRERR_NONE;
  const double radius = OSRGetSemiMajor(reference, &error);
  return error == OGRERR_NONE && std::abs(radius / kEarth - 1.0) > kSame;
}

/// True if an axis of longitude and latitude points west: planetographic systems of what turns
/// forward.
bool CountsLongitudeWest(OGRSpatialReferenceH reference)
{
  bool west = false;
  for (int axis = 0; axis < 2; ++axis)
  {
    OGRAxisOrientation orientation = OAO_Other;
    OSRGetAxis(reference, nullptr, axis, &orientation);
    west = west || orientation == OAO_West;
  }
  return west;
}

/// A definition of longitude, counted east, and latitude on an ellipsoid, for messages; on a sphere
/// if the semi-axes are alike.
std::string DegreesEastOn(double semiMajor, double semiMinor)
{
  std::ostringstream text;
  text.precision(12);
  text << "--crs '+proj=longlat +a=" << semiMajor << " +b=" << semiMinor << "'";
  return text.str();
}

/// True for longitude and planetocentric latitude.
bool IsPlanetocentric(OGRSpatialReferenceH reference)
{
  return Wkt(reference).find("CS[spherical") != std::string::npos;
}

/// The beginning of a long definition, in one line, for messages.
std::string Shortened(std::string text)
{
  constexpr std::size_t kLongest = 60;
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}
}

/// Transformations to and from WGS84, each used by one thread at a time.
class CoordinateSystem::Pool
{
public:
  Pool(OGRSpatialReferenceH from, OGRSpatialReferenceH to)
    : Masters{ OCTNewCoordinateTransformation(from, to), OCTNewCoordinateTransformation(to, from) }
  {
  }

  ~Pool()
  {
    for (int way = 0; way < 2; ++way)
    {
      for (OGRCoordinateTransformationH idle : this->Idle[way])
      {
        OCTDestroyCoordinateTransformation(idle);
      }
      if (this->Masters[way])
      {
        OCTDestroyCoordinateTransformation(this->Masters[way]);
      }
    }
  }

  Pool(const Pool&) = delete;
  void operator=(const Pool&) = delete;

  bool IsComplete() const
  {
    return this->Masters[0] && this->Masters[1];
  }

  OGRCoordinateTransformationH Take(int way)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Idle[way].empty())
    {
      return OCTClone(this->Masters[way]);
    }
    OGRCoordinateTransformationH taken = this->Idle[way].back();
    this->Idle[way].pop_back();
    return taken;
  }

  void GiveBack(int way, OGRCoordinateTransformationH taken)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Idle[way].push_back(taken);
  }

private:
  std::array<OGRCoordinateTransformationH, 2> Masters;
  std::array<std::vector<OGRCoordinateTransformationH>, 2> Idle;
  std::mutex Mutex;
};

CoordinateSystem::CoordinateSystem() = default;
CoordinateSystem::~CoordinateSystem() = default;

std::string CoordinateSystem::Read(const std::string& definition)
{
  this->TheKind = Kind::None;
  this->Name.clear();
  this->Metres = this->Degrees = 1.0;
  this->VerticalName.clear();
  this->VerticalMetres = 0.0;
  this->EllipsoidalHeights = this->IsPlaces = false;
  this->Transformations.reset();
  if (definition.empty())
  {
    return {};
  }
  if (!WhyNoGDAL().empty())
  {
    return WhyNoGDAL();
  }

  const GDALMessages messages;
  const Reference whole = NewReference();
  if (!DefineReference(whole.get(), definition))
  {
    const std::string& reason = messages.GetFailure();
    return "the coordinate system '" + Shortened(definition) + "' is not understood" +
      (reason.empty() ? "" : " (" + reason + ")");
  }
  const char* name = OSRGetName(whole.get());
  this->Name = name ? name : "unnamed";
  if (OSRIsLocal(whole.get()))
  {
    this->TheKind = Kind::Engineering;
    this->Metres = OSRGetLinearUnits(whole.get(), nullptr);
    return {};
  }
  this->ReadVertical(whole.get());
  const Reference flat(OSRClone(whole.get()), OSRRelease);
  OSRDemoteTo2D(flat.get(), nullptr);
  if (OSRIsCompound(flat.get()))
  {
    OSRStripVertical(flat.get());
  }
  TurnAxes(flat.get());
  return this->ReadFlat(flat.get());
}

void CoordinateSystem::ReadVertical(void* whole)
{
  if (OSRIsCompound(whole))
  {
    this->VerticalName = Attribute(whole, "COMPD_CS|VERT_CS");
    this->VerticalMetres = OSRGetTargetLinearUnits(whole, "VERT_CS", nullptr);
  }
  else if (OSRGetAxesCount(whole) == 3 && !OSRIsGeocentric(whole))
  {
    this->VerticalName = "height above the ellipsoid";
    this->EllipsoidalHeights = true;
  }
}

std::string CoordinateSystem::ReadFlat(void* flat)
{
  const bool projected = OSRIsProjected(flat) != 0;
  if (!projected && IsPlanetocentric(flat))
  {
    this->TheKind = Kind::Geographic; // degrees, of which no metres can be made
    const double radius = OSRGetSemiMajor(flat, nullptr);
    return "the coordinate system '" + this->Name +
      "' counts latitudes from the centre of an ellipsoid, which is not supported: name the sphere "
      "if that is meant (" +
      DegreesEastOn(radius, radius) + ")";
  }
  if (!projected && !OSRIsGeographic(flat))
  {
    return "the coordinate system '" + this->Name +
      "' is neither a map projection nor longitude and latitude";
  }
  this->SemiMajor = OSRGetSemiMajor(flat, nullptr);
  this->SemiMinor = OSRGetSemiMinor(flat, nullptr);
  this->CountsWest = !projected && CountsLongitudeWest(flat);
  if (IsOfOtherWorld(flat))
  {
    this->JoinOtherWorld(flat, projected);
    return {};
  }
  return this->JoinEarth(flat, projected);
}

void CoordinateSystem::JoinOtherWorld(void* flat, bool projected)
{
  this->TheKind = Kind::OtherWorld;
  this->Metres = projected ? OSRGetLinearUnits(flat, nullptr) : 1.0;
  this->Degrees = projected ? 0.0 : OSRGetAngularUnits(flat, nullptr) / kDegree;
  const Reference own(OSRCloneGeogCS(flat), OSRRelease);
  TurnAxes(own.get());
  this->Transformations = std::make_unique<Pool>(flat, own.get());
}

std::string CoordinateSystem::JoinEarth(void* flat, bool projected)
{
  const Reference places = NewReference();
  if (OSRImportFromEPSG(places.get(), 4326) != OGRERR_NONE)
  {
    return "PROJ's database of coordinate systems (proj.db) is not found";
  }
  if (projected)
  {
    this->Metres = OSRGetLinearUnits(flat, nullptr);
  }
  else
  {
    this->Degrees = OSRGetAngularUnits(flat, nullptr) / kDegree;
    const char* const options[] = { "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
      "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS", nullptr };
    this->IsPlaces = OSRIsSameEx(flat, places.get(), options) != 0;
  }
  this->Transformations = std::make_unique<Pool>(flat, places.get());
  if (!this->Transformations->IsComplete())
  {
    return "no transformation is known from '" + this->Name + "' to longitude and latitude";
  }
  this->TheKind = projected ? Kind::Projected : Kind::Geographic;
  return {};
}

bool CoordinateSystem::HasPlaces() const
{
  return this->IsOnEarth() ||
    (this->TheKind == Kind::OtherWorld && this->Transformations->IsComplete());
}

std::string CoordinateSystem::WhyNotLongitudeLatitude() const
{
  if (!this->IsInDegrees())
  {
    return "a globe needs heights in longitude and latitude, and '" + this->Name +
      "' is none: bring them to degrees first (gdalwarp -t_srs EPSG:4326 for the earth)";
  }
  return this->CountsWest ? "the coordinate system '" + this->Name +
      "' counts longitudes to the west: if those of the heights grow to the east, name one that "
      "counts so (" +
      DegreesEastOn(this->SemiMajor, this->SemiMinor) + ")"
                          : std::string();
}

bool CoordinateSystem::Transform(double* points, std::int64_t count, int stride, bool forward) const
{
  const GDALMessages messages;
  const int way = forward ? 0 : 1;
  OGRCoordinateTransformationH transformation = this->Transformations->Take(way);
  if (!transformation)
  {
    return false;
  }
  std::array<double, kBatch> x{};
  std::array<double, kBatch> y{};
  std::array<int, kBatch> good{};
  for (std::int64_t begin = 0; begin < count; begin += kBatch)
  {
    const std::int64_t size = std::min(kBatch, count - begin);
    double* batch = points + begin * stride;
    for (std::int64_t i = 0; i < size; ++i)
    {
      x[i] = batch[i * stride];
      y[i] = batch[i * stride + 1];
      if (!(std::abs(x[i]) <= kFarthest && std::abs(y[i]) <= kFarthest))
      {
        x[i] = y[i] = HUGE_VAL; // which OGR leaves alone
      }
    }
    OCTTransformEx(
      transformation, static_cast<int>(size), x.data(), y.data(), nullptr, good.data());
    for (std::int64_t i = 0; i < size; ++i)
    {
      const bool found = good[i] && std::isfinite(x[i]) && std::isfinite(y[i]);
      batch[i * stride] = found ? x[i] : std::numeric_limits<double>::quiet_NaN();
      batch[i * stride + 1] = found ? y[i] : std::numeric_limits<double>::quiet_NaN();
    }
  }
  this->Transformations->GiveBack(way, transformation);
  return true;
}

bool CoordinateSystem::ToPlaces(double* points, std::int64_t count, int stride) const
{
  if (!this->HasPlaces())
  {
    return false;
  }
  if (!this->IsPlaces)
  {
    return this->Transform(points, count, stride, true);
  }
  for (std::int64_t i = 0; i < count; ++i)
  {
    double* point = points + i * stride;
    if (!(std::abs(point[1]) <= 90.0) || !std::isfinite(point[0]))
    {
      point[0] = point[1] = std::numeric_limits<double>::quiet_NaN();
    }
    else if (std::abs(point[0]) > 180.0)
    {
      point[0] = std::remainder(point[0], 360.0);
    }
  }
  return true;
}

bool CoordinateSystem::FromPlaces(
  double* points, std::int64_t count, double nearX, int stride) const
{
  if (!this->HasPlaces() || (!this->IsPlaces && !this->Transform(points, count, stride, false)))
  {
    return false;
  }
  if (this->IsInDegrees())
  {
    const double turn = 360.0 / this->Degrees;
    for (std::int64_t i = 0; i < count; ++i)
    {
      double& x = points[i * stride];
      x = std::abs(x - nearX) <= 0.5 * turn ? x : nearX + std::remainder(x - nearX, turn);
    }
  }
  return true;
}

std::string CoordinateSystem::ToWkt(const std::string& definition)
{
  if (!WhyNoGDAL().empty())
  {
    return {};
  }
  const GDALMessages messages;
  const Reference reference = NewReference();
  return DefineReference(reference.get(), definition) ? Wkt(reference.get()) : std::string();
}
}
