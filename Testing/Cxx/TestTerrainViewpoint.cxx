// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "place/GroundPlaces.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainViewpoint.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
using FrameType = vtkTerrainGeoreference::FrameType;

/// 40 x 40 km at 200 m, flat at 1000 m, with a wall of 1500 m along x = 5000.
struct Wall
{
  vtkNew<vtkTerrainGeoreference> Reference;
  vtkNew<vtkImageData> Heights;
  vtkNew<vtkTerrainViewpoint> View;

  Wall(double wall = 1500.0)
  {
    this->Reference->SetCoordinateSystem("EPSG:4326");
    this->Reference->SetOrigin(86.9, 28.0, 0.0);
    this->Heights->SetDimensions(201, 201, 1);
    this->Heights->SetOrigin(-20000.0, -20000.0, 0.0);
    this->Heights->SetSpacing(200.0, 200.0, 1.0);
    this->Heights->AllocateScalars(VTK_FLOAT, 1);
    for (int j = 0; j < 201; ++j)
    {
      for (int i = 0; i < 201; ++i)
      {
        this->Heights->SetScalarComponentFromDouble(i, j, 0, 0, i == 125 ? wall : 1000.0);
      }
    }
    this->View->SetGeoreference(this->Reference);
    this->View->SetHeights(this->Heights);
  }
};

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}

TEST(TerrainViewpoint, PlacesOnTheGroundOfFurtherHeights)
{
  Wall wall;
  double scene[3];
  // 0.5 degrees to the east, 49 km
  EXPECT_TRUE(Contains(wall.View->FindPlace("87.4,28", scene), "does not lie on the terrain"));
  vtkNew<vtkImageData> east;
  east->DeepCopy(wall.Heights);
  east->SetOrigin(30000.0, -20000.0, 0.0);
  east->GetPointData()->GetScalars()->Fill(300.0);
  wall.View->AddHeights(east);
  EXPECT_EQ(wall.View->FindPlace("87.4,28,20agl", scene), "");
  EXPECT_NEAR(scene[2], 320.0, 1e-6);
  EXPECT_EQ(wall.View->FindPlace("86.9,28", scene), "");
  EXPECT_NEAR(scene[2], 1000.0, 1e-6) << "the first ones count";
  EXPECT_TRUE(Contains(wall.View->FindPlace("88.4,28", scene), "does not lie on the terrain"));
  wall.View->SetHeights(wall.Heights);
  EXPECT_TRUE(Contains(wall.View->FindPlace("87.4,28", scene), "does not lie on the terrain"));
}

TEST(TerrainViewpoint, PlacesByText)
{
  Wall wall;
  double scene[3];
  EXPECT_EQ(wall.View->FindPlace("86.9,28", scene), "");
  EXPECT_NEAR(scene[0], 0.0, 1e-6);
  EXPECT_NEAR(scene[2], 1000.0, 1e-6) << "on the ground";
  EXPECT_EQ(wall.View->FindPlace("86.9,28,5000", scene), "");
  EXPECT_NEAR(scene[2], 5000.0, 1e-6);
  EXPECT_EQ(wall.View->FindPlace("86.9,28,500agl", scene), "");
  EXPECT_NEAR(scene[2], 1500.0, 1e-6);
  wall.View->SetExaggeration(2.0);
  EXPECT_EQ(wall.View->FindPlace("86.9,28,500agl", scene), "");
  EXPECT_NEAR(scene[2], 3000.0, 1e-6);
  wall.View->SetExaggeration(1.0);
  const std::string mgrs = vtkTerrainGeoreference::GetMGRS(86.9, 28.0);
  EXPECT_EQ(wall.View->FindPlace(mgrs + ",2000", scene), "");
  EXPECT_NEAR(std::hypot(scene[0], scene[1]), 0.0, 1.0);
  EXPECT_NEAR(scene[2], 2000.0, 1e-6);

  EXPECT_TRUE(Contains(wall.View->FindPlace("86.9,128", scene), "no longitude and latitude"));
  EXPECT_TRUE(Contains(wall.View->FindPlace("86.9,28,high", scene), "no height"));
  EXPECT_TRUE(Contains(wall.View->FindPlace("86.9,28,1,2", scene), "too many parts"));
  EXPECT_TRUE(Contains(wall.View->FindPlace("Lukla", scene), "no place"));
  EXPECT_TRUE(Contains(wall.View->FindPlace("10,28", scene), "not lie on the terrain"));
  EXPECT_NE(wall.View->FindPlace("", scene), "");
  vtkNew<vtkTerrainViewpoint> empty;
  EXPECT_TRUE(Contains(empty->FindPlace("86.9,28", scene), "no georeference"));
}

