// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DefaultView.h"

#include "Placing.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
/// Angle of the default view below the horizon, in degrees; on a globe the wider the heights, the
/// steeper, from this many degrees of them on straight down.
constexpr double kDefaultTilt = 38.0;
constexpr double kSteepFrom = 60.0;
/// Part of the picture's width and height that the terrain fills at most in the default view.
constexpr double kFill = 0.94;
/// Distance of the near plane where the eye is close to the terrain, over the terrain's diagonal;
/// on a globe over the distance of what can be seen.
constexpr double kNearPlane = 0.9e-4;
constexpr double kNearPlaneOnGlobe = 1e-5;
/// Part of a distance by which clipping planes stand off.
constexpr double kSlack = 0.01;

using Vector = std::array<double, 3>;

/// Bounds along one direction of the picture, seen from a distance: all points lie between two
/// borders of the view, whose slopes are over the distance along it. From a distance d with the
/// centre of the view at c, a point `along`, nearer to the eye by t, is in view if
/// -low (d - t) <= along - c <= high (d - t).
struct Reach
{
  double LowSlope;
  double HighSlope;
  double Low = -VTK_DOUBLE_MAX;
  double High = -VTK_DOUBLE_MAX;

  void Add(double along, double towardsEye)
  {
    this->Low = std::max(this->Low, this->LowSlope * towardsEye - along);
    this->High = std::max(this->High, this->HighSlope * towardsEye + along);
  }
  /// The least distance of the eye that has everything in view, once the view is centred.
  double Distance() const
  {
    return (this->Low + this->High) / (this->LowSlope + this->HighSlope);
  }
  /// Where the centre of the view lies along the direction, from a distance that is enough.
  double Centre(double distance) const
  {
    return (this->High - this->Low + (this->LowSlope - this->HighSlope) * distance) / 2.0;
  }
};

/// East, north and up at a place.
struct Axes
{
  Vector East{ 1.0, 0.0, 0.0 };
  Vector North{ 0.0, 1.0, 0.0 };
  Vector Up{ 0.0, 0.0, 1.0 };
};

/// From the south, as near as shows all of some points, in axes about a centre.
void LookFromSouth(vtkCamera* camera, const std::vector<Vector>& points, const Vector& centre,
  const Axes& axes, double degreesDown, double aspect, const ViewRoom& room = {})
{
  const double tilt = vtkMath::RadiansFromDegrees(degreesDown);
  Vector up{};
  Vector towardsEye{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    up[k] = std::sin(tilt) * axes.North[k] + std::cos(tilt) * axes.Up[k];
    towardsEye[k] = std::sin(tilt) * axes.Up[k] - std::cos(tilt) * axes.North[k];
  }
  const double slopeY = kFill * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0);
  const double slopeX = slopeY * aspect;
  Reach horizontal{ slopeX, room.Right * slopeX };
  Reach vertical{ slopeY, room.Top * slopeY };
  for (Vector point : points)
  {
    vtkMath::Subtract(point.data(), centre.data(), point.data());
    const double depth = vtkMath::Dot(point.data(), towardsEye.data());
    horizontal.Add(vtkMath::Dot(point.data(), axes.East.data()), depth);
    vertical.Add(vtkMath::Dot(point.data(), up.data()), depth);
  }
  const double distance = std::max(horizontal.Distance(), vertical.Distance());
  Vector eye{};
  Vector focalPoint{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    focalPoint[k] =
      centre[k] + horizontal.Centre(distance) * axes.East[k] + vertical.Centre(distance) * up[k];
    eye[k] = focalPoint[k] + distance * towardsEye[k];
  }
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(focalPoint.data());
  camera->SetViewUp(up.data());
}

