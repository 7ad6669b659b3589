// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainMesh.h"

#include "core/mesh/GreedyMesh.h"
#include "data/ImageHeights.h"
#include "data/MeshOutput.h"
#include "data/SMPParallelFor.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

vtkStandardNewMacro(vtkTerrainMesh);

namespace
{
/// Half a step between numbers of 32 bits of that size.
double HalfStep(double value)
{
  const auto size = static_cast<float>(std::abs(value));
  return 0.5 * (std::nextafter(size, std::numeric_limits<float>::infinity()) - size);
}

/// Largest difference of neighbouring heights east or north, in height units.
template <typename T>
glm::dvec2 SteepestCells(const terrain::HeightfieldView<T>& view)
{
  glm::dvec2 steepest(0.0);
  for (std::int64_t j = 0; j < view.Height; ++j)
  {
    for (std::int64_t i = 0; i < view.Width; ++i)
    {
      const double height = view.At(i, j);
      // comparisons with NaN are false
      const double east = i + 1 < view.Width ? std::abs(view.At(i + 1, j) - height) : 0.0;
      const double north = j + 1 < view.Height ? std::abs(view.At(i, j + 1) - height) : 0.0;
      steepest.x = east > steepest.x ? east : steepest.x;
      steepest.y = north > steepest.y ? north : steepest.y;
    }
  }
  return steepest;
}

/// How far the surface may move vertically when its points are rounded to 32 bits, in height units,
/// if no triangle is steeper than the steepest cell.
template <typename T>
double RoundingMargin(
  const terrain::HeightfieldView<T>& view, const terrain::GridGeometry& geometry)
{
  double largest = 0.0;
  for (std::int64_t index = 0; index < view.Width * view.Height; ++index)
  {
    const std::int64_t i = index % view.Width;
    const double height = view.At(i, index / view.Width);
    largest = std::abs(height) > largest ? std::abs(height) : largest;
  }
  const glm::dvec3 first = glm::abs(geometry.ToModel({ 0.0, 0.0 }, largest));
  const glm::dvec3 last = glm::abs(geometry.ToModel({ view.Width - 1, view.Height - 1 }, -largest));
  const glm::dvec3 size = glm::max(first, last);
  const glm::dvec2 steepest = SteepestCells(view);
  return geometry.RiseToHeights(HalfStep(size.z)) +
    steepest.x * HalfStep(size.x) / geometry.Spacing.x +
    steepest.y * HalfStep(size.y) / geometry.Spacing.y;
}

/// Builds the mesh; returns its error.
template <typename T>
double BuildExact(
  const terrain::HeightfieldView<T>& view, double maximumError, terrain::GridMesh& mesh)
{
  terrain::GreedyMeshOptions options;
  options.MaximumError = maximumError;
  mesh = terrain::BuildGreedyMesh(view, options, terrain::SMPParallelFor);
  return terrain::FindMeshError(view, mesh, terrain::SMPParallelFor);
}

/// Builds the mesh so that its error holds for points of 32 bits, if these can hold it; returns
/// that error.
template <typename T>
double BuildRounded(const terrain::HeightfieldView<T>& view, const terrain::GridGeometry& geometry,
  double maximumError, terrain::GridMesh& mesh)
{
  const auto round = [&geometry](const glm::dvec3& vertex)
  { return geometry.ToGrid(glm::vec3(geometry.ToModel(glm::dvec2(vertex), vertex.z))); };
  // what rounding alone does to large coordinates is not mended by more triangles
  double tolerance = std::max(maximumError - RoundingMargin(view, geometry), 0.5 * maximumError);
  double error = 0.0;
  for (int build = 0; build < 2; ++build)
  {
    terrain::GreedyMeshOptions options;
    options.MaximumError = tolerance;
    mesh = terrain::BuildGreedyMesh(view, options, terrain::SMPParallelFor);
    error = terrain::FindMeshError(view, mesh, terrain::SMPParallelFor, round);
    const double excess = error - maximumError;
    if (!(excess > 0.0 && excess < 0.25 * tolerance))
    {
      break;
    }
    tolerance -= 2.0 * excess; // a triangle is steeper than its cells
  }
  return error;
}
}

//------------------------------------------------------------------------------
int vtkTerrainMesh::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainMesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* image = vtkImageData::GetData(inputVector[0]);
  const std::string whyNot = terrain::ImageHeights::WhyNotHeights(image);
  if (!whyNot.empty())
  {
    vtkErrorMacro("No mesh: " << whyNot << ".");
    return 0;
  }

  const terrain::GridGeometry geometry = terrain::ImageHeights::Geometry(image, this->Exaggeration);
  const bool rounds =
    this->HoldInSinglePrecision || this->OutputPointsPrecision == SINGLE_PRECISION;
  terrain::GridMesh mesh;
  double lowest = std::numeric_limits<double>::infinity();
  terrain::ImageHeights::Dispatch(image,
    [&](const auto& view)
    {
      this->MeshError = rounds ? BuildRounded(view, geometry, this->MaximumError, mesh)
                               : BuildExact(view, this->MaximumError, mesh);
      for (const glm::ivec2& vertex : mesh.Vertices)
      {
        lowest = std::min(lowest, view.At(vertex.x, vertex.y));
      }
    });
  this->LowestHeight = mesh.Vertices.empty() ? 0.0 : lowest;
  this->UpdateProgress(0.8);
  if (this->Block && !(this->BlockBase < lowest))
  {
    vtkErrorMacro("No mesh: the floor of the block, at height "
      << this->BlockBase << ", must lie below the lowest height, " << lowest
      << ": SetBlockBase() to less.");
    return 0;
  }

  terrain::MeshOutputOptions output;
  output.SinglePrecision = this->OutputPointsPrecision == SINGLE_PRECISION;
  output.Normals = this->ComputeNormals;
  output.TextureCoordinates = this->ComputeTextureCoordinates;
  output.PointArrays = this->PassPointArrays;
  output.Block = this->Block;
  output.BlockBase = this->BlockBase;
  vtkPolyData* polys = vtkPolyData::GetData(outputVector);
  terrain::FillMeshOutput(image, mesh, geometry, output, polys);

  vtkNew<vtkDoubleArray> error;
  error->SetName("MeshError");
  error->InsertNextValue(this->MeshError);
  polys->GetFieldData()->AddArray(error);
  return 1;
}

//------------------------------------------------------------------------------
double vtkTerrainMesh::GetHeightOfLength(double length) const
{
  terrain::GridGeometry geometry;
  geometry.Exaggeration = this->Exaggeration;
  return geometry.RiseToHeights(length);
}

//------------------------------------------------------------------------------
void vtkTerrainMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "Block: " << (this->Block ? "on" : "off") << "\n";
  os << indent << "BlockBase: " << this->BlockBase << "\n";
  os << indent << "ComputeNormals: " << (this->ComputeNormals ? "on" : "off") << "\n";
  os << indent << "ComputeTextureCoordinates: " << (this->ComputeTextureCoordinates ? "on" : "off")
     << "\n";
  os << indent << "PassPointArrays: " << (this->PassPointArrays ? "on" : "off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "HoldInSinglePrecision: " << (this->HoldInSinglePrecision ? "on" : "off") << "\n";
  os << indent << "MeshError: " << this->MeshError << "\n";
}
