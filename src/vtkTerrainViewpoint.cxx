// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainViewpoint.h"

#include "core/grid/Constants.h"
#include "core/place/Geodesics.h"
#include "core/place/SunPosition.h"
#include "core/rays/RayQuery.h"
#include "data/GlobeSurface.h"
#include "data/ImageHeights.h"
#include "data/ImageSurface.h"
#include "data/Setting.h"
#include "place/GroundPlaces.h"
#include "vtkTerrainGeoreference.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace
{
using FrameType = vtkTerrainGeoreference::FrameType;

using terrain::kNaN;
// Metres that the terrain must stand above a line of sight to hide its end.
constexpr double kTouch = 1e-3;

std::vector<std::string> Split(const std::string& text)
{
  std::vector<std::string> parts(1);
  for (char c : text)
  {
    if (c == ',')
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

/// Reads a number that is the whole text.
bool Read(const std::string& text, double& value)
{
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return !text.empty() && end && *end == '\0' && std::isfinite(value);
}

/// A place as it is written: degrees, and metres above sea level or ellipsoid, or above the ground.
struct WrittenPlace
{
  double Longitude = 0.0;
  double Latitude = 0.0;
  double Height = 0.0;
  bool IsAboveGround = true;
};

/// Reads the height of a place. False if it is none.
bool ReadHeight(std::string text, WrittenPlace& place)
{
  static const std::string suffix = "agl";
  place.IsAboveGround =
    text.size() > suffix.size() && text.substr(text.size() - suffix.size()) == suffix;
  if (place.IsAboveGround)
  {
    text.resize(text.size() - suffix.size());
  }
  return Read(text, place.Height);
}

/// Reads what the class comment says a place is. Returns one sentence if it is none.
std::string ReadPlace(const std::string& text, WrittenPlace& place)
{
  const std::vector<std::string> parts = Split(text);
  const bool isDegrees =
    parts.size() >= 2 && Read(parts[0], place.Longitude) && Read(parts[1], place.Latitude);
  const std::size_t used = isDegrees ? 2 : 1;
  if (isDegrees && (std::abs(place.Latitude) > 90.0 || std::abs(place.Longitude) > 720.0))
  {
    return "'" + text + "' is no longitude and latitude";
  }
  if (!isDegrees)
  {
    double reference[3] = { 0.0, 0.0, 0.0 };
    std::string why = vtkTerrainGeoreference::PlaceFromText(parts[0], reference);
    if (!why.empty())
    {
      return why;
    }
    place.Longitude = reference[0];
    place.Latitude = reference[1];
  }
  if (parts.size() > used + 1)
  {
    return "'" + text + "' has too many parts: LON,LAT[,HEIGHT]";
  }
  if (parts.size() > used && !ReadHeight(parts[used], place))
  {
    return "'" + parts[used] + "' is no height: metres, or metres above the ground as 500agl";
  }
  return {};
}
}

vtkStandardNewMacro(vtkTerrainViewpoint);

class vtkTerrainViewpoint::vtkInternals
{
public:
  /// The surface of an image as drawn, nothing if the image holds no heights.
  terrain::RayQuery QueryOf(vtkImageData* heights, double exaggeration)
  {
    if (!terrain::ImageHeights::WhyNotHeights(heights).empty())
    {
      return terrain::RayQuery({});
    }
    this->Surface.SetImage(heights);
    return terrain::RayQuery(this->Surface.GetSurface(exaggeration));
  }

  /// The heights of an image on a globe; null if they lie on none.
  const terrain::GlobeSurface* GlobeOf(vtkImageData* heights)
  {
    return this->Globe.SetImage(heights) ? &this->Globe : nullptr;
  }

private:
  terrain::ImageSurface Surface;
  terrain::GlobeSurface Globe;
};

vtkTerrainViewpoint::vtkTerrainViewpoint()
  : Internals(new vtkInternals)
{
}

vtkTerrainViewpoint::~vtkTerrainViewpoint() = default;

void vtkTerrainViewpoint::SetGeoreference(vtkTerrainGeoreference* georeference)
{
  terrain::Setting::Set(this, this->Georeference, georeference);
}

vtkTerrainGeoreference* vtkTerrainViewpoint::GetGeoreference() const
{
  return this->Georeference;
}

void vtkTerrainViewpoint::SetHeights(vtkImageData* heights)
{
  terrain::Setting::Set(this, this->Heights, heights);
  this->MoreHeights.clear();
}

void vtkTerrainViewpoint::AddHeights(vtkImageData* heights)
{
  this->MoreHeights.emplace_back(heights);
  this->Modified();
}

vtkImageData* vtkTerrainViewpoint::GetHeights() const
{
  return this->Heights;
}

std::string vtkTerrainViewpoint::WhyNot() const
{
  if (!this->Georeference)
  {
    return "there is no georeference";
  }
  std::string why = this->Georeference->GetWhyNot();
  if (!why.empty())
  {
    return why;
  }
  if (this->Georeference->GetFrame() == FrameType::Globe)
  {
    return this->Internals->GlobeOf(this->Heights)
      ? std::string()
      : "the heights of a scene in the frame Globe come from vtkTerrainGlobe";
  }
  return this->Georeference->IsOnEarth() ? terrain::ImageHeights::WhyNotHeights(this->Heights)
                                         : "the heights have no coordinate system: there are no "
                                           "places in the scene";
}

double vtkTerrainViewpoint::GetGround(double x, double y)
{
  const terrain::RayQuery query = this->Internals->QueryOf(this->Heights, this->Exaggeration);
  const terrain::GridGeometry& frame = query.GetSurface().Frame;
  return frame.ToModel({ 0.0, 0.0 }, query.HeightAt(x, y)).z;
}

bool vtkTerrainViewpoint::ToPlace(const double scene[3], double place[3])
{
  if (!this->WhyNot().empty())
  {
    return false;
  }
  if (this->Internals->GlobeOf(this->Heights))
  {
    const bool found = this->Georeference->SceneToPlaces(scene, place, 1);
    place[2] = terrain::DrawnOnGlobe(this->Exaggeration).RiseToHeights(place[2]);
    return found && std::isfinite(place[0]);
  }
  const terrain::GridGeometry frame =
    terrain::ImageHeights::Geometry(this->Heights, this->Exaggeration);
  const double plain[3] = { scene[0], scene[1], frame.ToTrueZ(scene[2]) };
  return this->Georeference->SceneToPlaces(plain, place, 1) && std::isfinite(place[0]);
}

/// Distances and areas are those of the earth's ellipsoid.
bool vtkTerrainViewpoint::ToEarth(const double scene[3], double place[3])
{
  return this->ToPlace(scene, place) && this->Georeference->IsOnEarth();
}

std::string vtkTerrainViewpoint::GetWhyNoPlace(const std::string& text)
{
  WrittenPlace written;
  return ReadPlace(text, written);
}

std::string vtkTerrainViewpoint::GetWhyNoTime(const std::string& text)
{
  terrain::UtcTime time;
  std::string why;
  terrain::TimeFromText(text, time, why);
  return why;
}

std::string vtkTerrainViewpoint::FindPlace(const std::string& text, double scene[3])
{
  std::string why = this->WhyNot();
  WrittenPlace written;
  why = why.empty() ? ReadPlace(text, written) : why;
  if (!why.empty())
  {
    return why;
  }
  const double place[3] = { written.Longitude, written.Latitude,
    written.IsAboveGround ? 0.0 : written.Height };
  if (!written.IsAboveGround)
  {
    this->PutAtHeight(this->Heights, place, scene);
    return std::isfinite(scene[0]) ? "" : "'" + text + "' has no image in the scene";
  }
  const bool isFound = this->PutOnGround(this->Heights, written.Height, place, scene) ||
    std::any_of(this->MoreHeights.begin(), this->MoreHeights.end(),
      [&](vtkImageData* more)
      {
        return terrain::ImageHeights::WhyNotHeights(more).empty() &&
          this->PutOnGround(more, written.Height, place, scene);
      });
  return isFound
    ? ""
    : "'" + text + "' does not lie on the terrain where it has data: give a height above sea level";
}

/// Scene point of a place so many metres above the ground of some heights; false if there is none.
bool vtkTerrainViewpoint::PutOnGround(
  vtkImageData* heights, double height, const double place[3], double scene[3])
{
  std::vector<double> ground(place, place + 3);
  if (const auto* globe = this->Internals->GlobeOf(heights))
  {
    ground[2] = this->GetGlobeGround(*globe, place);
  }
  else
  {
    terrain::LowerToGround(this->Georeference, heights, ground);
  }
  ground[2] += height;
  if (std::isnan(ground[2]))
  {
    return false;
  }
  this->PutAtHeight(heights, ground.data(), scene);
  return std::isfinite(scene[0]);
}

/// Scene point of a place, among heights as they are drawn.
void vtkTerrainViewpoint::PutAtHeight(
  vtkImageData* heights, const double place[3], double scene[3]) const
{
  std::copy(place, place + 3, scene);
  if (this->Internals->GlobeOf(heights))
  {
    scene[2] = terrain::DrawnOnGlobe(this->Exaggeration).RiseToModel(scene[2]);
    this->Georeference->PlacesToScene(scene, scene, 1);
    return;
  }
  this->Georeference->PlacesToScene(scene, scene, 1);
  scene[2] = terrain::ImageHeights::Geometry(heights, this->Exaggeration).ToDrawnZ(scene[2]);
}

double vtkTerrainViewpoint::GetGlobeGround(
  const terrain::GlobeSurface& globe, const double place[3]) const
{
  double scene[3] = { place[0], place[1], 0.0 };
  this->Georeference->PlacesToScene(scene, scene, 1);
  const glm::dvec3 there = globe.GetGrid().Body.ToPlace({ scene[0], scene[1], scene[2] });
  return globe.HeightAt(there.x / terrain::kDegree, there.y / terrain::kDegree);
}

std::string vtkTerrainViewpoint::Look(
  const std::string& from, const std::string& at, vtkCamera* camera)
{
  double eye[3];
  double focus[3];
  double place[3];
  std::string why = this->FindPlace(from, eye);
  why = why.empty() ? this->FindPlace(at, focus) : why;
  if (!why.empty())
  {
    return why;
  }
  if (std::equal(eye, eye + 3, focus))
  {
    return "'" + from + "' and '" + at + "' are the same place";
  }
  double east[3];
  double north[3];
  double up[3];
  this->ToPlace(eye, place);
  if (!this->Georeference->GetAxes(place, east, north, up))
  {
    return "'" + from + "' has no vertical in the scene";
  }
  const glm::dvec3 way =
    glm::normalize(glm::dvec3(focus[0] - eye[0], focus[1] - eye[1], focus[2] - eye[2]));
  const bool vertical = std::abs(way.x * up[0] + way.y * up[1] + way.z * up[2]) > 1.0 - 1e-9;
  camera->SetPosition(eye);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(vertical ? north : up);
  return {};
}

std::string vtkTerrainViewpoint::GetSun(
  const double scene[3], const std::string& time, double direction[3])
{
  std::string why = this->WhyNot();
  terrain::UtcTime utc;
  if (!why.empty() || !terrain::TimeFromText(time, utc, why))
  {
    return why;
  }
  if (!this->Georeference->IsOnEarth())
  {
    return "the place of the sun is known for the earth only: set a light";
  }
  double place[3];
  double east[3];
  double north[3];
  double up[3];
  if (!this->ToPlace(scene, place) || !this->Georeference->GetAxes(place, east, north, up))
  {
    return "the point is not on earth";
  }
  const glm::dvec3 sun =
    terrain::SunDirection(terrain::SunPosition({ place[0], place[1], place[2] }, utc));
  for (int i = 0; i < 3; ++i)
  {
    direction[i] = sun.x * east[i] + sun.y * north[i] + sun.z * up[i];
  }
  return {};
}

std::string vtkTerrainViewpoint::SetSun(const std::string& time, vtkLight* light)
{
  std::string why = this->WhyNot();
  if (!why.empty())
  {
    return why;
  }
  double bounds[6];
  this->Heights->GetBounds(bounds);
  const bool globe = this->Internals->GlobeOf(this->Heights) != nullptr;
  const double middle[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.0 };
  double sun[3];
  // from so far off it stands alike over a globe
  const double equator[3] = { terrain::kEarthRadius, 0.0, 0.0 };
  std::string whyNoSun = this->GetSun(globe ? equator : middle, time, sun);
  if (whyNoSun.empty())
  {
    light->SetLightTypeToSceneLight();
    light->PositionalOff();
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetPosition(sun);
    light->SetSwitch(globe || sun[2] > 0.0 ? 1 : 0);
  }
  return whyNoSun;
}

double vtkTerrainViewpoint::GetDistance(const double from[3], const double to[3], double* azimuth)
{
  double a[3];
  double b[3];
  if (!this->ToEarth(from, a) || !this->ToEarth(to, b))
  {
    return kNaN;
  }
  const terrain::GeodesicLeg leg =
    terrain::GeodesicBetween({ a[0], a[1], a[2] }, { b[0], b[1], b[2] });
  if (azimuth)
  {
    *azimuth = leg.StartAzimuth < 0.0 ? leg.StartAzimuth + 360.0 : leg.StartAzimuth;
  }
  return leg.Distance;
}

double vtkTerrainViewpoint::GetArea(vtkPoints* corners, double* perimeter)
{
  std::vector<glm::dvec3> places;
  for (vtkIdType i = 0; corners && i < corners->GetNumberOfPoints(); ++i)
  {
    double place[3];
    if (!this->ToEarth(corners->GetPoint(i), place))
    {
      return kNaN;
    }
    places.emplace_back(place[0], place[1], place[2]);
  }
  const terrain::GeodesicPolygon polygon = terrain::GeodesicPolygonOf(places);
  if (perimeter)
  {
    *perimeter = polygon.Perimeter;
  }
  return polygon.Area;
}

std::string vtkTerrainViewpoint::GetProfile(
  const double from[3], const double to[3], int count, vtkPolyData* profile)
{
  double a[3];
  double b[3];
  std::string why = this->WhyNot();
  if (!why.empty() || !this->ToEarth(from, a) || !this->ToEarth(to, b))
  {
    return why.empty() ? "a profile needs two points on earth" : why;
  }
  const terrain::GridGeometry frame =
    terrain::ImageHeights::Geometry(this->Heights, this->Exaggeration);
  const glm::dvec3 start(a[0], a[1], a[2]);
  const std::vector<glm::dvec3> places = terrain::GeodesicPlaces(
    start, { b[0], b[1], b[2] }, static_cast<std::size_t>(std::max(count, 2)));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("Distance");
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(places.size()));
  std::vector<double> ground;
  ground.reserve(3 * places.size());
  for (const glm::dvec3& place : places)
  {
    ground.insert(ground.end(), { place.x, place.y, place.z });
  }
  const terrain::GlobeSurface* globe = this->Internals->GlobeOf(this->Heights);
  if (!globe)
  {
    terrain::LowerToGround(this->Georeference, this->Heights, ground);
  }
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double height = globe ? this->GetGlobeGround(*globe, &places[i].x) : ground[3 * i + 2];
    double point[3] = { places[i].x, places[i].y, std::isnan(height) ? places[i].z : height };
    point[2] = globe ? terrain::DrawnOnGlobe(this->Exaggeration).RiseToModel(point[2]) : point[2];
    this->Georeference->PlacesToScene(point, point, 1);
    point[2] = globe ? point[2] : frame.ToDrawnZ(point[2]);
    line->InsertCellPoint(points->InsertNextPoint(point));
    distances->InsertNextValue(terrain::GeodesicBetween(start, places[i]).Distance);
    heights->InsertNextValue(height);
  }
  profile->Initialize();
  profile->SetPoints(points);
  profile->SetLines(line);
  profile->GetPointData()->AddArray(distances);
  profile->GetPointData()->AddArray(heights);
  return {};
}

