// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The words of VTKTERRAIN_DRIVER: each chooses a way to draw, and none another picture. A word that
// is none is told once.
#include "vtkTerrainTesting.h"

#include "vtkCamera.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainSource.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkStringOutputWindow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace
{
/// Sets the variable for a while.
class Words
{
public:
  explicit Words(const std::string& words)
  {
    const char* given = std::getenv("VTKTERRAIN_DRIVER");
    this->Before = given ? given : "";
    setenv("VTKTERRAIN_DRIVER", words.c_str(), 1);
  }
  Words(const Words&) = delete;
  Words& operator=(const Words&) = delete;
  ~Words()
  {
    setenv("VTKTERRAIN_DRIVER", this->Before.c_str(), 1);
  }

private:
  std::string Before;
};

/// What is drawn, and the fragment shader that draws it.
class Drawing
{
public:
  Drawing()
  {
    const vtkNew<vtkTerrainSource> source;
    source->SetDimensions(65, 65);
    this->Terrain->SetInputConnection(source->GetOutputPort());
    this->Scene.Renderer->AddActor(this->Terrain);
    this->Scene.Renderer->ResetCamera();
    this->Scene.Renderer->GetActiveCamera()->Elevation(-50.0);
    this->Scene.Renderer->ResetCamera();
    const vtkNew<vtkCallbackCommand> read;
    read->SetClientData(&this->Shader);
    read->SetCallback(
      [](vtkObject*, unsigned long, void* text, void* program)
      {
        *static_cast<std::string*>(text) =
          static_cast<vtkShaderProgram*>(program)->GetFragmentShader()->GetSource();
      });
    this->Terrain->GetTerrainMapper()->AddObserver(vtkCommand::UpdateShaderEvent, read);
  }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;
  ~Drawing() = default;

  /// The next picture, in the ways of some words.
  vtkSmartPointer<vtkImageData> Draw(const std::string& chosen)
  {
    const Words words(chosen);
    this->Shader.clear();
    return vtkTerrainTesting::Render(this->Scene.Window);
  }

  /// True if the driver can draw in the ways of a word. NVIDIA's has outputs of vertex shaders for
  /// fewer uniforms than there are.
  bool CanDraw(const std::string& word) const
  {
    const std::string driver = this->Scene.Window->ReportCapabilities();
    return word != "passed" || driver.find("NVIDIA") == std::string::npos;
  }

  /// True if the shader of the last picture has a text.
  bool Has(const std::string& text) const
  {
    return this->Shader.find(text) != std::string::npos;
  }

private:
  std::string Shader;
  const vtkNew<vtkTerrainActor> Terrain;
  vtkTerrainTesting::Scene Scene = vtkTerrainTesting::MakeScene(60, 40);
};

/// Two words, and what is in the shader with the first alone.
struct Choice
{
  const char* With;
  const char* Without;
  const char* Text;
};

void PrintTo(const Choice& choice, std::ostream* out)
{
  *out << choice.With;
}

class TerrainDriverWords : public testing::TestWithParam<Choice>
{
};
}

TEST_P(TerrainDriverWords, ChooseTheWayAndNotThePicture)
{
  const Choice& choice = GetParam();
  Drawing first;
  Drawing second;
  if (!first.CanDraw(choice.With))
  {
    GTEST_SKIP() << "this driver has too few outputs of vertex shaders";
  }
  const auto with = first.Draw(choice.With);
  const auto without = second.Draw(choice.Without);
  EXPECT_GT(vtkTerrainTesting::DrawnShare(with), 0.1);
  EXPECT_TRUE(first.Has(choice.Text));
  EXPECT_FALSE(second.Has(choice.Text));
  // a compute shader hands on distances and places that float rounds
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(with, without, 2), 0);
}

const Choice kOfTextures{ "buffer", "levels", "#define TERRAIN_PYRAMID_BUFFER\n" };
const Choice kOfPrograms[] = { { "gather", "fetch", "\n#define TERRAIN_GATHER\n" },
  { "passed", "plain", "VSOutput;\n#define terrain" },
  { "compute", "fragment", "#define TERRAIN_READ_SIGHTINGS\n" } };
const auto kNameOf = [](const auto& choice) { return std::string(choice.param.With); };

INSTANTIATE_TEST_SUITE_P(Textures, TerrainDriverWords, testing::Values(kOfTextures), kNameOf);
INSTANTIATE_TEST_SUITE_P(Programs, TerrainDriverWords, testing::ValuesIn(kOfPrograms), kNameOf);

class TerrainDriverPrograms : public testing::TestWithParam<Choice>
{
};

// Words that change while a scene lives change its next frame.
TEST_P(TerrainDriverPrograms, AreBuiltAnewForOtherWords)
{
  const Choice& choice = GetParam();
  Drawing drawing;
  if (!drawing.CanDraw(choice.With))
  {
    GTEST_SKIP() << "this driver has too few outputs of vertex shaders";
  }
  for (const bool with : { true, false, true })
  {
    drawing.Draw(with ? choice.With : choice.Without);
    EXPECT_EQ(drawing.Has(choice.Text), with);
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, TerrainDriverPrograms, testing::ValuesIn(kOfPrograms), kNameOf);

TEST(TerrainDriver, UnknownWordsAreOneWarning)
{
  const Words words("nonsense");
  const vtkNew<vtkStringOutputWindow> told;
  vtkOutputWindow::SetInstance(told);
  const vtkNew<vtkTerrainSource> source;
  source->SetDimensions(33, 33);
  const vtkNew<vtkTerrainActor> terrain;
  terrain->SetInputConnection(source->GetOutputPort());
  vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(40, 30);
  scene.Renderer->AddActor(terrain);
  scene.Renderer->ResetCamera();
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_GT(vtkTerrainTesting::DrawnShare(vtkTerrainTesting::Render(scene.Window)), 0.1);
  }
  vtkOutputWindow::SetInstance(nullptr);
  const std::string output = told->GetOutput();
  const std::string word = "VTKTERRAIN_DRIVER has \"nonsense\"";
  const std::size_t first = output.find(word);
  ASSERT_NE(first, std::string::npos) << output;
  EXPECT_EQ(output.find(word, first + 1), std::string::npos) << output;
}
