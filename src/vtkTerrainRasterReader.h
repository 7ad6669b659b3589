// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainRasterReader
 * @brief   reads heights from every raster that GDAL opens
 *
 * Output: vtkImageData of W x H x 1 points. The point scalars are named after the band's
 * description, else "Elevation". They have the type of the file: 8, 16 and 32-bit integers and
 * floating-point numbers. 64-bit integers become double. A scale and an offset that the band
 * declares are applied, and so is a unit of length other than metres. Integers of up to 16 bits
 * then become float, those of 32 bits double. Complex samples are refused.
 *
 * Conventions: the first row of samples is the southernmost, the first sample the westernmost,
 * however the file stores them. A sample lies at the centre of its pixel. That holds for files of
 * areas and for files of points (GDAL reports the corner of the latter half a cell out).
 *   - A raster in a projected CRS lies at its coordinates, in metres.
 *   - A raster in degrees is laid out in metres, at the scale of its centre latitude on the
 *     ellipsoid of its CRS. It is true there, too wide towards the poles and too narrow towards the
 *     equator. x = 0, y = 0 is the centre of the file. Windows of one file fit together; different
 *     files do not.
 *   - A raster without georeference has spacing 1. The south-western sample of the file lies at the
 *     origin.
 *   - Rotated and sheared rasters, by a hundredth of a cell or more over their length, are
 *     resampled in memory, up to 2^27 samples.
 *
 * Place, unit, sense and holes are found from all that the raster says: CRS, geotransform,
 * variables of coordinates (CF), attributes, masks, names of bands. Coordinates that are unevenly
 * spaced or two-dimensional are resampled onto an even grid of longitude and latitude, near a pole
 * onto a stereographic one. Heights that count down are turned: those of a vertical axis down, of
 * positive = down, and depths by their standard name. Axes of a CRS that point west or south are
 * turned too: x is east, y north. Describe tells what was taken from where. What contradicts or was
 * guessed is a warning that names the remedy.
 *
 * No data are NaN in floating-point scalars. In integers HIDDENPOINT is set for them in the point
 * array vtkGhostType, which exists only if there is such a point. They then hold the lowest height
 * of what was read, so that ranges and logarithms are those of the heights, and 0 where all are
 * hidden. Most filters of VTK do not look at vtkGhostType: contours, thresholds, probes and cuts
 * take the filler for ground. With NoDataAsNaN they are NaN whatever the file has. These have no
 * data:
 *   - the values that the band declares, and NoDataValue if it is used;
 *   - NaN, infinities, magnitudes from 1e30 on;
 *   - what a mask or an alpha band hides (0);
 *   - unless DetectNoData is off, fill values that nobody declares. These are usual ones (-999,
 *     32767, 65535, 1e6, 1e20, ...) that lie far from all other samples. In signed bands without
 *     NoData and scale they are also -32768 and -32767, and -9999 unless the file reaches below
 *     8,000 m of sea. A warning says so when there are any.
 *
 * Field data, where known:
 * | array         | type      | what                                                           |
 * | ---           | ---       | ---                                                            |
 * | FileName      | string    | the file                                                       |
 * | CRS           | string    | coordinate reference system as WKT2:2019                       |
 * | GeoTransform  | 6 doubles | GDAL's, from pixel corners of the whole file to the CRS        |
 * | RasterSize    | 2 doubles | columns and rows of the whole file                             |
 * | RasterWindow  | 4 doubles | x, y, width, height of the part read, in pixels of the file    |
 * | LayoutOrigin  | 2 doubles | place in the CRS that lies at x = 0, y = 0                     |
 * | LayoutScale   | 2 doubles | metres a unit: CRS = LayoutOrigin + (x, y) / LayoutScale       |
 * | VerticalUnit  | string    | name of the unit of the file's heights                         |
 * | VerticalScale | 1 double  | metres in that unit, below 0 if they count down; applied to the |
 * |               |           | scalars already; else 1                                        |
 * | Record        | strings   | what was taken from where, "topic: value (source)"             |
 * | Warnings      | strings   | sentences, each once                                           |
 *
 * A directory, or an archive of several rasters, is read as one raster of the tiles in it and in
 * folders below (.tif .tiff .hgt .dem .asc .img .dt0 to .dt2 .bil .bip .bsq .flt .grd .jp2 .sdat
 * .nc .xyz .bag .bt .cub .gxf .grb .grib .grib2 .hf2 .mtw .ntf .rst .sigdem). Its horizontal CRS is
 * that of the first tile: tiles of others are resampled into it, with a warning. A tile without a
 * CRS beside such that have one is an error. Unit, scale, sense and NoData are each tile's own.
 * Tiles on both sides of 180 degrees are joined. Between tiles there is no data. Where tiles
 * overlap, the finest counts, of equally fine ones the last by name. Pictures, masks and
 * derivatives (hillshade, slope) are left out, with a warning. Of tiles at sites far from each
 * other those of one are read: of the one that covers most, with a warning, or of the one whose
 * number SetPart names.
 *
 * A file of terrain-prepare, recognized by its content, is read like a raster: the heights as float
 * with NaN for no data, whole or in the pipeline's pieces, with FileName, CRS, LayoutOrigin,
 * LayoutScale. Window, the limits of samples, bands and no-data settings are for rasters.
 *
 * Reading less: Band, Window, and MaximumSize or MaximumNumberOfSamples. Reduced samples are means
 * over their area (of what has data, where half of it has), taken from the smallest overview that
 * is fine enough. The pipeline's pieces read only their part of the file, and equal the whole, but
 * for what integers hold where there is no data.
 *
 * Errors: one line that names the file and the reason, also in GetErrorMessage; the output is empty
 * then, as it is after AbortExecute. GDAL itself prints nothing.
 *
 * Cost: as GDAL's own reading; memory is the output and a stripe of the file.
 *
 * @code{.cpp}
 * vtkNew<vtkTerrainRasterReader> reader;
 * reader->SetFileName("N27E086.hgt");
 * reader->SetMaximumSize(4096);
 * @endcode
 *
 * @sa vtkTerrainSource
 */
