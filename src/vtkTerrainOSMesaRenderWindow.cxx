// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainOSMesaRenderWindow.h"

#include "windows/GLContext.h"

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
std::unique_ptr<terrain::GLContext> vtkTerrainOSMesaRenderWindow::CreateContext(std::string& whyNot)
{
  return terrain::MakeOSMesaContext(whyNot);
}
