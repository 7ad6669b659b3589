// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorBy.h"

#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "Statistics.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTerrainColors.h"
#include "vtkTerrainValues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace
{
/// The colours that the options name, else those of a raster's own table, else usual ones.
vtkSmartPointer<vtkTerrainColors> ChooseColors(const Options& options)
{
  const char* ofValues = options.ColorBy.IsAspect() ? "twilight" : "viridis";
  vtkSmartPointer<vtkTerrainColors> colors =
    options.Colors.MakeColors(options.ColorBy.IsGiven() ? ofValues : "");
  if (options.ColorBy.IsFile() && options.Colors.Colors.empty())
  {
    colors->ReadRaster(options.ColorBy.By, options.ColorBy.Band); // where it has one
  }
  return colors;
}

/// True if classes stand at single values: the colour just below one of them is still its own.
bool AreSingleValues(vtkTerrainColors* colors)
{
  if (!colors->IsDiscrete() || colors->GetNumberOfCategories() == 0)
  {
    return false;
  }
  const vtkSmartPointer<vtkColorTransferFunction> table = colors->MakeTable(0.0, 1.0);
  if (colors->GetNumberOfCategories() == 1)
  {
    return table->GetRange()[0] == table->GetRange()[1];
  }
  for (int k = 0; k < colors->GetNumberOfCategories(); ++k)
  {
    const double value = colors->GetCategoryValue(k);
    std::array<double, 3> at{};
    std::array<double, 3> below{};
    colors->GetCategoryColor(k, at.data());
    table->GetColor(value - 1e-6 * std::max(1.0, std::abs(value)), below.data());
    const bool isFirst = value <= table->GetRange()[0];
    if (!std::isfinite(value) || (!isFirst && below != at))
    {
      return false;
    }
  }
  return true;
}

/// Classes have one colour each, which no range and no order changes.
void CheckClasses(vtkTerrainColors* colors, const Options& options)
{
  if (!colors->IsDiscrete() || colors->GetNumberOfCategories() == 0)
  {
    return;
  }
  for (const auto& [option, isGiven] : { std::pair("--range", !options.Colors.Range.empty()),
         std::pair("--reverse", options.Colors.Reverse) })
  {
    if (isGiven)
    {
      throw Failure(option, "does not go with classes, which have a colour each: leave it out");
    }
  }
}

/// Puts the number of its class in the place of each value; warns of values that are no class.
void NumberClasses(vtkFloatArray* values, vtkTerrainColors* colors, const std::string& file)
{
  const vtkSmartPointer<vtkFloatArray> numbers = colors->FindCategories(values);
  std::set<float> unknown;
  for (vtkIdType k = 0; k < values->GetNumberOfValues(); ++k)
  {
    const float value = values->GetValue(k);
    float number = numbers->GetValue(k);
    const bool isClass = std::isfinite(number) &&
      static_cast<float>(colors->GetCategoryValue(static_cast<int>(number))) == value;
    if (std::isfinite(value) && !isClass)
    {
      unknown.insert(value);
    }
    number = isClass ? number : std::numeric_limits<float>::quiet_NaN();
    values->SetValue(k, number);
  }
  if (!unknown.empty())
  {
    std::ostringstream text;
    text << file << ": " << *unknown.begin() << " is none of the classes: it has no colour";
    if (unknown.size() > 1)
    {
      text << ", nor have " << unknown.size() - 1 << " more";
    }
    Warn(text.str());
  }
}
}

//------------------------------------------------------------------------------
ColorSource ReadColorSource(PlacedHeights& heights, const Options& options, Statistics& statistics)
{
  ColorSource source;
  source.Colors = ChooseColors(options);
  CheckClasses(source.Colors, options);
  if (!options.ColorBy.IsFile())
  {
    source.Title = options.ColorBy.IsSlope() ? "Slope in degrees"
      : options.ColorBy.IsAspect()           ? "Direction downhill in degrees"
                                             : kUsualLegend;
    return source;
  }
  const Stopwatch watch;
  const bool areSingle = AreSingleValues(source.Colors);
  const vtkNew<vtkTerrainValues> values;
  values->SetInputData(heights.Image);
  values->SetGeoreference(heights.Georeference);
  values->SetFileName(options.ColorBy.By);
  values->SetBand(options.ColorBy.Band);
  values->SetCoordinateSystem(options.Input.CoordinateSystem);
  values->SetKind(
    areSingle ? vtkTerrainValues::KindType::Classes : vtkTerrainValues::KindType::Automatic);
  values->Update();
  ThrowOnError(options.ColorBy.By);
  heights.Image = values->GetOutput();
  source.AreClasses = areSingle && values->AreClasses();
  if (source.AreClasses)
  {
    NumberClasses(vtkFloatArray::SafeDownCast(heights.Image->GetCellData()->GetArray(kColorValues)),
      source.Colors, options.ColorBy.By);
  }
  source.Title = values->GetTitle();
  source.Title += values->GetUnit().empty() ? "" : " in " + values->GetUnit();
  statistics.AddTime("color_by", watch.GetMilliseconds());
  return source;
}
