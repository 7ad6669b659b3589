// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What terrain-render does with bad and odd heights: a correct picture, or one sentence, status 1
// and no file.
#include "TerrainRenderFixture.h"

#include <vtk_jsoncpp.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace
{
class TerrainRenderInput : public TerrainRenderFixture
{
protected:
  /// Asserts that drawing the file fails with a sentence that names it, and leaves nothing behind.
  void ExpectHeightsRefused(const std::string& heights, const std::string& mention = "")
  {
    const std::vector<std::string> before = this->ListFiles();
    const RunResult result = this->Draw(heights);
    ExpectRefused(result, 1, heights);
    EXPECT_NE(result.Errors.find(mention), std::string::npos) << result.Errors;
    EXPECT_EQ(this->ListFiles(), before);
  }
};
}

TEST_F(TerrainRenderInput, MissingFile)
{
  this->ExpectHeightsRefused(this->Path("nowhere.tif"));
}

TEST_F(TerrainRenderInput, Folder)
{
  std::filesystem::create_directory(this->Path("folder.tif"));
  this->ExpectHeightsRefused(this->Path("folder.tif"));
}

TEST_F(TerrainRenderInput, EmptyFile)
{
  this->ExpectHeightsRefused(this->WriteText("empty.tif", ""));
}

TEST_F(TerrainRenderInput, TextNamedTif)
{
  this->ExpectHeightsRefused(this->WriteText("text.tif", "These are no heights.\n"));
}

TEST_F(TerrainRenderInput, TruncatedTiff)
{
  const std::string path = this->WriteHill("truncated.tif");
  const auto size = std::filesystem::file_size(path);
  for (const auto kept : { size / 2, size - 100, std::uintmax_t(100), std::uintmax_t(4) })
  {
    std::filesystem::resize_file(path, kept);
    this->ExpectHeightsRefused(path);
  }
}

TEST_F(TerrainRenderInput, NoSamples)
{
  this->ExpectHeightsRefused(
    this->WriteText("none.vrt", R"(<VRTDataset rasterXSize="0" rasterYSize="0"></VRTDataset>)"));
}

TEST_F(TerrainRenderInput, MoreSamplesThanMemory)
{
  this->ExpectHeightsRefused(this->WriteText("vast.vrt",
    R"(<VRTDataset rasterXSize="2000000000" rasterYSize="2000000000">)"
    R"(<VRTRasterBand dataType="Float64" band="1"/></VRTDataset>)"));
}

TEST_F(TerrainRenderInput, NoCells)
{
  for (const auto& [width, height] :
    { std::pair<int, int>(1, 1), std::pair<int, int>(1, 9), std::pair<int, int>(9, 1) })
  {
    RasterDescription line;
    line.Width = width;
    line.Height = height;
    this->ExpectHeightsRefused(this->WriteRaster("line.tif", line), "no surface");
  }
}

TEST_F(TerrainRenderInput, OneCell)
{
  RasterDescription cell;
  cell.Sample = [](int i, int j) { return 0.2 * i + 0.1 * j; };
  this->ExpectDrawn(this->Draw(this->WriteRaster("cell.tif", cell)), 1000);
}

TEST_F(TerrainRenderInput, ConstantHeights)
{
  for (const double height : { 0.0, 1234.5, -400.0 })
  {
    RasterDescription flat;
    flat.Width = 40;
    flat.Height = 30;
    flat.Sample = [height](int, int) { return height; };
    this->ExpectDrawn(this->Draw(this->WriteRaster("flat.tif", flat)), 1000);
  }
}

TEST_F(TerrainRenderInput, AllNoData)
{
  RasterDescription none;
  none.Width = 40;
  none.Height = 30;
  none.HasNoData = true;
  none.Sample = [](int, int) { return -32767.0; };
  this->ExpectHeightsRefused(this->WriteRaster("none.tif", none), "no surface");
  none.HasNoData = false;
  none.Sample = [](int, int) { return std::numeric_limits<double>::quiet_NaN(); };
  this->ExpectHeightsRefused(this->WriteRaster("nan.tif", none), "no surface");
}

TEST_F(TerrainRenderInput, NotFiniteAndNoDataAreHoles)
{
  RasterDescription holes;
  holes.Width = 61;
  holes.Height = 61;
  holes.HasNoData = true;
  holes.Sample = [](int i, int j)
  {
    if (std::abs(i - 30) < 10 && std::abs(j - 30) < 10)
    {
      const double values[] = { std::numeric_limits<double>::quiet_NaN(),
        std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
        -32767.0 };
      return values[(i + j) % 4];
    }
    return 5.0;
  };
  // from straight above, 60 x 60 m in the middle of the picture
  const RunResult result =
    this->Draw(this->WriteRaster("holes.tif", holes), { "--camera", "30,-30,205,30,-30,5" });
  this->ExpectDrawn(result, 1000);
  const Depths depths = this->ReadDepths();
  EXPECT_TRUE(std::isnan(depths.At(80, 60)));
  EXPECT_NEAR(depths.At(80, 40), 200.0, 0.01);
  EXPECT_NEAR(depths.At(60, 60), 200.0, 0.01);
}

