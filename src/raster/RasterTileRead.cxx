// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterTileRead.h"

#include "raster/GDALTable.h"
#include "raster/RasterFile.h"
#include "raster/RasterMessages.h"
#include "raster/RasterOpen.h"
#include "raster/RasterReference.h"
#include "raster/RasterRepairs.h"
#include "raster/RasterTileAlone.h"
#include "raster/RasterUnits.h"
#include "raster/Words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace terrain
{
namespace
{
bool IsColour(GDALDatasetH dataset)
{
  const GDALColorInterp color = GDALGetRasterColorInterpretation(GDALGetRasterBand(dataset, 1));
  return color == GCI_RedBand || color == GCI_PaletteIndex ||
    (GDALGetRasterCount(dataset) > 2 &&
      GDALGetRasterDataType(GDALGetRasterBand(dataset, 1)) == GDT_Byte);
}

/// True if GDAL may show something else than RasterFile does.
bool NeedsLook(GDALDatasetH dataset, GDALRasterBandH band, const RasterTile& tile)
{
  constexpr double kEarth = 6.37e6;
  constexpr double kLikeEarth = 0.01;
  constexpr double kSmallestRadius = 1e4;
  const bool hasPoints =
    tile.GeoTransform == std::array<double, 6>{} && GDALGetGCPCount(dataset) > 0;
  const bool hasAlpha = tile.Bands > 1 && !tile.HasMask &&
    GDALGetRasterColorInterpretation(GDALGetRasterBand(dataset, tile.Bands)) == GCI_AlphaBand;
  const std::string name = GDALGetDescription(band);
  const bool isOtherBand = tile.Bands > 1 && !name.empty() && !HasWordOfHeights(name);
  const bool isBeside = tile.System.empty() && !SystemBeside(tile.Path).empty();
  OGRErr error = OGRERR_NONE;
  OGRSpatialReferenceH reference = GDALGetSpatialRef(dataset);
  const double radius = reference ? OSRGetSemiMajor(reference, &error) : kEarth;
  const bool isOtherWorld = error == OGRERR_NONE && std::abs(radius / kEarth - 1.0) > kLikeEarth;
  const char* bits = GDALGetMetadataItem(band, "NBITS", "IMAGE_STRUCTURE");
  const bool isHalf = tile.HasNoData && tile.Type == GDT_Float32 && bits && std::atoi(bits) == 16;
  return hasPoints || hasAlpha || isOtherBand || isBeside || isOtherWorld || isHalf ||
    tile.BandOffset > kSmallestRadius;
}

bool IsSamePlace(const RasterTile& tile, const std::array<double, 6>& transform)
{
  constexpr double kSame = 1e-6; // of a cell
  const double step = kSame * tile.GeoTransform[1];
  return std::equal(transform.begin(), transform.end(), tile.GeoTransform.begin(),
    [step](double a, double b) { return std::abs(a - b) <= step; });
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
  tile.IsOtherQuantity = IsOtherQuantity(tile.Description, facts.BandUnit);
  tile.Warnings = own.GetWarnings();
  tile.Scale = meaning.Factor * tile.BandScale;
  tile.Offset = meaning.Factor * tile.BandOffset;
  tile.IsGeographic = reference && OSRIsGeographic(reference);
  tile.System = HorizontalSystem(reference);
  tile.NeedsLook = NeedsLook(dataset, band, tile);
}

/// What GDAL does not say of the place of a tile, as it is found where the tile is read alone.
void PlaceAsAlone(RasterTile& tile, bool isArray, HeldFiles& held)
{
  RasterFile file(tile.Path, {}, nullptr);
  file.SelectBand(0);
  file.TakeIn(RasterOptions());
  const RasterLayout& layout = file.GetLayout();
  // GDAL turns rows that run from the south, the array behind them does not.
  const bool isAsShown = !isArray ||
    (IsFromNorth(tile) && layout.HasGeoTransform && IsSamePlace(tile, layout.GeoTransform));
  const bool isOther = file.GetBand() != 1 || file.HasMask() != tile.HasMask ||
    file.GetHoles().Declared.size() > 1 ||
    (file.GetType() == GDT_Float64 && tile.Type == GDT_Int32);
  if (file.IsReplaced() || file.IsTurned() || !isAsShown || isOther || layout.GeoTransform[5] > 0.0)
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
  tile.Offset += file.GetHeights().Offset; // radii
}

/// True if an image has one band that is no colour.
bool HasPlainBand(const std::string& path)
{
  try
  {
    RasterFile(path, {}, nullptr).SelectBand(0);
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
    try // a grid of GMT 3, for one
    {
      HoldAsAlone(tile, held);
      return tile;
    }
    catch (const RasterError&)
    {
      throw RasterError("its tile " + tile.FileName() + " is not a raster that GDAL can open" +
        (messages.GetFailure().empty() ? "" : " (" + messages.GetFailure() + ")"));
    }
  }
  DescribeTile(dataset, band, tile);
  const std::string format = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
  GDALClose(dataset);
  if (format == "XYZ") // whose type is the least that holds its numbers
  {
    tile.Type = GDT_Float32;
  }
  const bool isText = format == "XYZ" || format == "AAIGrid";
  const bool isArray = IsOneOf(format, { "netCDF", "Zarr", "HDF5Image" });
  if (IsNamedAsProduct(path)) // which is left out, or the folder refused for it
  {
    return tile;
  }
  if (isText || isArray || tile.NeedsLook)
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
}
