// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTestErrorObserver.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(TerrainSource, GivesHeightsAsScalars)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(70, 40);
  source->Update();
  vtkImageData* image = source->GetOutput();
  EXPECT_EQ(image->GetDimensions()[0], 70);
  EXPECT_EQ(image->GetDimensions()[1], 40);
  EXPECT_EQ(image->GetDimensions()[2], 1);
  EXPECT_DOUBLE_EQ(image->GetSpacing()[0], 40960.0 / 69.0);
  EXPECT_DOUBLE_EQ(image->GetSpacing()[1], 40960.0 / 69.0);
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  ASSERT_NE(heights, nullptr);
  EXPECT_STREQ(heights->GetName(), "Elevation");
  EXPECT_EQ(heights->GetDataType(), VTK_FLOAT);
  EXPECT_GE(heights->GetRange()[0], 0.0);
  EXPECT_LE(heights->GetRange()[1], source->GetRelief());
}

TEST(TerrainSource, PiecesEqualTheWhole)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(90, 61);
  source->Update();
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(source->GetOutput());
  vtkNew<vtkTerrainSource> part;
  part->SetDimensions(90, 61);
  int extent[6] = { 20, 55, 13, 60, 0, 0 };
  part->UpdateExtent(extent);
  vtkImageData* piece = part->GetOutput();
  ASSERT_EQ(piece->GetExtent()[0], 20);
  ASSERT_EQ(piece->GetExtent()[3], 60);
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      ASSERT_EQ(piece->GetScalarComponentAsDouble(i, j, 0, 0),
        whole->GetScalarComponentAsDouble(i, j, 0, 0));
    }
  }
}

TEST(TerrainSource, IntegersAreRoundedHeights)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(33, 33);
  source->Update();
  vtkNew<vtkImageData> exact;
  exact->DeepCopy(source->GetOutput());
  for (const int type : { VTK_SHORT, VTK_UNSIGNED_SHORT })
  {
    source->SetOutputScalarType(type);
    source->Update();
    vtkDataArray* heights = source->GetOutput()->GetPointData()->GetScalars();
    ASSERT_EQ(heights->GetDataType(), type);
    for (vtkIdType k = 0; k < heights->GetNumberOfTuples(); ++k)
    {
      ASSERT_EQ(
        heights->GetTuple1(k), std::floor(exact->GetPointData()->GetScalars()->GetTuple1(k) + 0.5));
    }
  }
}

TEST(TerrainSource, ReliefBeyondTheTypeIsCutOff)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(33, 33);
  source->SetRelief(100000.0);
  source->SetOutputScalarTypeToShort();
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetPointData()->GetScalars()->GetRange()[1], 32767.0);
}

TEST(TerrainSource, DegenerateSizesAreLegal)
{
  const int sizes[][2] = { { 1, 1 }, { 1, 20 }, { 20, 1 }, { 2, 2 } };
  for (const auto& size : sizes)
  {
    vtkNew<vtkTerrainSource> source;
    source->SetDimensions(size[0], size[1]);
    source->Update();
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), size[0] * size[1]);
    EXPECT_TRUE(std::isfinite(source->GetOutput()->GetPointData()->GetScalars()->GetTuple1(0)));
  }
}

TEST(TerrainSource, RefusesImpossibleParameters)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  vtkNew<vtkTerrainSource> source;
  source->AddObserver(vtkCommand::ErrorEvent, errors);
  source->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  source->SetDimensions(0, 5);
  source->Update();
  EXPECT_NE(errors->GetErrorMessage().find("0 x 5"), std::string::npos);
  errors->Clear();
  source->SetDimensions(5, 5);
  source->SetOutputScalarType(VTK_CHAR);
  source->Update();
  EXPECT_NE(errors->GetErrorMessage().find("char"), std::string::npos);
}

TEST(TerrainSource, AbortLeavesNoHalfOutput)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(3000, 3000);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  source->AddObserver(vtkCommand::ProgressEvent, abort);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
}
