// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HierarchyTestTools.h"

#include <gtest/gtest.h>

#include <map>

using namespace hierarchytest;
using terrain::MemoryHierarchy;
using terrain::RefinementMethod;
using terrain::RefinementOptions;
using terrain::RefinementView;
using terrain::Refiner;
using terrain::StripMesh;

namespace
{
const std::vector<std::array<std::int64_t, 2>> Sizes{ { { 1, 1 } }, { { 1, 9 } }, { { 2, 2 } },
  { { 3, 3 } }, { { 2, 7 } }, { { 6, 5 } }, { { 17, 17 } }, { { 33, 20 } }, { { 65, 65 } },
  { { 66, 64 } }, { { 70, 130 } }, { { 100, 3 } } };
const std::vector<std::string> Patterns{ "none", "all", "speckles", "corner", "lake", "single" };

StripMesh Refine(
  const MemoryHierarchy& hierarchy, const RefinementView& view, const RefinementOptions& options)
{
  Refiner refiner(hierarchy.View());
  StripMesh mesh;
  refiner.Refine(view, options, mesh);
  return mesh;
}

/// Largest screen-space error of a triangle, in pixels.
double ScreenError(const Raster& raster, const RefinementView& view, const Drawn& drawn)
{
  const ErrorOfTriangle error = FindError(raster, view.Eye, drawn);
  return error.Height * view.PixelsPerUnit / error.Nearest;
}
}

TEST(Refinement, IsConformingForAnySizeAndHoles)
{
  for (const auto& size : Sizes)
  {
    for (const std::string& pattern : Patterns)
    {
      const Raster raster = WithHoles(MakeHills(size[0], size[1]), pattern);
      const MemoryHierarchy hierarchy = Build(raster);
      for (const double tolerance : { 0.3, 3.0, 30.0 })
      {
        for (const bool morphing : { false, true })
        {
          RefinementOptions options = WithTolerance(tolerance);
          options.Morphing = morphing;
          const StripMesh mesh = Refine(hierarchy, MakeView(raster, 0.3, 0.2, 20.0), options);
          EXPECT_EQ(WhyNotConforming(mesh), "")
            << size[0] << " x " << size[1] << " " << pattern << " tolerance " << tolerance;
          EXPECT_FALSE(HasTwins(mesh)) << size[0] << " x " << size[1] << " " << pattern;
        }
      }
    }
  }
}

TEST(Refinement, CoversTheRasterWithoutHolesAtAnyTolerance)
{
  for (const auto& size : Sizes)
  {
    const Raster raster = MakeHills(size[0], size[1]);
    const MemoryHierarchy hierarchy = Build(raster);
    for (const double tolerance : { 0.01, 1.0, 10.0, 1000.0 })
    {
      const StripMesh mesh =
        Refine(hierarchy, MakeView(raster, 0.3, 0.2, 20.0), WithTolerance(tolerance));
      std::int64_t area = 0;
      for (const Triangle& t : Triangles(mesh))
      {
        area += Area2(t);
      }
      EXPECT_EQ(area, 2 * (size[0] - 1) * (size[1] - 1)) << size[0] << " x " << size[1];
    }
  }
}

