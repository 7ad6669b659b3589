// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Types, registration, windows, reduction, pieces and abort, on generated rasters.
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainTestRaster.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

using vtkTerrainTesting::RasterFile;

namespace
{
// 0, 1, 2, ... row by row from the first row of the file.
std::vector<double> Count(int width, int height, double first = 0.0)
{
  std::vector<double> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (double& value : values)
  {
    value = first++;
  }
  return values;
}

vtkSmartPointer<vtkTerrainRasterReader> Read(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkTerrainRasterReader>::New();
  reader->SetFileName(path);
  reader->Update();
  EXPECT_STREQ(reader->GetErrorMessage(), "");
  return reader;
}

double Height(vtkImageData* image, int i, int j)
{
  return image->GetScalarComponentAsDouble(i, j, 0, 0);
}

double Number(vtkImageData* image, const char* array, int component = 0)
{
  vtkDataArray* numbers = image->GetFieldData()->GetArray(array);
  return numbers ? numbers->GetComponent(0, component) : std::numeric_limits<double>::quiet_NaN();
}

struct TypeCase
{
  GDALDataType File;
  int Scalars;
  double Lowest;
  double Highest;
};
}

TEST(TerrainRasterReader, KeepsTheTypeOfTheFile)
{
  const TypeCase cases[] = { { GDT_Byte, VTK_UNSIGNED_CHAR, 0, 255 },
    { GDT_UInt16, VTK_UNSIGNED_SHORT, 0, 65535 }, { GDT_Int16, VTK_SHORT, -32766, 32767 },
    { GDT_UInt32, VTK_UNSIGNED_INT, 0, 4294967295.0 },
    { GDT_Int32, VTK_INT, -2147483647.0, 2147483647.0 }, { GDT_Float32, VTK_FLOAT, -1e20, 0.5 },
    { GDT_Float64, VTK_DOUBLE, -1e20, 1.0 / 3.0 }, { GDT_Int64, VTK_DOUBLE, -1e12, 1e12 },
    { GDT_UInt64, VTK_DOUBLE, 0, 1e12 } };
  for (const TypeCase& type : cases)
  {
    RasterFile file;
    file.Width = 3;
    file.Height = 2;
    file.Type = type.File;
    file.Values = { 1, 2, 3, type.Lowest, type.Highest, 6 };
    const auto reader = Read(file.Write("types.tif"));
    vtkImageData* image = reader->GetOutput();
    vtkDataArray* heights = image->GetPointData()->GetScalars();
    ASSERT_NE(heights, nullptr);
    EXPECT_EQ(heights->GetDataType(), type.Scalars) << GDALGetDataTypeName(type.File);
    EXPECT_STREQ(heights->GetName(), "Elevation");
    // The last row of the file is the southernmost.
    const double tolerance = type.File == GDT_Float32 ? 1e-7 : 0.0;
    EXPECT_NEAR(Height(image, 0, 0), type.Lowest, tolerance * std::fabs(type.Lowest));
    EXPECT_NEAR(Height(image, 1, 0), type.Highest, tolerance * std::fabs(type.Highest));
    EXPECT_EQ(Height(image, 2, 0), 6);
    EXPECT_EQ(Height(image, 0, 1), 1);
    EXPECT_EQ(Height(image, 2, 1), 3);
    EXPECT_EQ(image->GetPointGhostArray(), nullptr);
  }
}

TEST(TerrainRasterReader, ReadsSignedBytes)
{
  RasterFile file;
  file.Width = 2;
  file.Height = 2;
  if (std::atoi(GDALVersionInfo("VERSION_NUM")) >= 3070000)
  {
    file.Type = static_cast<GDALDataType>(14); // GDT_Int8
    file.Values = { 1, 2, -1, -128 };
  }
  else
  {
    file.Type = GDT_Byte;
    file.Options = { "PIXELTYPE=SIGNEDBYTE" };
    file.Values = { 1, 2, 255, 128 };
  }
  const auto reader = Read(file.Write("signed.tif"));
  EXPECT_EQ(reader->GetOutput()->GetScalarType(), VTK_SIGNED_CHAR);
  EXPECT_EQ(Height(reader->GetOutput(), 0, 0), -1);
  EXPECT_EQ(Height(reader->GetOutput(), 1, 0), -128);
  reader->SetMaximumSize(1);
  reader->Update();
  EXPECT_EQ(Height(reader->GetOutput(), 0, 0), std::floor((1 + 2 - 1 - 128) / 4.0 + 0.5));
}

