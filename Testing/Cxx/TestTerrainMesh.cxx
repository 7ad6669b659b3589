// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainMesh through its pipeline, judged by VTK's own locators, edges and masses.
#include "vtkTerrainMesh.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFeatureEdges.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkShortArray.h>
#include <vtkStaticCellLocator.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace
{
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

vtkNew<vtkImageData> MakeHeights(
  int width, int height, const std::function<double(int, int)>& heightAt)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->SetOrigin(412345.5, 4123456.25, 10.0);
  image->SetSpacing(30.0, 25.0, 1.0);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Elevation");
  heights->SetNumberOfTuples(image->GetNumberOfPoints());
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      heights->SetValue(i + static_cast<vtkIdType>(width) * j, heightAt(i, j));
    }
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

double Hills(int i, int j)
{
  return 1000.0 + 200.0 * std::sin(0.13 * i) * std::cos(0.09 * j) + 3.0 * std::sin(2.1 * i + j);
}

double HillsWithLake(int i, int j)
{
  const int dx = i - 60;
  const int dy = j - 40;
  return dx * dx + dy * dy < 150 ? kNone : Hills(i, j);
}

/// True if a cell around the sample has a surface.
bool IsCovered(vtkImageData* image, int i, int j)
{
  const int* size = image->GetDimensions();
  const auto isThere = [&](int x, int y)
  {
    return x >= 0 && y >= 0 && x < size[0] && y < size[1] &&
      std::isfinite(image->GetScalarComponentAsDouble(x, y, 0, 0));
  };
  for (int y = j - 1; y <= j; ++y)
  {
    for (int x = i - 1; x <= i; ++x)
    {
      if (isThere(x, y) && isThere(x + 1, y) && isThere(x, y + 1) && isThere(x + 1, y + 1))
      {
        return true;
      }
    }
  }
  return false;
}

vtkIdType CountEdges(vtkPolyData* mesh, bool boundary)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->SetBoundaryEdges(boundary);
  edges->SetNonManifoldEdges(!boundary);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

//------------------------------------------------------------------------------
/// Rounds coordinates as a file of 32 bits does.
void RoundToSinglePrecision(vtkPolyData* mesh)
{
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    double point[3];
    mesh->GetPoint(k, point);
    for (double& coordinate : point)
    {
      coordinate = static_cast<float>(coordinate);
    }
    mesh->GetPoints()->SetPoint(k, point);
  }
}

/// The largest distance in z of samples from a mesh, without those of the border.
double LargestErrorInside(vtkImageData* image, vtkPolyData* mesh)
{
  const int* size = image->GetDimensions();
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  double largest = 0.0;
  for (int j = 1; j < size[1] - 1; ++j) // rounding moves the border
  {
    for (int i = 1; i < size[0] - 1; ++i)
    {
      if (!IsCovered(image, i, j))
      {
        continue;
      }
      double sample[3];
      image->GetPoint(i + size[0] * j, sample);
      const double height = sample[2] + image->GetScalarComponentAsDouble(i, j, 0, 0);
      const double from[3] = { sample[0], sample[1], -1e5 };
      const double to[3] = { sample[0], sample[1], 1e5 };
      double t = 0.0;
      double met[3];
      double parametric[3];
      int part = 0;
      vtkIdType cell = -1;
      if (locator->IntersectWithLine(from, to, 0.0, t, met, parametric, part, cell))
      {
        largest = std::max(largest, std::abs(met[2] - height));
      }
    }
  }
  return largest;
}
}

//------------------------------------------------------------------------------
// Vertical lines through all samples, met by VTK's locator.
TEST(TerrainMesh, LiesWithinItsErrorOfEverySample)
{
  const vtkNew<vtkImageData> image = MakeHeights(131, 97, HillsWithLake);
  for (const double error : { 0.5, 5.0 })
  {
    vtkNew<vtkTerrainMesh> filter;
    filter->SetInputData(image);
    filter->SetMaximumError(error);
    filter->SetExaggeration(2.0);
    filter->Update();
    vtkPolyData* mesh = filter->GetOutput();
    vtkNew<vtkStaticCellLocator> locator;
    locator->SetDataSet(mesh);
    locator->BuildLocator();
    double largest = 0.0;
    for (int j = 0; j < 97; ++j)
    {
      for (int i = 0; i < 131; ++i)
      {
        const double x = 412345.5 + 30.0 * i;
        const double y = 4123456.25 + 25.0 * j;
        const double above[3] = { x, y, 1e5 };
        const double below[3] = { x, y, -1e5 };
        double t = 0.0;
        double hit[3];
        double parametric[3];
        int part = 0;
        const bool isHit =
          locator->IntersectWithLine(above, below, 1e-3, t, hit, parametric, part) != 0;
        ASSERT_EQ(isHit, IsCovered(image, i, j)) << i << " " << j;
        if (isHit)
        {
          const double height = image->GetScalarComponentAsDouble(i, j, 0, 0);
          largest = std::max(largest, std::abs((hit[2] - 10.0) / 2.0 - height));
        }
      }
    }
    EXPECT_LE(largest, error + 1e-6);
    EXPECT_NEAR(filter->GetMeshError(), largest, 1e-6);
    EXPECT_EQ(
      mesh->GetFieldData()->GetArray("MeshError")->GetComponent(0, 0), filter->GetMeshError());
    EXPECT_GT(mesh->GetNumberOfCells(), 100);
    EXPECT_LT(mesh->GetNumberOfCells(), 130 * 96 * 2);
  }
}

