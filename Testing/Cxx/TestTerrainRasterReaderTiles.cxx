// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Several rasters as one terrain, and several bands as times.
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainTestRaster.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

using vtkTerrainTesting::RasterFile;
using vtkTerrainTesting::TemporaryFile;

namespace
{
/// first, first + 1, ... row by row from the first row of the file.
std::vector<double> Count(std::size_t samples, double first = 0.0)
{
  std::vector<double> values(samples);
  std::iota(values.begin(), values.end(), first);
  return values;
}

double Height(vtkImageData* image, int i, int j)
{
  return image->GetScalarComponentAsDouble(i, j, 0, 0);
}
}

TEST(TerrainRasterReaderTiles, DirectoryIsOneTerrain)
{
  // Three tiles of 4 x 3: two side by side, one below the first of them.
  const std::filesystem::path folder = TemporaryFile("tiles");
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  RasterFile tile;
  tile.Width = 4;
  tile.Height = 3;
  tile.EPSG = 32633;
  for (int k = 0; k < 3; ++k)
  {
    tile.GeoTransform = { 500000.0 + 40.0 * (k % 2), 10.0, 0.0, 5000060.0 - (k < 2 ? 0.0 : 30.0),
      0.0, -10.0 };
    tile.Values = Count(12, 100.0 * (k + 1));
    tile.Write((folder / ("tile" + std::to_string(k) + ".tif")).string());
  }
  std::ofstream(folder / "readme.txt") << "no tile";
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(folder.string());
  reader->Update();
  EXPECT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(reader->CanReadFile(folder.string().c_str()), 2);
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetDimensions()[0], 8);
  ASSERT_EQ(image->GetDimensions()[1], 6);
  EXPECT_EQ(Height(image, 0, 5), 100.0);
  EXPECT_EQ(Height(image, 7, 3), 211.0);
  EXPECT_EQ(Height(image, 3, 0), 311.0);
  vtkUnsignedCharArray* hidden = image->GetPointGhostArray();
  ASSERT_NE(hidden, nullptr);
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    const bool isGap = point % 8 >= 4 && point / 8 < 3;
    ASSERT_EQ(hidden->GetValue(point) == vtkDataSetAttributes::HIDDENPOINT, isGap) << point;
  }
}

TEST(TerrainRasterReaderTiles, BandsAreTimeSteps)
{
  RasterFile file;
  file.Width = 3;
  file.Height = 2;
  file.Bands = 3;
  file.Values = Count(18);
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(file.Write("bands-in-time.tif"));
  reader->Update();
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = reader->GetOutputInformation(0);
  EXPECT_FALSE(info->Has(Pipeline::TIME_STEPS()));
  reader->BandsAsTimeStepsOn();
  reader->UpdateInformation();
  ASSERT_EQ(info->Length(Pipeline::TIME_STEPS()), 3);
  EXPECT_EQ(info->Get(Pipeline::TIME_STEPS())[2], 3.0);
  for (const double time : { 3.0, 1.0, 2.0 })
  {
    reader->UpdateTimeStep(time);
    EXPECT_EQ(Height(reader->GetOutput(), 0, 1), 6.0 * (time - 1.0));
  }
  reader->UpdateTimeStep(99.0); // after the last one
  EXPECT_EQ(Height(reader->GetOutput(), 0, 1), 12.0);
}
