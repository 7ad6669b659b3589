// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Exaggeration that is chosen, scenes in files, pictures in pieces.
#include "TerrainRenderFixture.h"

#include "vtk_jsoncpp.h"

#include <gdal.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace
{
class TerrainRenderScenes : public TerrainRenderFixture
{
protected:
  /// Hills 100 m high over 30 km.
  std::string WriteCountry() const
  {
    RasterDescription country;
    country.Width = 101;
    country.Height = 101;
    country.GeoTransform = { 500000.0, 300.0, 0.0, 5000000.0, 0.0, -300.0 };
    country.CoordinateSystem = "EPSG:32632";
    country.Sample = [](int i, int j)
    { return 50.0 * (1.0 + std::sin(0.3 * i) * std::cos(0.2 * j)); };
    return this->WriteRaster("country.tif", country);
  }
  double Statistic(const std::string& key) const
  {
    Json::Value root;
    std::ifstream(this->Path("stats.json")) >> root;
    return root[key].asDouble();
  }
};

/// Pixels any of whose channels differ by more than so much; -1 for pictures of other sizes.
int CountOff(const Picture& a, const Picture& b, int tolerance)
{
  if (a.Values.size() != b.Values.size())
  {
    return -1;
  }
  int off = 0;
  for (std::size_t i = 0; i < a.Values.size(); i += 3)
  {
    bool isOff = false;
    for (std::size_t k = i; k < i + 3; ++k)
    {
      isOff = isOff || std::abs(int{ a.Values[k] } - int{ b.Values[k] }) > tolerance;
    }
    off += isOff ? 1 : 0;
  }
  return off;
}
}

TEST_F(TerrainRenderScenes, ExaggerationIsChosenAndTold)
{
  const std::string country = this->WriteCountry();
  const RunResult chosen =
    this->Draw(country, { "--exaggeration", "auto", "--stats", "stats.json", "--legend" });
  this->ExpectDrawn(chosen, 1000);
  EXPECT_EQ(std::count(chosen.Errors.begin(), chosen.Errors.end(), '\n'), 1) << chosen.Errors;
  EXPECT_NE(chosen.Errors.find("exaggeration 7, for the relief is"), std::string::npos)
    << chosen.Errors;
  EXPECT_EQ(this->Statistic("exaggeration"), 7.0);
  const Picture automatic = this->ReadPicture();
  // the same as the number, whose legend says so as well
  const RunResult given =
    this->Draw(country, { "--exaggeration", "7", "--stats", "stats.json", "--legend" });
  EXPECT_EQ(given.Errors, "");
  EXPECT_EQ(CountOff(automatic, this->ReadPicture(), 0), 0);
}

TEST_F(TerrainRenderScenes, SheetsAndTowersGetAHint)
{
  const std::string country = this->WriteCountry();
  const RunResult flat = this->Draw(country);
  this->ExpectDrawn(flat, 1000);
  EXPECT_NE(flat.Errors.find("hint: "), std::string::npos) << flat.Errors;
  EXPECT_NE(flat.Errors.find("sheet: --exaggeration auto takes 7\n"), std::string::npos)
    << flat.Errors;
  const RunResult steep = this->Draw(country, { "--exaggeration", "900" });
  EXPECT_NE(steep.Errors.find("tower"), std::string::npos) << steep.Errors;
  // whoever chose a place to look from knows better
  const RunResult near =
    this->Draw(country, { "--camera", "515000,4985000,20000,515000,4985001,0" });
  EXPECT_EQ(near.Errors, "");
  ExpectRefused(
    this->Draw(country, { "--exaggeration", "much" }), 2, "neither a finite number nor");
  ExpectRefused(this->Draw(country, { "--exaggeration", "0" }), 2, "not between 0.001 and 1000");
}

