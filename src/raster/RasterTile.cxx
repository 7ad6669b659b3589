// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterTile.h"

#include "raster/GDALTable.h"
#include "raster/RasterFile.h"
#include "raster/RasterMessages.h"
#include "raster/RasterReference.h"
#include "raster/RasterTileAlone.h"
#include "raster/RasterUnits.h"
#include "raster/Words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>

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

double CoveredBy(const std::vector<RasterTile>& tiles, const std::vector<std::size_t>& site)
{
  double covered = 0.0;
  for (const std::size_t k : site)
  {
    covered += (tiles[k].East() - tiles[k].West()) * (tiles[k].North() - tiles[k].South());
  }
  return covered;
}

/// True if tiles cover next to nothing of the raster that they would make.
bool AreSparse(const std::vector<RasterTile>& tiles)
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
  return covered <= kLeastCover * area && area / cell >= kSmallRaster;
}

bool IsSamePlace(const RasterTile& tile, const std::array<double, 6>& transform)
{
  constexpr double kSame = 1e-6; // of a cell
  const double step = kSame * tile.GeoTransform[1];
  return std::equal(transform.begin(), transform.end(), tile.GeoTransform.begin(),
    [step](double a, double b) { return std::abs(a - b) <= step; });
}

bool AreNear(const RasterTile& a, const RasterTile& b)
{
  const double reachX = kSiteGap * std::max(a.East() - a.West(), b.East() - b.West());
  const double reachY = kSiteGap * std::max(a.North() - a.South(), b.North() - b.South());
  return b.West() - a.East() < reachX && a.West() - b.East() < reachX &&
    b.South() - a.North() < reachY && a.South() - b.North() < reachY;
}

/// Indices of tiles that are near each other, in the order of the first of each site; one site
/// unless most of the raster round all would be empty.
std::vector<std::vector<std::size_t>> FindSites(const std::vector<RasterTile>& tiles)
{
  std::vector<std::vector<std::size_t>> sites;
  std::vector<bool> isTaken(tiles.size(), false);
  const bool isOne = !AreSparse(tiles);
  for (std::size_t first = 0; first < tiles.size(); ++first)
  {
    if (isTaken[first])
    {
      continue;
    }
    // A site grows by what is near to a tile of it.
    std::vector<std::size_t> site{ first };
    isTaken[first] = true;
    for (std::size_t grown = 0; grown < site.size(); ++grown)
    {
      for (std::size_t k = first; k < tiles.size(); ++k)
      {
        if (!isTaken[k] && (isOne || AreNear(tiles[site[grown]], tiles[k])))
        {
          isTaken[k] = true;
          site.push_back(k);
        }
      }
    }
    std::sort(site.begin(), site.end());
    sites.push_back(std::move(site));
  }
  return sites;
}

/// What GDAL says of a tile.
void DescribeTile(GDALDatasetH dataset, GDALRasterBandH band, RasterTile& tile)
{
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
  tile.Description = !facts.Description.empty() ? facts.Description
    : facts.LongName.empty()                    ? facts.Variable
                                                : facts.LongName;
  tile.Warnings = own.GetWarnings();
  tile.Scale = meaning.Factor * tile.BandScale;
  tile.Offset = meaning.Factor * tile.BandOffset;
  tile.IsGeographic = reference && OSRIsGeographic(reference);
  tile.System = HorizontalSystem(reference);
}

/// What GDAL does not say of the place of a tile, as it is found where the tile is read alone.
void PlaceAsAlone(RasterTile& tile, bool isArray, HeldFiles& held)
{
  RasterFile file(tile.Path);
  file.SelectBand(0);
  file.TakeIn(RasterOptions());
  const RasterLayout& layout = file.GetLayout();
  // GDAL turns rows that run from the south, the array behind them does not.
  const bool isAsShown = !isArray ||
    (IsFromNorth(tile) && layout.HasGeoTransform && IsSamePlace(tile, layout.GeoTransform));
  if (file.IsReplaced() || file.IsTurned() || !isAsShown || layout.GeoTransform[5] > 0.0)
  {
    HoldAsAlone(tile, held);
    return;
  }
  OGRSpatialReferenceH reference = MakeReference(layout.CRS);
  tile.System = HorizontalSystem(reference);
  tile.IsGeographic = layout.IsGeographic;
  if (reference)
  {
    OSRRelease(reference);
  }
  if (layout.HasGeoTransform)
  {
    tile.GeoTransform = layout.GeoTransform;
  }
}

