// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Refinement that runs on below the samples of a base, over repeated detail.
#include "HierarchyTestTools.h"

#include "core/strips/DetailHierarchy.h"
#include "core/strips/RefinementDetail.h"

#include <gtest/gtest.h>

using namespace hierarchytest;
using terrain::DetailHierarchy;
using terrain::MemoryHierarchy;
using terrain::RefinementMethod;
using terrain::RefinementOptions;
using terrain::RefinementView;
using terrain::Refiner;
using terrain::StripMesh;

namespace
{
/// A base, one period of detail and their sum as one raster, which only tests make.
struct Sum
{
  Raster Base;
  Raster Detail;
  Raster Whole;
  int Level = 0;
  double Scale = 1.0;
  MemoryHierarchy Hierarchy;
  DetailHierarchy Below;

  Sum(const Raster& base, const Raster& detail, int level, double scale)
    : Base(base)
    , Detail(detail)
    , Level(level)
    , Scale(scale)
    , Hierarchy(Build(base))
  {
    const std::string error = this->Below.Build(detail.Heights.data(),
      { static_cast<int>(detail.Width), static_cast<int>(detail.Height) }, level,
      terrain::SerialFor);
    EXPECT_EQ(error, "");
    this->MakeWhole();
  }

  terrain::GridGeometry Geometry() const
  {
    const double part = std::ldexp(1.0, -this->Level);
    return MakeGeometry(3.0 * part, 4.0 * part);
  }
  RefinementView View(double u, double v, double above) const
  {
    RefinementView view = MakeView(this->Base, u, v, above);
    view.DetailScale = this->Scale;
    return view;
  }
  double DetailAt(std::int64_t x, std::int64_t y) const
  {
    return this->Scale * this->Detail.At(x % this->Detail.Width, y % this->Detail.Height);
  }
  /// Of the scaled detail's range.
  double Middle() const
  {
    return 0.5 * this->Scale * (double(this->Below.Minimum()) + this->Below.Maximum());
  }
  StripMesh Refine(const RefinementView& view, const RefinementOptions& options) const
  {
    Refiner refiner(this->Hierarchy.View(), &this->Below);
    StripMesh mesh;
    refiner.Refine(view, options, mesh);
    return mesh;
  }

private:
  void MakeWhole()
  {
    const std::int64_t cells = std::int64_t(1) << this->Level;
    this->Whole.Width = (this->Base.Width - 1) * cells + 1;
    this->Whole.Height = (this->Base.Height - 1) * cells + 1;
    for (std::int64_t y = 0; y < this->Whole.Height; ++y)
    {
      for (std::int64_t x = 0; x < this->Whole.Width; ++x)
      {
        const double height =
          this->Base.HeightAt(static_cast<double>(x) / cells, static_cast<double>(y) / cells);
        this->Whole.Heights.push_back(static_cast<float>(height + this->DetailAt(x, y)));
      }
    }
  }
};

/// One period: waves that fit it, and noise.
Raster MakeDetail(std::int64_t width, std::int64_t height, unsigned seed = 5)
{
  Raster detail{ width, height, {} };
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> noise(-1.0f, 1.0f);
  for (std::int64_t y = 0; y < height; ++y)
  {
    for (std::int64_t x = 0; x < width; ++x)
    {
      detail.Heights.push_back(0.7f +
        static_cast<float>(std::sin(6.283185307179586 * static_cast<double>(x) / width)) *
          static_cast<float>(std::cos(6.283185307179586 * static_cast<double>(y) / height)) +
        0.2f * noise(random));
    }
  }
  return detail;
}

/// Bases, periods, levels and scales of all kinds: sides of 2^n + 1 and others, holes, periods that
/// fit the base's cells and that do not, flat bases and flat detail.
std::vector<Sum> MakeSums()
{
  Raster flat = MakeHills(9, 9);
  std::fill(flat.Heights.begin(), flat.Heights.end(), 100.0f);
  std::vector<Sum> sums;
  sums.emplace_back(MakeHills(9, 9), MakeDetail(16, 16), 3, 1.0);
  sums.emplace_back(MakeHills(17, 17), MakeDetail(64, 32), 2, 2.5);
  sums.emplace_back(MakeHills(12, 7), MakeDetail(8, 8), 3, 1.0);
  sums.emplace_back(MakeHills(9, 9), MakeDetail(12, 5), 3, 1.0);
  sums.emplace_back(MakeHills(5, 5), MakeDetail(1, 1), 2, 1.0);
  sums.emplace_back(MakeHills(6, 9), MakeDetail(16, 16), 3, 0.0);
  sums.emplace_back(flat, MakeDetail(16, 16), 3, 1.0);
  sums.emplace_back(MakeHills(9, 9), MakeDetail(4, 4), 0, 1.0);
  for (const char* pattern : { "lake", "speckles", "corner", "single", "all" })
  {
    sums.emplace_back(WithHoles(MakeHills(13, 11), pattern), MakeDetail(8, 16), 2, 1.0);
  }
  return sums;
}

/// Largest error of the mesh in pixels: over points finer than the sum's samples, each with its own
/// distance to the eye. Triangles of half a cell cannot be split and are left out.
double LargestError(const Sum& sum, const StripMesh& mesh, const RefinementView& view)
{
  const terrain::GridGeometry geometry = sum.Geometry();
  double largest = 0.0;
  for (const auto& indices : IndexTriangles(mesh))
  {
    Triangle t;
    std::array<double, 3> h{};
    for (int i = 0; i < 3; ++i)
    {
      t[i] = SampleOf(mesh, indices[i]);
      h[i] = static_cast<double>(mesh.Vertices[indices[i]].Height) +
        mesh.Vertices[indices[i]].Displacement;
    }
    const auto area = static_cast<double>(Area2(t));
    const auto [west, east] = std::minmax({ t[0][0], t[1][0], t[2][0] });
    const auto [south, north] = std::minmax({ t[0][1], t[1][1], t[2][1] });
    const std::int64_t points = (2 * (east - west) + 1) * (2 * (north - south) + 1);
    for (std::int64_t k = 0; area > 1.0 && k < points; ++k)
    {
      const double x = west + 0.5 * static_cast<double>(k % (2 * (east - west) + 1));
      const double y = south + 0.5 * static_cast<double>(k / (2 * (east - west) + 1));
      const auto weight = [&](int a, int b)
      { return ((t[a][0] - x) * (t[b][1] - y) - (t[a][1] - y) * (t[b][0] - x)) / area; };
      const std::array<double, 3> w{ { weight(1, 2), weight(2, 0), weight(0, 1) } };
      if (std::min({ w[0], w[1], w[2] }) < 0.0)
      {
        continue;
      }
      const double surface = sum.Whole.HeightAt(x, y);
      const double plane = w[0] * h[0] + w[1] * h[1] + w[2] * h[2];
      const double distance = glm::distance(view.Eye, geometry.ToModel({ x, y }, surface));
      const double error = std::abs(surface - plane) * view.PixelsPerUnit / distance;
      largest = std::isnan(largest) || error <= largest ? largest : error; // a NaN stays
    }
  }
  return largest;
}
}

