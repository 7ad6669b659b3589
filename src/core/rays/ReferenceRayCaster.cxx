// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/ReferenceRayCaster.h"

#include "core/grid/Constants.h"
#include "core/grid/SampleTypes.h"
#include "core/rays/Ray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace terrain
{
namespace
{

/// Distance at which a coordinate leaves the interval from low to high; infinite if it stands.
double LeaveDistance(double origin, double direction, double low, double high)
{
  if (direction == 0.0)
  {
    return kInfinity;
  }
  return ((direction > 0.0 ? high : low) - origin) / direction;
}

std::int64_t SquareAt(double position, double bias, std::int64_t size, std::int64_t count)
{
  const double standing = std::floor(position) == position ? bias : 0.0;
  const auto cell = static_cast<std::int64_t>(std::floor(position) + standing);
  return std::clamp<std::int64_t>(cell < 0 ? -1 : cell / size, 0, count - 1);
}

/// Squares of a grid, of so many cells a side, and which of them.
struct SquareGrid
{
  std::int64_t Size;
  std::int64_t CountX;
  std::int64_t CountY;
};

/// Calls visit(x, y, begin, end) for the squares that a ray passes in order, with the distances at
/// which it enters and leaves each, until visit returns true. The ray must be over the grid. Steps
/// are integer, so that no square is left out or met twice.
template <typename Ray, typename Visit>
bool WalkSquares(const Ray& ray, const SquareGrid& grid, double begin, double end, Visit&& visit)
{
  const glm::dvec3 start = ray.Origin + begin * ray.Direction;
  std::int64_t x = SquareAt(start.x, ray.Bias.x, grid.Size, grid.CountX);
  std::int64_t y = SquareAt(start.y, ray.Bias.y, grid.Size, grid.CountY);
  const auto line = [&grid](std::int64_t index) { return static_cast<double>(index * grid.Size); };
  while (x >= 0 && x < grid.CountX && y >= 0 && y < grid.CountY)
  {
    const double leaveX = LeaveDistance(ray.Origin.x, ray.Direction.x, line(x), line(x + 1));
    const double leaveY = LeaveDistance(ray.Origin.y, ray.Direction.y, line(y), line(y + 1));
    const double leave = std::max(begin, std::min({ leaveX, leaveY, end }));
    if (visit(x, y, begin, leave))
    {
      return true;
    }
    if (std::min(leaveX, leaveY) >= end)
    {
      return false;
    }
    begin = leave;
    x += leaveX <= leaveY ? (ray.Direction.x > 0.0 ? 1 : -1) : 0;
    y += leaveX <= leaveY ? 0 : (ray.Direction.y > 0.0 ? 1 : -1);
  }
  return false;
}

/// Smallest u in low..high with c + b u + a u^2 = 0; false if there is none.
bool FirstRoot(double a, double b, double c, double low, double high, double& root)
{
  std::array<double, 2> roots{ kInfinity, kInfinity };
  if (c == 0.0)
  {
    roots[0] = 0.0;
    roots[1] = a != 0.0 ? -b / a : kInfinity;
  }
  else if (a == 0.0)
  {
    roots[0] = b != 0.0 ? -c / b : kInfinity;
  }
  else
  {
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0)
    {
      return false;
    }
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    roots = { q / a, q != 0.0 ? c / q : kInfinity };
  }
  std::sort(roots.begin(), roots.end());
  for (const double u : roots)
  {
    if (u >= low && u <= high)
    {
      root = u;
      return true;
    }
  }
  return false;
}

/// Two unit vectors at right angles to a direction and to each other.
std::array<glm::dvec3, 2> Sideways(const glm::dvec3& direction)
{
  const glm::dvec3 d = glm::normalize(direction);
  const glm::dvec3 axis =
    std::abs(d.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 a = glm::normalize(glm::cross(d, axis));
  return { a, glm::cross(d, a) };
}
}

//------------------------------------------------------------------------------
ReferenceRay ReferenceCamera::PixelRay(std::int64_t x, std::int64_t y) const
{
  const double u = 2.0 * (static_cast<double>(x) + 0.5) / static_cast<double>(this->Width) - 1.0;
  const double v = 1.0 - 2.0 * (static_cast<double>(y) + 0.5) / static_cast<double>(this->Height);
  const glm::dvec3 offset = u * this->Right + v * this->Up;
  ReferenceRay ray;
  ray.Origin = this->Parallel ? this->Eye + offset : this->Eye;
  ray.Direction = this->Parallel ? this->Forward : this->Forward + offset;
  ray.Begin = this->Near;
  ray.End = this->Far;
  return ray;
}

//------------------------------------------------------------------------------
ReferenceCamera MakeReferenceCamera(const glm::dvec3& eye, const glm::dvec3& focalPoint,
  const glm::dvec3& viewUp, double viewAngle, std::int64_t width, std::int64_t height)
{
  ReferenceCamera camera;
  const double half = std::tan(glm::radians(0.5 * viewAngle));
  camera.Eye = eye;
  camera.Forward = glm::normalize(focalPoint - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.Forward, viewUp));
  camera.Up = half * glm::cross(right, camera.Forward);
  camera.Right = half * static_cast<double>(width) / static_cast<double>(height) * right;
  camera.Width = width;
  camera.Height = height;
  return camera;
}