TEST(TerrainRasterReader, SamplesLieAtPixelCentresOfAreas)
{
  RasterFile file;
  file.Width = 4;
  file.Height = 3;
  file.EPSG = 32633;
  file.GeoTransform = { 500000.0, 25.0, 0.0, 5200000.0, 0.0, -10.0 };
  file.Values = Count(4, 3);
  const auto reader = Read(file.Write("area.tif"));
  vtkImageData* image = reader->GetOutput();
  EXPECT_NEAR(image->GetOrigin()[0], 500012.5, 25e-6);
  EXPECT_NEAR(image->GetOrigin()[1], 5200000.0 - 25.0, 10e-6);
  EXPECT_EQ(image->GetOrigin()[2], 0.0);
  EXPECT_NEAR(image->GetSpacing()[0], 25.0, 25e-6);
  EXPECT_NEAR(image->GetSpacing()[1], 10.0, 10e-6);
}

TEST(TerrainRasterReader, SamplesOfPointsLieAtTheirPoints)
{
  RasterFile file;
  file.Width = 4;
  file.Height = 3;
  file.EPSG = 32633;
  file.GeoTransform = { 500000.0, 25.0, 0.0, 5200000.0, 0.0, -10.0 };
  file.Values = Count(4, 3);
  const std::string path = vtkTerrainTesting::TemporaryFile("point.tif");
  GDALDatasetH dataset = file.Create(path);
  GDALSetMetadataItem(dataset, "AREA_OR_POINT", "Point", nullptr);
  GDALClose(dataset);
  const auto reader = Read(path);
  // The tie point in the file is the sample itself: GDAL has moved it by half a cell on writing,
  // and back on reading.
  EXPECT_NEAR(reader->GetOutput()->GetOrigin()[0], 500012.5, 25e-6);
  EXPECT_NEAR(reader->GetOutput()->GetOrigin()[1], 5200000.0 - 25.0, 10e-6);
}

TEST(TerrainRasterReader, GridOfNodesLiesAtItsNodes)
{
  // ESRI ASCII grids give the corner of the first cell, or its centre.
  const std::string path = vtkTerrainTesting::TemporaryFile("nodes.asc");
  FILE* file = std::fopen(path.c_str(), "w");
  ASSERT_NE(file, nullptr);
  std::fputs("ncols 2\nnrows 2\nxllcenter 1000\nyllcenter 2000\ncellsize 50\n1 2\n3 4\n", file);
  std::fclose(file);
  const auto reader = Read(path);
  vtkImageData* image = reader->GetOutput();
  EXPECT_NEAR(image->GetOrigin()[0], 1000.0, 50e-6);
  EXPECT_NEAR(image->GetOrigin()[1], 2000.0, 50e-6);
  EXPECT_EQ(Height(image, 0, 0), 3);
  EXPECT_EQ(Height(image, 1, 1), 2);
}

TEST(TerrainRasterReader, BottomUpFileIsNotFlipped)
{
  RasterFile file;
  file.Width = 2;
  file.Height = 3;
  file.EPSG = 32633;
  file.GeoTransform = { 500000.0, 10.0, 0.0, 5200000.0, 0.0, 10.0 };
  file.Values = Count(2, 3);
  const auto reader = Read(file.Write("bottomup.tif"));
  vtkImageData* image = reader->GetOutput();
  EXPECT_NEAR(image->GetOrigin()[1], 5200005.0, 1e-5);
  EXPECT_EQ(Height(image, 0, 0), 0);
  EXPECT_EQ(Height(image, 1, 2), 5);
}

TEST(TerrainRasterReader, EastFirstFileIsMirrored)
{
  RasterFile file;
  file.Width = 3;
  file.Height = 2;
  file.EPSG = 32633;
  file.GeoTransform = { 500000.0, -10.0, 0.0, 5200000.0, 0.0, -10.0 };
  file.Values = Count(3, 2);
  const auto reader = Read(file.Write("eastfirst.tif"));
  vtkImageData* image = reader->GetOutput();
  EXPECT_NEAR(image->GetOrigin()[0], 499975.0, 1e-5);
  EXPECT_EQ(Height(image, 0, 0), 5);
  EXPECT_EQ(Height(image, 2, 1), 0);
}

