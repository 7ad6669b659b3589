// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Where terrain-render puts heights that lie somewhere on earth, and what it says of bad places.
#include "TerrainRenderFixture.h"

#include "vtk_jsoncpp.h"

#include <ogr_srs_api.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{
/// A raster of a test: the upper left corner and the size of its cells in units of its CRS.
struct Grid
{
  std::string System;
  double West;
  double North;
  double Cell;
};

constexpr int kWidth = 61;
constexpr int kHeight = 41;
/// Metres of height a column and a row.
constexpr double kColumnStep = 10.0;
constexpr double kRowStep = 3.0;
/// Where the tests look, in columns and rows.
constexpr double kColumn = 23.4;
constexpr double kRow = 17.3;
const Grid kDegrees{ "EPSG:4326", 86.9, 28.0, 0.0003 };
const Grid kUtm{ "EPSG:32645", 490000.0, 3098000.0, 30.0 };

RasterDescription Slope(const Grid& grid)
{
  RasterDescription slope;
  slope.Width = kWidth;
  slope.Height = kHeight;
  slope.CoordinateSystem = grid.System;
  slope.GeoTransform = { grid.West, grid.Cell, 0.0, grid.North, 0.0, -grid.Cell };
  slope.Sample = [](int i, int j) { return kColumnStep * i + kRowStep * j; };
  return slope;
}

constexpr double SlopeHeight(double column, double row)
{
  return kColumnStep * column + kRowStep * row;
}

/// Brings x, y from a CRS to another by OGR alone.
std::array<double, 2> Transform(const std::string& from, const std::string& to, double x, double y)
{
  std::array<OGRSpatialReferenceH, 2> references{};
  for (std::size_t i = 0; i < 2; ++i)
  {
    references[i] = OSRNewSpatialReference(nullptr);
    EXPECT_EQ(OSRSetFromUserInput(references[i], (i == 0 ? from : to).c_str()), OGRERR_NONE);
    OSRSetAxisMappingStrategy(references[i], OAMS_TRADITIONAL_GIS_ORDER);
  }
  OGRCoordinateTransformationH way = OCTNewCoordinateTransformation(references[0], references[1]);
  EXPECT_TRUE(OCTTransform(way, 1, &x, &y, nullptr));
  OCTDestroyCoordinateTransformation(way);
  OSRRelease(references[0]);
  OSRRelease(references[1]);
  return { x, y };
}

/// Longitude and latitude of a position between the samples of a raster.
std::array<double, 2> PlaceAt(const Grid& grid, double column, double row)
{
  return Transform(grid.System, "EPSG:4326", grid.West + (column + 0.5) * grid.Cell,
    grid.North - (row + 0.5) * grid.Cell);
}

std::string Text(const std::array<double, 2>& place, const std::string& height)
{
  std::ostringstream text;
  text.precision(12);
  text << place[0] << "," << place[1] << "," << height;
  return text.str();
}

/// Options of an eye straight above a position of a raster, at a height.
std::vector<std::string> LookDown(const Grid& grid, double column, double row, double height)
{
  const std::array<double, 2> place = PlaceAt(grid, column, row);
  return { "--look-from", Text(place, std::to_string(height)), "--look-at", Text(place, "-1000") };
}

/// Depth in the middle of the picture, between its four pixels.
double MiddleDepth(const Depths& depths)
{
  const int x = depths.Width / 2;
  const int y = depths.Height / 2;
  return 0.25 *
    (depths.At(x, y) + depths.At(x - 1, y) + depths.At(x, y - 1) + depths.At(x - 1, y - 1));
}

class TerrainRenderPlaces : public TerrainRenderFixture
{
protected:
  /// Draws, and returns the depth in the middle of the picture.
  double DrawDepth(const std::string& path, const std::vector<std::string>& arguments)
  {
    const RunResult result = this->Draw(path, arguments);
    this->LastErrors = result.Errors;
    this->ExpectDrawn(result, 1000);
    return MiddleDepth(this->ReadDepths());
  }

  void ExpectRefusal(
    const std::string& path, const std::vector<std::string>& arguments, const std::string& mention)
  {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    ExpectRefused(this->Draw(path, arguments), 1, mention);
  }

