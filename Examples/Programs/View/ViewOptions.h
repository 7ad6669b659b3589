// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From where the window shows the terrain at first: the words of terrain-render.
 */
#ifndef terrain_view_ViewOptions_h
#define terrain_view_ViewOptions_h

#include <array>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

struct ViewOptions
{
  /// "EX,EY,EZ,FX,FY,FZ[,UX,UY,UZ]" in world coordinates; empty for none.
  std::string Camera;
  /// Places of the eye and of what it looks at, both or none.
  std::string LookFrom;
  std::string LookAt;
  /// Vertical, in degrees.
  double Angle = 30.0;
  /// How the surface is found, by its name on the command line.
  std::string Technique = "pyramid";

  void Declare(CLI::App& app);
  /// Throws a CLI::ValidationError if options do not go together.
  void Check() const;
  /// Numbers of Camera; none if they are not 6 or 9.
  std::vector<double> GetCamera() const;
};

/// A place as people write it: degrees with the longitude first, MGRS, UTM, each with ",HEIGHT" or
/// ",HEIGHTagl" behind it or not. Without a height it is on the ground: 0 above it.
struct PlaceText
{
  std::array<double, 2> Place{};
  double Height = 0.0;
  bool IsAboveGround = true;
};

/// Reads what vtkTerrainViewpoint::GetWhyNoPlace() finds nothing wrong with.
PlaceText ReadPlace(const std::string& text);

#endif
