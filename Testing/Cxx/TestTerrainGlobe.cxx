// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainTestGlobe.h"

#include "vtkTerrainGeoreference.h"
#include "vtkTerrainGraticule.h"
#include "vtkTerrainViewpoint.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
using FrameType = vtkTerrainGeoreference::FrameType;

/// Heights i + 100 j in degrees, of a coordinate system.
vtkSmartPointer<vtkImageData> MakeHeights(
  double west, double south, double step, int columns, int rows, const std::string& system = {})
{
  auto image = vtkTerrainTesting::MakeDegrees(
    west, south, step, columns, rows, [](int i, int j) { return i + 100 * j; });
  if (!system.empty())
  {
    const vtkNew<vtkStringArray> array;
    array->SetName("CRS");
    array->InsertNextValue(system);
    image->GetFieldData()->AddArray(array);
  }
  return image;
}

vtkSmartPointer<vtkImageData> LayOnGlobe(vtkImageData* heights, std::string* why = nullptr)
{
  const vtkNew<vtkTest::ErrorObserver> errors;
  const vtkNew<vtkTerrainGlobe> globe;
  globe->AddObserver(vtkCommand::ErrorEvent, errors);
  globe->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  globe->SetInputData(heights);
  globe->Update();
  if (why)
  {
    *why = errors->GetErrorMessage();
  }
  EXPECT_EQ(errors->GetError(), why != nullptr);
  return globe->GetOutput();
}

double Latitude(vtkImageData* globe, int row)
{
  return globe->GetFieldData()->GetArray("GlobeLatitudes")->GetComponent(row, 0);
}

double Height(vtkImageData* globe, int i, int j)
{
  return globe->GetScalarComponentAsDouble(i, j, 0, 0);
}

/// Heights of the whole world, in steps of one degree.
vtkSmartPointer<vtkImageData> MakeWorld()
{
  return vtkTerrainTesting::MakeDegrees(
    -179.5, -89.5, 1.0, 360, 180, [](int i, int j) { return 500 + 3 * (i % 7) + 2 * (j % 5); });
}

/// Finer heights on both sides of 180 degrees.
vtkSmartPointer<vtkImageData> MakePart()
{
  return vtkTerrainTesting::MakeDegrees(
    175.0, 10.0, 0.1, 101, 81, [](int i, int j) { return 400 + (i * j) % 90; });
}
}

//------------------------------------------------------------------------------
TEST(TerrainGlobe, JoinsCellsAndClosesPoles)
{
  const auto globe = LayOnGlobe(MakeHeights(-179.5, -89.5, 1.0, 360, 180));
  EXPECT_EQ(globe->GetDimensions()[0], 361);
  EXPECT_EQ(globe->GetDimensions()[1], 182);
  EXPECT_EQ(Latitude(globe, 0), -90.0);
  EXPECT_EQ(Latitude(globe, 1), -89.5);
  EXPECT_EQ(Latitude(globe, 181), 90.0);
  EXPECT_EQ(Height(globe, 360, 7), Height(globe, 0, 7));
  EXPECT_EQ(Height(globe, 12, 7), 12 + 600);
  EXPECT_EQ(Height(globe, 3, 0), 180.0); // the mean of 0 to 359, rounded
  EXPECT_EQ(Height(globe, 300, 0), 180.0);
}

TEST(TerrainGlobe, KeepsNodesAtPolesAndPartsAsTheyAre)
{
  const auto heights = MakeHeights(-180.0, -90.0, 1.0, 361, 181);
  const auto nodes = LayOnGlobe(heights);
  EXPECT_EQ(nodes->GetPointData()->GetScalars(), heights->GetPointData()->GetScalars());
  EXPECT_EQ(Latitude(nodes, 180), 90.0);
  for (const auto& [west, columns] : { std::pair(350.0, 20), std::pair(-200.0, 300) })
  {
    const auto part = MakeHeights(west, 80.0, 1.0, columns, 10);
    EXPECT_EQ(LayOnGlobe(part)->GetPointData()->GetScalars(), part->GetPointData()->GetScalars());
  }
}

