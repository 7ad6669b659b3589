// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainReproject.h"
#include "vtkTerrainTesting.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"

#include <ogr_srs_api.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
using Frame = vtkTerrainGeoreference::FrameType;

struct Grid
{
  const char* System;
  double X;
  double Y;
  double Cell;
};

const std::vector<Grid> kGrids{
  { "EPSG:4326", 86.5, 27.5, 1.0 / 1200.0 }, { "EPSG:32645", 470000.0, 3080000.0, 90.0 },
  { "EPSG:32733", 780000.0, 6300000.0, 90.0 },
  { "EPSG:32661", 1995000.0, 1994000.0, 90.0 }, // UPS, the pole inside
  { "EPSG:3857", 9660000.0, 3240000.0, 90.0 }, { "EPSG:2154", 990000.0, 6530000.0, 90.0 },
  { "EPSG:3031", 300000.0, -1300000.0, 90.0 },
  { "EPSG:2263", 980000.0, 180000.0, 300.0 }, // US survey feet
  { "EPSG:2180", 560000.0, 150000.0, 90.0 },  // northing first
};

/// Heights over width x height samples from their column and row.
vtkSmartPointer<vtkImageData> Heights(const Grid& grid, int width, int height,
  const std::function<double(double, double)>& h, int type = VTK_DOUBLE)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->SetOrigin(grid.X, grid.Y, 0.0);
  image->SetSpacing(grid.Cell, grid.Cell, 1.0);
  image->AllocateScalars(type, 1);
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      image->SetScalarComponentFromDouble(i, j, 0, 0, h(i, j));
    }
  }
  vtkNew<vtkStringArray> system;
  system->SetName("CRS");
  system->InsertNextValue(grid.System);
  image->GetFieldData()->AddArray(system);
  return image;
}

/// Longitude and latitude to a CRS, by OGR alone.
void ToSystemByGDAL(const std::string& system, double& x, double& y)
{
  OGRSpatialReferenceH to = OSRNewSpatialReference(nullptr);
  OGRSpatialReferenceH from = OSRNewSpatialReference(nullptr);
  OSRSetFromUserInput(to, system.c_str());
  OSRImportFromEPSG(from, 4326);
  OSRSetAxisMappingStrategy(from, OAMS_TRADITIONAL_GIS_ORDER);
  OSRSetAxisMappingStrategy(to, OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationH transformation = OCTNewCoordinateTransformation(from, to);
  EXPECT_TRUE(OCTTransform(transformation, 1, &x, &y, nullptr));
  OCTDestroyCoordinateTransformation(transformation);
  OSRRelease(from);
  OSRRelease(to);
}

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

vtkIdType CountNaN(vtkImageData* image)
{
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    count += std::isnan(image->GetPointData()->GetScalars()->GetComponent(i, 0)) ? 1 : 0;
  }
  return count;
}

/// Why the filter refuses an image; it must.
std::string WhyNot(vtkTerrainReproject* filter, vtkImageData* image)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->SetInputData(image);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(errors->GetError());
  return filter->GetErrorMessage();
}
}

TEST(TerrainReproject, RegistrationInEveryFrame)
{
  for (const Grid& grid : kGrids)
  {
    for (Frame frame : { Frame::Plane, Frame::Zone, Frame::Local })
    {
      // Heights that tell the column: what a sample says is where it was taken from.
      for (int axis = 0; axis < 2; ++axis)
      {
        vtkNew<vtkTerrainReproject> filter;
        filter->SetInputData(
          Heights(grid, 121, 101, [axis](double i, double j) { return axis == 0 ? i : j; }));
        filter->GetGeoreference()->SetFrame(frame);
        filter->Update();
        ASSERT_EQ(filter->GetErrorMessage(), "") << grid.System;
        EXPECT_EQ(filter->GetWarningMessage(), "") << grid.System;
        vtkImageData* output = filter->GetOutput();
        const vtkIdType count = output->GetNumberOfPoints();
        EXPECT_LT(CountNaN(output), count / 2);
        for (vtkIdType i = 0; i < count; i += 487)
        {
          double scene[3];
          output->GetPoint(i, scene);
          scene[2] = output->GetPointData()->GetScalars()->GetComponent(i, 0);
          if (std::isnan(scene[2]))
          {
            continue;
          }
          double place[3];
          filter->GetGeoreference()->SceneToPlaces(scene, place, 1);
          double file[2] = { place[0], place[1] };
          ToSystemByGDAL(grid.System, file[0], file[1]);
          const double expected = (file[axis] - (axis == 0 ? grid.X : grid.Y)) / grid.Cell;
          EXPECT_NEAR(place[2], expected, vtkTerrainReproject::RegistrationError)
            << grid.System << " sample " << i;
        }
      }
    }
  }
}

