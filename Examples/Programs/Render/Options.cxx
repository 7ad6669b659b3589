// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Arguments.h"
#include "EmptyValues.h"
#include "NotNumbers.h"
#include "Outputs.h"
#include "SceneFile.h"
#include "SceneNames.h"

#include "vtkNew.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainOutputFile.h"

#include <CLI/CLI.hpp>
#include <cpl_string.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <system_error>
#include <utility>
#include <vector>

namespace
{
constexpr int kWrongCommandLine = 2;

const std::map<std::string, Technique> kTechniques = { { "mesh", Technique::Mesh },
  { "linear", Technique::Linear }, { "exponential", Technique::Exponential },
  { "equidistant", Technique::Equidistant }, { "pyramid", Technique::Pyramid },
  { "strips", Technique::Strips } };

const std::map<std::string, Window> kWindows = { { "auto", Window::Automatic },
  { "egl", Window::EGL }, { "osmesa", Window::OSMesa }, { "x", Window::X } };

std::array<int, 2> ParseSize(const std::string& text)
{
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos)
  {
    Refuse("--size", "'" + text + "' is not of the form WIDTHxHEIGHT");
  }
  return { ParseInteger("--size", text.substr(0, cross), 1, kMaximumSize),
    ParseInteger("--size", text.substr(cross + 1), 1, kMaximumSize) };
}

/// Three numbers of the list, from the given one on.
std::array<double, 3> Triple(const std::vector<double>& numbers, std::size_t first)
{
  return { numbers[first], numbers[first + 1], numbers[first + 2] };
}

/// True if the up vector and the direction of view span a plane.
bool HasUpright(const Camera& camera)
{
  const auto& up = camera.Up;
  const std::array<double, 3> direction = { camera.FocalPoint[0] - camera.Eye[0],
    camera.FocalPoint[1] - camera.Eye[1], camera.FocalPoint[2] - camera.Eye[2] };
  const std::array<double, 3> cross = { up[1] * direction[2] - up[2] * direction[1],
    up[2] * direction[0] - up[0] * direction[2], up[0] * direction[1] - up[1] * direction[0] };
  constexpr double kSmallestSine = 1e-9;
  return std::hypot(cross[0], cross[1], cross[2]) > kSmallestSine *
    std::hypot(up[0], up[1], up[2]) * std::hypot(direction[0], direction[1], direction[2]);
}

void CheckCoordinateSystem(const std::string& definition)
{
  const vtkNew<vtkTerrainGeoreference> reference;
  reference->SetCoordinateSystem(definition);
  reference->SetFrame(vtkTerrainGeoreference::FrameType::Grid);
  if (reference->IsOnOtherWorld())
  {
    return;
  }
  reference->SetFrame(vtkTerrainGeoreference::FrameType::Geocentric);
  const std::string why = reference->GetWhyNot();
  if (!why.empty())
  {
    Refuse("--crs", why);
  }
}

Camera ParseCamera(const std::string& text)
{
  constexpr double kFarthest = 1e12;
  const std::vector<double> numbers = ParseNumbers("--camera", text, kFarthest);
  if (numbers.size() != 6 && numbers.size() != 9)
  {
    Refuse("--camera",
      "takes 6 or 9 numbers with commas between them, not " + std::to_string(numbers.size()));
  }
  Camera camera;
  camera.Eye = Triple(numbers, 0);
  camera.FocalPoint = Triple(numbers, 3);
  if (camera.Eye == camera.FocalPoint)
  {
    Refuse("--camera", "the eye is the focal point: there is no direction to look in");
  }
  if (numbers.size() == 9)
  {
    camera.Up = Triple(numbers, 6);
    if (!HasUpright(camera))
    {
      Refuse("--camera", "the up vector has no length or lies along the direction of view");
    }
  }
  else if (!HasUpright(camera))
  {
    camera.Up = { 0.0, 1.0, 0.0 }; // straight up or down: north is on top
  }
  return camera;
}

/// What the options gave as text.
struct Texts
{
  std::string Size;
  std::string Piece;
  std::string Dots;
  std::string MeshCells;
  std::string Camera;
  std::string ViewAngle;
  std::string Frames;
  std::string Memory;
  std::string LargestTexture;
  PlaceArguments Place;
  std::string PixelTolerance;
  std::string Steps;
  std::string LongSteps;
  std::string SecantSteps;
  std::string StepLength;
  DetailArguments Detail;
};

