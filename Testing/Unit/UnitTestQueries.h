// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Test fields and rays (UnitTestFields.h, UnitTestRays.h) as queries in double precision take them.
 */
#ifndef UnitTestQueries_h
#define UnitTestQueries_h

#include "UnitTestFields.h"
#include "UnitTestRays.h"

#include "core/grid/HeightSampling.h"
#include "core/rays/RayQuery.h"

#include <memory>

namespace terrain
{
/// A field as UnitTestRays.h reads it: codes are heights above the lowest one, without rounding.
struct FieldCodes
{
  explicit FieldCodes(const TestField& field)
    : Field(field)
    , size(field.Width, field.Height)
  {
    for (const double height : field.Samples)
    {
      this->Low = std::isnan(height) ? this->Low : std::min(this->Low, height);
      this->High = std::isnan(height) ? this->High : std::max(this->High, height);
    }
  }
  glm::dvec4 CellCodes(glm::ivec2 cell) const
  {
    glm::dvec4 codes;
    for (int k = 0; k < 4; ++k)
    {
      const double height = this->Field.View().At(cell.x + (k & 1), cell.y + (k >> 1));
      codes[k] = std::isnan(height) ? -1.0 : height - this->Low;
    }
    return codes;
  }

  const TestField& Field;
  glm::ivec2 size;
  double Low = kInfinity;
  double High = -kInfinity;
};

inline Surface SurfaceOf(const TestField& field, SurfaceKind kind = SurfaceKind::Bilinear)
{
  Surface surface;
  surface.Heights = std::make_shared<SampledHeights<double>>(field.View(), BackwardFor);
  surface.Kind = kind;
  return surface;
}

/// The same ray in heights instead of codes.
inline QueryRay ToQuery(const TerrainRay& ray, double low, double bend = 0.0)
{
  QueryRay query;
  query.Origin = { ray.anchorCell.x + static_cast<double>(ray.originGC.x),
    ray.anchorCell.y + static_cast<double>(ray.originGC.y),
    static_cast<double>(ray.originGC.z) + static_cast<double>(ray.originLow) + low };
  query.Direction = glm::dvec3(ray.directionGC);
  query.Begin = ray.sBegin;
  query.End = ray.sEnd;
  query.Bend = bend;
  return query;
}
}

#endif
