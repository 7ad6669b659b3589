// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The command line of terrain-render.
 */
#ifndef terrain_render_Options_h
#define terrain_render_Options_h

#include "ColorByOptions.h"
#include "ColorOptions.h"
#include "Detail.h"
#include "ExaggerationOption.h"
#include "FlightOptions.h"
#include "HeightOptions.h"
#include "LightOptions.h"
#include "MarkOptions.h"
#include "PlaceOptions.h"
#include "PolygonOptions.h"
#include "SceneryOptions.h"
#include "SurfaceOptions.h"
#include "TrackOptions.h"

#include "vtkOpenGLTerrainMapper.h"

#include <array>
#include <optional>
#include <string>

/// How the surface is found; the names of the option are those of the techniques.
using Technique = vtkOpenGLTerrainMapper::Techniques;

/// Which window is drawn into; Automatic leaves the choice to VTK.
enum class Window
{
  Automatic,
  EGL,
  OSMesa,
  X
};

/// Where the camera stands, in world coordinates, z exaggerated.
struct Camera
{
  std::array<double, 3> Eye{};
  std::array<double, 3> FocalPoint{};
  std::array<double, 3> Up{ 0.0, 0.0, 1.0 };
};

/// The parameters of a search (vtkOpenGLTerrainMapper::SetSteps()); 0: chosen by the mapper.
struct SearchOptions
{
  int Steps = 0;
  int LongSteps = 0;
  int SecantSteps = 0;
  /// In cells.
  double StepLength = 0.0;

  /// True if none is given.
  bool AreDefault() const
  {
    return this->Steps == 0 && this->LongSteps == 0 && this->SecantSteps == 0 &&
      this->StepLength == 0.0;
  }
};

/// What the command line asks for, with the defaults of the options that were left out.
struct Options
{
  /// File of heights; empty for the built-in landscape.
  std::string Heights;
  /// Memory that a raster larger than a texture may take, in MiB, 1 to kMostMemory, and whether its
  /// levels are kept for the next time.
  int Memory = 1024;
  bool NoCache = false;
  /// Samples a side above which a raster is drawn from tiles, 256 to kLargestTexture.
  int LargestTexture = 16384;
  std::string Output = "terrain.png";
  /// Width and height of the picture, in pixels, 1 to kMaximumSize.
  std::array<int, 2> Size{ 1280, 720 };
  /// Largest side of what is drawn at once, in pixels, 256 to kLargestPiece.
  int Piece = 4096;
  /// Dots per inch; 0: the file tells none.
  double Dots = 0.0;
  Technique Search = Technique::Pyramid;
  /// Cells along the side of a quad of the technique mesh, >= 1; 0: 1.
  int MeshCells = 0;
  SearchOptions Steps;
  std::optional<Camera> View;
  /// Vertical field of view, in degrees.
  double ViewAngle = 30.0;
  ExaggerationOption Exaggeration;
  /// Pixels by which the technique pyramid (else 0: exact) or strips (else 1) may be off.
  std::optional<double> PixelTolerance;
  /// True to draw the edges of the technique strips, or the depths of its hierarchy in colours.
  bool Wireframe = false;
  bool Depths = false;
  /// True to draw the work of each ray in false colours.
  bool Crossings = false;
  /// File of depths; empty for none.
  std::string Depth;
  Window Target = Window::Automatic;
  int Frames = 1;
  /// File of statistics; empty for none.
  std::string Stats;
  /// What the file of heights does not say.
  HeightOptions Input;
  ColorOptions Colors;
  ColorByOptions ColorBy;
  LightOptions Light;
  SurfaceOptions Surface;
  /// Title of the legend of colours; empty for none.
  std::string Legend;
  /// Scene that options came from, and one to write, with its text; empty for none.
  std::string Scene;
  std::string SaveScene;
  std::string SceneText;
  /// True to tell what the heights are, and to draw nothing.
  bool Describe = false;
  PlaceOptions Place;
  TrackOptions Track;
  PolygonOptions Polygon;
  FlightOptions Flight;
  MarkOptions Marks;
  SceneryOptions Scenery;
  DetailOptions Detail;
};

/// Largest width and height of a picture, in pixels.
constexpr int kMaximumSize = 32768;
/// Side of a window that every graphics driver has, in pixels.
constexpr int kLargestPiece = 16384;
/// Samples a side that every graphics driver takes in a texture.
constexpr int kLargestTexture = 16384;
/// Largest budget of memory, in MiB: 1 TiB.
constexpr int kMostMemory = 1 << 20;

/// Title of a legend of heights.
constexpr const char* kUsualLegend = "Height in metres";

/// What messages about the heights begin with.
std::string HeightsName(const Options& options);

/// Name of a technique, as on the command line.
const char* NameOf(Technique technique);

/// Reads the command line. Empty if the program is to go on; else the exit status it ends with at
/// once: 0 after --help and --version, 2 after one sentence on stderr about what is wrong.
std::optional<int> ParseCommandLine(int argc, const char* const* argv, Options& options);

#endif
