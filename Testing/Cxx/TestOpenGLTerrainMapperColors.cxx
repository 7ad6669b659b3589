// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colours of the surface, judged by VTK's own mapper on a fine mesh with the same arrays.
#include "vtkTerrainTestingScene.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

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

/// Hills with the point arrays temperature (NaN in places), wind (3 components) and paint (RGBA),
/// and the cell arrays zone and stain (RGB).
vtkSmartPointer<vtkImageData> makeField()
{
  auto image = MakeHills();
  const int* size = image->GetDimensions();
  vtkNew<vtkFloatArray> temperature;
  temperature->SetName("temperature");
  vtkNew<vtkDoubleArray> wind;
  wind->SetName("wind");
  wind->SetNumberOfComponents(3);
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
  image->GetPointData()->AddArray(paint);
  image->GetCellData()->AddArray(zone);
  image->GetCellData()->AddArray(stain);
  return image;
}

Demands ofField()
{
  Demands demands;
  demands.Heights = makeField();
  return demands;
}

/// Colours by an array of points or of cells; plain mappers interpolate before mapping.
void colorBy(vtkMapper* mapper, const char* array, bool cells, double low, double high)
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

vtkSmartPointer<vtkLookupTable> makeTable()
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
vtkSmartPointer<vtkImageData> makePicture(int components)
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
}

//------------------------------------------------------------------------------
TEST(OpenGLTerrainMapperColors, HeightsThroughATable)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    colorBy(mapper, "heights", false, 75.0, 125.0);
    mapper->SetLookupTable(makeTable());
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(color, color));
}

TEST(OpenGLTerrainMapperColors, PointArrayWithGaps)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    colorBy(mapper, "temperature", false, 1000.0, 1050.0);
    mapper->SetLookupTable(makeTable());
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(color, color, ofField()));
}

TEST(OpenGLTerrainMapperColors, LogarithmicScale)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    colorBy(mapper, "heights", false, 60.0, 140.0);
    const auto table = makeTable();
    table->SetScaleToLog10();
    mapper->SetLookupTable(table);
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(color, color));
}

TEST(OpenGLTerrainMapperColors, TransferFunction)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    colorBy(mapper, "heights", false, 60.0, 140.0);
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
      colorBy(mapper, "wind", false, -1.5, 2.5);
      const auto table = makeTable();
      table->SetVectorMode(
        component < 0 ? vtkScalarsToColors::MAGNITUDE : vtkScalarsToColors::COMPONENT);
      table->SetVectorComponent(std::max(component, 0));
      mapper->SetLookupTable(table);
    };
    EXPECT_TRUE(DrawsAsThePlainMesh(color, color, ofField())) << component;
  }
}

TEST(OpenGLTerrainMapperColors, CellArray)
{
  auto color = [](vtkMapper* mapper, vtkActor*)
  {
    colorBy(mapper, "zone", true, 0.0, 4.0);
    mapper->SetLookupTable(makeTable());
  };
  EXPECT_TRUE(DrawsAsThePlainMesh(color, color, ofField()));
}

TEST(OpenGLTerrainMapperColors, DirectColors)
{
  for (bool cells : { false, true })
  {
    auto color = [cells](vtkMapper* mapper, vtkActor*)
    {
      colorBy(mapper, cells ? "stain" : "paint", cells, 0.0, 1.0);
      mapper->InterpolateScalarsBeforeMappingOff();
    };
    EXPECT_TRUE(DrawsAsThePlainMesh(color, color, ofField())) << cells;
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
      colorBy(mapper, slope ? "Slope" : "Aspect", true, 0.0, slope ? 120.0 : 360.0);
      mapper->SetLookupTable(table);
    };
    Demands demands;
    demands.Share = 0.99; // the mesh has steps of a fifth of a cell
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
      texture->SetInputData(makePicture(components));
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
    static_cast<vtkOpenGLTerrainMapper*>(mapper)->SetDrape(makePicture(3), bounds);
  };
  auto mesh = [](vtkMapper*, vtkActor* actor)
  {
    vtkNew<vtkTexture> texture;
    texture->SetInputData(makePicture(3));
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
