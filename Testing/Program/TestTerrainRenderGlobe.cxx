// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What terrain-render draws on a globe, and what it refuses there in a sentence.
#include "TerrainRenderFixture.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{
/// Heights in degrees: the upper left corner, the size of cells, and how many.
RasterDescription Degrees(double west, double north, double cell, int columns, int rows)
{
  RasterDescription raster;
  raster.Width = columns;
  raster.Height = rows;
  raster.CoordinateSystem = "EPSG:4326";
  raster.GeoTransform = { west, cell, 0.0, north, 0.0, -cell };
  raster.Sample = [](int i, int j) { return 1000.0 + 50.0 * (i % 7) + 30.0 * (j % 5); };
  return raster;
}

class TerrainRenderGlobe : public TerrainRenderFixture
{
protected:
  std::string WriteWorld(const std::string& system = "EPSG:4326")
  {
    RasterDescription world = Degrees(-180.0, 90.0, 2.0, 180, 90);
    world.CoordinateSystem = system;
    return this->WriteRaster("world.tif", world);
  }

  /// Pixels of a picture whose first channel leads the others by far.
  int CountRed(const std::string& path, const std::vector<std::string>& arguments)
  {
    const RunResult result = this->Draw(path, arguments);
    this->ExpectDrawn(result, 100);
    const Picture picture = this->ReadPicture();
    int red = 0;
    for (int k = 0; k < picture.Width * picture.Height; ++k)
    {
      const int row = k / picture.Width;
      const int column = k % picture.Width;
      red += picture.At(column, row, 0) > 150 && picture.At(column, row, 1) < 80 ? 1 : 0;
    }
    return red;
  }

  double MiddleDepth(const std::string& path, const std::vector<std::string>& arguments)
  {
    const RunResult result = this->Draw(path, arguments);
    this->ExpectDrawn(result, 100);
    this->Errors = result.Errors;
    const Depths depths = this->ReadDepths();
    return depths.At(depths.Width / 2, depths.Height / 2);
  }

  std::string Errors;
};
}

// A part of a planet fills the picture as a map of it would, wherever it lies.
TEST_F(TerrainRenderGlobe, PartsFillThePicture)
{
  for (const std::array<double, 2>& corner :
    { std::array<double, 2>{ 6.0, 47.0 }, { -71.0, -31.0 }, { 179.0, 1.0 }, { 30.0, 82.0 } })
  {
    SCOPED_TRACE(corner[0]);
    const std::string path =
      this->WriteRaster("part.tif", Degrees(corner[0], corner[1], 0.02, 100, 100));
    const RunResult result = this->Draw(path, { "--frame", "globe" });
    this->ExpectDrawn(result);
    const Depths depths = this->ReadDepths();
    EXPECT_GT(depths.CountHits(), depths.Width * depths.Height / 6); // narrow near a pole
    // and all of it is there: the border of the picture is free
    int border = 0;
    for (int x = 0; x < depths.Width; ++x)
    {
      border += std::isnan(depths.At(x, 0)) && std::isnan(depths.At(x, depths.Height - 1)) ? 0 : 1;
    }
    EXPECT_EQ(border, 0);
  }
}

// The ground is seen from beside the feet on, also where the whole planet is there.
TEST_F(TerrainRenderGlobe, EyesMayStandOnTheGround)
{
  RasterDescription flat = Degrees(-180.0, 90.0, 2.0, 180, 90);
  flat.Sample = [](int, int) { return 100.0; };
  const std::string path = this->WriteRaster("flat.tif", flat);
  this->ExpectDrawn(
    this->Draw(path, { "--look-from", "10,20,2agl", "--look-at", "10.0005,20,0agl" }), 100);
  const Depths depths = this->ReadDepths();
  const float feet = depths.At(depths.Width / 2, depths.Height - 1);
  EXPECT_GT(feet, 1.0F);
  EXPECT_LT(feet, 20.0F);
}

// Tracks and places on the near side are drawn, those behind the planet are not.
TEST_F(TerrainRenderGlobe, MarksLieOnIt)
{
  const std::string path = this->WriteWorld();
  const std::string near = this->WriteText(
    "near.geojson", R"({"type": "LineString", "coordinates": [[-20, -10], [20, 30]]})");
  const std::string far = this->WriteText(
    "far.geojson", R"({"type": "LineString", "coordinates": [[160, -10], [-160, 30]]})");
  EXPECT_GT(this->CountRed(path, { "--track", near }), 30);
  EXPECT_EQ(this->CountRed(path, { "--track", far }), 0);
  const std::string places = this->WriteText("places.csv", "lon,lat,name\n0,10,Near\n180,10,Far\n");
  this->ExpectDrawn(this->Draw(path, { "--labels", places, "--stats", "stats.json" }), 100);
  const std::string stats = this->ReadText("stats.json");
  EXPECT_NE(stats.find("Near"), std::string::npos);
  EXPECT_EQ(stats.find("Far"), std::string::npos);
  EXPECT_NE(stats.find("\"cell_unit\" : \"degree\""), std::string::npos) << stats;
  this->ExpectDrawn(this->Draw(path, { "--peaks", "5" }), 100);
}