TEST_F(TerrainRenderScenes, SceneDrawsTheSamePicture)
{
  this->WriteHill();
  std::filesystem::create_directory(this->Path("scenes"));
  const std::vector<std::string> options = { "hill.tif", "--size", "200x150", "--exaggeration",
    "1.5", "--colors", "oslo", "--reverse", "--contours", "5", "--legend=Height \"above\" 0",
    "--technique", "equidistant", "--sun", "200,30", "--output", "first.png" };
  std::vector<std::string> saving = options;
  saving.insert(saving.end(), { "--save-scene", "scenes/hill.toml" });
  EXPECT_EQ(this->Run(saving).Status, 0);
  EXPECT_EQ(this->ReadText("scenes/hill.toml"),
    "# terrain-render --scene FILE\nheights = \"../hill.tif\"\noutput = \"../first.png\"\n"
    "size = \"200x150\"\ntechnique = \"equidistant\"\nexaggeration = 1.5\ncolors = \"oslo\"\n"
    "reverse = true\nsun = \"200,30\"\ncontours = 5\nlegend = \"Height \\\"above\\\" 0\"\n");
  const Picture first = this->ReadPicture("first.png");
  // from another folder, and with another option beside it
  const RunResult again =
    this->Run({ "--scene", "scenes/hill.toml", "--output", "again.png", "--reverse=false" });
  EXPECT_EQ(again.Errors, "");
  EXPECT_GT(CountOff(first, this->ReadPicture("again.png"), 0), 1000);
  EXPECT_EQ(this->Run({ "--scene", "scenes/hill.toml", "--output", "again.png" }).Status, 0);
  EXPECT_EQ(CountOff(first, this->ReadPicture("again.png"), 0), 0);
  // what is read may be saved again, but not in its own place
  EXPECT_EQ(this->Run({ "--scene", "scenes/hill.toml", "--save-scene", "copy.toml" }).Status, 0);
  EXPECT_NE(this->ReadText("copy.toml").find("heights = \"hill.tif\""), std::string::npos);
  ExpectRefused(this->Run({ "--scene", "copy.toml", "--save-scene", "copy.toml" }), 2,
    "'copy.toml' is a file that the input");
}

TEST_F(TerrainRenderScenes, SceneGivesWayToOptionsBesideIt)
{
  const std::string hill = this->WriteHill();
  this->WriteText("scene.toml",
    "# a view\n\nsize = '64x48' # small\ntrack = [\n  \"a.gpx\",\n  \"b.gpx\",\n]\n"
    "camera = \"30,-60,40,30,20,0\"\nlook-at = \"1,2\"\nlook-from = \"1,2,3\"\n");
  // of camera and places only one can be
  ExpectRefused(this->Run({ hill, "--scene", "scene.toml" }), 2,
    "--camera says where the eye is already (scene.toml, line 10)");
  const RunResult result =
    this->Run({ hill, "--scene", "scene.toml", "--camera", "30,-60,40,30,20,0" });
  ExpectRefused(result, 1, "--track needs to know where it is");
}

TEST_F(TerrainRenderScenes, WrongScenesAreOneSentence)
{
  const std::string hill = this->WriteHill();
  const auto refuse = [&](const std::string& text, const std::string& mention)
  {
    this->WriteText("scene.toml", text);
    const std::vector<std::string> before = this->ListFiles();
    ExpectRefused(this->Run({ hill, "--scene", "scene.toml" }), 2, mention);
    EXPECT_EQ(this->ListFiles(), before);
  };
  refuse("size = \"9x9\"\nshade = true\n", "scene.toml, line 2: 'shade' is no option of a scene");
  refuse("scene = \"scene.toml\"\n", "line 1: 'scene' is no option of a scene");
  refuse("size = \"9x9\n", "line 1: a text does not end");
  refuse("size = 9x9\n", "line 1: '9x9' is no number: texts stand in quotes");
  refuse("\n\nsize \"9x9\"\n", "line 3: it is not of the form key = value");
  refuse("[view]\n", "line 1: a scene has no sections");
  refuse("track = [\"a\"\n", "does not end: ']' is missing");
  refuse("track = [\"a\" \"b\"]\n", "line 1: in a list a comma is missing");
  refuse("track = []\n", "line 1: 'track' has an empty list");
  refuse("size = [\"9x9\", \"8x8\"]\n", "line 1: 'size' takes one value, no list");
  refuse("size = \"9x9\"\nsize = \"8x8\"\n", "line 2: 'size' stands in line 1 already");
  refuse("size = true\n", "line 1: 'size' needs a value");
  refuse("\nsize = \"9by9\"\n", "not of the form WIDTHxHEIGHT (scene.toml, line 2)");
  refuse("size = " + std::string(300000, '1') + "\n", "not of the form WIDTHxHEIGHT");
  refuse("exaggeration = 0\n", "not between 0.001 and 1000 (scene.toml, line 1)");
  refuse("title = \"\\q\"\n", "line 1: after \\ only");
  ExpectRefused(this->Run({ hill, "--scene", "nowhere.toml" }), 2, "'nowhere.toml' is no file");
  ExpectRefused(this->Run({ hill, "--scene", "." }), 2, "'.' is no file of a scene");
}

