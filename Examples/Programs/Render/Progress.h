// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One progress bar for all that happens before the first frame.
 */
#ifndef terrain_render_Progress_h
#define terrain_render_Progress_h

#include "vtkAlgorithm.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

/// Shares of the bar that reading, placing and preparing take; 1 in all.
constexpr double kReadShare = 0.5;
constexpr double kPlaceShare = 0.2;
constexpr double kMeshShare = 0.3;

/**
 * A bar on stderr, drawn only if stderr is a terminal. Each algorithm watched fills its share of
 * the bar; shares are in [0, 1] and should add up to 1. The bar is erased when it is destroyed.
 */
class ProgressBar
{
public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Shows the progress of the algorithm as the next share of the bar.
  void Watch(vtkAlgorithm* algorithm, double share, const std::string& name);
  /// Fills the bar up to a fraction in [0, 1]; it never goes back.
  void Show(double fraction, const std::string& name);

private:
  struct Stage
  {
    vtkWeakPointer<vtkAlgorithm> Algorithm;
    unsigned long Observer = 0;
    double Begin = 0.0;
    double Share = 0.0;
    std::string Name;
  };

  void OnProgress(vtkObject* caller, unsigned long event, void* data);

  bool Visible = false;
  std::vector<Stage> Stages;
  int DrawnPercent = -1;
};

#endif
