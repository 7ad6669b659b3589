// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterReference.h"

#include "raster/GDALTable.h"
#include "raster/RasterMessages.h"

namespace terrain
{
namespace
{
/// An item of the band, else of the dataset under the band's variable (netCDF: "h#positive").
std::string ItemOf(
  GDALDatasetH dataset, GDALRasterBandH band, const std::string& variable, const char* name)
{
  const char* item = GDALGetMetadataItem(band, name, nullptr);
  item = item ? item : GDALGetMetadataItem(dataset, (variable + "#" + name).c_str(), nullptr);
  return item ? item : "";
}

void AddVerticalFacts(OGRSpatialReferenceH reference, HeightFacts& facts)
{
  if (!OSRIsCompound(reference) && !OSRIsVertical(reference))
  {
    return;
  }
  char* name = nullptr;
  facts.VerticalMetres = OSRGetTargetLinearUnits(reference, "VERT_CS", &name);
  facts.VerticalUnit = name ? name : "";
  OGRAxisOrientation orientation = OAO_Other;
  OSRGetAxis(reference, "VERT_CS", 0, &orientation);
  facts.IsVerticalDown = orientation == OAO_Down;
}
}

//------------------------------------------------------------------------------
std::string WktOf(OGRSpatialReferenceH reference)
{
  const char* const options[] = { "FORMAT=WKT2_2019", nullptr };
  char* text = nullptr;
  std::string wkt;
  if (reference && OSRExportToWktEx(reference, &text, options) == OGRERR_NONE && text)
  {
    wkt = text;
  }
  CPLFree(text);
  return wkt;
}

//------------------------------------------------------------------------------
std::string HorizontalSystem(OGRSpatialReferenceH reference)
{
  if (!reference)
  {
    return {};
  }
  OGRSpatialReferenceH flat = OSRClone(reference);
  if (OSRIsCompound(flat))
  {
    OSRStripVertical(flat);
  }
  std::string wkt = WktOf(flat);
  OSRRelease(flat);
  return wkt;
}

//------------------------------------------------------------------------------
bool DefineReference(OGRSpatialReferenceH reference, const std::string& definition)
{
  const auto has = [&definition](const char* part)
  { return definition.find(part) != std::string::npos; };
  const bool isWkt = has("[");
  return !definition.empty() && (isWkt || !(has("://") || has("/vsi"))) &&
    OSRSetFromUserInput(reference, definition.c_str()) == OGRERR_NONE;
}

//------------------------------------------------------------------------------
OGRSpatialReferenceH MakeReference(const std::string& definition)
{
  const GDALMessages messages;
  OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
  OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER);
  if (!DefineReference(reference, definition))
  {
    OSRRelease(reference);
    return nullptr;
  }
  OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

//------------------------------------------------------------------------------
bool IsSameSystem(const std::string& one, const std::string& other)
{
  OGRSpatialReferenceH first = MakeReference(one);
  OGRSpatialReferenceH second = MakeReference(other);
  const char* const options[] = { "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
    "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS", nullptr };
  const bool same = first && second ? OSRIsSameEx(first, second, options) != 0 : first == second;
  for (OGRSpatialReferenceH reference : { first, second })
  {
    if (reference)
    {
      OSRRelease(reference);
    }
  }
  return same;
}

//------------------------------------------------------------------------------
std::string NameOfSystem(const std::string& definition)
{
  OGRSpatialReferenceH reference = MakeReference(definition);
  if (!reference)
  {
    return "no CRS";
  }
  const char* name = OSRGetName(reference);
  std::string text = name ? name : "unnamed";
  OSRRelease(reference);
  return text;
}

//------------------------------------------------------------------------------
HeightFacts FactsOfBand(GDALDatasetH dataset, GDALRasterBandH band, OGRSpatialReferenceH reference)
{
  HeightFacts facts;
  const char* unit = GDALGetRasterUnitType(band);
  facts.BandUnit = unit ? unit : "";
  const char* description = GDALGetDescription(band);
  facts.Description = description ? description : "";
  const char* variable = GDALGetMetadataItem(band, "NETCDF_VARNAME", nullptr);
  facts.Variable = variable ? variable : "";
  facts.Positive = ItemOf(dataset, band, facts.Variable, "positive");
  facts.StandardName = ItemOf(dataset, band, facts.Variable, "standard_name");
  facts.LongName = ItemOf(dataset, band, facts.Variable, "long_name");
  GDALDriverH driver = GDALGetDatasetDriver(dataset);
  facts.Driver = driver ? GDALGetDriverShortName(driver) : "";
  if (facts.BandUnit.empty())
  {
    facts.BandUnit = ItemOf(dataset, band, facts.Variable, "units");
  }
  if (facts.BandUnit.empty()) // "[m^2/s^2]"
  {
    const std::string named = ItemOf(dataset, band, facts.Variable, "GRIB_UNIT");
    facts.BandUnit = named.size() > 2 ? named.substr(1, named.size() - 2) : "";
  }
  if (reference)
  {
    AddVerticalFacts(reference, facts);
    if (OSRIsProjected(reference) || OSRIsLocal(reference))
    {
      char* name = nullptr;
      facts.HorizontalMetres = OSRGetLinearUnits(reference, &name);
      facts.HorizontalUnit = name ? name : "";
    }
  }
  return facts;
}
}
