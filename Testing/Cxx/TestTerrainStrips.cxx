// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainStrips and vtkTerrainHierarchy through their pipeline: output, attributes, threads,
// files, refusals. Geometry itself is tested in UnitTestRefinement.
#include "vtkTerrainStrips.h"

#include "vtkTerrainDetailSource.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainSource.h"
#include "vtkTerrainTesting.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkFeatureEdges.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <set>
#include <thread>
#include <utility>

#include <unistd.h>

namespace
{
vtkNew<vtkImageData> MakeHeights(int width, int height)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->SetOrigin(412345.5, 4123456.25, 10.0);
  image->SetSpacing(30.0, 25.0, 1.0);
  vtkNew<vtkFloatArray> heights;
  heights->SetNumberOfTuples(image->GetNumberOfPoints());
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      heights->SetValue(i + static_cast<vtkIdType>(width) * j,
        static_cast<float>(100.0 * std::sin(0.07 * i) * std::cos(0.05 * j) + 3.0 * ((i * j) % 7)));
    }
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

/// A camera that sees all of the image from the south.
vtkNew<vtkCamera> MakeCamera(vtkImageData* image, double back = 1.2)
{
  double bounds[6];
  image->GetBounds(bounds);
  const double size = bounds[3] - bounds[2];
  vtkNew<vtkCamera> camera;
  camera->SetFocalPoint(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.0);
  camera->SetPosition(0.5 * (bounds[0] + bounds[1]), bounds[2] - back * size, 0.5 * size);
  camera->SetViewUp(0.0, 0.0, 1.0);
  return camera;
}

struct Pipeline
{
  vtkNew<vtkImageData> Heights = MakeHeights(129, 100);
  vtkNew<vtkCamera> Camera = MakeCamera(this->Heights);
  vtkNew<vtkTerrainStrips> Strips;
  vtkNew<vtkTest::ErrorObserver> Errors;

  Pipeline()
  {
    this->Strips->SetInputData(this->Heights);
    this->Strips->SetCamera(this->Camera);
    this->Strips->SetViewportSize(640, 480);
    this->Strips->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->Strips->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  }

  vtkPolyData* Update()
  {
    this->Strips->Update();
    return this->Strips->GetOutput();
  }
  /// True if an update fails with a message, and leaves the output empty.
  bool Fails()
  {
    this->Errors->Clear();
    this->Strips->Modified();
    this->Strips->Update();
    return this->Errors->GetError() && this->Strips->GetOutput()->GetNumberOfCells() == 0;
  }
};

std::string TemporaryPath(const std::string& name)
{
  return vtkTerrainTesting::OutputPath(name + std::to_string(getpid()) + ".hierarchy");
}
}

TEST(TerrainStrips, MakesOneStripWithoutCracks)
{
  Pipeline pipeline;
  vtkPolyData* output = pipeline.Update();
  EXPECT_EQ(output->GetNumberOfStrips(), 1);
  EXPECT_EQ(output->GetNumberOfPolys(), 0);
  EXPECT_GT(pipeline.Strips->GetNumberOfTriangles(), 100);
  pipeline.Strips->TriangleOutputOn();
  output = pipeline.Update();
  EXPECT_EQ(output->GetNumberOfPolys(), pipeline.Strips->GetNumberOfTriangles());
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(output);
  edges->BoundaryEdgesOff();
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->NonManifoldEdgesOn();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0);
  // All boundary edges lie on the four sides.
  edges->NonManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->Update();
  double bounds[6];
  pipeline.Heights->GetBounds(bounds);
  vtkPolyData* boundary = edges->GetOutput();
  EXPECT_GE(boundary->GetNumberOfCells(), 4);
  for (vtkIdType id = 0; id < boundary->GetNumberOfPoints(); ++id)
  {
    const double* p = boundary->GetPoint(id);
    EXPECT_TRUE(p[0] == bounds[0] || p[0] == bounds[1] || p[1] == bounds[2] || p[1] == bounds[3]);
  }
}

