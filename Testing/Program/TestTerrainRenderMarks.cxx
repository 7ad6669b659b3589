// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Texts in the picture, and what is around the terrain.
#include "TerrainRenderFixture.h"

#include "vtk_jsoncpp.h"

#include <gdal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

namespace
{
using Box = std::array<double, 4>;

/// Three hills 900, 600 and 300 m high along a line from west to east, round 9 E, 45 N, on a plain
/// of 100 m: 121 x 61 samples of 30 m.
RasterDescription Hills()
{
  RasterDescription hills;
  hills.Width = 121;
  hills.Height = 61;
  hills.CoordinateSystem = "EPSG:32632";
  hills.GeoTransform = { 498200.0, 30.0, 0.0, 4983865.0, 0.0, -30.0 };
  hills.Sample = [](int i, int j)
  {
    double height = 100.0;
    for (const auto& [column, top] :
      { std::pair(30, 800.0), std::pair(60, 500.0), std::pair(90, 200.0) })
    {
      const double square = (i - column) * (i - column) + (j - 30) * (j - 30);
      height += top * std::exp(-square / 60.0);
    }
    return height;
  };
  return hills;
}

class TerrainRenderMarks : public TerrainRenderFixture
{
protected:
  void SetUp() override
  {
    TerrainRenderFixture::SetUp();
    this->Heights = this->WriteRaster("hills.tif", Hills());
  }

  Picture DrawPicture(std::vector<std::string> arguments)
  {
    arguments.insert(
      arguments.begin(), { this->Heights, "--size", "480x320", "--output", "picture.png" });
    const RunResult result = this->Run(arguments);
    EXPECT_EQ(result.Status, 0);
    EXPECT_EQ(result.Errors, "");
    return this->ReadPicture();
  }

  /// The labels of a picture that are seen, with left, low, right and high border.
  std::multimap<std::string, Box> Labels(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(), { "--stats", "stats.json" });
    this->DrawPicture(arguments);
    Json::Value root;
    std::ifstream(this->Path("stats.json")) >> root;
    std::multimap<std::string, Box> labels;
    for (const Json::Value& entry : root["labels"])
    {
      const std::string text = entry.asString();
      const std::size_t end = text.rfind(": ");
      std::istringstream numbers(text.substr(end + 2));
      Box box{};
      for (double& number : box)
      {
        numbers >> number;
      }
      labels.emplace(text.substr(0, end), box);
    }
    return labels;
  }

  std::string Heights;
};

int CountUnlike(const Picture& a, const Picture& b)
{
  int unlike = 0;
  for (std::size_t i = 0; i < a.Values.size(); i += 3)
  {
    unlike += std::equal(&a.Values[i], &a.Values[i] + 3, &b.Values[i]) ? 0 : 1;
  }
  return unlike;
}
}

TEST_F(TerrainRenderMarks, PeaksAreTheMostProminent)
{
  // the hills' tops, the others' feet added, which are less than a metre
  const std::multimap<std::string, Box> three = this->Labels({ "--peaks", "9" });
  ASSERT_EQ(three.size(), 3U);
  EXPECT_EQ(three.count("900 m"), 1U);
  EXPECT_EQ(three.count("600 m"), 1U);
  EXPECT_EQ(three.count("300 m"), 1U);
  const std::multimap<std::string, Box> two = this->Labels({ "--peaks", "2" });
  EXPECT_EQ(two.count("300 m"), 0U);
  // from the south the highest one is the western one
  EXPECT_LT(two.find("900 m")->second[2], two.find("600 m")->second[0]);
  // under water, from straight above: the next ones take the places
  const std::vector<std::string> above = { "--peaks", "2", "--water", "650",
    "--look-from=9.0,45.0,9000", "--look-at=9.0,45.0,0" };
  const std::multimap<std::string, Box> dry = this->Labels(above);
  EXPECT_EQ(dry.size(), 1U);
  EXPECT_EQ(dry.count("900 m"), 1U);
  // drawn twice as high, with heights as they are
  EXPECT_EQ(this->Labels({ "--peaks", "2", "--exaggeration", "2" }).count("900 m"), 1U);
}

