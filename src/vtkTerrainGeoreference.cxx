// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGeoreference.h"

#include "core/grid/Constants.h"
#include "core/grid/HeightUnits.h"
#include "core/place/Geodesics.h"
#include "core/place/GridReference.h"
#include "data/Setting.h"
#include "place/GeoreferenceInternals.h"

#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace
{
using terrain::kNaN;
// Points handed to one thread at a time.
constexpr vtkIdType kPointsPerTask = 4096;
}

vtkStandardNewMacro(vtkTerrainGeoreference);

vtkTerrainGeoreference::vtkTerrainGeoreference()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkTerrainGeoreference::~vtkTerrainGeoreference() = default;

vtkMTimeType vtkTerrainGeoreference::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Internals->Geoid->GetMTime());
}

void vtkTerrainGeoreference::SetCoordinateSystem(const std::string& definition)
{
  terrain::Setting::Set(this, this->CoordinateSystem, definition);
}

void vtkTerrainGeoreference::SetExtent(double xMin, double xMax, double yMin, double yMax)
{
  const double extent[4] = { xMin, xMax, yMin, yMax };
  if (!std::equal(extent, extent + 4, this->Extent))
  {
    std::copy_n(extent, 4, this->Extent);
    this->Modified();
  }
}

void vtkTerrainGeoreference::SetFrame(FrameType frame)
{
  terrain::Setting::Set(this, this->Frame, frame);
}

void vtkTerrainGeoreference::SetOrigin(double longitude, double latitude, double height)
{
  const double origin[3] = { longitude, latitude, height };
  if (!this->IsOriginGiven || !std::equal(origin, origin + 3, this->Origin))
  {
    std::copy_n(origin, 3, this->Origin);
    this->IsOriginGiven = true;
    this->Modified();
  }
}

void vtkTerrainGeoreference::SetAutomaticOrigin()
{
  if (this->IsOriginGiven)
  {
    this->IsOriginGiven = false;
    this->Modified();
  }
}

void vtkTerrainGeoreference::SetZone(int zone, bool northern)
{
  const int clamped = std::clamp(zone, -1, 60);
  if (this->Zone != clamped || this->Northern != northern)
  {
    this->Zone = clamped;
    this->Northern = northern;
    this->Modified();
  }
}

void vtkTerrainGeoreference::SetHeightUnit(double metres)
{
  const double unit = std::isfinite(metres) && metres > 0.0 ? metres : 0.0;
  if (this->HeightUnit != unit)
  {
    this->HeightUnit = unit;
    this->Modified();
  }
}

void vtkTerrainGeoreference::SetFileHeights(HeightType heights)
{
  terrain::Setting::Set(this, this->FileHeights, heights);
}

void vtkTerrainGeoreference::SetSceneHeights(HeightType heights)
{
  terrain::Setting::Set(this, this->SceneHeights, heights);
}

double vtkTerrainGeoreference::HeightUnitFromName(const std::string& name)
{
  return terrain::MetresOfUnit(name);
}

vtkTerrainGeoid* vtkTerrainGeoreference::GetGeoid()
{
  return this->Internals->Geoid;
}

//------------------------------------------------------------------------------------------------
// What follows from the settings.

std::string vtkTerrainGeoreference::GetWhyNot()
{
  this->Prepare();
  return this->Internals->WhyNot;
}

bool vtkTerrainGeoreference::IsOnEarth()
{
  this->Prepare();
  return this->Internals->WhyNot.empty() && this->Internals->System.IsOnEarth();
}

bool vtkTerrainGeoreference::IsOnOtherWorld()
{
  this->Prepare();
  return this->Internals->WhyNot.empty() &&
    this->Internals->System.GetKind() == terrain::CoordinateSystem::Kind::OtherWorld;
}

bool vtkTerrainGeoreference::HasPlaces()
{
  this->Prepare();
  return this->Internals->WhyNot.empty() && this->Internals->System.HasPlaces();
}

bool vtkTerrainGeoreference::IsGeographic()
{
  this->Prepare();
  return this->Internals->System.GetKind() == terrain::CoordinateSystem::Kind::Geographic;
}

std::string vtkTerrainGeoreference::GetWarning()
{
  this->Prepare();
  return this->Internals->Warning;
}

std::string vtkTerrainGeoreference::GetCoordinateSystemName()
{
  this->Prepare();
  return this->Internals->System.GetName();
}

double vtkTerrainGeoreference::GetHeightUnit()
{
  this->Prepare();
  return this->Internals->HeightUnit;
}

