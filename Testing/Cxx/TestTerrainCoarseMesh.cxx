// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainCoarseMesh through its pipeline: output, sizes, hull, precision, threads, refusals.
#include "vtkTerrainCoarseMesh.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFeatureEdges.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkShortArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace
{
/// An image of floats at UTM-like coordinates with a hilly surface and holes of NaN.
vtkNew<vtkImageData> MakeHeights(int width, int height, unsigned int missingPercent)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->SetOrigin(412345.5, 4123456.25, 10.0);
  image->SetSpacing(30.0, 25.0, 1.0);
  vtkNew<vtkFloatArray> heights;
  heights->SetNumberOfTuples(image->GetNumberOfPoints());
  std::mt19937 random(11);
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const double value = 1000.0 + 200.0 * std::sin(0.3 * i) * std::cos(0.2 * j);
      heights->SetValue(i + static_cast<vtkIdType>(width) * j,
        random() % 100 < missingPercent ? std::numeric_limits<float>::quiet_NaN()
                                        : static_cast<float>(value));
    }
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

vtkNew<vtkPolyData> CoarseMeshOf(vtkImageData* image, vtkTerrainCoarseMesh* filter)
{
  filter->SetInputData(image);
  filter->Update();
  vtkNew<vtkPolyData> output;
  output->DeepCopy(filter->GetOutput());
  return output;
}

vtkIdType CountEdges(vtkPolyData* mesh, bool boundary)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->SetBoundaryEdges(boundary);
  edges->SetNonManifoldEdges(!boundary);
  edges->SetFeatureEdges(false);
  edges->SetManifoldEdges(false);
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

void ExpectEqualMeshes(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfPolys(), b->GetNumberOfPolys());
  for (vtkIdType id = 0; id < a->GetNumberOfPoints(); ++id)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(a->GetPoint(id)[k], b->GetPoint(id)[k]);
    }
  }
}
}

//------------------------------------------------------------------------------
TEST(TerrainCoarseMesh, DescribesItsOutput)
{
  vtkNew<vtkTerrainCoarseMesh> filter;
  filter->SetCellsPerQuad(8);
  const auto mesh = CoarseMeshOf(MakeHeights(41, 30, 0), filter);
  // 5 x 4 quads, the northern ones of 5 cells: 6 x 5 vertices twice, 18 edges of walls.
  EXPECT_EQ(mesh->GetNumberOfPoints(), 2 * 6 * 5);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2 * 2 * 20 + 2 * 18);
  EXPECT_EQ(filter->GetEffectiveCellsPerQuad(), 8);
  EXPECT_GT(filter->GetLargestGap(), 0.0);
  EXPECT_NEAR(filter->GetHeightRange()[0], 800.0, 5.0);
  EXPECT_NEAR(filter->GetHeightRange()[1], 1200.0, 5.0);
  vtkFieldData* field = mesh->GetFieldData();
  EXPECT_EQ(field->GetArray("LargestGap")->GetTuple1(0), filter->GetLargestGap());
  EXPECT_EQ(field->GetArray("CellsPerQuad")->GetTuple1(0), 8.0);
  EXPECT_EQ(field->GetArray("HeightRange")->GetTuple2(0)[1], filter->GetHeightRange()[1]);

  auto* grid = vtkFloatArray::SafeDownCast(mesh->GetPointData()->GetArray("GridCoordinates"));
  ASSERT_TRUE(grid);
  ASSERT_EQ(grid->GetNumberOfComponents(), 2);
  const double floor = 10.0 + filter->GetHeightRange()[0];
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    const double* point = mesh->GetPoint(id);
    EXPECT_EQ(point[0], 412345.5 + 30.0 * grid->GetComponent(id, 0));
    EXPECT_EQ(point[1], 4123456.25 + 25.0 * grid->GetComponent(id, 1));
    EXPECT_EQ(id<30, point[2]> floor);
  }
  EXPECT_EQ(grid->GetComponent(29, 0), 40.0);
  EXPECT_EQ(grid->GetComponent(29, 1), 29.0);
}

//------------------------------------------------------------------------------
// Old names do the same, with a warning.
TEST(TerrainCoarseMesh, KeepsOldNames)
{
  vtkNew<vtkTerrainCoarseMesh> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->SetSamplesPerQuad(8);
  EXPECT_EQ(filter->GetCellsPerQuad(), 8);
  EXPECT_EQ(filter->GetSamplesPerQuad(), 8);
  CoarseMeshOf(MakeHeights(41, 30, 0), filter);
  EXPECT_EQ(filter->GetEffectiveSamplesPerQuad(), 8);
  for (const char* name :
    { "SetCellsPerQuad()", "GetCellsPerQuad()", "GetEffectiveCellsPerQuad()" })
  {
    EXPECT_NE(observer->GetWarningMessage().find(name), std::string::npos) << name;
  }
}

//------------------------------------------------------------------------------
TEST(TerrainCoarseMesh, HullIsClosedAndEnclosesVolume)
{
  for (const unsigned int missing : { 0U, 2U, 20U, 60U })
  {
    vtkNew<vtkTerrainCoarseMesh> filter;
    filter->SetCellsPerQuad(3);
    const auto mesh = CoarseMeshOf(MakeHeights(50, 37, missing), filter);
    EXPECT_GT(mesh->GetNumberOfPolys(), 0);
    EXPECT_EQ(CountEdges(mesh, true), 0);
    EXPECT_EQ(CountEdges(mesh, false), 0);
    vtkNew<vtkMassProperties> properties;
    properties->SetInputData(mesh);
    EXPECT_GT(properties->GetVolume(), 0.0);

    filter->ClosedHullOff();
    const auto open = CoarseMeshOf(MakeHeights(50, 37, missing), filter);
    EXPECT_GT(CountEdges(open, true), 0);
  }
}

