// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// ParaView's presets: colour maps as JSON.
#include "data/ColorDocument.h"

#include "core/colors/ColorText.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>

namespace terrain
{
namespace
{
using JSON = nlohmann::json;

ColorFileResult Refuse(const std::string& why)
{
  ColorFileResult result;
  result.WhyNot = why;
  return result;
}

/// The member of an object; null without one.
const JSON& MemberOf(const JSON& object, const char* name)
{
  static const JSON none;
  const auto found = object.find(name);
  return found == object.end() ? none : *found;
}

/// Three numbers of a list, from 0 to 1, as a colour.
std::optional<Color> ColorOfList(const JSON& list, std::size_t first)
{
  Color color;
  for (int k = 0; k < 3; ++k)
  {
    const std::size_t at = first + static_cast<std::size_t>(k);
    if (!list.is_array() || at >= list.size() || !list[at].is_number())
    {
      return std::nullopt;
    }
    color[k] = list[at].get<double>();
    if (!(color[k] >= 0.0 && color[k] <= 1.0))
    {
      return std::nullopt;
    }
  }
  return color;
}

/// The colour of a member, where another one says that it is used.
std::optional<Color> ColorInUse(const JSON& map, const char* name, const char* isUsed)
{
  const JSON& use = MemberOf(map, isUsed);
  const bool isOn = use.is_boolean() ? use.get<bool>() : use.is_number() && use.get<double>() != 0;
  return isOn ? ColorOfList(MemberOf(map, name), 0) : std::nullopt;
}

/// Value and text of a class: the pair of a number in the list of annotations, where it has one.
ColorScheme::ClassName ClassOf(const JSON& annotations, std::size_t number)
{
  ColorScheme::ClassName one{ static_cast<double>(number), {} };
  const std::size_t at = 2 * number;
  if (annotations.is_array() && at + 1 < annotations.size())
  {
    const JSON& value = annotations[at];
    const std::optional<double> read = value.is_string() ? ToNumber(value.get<std::string>())
      : value.is_number() ? std::optional<double>(value.get<double>())
                          : std::nullopt;
    one.Value = read && std::isfinite(*read) ? *read : one.Value;
    one.Name = annotations[at + 1].is_string() ? annotations[at + 1].get<std::string>() : "";
  }
  return one;
}

ColorFileResult ReadIndexed(const JSON& map)
{
  const JSON& colors = MemberOf(map, "IndexedColors");
  ColorScheme scheme;
  scheme.Along = ColorScheme::Axis::Values;
  scheme.None = ColorOfList(MemberOf(map, "NanColor"), 0);
  for (std::size_t k = 0; 3 * k < colors.size(); ++k)
  {
    const std::optional<Color> color = ColorOfList(colors, 3 * k);
    if (!color)
    {
      return Refuse("colour " + std::to_string(k + 1) +
        " of IndexedColors needs r, g and b, numbers from 0 to 1");
    }
    scheme.Classes.push_back(ClassOf(MemberOf(map, "Annotations"), k));
    scheme.Stops.push_back({ scheme.Classes.back().Value, *color });
  }
  std::stable_sort(scheme.Stops.begin(), scheme.Stops.end(),
    [](const ColorStop& a, const ColorStop& b) { return a.Value < b.Value; });
  scheme.Stops = ExactStops(scheme.Stops);
  return { scheme, {} };
}

ColorFileResult ReadPoints(const JSON& map, const JSON& points)
{
  ColorScheme scheme;
  scheme.None = ColorOfList(MemberOf(map, "NanColor"), 0);
  scheme.Below = ColorInUse(map, "BelowRangeColor", "UseBelowRangeColor");
  scheme.Above = ColorInUse(map, "AboveRangeColor", "UseAboveRangeColor");
  for (std::size_t k = 0; k < points.size(); k += 4)
  {
    const std::optional<Color> color = ColorOfList(points, k + 1);
    if (!color || !points[k].is_number() || !std::isfinite(points[k].get<double>()))
    {
      return Refuse("point " + std::to_string(k / 4 + 1) +
        " of RGBPoints needs x, r, g and b, colours from 0 to 1");
    }
    scheme.Stops.push_back({ points[k].get<double>(), *color });
  }
  const JSON& space = MemberOf(map, "ColorSpace");
  return MixedIn(scheme, space.is_string() ? space.get<std::string>() : "RGB");
}
}

//------------------------------------------------------------------------------
ColorFileResult ReadColorMapPresets(const std::string& text)
{
  const JSON root = JSON::parse(text, nullptr, false);
  if (root.is_discarded())
  {
    return Refuse("it is no complete JSON");
  }
  const JSON& map = root.is_array() && !root.empty() ? root.front() : root;
  const JSON& points = map.is_object() ? MemberOf(map, "RGBPoints") : map;
  if (map.is_object() && points.is_array() && !points.empty())
  {
    return ReadPoints(map, points);
  }
  const JSON& indexed = map.is_object() ? MemberOf(map, "IndexedColors") : map;
  if (map.is_object() && indexed.is_array() && !indexed.empty())
  {
    return ReadIndexed(map);
  }
  return Refuse("there is no colour map with RGBPoints or IndexedColors in it");
}
}