TEST(TerrainRasterReader, DegreesAreLaidOutAtTheCentreLatitude)
{
  RasterFile file;
  file.Width = 10;
  file.Height = 20;
  file.EPSG = 4326;
  file.GeoTransform = { 7.0, 0.01, 0.0, 45.1, 0.0, -0.01 };
  file.Values = Count(10, 20);
  const auto reader = Read(file.Write("degrees.tif"));
  vtkImageData* image = reader->GetOutput();
  // Metres of a degree of longitude and of latitude at 45 degrees on WGS 84.
  EXPECT_NEAR(image->GetSpacing()[0], 788.468351, 1e-5);
  EXPECT_NEAR(image->GetSpacing()[1], 1111.317778, 1e-5);
  EXPECT_NEAR(image->GetOrigin()[0], -4.5 * image->GetSpacing()[0], 1e-6);
  EXPECT_NEAR(image->GetOrigin()[1], -9.5 * image->GetSpacing()[1], 1e-6);
  EXPECT_NEAR(Number(image, "LayoutOrigin", 0), 7.05, 1e-12);
  EXPECT_NEAR(Number(image, "LayoutOrigin", 1), 45.0, 1e-12);
}

TEST(TerrainRasterReader, FeetBecomeMetres)
{
  RasterFile file;
  file.Width = 2;
  file.Height = 2;
  file.EPSG = 2225; // California zone 1, US survey feet
  file.GeoTransform = { 6000000.0, 3.0, 0.0, 2000000.0, 0.0, -3.0 };
  file.Values = { 10, 20, 30, 40 };
  const std::string path = vtkTerrainTesting::TemporaryFile("feet.tif");
  GDALDatasetH dataset = file.Create(path);
  GDALSetRasterUnitType(GDALGetRasterBand(dataset, 1), "US survey foot");
  GDALClose(dataset);
  const auto reader = Read(path);
  vtkImageData* image = reader->GetOutput();
  const double foot = 1200.0 / 3937.0;
  EXPECT_NEAR(image->GetSpacing()[0], 3.0 * foot, 1e-9);
  EXPECT_NEAR(image->GetOrigin()[0], 6000001.5 * foot, 1e-6);
  EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
  EXPECT_NEAR(Height(image, 1, 1), 20.0 * foot, 1e-6);
  EXPECT_NEAR(Number(image, "VerticalScale"), foot, 1e-15);
}

TEST(TerrainRasterReader, NoGeoreferenceGivesPixels)
{
  RasterFile file;
  file.Width = 5;
  file.Height = 4;
  file.Values = Count(5, 4);
  const auto reader = Read(file.Write("plain.tif"));
  vtkImageData* image = reader->GetOutput();
  EXPECT_EQ(image->GetOrigin()[0], 0.0);
  EXPECT_EQ(image->GetOrigin()[1], 0.0);
  EXPECT_EQ(image->GetSpacing()[0], 1.0);
  EXPECT_EQ(image->GetSpacing()[1], 1.0);
  EXPECT_EQ(Height(image, 0, 0), 15);
  reader->SetWindow(1, 0, 2, 3);
  reader->Update();
  EXPECT_EQ(image->GetOrigin()[0], 1.0);
  EXPECT_EQ(image->GetOrigin()[1], 1.0);
  EXPECT_EQ(Height(image, 0, 0), 11);
}

TEST(TerrainRasterReader, ScaleAndOffsetAreApplied)
{
  RasterFile file;
  file.Width = 2;
  file.Height = 1;
  file.Values = { 100, -5 };
  const std::string path = vtkTerrainTesting::TemporaryFile("scaled.tif");
  GDALDatasetH dataset = file.Create(path);
  GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  GDALSetRasterScale(band, 0.25);
  GDALSetRasterOffset(band, 1000.0);
  GDALSetRasterNoDataValue(band, -5.0);
  GDALSetDescription(band, "ground");
  GDALClose(dataset);
  const auto reader = Read(path);
  vtkImageData* image = reader->GetOutput();
  EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
  EXPECT_EQ(Height(image, 0, 0), 1025.0);
  EXPECT_TRUE(std::isnan(Height(image, 1, 0)));
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "ground");
}

