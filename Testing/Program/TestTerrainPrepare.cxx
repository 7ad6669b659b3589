// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What terrain-prepare does: a file that holds the raster, or one sentence, status 1 and no file.
#include "TerrainRenderFixture.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <sys/stat.h>

namespace
{
class TerrainPrepare : public TerrainRenderFixture
{
protected:
  static std::string Program()
  {
    return TERRAIN_PREPARE_PROGRAM;
  }
  RunResult Prepare(std::vector<std::string> arguments, long fileLimit = 0) const
  {
    arguments.insert(arguments.begin(), Program());
    return this->RunCommand(arguments, fileLimit);
  }
  /// Asserts that preparing fails with a sentence that names a file, and leaves nothing behind.
  void ExpectPrepareRefused(const std::string& heights, const std::string& mention,
    const std::string& out = "out.hierarchy", long fileLimit = 0) const
  {
    const std::vector<std::string> before = this->ListFiles();
    ExpectRefused(this->Prepare({ heights, out }, fileLimit), 1, mention);
    EXPECT_EQ(this->ListFiles(), before);
  }
  /// A raster without a file behind it: side x side zeros.
  std::string WriteZeros(int side) const
  {
    const std::string size = std::to_string(side);
    return this->WriteText("zeros.vrt",
      "<VRTDataset rasterXSize=\"" + size + "\" rasterYSize=\"" + size +
        "\"><VRTRasterBand dataType=\"Float32\" band=\"1\"/></VRTDataset>");
  }
};
}

TEST_F(TerrainPrepare, WritesAFileThatChecks)
{
  const std::string hill = this->WriteHill();
  const RunResult result = this->Prepare({ hill, "out.hierarchy" });
  EXPECT_EQ(result.Status, 0) << result.Errors;
  EXPECT_EQ(result.Errors, "");
  EXPECT_EQ(this->ListFiles(), (std::vector<std::string>{ "hill.tif", "out.hierarchy" }));
  const RunResult check = this->Prepare({ "--check", "out.hierarchy" });
  EXPECT_EQ(check.Status, 0) << check.Errors;
  EXPECT_NE(check.Output.find("65 x 49 samples"), std::string::npos) << check.Output;
}

TEST_F(TerrainPrepare, WritesTheSameAgain)
{
  const std::string hill = this->WriteHill();
  ASSERT_EQ(this->Prepare({ hill, "first.hierarchy" }).Status, 0);
  this->WriteText("second.hierarchy", "what was there before");
  ASSERT_EQ(this->Prepare({ hill, "second.hierarchy" }).Status, 0);
  EXPECT_EQ(this->ReadText("first.hierarchy"), this->ReadText("second.hierarchy"));
}

TEST_F(TerrainPrepare, RefusesWhatAreNoHeights)
{
  this->ExpectPrepareRefused(this->Path("nowhere.tif"), "nowhere.tif");
  this->ExpectPrepareRefused(this->WriteText("empty.tif", ""), "empty.tif");
  this->ExpectPrepareRefused(this->WriteText("text.tif", "These are no heights.\n"), "text.tif");
  const std::string truncated = this->WriteHill("truncated.tif");
  std::filesystem::resize_file(truncated, std::filesystem::file_size(truncated) / 2);
  this->ExpectPrepareRefused(truncated, "truncated.tif");
  RasterDescription colours;
  colours.Bands = 3;
  colours.IsBytes = true;
  this->ExpectPrepareRefused(this->WriteRaster("colours.tif", colours), "colours.tif");
  this->ExpectPrepareRefused(this->WriteZeros(40000), "32769");
}

TEST_F(TerrainPrepare, TakesOneOfSeveralSitesThatIsNamed)
{
  const std::string sites = this->WriteSites();
  this->ExpectPrepareRefused(sites, "--part 1 to --part 2");
  ExpectRefused(this->Prepare({ "--mesh", "out.ply", sites }), 1, "--part 1 to --part 2");
  EXPECT_EQ(this->Prepare({ sites, "out.hierarchy", "--part", "2" }).Status, 0);
}

TEST_F(TerrainPrepare, RefusesPlacesItCannotWriteTo)
{
  const std::string hill = this->WriteHill();
  this->ExpectPrepareRefused(hill, "nowhere/out", this->Path("nowhere/out"));
  std::filesystem::create_directory(this->Path("folder"));
  this->ExpectPrepareRefused(hill, "folder", this->Path("folder"));
}

TEST_F(TerrainPrepare, KeepsTheOldFileWhenTheDiskIsFull)
{
  const std::string hill = this->WriteHill();
  this->ExpectPrepareRefused(hill, "out.hierarchy", "out.hierarchy", 20000);
  this->WriteText("out.hierarchy", "what was there before");
  this->ExpectPrepareRefused(hill, "out.hierarchy", "out.hierarchy", 20000);
  EXPECT_EQ(this->ReadText("out.hierarchy"), "what was there before");
}

