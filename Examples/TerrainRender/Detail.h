// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detail that is repeated all over the heights.
 */
#ifndef terrain_render_Detail_h
#define terrain_render_Detail_h

#include <optional>
#include <string>

namespace CLI
{
class App;
}
class Statistics;
class vtkImageData;
class vtkOpenGLTerrainMapper;

/// What the command line asks for.
struct DetailOptions
{
  /// File of one period of heights, or `builtin`; empty for none.
  std::string File;
  /// Detail cells along a cell of the heights, a power of two.
  int Cells = 16;
  /// Highest minus lowest height of the detail. None: those of the file; half a cell's width for
  /// the built-in one.
  std::optional<double> Height;
};

/// The texts of the options, until Interpret() has read them.
class DetailArguments
{
public:
  void Declare(CLI::App& app, DetailOptions& options);
  void Interpret(DetailOptions& options) const;

private:
  std::string Cells;
  std::string Height;
};

/// Gives the mapper of the heights their detail, if any is asked for. Throws a Failure.
void AddDetail(vtkOpenGLTerrainMapper* mapper, vtkImageData* heights, const DetailOptions& options,
  Statistics& statistics);

#endif
