// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkTerrainGeoreference that turns settings into a frame, or into a reason why not.
#include "place/GeoreferenceInternals.h"

#include "core/grid/Constants.h"
#include "core/place/GridReference.h"
#include "data/FieldData.h"
#include "data/GlobeData.h"
#include "data/ImageHeights.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace
{
using Kind = terrain::CoordinateSystem::Kind;
using terrain::PlaceExtent::IsKnown;

using terrain::kNaN;
// Points along each side of the extent that are looked at.
constexpr int kExtentPoints = 9;
// Degrees that a geographic extent may exceed the earth by, for rounding.
constexpr double kSlack = 1e-6;

std::string LongText(double value)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.10g", value);
  return text;
}
}

std::string terrain::PlaceExtent::ToText(const double extent[4])
{
  return "x " + LongText(extent[0]) + " to " + LongText(extent[1]) + ", y " + LongText(extent[2]) +
    " to " + LongText(extent[3]);
}

bool terrain::PlaceExtent::IsKnown(const double extent[4])
{
  return extent[0] <= extent[1] && extent[2] <= extent[3];
}

std::vector<double> terrain::PlaceExtent::Border(const double extent[4])
{
  std::vector<double> points;
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i + 1 < kExtentPoints; ++i)
    {
      const double t = static_cast<double>(i) / (kExtentPoints - 1);
      const double along = side < 2 ? t : 1.0 - t;
      const bool horizontal = side % 2 == 0;
      const double u = horizontal ? along : (side == 1 ? 1.0 : 0.0);
      const double v = horizontal ? (side == 0 ? 0.0 : 1.0) : along;
      points.push_back((1.0 - u) * extent[0] + u * extent[1]);
      points.push_back((1.0 - v) * extent[2] + v * extent[3]);
      points.push_back(0.0);
    }
  }
  return points;
}

void vtkTerrainGeoreference::SetGlobe(double equatorial, double polar)
{
  if (this->Globe[0] != equatorial || this->Globe[1] != polar)
  {
    this->Globe[0] = equatorial;
    this->Globe[1] = polar;
    this->Modified();
  }
}

void vtkTerrainGeoreference::SetFromHeights(vtkImageData* heights)
{
  const std::string system = terrain::FieldData::GetText(heights, "CRS");
  if (!system.empty())
  {
    this->SetCoordinateSystem(system);
  }
  const auto globe = terrain::GlobeData::Get(heights);
  this->SetGlobe(globe ? globe->Body.Equatorial : 0.0, globe ? globe->Body.Polar : 0.0);
  if (globe)
  {
    // in the units of the coordinate system, which may be grads
    this->Prepare();
    const double degrees = this->Internals->System.GetDegrees();
    const double unit = terrain::kDegree * (degrees > 0.0 ? degrees : 1.0);
    this->SetExtent(globe->West / unit, (globe->West + globe->Cells().x * globe->Step) / unit,
      globe->Latitudes.front() / unit, globe->Latitudes.back() / unit);
    return;
  }
  const terrain::FieldData::Layout layout = terrain::FieldData::GetLayout(heights);
  const terrain::GridGeometry geometry = terrain::ImageHeights::Geometry(heights);
  const int* dims = heights->GetDimensions();
  double extent[4];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double first = geometry.Origin[axis];
    const double last = first + (dims[axis] - 1) * geometry.Spacing[axis];
    double* ends = axis == 0 ? extent : extent + 2;
    ends[0] = layout.Origin[axis] + first / layout.Scale[axis];
    ends[1] = layout.Origin[axis] + last / layout.Scale[axis];
  }
  this->SetExtent(extent[0], extent[1], extent[2], extent[3]);
  std::copy_n(layout.Origin, 2, this->LayoutOrigin);
  std::copy_n(layout.Scale, 2, this->LayoutScale);
}

vtkTerrainGeoreference::FrameType vtkTerrainGeoreference::SuggestFrame(vtkImageData* heights)
{
  // The largest drop for a flat frame, metres.
  constexpr double kDeepestDrop = 200e3;
  const vtkNew<vtkTerrainGeoreference> ground;
  ground->SetFromHeights(heights);
  const int* dims = heights->GetDimensions();
  const double* spacing = heights->GetSpacing();
  if (!ground->GetWhyNot().empty())
  {
    return ground->IsGeographic() ? FrameType::Plane : FrameType::Grid;
  }
  if (!ground->IsGeographic())
  {
    const double* e = ground->GetExtent();
    const double x = 0.5 * (e[0] + e[1]);
    const double y = 0.5 * (e[2] + e[3]);
    double p[9] = { x, y, 0.0, x + (e[1] - e[0]) / std::max(dims[0] - 1, 1), y, 0.0, x,
      y + (e[3] - e[2]) / std::max(dims[1] - 1, 1), 0.0 };
    ground->FileToScene(p, p, 3);
    const double area = std::abs((p[3] - p[0]) * (p[7] - p[1]) - (p[4] - p[1]) * (p[6] - p[0]));
    if (dims[0] < 2 || dims[1] < 2 ||
      !(std::abs(std::sqrt(area / (spacing[0] * spacing[1])) - 1.0) >= ScaleError))
    {
      return FrameType::Grid;
    }
  }
  double sideways = 0.0;
  double drop = 0.0;
  ground->GetFlatError(sideways, drop);
  return drop < kDeepestDrop ? FrameType::Plane : FrameType::Grid;
}