// Wide cells are divided; the surface is the same.
TEST(TerrainGlobe, DividesWideCells)
{
  const auto globe = LayOnGlobe(MakeHeights(0.0, -67.5, 45.0, 8, 4));
  EXPECT_EQ(globe->GetDimensions()[0], 361);
  EXPECT_NEAR(Latitude(globe, 0), -90.0, 1e-9);
  const int rows = globe->GetDimensions()[1];
  int found = 0;
  EXPECT_NEAR(Latitude(globe, rows - 1), 90.0, 1e-9);
  for (int row = 0; row < rows; ++row)
  {
    if (std::abs(Latitude(globe, row) + 67.5) < 1e-9)
    {
      ++found;
      EXPECT_NEAR(Height(globe, 90, row), 2.0, 1e-5);
      EXPECT_NEAR(Height(globe, 100, row), 2.0 + 10.0 / 45.0, 1e-5);
      EXPECT_NEAR(Height(globe, 360, row), 0.0, 1e-5);
    }
  }
  EXPECT_EQ(found, 1);
}

TEST(TerrainGlobe, TakesHolesAndRadii)
{
  auto heights = MakeHeights(-179.5, -89.5, 1.0, 360, 180);
  vtkUnsignedCharArray* ghosts = heights->AllocatePointGhostArray();
  ghosts->Fill(0);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  const auto globe = LayOnGlobe(heights);
  EXPECT_NE(globe->GetPointGhostArray()->GetValue(361), 0);
  EXPECT_NE(globe->GetPointGhostArray()->GetValue(361 + 360), 0);
  EXPECT_EQ(globe->GetPointGhostArray()->GetValue(0), 0);

  const vtkNew<vtkImageData> radii;
  radii->DeepCopy(MakeHeights(0.0, 0.0, 1.0, 5, 5));
  radii->AllocateScalars(VTK_DOUBLE, 1);
  radii->GetPointData()->GetScalars()->Fill(1737500.0);
  const vtkNew<vtkTerrainGlobe> filter;
  filter->SetRadii(1737400.0, 1737400.0);
  filter->SetInputData(radii);
  filter->Update();
  EXPECT_EQ(Height(filter->GetOutput(), 2, 2), 100.0);
}

// Hidden samples may hold any number: radii are told by what is to be seen.
TEST(TerrainGlobe, TakesRadiiBesideHoles)
{
  for (const double hidden : { 0.0, -32768.0, 2e9 })
  {
    const auto radii = MakeHeights(0.0, 0.0, 1.0, 5, 5);
    radii->AllocateScalars(VTK_INT, 1);
    radii->GetPointData()->GetScalars()->Fill(1737500.0);
    radii->AllocatePointGhostArray()->Fill(0);
    radii->GetPointGhostArray()->SetValue(7, vtkDataSetAttributes::HIDDENPOINT);
    radii->GetPointData()->GetScalars()->SetComponent(7, 0, hidden);
    const vtkNew<vtkTerrainGlobe> filter;
    filter->SetRadii(1737400.0, 1737400.0);
    filter->SetInputData(radii);
    filter->Update();
    EXPECT_EQ(Height(filter->GetOutput(), 2, 2), 100.0) << hidden;
    EXPECT_NE(filter->GetOutput()->GetPointGhostArray()->GetValue(7), 0) << hidden;
  }
}

// Rows of a globe run north, whichever way those of the heights do.
TEST(TerrainGlobe, TurnsRowsFromNorth)
{
  const auto heights = MakeHeights(10.0, 20.0, 1.0, 5, 4);
  const auto turned = vtkSmartPointer<vtkImageData>::New();
  turned->DeepCopy(heights);
  turned->SetOrigin(10.0, 23.0, 0.0);
  turned->SetDirectionMatrix(1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0);
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 5; ++i)
    {
      turned->SetScalarComponentFromDouble(i, j, 0, 0, Height(heights, i, 3 - j));
    }
  }
  const vtkNew<vtkTerrainGlobe> filter;
  filter->SetInputData(turned);
  filter->UpdateInformation();
  const double turns[9] = { 1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0 };
  filter->GetOutputInformation(0)->Set(vtkDataObject::DIRECTION(), turns, 9); // as some VTKs do
  filter->Update();
  vtkImageData* globe = filter->GetOutput();
  EXPECT_TRUE(globe->GetDirectionMatrix()->IsIdentity());
  EXPECT_EQ(Height(globe, 2, 0), 2.0);
  EXPECT_EQ(Height(globe, 2, 3), 302.0);
  EXPECT_EQ(Latitude(globe, 0), 20.0);
  EXPECT_EQ(globe->GetOrigin()[1], 20.0);
}

