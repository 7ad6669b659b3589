// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Texts in a picture that do not cover one another.
 */
#ifndef terrain_render_LabelPlacer_h
#define terrain_render_LabelPlacer_h

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkCamera;
class vtkRenderer;
class vtkTextActor;
struct Options;

/// A rectangle in pixels of the picture.
struct PixelBox
{
  double Left = 0.0;
  double Right = 0.0;
  double Low = 0.0;
  double High = 0.0;

  bool Meets(const PixelBox& other, double margin) const
  {
    return this->Left < other.Right + margin && other.Left < this->Right + margin &&
      this->Low < other.High + margin && other.Low < this->High + margin;
  }
};

/// How a text looks: its height in shares of that of a usual picture.
struct TextStyle
{
  double Size = 0.024;
  bool IsBold = false;
  /// Opacity of the white box behind it; without one it is light on a dark upper border.
  double Backing = 0.7;
  /// Degrees, counterclockwise.
  double Turn = 0.0;
};

/**
 * Keeps the rectangles that are taken in a picture. Pixels are those of the whole picture, whatever
 * pieces it is drawn in.
 */
class LabelPlacer
{
public:
  LabelPlacer(vtkRenderer* renderer, const Options& options);

  /// Takes the places of all texts and shapes that the renderer has in pixels.
  void ReserveProps();

  /// Where a point of the scene is in the picture; empty behind the eye and outside the picture.
  std::optional<std::array<double, 2>> ToPixels(const double point[3]) const;

  /// Width and height of a text, in pixels.
  std::array<double, 2> SizeOf(const std::string& text, const TextStyle& style) const;

  /// Adds a text whose middle, or the middle of whose lower border, lies at a pixel, if all of it
  /// is in the picture and covers nothing. Returns its rectangle.
  std::optional<PixelBox> PlaceCentred(
    const std::string& text, double x, double y, const TextStyle& style);
  /// Adds a text above a pixel, as low as there is room for it, and a line down to the pixel.
  /// Nothing if a pixel nearer than the height of the text has a label.
  std::optional<PixelBox> PlaceAbove(
    const std::string& text, double x, double y, const TextStyle& style);

private:
  std::optional<PixelBox> Place(
    const std::string& text, double x, double low, const TextStyle& style);
  vtkSmartPointer<vtkTextActor> MakeText(const std::string& text, const TextStyle& style) const;

  vtkSmartPointer<vtkRenderer> Renderer;
  const Options& Wanted;
  std::vector<PixelBox> Taken;
  /// Pixels that have a label above them.
  std::vector<std::array<double, 2>> Anchors;
};

/// True for points in front of the eye; the projection would mirror the others into the picture.
bool IsInFront(vtkCamera* camera, const double point[3]);

#endif
