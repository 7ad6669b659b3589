// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * View-dependent refinement of a hierarchy into one generalized triangle strip.
 *
 * A vertex is active if its screen-space error rho = Error * lambda / d exceeds the tolerance, d
 * from the eye to the nearest point of its sphere. Errors and spheres are nested, so the parents of
 * an active vertex are active too, and the triangles that active vertices leave unsplit cover the
 * terrain without cracks or T-junctions. Every triangle above the finest depth is within the
 * tolerance (HierarchyBuild.h says what the error bounds).
 *
 * Improved: Balogh, section 5.1. The strip runs from the left to the right end of a triangle's
 * hypotenuse. It enters and leaves by a side or the bottom (hypotenuse), which is known at compile
 * time; so is the end of the entering edge that came last. Three procedures: general; left-only and
 * right-only for triangles where an unsplit neighbour forbids the other half to be split, so that
 * its vertex is not looked at. Every triangle costs one index, two where the strip turns twice to
 * the same side: no strip along the same path has fewer. Beyond the thesis, the active vertices are
 * found first, depth by depth, each decided on and made once (RefinementSelection.h); the three
 * procedures follow their links (RefinementStrip.h).
 * Plain: Lindstrom and Pascucci 2002, section 3.3, where a vertex is tested and appended once for
 * each triangle whose apex it is and repeated by comparing with the strip's end and its parity. The
 * same triangles, more vertices visited and more indices.
 *
 * Culling against planes with the nested spheres. The sphere of a vertex holds all of its diamond,
 * so what is culled is coarser, and only outside. Nested culling tests every sphere that a plane
 * still cuts: no cracks anywhere. Lazy culling (section 5.2) stops kLazyDepths above the finest
 * depth. It leaves T-junctions outside the planes in the plain procedure; the improved ones, which
 * ask both parents of a vertex, have none.
 *
 * Geomorphing by the error (section 4.6.1): with it, vertices are active above kMorphBegin times
 * the tolerance, and there lie on the surface without them; they reach their own height at
 * kMorphEnd times. Each adds (1 - m) (h - mean of the hypotenuse's heights) to the mean of its
 * hypotenuse, m the morph factor. The morphed surface is then a mean of nested meshes over
 * thresholds between both, so its error is at most their mean: the tolerance. Vertices beside the
 * border of the surface (rough ones) do not morph.
 */
#ifndef terrain_Refinement_h
#define terrain_Refinement_h

#include "core/grid/ParallelFor.h"
#include "core/strips/DetailHierarchy.h"
#include "core/strips/Hierarchy.h"
#include "core/strips/RefinementView.h"
#include "core/strips/StripMesh.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace terrain
{
/// Refines one hierarchy again and again. The view must stay valid; use from one thread at a time.
class Refiner
{
public:
  explicit Refiner(const HierarchyView& hierarchy);
  /// With detail, which must stay valid too: the mesh is one of the sum of both, in detail cells,
  /// and refinement runs on below the base's samples (RefinementDetail.h). Looks at all of the
  /// base's cells once, by `parallelFor`.
  Refiner(const HierarchyView& hierarchy, const DetailHierarchy* detail,
    const ParallelFor& parallelFor = SerialFor);
  ~Refiner();
  Refiner(const Refiner&) = delete;
  Refiner& operator=(const Refiner&) = delete;

  /// One sentence that says what is wrong with the view or the options, or empty.
  static std::string WhyNotRefine(const RefinementView& view, const RefinementOptions& options);

  /// Fills mesh; the arguments must be acceptable. Its memory is used again.
  void Refine(const RefinementView& view, const RefinementOptions& options, StripMesh& mesh);

  /// Only the strip, by the distance to the eye in place of errors, of samples as column +
  /// 65536 row; for measuring the refinement alone. A vertex of depth i is active nearer than
  /// `range` times the circle r_i = l_i / (1 - 1 / sqrt 2) (Balogh, section 6.3), l_i its distance
  /// to its children. Nothing is culled or left out, and detail plays no role. Returns the number
  /// of triangles.
  std::int64_t RefineByDistance(const RefinementView& view, double range, RefinementMethod method,
    std::vector<std::uint32_t>& strip);

private:
  struct Work;
  std::unique_ptr<Work> Private;
};
}

#endif
