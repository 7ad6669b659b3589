// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkOpenGLTerrainMapper where it is asked for a part of the terrain.
#include "parts/OpenGLTerrainMapperInternals.h"

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetExtract(const int first[2], const int last[2])
{
  if (first[0] >= last[0] || first[1] >= last[1])
  {
    vtkErrorMacro("An extract must have at least two samples each way");
    return;
  }
  terrain::Cutting& cutting = this->Internals->Scene.Cutting;
  cutting.Extracts = true;
  cutting.First = { first[0], first[1] };
  cutting.Last = { last[0], last[1] };
  this->PictureModified();
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::GetExtract(int first[2], int last[2]) const
{
  const terrain::Cutting& cutting = this->Internals->Scene.Cutting;
  for (int axis = 0; cutting.Extracts && axis < 2; ++axis)
  {
    first[axis] = cutting.First[axis];
    last[axis] = cutting.Last[axis];
  }
  return cutting.Extracts;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ExtractAll()
{
  this->Internals->Scene.Cutting.Extracts = false;
  this->PictureModified();
}