TEST(TerrainMesh, CarriesSamplesWithArraysNormalsAndTextureCoordinates)
{
  vtkNew<vtkImageData> image = MakeHeights(41, 33, [](int i, int j) { return 3.0 * i + 2.0 * j; });
  vtkNew<vtkShortArray> kinds;
  kinds->SetName("Kind");
  for (int k = 0; k < 41 * 33; ++k)
  {
    kinds->InsertNextValue(static_cast<short>(k));
  }
  image->GetPointData()->AddArray(kinds);
  vtkNew<vtkTerrainMesh> filter;
  filter->SetInputData(image);
  filter->SetMaximumError(0.0);
  filter->SetExaggeration(5.0);
  filter->PassPointArraysOn();
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfCells(), 2); // a plane
  ASSERT_EQ(mesh->GetNumberOfPoints(), 4);
  const double slopeX = 5.0 * 3.0 / 30.0;
  const double slopeY = 5.0 * 2.0 / 25.0;
  const double length = std::sqrt(slopeX * slopeX + slopeY * slopeY + 1.0);
  for (vtkIdType k = 0; k < 4; ++k)
  {
    double point[3];
    mesh->GetPoint(k, point);
    const double i = (point[0] - 412345.5) / 30.0;
    const double j = (point[1] - 4123456.25) / 25.0;
    EXPECT_DOUBLE_EQ(point[2], 10.0 + 5.0 * (3.0 * i + 2.0 * j));
    EXPECT_EQ(mesh->GetPointData()->GetArray("Kind")->GetComponent(k, 0), i + 41.0 * j);
    EXPECT_EQ(mesh->GetPointData()->GetArray("Elevation")->GetComponent(k, 0), 3.0 * i + 2.0 * j);
    const double* normal = mesh->GetPointData()->GetNormals()->GetTuple3(k);
    EXPECT_NEAR(normal[0], -slopeX / length, 1e-6);
    EXPECT_NEAR(normal[1], -slopeY / length, 1e-6);
    EXPECT_NEAR(normal[2], 1.0 / length, 1e-6);
    const double* texture = mesh->GetPointData()->GetTCoords()->GetTuple2(k);
    EXPECT_NEAR(texture[0], (i + 0.5) / 41.0, 1e-6);
    EXPECT_NEAR(texture[1], (j + 0.5) / 33.0, 1e-6);
  }
}

//------------------------------------------------------------------------------
// What a file of 32 bits holds, met by VTK's locator: coordinates of 10^4 with a step of 2^-10.
TEST(TerrainMesh, HoldsItsErrorInSinglePrecision)
{
  const vtkNew<vtkImageData> image = MakeHeights(131, 97, HillsWithLake);
  image->SetOrigin(10000.3, 10000.7, 1000.1);
  image->SetSpacing(1.001, 1.003, 1.0);
  constexpr double error = 0.5;
  for (const bool holds : { false, true })
  {
    vtkNew<vtkTerrainMesh> filter;
    filter->SetInputData(image);
    filter->SetMaximumError(error);
    filter->SetHoldInSinglePrecision(holds);
    filter->Update();
    vtkPolyData* mesh = filter->GetOutput();
    RoundToSinglePrecision(mesh);
    const double largest = LargestErrorInside(image, mesh);
    EXPECT_GT(largest, 0.8 * error);
    if (holds)
    {
      EXPECT_LE(largest, error + 1e-9);
      EXPECT_NEAR(filter->GetMeshError(), largest, 0.05 * error); // samples at borders
      EXPECT_LE(filter->GetMeshError(), error);
    }
    else
    {
      EXPECT_GT(largest, error);
    }
  }
}

