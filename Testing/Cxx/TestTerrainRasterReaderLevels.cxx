// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Rasters that are read at a level, and the files that keep levels, against the samples in full.
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainTestRaster.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

using vtkTerrainTesting::RasterFile;

namespace
{
constexpr int kWidth = 1300; // levels of 1300, 651, 326, 164 samples
constexpr int kHeight = 1100;

// Hills with noise, whole numbers; a lake of no data.
std::vector<double> Hills(bool withLake)
{
  std::minstd_rand generator(5);
  std::vector<double> values;
  for (int r = 0; r < kHeight; ++r)
  {
    for (int c = 0; c < kWidth; ++c)
    {
      const double hill = 900.0 + 500.0 * std::sin(0.013 * c) * std::cos(0.017 * r);
      const bool lake = withLake && std::hypot(c - 400.0, r - 500.0) < 90.0;
      values.push_back(lake ? -9999.0 : std::floor(hill) + static_cast<double>(generator() % 20U));
    }
  }
  return values;
}

// A folder of its own, that is also the user's cache; removed at the end.
class RasterLevels : public testing::Test
{
protected:
  RasterLevels()
    : Folder(vtkTerrainTesting::TemporaryFile(
        std::string("levels-") + testing::UnitTest::GetInstance()->current_test_info()->name()))
  {
    std::filesystem::remove_all(this->Folder);
    std::filesystem::create_directories(this->Folder);
    setenv("XDG_CACHE_HOME", this->Folder.c_str(), 1);
    this->Path = this->Folder + "/dem.tif";
  }
  ~RasterLevels() override
  {
    std::filesystem::permissions(this->Folder, std::filesystem::perms::owner_all);
    std::filesystem::remove_all(this->Folder);
  }

  void WriteRaster(const std::vector<double>& values, GDALDataType type = GDT_Int16) const
  {
    RasterFile raster;
    raster.Width = kWidth;
    raster.Height = kHeight;
    raster.Values = values;
    raster.Type = type;
    raster.GeoTransform = { 1000.0, 30.0, 0.0, 90000.0, 0.0, -30.0 };
    raster.EPSG = 32611;
    raster.Options = { "TILED=YES" };
    raster.Write(this->Path);
  }
  vtkSmartPointer<vtkTerrainRasterReader> Read(int mostAlongSide) const
  {
    auto reader = vtkSmartPointer<vtkTerrainRasterReader>::New();
    reader->SetFileName(this->Path);
    reader->SetMaximumSize(mostAlongSide);
    reader->UseLevelsOn();
    reader->Update();
    EXPECT_STREQ(reader->GetErrorMessage(), "");
    return reader;
  }
  // Files under the cache.
  std::vector<std::string> Kept() const
  {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry :
      std::filesystem::directory_iterator(this->Folder + "/vtkterrain", error))
    {
      names.push_back(entry.path().string());
    }
    return names;
  }

  std::string Folder;
  std::string Path;
};

bool IsHidden(vtkImageData* image, int i, int j)
{
  vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
  int point[3] = { i, j, 0 };
  return ghosts &&
    (ghosts->GetValue(image->ComputePointId(point)) & vtkDataSetAttributes::HIDDENPOINT) != 0;
}

// Lowest and highest sample of the cells of the file around sample (i, j) of a level.
void FindRange(const std::vector<double>& values, int level, int i, int j, double range[2])
{
  const int size = 1 << level;
  range[0] = std::numeric_limits<double>::infinity();
  range[1] = -range[0];
  for (int y = std::max((j - 1) * size, 0); y <= std::min((j + 1) * size, kHeight - 1); ++y)
  {
    for (int x = std::max((i - 1) * size, 0); x <= std::min((i + 1) * size, kWidth - 1); ++x)
    {
      const double value =
        values[static_cast<std::size_t>(kHeight - 1 - y) * kWidth + static_cast<std::size_t>(x)];
      range[0] = std::min(range[0], value);
      range[1] = std::max(range[1], value);
    }
  }
}
}

