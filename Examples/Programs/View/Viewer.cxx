// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer.h"

#include "BlockWalls.h"
#include "Failure.h"
#include "Messages.h"
#include "WindowEvents.h"

#include "vtkAxesActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCaptionActor2D.h"
#include "vtkCommand.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPNGWriter.h"
#include "vtkProperty.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainLook.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>

namespace
{
constexpr const char* kPictureFile = "terrain-view.png";
constexpr double kStepOfHeights = 1.25;
/// Milliseconds between looks at where the pointer is.
constexpr unsigned long kPointerInterval = 100;

constexpr std::array<const char*, 6> kTechniqueNames{ "mesh", "linear", "exponential",
  "equidistant", "pyramid", "strips" };

/// About a twentieth of the range of the heights, as 1, 2 or 5 times a power of ten.
double RoundInterval(vtkOpenGLTerrainMapper* mapper)
{
  std::array<double, 2> range{};
  mapper->GetHeightRange(range.data());
  const double interval = std::max((range[1] - range[0]) / 20.0, 1e-3);
  const double power = std::pow(10.0, std::floor(std::log10(interval)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (factor * power >= interval)
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

void PutText(vtkTextActor* text, double x, double y, bool atTop)
{
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(x, y);
  vtkTextProperty* property = text->GetTextProperty();
  property->SetFontFamilyToCourier();
  property->SetFontSize(13);
  property->SetColor(0.05, 0.05, 0.1);
  property->SetBackgroundColor(1.0, 1.0, 1.0);
  property->SetBackgroundOpacity(0.65);
  property->SetLineSpacing(1.2);
  if (atTop)
  {
    property->SetVerticalJustificationToTop();
  }
}
}

//------------------------------------------------------------------------------
const char* Viewer::GetHelp()
{
  return "t T    next, previous technique\n"
         "+ -    vertical exaggeration\n"
         "c      colours\n"
         "i      contour lines\n"
         "l      lights or hillshade\n"
         "u      shadows\n"
         "w      coarse mesh as wireframe\n"
         "x      number of nodes or samples a ray takes\n"
         "o      perspective or parallel projection\n"
         "r      all in view\n"
         "n      next site of a folder of several, then all\n"
         "m      measure: left clicks add points, on the first one an area, right ends\n"
         "p      print the position under the pointer, and what is measured\n"
         "y      copy the place under the pointer\n"
         "k K    add this view to a flight, take its last one away\n"
         "f F    play the flight, save it as terrain-view-flight.csv, for terrain-render --flight\n"
         "O      open a raster or a scene\n"
         "s      save the picture as terrain-view.png\n"
         "S      save the scene as terrain-view.toml, for terrain-render --scene\n"
         "h      this help\n"
         "q      quit\n"
         "left drag turns, middle drag moves, wheel and right drag go nearer;\n"
         "a raster or a scene that is dropped here is shown";
}

//------------------------------------------------------------------------------
Viewer::Viewer(vtkImageData* heights, const std::string& name, int width, int height)
  : Places(heights)
{
  this->Terrain->SetInputData(heights);
  this->Renderer->AddActor(this->Terrain);
  this->Renderer->GradientBackgroundOn();
  this->Renderer->SetBackground(0.90, 0.93, 0.95);
  this->Renderer->SetBackground2(0.50, 0.66, 0.84);
  this->Renderer->SetNearClippingPlaneTolerance(1e-5); // the eye may come close to the ground
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->SetWindowName((name + " - terrain-view").c_str());
  this->Picture->AddInput(name);
  this->Window->AddRenderer(this->Renderer);
  this->Interactor->SetRenderWindow(this->Window);
  this->AddLights();
  this->AddTexts();
  this->AddScalarBar();
  this->AddMarker();
  this->AddMesh(heights);
  this->MapKeys();
  this->Connect();
}

//------------------------------------------------------------------------------
void Viewer::AddLights()
{
  this->Renderer->AutomaticLightCreationOff();
  this->Sun->SetLightTypeToSceneLight();
  this->Sun->SetPosition(-1.0, 1.0, 1.2); // in the north-west, as on maps
  this->Sun->SetFocalPoint(0.0, 0.0, 0.0);
  this->Renderer->AddLight(this->Sun);
  this->EyeLight->SetLightTypeToHeadlight();
  this->EyeLight->SetIntensity(0.5);
  this->Renderer->AddLight(this->EyeLight);
}

//------------------------------------------------------------------------------
void Viewer::SetLight(const LightOptions& options)
{
  const vtkNew<vtkTerrainGeoreference> frame;
  frame->SetFromHeights(this->Terrain->GetHeights());
  const std::string why = PlaceSun(options.Sun, frame, this->Terrain->GetHeights(),
    this->Terrain->GetVerticalExaggeration(), this->Sun);
  if (!why.empty())
  {
    throw Failure("--sun", why);
  }
  if (!this->Sun->GetSwitch())
  {
    Warn("--sun: it is night");
    this->Sun->SetIntensity(0.0); // VTK draws everything in full light where no light is on
    this->Sun->SwitchOn();
  }
  this->EyeLight->SetSwitch(options.SkyLight == 0.0 ? 1 : 0);
  options.Apply(this->Terrain);
}

//------------------------------------------------------------------------------
void Viewer::AddTexts()
{
  PutText(this->Status, 0.01, 0.985, true);
  PutText(this->Position, 0.01, 0.015, false);
  PutText(this->Help, 0.01, 0.92, true);
  PutText(this->Measured, 0.01, 0.94, true);
  this->Measured->VisibilityOff();
  this->Position->SetInput("");
  this->Position->VisibilityOff();
  this->Help->SetInput(GetHelp());
  this->Help->VisibilityOff();
  for (vtkTextActor* text :
    { this->Status.Get(), this->Position.Get(), this->Measured.Get(), this->Help.Get() })
  {
    this->Renderer->AddViewProp(text);
  }
}

//------------------------------------------------------------------------------
void Viewer::AddScalarBar()
{
  this->ScalarBar->SetTitle("Height");
  this->ScalarBar->SetNumberOfLabels(5);
  this->ScalarBar->SetLabelFormat("%.0f");
  this->ScalarBar->SetUnconstrainedFontSize(true);
  this->ScalarBar->SetVerticalTitleSeparation(8);
  for (vtkTextProperty* property :
    { this->ScalarBar->GetTitleTextProperty(), this->ScalarBar->GetLabelTextProperty() })
  {
    property->SetColor(0.05, 0.05, 0.1);
    property->SetFontSize(14);
    property->ShadowOff();
    property->ItalicOff();
    property->BoldOff();
  }
  this->ScalarBar->SetWidth(0.07);
  this->ScalarBar->SetHeight(0.45);
  this->ScalarBar->SetPosition(0.91, 0.45);
  this->Renderer->AddViewProp(this->ScalarBar);
}

//------------------------------------------------------------------------------
void Viewer::AddMarker()
{
  const vtkNew<vtkAxesActor> axes;
  axes->SetXAxisLabelText("E");
  axes->SetYAxisLabelText("N");
  axes->SetZAxisLabelText("Up");
  for (vtkCaptionActor2D* caption : { axes->GetXAxisCaptionActor2D(),
         axes->GetYAxisCaptionActor2D(), axes->GetZAxisCaptionActor2D() })
  {
    caption->GetCaptionTextProperty()->SetColor(0.05, 0.05, 0.1);
    caption->GetCaptionTextProperty()->ShadowOff();
  }
  this->Marker->SetOrientationMarker(axes);
  this->Marker->KeyPressActivationOff(); // which would take the key i
  this->Marker->SetInteractor(this->Interactor);
  this->Marker->SetViewport(0.86, 0.12, 1.0, 0.32);
  this->Marker->SetDefaultRenderer(this->Renderer);
  this->Marker->EnabledOn();
  this->Marker->InteractiveOff();
}

//------------------------------------------------------------------------------
void Viewer::AddMesh(vtkImageData* heights)
{
  this->Mesh->SetInputData(heights);
  this->MeshMapper->SetInputConnection(this->Mesh->GetOutputPort());
  this->MeshActor->SetMapper(this->MeshMapper);
  this->MeshActor->GetProperty()->SetRepresentationToWireframe();
  this->MeshActor->GetProperty()->LightingOff();
  this->MeshActor->GetProperty()->SetColor(0.1, 0.1, 0.25);
  this->MeshActor->PickableOff();
  this->MeshActor->VisibilityOff();
  this->Renderer->AddActor(this->MeshActor);
}

//------------------------------------------------------------------------------
void Viewer::AddWalls(vtkImageData* heights, bool areTilesDrawn, const std::vector<Stratum>& strata)
{
  this->Walls = strata.empty() || areTilesDrawn ? MakeWallActor(this->Terrain, heights)
                                                : MakeLayerActor(this->Terrain, heights, strata);
  if (!this->Walls)
  {
    return;
  }
  if (areTilesDrawn)
  {
    this->Walls = nullptr;
    Warn("--block: there are no walls along the edge of the data: make the raster smaller "
         "(gdal_translate -outsize 50% 50% -r average)");
    return;
  }
  this->Walls->PickableOff();
  this->Renderer->AddActor(this->Walls);
}

//------------------------------------------------------------------------------
void Viewer::Connect()
{
  this->Interactor->SetInteractorStyle(this->Style);
  this->Interactor->SetPicker(this->Picker);
  this->Style->SetDefaultRenderer(this->Renderer);
  this->Style->KeyTyped = [this](char key) { this->TypeKey(key); };
  this->Interactor->AddObserver(vtkCommand::MouseMoveEvent, this, &Viewer::PointerMoved);
  this->Interactor->AddObserver(vtkCommand::TimerEvent, this, &Viewer::TimePassed);
  this->Interactor->AddObserver(vtkCommand::ExitEvent, this, &Viewer::Close);
  this->Interactor->AddObserver(vtkCommand::DropFilesEvent, this, &Viewer::FilesDropped);
  this->Measuring = std::make_unique<Measure>(this->Picker, this->Interactor, this->Renderer,
    this->Terrain, this->Places, [this] { this->MeasureChanged(); });
}

//------------------------------------------------------------------------------
void Viewer::Close()
{
  ForgetEvents(this->Window);
  this->Interactor->TerminateApp();
}

//------------------------------------------------------------------------------
void Viewer::Run()
{
  if (!this->HasView)
  {
    this->ShowAll();
  }
  this->Refresh();
  this->Interactor->Initialize();
  this->Interactor->CreateRepeatingTimer(kPointerInterval);
  this->Interactor->Start();
}

//------------------------------------------------------------------------------
void Viewer::MapKeys()
{
  vtkOpenGLTerrainMapper* mapper = this->Terrain->GetTerrainMapper();
  const auto technique = [this] { return static_cast<int>(this->Terrain->GetTechnique()); };
  this->Keys['t'] = [this, technique] { this->SetTechnique(technique() + 1); };
  this->Keys['T'] = [this, technique] { this->SetTechnique(technique() - 1); };
  this->Keys['+'] = [this] { this->Exaggerate(kStepOfHeights); };
  this->Keys['-'] = [this] { this->Exaggerate(1.0 / kStepOfHeights); };
  this->Keys['c'] = [this]
  {
    this->Colors = NextPalette(this->Colors);
    this->HasPalette = true;
    this->UsePalette();
  };
  this->Keys['i'] = [mapper]
  {
    mapper->SetContourInterval(RoundInterval(mapper));
    mapper->SetContours(!mapper->GetContours());
  };
  this->Keys['l'] = [this, mapper]
  {
    mapper->SetHillshade(!mapper->GetHillshade());
    this->Terrain->GetProperty()->SetLighting(!mapper->GetHillshade());
  };
  this->Keys['u'] = [this] { this->Terrain->SetSunShadows(!this->Terrain->GetSunShadows()); };
  this->Keys['w'] = [this] { this->MeshActor->SetVisibility(!this->MeshActor->GetVisibility()); };
  this->Keys['x'] = [mapper] { mapper->SetShowCrossings(!mapper->GetShowCrossings()); };
  this->Keys['o'] = [this] { this->SwitchProjection(); };
  this->Keys['r'] = [this] { this->ShowAll(); };
  this->Keys['n'] = [this] { this->ShowNext(); };
  this->Keys['p'] = [this] { this->PrintPosition(); };
  this->Keys['m'] = [this]
  {
    this->Measuring->Switch();
    this->MeasureChanged();
  };
  this->Keys['y'] = [this] { this->CopyPlace(); };
  this->Keys['k'] = [this] { this->AddToFlight(); };
  this->Keys['K'] = [this] { this->DropFromFlight(); };
  this->Keys['f'] = [this] { this->SwitchFlight(); };
  this->Keys['F'] = [this] { this->SaveFlight(); };
  this->Keys['O'] = [this] { this->AskForFile(); };
  this->Keys['s'] = [this] { this->SavePicture(); };
  this->Keys['S'] = [this] { this->SaveScene(); };
  this->Keys['h'] = [this] { this->Help->SetVisibility(!this->Help->GetVisibility()); };
  this->Keys['q'] = [this] { this->Close(); };
}

//------------------------------------------------------------------------------
void Viewer::TypeKey(char key)
{
  if (this->Typing.IsOn())
  {
    this->TypePath(key);
    return;
  }
  const auto found = this->Keys.find(key);
  if (found != this->Keys.end())
  {
    this->Note.clear();
    found->second();
    this->Refresh();
  }
}

//------------------------------------------------------------------------------
void Viewer::SwitchProjection()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetParallelScale(
    camera->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())));
  camera->SetParallelProjection(!camera->GetParallelProjection());
}