TEST_F(TerrainRenderMarks, LabelsHideBehindRidgesAndNeverOverlap)
{
  this->WriteText("places.csv",
    "name,lat,lon,height\nWest,45.0,8.9886,\nFoot,45.0,8.981,104\nEast,45.0,9.0115,\n");
  const std::vector<std::string> all = { "--labels", "places.csv" };
  const std::multimap<std::string, Box> fromSouth = this->Labels(all);
  EXPECT_EQ(fromSouth.count("West") + fromSouth.count("Foot 104 m") + fromSouth.count("East"), 3U);
  // from low in the west, the highest hill hides what is behind it
  const std::multimap<std::string, Box> fromWest = this->Labels({ "--labels", "places.csv",
    "--look-from=8.9785,45.0,150agl", "--look-at=8.99,45.0,600", "--view-angle", "60" });
  EXPECT_EQ(fromWest.count("West"), 1U);
  EXPECT_EQ(fromWest.count("East"), 0U);
  // a crowd: those that are placed do not meet, and are inside the picture
  std::ostringstream crowd;
  crowd << "lon;lat;name\n";
  for (int k = 0; k < 60; ++k)
  {
    crowd << 8.985 + 0.0005 * k << ";" << 45.0 + 0.0003 * (k % 7) << ";Place " << k << "\n";
  }
  this->WriteText("crowd.csv", crowd.str());
  const std::multimap<std::string, Box> placed = this->Labels({ "--labels", "crowd.csv", "--peaks",
    "3", "--legend", "--scale-bar", "--north-arrow", "--title", "Hills", "--caption", "A test" });
  EXPECT_GT(placed.size(), 8U);
  EXPECT_LT(placed.size(), 60U);
  EXPECT_EQ(placed.count("Place 0"), 1U) << "the first ones come first";
  for (auto a = placed.begin(); a != placed.end(); ++a)
  {
    EXPECT_GE(a->second[0], 0.0);
    EXPECT_LE(a->second[2], 480.0);
    EXPECT_LE(a->second[3], 320.0);
    for (auto b = std::next(a); b != placed.end(); ++b)
    {
      const bool isApart = a->second[2] < b->second[0] || b->second[2] < a->second[0] ||
        a->second[3] < b->second[1] || b->second[3] < a->second[1];
      EXPECT_TRUE(isApart) << a->first << " and " << b->first;
    }
  }
}

TEST_F(TerrainRenderMarks, TextsAreDrawnWhereTheyAreSaidToBe)
{
  const Picture bare = this->DrawPicture({});
  const std::multimap<std::string, Box> labels = this->Labels({ "--peaks", "1" });
  ASSERT_EQ(labels.size(), 1U);
  const Picture picture = this->ReadPicture();
  const Box box = labels.begin()->second;
  int inside = 0;
  int beside = 0;
  for (int row = 0; row < 320; ++row)
  {
    for (int column = 0; column < 480; ++column)
    {
      const std::size_t at = 3 * (static_cast<std::size_t>(row) * 480 + column);
      const bool isInside = column >= box[0] - 1 && column <= box[2] + 1 &&
        319 - row >= box[1] - 1 && 319 - row <= box[3] + 1;
      const bool differs = !std::equal(&bare.Values[at], &bare.Values[at] + 3, &picture.Values[at]);
      inside += differs && isInside ? 1 : 0;
      beside += differs && !isInside ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 0.8 * (box[2] - box[0]) * (box[3] - box[1]));
  EXPECT_GT(beside, 5) << "the line down to the summit";
  EXPECT_LT(beside, 60);
  // in pieces the same
  std::vector<std::string> crowd = { "--peaks", "3", "--title", "Hills", "--graticule", "utm" };
  const Picture whole = this->DrawPicture(crowd);
  crowd.insert(crowd.end(), { "--piece", "256" });
  const Picture pieces = this->DrawPicture(crowd);
  int off = 0;
  for (std::size_t i = 0; i < whole.Values.size(); ++i)
  {
    off += std::abs(int{ whole.Values[i] } - int{ pieces.Values[i] }) > 20 ? 1 : 0;
  }
  EXPECT_LT(off, 40);
  const Picture titled = this->DrawPicture({ "--title", "Hills" });
  EXPECT_GT(CountUnlike(bare, titled), 200);
}

TEST_F(TerrainRenderMarks, BackgroundsAreThoseAskedFor)
{
  const auto corner = [this](const std::string& background, int row)
  {
    const Picture picture = this->DrawPicture({ "--background", background });
    return std::array<int, 3>{ picture.At(1, row, 0), picture.At(1, row, 1),
      picture.At(1, row, 2) };
  };
  EXPECT_EQ(corner("#204060", 1), (std::array<int, 3>{ 0x20, 0x40, 0x60 }));
  EXPECT_EQ(corner("tomato", 318), (std::array<int, 3>{ 255, 99, 71 }));
  const std::array<int, 3> low = corner("black,#ffffff", 318);
  const std::array<int, 3> high = corner("black,#ffffff", 1);
  EXPECT_LT(low[0], 4);
  EXPECT_GT(high[0], 251);
  // a sky is bluer upwards
  const Picture sky = this->DrawPicture({ "--background", "sky", "--look-from=8.9785,45.0,150agl",
    "--look-at=8.99,45.0,400", "--view-angle", "60" });
  EXPECT_GT(sky.At(2, 100, 0), sky.At(2, 2, 0) + 30);
  EXPECT_GT(sky.At(2, 2, 2), sky.At(2, 2, 0) + 60);
}

TEST_F(TerrainRenderMarks, TransparentPicturesHaveAlpha)
{
  this->DrawPicture({ "--background", "transparent", "--water", "150" });
  GDALDatasetH dataset = GDALOpen(this->Path("picture.png").c_str(), GA_ReadOnly);
  ASSERT_NE(dataset, nullptr);
  ASSERT_EQ(GDALGetRasterCount(dataset), 4);
  std::vector<unsigned char> alpha(480 * 320);
  EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(dataset, 4), GF_Read, 0, 0, 480, 320, alpha.data(), 480,
              320, GDT_Byte, 0, 0),
    CE_None);
  GDALClose(dataset);
  EXPECT_EQ(alpha[0], 0);
  EXPECT_EQ(alpha[160 * 480 + 240], 255) << "terrain under water is opaque";
  // what has no alpha
  const std::vector<std::string> before = this->ListFiles();
  for (const char* name : { "a.jpg", "a.JPEG" })
  {
    ExpectRefused(
      this->Run({ this->Heights, "--background", "transparent", "--output", name }), 2, name);
  }
  const RunResult film = this->Run(
    { this->Heights, "--background", "transparent", "--flight", "orbit", "--output", "a.gif" });
  const RunResult maker = this->RunCommand({ "/bin/sh", "-c", "ffmpeg -version" });
  ExpectRefused(film, 2, maker.Status == 0 ? "alpha" : "films are made by ffmpeg");
  EXPECT_EQ(this->ListFiles(), before);
}

