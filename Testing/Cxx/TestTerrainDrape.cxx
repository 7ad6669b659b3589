// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainDrape.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTestErrorObserver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
/// 21 x 21 samples, 10 m apart from (100, 200), heights x * y / 100 about the first sample: every
/// cell twisted.
vtkSmartPointer<vtkImageData> Saddle()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(21, 21, 1);
  image->SetOrigin(100.0, 200.0, 0.0);
  image->SetSpacing(10.0, 10.0, 1.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int j = 0; j < 21; ++j)
  {
    for (int i = 0; i < 21; ++i)
    {
      image->SetScalarComponentFromDouble(i, j, 0, 0, static_cast<double>(i * j));
    }
  }
  return image;
}

double Ground(double x, double y)
{
  return (x - 100.0) * (y - 200.0) / 100.0;
}

/// One line through points of three doubles, with the running number as point data.
vtkSmartPointer<vtkPolyData> Line(const std::vector<double>& coordinates)
{
  auto line = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Number");
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(coordinates.size() / 3));
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    cells->InsertCellPoint(points->InsertNextPoint(&coordinates[i]));
    numbers->InsertNextValue(static_cast<double>(i) / 3.0);
  }
  line->SetPoints(points);
  line->SetLines(cells);
  line->GetPointData()->AddArray(numbers);
  return line;
}
}

TEST(TerrainDrape, LinesFollowTheSurface)
{
  vtkNew<vtkTerrainDrape> drape;
  drape->SetHeightsData(Saddle());
  drape->SetInputData(Line({ 103.0, 207.0, 5.0, 281.0, 366.0, 9.0, 281.0, 210.0, 5.0 }));
  for (const double tolerance : { 0.0, 0.001 })
  {
    drape->SetTolerance(tolerance);
    drape->Update();
    vtkPolyData* output = drape->GetOutput();
    ASSERT_EQ(output->GetNumberOfLines(), 1);
    EXPECT_GT(output->GetNumberOfPoints(), 48);
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    output->GetLines()->GetCellAtId(0, count, ids);
    EXPECT_EQ(count, output->GetNumberOfPoints());
    double last[3];
    for (vtkIdType i = 0; i < count; ++i)
    {
      double point[3];
      output->GetPoint(ids[i], point);
      EXPECT_NEAR(point[2], Ground(point[0], point[1]), 1e-9);
      if (i > 0)
      {
        for (double t : { 0.25, 0.5, 0.75 })
        {
          const double x = (1.0 - t) * last[0] + t * point[0];
          const double y = (1.0 - t) * last[1] + t * point[1];
          const double z = (1.0 - t) * last[2] + t * point[2];
          EXPECT_NEAR(z, Ground(x, y), tolerance > 0.0 ? tolerance + 1e-12 : 0.1);
        }
      }
      std::copy(point, point + 3, last);
    }
    auto* numbers = output->GetPointData()->GetArray("Number");
    ASSERT_TRUE(numbers);
    EXPECT_EQ(numbers->GetComponent(0, 0), 0.0);
    EXPECT_EQ(numbers->GetComponent(count - 1, 0), 2.0);
  }
}

TEST(TerrainDrape, Modes)
{
  vtkNew<vtkTerrainDrape> drape;
  drape->SetHeightsData(Saddle());
  drape->SetInputData(Line({ 110.0, 210.0, 5.0, 150.0, 250.0, 5.0 }));
  drape->SetOffset(2.0);
  drape->SetMode(vtkTerrainDrape::ModeType::AboveGround);
  drape->Update();
  double point[3];
  drape->GetOutput()->GetPoint(0, point);
  EXPECT_NEAR(point[2], 1.0 + 5.0 + 2.0, 1e-9);
  drape->SetMode(vtkTerrainDrape::ModeType::Clamped);
  drape->SetExaggeration(3.0);
  drape->Update();
  drape->GetOutput()->GetPoint(0, point);
  EXPECT_NEAR(point[2], 3.0 * (1.0 + 2.0), 1e-9);
  drape->SetMode(vtkTerrainDrape::ModeType::Absolute);
  drape->SetExaggeration(1.0);
  drape->Update();
  EXPECT_EQ(drape->GetOutput()->GetNumberOfPoints(), 2);
  drape->GetOutput()->GetPoint(1, point);
  EXPECT_NEAR(point[2], 7.0, 1e-9);
}

