// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parts/AssemblyPart.h"

#include "data/GlobeData.h"
#include "render/SurfaceScope.h"
#include "vtkTerrainActor.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace terrain
{
vtkStandardNewMacro(AssemblyPart);

namespace
{
/// While one lives, a terrain has the matrix of an assembly's part.
class Poke
{
public:
  Poke(vtkTerrainActor* terrain, vtkMatrix4x4* matrix)
    : Terrain(terrain)
  {
    this->Terrain->PokeMatrix(matrix);
  }
  ~Poke()
  {
    this->Terrain->PokeMatrix(nullptr);
  }
  Poke(const Poke&) = delete;
  Poke& operator=(const Poke&) = delete;

private:
  vtkTerrainActor* Terrain;
};
}

//------------------------------------------------------------------------------
/// The mesh, made with its bounds, as pickers of cells expect; vtkTerrainPicker needs none.
class AssemblyPart::BoundedMapper : public vtkPolyDataMapper
{
public:
  static BoundedMapper* New();
  vtkTypeMacro(BoundedMapper, vtkPolyDataMapper)

  double* GetBounds() override
  {
    return this->Terrain && SurfaceScope::IsOpen() ? this->Terrain->GetTerrainMapper()->GetBounds()
                                                   : this->Superclass::GetBounds();
  }
  void GetBounds(double bounds[6]) override
  {
    const double* found = this->GetBounds();
    std::copy(found, found + 6, bounds);
  }

  vtkWeakPointer<vtkTerrainActor> Terrain;
};
vtkStandardNewMacro(AssemblyPart::BoundedMapper);

//------------------------------------------------------------------------------
void AssemblyPart::SetTerrain(vtkTerrainActor* terrain)
{
  this->Terrain = terrain;
  const vtkNew<BoundedMapper> mapper;
  mapper->Terrain = terrain;
  this->SetMapper(mapper);
}

//------------------------------------------------------------------------------
vtkTerrainActor* AssemblyPart::GetTerrain()
{
  return this->Terrain;
}

//------------------------------------------------------------------------------
// The mesh looks as the surface's own actor does; it is not made by that.
bool AssemblyPart::TakeSurface()
{
  vtkActor* surface = this->Terrain ? this->Terrain->GetSurfaceActor() : nullptr;
  if (surface)
  {
    this->GetMapper()->ShallowCopy(surface->GetMapper());
    this->SetProperty(surface->GetProperty());
    this->SetBackfaceProperty(surface->GetBackfaceProperty());
    this->SetTexture(surface->GetTexture());
    if (!this->IsPoked)
    {
      if (!this->GetUserMatrix())
      {
        this->SetUserMatrix(vtkSmartPointer<vtkMatrix4x4>::New());
      }
      const double* matrix = surface->GetMatrix()->GetData();
      if (!std::equal(matrix, matrix + 16, this->GetUserMatrix()->GetData()))
      {
        this->GetUserMatrix()->DeepCopy(matrix); // a change makes the assembly ask for paths again
      }
    }
  }
  return surface != nullptr;
}

//------------------------------------------------------------------------------
// Assemblies and exporters ask this before they look at anything else, pickers the next.
vtkTypeBool AssemblyPart::GetVisibility()
{
  const SurfaceScope scope; // no picture is made for a frame
  this->TakeSurface();
  return this->Terrain && this->Terrain->GetVisibility();
}

//------------------------------------------------------------------------------
vtkTypeBool AssemblyPart::GetPickable()
{
  // a globe has no mesh, and the picker of this module asks for none
  const bool isFound = this->TakeSurface() ||
    (SurfaceScope::IsOpen() && this->Terrain && GlobeData::Has(this->Terrain->GetHeights()));
  return isFound && this->Terrain->GetPickable();
}

//------------------------------------------------------------------------------
void AssemblyPart::PokeMatrix(vtkMatrix4x4* matrix)
{
  this->IsPoked = matrix != nullptr;
  this->Superclass::PokeMatrix(matrix);
}

//------------------------------------------------------------------------------
void AssemblyPart::InitPathTraversal()
{
  this->TakeSurface();
  this->Superclass::InitPathTraversal();
}

//------------------------------------------------------------------------------
bool AssemblyPart::GetUseBounds()
{
  return this->Terrain && this->Terrain->GetUseBounds();
}

//------------------------------------------------------------------------------
double* AssemblyPart::GetBounds()
{
  if (this->Terrain)
  {
    const Poke poke(this->Terrain, this->GetMatrix());
    this->Terrain->GetBounds(this->Bounds);
  }
  return this->Bounds;
}

//------------------------------------------------------------------------------
int AssemblyPart::RenderOpaqueGeometry(vtkViewport* viewport)
{
  if (!this->Terrain)
  {
    return 0;
  }
  const Poke poke(this->Terrain, this->GetMatrix());
  this->Terrain->SetAllocatedRenderTime(this->AllocatedRenderTime, viewport);
  return this->Terrain->RenderOpaqueGeometry(viewport);
}

//------------------------------------------------------------------------------
int AssemblyPart::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  if (!this->Terrain)
  {
    return 0;
  }
  const Poke poke(this->Terrain, this->GetMatrix());
  this->Terrain->SetAllocatedRenderTime(this->AllocatedRenderTime, viewport);
  return this->Terrain->RenderTranslucentPolygonalGeometry(viewport);
}

//------------------------------------------------------------------------------
vtkTypeBool AssemblyPart::HasTranslucentPolygonalGeometry()
{
  return this->Terrain && this->Terrain->HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
void AssemblyPart::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Terrain)
  {
    this->Terrain->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
}
