// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// terrain-view in a real window on an X server of its own, driven by synthetic events.
#include "TerrainRenderFixture.h"
#include "VirtualDisplay.h"

#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace
{
constexpr int kWidth = 480;
constexpr int kHeight = 320;
constexpr int kMiddleX = kWidth / 2;
constexpr int kMiddleY = kHeight / 2;
/// Pixels that a change of the terrain changes at least; a line of text has less.
constexpr int kMany = kWidth * kHeight / 20;

class TerrainView : public TerrainRenderFixture
{
protected:
  void SetUp() override
  {
    TerrainRenderFixture::SetUp();
    // the user's own state is none of the tests' business
    ASSERT_EQ(setenv("XDG_STATE_HOME", this->Path("state").c_str(), 1), 0);
  }

  /// Opens the viewer with words in a window of the usual size; waits for a title.
  bool Show(std::vector<std::string> words, const std::string& title)
  {
    words.insert(words.begin(), TERRAIN_VIEW_PROGRAM);
    words.insert(
      words.end(), { "--width", std::to_string(kWidth), "--height", std::to_string(kHeight) });
    return this->Screen.Start(words, this->Folder, this->Path("stdout.txt"), title);
  }

  /// Opens the viewer on a hill in UTM zone 45 north; skips the test without Xvfb.
  void Open(bool prepared = false)
  {
    if (!this->Screen.IsThere())
    {
      GTEST_SKIP() << "there is no Xvfb here";
    }
    std::string heights = this->WritePlacedHill();
    if (prepared)
    {
      const std::string file = this->Path("hill.hierarchy");
      ASSERT_EQ(this->RunCommand({ TERRAIN_PREPARE_PROGRAM, heights, file }).Status, 0);
      heights = file;
    }
    ASSERT_TRUE(
      this->Screen.Start({ TERRAIN_VIEW_PROGRAM, heights, "--width", std::to_string(kWidth),
                           "--height", std::to_string(kHeight), "--exaggeration", "2" },
        this->Folder, this->Path("stdout.txt"), "terrain-view"));
    const Screenshot withoutPosition = this->Screen.CaptureStill();
    this->Screen.Move(kMiddleX, kMiddleY);
    this->First = this->Screen.CaptureChange(withoutPosition);
    ASSERT_EQ(this->First.Width, kWidth);
    ASSERT_EQ(this->First.Height, kHeight);
  }

  std::string WritePlacedHill()
  {
    RasterDescription hill;
    hill.Width = 65;
    hill.Height = 49;
    hill.Sample = [](int i, int j)
    { return 300.0 * std::exp(-((i - 32.0) * (i - 32.0) + (j - 24.0) * (j - 24.0)) / 150.0); };
    hill.GeoTransform = { 493000.0, 30.0, 0.0, 3095000.0, 0.0, -30.0 };
    const std::string path = this->WriteRaster("hill.tif", hill);
    GDALDatasetH dataset = GDALOpen(path.c_str(), GA_Update);
    OGRSpatialReferenceH system = OSRNewSpatialReference(nullptr);
    OSRImportFromEPSG(system, 32645);
    GDALSetSpatialRef(dataset, system);
    OSRDestroySpatialReference(system);
    GDALClose(dataset);
    return path;
  }

  /// What the window shows after a key with the pointer in its middle.
  Screenshot After(char key, const Screenshot& before)
  {
    this->Screen.Type(key, kMiddleX, kMiddleY);
    return this->Screen.CaptureChange(before);
  }

  void Quit()
  {
    this->Screen.Type('q', kMiddleX, kMiddleY);
    EXPECT_EQ(this->Screen.WaitForExit(), 0);
  }

  VirtualDisplay Screen;
  Screenshot First;
};
}

#define OPEN_OR_SKIP()                                                                             \
  this->Open();                                                                                    \
  if (this->IsSkipped() || this->HasFatalFailure())                                                \
  {                                                                                                \
    return;                                                                                        \
  }