  Json::Value ReadStatistics() const
  {
    Json::Value stats;
    std::istringstream text(this->ReadText("stats.json"));
    EXPECT_TRUE(Json::parseFromStream(Json::CharReaderBuilder(), text, &stats, nullptr));
    return stats;
  }

  std::string LastErrors;
};
}

TEST_F(TerrainRenderPlaces, HeightsOfEverySystemAreWhereTheyBelong)
{
  // 0.01 cell of misplacement is 0.1 m of height
  const std::vector<Grid> grids = { kDegrees, kUtm, { "EPSG:32719", 400000.0, 6390000.0, 30.0 },
    { "EPSG:5041", 1999000.0, 2001000.0, 30.0 }, { "EPSG:3857", 1113000.0, 8400000.0, 60.0 },
    { "EPSG:2154", 950000.0, 6540000.0, 30.0 }, { "EPSG:3031", 300000.0, -1300000.0, 30.0 },
    { "EPSG:2263+5703", 980000.0, 200000.0, 100.0 }, { "EPSG:2180", 560000.0, 150000.0, 30.0 },
    { "EPSG:26710", 560000.0, 5110000.0, 30.0 } };
  for (const Grid& grid : grids)
  {
    const std::string path = this->WriteRaster("slope.tif", Slope(grid));
    EXPECT_NEAR(this->DrawDepth(path, LookDown(grid, kColumn, kRow, 3000.0)),
      3000.0 - SlopeHeight(kColumn, kRow), 0.15)
      << grid.System;
    EXPECT_EQ(this->LastErrors, "") << grid.System;
  }
}

TEST_F(TerrainRenderPlaces, CellsKeepTheirShape)
{
  // degrees and Web Mercator at 60 degrees north are resampled, half as wide as they look
  for (const Grid& grid :
    { Grid{ "EPSG:4326", 10.0, 60.01, 0.0005 }, Grid{ "EPSG:3857", 1113000.0, 8400000.0, 100.0 } })
  {
    const std::string path = this->WriteRaster("slope.tif", Slope(grid));
    this->ExpectDrawn(this->Draw(path, { "--stats", "stats.json" }), 1000);
    const Json::Value stats = this->ReadStatistics();
    EXPECT_TRUE(stats.isMember("place"));
    const bool inDegrees = grid.System == "EPSG:4326";
    const double sides = stats["columns"].asDouble() / stats["rows"].asDouble();
    const double expected = static_cast<double>(kWidth) / kHeight * (inDegrees ? 0.5 : 1.0);
    EXPECT_NEAR(sides / expected, 1.0, 0.06) << grid.System;
  }
  // true to scale: left alone
  this->ExpectDrawn(
    this->Draw(this->WriteRaster("utm.tif", Slope(kUtm)), { "--stats", "stats.json" }), 1000);
  const Json::Value stats = this->ReadStatistics();
  EXPECT_FALSE(stats.isMember("place"));
  EXPECT_EQ(stats["columns"].asInt(), kWidth);
  EXPECT_EQ(stats["crs"].asString(), "WGS 84 / UTM zone 45N");
}

TEST_F(TerrainRenderPlaces, FramesHaveTheirCoordinates)
{
  const std::string path = this->WriteRaster("slope.tif", Slope(kDegrees));
  const std::array<double, 2> place = PlaceAt(kDegrees, kColumn, kRow);
  const double expected = 3000.0 - SlopeHeight(kColumn, kRow);
  const auto camera = [](double x, double y)
  {
    std::ostringstream text;
    text.precision(12);
    text << x << "," << y << ",3000," << x << "," << y << ",0";
    return text.str();
  };
  for (const char* zone : { "45", "44" })
  {
    const std::array<double, 2> metres =
      Transform("EPSG:4326", std::string("EPSG:326") + zone, place[0], place[1]);
    EXPECT_NEAR(
      this->DrawDepth(
        path, { "--utm-zone", std::string(zone) + "N", "--camera", camera(metres[0], metres[1]) }),
      expected, 0.15);
  }
  for (const char* frame : { "plane", "local" })
  {
    EXPECT_NEAR(this->DrawDepth(path,
                  { "--origin", Text(place, "0"), "--frame", frame, "--camera", camera(0.0, 0.0) }),
      expected, 0.15);
  }
  const std::string utm = this->WriteRaster("utm.tif", Slope(kUtm));
  EXPECT_NEAR(
    this->DrawDepth(utm,
      { "--frame", "grid", "--camera",
        camera(kUtm.West + (kColumn + 0.5) * kUtm.Cell, kUtm.North - (kRow + 0.5) * kUtm.Cell) }),
    expected, 0.15);
  this->ExpectRefusal(path, { "--frame", "grid" }, "in degrees");
  this->ExpectRefusal(path, { "--frame", "geocentric" }, "geocentric");
}

