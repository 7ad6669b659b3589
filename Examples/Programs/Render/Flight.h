// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A flight: frames in a folder, and a film of them.
 */
#ifndef terrain_render_Flight_h
#define terrain_render_Flight_h

class Canvas;
class Statistics;
class ViewMarks;
class vtkRenderer;
struct Options;
struct PlacedHeights;
struct Terrain;

/// What draws.
struct FlightStage
{
  vtkRenderer* Renderer;
  Canvas& Frame;
  ViewMarks& Marks;
  const Terrain& Ground;
  const PlacedHeights& Heights;
};

/**
 * Draws the flight that the options ask for, into a folder (FlightFrames.h), beside `scene.toml`,
 * which has the options, and `flight.csv`, which has the cameras and is a flight itself. Frames
 * that are there from an earlier run with the same options, heights and flight are kept and not
 * drawn again; a folder with anything else in it is left alone. Tells the name of the folder or of
 * the film. Throws a Failure: frames that are kept stay.
 */
void DrawFlight(const FlightStage& stage, const Options& options, Statistics& statistics);

#endif
