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
#include <vector>

vtkStandardNewMacro(vtkTerrainMesh);

namespace
{
/// Part of the error, and of a cell, by which rounding may move what nobody has asked to round.
constexpr double kUnseenShare = 64.0;

/// A rectangle of a view's samples, as a view of copies of them.
template <typename T>
class CutOut
{
public:
  CutOut(const terrain::HeightfieldView<T>& view, const glm::ivec2& first, const glm::ivec2& last)
  {
    this->View.Width = last.x - first.x + 1;
    this->View.Height = last.y - first.y + 1;
    this->View.HasNoData = view.HasNoData;
    this->View.NoData = view.NoData;
    this->View.MaskBits = view.MaskBits;
    for (int j = first.y; j <= last.y; ++j)
    {
      const std::int64_t from = view.Index(first.x, j);
      const std::int64_t to = view.Index(last.x, j) + 1;
      this->Samples.insert(this->Samples.end(), view.Samples + from, view.Samples + to);
      if (view.Mask)
      {
        this->Mask.insert(this->Mask.end(), view.Mask + from, view.Mask + to);
      }
    }
    this->View.Samples = this->Samples.data();
    this->View.Mask = view.Mask ? this->Mask.data() : nullptr;
  }
  CutOut(const CutOut&) = delete;
  CutOut& operator=(const CutOut&) = delete;

  const terrain::HeightfieldView<T>& GetView() const
  {
    return this->View;
  }

private:
  std::vector<T> Samples;
  std::vector<unsigned char> Mask;
  terrain::HeightfieldView<T> View;
};

/// First and last sample of what is meshed.
struct Part
{
  glm::ivec2 First{ 0 };
  glm::ivec2 Last;
  bool IsAll = true;

  explicit Part(vtkImageData* image)
    : Last(glm::ivec2(image->GetDimensions()[0], image->GetDimensions()[1]) - 1)
  {
  }
  Part(vtkImageData* image, const int first[2], const int last[2])
    : Part(image)
  {
    const Part all = *this;
    this->First = glm::clamp(glm::ivec2(first[0], first[1]), all.First, all.Last);
    this->Last = glm::clamp(glm::ivec2(last[0], last[1]), all.First, all.Last);
    this->IsAll = this->First == all.First && this->Last == all.Last;
  }
};

/// Calls build(view, geometry) for a part of a view.
template <typename T, typename Build>
void BuildPart(const terrain::HeightfieldView<T>& view, const terrain::GridGeometry& geometry,
  const Part& part, const Build& build)
{
  if (part.IsAll)
  {
    build(view, geometry);
    return;
  }
  terrain::GridGeometry place = geometry;
  place.Origin = geometry.ToModel(part.First, 0.0);
  build(CutOut(view, part.First, part.Last).GetView(), place);
}

void AddError(vtkPolyData* mesh, double value)
{
  vtkNew<vtkDoubleArray> error;
  error->SetName("MeshError");
  error->InsertNextValue(value);
  mesh->GetFieldData()->AddArray(error);
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
  const Part part = this->Extracts ? Part(image, this->First, this->Last) : Part(image);
  bool single = this->OutputPointsPrecision == SINGLE_PRECISION;
  const bool rounds = this->HoldInSinglePrecision || single;
  terrain::GridMesh mesh;
  double lowest = std::numeric_limits<double>::infinity();
  terrain::ImageHeights::Dispatch(image,
    [&](const auto& view)
    {
      BuildPart(view, geometry, part,
        [&](const auto& seen, const terrain::GridGeometry& place)
        {
          this->MeshError = rounds ? BuildRounded(seen, place, this->MaximumError, mesh, single)
                                   : BuildExact(seen, this->MaximumError, mesh);
        });
      for (glm::ivec2& vertex : mesh.Vertices)
      {
        vertex += part.First;
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
  std::copy_n(this->TextureBounds, 4, output.TextureBounds.begin());
  output.Slopes = this->ComputeSlopes;
  output.PointArrays = this->PassPointArrays;
  output.Block = this->Block;
  output.WallsOfHoles = this->WallsOfHoles;
  output.First = part.First;
  output.Last = part.Last;
  output.BlockBase = this->BlockBase;
  vtkPolyData* polys = vtkPolyData::GetData(outputVector);
  terrain::FillMeshOutput(image, mesh, geometry, output, polys);
  AddError(polys, this->MeshError);
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainMesh::SetExtract(const int first[2], const int last[2])
{
  if (!this->Extracts || !std::equal(first, first + 2, this->First) ||
    !std::equal(last, last + 2, this->Last))
  {
    this->Extracts = true;
    std::copy_n(first, 2, this->First);
    std::copy_n(last, 2, this->Last);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainMesh::ExtractAll()
{
  if (this->Extracts)
  {
    this->Extracts = false;
    this->Modified();
  }
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
  os << indent << "WallsOfHoles: " << (this->WallsOfHoles ? "on" : "off") << "\n";
  os << indent << "BlockBase: " << this->BlockBase << "\n";
  os << indent << "Extracts: " << (this->Extracts ? "on" : "off") << "\n";
  os << indent << "First: " << this->First[0] << " " << this->First[1] << "\n";
  os << indent << "Last: " << this->Last[0] << " " << this->Last[1] << "\n";
  os << indent << "ComputeNormals: " << (this->ComputeNormals ? "on" : "off") << "\n";
  os << indent << "ComputeTextureCoordinates: " << (this->ComputeTextureCoordinates ? "on" : "off")
     << "\n";
  os << indent << "TextureBounds: " << this->TextureBounds[0] << " " << this->TextureBounds[1]
     << " " << this->TextureBounds[2] << " " << this->TextureBounds[3] << "\n";
  os << indent << "ComputeSlopes: " << (this->ComputeSlopes ? "on" : "off") << "\n";
  os << indent << "PassPointArrays: " << (this->PassPointArrays ? "on" : "off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "HoldInSinglePrecision: " << (this->HoldInSinglePrecision ? "on" : "off") << "\n";
  os << indent << "MeshError: " << this->MeshError << "\n";
}
