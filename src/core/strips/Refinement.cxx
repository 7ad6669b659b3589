// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/Refinement.h"

#include "core/strips/RefinementCounts.h"
#include "core/strips/RefinementDetail.h"
#include "core/strips/RefinementPlain.h"
#include "core/strips/RefinementSelection.h"
#include "core/strips/RefinementStrip.h"
#include "core/strips/RefinementTriangles.h"
#include "core/strips/RefinementVertex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terrain
{
namespace
{
/// Counting stops at this many times the budget, and starts again with a larger tolerance.
constexpr std::int64_t kCountLimit = 8;
/// By this factor.
constexpr double kToleranceStep = 4.0;
/// The least factor by which it is raised where counting does not know how far.
constexpr double kLeastStep = 1.125;
/// Beyond this tolerance only spheres around the eye are refined.
constexpr double kLargestTolerance = 1.0e30;
/// Rounding of the base's heights between samples, which are float, in units of the largest one.
constexpr double kHeightRounding = 1.0e-6;
/// Relative slack of slants, which are float.
constexpr double kSlantSlack = 1.0e-6;
}

struct Refiner::Work
{
  Work(
    const HierarchyView& hierarchy, const DetailHierarchy* detail, const ParallelFor& parallelFor)
    : Hierarchy(hierarchy)
    , Detail(detail)
  {
    this->Tabulate();
    if (detail)
    {
      this->Steepness.Measure(hierarchy, parallelFor);
      this->TabulateRelief();
      this->TabulateDetail();
    }
  }

  HierarchyView Hierarchy;
  const DetailHierarchy* Detail;
  SteepnessTiles Steepness;
  /// What the tiles of each level are in scaled space, and slopes' factor there.
  std::vector<std::vector<BaseRelief>> Relief;
  double SlopeScale = -1.0;
  RefinementFrame Frame;
  std::array<std::vector<AxisEntry>, 2> Axes;
  std::array<std::vector<DistanceEntry>, 2> Distances;
  /// First and last column, first and last row of the square.
  std::array<std::array<AxisEntry, 2>, 2> Ends{};
  /// Scaled space is model space relative to the grid's origin, times this.
  double Scale = 1.0;
  int DepthCount = 0;
  RefinementSelection Selection;
  PlainRefinement Plain;

  void Tabulate();
  void TabulateDetail();
  void TabulateRelief();
  void SetRelief(double slopeScale);
  void SetDetailView(const RefinementView& view);
  void SetDetailTolerance(const RefinementView& view);
  void SetDistances();
  void SetDepths(int count);
  void SetView(const RefinementView& view);
  void SetTolerance(const RefinementView& view, double tolerance);
  void SetPlanes(const RefinementView& view, CullingMethod culling);

  int Level() const
  {
    return this->Detail ? this->Detail->Level() : 0;
  }
  int Depths() const
  {
    return this->Hierarchy.Layout->Depths() + 2 * this->Level();
  }
  double DetailRange() const
  {
    return static_cast<double>(this->Detail->Maximum()) - this->Detail->Minimum();
  }
  std::uint64_t Centre() const
  {
    const auto half = static_cast<std::uint64_t>(this->Hierarchy.Layout->Cells() / 2)
      << this->Level();
    return half | (half << 32);
  }
  VertexSite CentreSite() const;

  SquareSites MakeSquare() const;
  void MakeImproved(bool morphing, StripMesh& mesh);
  template <bool HasHoles>
  std::int64_t MakeStrip(std::vector<std::uint32_t>& strip) const;
  std::int64_t MakeImprovedByDistance(std::vector<std::uint32_t>& strip) const;
  double ToleranceFor(const RefinementView& view, const RefinementOptions& options);
  bool Coarsen(std::int64_t budget, StripMesh& mesh);
};

/// Terms and samples of all columns and rows of the square. Those beyond what refinement can reach
/// have no records; only damaged ones lead there, and on to the last records of the same parity.
void Refiner::Work::Tabulate()
{
  const HierarchyLayout& layout = *this->Hierarchy.Layout;
  const std::array<std::int64_t, 2> last{ { layout.Width() - 1, layout.Height() - 1 } };
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto entry = [&](std::int64_t cell, std::uint32_t term) {
      return AxisEntry{ term, static_cast<std::uint32_t>(std::min(cell, last[axis])) };
    };
    for (int pair = 0; pair < layout.Pairs(); ++pair)
    {
      const std::int64_t count = layout.Count(pair, axis);
      for (std::int64_t step = 0; step <= layout.Cells() >> layout.Shift(pair); ++step)
      {
        const std::int64_t known = step < count ? step : count - 1 - ((count - 1 - step) & 1);
        this->Axes[axis].push_back(
          entry(step << layout.Shift(pair), layout.Term(pair, axis, known)));
      }
    }
    this->Ends[axis] = { { entry(0, 0), entry(layout.Cells(), 0) } };
  }
  std::size_t begin = 0;
  for (int depth = 0; depth < layout.Depths(); ++depth)
  {
    const int pair = depth / 2;
    DepthTable& table = this->Frame.Depths[depth];
    table.Shift = layout.Shift(pair) + this->Level();
    table.Columns = &this->Axes[0][begin];
    table.Rows = &this->Axes[1][begin];
    table.IsOdd = (depth & 1) != 0;
    if (table.IsOdd)
    {
      begin += static_cast<std::size_t>(layout.Cells() >> layout.Shift(pair)) + 1;
    }
  }
  this->Frame.Records = this->Hierarchy.Records;
  this->Frame.LastColumn = static_cast<std::uint32_t>(last[0]);
  this->Frame.LastRow = static_cast<std::uint32_t>(last[1]);
  this->Frame.HasHoles = this->Hierarchy.Summary.HasHoles;
  this->Frame.SharesSamples = last[0] != layout.Cells() || last[1] != layout.Cells();
}