//------------------------------------------------------------------------------
TEST_F(TerrainView, ShowsTheTerrainAndHelp)
{
  OPEN_OR_SKIP();
  this->First.Write(this->Path("first.png"));
  EXPECT_GT(this->First.CountColors(), 500);
  const Screenshot help = this->After('h', this->First);
  help.Write(this->Path("help.png"));
  EXPECT_GT(help.CountDifferent(this->First), 2000);
  const Screenshot again = this->After('h', help);
  EXPECT_EQ(again.CountDifferent(this->First), 0);
  this->Quit();
}

// A plateau in a rim without data: its walls are new, in front of its edge.
TEST_F(TerrainView, ShowsWallsAlongTheEdgeOfTheData)
{
  if (!this->Screen.IsThere())
  {
    GTEST_SKIP() << "there is no Xvfb here";
  }
  RasterDescription plateau;
  plateau.Width = 41;
  plateau.Height = 41;
  plateau.HasNoData = true;
  plateau.Sample = [](int i, int j)
  { return i < 5 || i > 35 || j < 5 || j > 35 ? -32767.0 : 10.0 + 0.01 * i; };
  const std::string path = this->WriteRaster("plateau.tif", plateau);
  const auto show = [&](const std::string& block)
  {
    EXPECT_TRUE(this->Screen.Start({ TERRAIN_VIEW_PROGRAM, path, "--width", std::to_string(kWidth),
                                     "--height", std::to_string(kHeight), "--block", block },
      this->Folder, this->Path("stdout.txt"), "terrain-view"));
    Screenshot shown = this->Screen.CaptureStill();
    this->Quit();
    return shown;
  };
  const Screenshot thin = show("0.001");
  const Screenshot thick = show("10");
  thick.Write(this->Path("thick.png"));
  EXPECT_GT(thick.CountDifferent(thin), kMany / 2);
}

// Of a prepared file the same picture, and its place on earth; with strips, too.
TEST_F(TerrainView, ShowsPreparedFiles)
{
  OPEN_OR_SKIP();
  const Screenshot raster = this->First;
  const Screenshot rasterStrips = this->After('t', raster);
  this->Quit();
  this->Open(true);
  EXPECT_LT(this->First.CountDifferent(raster), 300);
  const Screenshot strips = this->After('t', this->First);
  strips.Write(this->Path("strips.png"));
  EXPECT_LT(strips.CountDifferent(rasterStrips), 300);
  this->Quit();
}

TEST_F(TerrainView, KeysChangeThePicture)
{
  OPEN_OR_SKIP();
  const Screenshot grey = this->After('c', this->First);
  grey.Write(this->Path("grey.png"));
  EXPECT_GT(grey.CountDifferent(this->First), kMany);
  const Screenshot contours = this->After('i', grey);
  EXPECT_GT(contours.CountDifferent(grey), 500);
  EXPECT_EQ(this->After('i', contours).CountDifferent(grey), 0);
  const Screenshot shaded = this->After('l', grey);
  EXPECT_GT(shaded.CountDifferent(grey), kMany);
  EXPECT_EQ(this->After('l', shaded).CountDifferent(grey), 0);
  const Screenshot wires = this->After('w', grey);
  wires.Write(this->Path("wires.png"));
  EXPECT_GT(wires.CountDifferent(grey), 500);
  const Screenshot taller = this->After('+', wires);
  EXPECT_GT(taller.CountDifferent(wires), kMany / 2);
  const Screenshot crossings = this->After('x', taller);
  crossings.Write(this->Path("crossings.png"));
  EXPECT_GT(crossings.CountDifferent(taller), kMany);
  const Screenshot parallel = this->After('o', crossings);
  EXPECT_GT(parallel.CountDifferent(crossings), kMany / 2);
  const Screenshot mesh = this->After('t', parallel);
  mesh.Write(this->Path("mesh.png"));
  EXPECT_GT(mesh.CountDifferent(parallel), kMany / 10);
  EXPECT_EQ(this->After('T', mesh).CountDifferent(parallel), 0);
  this->Quit();
}