TEST(TerrainDrape, CutsAtHolesAndBorders)
{
  auto image = Saddle();
  image->SetScalarComponentFromDouble(10, 10, 0, 0, std::nan(""));
  vtkNew<vtkTerrainDrape> drape;
  drape->SetHeightsData(image);
  // From beyond one border to beyond the other, through the hole.
  auto line = Line({ 0.0, 305.0, 0.0, 400.0, 305.0, 0.0 });
  vtkNew<vtkDoubleArray> names;
  names->SetName("Name");
  names->InsertNextValue(42.0);
  line->GetCellData()->AddArray(names);
  drape->SetInputData(line);
  drape->Update();
  vtkPolyData* output = drape->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 2);
  double bounds[6];
  output->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], 100.0, 1e-9);
  EXPECT_NEAR(bounds[1], 300.0, 1e-9);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double x = output->GetPoint(i)[0];
    EXPECT_TRUE(x < 190.0 + 1e-6 || x > 210.0 - 1e-6) << x;
  }
  EXPECT_EQ(output->GetCellData()->GetArray("Name")->GetComponent(1, 0), 42.0);
}

TEST(TerrainDrape, PointsAndOutlines)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(150.0, 250.0, 0.0);
  points->InsertNextPoint(50.0, 250.0, 0.0);
  points->InsertNextPoint(250.0, 250.0, 0.0);
  points->InsertNextPoint(250.0, 350.0, 0.0);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(2);
  vertices->InsertCellPoint(0);
  vertices->InsertCellPoint(1);
  const vtkIdType corners[3] = { 0, 2, 3 };
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(3, corners);
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  input->SetVerts(vertices);
  input->SetPolys(polygons);
  vtkNew<vtkTerrainDrape> drape;
  drape->SetHeightsData(Saddle());
  drape->SetInputData(input);
  drape->Update();
  EXPECT_EQ(drape->GetOutput()->GetNumberOfVerts(), 1) << "the other lies outside";
  ASSERT_EQ(drape->GetOutput()->GetNumberOfLines(), 1);
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  drape->GetOutput()->GetLines()->GetCellAtId(0, count, ids);
  double first[3];
  double last[3];
  drape->GetOutput()->GetPoint(ids[0], first);
  drape->GetOutput()->GetPoint(ids[count - 1], last);
  EXPECT_EQ(first[0], last[0]);
  EXPECT_EQ(first[1], last[1]);
}

TEST(TerrainDrape, DegenerateInput)
{
  vtkNew<vtkTerrainDrape> drape;
  drape->SetHeightsData(Saddle());
  vtkNew<vtkPolyData> nothing;
  drape->SetInputData(nothing);
  drape->Update();
  EXPECT_EQ(drape->GetOutput()->GetNumberOfCells(), 0);
  drape->SetInputData(Line({ std::nan(""), 250.0, 0.0, 150.0, 250.0, 0.0, 160.0, 250.0, 0.0 }));
  drape->Update();
  EXPECT_EQ(drape->GetOutput()->GetNumberOfLines(), 1) << "what is left of the line";
  drape->SetInputData(Line({ 150.0, 250.0, 0.0, 150.0, 250.0, 0.0 }));
  drape->Update();
  EXPECT_EQ(drape->GetOutput()->GetNumberOfLines(), 1);

  vtkNew<vtkImageData> empty;
  vtkNew<vtkTest::ErrorObserver> observer;
  drape->AddObserver(vtkCommand::ErrorEvent, observer);
  drape->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  drape->SetHeightsData(empty);
  drape->Update();
  EXPECT_TRUE(observer->GetError());
}
