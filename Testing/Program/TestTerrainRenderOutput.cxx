// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What terrain-render writes, and that it writes everything or nothing.
#include "TerrainRenderFixture.h"

#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace
{
class TerrainRenderOutput : public TerrainRenderFixture
{
};

/// A plain at height 3 of 41 x 41 samples of 1 m whose northern half has no data.
RasterDescription HalfPlain()
{
  RasterDescription plain;
  plain.Width = 41;
  plain.Height = 41;
  plain.HasNoData = true;
  plain.Sample = [](int, int j) { return j < 20 ? -32767.0 : 3.0; };
  return plain;
}

/// Part of the pixels whose colours differ by more than a few steps.
double DifferentPart(const Picture& first, const Picture& second)
{
  constexpr int kSteps = 6;
  int different = 0;
  for (std::size_t k = 0; k < first.Values.size(); k += 3)
  {
    int most = 0;
    for (std::size_t c = k; c < k + 3; ++c)
    {
      most = std::max(most, std::abs(int{ first.Values[c] } - int{ second.Values[c] }));
    }
    different += most > kSteps ? 1 : 0;
  }
  return different / (static_cast<double>(first.Values.size()) / 3.0);
}

/// Part of the pixels with a surface in the first whose depth in the second differs by more than a
/// hundredth, or that have none there.
double DisagreeingPart(const Depths& first, const Depths& second)
{
  constexpr double kTolerance = 0.01;
  int different = 0;
  for (std::size_t k = 0; k < first.Values.size(); ++k)
  {
    if (std::isfinite(first.Values[k]))
    {
      const double difference = std::abs(first.Values[k] - second.Values[k]);
      different += difference <= kTolerance * first.Values[k] ? 0 : 1;
    }
  }
  return static_cast<double>(different) / first.CountHits();
}
}

TEST_F(TerrainRenderOutput, DefaultsNeedNoArguments)
{
  const RunResult result = this->Run({ "--size", "320x180" });
  ASSERT_EQ(result.Status, 0) << result.Errors;
  EXPECT_EQ(this->ListFiles(), std::vector<std::string>{ "terrain.png" });
  EXPECT_EQ(this->ReadPictureSize("terrain.png"), (std::vector<int>{ 320, 180 }));
}

TEST_F(TerrainRenderOutput, PictureHasTheSizeAskedFor)
{
  const std::string hill = this->WriteHill();
  for (const char* size : { "1x1", "7x300", "333x17" })
  {
    const RunResult result = this->Run({ hill, "--size", size, "--output", "sized.png" });
    ASSERT_EQ(result.Status, 0) << size << result.Errors;
    const std::vector<int> read = this->ReadPictureSize("sized.png");
    EXPECT_EQ(std::to_string(read[0]) + "x" + std::to_string(read[1]), size);
  }
}

TEST_F(TerrainRenderOutput, PicturesAreWhatTheirNamesSay)
{
  const std::string hill = this->WriteHill();
  ASSERT_EQ(this->Run({ hill, "--size", "160x120", "--output", "a.png" }).Status, 0);
  for (const char* name : { "a.jpg", "a.JPEG" })
  {
    const RunResult result = this->Run({ hill, "--size", "160x120", "--output", name });
    ASSERT_EQ(result.Status, 0) << result.Errors;
    EXPECT_EQ(this->ReadText(name).substr(0, 3), "\xFF\xD8\xFF");
    // nearly the same colours
    const Picture exact = this->ReadPicture("a.png");
    const Picture picture = this->ReadPicture(name);
    ASSERT_EQ(picture.Values.size(), exact.Values.size());
    double sum = 0.0;
    for (std::size_t k = 0; k < exact.Values.size(); ++k)
    {
      sum += std::abs(int{ exact.Values[k] } - int{ picture.Values[k] });
    }
    EXPECT_LT(sum / static_cast<double>(exact.Values.size()), 3.0);
  }
}