bool vtkTerrainViewpoint::IsVisible(const double from[3], const double to[3], double obstruction[3])
{
  if (const auto* globe = this->Internals->GlobeOf(this->Heights))
  {
    const glm::dvec3 origin(from[0], from[1], from[2]);
    const glm::dvec3 way = glm::dvec3(to[0], to[1], to[2]) - origin;
    const double margin = std::min(kTouch / glm::length(way), 0.5);
    const auto hit = globe->Trace(origin, way, margin, 1.0 - margin, this->Exaggeration);
    const glm::dvec3 point = origin + hit.T * way;
    if (obstruction)
    {
      std::copy(&point.x, &point.x + 3, obstruction);
    }
    return !hit.Found;
  }
  const bool round = this->Georeference && this->Georeference->GetFrame() == FrameType::Local;
  terrain::QueryRay line;
  line.Origin = { from[0], from[1], from[2] };
  line.Direction = glm::dvec3(to[0], to[1], to[2]) - line.Origin;
  line.End = 1.0;
  // Between its ends, the line is t (1 - t) Bend lower over a flat map than on earth. A round scene
  // has that curve itself, unless its heights are exaggerated and so those of the line, too.
  const double length = glm::length(glm::dvec2(line.Direction));
  line.Bend = terrain::EarthBend(length, this->Refraction);
  if (round)
  {
    line.Bend = this->Georeference->GetSceneRise(line.Bend) - terrain::EarthBend(length, 0.0);
  }
  const terrain::RayQuery query = this->Internals->QueryOf(this->Heights, this->Exaggeration);
  line.Direction.z -= query.GetSurface().Frame.RiseToModel(line.Bend);
  const terrain::SurfaceSummit summit = query.Highest(line);
  if (obstruction)
  {
    const double part = std::isnan(summit.Distance) ? 0.0 : summit.Distance;
    for (int axis = 0; axis < 2; ++axis)
    {
      obstruction[axis] = from[axis] + part * (to[axis] - from[axis]);
    }
    obstruction[2] = this->GetGround(obstruction[0], obstruction[1]);
  }
  return !(summit.Height > kTouch);
}

void vtkTerrainViewpoint::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Georeference: " << this->Georeference.Get() << "\n";
  os << indent << "Heights: " << this->Heights.Get() << "\n";
  os << indent << "MoreHeights: " << this->MoreHeights.size() << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "Refraction: " << this->Refraction << "\n";
}
