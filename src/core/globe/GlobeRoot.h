// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where a path meets a cell of a globe (GlobeTraversal.h): the root of its height less that of the
 * surface. Twin of terrainGlobeRefine() in shaders/vtkTerrainGlobeTrace.glsl.
 */
#ifndef terrain_GlobeRoot_h
#define terrain_GlobeRoot_h

#include "core/globe/GlobeErrors.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace terrain
{
/// Differences that are looked at for a root at most, and parts that a path is followed in.
constexpr int kGlobeSteps = 16;

/// How a path meets a cell: the first root of a parabola through its differences in height.
template <typename Real>
struct GlobeMeeting
{
  Real Begin = 0;       ///< t where the path comes into the cell
  Real Length = 0;      ///< t from there to where it leaves
  Real A = 0;           ///< of the parabola A p^2 + B p + C, metres; p: part of the way, 0 to 1
  Real B = 0;           ///< likewise
  Real C = 0;           ///< likewise
  Real Part = -1;       ///< its first root, < 0 for none
  bool Between = false; ///< on the line where the path comes in
  bool Front = true;    ///< seen from above
};

/// Difference at a root, in metres, that is near enough.
template <typename Real>
Real GlobeEnoughAt(Real t)
{
  return std::is_same_v<Real, float>
    ? Real(kGlobeFloatError) + Real(kGlobeFloatPartError) * std::abs(t)
    : Real(0.1 * kGlobeError);
}

/// The first root of a meeting, as a part of the way, refined: twice by the parabola, then, where
/// meridians are close to each other, by secants between two parts on different sides.
/// difference(t): height less that of the surface at t, metres; asked last at the root. Below 0
/// where only the parabola dips through the surface.
template <typename Real, typename Difference>
Real RefineGlobeRoot(const GlobeMeeting<Real>& meeting, const Difference& difference)
{
  Real t = meeting.Part;
  bool isCrossed = meeting.C * (meeting.A + meeting.B + meeting.C) < 0;
  glm::vec<2, Real> bracket(0, 1); // between them the difference changes sign then
  bool found = true;
  glm::vec<2, Real> last(0); // the part before, and the difference there
  for (int i = 0; i < kGlobeSteps; ++i)
  {
    const Real at = meeting.Begin + t * meeting.Length;
    const Real off = difference(at);
    if (off * meeting.C <= 0)
    {
      bracket = { t > bracket.x ? bracket.x : Real(0), std::min(bracket.y, t) };
      isCrossed = true;
    }
    else if (t < bracket.y)
    {
      bracket.x = std::max(bracket.x, t);
    }
    const Real slope = i < 2 ? meeting.B + 2 * meeting.A * t : (off - last.y) / (t - last.x);
    const Real move = std::abs(slope) > 0 ? -off / slope : Real(2); // 2: out of the cell
    const bool isInside = t + move > bracket.x && t + move < bracket.y;
    found = meeting.Between || isCrossed || std::abs(off) <= GlobeEnoughAt(at);
    const bool isNear = std::abs(off) <= GlobeEnoughAt(at) ||
      std::abs(move) * meeting.Length <= 4 * std::numeric_limits<Real>::epsilon() * std::abs(at);
    if (meeting.Between || !(isInside || isCrossed) || (isNear && (i >= 2 || !isInside)) ||
      i == kGlobeSteps - 1)
    {
      break;
    }
    last = { t, off };
    t = isInside ? t + move : (bracket.x + bracket.y) / 2;
  }
  return found ? t : Real(-1);
}
}

#endif
