// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What casting rays at a globe works with, as floats or doubles: rays and hits, the grid about an
 * anchor, and where on it a ray is. The comments of shaders/vtkTerrainGlobeLines.glsl refer to
 * these.
 */
#ifndef terrain_GlobeLines_h
#define terrain_GlobeLines_h

#include "core/globe/GlobeAnchor.h"

#include <glm/glm.hpp>

#include <cmath>
#include <vector>

namespace terrain
{
/// Beyond any distance.
constexpr float kGlobeNever = 1e30f;

/// The level whose nodes are less than a quarter turn wide.
inline int TopOfGlobe(const GlobeGrid& grid)
{
  int top = 0;
  while (std::ldexp(grid.Step, top + 1) < 1.5)
  {
    ++top;
  }
  return top;
}

template <typename Real>
struct GlobeRay
{
  using Vec3 = glm::vec<3, Real>;
  Vec3 Origin{ 0 };    ///< relative to the anchor, in its axes, metres
  Vec3 Direction{ 0 }; ///< change per unit of t
  Real Begin = 0;      ///< searched are Begin <= t <= End
  Real End = 0;
};

template <typename Real>
struct GlobeHit
{
  bool Found = false;
  Real T = 0;
  glm::ivec2 Cell{ 0 };
  glm::vec<2, Real> Fraction{ 0 };
  bool Front = true; ///< seen from above
  int Crossings = 0;
};

/// The grid about an anchor as floats or doubles.
template <typename Real>
struct GlobeLines
{
  using Vec2 = glm::vec<2, Real>;
  using Vec3 = glm::vec<3, Real>;
  using Vec4 = glm::vec<4, Real>;

  GlobeLines() = default;
  GlobeLines(const GlobeGrid& grid, const GlobeAnchor& anchor)
    : Columns(anchor.Columns.begin(), anchor.Columns.end())
    , Rows(anchor.Rows.begin(), anchor.Rows.end())
    , Radius(static_cast<Real>(anchor.Radius))
    , Axis(static_cast<Real>(anchor.Position.z))
    , Height(static_cast<Real>(anchor.Height))
    , Outer(anchor.Outer.PerRadius, anchor.Outer.PerAxis, anchor.Outer.Anchor)
    , Inner(anchor.Inner.PerRadius, anchor.Inner.PerAxis, anchor.Inner.Anchor)
    , Curvature(static_cast<Real>(anchor.Curvature))
    , Spread(static_cast<Real>(anchor.Spread))
    , PerStep(static_cast<Real>(1.0 / grid.Step))
    , Turn(static_cast<Real>(kTurn / grid.Step))
    , Cells(grid.Cells())
    , Joined(grid.IsJoined())
  {
    for (const glm::dvec4& curve : GlobeCurves(grid))
    {
      this->Curves.emplace_back(curve);
    }
    this->AnchorCell = static_cast<int>(std::floor(anchor.Column));
    this->AnchorFraction = static_cast<Real>(anchor.Column - this->AnchorCell);
    this->Top = TopOfGlobe(grid);
  }

  std::vector<Vec2> Columns;
  std::vector<Vec4> Rows;
  std::vector<Vec4> Curves;
  Real Radius = 0;
  Real Axis = 0;
  Real Height = 0;
  Vec3 Outer{ 0 };
  Vec3 Inner{ 0 };
  Real Curvature = 0;
  Real Spread = 0;
  Real PerStep = 0; ///< cells a radian
  Real Turn = 0;    ///< cells that go round
  glm::ivec2 Cells{ 0 };
  bool Joined = false;
  int AnchorCell = 0;
  Real AnchorFraction = 0;
  int Top = 0; ///< TopOfGlobe()
};

/// A ray with what its lines share.
template <typename Real>
struct GlobePath
{
  glm::vec<3, Real> Origin; ///< x from the axis
  glm::vec<3, Real> Direction;
  glm::vec<3, Real> Squares; ///< (r^2 - Radius^2) = Squares.x + 2 t Squares.y + t^2 Squares.z
  bool East;
  Real Sag; ///< second derivative that heights cannot exceed
  Real Begin;
  Real End;
};

/// Where a ray is: the node that it runs on in. Column -1 is the gap of a partial raster, row -1
/// what lies south of it and -2 what lies north.
template <typename Real>
struct GlobeStep
{
  glm::ivec2 Node;
  int Level;
  Real T;
};

/// The part of a ray in a node.
template <typename Real>
struct GlobeSpan
{
  Real T;
  int Side; ///< 0 across a meridian, 1 north, 2 south
  bool Ends;
};

/// The lines about a node: columns from west to east, rows from south to north.
struct GlobeFence
{
  glm::ivec2 First;
  glm::ivec2 Last;
};
}

#endif
