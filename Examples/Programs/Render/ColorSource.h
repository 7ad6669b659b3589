// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colours of a terrain, what they show, and what a legend tells of them.
 */
#ifndef terrain_render_ColorSource_h
#define terrain_render_ColorSource_h

#include "Annotations.h"

#include "vtkSmartPointer.h"
#include "vtkTerrainColors.h"

#include <string>

class vtkImageData;
class vtkTerrainActor;
struct Options;

/// Array of heights that has the values of another raster: of points, or of cells where they are
/// classes.
constexpr const char* kColorValues = "Values";

/// Colours, and what they show.
struct ColorSource
{
  vtkSmartPointer<vtkTerrainColors> Colors;
  /// What the values are, with their unit.
  std::string Title;
  /// Whether the values are numbers of classes of Colors.
  bool AreClasses = false;
};

/// Colours a terrain by it, and returns what a legend tells of that.
LegendKey ColorTerrain(vtkTerrainActor* terrain, vtkImageData* heights, const ColorSource& source,
  const Options& options);

#endif