//------------------------------------------------------------------------------
void Viewer::SetTechnique(int technique)
{
  const int count = static_cast<int>(kTechniqueNames.size());
  this->Terrain->SetTechnique(
    static_cast<vtkTerrainActor::Techniques>((technique + count) % count));
}

//------------------------------------------------------------------------------
void Viewer::Exaggerate(double factor)
{
  double exaggeration = this->Terrain->GetVerticalExaggeration();
  exaggeration *= factor;
  this->Terrain->SetVerticalExaggeration(exaggeration);
  this->Measuring->Refresh();
}

//------------------------------------------------------------------------------
void Viewer::ShowAll()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, -1.0, 0.78);
  camera->SetViewUp(0.0, 0.0, 1.0);
  vtkBoundingBox box;
  for (std::size_t k = 0; k <= this->Sites.size(); ++k)
  {
    vtkTerrainActor* terrain = k == 0 ? this->Terrain.Get() : this->Sites[k - 1].Terrain.Get();
    if (this->Shown == 0 || this->Shown == k + 1)
    {
      box.AddBounds(terrain->GetBounds());
    }
  }
  std::array<double, 6> bounds{};
  box.GetBounds(bounds.data());
  this->Renderer->ResetCamera(bounds.data());
  camera->Dolly(1.3); // the terrain is flatter than the sphere around it
}

