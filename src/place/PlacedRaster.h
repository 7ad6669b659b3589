// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A raster file of any CRS on its way into a scene. Private to the module.
 */
#ifndef vtkTerrain_place_PlacedRaster_h
#define vtkTerrain_place_PlacedRaster_h

#include "core/globe/GlobeGrid.h"
#include "raster/GDALTable.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainGeoreference.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace terrain
{
/// vtkTerrainImageWarp::InterpolationError.
constexpr double kInterpolationError = 0.05;

/// A file of GDAL that closes itself.
using Dataset = std::unique_ptr<void, void (*)(void*)>;

Dataset Own(GDALDatasetH dataset);

/// The file, where its pixels are in a scene, and the grid of the scene that it is warped onto.
class PlacedRaster
{
public:
  Dataset File{ Own(nullptr) };
  std::array<double, 6> ToFile{};
  std::array<double, 6> FromFile{};
  vtkNew<vtkTerrainGeoreference> Picture;
  vtkTerrainGeoreference* Scene = nullptr;
  vtkSmartPointer<vtkImageData> Heights;
  /// Of heights on a globe, whose pictures lie in the flat coordinates of data/GlobePaths.h.
  std::unique_ptr<GlobeGrid> Globe;
  double MiddleHeight = 0.0;
  /// True if it lies in the coordinates of the heights' own file, which are no places on earth.
  bool IsOfHeights = false;
  /// Outer corner in the south-west of the grid's first pixel, and sides of its pixels, in the
  /// scene.
  std::array<double, 2> Corner{};
  std::array<double, 2> Spacing{};

  /// Opens the file, and finds its CRS and its affine transform. Returns one sentence on failure.
  std::string Open(const std::string& name, const std::string& system);

  ///@{
  /// Pixels of the file (x, y, height of the scene) to the scene, and back, in place.
  bool PixelsToScene(std::vector<double>& points);
  bool SceneToPixels(std::vector<double>& points);
  ///@}

  /// Warps by options that lack a transformer, and destroys these. Columns and rows are those of
  /// their target. Returns one sentence on failure.
  std::string Warp(GDALWarpOptions* options, int columns, int rows);

private:
  void SetPicture(const std::string& definition);
  static int Transform(
    void* self, int dstToSrc, int count, double* x, double* y, double* z, int* success);
};
}

#endif