/// Tables of the depths below the base's samples.
void Refiner::Work::TabulateDetail()
{
  const auto maskOf = [](glm::uvec2 size)
  {
    return glm::uvec2(
      (size.x & (size.x - 1)) == 0 ? size.x - 1 : 0, (size.y & (size.y - 1)) == 0 ? size.y - 1 : 0);
  };
  const int level = this->Level();
  const int first = this->Hierarchy.Layout->Depths();
  for (int depth = 0; depth < 2 * level; ++depth)
  {
    DepthTable& table = this->Frame.Depths[first + depth];
    const int pair = depth / 2;
    table.Shift = level - 1 - pair;
    table.IsOdd = (depth & 1) != 0;
    const DetailHierarchy::Pair& records = this->Detail->PairAt(pair);
    table.Detail.Records = records.Records;
    table.Detail.Shift = records.Shift;
    table.Detail.Count = records.Count;
    table.Detail.Mask = maskOf(table.Detail.Count);
    const double step = std::ldexp(1.0, -1 - pair);
    table.Detail.Bend = (table.IsOdd ? 0.25 : 1.0) * step * step;
  }
  this->Frame.FirstDetail = &this->Frame.Depths[first];
  DetailFrame& frame = this->Frame.Detail;
  frame.Base = &this->Hierarchy;
  frame.Heights = this->Detail->Heights();
  frame.Period = this->Detail->Period();
  frame.Mask = maskOf(frame.Period);
  frame.Level = level;
  frame.Corners = this->Hierarchy.Summary.Corners;
  frame.Centre = this->CentreSite().Record.Height;
}

/// Squares around the vertices of each depth, and tiles as large.
void Refiner::Work::TabulateRelief()
{
  for (int level = 0; level < this->Steepness.Levels(); ++level)
  {
    this->Relief.emplace_back(this->Steepness.LevelAt(level).Tiles.size());
  }
  for (int depth = 0; depth < this->Depths(); ++depth)
  {
    // Step of the depth in detail cells; a base cell has 2^Level() of them.
    const int shift = this->Hierarchy.Layout->Pairs() + this->Level() - 1 - depth / 2;
    ReliefTable& table = this->Frame.Depths[depth].Relief;
    table.Margin = ((depth & 1) != 0 ? 2u : 3u) << shift;
    // Twice the margin is less than eight steps.
    const int level = std::clamp(
      shift + 3 - this->Level() - SteepnessTiles::TileShift, 0, this->Steepness.Levels() - 1);
    const SteepnessTiles::Level& tiles = this->Steepness.LevelAt(level);
    table.Tiles = this->Relief[level].data();
    table.Shift = SteepnessTiles::TileShift + level + this->Level();
    table.Columns = static_cast<std::uint32_t>(tiles.Columns);
    table.LastColumn = table.Columns - 1;
    table.LastRow = static_cast<std::uint32_t>(tiles.Rows) - 1;
  }
}