TEST(RefinementDetail, IsConformingAndOfTheSumsHeights)
{
  for (const Sum& sum : MakeSums())
  {
    for (const double tolerance : { 0.5, 4.0, 40.0 })
    {
      for (const bool morphing : { false, true })
      {
        RefinementOptions options = WithTolerance(tolerance);
        options.Morphing = morphing;
        const StripMesh mesh = sum.Refine(sum.View(0.3, 0.2, 20.0), options);
        EXPECT_EQ(WhyNotConforming(mesh), "")
          << sum.Whole.Width << " x " << sum.Whole.Height << " tolerance " << tolerance;
        EXPECT_FALSE(HasTwins(mesh)) << sum.Whole.Width << " x " << sum.Whole.Height;
        for (const auto& indices : IndexTriangles(mesh))
        {
          for (const std::uint32_t index : indices)
          {
            const Sample sample = SampleOf(mesh, index);
            ASSERT_NEAR(mesh.Vertices[index].Height, sum.Whole.At(sample[0], sample[1]), 1.0e-4);
          }
        }
      }
    }
  }
}

TEST(RefinementDetail, KeepsEveryTriangleWithinTheTolerance)
{
  for (const Sum& sum : MakeSums())
  {
    for (const double tolerance : { 1.0, 4.0, 20.0 })
    {
      for (const bool morphing : { false, true })
      {
        const RefinementView view = sum.View(0.4, -0.5, 30.0);
        RefinementOptions options = WithTolerance(tolerance);
        options.Morphing = morphing;
        EXPECT_LE(LargestError(sum, sum.Refine(view, options), view), tolerance + 0.01)
          << sum.Whole.Width << " x " << sum.Whole.Height << (morphing ? " morphing" : "");
      }
    }
  }
}

