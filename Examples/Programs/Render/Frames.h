// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Drawing frames, and how long they take.
 */
#ifndef terrain_render_Frames_h
#define terrain_render_Frames_h

#include "vtkSmartPointer.h"

class Statistics;
class vtkImageData;
class vtkProp;
class vtkRenderWindow;
class vtkRenderer;

/**
 * Draws frames, at least one, and waits for each. Times: "first_frame", which has everything in it
 * that happens once, from the window's opening to the upload of the heights; "frame_cpu", a frame
 * from its call until it is complete, and "frame_gpu", the time between two queries on the
 * graphics card around it, both without the first frame if there are more. Software renderers
 * answer such queries for a part of their work only: there "frame_cpu" counts. Throws a Failure.
 */
void DrawFrames(vtkRenderWindow* window, vtkRenderer* renderer, int frames, Statistics& statistics);

/// Tells which window and which driver drew.
void TellWindow(vtkRenderWindow* window, Statistics& statistics);

/// Distances along the viewing direction of the terrain alone, with the walls of its block if there
/// are any: float scalars, the lowest row first, NaN where there is no surface. What the window
/// shows is lost. Throws a Failure.
vtkSmartPointer<vtkImageData> DrawDepths(
  vtkRenderWindow* window, vtkRenderer* renderer, vtkProp* terrain, vtkProp* walls = nullptr);

#endif
