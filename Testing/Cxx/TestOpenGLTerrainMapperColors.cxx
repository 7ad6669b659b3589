// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colours of the surface, judged by VTK's own mapper on a fine mesh with the same arrays.
#include "vtkTerrainActor.h"
#include "vtkTerrainTesting.h"
#include "vtkTerrainTestingScene.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using vtkTerrainTesting::Demands;
using vtkTerrainTesting::DrawsAsTheMesh;
using vtkTerrainTesting::DrawsAsThePlainMesh;
using vtkTerrainTesting::MakeHills;
using vtkTerrainTesting::TerrainProp;
using vtkTerrainTesting::TerrainScene;

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;
using ColorSources = vtkOpenGLTerrainMapper::ColorSources;

/// Seconds, of which float tells those 128 apart.
constexpr double FirstTime = 1.7e9;

/// Hills with the point arrays temperature (NaN in places), wind (3 components), time (far from 0)
/// and paint (RGBA), and the cell arrays zone and stain (RGB).
vtkSmartPointer<vtkImageData> MakeField()
{
  auto image = MakeHills();
  const int* size = image->GetDimensions();
  vtkNew<vtkFloatArray> temperature;
  temperature->SetName("temperature");
  vtkNew<vtkDoubleArray> wind;
  wind->SetName("wind");
  wind->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> time;
  time->SetName("time");
  vtkNew<vtkUnsignedCharArray> paint;
  paint->SetName("paint");
  paint->SetNumberOfComponents(4);
  for (int j = 0; j < size[1]; ++j)
  {
    for (int i = 0; i < size[0]; ++i)
    {
      const bool none = std::hypot(i - 12.0, j - 20.0) < 4.0;
      temperature->InsertNextValue(none ? std::numeric_limits<float>::quiet_NaN()
                                        : 1000.0f + static_cast<float>(std::exp(0.1 * i)));
      time->InsertNextValue(FirstTime + 2.5 * i);
      wind->InsertNextTuple3(std::cos(0.15 * i), 2.0 * std::sin(0.1 * j), 1.0);
      paint->InsertNextTuple4(6.0 * i, 7.0 * j, 120.0, 255.0);
    }
  }
  vtkNew<vtkDoubleArray> zone;
  zone->SetName("zone");
  vtkNew<vtkUnsignedCharArray> stain;
  stain->SetName("stain");
  stain->SetNumberOfComponents(3);
  for (int j = 0; j < size[1] - 1; ++j)
  {
    for (int i = 0; i < size[0] - 1; ++i)
    {
      zone->InsertNextValue((i / 8 + j / 8) % 5);
      stain->InsertNextTuple3(40.0 * (i % 6), 80.0, 30.0 * (j % 7));
    }
  }
  image->GetPointData()->AddArray(temperature);
  image->GetPointData()->AddArray(wind);
  image->GetPointData()->AddArray(time);
  image->GetPointData()->AddArray(paint);
  image->GetCellData()->AddArray(zone);
  image->GetCellData()->AddArray(stain);
  return image;
}

Demands OfField()
{
  Demands demands;
  demands.Heights = MakeField();
  return demands;
}

/// Colours by an array of points or of cells; plain mappers interpolate before mapping.
void ColorBy(vtkMapper* mapper, const char* array, bool cells, double low, double high)
{
  mapper->ScalarVisibilityOn();
  mapper->SetInterpolateScalarsBeforeMapping(!cells);
  if (cells)
  {
    mapper->SetScalarModeToUseCellFieldData();
  }
  else
  {
    mapper->SetScalarModeToUsePointFieldData();
  }
  mapper->SelectColorArray(array);
  mapper->SetScalarRange(low, high);
}

vtkSmartPointer<vtkLookupTable> MakeTable()
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(512);
  table->SetHueRange(0.0, 0.7);
  table->SetNanColor(1.0, 0.0, 1.0, 1.0);
  table->SetBelowRangeColor(0.0, 0.0, 0.0, 1.0);
  table->SetAboveRangeColor(1.0, 1.0, 1.0, 1.0);
  table->UseBelowRangeColorOn();
  table->UseAboveRangeColorOn();
  table->Build();
  return table;
}