TEST_F(TerrainRenderOutput, DepthsLieAlongTheViewingDirection)
{
  // straight down from 400 above the plain: the same depth everywhere, not longer off the middle
  const RunResult result = this->Draw(this->WriteRaster("plain.tif", HalfPlain()),
    { "--camera", "20,-20,403,20,-20,3", //
      "--view-angle", "5" });
  this->ExpectDrawn(result, 5000);
  const Depths depths = this->ReadDepths();
  EXPECT_EQ(depths.Width, 160);
  EXPECT_EQ(depths.Height, 120);
  EXPECT_TRUE(depths.IsFloat32);
  EXPECT_TRUE(depths.NoDataIsNaN);
  for (const float depth : depths.Values)
  {
    if (std::isfinite(depth))
    {
      ASSERT_NEAR(depth, 400.0, 400.0 * 2e-6);
    }
  }
  // row 0 is on top, and north is: there is nothing
  EXPECT_TRUE(std::isnan(depths.At(80, 20)));
  EXPECT_TRUE(std::isfinite(depths.At(80, 100)));
}

// The walls along the edge of the data are those that a raster without a rim has at its borders.
TEST_F(TerrainRenderOutput, BlocksHaveWallsAlongTheEdgeOfTheData)
{
  const auto hills = [](int i, int j)
  { return 10.0 + 3.0 * std::sin(0.4 * i) * std::cos(0.3 * j); };
  RasterDescription whole;
  whole.Width = 31;
  whole.Height = 25;
  whole.GeoTransform = { 5.0, 1.0, 0.0, -8.0, 0.0, -1.0 };
  whole.Sample = hills;
  RasterDescription rimmed;
  rimmed.Width = 41;
  rimmed.Height = 41;
  rimmed.HasNoData = true;
  rimmed.Sample = [&hills](int i, int j)
  { return i < 5 || i > 35 || j < 8 || j > 32 ? -32767.0 : hills(i - 5, j - 8); };
  for (const char* camera : { "60,-70,30,20,-20,5", "-15,25,12,20,-20,5" })
  {
    const std::vector<std::string> options{ "--block", "8", "--camera", camera, "--exaggeration",
      "1.5" };
    this->ExpectDrawn(this->Draw(this->WriteRaster("whole.tif", whole), options), 4000);
    const Depths expected = this->ReadDepths();
    const Picture picture = this->ReadPicture();
    const RunResult result = this->Draw(this->WriteRaster("rimmed.tif", rimmed), options);
    this->ExpectDrawn(result, 4000);
    EXPECT_EQ(result.Errors, "");
    EXPECT_LT(DisagreeingPart(expected, this->ReadDepths()), 0.01) << camera;
    EXPECT_LT(DisagreeingPart(this->ReadDepths(), expected), 0.01) << camera;
    EXPECT_LT(DifferentPart(picture, this->ReadPicture()), 0.02) << camera;
  }
  ExpectDrawn(this->Draw(this->WriteRaster("rimmed.tif", rimmed), { "--block", "8" }), 4000);
  const RunResult detailed =
    this->Draw(this->WriteRaster("rimmed.tif", rimmed), { "--block", "8", "--detail", "builtin" });
  EXPECT_EQ(detailed.Status, 0);
  EXPECT_NE(detailed.Errors.find("leave out --detail"), std::string::npos) << detailed.Errors;
}

// The rim of a plateau goes from the south to the east in steps, whose eastern sides have next to
// no light: they are lit as the plane through all of them.
TEST_F(TerrainRenderOutput, WallsOfStepsHaveNoStripes)
{
  RasterDescription plateau;
  plateau.Width = 81;
  plateau.Height = 81;
  plateau.HasNoData = true;
  plateau.Sample = [](int i, int j) { return i + j > 80 ? -32767.0 : 10.0; };
  this->ExpectDrawn(
    this->Draw(this->WriteRaster("plateau.tif", plateau),
      { "--block", "20", "--camera", "45,-140,10,40.5,-40.5,-5", "--colors", "grey" }),
    1000);
  const Picture picture = this->ReadPicture();
  int darkest = 255;
  for (int column = picture.Width / 3; column < 2 * picture.Width / 3; ++column)
  {
    darkest = std::min(darkest, picture.At(column, 6 * picture.Height / 10, 1));
  }
  EXPECT_GT(darkest, 12);
}

