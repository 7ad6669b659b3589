// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Worlds that break careless code, and rays at them of every kind.
 */
#ifndef UnitTestGlobe_h
#define UnitTestGlobe_h

#include "UnitTestFields.h"

#include "core/globe/GlobeReference.h"
#include "core/globe/GlobeTraversal.h"
#include "core/grid/Constants.h"

#include <glm/gtc/constants.hpp>

namespace terrain
{
/// A grid and its heights as a graphics card has them.
template <typename Texel>
struct World
{
  GlobeGrid Grid;
  CodedField<Texel> Field;

  World(GlobeGrid grid, const TestField& field)
    : Grid(std::move(grid))
    , Field(field)
  {
  }
  double Height(int i, int j) const
  {
    const float code = this->Field.Coded.heights.Code({ i, j });
    return code < 0.0f ? kNaN : this->Field.Codes.ToHeight(static_cast<double>(code));
  }
  GlobeReference Reference() const
  {
    return { this->Grid, [this](int i, int j) { return this->Height(i, j); }, this->Range() };
  }
  GlobeRange Range() const
  {
    return { this->Field.Codes.Offset, this->Field.Codes.ToHeight(this->Field.Codes.MaximumCode) };
  }
};

/// A traversal about an anchor, with all that it points to.
template <typename Real, typename Texel>
struct WorldTracer
{
  GlobeAnchor Anchor;
  GlobeLines<Real> Lines;
  GlobeTraversal<Real, Texel> Traversal;

  WorldTracer(const World<Texel>& world, const glm::dvec3& anchor)
    : Anchor(world.Grid, world.Range(), anchor)
    , Lines(world.Grid, this->Anchor)
  {
    this->Traversal.lines = &this->Lines;
    this->Traversal.heights = world.Field.Coded.heights;
    this->Traversal.pyramid = &world.Field.Pyramid;
    this->Traversal.SetHeights(
      world.Field.Codes.Offset, world.Field.Codes.Scale, this->Anchor.Height);
  }
  WorldTracer(const WorldTracer&) = delete;
  WorldTracer& operator=(const WorldTracer&) = delete;

  GlobeHit<Real> Trace(const GlobeReferenceRay& ray) const
  {
    GlobeRay<Real> about;
    about.Origin = this->Anchor.ToAxes(ray.Origin - this->Anchor.Position);
    about.Direction = this->Anchor.ToAxes(ray.Direction);
    about.Begin = static_cast<Real>(ray.Begin);
    about.End = static_cast<Real>(ray.End);
    return this->Traversal.Trace(about);
  }
};

/// By how much a height may be off at a hit: kGlobeError, and what a way of that length changes
/// along the steepest line of the cell.
inline double HeightErrorAt(
  const World<std::uint16_t>& world, const glm::ivec2& cell, double latitude)
{
  double low = kInfinity;
  double high = -low;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double height = world.Height(cell.x + (corner & 1), cell.y + (corner >> 1));
    low = std::min(low, height);
    high = std::max(high, height);
  }
  const double side = world.Grid.Step * world.Grid.Body.Polar * std::abs(std::cos(latitude));
  return kGlobeError * (1.0 + (high - low) / side);
}

/// From south to north, degrees.
inline std::vector<double> Parallels(double south, double step, int count)
{
  std::vector<double> latitudes;
  latitudes.reserve(static_cast<std::size_t>(count));
  for (int j = 0; j < count; ++j)
  {
    latitudes.push_back((south + step * j) * kDegree);
  }
  return latitudes;
}

inline GlobeGrid MakeGrid(
  const Ellipsoid& body, double west, double step, int columns, std::vector<double> latitudes)
{
  GlobeGrid grid;
  grid.Body = body;
  grid.West = west * kDegree;
  grid.Step = step * kDegree;
  grid.Columns = columns;
  grid.Latitudes = std::move(latitudes);
  return grid;
}

/// Cells about samples: a row of half cells closes each pole.
inline std::vector<double> ParallelsOfCells(double step)
{
  std::vector<double> latitudes =
    Parallels(-90.0 + 0.5 * step, step, static_cast<int>(180.0 / step));
  latitudes.insert(latitudes.begin(), -90.0 * kDegree);
  latitudes.push_back(90.0 * kDegree);
  return latitudes;
}

