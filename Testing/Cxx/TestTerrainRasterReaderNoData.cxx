// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Every way in which a file can say that a sample has no height, and files that say nothing.
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainTestRaster.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using vtkTerrainTesting::RasterFile;

namespace
{
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Heights of a file of one row; NaN where there is none, of whatever type.
std::vector<double> Heights(vtkTerrainRasterReader* reader)
{
  reader->Update();
  EXPECT_STREQ(reader->GetErrorMessage(), "");
  vtkImageData* image = reader->GetOutput();
  vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
  std::vector<double> heights;
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    const bool hidden =
      ghosts && (ghosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    heights.push_back(hidden ? kNaN : image->GetPointData()->GetScalars()->GetTuple1(point));
  }
  return heights;
}

void ExpectHeights(vtkTerrainRasterReader* reader, const std::vector<double>& expected)
{
  const std::vector<double> heights = Heights(reader);
  ASSERT_EQ(heights.size(), expected.size());
  for (std::size_t k = 0; k < heights.size(); ++k)
  {
    EXPECT_TRUE(heights[k] == expected[k] || (std::isnan(heights[k]) && std::isnan(expected[k])))
      << "sample " << k << ": " << heights[k] << " instead of " << expected[k];
  }
}

RasterFile MakeRow(GDALDataType type, const std::vector<double>& values)
{
  RasterFile file;
  file.Width = static_cast<int>(values.size());
  file.Type = type;
  file.Values = values;
  return file;
}

std::string WriteWithNoData(const RasterFile& file, const std::string& name, double noData)
{
  std::string path = vtkTerrainTesting::TemporaryFile(name);
  GDALDatasetH dataset = file.Create(path);
  EXPECT_EQ(GDALSetRasterNoDataValue(GDALGetRasterBand(dataset, 1), noData), CE_None);
  GDALClose(dataset);
  return path;
}

class TerrainRasterReaderNoData : public ::testing::Test
{
protected:
  void SetUp() override
  {
    vtkObject::GlobalWarningDisplayOff();
  }
  vtkNew<vtkTerrainRasterReader> Reader;
};
}

TEST_F(TerrainRasterReaderNoData, DeclaredValueHidesIntegers)
{
  this->Reader->SetFileName(
    WriteWithNoData(MakeRow(GDT_Int16, { 5, -99, 7, -32768 }), "declared.tif", -99));
  // What is declared is believed: the usual fill value is a height then.
  ExpectHeights(this->Reader, { 5, kNaN, 7, -32768 });
  EXPECT_STREQ(this->Reader->GetWarningMessage(), "");
}

// 0 lies neither between the heights of mountains nor between those of the sea floor.
TEST_F(TerrainRasterReaderNoData, HiddenIntegersAreInTheRangeOfTheHeights)
{
  const struct
  {
    GDALDataType Type;
    double Sign;
  } cases[] = { { GDT_Int16, 1.0 }, { GDT_Int16, -1.0 }, { GDT_UInt16, 1.0 }, { GDT_Byte, 1.0 },
    { GDT_Int32, -1.0 } };
  for (const auto& [type, sign] : cases)
  {
    this->Reader->SetFileName(
      WriteWithNoData(MakeRow(type, { 70 * sign, 1, 60 * sign, 1, 90 * sign }),
        "range" + std::to_string(type) + std::to_string(sign < 0.0) + ".tif", 1));
    ExpectHeights(this->Reader, { 70 * sign, kNaN, 60 * sign, kNaN, 90 * sign });
    double range[2];
    this->Reader->GetOutput()->GetScalarRange(range);
    EXPECT_EQ(range[0], std::min(60 * sign, 90 * sign)) << type;
    EXPECT_EQ(range[1], std::max(60 * sign, 90 * sign)) << type;
  }
}