TEST_F(TerrainRenderOutput, BlocksHaveNoContoursOnTheirWalls)
{
  RasterDescription plateau; // no line crosses its top
  plateau.Width = 31;
  plateau.Height = 31;
  plateau.Sample = [](int, int) { return 10.5; };
  const std::string path = this->WriteRaster("plateau.tif", plateau);
  const std::vector<std::string> options{ "--block", "10", "--camera", "40,-60,15,15,-15,5" };
  this->ExpectDrawn(this->Draw(path, options), 4000);
  const Picture bare = this->ReadPicture();
  std::vector<std::string> lines = options;
  lines.insert(lines.end(), { "--contours", "1" });
  this->ExpectDrawn(this->Draw(path, lines), 4000);
  EXPECT_EQ(DifferentPart(bare, this->ReadPicture()), 0.0);
}

TEST_F(TerrainRenderOutput, ExaggerationMovesTheSurface)
{
  const RunResult result = this->Draw(this->WriteRaster("plain.tif", HalfPlain()),
    { "--camera", "20,-20,400,20,-20,0", "--view-angle", "5", "--exaggeration", "10" });
  this->ExpectDrawn(result, 5000);
  EXPECT_NEAR(this->ReadDepths().At(80, 100), 370.0, 0.001);
}

TEST_F(TerrainRenderOutput, NothingNearTheEyeIsLost)
{
  RasterDescription plain;
  plain.Width = 1001;
  plain.Height = 1001;
  // the diagonal is 1414: what is 0.15 away has to be there
  const RunResult result =
    this->Draw(this->WriteRaster("plain.tif", plain), { "--camera", "500,-500,0.15,500,-500,0" });
  this->ExpectDrawn(result, 160 * 120);
  EXPECT_NEAR(this->ReadDepths().At(80, 60), 0.15, 1e-4);
}

TEST_F(TerrainRenderOutput, StripsKeepATolerance)
{
  const std::string hill = this->WriteHill();
  const auto triangles = [&](const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments{ "--technique", "strips", "--stats", "stats.json" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    this->ExpectDrawn(this->Draw(hill, arguments), 1000);
    const std::string text = this->ReadText("stats.json");
    const std::string key = "\"mesh_triangles\"";
    const std::size_t place = text.find(key);
    return place == std::string::npos ? -1 : std::stoi(text.substr(text.find(':', place) + 1));
  };
  const int standard = triangles({});
  EXPECT_EQ(triangles({ "--tolerance", "1" }), standard);
  EXPECT_LT(triangles({ "--tolerance", "4" }), standard);
  EXPECT_GT(triangles({ "--tolerance", "0.2" }), standard);
  EXPECT_EQ(triangles({ "--depths" }), standard);
  const RunResult old = this->Draw(hill, { "--technique", "strips", "--levels" });
  this->ExpectDrawn(old, 1000);
  EXPECT_NE(old.Errors.find("--levels is now called --depths"), std::string::npos) << old.Errors;
  const int hits = this->ReadDepths().CountHits();
  EXPECT_EQ(triangles({ "--wireframe" }), standard);
  EXPECT_LT(this->ReadDepths().CountHits(), hits);
}

TEST_F(TerrainRenderOutput, TechniquesAgree)
{
  const std::string hill = this->WriteHill();
  this->ExpectDrawn(this->Draw(hill, { "--technique", "mesh" }), 5000);
  const Depths reference = this->ReadDepths();
  for (const char* technique : { "equidistant", "pyramid", "strips" })
  {
    this->ExpectDrawn(this->Draw(hill, { "--technique", technique }), 5000);
    EXPECT_LT(DisagreeingPart(reference, this->ReadDepths()), 0.01) << technique;
  }
  for (const char* technique : { "linear", "exponential" })
  {
    this->ExpectDrawn(this->Draw(hill, { "--technique", technique, "--steps", "200" }), 4000);
    EXPECT_LT(DisagreeingPart(reference, this->ReadDepths()), 0.2) << technique;
  }
}

TEST_F(TerrainRenderOutput, SearchesSayWhatTheyMiss)
{
  const std::string hill = this->WriteHill();
  this->ExpectDrawn(this->Draw(hill, { "--technique", "pyramid" }), 5000);
  const Depths exact = this->ReadDepths();
  const std::vector<std::vector<std::string>> searches = { { "--technique", "linear" },
    { "--technique", "exponential" }, { "--technique", "linear", "--steps", "1" },
    { "--technique", "equidistant", "--steps", "1", "--step-length", "1e6" },
    { "--technique", "equidistant", "--steps", "2", "--long-steps", "1", "--step-length", "3",
      "--secant-steps", "1" } };
  int sum = 0;
  for (std::vector<std::string> search : searches)
  {
    search.insert(search.end(), { "--stats", "stats.json" });
    const RunResult result = this->Draw(hill, search);
    ASSERT_EQ(result.Status, 0) << result.Errors;
    const Depths found = this->ReadDepths();
    int missed = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < exact.Values.size(); ++i)
    {
      const bool same = std::isnan(found.Values[i]) == std::isnan(exact.Values[i]);
      missed += same ? 0 : 1;
      wrong +=
        same && std::abs(found.Values[i] - exact.Values[i]) > 1e-3f * exact.Values[i] ? 1 : 0;
    }
    sum += missed + wrong;
    const std::string sentence = "of " + std::to_string(exact.CountHits()) +
      " pixels of the surface the technique " + search[1] + " misses " + std::to_string(missed) +
      " and has " + std::to_string(wrong) + " at a wrong depth";
    EXPECT_NE(result.Errors.find(sentence), std::string::npos) << sentence << result.Errors;
    EXPECT_NE(this->ReadText("stats.json").find("\"missed_pixels\""), std::string::npos);
  }
  EXPECT_GT(sum, 0);
  const RunResult equidistant = this->Draw(hill, { "--technique", "equidistant" });
  EXPECT_EQ(equidistant.Errors, "");
}

