// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever cannot be read ends in one line that names the file and the reason, and an empty output.
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainTestRaster.h"

#include "raster/RasterFile.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <unistd.h>

using vtkTerrainTesting::RasterFile;
using vtkTerrainTesting::TemporaryFile;

namespace
{
class TerrainRasterReaderErrors : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Counter->SetClientData(&this->Errors);
    this->Counter->SetCallback(
      [](vtkObject*, unsigned long, void* errors, void*) { ++*static_cast<int*>(errors); });
    this->Reader->AddObserver(vtkCommand::ErrorEvent, this->Counter);
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->PipelineErrors);
  }

  // Reads, and expects an error whose line holds the file's name and the reason.
  void ExpectError(const std::string& path, const std::string& reason)
  {
    this->Reader->SetFileName(path);
    this->Reader->Modified();
    ::testing::internal::CaptureStderr();
    this->Reader->Update();
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    const std::string message = this->Reader->GetErrorMessage();
    EXPECT_NE(message.find("'" + path + "'"), std::string::npos) << message;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(this->Errors, 1) << message;
    EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 0);
    this->Errors = 0;
  }

  vtkNew<vtkTerrainRasterReader> Reader;
  int Errors = 0;
  vtkNew<vtkCallbackCommand> Counter;
  vtkNew<vtkTest::ErrorObserver> PipelineErrors; // keeps them from standard error
};

RasterFile MakeSquare(int size, GDALDataType type = GDT_Int16)
{
  RasterFile file;
  file.Width = size;
  file.Height = size;
  file.Type = type;
  file.Values.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 7.0);
  return file;
}

void WriteText(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}
}

TEST_F(TerrainRasterReaderErrors, NoFileName)
{
  this->ExpectError("", "no file name");
}

TEST_F(TerrainRasterReaderErrors, MissingFile)
{
  this->ExpectError(TemporaryFile("missing.tif"), "no such file");
}

// Hosts such as ParaView update again and again, whatever the last update said.
TEST_F(TerrainRasterReaderErrors, IsToldOnceUntilSomethingChanges)
{
  const std::string path = TemporaryFile("told-once.tif");
  std::filesystem::remove(path);
  this->ExpectError(path, "no such file"); // which sets the count back
  const auto countAfterUpdate = [this]
  {
    this->Reader->Modified();
    this->Reader->UpdateInformation();
    this->Reader->Update();
    return this->Errors;
  };
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(countAfterUpdate(), 0);
    EXPECT_NE(std::string(this->Reader->GetErrorMessage()).find("no such file"), std::string::npos);
    EXPECT_NE(this->Reader->GetErrorCode(), 0u);
  }
  WriteText(path, "no raster");
  EXPECT_EQ(countAfterUpdate(), 1);
  EXPECT_EQ(countAfterUpdate(), 1);
  MakeSquare(3).Write("told-once.tif");
  EXPECT_EQ(countAfterUpdate(), 1);
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 9);
  std::filesystem::remove(path);
  EXPECT_EQ(countAfterUpdate(), 2);
}

TEST_F(TerrainRasterReaderErrors, Directory)
{
  const std::string path = TemporaryFile("folder.tif");
  std::filesystem::create_directories(path);
  this->ExpectError(path, "directory");
}

// Places between which there are few numbers, so that no step leads from the first to the last.
TEST_F(TerrainRasterReaderErrors, PointsOfDenormalPlaces)
{
  const std::string path = TemporaryFile("denormal.xyz");
  std::string text;
  for (const char* x : { "4.94e-323", "0", "2e-323", "1e-323", "3e-323" })
  {
    text += std::string(x) + " 1 1\n" + x + " 0 2\n";
  }
  WriteText(path, text);
  this->Reader->SetFileName(path);
  this->Reader->Update();
  EXPECT_EQ(std::string(this->Reader->GetErrorMessage()), "");
  EXPECT_EQ(this->Reader->GetOutput()->GetDimensions()[0], 6);
}