TEST_F(TerrainView, ShowsTheSitesOfAFolder)
{
  OPEN_OR_SKIP();
  this->Quit();
  ASSERT_TRUE(this->Screen.Start(
    { TERRAIN_VIEW_PROGRAM, this->WriteSites(), "--width", std::to_string(kWidth), "--height",
      std::to_string(kHeight), "--exaggeration", "2" },
    this->Folder, this->Path("stdout.txt"), "terrain-view"));
  const Screenshot withoutPosition = this->Screen.CaptureStill();
  this->Screen.Move(kMiddleX, kMiddleY);
  const Screenshot first = this->Screen.CaptureChange(withoutPosition);
  first.Write(this->Path("first.png"));
  const Screenshot second = this->After('n', first);
  second.Write(this->Path("second.png"));
  EXPECT_GT(second.CountDifferent(first), kMany); // of higher heights: other colours
  const Screenshot all = this->After('n', second);
  all.Write(this->Path("all.png"));
  EXPECT_GT(all.CountDifferent(second), kMany); // two specks
  EXPECT_EQ(this->After('n', all).CountDifferent(first), 0);
  this->Quit();
}

TEST_F(TerrainView, TheMouseMovesTheView)
{
  OPEN_OR_SKIP();
  this->Screen.Press(1, kMiddleX, kMiddleY);
  this->Screen.Move(kMiddleX + 10, kMiddleY + 2);
  this->Screen.WaitForChange(this->First); // it asks where the pointer is when it comes to an event
  for (int step = 1; step <= 5; ++step)
  {
    this->Screen.Move(kMiddleX + 20 * step, kMiddleY + 4 * step);
  }
  this->Screen.Release(1, kMiddleX + 100, kMiddleY + 20);
  const Screenshot turned = this->Screen.CaptureChange(this->First);
  turned.Write(this->Path("turned.png"));
  EXPECT_GT(turned.CountDifferent(this->First), kMany);
  for (int click = 0; click < 4; ++click)
  {
    this->Screen.Press(4, kMiddleX, kMiddleY);
    this->Screen.Release(4, kMiddleX, kMiddleY);
  }
  const Screenshot nearer = this->Screen.CaptureChange(turned);
  nearer.Write(this->Path("nearer.png"));
  EXPECT_GT(nearer.CountDifferent(turned), kMany);
  const Screenshot whole = this->After('r', nearer);
  EXPECT_LT(whole.CountDifferent(this->First), kMany / 4); // the text at most
  this->Quit();
}

TEST_F(TerrainView, TellsThePositionUnderThePointer)
{
  OPEN_OR_SKIP();
  this->Screen.Type('p', kMiddleX, kMiddleY);
  // It asks where the pointer is when it comes to the event: before it shows the help.
  const Screenshot help = this->After('h', this->First);
  this->After('h', help);
  this->Screen.Move(2, kHeight - 2); // beside the terrain
  const Screenshot without = this->Screen.CaptureChange(this->First);
  EXPECT_GT(without.CountDifferent(this->First), 500);
  this->Screen.Type('p', 2, kHeight - 2);
  this->Screen.Type('h', 2, kHeight - 2);
  this->Screen.CaptureChange(without);
  this->Quit();
  const std::string words = this->ReadText("stdout.txt");
  EXPECT_NE(words.find("column"), std::string::npos) << words;
  EXPECT_NE(words.find("45n"), std::string::npos) << words;
  EXPECT_NE(words.find("45R"), std::string::npos) << words;
  double height = -1.0;
  const std::size_t place = words.find("height ");
  ASSERT_NE(place, std::string::npos) << words;
  height = std::strtod(words.c_str() + place + 7, nullptr);
  EXPECT_GT(height, 50.0); // the hill is in the middle
  EXPECT_LT(height, 300.0);
  EXPECT_EQ(words.find("column", place), std::string::npos) << words; // nothing beside it
}

/// The number behind a word of a text; NaN without it.
double NumberAfter(const std::string& text, const std::string& word)
{
  const std::size_t place = text.find(word);
  return place == std::string::npos ? std::nan("")
                                    : std::strtod(text.c_str() + place + word.size(), nullptr);
}

