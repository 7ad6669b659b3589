// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours by slope, aspect and other rasters, classes, and what stands on and beside blocks.
#include "TerrainRenderFixture.h"

#include "vtk_jsoncpp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>

namespace
{
/// A plane that rises by 0.5 to the east, from 0 m: 101 x 81 samples of 30 m round 9 E, 45 N.
RasterDescription Slope()
{
  RasterDescription slope;
  slope.Width = 101;
  slope.Height = 81;
  slope.CoordinateSystem = "EPSG:32632";
  slope.GeoTransform = { 498500.0, 30.0, 0.0, 4984200.0, 0.0, -30.0 };
  slope.Sample = [](int i, int) { return 15.0 * i; };
  return slope;
}

class TerrainRenderColorBy : public TerrainRenderFixture
{
protected:
  void SetUp() override
  {
    TerrainRenderFixture::SetUp();
    this->Heights = this->WriteRaster("slope.tif", Slope());
  }

  RunResult Try(const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments = { this->Heights, "--size", "320x240", "--output",
      "picture.png" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    return this->Run(arguments);
  }

  /// From straight above.
  Picture DrawPicture(std::vector<std::string> options)
  {
    options.insert(options.end(), { "--look-from=9.0,45.0,7000", "--look-at=9.0,45.0,0" });
    const RunResult result = this->Try(options);
    EXPECT_EQ(result.Status, 0) << result.Errors;
    EXPECT_EQ(result.Errors, "");
    return this->ReadPicture();
  }

  /// West and east half of a raster of other pixels, in degrees.
  std::string WriteHalves(const std::string& name, double west, double east)
  {
    RasterDescription other;
    other.Width = 200;
    other.Height = 100;
    other.CoordinateSystem = "EPSG:4326";
    other.GeoTransform = { 8.97, 0.0003, 0.0, 45.02, 0.0, -0.0004 };
    other.Sample = [=](int i, int) { return i < 100 ? west : east; };
    return this->WriteRaster(name, other);
  }

  std::string Heights;
};

/// The channel that stands out of a pixel: 0 red, 1 green, 2 blue; -1 for a grey.
int HueOf(const Picture& picture, int column, int row)
{
  std::array<int, 3> rgb = { picture.At(column, row, 0), picture.At(column, row, 1),
    picture.At(column, row, 2) };
  const auto most = std::max_element(rgb.begin(), rgb.end());
  const auto least = std::min_element(rgb.begin(), rgb.end());
  return *most - *least < 60 ? -1 : static_cast<int>(most - rgb.begin());
}

int CountOthers(const Picture& a, const Picture& b)
{
  int unlike = 0;
  for (std::size_t i = 0; i < a.Values.size(); i += 3)
  {
    unlike += std::equal(&a.Values[i], &a.Values[i] + 3, &b.Values[i]) ? 0 : 1;
  }
  return unlike;
}
}

TEST_F(TerrainRenderColorBy, SlopeAndAspectAreWhatTheyAre)
{
  // 26.6 degrees everywhere, downhill to the west
  this->WriteText(
    "slope.cpt", "0 255/0/0 20 255/0/0\n20 0/255/0 30 0/255/0\n30 0/0/255 90 0/0/255\n");
  this->WriteText(
    "aspect.cpt", "0 255/0/0 260 255/0/0\n260 0/0/255 280 0/0/255\n280 255/0/0 360 255/0/0\n");
  const Picture slope = this->DrawPicture({ "--color-by", "slope", "--colors", "slope.cpt" });
  const Picture aspect = this->DrawPicture({ "--color-by", "aspect", "--colors", "aspect.cpt" });
  for (const int column : { 90, 130, 160, 200, 230 })
  {
    EXPECT_EQ(HueOf(slope, column, 120), 1) << column;
    EXPECT_EQ(HueOf(aspect, column, 120), 2) << column;
  }
}

// All of the slope has 26.6 degrees.
TEST_F(TerrainRenderColorBy, SlopesReachOverTheirScale)
{
  const Picture own = this->DrawPicture({ "--color-by", "slope" });
  EXPECT_EQ(CountOthers(own, this->DrawPicture({ "--color-by", "slope", "--range", "0,30" })), 0);
  EXPECT_GT(
    CountOthers(own, this->DrawPicture({ "--color-by", "slope", "--range", "0,60" })), 10000);
}

TEST_F(TerrainRenderColorBy, ValuesOfAnotherRasterLieInTheirPlaces)
{
  this->WriteHalves("rain.tif", 10.0, 90.0);
  this->WriteText("rain.cpt", "0 255/0/0 50 255/0/0\n50 0/0/255 100 0/0/255\n");
  const Picture picture =
    this->DrawPicture({ "--color-by", "rain.tif", "--colors", "rain.cpt", "--legend" });
  for (const int column : { 90, 120, 150 })
  {
    EXPECT_EQ(HueOf(picture, column, 120), 0) << column;
    EXPECT_EQ(HueOf(picture, 319 - column, 120), 2) << column;
  }
  // twice the legend: of tracks, too
  this->WriteText("route.json",
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"kind":"path"},)"
    R"("geometry":{"type":"LineString","coordinates":[[8.99,45.0],[9.01,45.0]]}}]})");
  const Picture both = this->DrawPicture({ "--color-by", "rain.tif", "--colors", "rain.cpt",
    "--legend", "--track", "route.json", "--track-color-by", "kind" });
  EXPECT_GT(CountOthers(picture, both), 500);
}