//------------------------------------------------------------------------------
template <typename T>
ReferenceRayCaster<T>::ReferenceRayCaster(
  const HeightfieldView<T>& view, const GridGeometry& geometry, const ParallelFor& parallelFor)
  : View(view)
  , Geometry(geometry)
{
  if (view.Width < 2 || view.Height < 2)
  {
    return;
  }
  this->TilesX = (view.Width - 2) / kReferenceTileCells + 1;
  this->TilesY = (view.Height - 2) / kReferenceTileCells + 1;
  this->Tiles.resize(this->TilesX * this->TilesY, Tile{ kInfinity, -kInfinity });
  parallelFor(this->TilesX * this->TilesY,
    [this](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t tile = begin; tile < end; ++tile)
      {
        this->ScanTile(tile);
      }
    });
  for (const Tile& tile : this->Tiles)
  {
    this->Low = std::min(this->Low, tile.Low);
    this->High = std::max(this->High, tile.High);
  }
}

//------------------------------------------------------------------------------
template <typename T>
void ReferenceRayCaster<T>::ScanTile(std::int64_t tile)
{
  const std::int64_t firstX = tile % this->TilesX * kReferenceTileCells;
  const std::int64_t firstY = tile / this->TilesX * kReferenceTileCells;
  const std::int64_t lastX = std::min(firstX + kReferenceTileCells, this->View.Width - 1);
  const std::int64_t lastY = std::min(firstY + kReferenceTileCells, this->View.Height - 1);
  Tile& range = this->Tiles[tile];
  for (std::int64_t y = firstY; y <= lastY; ++y)
  {
    for (std::int64_t x = firstX; x <= lastX; ++x)
    {
      const double height = this->View.At(x, y);
      range.Low = height < range.Low ? height : range.Low;
      range.High = height > range.High ? height : range.High;
    }
  }
}

//------------------------------------------------------------------------------
template <typename T>
bool ReferenceRayCaster<T>::ClearsTile(
  const GridRay& ray, std::int64_t tx, std::int64_t ty, double begin, double end) const
{
  const Tile& tile = this->Tiles[tx + this->TilesX * ty];
  const double first = ray.Origin.z + begin * ray.Direction.z;
  const double last = ray.Origin.z + end * ray.Direction.z;
  const double margin =
    1e-9 * (this->High - this->Low) + 1e-12 * (std::abs(ray.Origin.z) + std::abs(this->High));
  return std::min(first, last) > tile.High + margin || std::max(first, last) < tile.Low - margin;
}