// Two points left and right of the middle, and a third: distance, profile, area.
TEST_F(TerrainView, MeasuresOnTheGround)
{
  OPEN_OR_SKIP();
  const auto print = [this](int x, int y)
  {
    this->Screen.Type('p', x, y);
    this->Screen.CaptureStill();
    const std::string all = this->ReadText("stdout.txt");
    return all.substr(all.rfind("column"));
  };
  const std::string left = print(kMiddleX - 60, kMiddleY);
  const std::string right = print(kMiddleX + 60, kMiddleY);
  Screenshot before = this->After('m', this->Screen.CaptureStill());
  const auto click = [&](int x, int y)
  {
    this->Screen.Press(1, x, y);
    this->Screen.Release(1, x, y);
    before = this->Screen.CaptureChange(before);
  };
  click(kMiddleX - 60, kMiddleY);
  click(kMiddleX + 60, kMiddleY);
  before.Write(this->Path("line.png"));
  const double east = NumberAfter(right, "x ") - NumberAfter(left, "x ");
  const double north = NumberAfter(right, "y ") - NumberAfter(left, "y ");
  const std::string line = print(kMiddleX, kMiddleY);
  const double length = NumberAfter(line, "distance ");
  EXPECT_NEAR(length, std::hypot(east, north) / 0.9996, 1.0) << line; // the scale of UTM
  EXPECT_GT(NumberAfter(line, "over the ground "), length + 1.0) << line;
  EXPECT_NEAR(NumberAfter(line, " to "), NumberAfter(line, "height "), 2.0) << line; // the hill
  click(kMiddleX, kMiddleY + 40);
  click(kMiddleX - 60, kMiddleY); // the first point: an area
  before.Write(this->Path("area.png"));
  const std::string below = print(kMiddleX, kMiddleY + 40);
  const double area = 0.5 *
    std::abs(east * (NumberAfter(below, "y ") - NumberAfter(left, "y ")) -
      north * (NumberAfter(below, "x ") - NumberAfter(left, "x ")));
  EXPECT_NEAR(NumberAfter(below, "area ") / area, 1.0, 0.01) << below;
  const Screenshot without = this->After('m', before);
  EXPECT_GT(without.CountDifferent(before), 2000);
  this->Quit();
}

TEST_F(TerrainView, CopiesThePlaceUnderThePointer)
{
  OPEN_OR_SKIP();
  this->Screen.Type('y', kMiddleX, kMiddleY);
  this->Screen.CaptureChange(this->First);
  const std::string text = this->Screen.ReadClipboard();
  EXPECT_NE(text.find("45R"), std::string::npos) << text;
  EXPECT_GT(NumberAfter(text, "height "), 50.0) << text;
  this->Quit();
}

// A scene of the window is the same picture in another window, and one of terrain-render.
TEST_F(TerrainView, SavesScenesThatAreDrawnAgain)
{
  OPEN_OR_SKIP();
  Screenshot now = this->After('i', this->First);
  now = this->After('+', now);
  this->Screen.Press(4, kMiddleX, kMiddleY);
  this->Screen.Release(4, kMiddleX, kMiddleY);
  now = this->Screen.CaptureChange(now);
  now.Write(this->Path("now.png"));
  this->After('S', now);
  this->Quit();
  const std::string scene = this->ReadText("terrain-view.toml");
  EXPECT_NE(scene.find("heights = \"hill.tif\""), std::string::npos) << scene;
  EXPECT_NE(scene.find("exaggeration = 2.5"), std::string::npos) << scene;
  EXPECT_NE(scene.find("look-from"), std::string::npos) << scene;
  EXPECT_NE(scene.find("contours"), std::string::npos) << scene;
  EXPECT_EQ(scene.find("width"), std::string::npos) << scene;
  this->WriteText("more.toml", scene + "title = \"Hill\"\n");
  ASSERT_TRUE(
    this->Screen.Start({ TERRAIN_VIEW_PROGRAM, "--scene", "more.toml", "--save-scene", "named.toml",
                         "--width", std::to_string(kWidth), "--height", std::to_string(kHeight) },
      this->Folder, this->Path("stdout.txt"), "terrain-view"));
  const Screenshot withoutPosition = this->Screen.CaptureStill();
  this->Screen.Move(kMiddleX, kMiddleY);
  const Screenshot again = this->Screen.CaptureChange(withoutPosition);
  again.Write(this->Path("again.png"));
  EXPECT_LT(again.CountDifferent(now), kMany / 4); // the texts at most
  this->After('S', again);                         // the first one is kept
  this->Quit();
  EXPECT_EQ(this->ReadText("terrain-view.toml"), scene);
  EXPECT_NE(this->ReadText("named.toml").find("title = \"Hill\""), std::string::npos);
  const RunResult drawn = this->RunCommand({ TERRAIN_RENDER_PROGRAM, "--scene", "more.toml",
    "--size", "480x320", "--output", "drawn.png" });
  EXPECT_EQ(drawn.Status, 0) << drawn.Errors;
}