TEST_F(TerrainRenderPlaces, CellAndInterpolation)
{
  const std::string path = this->WriteRaster("slope.tif", Slope(kUtm));
  std::vector<std::string> arguments = LookDown(kUtm, kColumn, kRow, 3000.0);
  arguments.insert(arguments.end(), { "--cell", "60", "--stats", "stats.json" });
  const double expected = 3000.0 - SlopeHeight(kColumn, kRow);
  EXPECT_NEAR(this->DrawDepth(path, arguments), expected, 0.15);
  EXPECT_NEAR(this->ReadStatistics()["columns"].asInt(), kWidth / 2, 2);
  arguments.emplace_back("--cubic");
  EXPECT_NEAR(this->DrawDepth(path, arguments), expected, 0.15);
  this->ExpectRefusal(path, { "--cell", "0.001" }, "samples");
}

TEST_F(TerrainRenderPlaces, EarthIsRoundOnRequest)
{
  RasterDescription wide;
  wide.Width = 301;
  wide.Height = 301;
  wide.CoordinateSystem = "EPSG:4326";
  wide.GeoTransform = { 9.0, 0.008, 0.0, 48.2, 0.0, -0.008 };
  const std::string path = this->WriteRaster("wide.tif", wide);
  const std::vector<std::string> camera = { "--camera", "80000,0,3000,80000,0,0" };
  EXPECT_NEAR(this->DrawDepth(path, camera), 3000.0, 0.01);
  EXPECT_NE(this->LastErrors.find("the flat scene is wrong by up to"), std::string::npos)
    << this->LastErrors;
  EXPECT_EQ(std::count(this->LastErrors.begin(), this->LastErrors.end(), '\n'), 1);
  const double radius = 6388e3; // of the prime vertical at 47 degrees north
  EXPECT_NEAR(this->DrawDepth(path, { camera[0], camera[1], "--curvature" }),
    3000.0 + 80000.0 * 80000.0 / (2.0 * radius), 0.5);
  EXPECT_EQ(this->LastErrors, "");
}

// 100 m become 2000, and the 501 m by which the ground falls stay what they are.
TEST_F(TerrainRenderPlaces, ExaggerationLeavesTheEarthAsItIs)
{
  RasterDescription wide;
  wide.Width = 301;
  wide.Height = 301;
  wide.CoordinateSystem = "EPSG:4326";
  wide.GeoTransform = { 9.0, 0.008, 0.0, 48.2, 0.0, -0.008 };
  wide.Sample = [](int, int) { return 100.0; };
  const std::string path = this->WriteRaster("plateau.tif", wide);
  const double radius = 6388e3; // of the prime vertical at 47 degrees north
  const double fall = 80000.0 * 80000.0 / (2.0 * radius);
  EXPECT_NEAR(this->DrawDepth(path,
                { "--camera", "80000,0,3000,80000,0,0", "--curvature", "--exaggeration", "20",
                  "--stats", "stats.json" }),
    3000.0 + fall - 2000.0 * (1.0 - fall / radius), 0.5);
  const Json::Value range = this->ReadStatistics()["height_range"];
  EXPECT_NEAR(range[0].asDouble(), 100.0, 1e-3);
  EXPECT_NEAR(range[1].asDouble(), 100.0, 1e-3);
}

