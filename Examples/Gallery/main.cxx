// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The pictures of docs/gallery.md, one function each: terrain-gallery [FOLDER [WIDTH]]
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkColorTransferFunction.h"
#include "vtkDepthOfFieldPass.h"
#include "vtkEDLShading.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkJPEGWriter.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOPass.h"
#include "vtkScalarBarActor.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkSphereSource.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainSource.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

namespace
{
constexpr double kSide = 40960.0; // metres, the source's own

/// A landscape, 40 km wide and drawn twice as high as it is, in a window.
struct Picture
{
  Picture()
  {
    vtkNew<vtkTerrainSource> source;
    source->SetDimensions(257, 257);
    source->SetOutputScalarTypeToFloat();
    source->Update();
    this->Heights->ShallowCopy(source->GetOutput());
    this->Terrain->SetInputData(this->Heights);
    this->Terrain->SetVerticalExaggeration(2.0);
    this->Terrain->GetProperty()->SetAmbient(0.2);
    this->Renderer->AddActor(this->Terrain);
    this->Renderer->SetBackground(0.90, 0.93, 0.95);
    this->Renderer->AddLight(this->Sun);
    this->Sun->SetLightTypeToSceneLight();
    this->Sun->SetPosition(-0.5 * kSide, 0.0, 0.8 * kSide);
    this->Sun->SetFocalPoint(0.5 * kSide, 0.5 * kSide, 0.0);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Renderer);
    this->Look(0.5, -0.75, 28000.0, 0.5, 0.42, 0.0);
  }

  vtkOpenGLTerrainMapper* Mapper()
  {
    return this->Terrain->GetTerrainMapper();
  }

  /// Eye and focal point: parts of the terrain's side, and heights.
  void Look(double x, double y, double z, double atX, double atY, double atZ)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(x * kSide, y * kSide, z);
    camera->SetFocalPoint(atX * kSide, atY * kSide, atZ);
    camera->SetViewUp(0.0, 0.0, 1.0);
  }

  vtkSmartPointer<vtkActor> AddSphere(double x, double y, double z, double radius)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(x * kSide, y * kSide, z);
    sphere->SetRadius(radius);
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(48);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.85, 0.25, 0.2);
    this->Renderer->AddActor(actor);
    return actor;
  }

  vtkNew<vtkImageData> Heights;
  vtkNew<vtkTerrainActor> Terrain;
  vtkNew<vtkLight> Sun;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

/// A picture with a city's blocks, transparent towards its border.
vtkSmartPointer<vtkImageData> MakeCity()
{
  constexpr int side = 512;
  vtkNew<vtkUnsignedCharArray> texels;
  texels->SetNumberOfComponents(4);
  texels->SetNumberOfTuples(vtkIdType{ side } * side);
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const bool street = i % 64 < 8 || j % 64 < 8;
      const double shade = street ? 70.0 : 150.0 + 20.0 * ((i / 64 * 7 + j / 64 * 5) % 5);
      const double edge = std::hypot(i - 256.0, j - 256.0) / 256.0;
      texels->SetTuple4(i + vtkIdType{ side } * j, shade, 0.9 * shade, 0.8 * shade,
        255.0 * std::min(1.0, std::max(0.0, 4.0 * (1.0 - edge))));
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, 1);
  image->GetPointData()->SetScalars(texels);
  return image;
}

void Plain(Picture& picture)
{
  picture.Terrain->SetColorByHeight(false);
  picture.Terrain->GetProperty()->SetColor(0.85, 0.8, 0.7);
}

void Relief(Picture& /*picture*/)
{
}

void Array(Picture& picture)
{
  vtkNew<vtkFloatArray> plume;
  plume->SetName("plume");
  for (int j = 0; j < 257; ++j)
  {
    for (int i = 0; i < 257; ++i)
    {
      const double across = j - 110.0 - 20.0 * std::sin(0.03 * i);
      const double value = std::exp(-0.01 * i - across * across / (50.0 + 4.0 * i));
      plume->InsertNextValue(
        value > 0.02 ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN());
    }
  }
  picture.Heights->GetPointData()->AddArray(plume);
  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.16, 0.0);
  table->SetNanColor(0.6, 0.66, 0.55, 1.0);
  table->SetScaleToLog10();
  table->SetRange(0.02, 1.0);
  picture.Terrain->SetLookupTable(table);
  picture.Mapper()->SetScalarModeToUsePointFieldData();
  picture.Mapper()->SelectColorArray("plume");
}