constexpr const char* kHelpOfStats =
  "JSON: record and warnings as --describe, columns, rows, samples, samples_without_data, crs, "
  "height_unit, height_range (m), bounds (x, y, z of the scene, m), cell with cell_unit, "
  "exaggeration, technique, window, width, height, texture_bytes, peak_memory_bytes, and "
  "{min, median, max} in ms of read, prepare, first_frame, frame_cpu, frame_gpu, total";

/// Adds an option with a value to an application.
struct Adder
{
  CLI::App& App;
  template <typename Value>
  CLI::Option* operator()(const char* name, Value& value, const char* type, const char* help) const
  {
    return this->App.add_option(name, value, help)->type_name(type);
  }
};

/// The file, the picture, and how the surface is found.
void DeclareSearch(CLI::App& app, Options& options, Texts& texts)
{
  const Adder add{ app };
  add("HEIGHTS", options.Heights, "FILE",
    "heights: any raster GDAL opens, a folder or an archive (.zip, .tar, .tgz) of them, which is "
    "one "
    "terrain, or a file of terrain-prepare; the built-in landscape without")
    ->check(CLI::Validator(HeightOptions::WhyNotFile, ""));
  add("--memory", texts.Memory, "MIB",
    "most memory for a raster that is larger than a texture; default 1024");
  add("--largest-texture", texts.LargestTexture, "SAMPLES",
    "samples a side above which a raster is drawn from tiles; default and most 16384");
  app.add_flag("--no-cache", options.NoCache,
    "neither use nor keep the levels of such a raster (~/.cache/vtkterrain)");
  add("--output", options.Output, "FILE", "picture, .png or .jpg; default terrain.png");
  add("--size", texts.Size, "WIDTHxHEIGHT", "of the picture in pixels; default 1280x720");
  add("--piece", texts.Piece, "PIXELS",
    "largest side that is drawn at once: larger pictures are drawn in pieces; default 4096");
  add("--dpi", texts.Dots, "DOTS",
    "per inch, told in the picture; texts then have their size on paper");
  add("--technique", options.Search, "NAME",
    "how the surface is found: pyramid (default, exact), equidistant, exponential, linear, "
    "strips, mesh")
    ->transform(CLI::CheckedTransformer(kTechniques).description(""));
  add("--mesh-cells", texts.MeshCells, "N",
    "cells along the side of a quad of the technique mesh; default 1");
  add("--steps", texts.Steps, "N",
    "of the techniques linear (default 5), exponential (10), equidistant (all it needs)");
  add("--long-steps", texts.LongSteps, "N", "further steps of double length of equidistant");
  add("--step-length", texts.StepLength, "CELLS", "of a step of equidistant; default 1.5");
  add("--secant-steps", texts.SecantSteps, "N",
    "that narrow down what a search has found; default 2, equidistant 6");
}

/// From where it is seen, and what else comes of it.
void DeclareView(CLI::App& app, Options& options, Texts& texts)
{
  const Adder add{ app };
  add("--camera", texts.Camera, "EX,EY,EZ,FX,FY,FZ[,UX,UY,UZ]",
    "eye, focal point and up in world coordinates, z exaggerated; default: all of the terrain in "
    "view, from the south");
  add("--view-angle", texts.ViewAngle, "DEGREES", "vertical field of view; default 30");
  options.Exaggeration.Declare(app);
  add("--pixel-tolerance,--tolerance", texts.PixelTolerance, "PIXELS",
    "by how much the techniques pyramid (default 0, exact) and strips (default 1) may be off");
  app.add_flag("--wireframe", options.Wireframe, "draw the technique strips as lines");
  app.add_flag(
    "--depths", options.Depths, "draw the technique strips in colours of its hierarchy's depths");
  const auto levels = [&options]()
  {
    std::cerr << "terrain-render: warning: --levels is now called --depths\n";
    options.Depths = true;
  };
  app.add_flag_callback("--levels", levels, "")->group(""); // not in the help
  app.add_flag("--crossings", options.Crossings,
    "draw how many nodes or samples each ray takes, blue for none to red for 64 and more");
  add("--depth", options.Depth, "FILE",
    "GeoTIFF of float32: distance along the viewing direction, NaN where there is no surface");
  add("--window", options.Target, "NAME", "auto (default), egl, osmesa, x")
    ->transform(CLI::CheckedTransformer(kWindows).description(""));
  add("--frames", texts.Frames, "N", "how often the picture is drawn; default 1");
  add("--stats", options.Stats, "FILE", kHelpOfStats);
  app.add_flag("--describe", options.Describe,
    "print what HEIGHTS is taken for and what was taken from where, and draw nothing");
}

