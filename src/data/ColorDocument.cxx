// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/ColorDocument.h"

#include "core/colors/ColorText.h"

#include "vtkCallbackCommand.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace terrain
{
namespace
{
/// The first element of a name, depth first; null if there is none.
vtkXMLDataElement* Find(vtkXMLDataElement* element, const char* name)
{
  if (!element || std::strcmp(element->GetName(), name) == 0)
  {
    return element;
  }
  for (int k = 0; k < element->GetNumberOfNestedElements(); ++k)
  {
    if (vtkXMLDataElement* found = Find(element->GetNestedElement(k), name))
    {
      return found;
    }
  }
  return nullptr;
}

std::string TextOf(vtkXMLDataElement* element, const char* attribute)
{
  const char* text = element->GetAttribute(attribute);
  return text ? text : "";
}

bool IsColor(const Color& color)
{
  return color.r >= 0.0 && color.g >= 0.0 && color.b >= 0.0 && color.r <= 1.0 && color.g <= 1.0 &&
    color.b <= 1.0;
}

/// Red, green and blue of attributes r, g, b.
std::optional<Color> ColorOfElement(vtkXMLDataElement* element)
{
  Color color;
  const bool isThere = element->GetScalarAttribute("r", color.r) != 0 &&
    element->GetScalarAttribute("g", color.g) != 0 &&
    element->GetScalarAttribute("b", color.b) != 0;
  return isThere && IsColor(color) ? std::optional<Color>(color) : std::nullopt;
}

ColorFileResult Refused(const std::string& why)
{
  ColorFileResult result;
  result.WhyNot = why;
  return result;
}

/// Parses a text, and calls with the first element of a name.
template <typename Read>
ColorFileResult WithElement(const std::string& text, const char* name, Read&& read)
{
  std::istringstream stream(text);
  vtkNew<vtkXMLDataParser> parser;
  vtkNew<vtkCallbackCommand> quiet; // the sentence returned is enough
  quiet->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  parser->AddObserver(vtkCommand::ErrorEvent, quiet);
  parser->SetStream(&stream);
  if (parser->Parse() == 0)
  {
    return Refused("it is no complete XML");
  }
  vtkXMLDataElement* element = Find(parser->GetRootElement(), name);
  return element ? read(element) : Refused("there is no <" + std::string(name) + "> in it");
}

ColorFileResult ReadShader(vtkXMLDataElement* shader)
{
  ColorScheme scheme;
  scheme.Along = ColorScheme::Axis::Values;
  for (int k = 0; k < shader->GetNumberOfNestedElements(); ++k)
  {
    vtkXMLDataElement* item = shader->GetNestedElement(k);
    if (std::strcmp(item->GetName(), "item") != 0)
    {
      continue;
    }
    const bool isInfinite = TextOf(item, "value") == "inf";
    const std::optional<double> value =
      isInfinite ? std::numeric_limits<double>::infinity() : ToNumber(TextOf(item, "value"));
    const std::optional<Color> color = ColorFromName(TextOf(item, "color"));
    if (!value || !color)
    {
      return Refused("item " + std::to_string(k + 1) + " needs a value and a colour #RRGGBB");
    }
    scheme.Stops.push_back({ *value, *color });
    if (!isInfinite || TextOf(shader, "colorRampType") == "DISCRETE")
    {
      scheme.Classes.push_back({ *value, TextOf(item, "label") });
    }
  }
  std::stable_sort(scheme.Stops.begin(), scheme.Stops.end(),
    [](const ColorStop& a, const ColorStop& b) { return a.Value < b.Value; });
  const std::string kind = TextOf(shader, "colorRampType");
  if (!HasLastOnly(scheme.Stops, kind == "EXACT"))
  {
    return Refused("'inf' ends the last class only: write it once, and with DISCRETE");
  }
  if (kind == "DISCRETE" || kind == "EXACT")
  {
    scheme.Stops = kind == "EXACT" ? ExactStops(scheme.Stops) : DiscreteStops(scheme.Stops);
    if (kind == "DISCRETE")
    {
      BeginClasses(scheme.Classes);
    }
  }
  else if (!scheme.Stops.empty() && std::isinf(scheme.Stops.back().Value))
  {
    scheme.Stops.pop_back();
  }
  return scheme.Stops.empty() ? Refused("there are no colours in it")
                              : ColorFileResult{ scheme, {} };
}

ColorFileResult ReadMap(vtkXMLDataElement* map)
{
  ColorScheme scheme;
  for (int k = 0; k < map->GetNumberOfNestedElements(); ++k)
  {
    vtkXMLDataElement* child = map->GetNestedElement(k);
    const std::string name = child->GetName();
    const std::optional<Color> color = ColorOfElement(child);
    const std::optional<double> value = ToNumber(TextOf(child, "x"));
    if (name == "Point" && color && value)
    {
      scheme.Stops.push_back({ *value, *color });
    }
    else if (name == "Point")
    {
      return Refused(
        "point " + std::to_string(k + 1) + " needs x, r, g and b, colours from 0 to 1");
    }
    else if (name == "NaN")
    {
      scheme.None = color;
    }
  }
  return MixedIn(scheme, TextOf(map, "space"));
}

/// How VTK mixes colours in a space of ParaView's; false for RGB.
bool ChooseSpace(vtkColorTransferFunction* table, const std::string& space)
{
  table->HSVWrapOff(); // as ParaView has it
  if (space == "HSV")
  {
    table->SetColorSpaceToHSV();
  }
  else if (space == "Lab" || space == "CIELAB")
  {
    table->SetColorSpaceToLab();
  }
  else if (space == "Lab/CIEDE2000")
  {
    table->SetColorSpaceToLabCIEDE2000();
  }
  else if (space == "Diverging")
  {
    table->SetColorSpaceToDiverging();
  }
  else if (space == "Step")
  {
    table->SetColorSpaceToStep();
  }
  else
  {
    return false;
  }
  return true;
}

/// Stops between those of a table that mixes in another space.
std::vector<ColorStop> SampledStops(
  vtkColorTransferFunction* table, const std::vector<ColorStop>& stops)
{
  std::vector<ColorStop> sampled;
  for (std::size_t k = 0; k + 1 < stops.size(); ++k)
  {
    sampled.push_back(stops[k]);
    const double from = stops[k].Value;
    const double length = stops[k + 1].Value - from;
    for (int i = 1; length > 0.0 && i < kStopsOfSpace; ++i)
    {
      const double value = from + length * i / kStopsOfSpace;
      Color color;
      table->GetColor(value, &color[0]);
      sampled.push_back({ value, glm::clamp(color, 0.0, 1.0) });
    }
  }
  sampled.push_back(stops.back());
  return sampled;
}
}

//------------------------------------------------------------------------------
ColorFileResult MixedIn(ColorScheme scheme, const std::string& space)
{
  if (scheme.Stops.empty())
  {
    return Refused("there are no colours in it");
  }
  std::stable_sort(scheme.Stops.begin(), scheme.Stops.end(),
    [](const ColorStop& a, const ColorStop& b) { return a.Value < b.Value; });
  scheme = Stretched(scheme, 0.0, 1.0);
  scheme.Along = ColorScheme::Axis::Shares;
  vtkNew<vtkColorTransferFunction> table;
  table->AllowDuplicateScalarsOn(); // at steps
  if (ChooseSpace(table, space))
  {
    for (const ColorStop& stop : scheme.Stops)
    {
      table->AddRGBPoint(stop.Value, stop.Shade.r, stop.Shade.g, stop.Shade.b);
    }
    scheme.Stops = SampledStops(table, scheme.Stops);
  }
  return { scheme, {} };
}

//------------------------------------------------------------------------------
ColorFileResult ReadStyle(const std::string& text)
{
  return WithElement(text, "colorrampshader", ReadShader);
}

ColorFileResult ReadColorMapDocument(const std::string& text)
{
  return WithElement(text, "ColorMap", ReadMap);
}
}