TEST_F(TerrainRenderGlobe, PicturesAndShadowsLieOnIt)
{
  const std::string path = this->WriteWorld();
  RasterDescription picture = Degrees(-30.0, 30.0, 1.0, 60, 60);
  picture.Bands = 3;
  picture.IsBytes = true;
  picture.Sample = [](int, int) { return 200.0; };
  const std::string photo = this->WriteRaster("photo.tif", picture);
  this->ExpectDrawn(
    this->Draw(
      path, { "--drape", photo, "--shadows", "--sun-angle", "0", "--sun", "2024-03-20T12:00Z" }),
    100);
  // a slope of ten degrees to the east at nine in the morning throws no shadow, a wall does
  RasterDescription wall = Degrees(0.0, 1.0, 0.01, 100, 200);
  wall.Sample = [](int i, int) { return i == 50 ? 6000.0 : 0.0; };
  const std::string walls = this->WriteRaster("wall.tif", wall);
  const auto shade = [&](const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments{ "--frame", "globe", "--sun", "2024-03-20T08:00Z",
      "--look-from", "0.45,0,20000", "--look-at", "0.45,0.001,0" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    this->ExpectDrawn(this->Draw(walls, arguments), 100);
    const Picture drawn = this->ReadPicture();
    return drawn.At(drawn.Width / 2, drawn.Height / 2, 0);
  };
  EXPECT_LT(shade({ "--shadows" }), shade({}) - 20);
}

// Values of the west and of the east half of the world, on all rasters of a globe.
TEST_F(TerrainRenderGlobe, ValuesOfAnotherRasterColorIt)
{
  const std::string path = this->WriteWorld();
  RasterDescription halves = Degrees(-180.0, 90.0, 1.0, 360, 180);
  halves.Sample = [](int i, int) { return i < 180 ? 0.0 : 100.0; };
  const std::string values = this->WriteRaster("halves.tif", halves);
  RasterDescription region = Degrees(-10.0, 20.0, 0.1, 200, 200);
  region.Sample = [](int, int) { return 3000.0; };
  const std::string finer = this->WriteRaster("region.tif", region);
  for (const std::vector<std::string>& more :
    { std::vector<std::string>(), std::vector<std::string>{ "--finer", finer } })
  {
    std::vector<std::string> arguments{ "--color-by", values, "--colors", "viridis" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    this->ExpectDrawn(this->Draw(path, arguments), 100);
    const Picture drawn = this->ReadPicture();
    const auto red = [&drawn](double part)
    { return drawn.At(static_cast<int>(part * drawn.Width), drawn.Height / 2, 0); };
    EXPECT_GT(red(0.53), red(0.47) + 80);
  }
  const std::string none = this->WriteRaster("values.tif", Degrees(30.001, 40.0, 0.0001, 9, 9));
  ExpectRefused(this->Draw(path, { "--color-by", none }), 1, "no values on the terrain");
}

// A region in fine cells on a world in coarse ones: the finest counts, however the other one rises.
TEST_F(TerrainRenderGlobe, FinerHeightsWin)
{
  const std::string world = this->WriteWorld(); // 1000 m and more
  RasterDescription region = Degrees(0.0, 20.0, 0.1, 200, 200);
  region.Sample = [](int, int) { return 20.0; };
  const std::string finer = this->WriteRaster("region.tif", region);
  const std::vector<std::string> down = { "--look-from", "10,10,100000", "--look-at", "10,10,0" };
  EXPECT_LT(this->MiddleDepth(world, down), 99100.0);
  std::vector<std::string> both = down;
  both.insert(both.end(), { "--finer", finer });
  EXPECT_NEAR(this->MiddleDepth(world, both), 100000.0 - 20.0, 5.0);
  EXPECT_EQ(this->Errors, "");
  // the other way round, too, and beside the region the world is as it was
  const std::vector<std::string> beside = { "--look-from", "40,10,100000", "--look-at", "40,10,0",
    "--frame", "globe", "--finer", world };
  EXPECT_LT(this->MiddleDepth(finer, beside), 99100.0);
  ExpectRefused(this->Draw(world, { "--finer", finer, "--frame", "map" }), 1, "--frame globe");
  ExpectRefused(this->Draw(world, { "--finer", finer, "--peaks", "3" }), 1, "gdalbuildvrt");
}

// Along the border of a finer raster the coarse one falls to below it or rises beside it: seen
// aslant from outside and from inside, nothing is seen through between them.
TEST_F(TerrainRenderGlobe, NoGapOpensAroundFinerHeights)
{
  const std::string world = this->WriteWorld();
  for (const double height : { 20.0, 2500.0 })
  {
    RasterDescription region = Degrees(0.05, 20.03, 0.1, 200, 200);
    region.Sample = [height](int i, int j) { return height + 40.0 * ((i + j) % 5); };
    const std::string finer = this->WriteRaster("region.tif", region);
    for (const auto& [from, at] : { std::pair("10,-6,300000", "10,1,0"),
           std::pair("10,4,150000", "10.3,-1,0"), std::pair("-3,23,200000", "1,19.5,0") })
    {
      SCOPED_TRACE(::testing::Message() << from << " beside " << height);
      this->ExpectDrawn(
        this->Draw(world, { "--finer", finer, "--look-from", from, "--look-at", at }), 5000);
      const Depths depths = this->ReadDepths();
      int holes = 0;
      for (int x = 0; x < depths.Width; ++x)
      {
        bool below = false; // the horizon
        for (int y = 0; y < depths.Height; ++y)
        {
          const bool isHit = !std::isnan(depths.At(x, y));
          holes += below && !isHit ? 1 : 0;
          below = below || isHit;
        }
      }
      EXPECT_EQ(holes, 0);
    }
  }
}

// Systems of other worlds, each axis asked for its direction; spheres, ellipsoids and radii.
TEST_F(TerrainRenderGlobe, OtherWorldsAreAsTheirSystemsSay)
{
  struct Case
  {
    const char* System;
    double Radius; ///< at the equator
    bool HasRadii;
  };
  for (const Case& body :
    { Case{ "IAU_2015:49900", 3396190.0, false }, Case{ "IAU_2015:49900", 3396190.0, true },
      Case{ "IAU_2015:30100", 1737400.0, false }, Case{ "IAU_2015:30100", 1737400.0, true },
      Case{ "+proj=longlat +a=3396190 +b=3376200", 3396190.0, false },
      Case{ "IAU_2015:200000400", 255000.0, true } })
  {
    SCOPED_TRACE(body.System);
    RasterDescription part = Degrees(-10.0, 10.0, 0.2, 100, 100);
    part.CoordinateSystem = body.System;
    part.Sample = [&body](int i, int)
    { return (body.HasRadii ? body.Radius : 0.0) + (i < 50 ? 500.0 : 1500.0); };
    const std::string path = this->WriteRaster("part.tif", part);
    // from 50 km above, 3 degrees east of the middle, where it is high
    const double far = body.Radius + 50000.0;
    const double angle = 3.0 * 3.14159265358979 / 180.0;
    const std::string camera = std::to_string(far * std::cos(angle)) + "," +
      std::to_string(far * std::sin(angle)) + ",0,0,0,0";
    EXPECT_NEAR(this->MiddleDepth(path, { "--camera", camera }), 50000.0 - 1500.0, 40.0);
  }
  RasterDescription part = Degrees(-10.0, 10.0, 0.2, 100, 100);
  part.CoordinateSystem.clear();
  const std::string bare = this->WriteRaster("bare.tif", part);
  ExpectRefused(this->Draw(bare, { "--crs", "IAU_2015:49901" }), 1,
    "--crs '+proj=longlat +a=3396190 +b=3376200'");
  ExpectRefused(this->Draw(bare, { "--crs", "IAU_2015:49902" }), 2,
    "--crs '+proj=longlat +a=3396190 +b=3396190'");
  ExpectRefused(this->Draw(bare, { "--crs", "+proj=longlat +a=281000 +b=226000" }), 1, "+R=METRES");
  this->ExpectDrawn(this->Draw(bare, { "--crs", "+proj=longlat +a=3396190 +b=3376200" }), 100);
}

TEST_F(TerrainRenderGlobe, RefusesWhatItHasNot)
{
  const std::string part = this->WriteRaster("part.tif", Degrees(6.0, 47.0, 0.02, 100, 100));
  for (const auto& [option, mention] :
    std::vector<std::pair<std::vector<std::string>, std::string>>{
      { { "--water", "0" }, "--frame plane" }, { { "--block", "100" }, "--frame map" },
      { { "--sky-light" }, "--frame map" }, { { "--sun", "120,30" }, "date and time" },
      { { "--scale-bar" }, "--frame map" }, { { "--technique", "strips" }, "pyramid" } })
  {
    SCOPED_TRACE(option.front());
    std::vector<std::string> arguments{ "--frame", "globe" };
    arguments.insert(arguments.end(), option.begin(), option.end());
    ExpectRefused(this->Draw(part, arguments), 1, mention);
  }
}
