// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Polygons on the ground: what fills them is part of the picture that lies on the terrain, and
 * their outlines are lines (ViewMarks).
 */
#ifndef terrain_render_PolygonLayer_h
#define terrain_render_PolygonLayer_h

#include "Annotations.h"
#include "ColorName.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

class Statistics;
class vtkImageData;
struct Options;
struct PlacedHeights;

struct PolygonLayer
{
  /// Of each file, its rings in the scene (Polygons::Rings), and points' values (kFieldValue) if
  /// there is a table.
  std::vector<vtkSmartPointer<vtkPolyData>> Files;
  /// What the colours tell; no table if they have one colour.
  LegendKey Key;
  RGB Color{};
};

/// Reads the polygons that the options name. Throws a Failure: no polygons, a round scene.
PolygonLayer ReadPolygonLayer(
  const PlacedHeights& heights, const Options& options, Statistics& statistics);

/// A picture over all of the heights with what fills the polygons over another picture, which is
/// null for none. Null if nothing is filled.
vtkSmartPointer<vtkImageData> FillPolygons(
  const PolygonLayer& layer, vtkImageData* heights, vtkImageData* below, const Options& options);

#endif
