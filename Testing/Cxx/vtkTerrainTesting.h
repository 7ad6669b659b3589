// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What tests that draw have in common: windows, pictures, baselines, and GLSL run on arrays.
 *
 * Pictures are vtkImageData of W x H x 1 points with unsigned char RGB scalars, row 0 at the
 * bottom.
 */
#ifndef vtkTerrainTesting_h
#define vtkTerrainTesting_h

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

class vtkShaderProgram;

namespace vtkTerrainTesting
{
/// A window with one renderer, black background, without multisampling.
struct Scene
{
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
};

/// A scene of width x height pixels in the window that VTK_DEFAULT_OPENGL_WINDOW names, watched by
/// WatchGL().
Scene MakeScene(int width, int height);

/// From the renderer's next picture on, errors and undefined behaviour that the driver reports
/// (KHR_debug) in its window's context are failures of the test; none where drivers do not report.
void WatchGL(vtkRenderer* renderer);

/// While it lives, what the driver reports is kept in place of being a failure.
class ExpectedGLErrors
{
public:
  ExpectedGLErrors();
  ~ExpectedGLErrors();
  ExpectedGLErrors(const ExpectedGLErrors&) = delete;
  void operator=(const ExpectedGLErrors&) = delete;
  const std::vector<std::string>& GetMessages() const
  {
    return this->Messages;
  }

private:
  std::vector<std::string> Messages;
};

/// Objects that are alive in a context.
struct GLObjects
{
  int Textures = 0;
  int Buffers = 0;
  int Framebuffers = 0;
  int Renderbuffers = 0;
  int VertexArrays = 0;
  int Queries = 0;
  int Programs = 0;
  int Shaders = 0;
};

/// Those of the window's context, by their names up to a number that no test reaches.
GLObjects CountGLObjects(vtkRenderWindow* window);

/// Renders, and returns the picture.
vtkSmartPointer<vtkImageData> Render(vtkRenderWindow* window);

/// The picture of the last render.
vtkSmartPointer<vtkImageData> ReadColor(vtkRenderWindow* window);

/// The depth buffer of the last render: W * H values of 0 (near plane) to 1 (far plane, or nothing
/// drawn), row 0 at the bottom.
std::vector<float> ReadDepth(vtkRenderWindow* window);

/// Number of pixels of a picture for which a function of their components is true.
template <typename Predicate>
int CountPixels(vtkImageData* picture, const Predicate& predicate)
{
  const auto* pixels = static_cast<const unsigned char*>(picture->GetScalarPointer());
  int count = 0;
  for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i)
  {
    count += predicate(pixels + i * picture->GetNumberOfScalarComponents()) ? 1 : 0;
  }
  return count;
}

/// Number of pixels in which a channel differs by more than channelTolerance (0 to 255); all pixels
/// if the pictures differ in size.
vtkIdType CountDifferentPixels(vtkImageData* a, vtkImageData* b, int channelTolerance = 0);

/// When a picture matches its baseline: at most maximumFraction (0 to 1) of the pixels may have a
/// channel that differs by more than channelTolerance (0 to 255).
struct Tolerance
{
  int Channel = 10;
  double Fraction = 0.001;
};

/// Compares a picture with Data/Baseline/NAME.png and its alternates NAME_1.png, NAME_2.png, ...;
/// one match suffices. Where none matches, the picture and its difference from NAME.png (absolute,
/// times 4) are written to the output directory; where there is no baseline, the picture is written
/// there as NAME.png, to be looked at and copied, and the result is false as well.
testing::AssertionResult MatchesBaseline(
  vtkImageData* picture, const std::string& name, const Tolerance& tolerance = Tolerance());

/// Share of a picture's pixels, 0 to 1, whose colour is not that of its upper left corner: a number
/// beside a baseline, which tells how much is drawn whatever the picture on file shows.
double DrawnShare(vtkImageData* picture);

/// Writes a picture as PNG.
void WritePicture(vtkImageData* picture, const std::string& path);

/// Path of a file in the directory for temporary files, which is made if need be. Tests of
/// different windows run at the same time: start names with WindowName() where they would meet.
std::string OutputPath(const std::string& file);

/// Path of a real elevation file, or empty if VTKTERRAIN_DATA_DIR is not set or lacks the file:
/// then GTEST_SKIP.
std::string DataPath(const std::string& file);

/// "egl", "osmesa" or "x": what VTK_DEFAULT_OPENGL_WINDOW asks for; "any" if it is not set.
std::string WindowName();

/// The text of shaders/NAME.glsl in the sources; empty if there is none.
std::string ReadShader(const std::string& name);

/// Runs a GLSL fragment once for each item and returns what it gives, 4 floats an item.
///
/// @param window any OpenGL window; its size does not matter, and its scene is left alone.
/// @param declarations functions, uniforms and the like, placed ahead of main. Version and
/// precision
///        are VTK's (`//VTK::System::Dec`, GLSL 1.50).
/// @param body statements that assign `vec4 result`. They see each input as `vec4 input0`,
///        `vec4 input1`, ...
/// @param inputs arrays of equal length, 4 floats an item. 1 to 8 arrays of up to 16 million items.
/// @param setUniforms sets uniforms and textures of the program just before it runs; optional.
/// @return 4 floats an item, unrounded; empty if the shader does not compile, in which case VTK has
///         reported it.
std::vector<float> RunShader(vtkRenderWindow* window, const std::string& declarations,
  const std::string& body, const std::vector<std::vector<float>>& inputs,
  const std::function<void(vtkShaderProgram*)>& setUniforms = nullptr);
}

#endif
