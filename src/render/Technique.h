// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What each technique of vtkTerrainLook needs: rays or a mesh, files of GLSL, uniforms. Private
 * to the module.
 */
#ifndef vtkTerrain_render_Technique_h
#define vtkTerrain_render_Technique_h

#include "core/grid/Coordinates.h"
#include "render/Features.h"
#include "vtkTerrainLook.h"

#include <string>

namespace terrain
{
class SurfaceTextures;
class Uniforms;

class Technique
{
public:
  explicit Technique(vtkTerrainLook::Techniques technique);

  /// How shaders find the surface.
  Features::Ways GetWay() const
  {
    return this->Way;
  }
  /// True if rays are cast, else the polygons of the mapper's port 0 are drawn.
  bool CastsRays() const
  {
    return this->Way != Features::Ways::Mesh;
  }
  /// True if rays meet the patches themselves, also behind the first one; searches step.
  bool IsExact() const
  {
    return this->Way == Features::Ways::Pyramid;
  }

  /// Uniforms of shaders/vtkTerrainSearch.glsl, for a surface and where it is drawn.
  void SetSearchUniforms(Uniforms& uniforms, const vtkTerrainLook* look,
    const SurfaceTextures& surface, const GridGeometry& geometry) const;

  ///@{
  /// The functions of a fragment shader; the sources of the compute shaders that find where beams
  /// start, cast all rays ahead, and look for the lights from where they meet the surface, without
  /// version lines.
  static std::string FragmentFunctions(const Features& features);
  static std::string BeamSource(const Features& features);
  static std::string SightingSource(const Features& features);
  static std::string LightSource(const Features& features);
  ///@}

private:
  Features::Ways Way;
};
}
#endif
