// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colours of values as people name them or have them in files, without VTK.
 */
#ifndef terrain_ColorScheme_h
#define terrain_ColorScheme_h

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace terrain
{
/// Red, green, blue from 0 to 1.
using Color = glm::dvec3;

struct ColorStop
{
  double Value = 0.0;
  Color Shade{ 0.0, 0.0, 0.0 };
};

/**
 * Colours along an axis of values, ascending. Between two stops colours are mixed in RGB. Two stops
 * of one value are a step: below it lies the colour of the first; at the value and above that of
 * the second, as in matplotlib and GMT.
 */
struct ColorScheme
{
  std::vector<ColorStop> Stops;
  /// What the values are: those of the data; or shares of their range, 0 to 1.
  enum class Axis
  {
    Values,
    Shares
  };
  Axis Along = Axis::Shares;
  /// Stops below sea level as shares, 0 at the deepest and 1 at the shore; empty if the scheme has
  /// no colours for the sea.
  std::vector<ColorStop> SeaStops;
  /// Colours of values below and above the stops, where the file has them; else the first and last.
  std::optional<Color> Below;
  std::optional<Color> Above;
  /// Colour of no data, where the file has one.
  std::optional<Color> None;
  /// Names of classes, for legends, in the order of the file: the value at which a class begins
  /// (minus infinity if it has no beginning), or is.
  struct ClassName
  {
    double Value;
    std::string Name;
  };
  std::vector<ClassName> Classes;
};

/// Names of the schemes that are built in, the default first.
std::vector<std::string> ColorSchemeNames();

/// A built-in scheme by its name; none if there is no such name.
///
/// Sources of figures: viridis, cividis and inferno are 17 colours each of matplotlib's tables (S.
/// van der Walt, N. Smith; J. Nunez and others), twilight 33 (B. Winterberg); batlow, lapaz, davos,
/// oslo, and oleron and bukavu with their seas, are those of F. Crameri's "Scientific colour maps"
/// 8 (2023). Mixing between them is off by less than 3/255 of the originals (cividis: 8/255).
std::optional<ColorScheme> FindColorScheme(const std::string& name);

/// The other way round: the first colour last. Steps stay where they are in the mirrored axis.
ColorScheme Reversed(const ColorScheme& scheme);

/// How a scheme is laid over data.
struct ColorRange
{
  double Lowest = 0.0;
  double Highest = 1.0;
  /// Whether heights below 0 are a sea.
  bool HasSea = false;
};

/// The scheme with values of the data: shares are laid over the range, a sea from the lowest to 0
/// and the rest from 0, or from the lowest where that lies above, to the highest. A scheme that has
/// values already is returned as it is. An empty range has the colour of plains.
ColorScheme LaidOver(const ColorScheme& scheme, const ColorRange& range);

/// The scheme stretched so that its first stop lies at the lowest value and its last at the
/// highest.
ColorScheme Stretched(const ColorScheme& scheme, double lowest, double highest);

/// True if no two colours are mixed anywhere: all of them are steps.
bool IsDiscrete(const ColorScheme& scheme);

/// Number of the class that each of some values belongs to, -1 for those of no class and for NaN:
/// of the classes next below and above a value the one whose colour the value has.
std::vector<int> ClassesOf(const ColorScheme& scheme, const std::vector<double>& values);

/// The colour of a value; see ColorScheme. NaN: None, or else black. A scheme without stops is
/// black.
Color ColorOf(const ColorScheme& scheme, double value);
}

#endif
