// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What goes in and out of the window: scenes, places, files.
#include "Viewer.h"

#include "Failure.h"
#include "Messages.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkProperty.h"
#include "vtkStringArray.h"
#include "vtkTerrainLook.h"
#include "vtkTerrainViewpoint.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <system_error>

namespace
{
constexpr const char* kSceneFile = "terrain-view";

constexpr std::array<const char*, 6> kTechniques{ "mesh", "linear", "exponential", "equidistant",
  "pyramid", "strips" };

std::string NumberText(double number, int digits)
{
  std::ostringstream text;
  text.precision(digits);
  text << number;
  return text.str();
}

/// Numbers with commas between them.
std::string ListText(const std::vector<double>& numbers)
{
  std::string text;
  for (const double number : numbers)
  {
    text += (text.empty() ? "" : ",") + NumberText(number, 12);
  }
  return text;
}

}

//------------------------------------------------------------------------------
std::string Viewer::FreeName(const std::string& name, const std::string& extension)
{
  std::string free = name + extension;
  for (int number = 2; std::filesystem::exists(free); ++number)
  {
    free = name;
    free.append("-").append(std::to_string(number)).append(extension);
  }
  return free;
}

//------------------------------------------------------------------------------
std::array<double, 3> Viewer::ToDrawn(const std::array<double, 3>& point, bool isBack) const
{
  const vtkNew<vtkActor> frame;
  this->Terrain->PlaceAsDrawn(frame);
  const vtkNew<vtkMatrix4x4> matrix;
  frame->GetMatrix(matrix);
  if (isBack)
  {
    matrix->Invert();
  }
  std::array<double, 4> moved{ point[0], point[1], point[2], 1.0 };
  matrix->MultiplyPoint(moved.data(), moved.data());
  return { moved[0], moved[1], moved[2] };
}

//------------------------------------------------------------------------------
std::array<double, 3> Viewer::FindPoint(const std::string& option, const std::string& text) const
{
  const PlaceText read = ReadPlace(text);
  std::array<double, 3> point{};
  if (!this->Places.FromPlace(read.Place.data(), point.data()))
  {
    throw Failure(option, "the heights have no place on earth that is known: --camera needs none");
  }
  double ground = 0.0;
  if (read.IsAboveGround)
  {
    const vtkNew<vtkTerrainViewpoint> heights;
    heights->SetHeights(this->Terrain->GetHeights());
    ground = heights->GetGround(point[0], point[1]);
    if (!std::isfinite(ground))
    {
      throw Failure(option, "'" + text + "' is beside the heights: give a height above sea level");
    }
  }
  point[2] = ground + read.Height;
  return this->ToDrawn(point, false);
}

//------------------------------------------------------------------------------
void Viewer::Look(const ViewOptions& options)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetViewAngle(options.Angle);
  for (std::size_t k = 0; k < kTechniques.size(); ++k)
  {
    if (options.Technique == kTechniques[k])
    {
      this->SetTechnique(static_cast<int>(k));
    }
  }
  this->HasView = !options.Camera.empty() || !options.LookFrom.empty();
  if (!options.Camera.empty())
  {
    const std::vector<double> numbers = options.GetCamera();
    camera->SetPosition(numbers.data());
    camera->SetFocalPoint(numbers.data() + 3);
    camera->SetViewUp(0.0, 0.0, 1.0);
    if (numbers.size() > 6)
    {
      camera->SetViewUp(numbers.data() + 6);
    }
  }
  else if (this->HasView)
  {
    camera->SetPosition(this->FindPoint("--look-from", options.LookFrom).data());
    camera->SetFocalPoint(this->FindPoint("--look-at", options.LookAt).data());
    camera->SetViewUp(0.0, 0.0, 1.0);
  }
}

//------------------------------------------------------------------------------
std::string Viewer::DescribePoint(const std::array<double, 3>& drawn, bool asPlace) const
{
  const std::array<double, 3> point = this->ToDrawn(drawn, true);
  std::array<double, 2> place{};
  return !asPlace                                      ? ListText({ drawn[0], drawn[1], drawn[2] })
    : this->Places.ToPlace(point.data(), place.data()) ? ListText({ place[0], place[1], point[2] })
                                                       : std::string();
}

//------------------------------------------------------------------------------
void Viewer::DescribeCamera(SceneValues& values) const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const FlightView view = this->GetView();
  const std::string from = this->DescribePoint(view.Eye, true);
  const std::string at = this->DescribePoint(view.Focus, true);
  const bool hasPlaces = !from.empty() && !at.empty();
  values["look-from"] = hasPlaces ? std::vector{ from } : std::vector<std::string>();
  values["look-at"] = hasPlaces ? std::vector{ at } : std::vector<std::string>();
  values["camera"].clear();
  if (!hasPlaces)
  {
    std::vector<double> numbers;
    for (const double* triple :
      { camera->GetPosition(), camera->GetFocalPoint(), camera->GetViewUp() })
    {
      numbers.insert(numbers.end(), triple, triple + 3);
    }
    values["camera"] = { ListText(numbers) };
  }
  values["view-angle"] = { NumberText(camera->GetViewAngle(), 6) };
}

//------------------------------------------------------------------------------
void Viewer::DescribeColors(SceneValues& values) const
{
  if (this->HasPalette)
  {
    const bool isScheme = this->Colors == Palette::Relief || this->Colors == Palette::Grey;
    values["colors"] =
      isScheme ? std::vector<std::string>{ NameOf(this->Colors) } : std::vector<std::string>();
    values["range"].clear();
    values["reverse"].clear();
  }
}

