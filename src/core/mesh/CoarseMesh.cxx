// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/CoarseMesh.h"

#include "core/grid/Constants.h"
#include "core/grid/SampleTypes.h"

#include <array>
#include <cmath>
#include <limits>
#include <mutex>

namespace terrain
{
namespace
{

/// A range of values, empty to begin with.
struct Range
{
  double Low = kInfinity;
  double High = -kInfinity;

  void Add(double value)
  {
    this->Low = value < this->Low ? value : this->Low;
    this->High = value > this->High ? value : this->High;
  }
  void Add(const Range& other)
  {
    this->Low = std::min(this->Low, other.Low);
    this->High = std::max(this->High, other.High);
  }
};

/// The cells of a quad and the heights of its corners.
struct Quad
{
  /// South-west sample, and cells east and north.
  std::int64_t X = 0;
  std::int64_t Y = 0;
  std::int64_t CellsX = 0;
  std::int64_t CellsY = 0;
  /// Heights are kept relative to this one, so that a large offset costs no precision.
  double Reference = 0.0;
  /// Relative heights: south-west, south-east, north-west, north-east.
  std::array<double, 4> Corners{};
  /// True if every sample has a height.
  bool Complete = true;
};

/// What the samples of a quad say: patch minus plane, and heights relative to the reference.
struct QuadRanges
{
  Range Difference;
  Range Relative;
};

/// A plane along one row of samples: value Start at x = 0 of the quad, Slope a cell.
struct PlaneRow
{
  double Start = 0.0;
  double Slope = 0.0;
};

/// Plane of the triangle south of the diagonal, on row y of the quad.
PlaneRow SouthPlane(const Quad& quad, std::int64_t y)
{
  const double north =
    (quad.Corners[3] - quad.Corners[1]) / static_cast<double>(quad.CellsY) * static_cast<double>(y);
  return { quad.Corners[0] + north,
    (quad.Corners[1] - quad.Corners[0]) / static_cast<double>(quad.CellsX) };
}

/// Plane of the triangle north of the diagonal, on row y of the quad.
PlaneRow NorthPlane(const Quad& quad, std::int64_t y)
{
  const double north =
    (quad.Corners[2] - quad.Corners[0]) / static_cast<double>(quad.CellsY) * static_cast<double>(y);
  return { quad.Corners[0] + north,
    (quad.Corners[3] - quad.Corners[2]) / static_cast<double>(quad.CellsX) };
}

/// Last sample of row y of the quad that is not south of the diagonal.
std::int64_t LastNorth(const Quad& quad, std::int64_t y)
{
  return y * quad.CellsX / quad.CellsY;
}

template <typename T>
void AddSamples(const T* row, std::int64_t begin, std::int64_t end, double reference,
  const PlaneRow& plane, QuadRanges& ranges)
{
  // Lanes are independent, so that the processor compares several samples at a time.
  constexpr std::int64_t kLanes = 4;
  std::array<Range, kLanes> difference;
  std::array<Range, kLanes> relative;
  const auto add = [&](std::int64_t x, std::int64_t lane)
  {
    const double value = static_cast<double>(row[x]) - reference;
    relative[lane].Add(value);
    difference[lane].Add(value - (plane.Start + plane.Slope * static_cast<double>(x)));
  };
  std::int64_t x = begin;
  for (; x + kLanes <= end; x += kLanes)
  {
    for (std::int64_t lane = 0; lane < kLanes; ++lane)
    {
      add(x + lane, lane);
    }
  }
  for (; x < end; ++x)
  {
    add(x, 0);
  }
  for (std::int64_t lane = 0; lane < kLanes; ++lane)
  {
    ranges.Difference.Add(difference[lane]);
    ranges.Relative.Add(relative[lane]);
  }
}

/// All samples of a quad that has no gaps.
template <typename T>
void AddAllSamples(const HeightfieldView<T>& view, const Quad& quad, QuadRanges& ranges)
{
  for (std::int64_t y = 0; y <= quad.CellsY; ++y)
  {
    const T* row = view.Samples + view.Index(quad.X, quad.Y + y);
    const std::int64_t middle = LastNorth(quad, y) + 1;
    AddSamples(row, 0, middle, quad.Reference, NorthPlane(quad, y), ranges);
    AddSamples(row, middle, quad.CellsX + 1, quad.Reference, SouthPlane(quad, y), ranges);
  }
}

/// The corners of the cells that have a surface.
template <typename T>
void AddValidCells(const HeightfieldView<T>& view, const Quad& quad, QuadRanges& ranges)
{
  for (std::int64_t y = 0; y < quad.CellsY; ++y)
  {
    for (std::int64_t x = 0; x < quad.CellsX; ++x)
    {
      if (!view.IsCellValid(quad.X + x, quad.Y + y))
      {
        continue;
      }
      for (std::int64_t row = y; row <= y + 1; ++row)
      {
        const T* samples = view.Samples + view.Index(quad.X, quad.Y + row);
        const std::int64_t middle = std::clamp(LastNorth(quad, row) + 1, x, x + 2);
        AddSamples(samples, x, middle, quad.Reference, NorthPlane(quad, row), ranges);
        AddSamples(samples, middle, x + 2, quad.Reference, SouthPlane(quad, row), ranges);
      }
    }
  }
}

/// Where the diagonal of a quad enters or leaves one of its cells: its parameter from the
/// south-west (0) to the north-east corner (1), and the position in the cell.
struct DiagonalPoint
{
  double T = 0.0;
  double X = 0.0;
  double Y = 0.0;
};

/// Patch minus diagonal along the part of the diagonal inside cell (x, y) of the quad: a parabola.
template <typename T>
void AddCut(const HeightfieldView<T>& view, const Quad& quad, std::int64_t x, std::int64_t y,
  Range& difference)
{
  const std::int64_t w = quad.CellsX;
  const std::int64_t h = quad.CellsY;
  const auto divide = [](std::int64_t a, std::int64_t b)
  { return static_cast<double>(a) / static_cast<double>(b); };
  const DiagonalPoint begin = x * h >= y * w
    ? DiagonalPoint{ divide(x, w), 0.0, divide(x * h - y * w, w) }
    : DiagonalPoint{ divide(y, h), divide(y * w - x * h, h), 0.0 };
  const DiagonalPoint end = (x + 1) * h <= (y + 1) * w
    ? DiagonalPoint{ divide(x + 1, w), 1.0, divide((x + 1) * h - y * w, w) }
    : DiagonalPoint{ divide(y + 1, h), divide((y + 1) * w - x * h, h), 1.0 };

  const T* south = view.Samples + view.Index(quad.X + x, quad.Y + y);
  const T* north = south + view.RowStep();
  const double sw = static_cast<double>(south[0]) - quad.Reference;
  const double se = static_cast<double>(south[1]) - quad.Reference;
  const double nw = static_cast<double>(north[0]) - quad.Reference;
  const double ne = static_cast<double>(north[1]) - quad.Reference;
  const double twist = (sw - se) + (ne - nw);
  const auto minusDiagonal = [&](const DiagonalPoint& p)
  {
    const double patch = sw + p.X * (se - sw) + p.Y * (nw - sw) + p.X * p.Y * twist;
    return patch - (quad.Corners[0] + p.T * (quad.Corners[3] - quad.Corners[0]));
  };

  const double first = minusDiagonal(begin);
  const double last = minusDiagonal(end);
  difference.Add(first);
  difference.Add(last);
  const double curvature = twist * (end.X - begin.X) * (end.Y - begin.Y);
  const double slope = last - first - curvature;
  if (std::abs(slope) < 2.0 * std::abs(curvature) && slope * curvature < 0.0)
  {
    difference.Add(first - slope * slope / (4.0 * curvature));
  }
}

/// The cells of a quad that its diagonal cuts.
template <typename T>
void AddCuts(const HeightfieldView<T>& view, const Quad& quad, Range& difference)
{
  for (std::int64_t y = 0; y < quad.CellsY; ++y)
  {
    const std::int64_t end = ((y + 1) * quad.CellsX + quad.CellsY - 1) / quad.CellsY;
    for (std::int64_t x = LastNorth(quad, y); x < end; ++x)
    {
      if (quad.Complete || view.IsCellValid(quad.X + x, quad.Y + y))
      {
        AddCut(view, quad, x, y, difference);
      }
    }
  }
}

template <typename T>
QuadRanges ComputeRanges(const HeightfieldView<T>& view, const Quad& quad)
{
  QuadRanges ranges;
  if (quad.Complete)
  {
    AddAllSamples(view, quad, ranges);
  }
  else
  {
    AddValidCells(view, quad, ranges);
  }
  AddCuts(view, quad, ranges.Difference);
  return ranges;
}

/// The sum of a and b, rounded up.
double AddRoundedUp(double a, double b)
{
  const double sum = a + b;
  const double bRounded = sum - a;
  const double error = (a - (sum - bRounded)) + (b - bRounded);
  return error > 0.0 ? std::nextafter(sum, kInfinity) : sum;
}

/// What is known of the samples of a quad before its corners are chosen.
struct QuadContent
{
  bool Kept = false;
  bool Complete = true;
  /// Mean height of the corners of the quad that have one, else of the corners of its cells.
  double Mean = 0.0;
};

/// Builds a mesh step by step.
template <typename T>
class Builder
{
public:
  Builder(const HeightfieldView<T>& view, const CoarseMeshOptions& options)
    : View(view)
    , PushUp(options.PushUp)
  {
    this->Mesh.Width = view.Width;
    this->Mesh.Height = view.Height;
    this->Mesh.CellsPerQuad = options.CellsPerQuad > 0
      ? std::min(
          options.CellsPerQuad, std::max<std::int64_t>({ view.Width - 1, view.Height - 1, 1 }))
      : AutomaticCellsPerQuad(view.Width, view.Height);
    this->MayHaveGaps = view.Mask || view.HasNoData || std::is_floating_point_v<T>;
  }