TEST(Refinement, DrawsEverySampleOfABorderThatIsKept)
{
  for (const auto& size : Sizes)
  {
    if (size[0] < 2)
    {
      continue; // no surface
    }
    const Raster raster = MakeHills(size[0], size[1]);
    const MemoryHierarchy hierarchy = Build(raster, MakeGeometry(), true);
    RefinementOptions options = WithTolerance(1000.0);
    options.Morphing = true;
    const StripMesh mesh = Refine(hierarchy, MakeView(raster, 0.3, 0.2, 20.0), options);
    EXPECT_EQ(WhyNotConforming(mesh), "") << size[0] << " x " << size[1];
    std::set<Sample> drawn;
    for (std::uint32_t i = 0; i < mesh.Vertices.size(); ++i)
    {
      const Sample at = SampleOf(mesh, i);
      drawn.insert(at);
      if (at[0] % (size[0] - 1) == 0 || at[1] % (size[1] - 1) == 0)
      {
        EXPECT_EQ(mesh.Vertices[i].Height, raster.At(at[0], at[1]));
      }
    }
    for (std::int64_t x = 0; x < size[0]; ++x)
    {
      EXPECT_TRUE(drawn.count({ { x, 0 } }) == 1 && drawn.count({ { x, size[1] - 1 } }) == 1)
        << x << " of " << size[0] << " x " << size[1];
    }
    for (std::int64_t y = 0; y < size[1]; ++y)
    {
      EXPECT_TRUE(drawn.count({ { 0, y } }) == 1 && drawn.count({ { size[0] - 1, y } }) == 1)
        << y << " of " << size[0] << " x " << size[1];
    }
    EXPECT_LT(drawn.size(), 12 * (size[0] + size[1])); // and few others
  }
}

TEST(Refinement, DrawsNoHoleAndAtSmallToleranceEverythingElse)
{
  for (const auto& size : Sizes)
  {
    for (const std::string& pattern : Patterns)
    {
      const Raster raster = WithHoles(MakeHills(size[0], size[1]), pattern);
      const MemoryHierarchy hierarchy = Build(raster);
      for (const double tolerance : { 1.0e-5, 2.0, 50.0 })
      {
        const StripMesh mesh =
          Refine(hierarchy, MakeView(raster, 0.3, 0.2, 20.0), WithTolerance(tolerance));
        std::int64_t area = 0;
        for (const Triangle& t : Triangles(mesh))
        {
          area += Area2(t);
          const std::array<double, 3> heights{ { raster.At(t[0][0], t[0][1]),
            raster.At(t[1][0], t[1][1]), raster.At(t[2][0], t[2][1]) } };
          EXPECT_TRUE(
            std::isfinite(ScreenError(raster, MakeView(raster, 0.3, 0.2, 20.0), { t, heights })));
        }
        EXPECT_LE(area, 2 * raster.ValidCells());
        if (tolerance < 1.0e-3)
        {
          EXPECT_EQ(area, 2 * raster.ValidCells()) << size[0] << " x " << size[1] << pattern;
        }
      }
    }
  }
}

TEST(Refinement, KeepsEveryTriangleWithinTheTolerance)
{
  for (const auto& size : Sizes)
  {
    for (const std::string& pattern : Patterns)
    {
      const Raster raster = WithHoles(MakeHills(size[0], size[1]), pattern);
      const MemoryHierarchy hierarchy = Build(raster);
      for (const double tolerance : { 1.0, 4.0, 20.0 })
      {
        for (const bool morphing : { false, true })
        {
          const RefinementView view = MakeView(raster, 0.4, -0.5, 30.0);
          RefinementOptions options = WithTolerance(tolerance);
          options.Morphing = morphing;
          const StripMesh mesh = Refine(hierarchy, view, options);
          for (const auto& indices : IndexTriangles(mesh))
          {
            const Drawn drawn = DrawnOf(mesh, indices);
            if (Area2(drawn.Corners) > 1)
            {
              EXPECT_LE(ScreenError(raster, view, drawn), tolerance * (1.0 + 1.0e-5) + 1.0e-4)
                << size[0] << " x " << size[1] << " " << pattern << (morphing ? " morphing" : "");
            }
          }
        }
      }
    }
  }
}

TEST(Refinement, PlainAndImprovedMakeTheSameTriangles)
{
  for (const auto& size : Sizes)
  {
    for (const std::string& pattern : Patterns)
    {
      const Raster raster = WithHoles(MakeHills(size[0], size[1]), pattern);
      const MemoryHierarchy hierarchy = Build(raster);
      for (const double tolerance : { 0.3, 3.0, 30.0 })
      {
        RefinementOptions options = WithTolerance(tolerance);
        const RefinementView view = MakeView(raster, 0.7, 0.6, 10.0);
        const StripMesh improved = Refine(hierarchy, view, options);
        options.Method = RefinementMethod::Plain;
        const StripMesh plain = Refine(hierarchy, view, options);
        EXPECT_EQ(WhyNotConforming(plain), "");
        EXPECT_EQ(TriangleSet(plain), TriangleSet(improved));
        EXPECT_LE(improved.Strip.size(), plain.Strip.size() + 4);
      }
    }
  }
}

