// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What colours are made from: constants that shaders/vtkTerrainColor.glsl shares.
 */
#ifndef terrain_PaintKinds_h
#define terrain_PaintKinds_h

namespace terrain
{
/// What the colour of a place is made from; terrainOf... in shaders/vtkTerrainColor.glsl.
enum class PaintKinds
{
  Material,
  Height,
  Slope,
  Aspect,
  Values,
  Colors,
  Crossings
};
/// Texels of the colour map.
constexpr int kColorMapSize = 4096;
/// In textures of values, for what is no number.
constexpr float kNotANumber = -3e38f;
}

#endif
