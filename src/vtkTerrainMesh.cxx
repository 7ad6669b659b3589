// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainMesh.h"

#include "core/mesh/GreedyMesh.h"
#include "core/mesh/MeshError.h"
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
/// Part of the error, and of a cell, by which rounding may move what nobody has asked to round.
constexpr double kUnseenShare = 64.0;

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
/// that error. single becomes true where 32 bits do next to nothing to the surface.
template <typename T>
double BuildRounded(const terrain::HeightfieldView<T>& view, const terrain::GridGeometry& geometry,
  double maximumError, terrain::GridMesh& mesh, bool& single)
{
  // what rounding alone does to large coordinates is not mended by more triangles
  const glm::dvec3 margin = terrain::FindRoundingMargin(view, geometry, terrain::SMPParallelFor);
  single = single ||
    (margin.z <= maximumError / kUnseenShare && margin.x <= 1.0 / kUnseenShare &&
      margin.y <= 1.0 / kUnseenShare);
  double tolerance = std::max(maximumError - margin.z, 0.5 * maximumError);
  double error = 0.0;
  for (int build = 0; build < 2; ++build)
  {
    terrain::GreedyMeshOptions options;
    options.MaximumError = tolerance;
    mesh = terrain::BuildGreedyMesh(view, options, terrain::SMPParallelFor);
    error = terrain::FindMeshError(view, mesh, terrain::SMPParallelFor, &geometry);
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
  bool single = this->OutputPointsPrecision == SINGLE_PRECISION;
  const bool rounds = this->HoldInSinglePrecision || single;
  terrain::GridMesh mesh;
  double lowest = std::numeric_limits<double>::infinity();
  terrain::ImageHeights::Dispatch(image,
    [&](const auto& view)
    {
      this->MeshError = rounds ? BuildRounded(view, geometry, this->MaximumError, mesh, single)
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
  output.SinglePrecision = single && this->OutputPointsPrecision != DOUBLE_PRECISION;
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
