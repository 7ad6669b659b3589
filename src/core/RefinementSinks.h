// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What becomes of the vertices and the strip of a refinement (RefinementKernel.h).
 */
#ifndef terrain_RefinementSinks_h
#define terrain_RefinementSinks_h

#include "core/RefinementKernel.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>
#include <unordered_map>

namespace terrain
{
/// Appends to the memory of a vector without asking whether there is room; Reserve() makes it.
template <typename T>
class AppendBuffer
{
public:
  /// Takes the vector's memory and begins at its start.
  void Begin(std::vector<T>& memory)
  {
    this->Memory.swap(memory);
    this->Used = 0;
    this->SetMemory();
  }
  /// Gives the memory back, as a vector of what was appended.
  void Finish(std::vector<T>& memory)
  {
    this->Memory.resize(this->Used);
    this->Memory.swap(memory);
    this->Memory.clear();
  }
  TERRAIN_INLINE void Append(const T& element)
  {
    this->Data[this->Used++] = element;
  }
  TERRAIN_INLINE std::uint32_t Count() const
  {
    return this->Used;
  }
  /// Makes room for what two triangles of each depth take, and their joins.
  TERRAIN_INLINE void Reserve()
  {
    if (this->Used >= this->Limit)
    {
      this->Grow();
    }
  }
  TERRAIN_INLINE T& operator[](std::uint32_t index)
  {
    return this->Data[index];
  }
  TERRAIN_INLINE const T& operator[](std::uint32_t index) const
  {
    return this->Data[index];
  }

private:
  static constexpr std::size_t Slack = 512;

  TERRAIN_NO_INLINE void Grow()
  {
    this->Memory.resize(this->Memory.size() + this->Memory.size() / 4 + 2 * Slack);
    this->SetMemory();
  }
  void SetMemory()
  {
    this->Data = this->Memory.data();
    this->Limit = static_cast<std::uint32_t>(std::max(this->Memory.size(), Slack) - Slack);
  }

  std::vector<T> Memory;
  T* Data = nullptr;
  std::uint32_t Used = 0;
  std::uint32_t Limit = 0;
};

/// A strip of indices; what a sink that keeps the strip is derived from.
class StripSink
{
public:
  AppendBuffer<std::uint32_t> Strip;

  void Prefetch(std::uint32_t) const
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

