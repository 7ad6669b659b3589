// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What vtkOpenGLTerrainMapper derives from its inputs and from the view. Private to the module.
 */
#ifndef vtkTerrainMapperInternals_h
#define vtkTerrainMapperInternals_h

#include "render/Coloring.h"
#include "render/ComputeTexture.h"
#include "render/HeightTexture.h"
#include "vtkOpenGLTerrainMapper.h"

#include "core/rays/PixelRays.h"
#include "core/surface/Cutting.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTextureObject.h"

#include <array>
#include <map>
#include <string>

class vtkShader;

class vtkOpenGLTerrainMapper::vtkInternals
{
public:
  /// What all shaders ask of the driver, where it has it.
  static constexpr const char* Extensions = "#extension GL_ARB_gpu_shader_fp64 : enable\n"
                                            "#extension GL_ARB_texture_gather : enable\n"
                                            "#ifdef GL_ARB_texture_gather\n"
                                            "#define TERRAIN_GATHER\n"
                                            "#endif\n";

  terrain::HeightTexture Heights;
  /// Why the heights cannot be used; empty if they can.
  std::string Why;

  int ShaderBuilds = 0;
  int BufferBuilds = 0;

  /// The far sides of this box stand for the coarse mesh while the eye is within it, and all of it
  /// where there is no mesh.
  vtkNew<vtkPolyData> Box;
  bool EyeInBox = false;
  /// Cells and height codes of the box, corners of the grid with a margin.
  glm::dvec3 BoxMinimumGC{ 0.0 };
  glm::dvec3 BoxMaximumGC{ 0.0 };
  std::array<glm::dvec3, 2> BoxCorners{};

  terrain::PixelRays Rays;
  glm::dmat4 ViewToGrid{ 1.0 };
  glm::dmat4 ViewToModel{ 1.0 };
  /// True if the actor's matrix and the view keep the orientation of triangles.
  bool KeepsOrientation = true;

  terrain::Coloring Coloring;
  /// The proxy with texture coordinates, which VTK's code for textures asks for.
  vtkNew<vtkPolyData> TexturedProxy;
  vtkMTimeType TexturedTime = 0;

  terrain::Cutting Cutting;
  int MaximumLayers = 4;
  /// The layer that is being drawn: surfaces that rays pass by.
  int Layer = 0;
  bool SampleShading = false;

  glm::ivec4 Viewport{ 0 };
  /// Distances at which the rays of tiles of BeamPixels x BeamPixels pixels begin
  /// (shaders/vtkTerrainBeamCS.glsl).
  terrain::ComputeTexture BeamStarts;
  static constexpr int BeamPixels = 8;
  static std::string BeamDefine()
  {
    return "#define TERRAIN_BEAM_PIXELS " + std::to_string(BeamPixels) + "\n";
  }
  /// The sightings of all pixels (shaders/vtkTerrainSightingCS.glsl).
  terrain::ComputeTexture Sightings;

  /// The defines that the shader of each primitive was built with.
  std::map<vtkOpenGLHelper*, std::string> ShaderBuiltWith;
};

/// Substitutes a tag in a shader; says so if the tag is not there.
void vtkTerrainSubstitute(
  vtkObject* self, vtkShader* shader, const std::string& tag, const std::string& text);

#endif
