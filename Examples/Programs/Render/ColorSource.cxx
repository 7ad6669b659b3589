// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorSource.h"

#include "Options.h"
#include "ShownHeights.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPointData.h"
#include "vtkTerrainActor.h"

#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{
/// How often each class occurs among numbers of classes.
std::vector<vtkIdType> CountClasses(vtkFloatArray* numbers, int classes)
{
  std::vector<vtkIdType> counts(static_cast<std::size_t>(classes));
  for (vtkIdType k = 0; k < numbers->GetNumberOfValues(); ++k)
  {
    if (std::isfinite(numbers->GetValue(k)))
    {
      ++counts[static_cast<std::size_t>(numbers->GetValue(k))];
    }
  }
  return counts;
}

std::vector<LegendClass> NameClasses(vtkTerrainColors* colors, vtkFloatArray* numbers)
{
  const std::vector<vtkIdType> counts = CountClasses(numbers, colors->GetNumberOfCategories());
  std::vector<LegendClass> classes;
  for (int k = 0; k < colors->GetNumberOfCategories(); ++k)
  {
    if (counts[static_cast<std::size_t>(k)] > 0)
    {
      LegendClass one;
      one.Name = colors->GetCategoryName(k);
      std::ostringstream value;
      value << colors->GetCategoryValue(k);
      one.Name = one.Name.empty() ? value.str() : one.Name;
      one.Count = counts[static_cast<std::size_t>(k)];
      colors->GetCategoryColor(k, one.Color.data());
      classes.push_back(one);
    }
  }
  return classes;
}

/// A table of the numbers of classes.
vtkSmartPointer<vtkScalarsToColors> TableOfClasses(vtkTerrainColors* colors)
{
  const int count = colors->GetNumberOfCategories();
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  table->SetTableRange(-0.5, count - 0.5);
  for (int k = 0; k < count; ++k)
  {
    std::array<double, 3> color{};
    colors->GetCategoryColor(k, color.data());
    table->SetTableValue(k, color[0], color[1], color[2]);
  }
  const double* none = colors->MakeTable(0.0, 1.0)->GetNanColor();
  table->SetNanColor(none[0], none[1], none[2], 1.0);
  return table;
}

/// Names of classes, where the colours are classes that have any.
std::vector<LegendClass> NameZones(vtkTerrainColors* colors, vtkDataArray* values)
{
  return colors->IsDiscrete() && colors->GetNumberOfCategories() > 0
    ? NameClasses(colors, colors->FindCategories(values))
    : std::vector<LegendClass>();
}

LegendKey ColorByValues(vtkTerrainActor* terrain, vtkImageData* heights, const ColorSource& source)
{
  vtkOpenGLTerrainMapper* mapper = terrain->GetTerrainMapper();
  vtkDataArray* ofPoints = heights->GetPointData()->GetArray(kColorValues);
  vtkDataArray* values = ofPoints ? ofPoints : heights->GetCellData()->GetArray(kColorValues);
  if (ofPoints)
  {
    mapper->SetScalarModeToUsePointFieldData();
  }
  else
  {
    mapper->SetScalarModeToUseCellFieldData();
  }
  mapper->SelectColorArray(kColorValues);
  LegendKey key;
  key.Title = source.Title;
  if (source.AreClasses)
  {
    key.Table = TableOfClasses(source.Colors);
    key.Classes = NameClasses(source.Colors, vtkFloatArray::SafeDownCast(values));
    return key;
  }
  std::array<double, 2> range{};
  values->GetFiniteRange(range.data());
  key.Table = source.Colors->MakeTable(range[0], range[1]);
  key.Classes = NameZones(source.Colors, values);
  return key;
}
}

//------------------------------------------------------------------------------
LegendKey ColorTerrain(vtkTerrainActor* terrain, vtkImageData* heights, const ColorSource& source,
  const Options& options)
{
  LegendKey key;
  key.Title = source.Title;
  if (options.ColorBy.IsFile())
  {
    key = ColorByValues(terrain, heights, source);
  }
  else if (options.ColorBy.IsGiven())
  {
    const bool isSlope = options.ColorBy.IsSlope();
    terrain->GetTerrainMapper()->SetColorSource(
      isSlope ? vtkTerrainLook::ColorSources::Slope : vtkTerrainLook::ColorSources::Aspect);
    key.Table = source.Colors->MakeTable(
      0.0, isSlope ? vtkTerrainActor::SuggestSteepestSlope(heights) : 360.0);
  }
  else if (options.Colors.IsGiven())
  {
    const std::array<double, 2> range = HeightRange(terrain, heights);
    key.Table = source.Colors->MakeTable(range[0], range[1]);
    key.Classes = NameZones(source.Colors, HeightsOf(heights));
  }
  if (key.Table)
  {
    terrain->SetLookupTable(key.Table);
  }
  else
  {
    key.Table = terrain->GetLookupTable();
  }
  return key;
}
