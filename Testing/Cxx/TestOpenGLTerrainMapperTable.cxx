// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is coloured by a table although VTK's own mappers would leave it alone.
#include "vtkTerrainActor.h"
#include "vtkTerrainTesting.h"
#include "vtkTerrainTestingScene.h"

#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

using vtkTerrainTesting::CountDifferentPixels;
using vtkTerrainTesting::DrawScene;
using vtkTerrainTesting::MakeHills;
using vtkTerrainTesting::TerrainProp;
using vtkTerrainTesting::TerrainScene;

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

/// Colours by the heights; plain mappers interpolate before mapping.
void ColorByHeights(vtkMapper* mapper, double alpha)
{
  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.0, 0.7);
  table->SetAlphaRange(alpha, 1.0);
  table->Build();
  mapper->ScalarVisibilityOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("heights");
  mapper->SetScalarRange(75.0, 125.0);
  mapper->SetLookupTable(table);
}

/// Hills with the heights of whole numbers, in an array of a type; VTK's mappers take bytes for
/// colours by default.
template <typename Array>
vtkSmartPointer<vtkImageData> MakeHillsOf()
{
  const auto hills = MakeHills();
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->DeepCopy(hills->GetPointData()->GetScalars());
  vtkNew<Array> heights;
  heights->DeepCopy(bytes);
  heights->SetName("heights");
  vtkNew<vtkImageData> image;
  image->CopyStructure(hills);
  image->GetPointData()->SetScalars(heights);
  return image;
}
}

//------------------------------------------------------------------------------
// TestOpenGLTerrainMapperColors compares the colours of doubles with those of VTK's mapper.
TEST(OpenGLTerrainMapperTable, HeightsInBytesAreNoColors)
{
  for (const auto technique : { Techniques::Pyramid, Techniques::Linear, Techniques::Mesh })
  {
    // The mesh of this scene has scalars of its own, which VTK asks for their alpha.
    for (const double alpha : { 1.0, technique == Techniques::Mesh ? 1.0 : 0.3 })
    {
      auto paint = [alpha](TerrainScene&, const TerrainProp& terrain)
      { ColorByHeights(terrain.Mapper, alpha); };
      const auto bytes = DrawScene(paint, technique, MakeHillsOf<vtkUnsignedCharArray>());
      const auto doubles = DrawScene(paint, technique, MakeHillsOf<vtkDoubleArray>());
      EXPECT_LE(CountDifferentPixels(bytes, doubles, 4), 20)
        << static_cast<int>(technique) << " " << alpha;
    }
  }
}

// On the lines themselves: the picture of the surface, where both are drawn.
TEST(OpenGLTerrainMapperTable, LinesAndPointsOfAMeshHaveTheColorsOfTheSurface)
{
  auto draw = [](int representation)
  {
    auto paint = [representation](TerrainScene&, const TerrainProp& terrain)
    {
      ColorByHeights(terrain.Mapper, 1.0);
      terrain.Mapper->SetColorSource(vtkOpenGLTerrainMapper::ColorSources::Slope);
      terrain.Mapper->SetScalarRange(0.0, 90.0); // all heights of the mesh itself are above it
      terrain.Actor->GetProperty()->LightingOff();
      terrain.Actor->GetProperty()->SetRepresentation(representation);
    };
    return DrawScene(paint, Techniques::Mesh);
  };
  const auto surface = draw(VTK_SURFACE);
  for (const int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    const auto picture = draw(representation);
    // The fine mesh has a line or a point in most pixels.
    EXPECT_LE(CountDifferentPixels(picture, surface, 30), 200 * 150 / 4) << representation;
  }
}

// Heights beside the edges of a table's colours, by 1/10000 of the range, as the table has them.
TEST(OpenGLTerrainMapperTable, ColorsBeginWhereTheTableHasThem)
{
  constexpr int side = 9;
  constexpr int colors = 8;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(colors);
  table->SetTableRange(0.0, 100.0);
  table->Build();
  const auto scene = vtkTerrainTesting::MakeScene(16, 16);
  vtkNew<vtkTerrainActor> terrain;
  terrain->SetLookupTable(table);
  terrain->GetProperty()->LightingOff();
  scene.Renderer->AddActor(terrain);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(4.0, 4.0, 50.0);
  camera->SetPosition(4.0, 4.0, 300.0);
  camera->SetViewAngle(0.2);
  for (int edge = 1; edge < colors; ++edge)
  {
    for (const double beside : { -0.01, 0.01 })
    {
      const double height = 100.0 * edge / colors + beside;
      const auto heights = vtkSmartPointer<vtkImageData>::New();
      heights->SetDimensions(side, side, 1);
      heights->AllocateScalars(VTK_DOUBLE, 1);
      for (int k = 0; k < side * side; ++k)
      {
        static_cast<double*>(heights->GetScalarPointer())[k] = k == 0 ? 0.0
          : k + 1 == side * side                                      ? 100.0
                                                                      : height;
      }
      terrain->SetInputData(heights);
      scene.Renderer->ResetCameraClippingRange();
      const auto picture = vtkTerrainTesting::Render(scene.Window);
      const unsigned char* expected = table->MapValue(height);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(picture->GetScalarComponentAsDouble(8, 8, 0, c), expected[c], 1.0) << height;
      }
    }
  }
}
