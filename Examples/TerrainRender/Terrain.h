// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a file of heights to an actor.
 */
#ifndef terrain_render_Terrain_h
#define terrain_render_Terrain_h

#include "vtkSmartPointer.h"

class ProgressBar;
class Statistics;
class vtkActor;
class vtkImageData;
struct Options;

/// Reads the file of heights, or raises the built-in landscape. Throws a Failure.
vtkSmartPointer<vtkImageData> ReadHeights(
  const Options& options, ProgressBar& progress, Statistics& statistics);

/// Builds what the technique draws with, coloured by height. Throws a Failure, also if the heights
/// have no surface at all.
vtkSmartPointer<vtkActor> PrepareTerrain(
  vtkImageData* heights, const Options& options, ProgressBar& progress, Statistics& statistics);

/// Adds what the terrain takes on the graphics card, after it was drawn.
void DescribeTerrain(vtkActor* terrain, Statistics& statistics);

#endif