TEST(TerrainStrips, PointsAreSamplesWithTheirAttributes)
{
  Pipeline pipeline;
  pipeline.Strips->NormalsOn();
  pipeline.Strips->TextureCoordinatesOn();
  pipeline.Strips->DepthColorsOn();
  pipeline.Strips->SetExaggeration(2.0);
  vtkPolyData* output = pipeline.Update();
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  vtkDataArray* coordinates = output->GetPointData()->GetTCoords();
  ASSERT_TRUE(normals && coordinates && output->GetPointData()->GetScalars());
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    const double* p = output->GetPoint(id);
    const int i = static_cast<int>(std::lround((p[0] - 412345.5) / 30.0));
    const int j = static_cast<int>(std::lround((p[1] - 4123456.25) / 25.0));
    EXPECT_EQ(p[0], 412345.5 + 30.0 * i);
    EXPECT_EQ(p[1], 4123456.25 + 25.0 * j);
    EXPECT_EQ(p[2], 10.0 + 2.0 * pipeline.Heights->GetScalarComponentAsDouble(i, j, 0, 0));
    EXPECT_FLOAT_EQ(coordinates->GetComponent(id, 0), i / 128.0);
    EXPECT_FLOAT_EQ(coordinates->GetComponent(id, 1), j / 99.0);
    const double* n = normals->GetTuple3(id);
    EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1.0, 1.0e-5);
    if (i > 0 && i < 128)
    {
      const double slope = (pipeline.Heights->GetScalarComponentAsDouble(i + 1, j, 0, 0) -
                             pipeline.Heights->GetScalarComponentAsDouble(i - 1, j, 0, 0)) /
        60.0;
      EXPECT_NEAR(-n[0] / n[2], 2.0 * slope, 0.01 * std::abs(2.0 * slope) + 1.0e-6);
    }
  }
}

// The old name does the same, with a warning.
TEST(TerrainStrips, KeepsTheOldNameOfDepthColors)
{
  const vtkNew<vtkTerrainStrips> strips;
  const vtkNew<vtkTest::ErrorObserver> observer;
  strips->AddObserver(vtkCommand::WarningEvent, observer);
  strips->LevelColorsOn();
  EXPECT_TRUE(strips->GetDepthColors());
  EXPECT_TRUE(observer->GetWarning());
  EXPECT_NE(observer->GetWarningMessage().find("SetDepthColors()"), std::string::npos);
  strips->LevelColorsOff();
  EXPECT_FALSE(strips->GetLevelColors());
}

TEST(TerrainStrips, WithDetailPointsAreSamplesOfTheSum)
{
  Pipeline pipeline;
  vtkNew<vtkTerrainDetailSource> source;
  source->SetSize(32);
  source->SetRelief(8.0);
  source->Update();
  vtkImageData* detail = source->GetOutput();
  pipeline.Strips->SetDetailData(detail);
  pipeline.Strips->SetDetailCells(4);
  pipeline.Strips->SetDetailScale(1.5);
  pipeline.Strips->SetTolerance(0.5);
  pipeline.Strips->NormalsOn();
  pipeline.Strips->TextureCoordinatesOn();
  pipeline.Strips->DepthColorsOn();
  EXPECT_EQ(pipeline.Strips->GetDetail(), detail);
  vtkPolyData* output = pipeline.Update();
  vtkIdType below = 0;
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    const double* p = output->GetPoint(id);
    const int i = static_cast<int>(std::lround((p[0] - 412345.5) / 7.5));
    const int j = static_cast<int>(std::lround((p[1] - 4123456.25) / 6.25));
    const int x = std::min(i / 4, 127);
    const int y = std::min(j / 4, 98);
    const double u = 0.25 * i - x;
    const double v = 0.25 * j - y;
    const auto at = [&](int dx, int dy)
    { return pipeline.Heights->GetScalarComponentAsDouble(x + dx, y + dy, 0, 0); };
    const double base =
      (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
    EXPECT_NEAR(
      p[2], 10.0 + base + 1.5 * detail->GetScalarComponentAsDouble(i % 32, j % 32, 0, 0), 1.0e-4);
    EXPECT_FLOAT_EQ(output->GetPointData()->GetTCoords()->GetComponent(id, 0), i / 512.0);
    below += i % 4 != 0 || j % 4 != 0 ? 1 : 0;
  }
  EXPECT_GT(below, 100);
  // With scale 0 few points are left; without detail it is as if there never was any.
  pipeline.Strips->SetDetailScale(0.0);
  EXPECT_LT(pipeline.Update()->GetNumberOfPoints(), below);
  pipeline.Strips->SetDetailData(nullptr);
  const vtkIdType bare = pipeline.Update()->GetNumberOfPoints();
  Pipeline other;
  other.Strips->SetTolerance(0.5);
  EXPECT_EQ(bare, other.Update()->GetNumberOfPoints());
}

