// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where observers stand: at points, along lines and in areas.
 */
#ifndef terrain_ObserverPlaces_h
#define terrain_ObserverPlaces_h

#include "core/grid/Coordinates.h"

#include <glm/glm.hpp>

#include <vector>

class vtkPointSet;

namespace terrain
{
/// Places in grid coordinates.
struct ObserverPlaces
{
  /// Most places: more are a mistake rather than a question.
  static constexpr double Most = 1e7;

  /// Observers must be able to stand here.
  std::vector<glm::dvec2> Fixed;
  /// In areas: those where there is no height are left out.
  std::vector<glm::dvec2> Optional;
  /// True if there are more than Most.
  bool TooMany = false;
};

/// The places of a point set: its points, but for those that are corners of polygons and nothing
/// else; between them along the lines of vtkPolyData; and inside of its polygons (even-odd rule) at
/// the samples of the grid. spacing: greatest distance between
/// places along lines, and distance of those in areas, in units of the frame's model coordinates;
/// 0 for one cell.
ObserverPlaces FindObserverPlaces(
  vtkPointSet* observers, const GridGeometry& frame, double spacing);
}

#endif
