// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One band of heights through GDAL's C API, without VTK: of a file, of a folder of tiles, or of
 * samples in memory with what their owner knows of them. All roads into the module end here.
 * Private to the module.
 *
 * Use: construct, SelectBand, TakeIn; then read. TakeIn finds place, unit, sense, holes and
 * orientation from all that the raster says, and where samples lie unevenly, along curved lines or
 * with rows for columns, puts an even raster in memory in its place.
 *
 * Errors are exceptions of type RasterError, whose text is one sentence; GDAL itself
 * prints nothing while a RasterFile is at work.
 */
#ifndef vtkTerrain_raster_RasterFile_h
#define vtkTerrain_raster_RasterFile_h

#include "raster/GridCoordinates.h"
#include "raster/HeldFiles.h"
#include "raster/RasterHoles.h"
#include "raster/RasterMessages.h"
#include "raster/RasterOpen.h"
#include "raster/RasterRecord.h"
#include "raster/RasterUnits.h"

#include <gdal.h>
#include <ogr_srs_api.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace terrain
{
class RasterArray;
struct EvenGrid;

/// A raster sheared by less than this many cells over its whole length is not sheared.
constexpr double kShearTolerance = 0.01;

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
  /// GDAL's affine transform from pixel corners to the CRS, x east and y north; the identity if
  /// there is none.
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

/// What the caller says in place of what the raster tells.
struct RasterOptions
{
  /// CRS: EPSG code, WKT or PROJ string; empty for the raster's own.
  std::string CoordinateSystem;
  /// Unit or metres per unit of heights (core/grid/HeightUnits.h); empty for the raster's own.
  std::string HeightUnit;
  /// True if the first row lies at the other side than the raster says.
  bool Flip = false;
  /// A value that is no height, besides those that the raster declares.
  bool UseNoData = false;
  double NoData = 0.0;
  /// True to look for fill values that it does not declare.
  bool DetectNoData = true;
};

/// Samples in memory and what their owner knows of them.
struct RasterMemory
{
  /// Row by row; must outlive the RasterFile.
  void* Samples = nullptr;
  GDALDataType Type = GDT_Unknown;
  int Width = 0;
  int Height = 0;
  std::string Name;
  /// As CF and GDAL name them: "units", "scale_factor", "positive", "_FillValue", ...
  std::map<std::string, std::string> Attributes;
  /// CRS of the coordinates; empty if it is not known.
  std::string CoordinateSystem;
  GridCoordinates Coordinates;
};

/// Values that are no heights.
struct RasterHoles
{
  std::vector<double> Declared;
  /// Fill that nobody declares, and whether some of it was seen.
  std::vector<double> Undeclared;
  bool UndeclaredOccurs = false;
  /// Samples beyond these are no heights, before scale and offset.
  double ValidLow = -HUGE_VAL;
  double ValidHigh = HUGE_VAL;
  /// Lowest and highest of the samples that were looked at, before scale and offset; low > high if
  /// all were fill.
  double Low = 1.0;
  double High = -1.0;
  /// What else they showed.
  FillFindings Seen;
};

/// A raster, one band of it; closed on destruction.
class RasterFile
{
public:
  /// Opens what a name stands for (RasterOpen.h) for reading: one raster, or with OpenRasterTiles
  /// (RasterTiles.h) as `openFolder` also many as one. An empty `part` stands for none. Throws
  /// RasterError.
  RasterFile(std::string fileName, const std::string& part, FolderOpener openFolder);
  /// Takes samples in memory. Throws RasterError.
  explicit RasterFile(const RasterMemory& memory);
  ~RasterFile();
  RasterFile(const RasterFile&) = delete;
  void operator=(const RasterFile&) = delete;

  /// Takes band 1 and following; 0 takes the first one unless the file is a colour image, or the
  /// only one of an image that is no colour. Throws.
  void SelectBand(int band);
  /// Finds everything else; once, after SelectBand. Throws.
  void TakeIn(const RasterOptions& options);

  /// The name that was opened: of the data, where that of a header was given.
  const std::string& GetName() const
  {
    return this->Name;
  }
  /// The band that SelectBand took, from 1 on.
  int GetBand() const
  {
    return this->BandNumber;
  }
  /// Bands of samples: without an alpha band at the end.
  int GetNumberOfBands() const
  {
    return this->NumberOfBands;
  }
  std::int64_t GetWidth() const;
  std::int64_t GetHeight() const;
  /// Files on disk that belong to it, as GDAL names them (InputFiles.cxx).
  std::vector<std::string> GetFileNames() const;

  /// Type of the samples in memory: a real type of 8 to 64 bits; 64-bit integers become
  /// GDT_Float64.
  GDALDataType GetType() const;
  /// True for GDT_Byte with the sign that old files declare beside the type.
  bool IsSignedByte() const;
  bool IsInteger() const;
  /// True if an even raster in memory stands for the file.
  bool IsReplaced() const
  {
    return this->Replaced;
  }
  /// True if x or y of the file were turned, for its CRS counts west or south.
  bool IsTurned() const
  {
    return this->Turned;
  }

  /// True if its coordinates were told in a unit other than metres.
  bool HasCoordinatesOfAnotherUnit() const
  {
    return this->Uneven.MetresPerUnit > 0.0 && this->Uneven.MetresPerUnit != 1.0;
  }

  std::string GetBandDescription() const;
  /// height in metres = offset + scale * value: of the band, its unit and its sense together.
  void GetScaleAndOffset(double& scale, double& offset) const;
  const HeightMeaning& GetHeights() const
  {
    return this->Heights;
  }
  const RasterLayout& GetLayout() const
  {
    return this->Layout;
  }
  const RasterHoles& GetHoles() const
  {
    return this->Holes;
  }
  /// What was taken from where, and warnings.
  RasterRecord& GetRecord()
  {
    return this->Record;
  }

  /// True if a mask, an alpha band or a range of valid values says which pixels have data.
  bool HasMask() const;

  /// Reads pixels of the band, in the type of GetType or GDT_Float64; overview -1 is the full
  /// resolution. Row r, column c goes to buffer + r * lineBytes + c * pixelBytes (either may be
  /// negative). Signed bytes come with their sign. Throws if any of it cannot be read.
  void Read(int overview, const RasterWindow& window, void* buffer, GDALDataType type,
    std::int64_t pixelBytes, std::int64_t lineBytes) const;
  /// As above for the mask, one byte a pixel; 0 means no data.
  void ReadMask(int overview, const RasterWindow& window, unsigned char* buffer,
    std::int64_t pixelBytes, std::int64_t lineBytes) const;

  /// All samples, before scale and offset, NaN for those that are no heights. Throws.
  std::vector<double> ReadHeights();

  /// The smallest overview of at least 1 / reduction of the full width and height, else -1.
  int FindOverview(double reduction) const;
  /// Size of an overview, or of the full resolution for -1.
  void GetSize(int overview, std::int64_t& width, std::int64_t& height) const;
  /// Rows, and columns, that are cheap to read together.
  std::int64_t GetBlockRows(int overview) const;
  std::int64_t GetBlockColumns(int overview) const;

private:
  GDALRasterBandH FindBand(int overview) const;
  int FindColors(int band) const;
  int FindNamedBand() const;
  static void ReadWindow(GDALRasterBandH band, const RasterWindow& window, void* buffer,
    GDALDataType type, std::int64_t pixelBytes, std::int64_t lineBytes);

  // RasterMask.cxx
  bool HasFileMask() const;
  bool HasValidRange() const;
  GDALRasterBandH FindAlpha() const;
  void TakeMissingValues();
  void FindValidRange();

  // RasterPlace.cxx
  void FindPlace(const RasterOptions& options);
  void PlaceByArray(const std::string& given);
  void PlaceByMemory(const std::string& given);
  void PlaceByGeolocation();
  void PlaceByText();
  void PlaceByColumns(const std::vector<std::string>& names);
  bool NeedsCoordinates() const;
  void TakePlace(const GridPlace& place, const std::string& system);
  void SetReference(const std::string& definition, const std::string& source);
  void TurnFileAxes();
  void PlaceSheared();
  std::string FindExchanged() const;
  bool HasDegreesForMetres() const;
  void WarnOfPlace();
  void MakeLayout();

  // RasterBeside.cxx
  void CheckUnitOfAxes();
  double FactorOfAxes(double metres);
  void PlaceByPoints();
  void PlaceByPolynomials();
  void TakeSystemOfPoints();
  bool BendToPoints(double cell);
  void TakeSystemBeside();

  // RasterIntake.cxx
  void FindHoles(const RasterOptions& options);
  std::vector<double> SampleBand() const;
  std::vector<double> GetDeclaredNoData() const;
  void FindHeights(const RasterOptions& options);
  void TakeRadii();
  void Resample();
  /// Heights of an even grid over the uneven one's; none if it spans no area.
  std::vector<double> MakeEven(EvenGrid& grid);
  void ReplaceByHeights(std::vector<double> heights, int width, int height);
  void Replace(GDALDatasetH dataset);
  void CheckSanity();
  void CheckBytes();
  void CheckSigns();
  void CheckFarValues(const std::string& range, double scale, double cell);

  std::string Name;
  HeldFiles Held;
  GDALDatasetH Dataset = nullptr;
  GDALRasterBandH Band = nullptr;
  int BandNumber = 0;
  int NumberOfBands = 0;
  bool Replaced = false;
  bool Turned = false;
  /// The array behind the dataset, where its variables say what GDAL's raster does not.
  std::unique_ptr<RasterArray> Array;
  std::map<std::string, std::string> Attributes;
  /// Of samples in memory.
  std::unique_ptr<GridCoordinates> Coordinates;
  std::string CoordinatesSystem;
  std::vector<double> MoreNoData;

  OGRSpatialReferenceH Reference = nullptr;
  std::array<double, 6> Transform{ { 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } };
  bool HasTransform = false;
  /// Coordinates of samples that are not evenly spaced.
  GridPlace Uneven;
  RasterLayout Layout;
  RasterHoles Holes;
  HeightMeaning Heights;
  RasterRecord Record;
};
}
#endif