/// A picture of squares of changing colours; odd ones are transparent if it has alpha.
vtkSmartPointer<vtkImageData> MakePicture(int components)
{
  constexpr int side = 256;
  vtkNew<vtkUnsignedCharArray> texels;
  texels->SetNumberOfComponents(components);
  texels->SetNumberOfTuples(vtkIdType{ side } * side);
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const int odd = (i / 32 + j / 32) % 2;
      const double colors[4] = { i * 1.0, j * 1.0, 90.0, odd ? 60.0 : 255.0 };
      const double greys[2] = { i * 1.0, odd ? 60.0 : 255.0 };
      texels->SetTuple(i + side * j, components > 2 ? colors : greys);
    }
  }
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(side, side, 1);
  picture->GetPointData()->SetScalars(texels);
  return picture;
}

/// Component of a picture, 0..255, at a position in pixels, bilinearly; times alpha but for alpha
/// itself, which is the last of four components.
double PremultipliedAt(vtkImageData* picture, double x, double y, int component)
{
  const int* size = picture->GetDimensions();
  double sum = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    const double i = std::floor(x) + k % 2;
    const int north = k / 2;
    const double j = std::floor(y) + north;
    const double weight = (1.0 - std::abs(x - i)) * (1.0 - std::abs(y - j));
    const int column = std::clamp(static_cast<int>(i), 0, size[0] - 1);
    const int row = std::clamp(static_cast<int>(j), 0, size[1] - 1);
    const double alpha = picture->GetScalarComponentAsDouble(column, row, 0, 3) / 255.0;
    const double value = picture->GetScalarComponentAsDouble(column, row, 0, component);
    sum += weight * value * (component == 3 ? 1.0 : alpha);
  }
  return sum;
}

/// What a picture with alpha within bounds makes of a colour, over all of the hills.
vtkSmartPointer<vtkImageData> Composite(
  vtkImageData* picture, const double bounds[4], const double color[3])
{
  constexpr int side = 1024;
  const int* size = picture->GetDimensions();
  vtkNew<vtkUnsignedCharArray> texels;
  texels->SetNumberOfComponents(3);
  texels->SetNumberOfTuples(vtkIdType{ side } * side);
  for (vtkIdType index = 0; index < texels->GetNumberOfTuples(); ++index)
  {
    const double x = 400.0 * (index % side) / (side - 1);
    const vtkIdType line = index / side;
    const double y = 384.0 * static_cast<double>(line) / (side - 1);
    const double i = size[0] * (x - bounds[0]) / (bounds[1] - bounds[0]) - 0.5;
    const double j = size[1] * (y - bounds[2]) / (bounds[3] - bounds[2]) - 0.5;
    const bool within = x > bounds[0] && x < bounds[1] && y > bounds[2] && y < bounds[3];
    const double alpha = within ? PremultipliedAt(picture, i, j, 3) / 255.0 : 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double above = within ? PremultipliedAt(picture, i, j, c) : 0.0;
      texels->SetComponent(index, c, above + (1.0 - alpha) * 255.0 * color[c]);
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, 1);
  image->GetPointData()->SetScalars(texels);
  return image;
}

constexpr double Azimuth = 60.0;
constexpr double Altitude = 35.0;

/// Colours the cells of a mesh by their slope and aspect as a sun would.
void ShadeCells(vtkPolyData* mesh, vtkMapper* mapper, vtkActor* actor)
{
  vtkDataArray* slopes = mesh->GetCellData()->GetArray("Slope");
  vtkDataArray* aspects = mesh->GetCellData()->GetArray("Aspect");
  const double altitude = vtkMath::RadiansFromDegrees(Altitude);
  const double* color = actor->GetProperty()->GetColor();
  vtkNew<vtkUnsignedCharArray> shades;
  shades->SetName("Shade");
  shades->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < slopes->GetNumberOfTuples(); ++i)
  {
    const double slope = vtkMath::RadiansFromDegrees(slopes->GetTuple1(i));
    const double turn = vtkMath::RadiansFromDegrees(Azimuth - aspects->GetTuple1(i));
    const double cosine =
      std::sin(altitude) * std::cos(slope) + std::cos(altitude) * std::sin(slope) * std::cos(turn);
    const double shade = 255.0 * std::max(0.0, cosine);
    shades->InsertNextTuple3(shade * color[0], shade * color[1], shade * color[2]);
  }
  mesh->GetCellData()->AddArray(shades);
  ColorBy(mapper, "Shade", true, 0.0, 1.0);
}
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperColors, TranslucentTable)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    ColorBy(mapper, "heights", false, 60.0, 140.0);
    const auto table = MakeTable();
    table->SetAlphaRange(0.1, 0.9);
    table->ForceBuild();
    mapper->SetLookupTable(table);
  };
  auto layered = [&](vtkMapper* mapper, vtkActor* actor)
  {
    color(mapper, actor);
    static_cast<vtkOpenGLTerrainMapper*>(mapper)->SetMaximumLayers(8);
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(layered, color));
}

