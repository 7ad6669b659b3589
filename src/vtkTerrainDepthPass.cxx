// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainDepthPass.h"

#include "render/Driver.h"

#include "vtkTerrainDistance.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLightsPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <limits>

vtkStandardNewMacro(vtkTerrainDepthPass);

namespace
{
/// What the buffer holds where nothing is drawn; no distance is as low.
constexpr float kNothing = std::numeric_limits<float>::lowest();
}

class vtkTerrainDepthPass::vtkInternals
{
public:
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkSequencePass> Delegate;
  vtkNew<vtkImageData> Distances;
};

//------------------------------------------------------------------------------
vtkTerrainDepthPass::vtkTerrainDepthPass()
  : Internals(new vtkInternals)
{
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  this->Internals->Delegate->SetPasses(passes);
}

//------------------------------------------------------------------------------
vtkTerrainDepthPass::~vtkTerrainDepthPass() = default;

//------------------------------------------------------------------------------
void vtkTerrainDepthPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Distances:\n";
  this->Internals->Distances->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
vtkImageData* vtkTerrainDepthPass::GetDistances()
{
  return this->Internals->Distances;
}

//------------------------------------------------------------------------------
bool vtkTerrainDepthPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  // extend: the last tag of main, so that nothing overwrites the distance
  return !vtkOpenGLPolyDataMapper::SafeDownCast(mapper) ||
    (vtkShaderProgram::Substitute(fragmentShader, "//VTK::Coincident::Dec",
       std::string(vtkTerrainDistance) + "//VTK::Coincident::Dec", false) &&
      vtkShaderProgram::Substitute(fragmentShader, "//VTK::Coincident::Impl",
        "gl_FragData[0] = terrainDistanceColor(vertexVC);\n  //VTK::Coincident::Impl", false));
}

//------------------------------------------------------------------------------
void vtkTerrainDepthPass::Render(const vtkRenderState* state)
{
  vtkInternals& internals = *this->Internals;
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* gl = window->GetState();
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  if (width < 1 || height < 1)
  {
    return;
  }

  internals.Framebuffer->SetContext(window);
  if (static_cast<int>(internals.Color->GetWidth()) != width ||
    static_cast<int>(internals.Color->GetHeight()) != height ||
    internals.Color->GetContext() != window)
  {
    internals.Color->SetContext(window);
    internals.Color->Allocate2D(width, height, 1, VTK_FLOAT);
    internals.Depth->SetContext(window);
    internals.Depth->AllocateDepth(width, height, vtkTextureObject::Fixed32);
  }

  vtkOpenGLState::ScopedglEnableDisable restoreBlend(gl, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable restoreDepth(gl, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable restoreScissor(gl, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglViewport restoreViewport(gl);
  gl->PushFramebufferBindings();
  internals.Framebuffer->Bind();
  internals.Framebuffer->AddColorAttachment(0, internals.Color);
  internals.Framebuffer->ActivateBuffer(0);
  internals.Framebuffer->AddDepthAttachment(internals.Depth);
  internals.Framebuffer->StartNonOrtho(width, height);
  gl->vtkglViewport(0, 0, width, height);
  gl->vtkglDisable(GL_SCISSOR_TEST);
  gl->vtkglDisable(GL_BLEND);
  gl->vtkglEnable(GL_DEPTH_TEST);
  gl->vtkglDepthMask(GL_TRUE);
  gl->vtkglClearDepth(1.0);
  const std::array<float, 4> nothing{ kNothing, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, nothing.data());
  gl->vtkglClear(GL_DEPTH_BUFFER_BIT);

  vtkRenderState own(renderer);
  own.SetPropArrayAndCount(state->GetPropArray(), state->GetPropArrayCount());
  own.SetFrameBuffer(internals.Framebuffer);
  this->PreRender(&own);
  internals.Delegate->Render(&own);
  this->PostRender(&own);
  this->NumberOfRenderedProps = internals.Delegate->GetNumberOfRenderedProps();
  this->Download(width, height);

  internals.Framebuffer->RemoveColorAttachments(1);
  internals.Framebuffer->RemoveDepthAttachment();
  gl->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkTerrainDepthPass::Download(int width, int height)
{
  vtkNew<vtkFloatArray> distances;
  distances->SetName("Distance");
  distances->SetNumberOfValues(static_cast<vtkIdType>(width) * height);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RED, GL_FLOAT, distances->GetPointer(0));
  float* values = distances->GetPointer(0);
  std::replace(values, values + distances->GetNumberOfValues(), kNothing,
    std::numeric_limits<float>::quiet_NaN());
  vtkImageData* image = this->Internals->Distances;
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(distances);
  image->Modified();
}

//------------------------------------------------------------------------------
void vtkTerrainDepthPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Framebuffer->ReleaseGraphicsResources(window);
  this->Internals->Color->ReleaseGraphicsResources(window);
  this->Internals->Depth->ReleaseGraphicsResources(window);
  this->Internals->Delegate->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