TEST(TerrainGlobe, RefusesWhatIsNone)
{
  const auto refusal = [](vtkImageData* heights)
  {
    std::string why;
    LayOnGlobe(heights, &why);
    return why;
  };
  const auto has = [](const std::string& why, const char* word)
  { return why.find(word) != std::string::npos; };
  EXPECT_TRUE(has(refusal(MakeHeights(0.0, 0.0, 1.0, 1, 9)), "two meridians"));
  EXPECT_TRUE(has(refusal(MakeHeights(-360.0, -80.0, 1.0, 721, 160)), "more than once"));
  EXPECT_TRUE(has(refusal(MakeHeights(0.0, -120.0, 1.0, 90, 240)), "latitudes"));
  EXPECT_TRUE(has(refusal(MakeHeights(0.0, 0.0, 1.0, 9, 9, "EPSG:32633")), "is none"));
  EXPECT_TRUE(
    has(refusal(MakeHeights(0.0, 0.0, 1.0, 9, 9, "+proj=longlat +a=6378137 +b=5000000 +no_defs")),
      "flattening"));
}

// A coarse raster lies below a finer one where that covers its cells, and elsewhere is as it was.
TEST(TerrainGlobe, GivesWayToFinerHeights)
{
  const auto world = MakeWorld();
  const auto part = MakePart();
  const auto finer = LayOnGlobe(part);
  const vtkNew<vtkTerrainGlobe> filter;
  filter->SetInputData(world);
  filter->AddFinerData(finer);
  filter->Update();
  const auto before = LayOnGlobe(world);
  vtkImageData* after = filter->GetOutput();
  ASSERT_EQ(after->GetDimensions()[0], before->GetDimensions()[0]);
  int lowered = 0;
  for (int j = 0; j < after->GetDimensions()[1]; ++j)
  {
    for (int i = 0; i < after->GetDimensions()[0]; ++i)
    {
      const double longitude = -179.5 + i;
      const double east = longitude < 0.0 ? longitude + 360.0 : longitude;
      const bool covered = east >= 176.0 && east <= 184.0 && Latitude(after, j) >= 11.0 - 1e-9 &&
        Latitude(after, j) <= 17.0 + 1e-9;
      lowered += covered ? 1 : 0;
      if (covered)
      {
        EXPECT_LT(Height(after, i, j), 400.0 - 1000.0) << i << " " << j; // 0.01 of a cell
        EXPECT_GT(Height(after, i, j), 400.0 - 1200.0) << i << " " << j;
      }
      else
      {
        EXPECT_EQ(Height(after, i, j), Height(before, i, j)) << i << " " << j;
      }
    }
  }
  EXPECT_EQ(lowered, 9 * 6);

  // where the finer one has a hole, nothing gives way
  part->AllocatePointGhostArray()->SetValue(50 + 101 * 40, vtkDataSetAttributes::HIDDENPOINT);
  const auto holed = LayOnGlobe(part);
  filter->RemoveAllInputConnections(1);
  filter->AddFinerData(holed);
  filter->Update();
  int same = 0;
  for (int k = 0; k < 4; ++k)
  {
    // about longitude 180, latitude 14
    const int i = k % 2 == 0 ? 359 : 0;
    const int j = 104 + k / 2;
    same += Height(filter->GetOutput(), i, j) == Height(before, i, j) ? 1 : 0;
  }
  EXPECT_EQ(same, 4);
}

TEST(TerrainGlobe, RefusesFinerHeightsOfAnotherBody)
{
  const auto part = MakePart();
  const vtkNew<vtkTerrainGlobe> filter;
  filter->SetInputData(MakeWorld());
  const vtkNew<vtkTerrainGlobe> moon;
  moon->SetInputData(part);
  moon->SetRadii(1737400.0, 1737400.0);
  moon->Update();
  filter->AddFinerData(moon->GetOutput());
  const vtkNew<vtkTest::ErrorObserver> errors;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->Update();
  EXPECT_NE(errors->GetErrorMessage().find("another body"), std::string::npos);
  filter->RemoveAllInputConnections(1);
  filter->AddFinerData(part);
  filter->Update();
  EXPECT_NE(errors->GetErrorMessage().find("lies on no globe"), std::string::npos);
}

