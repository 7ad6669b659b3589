// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterTile.h"

#include "raster/GDALTable.h"
#include "raster/RasterMessages.h"
#include "raster/RasterReference.h"
#include "raster/RasterUnits.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>

namespace terrain
{
namespace
{
// Names that are listed in a message.
constexpr std::size_t kListedTiles = 5;
// A raster is several sites if tiles cover less of it than this, and sites are farther from each
// other than this many tiles.
constexpr double kLeastCover = 0.1;
constexpr double kSiteGap = 2.0;
// Below this many samples nothing is too empty.
constexpr double kSmallRaster = 4e6;

std::string FileName(const RasterTile& tile)
{
  return CPLGetFilename(tile.Path.c_str());
}

bool IsColour(GDALDatasetH dataset)
{
  const GDALColorInterp color = GDALGetRasterColorInterpretation(GDALGetRasterBand(dataset, 1));
  return color == GCI_RedBand || color == GCI_PaletteIndex ||
    (GDALGetRasterCount(dataset) > 2 &&
      GDALGetRasterDataType(GDALGetRasterBand(dataset, 1)) == GDT_Byte);
}

void RemoveNamed(
  std::vector<RasterTile>& tiles, const std::vector<bool>& isLeftOut, RasterRecord& record)
{
  std::vector<std::string> names;
  std::vector<RasterTile> kept;
  for (std::size_t k = 0; k < tiles.size(); ++k)
  {
    if (isLeftOut[k])
    {
      names.push_back(FileName(tiles[k]));
    }
    else
    {
      kept.push_back(tiles[k]);
    }
  }
  if (!names.empty() && !kept.empty())
  {
    tiles.swap(kept);
    record.Warn(
      "left out of the folder, as they look like pictures, masks or derivatives of heights: " +
      ListText(names, kListedTiles) + " (open one alone to see it)");
  }
}
}

//------------------------------------------------------------------------------
bool IsNamedAsProduct(const std::string& path)
{
  std::string name = CPLGetFilename(path.c_str());
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::isalnum(c) ? std::tolower(c) : ' '); });
  name = " " + name + " ";
  for (const char* word : { "hillshade", "shade", "shaded", "slope", "aspect", "roughness", "tri",
         "tpi", "curvature", "wbm", "edm", "flm", "hem", "ql", "msk", "mask", "stk", "num", "swbd",
         "quality", "uncertainty", "browse", "thumb", "thumbnail", "preview", "ortho", "orthophoto",
         "count", "srtmswbd" })
  {
    if (name.find(" " + std::string(word) + " ") != std::string::npos)
    {
      return true;
    }
  }
  return name.find("hillshade") != std::string::npos;
}

//------------------------------------------------------------------------------
RasterTile ReadRasterTile(const std::string& path)
{
  const GDALMessages messages;
  RasterTile tile;
  tile.Path = path;
  GDALDatasetH dataset =
    GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
  GDALRasterBandH band =
    dataset && GDALGetRasterCount(dataset) > 0 ? GDALGetRasterBand(dataset, 1) : nullptr;
  if (!band)
  {
    if (dataset)
    {
      GDALClose(dataset);
    }
    throw RasterError("its tile " + FileName(tile) + " is not a raster that GDAL can open" +
      (messages.GetFailure().empty() ? "" : " (" + messages.GetFailure() + ")"));
  }
  tile.Width = GDALGetRasterXSize(dataset);
  tile.Height = GDALGetRasterYSize(dataset);
  tile.Bands = GDALGetRasterCount(dataset);
  GDALGetBlockSize(band, &tile.Block[0], &tile.Block[1]);
  tile.Type = GDALGetRasterDataType(band);
  if (GDALGetGeoTransform(dataset, tile.GeoTransform.data()) != CE_None)
  {
    tile.GeoTransform = {};
  }
  int given = 0;
  tile.NoData = GDALGetRasterNoDataValue(band, &given);
  tile.HasNoData = given != 0;
  const int flags = GDALGetMaskFlags(band);
  tile.HasMask = (flags & (GMF_ALL_VALID | GMF_NODATA)) == 0;
  tile.IsColour = IsColour(dataset);
  const double scale = GDALGetRasterScale(band, &given);
  tile.BandScale = given && std::isfinite(scale) && scale != 0.0 ? scale : 1.0;
  const double offset = GDALGetRasterOffset(band, &given);
  tile.BandOffset = given && std::isfinite(offset) ? offset : 0.0;
  OGRSpatialReferenceH reference = GDALGetSpatialRef(dataset);
  HeightFacts facts = FactsOfBand(dataset, band, reference);
  RasterRecord own;
  const HeightMeaning meaning = FindHeightMeaning(facts, own);
  tile.Unit = meaning.Unit;
  tile.Warnings = own.GetWarnings();
  tile.Scale = meaning.Factor * tile.BandScale;
  tile.Offset = meaning.Factor * tile.BandOffset;
  tile.IsGeographic = reference && OSRIsGeographic(reference);
  tile.System = HorizontalSystem(reference);
  GDALClose(dataset);
  return tile;
}