  CoarseMesh Build(const ParallelFor& parallelFor)
  {
    CoarseMesh& mesh = this->Mesh;
    if (mesh.Width < 2 || mesh.Height < 2)
    {
      return std::move(mesh);
    }
    const std::int64_t step = mesh.CellsPerQuad;
    mesh.QuadsX = (mesh.Width - 1 + step - 1) / step;
    mesh.QuadsY = (mesh.Height - 1 + step - 1) / step;
    const std::int64_t quads = mesh.QuadsX * mesh.QuadsY;
    mesh.QuadKept.resize(quads);
    if (this->PushUp)
    {
      mesh.QuadPushes.resize(quads);
      this->OwnGaps.resize(quads);
    }
    if (this->MayHaveGaps && step > 1)
    {
      this->Means.resize(quads, std::numeric_limits<double>::quiet_NaN());
    }
    mesh.VertexHeights.resize((mesh.QuadsX + 1) * (mesh.QuadsY + 1));
    parallelFor(
      quads, [this](std::int64_t begin, std::int64_t end) { this->PushQuads(begin, end); });
    parallelFor(mesh.QuadsY + 1,
      [this](std::int64_t begin, std::int64_t end) { this->RaiseVertices(begin, end); });
    parallelFor(
      quads, [this](std::int64_t begin, std::int64_t end) { this->BoundGaps(begin, end); });
    parallelFor(
      quads, [this](std::int64_t begin, std::int64_t end) { this->MeasureGaps(begin, end); });
    mesh.MinimumHeight = this->Heights.Low;
    mesh.MaximumHeight = this->Heights.High;
    return std::move(mesh);
  }

private:
  /// A quad without its corners' heights.
  Quad Frame(std::int64_t qx, std::int64_t qy) const
  {
    Quad quad;
    quad.X = this->Mesh.Column(qx);
    quad.Y = this->Mesh.Row(qy);
    quad.CellsX = this->Mesh.Column(qx + 1) - quad.X;
    quad.CellsY = this->Mesh.Row(qy + 1) - quad.Y;
    return quad;
  }