// In a round frame the vertical of a place is not the z of the frame.
TEST(TerrainViewpoint, PlacesAreOnTheGroundOfRoundFrames)
{
  Wall wall;
  wall.Reference->SetFrame(FrameType::Local);
  // from 500 m down in the west to 2500 m in the east, 50 m a km
  for (int id = 0; id < 201 * 201; ++id)
  {
    wall.Heights->SetScalarComponentFromDouble(id % 201, id / 201, 0, 0, 500.0 + 10.0 * (id % 201));
  }
  wall.View->SetHeights(wall.Heights);
  for (const char* place : { "86.9,28", "86.95,28.05", "86.75,27.88", "87.08,27.9" })
  {
    double scene[3];
    EXPECT_EQ(wall.View->FindPlace(place, scene), "");
    EXPECT_NEAR(scene[2], wall.View->GetGround(scene[0], scene[1]), terrain::kGroundTolerance)
      << place;
  }
}

TEST(TerrainViewpoint, CamerasByPlace)
{
  for (FrameType frame : { FrameType::Plane, FrameType::Local })
  {
    Wall wall;
    wall.Reference->SetFrame(frame);
    vtkNew<vtkCamera> camera;
    EXPECT_EQ(wall.View->Look("86.85,27.95,300agl", "86.9,28", camera), "");
    EXPECT_NEAR(camera->GetPosition()[2], 1300.0, 10.0);
    EXPECT_NEAR(camera->GetFocalPoint()[0], 0.0, 1.0);
    EXPECT_NEAR(camera->GetViewUp()[2], 1.0, 1e-4);
    EXPECT_EQ(wall.View->Look("86.9,28,9000", "86.9,28", camera), "");
    EXPECT_NEAR(camera->GetViewUp()[1], 1.0, 1e-4) << "north is up from above";
    EXPECT_TRUE(Contains(wall.View->Look("86.9,28", "86.9,28", camera), "same place"));
  }
}

TEST(TerrainViewpoint, SunByTime)
{
  Wall wall;
  vtkNew<vtkLight> light;
  EXPECT_EQ(wall.View->SetSun("2024-06-21T12:00+05:45", light), "");
  EXPECT_GT(light->GetPosition()[2], 0.98) << "high in summer";
  EXPECT_TRUE(light->GetSwitch());
  EXPECT_EQ(wall.View->SetSun("2024-12-21T08:00+05:45", light), "");
  EXPECT_GT(light->GetPosition()[0], 0.7) << "in the east in the morning";
  EXPECT_LT(light->GetPosition()[1], 0.0) << "south of it in winter";
  EXPECT_EQ(wall.View->SetSun("2024-06-21T00:00+05:45", light), "");
  EXPECT_FALSE(light->GetSwitch());
  EXPECT_TRUE(Contains(wall.View->SetSun("noon", light), "no time"));
}

TEST(TerrainViewpoint, Measures)
{
  Wall wall;
  const double a[3] = { -3000.0, 0.0, 1000.0 };
  const double b[3] = { 0.0, 4000.0, 1000.0 };
  double azimuth = 0.0;
  EXPECT_NEAR(wall.View->GetDistance(a, b, &azimuth), 5000.0, 0.01);
  EXPECT_NEAR(azimuth, 36.87, 0.02);
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  corners->InsertNextPoint(0.0, 0.0, 0.0);
  corners->InsertNextPoint(1000.0, 0.0, 0.0);
  corners->InsertNextPoint(1000.0, 1000.0, 0.0);
  corners->InsertNextPoint(0.0, 1000.0, 0.0);
  double perimeter = 0.0;
  EXPECT_NEAR(wall.View->GetArea(corners, &perimeter), 1.0e6, 1.0);
  EXPECT_NEAR(perimeter, 4000.0, 0.01);
  const double beyond[3] = { 8.0e6, 0.0, 0.0 };
  EXPECT_TRUE(std::isnan(wall.View->GetDistance(a, beyond)));
}