vtkTerrainGeoreference::HeightType vtkTerrainGeoreference::GetFileHeights()
{
  this->Prepare();
  return this->Internals->FileHeights;
}

void vtkTerrainGeoreference::GetOrigin(double origin[3])
{
  this->Prepare();
  const terrain::SceneFrame& frame = this->Internals->Frame;
  const bool hasOrigin = this->Internals->HasFrame &&
    (frame.Kind() == terrain::SceneKind::Plane || frame.Kind() == terrain::SceneKind::Local);
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = hasOrigin ? frame.Origin()[axis] : kNaN;
  }
}

double vtkTerrainGeoreference::GetSceneRise(double metres)
{
  this->Prepare();
  const vtkInternals& internals = *this->Internals;
  return internals.HasFrame ? internals.Frame.RiseToScene(metres) : metres;
}

int vtkTerrainGeoreference::GetZone()
{
  this->Prepare();
  return this->Internals->HasFrame ? this->Internals->Frame.Zone() : -1;
}

bool vtkTerrainGeoreference::GetNorthern()
{
  this->Prepare();
  return this->Internals->HasFrame ? this->Internals->Frame.Northern() : this->Northern;
}

std::string vtkTerrainGeoreference::GetSceneCoordinateSystem()
{
  this->Prepare();
  const vtkInternals& internals = *this->Internals;
  if (!internals.WhyNot.empty())
  {
    return {};
  }
  if (this->Frame == FrameType::Grid)
  {
    return internals.System.GetMetres() == 1.0
      ? terrain::CoordinateSystem::ToWkt(this->CoordinateSystem)
      : std::string();
  }
  char text[160];
  switch (internals.Frame.Kind())
  {
    case terrain::SceneKind::Plane:
      std::snprintf(text, sizeof(text),
        "+proj=ortho +lat_0=%.17g +lon_0=%.17g +datum=WGS84 +units=m +type=crs",
        internals.Frame.Origin().y, internals.Frame.Origin().x);
      return terrain::CoordinateSystem::ToWkt(text);
    case terrain::SceneKind::Geocentric:
      return terrain::CoordinateSystem::ToWkt("EPSG:4978");
    case terrain::SceneKind::Zone:
      // EPSG: 326zz and 327zz are UTM north and south, 32661 and 32761 (easting first: 5041, 5042)
      // UPS.
      std::snprintf(text, sizeof(text), "EPSG:%d",
        internals.Frame.Zone() == 0
          ? (internals.Frame.Northern() ? 5041 : 5042)
          : (internals.Frame.Northern() ? 32600 : 32700) + internals.Frame.Zone());
      return terrain::CoordinateSystem::ToWkt(text);
    default:
      return {};
  }
}

//------------------------------------------------------------------------------------------------
// Points.

template <typename Function>
bool vtkTerrainGeoreference::InBatches(
  const double* in, double* out, vtkIdType count, bool needsPlaces, Function&& function)
{
  this->Prepare();
  if (!this->Internals->WhyNot.empty() || (needsPlaces && !this->Internals->System.HasPlaces()))
  {
    return false;
  }
  vtkSMPTools::For(0, count, kPointsPerTask,
    [&](vtkIdType begin, vtkIdType end)
    {
      if (in != out)
      {
        std::copy(in + 3 * begin, in + 3 * end, out + 3 * begin);
      }
      function(out + 3 * begin, end - begin);
    });
  return true;
}

void vtkTerrainGeoreference::ConvertHeights(double* places, vtkIdType count, bool toScene)
{
  const vtkInternals& internals = *this->Internals;
  if (internals.GeoidSign == 0.0)
  {
    return;
  }
  std::vector<double> geoid(static_cast<std::size_t>(count));
  internals.Geoid->GetHeights(places, geoid.data(), count);
  const double sign = toScene ? internals.GeoidSign : -internals.GeoidSign;
  for (vtkIdType i = 0; i < count; ++i)
  {
    places[3 * i + 2] += sign * geoid[i];
  }
}

bool vtkTerrainGeoreference::FileToPlaces(const double* file, double* places, vtkIdType count)
{
  return this->InBatches(file, places, count, true,
    [this](double* points, vtkIdType size)
    {
      this->Internals->System.ToPlaces(points, size);
      for (vtkIdType i = 0; i < size; ++i)
      {
        points[3 * i + 2] *= this->Internals->HeightUnit;
      }
      this->ConvertHeights(points, size, true);
    });
}

