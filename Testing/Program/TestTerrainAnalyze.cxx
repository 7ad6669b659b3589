// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What terrain-analyze does: maps on the grid of the heights, or one sentence, status 1 and no
// file.
#include "TerrainRenderFixture.h"

#include <gdal.h>
#include <gdal_utils.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

namespace
{
/// A raster as GDAL reads it.
struct Bands
{
  int Width = 0;
  int Height = 0;
  int Count = 0;
  std::array<double, 6> Transform{};
  bool NoDataIsNaN = false;
  std::string Layout;
  std::vector<float> Values;

  explicit Bands(const std::string& path)
  {
    GDALAllRegister();
    GDALDatasetH dataset = GDALOpen(path.c_str(), GA_ReadOnly);
    EXPECT_NE(dataset, nullptr) << path;
    if (!dataset)
    {
      return;
    }
    this->Width = GDALGetRasterXSize(dataset);
    this->Height = GDALGetRasterYSize(dataset);
    this->Count = GDALGetRasterCount(dataset);
    GDALGetGeoTransform(dataset, this->Transform.data());
    const char* layout = GDALGetMetadataItem(dataset, "LAYOUT", "IMAGE_STRUCTURE");
    this->Layout = layout ? layout : "";
    this->NoDataIsNaN =
      std::isnan(GDALGetRasterNoDataValue(GDALGetRasterBand(dataset, 1), nullptr));
    this->Values.resize(static_cast<std::size_t>(this->Width) *
      static_cast<std::size_t>(this->Height) * static_cast<std::size_t>(this->Count));
    EXPECT_EQ(
      GDALDatasetRasterIO(dataset, GF_Read, 0, 0, this->Width, this->Height, this->Values.data(),
        this->Width, this->Height, GDT_Float32, this->Count, nullptr, 0, 0, 0),
      CE_None);
    GDALClose(dataset);
  }
  /// Band from 1 on, row 0 in the north.
  float At(int band, int column, int row) const
  {
    return this
      ->Values[static_cast<std::size_t>(column + this->Width * (row + this->Height * (band - 1)))];
  }
};

class TerrainAnalyze : public TerrainRenderFixture
{
protected:
  RunResult Analyze(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), TERRAIN_ANALYZE_PROGRAM);
    return this->RunCommand(arguments);
  }
  /// Runs a command that must succeed, and returns what it wrote.
  Bands Map(std::vector<std::string> arguments) const
  {
    // towers and wells look odd, as the program rightly warns
    arguments.insert(arguments.end(), { "--output", "map.tif", "--quiet" });
    const RunResult result = this->Analyze(arguments);
    EXPECT_EQ(result.Status, 0) << result.Errors;
    EXPECT_EQ(result.Errors, "");
    return Bands(this->Path("map.tif"));
  }
  /// Half rises to the east, one metre a metre.
  std::string WriteRamp(const std::string& crs = "EPSG:32632", double cell = 10.0) const
  {
    RasterDescription ramp;
    ramp.Width = 20;
    ramp.Height = 12;
    ramp.Sample = [](int column, int) { return 5.0 * column; };
    ramp.GeoTransform = { 500000.0, cell, 0.0, 5000000.0, 0.0, -cell };
    ramp.CoordinateSystem = crs;
    return this->WriteRaster("ramp.tif", ramp);
  }
};
}

TEST_F(TerrainAnalyze, HorizonBandsFollowTheCompass)
{
  const Bands map = this->Map({ "horizon", this->WriteRamp(), "--directions", "8" });
  ASSERT_EQ(map.Count, 8);
  EXPECT_EQ(map.Width, 20);
  EXPECT_EQ(map.Height, 12);
  EXPECT_EQ(map.Transform, (std::array<double, 6>{ 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 }));
  EXPECT_TRUE(map.NoDataIsNaN);
  EXPECT_EQ(map.Layout, "COG");
  for (int band = 1; band <= 8; ++band)
  {
    const double azimuth = (band - 1) * 45.0 * 3.14159265358979 / 180.0;
    const double angle = std::atan(0.5 * std::sin(azimuth)) * 180.0 / 3.14159265358979;
    EXPECT_NEAR(map.At(band, 9, 6), angle, 1e-4) << band;
  }
  // Nothing lies ahead at the border.
  EXPECT_EQ(map.At(3, 19, 6), -90.0f);
  EXPECT_EQ(map.At(1, 9, 0), -90.0f);
  EXPECT_EQ(map.At(5, 9, 11), -90.0f);
}