TEST(OpenGLTerrainMapperColors, TheTableHasTheMappersRange)
{
  vtkNew<vtkLookupTable> table;
  auto color = [&](TerrainScene&, const TerrainProp& terrain)
  {
    terrain.Mapper->ScalarVisibilityOn();
    terrain.Mapper->SetLookupTable(table);
    terrain.Mapper->SetScalarRange(75.0, 125.0);
  };
  vtkTerrainTesting::DrawScene(color);
  EXPECT_EQ(table->GetRange()[0], 75.0); // which a scalar bar shows
  EXPECT_EQ(table->GetRange()[1], 125.0);
}

TEST(OpenGLTerrainMapperColors, HeightsThroughATable)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    ColorBy(mapper, "heights", false, 75.0, 125.0);
    mapper->SetLookupTable(MakeTable());
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(color, color));
}

TEST(OpenGLTerrainMapperColors, PointArrayWithGaps)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    ColorBy(mapper, "temperature", false, 1000.0, 1050.0);
    mapper->SetLookupTable(MakeTable());
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(color, color, OfField()));
}

TEST(OpenGLTerrainMapperColors, ValuesFarFromZero)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    ColorBy(mapper, "time", false, FirstTime, FirstTime + 100.0);
    mapper->SetLookupTable(MakeTable());
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(color, color, OfField()));
}

TEST(OpenGLTerrainMapperColors, LogarithmicScale)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    ColorBy(mapper, "heights", false, 60.0, 140.0);
    const auto table = MakeTable();
    table->SetScaleToLog10();
    mapper->SetLookupTable(table);
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(color, color));
}

TEST(OpenGLTerrainMapperColors, TransferFunction)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    ColorBy(mapper, "heights", false, 60.0, 140.0);
    vtkNew<vtkColorTransferFunction> function;
    function->AddRGBPoint(60.0, 0.0, 0.2, 0.6);
    function->AddRGBPoint(100.0, 0.2, 0.7, 0.1);
    function->AddRGBPoint(140.0, 1.0, 1.0, 0.9);
    mapper->SetLookupTable(function);
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(color, color));
}

TEST(OpenGLTerrainMapperColors, ComponentsAndMagnitude)
{
  for (int component : { -1, 0, 1 })
  {
    auto color = [component](vtkMapper* mapper, vtkActor*)
    {
      ColorBy(mapper, "wind", false, -1.5, 2.5);
      const auto table = MakeTable();
      table->SetVectorMode(
        component < 0 ? vtkScalarsToColors::MAGNITUDE : vtkScalarsToColors::COMPONENT);
      table->SetVectorComponent(std::max(component, 0));
      mapper->SetLookupTable(table);
    };
    EXPECT_TRUE(DrawsAsThePlainMesh(color, color, OfField())) << component;
  }
}

TEST(OpenGLTerrainMapperColors, CellArray)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    ColorBy(mapper, "zone", true, 0.0, 4.0);
    mapper->SetLookupTable(MakeTable());
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(color, color, OfField()));
}

TEST(OpenGLTerrainMapperColors, DirectColors)
{
  for (bool cells : { false, true })
  {
    auto color = [cells](vtkMapper* mapper, vtkActor*)
    {
      ColorBy(mapper, cells ? "stain" : "paint", cells, 0.0, 1.0);
      mapper->InterpolateScalarsBeforeMappingOff();
    };
    EXPECT_TRUE(DrawsAsThePlainMesh(color, color, OfField())) << cells;
  }
}

