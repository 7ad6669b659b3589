// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Hierarchy files: the same as memory, refused when anything is wrong, never the end of the
// process.
#include "HierarchyTestTools.h"

#include "core/strips/HierarchyFile.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace hierarchytest;
using terrain::HierarchyFile;
using terrain::MemoryHierarchy;

namespace
{
/// A file in the tests' own directory; removed with the object.
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string& name)
  {
    const char* folder = std::getenv("VTKTERRAIN_TEST_OUTPUT_DIR");
    const std::string base = folder ? folder : testing::TempDir();
    mkdir(base.c_str(), 0777);
    this->Path = base + "/" + name + std::to_string(getpid()) + ".hierarchy";
  }
  ~TemporaryFile()
  {
    std::remove(this->Path.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::string Path;

  bool Exists() const
  {
    return access(this->Path.c_str(), F_OK) == 0;
  }
  /// Path of the file under construction beside it, empty if there is none.
  std::string FindPartial() const
  {
    const std::filesystem::path path(this->Path);
    const std::string begin = path.filename().string() + ".";
    for (const auto& entry : std::filesystem::directory_iterator(path.parent_path()))
    {
      if (entry.path().filename().string().compare(0, begin.size(), begin) == 0)
      {
        return entry.path().string();
      }
    }
    return {};
  }
  std::string Content() const
  {
    std::ifstream in(this->Path, std::ios::binary);
    return { std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>() };
  }
  void SetContent(const std::string& content) const
  {
    std::ofstream(this->Path, std::ios::binary | std::ios::trunc) << content;
  }
};

std::string Write(
  const TemporaryFile& file, const Raster& raster, const terrain::BuildProgress& progress = {})
{
  return terrain::WriteHierarchyFile(file.Path, raster.Width, raster.Height, MakeGeometry(),
    { "LOCAL_CS[\"test\"]" }, RowsOf(raster), terrain::SerialFor, progress);
}

/// What Open says about a file of the given content.
std::string Refusal(const std::string& content, bool verify = true)
{
  const TemporaryFile file("refused");
  file.SetContent(content);
  HierarchyFile hierarchy;
  return hierarchy.Open(file.Path, verify);
}

std::string GoodContent()
{
  const TemporaryFile file("good");
  EXPECT_EQ(Write(file, MakeHills(100, 90)), "");
  return file.Content();
}
}

TEST(HierarchyFile, RefinesLikeMemory)
{
  const Raster raster = WithHoles(MakeHills(150, 130), "lake");
  const MemoryHierarchy memory = Build(raster);
  const TemporaryFile streamed("streamed");
  const TemporaryFile copied("copied");
  ASSERT_EQ(Write(streamed, raster), "");
  ASSERT_EQ(
    terrain::WriteHierarchyFile(copied.Path, memory.View(), { "LOCAL_CS[\"test\"]" }, {}), "");
  EXPECT_EQ(streamed.Content(), copied.Content());
  EXPECT_EQ(streamed.FindPartial(), "");
  HierarchyFile file;
  ASSERT_EQ(file.Open(streamed.Path, true), "");
  EXPECT_EQ(file.Placing().CoordinateSystem, "LOCAL_CS[\"test\"]");
  EXPECT_EQ(file.View().Geometry.Origin, MakeGeometry().Origin);
  terrain::RefinementOptions options;
  options.Morphing = true;
  terrain::StripMesh fromMemory;
  terrain::StripMesh fromFile;
  const terrain::RefinementView view = MakeView(raster, 0.4, 0.3, 20.0);
  terrain::Refiner(memory.View()).Refine(view, options, fromMemory);
  terrain::Refiner(file.View()).Refine(view, options, fromFile);
  EXPECT_EQ(fromFile.Strip, fromMemory.Strip);
  ASSERT_EQ(fromFile.Vertices.size(), fromMemory.Vertices.size());
  for (std::size_t i = 0; i < fromFile.Vertices.size(); ++i)
  {
    EXPECT_EQ(fromFile.Vertices[i].Displacement, fromMemory.Vertices[i].Displacement);
  }
  EXPECT_FALSE(file.IsDamaged());
}