// Rows of the grid run north, whichever way those of the heights do.
TEST(TerrainReproject, TurnsRowsFromNorth)
{
  const auto heights = Heights(kGrids[0], 40, 30, [](double i, double j) { return i + 100.0 * j; });
  const auto turned = vtkSmartPointer<vtkImageData>::New();
  turned->DeepCopy(heights);
  turned->SetOrigin(kGrids[0].X, kGrids[0].Y + 29 * kGrids[0].Cell, 0.0);
  turned->SetDirectionMatrix(1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0);
  for (int j = 0; j < 30; ++j)
  {
    for (int i = 0; i < 40; ++i)
    {
      turned->SetScalarComponentFromDouble(i, j, 0, 0, i + 100.0 * (29 - j));
    }
  }
  vtkNew<vtkTerrainReproject> filter;
  vtkNew<vtkTerrainReproject> other;
  filter->SetInputData(heights);
  filter->Update();
  other->SetInputData(turned);
  other->UpdateInformation();
  const double turns[9] = { 1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0 };
  other->GetOutputInformation(0)->Set(vtkDataObject::DIRECTION(), turns, 9); // as some VTKs do
  other->Update();
  EXPECT_TRUE(other->GetOutput()->GetDirectionMatrix()->IsIdentity());
  ASSERT_EQ(other->GetOutput()->GetNumberOfPoints(), filter->GetOutput()->GetNumberOfPoints());
  for (int axis = 0; axis < 6; ++axis)
  {
    EXPECT_DOUBLE_EQ(other->GetOutput()->GetBounds()[axis], filter->GetOutput()->GetBounds()[axis]);
  }
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double expected = filter->GetOutput()->GetPointData()->GetScalars()->GetComponent(i, 0);
    const double found = other->GetOutput()->GetPointData()->GetScalars()->GetComponent(i, 0);
    ASSERT_TRUE(std::isnan(expected) ? std::isnan(found) : std::abs(found - expected) < 1e-6) << i;
  }
}

TEST(TerrainReproject, SpacingKeepsTheSizeOfCells)
{
  vtkNew<vtkTerrainReproject> filter;
  filter->SetInputData(Heights(kGrids[1], 50, 40, [](double i, double) { return i; }));
  filter->Update();
  EXPECT_NEAR(filter->GetOutput()->GetSpacing()[0], 90.0, 0.1);
  EXPECT_EQ(filter->GetOutput()->GetSpacing()[0], filter->GetOutput()->GetSpacing()[1]);
  filter->SetSpacing(200.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetSpacing()[0], 200.0);
  const double steps = filter->GetOutput()->GetOrigin()[0] / 200.0;
  EXPECT_EQ(steps, std::round(steps));
  filter->SetSpacing(0.0);
  filter->SetMaximumNumberOfSamples(500);
  filter->Update();
  EXPECT_LE(filter->GetOutput()->GetNumberOfPoints(), 500);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 300);
}

TEST(TerrainReproject, OwnGridIsLeftAlone)
{
  // Whole multiples of the cell: the samples themselves.
  const Grid grid{ "EPSG:32645", 470070.0, 3080070.0, 90.0 };
  vtkNew<vtkTerrainReproject> filter;
  filter->SetInputData(Heights({ grid.System, 90.0 * 5223, 90.0 * 34223, 90.0 }, 30, 20,
    [](double i, double j) { return i * i - 3.0 * j; }));
  filter->GetGeoreference()->SetFrame(Frame::Grid);
  filter->Update();
  vtkImageData* output = filter->GetOutput();
  ASSERT_EQ(output->GetDimensions()[0], 30);
  ASSERT_EQ(output->GetDimensions()[1], 20);
  for (int j = 0; j < 20; ++j)
  {
    for (int i = 0; i < 30; ++i)
    {
      EXPECT_NEAR(output->GetScalarComponentAsDouble(i, j, 0, 0), i * i - 3.0 * j, 1e-9);
    }
  }
  EXPECT_TRUE(output->GetFieldData()->GetAbstractArray("CRS"));
}

