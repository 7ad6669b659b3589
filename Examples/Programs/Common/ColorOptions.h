// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options by which a person chooses the colours of heights: the same words in every program.
 */
#ifndef terrain_common_ColorOptions_h
#define terrain_common_ColorOptions_h

#include <vtkSmartPointer.h>

#include <string>

class vtkScalarsToColors;
class vtkTerrainColors;
namespace CLI
{
class App;
}

struct ColorOptions
{
  /// A scheme or a file (vtkTerrainColors); empty for the program's own colours.
  std::string Colors;
  /// "LOWEST,HIGHEST": heights of the first and last colour, in metres; "each": all values of each
  /// terrain; empty for those of all terrains.
  std::string Range;
  bool Reverse = false;
  /// Whether heights below 0 are a sea: "auto", "always" or "never".
  std::string BelowSea = "auto";

  /// Adds the options to a command line, which fills this object and refuses what is no value.
  /// hasEach: a range may be that of each terrain.
  void Declare(CLI::App& app, bool hasEach);

  /// True if each terrain has a range of its own.
  bool AreOfEach() const
  {
    return this->Range == "each";
  }

  /// The file that Colors names; empty for a scheme, or none.
  std::string GetFileName() const;

  /// True if anything is asked for.
  bool IsGiven() const;

  /// The colours that are asked for; without any those of a scheme, else vtkTerrainColors' own.
  vtkSmartPointer<vtkTerrainColors> MakeColors(const std::string& usual = {}) const;

  /// The table for heights from lowest to highest, in metres.
  vtkSmartPointer<vtkScalarsToColors> MakeTable(double lowest, double highest) const;
};

#endif
