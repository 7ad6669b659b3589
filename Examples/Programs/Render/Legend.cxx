// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours of heights, with round numbers.
#include "Annotations.h"

#include "Fonts.h"
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
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTerrainActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace
{
/// In shares of the shorter side of the picture.
constexpr double kBarMargin = 0.03;
constexpr double kLength = 0.4;
constexpr double kWidth = 0.024;
constexpr double kGap = 0.009;
constexpr double kPadding = 0.018;
constexpr double kBarTextSize = 0.029;
/// In pixels.
constexpr int kSmallestBarText = 8;
/// Most of the picture's width that a title takes before it goes on in another line.
constexpr double kWidestTitle = 0.3;
/// Between lines of a title, in shares of the size of its text.
constexpr double kLineSpacing = 1.25;
/// Of the panel behind all of it, which keeps it readable over any terrain.
constexpr double kPanelOpacity = 0.8;
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
  void AddTo(vtkRenderer* renderer, double opacity)
  {
    const vtkNew<vtkPolyData> shape;
    shape->SetPoints(this->Points);
    shape->SetPolys(this->Cells);
    shape->GetCellData()->SetScalars(this->Colors);
    const vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape);
    const vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(opacity);
    renderer->AddViewProp(actor);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkUnsignedCharArray> Colors;
};

/// A line of text, right-justified at a point, its middle at the height of the point.
struct LegendText
{
  std::string Text;
  double X;
  double Y;
};

void SetUpText(vtkTextProperty* property, const std::string& text, int size)
{
  ChooseFont(property, text);
  property->SetFontSize(size);
  property->SetColor(0.08, 0.10, 0.16);
  property->SetJustificationToRight();
  property->SetVerticalJustificationToCentered();
}

void AddLegendText(vtkRenderer* renderer, const LegendText& text, int size)
{
  const vtkNew<vtkTextActor> actor;
  actor->SetInput(text.Text.c_str());
  actor->SetPosition(text.X, text.Y);
  SetUpText(actor->GetTextProperty(), text.Text, size);
  renderer->AddViewProp(actor);
}

/// Width of a text in pixels.
double WidthOf(vtkRenderer* renderer, const std::string& text, int size)
{
  const vtkNew<vtkTextProperty> property;
  SetUpText(property, text, size);
  std::array<int, 4> box{ 0, -1, 0, -1 };
  vtkTextRenderer* texts = vtkTextRenderer::GetInstance();
  const bool isKnown = texts &&
    texts->GetBoundingBox(property, text, box.data(), renderer->GetRenderWindow()->GetDPI());
  return isKnown ? box[1] - box[0] + 1.0 : 0.6 * size * static_cast<double>(text.size());
}

/// The longest beginning of a word that is no wider than some pixels, of one letter at least.
std::string BeginningOf(vtkRenderer* renderer, const std::string& word, int size, double widest)
{
  const auto isInside = [&word](std::size_t k) // a letter of UTF-8
  { return k < word.size() && (static_cast<unsigned char>(word[k]) & 0xC0U) == 0x80U; };
  std::size_t end = word.size();
  while (end > 1 && (isInside(end) || WidthOf(renderer, word.substr(0, end), size) > widest))
  {
    --end;
  }
  while (isInside(end))
  {
    ++end;
  }
  return word.substr(0, end);
}

