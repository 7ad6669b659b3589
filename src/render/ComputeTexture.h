// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A texture of floats that a compute shader fills ahead of drawing. Private to the module.
 */
#ifndef vtkTerrain_render_ComputeTexture_h
#define vtkTerrain_render_ComputeTexture_h

#include "render/ComputeProgram.h"
#include "render/Features.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace terrain
{
class ComputeTexture
{
public:
  /// Runs a compute shader of kGroupSize x kGroupSize invocations a group, one for each texel of 1
  /// or 4 floats, and makes the texture current for drawing. The source, made when features are
  /// new, has no version line; it writes the image of binding 0, r32f or rgba32f; setUniforms sets
  /// the uniforms. Programs are kept. Returns an empty string, or the compiler's words; once.
  std::string Fill(vtkOpenGLRenderWindow* window, const Features& features,
    const std::function<std::string()>& makeSource, glm::ivec2 size, int components,
    const std::function<void(Uniforms&)>& setUniforms);

  /// True from Fill() to Finish(), if that went well.
  bool IsFilled() const
  {
    return this->Filled;
  }
  /// For the sampler that reads the texture.
  int GetTextureUnit()
  {
    return this->Texture->GetTextureUnit();
  }
  /// The texels of the last Fill(), 4 floats each, row by row from the lowest; empty if there are
  /// none. Their context must be current.
  std::vector<glm::vec4> Read();
  glm::ivec2 GetSize() const
  {
    return this->Size;
  }
  /// Leaves nothing to Read().
  void Forget()
  {
    this->Size = { 0, 0 };
  }
  /// Ends the use of the texture in a drawing.
  void Finish();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Allocate(vtkOpenGLRenderWindow* window, glm::ivec2 size, int components);

  std::vector<std::pair<Features, ComputeProgram>> Programs;
  vtkNew<vtkTextureObject> Texture;
  glm::ivec2 Size{ 0, 0 };
  bool Filled = false;
};
}
#endif
