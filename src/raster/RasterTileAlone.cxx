// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterTileAlone.h"

#include "raster/GDALTable.h"
#include "raster/RasterFile.h"
#include "raster/RasterMessages.h"
#include "raster/RasterReference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numeric>
#include <system_error>
#include <utility>

namespace terrain
{
namespace
{
// Samples of a folder that are held in memory: 1 GiB of them.
constexpr std::int64_t kMostHeld = std::int64_t{ 1 } << 28;
// A tile that is warped takes the cells of the others where its own would differ by less than this.
constexpr double kLikeCells = 0.1;
// Names that are listed in a message.
constexpr std::size_t kListedNames = 5;

/// Heights in metres row by row from the north, each from the west; NaN for none.
std::vector<float> HeightsFromNorth(RasterFile& file)
{
  double scale = 1.0;
  double offset = 0.0;
  file.GetScaleAndOffset(scale, offset);
  const std::vector<double> samples = file.ReadHeights();
  const auto width = static_cast<std::size_t>(file.GetWidth());
  const std::size_t height = samples.size() / width;
  std::vector<float> heights(samples.size());
  for (std::size_t r = 0; r < height; ++r)
  {
    const std::size_t row = file.GetLayout().NorthFirst ? r : height - 1 - r;
    for (std::size_t c = 0; c < width; ++c)
    {
      const std::size_t column = file.GetLayout().EastFirst ? width - 1 - c : c;
      heights[row * width + column] = static_cast<float>(offset + scale * samples[r * width + c]);
    }
  }
  return heights;
}

std::array<double, 6> TransformFromNorth(const RasterFile& file)
{
  const std::array<double, 6>& t = file.GetLayout().GeoTransform;
  const double width = t[1] * static_cast<double>(file.GetWidth());
  const double height = t[5] * static_cast<double>(file.GetHeight());
  return { t[0] + std::min(width, 0.0), std::abs(t[1]), 0.0, t[3] + std::max(height, 0.0), 0.0,
    -std::abs(t[5]) };
}

/// What is true of all tiles that stand for others.
void DescribeHeld(RasterTile& tile, const std::string& path, GDALDatasetH dataset)
{
  tile.Path = path;
  tile.Width = GDALGetRasterXSize(dataset);
  tile.Height = GDALGetRasterYSize(dataset);
  tile.Bands = 1;
  GDALGetBlockSize(GDALGetRasterBand(dataset, 1), &tile.Block[0], &tile.Block[1]);
  tile.Type = GDT_Float32;
  GDALGetGeoTransform(dataset, tile.GeoTransform.data());
  tile.HasNoData = true;
  tile.NoData = std::numeric_limits<double>::quiet_NaN();
  tile.HasMask = false;
  tile.IsColour = false;
}

GDALDatasetH WriteHeld(
  const HeldFile& held, RasterFile& file, std::vector<float> heights, OGRSpatialReferenceH system)
{
  const auto width = static_cast<int>(file.GetWidth());
  const auto height = static_cast<int>(file.GetHeight());
  GDALDatasetH dataset = GDALCreate(
    GDALGetDriverByName("GTiff"), held.GetPath().c_str(), width, height, 1, GDT_Float32, nullptr);
  if (!dataset)
  {
    return nullptr;
  }
  std::array<double, 6> transform = TransformFromNorth(file);
  GDALSetGeoTransform(dataset, transform.data());
  if (system)
  {
    GDALSetSpatialRef(dataset, system);
  }
  GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  GDALSetRasterNoDataValue(band, std::numeric_limits<double>::quiet_NaN());
  if (GDALRasterIO(band, GF_Write, 0, 0, width, height, heights.data(), width, height, GDT_Float32,
        0, 0) != CE_None)
  {
    GDALClose(dataset);
    return nullptr;
  }
  return dataset;
}

void CheckHeldSize(const RasterFile& file, const HeldFiles& held)
{
  const std::int64_t before = std::accumulate(held.begin(), held.end(), std::int64_t{ 0 },
    [](std::int64_t sum, const auto& each) { return sum + each->GetSamples(); });
  if (before + file.GetWidth() * file.GetHeight() > kMostHeld)
  {
    throw RasterError("it does not fit into memory with the others that are no even grid from the "
                      "north as they stand: warp them into one file first (gdalwarp -dstnodata "
                      "-9999 TILES OUT.tif)");
  }
}

void HoldInMemory(RasterTile& tile, HeldFiles& held)
{
  RasterFile file(tile.Path, {}, nullptr);
  file.SelectBand(0);
  file.TakeIn(RasterOptions());
  const RasterLayout& layout = file.GetLayout();
  if (!layout.HasGeoTransform || file.IsTurned())
  {
    throw RasterError("it has no place, or its rows do not run from the north: make it one of the "
                      "others' kind (gdalwarp -dstnodata -9999 IN OUT.tif)");
  }
  CheckHeldSize(file, held);
  auto place = std::make_shared<HeldFile>(tile.Path, file.GetWidth() * file.GetHeight());
  OGRSpatialReferenceH system = MakeReference(layout.CRS);
  GDALDatasetH dataset = WriteHeld(*place, file, HeightsFromNorth(file), system);
  tile.System = HorizontalSystem(system);
  tile.IsGeographic = layout.IsGeographic;
  if (system)
  {
    OSRRelease(system);
  }
  if (!dataset)
  {
    throw RasterError("there is not enough memory for its samples");
  }
  DescribeHeld(tile, place->GetPath(), dataset);
  GDALClose(dataset);
  tile.IsOtherQuantity = tile.IsOtherQuantity && file.GetBand() == 1;
  tile.Scale = tile.BandScale = 1.0;
  tile.Offset = tile.BandOffset = 0.0;
  tile.Unit = "m";
  for (const std::string& warning : file.GetRecord().GetWarnings())
  {
    tile.Warnings.push_back(warning);
  }
  held.push_back(std::move(place));
}

/// A virtual raster of a tile in another CRS. The caller closes it.
GDALDatasetH WarpTile(const RasterTile& tile, const std::string& system, const std::string& path,
  const std::vector<double>& cells)
{
  std::error_code error;
  const std::string source = std::filesystem::absolute(tile.Path, error).string();
  GDALDatasetH dataset =
    GDALOpenEx(source.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
  std::vector<std::string> words{ "-of", "VRT", "-ot", "Float32", "-r", "bilinear", "-dstnodata",
    "nan", "-s_srs", tile.System, "-t_srs", system };
  const char* const names[] = { "-te", "", "", "", "-tr", "" };
  for (std::size_t k = 0; k < cells.size(); ++k)
  {
    if (*names[k] != '\0')
    {
      words.emplace_back(names[k]);
    }
    words.emplace_back(CPLSPrintf("%.17g", cells[k]));
  }
  char** list = nullptr;
  for (const std::string& word : words)
  {
    list = CSLAddString(list, word.c_str());
  }
  GDALWarpAppOptions* options = GDALWarpAppOptionsNew(list, nullptr);
  CSLDestroy(list);
  int wrong = 0;
  GDALDatasetH warped =
    dataset ? GDALWarp(path.c_str(), nullptr, 1, &dataset, options, &wrong) : nullptr;
  GDALWarpAppOptionsFree(options);
  if (dataset)
  {
    GDALClose(dataset);
  }
  return warped;
}

/// Where a tile goes in the grid of another: west, south, east, north, cells east and north. Empty
/// where its cells are of another size.
std::vector<double> SnapTo(const RasterTile& other, GDALDatasetH dataset)
{
  std::array<double, 6> t{};
  GDALGetGeoTransform(dataset, t.data());
  const double dx = other.GeoTransform[1];
  const double dy = -other.GeoTransform[5];
  if (std::abs(t[1] / dx - 1.0) > kLikeCells || std::abs(-t[5] / dy - 1.0) > kLikeCells)
  {
    return {};
  }
  const auto below = [](double x, double origin, double step)
  { return origin + std::floor((x - origin) / step) * step; };
  const auto above = [](double x, double origin, double step)
  { return origin + std::ceil((x - origin) / step) * step; };
  return { below(t[0], other.West(), dx),
    below(t[3] + GDALGetRasterYSize(dataset) * t[5], other.North(), dy),
    above(t[0] + GDALGetRasterXSize(dataset) * t[1], other.West(), dx),
    above(t[3], other.North(), dy), dx, dy };
}

/// True if GDAL's warper knows what of a tile is no height.
bool SaysItsHoles(const RasterTile& tile)
{
  RasterFile file(tile.Path, {}, nullptr);
  file.SelectBand(0);
  file.TakeIn(RasterOptions());
  const bool isFloat = tile.Type == GDT_Float32 || tile.Type == GDT_Float64;
  return tile.Bands == 1 && !tile.HasMask && (tile.HasNoData || !isFloat) &&
    !file.GetHoles().UndeclaredOccurs;
}

void BringInto(const RasterTile& first, RasterTile& tile, HeldFiles& held)
{
  const GDALMessages messages;
  const std::string name = tile.FileName();
  if (!SaysItsHoles(tile))
  {
    HoldAsAlone(tile, held);
  }
  auto place = std::make_shared<HeldFile>(tile.Path, 0);
  GDALDatasetH warped = WarpTile(tile, first.System, place->GetPath(), {});
  const std::vector<double> cells = warped ? SnapTo(first, warped) : std::vector<double>();
  if (!cells.empty())
  {
    GDALClose(warped);
    warped = WarpTile(tile, first.System, place->GetPath(), cells);
  }
  if (!warped)
  {
    throw RasterError("its tile " + name + " is in " + NameOfSystem(tile.System) +
      " and cannot be brought into " + NameOfSystem(first.System) + ", in which the others are" +
      (messages.GetFailure().empty() ? "" : " (" + messages.GetFailure() + ")") +
      ": open it alone");
  }
  DescribeHeld(tile, place->GetPath(), warped);
  GDALClose(warped);
  tile.System = first.System;
  tile.IsGeographic = first.IsGeographic;
  held.push_back(std::move(place));
}
}

//------------------------------------------------------------------------------
std::string FindDataOf(const std::string& path)
{
  return RasterFile(path, {}, nullptr).GetName();
}

//------------------------------------------------------------------------------
void HoldAsAlone(RasterTile& tile, HeldFiles& held)
{
  const std::string name = tile.FileName();
  try
  {
    HoldInMemory(tile, held);
  }
  catch (const RasterError& error)
  {
    throw RasterError("its tile " + name + " cannot be used: " + error.what());
  }
}

//------------------------------------------------------------------------------
void BringIntoOneSystem(std::vector<RasterTile>& tiles, HeldFiles& held, RasterRecord& record)
{
  const RasterTile first = tiles.front();
  std::vector<std::string> names;
  for (RasterTile& tile : tiles)
  {
    if (tile.System != first.System && !tile.System.empty() && !first.System.empty() &&
      !IsSameSystem(tile.System, first.System))
    {
      names.push_back(tile.FileName() + " of " + NameOfSystem(tile.System));
      BringInto(first, tile, held);
    }
  }
  if (!names.empty())
  {
    record.Warn("its tiles are in several CRSs: " + std::to_string(names.size()) + " of " +
      std::to_string(tiles.size()) + " are resampled into " + NameOfSystem(first.System) +
      ", in which " + first.FileName() + " is (" + ListText(names, kListedNames) +
      "); gdalwarp -t_srs CRS -dstnodata -9999 TILES OUT.tif brings all into another");
  }
}
}
