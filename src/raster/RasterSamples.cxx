// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterSamples.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

namespace terrain
{
namespace
{
GDALDataType TypeOf(int vtkType)
{
  switch (vtkType)
  {
    case VTK_UNSIGNED_CHAR:
      return GDT_Byte;
    case VTK_SHORT:
      return GDT_Int16;
    case VTK_UNSIGNED_SHORT:
      return GDT_UInt16;
    case VTK_INT:
      return GDT_Int32;
    case VTK_UNSIGNED_INT:
      return GDT_UInt32;
    case VTK_FLOAT:
      return GDT_Float32;
    case VTK_DOUBLE:
      return GDT_Float64;
    default:
      return GDT_Unknown;
  }
}

/// Texts "name=value" of an array; empty without it.
std::map<std::string, std::string> TextsOf(vtkFieldData* fields, const std::string& name)
{
  std::map<std::string, std::string> texts;
  auto* array = vtkStringArray::SafeDownCast(fields->GetAbstractArray(name.c_str()));
  for (vtkIdType k = 0; array && k < array->GetNumberOfValues(); ++k)
  {
    const std::string text = array->GetValue(k);
    const std::size_t cut = text.find('=');
    texts[text.substr(0, cut)] = cut == std::string::npos ? std::string() : text.substr(cut + 1);
  }
  return texts;
}

GridAxis AxisOf(vtkFieldData* fields, const std::string& name)
{
  GridAxis axis;
  axis.Attributes = TextsOf(fields, name + "Attributes");
  axis.Name = axis.Get("name");
  if (vtkDataArray* values = fields->GetArray(name.c_str()))
  {
    axis.Values.resize(static_cast<std::size_t>(values->GetNumberOfTuples()));
    for (std::size_t k = 0; k < axis.Values.size(); ++k)
    {
      axis.Values[k] = values->GetComponent(static_cast<vtkIdType>(k), 0);
    }
  }
  return axis;
}
}

//------------------------------------------------------------------------------
RasterMemory MemoryOf(vtkFieldData* samples)
{
  vtkDataArray* heights = samples->GetArray("Samples");
  vtkDataArray* size = samples->GetArray("Size");
  if (!heights || !size || size->GetNumberOfValues() != 2)
  {
    throw RasterError("the samples that are given lack an array Samples, or its Size");
  }
  RasterMemory memory;
  memory.Width = static_cast<int>(size->GetVariantValue(0).ToInt());
  memory.Height = static_cast<int>(size->GetVariantValue(1).ToInt());
  memory.Type = TypeOf(heights->GetDataType());
  const vtkIdType count = vtkIdType{ memory.Width } * memory.Height;
  if (memory.Type == GDT_Unknown || memory.Width < 1 || memory.Height < 1 ||
    heights->GetNumberOfComponents() != 1 || heights->GetNumberOfTuples() != count)
  {
    throw RasterError("the samples that are given are of a type or number that heights are not");
  }
  memory.Samples = heights->GetVoidPointer(0);
  memory.Attributes = TextsOf(samples, "Attributes");
  const std::map<std::string, std::string> own = TextsOf(samples, "Names");
  const auto text = [&own](const char* name)
  {
    const auto found = own.find(name);
    return found == own.end() ? std::string() : found->second;
  };
  memory.Name = text("name");
  memory.CoordinateSystem = text("crs");
  GridCoordinates& grid = memory.Coordinates;
  grid.RowCount = static_cast<std::size_t>(memory.Height);
  grid.ColumnCount = static_cast<std::size_t>(memory.Width);
  grid.Rows = AxisOf(samples, "Rows");
  grid.Columns = AxisOf(samples, "Columns");
  grid.GridMapping = TextsOf(samples, "GridMapping");
  for (int k = 0; samples->HasArray(("Field" + std::to_string(k)).c_str()); ++k)
  {
    grid.Fields.push_back(AxisOf(samples, "Field" + std::to_string(k)));
  }
  return memory;
}
}