//------------------------------------------------------------------------------
template <typename T>
bool ReferenceRayCaster<T>::Clip(GridRay& ray) const
{
  const double margin =
    1e-6 * (this->High - this->Low) + 1e-9 * (1.0 + std::abs(this->Low) + std::abs(this->High));
  return ClipToRange(ray.Origin.x, ray.Direction.x, 0.0, static_cast<double>(this->View.Width - 1),
           ray.Begin, ray.End) &&
    ClipToRange(ray.Origin.y, ray.Direction.y, 0.0, static_cast<double>(this->View.Height - 1),
      ray.Begin, ray.End) &&
    ClipToRange(
      ray.Origin.z, ray.Direction.z, this->Low - margin, this->High + margin, ray.Begin, ray.End) &&
    ray.Begin <= ray.End;
}

//------------------------------------------------------------------------------
template <typename T>
bool ReferenceRayCaster<T>::CastCell(const GridRay& ray, std::int64_t x, std::int64_t y,
  double begin, double end, ReferenceHit& hit) const
{
  if (!this->View.IsCellValid(x, y))
  {
    return false;
  }
  const double sw = this->View.At(x, y);
  const double se = this->View.At(x + 1, y) - sw;
  const double nw = this->View.At(x, y + 1) - sw;
  const double twist = this->View.At(x + 1, y + 1) - sw - se - nw;
  const glm::dvec3 start = ray.Origin + begin * ray.Direction;
  const double fx = start.x - static_cast<double>(x);
  const double fy = start.y - static_cast<double>(y);
  const glm::dvec3& d = ray.Direction;
  // Height of the ray minus that of the patch, over the distance u from where it enters.
  const double c = (start.z - sw) - (fx * se + fy * nw + fx * fy * twist);
  const double b = d.z - ((se + fy * twist) * d.x + (nw + fx * twist) * d.y);
  const double a = -twist * d.x * d.y;
  const double pace = std::max(std::abs(d.x), std::abs(d.y));
  const double outside = pace > 0.0 ? kReferenceTolerance / pace : 0.0;
  const double low = std::max(-outside, ray.Begin - begin);
  const double high = std::min(end - begin + outside, ray.End - begin);
  double u = 0.0;
  if (!FirstRoot(a, b, c, low, high, u))
  {
    return false;
  }
  hit.Found = true;
  hit.Distance = begin + u;
  hit.CellX = x;
  hit.CellY = y;
  hit.Fraction =
    glm::clamp(glm::dvec2(fx + u * d.x, fy + u * d.y), glm::dvec2(0.0), glm::dvec2(1.0));
  return true;
}

//------------------------------------------------------------------------------
template <typename T>
ReferenceHit ReferenceRayCaster<T>::CastGrid(const GridRay& ray) const
{
  ReferenceHit hit;
  const SquareGrid tiles{ kReferenceTileCells, this->TilesX, this->TilesY };
  const SquareGrid cells{ 1, this->View.Width - 1, this->View.Height - 1 };
  WalkSquares(ray, tiles, ray.Begin, ray.End,
    [&](std::int64_t tx, std::int64_t ty, double tileBegin, double tileEnd)
    {
      return !this->ClearsTile(ray, tx, ty, tileBegin, tileEnd) &&
        WalkSquares(ray, cells, tileBegin, tileEnd,
          [&](std::int64_t x, std::int64_t y, double begin, double end)
          { return this->CastCell(ray, x, y, begin, end, hit); });
    });
  return hit;
}

//------------------------------------------------------------------------------
template <typename T>
void ReferenceRayCaster<T>::Complete(const ReferenceRay& ray, ReferenceHit& hit) const
{
  const double sw = this->View.At(hit.CellX, hit.CellY);
  const double se = this->View.At(hit.CellX + 1, hit.CellY) - sw;
  const double nw = this->View.At(hit.CellX, hit.CellY + 1) - sw;
  const double twist = this->View.At(hit.CellX + 1, hit.CellY + 1) - sw - se - nw;
  hit.Normal = glm::normalize(this->Geometry.NormalToModel(
    { -se - hit.Fraction.y * twist, -nw - hit.Fraction.x * twist, 1.0 }));
  hit.FromAbove = glm::dot(hit.Normal, ray.Direction) <= 0.0;
}

