// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Refinement of records that no raster has, as a damaged file holds them: any mesh, but one whose
// indices and samples are there, from memory that belongs to it. And budgets in any view.
#include "HierarchyTestTools.h"

#include "core/strips/DetailHierarchy.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace hierarchytest;
using terrain::CullingMethod;
using terrain::MemoryHierarchy;
using terrain::RefinementMethod;
using terrain::RefinementOptions;
using terrain::RefinementView;
using terrain::StripMesh;

namespace
{
/// A view in a random direction, with the planes of a frustum.
RefinementView MakeFrustum(const Raster& raster, std::mt19937& random)
{
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const double u = part(random);
  const double v = part(random);
  RefinementView view = MakeView(raster, u, v, 5.0 + 300.0 * part(random) * part(random));
  const double turn = 6.283185307179586 * part(random);
  const glm::dvec3 ahead =
    glm::normalize(glm::dvec3(std::cos(turn), std::sin(turn), -1.5 * part(random)));
  const glm::dvec3 aside = glm::normalize(glm::cross(ahead, glm::dvec3(0.0, 0.0, 1.0)));
  const glm::dvec3 up = glm::cross(aside, ahead);
  for (const glm::dvec3& normal :
    { ahead + 1.6 * aside, ahead - 1.6 * aside, ahead + 2.0 * up, ahead - 2.0 * up, ahead })
  {
    view.Planes.emplace_back(normal, -glm::dot(normal, view.Eye));
  }
  return view;
}

/// What of a mesh refers to nothing.
std::string WhyNotWithin(
  const StripMesh& mesh, const terrain::HierarchyLayout& layout, std::uint32_t cells)
{
  for (const std::uint32_t index : mesh.Strip)
  {
    if (index >= mesh.Vertices.size())
    {
      return "index " + std::to_string(index) + " of " + std::to_string(mesh.Vertices.size());
    }
  }
  for (const terrain::StripVertex& vertex : mesh.Vertices)
  {
    const bool isRecord = vertex.Record < terrain::StripVertex::NoRecord;
    if (isRecord && vertex.Record >= layout.RecordCount())
    {
      return "record " + std::to_string(vertex.Record) + " of " +
        std::to_string(layout.RecordCount());
    }
    const bool isBelow = vertex.Record == terrain::StripVertex::BelowSamples;
    const std::int64_t columns = isBelow ? layout.Cells() + 1 : layout.Width();
    const std::int64_t rows = isBelow ? layout.Cells() + 1 : layout.Height();
    if (vertex.Column >= cells * columns || vertex.Row >= cells * rows)
    {
      return "a vertex beyond the raster";
    }
  }
  return {};
}

/// Overwrites bytes [begin, end) of the records.
void Damage(MemoryHierarchy& hierarchy, const std::string& kind, std::size_t begin, std::size_t end)
{
  std::mt19937 random(11);
  auto* bytes = reinterpret_cast<unsigned char*>(hierarchy.Records.data());
  end = std::min(end, hierarchy.Records.size() * sizeof(terrain::HierarchyRecord));
  const std::string text = "Other text lies here. ";
  for (std::size_t i = begin; i < end; ++i)
  {
    bytes[i] = static_cast<unsigned char>(
      kind == "noise" ? random() : (kind == "text" ? text[i % text.size()] : 0xff));
  }
}

void ExpectWithin(const MemoryHierarchy& hierarchy, const terrain::DetailHierarchy* detail,
  const Raster& raster, unsigned seed)
{
  std::mt19937 random(seed);
  terrain::Refiner refiner(hierarchy.View(), detail);
  const std::uint32_t cells = detail ? 1U << detail->Level() : 1U;
  for (const auto method : { RefinementMethod::Improved, RefinementMethod::Plain })
  {
    for (const auto culling : { CullingMethod::None, CullingMethod::Nested, CullingMethod::Lazy })
    {
      RefinementOptions options = WithTolerance(2.0);
      options.Method = method;
      options.Culling = culling;
      options.Morphing = (random() & 1) != 0;
      options.TriangleBudget = (random() & 1) != 0 ? 3000 : 0;
      RefinementView view = MakeFrustum(raster, random);
      view.DetailScale = 0.5;
      StripMesh mesh;
      refiner.Refine(view, options, mesh);
      EXPECT_EQ(WhyNotWithin(mesh, hierarchy.Layout, cells), "");
    }
  }
}
}

