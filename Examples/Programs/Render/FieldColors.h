// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colours of tracks and polygons by a field of their features.
 */
#ifndef terrain_render_FieldColors_h
#define terrain_render_FieldColors_h

#include "Annotations.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkMapper;
struct FieldOptions;

/// Name of the point array of numbers that a key's table colours.
constexpr const char* kFieldValue = "Value";

/// Turns the texts "Field" of the points of marks (ReadVectorsWithField) into numbers "Value", and
/// returns their key: numbers where all texts are, else classes in the order in which they come;
/// NaN where there is no text. Throws a Failure if there are too many classes to tell apart.
LegendKey ColorByField(
  const std::vector<vtkSmartPointer<vtkPolyData>>& marks, const FieldOptions& options);

/// Lets the values of marks choose their colours, if there is a table.
void ColorByValue(vtkMapper* mapper, vtkScalarsToColors* table);

#endif
