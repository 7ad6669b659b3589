// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is drawn over the terrain: scale bar, north arrow, legend.
 */
#ifndef terrain_render_Annotations_h
#define terrain_render_Annotations_h

#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkRenderer;
struct Options;
struct PlacedHeights;

/// A class of values: its name, its colour from 0 to 1, how many values belong to it.
struct LegendClass
{
  std::string Name;
  std::array<double, 3> Color{};
  vtkIdType Count = 0;
};

/// What a legend tells: classes if there are any, else the colours of a table.
struct LegendKey
{
  std::string Title;
  vtkSmartPointer<vtkScalarsToColors> Table;
  std::vector<LegendClass> Classes;
};

/// Adds scale bar and north arrow, as they are right at the focal point of the renderer's camera.
void AddOverlay(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options);

/// Adds keys to colours beside the picture's right border, the first on top. Returns the pixels
/// from there that they take.
double AddLegends(
  vtkRenderer* renderer, const std::vector<LegendKey>& keys, const Options& options);

/// 1, 2 or 5 times a power of ten, not less than a number above 0.
double RoundUp(double least);

/// The multiples of a step > 0 between two numbers, or off by a rounding; once each where the step
/// is too small to tell them apart. O((highest - lowest) / step).
std::vector<double> Multiples(double step, double lowest, double highest);

/// A number that is a multiple of a round step, with commas between thousands: "1,500", "0.25".
std::string GroupedNumber(double number, double step);

#endif
