// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Names and heights of places.
 */
#ifndef terrain_render_Labels_h
#define terrain_render_Labels_h

#include <array>
#include <optional>
#include <string>
#include <vector>

struct Options;
struct PlacedHeights;

/// A text at a point of the ground, in the scene.
struct Label
{
  std::string Text;
  std::array<double, 3> Point{};
};

/**
 * Labels of a file of points (MarkOptions::Labels), in its order. A name is that of the field
 * `name`, `label` or `title`, else of the first field with text; a field `height`, `ele` or
 * `elevation` with a number follows it, in metres. Of lines and areas the middle of their box is
 * taken. Places beside the terrain are left out, with a warning, as is what has no name or no
 * numbers for coordinates, with the line of the first one. Throws a Failure: no file, no points, no
 * names, no place on the terrain, a name that is not UTF-8.
 */
std::vector<Label> ReadLabels(const std::string& path, const PlacedHeights& heights);

/// Heights of the most prominent summits, as labels; those that a plane of water covers, at a
/// height in metres, are left out, and the next ones take their places.
std::vector<Label> FindPeakLabels(
  int count, const PlacedHeights& heights, std::optional<double> water);

#endif
