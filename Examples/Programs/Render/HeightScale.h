// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A ruler of heights at a corner of the terrain.
 */
#ifndef terrain_render_HeightScale_h
#define terrain_render_HeightScale_h

#include <array>

class LabelPlacer;
class vtkRenderer;
struct Options;

/// A box of the scene, and the heights in metres that its lowest and highest z stand for.
struct ScaledBox
{
  std::array<double, 6> Bounds{};
  std::array<double, 2> Heights{};
};

/// Adds a ruler with round numbers along the vertical edge of a box that is farthest to the left in
/// the picture. False if that is not in the picture.
bool AddHeightScale(
  vtkRenderer* renderer, LabelPlacer& placer, const ScaledBox& box, const Options& options);

#endif
