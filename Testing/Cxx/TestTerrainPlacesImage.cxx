// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures of a place: the island of Examples/Places with its orthophoto, which is in UTM where the
// heights are in degrees, the route that the photo shows as a light path, and a graticule. Beside
// each picture one number.
#include "vtkTerrainTesting.h"

#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainDrape.h"
#include "vtkTerrainGeoTransform.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainGraticule.h"
#include "vtkTerrainImageWarp.h"
#include "vtkTerrainPicker.h"
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainReproject.h"
#include "vtkTerrainViewpoint.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTransformFilter.h"

#include <gdal.h>
#include <ogr_api.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{
using FrameType = vtkTerrainGeoreference::FrameType;

constexpr int Width = 320;
constexpr int Height = 240;

std::string ExamplePath(const std::string& file)
{
  const char* baselines = std::getenv("VTKTERRAIN_BASELINE_DIR");
  return std::string(baselines ? baselines : ".") + "/../../../Examples/Places/" + file;
}

/// The route as one line of longitudes and latitudes.
vtkSmartPointer<vtkPolyData> ReadRoute()
{
  GDALAllRegister();
  auto route = vtkSmartPointer<vtkPolyData>::New();
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> lines;
  GDALDatasetH file =
    GDALOpenEx(ExamplePath("route.gpx").c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr);
  OGRLayerH layer = GDALDatasetGetLayerByName(file, "tracks");
  OGRFeatureH feature = OGR_L_GetNextFeature(layer);
  OGRGeometryH line = OGR_G_GetGeometryRef(OGR_F_GetGeometryRef(feature), 0);
  lines->InsertNextCell(OGR_G_GetPointCount(line));
  for (int i = 0; i < OGR_G_GetPointCount(line); ++i)
  {
    lines->InsertCellPoint(points->InsertNextPoint(OGR_G_GetX(line, i), OGR_G_GetY(line, i), 0.0));
  }
  OGR_F_Destroy(feature);
  GDALClose(file);
  route->SetPoints(points);
  route->SetLines(lines);
  return route;
}

/// The island in a frame, with its photo.
class Island
{
public:
  explicit Island(FrameType frame = FrameType::Plane)
  {
    this->Reader->SetFileName(ExamplePath("heights.tif"));
    this->Heights->SetInputConnection(this->Reader->GetOutputPort());
    this->Heights->GetGeoreference()->SetFrame(frame);
    this->Heights->Update();
    EXPECT_EQ(this->Heights->GetErrorMessage(), "");
    this->Photo->SetInputConnection(this->Heights->GetOutputPort());
    this->Photo->SetGeoreference(this->Georeference());
    this->Photo->SetFileName(ExamplePath("photo.tif"));
    this->Photo->Update();
    EXPECT_EQ(this->Photo->GetErrorMessage(), "");
    this->ToScene->SetGeoreference(this->Georeference());
    this->Placed->SetInputData(ReadRoute());
    this->Placed->SetTransform(this->ToScene);
    this->Placed->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    this->Route->SetInputConnection(this->Placed->GetOutputPort());
    this->Route->SetHeightsConnection(this->Heights->GetOutputPort());
    this->Route->SetOffset(12.0);
    this->Route->Update();
  }

  vtkTerrainGeoreference* Georeference()
  {
    return this->Heights->GetGeoreference();
  }

  /// Adds the terrain under one light, and a camera of the south-west.
  void Show(vtkRenderer* renderer, bool withPhoto)
  {
    const vtkNew<vtkOpenGLTerrainMapper> mapper;
    mapper->SetHeightsConnection(this->Heights->GetOutputPort());
    mapper->ScalarVisibilityOff();
    if (withPhoto)
    {
      mapper->SetDrape(this->Photo->GetOutput());
    }
    const vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.75, 0.72, 0.66);
    actor->GetProperty()->SetAmbient(0.2);
    renderer->AddActor(actor);
    const vtkNew<vtkTerrainViewpoint> viewpoint;
    viewpoint->SetGeoreference(this->Georeference());
    viewpoint->SetHeights(this->Heights->GetOutput());
    EXPECT_EQ(
      viewpoint->Look("-18.13,64.94,5200", "-18.009,64.996", renderer->GetActiveCamera()), "");
    const vtkNew<vtkLight> sun;
    EXPECT_EQ(viewpoint->SetSun("2024-06-21T09:00Z", sun), "");
    renderer->AddLight(sun);
    renderer->ResetCameraClippingRange();
  }

  vtkNew<vtkTerrainRasterReader> Reader;
  vtkNew<vtkTerrainReproject> Heights;
  vtkNew<vtkTerrainImageWarp> Photo;
  vtkNew<vtkTerrainGeoTransform> ToScene;
  vtkNew<vtkTransformFilter> Placed;
  vtkNew<vtkTerrainDrape> Route;
};

void AddLines(
  vtkRenderer* renderer, vtkPolyData* lines, double red, double green, double blue, float width)
{
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  mapper->ScalarVisibilityOff();
  const vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, blue);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(width);
  renderer->AddActor(actor);
}

/// Share of the pixels of a colour, each channel within 8.
double ShareOf(vtkImageData* picture, int red, int green, int blue)
{
  constexpr int kNear = 8;
  int found = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
      found += std::abs(pixel[0] - red) < kNear && std::abs(pixel[1] - green) < kNear &&
          std::abs(pixel[2] - blue) < kNear
        ? 1
        : 0;
    }
  }
  return static_cast<double>(found) / (Width * Height);
}
}

