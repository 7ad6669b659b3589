// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options by which a person says what a file of heights does not, or says wrongly: the same
 * words in every program.
 */
#ifndef terrain_common_HeightOptions_h
#define terrain_common_HeightOptions_h

#include <string>

class vtkTerrainRasterReader;

namespace CLI
{
class App;
}

struct HeightOptions
{
  /// CRS in place of the file's, or the name of a file that has one; empty for its own.
  std::string CoordinateSystem;
  /// Number of a band, from 1 on; 0: chosen by the reader.
  int Band = 0;
  /// Part of a file of several; empty: chosen by the reader.
  std::string Part;
  /// A number, "none" for no search of undeclared values, or empty.
  std::string NoData;
  /// Unit, or metres per unit; empty for the file's.
  std::string HeightUnit;
  bool Flip = false;

  /// The option HEIGHTS must not be empty, as a variable that is not set makes it. Returns why not.
  static std::string WhyNotFile(const std::string& name);

  /// Adds the options to a command line, which fills this object and refuses what is no value.
  void Declare(CLI::App& app);
  void Apply(vtkTerrainRasterReader* reader) const;

  /// For programs that make one thing of one raster: empty, or why a folder of several sites that
  /// the reader has looked at is none.
  static std::string WhyNotOneSite(vtkTerrainRasterReader* reader);
};

#endif
