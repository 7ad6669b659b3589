// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainTesting.h"

#include "render/Compatibility.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cassert>
#include <fstream>
#include <sstream>

namespace vtkTerrainTesting
{
namespace
{
// Items are laid out in rows of this many texels.
constexpr std::size_t kRow = 1024;

using Textures = std::vector<vtkSmartPointer<vtkTextureObject>>;

//------------------------------------------------------------------------------
std::string InputName(std::size_t index)
{
  return "input" + std::to_string(index);
}

//------------------------------------------------------------------------------
std::string FragmentShader(
  const std::string& declarations, const std::string& body, std::size_t inputs)
{
  std::string uniforms;
  std::string fetches;
  for (std::size_t i = 0; i < inputs; ++i)
  {
    const std::string name = InputName(i);
    uniforms.append("uniform sampler2D ").append(name).append("Texture;\n");
    fetches.append("  vec4 ").append(name).append(" = texelFetch(").append(name);
    fetches.append("Texture, texel, 0);\n");
  }
  // declarations may begin with extensions
  return "//VTK::System::Dec\n" + declarations + "\n//VTK::Output::Dec\nin vec2 texCoord;\n" +
    uniforms +
    "\nvoid main()\n{\n  vec4 result = vec4(0.0);\n"
    "  ivec2 texel = ivec2(texCoord * vec2(textureSize(input0Texture, 0)));\n" +
    fetches + body + "\n  gl_FragData[0] = result;\n}\n";
}

//------------------------------------------------------------------------------
Textures Upload(vtkOpenGLRenderWindow* window, const std::vector<std::vector<float>>& inputs,
  unsigned int width, unsigned int height)
{
  Textures textures;
  for (const std::vector<float>& input : inputs)
  {
    std::vector<float> padded(input);
    padded.resize(std::size_t{ 4 } * width * height, 0.0F);
    auto texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->Create2DFromRaw(width, height, 4, VTK_FLOAT, padded.data());
    textures.push_back(texture);
  }
  return textures;
}

//------------------------------------------------------------------------------
void Draw(vtkOpenGLQuadHelper& quad, const Textures& textures,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  for (std::size_t i = 0; i < textures.size(); ++i)
  {
    textures[i]->Activate();
    const std::string name = InputName(i) + "Texture";
    quad.Program->SetUniformi(name.c_str(), textures[i]->GetTextureUnit());
  }
  if (setUniforms)
  {
    setUniforms(quad.Program);
  }
  quad.Render();
  for (const auto& texture : textures)
  {
    texture->Deactivate();
  }
}
}

//------------------------------------------------------------------------------
std::string ReadShader(const std::string& name)
{
  std::ifstream file(VTKTERRAIN_SHADER_DIR "/" + name + ".glsl");
  EXPECT_TRUE(file) << name;
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

//------------------------------------------------------------------------------
std::vector<float> RunShader(vtkRenderWindow* anyWindow, const std::string& declarations,
  const std::string& body, const std::vector<std::vector<float>>& inputs,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(anyWindow);
  assert(window && !inputs.empty() && !inputs[0].empty());
  window->Initialize();
  window->MakeCurrent();
  const std::size_t items = inputs[0].size() / 4;
  const auto width = static_cast<unsigned int>(std::min(items, kRow));
  const auto height = static_cast<unsigned int>((items + width - 1) / width);
  const Textures textures = Upload(window, inputs, width, height);

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglViewport viewport(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->PushFramebufferBindings();

  vtkNew<vtkTextureObject> output;
  output->SetContext(window);
  output->Allocate2D(width, height, 4, VTK_FLOAT);
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  framebuffer->SetContext(window);
  framebuffer->Bind();
  framebuffer->AddColorAttachment(0, output);
  framebuffer->ActivateDrawBuffers(1);
  state->vtkglViewport(0, 0, static_cast<int>(width), static_cast<int>(height));

  std::vector<float> result;
  const std::string shader = FragmentShader(declarations, body, inputs.size());
  {
    vtkOpenGLQuadHelper quad(window, nullptr, shader.c_str(), nullptr);
    if (quad.Program && quad.Program->GetCompiled())
    {
      Draw(quad, textures, setUniforms);
      result.resize(std::size_t{ 4 } * width * height);
      framebuffer->ActivateReadBuffer(0);
      state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
      glReadPixels(0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height), GL_RGBA,
        GL_FLOAT, result.data());
      result.resize(4 * items);
    }
  }
  state->PopFramebufferBindings();
  return result;
}
}
