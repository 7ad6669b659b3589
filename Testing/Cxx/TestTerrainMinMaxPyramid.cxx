// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainMinMaxPyramid through its pipeline: levels, geometry, bounds, no data, refusals.
#include "vtkTerrainMinMaxPyramid.h"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace
{
template <typename Array>
vtkNew<vtkImageData> MakeHeights(int width, int height)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(5, 4 + width, -3, height - 4, 0, 0);
  image->SetOrigin(412345.5, 4123456.25, 10.0);
  image->SetSpacing(30.0, 25.0, 1.0);
  vtkNew<Array> heights;
  heights->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType k = 0; k < heights->GetNumberOfTuples(); ++k)
  {
    heights->SetValue(k, static_cast<typename Array::ValueType>((k * 7919) % 1000));
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

vtkImageData* Level(vtkMultiBlockDataSet* output, unsigned int k)
{
  return vtkImageData::SafeDownCast(output->GetBlock(k));
}

TEST(TerrainMinMaxPyramid, BoundsTheSamplesOfEveryCell)
{
  const vtkNew<vtkImageData> heights = MakeHeights<vtkShortArray>(22, 13);
  vtkNew<vtkTerrainMinMaxPyramid> filter;
  filter->SetInputData(heights);
  filter->Update();
  vtkMultiBlockDataSet* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfBlocks(), 5U);
  vtkDataArray* samples = heights->GetPointData()->GetScalars();
  for (unsigned int k = 0; k < 5; ++k)
  {
    vtkImageData* level = Level(output, k);
    const int size = 1 << k;
    const int columns = (21 + size - 1) / size;
    const int rows = (12 + size - 1) / size;
    EXPECT_EQ(
      output->GetMetaData(k)->Get(vtkCompositeDataSet::NAME()), "Level " + std::to_string(k));
    ASSERT_EQ(level->GetDimensions()[0], columns + 1);
    ASSERT_EQ(level->GetDimensions()[1], rows + 1);
    EXPECT_EQ(level->GetDimensions()[2], 1);
    EXPECT_DOUBLE_EQ(level->GetOrigin()[0], 412345.5 + 5 * 30.0);
    EXPECT_DOUBLE_EQ(level->GetOrigin()[1], 4123456.25 - 3 * 25.0);
    EXPECT_DOUBLE_EQ(level->GetSpacing()[0], size * 30.0);
    EXPECT_DOUBLE_EQ(level->GetSpacing()[1], size * 25.0);
    vtkDataArray* maximum = level->GetCellData()->GetScalars();
    vtkDataArray* minimum = level->GetCellData()->GetArray("Minimum");
    ASSERT_STREQ(maximum->GetName(), "Maximum");
    EXPECT_EQ(maximum->GetDataType(), VTK_SHORT);
    EXPECT_EQ(level->GetCellData()->GetArray("vtkGhostType"), nullptr);
    for (int y = 0; y < rows; ++y)
    {
      for (int x = 0; x < columns; ++x)
      {
        double high = -1.0;
        double low = 1e9;
        for (int j = y * size; j <= std::min((y + 1) * size, 12); ++j)
        {
          for (int i = x * size; i <= std::min((x + 1) * size, 21); ++i)
          {
            high = std::max(high, samples->GetTuple1(i + 22 * j));
            low = std::min(low, samples->GetTuple1(i + 22 * j));
          }
        }
        EXPECT_GE(maximum->GetTuple1(x + columns * y), high);
        EXPECT_LE(minimum->GetTuple1(x + columns * y), low);
        if (k == 0)
        {
          EXPECT_EQ(maximum->GetTuple1(x + columns * y), high);
          EXPECT_EQ(minimum->GetTuple1(x + columns * y), low);
        }
      }
    }
  }
  EXPECT_EQ(Level(output, 4)->GetNumberOfCells(), 2);
}

TEST(TerrainMinMaxPyramid, HidesCellsWithoutSurface)
{
  const vtkNew<vtkImageData> heights = MakeHeights<vtkFloatArray>(6, 6);
  heights->GetPointData()->GetScalars()->SetTuple1(
    2 + 6 * 3, std::numeric_limits<double>::quiet_NaN());
  vtkNew<vtkTerrainMinMaxPyramid> filter;
  filter->SetInputData(heights);
  filter->Update();
  vtkImageData* cells = Level(filter->GetOutput(), 0);
  vtkDataArray* ghosts = cells->GetCellData()->GetArray("vtkGhostType");
  ASSERT_NE(ghosts, nullptr);
  for (int j = 0; j < 5; ++j)
  {
    for (int i = 0; i < 5; ++i)
    {
      const bool touches = (i == 1 || i == 2) && (j == 2 || j == 3);
      EXPECT_EQ(ghosts->GetTuple1(i + 5 * j), touches ? vtkDataSetAttributes::HIDDENCELL : 0);
    }
  }
  EXPECT_EQ(Level(filter->GetOutput(), 1)->GetCellData()->GetArray("vtkGhostType"), nullptr);
}

TEST(TerrainMinMaxPyramid, IsEmptyWithoutCells)
{
  for (const auto& [width, height] : { std::pair{ 1, 1 }, { 1, 7 }, { 7, 1 } })
  {
    const vtkNew<vtkImageData> heights = MakeHeights<vtkDoubleArray>(width, height);
    vtkNew<vtkTerrainMinMaxPyramid> filter;
    filter->SetInputData(heights);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfBlocks(), 0U);
  }
}

TEST(TerrainMinMaxPyramid, RefusesWhatIsNotHeights)
{
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(3, 3, 3);
  volume->AllocateScalars(VTK_FLOAT, 1);
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTerrainMinMaxPyramid> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputData(volume);
  filter->Update();
  EXPECT_TRUE(observer->GetError());
  EXPECT_NE(observer->GetErrorMessage().find("3 x 3 x 3"), std::string::npos);
}
}
