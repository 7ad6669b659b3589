// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The surface as a mesh, for all who know no rays: exporters and VTK's pickers.
#include "vtkTerrainActor.h"

#include "data/GlobeData.h"
#include "data/ImageHeights.h"
#include "parts/AssemblyPart.h"
#include "parts/DrapePicture.h"
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
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
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
  this->CutSurface();
  this->UpdateSurfaceLook(heights);
  return this->SurfaceActor;
}

//------------------------------------------------------------------------------
// As rays are cut: by the extract, and by the sides and the floor of a block.
void vtkTerrainActor::CutSurface()
{
  std::array<int, 2> first{};
  std::array<int, 2> last{};
  if (this->TerrainMapper->GetExtract(first.data(), last.data()))
  {
    this->SurfaceMesh->SetExtract(first.data(), last.data());
  }
  else
  {
    this->SurfaceMesh->ExtractAll();
  }
  std::array<double, 2> range{};
  this->TerrainMapper->GetHeightRange(range.data());
  const double base = this->TerrainMapper->GetBlockBase();
  this->SurfaceMesh->WallsOfHolesOff();
  this->SurfaceMesh->SetBlock(this->TerrainMapper->GetBlock() && base < range[0] &&
    this->GetTechnique() == Techniques::Pyramid);
  this->SurfaceMesh->SetBlockBase(base);
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
  using Sources = vtkOpenGLTerrainMapper::ColorSources;
  const Sources source = this->TerrainMapper->GetColorSource();
  const bool ofHeights = source == Sources::Height;
  const bool ofSlopes = source == Sources::Slope || source == Sources::Aspect;
  this->SurfaceMesh->SetComputeSlopes(ofSlopes);
  mapper->SetScalarVisibility(this->TerrainMapper->GetScalarVisibility());
  vtkScalarsToColors* table = this->TerrainMapper->GetLookupTable();
  mapper->SetLookupTable(table);
  mapper->SetUseLookupTableScalarRange(this->TerrainMapper->GetUseLookupTableScalarRange());
  mapper->SetScalarRange(table->GetRange()); // some exporters give the table that of the mapper
  mapper->SetScalarModeToUsePointFieldData();
  const char* named = this->TerrainMapper->GetArrayName();
  const char* name = heights->GetPointData()->GetScalars()->GetName();
  const bool isNamed = !ofHeights && !ofSlopes && named && *named;
  const int mode = this->TerrainMapper->GetColorMode();
  const bool isHeight = !isNamed || (name && std::strcmp(named, name) == 0);
  mapper->SelectColorArray(ofSlopes ? (source == Sources::Slope ? "Slope" : "Aspect")
      : isNamed                     ? named
                                    : name);
  mapper->SetColorMode(isHeight && mode == VTK_COLOR_MODE_DEFAULT ? VTK_COLOR_MODE_MAP_SCALARS
                                                                  : mode); // no height is a colour
  mapper->SetArrayComponent(ofHeights || ofSlopes ? 0 : this->TerrainMapper->GetArrayComponent());
  mapper->SetClippingPlanes(this->TerrainMapper->GetClippingPlanes());
  this->UpdateSurfacePicture(heights);
}

//------------------------------------------------------------------------------
// A draped picture is the mesh's texture, in its own colours.
void vtkTerrainActor::UpdateSurfacePicture(vtkImageData* heights)
{
  vtkImageData* drape = this->TerrainMapper->GetDrape();
  if (!drape || drape->GetNumberOfPoints() == 0)
  {
    this->SurfacePicture = nullptr;
    this->SurfaceMesh->SetTextureBounds(0.0, 0.0, 0.0, 0.0);
    return;
  }
  vtkMapper* mapper = this->SurfaceActor->GetMapper();
  vtkScalarsToColors* table = mapper->GetLookupTable();
  const vtkMTimeType time = std::max({ drape->GetMTime(), heights->GetMTime(), table->GetMTime(),
    this->TerrainMapper->GetLookTime(), this->TerrainMapper->GetMTime() });
  if (!this->SurfacePicture || this->SurfacePictureTime != time)
  {
    if (terrain::SurfaceScope::IsOpen())
    {
      return; // an assembly asks for the look with each frame
    }
    std::array<double, 4> bounds{};
    this->TerrainMapper->GetLook()->GetDrapeBounds(bounds.data());
    const char* name = mapper->GetArrayName();
    vtkDataArray* values = name ? heights->GetPointData()->GetArray(name) : nullptr;
    vtkSmartPointer<vtkUnsignedCharArray> colors;
    if (values && mapper->GetScalarVisibility())
    {
      colors.TakeReference(
        table->MapScalars(values, mapper->GetColorMode(), mapper->GetArrayComponent()));
    }
    const auto picture = terrain::MakeDrapePicture(drape, bounds, heights, colors);
    if (!picture)
    {
      return; // the mapper says so where it draws
    }
    this->SurfacePictureTime = time;
    this->SurfacePicture = vtkSmartPointer<vtkTexture>::New();
    this->SurfacePicture->SetInputData(picture);
    this->SurfacePicture->InterpolateOn();
    this->SurfacePicture->RepeatOff();
  }
  const std::array<double, 4> bounds = terrain::FindSampleBounds(heights);
  this->SurfaceMesh->SetTextureBounds(bounds[0], bounds[1], bounds[2], bounds[3]);
  this->SurfaceActor->SetTexture(this->SurfacePicture);
  mapper->ScalarVisibilityOff();
  const vtkNew<vtkProperty> white;
  white->DeepCopy(this->GetProperty());
  white->SetColor(1.0, 1.0, 1.0); // which the picture is multiplied with
  this->SurfaceActor->SetProperty(white);
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
