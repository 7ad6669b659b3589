// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is coloured by a table although VTK's own mappers would leave it alone.
#include "vtkTerrainTestingScene.h"

#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
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