TEST(RefinementDetail, ReachesEverySampleOfTheSumAtSmallTolerance)
{
  for (const Sum& sum : MakeSums())
  {
    const bool isFlat = sum.Scale == 0.0 || sum.Detail.Heights.size() == 1;
    const StripMesh mesh = sum.Refine(sum.View(0.3, 0.2, 5.0), WithTolerance(1.0e-6));
    std::int64_t area = 0;
    for (const Triangle& t : Triangles(mesh))
    {
      area += Area2(t);
      EXPECT_TRUE(isFlat || Area2(t) == 1);
    }
    EXPECT_EQ(area, 2 * sum.Whole.ValidCells());
    // Far away it is coarse.
    EXPECT_LE(sum.Refine(sum.View(0.3, 0.2, 1.0e7), WithTolerance(1.0)).Triangles,
      sum.Hierarchy.Summary.HasHoles ? mesh.Triangles : 8);
  }
}

namespace
{
/// Largest distance of the sum over the diamonds of a vertex of the detail and of its descendants
/// from the base's surface over the vertex (x, y), horizontally and in space.
class Reach
{
public:
  Reach(const Sum& sum, std::int64_t x, std::int64_t y)
    : Of(sum)
    , Centre(
        sum.Geometry().ToModel({ x, y }, sum.Whole.At(x, y) - sum.DetailAt(x, y) + sum.Middle()))
  {
  }

  /// Adds the diamond of the vertex of a step at (x, y), and those of its descendants.
  void Add(std::int64_t x, std::int64_t y, std::int64_t step, bool isOdd)
  {
    for (std::int64_t i = -step; i <= step; i += std::max<std::int64_t>(step / 2, 1))
    {
      const std::int64_t left = isOdd ? step - std::abs(i) : step;
      for (const std::int64_t j : { -left, left / 2, left })
      {
        this->AddPoint(x + i, y + j);
      }
    }
    const std::int64_t half = step / 2;
    if (isOdd && half == 0)
    {
      return;
    }
    const std::array<std::int64_t, 4> dx = isOdd
      ? std::array<std::int64_t, 4>{ half, -half, half, -half }
      : std::array<std::int64_t, 4>{ step, -step, 0, 0 };
    const std::array<std::int64_t, 4> dy = isOdd
      ? std::array<std::int64_t, 4>{ half, half, -half, -half }
      : std::array<std::int64_t, 4>{ 0, 0, step, -step };
    for (int child = 0; child < 4; ++child)
    {
      this->Add(x + dx[child], y + dy[child], isOdd ? half : step, !isOdd);
    }
  }

  double Circle = 0.0;
  double Sphere = 0.0;

private:
  void AddPoint(std::int64_t x, std::int64_t y)
  {
    if (x < 0 || y < 0 || x >= this->Of.Whole.Width || y >= this->Of.Whole.Height)
    {
      return;
    }
    const glm::dvec3 offset =
      this->Of.Geometry().ToModel({ x, y }, this->Of.Whole.At(x, y)) - this->Centre;
    this->Circle = std::max(this->Circle, std::hypot(offset.x, offset.y));
    this->Sphere = std::max(this->Sphere, glm::length(offset));
  }

  const Sum& Of;
  glm::dvec3 Centre;
};
}