TEST(TerrainRasterReader, DegenerateSizesAreLegal)
{
  const int sizes[][2] = { { 1, 1 }, { 1, 7 }, { 7, 1 }, { 2, 2 } };
  for (const auto& size : sizes)
  {
    RasterFile file;
    file.Width = size[0];
    file.Height = size[1];
    file.Values = Count(size[0], size[1], 5.0);
    const auto reader = Read(file.Write("small.tif"));
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), size[0] * size[1]);
    EXPECT_EQ(Height(reader->GetOutput(), 0, size[1] - 1), 5.0);
    reader->SetMaximumSize(1);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 1);
    reader->SetMaximumSize(0);
    reader->SetMaximumNumberOfSamples(2);
    reader->Update();
    EXPECT_LE(reader->GetOutput()->GetNumberOfPoints(), 2);
    EXPECT_GE(reader->GetOutput()->GetNumberOfPoints(), 1);
  }
}

TEST(TerrainRasterReader, WindowCutsOutAPart)
{
  RasterFile file;
  file.Width = 6;
  file.Height = 5;
  file.EPSG = 32633;
  file.GeoTransform = { 500000.0, 10.0, 0.0, 5200000.0, 0.0, -10.0 };
  file.Values = Count(6, 5);
  const auto reader = Read(file.Write("window.tif"));
  reader->SetWindow(2, 1, 3, 2);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetDimensions()[0], 3);
  ASSERT_EQ(image->GetDimensions()[1], 2);
  EXPECT_EQ(Height(image, 0, 1), 8);
  EXPECT_EQ(Height(image, 2, 0), 16);
  EXPECT_NEAR(image->GetOrigin()[0], 500025.0, 1e-5);
  EXPECT_NEAR(image->GetOrigin()[1], 5200000.0 - 25.0, 1e-5);
  EXPECT_EQ(Number(image, "RasterWindow", 2), 3);
  reader->SetWindow(4, 3, 0, 0);
  reader->Update();
  EXPECT_EQ(image->GetDimensions()[0], 2);
  EXPECT_EQ(image->GetDimensions()[1], 2);
}

TEST(TerrainRasterReader, ReducedSamplesAreMeansOfTheirArea)
{
  RasterFile file;
  file.Width = 7;
  file.Height = 5;
  file.Type = GDT_Float64;
  file.EPSG = 32633;
  file.GeoTransform = { 500000.0, 10.0, 0.0, 5200000.0, 0.0, -10.0 };
  file.Values = Count(7, 5);
  const auto reader = Read(file.Write("reduced.tif"));
  reader->SetMaximumSize(3);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetDimensions()[0], 3);
  ASSERT_EQ(image->GetDimensions()[1], 2);
  EXPECT_NEAR(image->GetSpacing()[0], 70.0 / 3.0, 1e-9);
  EXPECT_NEAR(image->GetOrigin()[0], 500000.0 + 35.0 / 3.0, 1e-6);
  EXPECT_NEAR(image->GetOrigin()[1], 5200000.0 - 50.0 + 12.5, 1e-6);
  // A plane's mean over an area is its value at the centre: column x - 0.5, row y - 0.5.
  for (int j = 0; j < 2; ++j)
  {
    for (int i = 0; i < 3; ++i)
    {
      // The plane is constant over each pixel; means over parts of pixels weigh them by area.
      double sum = 0.0;
      for (int row = 0; row < 5; ++row)
      {
        for (int column = 0; column < 7; ++column)
        {
          const auto overlap = [](double a, double b, int pixel)
          { return std::max(0.0, std::min(b, pixel + 1.0) - std::max(a, pixel + 0.0)); };
          const double area = overlap(i * 7.0 / 3.0, (i + 1) * 7.0 / 3.0, column) *
            overlap((1 - j) * 2.5, (2 - j) * 2.5, row);
          sum += area * (column + 7 * row);
        }
      }
      EXPECT_NEAR(Height(image, i, j), sum / (7.0 / 3.0 * 2.5), 1e-9);
    }
  }
}