TEST_F(TerrainRenderInput, Rotation)
{
  RasterDescription rotated;
  rotated.Width = 8;
  rotated.Height = 8;
  rotated.GeoTransform = { 0.0, 0.8, 0.6, 0.0, 0.6, -0.8 };
  this->ExpectDrawn(this->Draw(this->WriteRaster("rotated.tif", rotated)), 1000);
}

TEST_F(TerrainRenderInput, ThreeBandsAreHeightsOfTheFirst)
{
  RasterDescription bands;
  bands.Width = 20;
  bands.Height = 20;
  bands.Bands = 3;
  bands.Sample = [](int i, int) { return i; };
  this->ExpectDrawn(this->Draw(this->WriteRaster("bands.tif", bands)), 1000);
}

TEST_F(TerrainRenderInput, ColoursAreNoHeights)
{
  RasterDescription image;
  image.Width = 20;
  image.Height = 20;
  image.Bands = 3;
  image.IsBytes = true;
  this->ExpectHeightsRefused(this->WriteRaster("image.tif", image));
}

TEST_F(TerrainRenderInput, FarFromTheOrigin)
{
  RasterDescription far;
  far.Width = 65;
  far.Height = 65;
  far.Sample = [](int i, int j) { return 10.0 * std::sin(i / 9.0) * std::cos(j / 7.0); };
  far.GeoTransform = { 500000.0, 30.0, 0.0, 9000000.0, 0.0, -30.0 };
  this->ExpectDrawn(this->Draw(this->WriteRaster("far.tif", far)), 1000);
}

TEST_F(TerrainRenderInput, CameraInsideAndUnderTheTerrain)
{
  const std::string hill = this->WriteHill();
  // inside the hill, below its top, looking out to the east; the raster's rows run south from y = 0
  this->ExpectDrawn(this->Draw(hill, { "--camera", "32,-24,5,40,-24,6" }), 100);
  // under the plain, looking up: the hill covers the picture
  this->ExpectDrawn(this->Draw(hill, { "--camera", "32,-24,-10,32,-24,10" }), 19000);
  // just above the top
  this->ExpectDrawn(this->Draw(hill, { "--camera", "32,-24,20.01,40,-24,19" }), 100);
}

TEST_F(TerrainRenderInput, CameraThatLooksAway)
{
  const RunResult result = this->Draw(this->WriteHill(), { "--camera", "32,-24,50,32,-24,90" });
  this->ExpectDrawn(result, 0);
  EXPECT_EQ(this->ReadDepths().CountHits(), 0);
}

TEST_F(TerrainRenderInput, SitesOfAFolderAreTerrainsOfOnePicture)
{
  constexpr double kAway = kAwayOfSites;
  const std::vector<std::string> plain{ this->WriteSites(), "--output", "picture.png", "--depth",
    "depth.tif", "--size", "800x800", "--stats", "stats.json" };
  std::vector<std::string> whole = plain;
  whole.insert(whole.end(), { "--camera", "500762,5000738,4000,500762,5000738,0,0,1,0" });
  const auto read = [this]
  {
    Json::Value stats;
    std::istringstream text(this->ReadText("stats.json"));
    EXPECT_TRUE(Json::parseFromStream(Json::CharReaderBuilder(), text, &stats, nullptr));
    return stats;
  };
  const RunResult both = this->Run(whole);
  EXPECT_EQ(both.Status, 0) << both.Errors;
  EXPECT_NE(both.Errors.find("--part N"), std::string::npos) << both.Errors;
  Json::Value stats = read();
  EXPECT_EQ(stats["sites"].asInt(), 2);
  EXPECT_NEAR(stats["bounds"][1].asDouble() - stats["bounds"][0].asDouble(), kAway + 23.5, 1e-6);
  EXPECT_EQ(stats["cell_unit"].asString(), "metre");
  EXPECT_NEAR(stats["height_range"][0].asDouble(), 0.0, 1e-5);
  EXPECT_NEAR(stats["height_range"][1].asDouble(), 109.4, 1e-4);
  const Depths depths = this->ReadDepths();
  int left = 0;
  int right = 0;
  for (int row = 0; row < depths.Height; ++row)
  {
    for (int column = 0; column < depths.Width; ++column)
    {
      int& half = 2 * column < depths.Width ? left : right;
      half += std::isfinite(depths.At(column, row)) ? 1 : 0;
    }
  }
  EXPECT_GT(left, 10);
  EXPECT_GT(right, 10);
  // from where both are seen they are specks: without a camera the first fills the picture
  const RunResult one = this->Run(plain);
  EXPECT_EQ(one.Status, 0) << one.Errors;
  EXPECT_NE(one.Errors.find("too far for one view, which shows number 1"), std::string::npos)
    << one.Errors;
  EXPECT_GT(this->ReadDepths().CountHits(), 800 * 800 / 5);
  EXPECT_EQ(read()["sites"].asInt(), 2);
  std::vector<std::string> second = plain;
  second.insert(second.end(), { "--part", "2" });
  EXPECT_EQ(this->Run(second).Status, 0);
  stats = read();
  EXPECT_FALSE(stats.isMember("sites"));
  EXPECT_NEAR(stats["height_range"][0].asDouble(), 100.0, 1e-5);
}