TEST(RefinementDetail, CirclesAndSpheresHoldTheSum)
{
  std::mt19937 random(11);
  for (int turn = 0; turn < 12; ++turn)
  {
    const int level = 1 + static_cast<int>(random() % 3u);
    const auto side = static_cast<std::int64_t>(8u << (random() % 3u));
    const Sum sum(MakeHills(7, 6, random()), MakeDetail(side, 2 * side, random()), level,
      0.25 * static_cast<double>(random() % 16u));
    terrain::SteepnessTiles steepness;
    steepness.Measure(sum.Hierarchy.View(), terrain::SerialFor);
    const double slant = std::hypot(1.0, steepness.Whole().Slope);
    const double half = 1.0e-4 * (2.0 * level + 1.0) +
      0.5 * sum.Scale * (double(sum.Below.Maximum()) - sum.Below.Minimum());
    double tightest = 0.0;
    for (int depth = 0; depth < 2 * level; ++depth)
    {
      const std::int64_t step = std::int64_t(1) << (level - 1 - depth / 2);
      const bool isOdd = (depth & 1) != 0;
      // The larger spacing, and the diagonal way of odd depths.
      const double length =
        4.0 * std::ldexp(1.0, -level) * static_cast<double>(step) * (isOdd ? std::sqrt(0.5) : 1.0);
      const double circle = terrain::DetailCircle(length, 2 * level - depth);
      for (std::int64_t y = isOdd ? 0 : step; y < sum.Whole.Height; y += 2 * step)
      {
        for (std::int64_t x = step; x < sum.Whole.Width; x += 6 * step)
        {
          Reach reach(sum, x, y);
          reach.Add(x, y, step, isOdd);
          ASSERT_LE(reach.Circle, circle);
          ASSERT_LE(reach.Sphere, slant * circle + half);
          tightest = std::max(tightest, reach.Circle / circle);
        }
      }
    }
    EXPECT_GT(tightest, 0.5);
  }
}

TEST(RefinementDetail, ErrorsOfThePeriodAreThoseOfItsRepetition)
{
  // The same as of a hierarchy over the detail repeated, and nested across the period's border.
  const Raster detail = MakeDetail(16, 32);
  Raster flat = MakeHills(9, 9);
  std::fill(flat.Heights.begin(), flat.Heights.end(), 0.0f);
  const Sum sum(flat, detail, 3, 1.0);
  const MemoryHierarchy whole = Build(sum.Whole, sum.Geometry());
  const terrain::HierarchyView view = whole.View();
  for (int pair = 0; pair < 3; ++pair)
  {
    const DetailHierarchy::Pair& records = sum.Below.PairAt(pair);
    const std::int64_t step = std::int64_t(1) << (2 - pair);
    for (std::int64_t y = 16; y <= 48; y += step)
    {
      for (std::int64_t x = 16; x <= 48; x += step)
      {
        if ((((x | y) / step) & 1) != 0)
        {
          const terrain::HierarchyRecord& record =
            records.Records[(x >> records.Shift) % records.Count.x +
              records.Count.x * ((y >> records.Shift) % records.Count.y)];
          const terrain::HierarchyRecord& expected = view.Records[view.RecordOf(x, y)];
          EXPECT_EQ(record.Error(), expected.Error());
          EXPECT_EQ(record.Height, expected.Height);
        }
      }
    }
  }
}

TEST(RefinementDetail, PlainAndImprovedMakeTheSameTriangles)
{
  for (const Sum& sum : MakeSums())
  {
    RefinementOptions options = WithTolerance(3.0);
    const RefinementView view = sum.View(0.7, 0.6, 10.0);
    const StripMesh improved = sum.Refine(view, options);
    options.Method = RefinementMethod::Plain;
    const StripMesh plain = sum.Refine(view, options);
    EXPECT_EQ(WhyNotConforming(plain), "");
    EXPECT_EQ(TriangleSet(plain), TriangleSet(improved));
  }
}

namespace
{
/// Plain ground with towers of one sample.
Raster MakeTowers(const std::vector<Sample>& towers)
{
  Raster raster = MakeHills(80, 70);
  std::fill(raster.Heights.begin(), raster.Heights.end(), 5.0f);
  for (const Sample& tower : towers)
  {
    raster.Heights[tower[0] + raster.Width * tower[1]] = 300.0f;
  }
  return raster;
}
}