TEST(TerrainRasterReader, OverviewsAreUsedWhereTheyAreFineEnough)
{
  RasterFile file;
  file.Width = 64;
  file.Height = 64;
  file.Values.assign(4096, 10.0);
  const std::string path = vtkTerrainTesting::TemporaryFile("overviews.tif");
  GDALDatasetH dataset = file.Create(path);
  int levels[] = { 2, 4 };
  ASSERT_EQ(
    GDALBuildOverviews(dataset, "NEAREST", 2, levels, 0, nullptr, nullptr, nullptr), CE_None);
  // So that it shows which one is used.
  std::vector<double> marks(1024, 20.0);
  for (int k = 0; k < 2; ++k)
  {
    GDALRasterBandH overview = GDALGetOverview(GDALGetRasterBand(dataset, 1), k);
    const int size = GDALGetRasterBandXSize(overview);
    std::fill(marks.begin(), marks.end(), size == 32 ? 20.0 : 30.0);
    ASSERT_EQ(GDALRasterIO(
                overview, GF_Write, 0, 0, size, size, marks.data(), size, size, GDT_Float64, 0, 0),
      CE_None);
  }
  GDALClose(dataset);
  const auto reader = Read(path);
  const int sizes[][2] = { { 64, 10 }, { 40, 10 }, { 32, 20 }, { 17, 20 }, { 16, 30 }, { 5, 30 } };
  for (const auto& size : sizes)
  {
    reader->SetMaximumSize(size[0]);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], size[0]);
    EXPECT_EQ(Height(reader->GetOutput(), 0, 0), size[1]) << size[0];
  }
}

TEST(TerrainRasterReader, PiecesEqualTheWhole)
{
  RasterFile file;
  file.Width = 53;
  file.Height = 41;
  file.EPSG = 32633;
  file.Values = Count(53, 41);
  file.Values[100] = -1.0;
  for (const double step : { -10.0, 10.0 })
  {
    for (const int maximum : { 0, 19 })
    {
      file.GeoTransform = { 500000.0, step, 0.0, 5200000.0, 0.0, -step };
      const std::string path = file.Write("pieces.tif");
      const auto whole = vtkSmartPointer<vtkTerrainRasterReader>::New();
      whole->SetFileName(path);
      whole->SetWindow(1, 2, 51, 38);
      whole->SetMaximumSize(maximum);
      whole->Update();
      vtkImageData* expected = whole->GetOutput();
      const int* dims = expected->GetDimensions();
      const auto part = vtkSmartPointer<vtkTerrainRasterReader>::New();
      part->SetFileName(path);
      part->SetWindow(1, 2, 51, 38);
      part->SetMaximumSize(maximum);
      int extent[6] = { 3, dims[0] - 2, dims[1] / 2, dims[1] - 1, 0, 0 };
      part->UpdateExtent(extent);
      vtkImageData* piece = part->GetOutput();
      ASSERT_EQ(piece->GetExtent()[0], extent[0]);
      ASSERT_EQ(piece->GetExtent()[3], extent[3]);
      EXPECT_EQ(piece->GetOrigin()[0], expected->GetOrigin()[0]);
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        for (int i = extent[0]; i <= extent[1]; ++i)
        {
          ASSERT_EQ(Height(piece, i, j), Height(expected, i, j));
        }
      }
    }
  }
}

TEST(TerrainRasterReader, PiecesHaveGhostsAndKeepHiddenPoints)
{
  RasterFile file;
  file.Width = 20;
  file.Height = 20;
  file.Values.assign(400, 5.0);
  file.Values[7] = -32768.0;
  file.Values[399] = -32768.0;
  const std::string path = vtkTerrainTesting::TemporaryFile("ghosts.tif");
  GDALDatasetH dataset = file.Create(path);
  GDALSetRasterNoDataValue(GDALGetRasterBand(dataset, 1), -32768.0);
  GDALClose(dataset);
  int hidden = 0;
  int owned = 0;
  for (int piece = 0; piece < 4; ++piece)
  {
    vtkNew<vtkTerrainRasterReader> reader;
    reader->SetFileName(path);
    reader->UpdatePiece(piece, 4, 1);
    vtkImageData* image = reader->GetOutput();
    vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
    ASSERT_NE(ghosts, nullptr);
    EXPECT_LT(image->GetNumberOfPoints(), 200);
    for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
    {
      const unsigned char mark = ghosts->GetValue(point);
      hidden += (mark & vtkDataSetAttributes::HIDDENPOINT) ? 1 : 0;
      owned += (mark & vtkDataSetAttributes::DUPLICATEPOINT) ? 0 : 1;
    }
  }
  EXPECT_EQ(hidden, 2);
  // The pipeline splits cells: pieces share the samples on their borders.
  EXPECT_EQ(owned, 21 * 21);
}

TEST(TerrainRasterReader, PieceWithoutDataIsLegal)
{
  RasterFile file;
  file.Values = { 3 };
  const std::string path = file.Write("onepoint.tif");
  for (int piece = 0; piece < 8; ++piece)
  {
    vtkNew<vtkTerrainRasterReader> reader;
    reader->SetFileName(path);
    reader->UpdatePiece(piece, 8, 0);
    EXPECT_STREQ(reader->GetErrorMessage(), "");
    EXPECT_LE(reader->GetOutput()->GetNumberOfPoints(), 1);
  }
}