/// The lowest and the highest height as drawn; 0 where there is none.
std::array<double, 2> DrawnRange(const PlacedHeights& heights)
{
  std::vector<vtkImageData*> images{ heights.Image };
  images.insert(images.end(), heights.Finer.begin(), heights.Finer.end());
  std::array<double, 2> all{ VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (vtkImageData* image : images)
  {
    std::array<double, 2> range{};
    image->GetPointData()->GetScalars()->GetFiniteRange(range.data());
    all = { std::min(all[0], range[0]), std::max(all[1], range[1]) };
  }
  if (!(all[0] <= all[1]))
  {
    return { 0.0, 0.0 };
  }
  vtkMath::MultiplyScalar2D(all.data(), heights.Exaggeration);
  return all;
}

/// The whole planet, over the middle of the heights; a little from the north.
void LookAtPlanet(vtkCamera* camera, double radius, const Vector& middle, double aspect)
{
  constexpr double kTilt = 20.0;
  constexpr double kSlope = 0.9;
  const double longitude = vtkMath::RadiansFromDegrees(middle[0]);
  const double latitude = vtkMath::RadiansFromDegrees(kTilt + (1.0 - kTilt / 90.0) * middle[1]);
  const double half = std::atan(kSlope * std::min(aspect, 1.0) *
    std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0));
  const double distance = radius / std::sin(half);
  camera->SetPosition(distance * std::cos(latitude) * std::cos(longitude),
    distance * std::cos(latitude) * std::sin(longitude), distance * std::sin(latitude));
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
}

/// Longitudes and latitudes of heights on a globe: west, east, south, north.
std::array<double, 4> DegreesOf(const PlacedHeights& heights)
{
  std::array<double, 6> bounds{};
  heights.Image->GetBounds(bounds.data());
  return { bounds[0], bounds[1], bounds[2], bounds[3] };
}

/// Points on the border of heights on a globe and inside, the lowest and the highest of each.
std::vector<Vector> OutlineOnGlobe(const PlacedHeights& heights)
{
  constexpr int kPoints = 17;
  const std::array<double, 4> degrees = DegreesOf(heights);
  std::vector<Vector> points;
  for (const double height : DrawnRange(heights))
  {
    for (int k = 0; k < kPoints * kPoints; ++k)
    {
      const double x = k % kPoints / (kPoints - 1.0);
      const double y = k / kPoints / (kPoints - 1.0); // NOLINT(bugprone-integer-division): the row
      points.push_back({ degrees[0] + x * (degrees[1] - degrees[0]),
        degrees[2] + y * (degrees[3] - degrees[2]), height });
    }
  }
  heights.Georeference->PlacesToScene(
    points.front().data(), points.front().data(), static_cast<vtkIdType>(points.size()));
  return points;
}

/// Degrees from which on heights lie around a pole that they have.
constexpr double kAllRound = 180.0;

/// The pole that heights have, -90 or 90; 0 for none.
double PoleOf(const std::array<double, 4>& degrees)
{
  constexpr double kPole = 89.0;
  return degrees[3] > kPole ? 90.0 : (degrees[2] < -kPole ? -90.0 : 0.0);
}

/// Degrees of a planet over which heights reach, 0 to 360; a cap around a pole from side to side.
double ReachOf(const std::array<double, 4>& degrees)
{
  const double south = degrees[2];
  const double north = degrees[3];
  const double width = degrees[1] - degrees[0];
  if (PoleOf(degrees) != 0.0)
  {
    const double reach = 90.0 - (PoleOf(degrees) > 0.0 ? south : -north);
    return width > kAllRound ? 2.0 * reach : std::max(width, reach);
  }
  const double nearest = std::clamp(0.0, south, north);
  return std::max(width * std::cos(vtkMath::RadiansFromDegrees(nearest)), north - south);
}

/// What lies before an eye on a globe: from the shell of the heights to the highest's horizon.
std::array<double, 2> ReachOnGlobe(vtkCamera* camera, const PlacedHeights& heights)
{
  constexpr double kAside = 0.5; // of a distance, along the view, at the corners of the picture
  Vector place{};
  heights.Georeference->SceneToPlaces(camera->GetPosition(), place.data(), 1);
  const double radius = std::max(vtkMath::Norm(camera->GetPosition()) - place[2], 0.0);
  const double highest = DrawnRange(heights)[1];
  const auto toHorizon = [radius](double height)
  { return std::sqrt(std::max(height, 0.0) * (2.0 * radius + std::max(height, 0.0))); };
  return { kAside * std::max(place[2] - highest, 0.0), toHorizon(place[2]) + toHorizon(highest) };
}
}