TEST_F(TerrainRasterReaderErrors, DirectoryOfTilesThatDoNotFit)
{
  const std::filesystem::path folder = TemporaryFile("tiles-with-and-without-a-system");
  std::filesystem::create_directories(folder);
  RasterFile tile;
  tile.GeoTransform = { 0.0, 10.0, 0.0, 0.0, 0.0, -10.0 };
  for (const int epsg : { 32633, 0 })
  {
    tile.EPSG = epsg;
    tile.Write((folder / (std::to_string(epsg) + ".tif")).string());
  }
  this->ExpectError(folder.string(), "gdal_translate -a_srs");
}

TEST_F(TerrainRasterReaderErrors, FileWithoutPermission)
{
  constexpr uid_t kNobody = 65534;
  const std::string path = MakeSquare(2).Write("secret.tif");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  // Root may read everything.
  const uid_t user = geteuid();
  ASSERT_TRUE(user != 0 || seteuid(kNobody) == 0);
  this->ExpectError(path, "permission");
  ASSERT_TRUE(user != 0 || seteuid(user) == 0);
  std::filesystem::remove(path);
}

TEST_F(TerrainRasterReaderErrors, TextNamedTif)
{
  const std::string path = TemporaryFile("text.tif");
  WriteText(path, "These are no heights.\n");
  this->ExpectError(path, "not a raster that GDAL can open");
}

TEST_F(TerrainRasterReaderErrors, EmptyFile)
{
  const std::string path = TemporaryFile("empty.tif");
  WriteText(path, "");
  this->ExpectError(path, "empty");
}

TEST_F(TerrainRasterReaderErrors, TruncatedFile)
{
  for (const char* compression : { "COMPRESS=NONE", "COMPRESS=DEFLATE" })
  {
    RasterFile file = MakeSquare(200, GDT_Float32);
    file.Options = { compression };
    for (std::size_t k = 0; k < file.Values.size(); ++k)
    {
      file.Values[k] = static_cast<double>(k % 977);
    }
    const std::string path = file.Write("truncated.tif");
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    this->ExpectError(path, "cannot");
    this->Reader->SetMaximumSize(10);
    this->ExpectError(path, "cannot");
    this->Reader->SetMaximumSize(0);
  }
}

TEST_F(TerrainRasterReaderErrors, TruncatedTextGrid)
{
  const std::string path = TemporaryFile("truncated.asc");
  WriteText(path, "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n4 5\n");
  this->ExpectError(path, "cannot be read");
}

TEST_F(TerrainRasterReaderErrors, NoSuchBand)
{
  const std::string path = MakeSquare(2).Write("bands.tif");
  this->Reader->SetBand(2);
  this->ExpectError(path, "no band 2");
  this->Reader->SetBand(-1);
  this->ExpectError(path, "no band -1");
}

TEST_F(TerrainRasterReaderErrors, WindowOutside)
{
  const std::string path = MakeSquare(4).Write("outside.tif");
  const int windows[][4] = { { 0, 0, 5, 1 }, { 4, 0, 0, 0 }, { -1, 0, 2, 2 }, { 0, 3, 1, 2 },
    { 0, 0, -1, 1 }, { 2147483647, 0, 2147483647, 1 } };
  for (const auto& window : windows)
  {
    this->Reader->SetWindow(window[0], window[1], window[2], window[3]);
    this->ExpectError(path, "is not within its 4 x 4 pixels");
  }
}

TEST_F(TerrainRasterReaderErrors, RowsAlongColumns)
{
  RasterFile file = MakeSquare(4);
  file.GeoTransform = { 0.0, 10.0, 20.0, 0.0, 3.0, 6.0 };
  this->ExpectError(file.Write("flat.tif"), "its georeference is degenerate");
}

