// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Real files of many producers, against what is known of them.
#include "vtkTerrainRasterReader.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <ostream>
#include <string>

namespace
{
struct Fact
{
  const char* File;
  int Columns;
  int Rows;
  int Type;
  double Lowest;
  double Highest;
  vtkIdType Voids;
  const char* CRS;   // a part of its name in the WKT
  double Origin[2];  // the south-western sample, in the CRS
  double Spacing[2]; // in the CRS
  bool Undeclared;   // voids are fill that the file does not declare
};

constexpr double kThird = 1.0 / 1200.0; // three seconds of arc

const Fact kFacts[] = {
  { "SainteHelens.dem", 327, 468, VTK_SHORT, 682, 2543, 4151, "Clarke 1866", { 557820, 5107980 },
    { 30, 30 }, false },
  { "aconcagua_srtm3_u16.png", 1201, 1201, VTK_UNSIGNED_SHORT, 250, 6929, 0, "WGS 84", { -71, -33 },
    { kThird, kThird }, false },
  { "S33E018.hgt", 1201, 1201, VTK_SHORT, -9, 1446, 278, "WGS 84", { 18, -33 }, { kThird, kThird },
    false },
  { "S34E018.hgt", 1201, 1201, VTK_SHORT, -25, 1488, 1568, "WGS 84", { 18, -34 },
    { kThird, kThird }, false },
  { "everest_srtm3_voids.tif", 1201, 1201, VTK_SHORT, 192, 8642, 130953, "WGS 84", { 86, 27 },
    { kThird, kThird }, false },
  { "craterlake_elev_30m.tif", 429, 279, VTK_SHORT, 1289, 1880, 39489, "WGS 84",
    { -122.165582686187904 + 0.5 * 0.000269965978544,
      42.979451627831743 - 278.5 * 0.000269965978544 },
    { 0.000269965978544, 0.000269965978544 }, true },
  { "bigtujunga_srtm1_utm11.tif", 1197, 643, VTK_SHORT, 315, 2295, 0, "UTM zone 11N",
    { 376328.655454263498541, 3807917.827628375496715 - 642.5 * 30 }, { 30, 30 }, false },
  { "greenriver_lidar_1m_utm12_f32.tif", 2000, 1000, VTK_FLOAT, 1297.29, 1347.03, 0, "UTM zone 12N",
    { 561000.5, 4304000.5 }, { 1, 1 }, false },
  { "monterey_topobathy_f32.tif", 540, 540, VTK_FLOAT, -2805.53, 1515.89, 0, "WGS 84",
    { -122.366765000000001 + 0.5 / 540, 37.179392 - 539.5 / 540 }, { 1.0 / 540, 1.0 / 540 },
    false },
  { "globe_g_8192x5120_i16.tif", 8192, 5120, VTK_SHORT, 0, 8311, 0, "WGS 84",
    { 10.866666666666667 + 0.5 / 120, 50 - 5119.5 / 120 }, { 1.0 / 120, 1.0 / 120 }, false },
};

void PrintTo(const Fact& fact, std::ostream* stream)
{
  *stream << fact.File;
}

std::string DataDirectory()
{
  const char* directory = std::getenv("VTKTERRAIN_DATA_DIR");
  return directory ? directory : "";
}

bool IsNone(vtkImageData* image, vtkIdType point)
{
  vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
  return (ghosts && (ghosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT)) ||
    std::isnan(image->GetPointData()->GetScalars()->GetTuple1(point));
}

double Number(vtkImageData* image, const char* array, int component)
{
  vtkDataArray* numbers = image->GetFieldData()->GetArray(array);
  return numbers ? numbers->GetComponent(0, component) : std::numeric_limits<double>::quiet_NaN();
}

class RasterReaderData : public ::testing::TestWithParam<Fact>
{
protected:
  void SetUp() override
  {
    if (DataDirectory().empty())
    {
      GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set";
    }
    vtkObject::GlobalWarningDisplayOff();
  }
};
}

TEST_P(RasterReaderData, IsReadAsItIs)
{
  const Fact& fact = GetParam();
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(DataDirectory() + "/" + fact.File);
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  vtkImageData* image = reader->GetOutput();
  EXPECT_EQ(image->GetDimensions()[0], fact.Columns);
  EXPECT_EQ(image->GetDimensions()[1], fact.Rows);
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  ASSERT_EQ(heights->GetDataType(), fact.Type);
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  vtkIdType voids = 0;
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    if (IsNone(image, point))
    {
      ++voids;
      continue;
    }
    const double height = heights->GetTuple1(point);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  EXPECT_NEAR(lowest, fact.Lowest, 0.005);
  EXPECT_NEAR(highest, fact.Highest, 0.005);
  EXPECT_EQ(voids, fact.Voids);
  EXPECT_EQ(std::string(reader->GetWarningMessage()).empty(), !fact.Undeclared);
}