/// Slants where slopes are `slopeScale` times as steep.
void Refiner::Work::SetRelief(double slopeScale)
{
  if (slopeScale == this->SlopeScale)
  {
    return;
  }
  this->SlopeScale = slopeScale;
  for (std::size_t level = 0; level < this->Relief.size(); ++level)
  {
    const std::vector<BaseSteepness>& tiles =
      this->Steepness.LevelAt(static_cast<int>(level)).Tiles;
    for (std::size_t i = 0; i < tiles.size(); ++i)
    {
      const double slope = tiles[i].Slope * slopeScale;
      const double slant = std::sqrt(1.0 + slope * slope);
      this->Relief[level][i] = { static_cast<float>(slant * (1.0 + kSlantSlack)), tiles[i].Twist };
    }
  }
}

/// Circles and spheres of the view; RefinementDetail.h says what they hold.
void Refiner::Work::SetDetailView(const RefinementView& view)
{
  DetailFrame& frame = this->Frame.Detail;
  const double heightUnit = this->Frame.Step.z;
  const double ends = double(this->Detail->Maximum()) + this->Detail->Minimum();
  frame.Scale = static_cast<float>(view.DetailScale);
  frame.Middle = 0.5 * view.DetailScale * ends;
  frame.PlaneStep = glm::dvec2(this->Frame.Step) * std::ldexp(1.0, -this->Level());
  frame.Step = view.Parallel ? glm::dvec2(0.0) : frame.PlaneStep;
  this->Frame.EyeHeight -= frame.Middle * this->Frame.DistanceScale;

  this->SetRelief(heightUnit / this->Scale);
  frame.RadiusScale = this->Frame.RadiusScale;
  const HierarchySummary& summary = this->Hierarchy.Summary;
  const double half = 0.5 * view.DetailScale * heightUnit * this->DetailRange();
  const double rounding = kHeightRounding * heightUnit *
    std::max(std::abs(summary.MinimumHeight), std::abs(summary.MaximumHeight));
  const int first = this->Hierarchy.Layout->Depths();
  double length = std::max(frame.PlaneStep.x, frame.PlaneStep.y) * std::sqrt(0.5);
  for (int depth = this->Depths() - 1; depth >= first; --depth)
  {
    const int left = this->Depths() - depth;
    DetailDepth& table = this->Frame.Depths[depth].Detail;
    table.Circle = DetailCircle(length, left);
    table.CircleReach = table.Circle * this->Frame.RadiusScale;
    table.Half = half + rounding * left;
    length *= std::sqrt(2.0);
  }
  // A sample of the last depth is as far from its children as the vertices one depth above them.
  const int left = this->Depths() - first + 1;
  frame.Circle = DetailCircle(length, left);
  frame.Half = half + rounding * left;
}

/// Reaches of errors; Frame.ErrorScale is that of a unit of height.
void Refiner::Work::SetDetailTolerance(const RefinementView& view)
{
  DetailFrame& frame = this->Frame.Detail;
  const double scale = this->Frame.ErrorScale;
  frame.ErrorScale = view.DetailScale * scale;
  frame.RangeReach = frame.ErrorScale * this->DetailRange();
  frame.FloorReach = frame.ErrorScale * this->Detail->LargestError();
  frame.BendReach = 0.0;
  const int first = this->Hierarchy.Layout->Depths();
  for (int depth = first; depth < this->Depths(); ++depth)
  {
    DetailDepth& table = this->Frame.Depths[depth].Detail;
    table.BendReach = table.Bend * scale;
    frame.BendReach = std::max(frame.BendReach, table.BendReach);
  }
}

