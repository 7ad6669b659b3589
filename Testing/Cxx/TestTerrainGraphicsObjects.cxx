// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What the module leaves in the graphics context.
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainSource.h"
#include "vtkTerrainTestDrawing.h"
#include "vtkTerrainTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include "render/Driver.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

using namespace vtkTerrainTesting;

namespace
{
vtkSmartPointer<vtkImageData> MakeHeights(int side)
{
  const vtkNew<vtkTerrainSource> source;
  source->SetDimensions(side, side);
  source->Update();
  return source->GetOutput();
}

void Look(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -1.0, 0.8);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
}

void ExpectSame(const GLObjects& now, const GLObjects& before)
{
  EXPECT_EQ(now.Textures, before.Textures);
  EXPECT_EQ(now.Buffers, before.Buffers);
  EXPECT_EQ(now.Framebuffers, before.Framebuffers);
  EXPECT_EQ(now.Renderbuffers, before.Renderbuffers);
  EXPECT_EQ(now.VertexArrays, before.VertexArrays);
  EXPECT_EQ(now.Queries, before.Queries);
}

const unsigned char* PixelsOf(vtkImageData* picture)
{
  return static_cast<const unsigned char*>(picture->GetScalarPointer());
}

/// The largest anisotropy of the filter that a program reads its picture with.
void FindAnisotropy(vtkObject*, unsigned long, void* found, void* program)
{
  const auto handle = static_cast<GLuint>(static_cast<vtkShaderProgram*>(program)->GetHandle());
  const GLint place = glGetUniformLocation(handle, "terrainDrape");
  if (place < 0)
  {
    return;
  }
  GLint unit = 0;
  GLint before = 0;
  glGetUniformiv(handle, place, &unit);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &before);
  glActiveTexture(GL_TEXTURE0 + static_cast<GLuint>(unit));
  glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<GLfloat*>(found));
  glActiveTexture(static_cast<GLenum>(before));
}
}

// So that the other tests of this file mean something.
TEST(TerrainGraphicsObjects, AreCountedAndErrorsNoticed)
{
  const Scene scene = MakeScene(32, 32);
  scene.Window->Render();
  const GLObjects before = CountGLObjects(scene.Window);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  EXPECT_EQ(CountGLObjects(scene.Window).Textures, before.Textures + 1);
  glDeleteTextures(1, &texture);
  ExpectSame(CountGLObjects(scene.Window), before);
  if (glDebugMessageCallback)
  {
    const ExpectedGLErrors errors;
    glBindTexture(GL_RGBA, 0);
    EXPECT_EQ(errors.GetMessages().size(), 1U);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  }
}

TEST(TerrainGraphicsObjects, NoneIsLeftAfter200Cycles)
{
  const Scene scene = MakeScene(48, 32);
  const vtkSmartPointer<vtkImageData> heights[2] = { MakeHeights(33), MakeHeights(50) };
  GLObjects before;
  for (int cycle = 0; cycle <= 200; ++cycle)
  {
    const vtkNew<vtkTerrainActor> terrain;
    terrain->SetInputData(heights[cycle % 2]);
    terrain->SetTechnique(static_cast<vtkOpenGLTerrainMapper::Techniques>(cycle % 5));
    scene.Renderer->AddActor(terrain);
    Look(scene.Renderer);
    scene.Window->Render();
    scene.Window->SetSize(48 + cycle % 7, 32 + cycle % 5);
    terrain->SetTechnique(static_cast<vtkOpenGLTerrainMapper::Techniques>((cycle + 1) % 5));
    scene.Window->Render();
    scene.Renderer->RemoveActor(terrain);
    scene.Window->SetSize(48, 32);
    scene.Window->Render();
    if (cycle == 0)
    {
      before = CountGLObjects(scene.Window);
    }
  }
  ExpectSame(CountGLObjects(scene.Window), before);
}

// A picture of one colour looks the same; of others llvmpipe's filter takes wrong texels.
TEST(TerrainGraphicsObjects, DrapesAreFilteredAsTheDriverIsToldTo)
{
  const char* words = std::getenv("VTKTERRAIN_DRIVER");
  const std::string before = words ? words : "";
  const vtkNew<vtkImageData> picture;
  picture->SetDimensions(64, 64, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(picture->GetScalarPointer()), 64 * 64 * 3, 180);
  vtkSmartPointer<vtkImageData> pictures[2];
  for (const bool anisotropic : { false, true })
  {
    setenv("VTKTERRAIN_DRIVER", anisotropic ? "anisotropic" : "graphics,isotropic", 1);
    const Scene scene = MakeScene(48, 32);
    const vtkNew<vtkTerrainActor> terrain;
    terrain->SetInputData(MakeHeights(33));
    const double bounds[4] = { -1e6, 1e6, -1e6, 1e6 };
    terrain->GetTerrainMapper()->SetDrape(picture, bounds);
    GLfloat found = 0.0f;
    const vtkNew<vtkCallbackCommand> find;
    find->SetCallback(FindAnisotropy);
    find->SetClientData(&found);
    terrain->GetTerrainMapper()->AddObserver(vtkCommand::UpdateShaderEvent, find);
    scene.Renderer->AddActor(terrain);
    Look(scene.Renderer);
    pictures[anisotropic ? 1 : 0] = Render(scene.Window);
    EXPECT_EQ(found, anisotropic ? 16.0f : 1.0f);
  }
  before.empty() ? unsetenv("VTKTERRAIN_DRIVER") : setenv("VTKTERRAIN_DRIVER", before.c_str(), 1);
  constexpr std::size_t numbers = std::size_t{ 48 } * 32 * 3;
  EXPECT_TRUE(
    std::equal(PixelsOf(pictures[0]), PixelsOf(pictures[0]) + numbers, PixelsOf(pictures[1])));
}