TEST_P(RasterReaderData, LiesWhereItIs)
{
  const Fact& fact = GetParam();
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(DataDirectory() + "/" + fact.File);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  vtkStringArray* crs =
    vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("CRS"));
  ASSERT_NE(crs, nullptr);
  EXPECT_NE(crs->GetValue(0).find(fact.CRS), std::string::npos) << crs->GetValue(0);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double scale = Number(image, "LayoutScale", axis);
    const double spacing = image->GetSpacing()[axis] / scale;
    const double origin = Number(image, "LayoutOrigin", axis) + image->GetOrigin()[axis] / scale;
    EXPECT_NEAR(spacing, fact.Spacing[axis], 1e-9 * fact.Spacing[axis]);
    EXPECT_NEAR(origin, fact.Origin[axis], 1e-6 * fact.Spacing[axis]);
  }
}

INSTANTIATE_TEST_SUITE_P(AllFiles, RasterReaderData, ::testing::ValuesIn(kFacts),
  [](const ::testing::TestParamInfo<Fact>& fact)
  {
    std::string name = fact.param.File;
    for (char& c : name)
    {
      if (!std::isalnum(static_cast<unsigned char>(c)))
      {
        c = '_';
      }
    }
    return name;
  });

TEST(RasterReaderNeighbours, CapeTilesShareARow)
{
  if (DataDirectory().empty())
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set";
  }
  vtkNew<vtkTerrainRasterReader> north;
  north->SetFileName(DataDirectory() + "/S33E018.hgt");
  north->Update();
  vtkNew<vtkTerrainRasterReader> south;
  south->SetFileName(DataDirectory() + "/S34E018.hgt");
  south->Update();
  vtkImageData* upper = north->GetOutput();
  vtkImageData* lower = south->GetOutput();
  for (int i = 0; i < 1201; ++i)
  {
    ASSERT_EQ(upper->GetScalarComponentAsDouble(i, 0, 0, 0),
      lower->GetScalarComponentAsDouble(i, 1200, 0, 0));
  }
  // The same latitude in the CRS.
  const double upperSouth =
    Number(upper, "LayoutOrigin", 1) + upper->GetBounds()[2] / Number(upper, "LayoutScale", 1);
  const double lowerNorth =
    Number(lower, "LayoutOrigin", 1) + lower->GetBounds()[3] / Number(lower, "LayoutScale", 1);
  EXPECT_NEAR(upperSouth, lowerNorth, 1e-6 * kThird);
}

TEST(RasterReaderImages, ColourImagesAreRefusedUnlessABandIsChosen)
{
  if (DataDirectory().empty())
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set";
  }
  vtkObject::GlobalWarningDisplayOff();
  for (const char* name : { "everest_landsat7_rgb_utm45.tif", "craterlake_imagery_30m.tif" })
  {
    vtkNew<vtkTerrainRasterReader> reader;
    reader->SetFileName(DataDirectory() + "/" + name);
    reader->Update();
    EXPECT_NE(std::string(reader->GetErrorMessage()).find("colour image"), std::string::npos);
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
    reader->SetBand(2);
    reader->Update();
    EXPECT_STREQ(reader->GetErrorMessage(), "");
    EXPECT_GT(reader->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(RasterReaderImages, AlphaHidesWhatTheElevationsLack)
{
  if (DataDirectory().empty())
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set";
  }
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkTerrainRasterReader> heights;
  heights->SetFileName(DataDirectory() + "/craterlake_elev_30m.tif");
  heights->Update();
  vtkNew<vtkTerrainRasterReader> colors;
  colors->SetFileName(DataDirectory() + "/craterlake_imagery_30m.tif");
  colors->SetBand(1);
  colors->Update();
  ASSERT_EQ(colors->GetOutput()->GetNumberOfPoints(), 429 * 279);
  for (vtkIdType point = 0; point < heights->GetOutput()->GetNumberOfPoints(); ++point)
  {
    ASSERT_EQ(IsNone(heights->GetOutput(), point), IsNone(colors->GetOutput(), point)) << point;
  }
}

TEST(RasterReaderReduced, LargeFileFitsTheLimits)
{
  if (DataDirectory().empty())
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set";
  }
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(DataDirectory() + "/globe_g_8192x5120_i16.tif");
  reader->SetMaximumSize(512);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  EXPECT_EQ(image->GetDimensions()[0], 512);
  EXPECT_EQ(image->GetDimensions()[1], 320);
  EXPECT_NEAR(image->GetSpacing()[0] / Number(image, "LayoutScale", 0), 16.0 / 120.0, 1e-12);
  reader->SetMaximumSize(0);
  reader->SetMaximumNumberOfSamples(10000);
  reader->Update();
  EXPECT_LE(image->GetNumberOfPoints(), 10000);
  EXPECT_GT(image->GetNumberOfPoints(), 9500);
}
