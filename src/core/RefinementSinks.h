// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What becomes of the vertices and the strip of a refinement (RefinementKernel.h).
 */
#ifndef terrain_RefinementSinks_h
#define terrain_RefinementSinks_h

#include "core/RefinementBuffers.h"
#include "core/RefinementKernel.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <unordered_map>

namespace terrain
{
/// A strip of indices; what a sink that keeps the strip is derived from.
class StripSink
{
public:
  AppendBuffer<std::uint32_t> Strip;

  static void Repeat(std::uint32_t)
  {
  }
  void Append(std::uint32_t index)
  {
    this->Strip.Append(index);
  }
  void Reserve()
  {
    this->Strip.Reserve();
  }
  std::uint32_t Count() const
  {
    return this->Strip.Count();
  }
  std::uint32_t Last() const
  {
    return this->Strip[this->Strip.Count() - 1];
  }
  /// Makes the first index the same as the third.
  void RepeatThird()
  {
    this->Strip[0] = this->Strip[2];
  }
  static constexpr bool Stopped()
  {
    return false;
  }
};

/// Only the strip; indices are samples: column + 65536 row.
class SampleSink : public StripSink
{
public:
  std::uint32_t Vertex(
    const RefinementFrame&, const VertexSite& site, std::uint32_t, std::uint32_t) const
  {
    return site.Column->Sample | (site.Row->Sample << 16);
  }
};

/// Length from the eye to the vertex's sphere, or circle if that is further.
TERRAIN_INLINE double GapOf(const VertexSite& site)
{
  return std::max(std::sqrt(site.Distance2) - site.RadiusReach, 1.0e-300);
}
TERRAIN_INLINE double GapOf(const DetailVertexSite& site)
{
  return std::max(
    GapOf(static_cast<const VertexSite&>(site)), std::sqrt(site.FlatDistance2) - site.CircleReach);
}

/// No strip: counts triangles by the tolerance, relative to the frame's, at which they would
/// appear.
class CountSink
{
public:
  /// Steps of a factor of 2 in tolerance.
  static constexpr int StepsPerOctave = 32;

  explicit CountSink(std::int64_t limit)
    : Limit(limit)
    , Buckets(64 * StepsPerOctave + 1)
  {
  }

  template <typename Site>
  std::uint32_t Vertex(const RefinementFrame&, const Site& site, std::uint32_t, std::uint32_t)
  {
    const auto bucket = static_cast<std::uint32_t>(BucketOf(site.ErrorReach / GapOf(site)));
    this->Repeat(bucket);
    return bucket;
  }
  /// A vertex appears in two triangles, each of which becomes two.
  void Repeat(std::uint32_t bucket)
  {
    ++this->Buckets[bucket];
    ++this->Total;
  }
  void Append(std::uint32_t)
  {
  }
  void Reserve()
  {
  }
  void RepeatThird()
  {
  }
  static constexpr std::uint32_t Count()
  {
    return 0;
  }
  static constexpr std::uint32_t Last()
  {
    return 0;
  }
  bool Stopped() const
  {
    return this->Total >= this->Limit;
  }

  /// Triangles besides the first four.
  std::int64_t Triangles() const
  {
    return this->Total;
  }

  /// Smallest factor on the tolerance that leaves at most `budget` triangles besides the first
  /// four. Infinite if none of the steps does: the eye is inside the spheres of that many.
  double FactorFor(std::int64_t budget) const
  {
    std::int64_t sum = 0;
    for (std::size_t bucket = this->Buckets.size(); bucket-- > 0;)
    {
      sum += this->Buckets[bucket];
      if (sum > budget)
      {
        return bucket + 1 == this->Buckets.size() ? std::numeric_limits<double>::infinity()
                                                  : EdgeOf(bucket + 1);
      }
    }
    return 1.0;
  }

private:
  /// A step is a range of floats with the same leading bits; 1.0 begins the first one.
  static constexpr int Shift = 23 - 5;
  static std::size_t BucketOf(double ratio)
  {
    const double largest = std::ldexp(1.0, 64);
    const std::uint32_t bits = FloatBits(static_cast<float>(std::clamp(ratio, 1.0, largest)));
    return (bits - FloatBits(1.0f)) >> Shift;
  }
  static double EdgeOf(std::size_t bucket)
  {
    return BitsFloat(FloatBits(1.0f) + (static_cast<std::uint32_t>(bucket) << Shift));
  }

  std::int64_t Limit;
  std::int64_t Total = 0;
  std::vector<std::int64_t> Buckets;
};

/// Makes a mesh in which every sample is one vertex.
class MeshSink : public StripSink
{
public:
  AppendBuffer<StripVertex> Vertices;
  bool Morphing = false;

  /// Begins a mesh in the memory of `mesh`.
  void Begin(StripMesh& mesh)
  {
    this->Vertices.Begin(mesh.Vertices);
    this->Strip.Begin(mesh.Strip);
    this->Border.clear();
    this->Reserve();
  }
  void Finish(StripMesh& mesh)
  {
    this->Vertices.Finish(mesh.Vertices);
    this->Strip.Finish(mesh.Strip);
  }

  /// Adds a corner of the square.
  std::uint32_t Corner(const RefinementFrame& frame, const AxisEntry& column, const AxisEntry& row,
    int corner, float height)
  {
    StripVertex vertex;
    vertex.Record = StripVertex::NoRecord + static_cast<std::uint32_t>(corner);
    PlaceSample(frame, column.Sample, row.Sample, height, vertex);
    return this->OnBorder(column.Sample, row.Sample, vertex);
  }