TEST_F(TerrainRenderPlaces, LargePartsOfTheEarthStayMaps)
{
  RasterDescription half;
  half.Width = 180;
  half.Height = 90;
  half.CoordinateSystem = "EPSG:4326";
  half.GeoTransform = { -90.0, 1.0, 0.0, 45.0, 0.0, -1.0 };
  half.Sample = [](int i, int) { return 1e5 * std::sin(0.2 * i); };
  const std::string path = this->WriteRaster("half.tif", half);
  const RunResult result = this->Draw(path, { "--frame", "map", "--stats", "stats.json" });
  this->ExpectDrawn(result, 1000);
  EXPECT_NE(result.Errors.find("--frame globe"), std::string::npos) << result.Errors;
  EXPECT_EQ(this->ReadStatistics()["columns"].asInt(), 180);
  this->ExpectDrawn(this->Draw(path, { "--frame", "local" }), 1000);
  // what needs places says that there are none in this map
  this->ExpectRefusal(path, { "--frame", "map", "--graticule", "degrees" }, "--graticule needs");
}

// Half the earth, and a part of Mars, as they are: looking straight down on a place.
TEST_F(TerrainRenderPlaces, DegreesAreAGlobe)
{
  RasterDescription half;
  half.Width = 180;
  half.Height = 90;
  half.CoordinateSystem = "EPSG:4326";
  half.GeoTransform = { -90.0, 1.0, 0.0, 45.0, 0.0, -1.0 };
  half.Sample = [](int i, int j) { return 100.0 * i + 10.0 * j; };
  const std::string path = this->WriteRaster("half.tif", half);
  const RunResult result = this->Draw(path, { "--stats", "stats.json" });
  this->ExpectDrawn(result, 500);
  EXPECT_EQ(result.Errors, "");
  EXPECT_EQ(this->ReadStatistics()["columns"].asInt(), 180);
  // the sample of column 90, row 45 is at longitude 0.5, latitude -0.5
  const std::vector<std::string> down = { "--look-from", "0.5,-0.5,100000", "--look-at",
    "0.5,-0.5,0" };
  EXPECT_NEAR(this->DrawDepth(path, down), 100000.0 - 9450.0, 30.0);
  std::vector<std::string> twice = down;
  twice.insert(twice.end(), { "--exaggeration", "2" });
  EXPECT_NEAR(this->DrawDepth(path, twice), 2.0 * (100000.0 - 9450.0), 60.0);
  this->ExpectDrawn(
    this->Draw(path, { "--graticule", "degrees", "--sun", "2024-06-21T12:00Z" }), 500);
  this->ExpectRefusal(path, { "--frame", "globe", "--technique", "linear" }, "leave it at pyramid");
  this->ExpectRefusal(path, { "--frame", "globe", "--technique", "strips" }, "--technique");
  this->ExpectRefusal(path, { "--frame", "globe", "--scale-bar" }, "--frame map");
  this->ExpectRefusal(path, { "--block", "1000" }, "--block: does not go with --frame globe");
  this->ExpectRefusal(path, { "--cubic" }, "--cubic: does not go with --frame globe");
  this->ExpectRefusal(path, { "--frame", "globe", "--cell", "9000" }, "--cell");

  half.CoordinateSystem = "+proj=longlat +a=3396190 +b=3376200 +no_defs";
  const std::string mars = this->WriteRaster("mars.tif", half);
  EXPECT_NEAR(this->DrawDepth(mars, { "--camera", "3496190,0,0,0,0,0" }), 100000.0 - 9400.0, 100.0);
  this->ExpectRefusal(mars, { "--sun", "2024-06-21T12:00Z" }, "earth only");
  this->ExpectRefusal(mars, { "--frame", "plane" }, "another world");
}

// 18 x 9 degrees fill the default picture; of the whole planet they would be a pixel in a hundred.
TEST_F(TerrainRenderPlaces, PartOfAGlobeFillsThePicture)
{
  RasterDescription part;
  part.Width = 180;
  part.Height = 90;
  part.CoordinateSystem = "+proj=longlat +a=3396190 +b=3376200 +no_defs";
  part.Sample = [](int i, int j) { return 100.0 * i + 10.0 * j; };
  for (const double north : { 4.5, 54.5, -70.0 })
  {
    part.GeoTransform = { 100.0, 0.1, 0.0, north, 0.0, -0.1 };
    this->ExpectDrawn(this->Draw(this->WriteRaster("part.tif", part)), 2000);
  }
}

