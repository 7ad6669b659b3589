// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainOffscreenRenderWindow.h"

#include "render/Compatibility.h"
#include "windows/GLContext.h"

#include "vtkObjectFactory.h"
#include "vtkRect.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace
{
// glewInit's answer if there is no GLX display; OpenGL's functions are loaded all the same.
constexpr GLenum kGlewNoGLXDisplay = 4;

constexpr int kDefaultSize = 300;

// Bytes of a pixel of the formats that vtkOpenGLRenderWindow reads back.
std::size_t BytesPerPixel(int glFormat, int glType)
{
  const std::size_t components = glFormat == GL_RGBA ? 4 : (glFormat == GL_RGB ? 3 : 1);
  return components * (glType == GL_FLOAT ? sizeof(float) : 1);
}
}

vtkStandardNewMacro(vtkTerrainOffscreenRenderWindow);

//------------------------------------------------------------------------------
vtkTerrainOffscreenRenderWindow::vtkTerrainOffscreenRenderWindow()
{
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  this->FrameBlitMode = vtkOpenGLRenderWindow::NoBlit;
}

//------------------------------------------------------------------------------
vtkTerrainOffscreenRenderWindow::~vtkTerrainOffscreenRenderWindow()
{
  this->Close();
  vtkCollectionSimpleIterator iterator;
  this->Renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(iterator))
  {
    renderer->SetRenderWindow(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << this->GetGenericContext() << "\n";
  os << indent << "WhyNot: " << this->WhyNot << "\n";
}

//------------------------------------------------------------------------------
std::unique_ptr<terrain::GLContext> vtkTerrainOffscreenRenderWindow::CreateContext(
  std::string& whyNot)
{
  if (whyNot.empty())
  {
    whyNot = "this window has no context";
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool vtkTerrainOffscreenRenderWindow::OpenContext()
{
  if (!this->Context && !this->ErrorReported)
  {
    std::string whyNot = this->WhyNot;
    this->Context = this->CreateContext(whyNot);
    this->WhyNot = this->Context ? std::string() : whyNot;
  }
  return this->Context != nullptr;
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::Initialize()
{
  if (this->Initialized)
  {
    return;
  }
  if (!this->OpenContext())
  {
    if (!this->ErrorReported)
    {
      this->ErrorReported = true;
      vtkErrorMacro("No render window can be had: " << this->WhyNot);
    }
    return;
  }
  this->CreateAWindow();
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::CreateAWindow()
{
  this->MakeCurrent();
  if (!this->IsCurrent())
  {
    return;
  }
  this->Mapped = 0;
  this->Size[0] = this->Size[0] > 0 ? this->Size[0] : kDefaultSize;
  this->Size[1] = this->Size[1] > 0 ? this->Size[1] : kDefaultSize;
  vtkCollectionSimpleIterator iterator;
  this->Renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(iterator))
  {
    renderer->SetRenderWindow(nullptr);
    renderer->SetRenderWindow(this);
  }
  this->OpenGLInit();
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized)
  {
    return;
  }
  const GLenum answer = glewInit();
  this->GlewInitValid = answer == GLEW_OK || answer == kGlewNoGLXDisplay;
  if (!this->GlewInitValid)
  {
    vtkErrorMacro("GLEW could not be initialized: " << glewGetErrorString(answer));
    return;
  }
  if (!GLEW_VERSION_3_2)
  {
    vtkErrorMacro("OpenGL 3.2 is needed, the driver has " << glGetString(GL_VERSION));
    return;
  }
  this->Initialized = true;
  GLfloat range[2] = { 1.0F, 1.0F };
  glGetFloatv(
    this->LineSmoothing ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = range[1];
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::Close()
{
  if (this->Context)
  {
    this->ReleaseGraphicsResources(this);
    this->Context.reset();
  }
  this->Mapped = 0;
  this->ErrorReported = false;
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::Finalize()
{
  this->Close();
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::DestroyWindow()
{
  this->Close();
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::WindowRemap()
{
  this->Finalize();
  this->Initialize();
}

//------------------------------------------------------------------------------
int vtkTerrainOffscreenRenderWindow::SupportsOpenGL()
{
  const bool supported = this->OpenContext();
  this->OpenGLSupportTested = true;
  this->OpenGLSupportResult = supported ? 1 : 0;
  this->OpenGLSupportMessage = supported ? "The window has an OpenGL 3.2 context" : this->WhyNot;
  return this->OpenGLSupportResult;
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::Render()
{
  this->Initialize();
  if (this->Initialized)
  {
    this->Superclass::Render();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::Frame()
{
  this->MakeCurrent();
  this->Superclass::Frame();
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::MakeCurrent()
{
  if (this->Context && !this->Context->MakeCurrent())
  {
    vtkErrorMacro("The context cannot be made current");
  }
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::ReleaseCurrent()
{
  if (this->Context)
  {
    this->Context->Release();
  }
}

//------------------------------------------------------------------------------
bool vtkTerrainOffscreenRenderWindow::IsCurrent()
{
  return this->Context && this->Context->IsCurrent();
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::PushContext()
{
  this->OuterContext = terrain::GLContext::GetCurrent();
  this->MakeCurrent();
}

//------------------------------------------------------------------------------
void vtkTerrainOffscreenRenderWindow::PopContext()
{
  if (this->OuterContext)
  {
    this->OuterContext->MakeCurrent();
    this->OuterContext = nullptr;
  }
}

//------------------------------------------------------------------------------
const char* vtkTerrainOffscreenRenderWindow::ReportCapabilities()
{
  this->Initialize();
  return this->Initialized ? this->Superclass::ReportCapabilities() : this->WhyNot.c_str();
}

//------------------------------------------------------------------------------
int vtkTerrainOffscreenRenderWindow::ReadPixels(
  const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right)
{
  if (this->Initialized)
  {
    return this->Superclass::ReadPixels(rect, front, glFormat, glType, data, right);
  }
  const auto pixels = static_cast<std::size_t>(std::max(rect.GetWidth(), 0)) *
    static_cast<std::size_t>(std::max(rect.GetHeight(), 0));
  std::memset(data, 0, pixels * BytesPerPixel(glFormat, glType));
  return VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkTerrainOffscreenRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  if (this->Initialized)
  {
    return this->Superclass::GetZbufferData(x1, y1, x2, y2, z);
  }
  const auto width = static_cast<std::size_t>(std::abs(x2 - x1)) + 1;
  const auto height = static_cast<std::size_t>(std::abs(y2 - y1)) + 1;
  std::fill_n(z, width * height, 0.0F);
  return VTK_ERROR;
}

//------------------------------------------------------------------------------
int* vtkTerrainOffscreenRenderWindow::GetScreenSize()
{
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
  return this->ScreenSize;
}

//------------------------------------------------------------------------------
void* vtkTerrainOffscreenRenderWindow::GetGenericContext()
{
  return this->Context ? this->Context->GetHandle() : nullptr;
}