  /// A sample of the base, or with detail a vertex below them.
  template <typename Site>
  TERRAIN_INLINE std::uint32_t Vertex(
    const RefinementFrame& frame, const Site& site, std::uint32_t left, std::uint32_t right)
  {
    if constexpr (std::is_same_v<Site, DetailVertexSite>)
    {
      if (site.Depth >= frame.FirstDetail)
      {
        return this->BelowSamples(frame, site, left, right);
      }
    }
    if (site.Column->Sample == frame.LastColumn || site.Row->Sample == frame.LastRow)
    {
      return this->BorderVertex(frame, site, left, right);
    }
    this->Vertices.Reserve();
    this->Vertices.Append(this->Make(frame, site, left, right));
    return this->Vertices.Count() - 1;
  }

private:
  /// Index of vertices that no drawn triangle uses: below all counts, never looked at.
  static constexpr std::uint32_t Beyond = 0;

  TERRAIN_INLINE std::uint32_t BelowSamples(const RefinementFrame& frame,
    const DetailVertexSite& site, std::uint32_t left, std::uint32_t right)
  {
    StripVertex vertex;
    vertex.Column = static_cast<std::uint32_t>(site.Position);
    vertex.Row = static_cast<std::uint32_t>(site.Position >> 32);
    vertex.Height = site.BaseHeight + frame.Detail.Scale * site.Record.Height;
    vertex.Record = StripVertex::BelowSamples;
    if (this->Morphing)
    {
      this->Displace(site, left, right, vertex);
    }
    this->Vertices.Reserve();
    this->Vertices.Append(vertex);
    return this->Vertices.Count() - 1;
  }

  /// Places a vertex on a sample of the base of a given height.
  TERRAIN_INLINE static void PlaceSample(const RefinementFrame& frame, std::uint32_t column,
    std::uint32_t row, float height, StripVertex& vertex)
  {
    vertex.Column = column << frame.Detail.Level;
    vertex.Row = row << frame.Detail.Level;
    vertex.Height = height;
    if (frame.FirstDetail)
    {
      vertex.Height += frame.Detail.DetailHeight(vertex.Column, vertex.Row);
    }
  }

  /// On the last row and column several vertices of the hierarchy share a sample, and are one.
  template <typename Site>
  TERRAIN_NO_INLINE std::uint32_t BorderVertex(
    const RefinementFrame& frame, const Site& site, std::uint32_t left, std::uint32_t right)
  {
    return IsBeyond(frame, site)
      ? Beyond
      : this->OnBorder(site.Column->Sample, site.Row->Sample, this->Make(frame, site, left, right));
  }

  std::uint32_t OnBorder(std::uint32_t column, std::uint32_t row, const StripVertex& vertex)
  {
    const auto [entry, isNew] =
      this->Border.try_emplace(column | (row << 16), this->Vertices.Count());
    if (isNew)
    {
      this->Vertices.Reserve();
      this->Vertices.Append(vertex);
    }
    return entry->second;
  }

  template <typename Site>
  TERRAIN_INLINE StripVertex Make(
    const RefinementFrame& frame, const Site& site, std::uint32_t left, std::uint32_t right) const
  {
    StripVertex vertex;
    PlaceSample(frame, site.Column->Sample, site.Row->Sample, site.Record.Height, vertex);
    vertex.Record = site.Index;
    if (this->Morphing && !site.Record.IsRough())
    {
      this->Displace(site, left, right, vertex);
    }
    return vertex;
  }

  /// Morphs a vertex between the ends of its hypotenuse.
  template <typename Site>
  TERRAIN_INLINE void Displace(
    const Site& site, std::uint32_t left, std::uint32_t right, StripVertex& vertex) const
  {
    const StripVertex& a = this->Vertices[left];
    const StripVertex& b = this->Vertices[right];
    vertex.Displacement = 0.5f * (a.Displacement + b.Displacement) -
      Morph(site.ErrorReach / GapOf(site)) * (vertex.Height - 0.5f * (a.Height + b.Height));
  }

  /// How far a vertex is from its own height, 1 to 0; `ratio` of its projected error to that from
  /// which it is active. See Refinement.h.
  static float Morph(double ratio)
  {
    constexpr double end = kMorphEnd / kMorphBegin;
    // Not std::clamp, whose branches would wait for the division.
    return static_cast<float>(std::min(std::max((end - ratio) * (1.0 / (end - 1.0)), 0.0), 1.0));
  }

  /// True if the diamond of a vertex beyond the raster does not touch it.
  static bool IsBeyond(const RefinementFrame& frame, const VertexSite& site)
  {
    const int level = frame.Detail.Level;
    const std::uint32_t x = static_cast<std::uint32_t>(site.Position) >> level;
    const std::uint32_t y = static_cast<std::uint32_t>(site.Position >> 32) >> level;
    const std::uint32_t step = (1u << site.Depth->Shift) >> level;
    return x >= frame.LastColumn + step || y >= frame.LastRow + step;
  }

  /// Index of the vertex of each sample, column + 65536 row, on the last row and column.
  std::unordered_map<std::uint32_t, std::uint32_t> Border;
};
}

#endif