TEST(TerrainReproject, RoundEarthSinks)
{
  // Three degrees of sea: 784.8 m below the horizon at 100 km, and no warning.
  vtkNew<vtkTerrainReproject> filter;
  filter->SetInputData(
    Heights({ "EPSG:4326", -1.5, -1.5, 0.01 }, 301, 301, [](double, double) { return 0.0; }));
  filter->GetGeoreference()->SetFrame(Frame::Local);
  filter->SetSpacing(1000.0);
  filter->Update();
  vtkImageData* output = filter->GetOutput();
  const double point[3] = { 100000.0, 0.0, 0.0 };
  const vtkIdType there = output->FindPoint(const_cast<double*>(point));
  EXPECT_NEAR(output->GetPointData()->GetScalars()->GetComponent(there, 0), -784.0, 1.0);
  vtkDataArray* heights = output->GetPointData()->GetArray("PlaceHeight");
  ASSERT_NE(heights, nullptr);
  EXPECT_NEAR(heights->GetComponent(there, 0), 0.0, vtkTerrainReproject::VerticalTolerance);
  EXPECT_EQ(filter->GetWarningMessage(), "");
  filter->GetGeoreference()->SetFrame(Frame::Plane);
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->Update();
  EXPECT_TRUE(observer->GetWarning());
  EXPECT_TRUE(Contains(filter->GetWarningMessage(), "the flat scene is wrong by up to"));
  EXPECT_TRUE(Contains(filter->GetWarningMessage(), "4356 m of the earth's curvature"))
    << filter->GetWarningMessage();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetScalars()->GetComponent(there, 0), 0.0);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("PlaceHeight"), nullptr);
}

TEST(TerrainReproject, NoDataAndFeet)
{
  auto image = Heights(kGrids[1], 60, 60,
    [](double i, double j)
    { return i >= 20.0 && i <= 30.0 && j >= 20.0 && j <= 30.0 ? std::nan("") : 1000.0; });
  vtkNew<vtkTerrainReproject> filter;
  filter->SetInputData(image);
  filter->GetGeoreference()->SetHeightUnit(0.3048);
  for (const auto kind : { vtkTerrainReproject::InterpolationType::Bilinear,
         vtkTerrainReproject::InterpolationType::Cubic })
  {
    filter->SetInterpolation(kind);
    filter->Update();
    vtkIdType holes = 0;
    vtkImageData* output = filter->GetOutput();
    for (int j = 10; j < 50; ++j)
    {
      for (int i = 10; i < 50; ++i)
      {
        const double h = output->GetScalarComponentAsDouble(i, j, 0, 0);
        holes += std::isnan(h) ? 1 : 0;
        if (!std::isnan(h))
        {
          EXPECT_NEAR(h, 304.8, 1e-6);
        }
      }
    }
    // 12 x 12 cells touch the hole.
    EXPECT_GT(holes, 120);
    EXPECT_LT(holes, 170);
  }
}

TEST(TerrainReproject, TilesJoin)
{
  // Two tiles that share a row, one that shares a column in another CRS of the same place.
  const auto h = [](double i, double j) { return 500.0 + 3.0 * i + 2.0 * j; };
  const double cell = 1.0 / 1200.0;
  const auto south = Heights({ "EPSG:4326", 18.0, -34.0, cell }, 101, 101, h);
  const auto north = Heights({ "EPSG:4326", 18.0, -34.0 + 100.0 * cell, cell }, 101, 101,
    [&h](double i, double j) { return h(i, j + 100.0); });
  vtkNew<vtkTerrainReproject> filter;
  filter->AddInputData(south);
  filter->AddInputData(north);
  filter->Update();
  ASSERT_EQ(filter->GetErrorMessage(), "");
  vtkImageData* output = filter->GetOutput();
  const int* dims = output->GetDimensions();
  const int column = dims[0] / 2;
  int valid = 0;
  double last = 0.0;
  for (int row = 3; row + 3 < dims[1]; ++row)
  {
    const double here = output->GetScalarComponentAsDouble(column, row, 0, 0);
    ASSERT_FALSE(std::isnan(here)) << "a gap at row " << row;
    if (valid++ > 0)
    {
      EXPECT_NEAR(here - last, 2.0 * output->GetSpacing()[1] / (110917.0 * cell), 0.02);
    }
    last = here;
  }
  EXPECT_GT(valid, 180);
}