TEST_F(TerrainAnalyze, HorizonOfANorthernTower)
{
  RasterDescription tower;
  tower.Width = 21;
  tower.Height = 21;
  tower.Sample = [](int column, int row) { return column == 10 && row == 2 ? 80.0 : 0.0; };
  const Bands map =
    this->Map({ "horizon", this->WriteRaster("tower.tif", tower), "--directions", "4" });
  // From 8 cells south of it.
  EXPECT_NEAR(map.At(1, 10, 10), std::atan2(80.0, 8.0) * 180.0 / 3.14159265358979, 1e-3);
  EXPECT_NEAR(map.At(2, 10, 10), 0.0, 1e-6);
  EXPECT_NEAR(map.At(2, 3, 2), std::atan2(80.0, 7.0) * 180.0 / 3.14159265358979, 1e-3);
}

TEST_F(TerrainAnalyze, NoDataIsNoDataAndHidesNothing)
{
  RasterDescription holes;
  holes.Width = 30;
  holes.Height = 9;
  holes.HasNoData = true;
  holes.NoData = 9999.0;
  holes.Sample = [](int column, int) { return column == 15 ? 9999.0 : column == 29 ? 40.0 : 0.0; };
  const Bands map =
    this->Map({ "horizon", this->WriteRaster("holes.tif", holes), "--directions", "4" });
  EXPECT_TRUE(std::isnan(map.At(2, 15, 4)));
  EXPECT_NEAR(map.At(2, 9, 4), std::atan2(40.0, 20.0) * 180.0 / 3.14159265358979, 1e-3);
}

TEST_F(TerrainAnalyze, FeetAndDegreesBecomeMetres)
{
  RasterDescription feet;
  feet.Width = 12;
  feet.Height = 12;
  feet.Unit = "ft";
  feet.Sample = [](int column, int) { return 10.0 * column; };
  const Bands inFeet =
    this->Map({ "horizon", this->WriteRaster("feet.tif", feet), "--directions", "4" });
  EXPECT_NEAR(inFeet.At(2, 5, 5), std::atan(3.048) * 180.0 / 3.14159265358979, 1e-3);
  // A tenth of a degree a cell at latitude 60: a degree of longitude is half as wide as at 0.
  RasterDescription degrees;
  degrees.Width = 40;
  degrees.Height = 400;
  degrees.CoordinateSystem = "EPSG:4326";
  degrees.GeoTransform = { 10.0, 0.1, 0.0, 65.0, 0.0, -0.1 };
  degrees.Sample = [](int column, int) { return 1000.0 * column; };
  const Bands map =
    this->Map({ "horizon", this->WriteRaster("degrees.tif", degrees), "--directions", "4" });
  for (const int row : { 20, 120, 350 })
  {
    const double phi = (65.0 - 0.1 * (row + 0.5)) * 3.14159265358979 / 180.0;
    const double radius =
      6378137.0 * std::cos(phi) / std::sqrt(1.0 - 0.00669438 * std::pow(std::sin(phi), 2.0));
    const double cell = radius * 0.1 * 3.14159265358979 / 180.0;
    EXPECT_NEAR(map.At(2, 5, row), std::atan(1000.0 / cell) * 180.0 / 3.14159265358979, 0.01)
      << row;
  }
}

