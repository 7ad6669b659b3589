// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What to do about files that GDAL does not open as rasters. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterRemedies_h
#define vtkTerrain_raster_RasterRemedies_h

#include <string>

namespace terrain
{
/// Why a file could not be opened and what to do about it, one sentence without the file's name;
/// GDAL's own reason, `failure`, comes last.
std::string WhyNotOpened(const std::string& name, const std::string& failure);
}
#endif