TEST(TerrainStrips, RefusesBadDetail)
{
  Pipeline pipeline;
  for (const int cells : { 0, -2, 3, 2048 })
  {
    pipeline.Errors->Clear();
    pipeline.Strips->SetDetailCells(cells);
    EXPECT_TRUE(pipeline.Errors->GetError());
  }
  EXPECT_EQ(pipeline.Strips->GetDetailCells(), 16);
  const vtkNew<vtkImageData> holed = MakeHeights(8, 8);
  pipeline.Strips->SetDetailData(holed);
  EXPECT_FALSE(pipeline.Fails());
  for (const double scale : { -1.0, std::nan("") })
  {
    pipeline.Strips->SetDetailScale(scale);
    EXPECT_TRUE(pipeline.Fails());
  }
  pipeline.Strips->SetDetailScale(1.0);
  holed->SetScalarComponentFromDouble(3, 3, 0, 0, std::nan(""));
  holed->Modified();
  EXPECT_TRUE(pipeline.Fails());
}

TEST(TerrainStrips, FollowsTheCamera)
{
  Pipeline pipeline;
  pipeline.Update();
  const vtkIdType far = pipeline.Strips->GetNumberOfTriangles();
  const vtkMTimeType before = pipeline.Strips->GetOutput()->GetMTime();
  pipeline.Update();
  EXPECT_EQ(pipeline.Strips->GetOutput()->GetMTime(), before);
  pipeline.Camera->Dolly(0.3);
  pipeline.Update();
  EXPECT_LT(pipeline.Strips->GetNumberOfTriangles(), far);
  pipeline.Strips->SetTriangleBudget(50);
  pipeline.Update();
  EXPECT_LE(pipeline.Strips->GetNumberOfTriangles(), 50);
  EXPECT_GT(pipeline.Strips->GetUsedTolerance(), 1.0);
}

TEST(TerrainStrips, ReadsFilesLikeMemory)
{
  const std::string path = TemporaryPath("strips");
  Pipeline pipeline;
  vtkNew<vtkStringArray> crs;
  crs->SetName("CRS");
  crs->InsertNextValue("EPSG:32611");
  pipeline.Heights->GetFieldData()->AddArray(crs);
  vtkNew<vtkTerrainHierarchy> memory;
  ASSERT_TRUE(memory->SetHeights(pipeline.Heights)) << memory->GetErrorMessage();
  EXPECT_EQ(memory->GetCoordinateSystem(), "EPSG:32611");
  ASSERT_TRUE(memory->WriteFile(path)) << memory->GetErrorMessage();
  vtkNew<vtkTerrainHierarchy> file;
  ASSERT_TRUE(file->OpenFile(path, true)) << file->GetErrorMessage();
  EXPECT_EQ(file->GetCoordinateSystem(), "EPSG:32611");
  double bounds[6];
  double imageBounds[6];
  file->GetBounds(bounds);
  pipeline.Heights->GetBounds(imageBounds);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(bounds[i], imageBounds[i]);
  }
  vtkNew<vtkPolyData> fromImage;
  fromImage->DeepCopy(pipeline.Update());
  pipeline.Strips->SetHierarchy(file);
  vtkPolyData* output = pipeline.Update();
  ASSERT_EQ(output->GetNumberOfPoints(), fromImage->GetNumberOfPoints());
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(output->GetPoint(id)[axis], fromImage->GetPoint(id)[axis]);
    }
  }
  // A file that shrinks: an error, then again a mesh from a new one.
  ASSERT_EQ(truncate(path.c_str(), 4096), 0);
  EXPECT_TRUE(pipeline.Fails());
  EXPECT_TRUE(file->IsDamaged());
  EXPECT_FALSE(file->OpenFile(path));
  EXPECT_NE(file->GetErrorMessage().find(path), std::string::npos);
  EXPECT_TRUE(pipeline.Fails());
  pipeline.Strips->SetHierarchy(memory);
  EXPECT_EQ(pipeline.Update()->GetNumberOfStrips(), 1);
  std::remove(path.c_str());
}