TEST_F(TerrainAnalyze, CurvatureLowersWhatIsFar)
{
  RasterDescription wall;
  wall.Width = 201;
  wall.Height = 5;
  wall.GeoTransform = { 0.0, 1000.0, 0.0, 0.0, 0.0, -1000.0 };
  wall.Sample = [](int column, int) { return column == 200 ? 5000.0 : 0.0; };
  const std::string path = this->WriteRaster("wall.tif", wall);
  const auto angle = [&](double radius, double refraction)
  {
    const double d = 100e3;
    return std::atan((5000.0 - (1.0 - refraction) * d * d / (2.0 * radius)) / d) * 180.0 /
      3.14159265358979;
  };
  EXPECT_NEAR(this->Map({ "horizon", path, "--directions", "4", "--curvature" }).At(2, 100, 2),
    angle(6371008.8, 0.13), 1e-3);
  EXPECT_NEAR(this
                ->Map({ "horizon", path, "--directions", "4", "--curvature", "--radius", "3389500",
                  "--refraction", "0" })
                .At(2, 100, 2),
    angle(3389500.0, 0.0), 1e-3);
  EXPECT_NEAR(this->Map({ "horizon", path, "--directions", "4" }).At(2, 100, 2),
    std::atan(0.05) * 57.29577951, 1e-3);
}

TEST_F(TerrainAnalyze, SkyOverAPlainAndInAWell)
{
  RasterDescription well;
  well.Width = 31;
  well.Height = 31;
  well.Sample = [](int column, int row)
  { return std::hypot(column - 15, row - 15) > 8.0 ? 1000.0 : 0.0; };
  const Bands map = this->Map({ "skyview", this->WriteRaster("well.tif", well) });
  EXPECT_LT(map.At(1, 15, 15), 0.001f);
  EXPECT_NEAR(map.At(1, 1, 1), 1.0, 1e-6);
}

TEST_F(TerrainAnalyze, SunOnAPlainLastsTheDay)
{
  RasterDescription plain;
  plain.Width = 5;
  plain.Height = 5;
  plain.CoordinateSystem = "EPSG:4326";
  plain.GeoTransform = { 10.0, 0.001, 0.0, 0.0025, 0.0, -0.001 };
  const Bands map =
    this->Map({ "sunlight", this->WriteRaster("plain.tif", plain), "--date", "2024-03-20" });
  ASSERT_EQ(map.Count, 4);
  EXPECT_NEAR(map.At(1, 2, 2), 12.0, 0.2); // equinox
  EXPECT_NEAR(map.At(2, 2, 2), 6.0 - 10.0 / 15.0 + 0.12, 0.2);
  EXPECT_NEAR(map.At(3, 2, 2), 18.0 - 10.0 / 15.0 + 0.12, 0.2);
  EXPECT_GT(map.At(4, 2, 2), 5000.0f);
  EXPECT_LT(map.At(4, 2, 2), 9000.0f);
}

TEST_F(TerrainAnalyze, SlopeAspectAndRuggednessAsGDAL)
{
  const std::string hill = this->WriteHill();
  for (const char* command : { "slope", "aspect", "ruggedness" })
  {
    const Bands map = this->Map({ command, hill });
    GDALAllRegister();
    GDALDatasetH source = GDALOpen(hill.c_str(), GA_ReadOnly);
    const std::string path = this->Path("gdal.tif");
    const std::string mode = std::string(command) == "ruggedness" ? "TRI" : command;
    char riley[] = "-alg";
    char name[] = "Riley";
    char* arguments[] = { riley, name, nullptr };
    GDALDEMProcessingOptions* options =
      GDALDEMProcessingOptionsNew(mode == "TRI" ? arguments : nullptr, nullptr);
    GDALClose(GDALDEMProcessing(path.c_str(), source, mode.c_str(), nullptr, options, nullptr));
    GDALDEMProcessingOptionsFree(options);
    GDALClose(source);
    const Bands reference(path);
    for (int row = 1; row < map.Height - 1; ++row)
    {
      for (int column = 1; column < map.Width - 1; ++column)
      {
        const float expected = reference.At(1, column, row);
        if (expected != -9999.0f)
        {
          ASSERT_NEAR(map.At(1, column, row), expected, 1e-3) << command << column << " " << row;
        }
      }
    }
    EXPECT_TRUE(std::isnan(map.At(1, 0, 0)));
  }
}

TEST_F(TerrainAnalyze, CurvatureOfAParaboloid)
{
  RasterDescription bowl;
  bowl.Width = 21;
  bowl.Height = 21;
  bowl.Sample = [](int column, int row)
  { return 0.01 * ((column - 10) * (column - 10) + (row - 10) * (row - 10)); };
  const Bands map = this->Map({ "curvature", this->WriteRaster("bowl.tif", bowl) });
  EXPECT_NEAR(map.At(1, 14, 6), 0.02, 1e-6);
  EXPECT_NEAR(map.At(2, 14, 6), 0.02, 1e-6);
}

