// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Words, numbers and colours in files of text.
 */
#ifndef terrain_ColorText_h
#define terrain_ColorText_h

#include "core/colors/ColorScheme.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace terrain
{
std::string LowerCase(std::string text);

/// Without blanks at both ends.
std::string Trimmed(const std::string& text);

/// A number that is the whole of a text, whatever the locale; none of a magnitude above 1e300,
/// which sums and differences would take to infinity.
std::optional<double> ToNumber(const std::string& text);

/// Words between separators, none of them empty.
std::vector<std::string> Split(const std::string& line, const char* separators);

/// Lines of a text, trimmed.
std::vector<std::string> Lines(const std::string& text);

/// What the numbers of a colour are.
enum class ColorModel
{
  RGB,
  HSV,
  CMYK
};

/// Takes a colour of one word, or of as many numbers as the model has, from words at a position
/// that moves on.
std::optional<Color> TakeColor(
  const std::vector<std::string>& words, std::size_t& at, ColorModel model);

/// Red, green, blue of "#RRGGBB", or of a name that CSS and GMT share ("white", "steelblue", ...).
std::optional<Color> ColorFromName(const std::string& name);
}

#endif
