// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Heights in longitude and latitude as those of a globe: the private half of vtkTerrainGlobe.
 */
#ifndef vtkTerrain_place_GlobeHeights_h
#define vtkTerrain_place_GlobeHeights_h

#include "core/globe/GlobeGrid.h"

#include <string>
#include <vector>

class vtkImageData;

namespace terrain
{
/// The grid of a globe and what its columns and rows are made from: the sample at part At of the
/// way from First to the sample after it. Rows before the first and behind the last one that are
/// used stand for the mean of that.
struct GlobePlan
{
  struct Line
  {
    int First = 0;
    double At = 0.0;
  };
  GlobeGrid Grid;
  std::vector<Line> Columns;
  std::vector<Line> Rows;
  /// First and last row of samples that are used.
  glm::ivec2 Used{ 0 };
  /// True if there is nothing to make.
  bool IsPlain = true;
  /// True if samples lie between samples.
  bool IsDivided = false;
  /// Empty, or one sentence that says why there is no globe.
  std::string WhyNot;
};

/// Plans the globe of heights; radii: semi-axes in metres, 0 for those of their coordinate system.
GlobePlan PlanGlobe(vtkImageData* heights, const double radii[2]);
/// Longitudes and latitudes over which the samples reach, degrees; 0 where they are none. isEarth:
/// false for another world.
glm::dvec2 GlobeReach(vtkImageData* heights, bool& isEarth);
/// Lowers the samples of a globe below finer heights on the same one: each whose cells are covered
/// by them, to less than the lowest of these by a hundredth of a cell. Scalars are floats.
/// Empty, or one sentence that says why not.
std::string GiveWay(vtkImageData* globe, vtkImageData* finer);
/// Writes the samples of a planned globe: height less offset; floats where they are asked for.
void FillGlobe(
  vtkImageData* heights, const GlobePlan& plan, double offset, bool asFloats, vtkImageData* output);
}
#endif
