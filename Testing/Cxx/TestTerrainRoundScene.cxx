// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Exaggerated heights on a round earth: terrain, lines, places and sight, against GeographicLib.
#include "vtkTerrainDrape.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainGraticule.h"
#include "vtkTerrainReproject.h"
#include "vtkTerrainViewpoint.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <GeographicLib/LocalCartesian.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
using Frame = vtkTerrainGeoreference::FrameType;

constexpr double kWest = 0.0;
constexpr double kSouth = 60.0;
constexpr double kCell = 0.05; // degrees
constexpr int kColumns = 401;
constexpr int kRows = 201;
/// Of the scene: the middle.
constexpr double kLongitude = 10.0;
constexpr double kLatitude = 65.0;

/// Ridges from south to north: 20 columns from one to the next, of straight slopes.
double Ridges(double longitude)
{
  const double column = (longitude - kWest) / kCell;
  return 500.0 + 200.0 * std::abs(column - 20.0 * std::round(column / 20.0));
}

vtkSmartPointer<vtkImageData> Degrees(const std::function<double(double)>& heightAt)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(kColumns, kRows, 1);
  image->SetOrigin(kWest, kSouth, 0.0);
  image->SetSpacing(kCell, kCell, 1.0);
  image->AllocateScalars(VTK_DOUBLE, 1);
  for (int j = 0; j < kRows; ++j)
  {
    for (int i = 0; i < kColumns; ++i)
    {
      image->SetScalarComponentFromDouble(i, j, 0, 0, heightAt(kWest + i * kCell));
    }
  }
  vtkNew<vtkStringArray> system;
  system->SetName("CRS");
  system->InsertNextValue("EPSG:4326");
  image->GetFieldData()->AddArray(system);
  return image;
}

/// A round scene of heights, and what GeographicLib says about its points.
struct RoundScene
{
  vtkNew<vtkTerrainReproject> Filter;
  vtkNew<vtkTerrainViewpoint> View;
  GeographicLib::LocalCartesian Exact{ kLatitude, kLongitude, 0.0 };
  double Exaggeration;

  RoundScene(const std::function<double(double)>& heightAt, double exaggeration, double spacing)
    : Exaggeration(exaggeration)
  {
    this->Filter->SetInputData(Degrees(heightAt));
    this->Filter->SetSpacing(spacing);
    this->Reference()->SetFrame(Frame::Local);
    this->Reference()->SetOrigin(kLongitude, kLatitude, 0.0);
    this->Reference()->SetVerticalExaggeration(exaggeration);
    this->Filter->Update();
    this->View->SetGeoreference(this->Reference());
    this->View->SetHeights(this->Heights());
  }

  vtkTerrainGeoreference* Reference()
  {
    return this->Filter->GetGeoreference();
  }
  vtkImageData* Heights()
  {
    return this->Filter->GetOutput();
  }
  /// Longitude, latitude and height, not exaggerated.
  std::array<double, 3> PlaceOf(const double scene[3])
  {
    std::array<double, 3> place{};
    this->Exact.Reverse(scene[0], scene[1], scene[2], place[1], place[0], place[2]);
    place[2] /= this->Exaggeration;
    return place;
  }
};

/// Longitudes of two places west to east along the middle parallel.
vtkSmartPointer<vtkPolyData> Track(RoundScene& scene, double west, double east)
{
  auto track = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (double longitude = west; longitude <= east; longitude += 0.5)
  {
    double point[3] = { longitude, kLatitude, 0.0 };
    scene.Reference()->PlacesToScene(point, point, 1);
    const vtkIdType id = points->InsertNextPoint(point);
    cells->InsertNextCell(1, &id);
  }
  track->SetPoints(points);
  track->SetVerts(cells);
  return track;
}
}

// At 50 the slopes stand at 62 degrees, and plain iteration along the vertical would not end.
TEST(TerrainRoundScene, ExaggeratesHeightsAndNotTheEarth)
{
  for (const double exaggeration : { 1.0, 20.0, 50.0 })
  {
    RoundScene scene(Ridges, exaggeration, 5000.0);
    vtkImageData* output = scene.Heights();
    vtkDataArray* z = output->GetPointData()->GetScalars();
    vtkDataArray* heights = output->GetPointData()->GetArray("PlaceHeight");
    vtkIdType compared = 0;
    double lowest = 0.0;
    double worst = 0.0;
    double worstHeight = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double point[3];
      output->GetPoint(i, point);
      point[2] = z->GetComponent(i, 0);
      if (std::isnan(point[2]))
      {
        continue;
      }
      const std::array<double, 3> place = scene.PlaceOf(point);
      ++compared;
      lowest = std::min(lowest, point[2]);
      worst = std::max(worst, exaggeration * std::abs(place[2] - Ridges(place[0])));
      worstHeight = std::max(worstHeight, std::abs(heights->GetComponent(i, 0) - place[2]));
    }
    // 20 x 10 degrees are 954 x 1113 km in the middle
    EXPECT_GT(compared, 38000) << "at " << exaggeration;
    EXPECT_LE(worst, 0.01) << "metres in the scene, at " << exaggeration;
    EXPECT_LE(worstHeight, 1e-3) << "at " << exaggeration;
    // the farthest corner is 787 km off, where the sea lies 48.4 km below the horizon
    EXPECT_GT(lowest, -48500.0) << "at " << exaggeration;
  }
}