void vtkTerrainGeoreference::PrepareUnits()
{
  vtkInternals& internals = *this->Internals;
  const terrain::CoordinateSystem& system = internals.System;
  const bool isLaidOut = !system.IsOnEarth() && system.IsInDegrees();
  for (int axis = 0; axis < 2; ++axis)
  {
    internals.GridOrigin[axis] = isLaidOut ? this->LayoutOrigin[axis] : 0.0;
    internals.GridScale[axis] = isLaidOut ? this->LayoutScale[axis] : system.GetMetres();
  }
  internals.HeightUnit = this->HeightUnit > 0.0 ? this->HeightUnit
    : system.GetVerticalMetres() > 0.0          ? system.GetVerticalMetres()
                                                : 1.0;
  internals.FileHeights = this->FileHeights;
  if (internals.FileHeights == HeightType::AsIs && !system.GetVerticalName().empty())
  {
    internals.FileHeights =
      system.HasEllipsoidalHeights() ? HeightType::Ellipsoid : HeightType::Geoid;
  }
  const bool ellipsoidal = internals.FileHeights == HeightType::Ellipsoid;
  internals.GeoidSign = 0.0;
  if (this->SceneHeights == HeightType::Ellipsoid && !ellipsoidal)
  {
    internals.GeoidSign = 1.0;
  }
  if (this->SceneHeights == HeightType::Geoid && ellipsoidal)
  {
    internals.GeoidSign = -1.0;
  }
}

void vtkTerrainGeoreference::Prepare()
{
  vtkInternals& internals = *this->Internals;
  const vtkMTimeType now = this->GetMTime();
  if (internals.PreparedTime == now)
  {
    return;
  }
  const std::lock_guard<std::mutex> lock(internals.Mutex);
  if (internals.PreparedTime == now)
  {
    return;
  }
  if (internals.PreparedTime == 0 || internals.SystemRead != this->CoordinateSystem)
  {
    internals.SystemWhyNot = internals.System.Read(this->CoordinateSystem);
    internals.SystemRead = this->CoordinateSystem;
  }
  const terrain::CoordinateSystem& system = internals.System;
  internals.Warning.clear();
  internals.WhyNot = internals.SystemWhyNot;
  internals.MiddleX = IsKnown(this->Extent) ? 0.5 * (this->Extent[0] + this->Extent[1]) : 0.0;
  this->PrepareUnits();
  if (internals.WhyNot.empty())
  {
    internals.WhyNot = this->WhyNotExtent();
  }
  internals.HasFrame = false;
  if (internals.WhyNot.empty())
  {
    this->PrepareFrame();
  }
  if (internals.WhyNot.empty() && internals.GeoidSign != 0.0)
  {
    internals.WhyNot = system.IsOnEarth() ? internals.Geoid->GetWhyNot()
                                          : "heights can only be converted between sea level and "
                                            "ellipsoid where the coordinate system is known";
  }
  internals.PreparedTime = now;
}

std::string vtkTerrainGeoreference::WhyNotExtent()
{
  const terrain::CoordinateSystem& system = this->Internals->System;
  const double* e = this->Extent;
  if (!IsKnown(e) || !system.IsOnEarth())
  {
    return {};
  }
  if (system.GetKind() == Kind::Geographic)
  {
    const double d = system.GetDegrees();
    const bool fits = std::abs(e[2] * d) <= 90.0 + kSlack && std::abs(e[3] * d) <= 90.0 + kSlack &&
      (e[1] - e[0]) * d <= 360.0 + kSlack && std::abs(e[0] * d) <= 720.0 &&
      std::abs(e[1] * d) <= 720.0;
    const bool fitsSwapped = std::abs(e[0] * d) <= 90.0 && std::abs(e[1] * d) <= 90.0 &&
      std::abs(e[2] * d) <= 360.0 && std::abs(e[3] * d) <= 360.0;
    return fits ? std::string()
                : "the coordinate system '" + system.GetName() +
        "' is longitude and latitude, but the data lie at " + terrain::PlaceExtent::ToText(e) +
        (fitsSwapped ? ": longitude and latitude are swapped" : ": those are no degrees");
  }
  std::vector<double> border = terrain::PlaceExtent::Border(e);
  border.insert(border.end(), { 0.5 * (e[0] + e[1]), 0.5 * (e[2] + e[3]), 0.0 });
  system.ToPlaces(border.data(), static_cast<std::int64_t>(border.size() / 3));
  bool any = false;
  for (std::size_t i = 0; i < border.size(); i += 3)
  {
    any = any || std::isfinite(border[i]);
  }
  if (!any)
  {
    return "the coordinate system '" + system.GetName() + "' does not reach the data at " +
      terrain::PlaceExtent::ToText(e);
  }
  if (std::abs(e[0]) <= 360.0 && std::abs(e[1]) <= 360.0 && std::abs(e[2]) <= 90.0 &&
    std::abs(e[3]) <= 90.0)
  {
    this->Internals->Warning = "the data lie at " + terrain::PlaceExtent::ToText(e) +
      ", which looks like degrees, but the coordinate system '" + system.GetName() +
      "' counts in units of " + LongText(system.GetMetres()) + " m";
  }
  return {};
}