  /// Subsampled height of a corner (0 or 1 east and north) of a quad; mean where there is none.
  double CornerHeight(const Quad& quad, int east, int north, double mean) const
  {
    const std::int64_t index =
      this->View.Index(quad.X + east * quad.CellsX, quad.Y + north * quad.CellsY);
    return !this->MayHaveGaps || this->View.IsValid(index)
      ? static_cast<double>(this->View.Samples[index])
      : mean;
  }

  /// The quad of step 1.
  Quad Subsample(std::int64_t qx, std::int64_t qy, const QuadContent& content) const
  {
    Quad quad = this->Frame(qx, qy);
    quad.Complete = content.Complete;
    quad.Reference = this->CornerHeight(quad, 0, 0, content.Mean);
    for (int corner = 1; corner < 4; ++corner)
    {
      quad.Corners[corner] =
        this->CornerHeight(quad, corner & 1, corner >> 1, content.Mean) - quad.Reference;
    }
    return quad;
  }

  /// Scans a quad for samples without height.
  QuadContent Inspect(std::int64_t qx, std::int64_t qy) const
  {
    QuadContent content;
    const Quad quad = this->Frame(qx, qy);
    for (std::int64_t y = 0; y <= quad.CellsY && content.Complete; ++y)
    {
      const std::int64_t row = this->View.Index(quad.X, quad.Y + y);
      for (std::int64_t x = 0; x <= quad.CellsX; ++x)
      {
        content.Complete = content.Complete && this->View.IsValid(row + x);
      }
    }
    content.Kept = content.Complete;
    if (!content.Complete)
    {
      this->InspectCells(quad, content);
    }
    return content;
  }