TEST_F(TerrainView, ShowsWhatIsDropped)
{
  OPEN_OR_SKIP();
  const Screenshot before = this->First;
  ASSERT_TRUE(this->Screen.Drop(this->Path("none.tif")));
  const Screenshot told = this->Screen.CaptureChange(before);
  EXPECT_LT(told.CountDifferent(before), kMany);
  const std::string other = this->WriteHill("other.tif");
  ASSERT_TRUE(this->Screen.Drop(other));
  ASSERT_TRUE(this->Screen.Find("other.tif"));
  this->Screen.CaptureStill().Write(this->Path("other.png"));
  this->Quit();
}

// A path is typed where there is no program for a dialog.
TEST_F(TerrainView, OpensATypedPath)
{
  const std::string path = std::getenv("PATH");
  setenv("PATH", this->Folder.c_str(), 1);
  OPEN_OR_SKIP();
  const std::string other = this->WriteHill("other.tif");
  Screenshot now = this->After('O', this->First);
  for (const char letter : { 'o', 't', 'x' })
  {
    now = this->After(letter, now);
  }
  now = this->After('\b', now);
  now = this->After('\t', now); // the rest of the name
  now.Write(this->Path("typed.png"));
  this->Screen.Type('\r', kMiddleX, kMiddleY);
  EXPECT_TRUE(this->Screen.Find("other.tif"));
  const Screenshot shown = this->Screen.CaptureStill();
  // q is a letter while a path is typed, and quits after it was given up
  const Screenshot typing = this->After('O', shown);
  const Screenshot letter = this->After('q', typing);
  EXPECT_LT(letter.CountDifferent(typing), kMany);
  this->After('\x1b', letter);
  this->Quit();
  setenv("PATH", path.c_str(), 1);
}

// A program that stands for the desktop's dialog chooses a file.
TEST_F(TerrainView, OpensWhatADialogChooses)
{
  const std::string other = this->WriteHill("other.tif");
  const std::string program = this->WriteText("zenity", "#!/bin/sh\necho '" + other + "'\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH");
  setenv("PATH", (this->Folder + ":" + path).c_str(), 1);
  OPEN_OR_SKIP();
  this->Screen.Type('O', kMiddleX, kMiddleY);
  EXPECT_TRUE(this->Screen.Find("other.tif"));
  this->Screen.CaptureStill();
  this->Quit();
  setenv("PATH", path.c_str(), 1);
}

TEST_F(TerrainView, RemembersWhatItShowedLast)
{
  OPEN_OR_SKIP();
  const Screenshot taller = this->After('+', this->First);
  const Screenshot lines = this->After('i', taller);
  this->Quit();
  ASSERT_TRUE(this->Show({}, "hill.tif"));
  const Screenshot withoutPosition = this->Screen.CaptureStill();
  this->Screen.Move(kMiddleX, kMiddleY);
  const Screenshot again = this->Screen.CaptureChange(withoutPosition);
  again.Write(this->Path("again.png"));
  EXPECT_LT(again.CountDifferent(lines), kMany / 4); // the texts at most
  this->Quit();
}

