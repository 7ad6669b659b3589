// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What the module leaves in the graphics context.
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainSource.h"
#include "vtkTerrainTestDrawing.h"
#include "vtkTerrainTesting.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"

#include "render/Driver.h"

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