TEST_F(TerrainRenderScenes, PiecesMakeTheSamePicture)
{
  const std::string folder = TERRAIN_RENDER_ISLAND_DIR;
  const std::vector<std::string> options = { folder + "/heights.tif", "--drape",
    folder + "/photo.tif", "--track", folder + "/route.gpx", "--track", folder + "/huts.geojson",
    "--graticule", "degrees", "--look-from", "-18.13,64.94,5200", "--look-at", "-18.009,64.996",
    "--sun", "2024-06-21T09:00Z", "--scale-bar", "--north-arrow", "--legend", "--contours", "50",
    "--shadows", "--sky-light", "--size", "700x500", "--dpi", "150", "--depth", "depth.tif",
    "--stats", "stats.json" };
  const RunResult whole = this->Run(options);
  EXPECT_EQ(whole.Status, 0) << whole.Errors;
  const Picture one = this->ReadPicture("terrain.png");
  const Depths oneDepths = this->ReadDepths();
  EXPECT_EQ(this->Statistic("pieces"), 1.0);
  std::vector<std::string> inPieces = options;
  inPieces.insert(inPieces.end(), { "--piece", "256" });
  const RunResult tiled = this->Run(inPieces);
  EXPECT_EQ(tiled.Status, 0) << tiled.Errors;
  EXPECT_EQ(this->Statistic("pieces"), 12.0);
  EXPECT_EQ(this->Statistic("width"), 700.0);
  const Picture several = this->ReadPicture("terrain.png");
  ASSERT_EQ(several.Width, 700);
  ASSERT_EQ(several.Height, 500);
  // rounding of rays and colours: none of it lies along a border of pieces
  EXPECT_GE(CountOff(one, several, 3), 0);
  EXPECT_LT(CountOff(one, several, 3), 700 * 500 / 1000);
  EXPECT_LT(CountOff(one, several, 40), 60);
  const Depths depths = this->ReadDepths();
  int off = 0;
  for (std::size_t i = 0; i < depths.Values.size(); ++i)
  {
    const bool isSame = std::isnan(depths.Values[i]) == std::isnan(oneDepths.Values[i]) &&
      !(std::abs(depths.Values[i] - oneDepths.Values[i]) > 1e-3 * oneDepths.Values[i]);
    off += isSame ? 0 : 1;
  }
  EXPECT_LT(off, 30);
}

TEST_F(TerrainRenderScenes, DotsAreToldAndScaleTexts)
{
  const std::string hill = this->WriteHill();
  const auto draw = [&](const std::vector<std::string>& more)
  {
    std::vector<std::string> options = { hill, "--size", "640x480", "--output", "dots.png" };
    options.insert(options.end(), more.begin(), more.end());
    EXPECT_EQ(this->Run(options).Status, 0);
    return this->ReadPicture("dots.png");
  };
  const Picture bare = draw({});
  const int plain = CountOff(bare, draw({ "--legend" }), 0);
  EXPECT_EQ(this->ReadText("dots.png").find("pHYs"), std::string::npos);
  EXPECT_GT(CountOff(bare, draw({ "--legend", "--dpi", "120" }), 0), plain + 500);
  // the header, its length and type: pixels per metre of 120 dots an inch, twice
  const std::string chunk = this->ReadText("dots.png").substr(33, 21);
  EXPECT_EQ(chunk.substr(4, 4), "pHYs");
  EXPECT_EQ(
    static_cast<unsigned char>(chunk[10]) * 256 + static_cast<unsigned char>(chunk[11]), 4724);
  ExpectRefused(this->Run({ hill, "--dpi", "5" }), 2, "--dpi");
  ExpectRefused(this->Run({ hill, "--size", "40000x10" }), 2, "--size");
  ExpectRefused(this->Run({ hill, "--technique", "strips", "--size", "5000x10" }), 2, "--piece");
}