TEST_F(TerrainRenderMarks, WaterCoversWhatIsLower)
{
  const std::vector<std::string> above = { "--look-from=9.0,45.0,9000", "--look-at=9.0,45.0,0",
    "--exaggeration", "2" };
  const Picture dry = this->DrawPicture(above);
  std::vector<std::string> wet = above;
  wet.insert(wet.end(), { "--water", "350" });
  const Picture picture = this->DrawPicture(wet);
  // brute force over the middle row of the hills, seen from straight above
  const RasterDescription hills = Hills();
  int wrong = 0;
  int seen = 0;
  for (int i = 5; i < 116; ++i)
  {
    const double height = hills.Sample(i, 30);
    // 160 pixels are 15 degrees; the eye is drawn twice as high, too
    const double metres = (i - 60) * 30.0;
    const double away = 2.0 * (9000.0 - std::max(height, 350.0));
    const int column = static_cast<int>(
      std::lround(239.5 + 160.0 * metres / (away * std::tan(std::atan(1.0) / 3.0))));
    if (std::abs(height - 350.0) > 60.0)
    {
      ++seen;
      const bool isWet = dry.At(column, 160, 0) != picture.At(column, 160, 0) ||
        dry.At(column, 160, 2) != picture.At(column, 160, 2);
      wrong += isWet != (height < 350.0) ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 80);
  EXPECT_LE(wrong, 2);
  ExpectRefused(this->Run({ this->Heights, "--frame", "local", "--water", "3" }), 1, "--water");
}

TEST_F(TerrainRenderMarks, FogHidesByDistance)
{
  const std::vector<std::string> options = { "--background", "#c8c8d2", "--look-from",
    "8.9785,45.0,250agl", "--look-at", "8.99,45.0", "--depth", "depth.tif" };
  const Picture clear = this->DrawPicture(options);
  std::vector<std::string> more = options;
  more.insert(more.end(), { "--fog", "1000" });
  const Picture fog = this->DrawPicture(more);
  const Depths depths = this->ReadDepths();
  const std::array<double, 3> color = { 0xc8, 0xc8, 0xd2 };
  int surface = 0;
  double worst = 0.0;
  for (int row = 0; row < 320; ++row)
  {
    for (int column = 0; column < 480; ++column)
    {
      if (std::isfinite(depths.At(column, row)))
      {
        ++surface;
        const double left = std::pow(0.5, depths.At(column, row) / 1000.0);
        for (int k = 0; k < 3; ++k)
        {
          const double expected = color[k] + left * (clear.At(column, row, k) - color[k]);
          worst = std::max(worst, std::abs(expected - fog.At(column, row, k)));
        }
      }
    }
  }
  EXPECT_GT(surface, 20000);
  EXPECT_LT(worst, 3.0) << "of 255";
}

TEST_F(TerrainRenderMarks, WrongMarksAreOneSentence)
{
  const auto refuse =
    [&](const std::string& name, const std::string& text, const std::string& mention)
  {
    this->WriteText(name, text);
    const std::vector<std::string> before = this->ListFiles();
    ExpectRefused(this->Run({ this->Heights, "--labels", name }), 1, mention);
    EXPECT_EQ(this->ListFiles(), before);
  };
  refuse("a.csv", "east,north,name\n9,45,A\n", "must name the columns lon, lat and name");
  refuse("a.csv", "lon,lat\n9,45\n", "none of its points has a name");
  refuse("a.csv", "lon,lat,name\n19,45,Far\n", "none of its places lies on the terrain");
  refuse("a.csv", "", "a.csv");
  refuse("a.geojson", "{}", "it cannot be read as points with names");
  refuse("a.geojson", R"({"type":"FeatureCollection","features":[]})", "there are no points in it");
  ExpectRefused(this->Run({ this->Heights, "--labels", "nowhere.csv" }), 1, "nowhere.csv");
  const std::string bare = this->WriteHill();
  this->WriteText("b.csv", "lon,lat,name\n9,45,A\n");
  ExpectRefused(this->Run({ bare, "--labels", "b.csv" }), 1, "--labels needs to know where it is");
  ExpectRefused(this->Run({ this->Heights, "--size", "200x100", "--title",
                  "A title that has no place in so small a picture as this one is" }),
    1, "is wider than the picture has room for");
  ExpectRefused(this->Run({ bare, "--peaks", "0" }), 2, "--peaks");
  ExpectRefused(this->Run({ bare, "--background", "#12345" }), 2, "is neither a colour");
  ExpectRefused(this->Run({ bare, "--background", "red,blue,green" }), 2, "is neither a colour");
  ExpectRefused(this->Run({ bare, "--water", "nan" }), 2, "is not a finite number");
  ExpectRefused(this->Run({ bare, "--fog", "0" }), 2, "--fog");
  ExpectRefused(this->Run({ this->Heights, "--labels", "b.csv", "--output", "b.csv" }), 2, "b.csv");
}

TEST_F(TerrainRenderMarks, BadLinesOfTablesAreTold)
{
  const auto run = [this](const std::string& text)
  {
    this->WriteText("a.csv", text);
    return this->Run({ this->Heights, "--size", "480x320", "--labels", "a.csv" });
  };
  const std::string good = "lon,lat,name\n8.9886,45.0,West\n";
  EXPECT_EQ(run(good).Errors, "");
  const RunResult several =
    run(good + "\n\"9\",abc,Word\n9,nan,NaN\n9,45,\n,45,Empty\n9.0115,45.0,East\n");
  EXPECT_EQ(several.Status, 0);
  const auto tells = [](const RunResult& result, const std::string& text)
  { return result.Errors.find("warning: a.csv, line " + text + "\n") != std::string::npos; };
  EXPECT_TRUE(tells(several, "4: its lat is no number: it is left out, with 3 more"))
    << several.Errors;
  const RunResult one = run(good + "9,45,\n");
  EXPECT_EQ(one.Status, 0);
  EXPECT_TRUE(tells(one, "3: it has no name: it is left out")) << one.Errors;
  ExpectRefused(run("lon,lat,name\nx9,45,A\n"), 1, "a.csv, line 2: its lon is no number");
}

TEST_F(TerrainRenderMarks, TextsThatAreNotUTF8AreOneSentence)
{
  const std::string latin = "Z\xFCrich"; // u with two dots, in ISO 8859-1
  this->WriteText("a.csv", "lon,lat,name\n8.9886,45.0,West\n9.0115,45.0," + latin + "\n");
  ExpectRefused(this->Run({ this->Heights, "--labels", "a.csv" }), 1, "a.csv, line 3: its name");
  for (const char* option : { "--title", "--caption" })
  {
    ExpectRefused(this->Run({ this->Heights, option, latin }), 2, option);
  }
  ExpectRefused(this->Run({ this->Heights, "--legend=" + latin }), 2, "--legend: is not UTF-8");
}

TEST_F(TerrainRenderMarks, NoValueIsRefused)
{
  for (const char* option : { "--labels", "--flight", "--stats", "--depth", "--track", "--drape",
         "--save-scene", "--scene", "--background", "--output" })
  {
    const std::vector<std::string> before = this->ListFiles();
    ExpectRefused(this->Run({ this->Heights, option, "" }), 2, option);
    EXPECT_EQ(this->ListFiles(), before);
  }
}

TEST_F(TerrainRenderMarks, WhatDoesNotFitIsTold)
{
  const std::string lines = "one\ntwo\nthree\nfour\nfive";
  this->DrawPicture({ "--caption", lines, "--title", "one\ntwo" });
  std::string many = lines;
  for (int k = 0; k < 12; ++k)
  {
    many += "\n" + lines;
  }
  const RunResult high = this->Run({ this->Heights, "--size", "480x320", "--caption", many });
  EXPECT_EQ(high.Status, 1);
  EXPECT_NE(high.Errors.find("is higher than the picture has room for"), std::string::npos);
  this->WriteText(
    "long.csv", "lon,lat,name\n8.9886,45.0," + std::string(200, 'a') + "\n9.0,45.0,Middle\n");
  const RunResult wide =
    this->Run({ this->Heights, "--size", "480x320", "--labels", "long.csv", "--peaks", "1" });
  EXPECT_EQ(wide.Status, 0);
  EXPECT_NE(wide.Errors.find("aaa' is wider than the picture: it is left out\n"), std::string::npos)
    << wide.Errors;
}

TEST_F(TerrainRenderMarks, LettersOfOtherScriptsAreDrawnOrTold)
{
  // Cyrillic, Greek, Chinese; nothing may vanish in silence
  const std::map<std::string, std::string> titles = { { "\xD0\x92\xD1\x8B\xD1\x81", "\xD0\x92" },
    { "\xCE\xA9\xCE\xB4\xCE\xB7", "\xCE\xA9" }, { "\xE5\xB1\xB1\xE5\xB3\xB0", "\xE5\xB1\xB1" } };
  const Picture bare = this->DrawPicture({ "--title", "." }); // with room for a title
  for (const auto& [title, letter] : titles)
  {
    const RunResult result = this->Run(
      { this->Heights, "--size", "480x320", "--output", "picture.png", "--title", title });
    EXPECT_EQ(result.Status, 0) << result.Errors;
    const bool isTold = result.Errors.find("no font here has " + letter) != std::string::npos;
    EXPECT_NE(isTold, CountUnlike(bare, this->ReadPicture()) > 60) << title << result.Errors;
  }
  // what VTK's own font has stays in it
  this->DrawPicture({ "--title", "Z\xC3\xBCrich" });
  // no font has a letter of the private use area
  const RunResult none = this->Run({ this->Heights, "--size", "480x320", "--output", "picture.png",
    "--title", "A\xF3\xB0\x80\x80" });
  EXPECT_EQ(none.Status, 0);
  EXPECT_NE(none.Errors.find("no font here has \xF3\xB0\x80\x80"), std::string::npos);
}

TEST_F(TerrainRenderMarks, MarksAreLightOnDark)
{
  // lightest and darkest grey of a part of the picture that is background and marks
  const auto range = [](const Picture& picture, int firstRow, int lastRow, int lastColumn)
  {
    std::array<int, 2> grey = { 255, 0 };
    for (int row = firstRow; row < lastRow; ++row)
    {
      for (int column = 0; column < lastColumn; ++column)
      {
        grey[0] = std::min(grey[0], picture.At(column, row, 1));
        grey[1] = std::max(grey[1], picture.At(column, row, 1));
      }
    }
    return grey;
  };
  const std::vector<std::string> marks = { "--title", "Hills", "--scale-bar", "--north-arrow",
    "--background" };
  const auto draw = [&](const std::string& background)
  {
    std::vector<std::string> arguments = marks;
    arguments.push_back(background);
    return this->DrawPicture(arguments);
  };
  const Picture black = draw("black");
  EXPECT_GT(range(black, 2, 24, 480)[1], 220) << "title";
  EXPECT_GT(range(black, 292, 304, 120)[1], 150) << "text of the scale bar";
  const Picture mixed = draw("navy,white");
  EXPECT_LT(range(mixed, 2, 24, 480)[0], 60) << "title";
  EXPECT_GT(range(mixed, 292, 304, 120)[1], 150) << "text of the scale bar";
  const Picture white = draw("white");
  EXPECT_LT(range(white, 2, 24, 480)[0], 60) << "title";
  EXPECT_LT(range(white, 292, 304, 120)[0], 110) << "text of the scale bar";
}
