// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a vtkAssembly has of a terrain that is one of its parts. Private to the module.
 *
 * An assembly asks each part for its paths once, and takes the last prop of each path for all it
 * does: drawing, bounds, picking. So one prop has to be the terrain where it is drawn and its mesh
 * where VTK's pickers look for cells.
 */
#ifndef terrain_parts_AssemblyPart_h
#define terrain_parts_AssemblyPart_h

#include "vtkActor.h"
#include "vtkWeakPointer.h"

class vtkTerrainActor;

namespace terrain
{
/// Draws a terrain with the matrix that an assembly pokes; its mapper is that of the mesh, which is
/// made when a picker asks for cells.
class AssemblyPart : public vtkActor
{
public:
  static AssemblyPart* New();
  vtkTypeMacro(AssemblyPart, vtkActor)

  void SetTerrain(vtkTerrainActor* terrain);
  vtkTerrainActor* GetTerrain();

  vtkTypeBool GetVisibility() override;
  vtkTypeBool GetPickable() override;
  void InitPathTraversal() override;
  void PokeMatrix(vtkMatrix4x4* matrix) override;
  bool GetUseBounds() override;
  double* GetBounds() override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  AssemblyPart(const AssemblyPart&) = delete;
  void operator=(const AssemblyPart&) = delete;

protected:
  AssemblyPart() = default;
  ~AssemblyPart() override = default;

private:
  class BoundedMapper;

  bool TakeSurface();

  vtkWeakPointer<vtkTerrainActor> Terrain;
  bool IsPoked = false; ///< has the matrix of an assembly
};
}
#endif
