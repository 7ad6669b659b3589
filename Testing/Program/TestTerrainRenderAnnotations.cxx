// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What terrain-render draws onto and over the terrain: tracks, graticules, scale bars, sunlight.
#include "TerrainRenderFixture.h"

#include <algorithm>
#include <cmath>

namespace
{
/// A north-south ridge of 91 x 81 samples of about 30 m round 86.915 E, 28 N: 1,000 m high in the
/// middle column, 20 m less a column to both sides.
RasterDescription Ridge()
{
  RasterDescription ridge;
  ridge.Width = 91;
  ridge.Height = 81;
  ridge.CoordinateSystem = "EPSG:4326";
  ridge.GeoTransform = { 86.90135, 0.0003, 0.0, 28.01215, 0.0, -0.0003 };
  ridge.Sample = [](int i, int) { return 1000.0 - 20.0 * std::abs(i - 45); };
  return ridge;
}

/// From straight above, 30 degrees of 6,000 m: all of the ridge.
const std::vector<std::string> kAbove = { "--look-from", "86.915,28,7000", "--look-at",
  "86.915,28,0" };

std::vector<std::string> Above(const std::vector<std::string>& more)
{
  std::vector<std::string> arguments = kAbove;
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

bool IsRed(const Picture& picture, int column, int row)
{
  return picture.At(column, row, 0) > 150 && picture.At(column, row, 1) < 90 &&
    picture.At(column, row, 2) < 90;
}

int CountRed(const Picture& picture)
{
  int red = 0;
  for (int row = 0; row < picture.Height; ++row)
  {
    for (int column = 0; column < picture.Width; ++column)
    {
      red += IsRed(picture, column, row) ? 1 : 0;
    }
  }
  return red;
}

int CountDifferent(const Picture& a, const Picture& b)
{
  int different = 0;
  for (std::size_t i = 0; i < a.Values.size(); i += 3)
  {
    different += std::equal(&a.Values[i], &a.Values[i] + 3, &b.Values[i]) ? 0 : 1;
  }
  return different;
}

/// Mean of the green channel over a column of the picture.
double MeanOfColumn(const Picture& picture, int column)
{
  double sum = 0.0;
  for (int row = 40; row < 80; ++row)
  {
    sum += picture.At(column, row, 1) / 40.0;
  }
  return sum;
}

class TerrainRenderAnnotations : public TerrainRenderFixture
{
protected:
  void SetUp() override
  {
    TerrainRenderFixture::SetUp();
    this->Heights = this->WriteRaster("ridge.tif", Ridge());
  }

  std::string WriteTrack(const std::string& name, const std::string& points) const
  {
    return this->WriteText(name,
      R"(<?xml version="1.0"?><gpx version="1.1" creator="test" )"
      R"(xmlns="http://www.topografix.com/GPX/1/1"><trk><trkseg>)" +
        points + "</trkseg></trk></gpx>");
  }

  Picture DrawPicture(const std::vector<std::string>& arguments)
  {
    const RunResult result = this->Draw(this->Heights, arguments);
    EXPECT_EQ(result.Errors, "");
    this->ExpectDrawn(result, 2000);
    return this->ReadPicture();
  }

  std::string Heights;
};

const char* const kWestToEast = R"(<trkpt lat="28.0" lon="86.905"><ele>2000</ele></trkpt>)"
                                R"(<trkpt lat="28.0" lon="86.925"><ele>2000</ele></trkpt>)";
}

TEST_F(TerrainRenderAnnotations, TrackLiesOnTheGround)
{
  const Picture bare = this->DrawPicture(kAbove);
  EXPECT_EQ(CountRed(bare), 0);
  const Depths depths = this->ReadDepths();
  const std::string track = this->WriteTrack("track.gpx", kWestToEast);
  const Picture picture = this->DrawPicture(Above({ "--track", track }));
  // through the middle of the picture, in its middle rows only
  for (const int column : { 60, 70, 80, 90, 100 })
  {
    EXPECT_TRUE(IsRed(picture, column, 59) || IsRed(picture, column, 60)) << column;
    EXPECT_FALSE(IsRed(picture, column, 50)) << column;
  }
  // the depths are those of the terrain alone
  EXPECT_EQ(this->ReadDepths().At(80, 60), depths.At(80, 60));
  // seen along the ridge, the track climbs it from both sides; at its own height it is level
  const std::vector<std::string> along = { "--look-from", "86.915,27.96,1500", "--look-at",
    "86.915,28,1000" };
  const auto highestRed = [](const Picture& seen, int column)
  {
    for (int row = 0; row < seen.Height; ++row)
    {
      if (IsRed(seen, column, row))
      {
        return row;
      }
    }
    return seen.Height;
  };
  std::vector<std::string> arguments = along;
  arguments.insert(arguments.end(), { "--track", track });
  const Picture climbing = this->DrawPicture(arguments);
  EXPECT_LT(highestRed(climbing, 80) + 8, highestRed(climbing, 62));
  arguments.insert(arguments.end(), { "--track-mode", "absolute" });
  const Picture level = this->DrawPicture(arguments);
  EXPECT_NEAR(highestRed(level, 80), highestRed(level, 62), 1);
  EXPECT_LT(highestRed(level, 80), highestRed(climbing, 80) - 8);
}

TEST_F(TerrainRenderAnnotations, VectorsOfAnySystemAndKind)
{
  const char* const json = R"({"type":"FeatureCollection","crs":{"type":"name","properties":)"
                           R"({"name":"urn:ogc:def:crs:EPSG::32645"}},"features":[)"
                           R"({"type":"Feature","properties":{},"geometry":%s}]})";
  // the middle of the ridge in UTM 45 N
  const std::string middle = "[491642.6,3097205.3]";
  const std::vector<std::string> geometries = { R"({"type":"Point","coordinates":)" + middle + "}",
    R"({"type":"MultiLineString","coordinates":[[[491342.9,3097205.3],[491942.9,3097205.3]]]})",
    R"({"type":"Polygon","coordinates":[[)" + middle +
      R"(,[491942.9,3097205.3],[491942.9,3097482.1],)" + middle + "]]}" };
  for (const std::string& geometry : geometries)
  {
    std::string text = json;
    text.replace(text.find("%s"), 2, geometry);
    const Picture picture =
      this->DrawPicture(Above({ "--track", this->WriteText("layer.json", text) }));
    EXPECT_TRUE(IsRed(picture, 80, 60) || IsRed(picture, 79, 59)) << geometry;
    EXPECT_LT(CountRed(picture), 400) << geometry;
  }
}

TEST_F(TerrainRenderAnnotations, TracksThatCannotBeDrawn)
{
  const auto refuse = [this](const std::string& path, const std::string& mention)
  {
    const std::vector<std::string> before = this->ListFiles();
    ExpectRefused(this->Draw(this->Heights, { "--track", path }), 1, mention);
    EXPECT_EQ(this->ListFiles(), before);
  };
  refuse(this->Path("nowhere.gpx"), "nowhere.gpx");
  refuse(this->WriteText("text.gpx", "These are no points.\n"), "text.gpx");
  refuse(this->WriteTrack("empty.gpx", ""), "no points");
  refuse(this->Heights, "ridge.tif");
  refuse(
    this->WriteTrack("far.gpx", R"(<trkpt lat="47.0" lon="11.0"/><trkpt lat="47.1" lon="11.0"/>)"),
    "does not meet the terrain");
}

TEST_F(TerrainRenderAnnotations, GraticuleScaleBarAndArrow)
{
  const Picture bare = this->DrawPicture(kAbove);
  const Depths depths = this->ReadDepths();
  for (const std::vector<std::string>& arguments :
    { std::vector<std::string>{ "--graticule", "degrees" }, { "--graticule", "utm" },
      { "--scale-bar" }, { "--north-arrow" } })
  {
    const Picture picture = this->DrawPicture(Above(arguments));
    EXPECT_GT(CountDifferent(bare, picture), 40) << arguments.front();
    EXPECT_LT(CountDifferent(bare, picture), 160 * 120 / 2) << arguments.front();
    EXPECT_EQ(this->ReadDepths().CountHits(), depths.CountHits());
  }
}

TEST_F(TerrainRenderAnnotations, ScaleBarAndArrowNeedNoPlaces)
{
  const std::string hill = this->WriteHill();
  const RunResult result = this->Draw(hill, { "--scale-bar", "--north-arrow" });
  this->ExpectDrawn(result, 1000);
  EXPECT_EQ(result.Errors, "");
}

TEST_F(TerrainRenderAnnotations, SunRisesInTheEast)
{
  // 1:30 UTC is 7:18 by the sun there, 10:30 is 16:18
  const Picture morning = this->DrawPicture(Above({ "--sun", "2024-06-21T01:30Z" }));
  EXPECT_GT(MeanOfColumn(morning, 90), MeanOfColumn(morning, 70) + 20.0);
  const Picture evening = this->DrawPicture(Above({ "--sun", "2024-06-21T16:15+05:45" }));
  EXPECT_GT(MeanOfColumn(evening, 70), MeanOfColumn(evening, 90) + 20.0);
  const RunResult night = this->Draw(this->Heights, Above({ "--sun", "2024-06-21T18:00Z" }));
  this->ExpectDrawn(night, 3000);
  EXPECT_NE(night.Errors.find("night"), std::string::npos) << night.Errors;
}

TEST_F(TerrainRenderAnnotations, ShadowsFollowTheSun)
{
  // a low sun in the east of a ridge on a plain, which is dark to the west of it
  RasterDescription onPlain = Ridge();
  onPlain.Sample = [](int i, int) { return std::max(0.0, 1000.0 - 60.0 * std::abs(i - 45)); };
  this->Heights = this->WriteRaster("plain.tif", onPlain);
  const std::vector<std::string> low = Above({ "--sun", "90,12" });
  std::vector<std::string> arguments = low;
  const Picture lit = this->DrawPicture(arguments);
  arguments.emplace_back("--shadows");
  const Picture shadows = this->DrawPicture(arguments);
  EXPECT_GT(CountDifferent(lit, shadows), 1000);
  arguments.emplace_back("--sky-light");
  EXPECT_GT(CountDifferent(shadows, this->DrawPicture(arguments)), 1000);
}

TEST_F(TerrainRenderAnnotations, ADayIsAPictureForEachStep)
{
  const RunResult result = this->Draw(
    this->Heights, Above({ "--shadows", "--sun", "2024-06-21T01:30Z/2024-06-21T11:30Z/300" }));
  EXPECT_EQ(result.Status, 0) << result.Errors;
  const std::vector<std::string> files = this->ListFiles();
  const auto count = [&files](const char* end)
  {
    return std::count_if(files.begin(), files.end(),
      [end](const std::string& file) { return file.find(end) != std::string::npos; });
  };
  EXPECT_EQ(count("-001.png") + count("-002.png") + count("-003.png"), 3);
  EXPECT_EQ(count("-004.png"), 0);
}

TEST_F(TerrainRenderAnnotations, LinesShadeAndBlock)
{
  const Picture plain = this->DrawPicture(Above({}));
  for (const std::vector<std::string>& arguments :
    { std::vector<std::string>{ "--contours", "50" }, { "--hillshade" }, { "--legend" } })
  {
    EXPECT_GT(CountDifferent(plain, this->DrawPicture(Above(arguments))), 30) << arguments.front();
  }
  // the walls of a block are seen from the side
  EXPECT_GT(CountDifferent(this->DrawPicture({}), this->DrawPicture({ "--block", "500" })), 300);
}

// Over black ground: dark text on a light panel that grows with the picture and stays within it.
TEST_F(TerrainRenderAnnotations, LegendsAreReadableOverAnyGround)
{
  this->WriteText("black.cpt", "-10000 0/0/0 10000 0/0/0\n");
  const auto draw = [this](const std::string& size, const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments = Above(more);
    arguments.insert(arguments.end(),
      { this->Heights, "--colors", "black.cpt", "--view-angle", "1", "--size", size, "--output",
        "picture.png" });
    const RunResult result = this->Run(arguments);
    EXPECT_EQ(result.Status, 0) << result.Errors;
    return this->ReadPicture();
  };
  // pixels that are not the ground's, of them those of the panel; and their first column
  struct Legend
  {
    int Others = 0;
    int Panel = 0;
    int First = 0;
  };
  const auto find = [](const Picture& picture)
  {
    Legend legend;
    legend.First = picture.Width;
    for (int column = 0; column < picture.Width; ++column)
    {
      for (int row = 0; row < picture.Height; ++row)
      {
        const int red = picture.At(column, row, 0);
        legend.Others += red > 0 ? 1 : 0;
        legend.Panel += red > 180 ? 1 : 0;
        legend.First = red > 0 ? std::min(legend.First, column) : legend.First;
      }
    }
    return legend;
  };
  ASSERT_EQ(find(draw("400x300", {})).Others, 0);
  const Legend plain = find(draw("400x300", { "--legend" }));
  EXPECT_GT(plain.Panel, 4000);
  EXPECT_GT(plain.Others - plain.Panel, 400); // the text and the frame of the bar
  EXPECT_GT(plain.First, 280);
  const Legend large = find(draw("800x600", { "--legend" }));
  EXPECT_NEAR(large.Panel, 4.0 * plain.Panel, 0.6 * plain.Panel);
  const Legend wrapped = find(
    draw("400x300", { "--legend=Height above the sea in metres, as the survey of 2019 has it" }));
  EXPECT_GT(wrapped.First, 200);
  EXPECT_GT(wrapped.Panel, plain.Panel);
  const Legend word = find(draw("400x300", { "--legend=" + std::string(200, 'm') }));
  EXPECT_GT(word.First, 2);
}

// Where a billionth of a metre is lost beside the height.
TEST_F(TerrainRenderAnnotations, LegendsOfFlatGroundEnd)
{
  RasterDescription flat;
  flat.Width = flat.Height = 8;
  flat.Sample = [](int, int) { return 9e6; };
  this->Heights = this->WriteRaster("flat.tif", flat);
  const RunResult result = this->Draw(this->Heights, { "--legend" });
  EXPECT_EQ(result.Status, 0) << result.Errors;
}

// Without a camera, the terrain fills what the panel and the title leave.
TEST_F(TerrainRenderAnnotations, LegendsAndTitlesCoverNothing)
{
  struct Borders
  {
    int Right = 0;
    int Top = 0;
  };
  const auto draw = [this](const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments = { this->Heights, "--size", "400x300", "--depth",
      "depth.tif", "--output", "picture.png" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult result = this->Run(arguments);
    EXPECT_EQ(result.Status, 0) << result.Errors;
    const Depths depths = this->ReadDepths("depth.tif");
    Borders borders{ 0, depths.Height };
    for (int row = 0; row < depths.Height; ++row)
    {
      for (int column = 0; column < depths.Width; ++column)
      {
        if (std::isfinite(depths.At(column, row)))
        {
          borders.Right = std::max(borders.Right, column);
          borders.Top = std::min(borders.Top, row);
        }
      }
    }
    return borders;
  };
  const Borders plain = draw({});
  EXPECT_GT(plain.Right, 300);
  const Borders legend = draw({ "--legend" });
  // the panel begins right of column 280, as LegendsAreReadableOverAnyGround has it
  EXPECT_LT(legend.Right, 300);
  EXPECT_GT(legend.Right, 200);
  const Borders both = draw({ "--legend=Height in metres above the sea", "--title", "Ridge" });
  EXPECT_LT(both.Right, 300);
  EXPECT_GE(both.Top, 300 * 8 / 100);
}

TEST_F(TerrainRenderAnnotations, PictureOfAnotherSystem)
{
  // in UTM, over the western part of the ridge only: red, green in its northern half, and a corner
  // without data
  RasterDescription photo;
  photo.Width = 100;
  photo.Height = 240;
  photo.Bands = 3;
  photo.IsBytes = true;
  photo.CoordinateSystem = "EPSG:32645";
  photo.GeoTransform = { 490642.6, 10.0, 0.0, 3098405.3, 0.0, -10.0 };
  photo.HasNoData = true;
  photo.NoData = 0.0;
  photo.Sample = [](int, int j) { return j < 120 ? 60.0 : 200.0; };
  const std::string path = this->WriteRaster("photo.tif", photo);
  const Picture bare = this->DrawPicture(kAbove);
  const Picture picture = this->DrawPicture(Above({ "--drape", path }));
  const Picture onStrips = this->DrawPicture(Above({ "--drape", path, "--technique", "strips" }));
  int others = 0;
  for (std::size_t i = 0; i < picture.Values.size(); ++i)
  {
    others += std::abs(int{ picture.Values[i] } - int{ onStrips.Values[i] }) > 15 ? 1 : 0;
  }
  EXPECT_LT(others, static_cast<int>(picture.Values.size()) / 100) << "the same on strips";
  const auto differs = [&](int column, int row)
  { return std::abs(picture.At(column, row, 2) - bare.At(column, row, 2)) > 15; };
  // the border of the picture is the middle of the ridge, where the view's middle is
  for (const int row : { 45, 55, 65, 75 })
  {
    EXPECT_TRUE(differs(77, row)) << row;
    EXPECT_FALSE(differs(83, row)) << row;
  }
  // grey, dark in its northern half
  EXPECT_LT(picture.At(75, 57, 0) + 30, picture.At(75, 63, 0));
  EXPECT_NEAR(picture.At(75, 63, 0), picture.At(75, 63, 1), 25);
}

TEST_F(TerrainRenderAnnotations, PicturesThatCannotBeDraped)
{
  const auto refuse = [this](const std::string& path, const std::string& mention)
  {
    const std::vector<std::string> before = this->ListFiles();
    ExpectRefused(this->Draw(this->Heights, { "--drape", path }), 1, mention);
    EXPECT_EQ(this->ListFiles(), before);
  };
  RasterDescription photo;
  photo.Width = 10;
  photo.Height = 10;
  photo.Bands = 3;
  photo.IsBytes = true;
  photo.Sample = [](int, int) { return 100.0; };
  refuse(this->Path("nowhere.tif"), "nowhere.tif");
  refuse(this->WriteText("text.tif", "This is no picture.\n"), "text.tif");
  refuse(this->WriteRaster("bare.tif", photo), "no coordinate system");
  photo.CoordinateSystem = "EPSG:32633";
  photo.GeoTransform = { 491642.6, 10.0, 0.0, 3097205.3, 0.0, -10.0 };
  refuse(this->WriteRaster("far.tif", photo), "does not meet the terrain");
  photo.CoordinateSystem = "EPSG:4326";
  refuse(this->WriteRaster("odd.tif", photo), "degrees");
}

TEST_F(TerrainRenderAnnotations, IslandOfTheExample)
{
  const std::string folder = TERRAIN_RENDER_ISLAND_DIR;
  const RunResult result = this->Draw(folder + "/heights.tif",
    { "--drape", folder + "/photo.tif", "--track", folder + "/route.gpx", "--track",
      folder + "/huts.geojson", "--graticule", "degrees", "--look-from", "-18.13,64.94,5200",
      "--look-at", "-18.009,64.996", "--sun", "2024-06-21T09:00Z", "--scale-bar",
      "--north-arrow" });
  this->ExpectDrawn(result, 8000);
  EXPECT_EQ(result.Errors, "");
  EXPECT_GT(CountRed(this->ReadPicture()), 40);
}
