// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * terrain-view: a window on a file of heights. What keys do is told by --help, and by the key h.
 * Exit status: 0, 2 for a wrong command line, 1 otherwise, with one line on stderr.
 */
#include "ColorOptions.h"
#include "EmptyValues.h"
#include "Ending.h"
#include "ExaggerationOption.h"
#include "Failure.h"
#include "HeightOptions.h"
#include "LightOptions.h"
#include "Messages.h"
#include "NotNumbers.h"
#include "SceneNames.h"
#include "Session.h"
#include "SurfaceOptions.h"
#include "ViewOptions.h"
#include "Viewer.h"

#include "vtkImageAlgorithm.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainSource.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace
{
constexpr int kWrongCommandLine = 2;

struct Options
{
  std::string Heights;
  HeightOptions Input;
  ColorOptions Colors;
  LightOptions Light;
  SurfaceOptions Surface;
  ExaggerationOption Exaggeration;
  ViewOptions View;
  SceneFile Scene;
  /// True to show nothing from the last time.
  bool StartsAnew = false;
  int Width = 1280;
  int Height = 720;
  /// The command line, which scenes are about.
  std::unique_ptr<CLI::App> App =
    std::make_unique<CLI::App>("Shows a file of heights in a window.", "terrain-view");
};

/// Samples a side that every graphics driver takes; larger rasters are drawn from tiles.
constexpr int kLargestTexture = 16384;
/// Samples a side of the image beside tiles.
constexpr int kBesideTiles = 4096;

vtkSmartPointer<vtkImageAlgorithm> MakeSource(const std::string& file, const HeightOptions& input)
{
  if (file.empty())
  {
    return vtkSmartPointer<vtkTerrainSource>::New();
  }
  auto reader = vtkSmartPointer<vtkTerrainRasterReader>::New();
  reader->SetFileName(file);
  input.Apply(reader);
  reader->WarnOfSitesOff(); // all are drawn
  reader->UseLevelsOn();
  reader->SetMaximumSize(kLargestTexture);
  reader->UpdateInformation();
  if (reader->GetLevel() > 0)
  {
    reader->SetMaximumSize(kBesideTiles);
    reader->WarnOfLevelsOff();
  }
  return reader;
}

/// The other sites of a folder; those that cannot be read are told of.
void AddSites(Viewer& viewer, vtkTerrainRasterReader* first, const Options& options)
{
  const int count = first ? first->GetNumberOfSites() : 1;
  if (count > 1)
  {
    Warn(options.Heights + ": its tiles lie at " + std::to_string(count) +
      " sites far from each other, a terrain each (the key n goes to the next, --part N, from 1 "
      "to " +
      std::to_string(count) + ", shows one alone)");
  }
  for (int site = 1; site <= count; ++site)
  {
    if (site == first->GetSite())
    {
      continue;
    }
    HeightOptions own = options.Input;
    own.Part = std::to_string(site);
    const vtkSmartPointer<vtkImageAlgorithm> source = MakeSource(options.Heights, own);
    source->Update();
    try
    {
      ThrowOnError(options.Heights);
      viewer.AddSite(
        source->GetOutput(), vtkTerrainRasterReader::SafeDownCast(source)->GetTileSource());
    }
    catch (const Failure& failure)
    {
      Warn("site " + own.Part + " is not shown: " + failure.what());
    }
  }
}

/// Throws where a window would end the program: VTK does not say that a display does not open.
void CheckDisplay()
{
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
  {
    throw Failure(
      "DISPLAY", "is not set, and a window needs an X server (terrain-render does not)");
  }
  // VTK loads the library as well, at the latest for its window. The connection stays open: a
  // server may reset itself when its only one closes, just before the window connects.
  void* library = dlopen("libX11.so.6", RTLD_NOW | RTLD_GLOBAL);
  if (!library)
  {
    throw Failure("libX11.so.6", "is not installed, and a window needs it");
  }
  using Open = void* (*)(const char* name);
  const auto open = reinterpret_cast<Open>(dlsym(library, "XOpenDisplay"));
  if (open && !open(display))
  {
    throw Failure(display, "does not open: there is no such X server, or it refuses this user");
  }
}

/// Fills in the options; the exit status if there is nothing to show.
std::optional<int> ParseCommandLine(int argc, const char* const* argv, Options& options)
{
  CLI::App& app = *options.App;
  app.footer(std::string("Keys in the window:\n") + Viewer::GetHelp());
  app.set_version_flag("--version", TERRAIN_VIEW_VERSION);
  app
    .add_option("HEIGHTS", options.Heights,
      "any raster that GDAL opens, a folder or an archive (.zip, .tar, .tgz) of them, which is one "
      "terrain, or a file of terrain-prepare; without it what was shown last, at first a built-in "
      "landscape")
    ->check(CLI::Validator(HeightOptions::WhyNotFile, ""));
  options.Exaggeration.Declare(app);
  options.Input.Declare(app);
  options.Colors.Declare(app, false);
  options.Light.Declare(app, false);
  options.Surface.Declare(app);
  options.View.Declare(app);
  app.add_option("--width", options.Width, "of the window in pixels, default 1280")
    ->check(CLI::Range(64, 16384));
  app.add_option("--height", options.Height, "of the window in pixels, default 720")
    ->check(CLI::Range(64, 16384));
  app.add_flag("--no-restore", options.StartsAnew,
    "without HEIGHTS the built-in landscape, not what was shown last");
  SceneNames names = NamesOfRenderScenes();
  names.Others.insert("no-restore");
  names.KeepsUnknown = true;
  options.Scene.Declare(app, names);
  try
  {
    RefuseEmptyValues(argc, argv);
    app.parse(argc, argv);
    RefuseNotANumber(app);
    options.Surface.CheckLight(options.Light);
    options.Surface.CheckStrata();
    options.View.Check();
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      return app.exit(error); // --help, --version
    }
    std::cerr << "terrain-view: " << options.Scene.Explain(error.what()) << '\n';
    return kWrongCommandLine;
  }
  return std::nullopt;
}

