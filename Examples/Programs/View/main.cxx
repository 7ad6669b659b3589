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
#include "SurfaceOptions.h"
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
#include <iostream>
#include <optional>
#include <string>

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
  int Width = 1280;
  int Height = 720;
};

/// Samples a side that every graphics driver takes; larger rasters are drawn from tiles.
constexpr int kLargestTexture = 16384;
/// Samples a side of the image beside tiles.
constexpr int kBesideTiles = 4096;

vtkSmartPointer<vtkImageAlgorithm> MakeSource(const Options& options)
{
  if (options.Heights.empty())
  {
    return vtkSmartPointer<vtkTerrainSource>::New();
  }
  auto reader = vtkSmartPointer<vtkTerrainRasterReader>::New();
  reader->SetFileName(options.Heights);
  options.Input.Apply(reader);
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
    Options own = options;
    own.Input.Part = std::to_string(site);
    const vtkSmartPointer<vtkImageAlgorithm> source = MakeSource(own);
    source->Update();
    try
    {
      ThrowOnError(options.Heights);
      viewer.AddSite(
        source->GetOutput(), vtkTerrainRasterReader::SafeDownCast(source)->GetTileSource());
    }
    catch (const Failure& failure)
    {
      Warn("site " + own.Input.Part + " is not shown: " + failure.what());
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

void Show(const Options& options)
{
  CheckDisplay();
  // No window that nobody would see.
  setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkXOpenGLRenderWindow", 1);
  const std::string name = options.Heights.empty() ? "built-in landscape" : options.Heights;
  const vtkSmartPointer<vtkImageAlgorithm> source = MakeSource(options);
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
  viewer.Run();
  ThrowOnError(name);
}

/// Fills in the options; the exit status if there is nothing to show.
std::optional<int> ParseCommandLine(int argc, char* argv[], Options& options)
{
  CLI::App app("Shows a file of heights in a window.", "terrain-view");
  app.footer(std::string("Keys in the window:\n") + Viewer::GetHelp());
  app.set_version_flag("--version", TERRAIN_VIEW_VERSION);
  app
    .add_option("HEIGHTS", options.Heights,
      "any raster that GDAL opens, or a file of terrain-prepare; the built-in landscape without it")
    ->check(CLI::Validator(HeightOptions::WhyNotFile, ""));
  options.Exaggeration.Declare(app);
  options.Input.Declare(app);
  options.Colors.Declare(app, false);
  options.Light.Declare(app, false);
  options.Surface.Declare(app);
  app.add_option("--width", options.Width, "of the window in pixels, default 1280")
    ->check(CLI::Range(64, 16384));
  app.add_option("--height", options.Height, "of the window in pixels, default 720")
    ->check(CLI::Range(64, 16384));
  try
  {
    RefuseEmptyValues(argc, argv);
    app.parse(argc, argv);
    RefuseNotANumber(app);
    options.Surface.CheckLight(options.Light);
    options.Surface.CheckStrata();
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      return app.exit(error); // --help, --version
    }
    std::cerr << "terrain-view: " << error.what() << '\n';
    return kWrongCommandLine;
  }
  return std::nullopt;
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
    Show(options);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "terrain-view: " << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