  /// Whether a quad with gaps has a surface, and its mean height.
  void InspectCells(const Quad& quad, QuadContent& content) const
  {
    const HeightfieldView<T>& view = this->View;
    double reference = 0.0;
    double sum = 0.0;
    std::int64_t count = 0;
    for (std::int64_t y = quad.Y; y < quad.Y + quad.CellsY; ++y)
    {
      for (std::int64_t x = quad.X; x < quad.X + quad.CellsX; ++x)
      {
        if (view.IsCellValid(x, y))
        {
          reference = count > 0 ? reference : view.At(x, y);
          sum += view.At(x, y) - reference;
          ++count;
        }
      }
    }
    content.Kept = count > 0;
    content.Mean = content.Kept ? reference + sum / static_cast<double>(count) : 0.0;
    sum = 0.0;
    count = 0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double height =
        view.At(quad.X + (corner & 1) * quad.CellsX, quad.Y + (corner >> 1) * quad.CellsY);
      sum += std::isnan(height) ? 0.0 : height - reference;
      count += std::isnan(height) ? 0 : 1;
    }
    content.Mean = count > 0 ? reference + sum / static_cast<double>(count) : content.Mean;
  }

  QuadContent Content(std::int64_t quadIndex) const
  {
    QuadContent content;
    content.Kept = this->Mesh.QuadKept[quadIndex] != 0;
    content.Complete = this->Means.empty() || std::isnan(this->Means[quadIndex]);
    content.Mean = content.Complete ? 0.0 : this->Means[quadIndex];
    return content;
  }

  /// Steps 1 and 2 for a range of quads.
  void PushQuads(std::int64_t begin, std::int64_t end)
  {
    CoarseMesh& mesh = this->Mesh;
    Range heights;
    for (std::int64_t index = begin; index < end; ++index)
    {
      const std::int64_t qx = index % mesh.QuadsX;
      const std::int64_t qy = index / mesh.QuadsX;
      const QuadContent content =
        this->MayHaveGaps ? this->Inspect(qx, qy) : QuadContent{ true, true, 0.0 };
      mesh.QuadKept[index] = content.Kept ? 1 : 0;
      if (!content.Kept)
      {
        continue;
      }
      if (!content.Complete)
      {
        this->Means[index] = content.Mean;
      }
      const Quad quad = this->Subsample(qx, qy, content);
      const QuadRanges ranges = ComputeRanges(this->View, quad);
      heights.Add(quad.Reference + ranges.Relative.Low);
      heights.Add(quad.Reference + ranges.Relative.High);
      if (this->PushUp)
      {
        mesh.QuadPushes[index] = ranges.Difference.High + kPushSlack * Relief(quad, ranges);
        this->OwnGaps[index] = mesh.QuadPushes[index] - ranges.Difference.Low;
      }
    }
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Heights.Add(heights);
  }

  /// Largest height, in amount, that the sums over a quad meet.
  static double Relief(const Quad& quad, const QuadRanges& ranges)
  {
    double relief = std::max(std::abs(ranges.Relative.Low), std::abs(ranges.Relative.High));
    for (const double corner : quad.Corners)
    {
      relief = std::max(relief, std::abs(corner));
    }
    return relief;
  }

  /// Step 3 for a range of rows of vertices.
  void RaiseVertices(std::int64_t begin, std::int64_t end)
  {
    CoarseMesh& mesh = this->Mesh;
    for (std::int64_t vy = begin; vy < end; ++vy)
    {
      for (std::int64_t vx = 0; vx <= mesh.QuadsX; ++vx)
      {
        double highest = -kInfinity;
        for (int corner = 0; corner < 4; ++corner)
        {
          const std::int64_t qx = vx - (corner & 1);
          const std::int64_t qy = vy - (corner >> 1);
          if (mesh.IsKept(qx, qy))
          {
            highest = std::max(highest, this->PushedCorner(qx, qy, corner));
          }
        }
        mesh.VertexHeights[vx + (mesh.QuadsX + 1) * vy] =
          highest > -kInfinity ? highest : std::numeric_limits<double>::quiet_NaN();
      }
    }
  }