TEST(HierarchyFile, RefusesForeignAndEmptyFiles)
{
  EXPECT_NE(Refusal("").find("empty"), std::string::npos);
  EXPECT_NE(Refusal("GIF89a").find("no hierarchy"), std::string::npos);
  EXPECT_NE(Refusal(std::string(100000, 'x')).find("no hierarchy"), std::string::npos);
  HierarchyFile file;
  EXPECT_NE(file.Open("/nowhere/at/all", false), "");
  EXPECT_NE(file.Open("/", false), "");
}

TEST(HierarchyFile, RefusesTruncatedFiles)
{
  const std::string content = GoodContent();
  for (const std::size_t size : { std::size_t(5), std::size_t(100), std::size_t(4095),
         std::size_t(4096), content.size() / 2, content.size() - 1 })
  {
    EXPECT_NE(Refusal(content.substr(0, size), false), "") << size;
  }
  EXPECT_NE(Refusal(content + "x", false), "");
}

TEST(HierarchyFile, RefusesAlteredFiles)
{
  const std::string content = GoodContent();
  EXPECT_EQ(Refusal(content), "");
  for (const std::size_t position : { std::size_t(24), std::size_t(50), std::size_t(4096),
         std::size_t(5000), content.size() / 2, content.size() - 20, content.size() - 1 })
  {
    std::string altered = content;
    altered[position] = static_cast<char>(altered[position] ^ 0x10);
    EXPECT_NE(Refusal(altered), "") << position;
  }
}

TEST(HierarchyFile, RefusesNewerVersionsOtherByteOrdersAndUnfinishedFiles)
{
  std::string content = GoodContent();
  content[12] = 99;
  EXPECT_NE(Refusal(content).find("version 99"), std::string::npos);
  content = GoodContent();
  std::swap(content[8], content[11]);
  EXPECT_NE(Refusal(content).find("byte order"), std::string::npos);
  content = GoodContent();
  content[16] = 0;
  EXPECT_NE(Refusal(content).find("never finished"), std::string::npos);
}

TEST(HierarchyFile, IsUnfinishedWhileItIsWritten)
{
  const TemporaryFile file("written");
  std::string seen;
  EXPECT_EQ(Write(file, MakeHills(60, 200),
              [&](double)
              {
                EXPECT_FALSE(file.Exists());
                HierarchyFile other;
                seen = other.Open(file.FindPartial(), false);
                return true;
              }),
    "");
  EXPECT_NE(seen.find("being written"), std::string::npos) << seen;
  EXPECT_TRUE(file.Exists());
}

TEST(HierarchyFile, LeavesNothingBehindWhenItFails)
{
  const TemporaryFile file("failed");
  EXPECT_NE(Write(file, MakeHills(60, 200), [](double) { return false; }), "");
  EXPECT_FALSE(file.Exists());
  EXPECT_EQ(file.FindPartial(), "");
  EXPECT_NE(terrain::WriteHierarchyFile("/nowhere/at/all", 2, 2, MakeGeometry(), {},
              RowsOf(MakeHills(2, 2)), terrain::SerialFor, {}),
    "");
}

TEST(HierarchyFile, FailsCleanlyWhenThereIsNoSpace)
{
  // A limit on the file's size stands for a full disk: both fail where space is reserved.
  const TemporaryFile file("full");
  rlimit before = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  auto* handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = { 8192, before.rlim_max };
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string error = Write(file, MakeHills(60, 200));
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(error, "");
  EXPECT_FALSE(file.Exists());
  EXPECT_EQ(file.FindPartial(), "");
}

TEST(HierarchyFile, SurvivesShrinkingWhileItIsMapped)
{
  const Raster raster = MakeHills(300, 300);
  const TemporaryFile file("shrunk");
  ASSERT_EQ(Write(file, raster), "");
  HierarchyFile hierarchy;
  ASSERT_EQ(hierarchy.Open(file.Path, false), "");
  ASSERT_EQ(truncate(file.Path.c_str(), 4096), 0);
  terrain::StripMesh mesh;
  terrain::Refiner(hierarchy.View())
    .Refine(MakeView(raster, 0.4, 0.3, 20.0), terrain::RefinementOptions(), mesh);
  EXPECT_TRUE(hierarchy.IsDamaged());
}