  std::uint32_t Vertex(
    const RefinementFrame& frame, const VertexSite& site, std::uint32_t, std::uint32_t)
  {
    const double gap = std::sqrt(site.Distance2) - site.Record.Radius() * frame.RadiusScale;
    const double ratio = site.Record.Error() * frame.ErrorScale / std::max(gap, 1.0e-300);
    ++this->Buckets[BucketOf(ratio)];
    ++this->Total;
    return 0;
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
  void Prefetch(std::uint32_t) const
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

/// Index of the vertex of each record, of this mesh alone: entries of meshes before are known by
/// their number and need not be cleared.
class VertexIndex
{
public:
  /// Makes room for a hierarchy's records; false if there is no memory. Memory that is never
  /// touched is not taken.
  bool Allocate(std::int64_t recordCount)
  {
    if (!this->Entries)
    {
      this->RecordCount = static_cast<std::size_t>(recordCount);
      this->Entries.reset(
        static_cast<std::uint32_t*>(std::calloc(this->RecordCount, sizeof(std::uint32_t))));
      this->First = 1;
    }
    return this->Entries != nullptr;
  }
  /// Forgets the vertices of a mesh; `count` were numbered.
  void Forget(std::uint32_t count)
  {
    this->First += count;
    // As many again must fit: a mesh has fewer than 2^31 vertices.
    if (this->First > (1u << 31))
    {
      std::fill_n(this->Entries.get(), this->RecordCount, 0u);
      this->First = 1;
    }
  }
  /// Index of the record's vertex, or a number that is no index below `count`.
  std::uint32_t Find(std::uint32_t record) const
  {
    return this->Entries.get()[record] - this->First;
  }
  TERRAIN_INLINE void Prefetch(std::uint32_t record) const
  {
    __builtin_prefetch(this->Entries.get() + record);
  }
  void Set(std::uint32_t record, std::uint32_t index)
  {
    this->Entries.get()[record] = this->First + index;
  }

private:
  struct FreeMemory
  {
    void operator()(std::uint32_t* memory) const
    {
      std::free(memory);
    }
  };
  std::unique_ptr<std::uint32_t, FreeMemory> Entries;
  std::size_t RecordCount = 0;
  std::uint32_t First = 1;
};

/// Makes a mesh in which every sample is one vertex.
class MeshSink : public StripSink
{
public:
  AppendBuffer<StripVertex> Vertices;
  /// Vertices inside the raster, by record.
  VertexIndex Inside;
  bool Morphing = false;

  TERRAIN_INLINE void Prefetch(std::uint32_t record) const
  {
    this->Inside.Prefetch(record);
  }

  /// Begins a mesh in the memory of `mesh`.
  void Begin(StripMesh& mesh)
  {
    this->Inside.Forget(this->Vertices.Count());
    this->Vertices.Begin(mesh.Vertices);
    this->Strip.Begin(mesh.Strip);
    this->Border.clear();
    this->Reserve();
  }
  void Finish(StripMesh& mesh)
  {
    this->Inside.Forget(this->Vertices.Count());
    this->Vertices.Finish(mesh.Vertices);
    this->Strip.Finish(mesh.Strip);
  }
  TERRAIN_INLINE void Reserve()
  {
    StripSink::Reserve();
    this->Vertices.Reserve();
  }

  /// Adds a corner of the square.
  std::uint32_t Corner(const AxisEntry& column, const AxisEntry& row, int corner, float height)
  {
    return this->OnBorder(column.Sample, row.Sample,
      { static_cast<std::uint16_t>(column.Sample), static_cast<std::uint16_t>(row.Sample), height,
        0.0f, StripVertex::NoRecord + static_cast<std::uint32_t>(corner) });
  }

  TERRAIN_INLINE std::uint32_t Vertex(
    const RefinementFrame& frame, const VertexSite& site, std::uint32_t left, std::uint32_t right)
  {
    if (site.Column->Sample == frame.LastColumn || site.Row->Sample == frame.LastRow)
    {
      return this->BorderVertex(frame, site, left, right);
    }
    const std::uint32_t next = this->Vertices.Count();
    const std::uint32_t known = this->Inside.Find(site.Index);
    if (known < next)
    {
      return known;
    }
    this->Inside.Set(site.Index, next);
    this->Add(frame, site, left, right);
    return next;
  }

private:
  /// Index of vertices that no drawn triangle uses: below all counts, never looked at.
  static constexpr std::uint32_t Beyond = 0;

  TERRAIN_NO_INLINE void Add(
    const RefinementFrame& frame, const VertexSite& site, std::uint32_t left, std::uint32_t right)
  {
    this->Vertices.Append(this->Make(frame, site, left, right));
  }

  /// On the last row and column several vertices of the hierarchy share a sample, and are one.
  TERRAIN_NO_INLINE std::uint32_t BorderVertex(
    const RefinementFrame& frame, const VertexSite& site, std::uint32_t left, std::uint32_t right)
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
      this->Vertices.Append(vertex);
    }
    return entry->second;
  }

  TERRAIN_INLINE StripVertex Make(const RefinementFrame& frame, const VertexSite& site,
    std::uint32_t left, std::uint32_t right) const
  {
    StripVertex vertex;
    vertex.Column = static_cast<std::uint16_t>(site.Column->Sample);
    vertex.Row = static_cast<std::uint16_t>(site.Row->Sample);
    vertex.Height = site.Record.Height;
    vertex.Record = site.Index;
    if (this->Morphing && !site.Record.IsRough())
    {
      const StripVertex& a = this->Vertices[left];
      const StripVertex& b = this->Vertices[right];
      vertex.Displacement = 0.5f * (a.Displacement + b.Displacement) -
        Morph(frame, site) * (vertex.Height - 0.5f * (a.Height + b.Height));
    }
    return vertex;
  }

  /// How far a vertex is from its own height: 1 to 0. See Refinement.h.
  static float Morph(const RefinementFrame& frame, const VertexSite& site)
  {
    constexpr double end = kMorphEnd / kMorphBegin;
    const double gap = std::sqrt(site.Distance2) - site.Record.Radius() * frame.RadiusScale;
    const double ratio = site.Record.Error() * frame.ErrorScale / std::max(gap, 1.0e-300);
    // Not std::clamp, whose branches would wait for the division.
    return static_cast<float>(std::min(std::max((end - ratio) * (1.0 / (end - 1.0)), 0.0), 1.0));
  }

  /// True if the diamond of a vertex beyond the raster does not touch it.
  static bool IsBeyond(const RefinementFrame& frame, const VertexSite& site)
  {
    const auto x = static_cast<std::uint32_t>(site.Position);
    const auto y = static_cast<std::uint32_t>(site.Position >> 32);
    const std::uint32_t step = 1u << site.Depth->Shift;
    return x >= frame.LastColumn + step || y >= frame.LastRow + step;
  }

  /// Index of the vertex of each sample, column + 65536 row, on the last row and column.
  std::unordered_map<std::uint32_t, std::uint32_t> Border;
};
}

#endif
