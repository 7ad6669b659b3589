// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterTiles.h"

#include "core/strips/HierarchyFile.h"
#include "raster/FolderFiles.h"
#include "raster/GDALTable.h"
#include "raster/RasterMessages.h"
#include "raster/RasterReference.h"
#include "raster/RasterTile.h"
#include "raster/RasterTileAlone.h"
#include "raster/RasterTileRead.h"
#include "raster/TileOverlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace terrain
{
namespace
{
std::string Escaped(const std::string& text)
{
  char* escaped = CPLEscapeString(text.c_str(), static_cast<int>(text.size()), CPLES_XML);
  std::string result(escaped);
  CPLFree(escaped);
  return result;
}

std::string Exact(double value)
{
  return std::isnan(value) ? "nan" : CPLSPrintf("%.17g", value);
}

/// The raster that tiles make.
struct Mosaic
{
  std::vector<RasterTile> Tiles;
  double West = 0.0;
  double North = 0.0;
  double StepX = 0.0;
  double StepY = 0.0;
  int Width = 0;
  int Height = 0;
  int Bands = 1;
  /// True if samples stay as they are in the tiles: they all mean the same.
  bool IsUniform = true;
  GDALDataType Type = GDT_Float32;
  double NoData = 0.0;
};

/// A type that holds the samples and one value besides, for gaps.
GDALDataType TypeWithGaps(GDALDataType type, const std::vector<RasterTile>& tiles)
{
  const bool declared = std::all_of(tiles.begin(), tiles.end(),
    [&tiles](const RasterTile& tile)
    { return tile.HasNoData && tile.NoData == tiles.front().NoData; });
  if (declared && !std::isnan(tiles.front().NoData))
  {
    return type;
  }
  switch (type)
  {
    case GDT_Byte:
      return GDT_Int16;
    case GDT_UInt16:
      return GDT_Int32;
    case GDT_UInt32:
      return GDT_Float64;
    default:
      return type;
  }
}

double GapValue(GDALDataType type, const std::vector<RasterTile>& tiles)
{
  const bool declared = std::all_of(tiles.begin(), tiles.end(),
    [&tiles](const RasterTile& tile)
    { return tile.HasNoData && tile.NoData == tiles.front().NoData; });
  switch (type)
  {
    case GDT_Float32:
    case GDT_Float64:
      return std::numeric_limits<double>::quiet_NaN();
    case GDT_Int16:
      return declared ? tiles.front().NoData : -32768.0;
    default:
      return declared ? tiles.front().NoData : -2147483648.0;
  }
}

Mosaic PlanMosaic(std::vector<RasterTile> tiles)
{
  Mosaic mosaic;
  const RasterTile first = tiles.front();
  double east = first.East();
  double south = first.South();
  mosaic.West = first.West();
  mosaic.North = first.North();
  mosaic.StepX = first.GeoTransform[1];
  mosaic.StepY = -first.GeoTransform[5];
  mosaic.Bands = first.Bands;
  bool isWide = false;
  for (const RasterTile& tile : tiles)
  {
    mosaic.West = std::min(mosaic.West, tile.West());
    mosaic.North = std::max(mosaic.North, tile.North());
    east = std::max(east, tile.East());
    south = std::min(south, tile.South());
    mosaic.StepX = std::min(mosaic.StepX, tile.GeoTransform[1]);
    mosaic.StepY = std::min(mosaic.StepY, -tile.GeoTransform[5]);
    mosaic.Bands = tile.Bands == first.Bands ? mosaic.Bands : 1;
    mosaic.IsUniform = mosaic.IsUniform && tile.Scale == first.Scale &&
      tile.Offset == first.Offset && tile.Type == first.Type;
    isWide =
      isWide || tile.Type == GDT_Float64 || tile.Type == GDT_Int32 || tile.Type == GDT_UInt32;
  }
  const double width = std::floor((east - mosaic.West) / mosaic.StepX + 0.5);
  const double height = std::floor((mosaic.North - south) / mosaic.StepY + 0.5);
  if (!(width * height < 1e13) || width > 2147483647.0 || height > 2147483647.0)
  {
    throw RasterError("its tiles make a raster of " + NumberText(width) + " x " +
      NumberText(height) + " samples, which is too large: open fewer of them");
  }
  mosaic.Width = static_cast<int>(width);
  mosaic.Height = static_cast<int>(height);
  mosaic.Type = mosaic.IsUniform ? TypeWithGaps(first.Type, tiles)
    : isWide                     ? GDT_Float64
                                 : GDT_Float32;
  mosaic.NoData = GapValue(mosaic.Type, tiles);
  // The finest is drawn last, and so is what comes last by name of equally fine ones.
  std::stable_sort(tiles.begin(), tiles.end(),
    [](const RasterTile& a, const RasterTile& b)
    { return a.CellArea() > b.CellArea() * (1.0 + 1e-6); });
  mosaic.Tiles = std::move(tiles);
  return mosaic;
}

/// A tile as a source of the virtual raster (GDAL's VRT format).
std::string DescribeSource(const Mosaic& mosaic, const RasterTile& tile, int band)
{
  const double x = (tile.West() - mosaic.West) / mosaic.StepX;
  const double y = (mosaic.North - tile.North()) / mosaic.StepY;
  const double width = tile.Width * tile.GeoTransform[1] / mosaic.StepX;
  const double height = tile.Height * -tile.GeoTransform[5] / mosaic.StepY;
  const auto snap = [](double value)
  { return std::abs(value - std::round(value)) < 1e-3 ? std::round(value) : value; };
  const bool isSame = snap(width) == tile.Width && snap(height) == tile.Height;
  std::string text = isSame ? "<ComplexSource>" : "<ComplexSource resampling=\"bilinear\">";
  text += "<SourceFilename relativeToVRT=\"0\">" + Escaped(tile.Path) +
    "</SourceFilename><SourceBand>" + std::to_string(band) + "</SourceBand>";
  text += CPLSPrintf("<SourceProperties RasterXSize=\"%d\" RasterYSize=\"%d\" DataType=\"%s\" "
                     "BlockXSize=\"%d\" BlockYSize=\"%d\"/>",
    tile.Width, tile.Height, GDALGetDataTypeName(tile.Type), tile.Block[0], tile.Block[1]);
  text += CPLSPrintf(
    "<SrcRect xOff=\"0\" yOff=\"0\" xSize=\"%d\" ySize=\"%d\"/>", tile.Width, tile.Height);
  text += CPLSPrintf("<DstRect xOff=\"%.17g\" yOff=\"%.17g\" xSize=\"%.17g\" ySize=\"%.17g\"/>",
    snap(x), snap(y), snap(width), snap(height));
  if (tile.HasMask)
  {
    text += "<UseMaskBand>true</UseMaskBand>";
  }
  else if (tile.HasNoData)
  {
    text += "<NODATA>" + Exact(tile.NoData) + "</NODATA>";
  }
  if (!mosaic.IsUniform)
  {
    text += "<ScaleOffset>" + Exact(tile.Offset) + "</ScaleOffset><ScaleRatio>" +
      Exact(tile.Scale) + "</ScaleRatio>";
  }
  return text + "</ComplexSource>";
}

/// Why a tile that is not called as tiles are is none; empty if it is one.
std::string WhyNoTile(const RasterTile& tile, bool hasSystems)
{
  if (!IsFromNorth(tile))
  {
    return "its tile " + tile.FileName() +
      " has no place, or its rows do not run from the north (gdalwarp IN OUT.tif)";
  }
  return hasSystems && tile.System.empty() ? "its tile " + tile.FileName() +
      " names no CRS, as others do (gdal_translate -a_srs EPSG:N IN OUT.tif)"
                                           : std::string();
}

/// The tiles of these files. Those that are not called as tiles are left out, with a warning, where
/// they cannot be read or have no place, or no CRS beside others that have one.
std::vector<RasterTile> ReadTiles(
  const std::vector<std::string>& paths, HeldFiles& held, RasterRecord& record)
{
  std::vector<RasterTile> read;
  std::vector<bool> isCalled;
  for (const std::string& path : paths)
  {
    try
    {
      read.push_back(ReadRasterTile(path, held));
      isCalled.push_back(IsCalledTile(path));
    }
    catch (const RasterError& error)
    {
      if (IsHierarchyFile(path))
      {
        record.Warn("left out of the folder: " + std::string(CPLGetFilename(path.c_str())) +
          " is a file of terrain-prepare (name it alone to see it)");
        continue;
      }
      if (IsCalledTile(path))
      {
        throw;
      }
      record.Warn(std::string("left out of the folder: ") + error.what());
    }
  }
  const bool hasSystems = std::any_of(
    read.begin(), read.end(), [](const RasterTile& tile) { return !tile.System.empty(); });
  std::vector<RasterTile> tiles;
  for (std::size_t k = 0; k < read.size(); ++k)
  {
    const std::string why = isCalled[k] ? std::string() : WhyNoTile(read[k], hasSystems);
    if (why.empty())
    {
      tiles.push_back(std::move(read[k]));
    }
    else
    {
      record.Warn("left out of the folder: " + why);
    }
  }
  return tiles;
}

std::string DescribeMosaic(const Mosaic& mosaic)
{
  const RasterTile& first = mosaic.Tiles.front();
  std::string text = "<VRTDataset rasterXSize=\"" + std::to_string(mosaic.Width) +
    "\" rasterYSize=\"" + std::to_string(mosaic.Height) + "\">";
  text += "<GeoTransform>" + Exact(mosaic.West) + ", " + Exact(mosaic.StepX) + ", 0, " +
    Exact(mosaic.North) + ", 0, " + Exact(-mosaic.StepY) + "</GeoTransform>";
  for (int band = 1; band <= mosaic.Bands; ++band)
  {
    text += CPLSPrintf(
      "<VRTRasterBand dataType=\"%s\" band=\"%d\">", GDALGetDataTypeName(mosaic.Type), band);
    text += "<NoDataValue>" + Exact(mosaic.NoData) + "</NoDataValue>";
    if (mosaic.IsUniform)
    {
      text += "<Description>" + Escaped(first.Description) + "</Description><UnitType>" +
        Escaped(first.Unit) + "</UnitType><Offset>" + Exact(first.BandOffset) + "</Offset><Scale>" +
        Exact(first.BandScale) + "</Scale>";
      text += first.Scale * first.BandScale < 0.0
        ? "<Metadata><MDI key=\"positive\">down</MDI></Metadata>"
        : "";
    }
    else
    {
      text += "<UnitType>m</UnitType>";
    }
    for (const RasterTile& tile : mosaic.Tiles)
    {
      text += DescribeSource(mosaic, tile, band);
    }
    text += "</VRTRasterBand>";
  }
  return text + "</VRTDataset>";
}
}

//------------------------------------------------------------------------------
GDALDatasetH OpenRasterTiles(
  const std::string& directory, const std::string& site, RasterRecord& record, HeldFiles& held)
{
  const FolderFiles files = FindFolderFiles(directory);
  std::vector<RasterTile> tiles = ReadTiles(files.Rasters, held, record);
  if (tiles.empty())
  {
    const std::string others = DescribeOthers(files);
    throw RasterError(
      "it is a directory without elevation tiles" + (others.empty() ? "" : "; it holds " + others));
  }
  TellOfOthers(files, record);
  const std::size_t found = tiles.size();
  LeaveOutProducts(tiles, record);
  BringIntoOneSystem(tiles, held, record);
  CheckTiles(tiles);
  for (const RasterTile& tile : tiles)
  {
    for (const std::string& warning : tile.Warnings)
    {
      record.Warn(warning);
    }
  }
  JoinDateLine(tiles, record);
  ChooseSite(tiles, site, record);
  const Mosaic mosaic = PlanMosaic(std::move(tiles));
  TellOfOverlaps(mosaic.Tiles, record);
  record.Take("tiles",
    std::to_string(mosaic.Tiles.size()) + " of " + std::to_string(found) + " files", "folder");
  if (!mosaic.IsUniform)
  {
    record.Take("tiles' heights",
      "brought to metres one by one: their units, scales or types differ", "each tile");
  }
  const GDALMessages messages;
  GDALDatasetH terrain = GDALOpenEx(
    DescribeMosaic(mosaic).c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
  if (!terrain)
  {
    throw RasterError("its " + std::to_string(found) + " tiles make no one raster" +
      (messages.GetFailure().empty() ? "" : " (" + messages.GetFailure() + ")"));
  }
  if (OGRSpatialReferenceH reference = MakeReference(mosaic.Tiles.front().System))
  {
    GDALSetSpatialRef(terrain, reference);
    OSRRelease(reference);
  }
  return terrain;
}
}
