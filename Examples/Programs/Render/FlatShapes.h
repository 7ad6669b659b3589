// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lines and polygons in pixels of the picture.
 */
#ifndef terrain_render_FlatShapes_h
#define terrain_render_FlatShapes_h

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <array>
#include <vector>

class vtkRenderer;

/// A place in the picture: column and row, the lowest row first.
using Pixel = std::array<double, 2>;

/// Shapes of one colour.
class FlatShapes
{
public:
  /// A line of a width.
  void AddLine(const Pixel& from, const Pixel& to, double width);

  /// The border of a polygon, in lines of a width.
  void AddBorder(const std::vector<Pixel>& corners, double width);

  /// A convex polygon that is filled.
  void AddPolygon(const std::vector<Pixel>& corners);

  void AddTo(vtkRenderer* renderer, const std::array<double, 3>& color) const;

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
};

#endif
