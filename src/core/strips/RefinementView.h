// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a refinement is asked for: the view, the tolerance, the method.
 */
#ifndef terrain_RefinementView_h
#define terrain_RefinementView_h

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace terrain
{
/// Bounds of the morph, in tolerances; their mean is 1.
constexpr double kMorphBegin = 0.75;
constexpr double kMorphEnd = 1.25;

/// Most that a morphing vertex moves on the screen, lambda / d times its vertical movement, while
/// the eye moves by d / lambda, a pixel in its distance, in tolerances; ancestors that morph with
/// it add as much each. For d' = d - Radius, rho = Error lambda / (d' tolerance) and m = (kMorphEnd
/// - rho) / (kMorphEnd - kMorphBegin) the vertex is m c from its place, c <= Error: Error |dm /
/// dd'| = Error rho / d' / (kMorphEnd - kMorphBegin), and Error / d' = rho tolerance / lambda.
constexpr double kMorphRate = kMorphEnd * kMorphEnd / (kMorphEnd - kMorphBegin);

/// Deepest depths, counted from the finest, that lazy culling does not test.
constexpr int kLazyDepths = 6;

/// Where the surface is seen from; positions in model coordinates.
struct RefinementView
{
  glm::dvec3 Eye{ 0.0, 0.0, 0.0 };
  /// lambda: most pixels of a unit length at unit distance. In the middle of the picture that is
  /// viewport height / (2 tan(angle / 2)), and 1 / cos^2 as much in its corners, of their angle to
  /// the middle. For parallel projection pixels of a unit length.
  double PixelsPerUnit = 1.0;
  bool Parallel = false;
  /// Vertical exaggeration, > 0, about height 0 of the grid; see GridGeometry.
  double Exaggeration = 1.0;
  /// Factor of the detail's heights, if there is detail, >= 0.
  double DetailScale = 1.0;
  /// Half spaces n . p + d >= 0 that are seen; at most 8.
  std::vector<glm::dvec4> Planes;
};

enum class RefinementMethod
{
  Plain,
  Improved
};

enum class CullingMethod
{
  None,
  Nested,
  Lazy
};

struct RefinementOptions
{
  /// Largest screen-space error in pixels, > 0.
  double Tolerance = 1.0;
  /// Largest number of triangles, 0 = any; the tolerance is raised until they suffice, but four
  /// triangles are always left.
  std::int64_t TriangleBudget = 0;
  RefinementMethod Method = RefinementMethod::Improved;
  CullingMethod Culling = CullingMethod::Nested;
  bool Morphing = false;
};
}

#endif