TEST(TerrainReproject, PiecesEqualTheWhole)
{
  const auto image = Heights(kGrids[0], 90, 80, [](double i, double j) { return i * 7.0 + j; });
  vtkNew<vtkTerrainReproject> whole;
  whole->SetInputData(image);
  whole->Update();
  vtkNew<vtkTerrainReproject> part;
  part->SetInputData(image);
  part->UpdateInformation();
  const int extent[6] = { 10, 40, 20, 33, 0, 0 };
  part->UpdateExtent(extent);
  EXPECT_EQ(part->GetOutput()->GetDimensions()[0], 31);
  for (int j = 20; j <= 33; ++j)
  {
    for (int i = 10; i <= 40; ++i)
    {
      EXPECT_EQ(part->GetOutput()->GetScalarComponentAsDouble(i, j, 0, 0),
        whole->GetOutput()->GetScalarComponentAsDouble(i, j, 0, 0));
    }
  }
}

TEST(TerrainReproject, AntimeridianInOnePiece)
{
  // Fiji, 177 to 183 degrees: the middle of the scene is beyond 180.
  vtkNew<vtkTerrainReproject> filter;
  filter->SetInputData(
    Heights({ "EPSG:4326", 177.0, -19.0, 0.05 }, 121, 61, [](double i, double) { return i; }));
  filter->SetSpacing(20000.0);
  filter->Update();
  vtkImageData* output = filter->GetOutput();
  double last = -1.0;
  int valid = 0;
  for (int i = 0; i < output->GetDimensions()[0]; ++i)
  {
    const double here = output->GetScalarComponentAsDouble(i, output->GetDimensions()[1] / 2, 0, 0);
    if (!std::isnan(here))
    {
      EXPECT_GT(here, last);
      last = here;
      ++valid;
    }
  }
  EXPECT_GE(valid, 30);
}

TEST(TerrainReproject, PoleInTheMiddle)
{
  // A cap in degrees, rows to the pole: heights are distances from it in degrees.
  vtkNew<vtkTerrainReproject> filter;
  filter->SetInputData(Heights(
    { "EPSG:4326", -180.0, 85.0, 0.5 }, 721, 11, [](double, double j) { return 5.0 - 0.5 * j; }));
  filter->GetGeoreference()->SetOrigin(0.0, 90.0, 0.0);
  filter->SetSpacing(20000.0);
  filter->Update();
  ASSERT_EQ(filter->GetErrorMessage(), "");
  vtkImageData* output = filter->GetOutput();
  for (int j = 0; j < output->GetDimensions()[1]; ++j)
  {
    for (int i = 0; i < output->GetDimensions()[0]; ++i)
    {
      double point[3];
      output->GetPoint(output->FindPoint(output->GetOrigin()[0] + 20000.0 * i,
                         output->GetOrigin()[1] + 20000.0 * j, 0.0),
        point);
      const double distance = std::hypot(point[0], point[1]) / 111694.0;
      const double here = output->GetScalarComponentAsDouble(i, j, 0, 0);
      if (distance < 4.9)
      {
        EXPECT_NEAR(here, distance, 0.02) << point[0] << " " << point[1];
      }
    }
  }
}