//------------------------------------------------------------------------------
void LeaveOutProducts(std::vector<RasterTile>& tiles, RasterRecord& record)
{
  const bool hasWide = std::any_of(tiles.begin(), tiles.end(),
    [](const RasterTile& tile) { return tile.Type != GDT_Byte && !IsNamedAsProduct(tile.Path); });
  std::vector<bool> isLeftOut;
  isLeftOut.reserve(tiles.size());
  for (const RasterTile& tile : tiles)
  {
    isLeftOut.push_back(
      IsNamedAsProduct(tile.Path) || tile.IsColour || (hasWide && tile.Type == GDT_Byte));
  }
  RemoveNamed(tiles, isLeftOut, record);
}

//------------------------------------------------------------------------------
void CheckTiles(const std::vector<RasterTile>& tiles)
{
  const RasterTile& first = tiles.front();
  for (const RasterTile& tile : tiles)
  {
    if (!(tile.GeoTransform[1] > 0.0) || !(tile.GeoTransform[5] < 0.0) ||
      tile.GeoTransform[2] != 0.0 || tile.GeoTransform[4] != 0.0)
    {
      throw RasterError("its tile " + FileName(tile) +
        " has no place, or its rows do not run from the north: make it one of the others' kind "
        "(gdalwarp)");
    }
    if (tile.System != first.System && !IsSameSystem(tile.System, first.System))
    {
      throw RasterError("its " + std::to_string(tiles.size()) +
        " tiles make no one raster: " + FileName(first) + " is in " + NameOfSystem(first.System) +
        ", " + FileName(tile) + " in " + NameOfSystem(tile.System) +
        "; warp them into one file first (gdalwarp TILES OUT.tif), or open them one by one");
    }
  }
}

//------------------------------------------------------------------------------
void JoinDateLine(std::vector<RasterTile>& tiles, RasterRecord& record)
{
  if (!tiles.front().IsGeographic)
  {
    return;
  }
  std::vector<std::pair<double, double>> spans;
  const auto turned = [](double x) { return x - 360.0 * std::floor((x + 180.0) / 360.0); };
  for (const RasterTile& tile : tiles)
  {
    const double west = turned(tile.West() + 1e-9) - 1e-9;
    spans.emplace_back(west, west + tile.East() - tile.West());
  }
  std::sort(spans.begin(), spans.end());
  // The widest gap on the circle: everything begins after it.
  double begin = spans.front().first;
  double end = spans.front().second;
  double widest = 0.0;
  for (const auto& [west, east] : spans)
  {
    if (west - end > widest)
    {
      widest = west - end;
      begin = west;
    }
    end = std::max(end, east);
  }
  if (spans.front().first + 360.0 - end >= widest)
  {
    begin = spans.front().first;
  }
  bool moved = false;
  for (RasterTile& tile : tiles)
  {
    double west = turned(tile.West() + 1e-9) - 1e-9;
    west += west < begin - 1e-6 ? 360.0 : 0.0;
    moved = moved || std::abs(west - tile.West()) > 1.0;
    tile.GeoTransform[0] = std::abs(west - tile.West()) > 1.0 ? west : tile.GeoTransform[0];
  }
  if (moved)
  {
    record.Take("date line", "tiles moved by a turn to lie side by side", "their longitudes");
  }
}

//------------------------------------------------------------------------------
void CheckSites(const std::vector<RasterTile>& tiles)
{
  double west = tiles.front().West();
  double east = tiles.front().East();
  double south = tiles.front().South();
  double north = tiles.front().North();
  double covered = 0.0;
  double cell = tiles.front().CellArea();
  for (const RasterTile& tile : tiles)
  {
    west = std::min(west, tile.West());
    east = std::max(east, tile.East());
    south = std::min(south, tile.South());
    north = std::max(north, tile.North());
    covered += (tile.East() - tile.West()) * (tile.North() - tile.South());
    cell = std::min(cell, tile.CellArea());
  }
  const double area = (east - west) * (north - south);
  if (covered > kLeastCover * area || area / cell < kSmallRaster)
  {
    return;
  }
  // The site of the first tile grows by what is near it.
  std::vector<bool> isNear(tiles.size(), false);
  std::vector<std::size_t> grown{ 0 };
  isNear[0] = true;
  while (!grown.empty())
  {
    const RasterTile& from = tiles[grown.back()];
    grown.pop_back();
    for (std::size_t k = 0; k < tiles.size(); ++k)
    {
      const RasterTile& to = tiles[k];
      const double reachX = kSiteGap * std::max(from.East() - from.West(), to.East() - to.West());
      const double reachY =
        kSiteGap * std::max(from.North() - from.South(), to.North() - to.South());
      if (!isNear[k] && to.West() - from.East() < reachX && from.West() - to.East() < reachX &&
        to.South() - from.North() < reachY && from.South() - to.North() < reachY)
      {
        isNear[k] = true;
        grown.push_back(k);
      }
    }
  }
  for (std::size_t k = 0; k < tiles.size(); ++k)
  {
    if (!isNear[k])
    {
      throw RasterError("its tiles lie far apart, " + FileName(tiles[0]) + " and " +
        FileName(tiles[k]) +
        " for example, and the raster round them would be empty for the most part: open them one "
        "by "
        "one, or put each site in a folder of its own");
    }
  }
}
}
