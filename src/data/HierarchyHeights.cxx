// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/HierarchyHeights.h"

#include "data/FieldData.h"
#include "data/SMPParallelFor.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace terrain
{
namespace
{
/// Heights of row y of columns [first, last], NaN where no cell with a surface is.
void CopyRow(const HierarchyView& hierarchy, std::int64_t y, std::int64_t first, std::int64_t last,
  float* heights)
{
  const std::int64_t width = hierarchy.Layout->Width();
  const std::int64_t height = hierarchy.Layout->Height();
  std::fill(heights, heights + (last - first + 1), std::numeric_limits<float>::quiet_NaN());
  for (std::int64_t cellY = std::max<std::int64_t>(y - 1, 0); cellY <= std::min(y, height - 2);
       ++cellY)
  {
    for (std::int64_t cellX = std::max<std::int64_t>(first - 1, 0);
         cellX <= std::min(last, width - 2); ++cellX)
    {
      if (!hierarchy.IsCellDrawn(cellX, cellY))
      {
        continue;
      }
      for (std::int64_t x = std::max(cellX, first); x <= std::min(cellX + 1, last); ++x)
      {
        heights[x - first] = hierarchy.HeightAt(x, y);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
std::string CopyHeights(const HierarchyData& data, const int extent[6], vtkImageData* heights)
{
  const HierarchyView hierarchy = data.View();
  heights->Initialize();
  heights->SetExtent(extent[0], extent[1], extent[2], extent[3], 0, 0);
  heights->SetOrigin(
    hierarchy.Geometry.Origin.x, hierarchy.Geometry.Origin.y, hierarchy.Geometry.Origin.z);
  heights->SetSpacing(hierarchy.Geometry.Spacing.x, hierarchy.Geometry.Spacing.y, 1.0);
  heights->AllocateScalars(VTK_FLOAT, 1);
  heights->GetPointData()->GetScalars()->SetName("Elevation");
  auto* samples = static_cast<float*>(heights->GetScalarPointer());
  const std::int64_t width = extent[1] - extent[0] + 1;
  SMPParallelFor(extent[3] - extent[2] + 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        CopyRow(hierarchy, extent[2] + row, extent[0], extent[1], samples + row * width);
      }
    });
  if (data.IsDamaged())
  {
    heights->Initialize();
    return "the file has lost data since it was opened: prepare it again";
  }
  if (!data.Placing.CoordinateSystem.empty())
  {
    FieldData::AddText(heights, "CRS", data.Placing.CoordinateSystem);
  }
  if (data.Placing.HasLayout)
  {
    const glm::dvec2& origin = data.Placing.LayoutOrigin;
    const glm::dvec2& scale = data.Placing.LayoutScale;
    FieldData::AddTuple(heights, "LayoutOrigin", { origin.x, origin.y });
    FieldData::AddTuple(heights, "LayoutScale", { scale.x, scale.y });
  }
  return {};
}
}
