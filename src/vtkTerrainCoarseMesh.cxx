// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainCoarseMesh.h"

#include "core/mesh/CoarseMesh.h"
#include "core/mesh/CoarseMeshSurface.h"
#include "data/ImageHeights.h"
#include "data/PointArrays.h"
#include "data/SMPParallelFor.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <initializer_list>
#include <limits>

vtkStandardNewMacro(vtkTerrainCoarseMesh);

namespace
{
/// The sum of an origin and a height in the type of the output, rounded up.
template <typename Real>
Real AddRoundedUp(double origin, double height)
{
  double sum = origin + height;
  const double heightRounded = sum - origin;
  const double error = (origin - (sum - heightRounded)) + (height - heightRounded);
  if (error > 0.0)
  {
    sum = std::nextafter(sum, std::numeric_limits<double>::infinity());
  }
  const Real rounded = static_cast<Real>(sum);
  return static_cast<double>(rounded) < sum
    ? std::nextafter(rounded, std::numeric_limits<Real>::infinity())
    : rounded;
}

/// Height of the floor of the hull: below all heights by more than any rounding.
double FloorHeight(
  const terrain::CoarseMesh& mesh, const terrain::GridGeometry& geometry, double margin)
{
  const double range = mesh.MaximumHeight - mesh.MinimumHeight;
  const double spacing = std::min(geometry.Spacing.x, geometry.Spacing.y);
  const double amount = std::abs(mesh.MinimumHeight) + std::abs(geometry.Origin.z);
  const double rounding = 4.0 * std::numeric_limits<float>::epsilon() * amount;
  return mesh.MinimumHeight - std::max({ margin * range, margin * spacing, rounding });
}

template <typename Real>
void FillPoints(const terrain::CoarseMeshSurface& surface, const terrain::GridGeometry& geometry,
  Real* points, float* gridCoordinates)
{
  surface.ForEachVertex(
    [&](std::int64_t id, const terrain::CoarseMeshVertex& vertex)
    {
      const glm::dvec2 positionGC(vertex.Column, vertex.Row);
      const glm::dvec3 positionMC = geometry.ToModel(positionGC, vertex.Height);
      points[3 * id] = static_cast<Real>(positionMC.x);
      points[3 * id + 1] = static_cast<Real>(positionMC.y);
      points[3 * id + 2] = AddRoundedUp<Real>(geometry.Origin.z, vertex.Height);
      gridCoordinates[2 * id] = static_cast<float>(vertex.Column);
      gridCoordinates[2 * id + 1] = static_cast<float>(vertex.Row);
    });
}

void AddFieldArray(vtkPolyData* output, const char* name, std::initializer_list<double> values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.begin());
  output->GetFieldData()->AddArray(array);
}

/// Adds the arrays of the samples that vertices lie on.
void AddPointArrays(
  const terrain::CoarseMeshSurface& surface, vtkImageData* image, vtkPolyData* output)
{
  vtkNew<vtkIdList> samples;
  samples->SetNumberOfIds(surface.NumberOfVertices());
  surface.ForEachVertex(
    [&](std::int64_t id, const terrain::CoarseMeshVertex& vertex) {
      samples->SetId(id, terrain::ImageHeights::PointOfSample(image, vertex.Column, vertex.Row));
    });
  terrain::AddPointArrays(
    image, samples->GetNumberOfIds(), [&](vtkIdType id) { return samples->GetId(id); }, output);
}