TEST(RefinementDetail, FlatGroundOfAnySizeIsRefinedByBothProcedures)
{
  // Nothing above the samples has an error, inside the raster or beyond.
  for (const std::int64_t width : { 3, 5, 6, 7, 10, 17, 26 })
  {
    Raster raster{ width, 9, std::vector<float>(static_cast<std::size_t>(9 * width), 5.0f) };
    const Sum sum(raster, MakeDetail(16, 16), 2, 1.0);
    RefinementOptions options = WithTolerance(4.0);
    const RefinementView view = sum.View(0.2, 0.12, 10.0);
    const StripMesh improved = sum.Refine(view, options);
    EXPECT_EQ(WhyNotConforming(improved), "");
    EXPECT_FALSE(HasTwins(improved));
    options.Method = RefinementMethod::Plain;
    EXPECT_EQ(TriangleSet(sum.Refine(view, options)), TriangleSet(improved)) << width;
  }
}

TEST(RefinementDetail, IsConformingWhereSteepnessChangesFromPlaceToPlace)
{
  const Sum sum(
    MakeTowers({ { { 3, 3 } }, { { 15, 16 } }, { { 16, 40 } }, { { 47, 31 } }, { { 79, 69 } } }),
    MakeDetail(16, 16), 2, 1.0);
  for (const double u : { 0.05, 0.5 })
  {
    const RefinementView view = sum.View(u, 0.6 * u, 10.0);
    const StripMesh mesh = sum.Refine(view, WithTolerance(10.0));
    EXPECT_EQ(WhyNotConforming(mesh), "") << u;
    EXPECT_FALSE(HasTwins(mesh));
    EXPECT_LE(LargestError(sum, mesh, view), 10.0 + 0.01);
  }
}

TEST(RefinementDetail, ACliffRefinesNothingFarFromIt)
{
  const auto nearTriangles = [](const std::vector<Sample>& towers)
  {
    const Sum sum(MakeTowers(towers), MakeDetail(16, 16), 3, 1.0);
    std::set<Triangle> near = TriangleSet(sum.Refine(sum.View(0.1, 0.1, 20.0), WithTolerance(8.0)));
    for (auto t = near.begin(); t != near.end();)
    {
      const bool isNear =
        std::all_of(t->begin(), t->end(), [](const Sample& s) { return s[0] <= 64 && s[1] <= 64; });
      t = isNear ? std::next(t) : near.erase(t);
    }
    return near;
  };
  const std::set<Triangle> plain = nearTriangles({});
  EXPECT_GT(plain.size(), 100u);
  EXPECT_LT(plain.size(), 2u * 64u * 64u);
  EXPECT_EQ(nearTriangles({ { { 75, 65 } } }), plain);
}

TEST(RefinementDetail, CullingLosesNothingThatIsSeen)
{
  const Sum sum(MakeHills(17, 14), MakeDetail(16, 16), 3, 1.0);
  const auto refine = [&sum](const RefinementView& view, const RefinementOptions& options)
  { return sum.Refine(view, options); };
  EXPECT_EQ(WhyCullingLoses(sum.Whole, sum.Geometry(), sum.View(0.5, 0.4, 15.0), refine), "");
}

TEST(RefinementDetail, KeepsTheTriangleBudgetAndParallelProjection)
{
  const Sum sum(MakeHills(17, 14), MakeDetail(16, 16), 3, 1.0);
  for (const bool parallel : { false, true })
  {
    RefinementView view = sum.View(0.3, 0.2, 20.0);
    view.Parallel = parallel;
    view.PixelsPerUnit = parallel ? 10.0 : view.PixelsPerUnit;
    RefinementOptions options = WithTolerance(0.5);
    const std::int64_t free = sum.Refine(view, options).Triangles;
    EXPECT_GT(free, 2000);
    for (const std::int64_t budget : { 4, 100, 1000 })
    {
      options.TriangleBudget = budget;
      const StripMesh mesh = sum.Refine(view, options);
      EXPECT_LE(mesh.Triangles, budget);
      EXPECT_GE(mesh.Triangles, budget / 2);
      EXPECT_GT(mesh.Tolerance, 0.5);
      EXPECT_EQ(WhyNotConforming(mesh), "");
    }
  }
}