TEST(TerrainReproject, RoundTheEarthWithoutSeam)
{
  // 360 columns of a degree, whose last and first are neighbours: heights of one wave round the
  // pole, seen from above it.
  constexpr double kDegree = 3.14159265358979323846 / 180.0;
  for (double west : { -179.5, 0.5 })
  {
    for (bool cubic : { false, true })
    {
      vtkNew<vtkTerrainReproject> filter;
      filter->SetInputData(Heights({ "EPSG:4326", west, 60.0, 1.0 }, 360, 31,
        [west](double i, double) { return 100.0 * std::cos((west + i) * kDegree); }));
      filter->SetInterpolation(cubic ? vtkTerrainReproject::InterpolationType::Cubic
                                     : vtkTerrainReproject::InterpolationType::Bilinear);
      filter->GetGeoreference()->SetOrigin(0.0, 90.0, 0.0);
      filter->SetSpacing(25000.0);
      filter->Update();
      ASSERT_EQ(filter->GetErrorMessage(), "");
      vtkImageData* output = filter->GetOutput();
      int beyond = 0;
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        double point[3];
        output->GetPoint(i, point);
        const double height = output->GetPointData()->GetScalars()->GetComponent(i, 0);
        if (std::hypot(point[0], point[1]) > 3.0e6)
        {
          continue;
        }
        double place[3];
        filter->GetGeoreference()->SceneToPlaces(point, place, 1);
        // A chord of one degree is 100 (1 - cos 0.5 degrees) below the wave at most.
        EXPECT_NEAR(height, 100.0 * std::cos(place[0] * kDegree), 0.004) << point[0] << point[1];
        beyond += std::abs(std::remainder(place[0] - west + 0.5, 360.0)) < 0.5 ? 1 : 0;
      }
      EXPECT_GT(beyond, 50);
    }
  }
}

TEST(TerrainReproject, RefusesWithASentence)
{
  const auto flat = [](double, double) { return 1.0; };
  vtkNew<vtkTerrainReproject> filter;
  auto nameless = Heights(kGrids[1], 10, 10, flat);
  nameless->GetFieldData()->Initialize();
  EXPECT_TRUE(Contains(WhyNot(filter, nameless), "no coordinate system"));
  EXPECT_TRUE(
    Contains(WhyNot(filter, Heights({ "EPSG:99", 0.0, 0.0, 1.0 }, 9, 9, flat)), "not understood"));
  EXPECT_TRUE(Contains(
    WhyNot(filter, Heights({ "EPSG:4326", 5e5, 5e6, 30.0 }, 9, 9, flat)), "those are no degrees"));
  vtkNew<vtkImageData> bare;
  EXPECT_FALSE(WhyNot(filter, bare).empty());
  filter->GetGeoreference()->SetFrame(Frame::Geocentric);
  EXPECT_TRUE(Contains(WhyNot(filter, Heights(kGrids[1], 9, 9, flat)), "z is not up"));
  filter->GetGeoreference()->SetFrame(Frame::Grid);
  EXPECT_TRUE(Contains(WhyNot(filter, Heights(kGrids[0], 9, 9, flat)), "in degrees"));
  filter->GetGeoreference()->SetFrame(Frame::Plane);
  filter->GetGeoreference()->SetOrigin(-94.0, -27.0, 0.0);
  EXPECT_TRUE(Contains(WhyNot(filter, Heights(kGrids[1], 9, 9, flat)), "no image"));
  filter->GetGeoreference()->SetAutomaticOrigin();
  filter->SetSpacing(1e-4);
  EXPECT_TRUE(Contains(WhyNot(filter, Heights(kGrids[1], 9, 9, flat)), "samples, more than"));
}

TEST(TerrainReproject, DegenerateSizes)
{
  for (const auto& size : { std::pair<int, int>(1, 1), { 1, 7 }, { 7, 1 }, { 2, 2 } })
  {
    vtkNew<vtkTerrainReproject> filter;
    filter->SetInputData(
      Heights(kGrids[1], size.first, size.second, [](double, double) { return 5.0; }));
    filter->Update();
    EXPECT_EQ(filter->GetErrorMessage(), "") << size.first;
    EXPECT_GE(filter->GetOutput()->GetNumberOfPoints(), 1);
  }
}

TEST(TerrainReproject, FollowsItsGeoreference)
{
  vtkNew<vtkTerrainReproject> filter;
  filter->SetInputData(Heights(kGrids[1], 20, 20, [](double, double) { return 5.0; }));
  filter->Update();
  const vtkMTimeType before = filter->GetOutput()->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetMTime(), before) << "nothing changed";
  filter->GetGeoreference()->SetFrame(Frame::Zone);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetOrigin()[0], 400000.0);
}