namespace
{
/// Heights and displacements of the vertices that triangles use, by sample.
std::map<Sample, std::array<float, 2>> Morphs(const StripMesh& mesh)
{
  std::map<Sample, std::array<float, 2>> morphs;
  for (const auto& indices : IndexTriangles(mesh))
  {
    for (const std::uint32_t index : indices)
    {
      const terrain::StripVertex& vertex = mesh.Vertices[index];
      morphs[SampleOf(mesh, index)] = { { vertex.Height, vertex.Displacement } };
    }
  }
  return morphs;
}
}

TEST(Refinement, PlainAndImprovedCullAndMorphAlike)
{
  for (const auto& size : Sizes)
  {
    for (const std::string& pattern : { std::string("none"), std::string("lake") })
    {
      const Raster raster = WithHoles(MakeHills(size[0], size[1]), pattern);
      const MemoryHierarchy hierarchy = Build(raster);
      RefinementView view = MakeView(raster, 0.4, 0.3, 10.0);
      const glm::dvec3 normal(0.8, 0.6, 0.0);
      view.Planes = { glm::dvec4(normal, -glm::dot(normal, view.Eye)) };
      RefinementOptions options = WithTolerance(3.0);
      options.Morphing = true;
      const StripMesh improved = Refine(hierarchy, view, options);
      options.Method = RefinementMethod::Plain;
      const StripMesh plain = Refine(hierarchy, view, options);
      EXPECT_EQ(TriangleSet(plain), TriangleSet(improved)) << size[0] << " x " << size[1];
      EXPECT_EQ(Morphs(plain), Morphs(improved)) << size[0] << " x " << size[1] << pattern;
    }
  }
}

namespace
{
/// Index of the edge (from, to) of a triangle, -1 if it has none.
int EdgeOf(const Triangle& triangle, const Sample& from, const Sample& to)
{
  for (int i = 0; i < 3; ++i)
  {
    if (triangle[i] == from && triangle[(i + 1) % 3] == to)
    {
      return i;
    }
  }
  return -1;
}

/// The edge by which a triangle, counter-clockwise, touches another one, -1 if it does not.
int SharedEdge(const Triangle& triangle, const Triangle& other)
{
  for (int i = 0; i < 3; ++i)
  {
    if (EdgeOf(other, triangle[(i + 1) % 3], triangle[i]) >= 0)
    {
      return i;
    }
  }
  return -1;
}
}

TEST(Refinement, TheStripIsAsShortAsItsPathAllows)
{
  // A strip goes from each triangle to a neighbour, turning left or right. Each triangle costs an
  // index, and one more when the strip turns to the same side as before.
  const Raster raster = MakeHills(129, 129);
  const MemoryHierarchy hierarchy = Build(raster);
  for (const double tolerance : { 0.01, 1.0, 5.0, 30.0 })
  {
    const StripMesh mesh =
      Refine(hierarchy, MakeView(raster, 0.3, 0.2, 20.0), WithTolerance(tolerance));
    const std::vector<Triangle> path = Triangles(mesh);
    std::size_t least = path.size() + 2;
    int before = 0;
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
    {
      const int in = SharedEdge(path[i], path[i - 1]);
      const int out = SharedEdge(path[i], path[i + 1]);
      ASSERT_TRUE(in >= 0 && out >= 0 && in != out);
      const int turn = (out - in + 3) % 3;
      least += turn == before ? 1 : 0;
      before = turn;
    }
    // Begin and end of the strip turn like its middle, as if it were closed.
    EXPECT_LE(mesh.Strip.size(), least + 3);
    if (tolerance == 0.01)
    {
      // Triangles of one size: two turns in three repeat the one before.
      EXPECT_NEAR(static_cast<double>(least) / static_cast<double>(path.size()), 5.0 / 3.0, 0.01);
    }
  }
}

