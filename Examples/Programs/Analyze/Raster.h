// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What terrain-analyze reads and writes: heights of any raster that GDAL opens, results on the same
 * grid.
 */
#ifndef terrain_analyze_Raster_h
#define terrain_analyze_Raster_h

#include "Failure.h"
#include "HeightOptions.h"

#include <vtkAlgorithm.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTerrainOutputFile.h>

#include <string>
#include <vector>

/// A bar on stderr, drawn only if that is a terminal, erased when it is destroyed.
class ProgressBar
{
public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  void operator=(const ProgressBar&) = delete;

  /// Fills the bar up to a part in [0, 1].
  void Show(double part);
  /// Shows the progress of a filter, up to a part.
  void Watch(vtkAlgorithm* filter, double until);

private:
  bool Shown;
  int Percent = -1;
};

/// How the command line has rasters read and written.
struct RasterOptions
{
  std::string Heights;
  std::string Output;
  /// All other files that the command reads; the output never replaces one.
  std::vector<std::string> Inputs;
  HeightOptions Input;
  std::string Compression = "NONE";
  bool Quiet = false;
};

/// Heights in metres, row 0 in the south (vtkTerrainRasterReader). bytes: what the command needs
/// for each sample, all in all. Throws Failure, also where the machine has less memory left.
vtkSmartPointer<vtkImageData> ReadHeights(const RasterOptions& options, double bytes);

/// Results on the grid of heights, written as a cloud-optimized GeoTIFF of floats with NaN for no
/// data. Nothing is left behind if that fails.
class ResultWriter
{
public:
  ResultWriter(const RasterOptions& options, vtkImageData* heights, int bands);
  ~ResultWriter();
  ResultWriter(const ResultWriter&) = delete;
  void operator=(const ResultWriter&) = delete;

  /// Takes one value a sample, in the order of the heights, as band 1 and following.
  void SetBand(int band, const std::string& description, const float* values);
  /// Writes the file.
  void Write();

private:
  void Check(bool done, const std::string& what) const;
  void DeclareNoData();
  void BuildOverviews();

  const RasterOptions& Options;
  int Width;
  int Height;
  bool NorthFirst = true;
  bool EastFirst = false;
  bool HasHoles = false; ///< some value is NaN
  void* Dataset = nullptr;
  vtkNew<vtkTerrainOutputFile> File;
};

/// Throws Failure if the output is a file that the command reads, which would be lost.
void CheckOutput(const RasterOptions& options);

/// Opens the output, which must not be a file that the command reads. Throws Failure.
void OpenOutput(vtkTerrainOutputFile* file, const RasterOptions& options);

/// Numbers of a field array of an image; empty if there is none.
std::vector<double> GetNumbers(vtkImageData* image, const char* name);

/// Metres between neighbouring samples of a row, east; by latitude if the heights are in degrees.
std::vector<double> EastSpacings(vtkImageData* heights);

#endif
