// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainActor.h"

#include "data/ImageHeights.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainStrips.h"

#include "vtkAlgorithmOutput.h"
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

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

vtkStandardNewMacro(vtkTerrainActor);

namespace
{
/// One colour of a scale: position in 0..1 from the lowest to the highest, and red, green, blue.
struct Tint
{
  double Position;
  std::array<double, 3> Color;
};

constexpr std::array<Tint, 6> LandTints = { { { 0.0, { 0.46, 0.58, 0.38 } },
  { 0.2, { 0.62, 0.67, 0.43 } }, { 0.45, { 0.80, 0.73, 0.52 } }, { 0.7, { 0.66, 0.53, 0.42 } },
  { 0.88, { 0.71, 0.68, 0.66 } }, { 1.0, { 0.97, 0.97, 0.98 } } } };
constexpr std::array<Tint, 3> SeaTints = { { { 0.0, { 0.07, 0.19, 0.36 } },
  { 0.7, { 0.25, 0.48, 0.66 } }, { 0.999, { 0.60, 0.77, 0.83 } } } };
/// Part of the range that lies below 0 from which on there is a sea.
constexpr double LeastSea = 0.1;

/// Length of what a matrix makes of a unit of one axis.
double scaleOf(vtkMatrix4x4* matrix, int axis)
{
  return std::hypot(
    matrix->GetElement(0, axis), matrix->GetElement(1, axis), matrix->GetElement(2, axis));
}

/// Makes a camera see a model as another one sees it in the world; toWorld: turns, shifts, and
/// scales all axes by as much.
void placeInModel(vtkCamera* world, vtkMatrix4x4* toWorld, vtkCamera* model)
{
  vtkNew<vtkMatrix4x4> toModel;
  vtkMatrix4x4::Invert(toWorld, toModel);
  const auto place = [&toModel](const double* vector, double w)
  {
    std::array<double, 4> placed{ vector[0], vector[1], vector[2], w };
    toModel->MultiplyPoint(placed.data(), placed.data());
    return placed;
  };
  model->SetPosition(place(world->GetPosition(), 1.0).data());
  model->SetFocalPoint(place(world->GetFocalPoint(), 1.0).data());
  model->SetViewUp(place(world->GetViewUp(), 0.0).data());
  model->SetParallelProjection(world->GetParallelProjection());
  model->SetParallelScale(world->GetParallelScale() / scaleOf(toWorld, 0));
  model->SetUseHorizontalViewAngle(world->GetUseHorizontalViewAngle());
  model->SetViewAngle(world->GetViewAngle());
  model->SetWindowCenter(world->GetWindowCenter()[0], world->GetWindowCenter()[1]);
}

/// True if some cell has a surface. Cost: up to the first such cell.
template <typename T>
bool hasSurface(const terrain::HeightfieldView<T>& view)
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

template <std::size_t N>
void addTints(
  vtkColorTransferFunction* colors, const std::array<Tint, N>& tints, double lowest, double highest)
{
  for (const Tint& tint : tints)
  {
    colors->AddRGBPoint(
      lowest + tint.Position * (highest - lowest), tint.Color[0], tint.Color[1], tint.Color[2]);
  }
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
  this->FullMesh->SetSamplesPerQuad(1);
  this->FullMesh->PushUpOff();
  this->Strips->ExaggeratePointsOff(); // the mapper does
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
  os << indent << "VerticalExaggeration: " << this->GetVerticalExaggeration() << "\n";
  os << indent << "ColorByHeight: " << this->ColorByHeight << "\n";
  os << indent << "LevelOfDetail: " << this->LevelOfDetail << "\n";
  os << indent << "LookupTable: " << this->LookupTable << "\n";
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetInputConnection(vtkAlgorithmOutput* heights)
{
  this->TerrainMapper->SetHeightsConnection(heights);
  this->CoarseMesh->SetInputConnection(heights);
  this->FullMesh->SetInputConnection(heights);
  this->Strips->SetInputConnection(heights);
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetInputData(vtkImageData* heights)
{
  this->TerrainMapper->SetHeightsData(heights);
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
void vtkTerrainActor::SetVerticalExaggeration(double exaggeration)
{
  this->TerrainMapper->SetVerticalExaggeration(exaggeration);
}

//------------------------------------------------------------------------------
double vtkTerrainActor::GetVerticalExaggeration() const
{
  return this->TerrainMapper->GetVerticalExaggeration();
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetColorByHeight(bool color)
{
  if (this->ColorByHeight != color)
  {
    this->ColorByHeight = color;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetLookupTable(vtkScalarsToColors* colors)
{
  if (this->LookupTable != colors)
  {
    this->LookupTable = colors;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainActor::SetLevelOfDetail(bool use)
{
  if (this->LevelOfDetail != use)
  {
    this->LevelOfDetail = use;
    this->Modified();
  }
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
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  const bool sea = lowest < -LeastSea * (highest - lowest) && highest > 0.0;
  if (sea)
  {
    addTints(colors, SeaTints, lowest, 0.0);
  }
  if (highest > lowest)
  {
    addTints(colors, LandTints, sea ? 0.0 : lowest, highest);
  }
  else
  {
    const std::array<double, 3>& color = LandTints[1].Color;
    colors->AddRGBPoint(lowest, color[0], color[1], color[2]);
  }
  return colors;
}

//------------------------------------------------------------------------------
bool vtkTerrainActor::HasSurface()
{
  this->TerrainMapper->GetBounds(); // brings the heights up to date
  vtkImageData* heights = this->GetHeights();
  bool found = false;
  if (terrain::ImageHeights::WhyNotHeights(heights).empty())
  {
    terrain::ImageHeights::Dispatch(
      heights, [&found](const auto& view) { found = hasSurface(view); });
  }
  return found;
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
  const double horizontal = std::min(scaleOf(toWorld, 0), scaleOf(toWorld, 1));
  const double vertical = scaleOf(toWorld, 2) / horizontal;
  const double origin = this->GetHeights() ? this->GetHeights()->GetOrigin()[2] : 0.0;
  for (int row = 0; row < 3; ++row)
  {
    const double up = toWorld->GetElement(row, 2);
    toWorld->SetElement(row, 2, up / vertical);
    toWorld->SetElement(row, 3, toWorld->GetElement(row, 3) + origin * (up - up / vertical));
  }
  if (!this->Strips->GetCamera())
  {
    this->Strips->SetCamera(vtkSmartPointer<vtkCamera>::New());
  }
  placeInModel(renderer->GetActiveCamera(), toWorld, this->Strips->GetCamera());
  this->Strips->SetExaggeration(this->GetVerticalExaggeration() * vertical);
  this->Strips->SetViewportSize(renderer->GetSize());
  // the camera's sides are planes that cut other parts where the ground is stretched one way
  const bool isStretched = std::abs(scaleOf(toWorld, 0) / scaleOf(toWorld, 1) - 1.0) > 1e-6;
  this->Strips->SetCulling(
    isStretched ? vtkTerrainStrips::CullingMode::Off : vtkTerrainStrips::CullingMode::Nested);
}

//------------------------------------------------------------------------------
void vtkTerrainActor::UpdateMesh()
{
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
  this->TerrainMapper->GetHeightRange(range.data());
  if (this->ReliefColors->GetSize() == 0 || this->ReliefRange != range)
  {
    this->ReliefRange = range;
    this->ReliefColors->DeepCopy(MakeReliefColors(range[0], range[1])); // scalar bars keep it
  }
  this->TerrainMapper->SetLookupTable(this->ReliefColors);
}

//------------------------------------------------------------------------------
double* vtkTerrainActor::GetBounds()
{
  this->UpdateMesh();
  return this->Superclass::GetBounds();
}

//------------------------------------------------------------------------------
void vtkTerrainActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  if (this->GetTechnique() == Techniques::Strips)
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
  const double tolerance = this->TerrainMapper->GetPixelTolerance();
  this->TerrainMapper->SetPixelTolerance(std::max(tolerance, this->InteractionTolerance));
  const auto begin = std::chrono::steady_clock::now();
  this->Superclass::Render(renderer, mapper);
  renderer->GetRenderWindow()->WaitForCompletion(); // drivers draw when it suits them
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  this->TerrainMapper->SetPixelTolerance(tolerance);

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
    this->LookupTable = other->LookupTable;
    this->ReliefColors = other->ReliefColors;
    this->ReliefRange = other->ReliefRange;
    this->ColorByHeight = other->ColorByHeight;
    this->LevelOfDetail = other->LevelOfDetail;
    this->ConnectedMesh = other->ConnectedMesh;
  }
  this->Superclass::ShallowCopy(prop);
}