// The same from a prepared file, whatever its name is: read as an image, or refined as it is.
TEST_F(TerrainRenderOutput, PreparedFilesAreDrawn)
{
  const std::string hill = this->WriteHill();
  const std::string prepared = this->Path("prepared.dat");
  ASSERT_EQ(this->RunCommand({ TERRAIN_PREPARE_PROGRAM, hill, prepared }).Status, 0);
  this->ExpectDrawn(this->Draw(hill, { "--technique", "mesh" }), 5000);
  const Depths reference = this->ReadDepths();
  for (const char* technique : { "mesh", "linear", "pyramid", "strips" })
  {
    this->ExpectDrawn(this->Draw(prepared, { "--technique", technique }), 5000);
    EXPECT_LT(DisagreeingPart(reference, this->ReadDepths()), 0.01) << technique;
  }
  // alone, and with the samples that detail needs
  this->ExpectDrawn(
    this->Draw(prepared, { "--technique", "strips", "--depths", "--scale-bar" }), 5000);
  this->ExpectDrawn(this->Draw(prepared, { "--technique", "strips", "--detail", "builtin" }), 5000);
  std::filesystem::resize_file(prepared, 5000);
  ExpectRefused(this->Draw(prepared), 1, "5000 bytes");
  ExpectRefused(this->Draw(prepared, { "--technique", "strips" }), 1, "5000 bytes");
}

TEST_F(TerrainRenderOutput, WindowsDrawTheSame)
{
  const std::string hill = this->WriteHill();
  this->ExpectDrawn(this->Draw(hill, { "--window", "egl", "--stats", "egl.json" }), 5000);
  const std::string picture = this->ReadText("picture.png");
  EXPECT_NE(this->ReadText("egl.json").find("EGL"), std::string::npos);
  const RunResult osmesa = this->Draw(hill, { "--window", "osmesa", "--stats", "osmesa.json" });
  if (osmesa.Errors.find("libOSMesa is not installed") != std::string::npos)
  {
    this->ExpectRefused(osmesa, 1, "no OSMesa window can be had");
    GTEST_SKIP() << osmesa.Errors;
  }
  this->ExpectDrawn(osmesa, 5000);
  EXPECT_NE(this->ReadText("osmesa.json").find("OS"), std::string::npos);
  if (this->ReadText("egl.json").find("llvmpipe") != std::string::npos)
  {
    EXPECT_EQ(this->ReadText("picture.png"), picture);
  }
}

