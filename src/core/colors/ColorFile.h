// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colour files that are plain text.
 */
#ifndef terrain_ColorFile_h
#define terrain_ColorFile_h

#include "core/colors/ColorScheme.h"

#include <string>

namespace terrain
{
/// A scheme, or why there is none: one sentence without the file's name, with the line's number.
struct ColorFileResult
{
  ColorScheme Scheme;
  std::string WhyNot;
};

/// GMT's colour palette table (.cpt): slices "z0 colour z1 colour", classes "key colour ;name", B,
/// F and N, colours as r g b, r/g/b, h-s-v, c/m/y/k, #RRGGBB, a grey, or a name; COLOR_MODEL = RGB,
/// HSV or CMYK. A palette that says that it is normalized (RANGE, or 0 to 1 with a HINGE) still has
/// the values that it lists. Source: GMT 6 Technical Reference, "CPTs".
ColorFileResult ReadColorPaletteTable(const std::string& text);

/// gdaldem's colour text: "value red green blue [alpha]" or "value name", divided by blanks, tabs,
/// commas or colons; "nv" is the colour of no data; "10%" is a share of the range, so that all
/// values must be. Lines may come in any order. Source: gdaldem(1), color-relief.
ColorFileResult ReadColorReliefText(const std::string& text);

/// A colour map as QGIS exports it (INTERPOLATION:INTERPOLATED, DISCRETE or EXACT, then "value,
/// red, green, blue, alpha, name"), or ESRI's .clr ("value red green blue" classes). DISCRETE: a
/// colour holds up to its value, inclusive in QGIS; here a value that ends a class has the next
/// one's colour.
ColorFileResult ReadColorMapText(const std::string& text);

/// A table of classes, of comma-separated values: "value,colour,name" a line, in this order or in
/// that of a first line that names these columns; ';' and tabs divide too, and text in quotes is
/// one field. Colours as in a palette table, also "r g b". The nearest class counts for values
/// between two.
ColorFileResult ReadClassTable(const std::string& text);

/// True if an infinite value, which ends a last class, is not there twice, nor where colours hold
/// at a value (EXACT).
bool HasLastOnly(const std::vector<ColorStop>& table, bool isExact);

/// Stops of a table whose colours hold up to a value (DISCRETE) or at a value (EXACT), in the way
/// of a ColorScheme. values ascend; the last may be infinite.
std::vector<ColorStop> DiscreteStops(const std::vector<ColorStop>& table);
std::vector<ColorStop> ExactStops(const std::vector<ColorStop>& table);

/// Moves the names of classes that hold up to a value to where each begins.
void BeginClasses(std::vector<ColorScheme::ClassName>& classes);
}

#endif