#ifndef vtkTerrainRasterReader_h
#define vtkTerrainRasterReader_h

#include "vtkImageAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

#include <memory> // For what is kept of a file
#include <string> // For texts

class vtkFieldData;
struct vtkTerrainRasterPlan;
namespace terrain
{
struct RasterOptions;
struct RasterTileSettings;
class TileSource;
}

class VTKTERRAIN_EXPORT vtkTerrainRasterReader : public vtkImageAlgorithm
{
public:
  static vtkTerrainRasterReader* New();
  vtkTypeMacro(vtkTerrainRasterReader, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainRasterReader(const vtkTerrainRasterReader&) = delete;
  void operator=(const vtkTerrainRasterReader&) = delete;

  ///@{
  /// File to read, or any other name that GDAL opens ("/vsizip/...", "NETCDF:..."); or a directory
  /// of tiles.
  void SetFileName(VTK_FILEPATH const char* fileName);
  void SetFileName(VTK_FILEPATH const std::string& fileName);
  VTK_FILEPATH const char* GetFileName() const;
  ///@}

  ///@{
  /// CRS of the file in place of the one it names: "EPSG:n", WKT, or a PROJ string; empty (the
  /// default) for its own.
  void SetCoordinateSystem(const std::string& definition);
  const std::string& GetCoordinateSystem() const
  {
    return this->CoordinateSystem;
  }
  ///@}

  ///@{
  /// Samples in memory in place of a file, with what their owner knows of them; null (the default)
  /// for the file. They are used in place, row by row as the owner has them. Arrays: "Samples" (one
  /// component) and "Size" (columns, rows); strings "name=value": "Names" (name, crs), "Attributes"
  /// (as CF and GDAL call them: units, scale_factor, add_offset, _FillValue, positive,
  /// standard_name), "GridMapping"; coordinates "Rows", "Columns" (one value each) and "Field0",
  /// "Field1" (one a sample) with their "RowsAttributes" and so on (name, units, standard_name).
  void SetSamples(vtkFieldData* samples);
  vtkFieldData* GetSamples() const;
  ///@}

  ///@{
  /// Part of a file of several rasters (netCDF, HDF5, GeoPackage): name of the variable or table,
  /// or its number from 1 on; empty (the default) for the only one, or the only one that is called
  /// as heights are. Of a directory of tiles at several sites the number of one.
  void SetPart(const std::string& part);
  const std::string& GetPart() const
  {
    return this->Part;
  }
  ///@}

  ///@{
  /// Unit of the heights in place of what the file says: a name ("ft", "us-ft", "fathom"; "-m" for
  /// depths), or metres per unit ("0.3048", "-1" for depths); empty (the default) for the file's.
  void SetHeightUnit(const std::string& unit);
  const std::string& GetHeightUnit() const
  {
    return this->HeightUnit;
  }
  ///@}

  ///@{
  /// Whether the first row lies at the other side than the file says; default off.
  vtkSetMacro(Flip, bool);
  vtkGetMacro(Flip, bool);
  vtkBooleanMacro(Flip, bool);
  ///@}

  ///@{
  /// Band of heights, from 1 on. 0 (the default) is the first one, but refuses colour images: files
  /// with red, green and blue, with a palette, or with more than two bands of bytes.
  vtkSetMacro(Band, int);
  vtkGetMacro(Band, int);
  ///@}

  ///@{
  /// Whether each band is a time step: the pipeline's time k, from 1 on, reads band k, in place of
  /// Band; default off. The scalars are called "Elevation" then, whatever the bands are.
  vtkSetMacro(BandsAsTimeSteps, bool);
  vtkGetMacro(BandsAsTimeSteps, bool);
  vtkBooleanMacro(BandsAsTimeSteps, bool);
  ///@}

  ///@{
  /// Part of the file to read: first column, first row, columns, rows, in pixels as the file stores
  /// them (row 0 is the northernmost as a rule). 0 columns or rows mean all up to the edge; the
  /// default, 0 0 0 0, is the whole file. A window that leaves the file is an error.
  vtkSetVector4Macro(Window, int);
  vtkGetVector4Macro(Window, int);
  ///@}

  ///@{
  /// Most samples a side; 0 (the default) is no limit.
  vtkSetClampMacro(MaximumSize, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumSize, int);
  ///@}

  ///@{
  /// Most samples in all; 0 (the default) is no limit.
  vtkSetClampMacro(MaximumNumberOfSamples, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfSamples, vtkIdType);
  ///@}

  ///@{
  /// A value of the file (before scale and offset) that is no height, besides those it declares;
  /// used only if UseNoDataValue is on. Defaults: -32768, off.
  vtkSetMacro(NoDataValue, double);
  vtkGetMacro(NoDataValue, double);
  vtkSetMacro(UseNoDataValue, bool);
  vtkGetMacro(UseNoDataValue, bool);
  vtkBooleanMacro(UseNoDataValue, bool);
  ///@}

  ///@{
  /// Takes the usual fill values for no data in bands that declare none; default on.
  vtkSetMacro(DetectNoData, bool);
  vtkGetMacro(DetectNoData, bool);
  vtkBooleanMacro(DetectNoData, bool);
  ///@}

  ///@{
  /// Whether integers become floating-point numbers, of 32 bits for integers of 8 and 16 and of 64
  /// for those of 32, whose places without a height are NaN: for filters, which leave NaN out.
  /// Default off: terrain is drawn from integers in half the memory.
  vtkSetMacro(NoDataAsNaN, bool);
  vtkGetMacro(NoDataAsNaN, bool);
  vtkBooleanMacro(NoDataAsNaN, bool);
  ///@}

  ///@{
  /// Whether a raster that exceeds MaximumSize or MaximumNumberOfSamples is read at a level: the
  /// finest one that both and MemoryBudget allow. Level k has every 2^k-th sample along both axes,
  /// from the south-western one on, and each is the average of the samples around it, within the
  /// bounds of all samples of the cells around it. The levels are made in one pass over the file,
  /// on all threads and in little memory, and kept for the next time: see UseCache. Has no effect
  /// with a Window or with BandsAsTimeSteps. Default: off, any reduction by means over areas.
  vtkSetMacro(UseLevels, bool);
  vtkGetMacro(UseLevels, bool);
  vtkBooleanMacro(UseLevels, bool);
  ///@}

  ///@{
  /// Whether levels are kept: in FILE.tiles beside the file if that exists, as
  /// PrepareLevels makes it, else in $XDG_CACHE_HOME/vtkterrain or ~/.cache/vtkterrain. Levels of
  /// another file, or of an older state of this one, are never used. Default: on.
  vtkSetMacro(UseCache, bool);
  vtkGetMacro(UseCache, bool);
  vtkBooleanMacro(UseCache, bool);
  ///@}

  /// Makes the levels of FileName and keeps them in FILE.tiles beside it, whatever its size.
  /// Returns true, or false with GetErrorMessage().
  bool PrepareLevels();

  ///@{
  /// Whether a warning tells of the level that is read (default): off for who draws the tiles.
  vtkSetMacro(WarnOfLevels, bool);
  vtkGetMacro(WarnOfLevels, bool);
  vtkBooleanMacro(WarnOfLevels, bool);
  ///@}

  ///@{
  /// With UseLevels, most bytes of memory that an application takes that reads a level and draws
  /// it, about four times the samples; 0 is no limit. Default: 1 GiB.
  vtkSetClampMacro(MemoryBudget, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MemoryBudget, vtkIdType);
  ///@}

  /// The tiles of all levels, for vtkOpenGLTerrainMapper::SetTileSource(): after an update that has
  /// read a level, else null. They may outlive the reader.
  std::shared_ptr<terrain::TileSource> GetTileSource() const
  {
    return this->Tiles;
  }

  /// The level that the last update read; 0 are the samples of the file.
  int GetLevel() const
  {
    return this->Level;
  }

  ///@{
  /// Sites far from each other of a folder without a Part, as the last update found them: how many
  /// there are (1 for all else), and the number of the one that was read, which covers most.
  /// SetPart takes another, from 1 on. A warning says so unless WarnOfSites is off, for who reads
  /// them all. Default: on.
  vtkGetMacro(NumberOfSites, int);
  vtkGetMacro(Site, int);
  vtkSetMacro(WarnOfSites, bool);
  vtkGetMacro(WarnOfSites, bool);
  vtkBooleanMacro(WarnOfSites, bool);
  ///@}

  /// Why the last update failed, one line; empty if it did not. It is told (ErrorEvent) once,
  /// and again after settings or the file have changed.
  const char* GetErrorMessage() const;
  /// What was warned of since the size was last asked for, a line each; empty if nothing.
  const char* GetWarningMessage() const;

  ///@{
  /// GDAL is not linked to the module. When a file or a coordinate system first needs it, it is
  /// found in this order: the library that the environment variable VTKTERRAIN_GDAL names; one that
  /// is in the process already; those that AddGDAL has named, files that are GDAL or bring it when
  /// loaded, in the order of the calls; the system's. AddGDAL has no effect afterwards. GetGDALFile
  /// tells the file that was taken; empty as long as none was needed, and if none was found.
  static void AddGDAL(VTK_FILEPATH const std::string& fileName);
  static std::string GetGDALFile();
  ///@}

  /// What the raster is taken for: lines "topic: value (source)", sizes and place first, then
  /// "warning: ..." for each warning. An error is the one line "error: ...". Reads no more than
  /// some blocks of samples.
  std::string Describe();
  /// True if the samples that are given are heights as they are: in metres, upwards, all with data,
  /// in an even grid of metres. False for files.
  bool GetSamplesAreHeights();

  /// 0 if GDAL opens no raster under this name, 2 if it does.
  virtual int CanReadFile(VTK_FILEPATH const char* fileName);
  /// Extensions of usual elevation files, separated by spaces.
  virtual const char* GetFileExtensions() const;
  /// What a dialog calls such files.
  virtual const char* GetDescriptiveName() const;

protected:
  vtkTerrainRasterReader();
  ~vtkTerrainRasterReader() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int RequestPrepared(vtkInformation* info, vtkImageData* image);
  std::shared_ptr<vtkTerrainRasterPlan> Plan(int band);
  std::shared_ptr<vtkTerrainRasterPlan> Open() const;
  void Complete(vtkTerrainRasterPlan& plan) const;
  void DeclareTimeSteps(int numberOfBands, vtkInformation* info) const;
  void ChooseLevel(vtkTerrainRasterPlan& plan) const;
  void PlaceLevel(vtkTerrainRasterPlan& plan) const;
  void Read(vtkTerrainRasterPlan& plan, vtkImageData* image);
  void ReadTiles(vtkTerrainRasterPlan& plan, vtkImageData* image);
  terrain::RasterTileSettings GetTileSettings() const;
  terrain::RasterOptions GetOptions() const;
  void WarnOfLevel(const vtkTerrainRasterPlan& plan, const std::string& message);
  void AddFieldData(vtkTerrainRasterPlan& plan, vtkImageData* image) const;
  int Fail(const std::string& reason);
  void Warn(const std::string& text);
  void WarnOf(const vtkTerrainRasterPlan& plan);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
  std::string FileName;
  std::string CoordinateSystem;
  std::string Part;
  std::string HeightUnit;
  bool Flip = false;
  int Band = 0;
  bool BandsAsTimeSteps = false;
  int Window[4] = { 0, 0, 0, 0 };
  int MaximumSize = 0;
  vtkIdType MaximumNumberOfSamples = 0;
  double NoDataValue = -32768.0;
  bool UseNoDataValue = false;
  bool DetectNoData = true;
  bool NoDataAsNaN = false;
  bool UseLevels = false;
  bool UseCache = true;
  bool WarnOfLevels = true;
  bool WarnOfSites = true;
  int NumberOfSites = 1;
  int Site = 1;
  vtkIdType MemoryBudget = vtkIdType{ 1 } << 30;
  int Level = 0;
  std::shared_ptr<terrain::TileSource> Tiles;
  std::string ErrorMessage;
  std::string WarningMessage;
};

#endif
