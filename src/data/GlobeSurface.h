// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The heights of an image on a globe (GlobeData.h), for rays and places on the host, in double
 * precision. Private to the module.
 */
#ifndef vtkTerrain_data_GlobeSurface_h
#define vtkTerrain_data_GlobeSurface_h

#include "core/globe/GlobeTraversal.h"
#include "core/grid/HeightCodes.h"

#include "vtkImageData.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <vector>

namespace terrain
{
class GlobeSurface
{
public:
  /// Takes over an image of heights on a globe and scans it if it has changed since the last call.
  /// False if it is none.
  bool SetImage(vtkImageData* image);
  vtkImageData* GetImage() const
  {
    return this->Image;
  }
  const GlobeGrid& GetGrid() const
  {
    return *this->Grid;
  }

  /// Height of the surface at a longitude and latitude in degrees, not exaggerated; NaN where there
  /// is none.
  double HeightAt(double longitude, double latitude) const;

  /// The first point of the surface on a ray in geocentric coordinates, from begin to end.
  GlobeHit<double> Trace(const glm::dvec3& origin, const glm::dvec3& direction, double begin,
    double end, double exaggeration) const;
  /// The first that is seen from above, as drawn: the planet below is opaque.
  GlobeHit<double> TraceSeen(const glm::dvec3& origin, const glm::dvec3& direction, double begin,
    double end, double exaggeration) const;
  /// Geocentric position of a point of the surface, and its normal there, of unit length; cells and
  /// the position in them.
  glm::dvec3 PositionAt(const glm::ivec2& cell, const glm::dvec2& fraction, double exaggeration,
    glm::dvec3& normal) const;

private:
  glm::dvec4 CellHeights(const glm::ivec2& cell) const;

  vtkWeakPointer<vtkImageData> Image;
  vtkMTimeType ImageTime = 0;
  std::unique_ptr<GlobeGrid> Grid;
  HeightCodes Codes;
  std::vector<float> Texels;
  MinMaxPyramid<float> Pyramid;
};
}
#endif
