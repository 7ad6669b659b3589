// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Polygons on the ground: filled, outlined, coloured by a field.
#include "TerrainRenderFixture.h"

#include <gdal.h>
#include <gdal_utils.h>

#include <array>
#include <cmath>

namespace
{
/// What the area of a picture's polygon may be off by: half a pixel along its borders.
constexpr double kAreaError = 400.0;

class TerrainRenderPolygons : public TerrainRenderFixture
{
protected:
  void SetUp() override
  {
    TerrainRenderFixture::SetUp();
    RasterDescription plain; // 3 x 2.4 km round 9 E, 45 N
    plain.Width = 101;
    plain.Height = 81;
    plain.CoordinateSystem = "EPSG:32632";
    plain.GeoTransform = { 498500.0, 30.0, 0.0, 4984200.0, 0.0, -30.0 };
    plain.Sample = [](int i, int) { return 0.5 * i; };
    this->Heights = this->WriteRaster("plain.tif", plain);
  }

  RunResult Try(const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments = { this->Heights, "--size", "320x240", "--output",
      "picture.png", "--colors", "grey", "--hillshade", "--background", "white" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    return this->Run(arguments);
  }

  /// From straight above.
  Picture DrawPicture(std::vector<std::string> options)
  {
    // 2,400 m are all of the height: 2 * 4,478 m * tan(15 degrees)
    options.insert(options.end(), { "--camera", "500000,4983000,4478.46,500000,4983000,0,0,1,0" });
    const RunResult result = this->Try(options);
    EXPECT_EQ(result.Status, 0) << result.Errors;
    EXPECT_EQ(result.Errors, "");
    return this->ReadPicture();
  }

  std::string WritePolygons(const std::string& name, const std::string& features) const
  {
    return this->WriteText(name,
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":)"
      R"("urn:ogc:def:crs:EPSG::32632"}},"features":[)" +
        features + "]}");
  }

  /// A square of 1,200 m with a hole of 600 m.
  std::string WriteFrame() const
  {
    return this->WritePolygons("frame.geojson",
      R"({"type":"Feature","properties":{"kind":"park","n":3},"geometry":{"type":"Polygon",)"
      R"("coordinates":[[[499400,4982400],[500600,4982400],[500600,4983600],[499400,4983600],)"
      R"([499400,4982400]],[[499700,4982700],[499700,4983300],[500300,4983300],[500300,4982700],)"
      R"([499700,4982700]]]}})");
  }

  std::string Heights;
};

using Test = bool (*)(int red, int green, int blue);

int Count(const Picture& picture, Test is)
{
  int count = 0;
  for (std::size_t i = 0; i < picture.Values.size(); i += 3)
  {
    count += is(picture.Values[i], picture.Values[i + 1], picture.Values[i + 2]) ? 1 : 0;
  }
  return count;
}

bool IsRed(int red, int green, int blue)
{
  return red > 100 && red > 3 * green && red > 3 * blue;
}

bool IsBluish(int red, int, int blue)
{
  return blue > red + 40;
}
}

// A pixel is 10 m.
TEST_F(TerrainRenderPolygons, FillsLeaveHolesOut)
{
  const std::vector<std::string> options = { "--polygons", this->WriteFrame(), "--polygon-colors",
    "red", "--polygon-opacity", "1", "--polygon-width", "0" };
  const Picture picture = this->DrawPicture(options);
  EXPECT_NEAR(Count(picture, IsRed), 120 * 120 - 60 * 60, kAreaError);
  const auto at = [&picture](int column, int row)
  {
    return IsRed(
      picture.At(column, row, 0), picture.At(column, row, 1), picture.At(column, row, 2));
  };
  EXPECT_FALSE(at(160, 120)); // the hole
  EXPECT_TRUE(at(115, 120));
  EXPECT_TRUE(at(160, 75));
  EXPECT_FALSE(at(160, 40)); // beside it
}

TEST_F(TerrainRenderPolygons, OutlinesGoRoundHoles)
{
  const Picture bare = this->DrawPicture({});
  EXPECT_EQ(Count(bare, IsRed), 0);
  const Picture lines = this->DrawPicture({ "--polygons", this->WriteFrame(), "--polygon-colors",
    "red", "--polygon-opacity", "0", "--polygon-width", "6" });
  // lines of 3 pixels, the least, 4 * 120 and 4 * 60 long
  EXPECT_NEAR(Count(lines, IsRed), 3 * (480 + 240), 200);
}

TEST_F(TerrainRenderPolygons, FormatsAreAlike)
{
  const auto draw = [this](const std::string& file)
  {
    return this->DrawPicture(
      { "--polygons", file, "--polygon-colors", "red", "--polygon-opacity", "0.5" });
  };
  const std::string frame = this->WriteFrame();
  const Picture first = draw(frame);
  GDALAllRegister();
  for (const auto& [driver, name] :
    { std::array<const char*, 2>{ "GPKG", "frame.gpkg" }, { "ESRI Shapefile", "frame.shp" } })
  {
    GDALDatasetH source = GDALOpenEx(frame.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr);
    std::array<char*, 7> words = { const_cast<char*>("-f"), const_cast<char*>(driver),
      const_cast<char*>("-t_srs"), const_cast<char*>("EPSG:4326"), const_cast<char*>("-nlt"),
      const_cast<char*>("MULTIPOLYGON"), nullptr };
    GDALVectorTranslateOptions* options = GDALVectorTranslateOptionsNew(words.data(), nullptr);
    const std::string path = this->Path(name);
    GDALDatasetH copy = GDALVectorTranslate(path.c_str(), nullptr, 1, &source, options, nullptr);
    GDALVectorTranslateOptionsFree(options);
    ASSERT_NE(copy, nullptr) << name;
    GDALClose(copy);
    GDALClose(source);
    const Picture other = draw(path);
    int unlike = 0;
    for (std::size_t i = 0; i < first.Values.size(); ++i)
    {
      unlike += std::abs(first.Values[i] - other.Values[i]) > 24 ? 1 : 0;
    }
    EXPECT_LT(unlike, 300) << name;
  }
}

TEST_F(TerrainRenderPolygons, FieldsChooseColors)
{
  const std::string two = this->WritePolygons("two.geojson",
    R"({"type":"Feature","properties":{"kind":"a","n":1},"geometry":{"type":"Polygon",)"
    R"("coordinates":[[[499000,4982400],[499600,4982400],[499600,4983600],[499000,4982400]]]}},)"
    R"({"type":"Feature","properties":{"kind":"b","n":2},"geometry":{"type":"Polygon",)"
    R"("coordinates":[[[500400,4982400],[501000,4982400],[501000,4983600],[500400,4982400]]]}})");
  // classes: orange and sky blue
  const Picture classes = this->DrawPicture(
    { "--polygons", two, "--polygon-color-by", "kind", "--polygon-opacity", "1" });
  EXPECT_NEAR(Count(classes, IsBluish), 60 * 120 / 2, kAreaError);
  this->WriteText("n.cpt", "1 255/0/0 1.5 255/0/0\n1.5 0/0/255 2 0/0/255\n");
  const Picture numbers = this->DrawPicture({ "--polygons", two, "--polygon-color-by", "n",
    "--polygon-colors", "n.cpt", "--polygon-opacity", "1" });
  EXPECT_NEAR(Count(numbers, IsRed), 60 * 120 / 2, kAreaError);
  EXPECT_NEAR(Count(numbers, IsBluish), 60 * 120 / 2, kAreaError);
  // their legend stands at the right
  const Picture legend = this->DrawPicture(
    { "--polygons", two, "--polygon-color-by", "kind", "--polygon-opacity", "0", "--legend" });
  EXPECT_GT(Count(legend, IsBluish), 40);
}

// A square on each of two terrains; from straight above both are as large.
TEST_F(TerrainRenderPolygons, LieOnAllSitesOfAFolder)
{
  std::string features;
  for (const double site : { 0.0, kAwayOfSites })
  {
    const auto point = [site](double x, double y)
    {
      return "[" + std::to_string(500000.0 + site + x) + "," +
        std::to_string(5000000.0 + site - 24.0 + y) + "]";
    };
    features += std::string(features.empty() ? "" : ",") +
      R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[)" +
      point(6, 6) + "," + point(18, 6) + "," + point(18, 18) + "," + point(6, 18) + "," +
      point(6, 6) + "]]}}";
  }
  const std::string file = this->WriteText("squares.geojson",
    R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":)"
    R"("urn:ogc:def:crs:EPSG::32631"}},"features":[)" +
      features + "]}");
  const std::string folder = this->WriteSites();
  for (const std::string part : { "fill", "outline" })
  {
    std::array<int, 2> counts{};
    for (const int site : { 0, 1 })
    {
      const double x = 500012.0 + site * kAwayOfSites;
      const double y = 4999988.0 + site * kAwayOfSites;
      const std::string eye = std::to_string(x) + "," + std::to_string(y);
      const std::string ground = site == 0 ? "5" : "105";
      const RunResult result =
        this->Run({ folder, "--size", "320x240", "--output", "picture.png", "--colors", "grey",
          "--hillshade", "--polygons", file, "--polygon-colors", "red", "--polygon-opacity",
          part == "fill" ? "1" : "0", "--polygon-width", part == "fill" ? "0" : "4", "--camera",
          eye + (site == 0 ? ",65," : ",165,") + eye + "," + ground + ",0,1,0" });
      ASSERT_EQ(result.Status, 0) << result.Errors;
      counts[static_cast<std::size_t>(site)] = Count(this->ReadPicture(), IsRed);
    }
    EXPECT_GT(counts[0], 500) << part;
    EXPECT_NEAR(counts[1], counts[0], 0.1 * counts[0]) << part;
  }
}

TEST_F(TerrainRenderPolygons, WhatCannotBeDrawnIsOneSentence)
{
  const auto refuse =
    [this](const std::vector<std::string>& options, int status, const std::string& mention)
  {
    const std::vector<std::string> before = this->ListFiles();
    ExpectRefused(this->Try(options), status, mention);
    EXPECT_EQ(this->ListFiles(), before) << mention;
  };
  const std::string frame = this->WriteFrame();
  const std::string text = this->ReadText("frame.geojson");
  refuse({ "--polygons", "nowhere.gpkg" }, 1, "nowhere.gpkg");
  refuse({ "--polygons", this->WriteText("cut.geojson", text.substr(0, text.size() - 60)) }, 1,
    "cut.geojson");
  refuse({ "--polygons",
           this->WritePolygons("points.geojson",
             R"({"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":)"
             R"([499000,4982400]}})") },
    1, "there are no polygons in it");
  refuse({ "--polygons", frame, "--polygon-color-by", "owner" }, 1, "there are height, kind, n");
  refuse({ "--polygons", frame, "--frame", "local" }, 1, "choose --frame plane");
  refuse({ "--polygon-color-by", "kind" }, 2, "give --polygons FILE");
  refuse({ "--polygons", frame, "--polygon-colors", "inferno" }, 2, "--polygon-color-by says");
  refuse({ "--polygons", frame, "--polygon-opacity", "2" }, 2, "--polygon-opacity");
  ExpectRefused(
    this->Run({ this->Heights, "--polygons", frame, "--output", frame }), 2, "is read from");
}