struct TestGlobe
{
  std::string Name;
  GlobeGrid Grid;
  std::function<double(int, int)> Heights;

  TestField Field() const
  {
    return { this->Name, this->Grid.Columns, static_cast<int>(this->Grid.Latitudes.size()),
      [this](int i, int j)
      { return this->Heights(this->Grid.IsJoined() && i == this->Grid.Columns - 1 ? 0 : i, j); } };
  }
};

inline std::vector<TestGlobe> TestGlobes()
{
  const Ellipsoid earth;
  const Ellipsoid mars{ 3396190.0, 3376200.0 };
  const Ellipsoid moon{ 1737400.0, 1737400.0 };
  const Ellipsoid oblate{ 6378137.0, 0.9 * 6378137.0 };
  const auto hills = [](int i, int j)
  {
    return std::floor(2000.0 + 3000.0 * std::sin(0.31 * i) * std::cos(0.23 * j) +
      2500.0 * std::sin(1.9 * i + j) * std::cos(2.3 * j));
  };
  const auto rough = [](int i, int j)
  {
    std::minstd_rand generator(static_cast<unsigned>(1 + 7919 * i + 104729 * j));
    generator.discard(5);
    return static_cast<double>(generator() % 9000u);
  };
  const auto pole = [hills](int i, int j) { return j == 0 || j == 180 ? 500.0 : hills(i, j); };
  const auto holes = [hills](int i, int j)
  { return (i * 7 + j * 5) % 23 == 0 ? kNaN : hills(i, j); };
  return {
    { "nodes at the poles", MakeGrid(earth, -180.0, 1.0, 361, Parallels(-90.0, 1.0, 181)), pole },
    { "cells at the poles", MakeGrid(earth, -179.5, 1.0, 361, ParallelsOfCells(1.0)), rough },
    { "0 to 360", MakeGrid(mars, 0.0, 1.0, 361, Parallels(-90.0, 1.0, 181)), hills },
    { "-200 to 160", MakeGrid(moon, -200.0, 1.0, 361, Parallels(-90.0, 1.0, 181)), rough },
    { "oblate", MakeGrid(oblate, -180.0, 0.5, 721, Parallels(-90.0, 0.5, 361)), hills },
    { "across the date line", MakeGrid(earth, 170.0, 0.5, 61, Parallels(-15.0, 0.5, 61)), hills },
    { "northern", MakeGrid(earth, 0.0, 0.5, 701, Parallels(60.0, 0.5, 61)), hills },
    { "fine", MakeGrid(earth, 10.0, 1.0 / 1200.0, 101, Parallels(46.0, 1.0 / 1200.0, 91)), rough },
    { "holes", MakeGrid(earth, -180.25, 1.0, 361, Parallels(-90.0, 1.0, 181)), holes },
    { "flat", MakeGrid(earth, -180.0, 1.0, 361, Parallels(-90.0, 1.0, 181)),
      [](int, int) { return 0.0; } },
  };
}

/// A sector at the north pole, of samples that differ there as well.
inline TestGlobe RoughPole(double step)
{
  constexpr int rows = 6;
  return { "spokes",
    MakeGrid(Ellipsoid{}, 20.0, step, 24, Parallels(90.0 - step * (rows - 1), step, rows)),
    [](int i, int j) { return 16.0 * ((i * 97 + j * 31) % 256); } };
}

/// Rays at a world from everywhere.
class GlobeRays
{
public:
  enum Kinds
  {
    Space,   ///< from up to three radii away to the ground
    Grazing, ///< past the horizon
    Ground,  ///< 2 m above the ground, most of them along it
    Inside,  ///< from within the planet
    Poles,   ///< through the axis near a pole
    Lines,   ///< in the plane of a meridian or of the equator
    Count
  };

  explicit GlobeRays(const TestGlobe& globe, unsigned seed)
    : Globe(globe)
    , Generator(seed)
  {
  }

