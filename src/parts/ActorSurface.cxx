// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The surface as a mesh, for all who know no rays: exporters and VTK's pickers.
#include "vtkTerrainActor.h"

#include "data/GlobeData.h"
#include "data/ImageHeights.h"
#include "parts/AssemblyPart.h"
#include "render/SurfaceScope.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainMesh.h"
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainStrips.h"

#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkAssemblyPaths.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkScalarsToColors.h"

#include <cstring>

//------------------------------------------------------------------------------
double vtkTerrainActor::GetUsedSurfaceError()
{
  if (this->SurfaceError >= 0.0)
  {
    return this->SurfaceError;
  }
  this->UpdateInput();
  double range[2];
  this->TerrainMapper->GetHeightRange(range);
  return range[0] <= range[1] ? (range[1] - range[0]) * SurfaceErrorShare : 0.0;
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetSurfaceError(double error)
{
  if (this->SurfaceError != error)
  {
    this->SurfaceError = error;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkActor* vtkTerrainActor::GetSurfaceActor()
{
  this->UpdateInput();
  this->TerrainMapper->GetBounds(); // brings the heights up to date
  this->UpdateColors();
  vtkImageData* heights = this->TerrainMapper->GetHeights();
  if (!terrain::ImageHeights::WhyNotHeights(heights).empty() || terrain::GlobeData::Has(heights))
  {
    return nullptr;
  }
  if (!this->SurfaceActor)
  {
    this->SurfaceMesh = vtkSmartPointer<vtkTerrainMesh>::New();
    this->SurfaceMesh->PassPointArraysOn();
    this->SurfaceMesh->HoldInSinglePrecisionOn(); // exporters write 32 bits
    this->SurfaceMesh->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
    this->SurfaceActor = vtkSmartPointer<vtkActor>::New();
    this->SurfaceActor->SetMapper(vtkSmartPointer<vtkPolyDataMapper>::New());
    this->SurfaceActor->GetMapper()->SetInputConnection(this->SurfaceMesh->GetOutputPort());
    this->SurfaceActor->SetUserMatrix(vtkSmartPointer<vtkMatrix4x4>::New());
  }
  this->SurfaceMesh->SetInputConnection(this->TerrainMapper->GetInputConnection(1, 0));
  this->SurfaceMesh->SetExaggeration(this->GetVerticalExaggeration());
  this->SurfaceMesh->SetMaximumError(this->GetUsedSurfaceError());
  this->UpdateSurfaceLook(heights);
  return this->SurfaceActor;
}

//------------------------------------------------------------------------------
// As far as a mesh can look so: one colour, the texture, or an array in the colours of the table.
void vtkTerrainActor::UpdateSurfaceLook(vtkImageData* heights)
{
  this->SurfaceActor->GetUserMatrix()->DeepCopy(this->GetMatrix());
  this->SurfaceActor->SetProperty(this->GetProperty());
  this->SurfaceActor->SetBackfaceProperty(this->GetBackfaceProperty());
  this->SurfaceActor->SetTexture(this->GetTexture());
  this->SurfaceActor->SetVisibility(this->GetVisibility());
  this->SurfaceActor->SetPickable(this->GetPickable());
  vtkMapper* mapper = this->SurfaceActor->GetMapper();
  const bool ofHeights =
    this->TerrainMapper->GetColorSource() == vtkOpenGLTerrainMapper::ColorSources::Height;
  mapper->SetScalarVisibility(this->TerrainMapper->GetScalarVisibility());
  mapper->SetLookupTable(this->TerrainMapper->GetLookupTable());
  mapper->SetUseLookupTableScalarRange(this->TerrainMapper->GetUseLookupTableScalarRange());
  mapper->SetScalarRange(this->TerrainMapper->GetScalarRange());
  mapper->SetScalarModeToUsePointFieldData();
  const char* named = this->TerrainMapper->GetArrayName();
  const char* name = heights->GetPointData()->GetScalars()->GetName();
  const bool isNamed = !ofHeights && named && *named;
  const int mode = this->TerrainMapper->GetColorMode();
  const bool isHeight = !isNamed || (name && std::strcmp(named, name) == 0);
  mapper->SelectColorArray(isNamed ? named : name);
  mapper->SetColorMode(isHeight && mode == VTK_COLOR_MODE_DEFAULT ? VTK_COLOR_MODE_MAP_SCALARS
                                                                  : mode); // no height is a colour
  mapper->SetArrayComponent(ofHeights ? 0 : this->TerrainMapper->GetArrayComponent());
  mapper->SetClippingPlanes(this->TerrainMapper->GetClippingPlanes());
}

//------------------------------------------------------------------------------
vtkPolyData* vtkTerrainActor::GetSurface()
{
  vtkActor* surface = this->GetSurfaceActor();
  if (!surface)
  {
    return nullptr;
  }
  this->SurfaceMesh->Update();
  return this->SurfaceMesh->GetOutput();
}

//------------------------------------------------------------------------------
// Exporters and pickers ask a prop for its paths and look at the last node of each; what is picked
// is the first.
void vtkTerrainActor::InitPathTraversal()
{
  vtkActor* surface = terrain::SurfaceScope::IsOpen() ? nullptr : this->GetSurfaceActor();
  this->Superclass::InitPathTraversal();
  if (surface)
  {
    vtkNew<vtkAssemblyPath> path;
    vtkNew<vtkMatrix4x4> identity;
    path->AddNode(this, this->GetMatrix());
    path->AddNode(surface, identity);
    this->Paths->RemoveAllItems();
    this->Paths->AddItem(path);
    this->Paths->InitTraversal();
  }
}

//------------------------------------------------------------------------------
// An assembly asks its parts for their paths, and draws and picks the last node of each.
void vtkTerrainActor::BuildPaths(vtkAssemblyPaths* paths, vtkAssemblyPath* path)
{
  if (!this->Part)
  {
    const vtkNew<terrain::AssemblyPart> part;
    part->SetTerrain(this);
    this->Part = part;
  }
  const vtkNew<vtkAssemblyPath> ours;
  ours->ShallowCopy(path); // its last node is this terrain, with the matrix of all that holds it
  ours->AddNode(this->Part, path->GetLastNode()->GetMatrix());
  paths->AddItem(ours);
}
