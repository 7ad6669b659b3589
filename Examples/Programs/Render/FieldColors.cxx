// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldColors.h"

#include "Failure.h"
#include "FieldOptions.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTerrainColors.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
/// Colours that most people tell apart. Source: M. Okabe, K. Ito, "Color Universal Design", 2008.
constexpr std::array<std::array<double, 3>, 8> kClassColors = { { { 0.90, 0.62, 0.00 },
  { 0.34, 0.71, 0.91 }, { 0.00, 0.62, 0.45 }, { 0.94, 0.89, 0.26 }, { 0.00, 0.45, 0.70 },
  { 0.84, 0.37, 0.00 }, { 0.80, 0.47, 0.65 }, { 0.10, 0.10, 0.10 } } };
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

vtkStringArray* TextsOf(vtkPolyData* mark)
{
  return vtkStringArray::SafeDownCast(mark->GetPointData()->GetAbstractArray("Field"));
}

bool IsNumber(const std::string& text, double& number)
{
  return CLI::detail::lexical_cast(text, number) && std::isfinite(number);
}

/// Number of a text: what it says, or that of its class.
class Numbers
{
public:
  explicit Numbers(const std::vector<vtkSmartPointer<vtkPolyData>>& marks)
  {
    for (vtkPolyData* mark : marks)
    {
      vtkStringArray* texts = TextsOf(mark);
      for (vtkIdType k = 0; k < texts->GetNumberOfValues(); ++k)
      {
        this->Take(texts->GetValue(k));
      }
    }
  }

  double Of(const std::string& text) const
  {
    if (text.empty())
    {
      return kNone;
    }
    double number = kNone;
    if (this->AreNumbers)
    {
      IsNumber(text, number);
      return number;
    }
    const auto found = std::find(this->Names.begin(), this->Names.end(), text);
    return static_cast<double>(found - this->Names.begin());
  }

  bool AreNumbers = true;
  double Lowest = HUGE_VAL;
  double Highest = -HUGE_VAL;
  std::vector<std::string> Names;
  std::vector<vtkIdType> Counts;

private:
  void Take(const std::string& text)
  {
    if (text.empty())
    {
      return;
    }
    double number = 0.0;
    const bool isNumber = IsNumber(text, number);
    this->AreNumbers = this->AreNumbers && isNumber;
    if (isNumber)
    {
      this->Lowest = std::min(this->Lowest, number);
      this->Highest = std::max(this->Highest, number);
    }
    const auto found = std::find(this->Names.begin(), this->Names.end(), text);
    if (found != this->Names.end())
    {
      ++this->Counts[static_cast<std::size_t>(found - this->Names.begin())];
    }
    else if (this->Names.size() <= kClassColors.size()) // one too many is remembered
    {
      this->Names.push_back(text);
      this->Counts.push_back(1);
    }
  }
};

LegendKey KeyOfClasses(const Numbers& numbers, const FieldOptions& options)
{
  if (numbers.Names.size() > kClassColors.size())
  {
    throw Failure(options.GetFieldOption(),
      "'" + options.ColorBy + "' has more than " + std::to_string(kClassColors.size()) +
        " texts, too many for colours: choose a field of numbers, or of fewer classes");
  }
  LegendKey key;
  const auto table = vtkSmartPointer<vtkLookupTable>::New();
  const auto count = static_cast<int>(numbers.Names.size());
  table->SetNumberOfTableValues(count);
  table->SetTableRange(-0.5, count - 0.5);
  for (int k = 0; k < count; ++k)
  {
    const auto at = static_cast<std::size_t>(k);
    const std::array<double, 3>& color = kClassColors[at];
    table->SetTableValue(k, color[0], color[1], color[2]);
    key.Classes.push_back({ numbers.Names[at], color, numbers.Counts[at] });
  }
  table->SetNanColor(0.5, 0.5, 0.5, 1.0);
  key.Table = table;
  return key;
}
}

//------------------------------------------------------------------------------
LegendKey ColorByField(
  const std::vector<vtkSmartPointer<vtkPolyData>>& marks, const FieldOptions& options)
{
  const Numbers numbers(marks);
  if (numbers.Names.empty())
  {
    throw Failure(options.GetFieldOption(), "'" + options.ColorBy + "' is empty in all features");
  }
  LegendKey key;
  if (numbers.AreNumbers)
  {
    key.Table = options.MakeColors()->MakeTable(numbers.Lowest, numbers.Highest);
  }
  else
  {
    key = KeyOfClasses(numbers, options);
  }
  key.Title = options.ColorBy;
  for (vtkPolyData* mark : marks)
  {
    vtkStringArray* texts = TextsOf(mark);
    const vtkNew<vtkDoubleArray> values;
    values->SetName(kFieldValue);
    for (vtkIdType k = 0; k < texts->GetNumberOfValues(); ++k)
    {
      values->InsertNextValue(numbers.Of(texts->GetValue(k)));
    }
    mark->GetPointData()->RemoveArray("Field");
    mark->GetPointData()->AddArray(values);
  }
  return key;
}

//------------------------------------------------------------------------------
void ColorByValue(vtkMapper* mapper, vtkScalarsToColors* table)
{
  if (table)
  {
    mapper->ScalarVisibilityOn();
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(kFieldValue);
    mapper->SetLookupTable(table);
    mapper->UseLookupTableScalarRangeOn();
    mapper->InterpolateScalarsBeforeMappingOn();
  }
}
