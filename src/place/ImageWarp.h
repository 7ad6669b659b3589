// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A picture on its way into a scene: the private half of vtkTerrainImageWarp.
 */
#ifndef vtkTerrain_place_ImageWarp_h
#define vtkTerrain_place_ImageWarp_h

#include "core/globe/GlobeGrid.h"
#include "raster/GDALTable.h"
#include "vtkTerrainGeoreference.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace terrain
{
/// vtkTerrainImageWarp::InterpolationError.
constexpr double kInterpolationError = 0.05;

/// A picture on its way into a scene.
class ImageWarp
{
public:
  using Dataset = std::unique_ptr<void, void (*)(void*)>;

  Dataset File{ nullptr, nullptr };
  Dataset Colors{ nullptr, nullptr };
  std::array<double, 6> ToFile{};
  std::array<double, 6> FromFile{};
  vtkNew<vtkTerrainGeoreference> Picture;
  vtkTerrainGeoreference* Scene = nullptr;
  vtkSmartPointer<vtkImageData> Heights;
  /// Of heights on a globe, whose pictures lie in the flat coordinates of data/GlobePaths.h.
  std::unique_ptr<GlobeGrid> Globe;
  double MiddleHeight = 0.0;
  double Spacing = 0.0;
  /// South-west corner of the first pixel, in the scene.
  double Corner[2] = { 0.0, 0.0 };
  int Size[2] = { 0, 0 };

  std::string Open(const std::string& name, const std::string& system);
  std::string Place(int maximumSize);
  bool PixelsToScene(std::vector<double>& points);
  bool SceneToPixels(std::vector<double>& points);
  std::array<double, 4> FindOverlap();
  void WidenOnGlobe(const std::vector<double>& points, std::array<double, 4>& own);
  GDALWarpOptions* MakeOptions(GDALDatasetH target);
  std::string Warp(unsigned char* rgba);
  static int Transform(
    void* self, int dstToSrc, int count, double* x, double* y, double* z, int* success);
};
}

#endif
