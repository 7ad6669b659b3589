// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The globe that heights lie on, if their field data say so (data/GlobeData.h), as one view sees
 * it: the lines of its grid about an anchor, for shaders/vtkTerrainGlobeLines.glsl. Private to the
 * module.
 */
#ifndef vtkTerrain_render_Globe_h
#define vtkTerrain_render_Globe_h

#include "core/globe/GlobeLines.h"
#include "core/grid/HeightCodes.h"
#include "render/View.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <string>

class vtkActor;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkWindow;

namespace terrain
{
class Uniforms;

class Globe
{
public:
  /// Takes over the grid of an image of heights, if it is a globe's and has changed since the last
  /// call. Empty, or one sentence that says why it cannot be used.
  std::string SetImage(vtkImageData* image);
  /// How often a grid was taken over.
  int GetNumberOfScans() const
  {
    return this->NumberOfScans;
  }
  bool IsRound() const
  {
    return this->Grid != nullptr;
  }

  /// Takes over how heights are drawn.
  void SetHeights(const HeightCodes& codes, double exaggeration);
  /// A box about the surface, in model coordinates.
  BoxGC GetBounds() const;

  /// Chooses the anchor of a view and uploads the lines about it; false if that failed.
  bool Update(vtkRenderer* renderer, vtkActor* actor);
  /// Matrix from the axes of the anchor, metres, to model coordinates.
  glm::dmat4 ModelFromAnchor() const;
  /// A box about that box, in the axes of the anchor.
  BoxGC GetAnchoredBounds() const;

  void Activate();
  void Deactivate();
  void SetUniforms(Uniforms& uniforms);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Upload(vtkOpenGLRenderWindow* window);

  vtkWeakPointer<vtkImageData> Image;
  vtkMTimeType ImageTime = 0;
  std::string WhyNot;
  int NumberOfScans = 0;
  std::unique_ptr<GlobeGrid> Grid;
  std::vector<glm::dvec4> Curves;
  GlobeRange Range;
  double Base = 0.0;
  double Scale = 1.0;
  double TrueScale = 1.0;
  double MaximumCode = 0.0;
  GlobeAnchor Anchor;
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLBufferObject> Buffer;
};
}
#endif
