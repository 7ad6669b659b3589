// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A surface with a look as one mapper draws it: what the recipe of vtkOpenGLTerrainMapper works
 * with. Private to the module.
 *
 * Three life times are in it: Surface, Cutting and Proxy follow the inputs, View and Prepass a
 * view, Layer one drawing of it.
 */
#ifndef vtkTerrain_render_Scene_h
#define vtkTerrain_render_Scene_h

#include "core/surface/Cutting.h"
#include "render/Globe.h"
#include "render/Lights.h"
#include "render/Prepass.h"
#include "render/Proxy.h"
#include "render/ShadowBoundsTexture.h"
#include "render/SkyTexture.h"
#include "render/SurfaceTextures.h"
#include "render/Technique.h"
#include "render/View.h"

#include <string>

class vtkActor;
class vtkImageData;
class vtkMapper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTerrainLook;

namespace terrain
{
class Scene
{
public:
  /// Both outlive the scene.
  Scene(vtkMapper* mapper, vtkTerrainLook* look)
    : Mapper(mapper)
    , Look(look)
  {
  }

  ///@{
  /// Update: takes over heights and detail (null for none). False if they cannot be used; Why is
  /// then one sentence that says why, else empty.
  bool Update(vtkImageData* heights, vtkImageData* detail);
  std::string Why;
  ///@}

  /// Bounds of what is drawn, exaggerated, in model coordinates; there must be a surface.
  void GetBounds(double bounds[6]) const;

  /// Prepare: brings what the graphics card holds up to date, the pyramid if rays are
  /// cast, and looks at it through the renderer's camera. Returns an empty string, or what cannot
  /// be drawn; nothing at all if there is a Why.
  std::string Prepare(vtkRenderer* renderer, vtkActor* actor);
  /// Prepare: computes where rays begin, if the look and the driver want that. Returns the
  /// compiler's words, or an empty string.
  std::string PrepareBeams(vtkRenderer* renderer, vtkActor* actor, const Features& features);
  /// Draw: begins a layer: casts its rays ahead, if the look and the driver want that. Returns the
  /// compiler's words, or an empty string.
  std::string BeginLayer(
    int layer, vtkRenderer* renderer, vtkActor* actor, const Features& features);
  void Finish();

  /// Whether a frame waits for all the tiles that it needs; else it shows those that are there.
  bool WaitsForTiles = true;
  /// Pixels by which frames in haste may be off at least.
  double LeastTolerance = 0.0;
  /// Pixels by which the picture may be off: the look's, or the least; tiles need some.
  double GetPixelTolerance() const;
  /// Tiles that the last frame needed, and whether it had them all.
  int GetNumberOfTiles() const
  {
    return static_cast<int>(this->Surface.HasTiles() ? this->Surface.Tiles.GetNumberOfTiles() : 0);
  }
  bool IsComplete() const
  {
    return !this->Surface.HasTiles() || this->Surface.Tiles.IsComplete();
  }

  /// True if an actor shows the surface, not the lines and points of the mapper's port 0.
  bool IsFound(vtkActor* actor) const;
  /// True if lights cast shadows over it.
  bool CastsShadows(vtkActor* actor) const;
  /// True if the sky gives light.
  bool HasSkyLight(vtkActor* actor) const;
  /// True if the technique casts rays for it.
  bool CastsRays(vtkActor* actor) const;
  /// The technique in use.
  Technique GetTechnique() const
  {
    return Technique(this->Look->GetTechnique());
  }
  /// True if textures lie on the surface: the actor's or its property's. The mapper's own texture
  /// of colours is none of them: the surface is painted.
  static bool IsTextured(vtkActor* actor);
  /// Adds what programs have to know of the technique, the surface, the view and the prepass.
  void AddFeatures(Features& features) const;
  /// The uniforms of all programs that have to do with the surface.
  void SetUniforms(Uniforms& uniforms, vtkActor* actor);
  /// The matrices of vertices, which the superclass has set for what is not exaggerated.
  void ExaggerateVertices(Uniforms& uniforms, vtkRenderer* renderer, vtkActor* actor,
    vtkOpenGLVertexBufferObjectGroup* buffers) const;
  void ReleaseGraphicsResources(vtkWindow* window);

  SurfaceTextures Surface;
  terrain::Globe Globe;
  terrain::Cutting Cutting;
  terrain::Proxy Proxy;
  terrain::View View;
  terrain::Lights Lights;
  SkyTexture Sky;
  ShadowBoundsTexture ShadowBounds;
  terrain::Prepass Prepass;

private:
  /// Takes over the globe that heights lie on, if any; Why not.
  std::string UpdateGlobe(vtkImageData* heights, vtkImageData* detail);
  GridGeometry Geometry() const;
  SampleRectangle Drawn() const;
  /// False if there are no bounds of a sun's rays.
  bool UploadShadowBounds(vtkOpenGLRenderWindow* window);
  PrepassFrame MakeFrame(vtkRenderer* renderer, vtkActor* actor, const Features& features);

  vtkMapper* Mapper;
  vtkTerrainLook* Look;
  bool SkyShines = false;
  bool BoundsShadows = false;
  /// Surfaces that rays pass by.
  int Layer = 0;
};
}
#endif