  GlobeReferenceRay Make(int kind)
  {
    const Ellipsoid& body = this->Globe.Grid.Body;
    GlobeReferenceRay ray;
    const glm::dvec3 ground = body.ToPosition(this->Place());
    const glm::dvec3 up = glm::normalize(ground);
    const double a = body.Equatorial;
    switch (kind)
    {
      case Space:
        ray.Origin =
          ground + a * this->In(0.01, 3.0) * glm::normalize(up + 0.9 * this->Direction());
        ray.Direction = ground - ray.Origin;
        break;
      case Grazing:
        ray.Direction = this->Direction();
        ray.Direction -= up * glm::dot(up, ray.Direction);
        ray.Origin = ground + up * this->In(-20000.0, 30000.0) -
          a * this->In(0.0, 2.0) * glm::normalize(ray.Direction);
        break;
      case Ground:
        ray.Origin = body.ToPosition(this->Place(2.0));
        ray.Direction = this->Direction();
        ray.Direction -= this->In(0.5, 1.0) * up * glm::dot(up, ray.Direction);
        break;
      case Inside:
        ray.Origin = a * this->In(0.0, 0.99) * this->Direction();
        ray.Direction = this->Direction();
        break;
      case Poles:
        ray.Origin = glm::dvec3(this->In(-1.0, 1.0), this->In(-1.0, 1.0), a * this->In(1.001, 2.0));
        ray.Origin.z *= this->In(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
        ray.Direction = glm::dvec3(0.01, 0.01, 1.0) * this->Direction() +
          glm::dvec3(0.0, 0.0, ray.Origin.z < 0.0 ? 1.0 : -1.0);
        if (this->In(0.0, 1.0) < 0.1 && this->Globe.Heights(0, 0) == this->Globe.Heights(7, 0))
        {
          ray.Origin.x = ray.Origin.y = ray.Direction.x = ray.Direction.y = 0.0;
        }
        break;
      default:
      {
        const double longitude = std::floor(this->In(-180.0, 180.0)) * kDegree;
        const glm::dvec3 east(std::cos(longitude), std::sin(longitude), 0.0);
        const glm::dvec3 other =
          this->In(0.0, 1.0) < 0.5 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(-east.y, east.x, 0.0);
        const double angle = this->In(0.0, 6.28);
        ray.Origin = a * this->In(1.0, 3.0) * (std::cos(angle) * east + std::sin(angle) * other);
        const double way = this->In(0.0, 6.28);
        ray.Direction =
          a * this->In(0.0, 1.0) * (std::cos(way) * east + std::sin(way) * other) - ray.Origin;
      }
    }
    ray.Direction = glm::normalize(ray.Direction);
    ray.End = 20.0 * a;
    return ray;
  }

private:
  double In(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Generator);
  }
  glm::dvec3 Direction()
  {
    std::normal_distribution<double> normal;
    return glm::normalize(
      glm::dvec3(normal(this->Generator), normal(this->Generator), normal(this->Generator)));
  }
  /// A place on the grid, at a height above its surface or about it.
  glm::dvec3 Place(double above = -1e9)
  {
    const GlobeGrid& grid = this->Globe.Grid;
    const double x = this->In(0.0, grid.Cells().x - 1e-6);
    const double y = this->In(0.0, grid.Cells().y - 1e-6);
    const auto row = static_cast<std::size_t>(y);
    const double v = y - static_cast<double>(row);
    const glm::dvec2 place(
      grid.West + x * grid.Step, grid.Latitudes[row] * (1.0 - v) + grid.Latitudes[row + 1] * v);
    double height = this->In(-1000.0, 9000.0);
    if (above > -1e8)
    {
      glm::ivec2 cell;
      glm::dvec2 fraction;
      GlobeReference reference(grid,
        [this](int i, int j)
        {
          const double h = this->Globe.Heights(
            this->Globe.Grid.IsJoined() && i == this->Globe.Grid.Columns - 1 ? 0 : i, j);
          return std::isnan(h) ? 0.0 : h;
        },
        {});
      height = above - reference.Above(grid.Body.ToPosition({ place, 0.0 }), cell, fraction, false);
    }
    return { place, height };
  }

  const TestGlobe& Globe;
  std::mt19937 Generator;
};
}

#endif
