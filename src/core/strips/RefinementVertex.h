// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The vertices of a refined mesh: where they are drawn, and how they morph.
 */
#ifndef terrain_RefinementVertex_h
#define terrain_RefinementVertex_h

#include "core/strips/RefinementFrame.h"
#include "core/strips/RefinementView.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
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

/// A vertex on a sample of the base of a given height, without a record.
TERRAIN_INLINE StripVertex PlaceSample(
  const RefinementFrame& frame, std::uint32_t column, std::uint32_t row, float height)
{
  StripVertex vertex;
  vertex.Column = column << frame.Detail.Level;
  vertex.Row = row << frame.Detail.Level;
  vertex.Height = height;
  if (frame.FirstDetail)
  {
    vertex.Height += frame.Detail.DetailHeight(vertex.Column, vertex.Row);
  }
  return vertex;
}

/// A sample of the base.
TERRAIN_INLINE StripVertex VertexOnSample(const RefinementFrame& frame, const VertexSite& site)
{
  StripVertex vertex =
    PlaceSample(frame, site.Column->Sample, site.Row->Sample, site.Record.Height);
  vertex.Record = site.Index;
  return vertex;
}

/// A vertex below the samples.
TERRAIN_INLINE StripVertex VertexBelowSamples(
  const RefinementFrame& frame, const DetailVertexSite& site)
{
  StripVertex vertex;
  vertex.Column = static_cast<std::uint32_t>(site.Position);
  vertex.Row = static_cast<std::uint32_t>(site.Position >> 32);
  vertex.Height = site.BaseHeight + frame.Detail.Scale * site.Record.Height;
  vertex.Record = StripVertex::BelowSamples;
  return vertex;
}

/// The value, or 0 if it is negative; no branch, which would wait for it.
TERRAIN_INLINE float AtLeastZero(float value)
{
  const std::uint32_t bits = FloatBits(value);
  return BitsFloat(bits & ((bits >> 31) - 1u));
}

/// How far a vertex is from its own height, 1 to 0; `ratio` of its projected error to that from
/// which it is active. See Refinement.h.
TERRAIN_INLINE float MorphOf(double ratio)
{
  constexpr double end = kMorphEnd / kMorphBegin;
  const auto morph = static_cast<float>((end - ratio) * (1.0 / (end - 1.0)));
  return AtLeastZero(1.0f - AtLeastZero(1.0f - morph));
}

/// Morphs a vertex between the ends of its hypotenuse.
template <typename Site>
TERRAIN_INLINE void Displace(
  const Site& site, const StripVertex& left, const StripVertex& right, StripVertex& vertex)
{
  vertex.Displacement = 0.5f * (left.Displacement + right.Displacement) -
    MorphOf(site.ErrorReach / GapOf(site)) * (vertex.Height - 0.5f * (left.Height + right.Height));
}

/// True if the diamond of a vertex beyond the raster does not touch it.
inline bool IsBeyond(const RefinementFrame& frame, const VertexSite& site)
{
  const int level = frame.Detail.Level;
  const std::uint32_t x = static_cast<std::uint32_t>(site.Position) >> level;
  const std::uint32_t y = static_cast<std::uint32_t>(site.Position >> 32) >> level;
  const std::uint32_t step = (1u << site.Depth->Shift) >> level;
  return x >= frame.LastColumn + step || y >= frame.LastRow + step;
}
}

#endif
