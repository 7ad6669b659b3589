// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One band of a raster file through GDAL's C API, without VTK. Private to the module.
 *
 * Errors are exceptions of type RasterError, whose text is one sentence; GDAL itself
 * prints nothing while a RasterFile is at work.
 */
#ifndef vtkTerrain_raster_RasterFile_h
#define vtkTerrain_raster_RasterFile_h

#include "raster/GDALTable.h"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace terrain
{
/// Why a raster cannot be used: one sentence without the file's name.
class RasterError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Collects the failures that GDAL reports on this thread while it lives, instead of printing them.
class GDALMessages
{
public:
  GDALMessages();
  ~GDALMessages();
  GDALMessages(const GDALMessages&) = delete;
  void operator=(const GDALMessages&) = delete;

  /// The first failure reported so far, as one line; empty if there was none.
  const std::string& GetFailure() const
  {
    return this->Failure;
  }

private:
  static void CPL_STDCALL Collect(CPLErr kind, CPLErrorNum number, const char* text);
  std::string Failure;
};

/// Pixels of a raster file: columns from its first, rows from its first (as a rule the
/// northernmost).
struct RasterWindow
{
  std::int64_t X = 0;
  std::int64_t Y = 0;
  std::int64_t Width = 0;
  std::int64_t Height = 0;
};

/// How the pixels of a raster lie on the ground, in metres.
struct RasterLayout
{
  /// GDAL's affine transform from pixel corners to the CRS; the identity if there is none.
  std::array<double, 6> GeoTransform{ { 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } };
  bool HasGeoTransform = false;
  /// WKT2:2019 of the CRS, empty if there is none.
  std::string CRS;
  bool IsGeographic = false;
  /// position = (coordinate in the CRS - Origin) * Scale, for x and y.
  std::array<double, 2> Origin{ { 0.0, 0.0 } };
  std::array<double, 2> Scale{ { 1.0, 1.0 } };
  /// True if the file's first row is the northernmost, its first column the easternmost.
  bool NorthFirst = true;
  bool EastFirst = false;
};

/// A raster file, one band of it; closed on destruction.
class RasterFile
{
public:
  /// Opens a file, or a directory of tiles as one, for reading. Throws RasterError.
  explicit RasterFile(const char* fileName);
  ~RasterFile();
  RasterFile(const RasterFile&) = delete;
  void operator=(const RasterFile&) = delete;

  /// Names, as GDAL tells them, of the files that the raster is read from. Not told are those that
  /// belong to the parts of a virtual raster or to the tiles of a directory.
  std::vector<std::string> GetFileNames() const;

  /// A CRS in place of the one that the file names: EPSG code, WKT or PROJ string. Throws if it is
  /// not understood.
  void SetCoordinateSystem(const std::string& definition);

  /// Takes band 1 and following; 0 takes the first one unless the file is a colour image. Throws.
  void SelectBand(int band);
  int GetBand() const
  {
    return this->BandNumber;
  }

  /// Bands of samples: without an alpha band at the end.
  int GetNumberOfBands() const;

  std::int64_t GetWidth() const;
  std::int64_t GetHeight() const;

  /// Type of the samples in memory: a real type of 8 to 64 bits; 64-bit integers become
  /// GDT_Float64.
  GDALDataType GetType() const;
  /// True for GDT_Byte with the sign that old files declare beside the type.
  bool IsSignedByte() const;
  bool IsInteger() const;

  std::string GetBandDescription() const;
  /// height = offset + scale * value, as the band declares it.
  void GetScaleAndOffset(double& scale, double& offset) const;
  /// Name of the heights' unit (of the band, else of the CRS's vertical axis), empty if unknown.
  std::string GetVerticalUnit() const;
  /// Metres in that unit; 1 if it is not a unit of length that is known.
  double GetMetresPerVerticalUnit() const;

  /// Throws where the pixels do not lie along the axes, or contradict their CRS.
  RasterLayout GetLayout() const;

  /// The declared NoData value if it can occur in the band's type.
  std::vector<double> GetDeclaredNoData() const;
  /// Well-known fill values that can only be fill in this band; sets `occur` if some of the blocks
  /// that are looked at hold one.
  std::vector<double> GetUndeclaredNoData(bool& occur) const;
  /// True if a mask or an alpha band says which pixels have data.
  bool HasMask() const;

  /// Reads pixels of the band, in the type of GetType or GDT_Float64; overview -1 is the full
  /// resolution. Row r, column c goes to buffer + r * lineBytes + c * pixelBytes (either may be
  /// negative). Signed bytes come with their sign. Throws if any of it cannot be read.
  void Read(int overview, const RasterWindow& window, void* buffer, GDALDataType type,
    std::int64_t pixelBytes, std::int64_t lineBytes) const;
  /// As above for the mask, one byte a pixel; 0 means no data.
  void ReadMask(int overview, const RasterWindow& window, unsigned char* buffer,
    std::int64_t pixelBytes, std::int64_t lineBytes) const;

  /// The smallest overview of at least 1 / reduction of the full width and height, else -1.
  int FindOverview(double reduction) const;
  /// Size of an overview, or of the full resolution for -1.
  void GetSize(int overview, std::int64_t& width, std::int64_t& height) const;
  /// Rows, and columns, that are cheap to read together.
  std::int64_t GetBlockRows(int overview) const;
  std::int64_t GetBlockColumns(int overview) const;

private:
  OGRSpatialReferenceH GetSpatialReference() const;
  GDALRasterBandH FindBand(int overview) const;
  void CheckColors() const;
  void SampleHeights(double& lowest, bool& fillOccurs) const;

  GDALDatasetH Dataset = nullptr;
  OGRSpatialReferenceH GivenReference = nullptr;
  GDALRasterBandH Band = nullptr;
  int BandNumber = 0;
};
}
#endif