// Detail changes the distances by no more than its height, and hardly any pixel is without.
TEST_F(TerrainRenderOutput, DetailIsAdded)
{
  const std::string hill = this->WriteHill();
  this->ExpectDrawn(this->Draw(hill), 5000);
  const Depths bare = this->ReadDepths();
  for (const std::string& detail : { std::string("builtin"), hill })
  {
    this->ExpectDrawn(this->Draw(hill,
                        { "--detail", detail, "--detail-cells", "8", "--detail-height", "0.5",
                          "--stats", "stats.json" }),
      5000);
    EXPECT_NE(
      this->ReadText("stats.json").find("\"effective_samples\" : 197505"), std::string::npos)
      << this->ReadText("stats.json");
    const Depths detailed = this->ReadDepths();
    int changed = 0;
    for (std::size_t k = 0; k < bare.Values.size(); ++k)
    {
      changed += std::abs(detailed.Values[k] - bare.Values[k]) > 1e-3f;
    }
    EXPECT_GT(changed, 3000);
  }
  RunResult result = this->Draw(hill, { "--detail", "missing.tif" });
  ExpectRefused(result, 1, "missing.tif");
}

TEST_F(TerrainRenderOutput, StatisticsHaveCountsAndTimes)
{
  const std::string hill = this->WriteHill();
  this->ExpectDrawn(this->Draw(hill, { "--frames", "3", "--stats", "stats.json" }));
  Json::Value stats;
  std::istringstream text(this->ReadText("stats.json"));
  ASSERT_TRUE(Json::parseFromStream(Json::CharReaderBuilder(), text, &stats, nullptr));
  EXPECT_EQ(stats["frames"].asInt(), 3);
  EXPECT_EQ(stats["width"].asInt(), 160);
  EXPECT_EQ(stats["height"].asInt(), 120);
  EXPECT_EQ(stats["columns"].asInt(), 65);
  EXPECT_EQ(stats["rows"].asInt(), 49);
  EXPECT_EQ(stats["samples"].asInt(), 65 * 49);
  EXPECT_EQ(stats["technique"].asString(), "pyramid");
  EXPECT_FALSE(stats.isMember("mesh_triangles")); // the pyramid needs no mesh
  EXPECT_GE(stats["texture_bytes"].asInt(), 65 * 49 * 2);
  EXPECT_GT(stats["peak_memory_bytes"].asInt64(), 1000000);
  for (const char* stage : { "read", "prepare", "first_frame", "frame_cpu", "frame_gpu", "total" })
  {
    ASSERT_TRUE(stats.isMember(stage)) << stage;
    EXPECT_GE(stats[stage]["min"].asDouble(), 0.0) << stage;
    EXPECT_GE(stats[stage]["median"].asDouble(), stats[stage]["min"].asDouble()) << stage;
    EXPECT_GE(stats[stage]["max"].asDouble(), stats[stage]["median"].asDouble()) << stage;
  }
}

TEST_F(TerrainRenderOutput, CrossingsAreCountedAndDrawn)
{
  const std::string hill = this->WriteHill();
  this->ExpectDrawn(this->Draw(hill, { "--stats", "exact.json" }));
  const std::string picture = this->ReadText("picture.png");
  this->ExpectDrawn(
    this->Draw(hill, { "--pixel-tolerance", "30", "--stats", "off.json", "--crossings" }));
  EXPECT_NE(this->ReadText("picture.png"), picture);
  std::int64_t work[2] = { 0, 0 };
  for (int k = 0; k < 2; ++k)
  {
    Json::Value stats;
    std::istringstream text(this->ReadText(k == 0 ? "exact.json" : "off.json"));
    ASSERT_TRUE(Json::parseFromStream(Json::CharReaderBuilder(), text, &stats, nullptr));
    std::int64_t rays = 0;
    for (Json::ArrayIndex n = 0; n < stats["crossings"].size(); ++n)
    {
      rays += stats["crossings"][n].asInt64();
      work[k] += n * stats["crossings"][n].asInt64();
    }
    EXPECT_EQ(rays, 160 * 120);
  }
  EXPECT_GT(work[0], 160 * 120);
  EXPECT_LT(work[1], work[0]); // large nodes end the search
}