TEST_F(RasterLevels, SamplesLieOnTheRaster)
{
  const std::vector<double> values = Hills(false);
  this->WriteRaster(values);
  const auto reader = this->Read(400);
  EXPECT_EQ(reader->GetLevel(), 2);
  vtkImageData* image = reader->GetOutput();
  EXPECT_EQ(image->GetScalarType(), VTK_SHORT);
  const int* dimensions = image->GetDimensions();
  EXPECT_EQ(dimensions[0], 326);
  EXPECT_EQ(dimensions[1], 276);
  // Sample (0, 0) is the middle of the south-western pixel, whatever the level.
  EXPECT_DOUBLE_EQ(image->GetOrigin()[0], 1015.0);
  EXPECT_DOUBLE_EQ(image->GetOrigin()[1], 90000.0 - 30.0 * kHeight + 15.0);
  EXPECT_DOUBLE_EQ(image->GetSpacing()[0], 120.0);
  EXPECT_DOUBLE_EQ(image->GetSpacing()[1], 120.0);
  for (int j = 0; j < dimensions[1]; j += 3)
  {
    for (int i = 0; i < dimensions[0]; i += 3)
    {
      double range[2];
      FindRange(values, 2, i, j, range);
      const double height = image->GetScalarComponentAsDouble(i, j, 0, 0);
      ASSERT_GE(height, range[0]) << i << ' ' << j;
      ASSERT_LE(height, range[1]) << i << ' ' << j;
    }
  }
  EXPECT_NE(std::string(reader->GetWarningMessage()).find("level 2"), std::string::npos);
}

TEST_F(RasterLevels, PiecesEqualTheWhole)
{
  this->WriteRaster(Hills(true));
  const auto whole = this->Read(700);
  EXPECT_EQ(whole->GetLevel(), 1);
  const vtkNew<vtkTerrainRasterReader> part;
  part->SetFileName(this->Path);
  part->SetMaximumSize(700);
  part->UseLevelsOn();
  int extent[6] = { 120, 400, 250, 303, 0, 0 };
  part->UpdateInformation();
  part->UpdateExtent(extent);
  int holes = 0;
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      ASSERT_EQ(IsHidden(part->GetOutput(), i, j), IsHidden(whole->GetOutput(), i, j));
      if (!IsHidden(whole->GetOutput(), i, j))
      {
        ASSERT_EQ(part->GetOutput()->GetScalarComponentAsDouble(i, j, 0, 0),
          whole->GetOutput()->GetScalarComponentAsDouble(i, j, 0, 0));
      }
      holes += IsHidden(whole->GetOutput(), i, j) ? 1 : 0;
    }
  }
  EXPECT_GT(holes, 500);
}

TEST_F(RasterLevels, AreNotUsedWhereTheRasterFits)
{
  this->WriteRaster(Hills(false));
  const auto reader = this->Read(kWidth);
  EXPECT_EQ(reader->GetLevel(), 0);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], kWidth);
  EXPECT_STREQ(reader->GetWarningMessage(), "");
  EXPECT_TRUE(this->Kept().empty());
}

TEST_F(RasterLevels, ABudgetCoarsens)
{
  this->WriteRaster(Hills(false));
  const vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(this->Path);
  reader->SetMaximumSize(700);
  reader->UseLevelsOn();
  reader->SetMemoryBudget(vtkIdType{ 8 } * 200 * 200);
  reader->Update();
  EXPECT_EQ(reader->GetLevel(), 3);
  reader->SetMemoryBudget(1); // no level is that small: the coarsest one
  reader->Update();
  EXPECT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(reader->GetLevel(), 3);
  reader->SetMemoryBudget(VTK_ID_MAX);
  reader->Update();
  EXPECT_EQ(reader->GetLevel(), 1);
  reader->SetMemoryBudget(0);
  reader->Update();
  EXPECT_EQ(reader->GetLevel(), 1);
}

// Levels are made once; a raster that has changed has new ones.
TEST_F(RasterLevels, AreKeptUntilTheRasterChanges)
{
  std::vector<double> values = Hills(false);
  this->WriteRaster(values);
  this->Read(400);
  ASSERT_EQ(this->Kept().size(), 1U);
  const auto time = std::filesystem::last_write_time(this->Kept().front());
  const auto again = this->Read(400);
  EXPECT_EQ(std::filesystem::last_write_time(this->Kept().front()), time);
  const double before = again->GetOutput()->GetScalarComponentAsDouble(100, 100, 0, 0);

  const auto rasterTime = std::filesystem::last_write_time(this->Path);
  for (double& value : values)
  {
    value += 100.0;
  }
  this->WriteRaster(values);
  std::filesystem::last_write_time(this->Path, rasterTime); // same size, same time
  const auto changed = this->Read(400);
  EXPECT_EQ(changed->GetOutput()->GetScalarComponentAsDouble(100, 100, 0, 0), before + 100.0);
  EXPECT_EQ(this->Kept().size(), 1U);
}

