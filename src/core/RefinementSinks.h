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
#include <cstring>
#include <limits>
#include <memory>

namespace terrain
{
/// A growing array of indices that appends without a test; Reserve() makes room for one triangle
/// of each depth and its joins.
class StripBuffer
{
public:
  void Clear()
  {
    this->Used = 0;
  }
  void Append(std::uint32_t index)
  {
    this->Indices[this->Used++] = index;
  }
  std::uint32_t Count() const
  {
    return static_cast<std::uint32_t>(this->Used);
  }
  std::uint32_t Last() const
  {
    return this->Indices[this->Used - 1];
  }
  /// Makes the first index the same as the third.
  void RepeatThird()
  {
    this->Indices[0] = this->Indices[2];
  }
  void Reserve()
  {
    if (this->Used + Slack > this->Indices.size())
    {
      this->Indices.resize(2 * this->Indices.size() + 2 * Slack);
    }
  }
  /// Swaps the strip with `strip`, cut to its length.
  void Take(std::vector<std::uint32_t>& strip)
  {
    this->Indices.resize(this->Used);
    this->Indices.swap(strip);
    this->Used = 0;
  }

private:
  static constexpr std::size_t Slack = 1024;
  std::vector<std::uint32_t> Indices;
  std::size_t Used = 0;
};

/// Indices are samples: column + 65536 row.
class SampleSink
{
public:
  StripBuffer Strip;

  std::uint32_t Vertex(
    const RefinementFrame&, const VertexSite& site, std::uint32_t, std::uint32_t) const
  {
    return site.Column->Sample | (site.Row->Sample << 16);
  }
  void Append(std::uint32_t index)
  {
    this->Strip.Append(index);
  }
  void Reserve()
  {
    this->Strip.Reserve();
  }
  void RepeatThird()
  {
    this->Strip.RepeatThird();
  }
  std::uint32_t Count() const
  {
    return this->Strip.Count();
  }
  std::uint32_t Last() const
  {
    return this->Strip.Last();
  }
  static constexpr bool Stopped()
  {
    return false;
  }
};

/// Counts triangles by the tolerance, relative to the frame's, at which they would appear.
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
    const HierarchyRecord& record = frame.Records[site.Record];
    const double gap = std::sqrt(site.Distance2) - record.Radius() * frame.RadiusScale;
    const double ratio = record.Error() * frame.ErrorScale / std::max(gap, 1.0e-300);
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
class MeshSink
{
public:
  StripBuffer Strip;
  std::vector<StripVertex> Vertices;
  bool Morphing = false;
  /// Index of vertices that no drawn triangle uses.
  static constexpr std::uint32_t Beyond = 0xffffffffu;

  void Clear()
  {
    this->Strip.Clear();
    this->Vertices.clear();
    if (this->Table.empty())
    {
      this->Table.resize(std::size_t(1) << 10);
    }
    this->TableUsed = 0;
    std::memset(this->Table.data(), 0xff, this->Table.size() * sizeof(Slot));
  }

  /// Adds a corner of the square.
  std::uint32_t Corner(const AxisEntry& column, const AxisEntry& row, int corner, float height)
  {
    Slot& slot = this->Find(column.Sample | (row.Sample << 16));
    if (slot.Index == Free)
    {
      slot = { column.Sample | (row.Sample << 16), this->NextIndex() };
      ++this->TableUsed;
      this->Vertices.push_back({ column.Sample, row.Sample, height, 0.0f,
        StripVertex::NoRecord + static_cast<std::uint32_t>(corner), 0 });
    }
    return slot.Index;
  }

  /// Vertices inside the raster are found by their record, those on its last row and column, where
  /// several vertices of the hierarchy share a sample, by the sample.
  std::uint32_t Vertex(
    const RefinementFrame& frame, const VertexSite& site, std::uint32_t left, std::uint32_t right)
  {
    if (site.Column->Sample != frame.LastColumn && site.Row->Sample != frame.LastRow)
    {
      std::uint32_t& known = this->Known.get()[site.Record];
      if (known == 0)
      {
        known = this->Add(frame, site, left, right) + 1;
      }
      return known - 1;
    }
    if (IsBeyond(frame, site))
    {
      return Beyond;
    }
    const std::uint32_t key = site.Column->Sample | (site.Row->Sample << 16);
    Slot& slot = this->Find(key);
    if (slot.Index != Free)
    {
      return slot.Index;
    }
    const std::uint32_t index = this->Add(frame, site, left, right);
    slot = { key, index };
    if (2 * ++this->TableUsed > this->Table.size())
    {
      this->Grow();
    }
    return index;
  }

