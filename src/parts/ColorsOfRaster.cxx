// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours that a raster brings with it.
#include "core/files/OutputFile.h"
#include "parts/ColorsInternals.h"
#include "place/PlacedRaster.h"
#include "raster/RasterMessages.h"

#include <algorithm>
#include <sstream>

namespace terrain
{
namespace
{
/// A class of a band.
struct BandClass
{
  double Value = 0.0;
  std::string Name;
  std::optional<Color> Shade;
};

/// Rows of an attribute table that stand for one value each.
std::vector<BandClass> ReadAttributes(GDALRasterAttributeTableH table)
{
  std::vector<BandClass> classes;
  const auto column = [table](GDALRATFieldUsage usage)
  { return GDALRATGetColOfUsage(table, usage); };
  const int exact = column(GFU_MinMax);
  const int value = exact >= 0 ? exact : column(GFU_Min);
  const std::array<int, 3> parts = { column(GFU_Red), column(GFU_Green), column(GFU_Blue) };
  const bool hasColors = parts[0] >= 0 && parts[1] >= 0 && parts[2] >= 0;
  const int name = column(GFU_Name);
  for (int row = 0; row < GDALRATGetRowCount(table); ++row)
  {
    BandClass one;
    one.Value = value >= 0 ? GDALRATGetValueAsDouble(table, row, value) : row;
    one.Name = name >= 0 ? GDALRATGetValueAsString(table, row, name) : "";
    if (hasColors)
    {
      Color shade;
      for (int k = 0; k < 3; ++k)
      {
        const int part = GDALRATGetValueAsInt(table, row, parts[static_cast<std::size_t>(k)]);
        shade[k] = part / 255.0;
      }
      one.Shade = shade;
    }
    classes.push_back(one);
  }
  return classes;
}

/// Entries of a colour table that are opaque.
std::vector<BandClass> ReadColorTable(GDALColorTableH table)
{
  std::vector<BandClass> classes;
  for (int entry = 0; entry < GDALGetColorEntryCount(table); ++entry)
  {
    GDALColorEntry color{};
    if (GDALGetColorEntryAsRGB(table, entry, &color) && color.c4 > 0)
    {
      classes.push_back({ double(entry), "", Color(color.c1, color.c2, color.c3) / 255.0 });
    }
  }
  return classes;
}

void TakeNames(
  std::vector<BandClass>& classes, const std::vector<BandClass>& attributes, char** categories)
{
  const int count = CSLCount(categories);
  for (BandClass& one : classes)
  {
    const auto row = std::find_if(attributes.begin(), attributes.end(),
      [&one](const BandClass& attribute) { return attribute.Value == one.Value; });
    const bool isCategory = one.Value >= 0.0 && one.Value < count;
    one.Name = row != attributes.end() && !row->Name.empty() ? row->Name
      : isCategory ? categories[static_cast<std::ptrdiff_t>(one.Value)]
                   : one.Name;
    if (one.Name.empty())
    {
      std::ostringstream text;
      text << one.Value;
      one.Name = text.str();
    }
  }
}

/// The scheme of classes; why not if there are none with colours.
ColorFileResult ReadBandColors(GDALRasterBandH band)
{
  GDALRasterAttributeTableH table = GDALGetDefaultRAT(band);
  const std::vector<BandClass> attributes =
    table ? ReadAttributes(table) : std::vector<BandClass>{};
  GDALColorTableH colors = GDALGetRasterColorTable(band);
  std::vector<BandClass> classes = colors ? ReadColorTable(colors) : attributes;
  TakeNames(classes, attributes, GDALGetRasterCategoryNames(band));
  ColorFileResult result;
  result.Scheme.Along = ColorScheme::Axis::Values;
  std::sort(classes.begin(), classes.end(),
    [](const BandClass& a, const BandClass& b) { return a.Value < b.Value; });
  for (const BandClass& one : classes)
  {
    if (one.Shade)
    {
      result.Scheme.Stops.push_back({ one.Value, *one.Shade });
      result.Scheme.Classes.push_back({ one.Value, one.Name });
    }
  }
  result.Scheme.Stops = ExactStops(result.Scheme.Stops);
  result.WhyNot = result.Scheme.Stops.empty() ? "it has no colour table" : "";
  return result;
}

ColorFileResult ReadRasterColors(const std::string& path, int band)
{
  ColorFileResult result;
  result.WhyNot = WhyNoGDAL().empty() ? WhyNotInput(path) : WhyNoGDAL();
  if (!result.WhyNot.empty())
  {
    return result;
  }
  GDALAllRegister();
  const GDALMessages messages;
  const Dataset file =
    Own(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  const int bands = file ? GDALGetRasterCount(file.get()) : 0;
  if (band < 1 || band > bands)
  {
    result.WhyNot = file ? "it has no band " + std::to_string(band) : "it is no raster";
    return result;
  }
  return ReadBandColors(GDALGetRasterBand(file.get(), band));
}
}
}

//------------------------------------------------------------------------------
bool vtkTerrainColors::ReadRaster(const std::string& path, int band)
{
  terrain::ColorFileResult result = terrain::ReadRasterColors(path, band);
  this->ErrorMessage = result.WhyNot.empty() ? "" : "'" + path + "': " + result.WhyNot;
  if (!result.WhyNot.empty())
  {
    return false;
  }
  this->Internals->Scheme = std::move(result.Scheme);
  this->Modified();
  return true;
}