TEST(TerrainGlobe, SuitsWhatIsWide)
{
  EXPECT_TRUE(vtkTerrainGlobe::Suits(MakeHeights(-180.0, -90.0, 1.0, 361, 181, "EPSG:4326")));
  EXPECT_FALSE(vtkTerrainGlobe::Suits(MakeHeights(0.0, 0.0, 1.0, 21, 21, "EPSG:4326")));
  EXPECT_TRUE(vtkTerrainGlobe::Suits(
    MakeHeights(0.0, 0.0, 1.0, 21, 21, "+proj=longlat +R=1737400 +no_defs")));
  EXPECT_FALSE(vtkTerrainGlobe::Suits(MakeHeights(0.0, 0.0, 1.0, 361, 181)));
  EXPECT_FALSE(vtkTerrainGlobe::Suits(MakeHeights(0.0, 0.0, 1e6, 361, 181, "EPSG:3857")));
}

// The frame Globe against numbers of the ellipsoids, there and back.
TEST(TerrainGlobe, PlacesPointsOnItsBody)
{
  for (const auto& [system, a, b] : { std::tuple("EPSG:4326", 6378137.0, 6356752.314245179),
         std::tuple("+proj=longlat +a=3396190 +b=3376200 +no_defs", 3396190.0, 3376200.0) })
  {
    SCOPED_TRACE(system);
    const vtkNew<vtkTerrainGeoreference> place;
    place->SetCoordinateSystem(system);
    place->SetFrame(FrameType::Globe);
    ASSERT_EQ(place->GetWhyNot(), "");
    double points[9] = { 0.0, 0.0, 10.0, 90.0, 0.0, 0.0, 12.0, 90.0, 5.0 };
    ASSERT_TRUE(place->FileToScene(points, points, 3));
    const double expected[9] = { a + 10.0, 0.0, 0.0, 0.0, a, 0.0, 0.0, 0.0, b + 5.0 };
    for (int k = 0; k < 9; ++k)
    {
      EXPECT_NEAR(points[k], expected[k], 1e-8) << k;
    }
    for (double longitude = -179.0; longitude < 180.0; longitude += 37.0)
    {
      const double from[3] = { longitude, 0.4 * longitude, 1234.0 };
      double there[3];
      double back[3];
      ASSERT_TRUE(place->PlacesToScene(from, there, 1));
      ASSERT_TRUE(place->SceneToPlaces(there, back, 1));
      EXPECT_NEAR(back[0], from[0], 1e-11);
      EXPECT_NEAR(back[1], from[1], 1e-11);
      EXPECT_NEAR(back[2], from[2], 1e-6);
    }
  }
  const vtkNew<vtkTerrainGeoreference> projected;
  projected->SetCoordinateSystem("EPSG:32633");
  projected->SetFrame(FrameType::Globe);
  EXPECT_NE(projected->GetWhyNot().find("longitude and latitude"), std::string::npos);
}

// The georeference of heights on a globe is that of their body, whatever the CRS says.
TEST(TerrainGlobe, TellsItsBodyToTheGeoreference)
{
  const auto heights = MakeHeights(10.0, 20.0, 1.0, 5, 5, "EPSG:4326");
  const vtkNew<vtkTerrainGlobe> globe;
  globe->SetInputData(heights);
  globe->SetRadii(1e6, 9.5e5);
  globe->Update();
  const vtkNew<vtkTerrainGeoreference> place;
  place->SetFrame(FrameType::Globe);
  place->SetFromHeights(globe->GetOutput());
  double point[3] = { 0.0, 90.0, 10.0 };
  ASSERT_TRUE(place->PlacesToScene(point, point, 1));
  EXPECT_NEAR(point[2], 9.5e5 + 10.0, 1e-6);
  place->SetFromHeights(heights);
  double other[3] = { 0.0, 90.0, 10.0 };
  ASSERT_TRUE(place->PlacesToScene(other, other, 1));
  EXPECT_NEAR(other[2], 6356752.314245179 + 10.0, 1e-6);
}

