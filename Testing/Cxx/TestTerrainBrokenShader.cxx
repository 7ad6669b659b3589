// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Shaders that the driver refuses: one error with its words, and a scene without the terrain.
#include "vtkTerrainActor.h"
#include "vtkTerrainSource.h"
#include "vtkTerrainTesting.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <string>
#include <vector>

using namespace vtkTerrainTesting;

namespace
{
/// Texts of errors, one by one.
class Errors : public vtkCommand
{
public:
  static Errors* New()
  {
    return new Errors;
  }
  void Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* text) override
  {
    this->Texts.emplace_back(static_cast<const char*>(text));
  }
  std::vector<std::string> Texts;
};

/// Pixels of the next picture that are not the black background.
int CountDrawn(const Scene& scene)
{
  return CountPixels(Render(scene.Window),
    [](const unsigned char* pixel) { return pixel[0] + pixel[1] + pixel[2] > 0; });
}

class TerrainBrokenShader : public testing::TestWithParam<vtkOpenGLTerrainMapper::Techniques>
{
protected:
  void SetUp() override
  {
    const vtkNew<vtkTerrainSource> source;
    source->SetDimensions(33, 33);
    this->Terrain->SetInputConnection(source->GetOutputPort());
    this->Terrain->SetTechnique(this->GetParam());
    this->Terrain->GetProperty()->LightingOff();
    this->Scene.Renderer->AddActor(this->Terrain);
    this->Terrain->GetTerrainMapper()->AddObserver(vtkCommand::ErrorEvent, this->Reported);
    this->Scene.Renderer->GetActiveCamera()->SetPosition(0.0, -1.0, 1.0);
    this->Scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    this->Scene.Renderer->ResetCamera();
  }

  /// Replaces a tag of the fragment shader; "" restores it.
  void Replace(const char* code)
  {
    this->Terrain->GetShaderProperty()->ClearAllFragmentShaderReplacements();
    if (code[0] != '\0')
    {
      this->Terrain->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Light::Impl", true, code, false);
    }
  }

  vtkTerrainTesting::Scene Scene = MakeScene(64, 48);
  const vtkNew<vtkTerrainActor> Terrain;
  const vtkNew<Errors> Reported;
};
}

TEST_P(TerrainBrokenShader, IsOneErrorAndDrawsNothing)
{
  const int whole = CountDrawn(this->Scene);
  ASSERT_GT(whole, 500);

  const ExpectedGLErrors said; // drivers report what they do not compile
  this->Replace("  thisIsNoGLSL(;\n//VTK::Light::Impl\n");
  EXPECT_EQ(CountDrawn(this->Scene), 0);
  ASSERT_EQ(this->Reported->Texts.size(), 1U);
  EXPECT_NE(this->Reported->Texts[0].find("do not build"), std::string::npos);
  EXPECT_NE(this->Reported->Texts[0].find("syntax error"), std::string::npos);
  for (int frame = 0; frame < 3; ++frame)
  {
    this->Scene.Renderer->GetActiveCamera()->Azimuth(10.0);
    EXPECT_EQ(CountDrawn(this->Scene), 0);
  }
  this->Terrain->GetProperty()->SetColor(1.0, 0.5, 0.5); // VTK builds the program again
  this->Terrain->GetShaderProperty()->Modified();
  EXPECT_EQ(CountDrawn(this->Scene), 0);
  EXPECT_EQ(this->Reported->Texts.size(), 1U);

  this->Replace("");
  EXPECT_GT(CountDrawn(this->Scene), whole / 2);
  EXPECT_EQ(this->Reported->Texts.size(), 1U);
}

TEST_P(TerrainBrokenShader, SaysWhatDoesNotLink)
{
  this->Terrain->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Color::Dec", true, "float terrainNowhere(float value);\n//VTK::Color::Dec\n", false);
  this->Terrain->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
    "  gl_FragData[0] = vec4(terrainNowhere(vertexVC.x));\n//VTK::Light::Impl\n", false);
  EXPECT_EQ(CountDrawn(this->Scene), 0);
  EXPECT_EQ(CountDrawn(this->Scene), 0);
  ASSERT_EQ(this->Reported->Texts.size(), 1U);
  EXPECT_NE(this->Reported->Texts[0].find("terrainNowhere"), std::string::npos);
}

// A vtkShaderProperty's own code, which is not VTK's, is followed or refused as VTK's is.
TEST_P(TerrainBrokenShader, SaysWhereDepthsWouldBeTheProxys)
{
  const bool castsRays = GetParam() == vtkOpenGLTerrainMapper::Techniques::Pyramid;
  this->Replace("  gl_FragData[0] = vec4(gl_FragCoord.xy, 1.0, gl_FrontFacing ? 1.0 : 0.0);\n"
                "  gl_FragData[0].z += gl_FragCoord.z;\n//VTK::Light::Impl\n");
  EXPECT_GT(CountDrawn(this->Scene), 500);
  EXPECT_TRUE(this->Reported->Texts.empty()) << this->Reported->Texts[0];
  this->Replace("  gl_FragData[0] = vec4(1.0) + gl_FragCoord;\n//VTK::Light::Impl\n");
  EXPECT_GT(CountDrawn(this->Scene), 500);
  EXPECT_GT(CountDrawn(this->Scene), 500);
  ASSERT_EQ(this->Reported->Texts.size(), castsRays ? 1U : 0U);
  EXPECT_TRUE(!castsRays ||
    this->Reported->Texts[0].find("gl_FragCoord;\": depths would be the proxy's") !=
      std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Techniques, TerrainBrokenShader,
  testing::Values(vtkOpenGLTerrainMapper::Techniques::Pyramid,
    vtkOpenGLTerrainMapper::Techniques::Mesh, vtkOpenGLTerrainMapper::Techniques::Strips));