// So does a cap around a pole, in degrees of all longitudes.
TEST_F(TerrainRenderPlaces, CapOfAGlobeFillsThePicture)
{
  RasterDescription cap;
  cap.Width = 361;
  cap.Height = 21;
  cap.CoordinateSystem = "EPSG:4326";
  cap.Sample = [](int i, int j) { return 100.0 * (i % 9) + 10.0 * j; };
  for (const double north : { 90.25, -79.75 })
  {
    cap.GeoTransform = { -180.5, 1.0, 0.0, north, 0.0, -0.5 };
    this->ExpectDrawn(this->Draw(this->WriteRaster("cap.tif", cap)), 5000);
  }
}

TEST_F(TerrainRenderPlaces, CoordinateSystemOfTheCommandLine)
{
  // rows of 30 m in no system at all
  Grid bare = kUtm;
  bare.System.clear();
  const std::string path = this->WriteRaster("bare.tif", Slope(bare));
  std::vector<std::string> arguments = LookDown(kUtm, kColumn, kRow, 3000.0);
  this->ExpectRefusal(path, arguments, "no coordinate system");
  this->ExpectRefusal(path, { "--frame", "plane" }, "no coordinate system");
  arguments.insert(arguments.end(), { "--crs", "EPSG:32645" });
  EXPECT_NEAR(this->DrawDepth(path, arguments), 3000.0 - SlopeHeight(kColumn, kRow), 0.15);
  // degrees, which are taken for metres, with a warning, unless they are named
  Grid degrees = kDegrees;
  degrees.System.clear();
  const std::string unnamed = this->WriteRaster("unnamed.tif", Slope(degrees));
  EXPECT_NE(this->Draw(unnamed).Errors.find("degrees"), std::string::npos);
  arguments = LookDown(kDegrees, kColumn, kRow, 3000.0);
  arguments.insert(arguments.end(), { "--crs", "EPSG:4326" });
  EXPECT_NEAR(this->DrawDepth(unnamed, arguments), 3000.0 - SlopeHeight(kColumn, kRow), 0.15);
  EXPECT_EQ(this->LastErrors, "");
  // in place of what the file names: the zone beside the right one
  Grid wrong = kUtm;
  wrong.System = "EPSG:32644";
  const std::string misnamed = this->WriteRaster("misnamed.tif", Slope(wrong));
  arguments = LookDown(kUtm, kColumn, kRow, 3000.0);
  this->ExpectDrawn(this->Draw(misnamed, arguments), 0);
  EXPECT_EQ(this->ReadDepths().CountHits(), 0);
  arguments.insert(arguments.end(), { "--crs", "EPSG:32645" });
  EXPECT_NEAR(this->DrawDepth(misnamed, arguments), 3000.0 - SlopeHeight(kColumn, kRow), 0.15);
}

TEST_F(TerrainRenderPlaces, HeightsAboveTheEllipsoid)
{
  // a geoid 30 m below the ellipsoid everywhere, in GeographicLib's format
  std::ofstream file(this->Path("flat30.pgm"), std::ios::binary);
  file << "P5\n# Geoid file in PGM format for GeographicLib\n# Description made up by a test\n"
       << "# DateTime 2020-01-01 00:00:00\n# MaxBilinearError 0.1\n# RMSBilinearError 0.1\n"
       << "# MaxCubicError 0.1\n# RMSCubicError 0.1\n# Offset -108\n# Scale 0.003\n"
       << "# Origin 90N 0E\n# AREA_OR_POINT Point\n24 13\n65535\n";
  for (int i = 0; i < 24 * 13; ++i)
  {
    file.put(static_cast<char>(26000 >> 8)).put(static_cast<char>(26000 & 0xff));
  }
  file.close();
  setenv("GEOGRAPHICLIB_GEOID_PATH", this->Folder.c_str(), 1);
  for (const Grid& grid : { kDegrees, kUtm })
  {
    const std::string path = this->WriteRaster("slope.tif", Slope(grid));
    const double seaLevel = 3000.0 - SlopeHeight(kColumn, kRow);
    for (const char* vertical : { "as-is", "geoid", "ellipsoid" })
    {
      std::vector<std::string> arguments = LookDown(grid, kColumn, kRow, 3000.0);
      arguments.insert(arguments.end(), { "--vertical", vertical, "--geoid", "flat30" });
      EXPECT_NEAR(this->DrawDepth(path, arguments),
        seaLevel + (std::string(vertical) == "ellipsoid" ? 30.0 : 0.0), 0.15)
        << vertical;
    }
    this->ExpectRefusal(path, { "--vertical", "ellipsoid" }, "egm96-5.pgm");
    this->ExpectRefusal(
      path, { "--vertical", "ellipsoid", "--geoid", "egm2008-1" }, "geographiclib-get-geoids");
  }
  unsetenv("GEOGRAPHICLIB_GEOID_PATH");
}

