// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the observers of a viewshed stand, as the command line says.
 */
#ifndef terrain_analyze_Observers_h
#define terrain_analyze_Observers_h

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

/// Observers in the CRS of the heights.
struct ObserverOptions
{
  /// "X,Y" each.
  std::vector<std::string> Points;
  /// Corners, "X,Y X,Y ...".
  std::vector<std::string> Lines;
  std::vector<std::string> Areas;
  /// Vectors that GDAL opens, in any CRS: points, lines and polygons, whose holes count as inside.
  std::vector<std::string> Files;
};

/// Why a text is not "X,Y", two finite numbers; empty if it is.
std::string WhyNotCorner(const std::string& text);

/// Points, lines and polygons in the scene of heights. Throws Failure.
vtkSmartPointer<vtkPolyData> MakeObservers(const ObserverOptions& options, vtkImageData* heights);

#endif
