// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Keys to colours, with round numbers or names of classes.
#include "Annotations.h"

#include "Fonts.h"
#include "Messages.h"
#include "Options.h"
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
constexpr double kWidestTitle = 0.22;
/// Of the names of classes.
constexpr double kWidestName = 0.25;
/// Height of the row of a class, in sizes of its text.
constexpr double kRow = 1.35;
/// Part of the picture's height that legends take at most.
constexpr double kMostOfHeight = 0.92;
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
  /// Adds them so much higher.
  void AddTo(vtkRenderer* renderer, double up, double opacity)
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
    actor->SetPosition(0.0, up);
    renderer->AddViewProp(actor);
  }

private:
  vtkSmartPointer<vtkPoints> Points = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkCellArray> Cells = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkUnsignedCharArray> Colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
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

/// One key to colours at the right side of the picture: a bar with numbers, or classes with names,
/// and a title above it. Counts its height from the lower border of its panel.
class Legend
{
public:
  Legend(vtkRenderer* renderer, const LegendKey& key, const Options& options, double share)
    : Renderer(renderer)
    , Unit(std::min(options.Size[0], options.Size[1]))
    , Size(std::max(kSmallestBarText, static_cast<int>(TextPixels(kBarTextSize, options))))
    , Right(options.Size[0] - (kBarMargin + kPadding) * this->Unit)
    , Left(this->Right - kWidth * this->Unit)
    , Low(0.5 * this->Size + kPadding * this->Unit)
    , Room(share * options.Size[1] - 2.0 * kPadding * this->Unit)
  {
    if (key.Classes.empty())
    {
      this->Length = std::min(kLength * this->Unit, this->Room - 3.0 * this->Size);
      this->AddBar(key.Table);
      this->AddNumbers(key.Table);
    }
    else
    {
      this->AddClasses(key.Classes, options);
    }
    this->AddTitle(key.Title, options);
  }

  double GetHeight() const
  {
    double high = this->Low + this->Length;
    for (const LegendText& text : this->Texts)
    {
      high = std::max(high, text.Y + 0.5 * this->Size);
    }
    return high + kPadding * this->Unit;
  }

  /// Where its panel begins.
  double GetLeft() const
  {
    double left = this->Left;
    for (const LegendText& text : this->Texts)
    {
      left = std::min(left, text.X - WidthOf(this->Renderer, text.Text, this->Size));
    }
    return left - kPadding * this->Unit;
  }

  void Add(double low)
  {
    Rectangles panel;
    const double padding = kPadding * this->Unit;
    panel.Add(
      this->GetLeft(), 0.0, this->Right + padding, this->GetHeight(), { { 250, 251, 253 } });
    panel.AddTo(this->Renderer, low, kPanelOpacity);
    this->Shapes.AddTo(this->Renderer, low, 1.0);
    for (LegendText text : this->Texts)
    {
      text.Y += low;
      AddLegendText(this->Renderer, text, this->Size);
    }
  }

private:
  void AddBar(vtkScalarsToColors* table)
  {
    const double lowest = table->GetRange()[0];
    const double highest = std::max(table->GetRange()[1], lowest + 1e-9);
    this->Shapes.Add(
      this->Left - 1.0, this->Low - 1.0, this->Right + 1.0, this->Low + this->Length + 1.0, {});
    for (int part = 0; part < kParts; ++part)
    {
      const double value = lowest + (part + 0.5) / kParts * (highest - lowest);
      const unsigned char* color = table->MapValue(value);
      this->Shapes.Add(this->Left, this->Low + this->Length * part / kParts, this->Right,
        this->Low + this->Length * (part + 1) / kParts, { { color[0], color[1], color[2] } });
    }
  }

  void AddNumbers(vtkScalarsToColors* table)
  {
    const double lowest = table->GetRange()[0];
    const double highest = std::max(table->GetRange()[1], lowest + 1e-9);
    const double range = highest - lowest;
    const double step = RoundUp(range / std::min(kMostLabels, this->Length / (1.5 * this->Size)));
    const double gap = kGap * this->Unit;
    for (const double number : Multiples(step, lowest, highest))
    {
      const double y = this->Low + this->Length * (number - lowest) / range;
      this->Shapes.Add(this->Left - gap, y - 0.5, this->Left, y + 0.5, {});
      this->Texts.push_back({ GroupedNumber(number, step), this->Left - 2.0 * gap, y });
    }
  }

