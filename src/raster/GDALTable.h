// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * GDAL's C functions, found when the first of them is called. Private to the module.
 *
 * The module is compiled with GDAL's headers and is not linked to GDAL: it takes the GDAL that is
 * in the process already, else the one that is installed, whatever its version and its C++ string
 * ABI. Code in namespace terrain calls the functions by their own names, which are objects here
 * that hide GDAL's declarations:
 *
 *   GDALDatasetH dataset = GDALOpen(name, GA_ReadOnly);
 *
 * A function that is called and not listed below ends the build: the linker does not find it.
 */
#ifndef vtkTerrain_raster_GDALTable_h
#define vtkTerrain_raster_GDALTable_h

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_alg.h>
#include <gdal_utils.h>
#include <gdalwarper.h>
#include <ogr_srs_api.h>

#include <string>

/// The functions that the module calls: sorted, one line each.
// clang-format off
#define VTKTERRAIN_GDAL_FUNCTIONS(ENTRY)                                                           \
  ENTRY(CPLAtof)                                                                                   \
  ENTRY(CPLErrorReset)                                                                             \
  ENTRY(CPLEscapeString)                                                                           \
  ENTRY(CPLFormFilename)                                                                           \
  ENTRY(CPLGetErrorHandlerUserData)                                                                \
  ENTRY(CPLGetExtension)                                                                           \
  ENTRY(CPLGetFilename)                                                                            \
  ENTRY(CPLMalloc)                                                                                 \
  ENTRY(CPLPopErrorHandler)                                                                        \
  ENTRY(CPLPushErrorHandlerEx)                                                                     \
  ENTRY(CPLResetExtension)                                                                         \
  ENTRY(CPLSPrintf)                                                                                \
  ENTRY(CPLSetConfigOption)                                                                        \
  ENTRY(CSLAddString)                                                                              \
  ENTRY(CSLCount)                                                                                  \
  ENTRY(CSLDestroy)                                                                                \
  ENTRY(CSLFetchNameValue)                                                                         \
  ENTRY(CSLSetNameValue)                                                                           \
  ENTRY(CSLTokenizeString2)                                                                        \
  ENTRY(GDALAddBand)                                                                               \
  ENTRY(GDALAllRegister)                                                                           \
  ENTRY(GDALApplyGeoTransform)                                                                     \
  ENTRY(GDALApproxTransform)                                                                       \
  ENTRY(GDALAttributeGetName)                                                                      \
  ENTRY(GDALAttributeReadAsDouble)                                                                 \
  ENTRY(GDALAttributeReadAsDoubleArray)                                                            \
  ENTRY(GDALAttributeReadAsString)                                                                 \
  ENTRY(GDALAttributeRelease)                                                                      \
  ENTRY(GDALChunkAndWarpImage)                                                                     \
  ENTRY(GDALClose)                                                                                 \
  ENTRY(GDALCreate)                                                                                \
  ENTRY(GDALCreateApproxTransformer)                                                               \
  ENTRY(GDALCreateRPCTransformerV2)                                                                \
  ENTRY(GDALCreateTPSTransformer)                                                                  \
  ENTRY(GDALCreateWarpOperation)                                                                   \
  ENTRY(GDALCreateWarpOptions)                                                                     \
  ENTRY(GDALDataTypeIsComplex)                                                                     \
  ENTRY(GDALDatasetGetRootGroup)                                                                   \
  ENTRY(GDALDatasetRasterIOEx)                                                                     \
  ENTRY(GDALDeleteRasterNoDataValue)                                                               \
  ENTRY(GDALDestroyApproxTransformer)                                                              \
  ENTRY(GDALDestroyRPCTransformer)                                                                 \
  ENTRY(GDALDestroyTPSTransformer)                                                                 \
  ENTRY(GDALDestroyWarpOperation)                                                                  \
  ENTRY(GDALDestroyWarpOptions)                                                                    \
  ENTRY(GDALDimensionGetIndexingVariable)                                                          \
  ENTRY(GDALDimensionGetName)                                                                      \
  ENTRY(GDALDimensionGetSize)                                                                      \
  ENTRY(GDALExtendedDataTypeCreate)                                                                \
  ENTRY(GDALExtendedDataTypeRelease)                                                               \
  ENTRY(GDALExtractRPCInfoV2)                                                                      \
  ENTRY(GDALFillRaster)                                                                            \
  ENTRY(GDALFlushRasterCache)                                                                      \
  ENTRY(GDALGCPsToGeoTransform)                                                                    \
  ENTRY(GDALGetBlockSize)                                                                          \
  ENTRY(GDALGetColorEntryAsRGB)                                                                    \
  ENTRY(GDALGetColorEntryCount)                                                                    \
  ENTRY(GDALGetDataTypeName)                                                                       \
  ENTRY(GDALGetDataTypeSizeBytes)                                                                  \
  ENTRY(GDALGetDatasetDriver)                                                                      \
  ENTRY(GDALGetDefaultRAT)                                                                         \
  ENTRY(GDALGetDescription)                                                                        \
  ENTRY(GDALGetDriverByName)                                                                       \
  ENTRY(GDALGetDriverLongName)                                                                     \
  ENTRY(GDALGetDriverShortName)                                                                    \
  ENTRY(GDALGetFileList)                                                                           \
  ENTRY(GDALGetGCPCount)                                                                           \
  ENTRY(GDALGetGCPSpatialRef)                                                                      \
  ENTRY(GDALGetGCPs)                                                                               \
  ENTRY(GDALGetGeoTransform)                                                                       \
  ENTRY(GDALGetMaskBand)                                                                           \
  ENTRY(GDALGetMaskFlags)                                                                          \
  ENTRY(GDALGetMetadata)                                                                           \
  ENTRY(GDALGetMetadataItem)                                                                       \
  ENTRY(GDALGetOverview)                                                                           \
  ENTRY(GDALGetOverviewCount)                                                                      \
  ENTRY(GDALGetProjectionRef)                                                                      \
  ENTRY(GDALGetRasterBand)                                                                         \
  ENTRY(GDALGetRasterBandXSize)                                                                    \
  ENTRY(GDALGetRasterBandYSize)                                                                    \
  ENTRY(GDALGetRasterCategoryNames)                                                                \
  ENTRY(GDALGetRasterColorInterpretation)                                                          \
  ENTRY(GDALGetRasterColorTable)                                                                   \
  ENTRY(GDALGetRasterCount)                                                                        \
  ENTRY(GDALGetRasterDataType)                                                                     \
  ENTRY(GDALGetRasterNoDataValue)                                                                  \
  ENTRY(GDALGetRasterNoDataValueAsInt64)                                                           \
  ENTRY(GDALGetRasterNoDataValueAsUInt64)                                                          \
  ENTRY(GDALGetRasterOffset)                                                                       \
  ENTRY(GDALGetRasterScale)                                                                        \
  ENTRY(GDALGetRasterUnitType)                                                                     \
  ENTRY(GDALGetRasterXSize)                                                                        \
  ENTRY(GDALGetRasterYSize)                                                                        \
  ENTRY(GDALGetSpatialRef)                                                                         \
  ENTRY(GDALGroupGetAttribute)                                                                     \
  ENTRY(GDALGroupGetGroupNames)                                                                    \
  ENTRY(GDALGroupGetMDArrayNames)                                                                  \
  ENTRY(GDALGroupOpenGroup)                                                                        \
  ENTRY(GDALGroupOpenGroupFromFullname)                                                            \
  ENTRY(GDALGroupOpenMDArray)                                                                      \
  ENTRY(GDALGroupOpenMDArrayFromFullname)                                                          \
  ENTRY(GDALGroupRelease)                                                                          \
  ENTRY(GDALGroupResolveMDArray)                                                                   \
  ENTRY(GDALInvGeoTransform)                                                                       \
  ENTRY(GDALIdentifyDriverEx)                                                                      \
  ENTRY(GDALMDArrayAsClassicDataset)                                                               \
  ENTRY(GDALMDArrayGetAttribute)                                                                   \
  ENTRY(GDALMDArrayGetAttributes)                                                                  \
  ENTRY(GDALMDArrayGetDimensionCount)                                                              \
  ENTRY(GDALMDArrayGetDimensions)                                                                  \
  ENTRY(GDALMDArrayGetFullName)                                                                    \
  ENTRY(GDALMDArrayGetOffset)                                                                      \
  ENTRY(GDALMDArrayGetScale)                                                                       \
  ENTRY(GDALMDArrayGetTotalElementsCount)                                                          \
  ENTRY(GDALMDArrayGetUnit)                                                                        \
  ENTRY(GDALMDArrayGetView)                                                                        \
  ENTRY(GDALMDArrayRead)                                                                           \
  ENTRY(GDALMDArrayRelease)                                                                        \
  ENTRY(GDALOpen)                                                                                  \
  ENTRY(GDALOpenEx)                                                                                \
  ENTRY(GDALRATGetColOfUsage)                                                                      \
  ENTRY(GDALRATGetRowCount)                                                                        \
  ENTRY(GDALRATGetTableType)                                                                       \
  ENTRY(GDALRATGetValueAsDouble)                                                                   \
  ENTRY(GDALRATGetValueAsInt)                                                                      \
  ENTRY(GDALRATGetValueAsString)                                                                   \
  ENTRY(GDALRPCTransform)                                                                          \
  ENTRY(GDALRasterIO)                                                                              \
  ENTRY(GDALRasterIOEx)                                                                            \
  ENTRY(GDALReleaseAttributes)                                                                     \
  ENTRY(GDALReleaseDimensions)                                                                     \
  ENTRY(GDALSetDescription)                                                                        \
  ENTRY(GDALSetGeoTransform)                                                                       \
  ENTRY(GDALSetMetadata)                                                                           \
  ENTRY(GDALSetMetadataItem)                                                                       \
  ENTRY(GDALSetRasterNoDataValue)                                                                  \
  ENTRY(GDALSetRasterOffset)                                                                       \
  ENTRY(GDALSetRasterScale)                                                                        \
  ENTRY(GDALSetRasterUnitType)                                                                     \
  ENTRY(GDALSetSpatialRef)                                                                         \
  ENTRY(GDALTPSTransform)                                                                          \
  ENTRY(GDALTranslate)                                                                             \
  ENTRY(GDALTranslateOptionsFree)                                                                  \
  ENTRY(GDALTranslateOptionsNew)                                                                   \
  ENTRY(GDALVersionInfo)                                                                           \
  ENTRY(GDALWarp)                                                                                  \
  ENTRY(GDALWarpAppOptionsFree)                                                                    \
  ENTRY(GDALWarpAppOptionsNew)                                                                     \
  ENTRY(OCTClone)                                                                                  \
  ENTRY(OCTDestroyCoordinateTransformation)                                                        \
  ENTRY(OCTNewCoordinateTransformation)                                                            \
  ENTRY(OCTTransformEx)                                                                            \
  ENTRY(OSRClone)                                                                                  \
  ENTRY(OSRCloneGeogCS)                                                                            \
  ENTRY(OSRDemoteTo2D)                                                                             \
  ENTRY(OSRExportToWktEx)                                                                          \
  ENTRY(OSRGetAngularUnits)                                                                        \
  ENTRY(OSRGetAreaOfUse)                                                                           \
  ENTRY(OSRGetAttrValue)                                                                           \
  ENTRY(OSRGetAuthorityCode)                                                                       \
  ENTRY(OSRGetAxesCount)                                                                           \
  ENTRY(OSRGetAxis)                                                                                \
  ENTRY(OSRGetDataAxisToSRSAxisMapping)                                                            \
  ENTRY(OSRGetInvFlattening)                                                                       \
  ENTRY(OSRGetLinearUnits)                                                                         \
  ENTRY(OSRGetName)                                                                                \
  ENTRY(OSRGetSemiMajor)                                                                           \
  ENTRY(OSRGetSemiMinor)                                                                           \
  ENTRY(OSRGetTargetLinearUnits)                                                                   \
  ENTRY(OSRImportFromEPSG)                                                                         \
  ENTRY(OSRIsCompound)                                                                             \
  ENTRY(OSRIsGeocentric)                                                                           \
  ENTRY(OSRIsGeographic)                                                                           \
  ENTRY(OSRIsLocal)                                                                                \
  ENTRY(OSRIsProjected)                                                                            \
  ENTRY(OSRIsSameEx)                                                                               \
  ENTRY(OSRIsVertical)                                                                             \
  ENTRY(OSRNewSpatialReference)                                                                    \
  ENTRY(OSRRelease)                                                                                \
  ENTRY(OSRSetAxisMappingStrategy)                                                                 \
  ENTRY(OSRSetDataAxisToSRSAxisMapping)                                                            \
  ENTRY(OSRSetFromUserInput)                                                                       \
  ENTRY(OSRSetPROJSearchPaths)                                                                     \
  ENTRY(OSRStripVertical)                                                                          \
  ENTRY(VSICloseDir)                                                                               \
  ENTRY(VSIFCloseL)                                                                                \
  ENTRY(VSIFOpenL)                                                                                 \
  ENTRY(VSIFReadL)                                                                                 \
  ENTRY(VSIFree)                                                                                   \
  ENTRY(VSIGetNextDirEntry)                                                                        \
  ENTRY(VSIOpenDir)                                                                                \
  ENTRY(VSIStatL)                                                                                  \
  ENTRY(VSIUnlink)