void Slope(Picture& picture)
{
  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.33, 0.0);
  table->SetRange(0.0, 40.0);
  picture.Terrain->SetLookupTable(table);
  picture.Mapper()->SetColorSource(vtkOpenGLTerrainMapper::ColorSources::Slope);
}

void Aspect(Picture& picture)
{
  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.0, 1.0);
  table->SetSaturationRange(0.5, 0.5);
  table->SetRange(0.0, 360.0);
  picture.Terrain->SetLookupTable(table);
  picture.Mapper()->SetColorSource(vtkOpenGLTerrainMapper::ColorSources::Aspect);
}

void Contours(Picture& picture)
{
  picture.Mapper()->SetContours(true);
  picture.Mapper()->SetContourInterval(200.0);
  picture.Mapper()->SetContourWidth(1.0);
  picture.Mapper()->SetContourColor(0.3, 0.15, 0.0, 0.8);
}

void Hillshade(Picture& picture)
{
  picture.Terrain->GetProperty()->LightingOff();
  picture.Mapper()->SetHillshade(true);
  picture.Look(0.5, 0.49, 84000.0, 0.5, 0.5, 0.0);
}

void Drape(Picture& picture)
{
  const double bounds[4] = { 0.25 * kSide, 0.75 * kSide, 0.2 * kSide, 0.7 * kSide };
  picture.Mapper()->SetDrape(MakeCity(), bounds);
}

void AmongActors(Picture& picture)
{
  picture.AddSphere(0.35, 0.3, 2500.0, 3500.0);
  picture.AddSphere(0.65, 0.4, 3500.0, 4500.0)->GetProperty()->SetOpacity(0.4);
}

void Translucent(Picture& picture)
{
  picture.Terrain->GetProperty()->SetOpacity(0.5);
  picture.AddSphere(0.4, 0.4, 1000.0, 2500.0);
  picture.AddSphere(0.6, 0.5, 0.0, 3000.0);
  picture.Renderer->UseDepthPeelingOn();
  picture.Renderer->SetMaximumNumberOfPeels(12);
  picture.Window->AlphaBitPlanesOn();
  picture.Look(0.5, -0.6, 14000.0, 0.5, 0.45, 0.0);
}

void Shadows(Picture& picture)
{
  picture.AddSphere(0.4, 0.35, 9000.0, 2500.0);
  picture.Sun->SetPosition(-1.1 * kSide, 0.1 * kSide, 1.2 * kSide);
  picture.Sun->SetPositional(true);
  picture.Sun->SetConeAngle(35.0);
  picture.Sun->SetShadowAttenuation(0.9f);
  vtkNew<vtkShadowMapPass> pass;
  pass->GetShadowMapBakerPass()->SetResolution(2048);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(pass->GetShadowMapBakerPass());
  passes->AddItem(pass);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  picture.Renderer->SetPass(camera);
}

void Occlusion(Picture& picture)
{
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAOPass> pass;
  pass->SetRadius(2500.0);
  pass->SetBias(100.0);
  pass->SetKernelSize(128);
  pass->BlurOn();
  pass->SetDelegatePass(steps);
  picture.Renderer->SetPass(pass);
}

void EyeDome(Picture& picture)
{
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkEDLShading> pass;
  pass->SetDelegatePass(steps);
  picture.Renderer->SetPass(pass);
}

void PhysicallyBased(Picture& picture)
{
  picture.Terrain->SetColorByHeight(false);
  picture.Terrain->GetProperty()->SetInterpolationToPBR();
  picture.Terrain->GetProperty()->SetColor(0.95, 0.8, 0.6);
  picture.Terrain->GetProperty()->SetMetallic(0.2);
  picture.Terrain->GetProperty()->SetRoughness(0.45);
  picture.Sun->SetIntensity(3.0);
}

void Block(Picture& picture)
{
  picture.Mapper()->SetBlock(true);
  picture.Mapper()->SetBlockBase(-1500.0);
  picture.Look(-0.35, -0.65, 22000.0, 0.5, 0.42, -1000.0);
}

