// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/colors/ColorScheme.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace terrain
{
namespace
{
/// Where flat ground stands in a scheme: with the plains.
constexpr double kFlatShare = 0.2;

/// A scheme of colours at even distances, 0xRRGGBB.
struct Table
{
  const char* Name;
  std::vector<std::uint32_t> Land;
  std::vector<std::uint32_t> Sea;
};

const std::vector<Table>& Tables()
{
  static const std::vector<Table> tables{
    { "grey", { 0x262626, 0xF7F7F7 }, {} },
    { "viridis",
      { 0x440154, 0x48186A, 0x472D7B, 0x424086, 0x3B528B, 0x33638D, 0x2C728E, 0x26828E, 0x21918C,
        0x1F9F88, 0x27AD81, 0x3DBC74, 0x5CC863, 0x81D34D, 0xAADC32, 0xD5E21A, 0xFDE725 },
      {} },
    { "cividis",
      { 0x00224E, 0x002E6A, 0x1A386F, 0x32436D, 0x434E6C, 0x535A6D, 0x61656F, 0x6F7073, 0x7D7C78,
        0x8B8778, 0x9A9376, 0xAAA073, 0xBBAD6D, 0xCCBA64, 0xDDC858, 0xEFD748, 0xFEE838 },
      {} },
    { "inferno",
      { 0x000004, 0x0B0724, 0x210C4A, 0x3D0965, 0x57106E, 0x71196E, 0x8A226A, 0xA32C61, 0xBC3754,
        0xD04545, 0xE35933, 0xF1711F, 0xF98C0A, 0xFCAA0F, 0xF9C932, 0xF2E865, 0xFCFFA4 },
      {} },
    { "batlow",
      { 0x011959, 0x0D315D, 0x114360, 0x175262, 0x226061, 0x356A59, 0x4D734D, 0x677B3E, 0x828231,
        0x9F892B, 0xBE9035, 0xDB954B, 0xF19D6B, 0xFCA890, 0xFDB4B4, 0xFCBFD6, 0xFACCFA },
      {} },
    { "lapaz",
      { 0x1A0C64, 0x202071, 0x24327E, 0x284289, 0x2D5393, 0x33629B, 0x3D71A0, 0x4B80A3, 0x5C8CA3,
        0x6F96A1, 0x859E9C, 0x9BA496, 0xB3AC96, 0xD0BAA0, 0xEACEB9, 0xF9E1D6, 0xFEF2F3 },
      {} },
    { "davos",
      { 0x00054A, 0x081C61, 0x143277, 0x214789, 0x2F5A96, 0x3E6B9C, 0x4E799D, 0x5D8499, 0x6C8E93,
        0x7A978D, 0x8BA388, 0xA0B289, 0xBBC794, 0xD9DFAD, 0xEFF0CB, 0xFAF9E6, 0xFEFEFE },
      {} },
    { "oslo",
      { 0x010101, 0x0A121B, 0x0E1E2E, 0x112B44, 0x15395B, 0x1C4873, 0x26578C, 0x3767A6, 0x507BBC,
        0x678BC7, 0x7B98CA, 0x8EA4C9, 0xA2B0CA, 0xB6BECD, 0xCED1D7, 0xE6E7E9, 0xFFFFFF },
      {} },
    { "twilight",
      { 0xE2D9E2, 0xD7D7DD, 0xC4CED4, 0xACC2CC, 0x95B5C7, 0x81A6C3, 0x7297C1, 0x6887BE, 0x6276BA,
        0x5F64B5, 0x5E51AD, 0x5D3DA1, 0x592A8F, 0x511B77, 0x45135C, 0x381145, 0x2F1436, 0x3A113A,
        0x4A1342, 0x5F174A, 0x741E4F, 0x872750, 0x983550, 0xA64550, 0xB25652, 0xBB6958, 0xC27C63,
        0xC89073, 0xCCA389, 0xD1B6A3, 0xD8C7BE, 0xDFD4D6, 0xE2D9E2 },
      {} },
    { "oleron",
      { 0x1A4C00, 0x405700, 0x63640A, 0x87792C, 0xAA9050, 0xCCAA73, 0xECC79A, 0xF8E2C0, 0xFDFDE6 },
      { 0x1A2659, 0x323F72, 0x4C598C, 0x6774A7, 0x8390C3, 0x9FACDE, 0xBAC7F3, 0xD0DDFA,
        0xE6F2FF } },
    { "bukavu",
      { 0x014026, 0x175616, 0x4B6D1A, 0x78762F, 0x9C7E43, 0xBB9569, 0xCEB99C, 0xDFD7D0, 0xEDEDFC },
      { 0x1A3333, 0x1E4255, 0x235786, 0x2D75AF, 0x3F92C8, 0x5BABCA, 0x78C5CC, 0xACE2D7,
        0xE4FEE5 } },
  };
  return tables;
}

std::vector<ColorStop> EvenStops(const std::vector<std::uint32_t>& colors)
{
  std::vector<ColorStop> stops;
  for (std::size_t k = 0; k < colors.size(); ++k)
  {
    const Color shade((colors[k] >> 16U) & 0xFFU, (colors[k] >> 8U) & 0xFFU, colors[k] & 0xFFU);
    stops.push_back(
      { static_cast<double>(k) / static_cast<double>(colors.size() - 1), shade / 255.0 });
  }
  return stops;
}

/// Green, brown and white above blue, as relief maps have them.
ColorScheme Relief()
{
  ColorScheme scheme;
  scheme.Stops = { { 0.0, { 0.46, 0.58, 0.38 } }, { 0.2, { 0.62, 0.67, 0.43 } },
    { 0.45, { 0.80, 0.73, 0.52 } }, { 0.7, { 0.66, 0.53, 0.42 } }, { 0.88, { 0.71, 0.68, 0.66 } },
    { 1.0, { 0.97, 0.97, 0.98 } } };
  scheme.SeaStops = { { 0.0, { 0.07, 0.19, 0.36 } }, { 0.7, { 0.25, 0.48, 0.66 } },
    { 0.999, { 0.60, 0.77, 0.83 } } };
  return scheme;
}

void Mirror(std::vector<ColorStop>& stops)
{
  if (stops.empty())
  {
    return;
  }
  const double sum = stops.front().Value + stops.back().Value;
  std::reverse(stops.begin(), stops.end());
  for (ColorStop& stop : stops)
  {
    stop.Value = sum - stop.Value;
  }
}

void AppendLaid(const std::vector<ColorStop>& shares, double lowest, double highest,
  std::vector<ColorStop>& stops)
{
  for (const ColorStop& stop : shares)
  {
    stops.push_back({ lowest + stop.Value * (highest - lowest), stop.Shade });
  }
}
}

//--------------------------------------------------------------------------------------------------
std::vector<std::string> ColorSchemeNames()
{
  std::vector<std::string> names{ "relief" };
  for (const Table& table : Tables())
  {
    names.emplace_back(table.Name);
  }
  return names;
}

std::optional<ColorScheme> FindColorScheme(const std::string& name)
{
  if (name == "relief")
  {
    return Relief();
  }
  for (const Table& table : Tables())
  {
    if (name == table.Name)
    {
      ColorScheme scheme;
      scheme.Stops = EvenStops(table.Land);
      scheme.SeaStops = EvenStops(table.Sea);
      return scheme;
    }
  }
  return std::nullopt;
}

ColorScheme Reversed(const ColorScheme& scheme)
{
  ColorScheme reversed = scheme;
  Mirror(reversed.Stops);
  Mirror(reversed.SeaStops);
  std::swap(reversed.Below, reversed.Above);
  if (!scheme.Stops.empty())
  {
    const double sum = scheme.Stops.front().Value + scheme.Stops.back().Value;
    std::reverse(reversed.Classes.begin(), reversed.Classes.end());
    for (ColorScheme::ClassName& name : reversed.Classes)
    {
      name.Value = sum - name.Value;
    }
  }
  return reversed;
}

ColorScheme LaidOver(const ColorScheme& scheme, const ColorRange& range)
{
  if (scheme.Along == ColorScheme::Axis::Values)
  {
    return scheme;
  }
  ColorScheme laid = scheme;
  laid.Along = ColorScheme::Axis::Values;
  laid.Stops.clear();
  laid.SeaStops.clear();
  double lowest = range.Lowest;
  if (range.HasSea && range.Lowest < 0.0 && !scheme.SeaStops.empty())
  {
    AppendLaid(scheme.SeaStops, range.Lowest, 0.0, laid.Stops);
    lowest = 0.0;
  }
  if (range.Highest > lowest)
  {
    AppendLaid(scheme.Stops, lowest, range.Highest, laid.Stops);
  }
  else if (laid.Stops.empty())
  {
    laid.Stops.push_back({ range.Lowest, ColorOf(scheme, kFlatShare) });
  }
  return laid;
}

ColorScheme Stretched(const ColorScheme& scheme, double lowest, double highest)
{
  ColorScheme stretched = scheme;
  stretched.Along = ColorScheme::Axis::Values;
  stretched.SeaStops.clear();
  if (scheme.Stops.empty())
  {
    return stretched;
  }
  const double first = scheme.Stops.front().Value;
  const double width = scheme.Stops.back().Value - first;
  const auto move = [&](double value)
  { return width > 0.0 ? lowest + (value - first) / width * (highest - lowest) : lowest; };
  for (ColorStop& stop : stretched.Stops)
  {
    stop.Value = move(stop.Value);
  }
  for (ColorScheme::ClassName& name : stretched.Classes)
  {
    name.Value = move(name.Value);
  }
  return stretched;
}

bool IsDiscrete(const ColorScheme& scheme)
{
  const auto isMixed = [](const ColorStop& a, const ColorStop& b)
  { return a.Value != b.Value && a.Shade != b.Shade; };
  return scheme.SeaStops.empty() &&
    std::adjacent_find(scheme.Stops.begin(), scheme.Stops.end(), isMixed) == scheme.Stops.end();
}

std::vector<int> ClassesOf(const ColorScheme& scheme, const std::vector<double>& values)
{
  struct Known
  {
    double Value;
    int Number;
    Color Shade;
  };
  std::vector<Known> known;
  known.reserve(scheme.Classes.size());
  for (const ColorScheme::ClassName& name : scheme.Classes)
  {
    known.push_back({ name.Value, static_cast<int>(known.size()), ColorOf(scheme, name.Value) });
  }
  std::sort(
    known.begin(), known.end(), [](const Known& a, const Known& b) { return a.Value < b.Value; });
  const auto find = [&](double value)
  {
    const Color shade = ColorOf(scheme, value);
    const auto above = std::upper_bound(
      known.begin(), known.end(), value, [](double v, const Known& one) { return v < one.Value; });
    if (above != known.begin() && (above - 1)->Shade == shade)
    {
      return (above - 1)->Number;
    }
    return above != known.end() && above->Shade == shade ? above->Number : -1;
  };
  std::vector<int> classes;
  classes.reserve(values.size());
  for (const double value : values)
  {
    classes.push_back(std::isnan(value) ? -1 : find(value));
  }
  return classes;
}

Color ColorOf(const ColorScheme& scheme, double value)
{
  const std::vector<ColorStop>& stops = scheme.Stops;
  if (stops.empty() || std::isnan(value))
  {
    return scheme.None.value_or(Color(0.0));
  }
  // the first stop above the value: of stops at the value itself the last one counts
  const auto above = std::upper_bound(stops.begin(), stops.end(), value,
    [](double v, const ColorStop& stop) { return v < stop.Value; });
  if (above == stops.begin())
  {
    return scheme.Below.value_or(stops.front().Shade);
  }
  const ColorStop& below = *(above - 1);
  if (above == stops.end())
  {
    return value > below.Value ? scheme.Above.value_or(below.Shade) : below.Shade;
  }
  const double share = (value - below.Value) / (above->Value - below.Value);
  return below.Shade + share * (above->Shade - below.Shade);
}
}