TEST_F(TerrainPrepare, LeavesNothingWhenItIsStopped)
{
  const std::string zeros = this->WriteZeros(4000);
  for (const char* signal : { "TERM", "HUP", "XCPU" })
  {
    // as soon as the file is begun
    const RunResult result = this->RunCommand({ "/bin/sh", "-c",
      Program() + " " + zeros + " out.hierarchy & p=$!\n" +
        "while ! ls | grep -q partial; do sleep 0.01; kill -0 $p || exit 99; done\n" + "kill -" +
        signal + " $p; wait $p" });
    ExpectRefused(result, 1, "stopped on request");
    EXPECT_EQ(this->ListFiles(), std::vector<std::string>{ "zeros.vrt" });
  }
}

TEST_F(TerrainPrepare, NeverReplacesItsInput)
{
  const std::string hill = this->WriteHill();
  const std::string content = this->ReadText("hill.tif");
  std::filesystem::create_symlink("hill.tif", this->Path("link.tif"));
  for (const char* out : { "hill.tif", "./hill.tif", "link.tif" })
  {
    ExpectRefused(this->Prepare({ hill, out }), 2, "HEIGHTS is read from");
    ExpectRefused(this->Prepare({ "link.tif", out }), 2, "HEIGHTS is read from");
  }
  EXPECT_EQ(this->ReadText("hill.tif"), content);
  EXPECT_EQ(this->ListFiles(), (std::vector<std::string>{ "hill.tif", "link.tif" }));
}

// A pipe without a writer is waited for by whoever opens it.
TEST_F(TerrainPrepare, TakesRegularFilesOnly)
{
  const std::string hill = this->WriteHill();
  ASSERT_EQ(mkfifo(this->Path("pipe").c_str(), 0666), 0);
  ExpectRefused(this->Prepare({ hill, "pipe" }), 1, "no regular file");
  ExpectRefused(this->Prepare({ hill, "/dev/null" }), 1, "no regular file");
  ExpectRefused(this->Prepare({ "pipe", "out.hierarchy" }), 1, "no regular file");
  ExpectRefused(this->Prepare({ "--check", "pipe" }), 1, "not a regular file");
  EXPECT_TRUE(std::filesystem::is_fifo(this->Path("pipe")));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(TerrainPrepare, TwoOfOneNameDoNotMeet)
{
  const std::string zeros = this->WriteZeros(3000);
  const std::string hill = this->WriteHill();
  const RunResult result = this->RunCommand({ "/bin/sh", "-c",
    Program() + " " + zeros + " out.hierarchy & p=$!\n" +
      "while ! ls | grep -q partial; do sleep 0.01; kill -0 $p || exit 99; done\n" + Program() +
      " " + hill + " out.hierarchy && wait $p" });
  EXPECT_EQ(result.Status, 0) << result.Errors;
  EXPECT_EQ(
    this->ListFiles(), (std::vector<std::string>{ "hill.tif", "out.hierarchy", "zeros.vrt" }));
  EXPECT_EQ(this->Prepare({ "--check", "out.hierarchy" }).Status, 0);
}

TEST_F(TerrainPrepare, FindsDamage)
{
  ASSERT_EQ(this->Prepare({ this->WriteHill(), "out.hierarchy" }).Status, 0);
  {
    std::fstream file(this->Path("out.hierarchy"), std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(5000);
    file.put('\x55');
  }
  ExpectRefused(this->Prepare({ "--check", "out.hierarchy" }), 1, "out.hierarchy");
  ExpectRefused(this->Prepare({ "--check", "hill.tif" }), 1, "no hierarchy file");
}

TEST_F(TerrainPrepare, RefusesWrongCommandLines)
{
  const std::vector<std::vector<std::string>> lines{ {}, { "one" }, { "--check" },
    { "--check", "one", "two" }, { "one", "two", "three" }, { "--unknown", "one", "two" } };
  for (const std::vector<std::string>& arguments : lines)
  {
    EXPECT_EQ(this->Prepare(arguments).Status, 2);
  }
  EXPECT_EQ(this->Prepare({ "--help" }).Status, 0);
  EXPECT_TRUE(this->ListFiles().empty());
}

TEST_F(TerrainPrepare, ShowsProgressOnATerminal)
{
  const std::string terminal = "/usr/bin/script";
  const std::string typescript = this->Path("typescript");
  if (this->RunCommand({ terminal, "-qec", "true", typescript }).Status != 0)
  {
    GTEST_SKIP() << "there is no terminal to be had";
  }
  const std::string line = Program() + " " + this->WriteHill() + " out.hierarchy";
  const RunResult shown = this->RunCommand({ terminal, "-qec", line, typescript });
  EXPECT_EQ(shown.Status, 0);
  EXPECT_NE(shown.Output.find("preparing ["), std::string::npos) << shown.Output;
  EXPECT_NE(shown.Output.find("100 %"), std::string::npos) << shown.Output;
  const RunResult quiet = this->RunCommand({ terminal, "-qec", line + " --quiet", typescript });
  EXPECT_EQ(quiet.Status, 0);
  EXPECT_EQ(quiet.Output, "");
}