// Opened without a look at its checksums; what it holds beyond its header is other text.
TEST(TerrainStrips, DamagedFilesAreErrors)
{
  const std::string path = TemporaryPath("damaged-strips");
  Pipeline pipeline;
  vtkNew<vtkTerrainHierarchy> memory;
  ASSERT_TRUE(memory->SetHeights(pipeline.Heights)) << memory->GetErrorMessage();
  ASSERT_TRUE(memory->WriteFile(path)) << memory->GetErrorMessage();
  vtkNew<vtkTerrainHierarchy> file;
  ASSERT_TRUE(file->OpenFile(path));
  pipeline.Strips->SetHierarchy(file);
  EXPECT_GT(pipeline.Update()->GetNumberOfPoints(), 4);
  {
    std::fstream stream(path, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(4096);
    stream << std::string(8192, 'T');
  }
  ASSERT_TRUE(file->OpenFile(path));
  EXPECT_TRUE(pipeline.Fails());
  EXPECT_FALSE(file->OpenFile(path, true));
  std::remove(path.c_str());
}

TEST(TerrainStrips, AsynchronousBuildingConvergesToTheSynchronousMesh)
{
  Pipeline synchronous;
  Pipeline pipeline;
  pipeline.Strips->AsynchronousOn();
  for (int frame = 0; frame < 20; ++frame)
  {
    pipeline.Camera->Azimuth(1.0);
    synchronous.Camera->Azimuth(1.0);
    pipeline.Update();
  }
  int updates = 0;
  while (pipeline.Strips->IsBuilding() && updates < 10000)
  {
    pipeline.Update();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ++updates;
  }
  vtkPolyData* expected = synchronous.Update();
  vtkPolyData* output = pipeline.Strips->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
  ASSERT_EQ(pipeline.Strips->GetNumberOfTriangles(), synchronous.Strips->GetNumberOfTriangles());
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(output->GetPoint(id)[axis], expected->GetPoint(id)[axis]);
    }
  }
}

TEST(TerrainStrips, StopsItsThreadWhenItIsDeletedAtWork)
{
  for (int i = 0; i < 20; ++i)
  {
    Pipeline pipeline;
    pipeline.Strips->AsynchronousOn();
    pipeline.Update();
  }
}

TEST(TerrainStrips, RefusesBadParameters)
{
  Pipeline pipeline;
  EXPECT_FALSE(pipeline.Fails());
  for (const double tolerance : { 0.0, -1.0, std::nan(""), HUGE_VAL })
  {
    pipeline.Strips->SetTolerance(tolerance);
    EXPECT_TRUE(pipeline.Fails()) << tolerance;
  }
  pipeline.Strips->SetTolerance(1.0);
  pipeline.Strips->SetViewportSize(0, 0);
  EXPECT_TRUE(pipeline.Fails());
  pipeline.Strips->SetViewportSize(640, 480);
  pipeline.Strips->SetTriangleBudget(-3);
  EXPECT_TRUE(pipeline.Fails());
  pipeline.Strips->SetTriangleBudget(0);
  pipeline.Strips->SetExaggeration(0.0);
  EXPECT_TRUE(pipeline.Fails());
  pipeline.Strips->SetExaggeration(1.0);
  EXPECT_FALSE(pipeline.Fails());
  pipeline.Camera->SetPosition(HUGE_VAL, 0.0, 0.0);
  EXPECT_TRUE(pipeline.Fails());
  pipeline.Strips->SetCamera(nullptr);
  EXPECT_TRUE(pipeline.Fails());
}

TEST(TerrainStrips, RefusesWhatAreNoHeights)
{
  Pipeline pipeline;
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(3, 3, 3);
  volume->AllocateScalars(VTK_FLOAT, 1);
  pipeline.Strips->SetInputData(volume);
  EXPECT_TRUE(pipeline.Fails());
  pipeline.Strips->SetInputData(nullptr);
  EXPECT_TRUE(pipeline.Fails());
  vtkNew<vtkTerrainHierarchy> empty;
  EXPECT_TRUE(empty->IsEmpty());
  pipeline.Strips->SetHierarchy(empty);
  EXPECT_TRUE(pipeline.Fails());
  EXPECT_FALSE(empty->WriteFile(TemporaryPath("empty")));
}

