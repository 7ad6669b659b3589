// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The same terrain near the origin, in UTM coordinates and on the earth's surface in geocentric
// ones: the same pictures, and nothing trembles on the way from 100 km to 2 m.
#include "vtkTerrainTesting.h"

#include "vtkTerrainActor.h"
#include "vtkTerrainDepthPass.h"
#include "vtkTerrainPicker.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkShortArray.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace
{
using Point = std::array<double, 3>;

constexpr int Columns = 65;
constexpr int Rows = 49;
constexpr double Spacing = 100.0;

/// Whole metres, which the graphics card stores without loss.
double Hill(int i, int j)
{
  return std::round(
    400.0 + 250.0 * std::sin(0.3 * i) * std::cos(0.25 * j) + 15.0 * ((i * 7 + j * 13) % 5));
}

/// A place of the terrain: where its image and its actor put it.
struct Place
{
  std::string Name;
  Point ImageOrigin{};
  /// Position and orientation (degrees about x and z) of the actor.
  Point ActorPosition{};
  double TiltX = 0.0;
  double TurnZ = 0.0;
};

/// At 6.4e6 from the earth's centre, turned as east, north, up are there.
const Place Geocentric{ "geocentric", {}, { 4100000.0, 1000000.0, 4812000.0 }, 41.0, 104.0 };

/// A terrain at a place, and a camera that moves with it.
class PlacedTerrain
{
public:
  PlacedTerrain(const Place& place, int width, int height)
    : Scene(vtkTerrainTesting::MakeScene(width, height))
  {
    vtkNew<vtkShortArray> heights;
    for (int id = 0; id < Columns * Rows; ++id)
    {
      heights->InsertNextValue(static_cast<short>(Hill(id % Columns, id / Columns)));
    }
    vtkNew<vtkImageData> image;
    image->SetDimensions(Columns, Rows, 1);
    image->SetOrigin(place.ImageOrigin.data());
    image->SetSpacing(Spacing, Spacing, 1.0);
    image->GetPointData()->SetScalars(heights);
    this->Terrain->SetInputData(image);

    vtkNew<vtkTransform> placing;
    placing->Translate(place.ActorPosition.data());
    placing->RotateX(place.TiltX);
    placing->RotateZ(place.TurnZ);
    this->Terrain->SetUserMatrix(placing->GetMatrix());
    this->LocalToWorld->SetMatrix(placing->GetMatrix());
    this->LocalToWorld->Translate(place.ImageOrigin.data());
    this->Scene.Renderer->AddActor(this->Terrain);
  }

  vtkCamera* Camera()
  {
    return this->Scene.Renderer->GetActiveCamera();
  }

  /// Eye and focal point in metres from the first sample, and distances that are seen.
  void Look(const Point& eye, const Point& focalPoint, double nearest, double farthest)
  {
    const double up[3] = { 0.0, 0.0, 1.0 };
    this->Camera()->SetPosition(this->LocalToWorld->TransformPoint(eye.data()));
    this->Camera()->SetFocalPoint(this->LocalToWorld->TransformPoint(focalPoint.data()));
    this->Camera()->SetViewUp(this->LocalToWorld->TransformVector(up));
    this->Camera()->SetClippingRange(nearest, farthest);
  }

  vtkSmartPointer<vtkImageData> Draw()
  {
    return vtkTerrainTesting::Render(this->Scene.Window);
  }

  vtkImageData* Distances()
  {
    this->Scene.Renderer->SetPass(this->Pass);
    this->Scene.Window->Render();
    this->Scene.Renderer->SetPass(nullptr);
    return this->Pass->GetDistances();
  }

  /// Distance of the surface along the viewing direction in the centre of a pixel; NaN if it is not
  /// there.
  double ExactDistance(int x, int y)
  {
    if (!this->Picker->Pick(x + 0.5, y + 0.5, 0.0, this->Scene.Renderer))
    {
      return vtkMath::Nan();
    }
    double offset[3];
    vtkMath::Subtract(this->Picker->GetPickPosition(), this->Camera()->GetPosition(), offset);
    return vtkMath::Dot(offset, this->Camera()->GetDirectionOfProjection());
  }

private:
  vtkTerrainTesting::Scene Scene;
  vtkNew<vtkTerrainActor> Terrain;
  vtkNew<vtkTransform> LocalToWorld;
  vtkNew<vtkTerrainDepthPass> Pass;
  vtkNew<vtkTerrainPicker> Picker;
};

/// On the surface at a sample, and the point at a distance from it to the south-east and up.
const Point Target{ 30.0 * Spacing, 20.0 * Spacing, Hill(30, 20) };

Point EyeAt(double distance)
{
  return { Target[0] + 0.48 * distance, Target[1] - 0.36 * distance, Target[2] + 0.8 * distance };
}

double ApproachDistance(int frame, int frames)
{
  return 1e5 * std::pow(2.0 / 1e5, static_cast<double>(frame) / (frames - 1));
}
}

//------------------------------------------------------------------------------
TEST(TerrainLargeCoordinates, ShowTheSamePicture)
{
  const Place origin{ "origin" };
  PlacedTerrain atOrigin(origin, 160, 120);
  const std::array<Place, 3> places{ { { "UTM", { 500000.0, 5000000.0, 0.0 } },
    { "UTM by the actor", {}, { 500000.0, 5000000.0, 0.0 } }, Geocentric } };
  for (const Place& place : places)
  {
    PlacedTerrain far(place, 160, 120);
    for (const double distance : { 12000.0, 900.0, 30.0 })
    {
      for (PlacedTerrain* terrain : { &atOrigin, &far })
      {
        terrain->Look(EyeAt(distance), Target, 0.4 * distance, distance + 12000.0);
      }
      const auto expected = atOrigin.Draw();
      EXPECT_LE(vtkTerrainTesting::CountDifferentPixels(far.Draw(), expected, 2), 19)
        << place.Name << " from " << distance << " m";
    }
  }
}

// 300 frames of a small picture: each distance that is drawn is the exact one, of which no part
// hangs on the frame before.
TEST(TerrainLargeCoordinates, NothingTremblesOnTheWayDown)
{
  constexpr int Frames = 300;
  constexpr int PixelsX = 20;
  constexpr int PixelsY = 15;
  constexpr double Precision = vtkOpenGLTerrainMapper::HitError;
  PlacedTerrain terrain(Geocentric, PixelsX, PixelsY);
  terrain.Camera()->SetViewAngle(6.0);
  int wrong = 0;
  int compared = 0;
  double largest = 0.0;
  for (int frame = 0; frame < Frames; ++frame)
  {
    const double distance = ApproachDistance(frame, Frames);
    terrain.Look(EyeAt(distance), Target, 0.4 * distance, distance + 12000.0);
    vtkImageData* distances = terrain.Distances();
    for (int y = 1; y < PixelsY; y += 4)
    {
      for (int x = 1; x < PixelsX; x += 4)
      {
        const double exact = terrain.ExactDistance(x, y);
        const double drawn = distances->GetScalarComponentAsDouble(x, y, 0, 0);
        if (std::isnan(exact) && std::isnan(drawn))
        {
          continue;
        }
        const double error = std::abs(drawn - exact) / exact;
        wrong += error <= Precision ? 0 : 1;
        largest = error > largest && error <= Precision ? error : largest;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 4000);
  EXPECT_LE(wrong, compared / 1000) << "silhouettes; the largest error elsewhere is " << largest;
}
