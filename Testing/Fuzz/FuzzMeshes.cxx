// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Greedy meshes of heights of any size and value: within their error of every sample, and with the
// border of the cells that have a surface.
#include "FuzzInput.h"
#include "UnitTestFields.h"

#include "core/mesh/GreedyMesh.h"
#include "core/mesh/MeshError.h"

#include <cmath>

namespace
{
double HeightOf(FuzzInput& input, std::uint32_t kind)
{
  const int number = input.Take<std::int8_t>();
  const bool hole = kind != 0 && number % 32 == 7;
  switch (kind)
  {
    case 1:
      return hole ? std::nan("") : number;
    case 2:
      return hole ? std::nan("") : number * 1e30;
    case 3:
      return input.Take<float>();
    default:
      return 0.125 * number;
  }
}

/// Sides of cells with a surface that no other such cell has.
std::size_t BorderSides(const terrain::HeightfieldView<double>& view, double& area)
{
  const auto has = [&view](std::int64_t i, std::int64_t j) {
    return i >= 0 && j >= 0 && i < view.Width - 1 && j < view.Height - 1 && view.IsCellValid(i, j);
  };
  std::size_t sides = 0;
  for (std::int64_t j = 0; j < view.Height - 1; ++j)
  {
    for (std::int64_t i = 0; i < view.Width - 1; ++i)
    {
      if (has(i, j))
      {
        area += 1.0;
        sides += (has(i - 1, j) ? 0 : 1) + (has(i + 1, j) ? 0 : 1) + (has(i, j - 1) ? 0 : 1) +
          (has(i, j + 1) ? 0 : 1);
      }
    }
  }
  return sides;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  const int width = 1 + static_cast<int>(input.Number(40));
  const int height = 1 + static_cast<int>(input.Number(40));
  const std::uint32_t kind = input.Number(4);
  terrain::GreedyMeshOptions options;
  options.CellsPerTile = static_cast<int>(input.Number(40));
  options.MaximumError = std::abs(100.0 * input.Real());
  double highest = 0.0;
  const terrain::TestField field("input", width, height,
    [&](int, int)
    {
      const double sample = HeightOf(input, kind);
      highest = std::isfinite(sample) ? std::max(highest, std::abs(sample)) : highest;
      return sample;
    });
  const terrain::HeightfieldView<double> view = field.View();
  const terrain::GridMesh mesh = terrain::BuildGreedyMesh(view, options, terrain::SerialFor);
  double area = 0.0;
  const std::size_t sides = BorderSides(view, area);
  double border = 0.0;
  for (const glm::ivec2& edge : terrain::FindBorderEdges(mesh))
  {
    const glm::dvec2 way = mesh.Vertices[static_cast<std::size_t>(edge.y)] -
      mesh.Vertices[static_cast<std::size_t>(edge.x)];
    border += glm::length(way);
  }
  double covered = 0.0;
  for (std::size_t k = 0; k + 2 < mesh.Triangles.size(); k += 3)
  {
    const auto corner = [&](std::size_t c)
    { return glm::dvec2(mesh.Vertices[static_cast<std::size_t>(mesh.Triangles[k + c])]); };
    const glm::dvec2 a = corner(1) - corner(0);
    const glm::dvec2 b = corner(2) - corner(0);
    Require(a.x * b.y - a.y * b.x > 0.0);
    covered += 0.5 * (a.x * b.y - a.y * b.x);
  }
  Require(covered == area && border == static_cast<double>(sides));
  const double most = std::max(options.MaximumError, 2.0 * terrain::kMeshErrorSlack * highest);
  Require(mesh.Triangles.empty() || terrain::FindMeshError(view, mesh, terrain::SerialFor) <= most);
  return 0;
}
