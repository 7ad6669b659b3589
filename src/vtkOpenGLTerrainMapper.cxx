// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLTerrainMapper.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOpenGLTerrainMapper);

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
