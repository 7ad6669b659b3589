// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterTile.h"

#include "raster/GDALTable.h"
#include "raster/RasterMessages.h"
#include "raster/RasterReference.h"
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

/// True if a name holds a word of products that are no heights.
bool HasProductWord(std::string name)
{
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

void RemoveNamed(
  std::vector<RasterTile>& tiles, const std::vector<bool>& isLeftOut, RasterRecord& record)
{
  std::vector<std::string> names;
  std::vector<RasterTile> kept;
  for (std::size_t k = 0; k < tiles.size(); ++k)
  {
    if (isLeftOut[k])
    {
      names.push_back(tiles[k].FileName());
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
std::string RasterTile::FileName() const
{
  return CPLGetFilename(this->Path.c_str());
}

//------------------------------------------------------------------------------
bool IsFromNorth(const RasterTile& tile)
{
  return tile.GeoTransform[1] > 0.0 && tile.GeoTransform[5] < 0.0 && tile.GeoTransform[2] == 0.0 &&
    tile.GeoTransform[4] == 0.0;
}

//------------------------------------------------------------------------------
bool IsNamedAsProduct(const std::string& path)
{
  return HasProductWord(CPLGetFilename(path.c_str()));
}

//------------------------------------------------------------------------------
bool IsOtherQuantity(const std::string& description, const std::string& unit)
{
  return HasProductWord(description) ||
    IsOneOf(LowerCase(unit),
      { "degree", "degrees", "deg", "\xC2\xB0", "radian", "radians", "rad", "percent", "%",
        "pct" });
}

//------------------------------------------------------------------------------
void LeaveOutProducts(std::vector<RasterTile>& tiles, RasterRecord& record)
{
  const bool hasWide = std::any_of(tiles.begin(), tiles.end(),
    [](const RasterTile& tile)
    { return tile.Type != GDT_Byte && !tile.IsOtherQuantity && !IsNamedAsProduct(tile.Path); });
  std::vector<bool> isLeftOut;
  isLeftOut.reserve(tiles.size());
  for (const RasterTile& tile : tiles)
  {
    isLeftOut.push_back(IsNamedAsProduct(tile.Path) || tile.IsColour || tile.IsOtherQuantity ||
      (hasWide && tile.Type == GDT_Byte));
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
      throw RasterError("its tile " + tile.FileName() +
        " has no place, or its rows do not run from the north: make it one of the others' kind "
        "(gdalwarp)");
    }
    if (tile.System != first.System && !IsSameSystem(tile.System, first.System))
    {
      throw RasterError("its " + std::to_string(tiles.size()) +
        " tiles make no one raster: " + first.FileName() + " is in " + NameOfSystem(first.System) +
        ", " + tile.FileName() + " in " + NameOfSystem(tile.System) +
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
    names.push_back(std::to_string(k + 1) + " (" + tiles[sites[k].front()].FileName() + ")");
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