TEST_F(TerrainRenderPlaces, HeightsInFeet)
{
  RasterDescription feet = Slope(kDegrees);
  feet.Unit = "ft";
  EXPECT_NEAR(
    this->DrawDepth(this->WriteRaster("feet.tif", feet), LookDown(kDegrees, kColumn, kRow, 3000.0)),
    3000.0 - 0.3048 * SlopeHeight(kColumn, kRow), 0.05);
}

TEST_F(TerrainRenderPlaces, EyeAboveTheGround)
{
  const std::string path = this->WriteRaster("slope.tif", Slope(kDegrees));
  const std::array<double, 2> place = PlaceAt(kDegrees, kColumn, kRow);
  for (const char* exaggeration : { "1", "2" })
  {
    const double drawn = 500.0 * std::atof(exaggeration);
    EXPECT_NEAR(this->DrawDepth(path,
                  { "--look-from", Text(place, "500agl"), "--look-at", Text(place, "0agl"),
                    "--exaggeration", exaggeration }),
      drawn, 0.2);
  }
  // an MGRS reference reads as well
  this->ExpectDrawn(this->Draw(path,
                      { "--look-from", "45RVL9000097000,5000", "--look-at",
                        Text(PlaceAt(kDegrees, 30.0, 20.0), "0") }),
    100);
  this->ExpectRefusal(
    path, { "--look-from", "12,47,500agl", "--look-at", Text(place, "0") }, "--look-from: '12,47");
  this->ExpectRefusal(
    path, { "--look-from", Text(place, "500agl"), "--look-at", "12,47" }, "--look-at: '12,47");
  this->ExpectRefusal(
    path, { "--look-from", Text(place, "0"), "--look-at", Text(place, "0") }, "same place");
}

TEST_F(TerrainRenderPlaces, SystemsThatFitNowhere)
{
  Grid wrong = kUtm;
  wrong.System = "EPSG:4326";
  this->ExpectRefusal(this->WriteRaster("degrees.tif", Slope(wrong)), {}, "degrees");
  const Grid swapped{ "EPSG:4326", 28.0, 116.9, 0.0003 };
  this->ExpectRefusal(this->WriteRaster("swapped.tif", Slope(swapped)), {}, "degrees");
  const Grid partly{ "EPSG:4326", 28.0, 91.0, 0.1 };
  this->ExpectRefusal(this->WriteRaster("partly.tif", Slope(partly)), {}, "longitude and latitude");
  const Grid wide{ "EPSG:4326", -200.0, 80.0, 8.0 };
  this->ExpectRefusal(this->WriteRaster("wide.tif", Slope(wide)), {}, "degrees");
  // a projection that does not reach so far: the file's own grid is drawn, with a warning
  const Grid far{ "EPSG:32645", 1e12, 1e12, 30.0 };
  const RunResult result = this->Draw(this->WriteRaster("far.tif", Slope(far)));
  EXPECT_EQ(result.Status, 0) << result.Errors;
  EXPECT_NE(result.Errors.find("does not reach"), std::string::npos) << result.Errors;
  this->ExpectRefusal(this->Path("far.tif"), { "--sun", "2024-06-21T06:30Z" }, "does not reach");
  // degrees under the name of metres
  const Grid small{ "EPSG:32645", 86.9, 28.0, 0.0003 };
  const RunResult odd = this->Draw(this->WriteRaster("small.tif", Slope(small)));
  EXPECT_EQ(odd.Status, 0);
  EXPECT_NE(odd.Errors.find("looks like degrees"), std::string::npos) << odd.Errors;
}

