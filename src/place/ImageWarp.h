// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A picture on its way into a scene: the private half of vtkTerrainImageWarp.
 */
#ifndef vtkTerrain_place_ImageWarp_h
#define vtkTerrain_place_ImageWarp_h

#include "place/PlacedRaster.h"

#include <array>
#include <string>
#include <vector>

namespace terrain
{
/// A picture on its way into a scene.
class ImageWarp : public PlacedRaster
{
public:
  /// The file as colours; a view of it.
  Dataset Colors{ Own(nullptr) };
  /// Pixels of the output.
  std::array<int, 2> Size{};

  /// Opens the file, and what is drawn of it. Returns one sentence on failure.
  std::string OpenColors(const std::string& name, const std::string& system);
  /// Finds the overlap with the heights and the grid of the output. Returns one sentence on
  /// failure.
  std::string Place(int maximumSize);
  /// Warps the picture into Size[0] x Size[1] pixels of RGBA, southern row first. Returns one
  /// sentence on failure.
  std::string WarpColors(unsigned char* rgba);

private:
  std::array<double, 4> FindOverlap();
  void WidenOnGlobe(const std::vector<double>& points, std::array<double, 4>& own);
  GDALWarpOptions* MakeOptions(GDALDatasetH target);
};
}

#endif