/// True for the files of scenes.
bool IsScene(const std::string& path)
{
  return std::filesystem::path(path).extension() == ".toml";
}

/// The options of a file that was dropped into a window of some size; the exit status if there is
/// nothing to show.
std::optional<int> ParseDropped(
  const std::string& path, const std::array<int, 2>& size, Options& options)
{
  std::vector<std::string> words = { "terrain-view", "--width", std::to_string(size[0]), "--height",
    std::to_string(size[1]), path };
  if (IsScene(path))
  {
    words.insert(words.end() - 1, "--scene");
  }
  std::vector<const char*> pointers;
  pointers.reserve(words.size());
  for (const std::string& word : words)
  {
    pointers.push_back(word.c_str());
  }
  return ParseCommandLine(static_cast<int>(pointers.size()), pointers.data(), options);
}

/// One sentence if a file cannot be shown; empty if it can.
std::string WhyNotShown(const std::string& path)
{
  Options options;
  if (ParseDropped(path, { options.Width, options.Height }, options))
  {
    return path + " is no scene that can be shown";
  }
  try
  {
    MakeSource(options.Heights, options.Input);
    ThrowOnError(options.Heights);
  }
  catch (const Failure& failure)
  {
    return failure.what();
  }
  return {};
}

/// True if a command line names nothing that is shown, nor how.
bool IsBare(const Options& options)
{
  const auto isAboutScene = [](const CLI::Option* option)
  {
    const std::string name = option->get_name();
    return option->count() > 0 && name != "--width" && name != "--height";
  };
  return options.App->get_options(isAboutScene).empty();
}

/// Reads what was shown last, where a command line leaves room for it, and tells of it. False if
/// there is nothing.
bool Restore(const Options& given, Options& last)
{
  const std::string path = GetSessionPath();
  std::error_code error;
  if (given.StartsAnew || !IsBare(given) || !std::filesystem::exists(path, error))
  {
    return false;
  }
  const std::string why = WhyNotShown(path);
  if (!why.empty())
  {
    Warn("what was shown last cannot be shown: " + why);
    return false;
  }
  Tell("what was shown last, from " + path + " (--no-restore leaves it)");
  return !ParseDropped(path, { given.Width, given.Height }, last);
}

