// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a shader of a terrain is built for: one value makes its defines, and tells whether another
 * program is needed. And the constants that GLSL shares with C++. Private to the module.
 */
#ifndef vtkTerrain_render_Features_h
#define vtkTerrain_render_Features_h

#include "core/rays/PaintKinds.h"

#include <string>
#include <tuple>

namespace terrain
{
/// Invocations of a compute shader's group, each way.
constexpr int kGroupSize = 8;
/// Side of the tiles of pixels whose rays begin at a common start.
constexpr int kBeamPixels = 8;
/// Most lights that cast shadows; those of VTK's shaders with a higher number cast none.
constexpr int kMostShadows = 8;
/// Steps of a light's share in a texel, two to a float: 2^24 is its last whole number.
constexpr int kShareSteps = 4096;

struct Features
{
  /// How the surface is found: not at all, as in VTK's own program; below the polygons of a mesh;
  /// by rays.
  enum class Ways
  {
    None,
    Mesh,
    Linear,
    Exponential,
    Equidistant,
    Pyramid
  };
  Ways Way = Ways::None;
  bool IntegerHeights = false; ///< texels are 16-bit integers, else floats
  bool BuffersPyramid = false; ///< the pyramid is a buffer, else a texture with mip levels
  bool Gathers = false;        ///< textureGather() is used where the driver has it
  bool Globe = false;          ///< heights are in longitude and latitude on an ellipsoid
  bool Tiles = false;          ///< heights are in tiles of several levels
  bool Detail = false;         ///< the heights are a sum with repeated detail
  bool Columns = false;        ///< columns of constant height, else bilinear patches
  bool Within = false;         ///< a pixel tolerance ends searches
  bool Block = false;          ///< clipping planes cut a block
  bool BelowBox = false;       ///< rays begin at the box, else at the near plane
  bool ReadsSightings = false; ///< a compute shader has cast the rays
  bool ShiftsDepth = false;    ///< coincident topology moves depths
  bool Textured = false;       ///< textures of VTK
  bool Paints = false;         ///< the surface has, or has had, colours of its own
  int ClipPlanes = 0;          ///< most clipping planes
  int BeamPixels = 0;          ///< kBeamPixels if starts of tiles are known
  int DrapeComponents = 0;     ///< of the draped picture
  int ShadowMask = 0;          ///< bit i: VTK's light i casts shadows; see kMostShadows
  bool Sky = false;            ///< the sky gives light
  bool BoundsShadows = false;  ///< there are bounds of the rays of one light
  bool ReadsLights = false;    ///< a compute shader has looked for the lights
  bool PassesUniforms = false; ///< the vertex shader passes uniforms; without a line in Defines()

  bool FindsSurface() const
  {
    return this->Way != Ways::None;
  }
  bool CastsRays() const
  {
    return this->Way > Ways::Mesh;
  }
  /// How many lights cast shadows.
  int Shadows() const;
  bool operator==(const Features& other) const;
  bool operator!=(const Features& other) const
  {
    return !(*this == other);
  }

  /// Lines that enable extensions, then one #define line for each feature but PassesUniforms, which
  /// changes the text in another way (UniformPasser.h).
  std::string Defines() const;
  /// The #define lines of the constants: the same for all features.
  static std::string Constants();
};

/// References to every member of features, in a tuple: the key by which programs are told apart.
/// The names are written once. With a member more or less than names it does not compile.
template <typename SomeFeatures>
auto MembersOf(SomeFeatures& features)
{
#define TERRAIN_FEATURES                                                                           \
  way, integerHeights, buffersPyramid, gathers, globe, tiles, detail, columns, within, block,      \
    belowBox, readsSightings, shiftsDepth, textured, paints, clipPlanes, beamPixels,               \
    drapeComponents, shadowMask, sky, boundsShadows, readsLights, passesUniforms
  auto& [TERRAIN_FEATURES] = features;
  return std::tie(TERRAIN_FEATURES);
#undef TERRAIN_FEATURES
}
}
#endif
