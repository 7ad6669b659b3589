// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What compute shaders find out of a view ahead of drawing it: where the rays of tiles of pixels
 * may begin, and what all rays see. Private to the module.
 */
#ifndef vtkTerrain_render_Prepass_h
#define vtkTerrain_render_Prepass_h

#include "render/ComputeTexture.h"
#include "render/Features.h"

#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <functional>
#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkWindow;

namespace terrain
{
class SurfaceTextures;
class Uniforms;

/// A view that is about to be drawn: by a program of these features, with these uniforms.
struct PrepassFrame
{
  vtkOpenGLRenderWindow* Window = nullptr;
  glm::ivec2 Size{ 0 };
  terrain::Features Features;
  std::function<void(Uniforms&)> SetUniforms;
};

class Prepass
{
public:
  ///@{
  /// Computes the starts of beams, the sightings of a layer; current until Finish(). Sightings use
  /// the beams that are there. Returns an empty string, or the compiler's words.
  std::string ComputeBeams(const PrepassFrame& frame);
  std::string ComputeSightings(const PrepassFrame& frame);
  ///@}
  /// Computes the lights that the points of the layer's sightings see, which must be there.
  std::string ComputeLights(const PrepassFrame& frame);
  /// Ends the use of sightings and their lights, and leaves none to be read.
  void ForgetLayer();
  void Finish();

  /// Adds what the program that draws has to know of what has been computed.
  void AddFeatures(Features& features) const;
  void SetUniforms(Uniforms& uniforms, const SurfaceTextures& surface);

  /// The work of all rays, an image of int; null without sightings.
  vtkSmartPointer<vtkImageData> ReadCrossings();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  ComputeTexture BeamStarts;
  ComputeTexture Sightings;
  ComputeTexture LightShares;
};
}
#endif
