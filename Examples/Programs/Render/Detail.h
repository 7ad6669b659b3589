// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detail that is repeated all over the heights.
 */
#ifndef terrain_render_Detail_h
#define terrain_render_Detail_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>

namespace CLI
{
class App;
}
class Statistics;

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

/// Detail as the mapper and the strips take it; nothing if none is asked for.
struct PreparedDetail
{
  vtkSmartPointer<vtkImageData> Image;
  int Cells = 1;
  double Scale = 0.0;

  /// Lowest and highest of the scaled heights.
  std::array<double, 2> Range() const;

  /// Gives it to a vtkOpenGLTerrainMapper or vtkTerrainStrips.
  template <typename Target>
  void AddTo(Target* target) const
  {
    if (this->Image)
    {
      target->SetDetailData(this->Image);
      target->SetDetailCells(this->Cells);
      target->SetDetailScale(this->Scale);
    }
  }
};

/// Reads or makes the detail for some heights. Throws a Failure.
PreparedDetail PrepareDetail(
  vtkImageData* heights, const DetailOptions& options, Statistics& statistics);

#endif
