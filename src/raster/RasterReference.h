// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a dataset's CRS and metadata say of it, through GDAL's C API. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterReference_h
#define vtkTerrain_raster_RasterReference_h

#include "raster/RasterUnits.h"

#include <gdal.h>
#include <ogr_srs_api.h>

#include <string>

namespace terrain
{
/// WKT2:2019 of a CRS; empty for null.
std::string WktOf(OGRSpatialReferenceH reference);

/// WKT2:2019 of the horizontal part of a CRS; empty for null.
std::string HorizontalSystem(OGRSpatialReferenceH reference);

/// True if two definitions mean the same coordinates.
bool IsSameSystem(const std::string& one, const std::string& other);

/// Name of a definition for messages; "no CRS" for an empty one.
std::string NameOfSystem(const std::string& definition);

/// Makes a CRS of a definition; false if it is not understood, or names a place in a network, which
/// GDAL would fetch.
bool DefineReference(OGRSpatialReferenceH reference, const std::string& definition);

/// A CRS from a definition, x first; null if it is not understood. The caller releases it.
OGRSpatialReferenceH MakeReference(const std::string& definition);

/// What a band, its metadata and the CRS (may be null) say of the unit and sense of heights.
HeightFacts FactsOfBand(GDALDatasetH dataset, GDALRasterBandH band, OGRSpatialReferenceH reference);
}
#endif