/// The text of a scene with values as the window shows them.
std::string WriteScene(Options& options, const std::string& path, const Viewer::SceneValues& values)
{
  for (const auto& [name, texts] : values)
  {
    options.Scene.Replace(name, texts);
  }
  // the window is not the picture
  return options.Scene.ToText(path, { "width", "height", "save-scene" });
}

/// Shows a window; returns the file that was dropped into it, empty for none.
std::string Show(Options& options)
{
  const std::string name = options.Heights.empty() ? "built-in landscape" : options.Heights;
  const vtkSmartPointer<vtkImageAlgorithm> source = MakeSource(options.Heights, options.Input);
  source->Update();
  ThrowOnError(name);
  Viewer viewer(source->GetOutput(), name, options.Width, options.Height);
  viewer.KeepFile(options.Input.CoordinateSystem);
  viewer.KeepFile(options.Colors.GetFileName());
  if (!viewer.GetTerrain()->HasSurface())
  {
    throw Failure(name, "no four neighbouring samples all have heights");
  }
  if (auto* reader = vtkTerrainRasterReader::SafeDownCast(source))
  {
    viewer.GetTerrain()->GetTerrainMapper()->SetTileSource(reader->GetTileSource());
  }
  AddSites(viewer, vtkTerrainRasterReader::SafeDownCast(source), options);
  const double factor = options.Exaggeration.Choose(source->GetOutput(), false);
  options.Exaggeration.TellIfOdd(source->GetOutput(), factor);
  viewer.GetTerrain()->SetVerticalExaggeration(factor);
  viewer.SetLight(options.Light);
  const std::array<double, 2> range = viewer.GetHeightRange();
  options.Surface.Apply(viewer.GetTerrain(), range[0]);
  viewer.GetTerrain()->GetProperty()->SetLighting(!options.Surface.Hillshade);
  if (options.Colors.IsGiven())
  {
    viewer.GetTerrain()->SetLookupTable(options.Colors.MakeTable(range[0], range[1]));
  }
  else
  {
    viewer.UsePalette();
  }
  if (options.Surface.Block > 0.0)
  {
    auto* reader = vtkTerrainRasterReader::SafeDownCast(source);
    viewer.AddWalls(
      source->GetOutput(), reader && reader->GetTileSource(), options.Surface.GetStrata());
  }
  if (vtkTerrainHierarchy::IsPreparedFile(options.Heights))
  {
    const vtkNew<vtkTerrainHierarchy> hierarchy;
    hierarchy->OpenFile(options.Heights);
    viewer.GetTerrain()->SetHierarchy(hierarchy);
  }
  viewer.Look(options.View);
  viewer.SetSceneWriter([&options](const std::string& path, const Viewer::SceneValues& values)
    { return WriteScene(options, path, values); });
  viewer.SetSceneFile(options.Scene.GetOutput(), { options.Heights, options.Scene.GetInput() });
  viewer.SetOpener(WhyNotShown);
  viewer.Run();
  ThrowOnError(name);
  viewer.SaveSession(GetSessionPath());
  return viewer.GetNext();
}
}

int main(int argc, char* argv[])
{
  try
  {
    Options options;
    const std::optional<int> status = ParseCommandLine(argc, argv, options);
    if (status)
    {
      return *status;
    }
    EndOnSignals("terrain-view: stopped on request\n");
    CatchMessages("terrain-view");
    CheckDisplay();
    // No window that nobody would see.
    setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkXOpenGLRenderWindow", 1);
    Options last;
    for (std::string next = Show(Restore(options, last) ? last : options); !next.empty();)
    {
      Options dropped;
      ParseDropped(next, { options.Width, options.Height }, dropped);
      next = Show(dropped);
    }
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "terrain-view: " << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
