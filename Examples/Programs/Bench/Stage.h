// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is drawn, from where, and how long that takes.
 */
#ifndef terrain_bench_Stage_h
#define terrain_bench_Stage_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkActor;
class vtkCamera;
class vtkImageData;
class vtkProp;
class vtkRenderWindow;
class vtkRenderer;

/// The built-in landscape, 123 km a side whatever its samples: heights of 16 bits, in metres.
vtkSmartPointer<vtkImageData> MakeLandscape(int samples);

/// Eye and focal point, in world coordinates.
struct View
{
  std::string Name;
  std::array<double, 3> Eye;
  std::array<double, 3> Focus;
};

/// Four fundamentally different views: oblique, fly, walk, down.
std::vector<View> FixedViews(vtkImageData* heights);

/// A flight over the landscape, 0 <= part <= 1, 3500 m high, and a walk, 2 m above the ground.
View OnFlight(vtkImageData* heights, double part);
View OnWalk(vtkImageData* heights, double part);

/// A way over the landscape.
using Way = View (*)(vtkImageData*, double);

/// Moves a camera to a view.
void Look(vtkCamera* camera, const View& view);

/// Of a list of times.
struct Times
{
  double Median = 0.0;
  double Shortest = 0.0;
  double Longest = 0.0;
};
Times Summarize(std::vector<double> milliseconds);

/// Time from one moment on, in milliseconds by the clock.
class Stopwatch
{
public:
  Stopwatch();
  double Milliseconds() const;

private:
  double Begin;
};

/// An off-screen window that shows one prop at a time.
class Stage
{
public:
  Stage(int width, int height);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Shows a prop instead of the last, whose graphics resources are given back.
  void Show(vtkProp* prop);
  void Look(const View& view);
  /// Draws a frame; the first of a prop after some that do not count. Milliseconds: of the graphics
  /// card's timer; of the processor time of all threads where software renders.
  double Draw();
  /// Some frames from one place.
  Times Draw(int frames);
  /// Distances of what is shown, NaN for none.
  vtkSmartPointer<vtkImageData> Depths();
  /// The driver's own name; empty before the first frame.
  std::string RendererName() const;
  bool IsSoftware() const;
  vtkRenderer* GetRenderer();
  int GetPixels() const;

private:
  void WarmUp();

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkProp> Shown;
  bool Software = true;
  bool IsCold = true;
};

/// Pixels of a picture of depths against the exact one.
struct Agreement
{
  double MissedPercent = 0.0; ///< of the surface's pixels: there is none, or there is one in vain
  double WrongPercent = 0.0;  ///< of those: more than a thousandth of their distance off
};
Agreement Compare(vtkImageData* found, vtkImageData* exact);

/// Draws heights by a technique: "coarse N" (a coarse mesh of N x N quads, no search), "full mesh",
/// "linear", "exponential", "equidistant", "equidistant, paper's N" (with the paper's steps for a
/// mesh of N x N quads, 32 or 256), "pyramid", "columns".
vtkSmartPointer<vtkActor> MakeActor(const std::string& technique, vtkImageData* heights);

#endif
