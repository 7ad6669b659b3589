// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Samples in memory as field data describe them (vtkTerrainRasterReader::SetSamples). Private to
 * the module.
 */
#ifndef vtkTerrain_raster_RasterSamples_h
#define vtkTerrain_raster_RasterSamples_h

#include "raster/RasterFile.h"

class vtkFieldData;

namespace terrain
{
/// Throws RasterError if the field data describe no samples.
RasterMemory MemoryOf(vtkFieldData* samples);
}
#endif