TEST(Refinement, FlatGroundTakesFourTriangles)
{
  Raster raster = MakeHills(129, 129);
  std::fill(raster.Heights.begin(), raster.Heights.end(), 5.0f);
  const StripMesh mesh = Refine(Build(raster), MakeView(raster, 0.5, 0.5, 1.0), WithTolerance(0.1));
  EXPECT_EQ(mesh.Triangles, 4);
  EXPECT_EQ(mesh.Vertices.size(), 5u);
}

TEST(Refinement, KeepsTheTriangleBudget)
{
  const Raster raster = MakeHills(257, 200);
  const MemoryHierarchy hierarchy = Build(raster);
  const RefinementView view = MakeView(raster, 0.3, 0.2, 20.0);
  const std::int64_t free = Refine(hierarchy, view, WithTolerance(0.1)).Triangles;
  for (const std::int64_t budget : { 4, 10, 100, 1000, 5000 })
  {
    for (const bool morphing : { false, true })
    {
      RefinementOptions options = WithTolerance(0.1);
      options.TriangleBudget = budget;
      options.Morphing = morphing;
      const StripMesh mesh = Refine(hierarchy, view, options);
      EXPECT_LE(mesh.Triangles, budget);
      EXPECT_GT(mesh.Tolerance, 0.1);
      if (budget >= 1000)
      {
        EXPECT_GE(mesh.Triangles, budget * 8 / 10);
      }
      EXPECT_EQ(WhyNotConforming(mesh), "");
    }
  }
  RefinementOptions options = WithTolerance(0.1);
  options.TriangleBudget = 2 * free;
  EXPECT_EQ(Refine(hierarchy, view, options).Tolerance, 0.1);
}

TEST(Refinement, CullingLosesNothingThatIsSeen)
{
  for (const std::string& pattern : { std::string("none"), std::string("lake") })
  {
    const Raster raster = WithHoles(MakeHills(65, 80), pattern);
    const MemoryHierarchy hierarchy = Build(raster);
    const auto refine = [&](const RefinementView& view, const RefinementOptions& options)
    { return Refine(hierarchy, view, options); };
    EXPECT_EQ(
      WhyCullingLoses(raster, MakeGeometry(), MakeView(raster, 0.5, 0.4, 15.0), refine), "");
  }
}

TEST(Refinement, ParallelProjectionHasOneErrorEverywhere)
{
  const Raster raster = MakeHills(129, 129);
  RefinementView view = MakeView(raster, 0.5, 0.5, 1.0e7);
  view.Parallel = true;
  view.PixelsPerUnit = 1.0;
  const MemoryHierarchy hierarchy = Build(raster);
  const StripMesh far = Refine(hierarchy, view, WithTolerance(2.0));
  view.Eye.z = 0.0;
  EXPECT_EQ(TriangleSet(far), TriangleSet(Refine(hierarchy, view, WithTolerance(2.0))));
  EXPECT_GT(far.Triangles, 100);
  EXPECT_LT(far.Triangles, 20000);
}

