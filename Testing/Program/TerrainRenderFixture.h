// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs terrain-render as its users do, with files made for the test.
 */
#ifndef TerrainRenderFixture_h
#define TerrainRenderFixture_h

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

/// How a run of the program ended.
struct RunResult
{
  /// Exit status; -1 if the program was ended by a signal or ran too long.
  int Status = -1;
  std::string Output;
  std::string Errors;
};

/// What a raster that a test writes looks like.
struct RasterDescription
{
  int Width = 2;
  int Height = 2;
  int Bands = 1;
  /// Bytes, which are colours if there are three bands; else float32.
  bool IsBytes = false;
  /// Height of column, row; row 0 is the northern one.
  std::function<double(int, int)> Sample = [](int, int) { return 0.0; };
  bool HasNoData = false;
  double NoData = -32767.0;
  /// As GDAL has it: x = g0 + g1 column + g2 row, y = g3 + g4 column + g5 row.
  std::vector<double> GeoTransform = { 0.0, 1.0, 0.0, 0.0, 0.0, -1.0 };
  /// "EPSG:n", WKT or PROJ; empty for none.
  std::string CoordinateSystem;
  /// Of heights; empty for none.
  std::string Unit;
};

/// A picture of 8 bits a channel.
struct Picture
{
  int Width = 0;
  int Height = 0;
  /// Red, green, blue of each pixel, row 0 on top.
  std::vector<unsigned char> Values;

  /// Channel 0 to 2 of a pixel.
  int At(int column, int row, int channel) const
  {
    return this->Values[3 * (static_cast<std::size_t>(row) * this->Width + column) + channel];
  }
};

/// What a depth file holds.
struct Depths
{
  int Width = 0;
  int Height = 0;
  bool IsFloat32 = false;
  bool NoDataIsNaN = false;
  /// Row 0 is on top.
  std::vector<float> Values;

  float At(int column, int row) const
  {
    return this->Values[static_cast<std::size_t>(row) * this->Width + column];
  }
  /// Number of pixels with a surface.
  int CountHits() const;
};

/// Gives every test an empty folder of its own.
/// Metres between the sites of WriteSites(): more than 4 million samples round both.
constexpr double kAwayOfSites = 1500.0;

class TerrainRenderFixture : public ::testing::Test
{
protected:
  void SetUp() override;

  /// Path of a file in the folder of the test.
  std::string Path(const std::string& name) const
  {
    return this->Folder + "/" + name;
  }
  /// Writes a text file and returns its path.
  std::string WriteText(const std::string& name, const std::string& text) const;
  /// Writes a GeoTIFF and returns its path.
  std::string WriteRaster(const std::string& name, const RasterDescription& description) const;
  /// A small hill with slopes to all sides, 65 x 49 samples of 1 m, 0 to 20 m high.
  std::string WriteHill(const std::string& name = "hill.tif") const;
  /// A folder of two tiles of 24 m, kAwayOfSites east and north of each other: heights from 0 to
  /// 9.4 m, and 100 m higher.
  std::string WriteSites() const;

  /// Runs the program in the folder of the test. No file grows beyond `fileLimit` bytes; 0: no
  /// limit.
  RunResult Run(const std::vector<std::string>& arguments, long fileLimit = 0) const;
  /// Runs any command in the folder of the test.
  RunResult RunCommand(const std::vector<std::string>& command, long fileLimit = 0) const;
  /// Path of the program.
  static std::string Program();
  /// The same for a small picture "picture.png" and depths "depth.tif".
  RunResult Draw(const std::string& heights, std::vector<std::string> arguments = {}) const;

  Depths ReadDepths(const std::string& name = "depth.tif") const;
  Picture ReadPicture(const std::string& name = "picture.png") const;
  /// Width and height of a PNG; 0 x 0 if it is none.
  std::vector<int> ReadPictureSize(const std::string& name) const;
  std::string ReadText(const std::string& name) const;
  /// Names of the files in the folder of the test, sorted.
  std::vector<std::string> ListFiles() const;

  /// Asserts the contract of a failure: the status, and one line on stderr that has `mention` in
  /// it.
  static void ExpectRefused(const RunResult& result, int status, const std::string& mention);
  /// Asserts success, and that the depths of Draw() have at least as many hits.
  void ExpectDrawn(const RunResult& result, int leastHits = 1) const;

  std::string Folder;
};

#endif