TEST(OpenGLTerrainMapperColors, SlopeAndAspect)
{
  for (bool slope : { false, true })
  {
    vtkNew<vtkLookupTable> table;
    table->SetHueRange(0.0, slope ? 0.0 : 1.0);
    table->SetSaturationRange(slope ? 0.0 : 0.3, slope ? 0.0 : 0.3);
    table->SetValueRange(slope ? 0.0 : 1.0, 1.0);
    table->SetNumberOfTableValues(1024);
    auto terrain = [&](vtkMapper* mapper, vtkActor*)
    {
      mapper->ScalarVisibilityOn();
      mapper->SetScalarRange(0.0, slope ? 120.0 : 360.0);
      mapper->SetLookupTable(table);
      static_cast<vtkOpenGLTerrainMapper*>(mapper)->SetColorSource(
        slope ? ColorSources::Slope : ColorSources::Aspect);
    };
    auto mesh = [&](vtkMapper* mapper, vtkActor*)
    {
      ColorBy(mapper, slope ? "Slope" : "Aspect", true, 0.0, slope ? 120.0 : 360.0);
      mapper->SetLookupTable(table);
    };
    Demands demands;
    demands.Parts = 15; // each triangle of the mesh has one colour
    EXPECT_TRUE(DrawsAsThePlainMesh(terrain, mesh, demands)) << slope;
  }
}

TEST(OpenGLTerrainMapperColors, ActorsTexture)
{
  for (int components : { 3, 4 })
  {
    auto dress = [components](vtkMapper*, vtkActor* actor)
    {
      vtkNew<vtkTexture> texture;
      texture->SetInputData(MakePicture(components));
      texture->InterpolateOn();
      actor->SetTexture(texture);
    };
    EXPECT_TRUE(DrawsAsThePlainMesh(dress, dress)) << components;
    Demands demands;
    demands.Technique = Techniques::Equidistant;
    EXPECT_TRUE(components == 4 || DrawsAsThePlainMesh(dress, dress, demands));
  }
}

TEST(OpenGLTerrainMapperColors, DrapeOverTheWholeTerrain)
{
  auto terrain = [](vtkMapper* mapper, vtkActor*)
  {
    const double bounds[4] = { 0.0, 400.0, 0.0, 384.0 };
    static_cast<vtkOpenGLTerrainMapper*>(mapper)->SetDrape(MakePicture(3), bounds);
  };
  auto mesh = [](vtkMapper*, vtkActor* actor)
  {
    vtkNew<vtkTexture> texture;
    texture->SetInputData(MakePicture(3));
    texture->InterpolateOn();
    texture->MipmapOn();
    actor->SetTexture(texture);
    actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    actor->GetProperty()->SetAmbient(1.0);
    actor->GetProperty()->SetDiffuse(0.0);
  };
  auto white = [&](vtkMapper* mapper, vtkActor* actor)
  {
    terrain(mapper, actor);
    actor->GetProperty()->SetAmbient(1.0);
    actor->GetProperty()->SetDiffuse(0.0);
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(white, mesh));
}

TEST(OpenGLTerrainMapperColors, DrapeWithAlphaOverAPart)
{
  constexpr double bounds[4] = { 100.0, 300.0, 96.0, 288.0 };
  auto dim = [](vtkActor* actor)
  {
    actor->GetProperty()->SetAmbient(1.0);
    actor->GetProperty()->SetDiffuse(0.0);
  };
  auto terrain = [&](vtkMapper* mapper, vtkActor* actor)
  {
    const auto picture = MakePicture(4);
    picture->SetSpacing(200.0 / 256.0, 192.0 / 256.0, 1.0);
    picture->SetOrigin(100.0 + 100.0 / 256.0, 96.0 + 96.0 / 256.0, 0.0);
    static_cast<vtkOpenGLTerrainMapper*>(mapper)->SetDrape(picture); // the bounds above
    dim(actor);
  };
  auto mesh = [&](vtkMapper*, vtkActor* actor)
  {
    vtkNew<vtkTexture> texture;
    texture->SetInputData(Composite(MakePicture(4), bounds, actor->GetProperty()->GetColor()));
    texture->InterpolateOn();
    texture->MipmapOn();
    texture->SetMaximumAnisotropicFiltering(1.0f);
    actor->SetTexture(texture);
    actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    dim(actor);
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(terrain, mesh));
}

