// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the samples of heights lie on a body: sample (i, j) at longitude West + i * Step and at
 * latitude Latitudes[j], from the south. The surface over a cell is the height bilinear in
 * longitude and latitude above the ellipsoid, drawn at Base + Exaggeration * height.
 */
#ifndef terrain_GlobeGrid_h
#define terrain_GlobeGrid_h

#include "core/grid/Coordinates.h"
#include "core/place/Ellipsoid.h"

#include <glm/glm.hpp>

#include <array>
#include <string>
#include <vector>

namespace terrain
{
/// Heights between which a surface lies, in metres, as drawn.
struct GlobeRange
{
  double Lowest = 0.0;
  double Highest = 0.0;
};

/// How heights are drawn above the ellipsoid, which is not exaggerated itself.
inline GridGeometry DrawnOnGlobe(double exaggeration)
{
  GridGeometry geometry;
  geometry.Exaggeration = exaggeration;
  return geometry;
}

struct GlobeGrid
{
  Ellipsoid Body;
  double West = 0.0; ///< longitude of the first column, radians
  double Step = 0.0; ///< from a column to the next, > 0
  int Columns = 0;   ///< of samples; where the grid goes round, the last repeats the first
  std::vector<double> Latitudes; ///< of the rows of samples, rising

  glm::ivec2 Cells() const
  {
    return { this->Columns - 1, static_cast<int>(this->Latitudes.size()) - 1 };
  }
  /// True if the last column lies on the first.
  bool IsJoined() const;
  /// Empty, or one sentence that says why there is no such grid.
  std::string WhyNot() const;
  ///@{
  /// The position of a latitude among the rows, and back: linear between them, and on beyond the
  /// first and the last as beside them.
  double RowOf(double latitude) const;
  double LatitudeOf(double row) const;
  ///@}
  /// Corners of the least box, in geocentric coordinates, about all positions over the grid whose
  /// heights lie in a range above half the body's polar semi-axis below it.
  std::array<glm::dvec3, 2> BoxOf(const GlobeRange& range) const;
};
}

#endif