void Refiner::Work::SetView(const RefinementView& view)
{
  this->Scale = 1.0 / std::max(1.0, view.Exaggeration);
  const glm::dvec3 eye = (view.Eye - this->Hierarchy.Geometry.Origin) * this->Scale;
  this->Frame.Step = this->Scale * glm::dvec3(this->Hierarchy.Geometry.Spacing, view.Exaggeration);
  this->Frame.DistanceScale = view.Parallel ? 0.0 : this->Frame.Step.z;
  this->Frame.EyeHeight = view.Parallel ? 0.0 : eye.z;
  this->Frame.RadiusScale = view.Parallel ? 0.0 : 1.0;
  this->SetDepths(this->Depths());
  // Halves of 1, whatever the column and row.
  this->Frame.Eye = view.Parallel ? glm::dvec2(std::sqrt(0.5)) : glm::dvec2(eye);
  this->Frame.DistanceStep = view.Parallel ? glm::dvec2(0.0) : glm::dvec2(this->Frame.Step);
  if (this->Detail)
  {
    this->SetDetailView(view);
  }
}

/// Tables of distances to the eye, for refinement by them alone.
void Refiner::Work::SetDistances()
{
  for (int axis = 0; axis < 2; ++axis)
  {
    std::vector<DistanceEntry>& entries = this->Distances[axis];
    entries.clear();
    for (const AxisEntry& entry : this->Axes[axis])
    {
      const double distance = entry.Sample * this->Frame.DistanceStep[axis] - this->Frame.Eye[axis];
      entries.push_back({ distance * distance, entry.Sample });
    }
  }
  for (DepthTable& table : this->Frame.Depths)
  {
    if (table.Columns)
    {
      table.ColumnDistances = &this->Distances[0][table.Columns - this->Axes[0].data()];
      table.RowDistances = &this->Distances[1][table.Rows - this->Axes[1].data()];
    }
  }
}

/// Vertices of the first `count` depths are looked at.
void Refiner::Work::SetDepths(int count)
{
  this->DepthCount = count;
  this->Frame.Deepest = &this->Frame.Depths[count - 1];
}

void Refiner::Work::SetTolerance(const RefinementView& view, double tolerance)
{
  // Errors beside holes are horizontal: flattening must not make them smaller.
  const double stretch =
    this->Hierarchy.Summary.HasHoles ? std::max(1.0, view.Exaggeration) : view.Exaggeration;
  const double unit = view.Parallel ? 1.0 : this->Scale;
  this->Frame.ErrorScale = stretch * unit * view.PixelsPerUnit / tolerance;
  if (this->Detail)
  {
    this->SetDetailTolerance(view);
  }
}

void Refiner::Work::SetPlanes(const RefinementView& view, CullingMethod culling)
{
  this->Frame.PlaneCount = 0;
  this->Frame.IsLazy = culling == CullingMethod::Lazy;
  const int lazyDepths = culling == CullingMethod::Lazy ? kLazyDepths : 0;
  for (int depth = 0; depth < this->DepthCount; ++depth)
  {
    this->Frame.Depths[depth].PlaneMask = depth < this->DepthCount - lazyDepths ? ~0u : 0u;
  }
  if (culling == CullingMethod::None)
  {
    return;
  }
  for (const glm::dvec4& plane : view.Planes)
  {
    const glm::dvec3 normal(plane);
    const double length = glm::length(normal);
    if (length > 0.0 && this->Frame.PlaneCount < static_cast<int>(this->Frame.Planes.size()))
    {
      const double offset = plane.w + glm::dot(normal, this->Hierarchy.Geometry.Origin);
      this->Frame.Planes[this->Frame.PlaneCount++] =
        glm::dvec4(normal / length, this->Scale * offset / length);
    }
  }
}

VertexSite Refiner::Work::CentreSite() const
{
  VertexSite site{};
  site.Depth = &this->Frame.Depths[0];
  site.Column = &site.Depth->Columns[1];
  site.Row = &site.Depth->Rows[1];
  site.Position = this->Centre();
  site.Index = site.Column->Term + site.Row->Term;
  site.Record = this->Frame.Records[site.Index];
  return site;
}

