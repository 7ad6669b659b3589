// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What refinement asks of vertices, and with detail of triangles.
 */
#ifndef terrain_RefinementSites_h
#define terrain_RefinementSites_h

#include "core/strips/RefinementFrame.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace terrain
{
/// True if a diagonal hypotenuse rises to the east.
inline bool IsRising(const DetailTriangleSite& triangle)
{
  const auto east = static_cast<std::int32_t>(triangle.ToLeft);
  return (east > 0) == (triangle.ToLeft - east > 0);
}

/// Completes a half of a base cell.
TERRAIN_NO_INLINE inline void EnterCell(const RefinementFrame& frame, DetailTriangleSite& triangle)
{
  const std::uint64_t opposite = triangle.Position - static_cast<std::uint64_t>(triangle.ToApex);
  const float height = frame.Detail.BaseHeight(
    static_cast<std::uint32_t>(opposite), static_cast<std::uint32_t>(opposite >> 32));
  const float twist =
    0.25f * ((triangle.LeftBase + triangle.RightBase) - (triangle.ApexBase + height));
  triangle.Twist = IsRising(triangle) ? twist : -twist;
}

/// Height of the base at the vertex that halves a triangle below the samples: the mean of its
/// hypotenuse's ends, and between two diagonal ones the patch's bend.
TERRAIN_INLINE float BaseAt(const DetailTriangleSite& triangle)
{
  const float mean = 0.5f * (triangle.LeftBase + triangle.RightBase);
  if (triangle.Depth->IsOdd)
  {
    return mean;
  }
  return IsRising(triangle) ? mean - triangle.Twist : mean + triangle.Twist;
}

/// Relief of the base about a vertex.
TERRAIN_INLINE BaseRelief ReliefAbout(const VertexSite& site)
{
  return site.Depth->Relief.About(
    static_cast<std::uint32_t>(site.Position), static_cast<std::uint32_t>(site.Position >> 32));
}

/// Makes error and sphere of a sample of the base hold for what is below it.
TERRAIN_INLINE void AddDetail(const RefinementFrame& frame, DetailVertexSite& site)
{
  const DetailFrame& detail = frame.Detail;
  const BaseRelief relief = ReliefAbout(site);
  site.BaseHeight = site.Record.Height;
  site.ErrorReach = std::max(
    site.ErrorReach + detail.RangeReach, detail.FloorReach + relief.Twist * detail.BendReach);
  const double more = relief.Slant * detail.Circle + detail.Half;
  site.Radius = site.Record.Radius() + more;
  site.RadiusReach += more * detail.RadiusScale;
  site.FlatDistance2 = 0.0;
  site.CircleReach = 0.0;
}

/// True if a sample takes part, culling aside: its error is too large to leave it out.
template <typename Site>
TERRAIN_INLINE bool IsSampleNeeded(const RefinementFrame& frame, Site& site)
{
  site.Record = frame.Records[site.Index];
  const double dx = site.Column->Sample * frame.DistanceStep.x - frame.Eye.x;
  const double dy = site.Row->Sample * frame.DistanceStep.y - frame.Eye.y;
  const double dz = site.Record.Height * frame.DistanceScale - frame.EyeHeight;
  site.Distance2 = dx * dx + dy * dy + dz * dz;
  site.ErrorReach = site.Record.Error() * frame.ErrorScale;
  site.RadiusReach = site.Record.Radius() * frame.RadiusScale;
  bool hasError = site.Record.HasError();
  if constexpr (std::is_same_v<Site, DetailVertexSite>)
  {
    AddDetail(frame, site);
    hasError = hasError || site.Record.Drawn() != 0;
  }
  const double reach = site.ErrorReach + site.RadiusReach;
  // Both tests at once: the second alone decides too seldom for a branch of its own.
  return (int(reach * reach > site.Distance2) & int(hasError)) != 0;
}

/// True if a vertex below the samples, where the base is `baseHeight` high, takes part, culling
/// aside.
TERRAIN_INLINE bool IsDetailNeeded(
  const RefinementFrame& frame, float baseHeight, DetailVertexSite& site)
{
  const DetailFrame& detail = frame.Detail;
  const DetailDepth& depth = site.Depth->Detail;
  const auto x = static_cast<std::uint32_t>(site.Position);
  const auto y = static_cast<std::uint32_t>(site.Position >> 32);
  const BaseRelief relief = ReliefAbout(site);
  site.Record = depth.Record(x, y);
  site.BaseHeight = baseHeight;
  const double dx = x * detail.Step.x - frame.Eye.x;
  const double dy = y * detail.Step.y - frame.Eye.y;
  const double dz = site.BaseHeight * frame.DistanceScale - frame.EyeHeight;
  site.FlatDistance2 = dx * dx + dy * dy;
  site.Distance2 = site.FlatDistance2 + dz * dz;
  site.ErrorReach = site.Record.Error() * detail.ErrorScale + relief.Twist * depth.BendReach;
  site.Radius = relief.Slant * depth.Circle + depth.Half;
  site.RadiusReach = site.Radius * detail.RadiusScale;
  site.CircleReach = depth.CircleReach;
  const double reach = site.ErrorReach + site.RadiusReach;
  const double circle = site.ErrorReach + site.CircleReach;
  return (int(reach * reach > site.Distance2) & int(circle * circle > site.FlatDistance2) &
           int(site.ErrorReach > 0.0)) != 0;
}

/// Centre and radius of the sphere of a vertex, in the planes' space.
inline std::pair<glm::dvec3, double> SphereOf(const RefinementFrame& frame, const VertexSite& site)
{
  return { frame.Step * glm::dvec3(site.Column->Sample, site.Row->Sample, site.Record.Height),
    site.Record.Radius() };
}
inline std::pair<glm::dvec3, double> SphereOf(
  const RefinementFrame& frame, const DetailVertexSite& site)
{
  const DetailFrame& detail = frame.Detail;
  const double height = frame.Step.z * (site.BaseHeight + detail.Middle);
  if (site.Depth >= frame.FirstDetail)
  {
    const glm::dvec2 position(static_cast<std::uint32_t>(site.Position), site.Position >> 32);
    return { glm::dvec3(detail.PlaneStep * position, height), site.Radius };
  }
  return { glm::dvec3(frame.Step.x * site.Column->Sample, frame.Step.y * site.Row->Sample, height),
    site.Radius };
}

/// True if the sphere is outside some plane of the mask; planes that it is inside of leave it.
template <typename Site>
TERRAIN_NO_INLINE bool IsCulled(const RefinementFrame& frame, const Site& site, std::uint32_t& mask)
{
  const auto [centre, radius] = SphereOf(frame, site);
  for (int i = 0; i < frame.PlaneCount; ++i)
  {
    if ((mask & (1u << i)) != 0)
    {
      const glm::dvec4& plane = frame.Planes[i];
      const double distance =
        plane.x * centre.x + plane.y * centre.y + plane.z * centre.z + plane.w;
      if (distance < -radius)
      {
        return true;
      }
      if (distance > radius)
      {
        mask &= ~(1u << i);
      }
    }
  }
  return false;
}
}

#endif
