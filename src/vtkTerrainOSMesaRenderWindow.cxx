// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainOSMesaRenderWindow.h"

#include "vtkTerrainGLContext.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTerrainOSMesaRenderWindow);

//------------------------------------------------------------------------------
vtkTerrainOSMesaRenderWindow::~vtkTerrainOSMesaRenderWindow()
{
  this->Close();
}

//------------------------------------------------------------------------------
void vtkTerrainOSMesaRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkTerrainGLContext> vtkTerrainOSMesaRenderWindow::CreateContext(
  std::string& whyNot)
{
  return vtkTerrainMakeOSMesaContext(whyNot);
}
