// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Refinement as an input asks for it: any mesh, whose indices, records and samples are there.
 */
#ifndef FuzzStrips_h
#define FuzzStrips_h

#include "FuzzInput.h"

#include "core/strips/HierarchyBuild.h"
#include "core/strips/Refinement.h"

#include <cmath>
#include <cstdint>
#include <string>

/// Rows of a raster of some width, no two of its samples alike.
inline terrain::HeightRows RowsOfWidth(std::int64_t width)
{
  return [width](std::int64_t first, std::int64_t count, float* heights)
  {
    for (std::int64_t i = 0; i < count * width; ++i)
    {
      heights[i] = static_cast<float>((first * width + i) * 7919 % 101);
    }
    return std::string();
  };
}

struct FuzzRefinement
{
  terrain::RefinementView View;
  terrain::RefinementOptions Options;

  explicit FuzzRefinement(FuzzInput& input)
  {
    this->View.Eye = { 40.0 * input.Real(), 40.0 * input.Real(), 200.0 * input.Real() };
    this->View.PixelsPerUnit = 1.0 + 1000.0 * std::abs(input.Real());
    this->View.Planes.resize(input.Number(5));
    for (glm::dvec4& plane : this->View.Planes)
    {
      plane = { input.Real(), input.Real(), input.Real(), 50.0 * input.Real() };
    }
    this->Options.Tolerance = 0.1 + std::abs(input.Real());
    this->Options.Method = static_cast<terrain::RefinementMethod>(input.Number(2));
    this->Options.Culling = static_cast<terrain::CullingMethod>(input.Number(3));
    this->Options.Morphing = input.Number(2) != 0;
    this->Options.TriangleBudget = input.Number(2) * (4 + input.Number(2000));
  }

  void Check(const terrain::HierarchyView& hierarchy) const
  {
    if (!terrain::Refiner::WhyNotRefine(this->View, this->Options).empty())
    {
      return;
    }
    terrain::StripMesh mesh;
    terrain::Refiner(hierarchy).Refine(this->View, this->Options, mesh);
    for (const std::uint32_t index : mesh.Strip)
    {
      Require(index < mesh.Vertices.size());
    }
    const terrain::HierarchyLayout& layout = *hierarchy.Layout;
    for (const terrain::StripVertex& vertex : mesh.Vertices)
    {
      const bool isRecord = vertex.Record < terrain::StripVertex::NoRecord;
      Require(!isRecord || vertex.Record < layout.RecordCount());
      Require(vertex.Column < layout.Width() && vertex.Row < layout.Height());
    }
    const std::int64_t budget = this->Options.TriangleBudget;
    Require(budget == 0 || mesh.Triangles <= budget);
  }
};

#endif