void Declare(CLI::App& app, Options& options, Texts& texts)
{
  DeclareSearch(app, options, texts);
  DeclareView(app, options, texts);
  options.Input.Declare(app);
  options.Colors.Declare(app, true);
  options.ColorBy.Declare(app);
  options.Light.Declare(app, true);
  options.Surface.Declare(app);
  options.Scenery.Declare(app);
  options.Marks.Declare(app);
  options.Track.Declare(app);
  options.Polygon.Declare(app);
  options.Flight.Declare(app);
  app.add_flag("--legend{" + std::string(kUsualLegend) + "}", options.Legend,
    "the colours with numbers, or with names of classes; --legend='Depth in metres' for another "
    "title");
  texts.Place.Declare(app, options.Place);
  texts.Detail.Declare(app, options.Detail);
  app.set_version_flag("--version", TERRAIN_RENDER_VERSION);
}

/// Steps that a search may take: in these, no ray takes longer than a few hundred samples.
constexpr int kMostSteps = 256;
constexpr int kMostEquidistantSteps = 1000000;
constexpr int kMostSecantSteps = 32;

void InterpretSteps(const Texts& texts, Technique technique, SearchOptions& search)
{
  const bool equidistant = technique == Technique::Equidistant;
  if (!texts.Steps.empty())
  {
    search.Steps =
      ParseInteger("--steps", texts.Steps, 1, equidistant ? kMostEquidistantSteps : kMostSteps);
  }
  if (!texts.LongSteps.empty())
  {
    search.LongSteps = ParseInteger("--long-steps", texts.LongSteps, 1, kMostEquidistantSteps);
  }
  if (!texts.SecantSteps.empty())
  {
    search.SecantSteps = ParseInteger("--secant-steps", texts.SecantSteps, 1, kMostSecantSteps);
  }
  if (!texts.StepLength.empty())
  {
    search.StepLength = ParseNumber("--step-length", texts.StepLength, 0.125, 1e6);
  }
  if ((search.LongSteps != 0 || search.StepLength != 0.0) && !equidistant)
  {
    Refuse(search.LongSteps != 0 ? "--long-steps" : "--step-length",
      "is for the technique equidistant only");
  }
  const bool steps =
    equidistant || technique == Technique::Linear || technique == Technique::Exponential;
  if (!search.AreDefault() && !steps)
  {
    Refuse(search.Steps != 0 ? "--steps" : "--secant-steps",
      "is for the techniques linear, exponential and equidistant only");
  }
}

void InterpretNumbers(const Texts& texts, Options& options)
{
  if (!texts.Size.empty())
  {
    options.Size = ParseSize(texts.Size);
  }
  if (!texts.Piece.empty())
  {
    options.Piece = ParseInteger("--piece", texts.Piece, 256, kLargestPiece);
  }
  if (!texts.Dots.empty())
  {
    options.Dots = ParseNumber("--dpi", texts.Dots, 10.0, 10000.0);
  }
  if (!texts.MeshCells.empty())
  {
    options.MeshCells = ParseInteger("--mesh-cells", texts.MeshCells, 1, 65536);
  }
  if (!texts.Camera.empty())
  {
    options.View = ParseCamera(texts.Camera);
  }
  if (!texts.ViewAngle.empty())
  {
    options.ViewAngle = ParseNumber("--view-angle", texts.ViewAngle, 0.01, 170.0);
  }
  if (!texts.Frames.empty())
  {
    options.Frames = ParseInteger("--frames", texts.Frames, 1, 1000000);
  }
  InterpretSteps(texts, options.Search, options.Steps);
  if (!texts.LargestTexture.empty())
  {
    options.LargestTexture =
      ParseInteger("--largest-texture", texts.LargestTexture, 256, kLargestTexture);
  }
  if (!texts.Memory.empty())
  {
    options.Memory = ParseInteger("--memory", texts.Memory, 1, kMostMemory);
  }
}