TEST(OpenGLTerrainMapperColors, Hillshade)
{
  auto terrain = [](vtkMapper* mapper, vtkActor*)
  {
    auto* rays = static_cast<vtkOpenGLTerrainMapper*>(mapper);
    rays->SetHillshade(true);
    rays->SetHillshadeAzimuth(Azimuth);
    rays->SetHillshadeAltitude(Altitude);
  };
  auto mesh = [](vtkMapper* mapper, vtkActor* actor)
  { ShadeCells(static_cast<vtkPolyDataMapper*>(mapper)->GetInput(), mapper, actor); };
  Demands demands;
  demands.Parts = 15; // each triangle of the mesh has one colour
  EXPECT_TRUE(DrawsAsThePlainMesh(terrain, mesh, demands));
}

// A plane at 45 degrees, down to the west, has one shade: that of Horn, Hill Shading and the
// Reflectance Map, Proc. IEEE 69, 1981, Eq. for a Lambertian surface. Two degrees are 5 of 255.
TEST(OpenGLTerrainMapperColors, HillshadeOfAPlane)
{
  constexpr int side = 9;
  const auto heights = vtkSmartPointer<vtkImageData>::New();
  heights->SetDimensions(side, side, 1);
  heights->AllocateScalars(VTK_FLOAT, 1);
  for (int k = 0; k < side * side; ++k)
  {
    static_cast<float*>(heights->GetScalarPointer())[k] = static_cast<float>(k % side);
  }
  const auto scene = vtkTerrainTesting::MakeScene(16, 16);
  vtkNew<vtkTerrainActor> terrain;
  terrain->SetInputData(heights);
  terrain->SetColorByHeight(false);
  terrain->GetProperty()->LightingOff();
  terrain->GetProperty()->SetColor(1.0, 1.0, 1.0);
  scene.Renderer->AddActor(terrain);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(4.0, 4.0, 4.0);
  camera->SetPosition(4.0, 4.0, 14.0);
  camera->SetViewAngle(10.0);
  scene.Renderer->ResetCameraClippingRange();
  vtkOpenGLTerrainMapper* mapper = terrain->GetTerrainMapper();
  mapper->SetHillshade(true);
  for (const double altitude : { 20.0, 45.0, 80.0 })
  {
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 30.0)
    {
      mapper->SetHillshadeAzimuth(azimuth);
      mapper->SetHillshadeAltitude(altitude);
      const double slope = vtkMath::RadiansFromDegrees(45.0);
      const double sun = vtkMath::RadiansFromDegrees(altitude);
      const double turn = vtkMath::RadiansFromDegrees(azimuth - 270.0);
      const double shade =
        std::sin(sun) * std::cos(slope) + std::cos(sun) * std::sin(slope) * std::cos(turn);
      const auto picture = vtkTerrainTesting::Render(scene.Window);
      EXPECT_NEAR(
        picture->GetScalarComponentAsDouble(8, 8, 0, 1), 255.0 * std::max(shade, 0.0), 1.0)
        << azimuth << ' ' << altitude;
    }
  }
}

TEST(OpenGLTerrainMapperColors, AllTogether)
{
  auto paint = [](TerrainScene&, const TerrainProp& terrain)
  {
    const double bounds[4] = { 100.0, 300.0, 96.0, 288.0 };
    terrain.Mapper->ScalarVisibilityOn();
    terrain.Mapper->SetScalarRange(60.0, 140.0);
    terrain.Mapper->SetDrape(MakePicture(4), bounds);
    terrain.Mapper->SetContours(true);
    terrain.Mapper->SetContourInterval(10.0);
    terrain.Mapper->SetHillshade(true);
  };
  Demands demands;
  demands.StockMean = 0.0;
  EXPECT_TRUE(DrawsAsTheMesh(paint, demands));
}