TEST_F(RasterLevels, DamagedOnesAreMadeAgain)
{
  this->WriteRaster(Hills(false));
  const auto good = this->Read(400);
  const std::string kept = this->Kept().front();
  for (const int size : { 0, 5000, 1 })
  {
    if (size == 1)
    {
      std::ofstream(kept) << std::string(100000, 'x');
    }
    else
    {
      std::filesystem::resize_file(kept, static_cast<std::uintmax_t>(size));
    }
    const auto again = this->Read(400);
    EXPECT_EQ(again->GetOutput()->GetScalarComponentAsDouble(200, 100, 0, 0),
      good->GetOutput()->GetScalarComponentAsDouble(200, 100, 0, 0));
  }
}

TEST_F(RasterLevels, NoCacheLeavesNothing)
{
  this->WriteRaster(Hills(false));
  const vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(this->Path);
  reader->SetMaximumSize(400);
  reader->UseLevelsOn();
  reader->UseCacheOff();
  reader->Update();
  EXPECT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(reader->GetLevel(), 2);
  EXPECT_TRUE(this->Kept().empty());
  EXPECT_FALSE(std::filesystem::exists(this->Path + ".tiles"));
}

// A cache that cannot be written: the picture all the same, and one line that says so.
TEST_F(RasterLevels, ACacheThatCannotBeWritten)
{
  this->WriteRaster(Hills(false));
  std::ofstream(this->Folder + "/vtkterrain") << "a file where the folder should be";
  const auto reader = this->Read(400);
  EXPECT_EQ(reader->GetLevel(), 2);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], 326);
  EXPECT_NE(std::string(reader->GetWarningMessage()).find("cannot be kept"), std::string::npos);
}

TEST_F(RasterLevels, LevelsBesideTheRasterComeFirst)
{
  this->WriteRaster(Hills(false));
  const vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(this->Path);
  ASSERT_TRUE(reader->PrepareLevels());
  EXPECT_TRUE(std::filesystem::exists(this->Path + ".tiles"));
  this->Read(400);
  EXPECT_TRUE(this->Kept().empty());
  // Stale ones are left alone and not used.
  std::vector<double> values = Hills(false);
  values.front() += 5.0;
  this->WriteRaster(values);
  this->Read(400);
  EXPECT_EQ(this->Kept().size(), 1U);
}

// Types that the file of tiles does not hold are kept as float; scaled ones come scaled.
TEST_F(RasterLevels, OtherTypes)
{
  std::vector<double> values = Hills(true);
  for (const GDALDataType type : { GDT_Float32, GDT_Float64, GDT_Int32 })
  {
    this->WriteRaster(values, type);
    const auto reader = this->Read(400);
    vtkImageData* image = reader->GetOutput();
    const int i = 163;
    const int j = 50;
    double range[2];
    FindRange(values, 2, i, j, range);
    EXPECT_GE(image->GetScalarComponentAsDouble(i, j, 0, 0), range[0]);
    EXPECT_LE(image->GetScalarComponentAsDouble(i, j, 0, 0), range[1]);
    const int lake[2] = { 100, (kHeight - 1 - 500) / 4 };
    const double none = image->GetScalarComponentAsDouble(lake[0], lake[1], 0, 0);
    EXPECT_TRUE(std::isnan(none) || IsHidden(image, lake[0], lake[1]));
  }
  // 16 bits that use all values
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    values[k] = k % 2 == 0 ? -32768.0 : 32767.0;
  }
  this->WriteRaster(values, GDT_UInt16); // clamped to 0 and 32767
  this->Read(400);
}

TEST_F(RasterLevels, StopsWhenAsked)
{
  this->WriteRaster(Hills(false));
  const vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(this->Path);
  reader->SetMaximumSize(400);
  reader->UseLevelsOn();
  const vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkTerrainRasterReader*>(caller)->SetAbortExecute(1); });
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Update();
  EXPECT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(this->Kept().empty());
}