void Interpret(const Texts& texts, Options& options)
{
  InterpretNumbers(texts, options);
  if (!options.Input.CoordinateSystem.empty())
  {
    CheckCoordinateSystem(options.Input.CoordinateSystem);
  }
  if (options.Flight.IsWanted() && options.Light.GetSuns().size() > 1)
  {
    Refuse("--flight", "goes by one sun: name one time by --sun");
  }
  if (options.Flight.IsWanted() && !options.Depth.empty())
  {
    Refuse("--depth", "is of one picture, and a flight has many");
  }
  if (options.Describe && options.Heights.empty())
  {
    Refuse("--describe", "needs a file of heights");
  }
  if (options.Marks.ContourLabels && options.Surface.Contours <= 0.0)
  {
    Refuse("--contour-labels", "stand on contour lines: give --contours INTERVAL, too");
  }
  texts.Place.Interpret(options.Place);
  options.Place.HasTimeOfSun = options.Light.NeedsPlace();
  options.Place.HasLabels = !options.Marks.Labels.empty();
  options.Place.HasPolygons = !options.Polygon.Files.empty();
  texts.Detail.Interpret(options.Detail);
  if (options.View && !options.Place.LookFrom.empty())
  {
    Refuse("--look-from", "--camera says where the eye is already");
  }
  if (!texts.PixelTolerance.empty())
  {
    options.PixelTolerance = ParseNumber("--pixel-tolerance", texts.PixelTolerance, 0.0, 1e3);
  }
}

/// Texts that are drawn must be what the fonts are asked in.
void CheckTexts(const Options& options)
{
  for (const auto& [option, text] : { std::pair("--title", options.Marks.Title),
         std::pair("--caption", options.Marks.Caption), std::pair("--legend", options.Legend) })
  {
    if (CPLIsUTF8(text.c_str(), -1) == 0)
    {
      Refuse(option, "is not UTF-8: write it, or the scene it is in, in that encoding");
    }
  }
}

/// Options that some techniques know nothing of.
void CheckTechnique(const Options& options)
{
  const bool rays = options.Search != Technique::Mesh && options.Search != Technique::Strips;
  if (options.Crossings && !rays)
  {
    Refuse("--crossings", std::string(NameOf(options.Search)) + " casts no rays");
  }
  const bool strips = options.Search == Technique::Strips;
  if (options.PixelTolerance && !strips && options.Search != Technique::Pyramid)
  {
    Refuse("--pixel-tolerance", "is for the techniques pyramid and strips only");
  }
  if (strips && options.PixelTolerance && *options.PixelTolerance == 0.0)
  {
    Refuse("--pixel-tolerance", "must not be 0 for the technique strips");
  }
  if (strips && std::max(options.Size[0], options.Size[1]) > options.Piece)
  {
    Refuse("--size",
      "the technique strips refines for one window: draw at most " + std::to_string(options.Piece) +
        " pixels a side (--piece), or by the technique pyramid");
  }
  if (options.Surface.Block > 0.0 && options.Search != Technique::Pyramid)
  {
    Refuse("--block", "is for the technique pyramid only");
  }
  options.Surface.CheckLight(options.Light);
  options.Surface.CheckStrata();
  options.Track.Check(!options.Place.Tracks.empty());
  options.Polygon.Check();
  if (options.Wireframe && !strips)
  {
    Refuse("--wireframe", "is for the technique strips only");
  }
  if (options.Depths && !strips)
  {
    Refuse("--depths", "is for the technique strips only");
  }
  if ((options.Wireframe || options.Depths || options.Crossings) && options.ColorBy.IsGiven())
  {
    Refuse("--color-by", "does not go with --wireframe, --depths and --crossings");
  }
  if ((options.Wireframe || options.Depths) && !options.Place.Drape.empty())
  {
    Refuse("--drape", "does not go with --wireframe and --depths");
  }
}

/// Absolute, links followed as far as there is something; empty for no name.
std::string CanonicalPath(const std::string& name)
{
  std::error_code error;
  return name.empty()
    ? name
    : std::filesystem::weakly_canonical(std::filesystem::absolute(name), error).string();
}

/// All files that the options have read.
std::vector<std::string> InputFiles(const Options& options)
{
  std::vector<std::string> inputs = { options.Heights, options.Input.CoordinateSystem,
    options.Colors.GetFileName(), options.ColorBy.IsFile() ? options.ColorBy.By : std::string(),
    options.Track.GetFileName(), options.Polygon.GetFileName(), options.Place.Drape,
    options.Place.GetGeoidFile(), options.Detail.File, options.Scene, options.Marks.Labels,
    options.Flight.IsFile() ? options.Flight.Flight : std::string() };
  for (const auto* files : { &options.Place.Tracks, &options.Place.Finer, &options.Polygon.Files })
  {
    inputs.insert(inputs.end(), files->begin(), files->end());
  }
  return inputs;
}

/// True if a file lies in a folder, or a folder of that one.
bool LiesIn(const std::string& file, const std::string& folder)
{
  const std::filesystem::path inner(CanonicalPath(file));
  std::filesystem::path outer(CanonicalPath(folder));
  outer = outer.has_filename() ? outer : outer.parent_path();
  const auto [a, b] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  return a == outer.end() && b != inner.end();
}