//------------------------------------------------------------------------------
Viewer::SceneValues Viewer::DescribeScene() const
{
  using Texts = std::vector<std::string>;
  SceneValues values;
  vtkOpenGLTerrainMapper* mapper = this->Terrain->GetTerrainMapper();
  const auto flag = [](bool is) { return is ? Texts{ "true" } : Texts(); };
  this->DescribeCamera(values);
  this->DescribeColors(values);
  values["exaggeration"] = { NumberText(this->Terrain->GetVerticalExaggeration(), 6) };
  values["hillshade"] = flag(mapper->GetHillshade());
  // terrain-render takes either of them
  const bool isLit = !mapper->GetHillshade();
  values["shadows"] = flag(isLit && this->Terrain->GetSunShadows());
  if (!isLit)
  {
    values["sun"].clear();
    values["sky-light"].clear();
  }
  const bool hasLines = mapper->GetContours();
  values["contours"] = hasLines ? Texts{ NumberText(mapper->GetContourInterval(), 6) } : Texts();
  values["contour-index"] = hasLines ? Texts{ std::to_string(mapper->GetContourIndex()) } : Texts();
  const auto technique = static_cast<std::size_t>(this->Terrain->GetTechnique());
  values["technique"] =
    std::string(kTechniques[technique]) == "pyramid" ? Texts() : Texts{ kTechniques[technique] };
  return values;
}

//------------------------------------------------------------------------------
void Viewer::SaveScene()
{
  const std::string name =
    this->SceneFile.empty() ? FreeName(kSceneFile, ".toml") : this->SceneFile;
  if (!this->WriteScene)
  {
    return;
  }
  const SceneValues values = this->DescribeScene();
  const auto colors = values.find("colors");
  if (colors != values.end() && colors->second.empty())
  {
    Warn(std::string("the colours '") + NameOf(this->Colors) + "' are not those of a scheme");
  }
  this->SaveText(name, this->WriteScene(name, values), "scene");
}

//------------------------------------------------------------------------------
void Viewer::SaveSession(const std::string& path) const
{
  if (path.empty() || !this->WriteScene)
  {
    return;
  }
  const std::string text = this->WriteScene(path, this->DescribeScene());
  std::error_code error; // what follows tells that there is no folder
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
  const vtkNew<vtkTerrainOutputFile> file;
  if (!(file->Open(path) && file->Write(text.data(), text.size()) && file->Commit()))
  {
    Warn("the scene is not kept for the next time: " + file->GetErrorMessage());
  }
}

//------------------------------------------------------------------------------
void Viewer::SaveText(const std::string& name, const std::string& text, const std::string& what)
{
  const vtkNew<vtkTerrainOutputFile> file;
  for (const std::string& input : this->SceneInputs)
  {
    file->AddInput(input);
  }
  if (!(file->Open(name) && file->Write(text.data(), text.size()) && file->Commit()))
  {
    Warn("the " + what + " is not saved: " + file->GetErrorMessage());
    this->Note = "  the " + what + " is not saved";
    return;
  }
  this->Note = "  saved " + name;
  std::cout << name << std::endl;
}

//------------------------------------------------------------------------------
void Viewer::CopyPlace()
{
  this->PointerHasMoved = true;
  this->TellPosition();
  const std::string text = this->Position->GetInput();
  const bool isThere = !text.empty();
  const bool isCopied = isThere && this->Board.Offer(text);
  this->Note = isCopied ? "  copied"
    : isThere           ? "  there is no clipboard (p prints the place)"
                        : "  there is no terrain under the pointer";
}

//------------------------------------------------------------------------------
void Viewer::FilesDropped(vtkObject*, unsigned long, void* files)
{
  auto* names = static_cast<vtkStringArray*>(files);
  if (!names || names->GetNumberOfValues() == 0)
  {
    return;
  }
  this->OpenFile(names->GetValue(0));
}

//------------------------------------------------------------------------------
void Viewer::AskForFile()
{
  if (!this->Dialog.Open())
  {
    this->Typing.Begin();
  }
}

//------------------------------------------------------------------------------
void Viewer::PollDialog()
{
  const std::optional<std::string> chosen = this->Dialog.Poll();
  if (chosen && !chosen->empty())
  {
    this->OpenFile(*chosen);
  }
}

//------------------------------------------------------------------------------
void Viewer::TypePath(char key)
{
  if (this->Typing.Take(key) == TypedPath::State::Done)
  {
    this->OpenFile(this->Typing.GetPath());
    return;
  }
  this->Refresh();
}

//------------------------------------------------------------------------------
void Viewer::OpenFile(const std::string& name)
{
  const std::string why = this->WhyNotShown ? this->WhyNotShown(name) : "it cannot be shown";
  if (!why.empty())
  {
    Warn(why);
    this->Note = "  that is nothing to be shown";
    this->Refresh();
    return;
  }
  this->Next = name;
  this->Close();
}

//------------------------------------------------------------------------------
void Viewer::MeasureChanged()
{
  const std::string text = this->Measuring->Describe();
  this->Measured->SetInput(
    text.empty() ? "measure: click points of a line on the ground" : text.c_str());
  this->Measured->SetVisibility(this->Measuring->IsOn());
}
