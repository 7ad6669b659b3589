// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours of heights, with round numbers.
#include "Annotations.h"

#include "Options.h"
#include "Terrain.h"
#include "TextSize.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTerrainActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace
{
/// In shares of the picture's height.
constexpr double kBarMargin = 0.03;
constexpr double kLength = 0.36;
constexpr double kWidth = 0.022;
constexpr double kGap = 0.008;
constexpr double kBarTextSize = 0.026;
constexpr int kSmallestBarText = 8;
/// Parts of the bar, each of one colour.
constexpr int kParts = 256;
/// Most numbers beside the bar.
constexpr double kMostLabels = 6.0;

struct BarColor
{
  std::array<unsigned char, 3> Parts{ 20, 26, 41 };
};

/// Rectangles in pixels, each of one colour.
class Rectangles
{
public:
  Rectangles()
  {
    this->Colors->SetNumberOfComponents(3);
  }
  void Add(double left, double low, double right, double high, const BarColor& color)
  {
    const vtkIdType first = this->Points->InsertNextPoint(left, low, 0.0);
    this->Points->InsertNextPoint(right, low, 0.0);
    this->Points->InsertNextPoint(right, high, 0.0);
    this->Points->InsertNextPoint(left, high, 0.0);
    this->Cells->InsertNextCell({ first, first + 1, first + 2, first + 3 });
    this->Colors->InsertNextTypedTuple(color.Parts.data());
  }
  void AddTo(vtkRenderer* renderer)
  {
    const vtkNew<vtkPolyData> shape;
    shape->SetPoints(this->Points);
    shape->SetPolys(this->Cells);
    shape->GetCellData()->SetScalars(this->Colors);
    const vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape);
    const vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    renderer->AddViewProp(actor);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkUnsignedCharArray> Colors;
};

void AddLegendText(vtkRenderer* renderer, const std::string& text, double x, double y, double size)
{
  const vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(x, y);
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontSize(std::max(kSmallestBarText, static_cast<int>(size)));
  property->SetColor(0.08, 0.10, 0.16);
  property->SetJustificationToRight();
  property->SetVerticalJustificationToCentered();
  renderer->AddViewProp(actor);
}

/// 1, 2 or 5 times a power of ten, not less than a number above 0.
double RoundUp(double least)
{
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (factor * power >= least * (1.0 - 1e-9))
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

/// A number that is a multiple of a round step, with commas between thousands: "1,500", "0.25".
std::string GroupedNumber(double number, double step)
{
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
  const double power = std::pow(10.0, decimals);
  std::string text = std::to_string(std::llround(std::abs(number) * power));
  text.insert(0, std::max(0, decimals + 1 - static_cast<int>(text.size())), '0');
  const std::size_t whole = text.size() - static_cast<std::size_t>(decimals);
  std::string grouped;
  for (std::size_t k = 0; k < whole; ++k)
  {
    grouped += k > 0 && (whole - k) % 3 == 0 ? "," : "";
    grouped += text[k];
  }
  grouped += decimals > 0 ? "." + text.substr(whole) : "";
  const bool isZero = grouped.find_first_not_of("0.,") == std::string::npos;
  return (number < 0.0 && !isZero ? "\xE2\x88\x92" : "") + grouped; // the sign for minus
}
}

//------------------------------------------------------------------------------
void AddLegend(vtkRenderer* renderer, const Terrain& terrain, const Options& options)
{
  if (options.Legend.empty())
  {
    return;
  }
  vtkScalarsToColors* table = terrain.Actor->GetLookupTable();
  const double* range = table->GetRange();
  const double lowest = range[0];
  const double highest = std::max(range[1], lowest + 1e-9);
  const double height = options.Size[1];
  const double right = options.Size[0] - kBarMargin * height;
  const double left = right - kWidth * height;
  const double low = 0.5 * (1.0 - kLength) * height;
  const double length = kLength * height;
  Rectangles shapes;
  shapes.Add(left - 1.0, low - 1.0, right + 1.0, low + length + 1.0, {});
  for (int part = 0; part < kParts; ++part)
  {
    const double value = lowest + (part + 0.5) / kParts * (highest - lowest);
    const unsigned char* color = table->MapValue(value);
    shapes.Add(left, low + length * part / kParts, right, low + length * (part + 1) / kParts,
      { { color[0], color[1], color[2] } });
  }
  const double step = RoundUp((highest - lowest) / kMostLabels);
  const double tip = left - kGap * height;
  for (double number = step * std::ceil(lowest / step - 1e-9); number <= highest + 1e-9 * step;
       number += step)
  {
    const double y = low + length * (number - lowest) / (highest - lowest);
    shapes.Add(tip, y - 0.5, left, y + 0.5, {});
    AddLegendText(renderer, GroupedNumber(number, step), tip - kGap * height, y,
      TextPixels(kBarTextSize, options));
  }
  shapes.AddTo(renderer);
  AddLegendText(renderer, options.Legend, right,
    low + length + 1.2 * TextPixels(kBarTextSize, options), TextPixels(kBarTextSize, options));
}