//------------------------------------------------------------------------------
void LookAtAll(vtkCamera* camera, const vtkBoundingBox& box, const PlacedHeights& heights,
  double aspect, const ViewRoom& room)
{
  if (!heights.IsGlobe())
  {
    std::vector<Vector> corners(8);
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
    {
      box.GetCorner(static_cast<int>(corner), corners[corner].data());
    }
    Vector centre{};
    box.GetCenter(centre.data());
    LookFromSouth(camera, corners, centre, {}, kDefaultTilt, aspect, room);
    camera->SetViewUp(0.0, 0.0, 1.0);
    return;
  }
  const std::array<double, 4> degrees = DegreesOf(heights);
  Vector middle{ 0.5 * (degrees[0] + degrees[1]), 0.5 * (degrees[2] + degrees[3]), 0.0 };
  Vector centre{};
  const double reach = ReachOf(degrees);
  constexpr double kPlanet = 120.0;
  if (reach > kPlanet)
  {
    const Vector highest{ 0.0, 0.0, std::max(DrawnRange(heights)[1], 0.0) };
    heights.Georeference->PlacesToScene(highest.data(), centre.data(), 1);
    LookAtPlanet(camera, vtkMath::Norm(centre.data()), middle, aspect);
    return;
  }
  if (degrees[1] - degrees[0] > kAllRound && PoleOf(degrees) != 0.0)
  {
    middle[1] = PoleOf(degrees); // of a cap
  }
  Axes axes;
  heights.Georeference->PlacesToScene(middle.data(), centre.data(), 1);
  heights.Georeference->GetAxes(middle.data(), axes.East.data(), axes.North.data(), axes.Up.data());
  const double steep = (90.0 - kDefaultTilt) * std::min(reach / kSteepFrom, 1.0);
  LookFromSouth(camera, OutlineOnGlobe(heights), centre, axes, kDefaultTilt + steep, aspect);
}

//------------------------------------------------------------------------------
void LightGlobe(vtkCamera* camera, vtkLight* sun)
{
  constexpr Vector kFrom = { -0.55, 0.45, 0.7 };
  Vector back{};
  Vector right{};
  Vector up{};
  camera->GetDirectionOfProjection(back.data());
  vtkMath::MultiplyScalar(back.data(), -1.0);
  camera->OrthogonalizeViewUp();
  camera->GetViewUp(up.data());
  vtkMath::Cross(up.data(), back.data(), right.data());
  sun->SetPosition(kFrom[0] * right[0] + kFrom[1] * up[0] + kFrom[2] * back[0],
    kFrom[0] * right[1] + kFrom[1] * up[1] + kFrom[2] * back[1],
    kFrom[0] * right[2] + kFrom[1] * up[2] + kFrom[2] * back[2]);
}

//------------------------------------------------------------------------------
bool IsInsidePlanet(vtkCamera* camera, const PlacedHeights& heights)
{
  if (!heights.IsGlobe())
  {
    return false;
  }
  Vector place{};
  heights.Georeference->SceneToPlaces(camera->GetPosition(), place.data(), 1);
  return place[2] < DrawnRange(heights)[0];
}

//------------------------------------------------------------------------------
void SetClippingRange(vtkCamera* camera, const vtkBoundingBox& box, const PlacedHeights& heights)
{
  double nearest = VTK_DOUBLE_MAX;
  double farthest = 0.0;
  Vector eye{};
  Vector direction{};
  camera->GetPosition(eye.data());
  camera->GetDirectionOfProjection(direction.data());
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector point{};
    box.GetCorner(corner, point.data());
    vtkMath::Subtract(point.data(), eye.data(), point.data());
    const double depth = vtkMath::Dot(point.data(), direction.data());
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  double least = kNearPlane * box.GetDiagonalLength();
  if (heights.IsGlobe())
  {
    const std::array<double, 2> reach = ReachOnGlobe(camera, heights);
    farthest = std::min(farthest, reach[1]);
    least = std::max(reach[0], kNearPlaneOnGlobe * farthest);
  }
  const double nearPlane = std::max((1.0 - kSlack) * nearest, least);
  camera->SetClippingRange(nearPlane, std::max((1.0 + kSlack) * farthest, 2.0 * nearPlane));
}