  /// Height of a corner of a quad after step 2, rounded up.
  double PushedCorner(std::int64_t qx, std::int64_t qy, int corner) const
  {
    const std::int64_t index = qx + this->Mesh.QuadsX * qy;
    const QuadContent content = this->Content(index);
    if (!this->PushUp)
    {
      return this->CornerHeight(this->Frame(qx, qy), corner & 1, corner >> 1, content.Mean);
    }
    const Quad quad = this->Subsample(qx, qy, content);
    return AddRoundedUp(quad.Reference, quad.Corners[corner] + this->Mesh.QuadPushes[index]);
  }

  /// Bounds of the largest distance of mesh and surface over a quad: that after step 2, plus what
  /// step 3 raised its corners by. Nothing is known without PushUp.
  Range GapBounds(std::int64_t index) const
  {
    if (!this->PushUp)
    {
      return { 0.0, kInfinity };
    }
    const CoarseMesh& mesh = this->Mesh;
    const std::int64_t qx = index % mesh.QuadsX;
    const std::int64_t qy = index / mesh.QuadsX;
    Range raised;
    for (int corner = 0; corner < 4; ++corner)
    {
      raised.Add(mesh.VertexHeight(qx + (corner & 1), qy + (corner >> 1)) -
        this->PushedCorner(qx, qy, corner));
    }
    constexpr double kRounding = 1e-12;
    return { (this->OwnGaps[index] + raised.Low) * (1.0 - kRounding),
      (this->OwnGaps[index] + raised.High) * (1.0 + kRounding) };
  }

  /// Finds a gap that the largest is not smaller than.
  void BoundGaps(std::int64_t begin, std::int64_t end)
  {
    double least = 0.0;
    for (std::int64_t index = begin; index < end; ++index)
    {
      least = this->Mesh.QuadKept[index] ? std::max(least, this->GapBounds(index).Low) : least;
    }
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->LeastGap = std::max(this->LeastGap, least);
  }

  /// Largest distance of mesh and surface over those quads of a range where it may be.
  void MeasureGaps(std::int64_t begin, std::int64_t end)
  {
    const CoarseMesh& mesh = this->Mesh;
    double gap = 0.0;
    for (std::int64_t index = begin; index < end; ++index)
    {
      if (!mesh.QuadKept[index] || this->GapBounds(index).High < this->LeastGap)
      {
        continue;
      }
      const std::int64_t qx = index % mesh.QuadsX;
      const std::int64_t qy = index / mesh.QuadsX;
      Quad quad = this->Frame(qx, qy);
      quad.Complete = this->Content(index).Complete;
      quad.Reference = mesh.VertexHeight(qx, qy);
      for (int corner = 1; corner < 4; ++corner)
      {
        quad.Corners[corner] =
          mesh.VertexHeight(qx + (corner & 1), qy + (corner >> 1)) - quad.Reference;
      }
      const Range difference = ComputeRanges(this->View, quad).Difference;
      gap = std::max({ gap, std::abs(difference.Low), std::abs(difference.High) });
    }
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Mesh.LargestGap = std::max(this->Mesh.LargestGap, gap);
  }

  const HeightfieldView<T>& View;
  const bool PushUp;
  bool MayHaveGaps = false;
  CoarseMesh Mesh;
  /// Of each quad with gaps its mean height, else NaN; empty if there can be none.
  std::vector<double> Means;
  /// Of each quad the largest distance to the surface after step 2; empty unless PushUp.
  std::vector<double> OwnGaps;
  /// The largest gap is not smaller than this.
  double LeastGap = 0.0;
  std::mutex Mutex;
  Range Heights;
};
}

//------------------------------------------------------------------------------
std::int64_t AutomaticCellsPerQuad(std::int64_t width, std::int64_t height)
{
  const std::int64_t cells = std::max(width, height) - 1;
  std::int64_t size = kAutomaticCellsPerQuad;
  while (size * kAutomaticQuads < cells)
  {
    size *= 2;
  }
  return size;
}

//------------------------------------------------------------------------------
template <typename T>
CoarseMesh BuildCoarseMesh(
  const HeightfieldView<T>& view, const CoarseMeshOptions& options, const ParallelFor& parallelFor)
{
  Builder<T> builder(view, options);
  return builder.Build(parallelFor);
}

#define TERRAIN_INSTANTIATE(T)                                                                     \
  template CoarseMesh BuildCoarseMesh<T>(                                                          \
    const HeightfieldView<T>&, const CoarseMeshOptions&, const ParallelFor&);
TERRAIN_FOR_EACH_SAMPLE_TYPE(TERRAIN_INSTANTIATE)
#undef TERRAIN_INSTANTIATE
}