TEST_F(TerrainRenderColorBy, ClassesHaveTheirOwnColorsAndNames)
{
  this->WriteHalves("cover.tif", 4.0, 9.0);
  this->WriteText(
    "cover.csv", "value,colour,name\n4,#ff0000,Rock\n9,#0000ff,Lake\n5,green,None of it\n");
  const std::vector<std::string> options = { "--color-by", "cover.tif", "--colors", "cover.csv" };
  const Picture picture = this->DrawPicture(options);
  int others = 0;
  for (int column = 90; column < 230; ++column)
  {
    const int hue = HueOf(picture, column, 120);
    others += hue != (column < 160 ? 0 : 2) ? 1 : 0;
  }
  EXPECT_LE(others, 3) << "no class between two others";
  std::vector<std::string> more = options;
  more.emplace_back("--legend");
  EXPECT_GT(CountOthers(picture, this->DrawPicture(more)), 1000);
  // a value that no class has is told
  this->WriteHalves("other.tif", 4.0, 7.0);
  const RunResult unknown = this->Try({ "--color-by", "other.tif", "--colors", "cover.csv" });
  EXPECT_EQ(unknown.Status, 0);
  EXPECT_NE(unknown.Errors.find("7 is none of the classes"), std::string::npos) << unknown.Errors;
  // classes have neither a range nor an order
  std::vector<std::string> reversed = options;
  reversed.emplace_back("--reverse");
  ExpectRefused(this->Try(reversed), 1, "--reverse");
}

TEST_F(TerrainRenderColorBy, WhatCannotBeShownIsOneSentence)
{
  const auto refuse =
    [this](const std::vector<std::string>& options, int status, const std::string& mention)
  {
    const std::vector<std::string> before = this->ListFiles();
    ExpectRefused(this->Try(options), status, mention);
    EXPECT_EQ(this->ListFiles(), before);
  };
  refuse({ "--color-by", "nowhere.tif" }, 1, "nowhere.tif");
  refuse({ "--color-by", "" }, 2, "--color-by");
  refuse({ "--color-by", "slope.tif", "--color-band", "2" }, 1, "no band 2");
  ExpectRefused(
    this->Run({ this->Heights, "--color-by", "rain.tif", "--output", "rain.tif" }), 2, "rain.tif");
  refuse({ "--color-by", "slope", "--crossings" }, 2, "--color-by");
  RasterDescription far = Slope();
  far.GeoTransform[0] = 100000.0;
  this->WriteRaster("far.tif", far);
  refuse({ "--color-by", "far.tif" }, 1, "no values on the terrain");
  this->WriteText("bad.csv", "value,colour,name\n1,#12,a\n");
  refuse({ "--colors", "bad.csv" }, 2, "line 2");
  refuse({ "--strata", "red" }, 2, "--block");
  refuse({ "--block", "100", "--strata", "red,blue" }, 2, "--strata");
  refuse({ "--block", "100", "--strata", "red=-3,blue" }, 2, "--strata");
  refuse({ "--contour-labels" }, 2, "--contours");
  refuse({ "--track-width", "4" }, 2, "--track");
  refuse({ "--outline=round" }, 2, "--outline");
  this->WriteText("route.json",
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"kind":"path"},)"
    R"("geometry":{"type":"LineString","coordinates":[[8.99,45.0],[9.01,45.0]]}}]})");
  refuse({ "--track", "route.json", "--track-color-by", "speed" }, 1, "there are height, kind");
  refuse({ "--track", "route.json", "--track-width", "0m" }, 2, "--track-width");
}