TEST(HierarchyFile, HoldsRastersOfAnySize)
{
  for (const auto& size :
    std::vector<std::array<std::int64_t, 2>>{ { { 1, 1 } }, { { 1, 9 } }, { { 2, 2 } } })
  {
    const TemporaryFile file("small");
    ASSERT_EQ(Write(file, MakeHills(size[0], size[1])), "");
    HierarchyFile hierarchy;
    EXPECT_EQ(hierarchy.Open(file.Path, true), "");
    EXPECT_EQ(hierarchy.View().Layout->Width(), size[0]);
    EXPECT_EQ(hierarchy.View().Layout->Height(), size[1]);
  }
}

// Checksums are not meant against intent, and numbers that no raster has are found all the same.
TEST(HierarchyFile, RefusesNumbersThatNoRasterHas)
{
  const MemoryHierarchy sound = Build(MakeHills(100, 90));
  const auto refusal = [](const MemoryHierarchy& hierarchy)
  {
    const TemporaryFile file("hostile");
    EXPECT_EQ(terrain::WriteHierarchyFile(file.Path, hierarchy.View(), {}, {}), "");
    HierarchyFile opened;
    return opened.Open(file.Path, true);
  };
  EXPECT_EQ(refusal(sound), "");
  for (const float number : { std::numeric_limits<float>::infinity(), None })
  {
    MemoryHierarchy hierarchy = sound;
    hierarchy.Summary.Corners[2] = number;
    EXPECT_NE(refusal(hierarchy), "");
    hierarchy = sound;
    hierarchy.Summary.MinimumHeight = number;
    EXPECT_NE(refusal(hierarchy), "");
    hierarchy = sound;
    hierarchy.Geometry.Origin.x = number;
    EXPECT_NE(refusal(hierarchy), "");
    hierarchy = sound;
    hierarchy.Geometry.Spacing.y = number;
    EXPECT_NE(refusal(hierarchy), "");
    hierarchy = sound;
    hierarchy.Records[hierarchy.Records.size() / 2].Height = number;
    EXPECT_NE(refusal(hierarchy).find("no number"), std::string::npos);
  }
}

TEST(HierarchyFile, KeepsWhereTheHeightsLie)
{
  const Raster raster = MakeHills(20, 30);
  const TemporaryFile file("placed");
  terrain::HierarchyPlacing placing{ "EPSG:4326", true, { 86.5, 27.25 }, { 98000.0, 110000.0 } };
  ASSERT_EQ(terrain::WriteHierarchyFile(file.Path, raster.Width, raster.Height, MakeGeometry(),
              placing, RowsOf(raster), terrain::SerialFor, {}),
    "");
  EXPECT_TRUE(terrain::IsHierarchyFile(file.Path));
  HierarchyFile opened;
  ASSERT_EQ(opened.Open(file.Path, true), "");
  EXPECT_EQ(opened.Placing().CoordinateSystem, placing.CoordinateSystem);
  ASSERT_TRUE(opened.Placing().HasLayout);
  EXPECT_EQ(opened.Placing().LayoutOrigin, placing.LayoutOrigin);
  EXPECT_EQ(opened.Placing().LayoutScale, placing.LayoutScale);
  std::string content = file.Content();
  content[2048] = static_cast<char>(content[2048] ^ 1);
  EXPECT_NE(Refusal(content).find("layout"), std::string::npos);
  const TemporaryFile plain("plain");
  ASSERT_EQ(Write(plain, raster), "");
  HierarchyFile without;
  ASSERT_EQ(without.Open(plain.Path, true), "");
  EXPECT_FALSE(without.Placing().HasLayout);
  EXPECT_FALSE(terrain::IsHierarchyFile("/nowhere"));
  plain.SetContent("vtkTer");
  EXPECT_FALSE(terrain::IsHierarchyFile(plain.Path));
}