//------------------------------------------------------------------------------
TEST(TerrainPlacesImage, PhotoAndRoute)
{
  Island island;
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(Width, Height);
  island.Show(scene.Renderer, true);
  AddLines(scene.Renderer, island.Route->GetOutput(), 0.85, 0.1, 0.08, 2.0F);
  const auto picture = vtkTerrainTesting::Render(scene.Window);
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(picture, "TerrainPlacesPhoto"));
  EXPECT_NEAR(ShareOf(picture, 217, 26, 20), 0.0075, 0.0008);
}

TEST(TerrainPlacesImage, Graticule)
{
  Island island;
  const vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputConnection(island.Heights->GetOutputPort());
  graticule->SetGeoreference(island.Georeference());
  graticule->SetNumberOfLines(8);
  graticule->SetOffset(15.0);
  graticule->Update();
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(Width, Height);
  island.Show(scene.Renderer, false);
  AddLines(scene.Renderer, graticule->GetOutput(), 0.1, 0.3, 0.9, 1.0F);
  const auto picture = vtkTerrainTesting::Render(scene.Window);
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(picture, "TerrainPlacesGraticule"));
  EXPECT_NEAR(ShareOf(picture, 26, 77, 230), 0.0357, 0.004);
}

TEST(TerrainPlacesImage, PickedPlacesAreMeasured)
{
  // what vtkTerrainPicker gives are scene points, which vtkTerrainViewpoint takes
  Island island;
  const vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(Width, Height);
  island.Show(scene.Renderer, false);
  vtkTerrainTesting::Render(scene.Window);
  const vtkNew<vtkTerrainViewpoint> viewpoint;
  viewpoint->SetGeoreference(island.Georeference());
  viewpoint->SetHeights(island.Heights->GetOutput());
  viewpoint->SetRefraction(1.0); // light goes straight, as in the picture
  const vtkNew<vtkTerrainPicker> picker;
  double picked[2][3];
  for (int k = 0; k < 2; ++k)
  {
    ASSERT_NE(picker->Pick(80.5 + 130.0 * k, 60.5 + 20.0 * k, 0.0, scene.Renderer), 0);
    ASSERT_TRUE(picker->IsTerrainPicked());
    picker->GetPickPosition(picked[k]);
    EXPECT_TRUE(viewpoint->IsVisible(scene.Renderer->GetActiveCamera()->GetPosition(), picked[k]));
    EXPECT_NE(island.Georeference()->GetReadout(picked[k]).find("27W"), std::string::npos)
      << island.Georeference()->GetReadout(picked[k]);
  }
  double azimuth = 0.0;
  const double distance = viewpoint->GetDistance(picked[0], picked[1], &azimuth);
  const double east = picked[1][0] - picked[0][0];
  const double north = picked[1][1] - picked[0][1];
  EXPECT_NEAR(distance / std::hypot(east, north), 1.0, 1e-5);
  EXPECT_NEAR(azimuth, vtkMath::DegreesFromRadians(std::atan2(east, north)), 0.1);
  const vtkNew<vtkPolyData> profile;
  EXPECT_EQ(viewpoint->GetProfile(picked[0], picked[1], 50, profile), "");
  vtkDataArray* heights = profile->GetPointData()->GetArray("Height");
  ASSERT_EQ(heights->GetNumberOfTuples(), 50);
  EXPECT_NEAR(heights->GetComponent(0, 0), picked[0][2], 0.01);
  EXPECT_NEAR(heights->GetComponent(49, 0), picked[1][2], 0.01);
}

TEST(TerrainPlacesImage, RouteLiesOnThePathOfThePhoto)
{
  // the path is 28 m wide, lighter than all round it; a pixel is 10 m
  for (const FrameType frame : { FrameType::Plane, FrameType::Local, FrameType::Zone })
  {
    Island island(frame);
    vtkImageData* photo = island.Photo->GetOutput();
    vtkPolyData* route = island.Route->GetOutput();
    ASSERT_GT(route->GetNumberOfPoints(), 200);
    int onPath = 0;
    int aside = 0;
    const auto isLight = [photo](double x, double y)
    {
      int index[3];
      double parts[3];
      double point[3] = { x, y, 0.0 };
      if (!photo->ComputeStructuredCoordinates(point, index, parts))
      {
        return false;
      }
      const auto* color = static_cast<unsigned char*>(photo->GetScalarPointer(
        index[0] + (parts[0] > 0.5 ? 1 : 0), index[1] + (parts[1] > 0.5 ? 1 : 0), 0));
      return color[3] == 255 && color[0] > 200 && color[2] < 215 && color[0] > color[2] + 20;
    };
    for (vtkIdType i = 0; i < route->GetNumberOfPoints(); ++i)
    {
      const double* point = route->GetPoint(i);
      onPath += isLight(point[0], point[1]) ? 1 : 0;
      aside += isLight(point[0] + 40.0, point[1] + 40.0) ? 1 : 0;
    }
    EXPECT_GT(onPath, 0.95 * route->GetNumberOfPoints()) << static_cast<int>(frame);
    EXPECT_LT(aside, 0.4 * route->GetNumberOfPoints()) << static_cast<int>(frame);
  }
}
