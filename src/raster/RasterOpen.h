// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From the name that people give to a dataset: files, archives, folders of tiles, headers beside
 * the data, one part of several. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterOpen_h
#define vtkTerrain_raster_RasterOpen_h

#include "raster/HeldFiles.h"
#include "raster/RasterRecord.h"

#include <gdal.h>

#include <string>

namespace terrain
{
/// True if a word of a name is one that heights are called by: "z", "elevation", "dem", ...
bool HasWordOfHeights(const std::string& name);

/// Makes GDAL's drivers known, once.
void RegisterDrivers();

/// Opens a folder, or an archive of several rasters, as one raster; OpenRasterTiles (RasterTiles.h)
/// does. `part` says which of its sites. Throws RasterError. The caller closes the dataset.
using FolderOpener = GDALDatasetH (*)(
  const std::string& directory, const std::string& part, RasterRecord& record, HeldFiles& held);

/// Opens a raster of at least one band: a name that GDAL opens, the one raster or the tiles in an
/// archive (.zip, .tar, .tgz) or a folder, the data that a sidecar lies beside (.sgrd, .hdr, .prj),
/// the part of the wanted name or number (from 1 on) of a file of several; without a name the only
/// part that is called as heights are. `name` becomes that of what was opened. Warnings of GDAL go
/// to the record. Without `openFolder` several rasters are an error. Throws RasterError. The caller
/// closes it.
GDALDatasetH OpenRaster(std::string& name, const std::string& wanted, RasterRecord& record,
  HeldFiles& held, FolderOpener openFolder);
}
#endif