//------------------------------------------------------------------------------
template <typename T>
ReferenceHit ReferenceRayCaster<T>::Cast(const ReferenceRay& ray) const
{
  ReferenceHit hit;
  if (this->Tiles.empty() || !(this->Low <= this->High))
  {
    return hit;
  }
  GridRay gridRay{ this->Geometry.ToGrid(ray.Origin), this->Geometry.DirectionToGrid(ray.Direction),
    ray.Begin, ray.End, { 0.0, 0.0 } };
  if (!this->Clip(gridRay))
  {
    return hit;
  }
  // A ray that runs along a grid line touches the cells on both sides.
  const auto runsAlongLine = [](double origin, double direction)
  { return direction == 0.0 && std::floor(origin) == origin; };
  const int countX = runsAlongLine(gridRay.Origin.x, gridRay.Direction.x) ? 2 : 1;
  const int countY = runsAlongLine(gridRay.Origin.y, gridRay.Direction.y) ? 2 : 1;
  for (int variant = 0; variant < countX * countY; ++variant)
  {
    const int west = variant % countX;
    const int south = variant / countX;
    gridRay.Bias = { -west, -south };
    const ReferenceHit other = this->CastGrid(gridRay);
    if (other.Found && (!hit.Found || other.Distance < hit.Distance))
    {
      hit = other;
    }
  }
  if (hit.Found)
  {
    this->Complete(ray, hit);
  }
  return hit;
}

//------------------------------------------------------------------------------
template <typename T>
std::vector<double> ReferenceRayCaster<T>::RenderDepth(
  const ReferenceCamera& camera, const ParallelFor& parallelFor) const
{
  std::vector<double> depth(camera.Width * camera.Height);
  parallelFor(camera.Height,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t y = begin; y < end; ++y)
      {
        for (std::int64_t x = 0; x < camera.Width; ++x)
        {
          depth[x + camera.Width * y] = this->Cast(camera.PixelRay(x, y)).Distance;
        }
      }
    });
  return depth;
}

//------------------------------------------------------------------------------
template <typename T>
bool ReferenceRayCaster<T>::IsNearSilhouette(const ReferenceRay& ray, double cells) const
{
  const ReferenceHit hit = this->Cast(ray);
  const auto sideways = Sideways(ray.Direction);
  const double length = cells * std::min(this->Geometry.Spacing.x, this->Geometry.Spacing.y);
  for (int k = 0; k < kSilhouetteDirections; ++k)
  {
    const double angle = 2.0 * glm::radians(180.0) * k / kSilhouetteDirections;
    ReferenceRay moved = ray;
    moved.Origin += length * (std::cos(angle) * sideways[0] + std::sin(angle) * sideways[1]);
    const ReferenceHit other = this->Cast(moved);
    if (other.Found != hit.Found || (hit.Found && other.FromAbove != hit.FromAbove))
    {
      return true;
    }
    const auto position = [](const ReferenceHit& h)
    { return glm::dvec2(h.CellX, h.CellY) + h.Fraction; };
    if (hit.Found && glm::length(position(hit) - position(other)) > kSilhouetteJump)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
template <typename T>
double ReferenceRayCaster<T>::SilhouetteDistance(const ReferenceRay& ray, double largestCells) const
{
  for (int exponent = -9; std::pow(10.0, exponent) <= largestCells * (1.0 + 1e-12); ++exponent)
  {
    const double cells = std::pow(10.0, exponent);
    if (this->IsNearSilhouette(ray, cells))
    {
      return cells;
    }
  }
  return kInfinity;
}

#define TERRAIN_INSTANTIATE(T) template class ReferenceRayCaster<T>;
TERRAIN_FOR_EACH_SAMPLE_TYPE(TERRAIN_INSTANTIATE)
#undef TERRAIN_INSTANTIATE
}