TEST(TerrainReproject, CapeTilesJoin)
{
  const std::string south = vtkTerrainTesting::DataPath("S34E018.hgt");
  const std::string north = vtkTerrainTesting::DataPath("S33E018.hgt");
  if (south.empty() || north.empty())
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set, or lacks the files";
  }
  vtkNew<vtkTerrainRasterReader> southReader;
  southReader->SetFileName(south);
  southReader->SetWindow(0, 0, 1201, 60);
  vtkNew<vtkTerrainRasterReader> northReader;
  northReader->SetFileName(north);
  northReader->SetWindow(0, 1141, 1201, 60);
  vtkNew<vtkTerrainReproject> filter;
  filter->AddInputConnection(southReader->GetOutputPort());
  filter->AddInputConnection(northReader->GetOutputPort());
  filter->GetGeoreference()->SetFrame(Frame::Local);
  filter->Update();
  ASSERT_EQ(filter->GetErrorMessage(), "");
  vtkImageData* output = filter->GetOutput();
  // Along the border, latitude -33 degrees, as many holes as the voids of its row explain, and no
  // step that the rows beside it do not have.
  int holes = 0;
  int samples = 0;
  double worst = 0.0;
  double usual = 0.0;
  for (double longitude = 18.01; longitude < 18.99; longitude += 0.001)
  {
    double steps[3] = { 0.0, 0.0, 0.0 };
    for (int k = 0; k < 3; ++k)
    {
      double sides[2];
      for (int side = 0; side < 2; ++side)
      {
        const double latitude = -33.0 + 0.002 * (k - 1) + (side - 0.5) / 1200.0;
        double point[3] = { longitude, latitude, 0.0 };
        filter->GetGeoreference()->PlacesToScene(point, point, 1);
        const double x = (point[0] - output->GetOrigin()[0]) / output->GetSpacing()[0];
        const double y = (point[1] - output->GetOrigin()[1]) / output->GetSpacing()[1];
        sides[side] = output->GetScalarComponentAsDouble(
          static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)), 0, 0);
      }
      steps[k] = std::abs(sides[1] - sides[0]);
    }
    ++samples;
    holes += std::isnan(steps[1]) ? 1 : 0;
    worst = std::isnan(steps[1]) ? worst : std::max(worst, steps[1]);
    usual = std::max(usual,
      std::max(std::isnan(steps[0]) ? 0.0 : steps[0], std::isnan(steps[2]) ? 0.0 : steps[2]));
  }
  EXPECT_LE(holes, samples / 100);
  EXPECT_LE(worst, 1.5 * usual);
}

TEST(TerrainReproject, RealFilesInTheirOwnPlaces)
{
  int found = 0;
  for (const char* name :
    { "SainteHelens.dem", "aconcagua_srtm3_u16.png", "bigtujunga_srtm1_utm11.tif",
      "craterlake_elev_30m.tif", "everest_srtm3_voids.tif", "monterey_topobathy_f32.tif" })
  {
    const std::string path = vtkTerrainTesting::DataPath(name);
    if (path.empty())
    {
      continue;
    }
    ++found;
    vtkNew<vtkTerrainRasterReader> reader;
    reader->SetFileName(path);
    reader->SetMaximumSize(300);
    reader->Update();
    vtkImageData* input = reader->GetOutput();
    vtkNew<vtkTerrainReproject> filter;
    filter->SetInputConnection(reader->GetOutputPort());
    filter->GetGeoreference()->SetFrame(Frame::Local);
    filter->Update();
    ASSERT_EQ(filter->GetErrorMessage(), "") << name;
    // The highest summits, found again where the file has them.
    double range[2];
    input->GetPointData()->GetScalars()->GetFiniteRange(range);
    vtkImageData* output = filter->GetOutput();
    double highest = -HUGE_VAL;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double scene[3];
      output->GetPoint(i, scene);
      scene[2] = output->GetPointData()->GetScalars()->GetComponent(i, 0);
      if (!std::isnan(scene[2]))
      {
        filter->GetGeoreference()->SceneToPlaces(scene, scene, 1);
        highest = std::max(highest, scene[2]);
      }
    }
    EXPECT_LE(highest, range[1] + 0.01) << name;
    EXPECT_GE(highest, range[1] - 0.05 * (range[1] - range[0])) << name;
  }
  if (found == 0)
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set, or lacks the files";
  }
}
