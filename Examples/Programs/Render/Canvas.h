// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A picture of any size, drawn in pieces where it is larger than a window can be.
 */
#ifndef terrain_render_Canvas_h
#define terrain_render_Canvas_h

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <vector>

class Statistics;
class vtkImageData;
class vtkProp;
class vtkRenderWindow;
class vtkRenderer;
struct Options;

/**
 * Draws what a renderer shows as a picture of the size that the options ask for. A picture larger
 * than Options::Piece a side is drawn piece by piece into a window of that size: the camera looks
 * at a part of the same image plane (vtkCamera::SetWindowCenter), from the same place and in the
 * same direction, so that lights and shadows are those of the whole; what lies in pixels is moved.
 * Pieces overlap by more than half the width of any line, and only their middles are kept.
 */
class Canvas
{
public:
  Canvas(vtkRenderWindow* window, vtkRenderer* renderer, const Options& options);

  bool IsTiled() const
  {
    return this->Places.size() > 1;
  }

  /// Draws as many frames as the options ask for, tells their times as DrawFrames() does, and
  /// returns the last: bytes, three components, or four with alpha. Throws a Failure.
  vtkSmartPointer<vtkImageData> DrawFrames(Statistics& statistics);

  /// Draws once.
  vtkSmartPointer<vtkImageData> Draw();

  /// Distances of a prop and its walls, as DrawDepths() of Frames.h.
  vtkSmartPointer<vtkImageData> DrawDepths(vtkProp* terrain, vtkProp* walls = nullptr);

private:
  /// First column and row of a piece in the picture, its margin included; row 0 is the lowest.
  using Place = std::array<int, 2>;

  /// Calls a function after the view was set to each piece, and puts together what it returns.
  vtkSmartPointer<vtkImageData> PutTogether(
    const std::function<vtkSmartPointer<vtkImageData>()>& draw);
  void CopyMiddle(vtkImageData* piece, const Place& place, vtkImageData* all) const;

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  const Options& Wanted;
  std::array<int, 2> Piece;
  int Margin = 0;
  std::vector<Place> Places;
};

/// Width and height of the window that the pieces of a picture are drawn into.
std::array<int, 2> PieceSize(const Options& options);

#endif