// The middles of the sites, by OGR.
TEST_F(TerrainRenderInput, PlacesLieOnTheGroundOfEachSite)
{
  const std::string isles = this->WriteSites();
  const std::vector<std::string> middles{ "3.00015266,45.15336916", "3.01924002,45.16687005" };
  for (const std::string& middle : middles)
  {
    const std::string ground = this->WriteText("one.csv", "lon,lat,name\n" + middle + ",Here\n");
    this->ExpectDrawn(this->Draw(isles,
      { "--look-from", middle + ",50agl", "--look-at", middle, "--labels", ground, "--stats",
        "stats.json" }));
    const Depths depths = this->ReadDepths();
    EXPECT_NEAR(depths.At(depths.Width / 2, depths.Height / 2), 50.0, 0.1) << middle;
    EXPECT_NE(this->ReadText("stats.json").find("Here"), std::string::npos);
  }
  // from one to the other; between them is no ground
  this->ExpectDrawn(this->Draw(isles,
                      { "--look-from", middles[0] + ",500agl", "--look-at", middles[1] + ",0agl",
                        "--view-angle", "5" }),
    1);
  const RunResult none =
    this->Draw(isles, { "--look-from", middles[0] + ",50agl", "--look-at", "3.01,45.16" });
  EXPECT_EQ(none.Status, 1);
  EXPECT_NE(none.Errors.find("'3.01,45.16' does not lie on the terrain"), std::string::npos);
}

TEST_F(TerrainRenderInput, SitesHaveRangesAndLegendsOfTheirOwn)
{
  const auto draw = [this](const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments{ this->WriteSites(), "--output", "picture.png", "--size",
      "320x240", "--hillshade" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    const RunResult result = this->Run(arguments);
    EXPECT_EQ(result.Status, 0) << result.Errors;
    return this->ReadPicture();
  };
  const auto countUnlike = [](const Picture& a, const Picture& b)
  {
    int unlike = 0;
    for (std::size_t i = 0; i < a.Values.size(); ++i)
    {
      unlike += std::abs(a.Values[i] - b.Values[i]) > 8 ? 1 : 0;
    }
    return unlike;
  };
  const Picture alone = draw({ "--part", "1" });
  EXPECT_GT(countUnlike(draw({}), alone), 5000);
  EXPECT_LT(countUnlike(draw({ "--range", "each" }), alone), 100);
  // panels at the right border, light over black
  const auto countPanels = [](const Picture& picture)
  {
    int panels = 0;
    for (int row = 1; row < picture.Height; ++row)
    {
      const int column = picture.Width - 10;
      panels += picture.At(column, row, 0) > 150 && picture.At(column, row - 1, 0) <= 150 ? 1 : 0;
    }
    return panels;
  };
  const std::string black = "--background=black";
  EXPECT_EQ(countPanels(draw({ black })), 0);
  EXPECT_EQ(countPanels(draw({ black, "--legend" })), 1);
  EXPECT_EQ(countPanels(draw({ black, "--legend", "--range", "each" })), 2);
}

TEST_F(TerrainRenderInput, WarningsAreToldOnce)
{
  // two sites, in two zones: the folder is read once for each of them
  std::filesystem::create_directory(this->Path("two"));
  RasterDescription tile;
  tile.Width = 65;
  tile.Height = 65;
  tile.Sample = [](int i, int j) { return 100.0 + i + 0.5 * j; };
  tile.GeoTransform = { 500000.0, 30.0, 0.0, 4980000.0, 0.0, -30.0 };
  tile.CoordinateSystem = "EPSG:32632";
  this->WriteRaster("two/a.tif", tile);
  tile.CoordinateSystem = "EPSG:32633";
  this->WriteRaster("two/b.tif", tile);
  const RunResult result = this->Run({ "two", "--size", "160x120", "--output", "picture.png" });
  EXPECT_EQ(result.Status, 0) << result.Errors;
  const std::string warning = "its tiles are in several CRSs";
  const std::size_t first = result.Errors.find(warning);
  ASSERT_NE(first, std::string::npos) << result.Errors;
  EXPECT_EQ(result.Errors.find(warning, first + 1), std::string::npos) << result.Errors;
}

TEST_F(TerrainRenderInput, RealFilesOfManyFormats)
{
  const std::string data = TERRAIN_RENDER_DATA_DIR;
  if (data.empty())
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set";
  }
  // USGS DEM, PNG, SRTM with voids, GeoTIFF whose fill value is not declared, float GeoTIFF
  for (const char* name : { "SainteHelens.dem", "aconcagua_srtm3_u16.png", "S34E018.hgt",
         "craterlake_elev_30m.tif", "monterey_topobathy_f32.tif" })
  {
    this->ExpectDrawn(this->Draw(data + "/" + name, { "--technique", "pyramid" }), 4000);
  }
}
