// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A small map in a corner of the picture.
 */
#ifndef terrain_render_Inset_h
#define terrain_render_Inset_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>

class vtkRenderer;
class vtkScalarsToColors;
struct Options;

/**
 * All of the heights from above, north on top, with shade from the north-west: at the upper left
 * corner of the picture. A frame on it shows the ground that the eye would see if that were level
 * in the middle of its heights, and a triangle where the eye is and looks; an eye beside the map is
 * marked at its border.
 */
class InsetMap
{
public:
  /// Of heights in the colours of a table, exaggerated in the picture, in a box of the scene.
  InsetMap(vtkImageData* heights, vtkScalarsToColors* colors, const std::array<double, 6>& box,
    const Options& options);

  /// Adds it, for the camera as it is.
  void AddTo(vtkRenderer* renderer) const;

private:
  void AddMarks(vtkRenderer* renderer) const;
  /// Where a place of the scene is on the map.
  std::array<double, 2> ToPixel(double x, double y) const;

  std::array<double, 6> Box;
  const Options& Wanted;
  vtkSmartPointer<vtkImageData> Picture;
  /// Lower left corner and size in pixels.
  std::array<double, 2> Corner{};
  std::array<double, 2> Size{};
};

#endif
