// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the files of vtkOpenGLTerrainMapper share. Private to the module.
 */
#ifndef vtkTerrain_parts_OpenGLTerrainMapperInternals_h
#define vtkTerrain_parts_OpenGLTerrainMapperInternals_h

#include "vtkOpenGLTerrainMapper.h"

#include "render/Features.h"
#include "render/Scene.h"
#include "render/SurfaceProgram.h"

#include "vtkOpenGLHelper.h"

#include <map>

/// What is drawn, and what has been made for it.
class vtkOpenGLTerrainMapper::vtkInternals
{
public:
  vtkInternals(vtkOpenGLTerrainMapper* self)
    : Scene(self, self->Look)
  {
  }

  terrain::Scene Scene;
  terrain::SurfaceProgram Program;
  /// What the program of each primitive was built for.
  std::map<vtkOpenGLHelper*, terrain::Features> BuiltFor;
  int ShaderBuilds = 0;
  int BufferBuilds = 0;
};

#endif