TEST(TerrainRoundScene, TheSeaStaysWhereItIs)
{
  RoundScene plain([](double) { return 0.0; }, 1.0, 20000.0);
  RoundScene exaggerated([](double) { return 0.0; }, 50.0, 20000.0);
  vtkDataArray* a = plain.Heights()->GetPointData()->GetScalars();
  vtkDataArray* b = exaggerated.Heights()->GetPointData()->GetScalars();
  ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  vtkIdType compared = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    if (!std::isnan(a->GetComponent(i, 0)))
    {
      ++compared;
      ASSERT_NEAR(
        a->GetComponent(i, 0), b->GetComponent(i, 0), 2.0 * vtkTerrainReproject::VerticalTolerance);
    }
  }
  EXPECT_GT(compared, 2300);
}

TEST(TerrainRoundScene, PlacesLieOnTheTerrain)
{
  for (const double exaggeration : { 1.0, 20.0 })
  {
    RoundScene scene(Ridges, exaggeration, 4000.0);
    for (const char* where : { "10.25,65", "2.25,61", "17.75,69.2", "5.25,63" })
    {
      double point[3];
      ASSERT_EQ(scene.View->FindPlace(where, point), "") << where;
      const std::array<double, 3> ground = scene.PlaceOf(point);
      EXPECT_NEAR(ground[0], std::stod(where), 1e-7) << where;
      EXPECT_NEAR(ground[2], Ridges(ground[0]), 10.0) << where << " at " << exaggeration;
      ASSERT_EQ(scene.View->FindPlace(where + std::string(",700agl"), point), "");
      EXPECT_NEAR(scene.PlaceOf(point)[2] - ground[2], 700.0, 0.01) << where;
      ASSERT_EQ(scene.View->FindPlace(where + std::string(",4000"), point), "");
      EXPECT_NEAR(scene.PlaceOf(point)[2], 4000.0, 1e-6) << where;
      double place[3];
      ASSERT_TRUE(scene.Reference()->SceneToPlaces(point, place, 1));
      EXPECT_NEAR(place[2], 4000.0, 1e-6) << where;
    }
  }
}

TEST(TerrainRoundScene, LinesLieOnTheirPlaces)
{
  RoundScene scene(Ridges, 20.0, 5000.0);
  vtkNew<vtkTerrainDrape> drape;
  drape->SetInputData(Track(scene, 1.0, 19.0));
  drape->SetHeightsData(scene.Heights());
  double farthest[2] = { 0.0, 0.0 };
  for (int known = 0; known < 2; ++known)
  {
    drape->SetGeoreference(known == 1 ? scene.Reference() : nullptr);
    drape->Update();
    vtkPolyData* output = drape->GetOutput();
    ASSERT_EQ(output->GetNumberOfPoints(), 37);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double wanted = 1.0 + 0.5 * static_cast<double>(i);
      const double off = std::abs(scene.PlaceOf(output->GetPoint(i))[0] - wanted);
      farthest[known] = std::max(farthest[known], off);
    }
  }
  EXPECT_LE(farthest[1], 1e-6) << "degrees";
  EXPECT_GE(farthest[0], 0.05) << "a height of 50 km at 8 degrees moves its foot by 6 km";

  vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputData(scene.Heights());
  graticule->SetGeoreference(scene.Reference());
  graticule->SetStep(2.0);
  graticule->Update();
  vtkPolyData* lines = graticule->GetOutput();
  vtkDataArray* values = lines->GetCellData()->GetArray("Value");
  vtkDataArray* axes = lines->GetCellData()->GetArray("Axis");
  ASSERT_GT(lines->GetNumberOfLines(), 10);
  double worst = 0.0;
  vtkIdType compared = 0;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfLines(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    lines->GetLines()->GetCellAtId(cell, count, ids);
    // ends may lie between a point on the terrain and one beyond it
    for (vtkIdType k = 0; k < count; ++k)
    {
      const std::array<double, 3> place = scene.PlaceOf(lines->GetPoint(ids[k]));
      if (place[0] < 1.0 || place[0] > 19.0 || place[1] < 61.0 || place[1] > 69.0)
      {
        continue;
      }
      const auto axis = static_cast<std::size_t>(axes->GetComponent(cell, 0));
      worst = std::max(worst, std::abs(place[axis] - values->GetComponent(cell, 0)));
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_LE(worst, 0.02) << "degrees";
}

// Who sees whom over the sea is a matter of the earth alone: from 100 m each, up to twice the
// distance of the horizon, 2 sqrt(2 R h) = 71.4 km.
TEST(TerrainRoundScene, SightDoesNotDependOnExaggeration)
{
  for (const double exaggeration : { 1.0, 20.0 })
  {
    RoundScene scene([](double) { return 0.0; }, exaggeration, 2000.0);
    scene.View->SetRefraction(0.0);
    for (const double kilometres : { 69.0, 74.0 })
    {
      const double half =
        0.5 * kilometres / (111.32 * std::cos(kLatitude * 3.14159265358979 / 180.0));
      double from[3] = { kLongitude - half, kLatitude, 100.0 };
      double to[3] = { kLongitude + half, kLatitude, 100.0 };
      scene.Reference()->PlacesToScene(from, from, 1);
      scene.Reference()->PlacesToScene(to, to, 1);
      EXPECT_EQ(scene.View->IsVisible(from, to), kilometres < 71.4)
        << kilometres << " km at " << exaggeration;
    }
  }
}
