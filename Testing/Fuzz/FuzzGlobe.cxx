// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays at rasters on globes of any shape and place, against brute force in double precision.
#include "UnitTestGlobe.h"

#include "FuzzInput.h"

#include <array>
#include <cmath>

namespace
{
using terrain::kDegree;

terrain::GlobeGrid GridOf(FuzzInput& input)
{
  terrain::GlobeGrid grid;
  grid.Body.Equatorial = input.Number(2) != 0 ? 6378137.0 : 1000000.0 * (1.0 + input.Number(10));
  grid.Body.Polar =
    grid.Body.Equatorial * (1.0 - terrain::kMostFlattening * std::abs(input.Real()));
  // kGlobeError is for cells of at most a degree
  constexpr std::array<double, 4> steps{ 1.0, 0.25, 1.0 / 120.0, 1.0 / 3600.0 };
  const double step = steps[input.Number(steps.size())];
  grid.West = 360.0 * input.Real() * kDegree;
  grid.Step = step * kDegree;
  grid.Columns = 2 + static_cast<int>(input.Number(22));
  const int rows = 2 + static_cast<int>(input.Number(22));
  double latitude = 90.0 * input.Real();
  latitude = std::min(latitude, 90.0 - step * (rows - 1));
  // a pole is the border of many rasters
  const std::uint32_t pole = input.Number(8);
  latitude = pole == 0 ? -90.0 : pole == 1 ? 90.0 - step * (rows - 1) : latitude;
  for (int j = 0; j < rows; ++j)
  {
    grid.Latitudes.push_back(
      std::clamp((latitude + step * j) * kDegree, -90.0 * kDegree, 90.0 * kDegree));
  }
  return grid;
}

/// A place over a grid or beside it, as a position.
glm::dvec3 PointOf(FuzzInput& input, const terrain::GlobeGrid& grid)
{
  // aside of the lines of the grid, which may be the rims of holes
  const double column = grid.Cells().x * (0.5 + 0.7 * input.Real()) + 0.00137;
  const double row =
    std::clamp(grid.Cells().y * (0.5 + 0.7 * input.Real()), 0.0, grid.Cells().y - 0.01) + 0.00171;
  const std::uint32_t above = input.Number(4);
  const double height = above == 0 ? grid.Body.Equatorial * (1.0 + input.Real()) * 1.5
    : above == 1                   ? 9000.0 * input.Real()
    : above == 2                   ? -0.5 * grid.Body.Equatorial * (1.0 + input.Real())
                                   : 400000.0 * (1.0 + input.Real());
  return grid.Body.ToPosition({ grid.West + column * grid.Step, grid.LatitudeOf(row), height });
}

/// True where cells are so narrow that heights of any kind in them have no bound of their slope.
bool IsAtPole(const terrain::GlobeGrid& grid)
{
  return std::max(-grid.Latitudes.front(), grid.Latitudes.back()) > 85.0 * kDegree;
}

/// A hit lies on the surface; a ray that goes through the surface before it, or without any, does
/// so by no more than the error.
void Check(const terrain::World<std::uint16_t>& world, const terrain::GlobeReference& reference,
  const terrain::GlobeReferenceRay& ray)
{
  const terrain::WorldTracer<double, std::uint16_t> tracer(world, ray.Origin);
  const auto hit = tracer.Trace(ray);
  const terrain::GlobeReferenceHit expected = reference.Cast(ray);
  const auto above = [&](double t, glm::ivec2 cell, bool given, double& error)
  {
    glm::dvec2 fraction;
    const glm::dvec3 position = ray.Origin + t * ray.Direction;
    const double height = reference.Above(position, cell, fraction, given);
    error = std::isnan(height)
      ? 0.0
      : terrain::HeightErrorAt(world, cell, world.Grid.Body.ToPlace(position).y);
    return height;
  };
  double error = 0.0;
  Require(!hit.Found ||
    (glm::all(glm::greaterThanEqual(hit.Cell, glm::ivec2(0))) &&
      glm::all(glm::lessThan(hit.Cell, world.Grid.Cells()))));
  // on the axis itself samples of a polar row are at one place
  const glm::dvec3 met = ray.Origin + hit.T * ray.Direction;
  if (hit.Found && glm::length(glm::dvec2(met)) > 1.0)
  {
    const double height = above(hit.T, hit.Cell, true, error);
    Require(std::abs(height) <= error);
  }
  const double end = hit.Found ? hit.T : ray.End;
  if (!IsAtPole(world.Grid) && expected.Found &&
    end > expected.T + 1.0) // metres: what grazes is met anywhere about there
  {
    // as deep as anywhere in the cell where the reference meets the surface
    above(expected.T, expected.Cell, true, error);
    Require(expected.Nearest <= error);
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  const terrain::GlobeGrid grid = GridOf(input);
  if (!grid.WhyNot().empty())
  {
    return 0;
  }
  const bool holes = input.Number(2) != 0;
  FuzzInput rays = input;
  const terrain::TestField field("input", grid.Columns, static_cast<int>(grid.Latitudes.size()),
    [&](int, int)
    {
      const int number = input.Take<std::uint8_t>();
      return holes && number % 16 == 5 ? terrain::kNaN : 16.0 * number;
    });
  const terrain::World<std::uint16_t> world(grid, field);
  if (!world.Field.Codes.HasData)
  {
    return 0;
  }
  const terrain::GlobeReference reference = world.Reference();
  for (int k = 0; k < 4; ++k)
  {
    terrain::GlobeReferenceRay ray;
    ray.Origin = PointOf(rays, grid);
    ray.Direction = PointOf(rays, grid) - ray.Origin;
    ray.End = 20.0 * grid.Body.Equatorial;
    if (!(glm::length(ray.Direction) > 1.0))
    {
      continue;
    }
    ray.Direction = glm::normalize(ray.Direction);
    Check(world, reference, ray);
  }
  return 0;
}