// clang-format on

namespace terrain
{
/// Finds GDAL, once, in this order: what the environment variable VTKTERRAIN_GDAL names; a GDAL
/// that is in the process already; what AddGDAL was told, in that order; the system's. Afterwards
/// the coordinate systems (PROJ's proj.db) and the other data that came with it are found too,
/// unless PROJ_DATA, PROJ_LIB or GDAL_DATA say where. Returns why there is none, in one sentence
/// that names the remedy; empty if there is one. Safe to call from several threads.
const std::string& WhyNoGDAL();

/// Adds a library that is GDAL, or that brings GDAL when it is loaded, such as an extension module
/// of Python. Of no effect once GDAL has been found.
void AddGDAL(const std::string& path);

/// The file of the GDAL that is in use; empty if none has been needed yet, or there is none.
std::string GetGDALFile();

/// Finds GDAL as WhyNoGDAL does; throws std::runtime_error if there is none.
void RequireGDAL();

/// A function of GDAL: what is called, or pointed to, is the function of the GDAL that was found.
/// Throws as RequireGDAL.
template <typename Function>
class GDALFunction
{
public:
  operator Function*() const
  {
    RequireGDAL();
    return reinterpret_cast<Function*>(this->Address);
  }

  /// Filled when GDAL is found.
  void* Address = nullptr;
};

// A pointer does not keep what GDAL promises of results, such as that they must be looked at.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wignored-attributes"
// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared takes none
#define VTKTERRAIN_DECLARE(name) inline GDALFunction<decltype(::name)> name;
VTKTERRAIN_GDAL_FUNCTIONS(VTKTERRAIN_DECLARE)
#undef VTKTERRAIN_DECLARE
#pragma GCC diagnostic pop
}
#endif
