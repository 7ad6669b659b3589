// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays at heights in three ways, the ray query, the shader's twin and the reference, each against
// every cell in double precision.
#include "UnitTestQueries.h"

#include "FuzzInput.h"

#include "core/rays/ReferenceRayCaster.h"

#include <cmath>

namespace
{
using terrain::CellPiece;
using terrain::TerrainRay;

terrain::TestField FieldOf(FuzzInput& input)
{
  const int width = 2 + static_cast<int>(input.Number(14));
  const int height = 2 + static_cast<int>(input.Number(14));
  const bool holes = input.Number(2) != 0;
  const double step = std::ldexp(1.0, static_cast<int>(input.Number(12)) - 4);
  const double low = 5000.0 * input.Real();
  return { "input", width, height,
    [&](int, int)
    {
      const int number = input.Take<std::int8_t>();
      return holes && number % 16 == 5 ? terrain::kNaN : low + step * number;
    } };
}

/// A ray over and about a field, of those that go along axes as well; along edges and through
/// vertices only where asked for: where these are rims of holes or of columns it has a choice.
TerrainRay RayOf(FuzzInput& input, const terrain::TestField& field, double relief, bool onEdges)
{
  const std::uint32_t kind = input.Number(onEdges ? 6 : 4);
  const auto end = [&](const glm::dvec2& aside)
  {
    glm::dvec3 point = (glm::dvec3(input.Real(), input.Real(), input.Real()) * 1.5 + 0.5) *
      glm::dvec3(field.Width - 1, field.Height - 1, relief);
    const glm::dvec2 place = kind < 4 ? glm::dvec2(point) : glm::floor(glm::dvec2(point));
    return glm::dvec3(onEdges ? place : place + aside, point.z);
  };
  const glm::dvec3 begin = end({ 0.0121, 0.0233 });
  glm::dvec3 last = end({ 0.0317, 0.0453 });
  last.x = kind == 1 || kind == 3 || kind == 5 ? begin.x : last.x;
  last.y = kind == 3 ? begin.y : last.y;
  last.z = kind == 2 ? begin.z : last.z;
  return terrain::RayBetween(begin, last);
}

/// The largest coordinate in cells, and more, of which kQueryError is a part.
double LargestCoordinate(const terrain::QueryRay& ray, const glm::ivec2& size)
{
  return glm::length(glm::dvec2(ray.Origin)) + glm::length(glm::dvec2(ray.Direction)) +
    glm::length(glm::dvec2(size));
}

/// Heights by which a query of a bent ray may be off.
double HeightTolerance(
  const terrain::QueryRay& ray, const terrain::FieldCodes& codes, double bend = 0.0)
{
  const double steepest = 1.0 + codes.High - codes.Low + std::abs(ray.Direction.z) + std::abs(bend);
  return terrain::kQueryError *
    ((1.0 + LargestCoordinate(ray, codes.size)) * steepest + std::abs(codes.Low) +
      std::abs(ray.Origin.z));
}

/// Checks a query of a surface; returns its answer.
terrain::SurfaceHit CheckQuery(const terrain::TestField& field, const terrain::FieldCodes& codes,
  const TerrainRay& ray, terrain::SurfaceKind kind, double bend)
{
  const terrain::RayQuery query(terrain::SurfaceOf(field, kind));
  const terrain::QueryRay asked = terrain::ToQuery(ray, codes.Low, bend);
  std::vector<CellPiece> pieces =
    terrain::RayPieces(codes, ray, kind == terrain::SurfaceKind::Columns);
  for (CellPiece& piece : pieces)
  {
    piece.A += bend;
  }
  const double largest = LargestCoordinate(asked, codes.size);
  const double tolerance = HeightTolerance(asked, codes, bend);
  const terrain::SurfaceHit hit = query.First(asked);
  Require(hit.Found == query.Any(asked));
  const double before = hit.Found ? hit.Distance - 1e-9 : terrain::kInfinity;
  Require(terrain::Penetration(pieces, before) <= tolerance);
  if (hit.Found)
  {
    const glm::dvec2 expected =
      glm::dvec2(asked.Origin) + hit.Distance * glm::dvec2(asked.Direction);
    Require(glm::length(glm::dvec2(hit.Cell) + hit.Fraction - expected) <=
      terrain::kQueryError * largest);
    const double height =
      asked.Origin.z + hit.Distance * (asked.Direction.z + hit.Distance * asked.Bend);
    Require(std::abs(hit.Height - height) <= tolerance);
  }
  return hit;
}

/// The reference and the query in double precision may differ where a ray touches the surface, ends
/// on it, or goes through the rim at one point: then one that is moved by next to nothing agrees.
/// One that stays on a side, so that it touches at most, hits or does not as rounding has it.
void CheckReference(const terrain::TestField& field, const terrain::FieldCodes& codes,
  const TerrainRay& cast, const terrain::SurfaceHit& hit)
{
  const terrain::QueryRay asked = terrain::ToQuery(cast, codes.Low);
  if (terrain::Penetration(terrain::RayPieces(codes, cast), terrain::kInfinity) <=
    HeightTolerance(asked, codes))
  {
    return;
  }
  const terrain::ReferenceRayCaster<double> reference(field.View(), {}, terrain::SerialFor);
  const double pace = glm::length(glm::dvec2(asked.Direction));
  bool agrees = false;
  for (const double aside : { 0.0, 1e-8, -1e-8 })
  {
    for (const double longer : { 0.0, 1e-9, -1e-9 })
    {
      terrain::ReferenceRay ray;
      ray.Origin = asked.Origin + glm::dvec3(aside, 0.7 * aside, 0.0);
      ray.Direction = asked.Direction;
      ray.Begin = asked.Begin;
      ray.End = asked.End + longer;
      const terrain::ReferenceHit expected = reference.Cast(ray);
      agrees = agrees ||
        (expected.Found == hit.Found &&
          (!hit.Found || std::abs(expected.Distance - hit.Distance) * pace < 1e-6)) ||
        reference.IsNearSilhouette(ray, 1e-5);
    }
  }
  Require(agrees);
}

/// The shader's twin in float, as far as its rays can be told.
void CheckTwin(const terrain::CodedField<float>& coded, const TerrainRay& ray)
{
  const terrain::TerrainHit hit = coded.Coded.TracePyramid(ray);
  const std::vector<CellPiece> pieces = terrain::RayPieces(coded.Coded.heights, ray);
  const double highest = coded.Codes.MaximumCode;
  const double run = glm::length(glm::dvec2(ray.directionGC)) + 10.0;
  const double error = 1e-6 *
      (highest + std::abs(static_cast<double>(ray.originGC.z)) +
        std::abs(static_cast<double>(ray.directionGC.z))) +
    2e-7 * run * highest;
  const double before = hit.found ? static_cast<double>(hit.s) : terrain::kInfinity;
  Require(terrain::Penetration(pieces, before) <= error);
  Require(!hit.found || glm::all(glm::lessThan(hit.cell, coded.Coded.heights.size - 1)));
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  FuzzInput rays(data, size);
  const std::uint32_t skipped = input.Number(64);
  const terrain::TestField field = FieldOf(input);
  for (std::uint32_t k = 0; k < skipped; ++k)
  {
    rays.Take<std::uint8_t>();
  }
  const terrain::FieldCodes codes(field);
  const terrain::CodedField<float> coded(field);
  const bool holes = coded.Codes.HasNoData;
  if (!coded.Codes.HasData)
  {
    return 0;
  }
  const double relief = std::max(codes.High - codes.Low, 1e-3);
  for (int k = 0; k < 4; ++k)
  {
    const TerrainRay ray = RayOf(rays, field, relief, !holes);
    const bool isVertical = ray.directionGC.x == 0.0f && ray.directionGC.y == 0.0f;
    const double bend = isVertical ? 0.0 : 4.0 * relief * rays.Real();
    if (ray.directionGC != glm::vec3(0.0f))
    {
      const auto hit = CheckQuery(field, codes, ray, terrain::SurfaceKind::Bilinear, 0.0);
      CheckReference(field, codes, ray, hit);
      CheckQuery(field, codes, ray, terrain::SurfaceKind::Bilinear, bend);
      CheckTwin(coded, ray);
    }
    const TerrainRay aside = RayOf(rays, field, relief, false);
    if (aside.directionGC != glm::vec3(0.0f))
    {
      CheckQuery(field, codes, aside, terrain::SurfaceKind::Columns, 0.0);
    }
  }
  return 0;
}
