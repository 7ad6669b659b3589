// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What an input is read from is never replaced: not its sidecars, its parts, its tiles either.
#include "vtkTerrainOutputFile.h"
#include "vtkTerrainTestRaster.h"

#include "vtkNew.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace
{
namespace fs = std::filesystem;

/// A raster of its own at x, with statistics in a file beside it.
std::string WriteTile(const std::string& path, double x)
{
  vtkTerrainTesting::RasterFile raster;
  raster.Width = 2;
  raster.Height = 2;
  raster.Values = { 1.0, 2.0, 3.0, 4.0 };
  raster.GeoTransform = { x, 1.0, 0.0, 0.0, 0.0, -1.0 };
  raster.EPSG = 32633;
  GDALClose(raster.Create(path));
  GDALDatasetH dataset = GDALOpen(path.c_str(), GA_ReadOnly);
  double mean = 0.0;
  EXPECT_EQ(GDALComputeRasterStatistics(
              GDALGetRasterBand(dataset, 1), 0, &mean, &mean, &mean, &mean, nullptr, nullptr),
    CE_None);
  GDALClose(dataset);
  EXPECT_TRUE(fs::exists(path + ".aux.xml"));
  return path;
}

void WriteText(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

class TerrainOutputFile : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = vtkTerrainTesting::TemporaryFile(
      std::string("outputs-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  std::string Path(const std::string& name) const
  {
    return this->Folder + "/" + name;
  }
  /// Asserts that `path` is refused as an output of `input`, with one sentence, and stays.
  static void ExpectRefused(const std::string& input, const std::string& path)
  {
    vtkNew<vtkTerrainOutputFile> file;
    file->AddInput(input);
    const auto size = fs::file_size(path);
    EXPECT_FALSE(file->Open(path)) << path << " of " << input;
    EXPECT_NE(file->GetErrorMessage().find(path + ": "), std::string::npos);
    EXPECT_EQ(file->GetErrorMessage().find('\n'), std::string::npos);
    EXPECT_EQ(file->FindInput(path), input);
    EXPECT_EQ(fs::file_size(path), size);
  }
  static void ExpectReplaced(const std::string& input, const std::string& path)
  {
    vtkNew<vtkTerrainOutputFile> file;
    file->AddInput(input);
    EXPECT_EQ(file->FindInput(path), "");
    EXPECT_TRUE(file->Open(path) && file->Write("new", 3) && file->Commit())
      << file->GetErrorMessage();
    EXPECT_EQ(fs::file_size(path), 3U);
  }

  std::string Folder;
};
}

TEST_F(TerrainOutputFile, NeverReplacesARasterOrItsSidecars)
{
  const std::string raster = WriteTile(this->Path("a.tif"), 0.0);
  WriteText(this->Path("a.tfw"), "1\n0\n0\n-1\n0.5\n-0.5\n");
  fs::create_symlink("a.tif", this->Path("link.tif"));
  fs::create_hard_link(raster, this->Path("hard.tif"));
  for (const char* name : { "a.tif", "./a.tif", "link.tif", "hard.tif", "a.tif.aux.xml" })
  {
    ExpectRefused(raster, this->Path(name));
    ExpectRefused(this->Path("link.tif"), this->Path("a.tif"));
  }
  WriteText(this->Path("a.png"), "a picture");
  ExpectReplaced(raster, this->Path("a.png"));
  ExpectReplaced(raster, this->Path("new"));
  ExpectReplaced("", this->Path("new"));
}

// Statistics, overviews and masks of what was there before would be taken for the new file's.
TEST_F(TerrainOutputFile, ReplacesWhatGDALKeptBesideAFile)
{
  const std::string raster = WriteTile(this->Path("a.tif"), 0.0);
  WriteText(this->Path("a.tif.msk"), "a mask");
  WriteText(this->Path("a.tif.txt"), "a note");
  const std::string overviews = WriteTile(this->Path("a.tif.ovr"), 0.0); // an input of its own
  ExpectReplaced(overviews, raster);
  EXPECT_FALSE(fs::exists(this->Path("a.tif.aux.xml")));
  EXPECT_FALSE(fs::exists(this->Path("a.tif.msk")));
  EXPECT_TRUE(fs::exists(this->Path("a.tif.txt")));
  EXPECT_TRUE(fs::exists(overviews));
  WriteText(this->Path("b.tif.aux.xml"), "of nothing");
  ExpectReplaced("", this->Path("b.tif"));
  EXPECT_TRUE(fs::exists(this->Path("b.tif.aux.xml"))); // nothing was replaced
}

TEST_F(TerrainOutputFile, NeverReplacesTheHeaderOfARaster)
{
  WriteText(
    this->Path("a.asc"), "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n");
  WriteText(this->Path("a.prj"), "LOCAL_CS[\"test\",UNIT[\"m\",1]]");
  ExpectRefused(this->Path("a.asc"), this->Path("a.prj"));
}

TEST_F(TerrainOutputFile, NeverReplacesTilesOfADirectory)
{
  fs::create_directory(this->Path("tiles"));
  WriteTile(this->Path("tiles/a.tif"), 0.0);
  WriteTile(this->Path("elsewhere.tif"), 2.0);
  fs::create_symlink("../elsewhere.tif", this->Path("tiles/b.tif"));
  WriteText(this->Path("tiles/picture.png"), "a picture");
  for (const char* name : { "tiles/a.tif", "tiles/b.tif", "elsewhere.tif", "tiles/a.tif.aux.xml" })
  {
    ExpectRefused(this->Path("tiles"), this->Path(name));
  }
  ExpectReplaced(this->Path("tiles"), this->Path("tiles/picture.png"));
  ExpectReplaced(this->Path("tiles"), this->Path("other"));
}

TEST_F(TerrainOutputFile, NeverReplacesPartsOfAVirtualRaster)
{
  WriteTile(this->Path("part.tif"), 0.0);
  WriteText(this->Path("whole.vrt"),
    "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><VRTRasterBand dataType=\"Int16\" band=\"1\">"
    "<SimpleSource><SourceFilename relativeToVRT=\"1\">part.tif</SourceFilename>"
    "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>");
  for (const char* name : { "whole.vrt", "part.tif", "part.tif.aux.xml" })
  {
    ExpectRefused(this->Path("whole.vrt"), this->Path(name));
  }
}

TEST_F(TerrainOutputFile, NeverReplacesTheArchiveOfAnInput)
{
  WriteTile(this->Path("a.tif"), 0.0);
  const std::string archive = this->Path("a.zip");
  ASSERT_EQ(CPLCopyFile(("/vsizip/" + archive + "/a.tif").c_str(), this->Path("a.tif").c_str()), 0);
  ExpectRefused("/vsizip/" + archive + "/a.tif", archive);
  ExpectRefused("/vsizip/{" + archive + "}/a.tif", archive);
  ExpectReplaced("/vsizip/" + archive + "/a.tif", this->Path("a.tif"));
}

TEST_F(TerrainOutputFile, NeverReplacesVectorsOrTheirTables)
{
  WriteText(this->Path("track.csv"), "id,WKT\n1,\"POINT (1 2)\"\n");
  WriteText(this->Path("track.csvt"), "Integer,WKT\n");
  ExpectRefused(this->Path("track.csv"), this->Path("track.csv"));
}

TEST_F(TerrainOutputFile, SaysWhatIsNotOpen)
{
  vtkNew<vtkTerrainOutputFile> file;
  EXPECT_FALSE(file->Commit());
  EXPECT_FALSE(file->Write("", 0));
  file->Discard();
  EXPECT_EQ(file->GetPartialFileName(), "");
  EXPECT_FALSE(file->Open("/dev/null"));
  EXPECT_EQ(file->GetErrorMessage(), "/dev/null: is no regular file");
  ASSERT_TRUE(file->Open(this->Path("out")));
  EXPECT_TRUE(fs::exists(file->GetPartialFileName()));
  vtkTerrainOutputFile::RemovePartialFiles();
  EXPECT_FALSE(fs::exists(file->GetPartialFileName()));
}