TEST(TerrainStrips, PiecesHaveTheWholeDetailAndMayBeEmpty)
{
  Pipeline pipeline;
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(33, 20);
  vtkNew<vtkTerrainDetailSource> detail;
  detail->SetSize(32);
  pipeline.Strips->SetInputConnection(source->GetOutputPort());
  pipeline.Strips->SetDetailConnection(detail->GetOutputPort());
  pipeline.Strips->SetDetailCells(4);
  for (const int pieces : { 3, 64 }) // of 64 most have no samples
  {
    for (const int piece : { 0, 1, pieces - 1 })
    {
      pipeline.Strips->UpdatePiece(piece, pieces, 0);
      EXPECT_FALSE(pipeline.Errors->GetError()) << pipeline.Errors->GetErrorMessage();
      EXPECT_EQ(pipeline.Strips->GetDetail()->GetDimensions()[1], 32);
    }
  }
}

TEST(TerrainStrips, DrawsNothingOfNoCells)
{
  Pipeline pipeline;
  vtkNew<vtkImageData> row = MakeHeights(1, 50);
  pipeline.Strips->SetInputData(row);
  EXPECT_EQ(pipeline.Update()->GetNumberOfCells(), 0);
  EXPECT_FALSE(pipeline.Errors->GetError());
}

// The heights of a hierarchy are those it was made of, NaN where no cell around a sample has a
// surface.
TEST(TerrainHierarchy, GivesItsHeightsBack)
{
  for (const auto& size : { std::pair(1, 1), { 2, 2 }, { 9, 5 }, { 70, 45 } })
  {
    const int width = size.first;
    const int height = size.second;
    vtkNew<vtkImageData> image = MakeHeights(width, height);
    vtkDataArray* samples = image->GetPointData()->GetScalars();
    for (vtkIdType id = 4; id < image->GetNumberOfPoints(); id += 17)
    {
      samples->SetComponent(id, 0, std::numeric_limits<double>::quiet_NaN());
    }
    const auto at = [&](int i, int j)
    {
      return i < 0 || j < 0 || i >= width || j >= height
        ? std::numeric_limits<double>::quiet_NaN()
        : image->GetScalarComponentAsDouble(i, j, 0, 0);
    };
    const auto isInCell = [&](int i, int j)
    {
      bool found = false;
      for (const auto& [x, y] : { std::pair(1, 1), { -1, 1 }, { 1, -1 }, { -1, -1 } })
      {
        found = found || !std::isnan(at(i, j) + at(i + x, j) + at(i, j + y) + at(i + x, j + y));
      }
      return found;
    };
    vtkNew<vtkTerrainHierarchy> hierarchy;
    ASSERT_TRUE(hierarchy->SetHeights(image)) << hierarchy->GetErrorMessage();
    const int part[6] = { width / 3, width - 1, height / 4, height - 1, 0, 0 };
    vtkNew<vtkImageData> whole;
    vtkNew<vtkImageData> piece;
    ASSERT_TRUE(hierarchy->GetHeights(whole)) << hierarchy->GetErrorMessage();
    ASSERT_TRUE(hierarchy->GetHeights(part, piece)) << hierarchy->GetErrorMessage();
    EXPECT_EQ(whole->GetOrigin()[2], image->GetOrigin()[2]);
    EXPECT_EQ(whole->GetSpacing()[1], image->GetSpacing()[1]);
    for (int j = 0; j < height; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        const double given = whole->GetScalarComponentAsDouble(i, j, 0, 0);
        EXPECT_EQ(std::isnan(given), !isInCell(i, j)) << i << " " << j;
        EXPECT_TRUE(std::isnan(given) || given == at(i, j)) << i << " " << j;
        if (i >= part[0] && j >= part[2])
        {
          const double again = piece->GetScalarComponentAsDouble(i, j, 0, 0);
          EXPECT_TRUE(again == given || (std::isnan(again) && std::isnan(given)));
        }
      }
    }
    const int outside[6] = { 0, width, 0, 0, 0, 0 };
    EXPECT_FALSE(hierarchy->GetHeights(outside, piece));
    EXPECT_NE(hierarchy->GetErrorMessage(), "");
  }
  vtkNew<vtkTerrainHierarchy> empty;
  vtkNew<vtkImageData> nothing;
  EXPECT_FALSE(empty->GetHeights(nothing));
}