bool vtkTerrainGeoreference::Middle(double place[3])
{
  if (!IsKnown(this->Extent))
  {
    return false;
  }
  place[0] = 0.5 * (this->Extent[0] + this->Extent[1]);
  place[1] = 0.5 * (this->Extent[2] + this->Extent[3]);
  place[2] = 0.0;
  return this->Internals->System.ToPlaces(place, 1) && std::isfinite(place[0]);
}

std::string vtkTerrainGeoreference::WhyNoFrame()
{
  const terrain::CoordinateSystem& system = this->Internals->System;
  const Kind kind = system.GetKind();
  if (this->Frame == FrameType::Grid)
  {
    return kind != Kind::Geographic ? std::string()
                                    : "the file's own grid is in degrees ('" + system.GetName() +
        "'): a scene needs a frame in metres";
  }
  if (kind == Kind::None)
  {
    return "the data have no coordinate system: name one (EPSG code or WKT), or keep the file's "
           "own grid";
  }
  if (kind == Kind::Engineering)
  {
    return "the coordinate system '" + system.GetName() +
      "' is tied to no place on earth: only the file's own grid can be kept";
  }
  if (this->Frame == FrameType::Globe)
  {
    return system.WhyNotLongitudeLatitude();
  }
  if (kind == Kind::OtherWorld)
  {
    return "the coordinate system '" + system.GetName() +
      "' is of another world than the earth: only the file's own grid or the globe can be kept";
  }
  return {};
}

std::string vtkTerrainGeoreference::PlaceFrame()
{
  terrain::SceneFrame& frame = this->Internals->Frame;
  const terrain::CoordinateSystem& system = this->Internals->System;
  if (this->Frame == FrameType::Globe)
  {
    frame = terrain::SceneFrame::OfBody(this->Globe[0] > 0.0
        ? terrain::Ellipsoid{ this->Globe[0], this->Globe[1] }
        : terrain::Ellipsoid{ system.GetSemiMajor(), system.GetSemiMinor() });
    return {};
  }
  if (this->Frame == FrameType::Geocentric)
  {
    frame = terrain::SceneFrame();
    return {};
  }
  if (this->Frame == FrameType::Zone && this->Zone >= 0)
  {
    frame = terrain::SceneFrame::OfZone(this->Zone, this->Northern);
    return {};
  }
  double middle[3] = { kNaN, kNaN, 0.0 };
  if (!this->Middle(middle) && !(this->IsOriginGiven && this->Frame != FrameType::Zone))
  {
    return IsKnown(this->Extent)
      ? "the middle of the data has no place in '" + system.GetName() + "': give an origin"
      : "neither an origin nor the extent of the data is known";
  }
  if (this->Frame == FrameType::Zone)
  {
    const terrain::GridPosition position =
      terrain::ToGridPosition({ middle[0], middle[1], middle[2] });
    frame = terrain::SceneFrame::OfZone(position.Zone, position.Northern);
    return {};
  }
  const double* origin = this->IsOriginGiven ? this->Origin : middle;
  if (!(std::abs(origin[1]) <= 90.0) || !std::isfinite(origin[0]) || !std::isfinite(origin[2]))
  {
    return "the origin (longitude " + LongText(origin[0]) + ", latitude " + LongText(origin[1]) +
      ") is not on earth";
  }
  frame = terrain::SceneFrame::AtOrigin(
    this->Frame == FrameType::Plane ? terrain::SceneKind::Plane : terrain::SceneKind::Local,
    { origin[0], origin[1], origin[2] }, this->VerticalExaggeration);
  return {};
}

void vtkTerrainGeoreference::PrepareFrame()
{
  vtkInternals& internals = *this->Internals;
  internals.WhyNot = this->WhyNoFrame();
  if (internals.WhyNot.empty() && this->Frame != FrameType::Grid)
  {
    internals.WhyNot = this->PlaceFrame();
    internals.HasFrame = internals.WhyNot.empty();
  }
}