void FillOutput(const terrain::CoarseMeshSurface& surface, const terrain::GridGeometry& geometry,
  bool single, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(surface.NumberOfVertices());
  vtkNew<vtkFloatArray> gridCoordinates;
  gridCoordinates->SetName("GridCoordinates");
  gridCoordinates->SetNumberOfComponents(2);
  gridCoordinates->SetNumberOfTuples(surface.NumberOfVertices());
  if (single)
  {
    FillPoints(surface, geometry, vtkFloatArray::SafeDownCast(points->GetData())->GetPointer(0),
      gridCoordinates->GetPointer(0));
  }
  else
  {
    FillPoints(surface, geometry, vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0),
      gridCoordinates->GetPointer(0));
  }

  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(3 * surface.NumberOfTriangles());
  vtkIdType* ids = connectivity->GetPointer(0);
  surface.ForEachTriangle(
    [&ids](std::int64_t a, std::int64_t b, std::int64_t c)
    {
      *ids++ = a;
      *ids++ = b;
      *ids++ = c;
    });
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(3, connectivity);

  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->AddArray(gridCoordinates);
}
}

//------------------------------------------------------------------------------
void vtkTerrainCoarseMesh::SetSamplesPerQuad(vtkIdType cells)
{
  vtkWarningMacro("SetSamplesPerQuad() is now called SetCellsPerQuad()");
  this->SetCellsPerQuad(cells);
}

//------------------------------------------------------------------------------
vtkIdType vtkTerrainCoarseMesh::GetSamplesPerQuad()
{
  vtkWarningMacro("GetSamplesPerQuad() is now called GetCellsPerQuad()");
  return this->CellsPerQuad;
}

//------------------------------------------------------------------------------
vtkIdType vtkTerrainCoarseMesh::GetEffectiveSamplesPerQuad()
{
  vtkWarningMacro("GetEffectiveSamplesPerQuad() is now called GetEffectiveCellsPerQuad()");
  return this->EffectiveCellsPerQuad;
}

//------------------------------------------------------------------------------
int vtkTerrainCoarseMesh::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainCoarseMesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* image = vtkImageData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const std::string whyNot = terrain::ImageHeights::WhyNotHeights(image);
  if (!whyNot.empty())
  {
    vtkErrorMacro("No coarse mesh: " << whyNot << ".");
    return 0;
  }

  terrain::CoarseMeshOptions options;
  options.CellsPerQuad = this->CellsPerQuad;
  options.PushUp = this->PushUp;
  terrain::CoarseMesh mesh;
  terrain::ImageHeights::Dispatch(image,
    [&](const auto& view)
    { mesh = terrain::BuildCoarseMesh(view, options, terrain::SMPParallelFor); });
  this->UpdateProgress(0.5);

  const terrain::GridGeometry geometry = terrain::ImageHeights::Geometry(image);
  const terrain::CoarseMeshSurface surface(
    mesh, this->PushUp && this->ClosedHull, FloorHeight(mesh, geometry, FloorMargin));
  FillOutput(surface, geometry, this->OutputPointsPrecision == SINGLE_PRECISION, output);
  if (this->PassPointArrays)
  {
    AddPointArrays(surface, image, output);
  }

  this->EffectiveCellsPerQuad = mesh.CellsPerQuad;
  this->LargestGap = mesh.LargestGap;
  this->HeightRange[0] = mesh.MinimumHeight;
  this->HeightRange[1] = mesh.MaximumHeight;
  AddFieldArray(output, "LargestGap", { mesh.LargestGap });
  AddFieldArray(output, "CellsPerQuad", { static_cast<double>(mesh.CellsPerQuad) });
  AddFieldArray(output, "HeightRange", { mesh.MinimumHeight, mesh.MaximumHeight });
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainCoarseMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CellsPerQuad: " << this->CellsPerQuad << "\n";
  os << indent << "PushUp: " << (this->PushUp ? "on" : "off") << "\n";
  os << indent << "ClosedHull: " << (this->ClosedHull ? "on" : "off") << "\n";
  os << indent << "PassPointArrays: " << (this->PassPointArrays ? "on" : "off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "EffectiveCellsPerQuad: " << this->EffectiveCellsPerQuad << "\n";
  os << indent << "LargestGap: " << this->LargestGap << "\n";
  os << indent << "HeightRange: " << this->HeightRange[0] << " " << this->HeightRange[1] << "\n";
}
