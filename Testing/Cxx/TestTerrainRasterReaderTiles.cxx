// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Several rasters as one terrain, and several bands as times.
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainTestRaster.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
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

/// An empty folder.
std::filesystem::path MakeFolder(const std::string& name)
{
  std::filesystem::path folder = TemporaryFile(name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

/// A tile with a coordinate system and so many samples, whose north-western corner lies so far east
/// and north of the first one's, in metres.
RasterFile MakeTile(int width, int height, double east, double north)
{
  RasterFile tile;
  tile.Width = width;
  tile.Height = height;
  tile.EPSG = 32633;
  tile.GeoTransform = { 500000.0 + east, 10.0, 0.0, 5000060.0 + north, 0.0, -10.0 };
  return tile;
}

std::string TilePath(const std::filesystem::path& folder, int number)
{
  return (folder / ("tile" + std::to_string(number) + ".tif")).string();
}

double Height(vtkImageData* image, int i, int j)
{
  return image->GetScalarComponentAsDouble(i, j, 0, 0);
}
}

TEST(TerrainRasterReaderTiles, DirectoryIsOneTerrain)
{
  // Three tiles of 4 x 3: two side by side, one below the first of them.
  const std::filesystem::path folder = MakeFolder("tiles");
  for (int k = 0; k < 3; ++k)
  {
    RasterFile tile = MakeTile(4, 3, 40.0 * (k % 2), k < 2 ? 0.0 : -30.0);
    tile.Values = Count(12, 100.0 * (k + 1));
    tile.Write(TilePath(folder, k));
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

TEST(TerrainRasterReaderTiles, HolesWithinTilesStayHoles)
{
  // The first tile declares nothing; the second has a value for no data, or a mask.
  for (const bool masked : { false, true })
  {
    const std::filesystem::path folder = MakeFolder(masked ? "masked-tiles" : "tiles-with-holes");
    for (int k = 0; k < 2; ++k)
    {
      RasterFile tile = MakeTile(2, 2, 20.0 * k, 0.0);
      tile.Values = { 5.0, 6.0, 7.0, k == 1 ? -9999.0 : 8.0 };
      GDALDatasetH dataset = tile.Create(TilePath(folder, k));
      if (k == 1 && !masked)
      {
        EXPECT_EQ(GDALSetRasterNoDataValue(GDALGetRasterBand(dataset, 1), -9999.0), CE_None);
      }
      if (k == 1 && masked)
      {
        EXPECT_EQ(GDALCreateDatasetMaskBand(dataset, GMF_PER_DATASET), CE_None);
        std::vector<unsigned char> mask{ 255, 255, 255, 0 };
        EXPECT_EQ(GDALRasterIO(GDALGetMaskBand(GDALGetRasterBand(dataset, 1)), GF_Write, 0, 0, 2, 2,
                    mask.data(), 2, 2, GDT_Byte, 0, 0),
          CE_None);
      }
      GDALClose(dataset);
    }
    vtkNew<vtkTerrainRasterReader> reader;
    reader->SetFileName(folder.string());
    reader->Update();
    EXPECT_STREQ(reader->GetErrorMessage(), "");
    vtkUnsignedCharArray* hidden = reader->GetOutput()->GetPointGhostArray();
    ASSERT_NE(hidden, nullptr);
    for (vtkIdType point = 0; point < 8; ++point)
    {
      EXPECT_EQ(hidden->GetValue(point) == vtkDataSetAttributes::HIDDENPOINT, point == 3)
        << masked << " " << point;
    }
  }
}

TEST(TerrainRasterReaderTiles, TimesMayHaveOtherTypesAndNames)
{
  RasterFile file;
  file.Width = 64;
  file.Height = 64;
  file.Bands = 3;
  file.Values = Count(std::size_t{ 3 } * 64 * 64);
  const std::string path = TemporaryFile("scaled-in-time.tif");
  GDALDatasetH dataset = file.Create(path);
  for (int k = 1; k <= 3; ++k)
  {
    GDALSetDescription(GDALGetRasterBand(dataset, k), std::to_string(2018 + k).c_str());
  }
  EXPECT_EQ(GDALSetRasterScale(GDALGetRasterBand(dataset, 2), 0.5), CE_None);
  EXPECT_EQ(
    GDALSetRasterColorInterpretation(GDALGetRasterBand(dataset, 3), GCI_AlphaBand), CE_None);
  GDALClose(dataset);
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(path);
  reader->BandsAsTimeStepsOn();
  reader->UpdateInformation();
  EXPECT_EQ(
    reader->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 2);
  reader->UpdateTimeStep(1.0);
  EXPECT_EQ(reader->GetOutput()->GetScalarType(), VTK_SHORT);
  reader->UpdateTimeStep(2.0);
  EXPECT_EQ(reader->GetOutput()->GetScalarType(), VTK_FLOAT);
  EXPECT_EQ(Height(reader->GetOutput(), 63, 0), 0.5 * (2 * 64 * 64 - 1));
  EXPECT_STREQ(reader->GetOutput()->GetPointData()->GetScalars()->GetName(), "Elevation");
}

TEST(TerrainRasterReaderTiles, FilesOfASeriesHaveOneSize)
{
  // What vtkFileSeriesReader does: the pipeline knows the first file, another one is read.
  RasterFile file;
  file.Width = 3;
  file.Height = 2;
  file.Values = Count(6);
  const std::string first = file.Write("first-in-time.tif");
  file.Type = GDT_Float64;
  const std::string second = file.Write("second-in-time.tif");
  file.Height = 1;
  file.Values = Count(3);
  const std::string third = file.Write("third-in-time.tif");
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(first);
  reader->UpdateInformation();
  vtkNew<vtkInformation> request;
  request->Set(vtkDemandDrivenPipeline::REQUEST_DATA());
  vtkNew<vtkInformationVector> outputs;
  vtkNew<vtkInformation> info;
  info->Copy(reader->GetOutputInformation(0));
  outputs->Append(info);
  vtkNew<vtkImageData> image;
  info->Set(vtkDataObject::DATA_OBJECT(), image);
  const int whole[6] = { 0, 2, 0, 1, 0, 0 };
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  reader->SetFileName(second);
  EXPECT_EQ(reader->ProcessRequest(request, nullptr, outputs), 1);
  EXPECT_EQ(image->GetScalarType(), VTK_DOUBLE);
  EXPECT_EQ(Height(image, 2, 0), 5.0);
  reader->SetFileName(third);
  vtkObject::GlobalWarningDisplayOff();
  EXPECT_EQ(reader->ProcessRequest(request, nullptr, outputs), 0);
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_NE(std::string(reader->GetErrorMessage()).find("3 x 1"), std::string::npos);
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
