// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainTesting.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace vtkTerrainTesting
{
namespace
{
//------------------------------------------------------------------------------
std::string Environment(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadPicture(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
bool IsPicture(vtkImageData* image)
{
  return image && vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars()) &&
    image->GetNumberOfScalarComponents() == 3;
}

//------------------------------------------------------------------------------
const unsigned char* Pixels(vtkImageData* image)
{
  return vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars())->GetPointer(0);
}

//------------------------------------------------------------------------------
bool SameSize(vtkImageData* a, vtkImageData* b)
{
  const int* sizeA = a->GetDimensions();
  const int* sizeB = b->GetDimensions();
  return std::equal(sizeA, sizeA + 3, sizeB);
}

//------------------------------------------------------------------------------
void WriteDifference(vtkImageData* a, vtkImageData* b, const std::string& path)
{
  vtkNew<vtkImageData> difference;
  difference->DeepCopy(a);
  auto* out = static_cast<unsigned char*>(difference->GetScalarPointer());
  const unsigned char* pixelsA = Pixels(a);
  const unsigned char* pixelsB = Pixels(b);
  const vtkIdType count = 3 * a->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    out[i] = static_cast<unsigned char>(std::min(255, 4 * std::abs(pixelsA[i] - pixelsB[i])));
  }
  WritePicture(difference, path);
}
}

//------------------------------------------------------------------------------
Scene MakeScene(int width, int height)
{
  Scene scene;
  scene.Window = vtkSmartPointer<vtkRenderWindow>::New();
  scene.Renderer = vtkSmartPointer<vtkRenderer>::New();
  scene.Window->SetOffScreenRendering(true);
  scene.Window->SetMultiSamples(0);
  scene.Window->SetSize(width, height);
  scene.Window->AddRenderer(scene.Renderer);
  WatchGL(scene.Renderer);
  return scene;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Render(vtkRenderWindow* window)
{
  window->Render();
  return ReadColor(window);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadColor(vtkRenderWindow* window)
{
  const int* size = window->GetActualSize();
  const int width = size[0];
  const int height = size[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetName("RGB");
  window->GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(pixels);
  return image;
}

//------------------------------------------------------------------------------
std::vector<float> ReadDepth(vtkRenderWindow* window)
{
  const int* size = window->GetActualSize();
  const int width = size[0];
  const int height = size[1];
  vtkNew<vtkFloatArray> depth;
  window->GetZbufferData(0, 0, width - 1, height - 1, depth);
  return { depth->GetPointer(0), depth->GetPointer(0) + depth->GetNumberOfValues() };
}

//------------------------------------------------------------------------------
double DrawnShare(vtkImageData* picture)
{
  const int* size = picture->GetDimensions();
  const int channels = picture->GetNumberOfScalarComponents();
  const auto* corner =
    static_cast<const unsigned char*>(picture->GetScalarPointer(0, size[1] - 1, 0));
  const auto* pixels = static_cast<const unsigned char*>(picture->GetScalarPointer());
  vtkIdType drawn = 0;
  for (vtkIdType k = 0; k < picture->GetNumberOfPoints(); ++k)
  {
    drawn += std::equal(corner, corner + channels, pixels + k * channels) ? 0 : 1;
  }
  return static_cast<double>(drawn) / static_cast<double>(picture->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
vtkIdType CountDifferentPixels(vtkImageData* a, vtkImageData* b, int channelTolerance)
{
  if (!IsPicture(a) || !IsPicture(b) || !SameSize(a, b))
  {
    return std::max<vtkIdType>(1, a ? a->GetNumberOfPoints() : 0);
  }
  const unsigned char* pixelsA = Pixels(a);
  const unsigned char* pixelsB = Pixels(b);
  const vtkIdType count = a->GetNumberOfPoints();
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    int largest = 0;
    for (vtkIdType c = 3 * i; c < 3 * i + 3; ++c)
    {
      largest = std::max(largest, std::abs(pixelsA[c] - pixelsB[c]));
    }
    different += largest > channelTolerance ? 1 : 0;
  }
  return different;
}

//------------------------------------------------------------------------------
testing::AssertionResult MatchesBaseline(
  vtkImageData* picture, const std::string& name, const Tolerance& tolerance)
{
  if (!IsPicture(picture))
  {
    return testing::AssertionFailure() << "there is no picture";
  }
  const std::filesystem::path directory = Environment("VTKTERRAIN_BASELINE_DIR");
  const auto allowed =
    static_cast<vtkIdType>(tolerance.Fraction * static_cast<double>(picture->GetNumberOfPoints()));
  const std::string firstPath = (directory / (name + ".png")).string();
  if (!std::filesystem::exists(firstPath))
  {
    const std::string path = OutputPath(name + ".png");
    WritePicture(picture, path);
    return testing::AssertionFailure()
      << "there is no baseline " << firstPath << "; the picture is " << path;
  }
  vtkIdType fewest = VTK_ID_MAX;
  std::string path = firstPath;
  for (int alternate = 1; std::filesystem::exists(path); ++alternate)
  {
    fewest = std::min(fewest, CountDifferentPixels(picture, ReadPicture(path), tolerance.Channel));
    if (fewest <= allowed)
    {
      return testing::AssertionSuccess();
    }
    path = (directory / (name + "_" + std::to_string(alternate) + ".png")).string();
  }
  const std::string actual = OutputPath(WindowName() + "-" + name + ".png");
  WritePicture(picture, actual);
  vtkSmartPointer<vtkImageData> first = ReadPicture(firstPath);
  if (IsPicture(first) && SameSize(picture, first))
  {
    WriteDifference(picture, first, OutputPath(WindowName() + "-" + name + "-difference.png"));
  }
  return testing::AssertionFailure()
    << fewest << " pixels differ by more than " << tolerance.Channel << " from " << firstPath
    << ", " << allowed << " may; the picture is " << actual;
}

//------------------------------------------------------------------------------
void WritePicture(vtkImageData* picture, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(path.c_str());
  writer->Write();
}

//------------------------------------------------------------------------------
std::string OutputPath(const std::string& file)
{
  std::filesystem::path directory = Environment("VTKTERRAIN_TEST_OUTPUT_DIR");
  if (directory.empty())
  {
    directory = std::filesystem::temp_directory_path() / "vtkTerrainTesting";
  }
  std::filesystem::create_directories(directory);
  return (directory / file).string();
}

//------------------------------------------------------------------------------
std::string DataPath(const std::string& file)
{
  const std::filesystem::path directory = Environment("VTKTERRAIN_DATA_DIR");
  const std::filesystem::path path = directory / file;
  return !directory.empty() && std::filesystem::exists(path) ? path.string() : std::string();
}

//------------------------------------------------------------------------------
std::string WindowName()
{
  const std::string name = Environment("VTK_DEFAULT_OPENGL_WINDOW");
  if (name == "vtkEGLRenderWindow")
  {
    return "egl";
  }
  if (name == "vtkOSOpenGLRenderWindow")
  {
    return "osmesa";
  }
  return name == "vtkXOpenGLRenderWindow" ? "x" : "any";
}
}
