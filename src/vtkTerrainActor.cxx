// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainActor.h"

#include "core/grid/Coordinates.h"
#include "data/GlobeData.h"
#include "data/HierarchyData.h"
#include "data/ImageHeights.h"
#include "data/Setting.h"
#include "render/ModelCamera.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainColors.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainMesh.h" // For the destructor of a member
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainStrips.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTexture.h" // For the destructor of a member

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

vtkStandardNewMacro(vtkTerrainActor);

namespace
{
/// True if some cell has a surface. Cost: up to the first such cell.
template <typename T>
bool HoldsSurface(const terrain::HeightfieldView<T>& view)
{
  for (std::int64_t j = 0; j + 1 < view.Height; ++j)
  {
    for (std::int64_t i = 0; i + 1 < view.Width; ++i)
    {
      if (view.IsCellValid(i, j))
      {
        return true;
      }
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
vtkTerrainActor::vtkTerrainActor()
  : TerrainMapper(vtkSmartPointer<vtkOpenGLTerrainMapper>::New())
  , CoarseMesh(vtkSmartPointer<vtkTerrainCoarseMesh>::New())
  , FullMesh(vtkSmartPointer<vtkTerrainCoarseMesh>::New())
  , Strips(vtkSmartPointer<vtkTerrainStrips>::New())
  , ReliefColors(vtkSmartPointer<vtkColorTransferFunction>::New())
{
  this->FullMesh->SetCellsPerQuad(1);
  this->FullMesh->PushUpOff();
  this->SetMapper(this->TerrainMapper);
  this->GetProperty()->SetAmbient(0.0);
  this->GetProperty()->SetDiffuse(1.0);
  this->GetProperty()->SetSpecular(0.0);
}

//------------------------------------------------------------------------------
vtkTerrainActor::~vtkTerrainActor() = default;

//------------------------------------------------------------------------------
void vtkTerrainActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TerrainMapper: " << this->TerrainMapper << "\n";
  os << indent << "CoarseMesh: " << this->CoarseMesh << "\n";
  os << indent << "Technique: " << static_cast<int>(this->GetTechnique()) << "\n";
  os << indent << "Strips: " << this->Strips << "\n";
  os << indent << "Hierarchy: " << this->GetHierarchy() << "\n";
  os << indent << "VerticalExaggeration: " << this->GetVerticalExaggeration() << "\n";
  os << indent << "ColorByHeight: " << this->ColorByHeight << "\n";
  os << indent << "SurfaceError: " << this->SurfaceError << "\n";
  os << indent << "LevelOfDetail: " << this->LevelOfDetail << "\n";
  os << indent << "LookupTable: " << this->LookupTable << "\n";
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetInputConnection(vtkAlgorithmOutput* heights)
{
  this->PreparedReader = nullptr;
  this->TerrainMapper->SetHeightsConnection(heights);
  this->TerrainMapper->SetTileSource(nullptr); // those of other heights
  this->CoarseMesh->SetInputConnection(heights);
  this->FullMesh->SetInputConnection(heights);
  this->Strips->SetInputConnection(heights);
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetInputData(vtkImageData* heights)
{
  this->PreparedReader = nullptr;
  this->TerrainMapper->SetHeightsData(heights);
  this->TerrainMapper->SetTileSource(nullptr); // those of other heights
  this->CoarseMesh->SetInputData(heights);
  this->FullMesh->SetInputData(heights);
  this->Strips->SetInputData(heights);
}

//------------------------------------------------------------------------------
vtkImageData* vtkTerrainActor::GetHeights()
{
  return this->TerrainMapper->GetHeights();
}

//------------------------------------------------------------------------------
vtkOpenGLTerrainMapper* vtkTerrainActor::GetTerrainMapper()
{
  return this->TerrainMapper;
}

//------------------------------------------------------------------------------
vtkTerrainCoarseMesh* vtkTerrainActor::GetCoarseMesh()
{
  return this->CoarseMesh;
}

//------------------------------------------------------------------------------
vtkTerrainStrips* vtkTerrainActor::GetStrips()
{
  return this->Strips;
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetHierarchy(vtkTerrainHierarchy* hierarchy)
{
  if (this->GetHierarchy() != hierarchy)
  {
    this->Strips->SetHierarchy(hierarchy);
    this->PreparedReader = nullptr;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTerrainHierarchy* vtkTerrainActor::GetHierarchy()
{
  return this->Strips->GetHierarchy();
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetTechnique(Techniques technique)
{
  this->TerrainMapper->SetTechnique(technique);
}

//------------------------------------------------------------------------------
vtkTerrainActor::Techniques vtkTerrainActor::GetTechnique() const
{
  return this->TerrainMapper->GetTechnique();
}

//------------------------------------------------------------------------------
#define vtkTerrainMapperMacro(Name, Type)                                                          \
  void vtkTerrainActor::Set##Name(Type value)                                                      \
  {                                                                                                \
    this->TerrainMapper->Set##Name(value);                                                         \
  }                                                                                                \
  Type vtkTerrainActor::Get##Name() const                                                          \
  {                                                                                                \
    return this->TerrainMapper->Get##Name();                                                       \
  }
vtkTerrainMapperMacro(VerticalExaggeration, double);
vtkTerrainMapperMacro(SunShadows, bool);
vtkTerrainMapperMacro(SunAngle, double);
vtkTerrainMapperMacro(SkyLight, double);

//------------------------------------------------------------------------------
void vtkTerrainActor::SetColorByHeight(bool color)
{
  terrain::Setting::Set(this, this->ColorByHeight, color);
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetLookupTable(vtkScalarsToColors* colors)
{
  terrain::Setting::Set(this, this->LookupTable, colors);
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetLevelOfDetail(bool use)
{
  terrain::Setting::Set(this, this->LevelOfDetail, use);
}

//------------------------------------------------------------------------------
vtkScalarsToColors* vtkTerrainActor::GetLookupTable()
{
  this->UpdateColors();
  return this->TerrainMapper->GetLookupTable();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> vtkTerrainActor::MakeReliefColors(
  double lowest, double highest)
{
  const vtkNew<vtkTerrainColors> colors;
  return colors->MakeTable(lowest, highest);
}

//------------------------------------------------------------------------------
bool vtkTerrainActor::HasSurface()
{
  this->UpdateInput();
  bool found = false;
  if (this->DrawsStripsAlone())
  {
    std::array<double, 6> bounds{};
    this->GetHierarchy()->GetBounds(bounds.data());
    return bounds[0] <= bounds[1];
  }
  this->TerrainMapper->GetBounds(); // brings the heights up to date
  vtkImageData* heights = this->GetHeights();
  if (terrain::ImageHeights::WhyNotHeights(heights).empty())
  {
    terrain::ImageHeights::Dispatch(
      heights, [&found](const auto& view) { found = HoldsSurface(view); });
  }
  return found;
}

//------------------------------------------------------------------------------
bool vtkTerrainActor::DrawsStrips() const
{
  return this->GetTechnique() == Techniques::Strips;
}

//------------------------------------------------------------------------------
bool vtkTerrainActor::DrawsStripsAlone() const
{
  return this->DrawsStrips() && this->Strips->GetHierarchy() &&
    this->TerrainMapper->GetNumberOfInputConnections(1) == 0;
}

//------------------------------------------------------------------------------
double vtkTerrainActor::GetOriginOfHeights()
{
  if (vtkImageData* heights = this->GetHeights())
  {
    return terrain::ImageHeights::Geometry(heights).Origin.z;
  }
  const auto data = this->GetHierarchy() ? this->GetHierarchy()->GetData() : nullptr;
  return data ? data->View().Geometry.Origin.z : 0.0;
}

//------------------------------------------------------------------------------
vtkTerrainCoarseMesh* vtkTerrainActor::GetUsedMesh()
{
  if (this->GetTechnique() == Techniques::Mesh || this->GetTechnique() == Techniques::Strips)
  {
    return this->GetTechnique() == Techniques::Mesh ? this->FullMesh.Get() : nullptr;
  }
  const bool castsRays = this->GetProperty()->GetRepresentation() == VTK_SURFACE;
  return castsRays ? nullptr : this->CoarseMesh.Get();
}

//------------------------------------------------------------------------------
// In coordinates in which nothing has to be scaled but the heights, from the origin's on.
void vtkTerrainActor::RefineFor(vtkRenderer* renderer)
{
  vtkNew<vtkMatrix4x4> toWorld;
  this->GetMatrix(toWorld);
  const double horizontal =
    std::min(terrain::AxisScale(toWorld, 0), terrain::AxisScale(toWorld, 1));
  const double vertical = terrain::AxisScale(toWorld, 2) / horizontal;
  terrain::Exaggerate(toWorld, this->GetOriginOfHeights(), 1.0 / vertical);
  if (!this->Strips->GetCamera())
  {
    this->Strips->SetCamera(vtkSmartPointer<vtkCamera>::New());
  }
  terrain::PlaceInModel(renderer->GetActiveCamera(), toWorld, this->Strips->GetCamera());
  terrain::GridGeometry drawn;
  drawn.Exaggeration = this->GetVerticalExaggeration();
  this->Strips->SetExaggeration(drawn.RiseToModel(vertical));
  // with the heights, the mapper exaggerates, lights and colours the points
  const bool alone = this->DrawsStripsAlone();
  this->Strips->SetPointExaggeration(alone ? this->GetVerticalExaggeration() : 1.0);
  this->Strips->SetNormals(alone);
  this->Strips->SetHeightScalars(alone);
  this->Strips->SetViewportSize(renderer->GetSize());
  // the camera's sides are planes that cut other parts where the ground is stretched one way
  const bool isStretched =
    std::abs(terrain::AxisScale(toWorld, 0) / terrain::AxisScale(toWorld, 1) - 1.0) > 1e-6;
  this->Strips->SetCulling(
    isStretched ? vtkTerrainStrips::CullingMode::Off : vtkTerrainStrips::CullingMode::Nested);
}

//------------------------------------------------------------------------------
void vtkTerrainActor::RefineStrips(vtkRenderer* renderer)
{
  this->UpdateInput();
  this->RefineFor(renderer);
  this->Strips->Update();
}

//------------------------------------------------------------------------------
void vtkTerrainActor::UpdateMesh()
{
  this->UpdateInput();
  vtkAlgorithm* mesh = this->GetUsedMesh();
  if (this->GetTechnique() == Techniques::Strips && this->Strips->GetCamera())
  {
    mesh = this->Strips;
  }
  if (this->ConnectedMesh == mesh)
  {
    return;
  }
  this->ConnectedMesh = mesh;
  if (mesh)
  {
    this->TerrainMapper->SetInputConnection(0, mesh->GetOutputPort());
  }
  else
  {
    this->TerrainMapper->RemoveMesh();
  }
  if (mesh != this->FullMesh)
  {
    this->FullMesh->GetOutput()->ReleaseData(); // gigabytes
  }
}

//------------------------------------------------------------------------------
void vtkTerrainActor::GetHeightRange(double range[2])
{
  this->UpdateInput();
  if (!this->DrawsStripsAlone())
  {
    this->TerrainMapper->GetHeightRange(range);
    return;
  }
  std::array<double, 6> bounds{};
  this->GetHierarchy()->GetBounds(bounds.data());
  range[0] = bounds[4] - this->GetOriginOfHeights();
  range[1] = bounds[5] - this->GetOriginOfHeights();
}

//------------------------------------------------------------------------------
void vtkTerrainActor::UpdateColors()
{
  this->TerrainMapper->SetScalarVisibility(this->ColorByHeight);
  this->TerrainMapper->SetUseLookupTableScalarRange(true);
  if (this->LookupTable)
  {
    this->TerrainMapper->SetLookupTable(this->LookupTable);
    return;
  }
  std::array<double, 2> range{};
  this->GetHeightRange(range.data());
  if (this->ReliefColors->GetSize() == 0 || this->ReliefRange != range)
  {
    this->ReliefRange = range;
    const vtkNew<vtkTerrainColors> colors;
    colors->SetSea(
      this->HasSea() ? vtkTerrainColors::SeaMode::Automatic : vtkTerrainColors::SeaMode::Never);
    this->ReliefColors->DeepCopy(colors->MakeTable(range[0], range[1])); // scalar bars keep it
  }
  this->TerrainMapper->SetLookupTable(this->ReliefColors);
}

//------------------------------------------------------------------------------
double* vtkTerrainActor::GetBounds()
{
  this->UpdateMesh();
  if (!this->DrawsStripsAlone())
  {
    return this->Superclass::GetBounds();
  }
  // of all heights, not of what the camera sees
  std::array<double, 6> bounds{};
  this->GetHierarchy()->GetBounds(bounds.data());
  vtkBoundingBox box;
  if (bounds[0] <= bounds[1])
  {
    vtkNew<vtkMatrix4x4> toWorld;
    this->GetMatrix(toWorld);
    terrain::Exaggerate(toWorld, this->GetOriginOfHeights(), this->GetVerticalExaggeration());
    for (int corner = 0; corner < 8; ++corner)
    {
      const std::array<double, 4> point{ bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
        bounds[4 + (corner >> 2)], 1.0 };
      std::array<double, 4> moved{};
      toWorld->MultiplyPoint(point.data(), moved.data());
      box.AddPoint(moved.data());
    }
  }
  box.GetBounds(this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkTerrainActor::PlaceAsDrawn(vtkProp3D* other)
{
  this->PlaceAsDrawn(other, this->GetOriginOfHeights());
}

//------------------------------------------------------------------------------
void vtkTerrainActor::PlaceAsDrawn(vtkProp3D* other, double originZ)
{
  vtkNew<vtkMatrix4x4> toWorld;
  this->GetMatrix(toWorld);
  if (!terrain::GlobeData::Has(this->GetHeights()))
  {
    terrain::Exaggerate(toWorld, originZ, this->GetVerticalExaggeration());
  }
  else if (this->GetVerticalExaggeration() != 1.0)
  {
    vtkErrorMacro("No matrix exaggerates heights on a globe: multiply the heights of the other "
                  "prop's places before they become points of the scene.");
  }
  other->SetOrigin(0.0, 0.0, 0.0);
  other->SetPosition(0.0, 0.0, 0.0);
  other->SetOrientation(0.0, 0.0, 0.0);
  other->SetScale(1.0, 1.0, 1.0);
  other->SetUserMatrix(toWorld);
}

//------------------------------------------------------------------------------
void vtkTerrainActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  this->UpdateInput();
  if (!this->DrawsStrips() && this->GetHierarchy() &&
    this->TerrainMapper->GetNumberOfInputConnections(1) == 0)
  {
    vtkErrorMacro("Prepared heights alone are drawn by the technique Strips only; set their image, "
                  "or let SetFileName read it.");
    return;
  }
  if (this->DrawsStrips())
  {
    this->RefineFor(renderer);
  }
  this->UpdateMesh();
  this->UpdateColors();
  if (this->LevelOfDetail && this->AllocatedRenderTime < LongestInteraction &&
    this->GetTechnique() == Techniques::Pyramid)
  {
    this->RenderInTime(renderer, mapper);
  }
  else
  {
    this->Superclass::Render(renderer, mapper);
  }
}

//------------------------------------------------------------------------------
void vtkTerrainActor::RenderInTime(vtkRenderer* renderer, vtkMapper* mapper)
{
  this->TerrainMapper->SetHastyTolerance(this->InteractionTolerance);
  const auto begin = std::chrono::steady_clock::now();
  const bool waits = this->TerrainMapper->GetWaitForTiles();
  this->TerrainMapper->SetWaitForTiles(false);
  this->Superclass::Render(renderer, mapper);
  this->TerrainMapper->SetWaitForTiles(waits);
  renderer->GetRenderWindow()->WaitForCompletion(); // drivers draw when it suits them
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  this->TerrainMapper->SetHastyTolerance(0.0);

  // less than 2 pixels hardly ends a search sooner
  constexpr double least = 2.0;
  if (seconds.count() > this->AllocatedRenderTime)
  {
    this->InteractionTolerance =
      std::clamp(2.0 * this->InteractionTolerance, least, CoarsestTolerance);
  }
  else if (seconds.count() < this->AllocatedRenderTime / 3.0)
  {
    const double finer = this->InteractionTolerance / 2.0;
    this->InteractionTolerance = finer < least ? 0.0 : finer;
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTerrainActor::GetRedrawMTime()
{
  return std::max(this->Superclass::GetRedrawMTime(), this->TerrainMapper->GetLookTime());
}

//------------------------------------------------------------------------------
void vtkTerrainActor::CopyLook(vtkTerrainActor* other)
{
  this->TerrainMapper->GetLook()->DeepCopy(other->TerrainMapper->GetLook());
  this->Strips->SetTolerance(other->Strips->GetTolerance());
  this->Strips->SetTriangleBudget(other->Strips->GetTriangleBudget());
  this->SetLevelOfDetail(other->LevelOfDetail);
}

//------------------------------------------------------------------------------
void vtkTerrainActor::ShallowCopy(vtkProp* prop)
{
  if (auto* other = vtkTerrainActor::SafeDownCast(prop))
  {
    this->TerrainMapper = other->TerrainMapper;
    this->CoarseMesh = other->CoarseMesh;
    this->FullMesh = other->FullMesh;
    this->Strips = other->Strips;
    this->PreparedReader = other->PreparedReader;
    this->LookupTable = other->LookupTable;
    this->ReliefColors = other->ReliefColors;
    this->ReliefRange = other->ReliefRange;
    this->ColorByHeight = other->ColorByHeight;
    this->LevelOfDetail = other->LevelOfDetail;
    this->SurfaceError = other->SurfaceError;
    this->ConnectedMesh = other->ConnectedMesh;
  }
  this->Superclass::ShallowCopy(prop);
}