TEST_F(TerrainRenderPlaces, EngineeringSystem)
{
  Grid mine = kUtm;
  mine.System = "LOCAL_CS[\"mine\",UNIT[\"metre\",1]]";
  const std::string path = this->WriteRaster("mine.tif", Slope(mine));
  const RunResult result = this->Draw(path);
  this->ExpectDrawn(result, 1000);
  EXPECT_EQ(result.Errors, "");
  this->ExpectRefusal(path, { "--frame", "plane" }, "tied to no place");
  this->ExpectRefusal(path, { "--graticule", "utm" }, "tied to no place");
}

TEST_F(TerrainRenderPlaces, AxesInAnyOrder)
{
  // EPSG:2180 and EPSG:3035 count northings first; so does this definition of latitude, longitude
  Grid odd = kDegrees;
  odd.System =
    "GEOGCRS[\"odd\",DATUM[\"World Geodetic System 1984\",ELLIPSOID[\"WGS 84\",6378137,"
    "298.257223563]],CS[ellipsoidal,2],AXIS[\"latitude\",north,ORDER[1]],AXIS[\"longitude\",east,"
    "ORDER[2]],ANGLEUNIT[\"degree\",0.0174532925199433]]";
  const Grid lambert{ "EPSG:3035", 4321000.0, 3210000.0, 30.0 };
  for (const Grid& grid : { odd, lambert })
  {
    const std::string path = this->WriteRaster("slope.tif", Slope(grid));
    EXPECT_NEAR(this->DrawDepth(path, LookDown(grid, kColumn, kRow, 3000.0)),
      3000.0 - SlopeHeight(kColumn, kRow), 0.15);
  }
}

TEST_F(TerrainRenderPlaces, AcrossTheAntimeridianAndRoundThePole)
{
  const Grid fiji{ "EPSG:4326", 179.99, -17.0, 0.0003 };
  const std::string path = this->WriteRaster("fiji.tif", Slope(fiji));
  for (const double column : { 10.3, 50.7 })
  {
    EXPECT_NEAR(this->DrawDepth(path, LookDown(fiji, column, kRow, 3000.0)),
      3000.0 - SlopeHeight(column, kRow), 0.15);
  }
  RasterDescription cap;
  cap.Width = 360;
  cap.Height = 21;
  cap.CoordinateSystem = "EPSG:4326";
  cap.GeoTransform = { -180.0, 1.0, 0.0, 90.05, 0.0, -0.1 };
  cap.Sample = [](int, int j) { return 100.0 * j; };
  const std::string polar = this->WriteRaster("cap.tif", cap);
  // the pole itself, and the meridian where the raster closes
  for (const std::string place : { "0,90", "-180,89.05", "179.9,89.05", "37,89.05" })
  {
    const double expected = place == "0,90" ? 0.0 : 950.0;
    EXPECT_NEAR(
      this->DrawDepth(polar,
        { "--look-from", place + ",20000", "--look-at", place + ",-9000", "--view-angle", "3" }),
      20000.0 - expected, 20.0)
      << place;
  }
}

TEST_F(TerrainRenderPlaces, RealFilesInTheirPlaces)
{
  const std::string data = TERRAIN_RENDER_DATA_DIR;
  if (data.empty())
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set";
  }
  // the lake of Crater Lake is level at 1,882 m; Everest's DEM has a void there, so Lhotse's side
  EXPECT_NEAR(this->DrawDepth(data + "/aconcagua_srtm3_u16.png",
                { "--look-from", "-70.0111,-32.6532,12000", "--look-at", "-70.0111,-32.6532,0",
                  "--view-angle", "1" }),
    12000.0 - 6900.0, 60.0);
  this->ExpectDrawn(this->Draw(data + "/SainteHelens.dem",
                      { "--look-from", "-122.19,46.15,500agl", "--look-at", "-122.1867,46.1998",
                        "--sun", "2024-06-21T16:00Z" }),
    4000);
}