TEST_F(TerrainRenderColorBy, StrataAreAsThickAsTheyAre)
{
  // the southern side, seen straight from the south: layers follow the surface
  const std::vector<std::string> side = { "--camera", "1500,-9000,300,1500,0,300", "--frame",
    "grid", "--view-angle", "14" };
  std::vector<std::string> options = side;
  options.insert(options.end(), { "--block", "900", "--strata", "red=300,lime=300,blue" });
  const RasterDescription plane = Slope();
  RasterDescription bare = plane;
  bare.CoordinateSystem.clear();
  bare.GeoTransform = { 0.0, 30.0, 0.0, 2430.0, 0.0, -30.0 };
  this->Heights = this->WriteRaster("bare.tif", bare);
  const RunResult result = this->Try(options);
  ASSERT_EQ(result.Status, 0) << result.Errors;
  const Picture picture = this->ReadPicture();
  int wrong = 0;
  int seen = 0;
  const double pixel =
    2.0 * 9000.0 * std::tan(7.0 * std::atan(1.0) / 45.0) / 240.0; // metres at y = 0
  for (int column = 20; column < 300; column += 7)
  {
    const double x = 1500.0 + (column + 0.5 - 160.0) * pixel;
    for (int row = 2; row < 238; row += 3)
    {
      const double z = 300.0 + (119.5 - row) * pixel;
      const double depth = 0.5 * x - z;
      const bool isNear = std::fmod(std::abs(depth) + 300.0, 300.0) < 40.0 ||
        std::fmod(std::abs(depth) + 300.0, 300.0) > 260.0;
      if (x < 60.0 || x > 2940.0 || depth < 40.0 || z < -860.0 || (isNear && depth < 650.0))
      {
        continue;
      }
      ++seen;
      wrong += HueOf(picture, column, row) != (depth < 300.0 ? 0 : (depth < 600.0 ? 1 : 2)) ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 400);
  EXPECT_LE(wrong, seen / 50);
}

TEST_F(TerrainRenderColorBy, WaterEndsWhereTheDataDo)
{
  RasterDescription half = Slope();
  half.HasNoData = true;
  half.Sample = [](int, int j) { return j < 40 ? -32767.0 : 100.0; };
  this->Heights = this->WriteRaster("half.tif", half);
  const Picture dry = this->DrawPicture({});
  const Picture wet = this->DrawPicture({ "--water", "300" });
  int north = 0;
  int south = 0;
  for (int column = 90; column < 230; ++column)
  {
    for (int row = 0; row < 240; ++row)
    {
      const bool isUnlike = dry.At(column, row, 0) != wet.At(column, row, 0) ||
        dry.At(column, row, 2) != wet.At(column, row, 2);
      north += isUnlike && row < 112 ? 1 : 0;
      south += isUnlike && row > 128 ? 1 : 0;
    }
  }
  EXPECT_EQ(north, 0);
  EXPECT_GT(south, 3000);
}

TEST_F(TerrainRenderColorBy, ContourLabelsAreHeightsOfTheirLines)
{
  const RunResult result = this->Try({ "--contours", "50", "--contour-labels", "--stats",
    "stats.json", "--look-from=9.0,45.0,7000", "--look-at=9.0,45.0,0" });
  ASSERT_EQ(result.Status, 0) << result.Errors;
  Json::Value root;
  std::ifstream(this->Path("stats.json")) >> root;
  EXPECT_GE(root["labels"].size(), 3U);
  for (const Json::Value& entry : root["labels"])
  {
    const std::string text = entry.asString();
    std::string number = text.substr(0, text.find(':'));
    number.erase(std::remove(number.begin(), number.end(), ','), number.end());
    EXPECT_EQ(std::stoi(number) % 250, 0) << text;
  }
}

TEST_F(TerrainRenderColorBy, MarksAreDrawn)
{
  const Picture bare = this->DrawPicture({});
  for (const std::vector<std::string>& options :
    { std::vector<std::string>{ "--outline" }, { "--outline=edge" }, { "--inset" },
      { "--height-scale", "--block", "500" }, { "--contours", "50", "--contour-index", "0" } })
  {
    EXPECT_GT(CountOthers(bare, this->DrawPicture(options)), 100) << options.front();
  }
  // every fifth line is wider
  const Picture even = this->DrawPicture({ "--contours", "50", "--contour-index", "0" });
  EXPECT_GT(CountOthers(even, this->DrawPicture({ "--contours", "50" })), 100);
}