  /// Squares of colour with names, the first on top; of more than there is room for, those that
  /// occur most, and a warning.
  void AddClasses(const std::vector<LegendClass>& all, const Options& options)
  {
    const double row = kRow * this->Size;
    const auto most = static_cast<std::size_t>(std::max(1.0, (this->Room - 2.0 * row) / row));
    std::vector<vtkIdType> counts;
    counts.reserve(all.size());
    for (const LegendClass& one : all)
    {
      counts.push_back(one.Count);
    }
    std::sort(counts.rbegin(), counts.rend());
    const vtkIdType least = counts[std::min(most, counts.size()) - 1];
    std::vector<LegendClass> shown;
    for (const LegendClass& one : all)
    {
      if (one.Count >= least && shown.size() < most)
      {
        shown.push_back(one);
      }
    }
    if (shown.size() < all.size())
    {
      Warn("--legend: there is room for " + std::to_string(shown.size()) + " of " +
        std::to_string(all.size()) + " classes: those that cover most are shown");
    }
    this->Left = this->Right - this->Size;
    const double widest = kWidestName * options.Size[0];
    double y = this->Low + 0.5 * this->Size + row * static_cast<double>(shown.size() - 1);
    this->Length = y + 0.5 * this->Size - this->Low;
    for (const LegendClass& one : shown)
    {
      const double half = 0.45 * this->Size;
      this->Shapes.Add(
        this->Left - 1.0, y - half - 1.0, this->Left + 2.0 * half + 1.0, y + half + 1.0, {});
      BarColor color;
      for (std::size_t k = 0; k < color.Parts.size(); ++k)
      {
        color.Parts[k] = static_cast<unsigned char>(std::lround(255.0 * one.Color[k]));
      }
      this->Shapes.Add(this->Left, y - half, this->Left + 2.0 * half, y + half, color);
      const std::string name = BeginningOf(this->Renderer, one.Name, this->Size, widest);
      this->Texts.push_back({ name == one.Name ? name : name + "\xE2\x80\xA6", // three dots
        this->Left - 2.0 * kGap * this->Unit, y });
      y -= row;
    }
  }

  /// Lines from the bar up.
  void AddTitle(const std::string& title, const Options& options)
  {
    const double room = this->Right - (kBarMargin + kPadding) * this->Unit;
    const double widest = std::max(kWidestTitle * options.Size[0], 6.0 * this->Size);
    const std::vector<std::string> lines =
      LinesOf(this->Renderer, title, this->Size, std::min(widest, room), room);
    double y = this->Low + this->Length + 1.4 * this->Size;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line)
    {
      this->Texts.push_back({ *line, this->Right, y });
      y += kLineSpacing * this->Size;
    }
  }

  vtkRenderer* Renderer;
  double Unit;
  int Size; ///< of the text
  double Right;
  double Left;
  double Low;
  double Room;
  double Length = 0.0;
  Rectangles Shapes;
  std::vector<LegendText> Texts;
};
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
std::vector<double> Multiples(double step, double lowest, double highest)
{
  // counted, for a step may be lost beside a large number
  const double first = std::ceil(lowest / step - 1e-9);
  const double count = std::floor(highest / step + 1e-9) - first;
  std::vector<double> numbers;
  for (double k = 0.0; k <= count; k += 1.0)
  {
    const double number = step * (first + k);
    if (numbers.empty() || number > numbers.back())
    {
      numbers.push_back(number);
    }
  }
  return numbers;
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
double AddLegends(vtkRenderer* renderer, const std::vector<LegendKey>& keys, const Options& options)
{
  const double unit = std::min(options.Size[0], options.Size[1]);
  const double gap = kPadding * unit;
  std::vector<Legend> legends;
  double height = -gap;
  for (const LegendKey& key : keys)
  {
    legends.emplace_back(renderer, key, options, kMostOfHeight / static_cast<double>(keys.size()));
    height += legends.back().GetHeight() + gap;
  }
  // as one stands alone: the middle of its bar at that of the picture, if there is room
  const double bar = kLength * unit;
  const double above = height - (keys.empty() ? 0.0 : 0.5 * bar + kPadding * unit);
  double high = keys.size() == 1 && keys.front().Classes.empty() ? 0.5 * options.Size[1] + above
                                                                 : 0.5 * (options.Size[1] + height);
  double width = 0.0;
  for (Legend& legend : legends)
  {
    high -= legend.GetHeight();
    legend.Add(high);
    high -= gap;
    width = std::max(width, options.Size[0] - legend.GetLeft());
  }
  return width;
}