SquareSites Refiner::Work::MakeSquare() const
{
  SquareSites square{};
  for (std::uint32_t corner = 0; corner < 4; ++corner)
  {
    const std::uint32_t column = this->Ends[0][corner & 1].Sample;
    const std::uint32_t row = this->Ends[1][corner >> 1].Sample;
    square.Samples[corner] = column | (row << 16);
    square.Corners[corner] =
      PlaceSample(this->Frame, column, row, this->Hierarchy.Summary.Corners[corner]);
    square.Corners[corner].Record = StripVertex::NoRecord + corner;
  }
  square.Centre = this->CentreSite();
  return square;
}

/// The strip through the triangles that were selected; returns their number.
template <bool HasHoles>
std::int64_t Refiner::Work::MakeStrip(std::vector<std::uint32_t>& strip) const
{
  using Triangles = SelectedTriangles<HasHoles>;
  constexpr std::uint32_t centre = RefinementSelection::Centre;
  std::array<typename Triangles::Triangle, 4> square;
  for (std::uint32_t side = 0; side < 4; ++side)
  {
    square[side] = { kSquareRound[side], centre, kSquareRound[side + 1],
      this->Selection.Halves()[2 * centre + side / 2][side & 1], true };
  }
  return StripThrough(Triangles(this->Selection), square, strip);
}

void Refiner::Work::MakeImproved(bool morphing, StripMesh& mesh)
{
  this->Selection.MakeMesh(this->Frame, this->MakeSquare(), morphing, mesh.Vertices);
  mesh.Triangles =
    this->Frame.HasHoles ? this->MakeStrip<true>(mesh.Strip) : this->MakeStrip<false>(mesh.Strip);
  this->Selection.MergeSamples(mesh.Vertices, mesh.Strip);
}

std::int64_t Refiner::Work::MakeImprovedByDistance(std::vector<std::uint32_t>& strip) const
{
  const SquareSites sites = this->MakeSquare();
  const std::int64_t half = std::int64_t(1) << this->Frame.Depths[0].Shift;
  std::array<DistanceTriangles::Triangle, 4> square;
  for (int side = 0; side < 4; ++side)
  {
    const auto way = [half](int direction)
    {
      const std::array<int, 2>& unit = HierarchyLayout::Directions[direction & 7];
      return half * (unit[0] + unit[1] * (std::int64_t(1) << 32));
    };
    const std::int64_t toApex = way(2 + 2 * side);
    square[side] = { this->Centre() - static_cast<std::uint64_t>(toApex), toApex, way(4 + 2 * side),
      &this->Frame.Depths[1], sites.SampleAt(kSquareRound[side]), sites.SampleAt(4),
      sites.SampleAt(kSquareRound[side + 1]), 0 };
  }
  return StripThrough(DistanceTriangles(this->Frame), square, strip);
}

/// The tolerance of the options, raised until the budget suffices: counts how many triangles each
/// tolerance takes, over a range that starts higher when there are too many to count. Around the
/// eye no tolerance is large enough: then it is infinite, and the depth is limited.
double Refiner::Work::ToleranceFor(const RefinementView& view, const RefinementOptions& options)
{
  const double share = options.Morphing ? kMorphBegin : 1.0;
  const std::int64_t budget = std::max<std::int64_t>(options.TriangleBudget, 4) - 4;
  const auto count = [&](double tolerance)
  {
    ToleranceCounts counts(kCountLimit * (budget + 4) + 64);
    this->SetTolerance(view, share * tolerance);
    this->Selection.Count(this->Frame, this->MakeSquare(), counts);
    return counts;
  };
  double tolerance = options.Tolerance;
  for (; tolerance < kLargestTolerance; tolerance *= kToleranceStep)
  {
    const ToleranceCounts counts = count(tolerance);
    const double factor = counts.AreEnough() ? 0.0 : counts.FactorFor(budget);
    if (factor > 0.0 && std::isfinite(factor))
    {
      return tolerance * factor;
    }
    if (factor > 0.0)
    {
      break;
    }
  }
  tolerance = std::numeric_limits<double>::infinity();
  for (ToleranceCounts counts = count(tolerance); counts.AreEnough() || counts.Triangles() > budget;
       counts = count(tolerance))
  {
    this->SetDepths(this->DepthCount - 1);
  }
  return tolerance;
}

