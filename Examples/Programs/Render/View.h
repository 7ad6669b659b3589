// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Window, camera, light and sky.
 */
#ifndef terrain_render_View_h
#define terrain_render_View_h

#include "vtkSmartPointer.h"

#include <string>

class vtkBoundingBox;
class vtkCamera;
class vtkRenderWindow;
class vtkRenderer;
struct Options;
struct PlacedHeights;
struct Terrain;

/// An off-screen window of the kind and size that the options ask for, not opened yet.
vtkSmartPointer<vtkRenderWindow> MakeWindow(const Options& options);

/// A renderer of the terrain under a light from the north-west or the sun of the options, before a
/// sky. The camera is that of the options, else looks from the south with all of the terrain in
/// view; nothing beyond 1e-4 of the terrain's diagonal from the eye is lost to the near plane.
/// Throws a Failure.
vtkSmartPointer<vtkRenderer> MakeRenderer(
  const Terrain& terrain, const PlacedHeights& heights, const Options& options);

/// Moves the sun of such a renderer to one of LightOptions::GetSuns(). Throws a Failure.
void SetSun(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options,
  const std::string& sun);

/// Moves the camera that nobody has placed so that the terrain lies beside what takes so many
/// pixels at the right border, and below the title. Nothing on a globe.
void LeaveRoom(vtkRenderer* renderer, const Terrain& terrain, const PlacedHeights& heights,
  const Options& options, double right);

#endif