// Rows that leave the east by less than kShearTolerance cells over the raster are taken as they
// are; from there on they are resampled.
TEST_F(TerrainRasterReaderErrors, RowsThatDoNotQuiteRunEast)
{
  constexpr int size = 20;
  constexpr double cell = 10.0;
  for (const bool turned : { false, true })
  {
    for (const double part : { -0.99, 0.99, -1.01, 1.01 })
    {
      const double shear = part * terrain::kShearTolerance * cell / size;
      RasterFile file = MakeSquare(size);
      file.EPSG = 32631;
      file.GeoTransform = { 5e5, cell, turned ? 0.0 : shear, 5e6, turned ? shear : 0.0, -cell };
      this->Reader->SetFileName(file.Write("shear.tif"));
      this->Reader->Modified();
      this->Reader->Update();
      EXPECT_STREQ(this->Reader->GetErrorMessage(), "");
      auto* record = vtkStringArray::SafeDownCast(
        this->Reader->GetOutput()->GetFieldData()->GetAbstractArray("Record"));
      ASSERT_NE(record, nullptr);
      bool isResampled = false;
      for (vtkIdType i = 0; i < record->GetNumberOfValues(); ++i)
      {
        isResampled = isResampled || record->GetValue(i).find("resampled") != std::string::npos;
      }
      EXPECT_EQ(isResampled, std::abs(part) > 1.0) << part;
    }
  }
}

TEST_F(TerrainRasterReaderErrors, ColourImage)
{
  RasterFile file = MakeSquare(4, GDT_Byte);
  file.Bands = 3;
  file.Options = { "PHOTOMETRIC=RGB" };
  const std::string path = file.Write("colours.tif");
  this->ExpectError(path, "colour image of 3 bands");
  this->Reader->SetBand(1);
  this->Reader->Update();
  EXPECT_STREQ(this->Reader->GetErrorMessage(), "");
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 16);
}

TEST_F(TerrainRasterReaderErrors, ComplexSamples)
{
  this->ExpectError(MakeSquare(2, GDT_CFloat32).Write("complex.tif"), "complex");
}

TEST_F(TerrainRasterReaderErrors, DegreesThatAreNone)
{
  RasterFile file = MakeSquare(4);
  file.EPSG = 4326;
  file.GeoTransform = { 500000.0, 30.0, 0.0, 5200000.0, 0.0, -30.0 };
  this->ExpectError(file.Write("nodegrees.tif"), "degrees");
  file.GeoTransform = { -180.0, 400.0, 0.0, 80.0, 0.0, -1.0 };
  this->ExpectError(file.Write("widedegrees.tif"), "degrees");
}

TEST_F(TerrainRasterReaderErrors, MoreSamplesThanMemory)
{
  const std::string path = TemporaryFile("vast.vrt");
  WriteText(path,
    "<VRTDataset rasterXSize=\"2000000000\" rasterYSize=\"2000000000\">"
    "<VRTRasterBand dataType=\"Float64\" band=\"1\"/></VRTDataset>");
  this->ExpectError(path, "memory");
}

TEST_F(TerrainRasterReaderErrors, ReaderRecovers)
{
  this->ExpectError(TemporaryFile("missing.tif"), "no such file");
  this->Reader->SetFileName(MakeSquare(3).Write("recovers.tif"));
  this->Reader->Update();
  EXPECT_STREQ(this->Reader->GetErrorMessage(), "");
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 9);
}

TEST_F(TerrainRasterReaderErrors, CoordinateSystemInPlaceOfTheFiles)
{
  RasterFile file = MakeSquare(10);
  file.GeoTransform = { 7.0, 0.01, 0.0, 45.05, 0.0, -0.01 };
  for (const int named : { 0, 32632 })
  {
    file.EPSG = named;
    const std::string path = file.Write("renamed.tif");
    this->Reader->SetFileName(path);
    this->Reader->SetCoordinateSystem("EPSG:4326");
    this->Reader->Update();
    EXPECT_STREQ(this->Reader->GetErrorMessage(), "");
    EXPECT_STREQ(this->Reader->GetWarningMessage(), "");
    // metres of 0.01 degrees of longitude at 45 degrees
    EXPECT_NEAR(this->Reader->GetOutput()->GetSpacing()[0], 788.468351, 1e-5);
    this->Reader->SetCoordinateSystem("EPSG:99999999");
    this->ExpectError(path, "'EPSG:99999999' is not understood");
  }
}