bool vtkTerrainGeoreference::PlacesToFile(const double* places, double* file, vtkIdType count)
{
  return this->InBatches(places, file, count, true,
    [this](double* points, vtkIdType size)
    {
      this->ConvertHeights(points, size, false);
      for (vtkIdType i = 0; i < size; ++i)
      {
        points[3 * i + 2] /= this->Internals->HeightUnit;
      }
      this->Internals->System.FromPlaces(points, size, this->Internals->MiddleX);
    });
}

bool vtkTerrainGeoreference::PlacesToScene(const double* places, double* scene, vtkIdType count)
{
  return this->InBatches(places, scene, count, true,
    [this](double* points, vtkIdType size)
    {
      const vtkInternals& internals = *this->Internals;
      if (internals.HasFrame && this->Frame != FrameType::Globe)
      {
        internals.Frame.ToScene(points, points, size);
        return;
      }
      internals.System.FromPlaces(points, size, internals.MiddleX);
      if (internals.HasFrame)
      {
        internals.ScaleDegrees(points, size, internals.System.GetDegrees());
        internals.Frame.ToScene(points, points, size);
        return;
      }
      for (vtkIdType i = 0; i < size; ++i)
      {
        internals.GridToScene(points + 3 * i);
      }
    });
}

bool vtkTerrainGeoreference::SceneToPlaces(const double* scene, double* places, vtkIdType count)
{
  return this->InBatches(scene, places, count, true,
    [this](double* points, vtkIdType size)
    {
      const vtkInternals& internals = *this->Internals;
      if (internals.HasFrame)
      {
        internals.Frame.ToPlaces(points, points, size);
        if (this->Frame == FrameType::Globe)
        {
          internals.ScaleDegrees(points, size, 1.0 / internals.System.GetDegrees());
          internals.System.ToPlaces(points, size);
        }
        return;
      }
      for (vtkIdType i = 0; i < size; ++i)
      {
        internals.SceneToGrid(points + 3 * i);
      }
      internals.System.ToPlaces(points, size);
    });
}

bool vtkTerrainGeoreference::FileToScene(const double* file, double* scene, vtkIdType count)
{
  this->Prepare();
  const vtkInternals& internals = *this->Internals;
  if (internals.HasFrame || internals.GeoidSign != 0.0)
  {
    return this->FileToPlaces(file, scene, count) && this->PlacesToScene(scene, scene, count);
  }
  return this->InBatches(file, scene, count, false,
    [&internals](double* points, vtkIdType size)
    {
      for (vtkIdType i = 0; i < size; ++i)
      {
        internals.GridToScene(points + 3 * i);
        points[3 * i + 2] *= internals.HeightUnit;
      }
    });
}

bool vtkTerrainGeoreference::SceneToFile(const double* scene, double* file, vtkIdType count)
{
  this->Prepare();
  const vtkInternals& internals = *this->Internals;
  if (internals.HasFrame || internals.GeoidSign != 0.0)
  {
    return this->SceneToPlaces(scene, file, count) && this->PlacesToFile(file, file, count);
  }
  return this->InBatches(scene, file, count, false,
    [&internals](double* points, vtkIdType size)
    {
      for (vtkIdType i = 0; i < size; ++i)
      {
        internals.SceneToGrid(points + 3 * i);
        points[3 * i + 2] /= internals.HeightUnit;
      }
    });
}

bool vtkTerrainGeoreference::FileHeightsToPlaces(
  const double* places, double* heights, vtkIdType count)
{
  this->Prepare();
  const vtkInternals& internals = *this->Internals;
  if (!internals.WhyNot.empty())
  {
    return false;
  }
  vtkSMPTools::For(0, count, kPointsPerTask,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> geoid(static_cast<std::size_t>(end - begin), 0.0);
      if (internals.GeoidSign != 0.0)
      {
        internals.Geoid->GetHeights(places + 3 * begin, geoid.data(), end - begin);
      }
      for (vtkIdType i = begin; i < end; ++i)
      {
        heights[i] = heights[i] * internals.HeightUnit +
          internals.GeoidSign * geoid[static_cast<std::size_t>(i - begin)];
      }
    });
  return true;
}

