// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What becomes of the vertices and the strip of a refinement (RefinementPlainKernel.h).
 */
#ifndef terrain_RefinementSinks_h
#define terrain_RefinementSinks_h

#include "core/strips/RefinementBuffers.h"
#include "core/strips/RefinementVertex.h"

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
};

/// Only the strip; indices are samples: column + 65536 row.
class SampleSink : public StripSink
{
public:
  std::uint32_t Vertex(
    const RefinementFrame&, const VertexSite& site, std::uint32_t, std::uint32_t) const
  {
    return site.Depth->ColumnDistance(site.Position).Sample |
      (site.Depth->RowDistance(site.Position).Sample << 16);
  }
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
  std::uint32_t Corner(const RefinementFrame& frame, const StripVertex& vertex)
  {
    const int level = frame.Detail.Level;
    return this->OnBorder(vertex.Column >> level, vertex.Row >> level, vertex);
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
        StripVertex vertex = VertexBelowSamples(frame, site);
        if (this->Morphing)
        {
          Displace(site, this->Vertices[left], this->Vertices[right], vertex);
        }
        this->Vertices.Reserve();
        this->Vertices.Append(vertex);
        return this->Vertices.Count() - 1;
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
    StripVertex vertex = VertexOnSample(frame, site);
    if (this->Morphing && !site.Record.IsRough())
    {
      Displace(site, this->Vertices[left], this->Vertices[right], vertex);
    }
    return vertex;
  }

  /// Index of the vertex of each sample, column + 65536 row, on the last row and column.
  std::unordered_map<std::uint32_t, std::uint32_t> Border;
};
}

#endif