/// True if an image has one band that is no colour.
bool HasPlainBand(const std::string& path)
{
  try
  {
    RasterFile(path).SelectBand(0);
    return true;
  }
  catch (const RasterError&)
  {
    return false;
  }
}

/// The data that a file is for which GDAL does not open; empty if there is none.
std::string DataBehind(const std::string& path)
{
  try
  {
    const std::string data = FindDataOf(path);
    return data == path ? std::string() : data;
  }
  catch (const RasterError&)
  {
    return {};
  }
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
RasterTile ReadRasterTile(const std::string& path, HeldFiles& held)
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
    const std::string data = DataBehind(path);
    if (!data.empty())
    {
      return ReadRasterTile(data, held);
    }
    throw RasterError("its tile " + FileName(tile) + " is not a raster that GDAL can open" +
      (messages.GetFailure().empty() ? "" : " (" + messages.GetFailure() + ")"));
  }
  DescribeTile(dataset, band, tile);
  const std::string format = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
  GDALClose(dataset);
  if (format == "XYZ") // whose type is the least that holds its numbers
  {
    tile.Type = GDT_Float32;
  }
  const bool isText = format == "XYZ" || format == "AAIGrid";
  const bool isArray = tile.System.empty() && IsOneOf(format, { "netCDF", "Zarr", "HDF5Image" });
  if (IsNamedAsProduct(path)) // which is left out, or the folder refused for it
  {
    return tile;
  }
  if (isText || isArray)
  {
    PlaceAsAlone(tile, isArray, held);
  }
  else if ((tile.GeoTransform != std::array<double, 6>{} && !IsFromNorth(tile)) ||
    (tile.IsColour && tile.Bands > 1 && HasPlainBand(path)))
  {
    HoldAsAlone(tile, held);
  }
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
    if (!IsFromNorth(tile))
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
        "; name the CRS of that without one (gdal_translate -a_srs EPSG:N IN OUT.tif), or open "
        "them "
        "one by one");
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
void ChooseSite(std::vector<RasterTile>& tiles, const std::string& wanted, RasterRecord& record)
{
  const std::vector<std::vector<std::size_t>> sites = FindSites(tiles);
  char* end = nullptr;
  const long number = std::strtol(wanted.c_str(), &end, 10);
  const bool isNumber = !wanted.empty() && *end == '\0' && number >= 1;
  if (!wanted.empty() && (!isNumber || number > static_cast<long>(sites.size())))
  {
    throw RasterError("it has no part '" + wanted + "': " +
      (sites.size() > 1 ? "its sites are 1 to " + std::to_string(sites.size()) + " (--part N)"
                        : "its tiles make one raster"));
  }
  if (sites.size() == 1)
  {
    return;
  }
  // The one that covers most, unless one is named.
  std::size_t chosen = isNumber ? static_cast<std::size_t>(number - 1) : 0;
  std::vector<std::string> names;
  double most = 0.0;
  for (std::size_t k = 0; k < sites.size(); ++k)
  {
    names.push_back(std::to_string(k + 1) + " (" + FileName(tiles[sites[k].front()]) + ")");
    const double covered = CoveredBy(tiles, sites[k]);
    if (!isNumber && covered > most * (1.0 + 1e-6))
    {
      most = covered;
      chosen = k;
    }
  }
  record.Take("part", names[chosen], isNumber ? "given" : "site that covers most");
  if (!isNumber)
  {
    record.SetSites({ static_cast<int>(sites.size()), static_cast<int>(chosen) + 1,
      "its tiles lie at " + std::to_string(sites.size()) +
        " sites far from each other, of which number " + names[chosen] +
        " is taken, which covers most (--part N chooses another of " +
        ListText(names, kListedTiles) + ")" });
  }
  std::vector<RasterTile> kept;
  kept.reserve(sites[chosen].size());
  for (const std::size_t k : sites[chosen])
  {
    kept.push_back(std::move(tiles[k]));
  }
  tiles.swap(kept);
}
}