TEST_F(TerrainRasterReaderNoData, IntegersBecomeNaNWhereFiltersAskForIt)
{
  const struct
  {
    GDALDataType Type;
    int Scalars;
    double Highest;
  } cases[] = { { GDT_Byte, VTK_FLOAT, 255 }, { GDT_Int16, VTK_FLOAT, 32767 },
    { GDT_UInt16, VTK_FLOAT, 65535 }, { GDT_Int32, VTK_DOUBLE, 2147483647 },
    { GDT_UInt32, VTK_DOUBLE, 4294967295 }, { GDT_Float32, VTK_FLOAT, 0.1F },
    { GDT_Float64, VTK_DOUBLE, 0.1 } };
  this->Reader->NoDataAsNaNOn();
  for (const auto& [type, scalars, highest] : cases)
  {
    this->Reader->SetFileName(WriteWithNoData(
      MakeRow(type, { 5, 1, highest }), "filters" + std::to_string(type) + ".tif", 1));
    ExpectHeights(this->Reader, { 5, kNaN, highest });
    vtkImageData* image = this->Reader->GetOutput();
    EXPECT_EQ(image->GetScalarType(), scalars) << type;
    EXPECT_EQ(image->GetPointGhostArray(), nullptr) << type;
  }
}

TEST_F(TerrainRasterReaderNoData, DeclaredValueBecomesNaN)
{
  this->Reader->SetFileName(
    WriteWithNoData(MakeRow(GDT_Float32, { 5, -99.1, 7 }), "declaredfloat.tif", -99.1));
  ExpectHeights(this->Reader, { 5, kNaN, 7 });
  EXPECT_EQ(this->Reader->GetOutput()->GetPointGhostArray(), nullptr);
}

TEST_F(TerrainRasterReaderNoData, NoHiddenPointNoGhostArray)
{
  this->Reader->SetFileName(WriteWithNoData(MakeRow(GDT_Int16, { 5, 6 }), "unused.tif", -32768));
  ExpectHeights(this->Reader, { 5, 6 });
  EXPECT_EQ(this->Reader->GetOutput()->GetPointGhostArray(), nullptr);
}

TEST_F(TerrainRasterReaderNoData, AllSamplesMayBeHidden)
{
  this->Reader->SetFileName(WriteWithNoData(MakeRow(GDT_Int16, { -1, -1, -1 }), "all.tif", -1));
  ExpectHeights(this->Reader, { kNaN, kNaN, kNaN });
}

TEST_F(TerrainRasterReaderNoData, ValueBeyondTheTypeHidesNothing)
{
  this->Reader->SetFileName(
    WriteWithNoData(MakeRow(GDT_UInt16, { 0, 65535, 55537 }), "beyond.tif", -9999));
  ExpectHeights(this->Reader, { 0, 65535, 55537 });
  this->Reader->SetFileName(
    WriteWithNoData(MakeRow(GDT_Byte, { 0, 255, 241 }), "beyond8.tif", -9999));
  ExpectHeights(this->Reader, { 0, 255, 241 });
}

TEST_F(TerrainRasterReaderNoData, NaNAndInfinityAreNoHeights)
{
  for (const GDALDataType type : { GDT_Float32, GDT_Float64 })
  {
    this->Reader->SetFileName(
      MakeRow(type, { 1, kNaN, kInfinity, -kInfinity, 2, -3.4028234663852886e38 })
        .Write("nan" + std::to_string(type) + ".tif"));
    ExpectHeights(this->Reader, { 1, kNaN, kNaN, kNaN, 2, kNaN });
  }
}

TEST_F(TerrainRasterReaderNoData, DeclaredNaNIsNoHeight)
{
  this->Reader->SetFileName(
    WriteWithNoData(MakeRow(GDT_Float32, { 1, kNaN, 2 }), "nannodata.tif", kNaN));
  ExpectHeights(this->Reader, { 1, kNaN, 2 });
}

TEST_F(TerrainRasterReaderNoData, UsualFillIsFoundUndeclared)
{
  this->Reader->SetFileName(
    MakeRow(GDT_Int16, { -32768, 3, -32767, -9999, -500, 0 }).Write("usual.tif"));
  ExpectHeights(this->Reader, { kNaN, 3, kNaN, kNaN, -500, 0 });
  const std::string warning = this->Reader->GetWarningMessage();
  EXPECT_NE(warning.find("usual.tif"), std::string::npos) << warning;
  EXPECT_NE(warning.find("does not declare"), std::string::npos) << warning;
  this->Reader->DetectNoDataOff();
  ExpectHeights(this->Reader, { -32768, 3, -32767, -9999, -500, 0 });
  EXPECT_STREQ(this->Reader->GetWarningMessage(), "");
}

