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
#include <limits>
#include <string>

vtkStandardNewMacro(vtkTerrainMesh);

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

  terrain::GreedyMeshOptions options;
  options.MaximumError = this->MaximumError;
  terrain::GridMesh mesh;
  double lowest = std::numeric_limits<double>::infinity();
  terrain::ImageHeights::Dispatch(image,
    [&](const auto& view)
    {
      mesh = terrain::BuildGreedyMesh(view, options, terrain::SMPParallelFor);
      this->UpdateProgress(0.7);
      this->MeshError = terrain::FindMeshError(view, mesh, terrain::SMPParallelFor);
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

  const terrain::GridGeometry geometry = terrain::ImageHeights::Geometry(image, this->Exaggeration);
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
  os << indent << "MeshError: " << this->MeshError << "\n";
}