//------------------------------------------------------------------------------
void Viewer::AddSite(vtkImageData* heights, const std::shared_ptr<terrain::TileSource>& tiles)
{
  constexpr double kSpeck = 0.1; // of the diagonal of all
  Site site;
  site.Terrain = vtkSmartPointer<vtkTerrainActor>::New();
  site.Terrain->SetInputData(heights);
  site.Terrain->GetTerrainMapper()->SetTileSource(tiles);
  site.Places = std::make_unique<Readout>(heights);
  // Degrees are laid out in metres round the middle of each site.
  std::array<double, 2> shift{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    shift[axis] = (site.Places->GetLayoutOrigin()[axis] - this->Places.GetLayoutOrigin()[axis]) *
      this->Places.GetLayoutScale()[axis];
  }
  site.Terrain->SetPosition(shift[0], shift[1], 0.0);
  this->Renderer->AddActor(site.Terrain);
  this->Sites.push_back(std::move(site));
  vtkBoundingBox box(this->Terrain->GetBounds());
  const double own = box.GetDiagonalLength();
  for (const Site& each : this->Sites)
  {
    box.AddBounds(each.Terrain->GetBounds());
  }
  this->Shown = own < kSpeck * box.GetDiagonalLength() ? 1 : 0;
}

//------------------------------------------------------------------------------
std::array<double, 2> Viewer::GetHeightRange() const
{
  std::array<double, 2> range{};
  this->Terrain->GetTerrainMapper()->GetHeightRange(range.data());
  for (const Site& site : this->Sites)
  {
    std::array<double, 2> own{};
    site.Terrain->GetTerrainMapper()->GetHeightRange(own.data());
    range = { std::min(range[0], own[0]), std::max(range[1], own[1]) };
  }
  return range;
}

