// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What vtkTerrainReproject plans before it takes samples. Private to the module.
 */
#ifndef vtkTerrain_place_ReprojectInternals_h
#define vtkTerrain_place_ReprojectInternals_h

#include "core/grid/Coordinates.h"
#include "core/place/VerticalSearch.h"
#include "data/FieldData.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainReproject.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

/// An input and where it lies.
struct vtkTerrainReproject::Tile
{
  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkTerrainGeoreference> Reference;
  std::string System;
  bool IsInMetres = false;
  terrain::GridGeometry Geometry;
  terrain::FieldData::Layout Layout;
  /// In the CRS: first and last sample.
  double Extent[4] = { 0.0, 0.0, 0.0, 0.0 };
  double Heights[2] = { 0.0, 0.0 };
  /// In the scene; empty if none of it has an image.
  double Bounds[4] = { 1.0, -1.0, 1.0, -1.0 };
  /// Columns round the earth, if that many close the circle; else 0.
  double Turn = 0.0;

  /// Point of the CRS to grid coordinates, cells.
  void ToGrid(const double* file, double& x, double& y) const
  {
    x = ((file[0] - this->Layout.Origin[0]) * this->Layout.Scale[0] - this->Geometry.Origin.x) /
      this->Geometry.Spacing.x;
    y = ((file[1] - this->Layout.Origin[1]) * this->Layout.Scale[1] - this->Geometry.Origin.y) /
      this->Geometry.Spacing.y;
  }
};

class vtkTerrainReproject::vtkInternals
{
public:
  /// Searches of a round scene along the verticals of points, whose z is that of the height 0.
  std::vector<terrain::VerticalSearch> BeginSearches(const std::vector<double>& scene) const;

  vtkSmartPointer<vtkTerrainGeoreference> Georeference;
  /// Modification time of the georeference after this filter filled it in itself.
  vtkMTimeType OwnTime = 0;
  std::string OwnSystem;
  double OwnExtent[4] = { 1.0, -1.0, 1.0, -1.0 };
  std::vector<std::unique_ptr<Tile>> Tiles;
  double Spacing = 0.0;
  int Extent[6] = { 0, -1, 0, -1, 0, 0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
};

#endif
