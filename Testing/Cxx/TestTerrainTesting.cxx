// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The helpers of the tests, tested.
#include "vtkTerrainTesting.h"

#include "vtkShaderProgram.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

using namespace vtkTerrainTesting;

namespace
{
vtkSmartPointer<vtkImageData> MakePicture(int width, int height, unsigned char value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill_n(pixels, 3 * width * height, value);
  return image;
}
}

//------------------------------------------------------------------------------
TEST(TestTerrainTesting, ShaderReturnsFloatsUnrounded)
{
  // 1500 items: more than one row of the texture, and a last row that is not full.
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-1e6F, 1e6F);
  std::vector<float> values(6000);
  for (float& value : values)
  {
    value = uniform(random);
  }
  values[0] = 1.0F + std::numeric_limits<float>::epsilon();
  values[1] = 16777213.0F;
  values[2] = std::numeric_limits<float>::max();

  const Scene scene = MakeScene(64, 64);
  const std::vector<float> result = RunShader(scene.Window, "", "result = input0;", { values });
  EXPECT_EQ(result, values);
}

//------------------------------------------------------------------------------
TEST(TestTerrainTesting, ShaderSeesFunctionsInputsAndUniforms)
{
  const Scene scene = MakeScene(64, 64);
  const std::vector<float> a = { 1, 2, 3, 4, 5, 6, 7, 8 };
  const std::vector<float> b = { 10, 20, 30, 40, 50, 60, 70, 80 };
  const std::vector<float> result = RunShader(scene.Window,
    "uniform float scale;\nvec4 combine(vec4 a, vec4 b) { return a * scale + b; }\n",
    "result = combine(input0, input1);", { a, b },
    [](vtkShaderProgram* program) { program->SetUniformf("scale", 0.5F); });
  EXPECT_EQ(result, std::vector<float>({ 10.5, 21, 31.5, 42, 52.5, 63, 73.5, 84 }));
}

//------------------------------------------------------------------------------
TEST(TestTerrainTesting, ShaderLeavesTheSceneAlone)
{
  const Scene scene = MakeScene(64, 64);
  scene.Renderer->SetBackground(0.2, 0.4, 0.6);
  const auto before = Render(scene.Window);
  RunShader(scene.Window, "", "result = input0;", { { 1, 2, 3, 4 } });
  EXPECT_EQ(CountDifferentPixels(before, ReadColor(scene.Window)), 0);
  EXPECT_EQ(CountDifferentPixels(before, Render(scene.Window)), 0);
}

//------------------------------------------------------------------------------
TEST(TestTerrainTesting, ReadsColorAndDepth)
{
  const Scene scene = MakeScene(30, 20);
  scene.Renderer->SetBackground(1.0, 0.0, 1.0);
  const auto picture = Render(scene.Window);
  ASSERT_EQ(picture->GetNumberOfPoints(), 600);
  const auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(29, 19, 0));
  EXPECT_EQ(pixel[0], 255);
  EXPECT_EQ(pixel[1], 0);
  EXPECT_EQ(pixel[2], 255);
  EXPECT_EQ(ReadDepth(scene.Window), std::vector<float>(600, 1.0F));
}

//------------------------------------------------------------------------------
TEST(TestTerrainTesting, CountsDifferentPixels)
{
  const auto a = MakePicture(10, 5, 100);
  const auto b = MakePicture(10, 5, 100);
  EXPECT_EQ(CountDifferentPixels(a, b), 0);
  static_cast<unsigned char*>(b->GetScalarPointer(3, 2, 0))[1] = 110;
  EXPECT_EQ(CountDifferentPixels(a, b), 1);
  EXPECT_EQ(CountDifferentPixels(a, b, 9), 1);
  EXPECT_EQ(CountDifferentPixels(a, b, 10), 0);
  EXPECT_EQ(CountDifferentPixels(a, MakePicture(5, 10, 100)), 50);
  EXPECT_GT(CountDifferentPixels(a, nullptr), 0);
}

//------------------------------------------------------------------------------
TEST(TestTerrainTesting, MissingBaselineFailsAndIsWritten)
{
  const std::string name = WindowName() + "-TestTerrainTestingMissing";
  std::filesystem::remove(OutputPath(name + ".png"));
  EXPECT_FALSE(MatchesBaseline(MakePicture(10, 5, 100), name));
  EXPECT_TRUE(std::filesystem::exists(OutputPath(name + ".png")));
  EXPECT_FALSE(MatchesBaseline(nullptr, name));
}