bool vtkTerrainGeoreference::GetAxes(
  const double place[3], double east[3], double north[3], double up[3])
{
  // Neighbours 10 m to either side, through the same transformation as everything else.
  constexpr double kStep = 10.0;
  const terrain::SceneFrame local =
    terrain::SceneFrame::AtOrigin(terrain::SceneKind::Local, { place[0], place[1], place[2] });
  double* axes[3] = { east, north, up };
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 step(0.0);
    step[axis] = kStep;
    const glm::dvec3 ahead = local.ToPlace(step);
    const glm::dvec3 behind = local.ToPlace(-step);
    double points[6] = { ahead.x, ahead.y, ahead.z, behind.x, behind.y, behind.z };
    if (!this->PlacesToScene(points, points, 2))
    {
      return false;
    }
    const glm::dvec3 unit = glm::normalize(
      glm::dvec3(points[0] - points[3], points[1] - points[4], points[2] - points[5]));
    axes[axis][0] = unit.x;
    axes[axis][1] = unit.y;
    axes[axis][2] = unit.z;
  }
  return std::isfinite(east[0] + north[0] + up[0]);
}

void vtkTerrainGeoreference::GetFlatError(double& horizontal, double& vertical)
{
  horizontal = vertical = kNaN;
  double middle[3];
  if (!this->IsOnEarth() || !this->Middle(middle))
  {
    return;
  }
  horizontal = vertical = 0.0;
  if (this->Frame == FrameType::Local || this->Frame == FrameType::Geocentric ||
    this->Frame == FrameType::Globe)
  {
    return;
  }
  const glm::dvec3 centre(middle[0], middle[1], 0.0);
  const terrain::SceneFrame local =
    terrain::SceneFrame::AtOrigin(terrain::SceneKind::Local, centre);
  std::vector<double> places = terrain::PlaceExtent::Border(this->Extent);
  const std::size_t count = places.size() / 3;
  this->Internals->System.ToPlaces(places.data(), static_cast<std::int64_t>(count));
  places.insert(places.end(), { centre.x, centre.y, 0.0 });
  std::vector<double> scene(places.size());
  this->PlacesToScene(places.data(), scene.data(), static_cast<vtkIdType>(count) + 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::dvec3 place(places[3 * i], places[3 * i + 1], 0.0);
    const double flat =
      std::hypot(scene[3 * i] - scene[3 * count], scene[3 * i + 1] - scene[3 * count + 1]);
    const double error = std::abs(flat - terrain::GeodesicBetween(centre, place).Distance);
    const double drop = -local.ToScene(place).z;
    horizontal = std::isfinite(error) ? std::max(horizontal, error) : horizontal;
    vertical = std::isfinite(drop) ? std::max(vertical, drop) : vertical;
  }
}

//------------------------------------------------------------------------------------------------
// Text.

std::string vtkTerrainGeoreference::GetReadout(const double scene[3])
{
  double point[3];
  if (!this->SceneToPlaces(scene, point, 1) || !std::isfinite(point[0]))
  {
    return "-";
  }
  const glm::dvec3 place(point[0], point[1], point[2]);
  char height[40];
  std::snprintf(height, sizeof(height), "%.1f m", place.z);
  const std::string text = terrain::ToDegreesText(place) + "  " + height;
  return this->IsOnEarth() ? text + "  " + terrain::ToUtmText(place) + "  " + terrain::ToMgrs(place)
                           : text;
}

std::string vtkTerrainGeoreference::GetMGRS(double longitude, double latitude, int precision)
{
  return terrain::ToMgrs({ longitude, latitude, 0.0 }, precision);
}

std::string vtkTerrainGeoreference::PlaceFromText(const std::string& text, double place[3])
{
  glm::dvec3 read(0.0);
  std::string message;
  if (terrain::PlaceFromText(text, read, message))
  {
    place[0] = read.x;
    place[1] = read.y;
  }
  return message;
}

void vtkTerrainGeoreference::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  double origin[3];
  this->GetOrigin(origin);
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "Extent: " << terrain::PlaceExtent::ToText(this->Extent) << "\n";
  os << indent << "Globe: " << this->Globe[0] << ", " << this->Globe[1] << "\n";
  os << indent << "Frame: " << static_cast<int>(this->Frame) << "\n";
  os << indent << "Origin: " << origin[0] << ", " << origin[1] << ", " << origin[2] << "\n";
  os << indent << "VerticalExaggeration: " << this->VerticalExaggeration << "\n";
  os << indent << "Zone: " << this->GetZone() << (this->GetNorthern() ? " north" : " south")
     << "\n";
  os << indent << "HeightUnit: " << this->GetHeightUnit() << " m\n";
  os << indent << "FileHeights: " << static_cast<int>(this->GetFileHeights()) << "\n";
  os << indent << "SceneHeights: " << static_cast<int>(this->SceneHeights) << "\n";
  os << indent << "WhyNot: " << this->GetWhyNot() << "\n";
}