//------------------------------------------------------------------------------
TEST(TerrainCoarseMesh, FullMeshHasEveryCellWithData)
{
  vtkNew<vtkTerrainCoarseMesh> filter;
  filter->SetCellsPerQuad(1);
  filter->PushUpOff();
  auto image = MakeHeights(20, 10, 0);
  auto* heights = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  heights->SetValue(0, std::numeric_limits<float>::quiet_NaN());
  const auto mesh = CoarseMeshOf(image, filter);
  EXPECT_EQ(mesh->GetNumberOfPoints(), 199);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2 * (19 * 9 - 1));
  EXPECT_EQ(mesh->GetPoint(0)[2], 10.0 + heights->GetValue(1));
}

//------------------------------------------------------------------------------
TEST(TerrainCoarseMesh, SinglePrecisionIsRoundedUp)
{
  vtkNew<vtkTerrainCoarseMesh> filter;
  const auto exact = CoarseMeshOf(MakeHeights(60, 60, 0), filter);
  filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  const auto rounded = CoarseMeshOf(MakeHeights(60, 60, 0), filter);
  ASSERT_EQ(rounded->GetPoints()->GetDataType(), VTK_FLOAT);
  ASSERT_EQ(exact->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType id = 0; id < exact->GetNumberOfPoints(); ++id)
  {
    EXPECT_GE(rounded->GetPoint(id)[2], exact->GetPoint(id)[2]);
    EXPECT_NEAR(rounded->GetPoint(id)[2], exact->GetPoint(id)[2], 2e-4);
  }
}

//------------------------------------------------------------------------------
TEST(TerrainCoarseMesh, DegenerateSizes)
{
  for (const auto& size : { std::pair<int, int>{ 1, 1 }, { 1, 40 }, { 40, 1 }, { 2, 2 } })
  {
    vtkNew<vtkTerrainCoarseMesh> filter;
    const auto mesh = CoarseMeshOf(MakeHeights(size.first, size.second, 0), filter);
    const bool hasCells = size.first > 1 && size.second > 1;
    EXPECT_EQ(mesh->GetNumberOfPoints(), hasCells ? 8 : 0);
    EXPECT_EQ(mesh->GetNumberOfPolys(), hasCells ? 12 : 0);
    EXPECT_EQ(CountEdges(mesh, true), 0);
  }
}

//------------------------------------------------------------------------------
TEST(TerrainCoarseMesh, ConstantAndEmptyHeights)
{
  auto image = MakeHeights(9, 9, 0);
  image->GetPointData()->GetScalars()->Fill(0.0);
  vtkNew<vtkTerrainCoarseMesh> filter;
  const auto flat = CoarseMeshOf(image, filter);
  EXPECT_EQ(filter->GetLargestGap(), 0.0);
  EXPECT_LT(flat->GetBounds()[4], 10.0);
  EXPECT_EQ(flat->GetBounds()[5], 10.0);

  image->GetPointData()->GetScalars()->Fill(std::numeric_limits<double>::quiet_NaN());
  image->Modified();
  const auto none = CoarseMeshOf(image, filter);
  EXPECT_EQ(none->GetNumberOfPoints(), 0);
  EXPECT_EQ(none->GetNumberOfPolys(), 0);
  EXPECT_GT(filter->GetHeightRange()[0], filter->GetHeightRange()[1]);
}

//------------------------------------------------------------------------------
TEST(TerrainCoarseMesh, HiddenPointsHaveNoMesh)
{
  auto image = MakeHeights(9, 9, 0);
  vtkNew<vtkTerrainCoarseMesh> filter;
  filter->ClosedHullOff();
  filter->SetCellsPerQuad(4);
  image->AllocatePointGhostArray();
  for (int j = 0; j < 9; ++j)
  {
    for (int i = 4; i < 9; ++i)
    {
      image->GetPointGhostArray()->SetValue(i + 9 * j, vtkDataSetAttributes::HIDDENPOINT);
    }
  }
  const auto mesh = CoarseMeshOf(image, filter);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 4);
}

//------------------------------------------------------------------------------
TEST(TerrainCoarseMesh, SameForAnyNumberOfThreads)
{
  vtkNew<vtkTerrainCoarseMesh> filter;
  vtkSMPTools::Initialize(1);
  const auto one = CoarseMeshOf(MakeHeights(300, 200, 5), filter);
  const double gap = filter->GetLargestGap();
  vtkSMPTools::Initialize(2);
  filter->Modified();
  const auto two = CoarseMeshOf(MakeHeights(300, 200, 5), filter);
  EXPECT_EQ(gap, filter->GetLargestGap());
  ExpectEqualMeshes(one, two);
}

//------------------------------------------------------------------------------
TEST(TerrainCoarseMesh, RefusesWhatIsNotAHeightfield)
{
  vtkNew<vtkTerrainCoarseMesh> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->AllocateScalars(VTK_FLOAT, 1);
  filter->SetInputData(image);
  filter->Update();
  EXPECT_NE(observer->GetErrorMessage().find("W x H x 1"), std::string::npos);
}
