// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Heights as large as their type holds: what is derived from them is finite.
#include "HierarchyTestTools.h"
#include "UnitTestFields.h"

#include "core/mesh/CoarseMesh.h"

#include <gtest/gtest.h>

using namespace hierarchytest;

namespace
{
/// Hills with single samples of the given values, and their negatives, among them.
template <typename T>
std::vector<T> HillsWith(const std::vector<double>& values)
{
  const Raster hills = MakeHills(37, 29);
  std::vector<T> samples(hills.Heights.begin(), hills.Heights.end());
  std::size_t at = 50;
  for (const double value : values)
  {
    samples[at] = static_cast<T>(value);
    samples[at + 300] = static_cast<T>(-value);
    samples[at + 301] = static_cast<T>(value);
    at += 97;
  }
  return samples;
}

template <typename T>
terrain::HeightfieldView<T> ViewOf(const std::vector<T>& samples)
{
  terrain::HeightfieldView<T> view;
  view.Samples = samples.data();
  view.Width = 37;
  view.Height = 29;
  return view;
}

template <typename T>
void ExpectFiniteMesh(const std::vector<double>& values)
{
  const std::vector<T> samples = HillsWith<T>(values);
  for (const std::int64_t cells : { 1, 2, 5 })
  {
    terrain::CoarseMeshOptions options;
    options.CellsPerQuad = cells;
    const auto mesh = terrain::BuildCoarseMesh(ViewOf(samples), options, terrain::SerialFor);
    for (std::int64_t quad = 0; quad < mesh.QuadsX * mesh.QuadsY; ++quad)
    {
      const std::int64_t vx = quad % mesh.QuadsX;
      const std::int64_t vy = quad / mesh.QuadsX;
      for (int corner = 0; corner < 4 && mesh.QuadKept[quad] != 0; ++corner)
      {
        EXPECT_TRUE(std::isfinite(mesh.VertexHeight(vx + (corner & 1), vy + (corner >> 1))))
          << "quad " << quad << " of " << cells << " cells";
      }
    }
  }
  const auto range = terrain::FindHeightRange(ViewOf(samples), terrain::SerialFor);
  EXPECT_TRUE(std::isfinite(range.Maximum - range.Minimum));
}

const std::vector<double> kDoubles{ 1e300, 1.7e308, 9e29, 1e30, 1e35 };
const std::vector<double> kFloats{ 3e38, 3.4028235e38, 9e29, 1e30, 1e35 };
}

TEST(HeightLimits, AreThoseOfFill)
{
  EXPECT_TRUE(terrain::IsHeight(9.99e29));
  EXPECT_FALSE(terrain::IsHeight(1e30));
  EXPECT_FALSE(terrain::IsHeight(-1e30f));
  EXPECT_FALSE(terrain::IsHeight(std::nan("")));
  EXPECT_FALSE(terrain::IsHeight(std::numeric_limits<float>::infinity()));
  EXPECT_TRUE(terrain::IsHeight(std::numeric_limits<int>::max()));
}

TEST(HeightLimits, CoarseMeshesAreFinite)
{
  ExpectFiniteMesh<double>(kDoubles);
  ExpectFiniteMesh<float>(kFloats);
}

TEST(HeightLimits, RefinedMeshesAreFinite)
{
  const Raster hills = MakeHills(37, 29);
  // Up to 1.3 times the hills' 100.
  for (const float factor : { 7e27f, 2e36f })
  {
    Raster raster = hills;
    for (float& height : raster.Heights)
    {
      height *= factor;
    }
    const terrain::MemoryHierarchy hierarchy = Build(raster);
    for (const auto method :
      { terrain::RefinementMethod::Improved, terrain::RefinementMethod::Plain })
    {
      terrain::RefinementOptions options = WithTolerance(1.0);
      options.Method = method;
      options.Morphing = true;
      terrain::StripMesh mesh;
      terrain::Refiner(hierarchy.View()).Refine(MakeView(hills, 0.4, 0.3, 30.0), options, mesh);
      const bool areHeights = terrain::IsHeight(130.0f * factor);
      EXPECT_EQ(mesh.Triangles > 100, areHeights);
      for (const terrain::StripVertex& vertex : mesh.Vertices)
      {
        EXPECT_TRUE(std::isfinite(vertex.Height + vertex.Displacement));
      }
    }
  }
}
