// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Polygons filled in a picture.
 */
#ifndef terrain_render_PolygonFill_h
#define terrain_render_PolygonFill_h

#include <array>
#include <vector>

class vtkImageData;

/// Closed lines: x and y of their points, the first one again at the end or not.
using PlaneRings = std::vector<std::vector<std::array<double, 2>>>;

/// Fills what an odd number of rings encloses, over a picture: W x H x 1 points of four unsigned
/// chars, RGBA, pixel centres at origin + index * spacing, spacing > 0. Pixels that a border
/// crosses are filled by their covered part, from four lines a pixel. Color: red, green, blue,
/// opacity, 0 to 1.
void FillRings(vtkImageData* picture, const PlaneRings& rings, const std::array<double, 4>& color);

#endif
