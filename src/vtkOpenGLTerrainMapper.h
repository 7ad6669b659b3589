// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLTerrainMapper
 * @brief   draws a heightfield below a coarse mesh
 */
#ifndef vtkOpenGLTerrainMapper_h
#define vtkOpenGLTerrainMapper_h

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkTerrainModule.h" // For export macro

class VTKTERRAIN_EXPORT vtkOpenGLTerrainMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkOpenGLTerrainMapper* New();
  vtkTypeMacro(vtkOpenGLTerrainMapper, vtkOpenGLPolyDataMapper)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkOpenGLTerrainMapper(const vtkOpenGLTerrainMapper&) = delete;
  void operator=(const vtkOpenGLTerrainMapper&) = delete;

protected:
  vtkOpenGLTerrainMapper() = default;
  ~vtkOpenGLTerrainMapper() override = default;
};

#endif