TEST_F(TerrainRasterReaderNoData, TheDeepSeaMayHaveTheDepth)
{
  this->Reader->SetFileName(MakeRow(GDT_Float32, { -9500, -9999, -10200, 12 }).Write("trench.tif"));
  ExpectHeights(this->Reader, { -9500, -9999, -10200, 12 });
}

TEST_F(TerrainRasterReaderNoData, APersonCanNameTheValue)
{
  this->Reader->SetFileName(MakeRow(GDT_Int16, { 1, 0, 2, -32768 }).Write("named.tif"));
  this->Reader->SetNoDataValue(0);
  this->Reader->UseNoDataValueOn();
  ExpectHeights(this->Reader, { 1, kNaN, 2, -32768 });
}

TEST_F(TerrainRasterReaderNoData, MaskHides)
{
  RasterFile file = MakeRow(GDT_Int16, { 1, 2, 3 });
  const std::string path = vtkTerrainTesting::TemporaryFile("masked.tif");
  GDALDatasetH dataset = file.Create(path);
  ASSERT_EQ(GDALCreateDatasetMaskBand(dataset, GMF_PER_DATASET), CE_None);
  unsigned char mask[] = { 255, 0, 255 };
  ASSERT_EQ(GDALRasterIO(GDALGetMaskBand(GDALGetRasterBand(dataset, 1)), GF_Write, 0, 0, 3, 1, mask,
              3, 1, GDT_Byte, 0, 0),
    CE_None);
  GDALClose(dataset);
  this->Reader->SetFileName(path);
  ExpectHeights(this->Reader, { 1, kNaN, 3 });
}

TEST_F(TerrainRasterReaderNoData, AlphaHides)
{
  RasterFile file = MakeRow(GDT_UInt16, { 1, 2, 3, 65535, 0, 1 });
  file.Width = 3;
  file.Bands = 2;
  file.Options = { "ALPHA=YES" };
  this->Reader->SetFileName(file.Write("alpha.tif"));
  ExpectHeights(this->Reader, { 1, kNaN, 3 });
}

TEST_F(TerrainRasterReaderNoData, MeansLeaveOutWhatHasNoData)
{
  RasterFile file = MakeRow(GDT_Int16, { 10, 20, -1, -1, 30, -1, 40, -1, 40, -1, -1, -1 });
  file.Width = 6;
  file.Height = 2;
  this->Reader->SetFileName(WriteWithNoData(file, "means.tif", -1));
  this->Reader->SetMaximumSize(3);
  // Two of four samples are enough, one is not.
  ExpectHeights(this->Reader, { 70.0 / 3.0 - 1.0 / 3.0, kNaN, kNaN });
}

TEST_F(TerrainRasterReaderNoData, MeansLeaveOutUndeclaredFill)
{
  RasterFile file = MakeRow(GDT_Float32, { 10, -32767, 20, 30 });
  file.Width = 2;
  file.Height = 2;
  this->Reader->SetFileName(file.Write("fillmeans.tif"));
  this->Reader->SetMaximumSize(1);
  ExpectHeights(this->Reader, { 20 });
  EXPECT_NE(std::string(this->Reader->GetWarningMessage()), "");
}

TEST_F(TerrainRasterReaderNoData, OverviewsOfUndeclaredFillAreNotUsed)
{
  RasterFile file;
  file.Width = 32;
  file.Height = 32;
  file.Values.assign(1024, 100.0);
  for (std::size_t k = 0; k < 1024; k += 2)
  {
    file.Values[k] = -32767.0;
  }
  const std::string path = vtkTerrainTesting::TemporaryFile("filloverviews.tif");
  GDALDatasetH dataset = file.Create(path);
  int level = 4;
  ASSERT_EQ(
    GDALBuildOverviews(dataset, "AVERAGE", 1, &level, 0, nullptr, nullptr, nullptr), CE_None);
  GDALClose(dataset);
  this->Reader->SetFileName(path);
  this->Reader->SetMaximumSize(8);
  ExpectHeights(this->Reader, std::vector<double>(64, 100.0));
}