/// A title in lines that are no wider than some pixels; words go on in the next line only if they
/// are wider than all the room there is.
std::vector<std::string> LinesOf(
  vtkRenderer* renderer, const std::string& title, int size, double widest, double room)
{
  std::vector<std::string> lines;
  std::istringstream words(title);
  for (std::string word; words >> word;)
  {
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (!lines.empty() && WidthOf(renderer, longer, size) <= widest)
    {
      lines.back() = longer;
      continue;
    }
    while (!word.empty())
    {
      lines.push_back(BeginningOf(renderer, word, size, room));
      word.erase(0, lines.back().size());
    }
  }
  return lines;
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

/// The bar of colours, its numbers and its title, at the right side of the picture.
class Legend
{
public:
  Legend(vtkRenderer* renderer, vtkScalarsToColors* table, const Options& options)
    : Renderer(renderer)
    , Table(table)
    , Unit(std::min(options.Size[0], options.Size[1]))
    , Size(std::max(kSmallestBarText, static_cast<int>(TextPixels(kBarTextSize, options))))
    , Right(options.Size[0] - (kBarMargin + kPadding) * this->Unit)
    , Left(this->Right - kWidth * this->Unit)
    , Low(0.5 * (options.Size[1] - kLength * this->Unit))
    , Length(kLength * this->Unit)
    , Lowest(table->GetRange()[0])
    , Highest(std::max(table->GetRange()[1], this->Lowest + 1e-9))
  {
    this->AddBar();
    this->AddNumbers();
    this->AddTitle(options);
  }

  void Add()
  {
    Rectangles panel;
    const double padding = kPadding * this->Unit;
    const double half = 0.5 * this->Size;
    double left = this->Left;
    double high = this->Low + this->Length;
    for (const LegendText& text : this->Texts)
    {
      left = std::min(left, text.X - WidthOf(this->Renderer, text.Text, this->Size));
      high = std::max(high, text.Y + half);
    }
    panel.Add(left - padding, this->Low - half - padding, this->Right + padding, high + padding,
      { { 250, 251, 253 } });
    panel.AddTo(this->Renderer, kPanelOpacity);
    this->Shapes.AddTo(this->Renderer, 1.0);
    for (const LegendText& text : this->Texts)
    {
      AddLegendText(this->Renderer, text, this->Size);
    }
  }

private:
  void AddBar()
  {
    this->Shapes.Add(
      this->Left - 1.0, this->Low - 1.0, this->Right + 1.0, this->Low + this->Length + 1.0, {});
    for (int part = 0; part < kParts; ++part)
    {
      const double value = this->Lowest + (part + 0.5) / kParts * (this->Highest - this->Lowest);
      const unsigned char* color = this->Table->MapValue(value);
      this->Shapes.Add(this->Left, this->Low + this->Length * part / kParts, this->Right,
        this->Low + this->Length * (part + 1) / kParts, { { color[0], color[1], color[2] } });
    }
  }

  void AddNumbers()
  {
    const double range = this->Highest - this->Lowest;
    const double step = RoundUp(range / kMostLabels);
    const double gap = kGap * this->Unit;
    for (double number = step * std::ceil(this->Lowest / step - 1e-9);
         number <= this->Highest + 1e-9 * step; number += step)
    {
      const double y = this->Low + this->Length * (number - this->Lowest) / range;
      this->Shapes.Add(this->Left - gap, y - 0.5, this->Left, y + 0.5, {});
      this->Texts.push_back({ GroupedNumber(number, step), this->Left - 2.0 * gap, y });
    }
  }

  /// Lines from the bar up.
  void AddTitle(const Options& options)
  {
    const double room = this->Right - (kBarMargin + kPadding) * this->Unit;
    const double widest = std::max(kWidestTitle * options.Size[0], 6.0 * this->Size);
    const std::vector<std::string> lines =
      LinesOf(this->Renderer, options.Legend, this->Size, std::min(widest, room), room);
    double y = this->Low + this->Length + 1.4 * this->Size;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line)
    {
      this->Texts.push_back({ *line, this->Right, y });
      y += kLineSpacing * this->Size;
    }
  }

  vtkRenderer* Renderer;
  vtkScalarsToColors* Table;
  double Unit;
  int Size; ///< of the text
  double Right;
  double Left;
  double Low;
  double Length;
  double Lowest;
  double Highest;
  Rectangles Shapes;
  std::vector<LegendText> Texts;
};
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
void AddLegend(vtkRenderer* renderer, const Terrain& terrain, const Options& options)
{
  if (!options.Legend.empty())
  {
    Legend(renderer, terrain.Actor->GetLookupTable(), options).Add();
  }
}