//------------------------------------------------------------------------------
void Viewer::UsePalette()
{
  ApplyPalette(this->Colors, this->GetHeightRange(), this->Terrain);
}

//------------------------------------------------------------------------------
void Viewer::ShowNext()
{
  this->Shown = (this->Shown + 1) % (this->Sites.size() + 2);
  this->ShowAll();
}

//------------------------------------------------------------------------------
void Viewer::MatchSites()
{
  for (const Site& site : this->Sites)
  {
    site.Terrain->SetTechnique(this->Terrain->GetTechnique());
    site.Terrain->SetVerticalExaggeration(this->Terrain->GetVerticalExaggeration());
    site.Terrain->SetColorByHeight(this->Terrain->GetColorByHeight());
    site.Terrain->SetLookupTable(this->Terrain->GetLookupTable());
    site.Terrain->GetProperty()->DeepCopy(this->Terrain->GetProperty());
    site.Terrain->GetTerrainMapper()->GetLook()->DeepCopy(
      this->Terrain->GetTerrainMapper()->GetLook());
    site.Terrain->SetSunShadows(this->Terrain->GetSunShadows());
  }
}

//------------------------------------------------------------------------------
std::string Viewer::DescribeShown() const
{
  const std::string count = std::to_string(this->Sites.size() + 1);
  return this->Sites.empty() ? std::string()
    : this->Shown == 0       ? "  all " + count + " sites (n: next)"
                       : "  site " + std::to_string(this->Shown) + " of " + count + " (n: next)";
}

