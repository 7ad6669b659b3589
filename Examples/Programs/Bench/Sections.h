// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The sections of the report.
 */
#ifndef terrain_bench_Sections_h
#define terrain_bench_Sections_h

#include "Report.h"

#include <vector>

/// How much is measured.
struct Plan
{
  /// Largest side of a landscape, in samples.
  int Largest = 4097;
  /// Frames of each measurement.
  int Frames = 7;
  /// Seconds for each measurement of Google Benchmark.
  double Seconds = 0.3;
  /// Tiny landscapes and pictures: to see that all runs.
  bool IsSmoke = false;
};

/// Sides of landscapes, in samples, from the given ones: those that the plan allows.
std::vector<int> SidesOf(const Plan& plan, const std::vector<int>& sides);

/// Fehér's table 2, beside his own: time, missed and wrong pixels of all searches.
Section MeasureSearches(const Plan& plan);

/// Park and Oh's table 1, beside theirs: preprocessing, flight and walk; and the nodes that rays
/// visit.
Section MeasurePyramid(const Plan& plan);

/// Balogh's figures: triangles in a second; and other work of the processor, by Google Benchmark.
Section MeasureProcessor(const Plan& plan);

/// What VTK has without this module: the full mesh, and vtkGreedyTerrainDecimation.
Section MeasureToday(const Plan& plan);

/// Frames against samples and against pixels.
Section MeasureGrowth(const Plan& plan);

#endif