// Views that keys record become a table that terrain-render flies, and are played.
TEST_F(TerrainView, RecordsFlights)
{
  OPEN_OR_SKIP();
  Screenshot now = this->After('f', this->First); // a flight of no views is none
  EXPECT_LT(now.CountDifferent(this->First), kMany);
  now = this->After('k', now);
  const auto nearer = [&]
  {
    this->Screen.Press(4, kMiddleX, kMiddleY);
    this->Screen.Release(4, kMiddleX, kMiddleY);
    now = this->Screen.CaptureChange(now);
    now = this->After('k', now);
  };
  nearer();
  nearer();
  now = this->After('K', now);
  now = this->After('F', now);
  this->Screen.Type('f', kMiddleX, kMiddleY);
  const Screenshot flown = this->Screen.CaptureChange(now);
  flown.Write(this->Path("flown.png"));
  this->Quit();
  const std::string table = this->ReadText("terrain-view-flight.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3) << table;
  EXPECT_NE(table.find("seconds,lon,lat,height,look_lon,look_lat,look_height"), std::string::npos);
  EXPECT_NE(table.find("\n4,"), std::string::npos) << table;
  const RunResult drawn =
    this->RunCommand({ TERRAIN_RENDER_PROGRAM, "hill.tif", "--exaggeration", "2", "--flight",
      "terrain-view-flight.csv", "--fps", "1", "--size", "96x64", "--output", "frames" });
  EXPECT_EQ(drawn.Status, 0) << drawn.Errors;
  EXPECT_TRUE(std::filesystem::exists(this->Path("frames/frame-00004.png")));
}

// Who drops a file goes on moving the mouse: over a window that is about to go.
TEST_F(TerrainView, GoesOnWhileThePointerMovesOverWhatIsDropped)
{
  OPEN_OR_SKIP();
  const std::string files[2] = { this->WriteHill("one.tif"), this->WriteHill("other.tif") };
  for (int drop = 0; drop < 6; ++drop)
  {
    ASSERT_TRUE(this->Screen.Drop(files[drop % 2]));
    for (int move = 0; move < 400; ++move)
    {
      this->Screen.Move(kMiddleX + move % 40, kMiddleY + move % 30);
    }
    ASSERT_TRUE(this->Screen.Find(drop % 2 == 0 ? "one.tif" : "other.tif")) << drop;
  }
  this->Quit();
}

TEST_F(TerrainView, RefusesWhatItCannotShow)
{
  const std::string hill = this->WriteHill();
  const auto run = [this](const std::vector<std::string>& arguments)
  {
    std::vector<std::string> command{ TERRAIN_VIEW_PROGRAM };
    command.insert(command.end(), arguments.begin(), arguments.end());
    return this->RunCommand(command);
  };
  ASSERT_EQ(unsetenv("DISPLAY"), 0);
  ExpectRefused(run({ hill }), 1, "DISPLAY");
  ExpectRefused(run({ "--exaggeration", "-1" }), 2, "--exaggeration");
  ExpectRefused(run({ "--nonsense" }), 2, "--nonsense");
  ExpectRefused(run({ "" }), 2, "HEIGHTS");
  ExpectRefused(run({ "--colors=", hill }), 2, "--colors");
  ExpectRefused(run({ hill, "--hillshade", "--shadows" }), 2, "--hillshade");
  for (const char* option : { "--exaggeration", "--sun-angle", "--contours", "--block" })
  {
    ExpectRefused(run({ option, "nan" }), 2, option);
  }
  ExpectRefused(run({ hill, "--look-from", "9,45,100" }), 2, "need each other");
  ExpectRefused(run({ hill, "--camera", "1,2,3" }), 2, "--camera");
  this->WriteText("bad.toml", "heights = \"hill.tif\"\nexaggeration = \"high\"\n");
  ExpectRefused(run({ "--scene", "bad.toml" }), 2, "bad.toml, line 2");
  EXPECT_EQ(run({ "--help" }).Status, 0);
  setenv("DISPLAY", ":no-display", 1);
  ExpectRefused(run({ hill }), 1, ":no-display");
  if (this->Screen.IsThere())
  {
    setenv("DISPLAY", this->Screen.GetName().c_str(), 1);
    ExpectRefused(run({ this->Path("none.tif") }), 1, "none.tif");
  }
}