TEST(RefinementDamage, StaysWithinItsMemory)
{
  terrain::DetailHierarchy detail;
  const Raster period = MakeHills(16, 16);
  ASSERT_EQ(detail.Build(period.Heights.data(), { 16, 16 }, 1, terrain::SerialFor), "");
  // Just above a power of two there is the most room beyond the raster.
  for (const auto& size :
    std::vector<std::array<std::int64_t, 2>>{ { { 70, 34 } }, { { 34, 66 } } })
  {
    for (const char* pattern : { "none", "lake" })
    {
      const Raster raster = WithHoles(MakeHills(size[0], size[1]), pattern);
      const MemoryHierarchy sound = Build(raster);
      const std::size_t bytes = sound.Records.size() * sizeof(terrain::HierarchyRecord);
      for (const char* kind : { "noise", "text", "ones" })
      {
        for (const std::size_t begin :
          { std::size_t(0), bytes / 3, bytes - std::min<std::size_t>(bytes, 4096) })
        {
          MemoryHierarchy damaged = sound;
          Damage(damaged, kind, begin, begin + 4096);
          ExpectWithin(damaged, nullptr, raster, 1);
          ExpectWithin(damaged, &detail, raster, 2);
        }
        MemoryHierarchy damaged = sound;
        Damage(damaged, kind, 0, bytes);
        ExpectWithin(damaged, nullptr, raster, 3);
        ExpectWithin(damaged, &detail, raster, 4);
      }
    }
  }
}

// Everything is as wrong as can be, so everything is refined.
TEST(RefinementDamage, RefinesTheWholeSquareAtMost)
{
  const Raster raster = MakeHills(70, 34);
  MemoryHierarchy hierarchy = Build(raster);
  for (terrain::HierarchyRecord& record : hierarchy.Records)
  {
    record.SetError(1.0e30f);
    record.SetRadius(1.0e30f);
    record.SetDrawn(terrain::HierarchyRecord::DrawnBits);
  }
  for (const auto method : { RefinementMethod::Improved, RefinementMethod::Plain })
  {
    RefinementOptions options = WithTolerance(1.0);
    options.Method = method;
    StripMesh mesh;
    terrain::Refiner(hierarchy.View()).Refine(MakeView(raster, 0.5, 0.5, 10.0), options, mesh);
    EXPECT_GT(mesh.Triangles, 2 * 64 * 32);
    EXPECT_LE(mesh.Triangles, 2 * 128 * 128);
    EXPECT_EQ(WhyNotWithin(mesh, hierarchy.Layout, 1), "");
  }
}

TEST(RefinementDamage, KeepsBudgetsInAnyView)
{
  const Raster raster = MakeHills(257, 200);
  const MemoryHierarchy hierarchy = Build(raster);
  terrain::Refiner refiner(hierarchy.View());
  std::mt19937 random(5);
  StripMesh mesh;
  for (int i = 0; i < 400; ++i)
  {
    const RefinementView view = MakeFrustum(raster, random);
    RefinementOptions options = WithTolerance(0.3);
    options.Method = (i & 1) != 0 ? RefinementMethod::Plain : RefinementMethod::Improved;
    options.Culling = static_cast<CullingMethod>(random() % 3);
    options.Morphing = (random() & 1) != 0;
    options.TriangleBudget = 50 + random() % 3000;
    refiner.Refine(view, options, mesh);
    EXPECT_LE(mesh.Triangles, options.TriangleBudget) << "view " << i;
  }
}
