// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainHierarchy.h"

#include "data/FieldData.h"
#include "data/HierarchyData.h"
#include "data/HierarchyHeights.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include <limits>

vtkStandardNewMacro(vtkTerrainHierarchy);

namespace
{
/// Rows of an image as float heights with NaN for no data.
terrain::HeightRows RowsOf(vtkImageData* image)
{
  return [image](std::int64_t first, std::int64_t count, float* heights)
  {
    terrain::ImageHeights::Dispatch(image,
      [&](const auto& view)
      {
        float* out = heights;
        for (std::int64_t j = first; j < first + count; ++j)
        {
          for (std::int64_t i = 0; i < view.Width; ++i)
          {
            const std::int64_t index = view.Index(i, j);
            *out++ = view.IsValid(index) ? static_cast<float>(view.Samples[index])
                                         : std::numeric_limits<float>::quiet_NaN();
          }
        }
      });
    return std::string();
  };
}

/// What the field data of an image say, as vtkTerrainRasterReader gives them.
terrain::HierarchyPlacing PlacingOf(vtkImageData* image)
{
  terrain::HierarchyPlacing placing;
  if (image)
  {
    placing.CoordinateSystem = terrain::FieldData::GetText(image, "CRS");
    placing.HasLayout =
      terrain::FieldData::GetPair(image, "LayoutOrigin", &placing.LayoutOrigin.x) &&
      terrain::FieldData::GetPair(image, "LayoutScale", &placing.LayoutScale.x);
  }
  return placing;
}
}

vtkTerrainHierarchy::vtkTerrainHierarchy() = default;
vtkTerrainHierarchy::~vtkTerrainHierarchy() = default;

void vtkTerrainHierarchy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  int dimensions[2];
  this->GetDimensions(dimensions);
  os << indent << "Dimensions: " << dimensions[0] << " x " << dimensions[1] << "\n"
     << indent << "KeepBorder: " << this->KeepBorder << "\n"
     << indent << "InFile: " << (this->Data && this->Data->IsFile) << "\n"
     << indent << "Damaged: " << this->IsDamaged() << "\n"
     << indent << "CoordinateSystem: " << this->GetCoordinateSystem() << "\n"
     << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}

bool vtkTerrainHierarchy::Finish(const std::string& error)
{
  this->ErrorMessage = error;
  return error.empty();
}

bool vtkTerrainHierarchy::SetHeights(vtkImageData* heights, const ProgressFunction& progress)
{
  this->Data.reset();
  this->Modified();
  std::string error = terrain::ImageHeights::WhyNotHeights(heights);
  if (!error.empty())
  {
    return this->Finish(error);
  }
  const int* dims = heights->GetDimensions();
  error = terrain::HierarchyLayout::WhyNotSize(dims[0], dims[1]);
  if (error.empty())
  {
    auto data = std::make_shared<terrain::HierarchyData>();
    data->Placing = PlacingOf(heights);
    error = terrain::BuildHierarchy(data->Memory, dims[0], dims[1],
      terrain::ImageHeights::Geometry(heights), RowsOf(heights), terrain::SMPParallelFor, progress,
      this->KeepBorder);
    if (error.empty())
    {
      this->Data = data;
    }
  }
  return this->Finish(error);
}

bool vtkTerrainHierarchy::OpenFile(const std::string& path, bool verify)
{
  this->Data.reset();
  this->Modified();
  auto data = std::make_shared<terrain::HierarchyData>();
  data->IsFile = true;
  const std::string error = data->File.Open(path, verify);
  if (error.empty())
  {
    data->Placing = data->File.Placing();
    this->Data = data;
  }
  return this->Finish(error.empty() ? error : path + ": " + error);
}

bool vtkTerrainHierarchy::WriteFile(const std::string& path, const ProgressFunction& progress)
{
  if (!this->Data)
  {
    return this->Finish("there is no hierarchy to write");
  }
  const std::string error =
    terrain::WriteHierarchyFile(path, this->Data->View(), this->Data->Placing, progress);
  return this->Finish(error.empty() ? error : path + ": " + error);
}

bool vtkTerrainHierarchy::PrepareFile(const std::string& path, int width, int height,
  const double origin[3], const double spacing[2], vtkImageData* placed, const RowFunction& rows,
  const ProgressFunction& progress)
{
  terrain::GridGeometry geometry;
  geometry.Origin = { origin[0], origin[1], origin[2] };
  geometry.Spacing = { spacing[0], spacing[1] };
  const auto heights = [&rows](std::int64_t first, std::int64_t count, float* out)
  { return rows(static_cast<vtkIdType>(first), static_cast<vtkIdType>(count), out); };
  const std::string error = terrain::WriteHierarchyFile(
    path, width, height, geometry, PlacingOf(placed), heights, terrain::SMPParallelFor, progress);
  return this->Finish(error.empty() ? error : path + ": " + error);
}

bool vtkTerrainHierarchy::IsPreparedFile(const std::string& path)
{
  return terrain::IsHierarchyFile(path);
}

bool vtkTerrainHierarchy::GetHeights(vtkImageData* heights)
{
  int dimensions[2];
  this->GetDimensions(dimensions);
  const int extent[6] = { 0, dimensions[0] - 1, 0, dimensions[1] - 1, 0, 0 };
  return this->GetHeights(extent, heights);
}

bool vtkTerrainHierarchy::GetHeights(const int extent[6], vtkImageData* heights)
{
  heights->Initialize();
  int dimensions[2];
  this->GetDimensions(dimensions);
  if (extent[0] < 0 || extent[2] < 0 || extent[0] > extent[1] || extent[2] > extent[3] ||
    extent[1] >= dimensions[0] || extent[3] >= dimensions[1])
  {
    return this->Finish("these samples are not among the prepared ones");
  }
  return this->Finish(terrain::CopyHeights(*this->Data, extent, heights));
}

bool vtkTerrainHierarchy::IsDamaged() const
{
  return this->Data && this->Data->IsDamaged();
}

void vtkTerrainHierarchy::GetDimensions(int dimensions[2]) const
{
  const terrain::HierarchyView view = this->Data ? this->Data->View() : terrain::HierarchyView();
  dimensions[0] = view.Layout ? static_cast<int>(view.Layout->Width()) : 0;
  dimensions[1] = view.Layout ? static_cast<int>(view.Layout->Height()) : 0;
}

void vtkTerrainHierarchy::GetBounds(double bounds[6]) const
{
  vtkMath::UninitializeBounds(bounds);
  if (!this->Data)
  {
    return;
  }
  const terrain::HierarchyView view = this->Data->View();
  if (view.Summary.MinimumHeight <= view.Summary.MaximumHeight)
  {
    const glm::dvec2 last(view.Layout->Width() - 1, view.Layout->Height() - 1);
    const glm::dvec3 low = view.Geometry.ToModel({ 0.0, 0.0 }, view.Summary.MinimumHeight);
    const glm::dvec3 high = view.Geometry.ToModel(last, view.Summary.MaximumHeight);
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[std::size_t{ 2 } * axis] = low[axis];
      bounds[std::size_t{ 2 } * axis + 1] = high[axis];
    }
  }
}

std::string vtkTerrainHierarchy::GetCoordinateSystem() const
{
  return this->Data ? this->Data->Placing.CoordinateSystem : std::string();
}

void vtkTerrainHierarchy::ReleasePages()
{
  if (this->Data && this->Data->IsFile)
  {
    this->Data->File.ReleasePages();
  }
}