TEST_F(TerrainAnalyze, ProfileAndLineOfSight)
{
  RasterDescription ridge;
  ridge.Width = 101;
  ridge.Height = 21;
  ridge.CoordinateSystem = "EPSG:32632";
  ridge.GeoTransform = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  ridge.Sample = [](int column, int) { return column == 50 ? 100.0 : 0.0; };
  const std::string path = this->WriteRaster("ridge.tif", ridge);
  const std::string west = "32N 500100 4999900";
  const std::string east = "32N 500900 4999900";
  const RunResult hidden = this->Analyze({ "line-of-sight", path, "--from", west, "--to", east });
  EXPECT_EQ(hidden.Status, 0) << hidden.Errors;
  EXPECT_EQ(hidden.Output.rfind("hidden", 0), 0u) << hidden.Output;
  const RunResult seen =
    this->Analyze({ "line-of-sight", path, "--from", west + ",300", "--to", east + ",300" });
  EXPECT_EQ(seen.Output, "visible\n") << seen.Errors;
  const RunResult profile = this->Analyze(
    { "profile", path, "--from", west, "--to", east, "--count", "81", "--output", "profile.csv" });
  EXPECT_EQ(profile.Status, 0) << profile.Errors;
  EXPECT_EQ(this->ReadText("profile.csv").rfind("distance,height\n", 0), 0u);
}

TEST_F(TerrainAnalyze, ViewshedBehindARidge)
{
  RasterDescription ridge;
  ridge.Width = 61;
  ridge.Height = 41;
  ridge.CoordinateSystem = "EPSG:32632";
  ridge.GeoTransform = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  ridge.HasNoData = true;
  ridge.NoData = -1.0;
  ridge.Sample = [](int column, int row) {
    return column == 30 ? 50.0 : column == 5 && row == 5 ? -1.0 : 0.0;
  };
  const std::string path = this->WriteRaster("ridge.tif", ridge);
  const Bands map =
    this->Map({ "viewshed", path, "--observer", "500105,4999795", "--observer", "500205,4999795" });
  EXPECT_EQ(map.At(1, 12, 20), 2.0f);
  EXPECT_EQ(map.At(1, 30, 3), 2.0f); // the crest
  EXPECT_EQ(map.At(1, 45, 20), 0.0f);
  EXPECT_TRUE(std::isnan(map.At(1, 5, 5)));
  // A mast of 200 m behind the ridge is seen, from near enough.
  const Bands masts = this->Map({ "viewshed", path, "--observer", "500105,4999795",
    "--target-height", "200", "--distance", "300" });
  EXPECT_EQ(masts.At(1, 35, 20), 1.0f);
  EXPECT_EQ(masts.At(1, 45, 20), 0.0f);
  const std::vector<std::string> before = this->ListFiles();
  ExpectRefused(
    this->Analyze({ "viewshed", path, "--quiet", "--observer", "0,0", "--output", "none.tif" }), 1,
    "outside");
  ExpectRefused(this->Analyze({ "viewshed", path, "--quiet", "--observer", "500055,4999945",
                  "--output", "none.tif" }),
    1, "no height");
  EXPECT_EQ(this->ListFiles(), before);
}

TEST_F(TerrainAnalyze, TakesOneOfSeveralSitesThatIsNamed)
{
  const std::string sites = this->WriteSites();
  ExpectRefused(
    this->Analyze({ "slope", sites, "--output", "none.tif" }), 1, "--part 1 to --part 2");
  EXPECT_EQ(this->Analyze({ "slope", sites, "--part", "2", "--output", "slope.tif" }).Status, 0);
}

