// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options of terrain-render about texts in the picture.
 */
#ifndef terrain_render_MarkOptions_h
#define terrain_render_MarkOptions_h

#include <string>

namespace CLI
{
class App;
}

struct MarkOptions
{
  /// File of points with names; empty for none.
  std::string Labels;
  /// Most summits that are labelled, the most prominent first.
  int Peaks = 0;
  /// Numbers on the index contours.
  bool ContourLabels = false;
  /// "box" or "edge"; empty for none.
  std::string Outline;
  bool HeightScale = false;
  bool Inset = false;
  std::string Title;
  std::string Caption;

  void Declare(CLI::App& app);
};

#endif
