// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// A prepared hierarchy whose records, summary and view are the input's: any mesh, whose indices,
// records and samples are there.
#include "FuzzInput.h"

#include "core/strips/HierarchyBuild.h"
#include "core/strips/Refinement.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace
{
terrain::MemoryHierarchy Prepare(std::int64_t width, std::int64_t height)
{
  terrain::MemoryHierarchy hierarchy;
  const auto rows = [width](std::int64_t first, std::int64_t count, float* heights)
  {
    for (std::int64_t i = 0; i < count * width; ++i)
    {
      heights[i] = static_cast<float>((first * width + i) * 7919 % 101);
    }
    return std::string();
  };
  if (!terrain::BuildHierarchy(hierarchy, width, height, {}, rows, terrain::SerialFor, {}, false)
         .empty())
  {
    std::abort();
  }
  return hierarchy;
}

void Check(const terrain::StripMesh& mesh, const terrain::MemoryHierarchy& hierarchy)
{
  for (const std::uint32_t index : mesh.Strip)
  {
    if (index >= mesh.Vertices.size())
    {
      std::abort();
    }
  }
  for (const terrain::StripVertex& vertex : mesh.Vertices)
  {
    const bool isRecord = vertex.Record < terrain::StripVertex::NoRecord;
    if ((isRecord && vertex.Record >= hierarchy.Records.size()) ||
      vertex.Column >= hierarchy.Layout.Width() || vertex.Row >= hierarchy.Layout.Height())
    {
      std::abort();
    }
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::array<terrain::MemoryHierarchy, 3> prepared{ Prepare(34, 18), Prepare(33, 33),
    Prepare(5, 60) };
  FuzzInput input(data, size);
  terrain::MemoryHierarchy hierarchy = prepared[input.Number(3)];
  hierarchy.Summary.HasHoles = input.Number(2) != 0;
  terrain::RefinementView view;
  view.Eye = { 40.0 * input.Real(), 40.0 * input.Real(), 200.0 * input.Real() };
  view.PixelsPerUnit = 1.0 + 1000.0 * std::abs(input.Real());
  view.Planes.resize(input.Number(5));
  for (glm::dvec4& plane : view.Planes)
  {
    plane = { input.Real(), input.Real(), input.Real(), 50.0 * input.Real() };
  }
  terrain::RefinementOptions options;
  options.Tolerance = 0.1 + std::abs(input.Real());
  options.Method = static_cast<terrain::RefinementMethod>(input.Number(2));
  options.Culling = static_cast<terrain::CullingMethod>(input.Number(3));
  options.Morphing = input.Number(2) != 0;
  options.TriangleBudget = input.Number(2) * (4 + input.Number(2000));
  // What is left goes over the records, from a place on that it says.
  const std::size_t bytes = hierarchy.Records.size() * sizeof(terrain::HierarchyRecord);
  const std::size_t begin = input.Number(static_cast<std::uint32_t>(bytes));
  const std::size_t count = std::min(input.Left(), bytes - begin);
  std::memcpy(reinterpret_cast<char*>(hierarchy.Records.data()) + begin, input.Rest(), count);
  terrain::StripMesh mesh;
  if (terrain::Refiner::WhyNotRefine(view, options).empty())
  {
    terrain::Refiner(hierarchy.View()).Refine(view, options, mesh);
    Check(mesh, hierarchy);
    if (options.TriangleBudget > 0 && mesh.Triangles > options.TriangleBudget)
    {
      std::abort();
    }
  }
  return 0;
}