  /// Makes room for the vertices of a hierarchy; false if there is no memory. Memory that is never
  /// touched is not taken.
  bool Allocate(std::int64_t recordCount)
  {
    if (!this->Known)
    {
      this->Known.reset(static_cast<std::uint32_t*>(
        std::calloc(static_cast<std::size_t>(recordCount), sizeof(std::uint32_t))));
    }
    return this->Known != nullptr;
  }

  /// Forgets where the vertices are.
  void Forget()
  {
    for (const StripVertex& vertex : this->Vertices)
    {
      if (vertex.Record < StripVertex::NoRecord)
      {
        this->Known.get()[vertex.Record] = 0;
      }
    }
  }

  void Append(std::uint32_t index)
  {
    this->Strip.Append(index);
  }
  void Reserve()
  {
    this->Strip.Reserve();
  }
  void RepeatThird()
  {
    this->Strip.RepeatThird();
  }
  std::uint32_t Count() const
  {
    return this->Strip.Count();
  }
  std::uint32_t Last() const
  {
    return this->Strip.Last();
  }
  static constexpr bool Stopped()
  {
    return false;
  }

private:
  static constexpr std::uint32_t Free = 0xffffffffu;
  struct Slot
  {
    std::uint32_t Key;
    std::uint32_t Index;
  };

  std::uint32_t NextIndex() const
  {
    return static_cast<std::uint32_t>(this->Vertices.size());
  }

  std::uint32_t Add(
    const RefinementFrame& frame, const VertexSite& site, std::uint32_t left, std::uint32_t right)
  {
    const HierarchyRecord& record = frame.Records[site.Record];
    const float displacement = this->Morphing && !record.IsRough()
      ? this->Displacement(frame, site, record, left, right)
      : 0.0f;
    const std::uint32_t index = this->NextIndex();
    this->Vertices.push_back({ site.Column->Sample, site.Row->Sample, record.Height, displacement,
      site.Record, site.Depth });
    return index;
  }

  /// True if the diamond of a vertex beyond the raster does not touch it.
  static bool IsBeyond(const RefinementFrame& frame, const VertexSite& site)
  {
    const auto x = static_cast<std::uint32_t>(site.Position);
    const auto y = static_cast<std::uint32_t>(site.Position >> 32);
    const std::uint32_t step = 1u << frame.Depths[site.Depth].Shift;
    return x >= frame.LastColumn + step || y >= frame.LastRow + step;
  }

  /// What the morph adds to the height, in height units; see Refinement.h. A vertex that does not
  /// morph has no ancestor that does.
  float Displacement(const RefinementFrame& frame, const VertexSite& site,
    const HierarchyRecord& record, std::uint32_t left, std::uint32_t right) const
  {
    constexpr double end = kMorphEnd / kMorphBegin;
    const double radius = record.Radius() * frame.RadiusScale;
    const double reach = record.Error() * frame.ErrorScale;
    const double still = reach / end + radius;
    if (still * still > site.Distance2)
    {
      return 0.0f;
    }
    const double ratio = reach / (std::sqrt(site.Distance2) - radius);
    const auto morph = static_cast<float>(std::clamp((end - ratio) / (end - 1.0), 0.0, 1.0));
    const StripVertex& a = this->Vertices[left];
    const StripVertex& b = this->Vertices[right];
    return 0.5f * (a.Displacement + b.Displacement) -
      morph * (record.Height - 0.5f * (a.Height + b.Height));
  }

  /// The slot of a key, or the free one where it belongs.
  Slot& Find(std::uint32_t key)
  {
    const std::size_t mask = this->Table.size() - 1;
    std::size_t position = (key * 0x9e3779b1u) >> 7;
    for (;; ++position)
    {
      Slot& slot = this->Table[position & mask];
      if (slot.Index == Free || slot.Key == key)
      {
        return slot;
      }
    }
  }

  void Grow()
  {
    std::vector<Slot> old(2 * this->Table.size(), Slot{ Free, Free });
    old.swap(this->Table);
    for (const Slot& slot : old)
    {
      if (slot.Index != Free)
      {
        this->Find(slot.Key) = slot;
      }
    }
  }

  struct FreeMemory
  {
    void operator()(std::uint32_t* memory) const
    {
      std::free(memory);
    }
  };
  /// Index + 1 of the vertex of each record, 0 if there is none.
  std::unique_ptr<std::uint32_t, FreeMemory> Known;
  /// Vertices on the last row and column and the corners.
  std::vector<Slot> Table;
  std::size_t TableUsed = 0;
};
}

#endif
