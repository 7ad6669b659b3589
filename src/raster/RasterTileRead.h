// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens a tile of a directory and says what it is. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterTileRead_h
#define vtkTerrain_raster_RasterTileRead_h

#include "raster/HeldFiles.h"
#include "raster/RasterTile.h"

#include <string>

namespace terrain
{
/// Opens a tile and looks at what it says; one that GDAL alone does not show as it is read alone is
/// held in memory. Throws RasterError that names it.
RasterTile ReadRasterTile(const std::string& path, HeldFiles& held);
}
#endif