/// After a mesh of too many triangles: raises the tolerance, or looks at one depth less where it is
/// infinite; false if nothing is left. Where vertices are not tested against the planes, the plain
/// procedure splits the two sides of an edge independently, into more triangles than are counted.
bool Refiner::Work::Coarsen(std::int64_t budget, StripMesh& mesh)
{
  if (std::isfinite(mesh.Tolerance))
  {
    const double excess = static_cast<double>(mesh.Triangles) / static_cast<double>(budget);
    mesh.Tolerance *= std::max(excess, kLeastStep);
    mesh.Tolerance =
      mesh.Tolerance < kLargestTolerance ? mesh.Tolerance : std::numeric_limits<double>::infinity();
    return true;
  }
  this->SetDepths(std::max(this->DepthCount - 1, 1));
  return this->DepthCount > 1;
}

Refiner::Refiner(const HierarchyView& hierarchy)
  : Refiner(hierarchy, nullptr)
{
}

Refiner::Refiner(
  const HierarchyView& hierarchy, const DetailHierarchy* detail, const ParallelFor& parallelFor)
  : Private(std::make_unique<Work>(hierarchy, detail, parallelFor))
{
}

Refiner::~Refiner() = default;

void Refiner::Refine(const RefinementView& view, const RefinementOptions& options, StripMesh& mesh)
{
  Work& work = *this->Private;
  mesh.Tolerance = options.Tolerance;
  const HierarchyLayout& layout = *work.Hierarchy.Layout;
  if (layout.Width() < 2 || layout.Height() < 2)
  {
    mesh.Clear();
    return;
  }
  work.SetView(view);
  work.SetPlanes(view, options.Culling);
  if (options.TriangleBudget > 0)
  {
    mesh.Tolerance = work.ToleranceFor(view, options);
  }
  const double share = options.Morphing ? kMorphBegin : 1.0;
  work.SetTolerance(view, share * mesh.Tolerance);
  if (options.Method == RefinementMethod::Improved)
  {
    work.MakeImproved(options.Morphing, mesh);
    return;
  }
  work.Plain.MakeMesh(work.Frame, work.MakeSquare(), options.Morphing, mesh);
  while (options.TriangleBudget > 0 && mesh.Triangles > options.TriangleBudget &&
    work.Coarsen(options.TriangleBudget, mesh))
  {
    work.SetTolerance(view, share * mesh.Tolerance);
    work.Plain.MakeMesh(work.Frame, work.MakeSquare(), options.Morphing, mesh);
  }
}

std::int64_t Refiner::RefineByDistance(const RefinementView& view, double range,
  RefinementMethod method, std::vector<std::uint32_t>& strip)
{
  Work& work = *this->Private;
  work.SetView(view);
  work.SetDistances();
  work.SetDepths(work.Hierarchy.Layout->Depths());
  work.SetPlanes(view, CullingMethod::None);
  const HierarchyLayout& layout = *work.Hierarchy.Layout;
  const glm::dvec2 spacing = work.Hierarchy.Geometry.Spacing;
  double reach = work.Scale * std::max(spacing.x, spacing.y) * static_cast<double>(layout.Cells());
  reach *= 0.5 * range / (1.0 - std::sqrt(0.5));
  for (int depth = 0; depth < layout.Depths(); ++depth)
  {
    // A little more for the coarser ones, so that rounding keeps them nested.
    const double nested = reach * (1.0 + 1.0e-9 * (layout.Depths() - depth));
    work.Frame.Depths[depth].Range2 = nested * nested - work.Frame.EyeHeight * work.Frame.EyeHeight;
    reach *= std::sqrt(0.5);
  }
  return method == RefinementMethod::Improved
    ? work.MakeImprovedByDistance(strip)
    : work.Plain.MakeStrip(work.Frame, work.MakeSquare(), strip);
}
}