/// The folder of a flight holds the flight alone.
void CheckFolder(const Options& options)
{
  const std::string folder = FramesFolder(options.Output);
  for (const auto& [option, file] : { std::pair("--stats", options.Stats),
         std::pair("--save-scene", options.SaveScene), std::pair("--depth", options.Depth) })
  {
    if (options.Flight.IsWanted() && !file.empty() && LiesIn(file, folder))
    {
      std::string why = "'";
      why.append(file).append("' lies in '").append(folder);
      Refuse(option, why.append("', which is for the frames alone: name a file beside it"));
    }
  }
}

/// No output may be a file that an input is read from, which would be lost, or another output.
void CheckFiles(const Options& options)
{
  if (options.Output.empty())
  {
    Refuse("--output", "needs the name of a file");
  }
  const std::vector<std::string> inputs = InputFiles(options);
  const vtkNew<vtkTerrainOutputFile> files;
  std::vector<std::string> paths;
  for (const std::string& input : inputs)
  {
    files->AddInput(input);
    paths.push_back(CanonicalPath(input));
  }
  std::vector<std::pair<const char*, std::string>> outputs = { { "--output", options.Output },
    { "--depth", options.Depth }, { "--stats", options.Stats },
    { "--save-scene", options.SaveScene } };
  const std::size_t pictures = options.Light.GetSuns().size();
  for (std::size_t k = 1; pictures > 1 && k <= pictures; ++k)
  {
    outputs.emplace_back("--output", PictureName(options.Output, k, pictures));
  }
  CheckFolder(options);
  for (const auto& [option, output] : outputs)
  {
    const std::string input = files->FindInput(output);
    if (!input.empty())
    {
      std::string why = "'";
      why.append(output).append("' is a file that the input '").append(input);
      Refuse(option, why.append("' is read from"));
    }
    const std::string path = CanonicalPath(output);
    if (!path.empty() && std::find(paths.begin(), paths.end(), path) != paths.end())
    {
      Refuse(option, "'" + output + "' is another file of the command line already");
    }
    paths.push_back(path);
  }
  const std::string why = options.Flight.IsWanted() ? std::string() : WhyNotPicture(options.Output);
  if (!why.empty())
  {
    Refuse("--output", why);
  }
  const bool isOpaque = options.Flight.IsWanted() ? IsFilm(options.Output) : IsJPEG(options.Output);
  if (options.Scenery.IsTransparent() && isOpaque)
  {
    Refuse("--background",
      "transparent needs pictures with alpha, which '" + options.Output +
        "' has not: name a .png, or for a flight a folder of frames");
  }
}
}

//------------------------------------------------------------------------------
std::string HeightsName(const Options& options)
{
  return options.Heights.empty() ? "built-in landscape" : options.Heights;
}

//------------------------------------------------------------------------------
const char* NameOf(Technique technique)
{
  for (const auto& [name, value] : kTechniques)
  {
    if (value == technique)
    {
      return name.c_str();
    }
  }
  return "";
}

//------------------------------------------------------------------------------
std::optional<int> ParseCommandLine(int argc, const char* const* argv, Options& options)
{
  CLI::App app("Draws a file of heights as terrain.", "terrain-render");
  Texts texts;
  SceneFile scene;
  try
  {
    Declare(app, options, texts);
    scene.Declare(app, NamesOfRenderScenes());
    RefuseEmptyValues(argc, argv);
    app.parse(argc, argv);
    RefuseNoValue(app, { "--title", "--caption" });
    RefuseNotANumber(app);
    options.Scene = scene.GetInput();
    options.SaveScene = scene.GetOutput();
    options.SceneText = options.SaveScene.empty() ? "" : scene.ToText(options.SaveScene);
    Interpret(texts, options);
    if (options.Flight.IsWanted() && app.get_option("--output")->empty())
    {
      options.Output = "terrain-flight";
    }
    options.Flight.Check(options.Output);
    options.Flight.Scene = scene.ToText(
      FramesFolder(options.Output) + "/scene.toml", { "output", "stats", "save-scene", "frames" });
    CheckTexts(options);
    CheckFiles(options);
    CheckTechnique(options);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      return app.exit(error);
    }
    std::cerr << "terrain-render: " << scene.Explain(error.what()) << '\n';
    return kWrongCommandLine;
  }
  return std::nullopt;
}