//------------------------------------------------------------------------------
// The volume of a block is that below the bilinear surface but for the error, and for what the
// patches add, which the samples' sum over cells has exactly.
TEST(TerrainMesh, ClosesABlock)
{
  for (const bool hasLake : { false, true })
  {
    const vtkNew<vtkImageData> image = MakeHeights(90, 70, hasLake ? HillsWithLake : Hills);
    vtkNew<vtkTerrainMesh> filter;
    filter->SetInputData(image);
    filter->SetMaximumError(0.5);
    filter->BlockOn();
    filter->SetBlockBase(700.0);
    filter->ComputeNormalsOff();
    filter->Update();
    vtkPolyData* mesh = filter->GetOutput();
    EXPECT_EQ(CountEdges(mesh, true), 0);
    EXPECT_EQ(CountEdges(mesh, false), 0);
    EXPECT_DOUBLE_EQ(mesh->GetBounds()[4], 710.0);

    double volume = 0.0;
    double area = 0.0;
    for (int j = 0; j < 69; ++j)
    {
      for (int i = 0; i < 89; ++i)
      {
        const double sum = image->GetScalarComponentAsDouble(i, j, 0, 0) +
          image->GetScalarComponentAsDouble(i + 1, j, 0, 0) +
          image->GetScalarComponentAsDouble(i, j + 1, 0, 0) +
          image->GetScalarComponentAsDouble(i + 1, j + 1, 0, 0);
        if (std::isfinite(sum))
        {
          area += 30.0 * 25.0;
          volume += 30.0 * 25.0 * (0.25 * sum - 700.0);
        }
      }
    }
    vtkNew<vtkMassProperties> mass;
    mass->SetInputData(mesh);
    mass->Update();
    EXPECT_NEAR(mass->GetVolume(), volume, 0.5 * area); // also tells inside from outside
    EXPECT_GT(volume, 100.0 * area);

    filter->ComputeNormalsOn();
    filter->Update();
    const double* bounds = filter->GetOutput()->GetBounds();
    vtkDataArray* normals = filter->GetOutput()->GetPointData()->GetNormals();
    int west = 0;
    for (vtkIdType k = 0; k < normals->GetNumberOfTuples(); ++k)
    {
      const double* normal = normals->GetTuple3(k);
      if (normal[0] == -1.0 && filter->GetOutput()->GetPoint(k)[0] == bounds[0])
      {
        ++west;
      }
    }
    EXPECT_GT(west, 4);
  }
}

TEST(TerrainMesh, IsSmallerWhereMoreErrorIsAllowed)
{
  const vtkNew<vtkImageData> image = MakeHeights(200, 180, Hills);
  vtkNew<vtkTerrainMesh> filter;
  filter->SetInputData(image);
  vtkIdType previous = 2 * 199 * 179 + 1;
  for (const double error : { 0.0, 0.5, 2.0, 8.0, 1000.0 })
  {
    filter->SetMaximumError(error);
    filter->Update();
    EXPECT_LT(filter->GetOutput()->GetNumberOfCells(), previous);
    EXPECT_LE(filter->GetMeshError(), error + 1e-9);
    previous = filter->GetOutput()->GetNumberOfCells();
  }
  EXPECT_EQ(previous, 2);
}

TEST(TerrainMesh, DoesNotDependOnThreads)
{
  const vtkNew<vtkImageData> image = MakeHeights(1200, 1100, Hills);
  vtkIdType cells[2];
  double sums[2] = { 0.0, 0.0 };
  for (int run = 0; run < 2; ++run)
  {
    vtkSMPTools::Initialize(run + 1);
    vtkNew<vtkTerrainMesh> filter;
    filter->SetInputData(image);
    filter->SetMaximumError(4.0);
    filter->Update();
    cells[run] = filter->GetOutput()->GetNumberOfCells();
    for (vtkIdType k = 0; k < filter->GetOutput()->GetNumberOfPoints(); ++k)
    {
      sums[run] += filter->GetOutput()->GetPoint(k)[2] * static_cast<double>(k % 17);
    }
  }
  vtkSMPTools::Initialize(0);
  EXPECT_EQ(cells[0], cells[1]);
  EXPECT_EQ(sums[0], sums[1]);
}

//------------------------------------------------------------------------------
TEST(TerrainMesh, RefusesInOneSentence)
{
  vtkNew<vtkTerrainMesh> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(3, 3, 3);
  volume->AllocateScalars(VTK_FLOAT, 1);
  filter->SetInputData(volume);
  filter->Update();
  EXPECT_NE(observer->GetErrorMessage().find("W x H x 1"), std::string::npos);
  observer->Clear();

  const vtkNew<vtkImageData> image = MakeHeights(20, 20, Hills);
  filter->SetInputData(image);
  for (const double number : { HUGE_VAL, 1e308, std::nan("") })
  {
    image->SetOrigin(number, 0.0, 0.0);
    image->SetSpacing(number, 1.0, 1.0);
    filter->Update();
    const std::string reason = std::isnan(number) ? "spacings above 0" : "finite places";
    EXPECT_NE(observer->GetErrorMessage().find(reason), std::string::npos) << number;
    observer->Clear();
  }
  image->SetOrigin(0.0, 0.0, 0.0);
  image->SetSpacing(1.0, 1.0, 1.0);
  filter->BlockOn();
  filter->SetBlockBase(1000.0);
  filter->Update();
  EXPECT_NE(observer->GetErrorMessage().find("SetBlockBase"), std::string::npos);
}

TEST(TerrainMesh, IsEmptyWithoutCells)
{
  vtkNew<vtkTerrainMesh> filter;
  filter->BlockOn();
  filter->SetBlockBase(-5.0);
  for (const auto& [width, height] : { std::pair<int, int>{ 1, 1 }, { 1, 9 }, { 3, 3 } })
  {
    const vtkNew<vtkImageData> image =
      MakeHeights(width, height, [](int i, int j) { return i == 1 && j == 1 ? kNone : 1.0; });
    filter->SetInputData(image);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}