TEST(TerrainRasterReader, AbortLeavesNoHalfOutput)
{
  RasterFile file;
  file.Width = 3000;
  file.Height = 3000;
  file.Type = GDT_Byte;
  file.Values.assign(9000000, 1.0);
  const std::string path = file.Write("abort.tif");
  for (const int maximum : { 0, 1000 })
  {
    vtkNew<vtkTerrainRasterReader> reader;
    reader->SetFileName(path);
    reader->SetMaximumSize(maximum);
    vtkNew<vtkCallbackCommand> abort;
    double last = 0.0;
    abort->SetClientData(&last);
    abort->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto* algorithm = static_cast<vtkAlgorithm*>(caller);
        *static_cast<double*>(data) = algorithm->GetProgress();
        algorithm->SetAbortExecute(algorithm->GetProgress() > 0.3 ? 1 : 0);
      });
    reader->AddObserver(vtkCommand::ProgressEvent, abort);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_STREQ(reader->GetErrorMessage(), "");
    EXPECT_GT(last, 0.3);
  }
}

TEST(TerrainRasterReader, HugeRasterHasItsExtent)
{
  RasterFile file;
  file.Width = 100000;
  file.Height = 90000;
  file.Type = GDT_Byte;
  file.Options = { "SPARSE_OK=TRUE", "TILED=YES", "BIGTIFF=YES", "COMPRESS=LZW" };
  const std::string path = vtkTerrainTesting::TemporaryFile("huge.tif");
  GDALDatasetH dataset = file.Create(path);
  unsigned char mark = 77;
  ASSERT_EQ(GDALRasterIO(GDALGetRasterBand(dataset, 1), GF_Write, 99999, 89999, 1, 1, &mark, 1, 1,
              GDT_Byte, 0, 0),
    CE_None);
  GDALClose(dataset);
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(path);
  int extent[6] = { 99990, 99999, 0, 9, 0, 0 };
  reader->UpdateExtent(extent);
  EXPECT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(Height(reader->GetOutput(), 99999, 0), 77);
  EXPECT_EQ(Height(reader->GetOutput(), 99998, 1), 0);
}

TEST(TerrainRasterReader, FieldDataTellWhatIsKnown)
{
  RasterFile file;
  file.Width = 3;
  file.Height = 2;
  file.EPSG = 32719;
  file.GeoTransform = { 400000.0, 90.0, 0.0, 7000000.0, 0.0, -90.0 };
  file.Values = Count(3, 2);
  const std::string path = file.Write("fields.tif");
  const auto reader = Read(path);
  vtkFieldData* fields = reader->GetOutput()->GetFieldData();
  auto* name = vtkStringArray::SafeDownCast(fields->GetAbstractArray("FileName"));
  ASSERT_NE(name, nullptr);
  EXPECT_EQ(name->GetValue(0), path);
  auto* crs = vtkStringArray::SafeDownCast(fields->GetAbstractArray("CRS"));
  ASSERT_NE(crs, nullptr);
  EXPECT_EQ(crs->GetValue(0).rfind("PROJCRS[\"WGS 84 / UTM zone 19S\"", 0), 0U);
  const double transform[6] = { 400000.0, 90.0, 0.0, 7000000.0, 0.0, -90.0 };
  for (int k = 0; k < 6; ++k)
  {
    EXPECT_EQ(Number(reader->GetOutput(), "GeoTransform", k), transform[k]);
  }
  EXPECT_EQ(Number(reader->GetOutput(), "RasterSize", 0), 3);
  EXPECT_EQ(Number(reader->GetOutput(), "RasterSize", 1), 2);
  EXPECT_EQ(fields->GetAbstractArray("VerticalUnit"), nullptr);
}

TEST(TerrainRasterReader, TellsWhatItCanRead)
{
  RasterFile file;
  file.Values = { 1 };
  vtkNew<vtkTerrainRasterReader> reader;
  EXPECT_NE(reader->CanReadFile(file.Write("can.tif").c_str()), 0);
  EXPECT_EQ(reader->CanReadFile("/no/such/file.tif"), 0);
  EXPECT_EQ(reader->CanReadFile(nullptr), 0);
  EXPECT_NE(std::string(reader->GetFileExtensions()).find(".tif"), std::string::npos);
}
