// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colours of tracks by a field of their features.
 */
#ifndef terrain_render_TrackColors_h
#define terrain_render_TrackColors_h

#include "Annotations.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

struct TrackOptions;

/// Name of the point array of numbers that a key's table colours.
constexpr const char* kTrackValue = "Value";

/// Turns the texts "Field" of the points of tracks (ReadVectorsWithField) into numbers "Value", and
/// returns their key: numbers where all texts are, else classes in the order in which they come;
/// NaN where there is no text. Throws a Failure if there are too many classes to tell apart.
LegendKey ColorTracks(
  const std::vector<vtkSmartPointer<vtkPolyData>>& tracks, const TrackOptions& options);

#endif