// Files may count in grads.
TEST(TerrainGlobe, TakesAnyUnitOfAngles)
{
  const auto globe = LayOnGlobe(MakeHeights(0.0, 50.0, 1.0, 9, 9, "EPSG:4807"));
  const vtkNew<vtkTerrainGeoreference> place;
  place->SetFrame(FrameType::Globe);
  place->SetFromHeights(globe);
  EXPECT_NEAR(place->GetExtent()[1], 8.0, 1e-9);
  EXPECT_NEAR(place->GetExtent()[2], 50.0, 1e-9);
  const vtkNew<vtkTerrainViewpoint> viewpoint;
  viewpoint->SetGeoreference(place);
  viewpoint->SetHeights(globe);
  double scene[3];
  ASSERT_EQ(viewpoint->FindPlace("5.5,48.5,0agl", scene), "");
  double file[3];
  place->SceneToFile(scene, file, 1);
  EXPECT_NEAR(file[2], file[0] + 100.0 * (file[1] - 50.0), 1e-3);
}

// Cameras by place, profiles and sight on the globe.
TEST(TerrainGlobe, HasViewpoints)
{
  const auto heights = MakeHeights(-180.0, -90.0, 1.0, 361, 181, "EPSG:4326");
  const auto globe = LayOnGlobe(heights);
  const vtkNew<vtkTerrainGeoreference> place;
  place->SetFromHeights(globe);
  place->SetFrame(FrameType::Globe);
  const vtkNew<vtkTerrainViewpoint> viewpoint;
  viewpoint->SetGeoreference(place);
  viewpoint->SetHeights(globe);
  viewpoint->SetExaggeration(2.0);
  const vtkNew<vtkCamera> camera;
  ASSERT_EQ(viewpoint->Look("10,45,100agl", "11,45", camera), "");
  double eye[3];
  place->SceneToPlaces(camera->GetPosition(), eye, 1);
  EXPECT_NEAR(eye[0], 10.0, 1e-9);
  EXPECT_NEAR(eye[1], 45.0, 1e-9);
  EXPECT_NEAR(eye[2], 2.0 * (190.0 + 13500.0 + 100.0), 1e-6);
  double far[3];
  place->PlacesToScene(std::array<double, 3>{ 60.0, 45.0, 30000.0 }.data(), far, 1);
  EXPECT_FALSE(viewpoint->IsVisible(camera->GetPosition(), far));
  const vtkNew<vtkPolyData> profile;
  ASSERT_EQ(viewpoint->GetProfile(camera->GetPosition(), far, 11, profile), "");
  EXPECT_NEAR(profile->GetPointData()->GetArray("Height")->GetComponent(0, 0), 13690.0, 1e-6);
}

TEST(TerrainGlobe, HasAGraticule)
{
  const auto globe = LayOnGlobe(MakeHeights(-179.5, -89.5, 1.0, 360, 180, "EPSG:4326"));
  const vtkNew<vtkTerrainGeoreference> place;
  place->SetFromHeights(globe);
  place->SetFrame(FrameType::Globe);
  const vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputData(globe);
  graticule->SetGeoreference(place);
  graticule->SetOffset(7.0);
  graticule->SetStep(30.0);
  graticule->Update();
  vtkPolyData* lines = graticule->GetOutput();
  ASSERT_GE(lines->GetNumberOfLines(), 12 + 5);
  int onLines = 0;
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    double there[3];
    place->SceneToPlaces(lines->GetPoint(i), there, 1);
    const bool meridian = std::abs(std::remainder(there[0], 30.0)) < 1e-6;
    const bool parallel = std::abs(std::remainder(there[1], 30.0)) < 1e-6;
    onLines += meridian || parallel ? 1 : 0;
    EXPECT_GT(there[2], 0.0);
  }
  EXPECT_EQ(onLines, lines->GetNumberOfPoints());

  // labels all round: 12 meridians near the equator, 5 parallels at four longitudes, both poles
  vtkPolyData* labels = graticule->GetOutput(1);
  EXPECT_EQ(labels->GetNumberOfPoints(), 12 + 5 * 4 + 2);
  for (vtkIdType i = 0; i < labels->GetNumberOfPoints(); ++i)
  {
    double there[3];
    place->SceneToPlaces(labels->GetPoint(i), there, 1);
    const bool onMeridian = std::abs(there[1] - 15.0) < 0.5;
    const bool onParallel = std::abs(std::remainder(there[0] - 15.0, 90.0)) < 0.5;
    EXPECT_TRUE(onMeridian || onParallel || std::abs(there[1]) > 89.9)
      << there[0] << " " << there[1];
    EXPECT_GT(there[2], 0.0);
  }
}