TEST_F(TerrainRenderOutput, ProgressIsShownToTerminalsOnly)
{
  const std::string hill = this->WriteHill();
  const RunResult quiet = this->Draw(hill);
  EXPECT_EQ(quiet.Errors, "");
  const std::string terminal = "/usr/bin/script";
  const std::string typescript = this->Path("typescript");
  if (this->RunCommand({ terminal, "-qec", "true", typescript }).Status != 0)
  {
    GTEST_SKIP() << "there is no terminal to be had";
  }
  const RunResult shown =
    this->RunCommand({ terminal, "-qec", Program() + " " + hill + " --size 32x32", typescript });
  EXPECT_EQ(shown.Status, 0);
  EXPECT_NE(shown.Output.find("% reading"), std::string::npos) << shown.Output;
}

TEST_F(TerrainRenderOutput, UnwritableFilesAreRefused)
{
  const std::string hill = this->WriteHill();
  std::filesystem::create_directory(this->Path("folder.png"));
  const std::vector<std::string> before = this->ListFiles();
  for (const char* option : { "--output", "--depth", "--stats" })
  {
    for (const char* path : { "nowhere/file", "folder.png", "/proc/file", "/dev/full" })
    {
      const RunResult result = this->Run({ hill, "--size", "32x32", option, path });
      ExpectRefused(result, 1, path);
      EXPECT_EQ(this->ListFiles(), before);
    }
  }
}

TEST_F(TerrainRenderOutput, FullDiskLeavesNothingBehind)
{
  const std::string hill = this->WriteHill();
  const std::vector<std::string> before = this->ListFiles();
  for (const long limit : { 1L, 300L, 1000L })
  {
    const RunResult result = this->Run(
      { hill, "--size", "400x300", "--output", "a.png", "--depth", "a.tif", "--stats", "a.json" },
      limit);
    EXPECT_EQ(result.Status, 1) << limit;
    EXPECT_EQ(this->ListFiles(), before) << limit;
  }
}

TEST_F(TerrainRenderOutput, FailureKeepsWhatWasThere)
{
  this->WriteText("picture.png", "an older picture");
  ExpectRefused(this->Draw(this->Path("nowhere.tif")), 1, "nowhere.tif");
  EXPECT_EQ(this->ReadText("picture.png"), "an older picture");
  EXPECT_EQ(this->ListFiles(), std::vector<std::string>{ "picture.png" });
}

TEST_F(TerrainRenderOutput, InputsAndOutputsAreNeverReplaced)
{
  const std::string hill = this->WriteHill();
  const std::string content = this->ReadText("hill.tif");
  std::filesystem::create_symlink("hill.tif", this->Path("link.tif"));
  const std::string colors = "0 red 100 red\n";
  this->WriteText("red.cpt", colors);
  std::filesystem::create_hard_link(this->Path("red.cpt"), this->Path("same.cpt"));
  const std::string crs = "+proj=utm +zone=45 +datum=WGS84\n";
  this->WriteText("utm.prj", crs);
  const std::vector<std::vector<std::string>> lines{ { hill, "--output", "./hill.tif" },
    { hill, "--output", "link.tif" }, { "link.tif", "--output", "hill.tif" },
    { hill, "--depth", "hill.tif" }, { hill, "--stats", "link.tif" },
    { "--track", hill, "--output", "link.tif" }, { "--drape", hill, "--output", "link.tif" },
    { "--detail", "link.tif", "--output", hill }, { "--stats", "./terrain.png" },
    { "--colors", "red.cpt", "--output", "red.cpt" },
    { hill, "--colors", "red.cpt", "--depth", "same.cpt" },
    { hill, "--colors", "same.cpt", "--stats", "./red.cpt" },
    { hill, "--crs", "utm.prj", "--output", "utm.prj" },
    { "--depth", "depth.tif", "--stats", "./depth.tif" } };
  for (const std::vector<std::string>& line : lines)
  {
    ExpectRefused(this->Run(line), 2, line[line.size() - 2]);
  }
  EXPECT_EQ(this->ReadText("hill.tif"), content);
  EXPECT_EQ(this->ReadText("red.cpt"), colors);
  EXPECT_EQ(this->ReadText("utm.prj"), crs);
  EXPECT_EQ(this->ListFiles(),
    (std::vector<std::string>{ "hill.tif", "link.tif", "red.cpt", "same.cpt", "utm.prj" }));
}