namespace
{
/// Heights of the drawn surface at all samples.
std::vector<double> DrawnSurface(const Raster& raster, const StripMesh& mesh)
{
  std::vector<double> surface(raster.Heights.size(), 0.0);
  for (const auto& indices : IndexTriangles(mesh))
  {
    const auto [triangle, heights] = DrawnOf(mesh, indices);
    const auto [west, east] = std::minmax({ triangle[0][0], triangle[1][0], triangle[2][0] });
    const auto [south, north] = std::minmax({ triangle[0][1], triangle[1][1], triangle[2][1] });
    for (std::int64_t y = south; y <= north; ++y)
    {
      for (std::int64_t x = west; x <= east; ++x)
      {
        const auto px = static_cast<double>(x);
        const auto py = static_cast<double>(y);
        if (PlaneAt(triangle, { { 1, 0, 0 } }, px, py) >= 0.0 &&
          PlaneAt(triangle, { { 0, 1, 0 } }, px, py) >= 0.0 &&
          PlaneAt(triangle, { { 0, 0, 1 } }, px, py) >= 0.0)
        {
          surface[x + raster.Width * y] = PlaneAt(triangle, heights, px, py);
        }
      }
    }
  }
  return surface;
}

/// Number of depths that have a vertex out of its place.
int MorphingDepths(const MemoryHierarchy& hierarchy, const StripMesh& mesh)
{
  std::set<int> depths;
  for (const terrain::StripVertex& vertex : mesh.Vertices)
  {
    if (vertex.Displacement != 0.0f)
    {
      depths.insert(hierarchy.Layout.DepthOf(vertex.Record));
    }
  }
  return static_cast<int>(depths.size());
}

/// Most change of the surface in 300 steps of the eye. Of a point at distance d it is in pixels,
/// dz lambda / d, over the step in the same distances, |step| / d, in units of the tolerance.
struct Movement
{
  double Change = 0.0;
  /// Most depths that morphed in one mesh.
  int Depths = 0;
};

Movement LargestChange(bool morphing)
{
  const Raster raster = MakeHills(129, 129);
  const MemoryHierarchy hierarchy = Build(raster);
  RefinementOptions options = WithTolerance(6.0);
  options.Morphing = morphing;
  Refiner refiner(hierarchy.View());
  StripMesh mesh;
  std::vector<double> before;
  glm::dvec3 eye(0.0);
  Movement largest;
  for (int step = 0; step < 300; ++step)
  {
    const RefinementView view = MakeView(raster, 0.1 + 0.4 * step / 300.0, -0.6, 60.0);
    refiner.Refine(view, options, mesh);
    std::vector<double> surface = DrawnSurface(raster, mesh);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      largest.Change = std::max(largest.Change,
        std::abs(surface[i] - before[i]) * view.PixelsPerUnit /
          (options.Tolerance * glm::distance(eye, view.Eye)));
    }
    before.swap(surface);
    eye = view.Eye;
    largest.Depths = std::max(largest.Depths, MorphingDepths(hierarchy, mesh));
  }
  return largest;
}

}

TEST(Refinement, MorphedSurfaceMovesWithTheEyeAndDoesNotJump)
{
  const Movement morphed = LargestChange(true);
  const double bound = terrain::kMorphRate * morphed.Depths;
  RecordProperty("change", std::to_string(morphed.Change));
  RecordProperty("bound", std::to_string(bound));
  EXPECT_LE(morphed.Change, bound);
  EXPECT_GT(LargestChange(false).Change, 2.0 * bound);
}

TEST(Refinement, RefusesBadViewsAndOptions)
{
  const Raster raster = MakeHills(9, 9);
  const RefinementView good = MakeView(raster, 0.5, 0.5, 10.0);
  EXPECT_EQ(Refiner::WhyNotRefine(good, RefinementOptions()), "");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double tolerance : { 0.0, -1.0, std::nan(""), infinity })
  {
    EXPECT_NE(Refiner::WhyNotRefine(good, WithTolerance(tolerance)), "");
  }
  for (const double bad : { 0.0, -1.0, std::nan(""), infinity })
  {
    RefinementView view = good;
    view.PixelsPerUnit = bad;
    EXPECT_NE(Refiner::WhyNotRefine(view, RefinementOptions()), "");
    view = good;
    view.Exaggeration = bad;
    EXPECT_NE(Refiner::WhyNotRefine(view, RefinementOptions()), "");
  }
  RefinementView view = good;
  view.Eye.x = infinity;
  EXPECT_NE(Refiner::WhyNotRefine(view, RefinementOptions()), "");
  view = good;
  view.Planes.emplace_back(std::nan(""), 0.0, 0.0, 1.0);
  EXPECT_NE(Refiner::WhyNotRefine(view, RefinementOptions()), "");
  RefinementOptions options;
  options.TriangleBudget = -1;
  EXPECT_NE(Refiner::WhyNotRefine(good, options), "");
}