//------------------------------------------------------------------------------
void Viewer::PrintPosition()
{
  this->PointerMoved();
  this->TellPosition();
  std::cout << this->Position->GetInput() << std::endl;
  if (!this->Measuring->Describe().empty())
  {
    std::cout << this->Measuring->Describe() << std::endl;
  }
}

//------------------------------------------------------------------------------
void Viewer::SavePicture()
{
  const vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(this->Window);
  capture->ReadFrontBufferOff();
  const vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(capture->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (!bytes ||
    !(this->Picture->Open(kPictureFile) &&
      this->Picture->Write(
        bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues())) &&
      this->Picture->Commit()))
  {
    Warn("the picture is not saved: " + this->Picture->GetErrorMessage());
  }
}

//------------------------------------------------------------------------------
void Viewer::Refresh()
{
  const auto technique = static_cast<std::size_t>(this->Terrain->GetTechnique());
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "%s  exaggeration %.2f  colours %s   h: help",
    kTechniqueNames[technique], this->Terrain->GetVerticalExaggeration(), NameOf(this->Colors));
  this->Status->SetInput(this->Typing.IsOn()
      ? this->Typing.GetPrompt().c_str()
      : (text.data() + this->DescribeShown() + this->Note).c_str());
  this->MatchSites();
  this->ScalarBar->SetLookupTable(this->Terrain->GetLookupTable());
  this->ScalarBar->SetVisibility(
    this->Terrain->GetColorByHeight() && !this->Terrain->GetTerrainMapper()->GetShowCrossings());
  this->Terrain->PlaceAsDrawn(this->MeshActor);
  if (this->Walls)
  {
    this->Terrain->PlaceAsDrawn(this->Walls);
    if (this->Terrain->GetTerrainMapper()->GetBlock()) // else its layers have their own colours
    {
      this->Walls->GetMapper()->SetLookupTable(this->Terrain->GetLookupTable());
      this->Walls->GetMapper()->SetScalarVisibility(this->Terrain->GetColorByHeight());
      this->Walls->SetVisibility(
        this->Terrain->GetTechnique() == vtkTerrainActor::Techniques::Pyramid);
    }
  }
  this->Renderer->ResetCameraClippingRange();
  this->Window->Render();
}

//------------------------------------------------------------------------------
void Viewer::PointerMoved()
{
  this->PointerHasMoved = true;
}

//------------------------------------------------------------------------------
void Viewer::TimePassed(vtkObject* /*caller*/, unsigned long /*event*/, void* timer)
{
  if (*static_cast<const int*>(timer) == this->FlightTimer)
  {
    this->FlyOn();
    return;
  }
  this->Board.Serve();
  this->PollDialog();
  this->TellPosition();
}

//------------------------------------------------------------------------------
void Viewer::TellPosition()
{
  if (!this->PointerHasMoved)
  {
    return;
  }
  this->PointerHasMoved = false;
  const int* pointer = this->Interactor->GetEventPosition();
  this->Picker->Pick(pointer[0] + 0.5, pointer[1] + 0.5, 0.0, this->Renderer);
  const Readout* places = &this->Places;
  for (const Site& site : this->Sites)
  {
    places = this->Picker->GetViewProp() == site.Terrain ? site.Places.get() : places;
  }
  const std::string text = places->Describe(this->Picker);
  if (text != this->Position->GetInput())
  {
    this->Position->SetInput(text.c_str());
    this->Position->SetVisibility(!text.empty());
    this->Window->Render();
  }
}
