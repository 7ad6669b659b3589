// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Heights of any size and value through codes, pyramid, coarse mesh, hierarchy and rays: bounds
// against brute force, positions against what they are positions of.
#include "FuzzInput.h"
#include "UnitTestFields.h"
#include "UnitTestRays.h"

#include "core/mesh/CoarseMesh.h"
#include "core/strips/HierarchyBuild.h"
#include "core/strips/Refinement.h"

#include <vector>

namespace
{
void CheckMesh(const terrain::TestField& field, std::int64_t cells)
{
  terrain::CoarseMeshOptions options;
  options.CellsPerQuad = cells;
  const auto mesh = terrain::BuildCoarseMesh(field.View(), options, terrain::SerialFor);
  for (std::int64_t quad = 0; quad < mesh.QuadsX * mesh.QuadsY; ++quad)
  {
    for (int corner = 0; corner < 4 && mesh.QuadKept[quad] != 0; ++corner)
    {
      Require(std::isfinite(
        mesh.VertexHeight(quad % mesh.QuadsX + (corner & 1), quad / mesh.QuadsX + (corner >> 1))));
    }
  }
}

void CheckHierarchy(const terrain::TestField& field, FuzzInput& input)
{
  std::vector<float> samples;
  for (std::int64_t j = 0; j < field.Height; ++j)
  {
    for (std::int64_t i = 0; i < field.Width; ++i)
    {
      samples.push_back(static_cast<float>(field.View().At(i, j)));
    }
  }
  const auto rows = [&](std::int64_t first, std::int64_t count, float* heights)
  {
    std::copy_n(&samples[first * field.Width], count * field.Width, heights);
    return std::string();
  };
  terrain::MemoryHierarchy hierarchy;
  Require(terrain::BuildHierarchy(
    hierarchy, field.Width, field.Height, {}, rows, terrain::SerialFor, {}, input.Number(2) != 0)
            .empty());
  terrain::RefinementView view;
  view.Eye = { 20.0 * input.Real(), 20.0 * input.Real(), 100.0 * input.Real() };
  view.PixelsPerUnit = 500.0;
  terrain::RefinementOptions options;
  options.Morphing = true;
  options.Method = static_cast<terrain::RefinementMethod>(input.Number(2));
  terrain::StripMesh mesh;
  terrain::Refiner(hierarchy.View()).Refine(view, options, mesh);
  for (const std::uint32_t index : mesh.Strip)
  {
    Require(index < mesh.Vertices.size() && std::isfinite(mesh.Vertices[index].Height) &&
      std::isfinite(mesh.Vertices[index].Displacement));
  }
}

void CheckRays(const terrain::TestField& field, FuzzInput& input)
{
  const terrain::CodedField<float> coded(field);
  if (!coded.Codes.HasData || field.Width < 2 || field.Height < 2)
  {
    return;
  }
  for (int ray = 0; ray < 4; ++ray)
  {
    const auto end = [&]
    {
      return glm::dvec3(field.Width * input.Real(), field.Height * input.Real(),
        coded.Codes.MaximumCode * (0.5 + input.Real()));
    };
    const glm::dvec3 begin = end();
    const terrain::TerrainHit hit = coded.Coded.TracePyramid(terrain::RayBetween(begin, end()));
    Require(hit.crossings <= 2 * (field.Width + field.Height) + 64);
    if (hit.found)
    {
      Require(hit.cell.x >= 0 && hit.cell.y >= 0 && hit.cell.x < field.Width - 1 &&
        hit.cell.y < field.Height - 1 && field.View().IsCellValid(hit.cell.x, hit.cell.y));
    }
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  const int width = 1 + static_cast<int>(input.Number(70));
  const int height = 1 + static_cast<int>(input.Number(40));
  const std::uint32_t kind = input.Number(4);
  const terrain::TestField field("input", width, height,
    [&](int i, int j) -> double
    {
      switch (input.Left() > 8 ? kind : 4)
      {
        case 0:
          return input.Real() * 1000.0;
        case 1:
          return input.Take<float>();
        case 2:
          return input.Take<double>();
        case 3:
          return input.Take<std::int8_t>() * 1e28;
        default:
          return (i * 31 + j * 17) % 23;
      }
    });
  CheckMesh(field, 1 + width % 9);
  CheckHierarchy(field, input);
  CheckRays(field, input);
  return 0;
}
