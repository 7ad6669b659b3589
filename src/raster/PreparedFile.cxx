// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/PreparedFile.h"

#include "data/FieldData.h"
#include "data/HierarchyHeights.h"
#include "raster/CoordinateSystem.h"
#include "raster/MemoryLimit.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace terrain
{
namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

std::string OpenPrepared(const std::string& path, const PreparedWishes& wishes, HierarchyData& data)
{
  if (wishes.IsPart)
  {
    return "a prepared file is read whole; set a window on the raster that it was prepared from";
  }
  if (wishes.IsOtherBand)
  {
    return "a prepared file has one band; choose the band of the raster that it was prepared from";
  }
  data.IsFile = true;
  std::string error = data.File.Open(path, false);
  if (!error.empty())
  {
    return error;
  }
  const HierarchyLayout& layout = *data.View().Layout;
  const std::int64_t size = std::max(layout.Width(), layout.Height());
  if ((wishes.MaximumSize > 0 && size > wishes.MaximumSize) ||
    (wishes.MaximumNumberOfSamples > 0 &&
      layout.Width() * layout.Height() > wishes.MaximumNumberOfSamples))
  {
    return "a prepared file is read whole, and its " + std::to_string(layout.Width()) + " x " +
      std::to_string(layout.Height()) +
      " samples are more than the limit; the technique strips draws it without reading it, other "
      "techniques the raster that it was prepared from";
  }
  data.Placing = data.File.Placing();
  std::string& own = data.Placing.CoordinateSystem;
  if (wishes.CoordinateSystem.empty())
  {
    return {};
  }
  if (!own.empty())
  {
    return "a prepared file keeps its own coordinate system; set none";
  }
  own = CoordinateSystem::ToWkt(wishes.CoordinateSystem);
  return own.empty() ? "the coordinate system '" + wishes.CoordinateSystem +
      "' is not understood; give an EPSG code, WKT or a PROJ string"
                     : std::string();
}

void Describe(const HierarchyView& hierarchy, vtkInformation* info)
{
  const GridGeometry& geometry = hierarchy.Geometry;
  const int extent[6] = { 0, static_cast<int>(hierarchy.Layout->Width()) - 1, 0,
    static_cast<int>(hierarchy.Layout->Height()) - 1, 0, 0 };
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), geometry.Origin.x, geometry.Origin.y, geometry.Origin.z);
  info->Set(vtkDataObject::SPACING(), geometry.Spacing.x, geometry.Spacing.y, 1.0);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
}

std::string Fill(const HierarchyData& data, const int extent[6], vtkImageData* image)
{
  const HierarchyLayout& layout = *data.View().Layout;
  if (extent[0] < 0 || extent[2] < 0 || extent[1] >= layout.Width() || extent[3] >= layout.Height())
  {
    return "the file has changed while it was read: read it again";
  }
  try
  {
    CheckMemory(extent, VTK_FLOAT);
    return CopyHeights(data, extent, image);
  }
  catch (const std::bad_alloc&)
  {
    return "there is not enough memory for its samples; the technique strips of vtkTerrainActor "
           "reads only what is seen";
  }
}
}

//------------------------------------------------------------------------------
std::string ReadPreparedFile(
  const std::string& path, const PreparedWishes& wishes, vtkInformation* info, vtkImageData* image)
{
  HierarchyData data;
  std::string why = OpenPrepared(path, wishes, data);
  if (!why.empty() || !image)
  {
    if (why.empty())
    {
      Describe(data.View(), info);
    }
    return why;
  }
  image->Initialize();
  int extent[6];
  info->Get(Pipeline::UPDATE_EXTENT(), extent);
  if (extent[0] <= extent[1] && extent[2] <= extent[3])
  {
    why = Fill(data, extent, image);
  }
  if (why.empty())
  {
    FieldData::AddText(image, "FileName", path);
  }
  else
  {
    image->Initialize();
  }
  return why;
}
}
