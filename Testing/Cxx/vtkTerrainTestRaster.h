// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Raster files for tests, written through GDAL's C API to the tests' output directory.
 */
#ifndef vtkTerrainTestRaster_h
#define vtkTerrainTestRaster_h

#include <cpl_string.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace vtkTerrainTesting
{
/// Path of a temporary file of a test; its directory exists.
inline std::string TemporaryFile(const std::string& name)
{
  const char* directory = std::getenv("VTKTERRAIN_TEST_OUTPUT_DIR");
  const std::filesystem::path folder = directory ? directory : ::testing::TempDir();
  std::filesystem::create_directories(folder);
  return (folder / name).string();
}

/// A raster file; values are row by row as the file stores them, the first band's first.
struct RasterFile
{
  int Width = 1;
  int Height = 1;
  std::vector<double> Values;
  GDALDataType Type = GDT_Int16;
  int Bands = 1;
  std::vector<double> GeoTransform; // none or 6
  int EPSG = 0;                     // 0 for none
  std::vector<std::string> Options; // of creation
  const char* Driver = "GTiff";

  /// Creates the file and leaves it open; the caller closes it.
  GDALDatasetH Create(const std::string& path) const
  {
    GDALAllRegister();
    char** options = nullptr;
    for (const std::string& option : this->Options)
    {
      options = CSLAddString(options, option.c_str());
    }
    GDALDatasetH dataset = GDALCreate(GDALGetDriverByName(this->Driver), path.c_str(), this->Width,
      this->Height, this->Bands, this->Type, options);
    CSLDestroy(options);
    if (!this->GeoTransform.empty())
    {
      std::vector<double> transform = this->GeoTransform;
      EXPECT_EQ(GDALSetGeoTransform(dataset, transform.data()), CE_None);
    }
    if (this->EPSG > 0)
    {
      OGRSpatialReferenceH srs = OSRNewSpatialReference(nullptr);
      EXPECT_EQ(OSRImportFromEPSG(srs, this->EPSG), OGRERR_NONE);
      EXPECT_EQ(GDALSetSpatialRef(dataset, srs), CE_None);
      OSRDestroySpatialReference(srs);
    }
    const auto count =
      static_cast<std::size_t>(this->Width) * static_cast<std::size_t>(this->Height);
    std::vector<double> values = this->Values;
    for (std::size_t band = 0; (band + 1) * count <= values.size(); ++band)
    {
      EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(dataset, static_cast<int>(band) + 1), GF_Write, 0, 0,
                  this->Width, this->Height, &values[band * count], this->Width, this->Height,
                  GDT_Float64, 0, 0),
        CE_None);
    }
    return dataset;
  }

  /// Writes the file and returns its path.
  std::string Write(const std::string& name) const
  {
    std::string path = TemporaryFile(name);
    GDALClose(this->Create(path));
    return path;
  }
};
}

#endif
