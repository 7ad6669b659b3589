// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * OpenGL's names through the loader that VTK was built with; who draws, and which of two ways that
 * give the same picture is the faster one there. Private to the module.
 */
#ifndef vtkTerrain_render_Driver_h
#define vtkTerrain_render_Driver_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h" // IWYU pragma: export
#else
#include "vtk_glew.h" // IWYU pragma: export
#endif

#include <cstring>
#include <string>

namespace terrain
{
/// True if the current context draws on the processor, with Mesa's llvmpipe or softpipe. The latter
/// fetches texels of all pixels of a square of four from the level that the first one asks for
/// (sp_get_texels of Mesa 22.3): where levels differ by pixel they must be in a buffer.
inline bool IsSoftware()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return renderer && (std::strstr(renderer, "llvmpipe") || std::strstr(renderer, "softpipe"));
}

/// Switches a capability on that vtkOpenGLState does not keep, and back to what it was.
class ScopedCapability
{
public:
  ScopedCapability(GLenum capability, bool on)
    : Capability(capability)
    , Switches(on && glIsEnabled(capability) == GL_FALSE)
  {
    if (this->Switches)
    {
      glEnable(capability);
    }
  }
  ScopedCapability(const ScopedCapability&) = delete;
  void operator=(const ScopedCapability&) = delete;
  ~ScopedCapability()
  {
    if (this->Switches)
    {
      glDisable(this->Capability);
    }
  }

private:
  GLenum Capability;
  bool Switches;
};

/// Runs the fragment shader for each sample, and as before afterwards.
class ScopedSampleShading
{
public:
  explicit ScopedSampleShading(bool on)
    : Capability(GL_SAMPLE_SHADING, on)
    , On(on)
  {
    if (on)
    {
      glGetFloatv(GL_MIN_SAMPLE_SHADING_VALUE, &this->Least);
      glMinSampleShading(1.0f);
    }
  }
  ScopedSampleShading(const ScopedSampleShading&) = delete;
  void operator=(const ScopedSampleShading&) = delete;
  ~ScopedSampleShading()
  {
    if (this->On)
    {
      glMinSampleShading(this->Least);
    }
  }

private:
  ScopedCapability Capability;
  bool On;
  float Least = 0.0f;
};

/// The ways that a driver is drawn with.
struct Driver
{
  /// The pyramid is a buffer, not a texture with mip levels (PyramidTexture.h).
  bool BuffersPyramid = false;
  /// Uniforms of the fragment shader are passed by the vertex shader (UniformPasser.h).
  bool PassesUniforms = false;
  /// Rays are cast in a compute shader, where the look leaves it open (vtkTerrainLook).
  bool ComputesSightings = true;
  /// The four samples of a cell are read by one textureGather(), where the driver has it.
  bool Gathers = true;
  /// Largest anisotropy of the filter of drapes.
  float Anisotropy = 16.0f;

  /// Of llvmpipe: it finds a mip level for each pixel by itself, in some 150 instructions, and
  /// reads a uniform in 25 and a flat input in two; its filter (Mesa 22) takes wrong texels with
  /// explicit gradients.
  static Driver Software();

  /// Of the current context, changed by the environment's VTKTERRAIN_DRIVER: words with commas
  /// between them, applied from left to right, so that tests run the ways of a graphics card on
  /// llvmpipe. "software" and "graphics" choose all; one alone: "buffer" or "levels", "passed" or
  /// "plain", "fragment" or "compute", "gather" or "fetch", "isotropic" or "anisotropic". The
  /// variable is read again where it has changed; another word is one warning.
  static Driver Current();

  /// Applies such words; returns the first that is none of them, or an empty string.
  std::string Apply(const std::string& words);
};
}
#endif