TEST_F(TerrainAnalyze, ViewshedOfARoadAnAreaAndAFile)
{
  RasterDescription plain;
  plain.Width = 61;
  plain.Height = 41;
  plain.CoordinateSystem = "EPSG:32632";
  plain.GeoTransform = { 500000.0, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
  plain.Sample = [](int column, int) { return column == 30 ? 50.0 : 0.0; };
  const std::string path = this->WriteRaster("plain.tif", plain);
  const Bands road = this->Map({ "viewshed", path, "--line", "500105,4999795 500165,4999795" });
  EXPECT_EQ(road.At(1, 5, 5), 7.0f);
  const Bands area = this->Map({ "viewshed", path, "--area",
    "500101,4999791 500119,4999791 500119,4999809 500101,4999809", "--rise" });
  ASSERT_EQ(area.Count, 2);
  EXPECT_EQ(area.At(1, 5, 5), 4.0f); // the samples inside, not the corners
  EXPECT_EQ(area.At(2, 5, 5), 0.0f);
  EXPECT_GT(area.At(2, 45, 20), 50.0f);
  std::ofstream(this->Path("road.geojson"))
    << R"({"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":)"
    << R"([[9.00133,45.15275],[9.00209,45.15275]]}})";
  const Bands file = this->Map({ "viewshed", path, "--observers", this->Path("road.geojson"),
    "--azimuth", "180,360", "--nearest", "30", "--rise" });
  EXPECT_GE(file.At(1, 2, 20), 6.0f);
  EXPECT_EQ(file.At(1, 28, 20), 0.0f); // east
  EXPECT_EQ(file.At(2, 2, 20), 0.0f);
  EXPECT_TRUE(std::isnan(file.At(2, 28, 20))); // no rise brings it to the west
  const std::vector<std::string> before = this->ListFiles();
  const auto refuse = [&](std::vector<std::string> arguments, const std::string& mention)
  {
    arguments.insert(arguments.begin(), { "viewshed", path, "--quiet", "--output", "none.tif" });
    ExpectRefused(this->Analyze(arguments), 1, mention);
    EXPECT_EQ(this->ListFiles(), before);
  };
  refuse({}, "--observer");
  refuse({ "--line", "500105,4999795" }, "fewer than 2");
  refuse({ "--line", "500105,4999795 here" }, "here");
  refuse({ "--observers", "nowhere.geojson" }, "nowhere.geojson");
  refuse({ "--observer", "500105,4999795", "--azimuth", "90,10" }, "azimuths");
  refuse({ "--observer", "500105,4999795", "--azimuth", "0,1000" }, "360 degrees");
  // no sample lies inside of these
  refuse({ "--area", "500106,4999796 500107,4999796 500107,4999797" }, "no sample");
  refuse({ "--area", "500106,4999796 500106,4999796 500106,4999796" }, "no sample");
  ExpectRefused(this->Analyze({ "viewshed", path, "--quiet", "--output", "none.tif", "--observer",
                  "500105,4999795,300" }),
    2, "--observer");
  EXPECT_EQ(this->ListFiles(), before);
}

TEST_F(TerrainAnalyze, SaysHowToGoOnWithoutMemory)
{
  const std::string path = this->Path("large.vrt");
  std::ofstream(path) << R"(<VRTDataset rasterXSize="2000000" rasterYSize="2000000">)"
                      << "<SRS>EPSG:32632</SRS><GeoTransform>0,1,0,0,0,-1</GeoTransform>"
                      << R"(<VRTRasterBand dataType="Float32" band="1"/></VRTDataset>)";
  ExpectRefused(this->Analyze({ "slope", path, "--output", "none.tif" }), 1, "gdal_translate");
}

TEST_F(TerrainAnalyze, NeverReplacesItsRaster)
{
  const std::string ramp = this->WriteRamp();
  for (const char* command : { "slope", "horizon" })
  {
    const std::vector<std::string> files = this->ListFiles();
    ExpectRefused(this->Analyze({ command, ramp, "--output", ramp }), 1, ramp);
    EXPECT_EQ(this->ListFiles(), files);
  }
  EXPECT_EQ(this->Analyze({ "slope", ramp, "--output", "again.tif" }).Status, 0);
}

TEST_F(TerrainAnalyze, NeverReplacesWhatElseItReads)
{
  const std::string ramp = this->WriteRamp();
  const std::string people = R"({"type":"Point","coordinates":[9.001,45.1525]})";
  this->WriteText("people.geojson", people);
  std::filesystem::create_symlink("people.geojson", this->Path("link.geojson"));
  const std::string crs = "+proj=utm +zone=32 +datum=WGS84\n";
  this->WriteText("utm.prj", crs);
  const std::vector<std::string> files = this->ListFiles();
  const std::vector<std::string> looks{ "viewshed", ramp, "--observers", "people.geojson" };
  for (const char* output : { "people.geojson", "link.geojson" })
  {
    std::vector<std::string> arguments = looks;
    arguments.insert(arguments.end(), { "--output", output });
    ExpectRefused(this->Analyze(arguments), 1, output);
  }
  ExpectRefused(
    this->Analyze({ "slope", ramp, "--crs", "utm.prj", "--output", "utm.prj" }), 1, "utm.prj");
  EXPECT_EQ(this->ReadText("people.geojson"), people);
  EXPECT_EQ(this->ReadText("utm.prj"), crs);
  EXPECT_EQ(this->ListFiles(), files);
}

TEST_F(TerrainAnalyze, RefusesWhatIsNoNumber)
{
  const std::string ramp = this->WriteRamp();
  const std::vector<std::string> before = this->ListFiles();
  const std::vector<std::vector<std::string>> wrong{ { "horizon", "--eye-height" },
    { "horizon", "--refraction" }, { "skyview", "--radius" },
    { "sunlight", "--date", "2024-06-21", "--time-step" },
    { "sunlight", "--date", "2024-06-21", "--turbidity" },
    { "line-of-sight", "--from", "9,45", "--to", "9,45", "--refraction" },
    { "viewshed", "--eye-height" }, { "viewshed", "--target-height" }, { "viewshed", "--distance" },
    { "viewshed", "--nearest" }, { "viewshed", "--observer-spacing" }, { "viewshed", "--radius" },
    { "viewshed", "--refraction" }, { "viewshed", "--observer" }, { "viewshed", "--azimuth" },
    { "viewshed", "--elevation" } };
  for (std::vector<std::string> arguments : wrong)
  {
    const std::string option = arguments.back();
    const bool isPair = option == "--observer" || option == "--azimuth" || option == "--elevation";
    arguments.insert(arguments.begin() + 1, ramp);
    arguments.emplace_back(isPair ? "0,nan" : "nan");
    if (arguments[0] != "line-of-sight")
    {
      arguments.insert(arguments.end(), { "--output", "map.tif" });
    }
    SCOPED_TRACE(arguments[0] + " " + option);
    ExpectRefused(this->Analyze(arguments), 2, option);
  }
  EXPECT_EQ(this->ListFiles(), before);
}

TEST_F(TerrainAnalyze, RefusesInOneLineAndLeavesNothing)
{
  const std::string ramp = this->WriteRamp();
  const std::vector<std::string> before = this->ListFiles();
  const auto refuse = [&](std::vector<std::string> arguments, const std::string& mention)
  {
    arguments.insert(arguments.end(), { "--output", "map.tif" });
    ExpectRefused(this->Analyze(arguments), 1, mention);
    EXPECT_EQ(this->ListFiles(), before);
  };
  refuse({ "horizon", "nowhere.tif" }, "nowhere.tif");
  ExpectRefused(this->Analyze({ "horizon", "--output=", ramp }), 2, "--output");
  ExpectRefused(this->Analyze({ "horizon", "", "--output", "map.tif" }), 2, "HEIGHTS");
  refuse({ "horizon", ramp, "--directions", "0" }, "1 to 3600");
  refuse({ "horizon", ramp, "--directions", "1000000" }, "1 to 3600");
  refuse({ "sunlight", ramp, "--date", "tomorrow" }, "tomorrow");
  ExpectRefused(this->Analyze({ "horizon", ramp, "--output", "/nowhere/map.tif" }), 1, "/nowhere");
  EXPECT_EQ(this->Analyze({ "horizon", ramp }).Status, 2);
  EXPECT_EQ(this->Analyze({ "fly", ramp, "--output", "map.tif" }).Status, 2);
  EXPECT_EQ(this->Analyze({ "horizon", ramp, "--radius", "-1", "--output", "map.tif" }).Status, 2);
  EXPECT_EQ(this->ListFiles(), before);
}
