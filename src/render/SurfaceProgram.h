// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What goes into VTK's program for polygons so that it shows a surface: calls of the functions in
 * shaders/, one method for each concept of VTK's shaders. Private to the module.
 *
 * Every method does what the features given to Begin() ask for, which may be nothing; it says
 * whether it extends VTK's code at a tag, replaces it, or follows it.
 */
#ifndef vtkTerrain_render_SurfaceProgram_h
#define vtkTerrain_render_SurfaceProgram_h

#include "render/Features.h"
#include "render/ProgramGuard.h"

#include "vtkShader.h"

#include <map>
#include <string>

namespace terrain
{
class SurfaceProgram
{
public:
  using Shaders = std::map<vtkShader::Type, vtkShader*>;

  /// Extends: before VTK's code. Our functions stand before main, behind VTK's declarations.
  void Begin(const Features& features, Shaders& shaders);
  /// Replaces: positions in view coordinates are there without lights, too.
  void PlaceVertices(Shaders& shaders);
  /// Extends: finds the point of the surface that the fragment shows.
  void FindSurface(Shaders& shaders);
  /// Replaces: it is the depth of the surface that is shifted.
  void ShiftDepth(Shaders& shaders);
  /// Replaces: the normal is the surface's, not the proxy's; that of a coat as well.
  void ReplaceNormal(Shaders& shaders, bool hasCoat);
  /// Extends: what VTK's lights give is taken away in shadows, and what the sky gives is added.
  void CastShadows(Shaders& shaders);
  /// Follows: of the sky's light in physically based materials. Behind VTK's code.
  void AddSkyLight(Shaders& shaders, bool physicallyBased);
  /// Extends: the colours of VTK's code are painted over where the surface has its own.
  void PaintColors(Shaders& shaders);
  /// Follows: texture coordinates are the surface's. Behind VTK's code.
  void FollowTextures(Shaders& shaders, bool isActorTextured);
  /// Replaces for meshes: planes cut what is exaggerated, not what is in the buffer. Rays are
  /// clipped before they are cast, so that the cut shows what lies behind.
  void ClipMesh(Shaders& shaders);
  /// Replaces: with rays, identifiers are those of the grid's cells, or else of its samples.
  void ReplaceIds(Shaders& shaders, bool ofCells, bool highBits);
  /// Follows, in complete texts: where the code of VTK, of render passes or of a vtkShaderProperty
  /// speaks of the fragment's depth or side, it means the surface's. Returns an empty string, or
  /// why the program does not draw right.
  std::string End(Shaders& shaders);

  /// For complete programs.
  ProgramGuard Guard;

private:
  void FollowSurface(Shaders& shaders);

  terrain::Features Features;
  std::string Problem;
};
}
#endif