TEST(TerrainViewpoint, Profiles)
{
  Wall wall;
  const double a[3] = { 0.0, 0.0, 1000.0 };
  const double b[3] = { 25000.0, 0.0, 1000.0 };
  vtkNew<vtkPolyData> profile;
  EXPECT_EQ(wall.View->GetProfile(a, b, 26, profile), "");
  ASSERT_EQ(profile->GetNumberOfPoints(), 26);
  vtkDataArray* distances = profile->GetPointData()->GetArray("Distance");
  vtkDataArray* heights = profile->GetPointData()->GetArray("Height");
  EXPECT_EQ(distances->GetComponent(0, 0), 0.0);
  EXPECT_NEAR(distances->GetComponent(5, 0), 5000.0, 0.1);
  EXPECT_NEAR(heights->GetComponent(5, 0), 1500.0, 1.0);
  EXPECT_NEAR(heights->GetComponent(10, 0), 1000.0, 1e-3);
  EXPECT_TRUE(std::isnan(heights->GetComponent(25, 0))) << "outside the terrain";
}

TEST(TerrainViewpoint, LinesOfSight)
{
  Wall wall;
  const double eye[3] = { 0.0, 0.0, 1400.0 };
  const double behind[3] = { 10000.0, 0.0, 1400.0 };
  const double before[3] = { 4000.0, 0.0, 1400.0 };
  const double above[3] = { 10000.0, 0.0, 1700.0 };
  double obstruction[3];
  EXPECT_FALSE(wall.View->IsVisible(eye, behind, obstruction));
  EXPECT_NEAR(obstruction[0], 5000.0, 1.0);
  EXPECT_NEAR(obstruction[2], 1500.0, 1.0);
  EXPECT_TRUE(wall.View->IsVisible(eye, before));
  EXPECT_TRUE(wall.View->IsVisible(eye, above));
  // Both on the ground of a plain: the earth's curvature hides what is 30 km away in a flat frame.
  Wall plain(1000.0);
  const double west[3] = { -15000.0, 0.0, 1002.0 };
  const double east[3] = { 15000.0, 0.0, 1002.0 };
  EXPECT_FALSE(plain.View->IsVisible(west, east));
  plain.View->SetRefraction(1.0);
  EXPECT_TRUE(plain.View->IsVisible(west, east)) << "a ray as curved as the earth";
  // On the surface itself, along it.
  const double here[3] = { 0.0, 0.0, 1000.0 };
  EXPECT_TRUE(plain.View->IsVisible(here, here));
}

// Heights are exaggerated from the height 0, which an image may place at any z. All functions know
// the same place for it: where the surface is drawn.
TEST(TerrainViewpoint, ExaggeratesFromTheOriginOfHeights)
{
  for (const double base : { 100.0, -3000.0 })
  {
    Wall plain(1000.0);
    plain.Heights->SetOrigin(-20000.0, -20000.0, base);
    plain.View->SetExaggeration(2.0);
    const double ground = base + 2.0 * 1000.0;
    EXPECT_DOUBLE_EQ(plain.View->GetGround(0.0, 0.0), ground);
    const double west[3] = { -1000.0, 0.0, ground + 20.0 };
    const double east[3] = { 1000.0, 0.0, ground + 20.0 };
    EXPECT_TRUE(plain.View->IsVisible(west, east)) << "20 above flat ground";
    const double under[3] = { 1000.0, 0.0, ground - 20.0 };
    EXPECT_FALSE(plain.View->IsVisible(west, under));
    double scene[3];
    EXPECT_EQ(plain.View->FindPlace("86.9,28", scene), "");
    EXPECT_NEAR(scene[2], ground, 1e-6);
    EXPECT_EQ(plain.View->FindPlace("86.9,28,500agl", scene), "");
    EXPECT_NEAR(scene[2], ground + 2.0 * 500.0, 1e-6);
    vtkNew<vtkPolyData> profile;
    EXPECT_EQ(plain.View->GetProfile(west, east, 3, profile), "");
    // true heights in the scene: 1000 above where the image has its height 0
    EXPECT_NEAR(
      profile->GetPointData()->GetArray("Height")->GetComponent(1, 0), base + 1000.0, 1e-3);
    double point[3];
    profile->GetPoint(1, point);
    EXPECT_NEAR(point[2], ground, 1e-6);
  }
}
