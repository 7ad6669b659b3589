// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a directory needs to know of each of its tiles, and how they lie to each other. Private to
 * the module.
 */
#ifndef vtkTerrain_raster_RasterTile_h
#define vtkTerrain_raster_RasterTile_h

#include "raster/RasterRecord.h"

#include <gdal.h>

#include <array>
#include <string>
#include <vector>

namespace terrain
{
/// One raster file of a directory.
struct RasterTile
{
  std::string Path;
  int Width = 0;
  int Height = 0;
  int Bands = 0;
  std::array<int, 2> Block{ { 0, 0 } };
  GDALDataType Type = GDT_Unknown;
  std::array<double, 6> GeoTransform{};
  /// Horizontal CRS as WKT2; empty for none.
  std::string System;
  bool IsGeographic = false;
  /// metres = Offset + Scale * sample, heights up; what the tile itself says stands apart.
  double Scale = 1.0;
  double Offset = 0.0;
  double BandScale = 1.0;
  double BandOffset = 0.0;
  std::string Unit;
  /// What the band is called.
  std::string Description;
  bool HasNoData = false;
  double NoData = 0.0;
  bool HasMask = false;
  bool IsColour = false;
  /// True if its band is called, or has a unit, as slopes, shades and the like have.
  bool IsOtherQuantity = false;
  /// True if GDAL may not show it as it is read alone: points for a place, an alpha band that is no
  /// mask, another band for its heights, a CRS beside it, distances from a centre, halves.
  bool NeedsLook = false;
  /// Of its unit and sense.
  std::vector<std::string> Warnings;

  /// The last part of the path, for messages.
  std::string FileName() const;
  double West() const
  {
    return this->GeoTransform[0];
  }
  double East() const
  {
    return this->GeoTransform[0] + this->Width * this->GeoTransform[1];
  }
  double North() const
  {
    return this->GeoTransform[3];
  }
  double South() const
  {
    return this->GeoTransform[3] + this->Height * this->GeoTransform[5];
  }
  double CellArea() const
  {
    return this->GeoTransform[1] * -this->GeoTransform[5];
  }
};

/// True if a tile has a place, its rows run from the north and its columns from the west.
bool IsFromNorth(const RasterTile& tile);

/// True for names that hold a word of products that are no heights (hillshade, mask, slope, ...).
bool IsNamedAsProduct(const std::string& path);

/// True for what a band is called, or for its unit, where it holds slopes, shades and the like.
bool IsOtherQuantity(const std::string& description, const std::string& unit);

/// Leaves out what are no heights: by name, by what their band is called or its unit, colours, and
/// bytes beside wider types; warns of them.
void LeaveOutProducts(std::vector<RasterTile>& tiles, RasterRecord& record);

/// Throws RasterError that names the first tile of another CRS, or that is no grid from the north.
void CheckTiles(const std::vector<RasterTile>& tiles);

/// Moves tiles of degrees by a turn where that makes them lie nearer to each other.
void JoinDateLine(std::vector<RasterTile>& tiles, RasterRecord& record);

/// Leaves the tiles of one site where they are several, most of the raster round them being empty:
/// of the one with this number, from 1 on, or of the one that covers most, with a warning. Throws
/// RasterError if there is no such site.
void ChooseSite(std::vector<RasterTile>& tiles, const std::string& wanted, RasterRecord& record);
}
#endif
