// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * terrain-prepare --mesh: a raster of heights as triangles.
 */
#ifndef MeshOptions_h
#define MeshOptions_h

#include "MeshFile.h"

#include <string>

struct HeightOptions;
namespace CLI
{
class App;
}

/// What --mesh and its companions say.
struct MeshOptions
{
  std::string Path;
  /// Largest vertical distance of a sample to the mesh, in metres, not exaggerated.
  double Error = 1.0;
  double Exaggeration = 1.0;
  /// Closes the mesh to a block, whose floor lies so many metres below the lowest height; 0: open.
  double Block = 0.0;
  /// Longer side of a print in millimetres; 0: the mesh keeps its size.
  double PrintWidth = 0.0;
  /// Thickness of a print below its lowest height, in millimetres.
  double PrintBase = 2.0;
  MeshLook Look;
};

/// Adds the options to the program's.
void AddMeshOptions(CLI::App& app, MeshOptions& options);

/// Writes the mesh. Throws std::runtime_error with one sentence.
void PrepareMesh(
  const std::string& heights, const MeshOptions& options, const HeightOptions& input, bool quiet);

#endif
