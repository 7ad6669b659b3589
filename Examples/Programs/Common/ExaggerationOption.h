// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How many times as high as true a terrain is drawn: the same words in every program.
 */
#ifndef terrain_common_ExaggerationOption_h
#define terrain_common_ExaggerationOption_h

#include <string>

class vtkImageData;
namespace CLI
{
class App;
}

struct ExaggerationOption
{
  /// A factor from 0.001 to 1000, or "auto".
  std::string Text = "1";

  /// Adds the option to a command line, which fills this object and refuses what is no value.
  void Declare(CLI::App& app);

  bool IsAuto() const;

  /// The factor for heights in metres, before they are brought into a scene. One that is chosen
  /// here is told on stderr. Throws a Failure where it is to be chosen and there are no samples.
  double Choose(vtkImageData* heights, bool isGlobe) const;

  /// Tells on stderr if a view of all the heights shows a sheet or towers with a factor that was
  /// given.
  void TellIfOdd(vtkImageData* heights, double factor) const;
};

/// A factor as people write it: "1.5", "20".
std::string FactorText(double factor);

#endif