void OpenedBlock(Picture& picture)
{
  Block(picture);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.6 * kSide, 0.35 * kSide, 0.0);
  plane->SetNormal(0.5, 1.0, 0.0);
  picture.Mapper()->AddClippingPlane(plane);
  const int first[2] = { 0, 0 };
  const int last[2] = { 220, 256 };
  picture.Mapper()->SetExtract(first, last);
}

void Samples(Picture& picture)
{
  picture.Window->SetMultiSamples(8);
  picture.Mapper()->SetSampleShading(true);
  picture.Look(0.35, 0.0, 5500.0, 0.5, 0.6, 2500.0);
}

void Columns(Picture& picture)
{
  picture.Mapper()->SetSurface(vtkOpenGLTerrainMapper::Surfaces::Columns);
  const int first[2] = { 96, 64 };
  const int last[2] = { 160, 128 };
  picture.Mapper()->SetExtract(first, last);
  picture.Mapper()->SetBlock(true);
  picture.Look(0.4, 0.05, 9500.0, 0.5, 0.37, 1500.0);
}

void ScalarBar(Picture& picture)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(picture.Terrain->GetLookupTable());
  bar->SetTitle("m");
  bar->SetNumberOfLabels(4);
  bar->SetLabelFormat("%.0f");
  bar->SetPosition(0.86, 0.3);
  bar->SetWidth(0.1);
  bar->SetHeight(0.6);
  bar->SetUnconstrainedFontSize(true);
  for (vtkTextProperty* text : { bar->GetLabelTextProperty(), bar->GetTitleTextProperty() })
  {
    text->SetColor(0.1, 0.1, 0.1);
    text->SetFontSize(12);
    text->ShadowOff();
  }
  picture.Renderer->AddViewProp(bar);
}

void DepthOfField(Picture& picture)
{
  picture.Look(0.35, -0.05, 6500.0, 0.5, 0.45, 2500.0);
  picture.Renderer->GetActiveCamera()->SetFocalDisk(600.0);
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkDepthOfFieldPass> pass;
  pass->AutomaticFocalDistanceOff();
  pass->SetDelegatePass(steps);
  picture.Renderer->SetPass(pass);
  picture.Renderer->ResetCameraClippingRange();
  picture.Window->Render(); // the first frame of this pass is black, whatever the scene
}

void OneSample(Picture& picture)
{
  picture.Look(0.35, 0.0, 5500.0, 0.5, 0.6, 2500.0);
}

struct Entry
{
  const char* Name;
  void (*Make)(Picture& picture);
};

constexpr Entry kEntries[] = { { "plain", Plain }, { "relief", Relief }, { "array", Array },
  { "slope", Slope }, { "aspect", Aspect }, { "contours", Contours }, { "hillshade", Hillshade },
  { "drape", Drape }, { "actors", AmongActors }, { "translucent", Translucent },
  { "shadows", Shadows }, { "occlusion", Occlusion }, { "eye-dome", EyeDome },
  { "physically-based", PhysicallyBased }, { "block", Block }, { "opened-block", OpenedBlock },
  { "columns", Columns }, { "scalar-bar", ScalarBar }, { "depth-of-field", DepthOfField },
  { "one-sample", OneSample }, { "samples", Samples } };

bool Write(Picture& picture, const std::string& path)
{
  picture.Renderer->ResetCameraClippingRange();
  picture.Window->Render();
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(picture.Window);
  capture->ReadFrontBufferOff();
  capture->ShouldRerenderOff();
  vtkNew<vtkJPEGWriter> writer;
  writer->SetInputConnection(capture->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->SetQuality(85);
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}

int main(int argc, char* argv[])
{
  const std::string folder = argc > 1 ? argv[1] : ".";
  const int width = argc > 2 ? std::atoi(argv[2]) : 480;
  if (width < 16 || width > 16384)
  {
    std::cerr << "terrain-gallery [FOLDER [WIDTH]]: WIDTH is 16 to 16384 pixels\n";
    return EXIT_FAILURE;
  }
  bool done = true;
  for (const Entry& entry : kEntries)
  {
    Picture picture;
    picture.Window->SetSize(width, width * 9 / 16);
    entry.Make(picture);
    const std::string path = folder + "/" + entry.Name + ".jpg";
    done = Write(picture, path) && done;
    std::cout << path << "\n";
  }
  return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