TEST_F(TerrainRenderOutput, LinksAreFollowed)
{
  this->WriteText("target.png", "what was there before");
  std::filesystem::create_symlink("target.png", this->Path("picture.png"));
  this->ExpectDrawn(this->Draw(this->WriteHill()));
  EXPECT_TRUE(std::filesystem::is_symlink(this->Path("picture.png")));
  EXPECT_EQ(this->ReadPictureSize("target.png").front(), this->ReadPicture().Width);
}

TEST_F(TerrainRenderOutput, SignalsLeaveNothingBehind)
{
  const std::string hill = this->WriteHill();
  for (const char* signal : { "TERM", "HUP" })
  {
    const RunResult result = this->RunCommand({ "/bin/sh", "-c",
      Program() + " " + hill + " --size 64x64 --frames 1000000 --depth depth.tif & p=$!\n" +
        "while ! ls | grep -q partial; do sleep 0.01; kill -0 $p || exit 99; done\n" +
        "sleep 0.2; kill -" + signal + " $p; wait $p" });
    ExpectRefused(result, 1, "stopped on request");
    EXPECT_EQ(this->ListFiles(), std::vector<std::string>{ "hill.tif" });
  }
}

// OpenGL 3.2 does not promise timers; Mesa can be told to have none.
TEST_F(TerrainRenderOutput, DriversWithoutTimersDraw)
{
  const std::vector<std::string> line{ Program(), this->WriteHill(), "--size", "32x32", "--output",
    "picture.png", "--stats", "stats.json" };
  setenv("MESA_EXTENSION_OVERRIDE", "-GL_ARB_timer_query", 1);
  const RunResult result = this->RunCommand(line);
  unsetenv("MESA_EXTENSION_OVERRIDE");
  ASSERT_EQ(result.Status, 0) << result.Errors;
  EXPECT_EQ(this->ReadText("stats.json").find("frame_gpu"), std::string::npos);
  EXPECT_NE(this->ReadText("stats.json").find("frame_cpu"), std::string::npos);
}

// Mesa's softpipe fetches the texels of four pixels from one level.
TEST_F(TerrainRenderOutput, SoftpipeDrawsNoHoles)
{
  const std::string hill = this->WriteHill();
  const std::vector<std::string> line{ Program(), hill, "--size", "64x48", "--window", "egl",
    "--output" };
  const auto draw = [&](const char* driver, const char* name)
  {
    std::vector<std::string> command = line;
    command.emplace_back(name);
    setenv("GALLIUM_DRIVER", driver, 1);
    const RunResult result = this->RunCommand(command);
    unsetenv("GALLIUM_DRIVER");
    EXPECT_EQ(result.Status, 0) << result.Errors;
    return this->ReadPicture(name);
  };
  const Picture reference = draw("llvmpipe", "llvmpipe.png");
  const Picture picture = draw("softpipe", "softpipe.png");
  ASSERT_EQ(picture.Values.size(), reference.Values.size());
  int different = 0;
  for (std::size_t i = 0; i < picture.Values.size(); ++i)
  {
    different += std::abs(int{ picture.Values[i] } - int{ reference.Values[i] }) > 8 ? 1 : 0;
  }
  EXPECT_LE(different, 30);
}

// A disk that takes small frames alone: those of the sky, before that of the hill.
TEST_F(TerrainRenderOutput, FramesBeforeAFullDiskAreKept)
{
  this->WriteText("down.csv",
    "seconds,x,y,z,look_x,look_y,look_z\n0,32,-90,60,32,-91,200\n"
    "6,32,-90,60,32,-91,200\n12,32,-60,40,32,-24,5\n");
  const RunResult full = this->Run({ this->WriteHill(), "--size", "320x240", "--flight", "down.csv",
                                     "--fps", "2", "--output", "down", "--contours", "1" },
    12000);
  EXPECT_EQ(full.Status, 1);
  EXPECT_EQ(std::count(full.Errors.begin(), full.Errors.end(), '\n'), 1) << full.Errors;
  EXPECT_NE(full.Errors.find("the frames before it are kept in 'down'"), std::string::npos)
    << full.Errors;
  EXPECT_TRUE(std::filesystem::exists(this->Path("down/frame-00001.png")));
}
