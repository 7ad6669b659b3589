// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What vtkTerrainGeoreference derives from its settings. Private to the module.
 */
#ifndef vtkTerrain_place_GeoreferenceInternals_h
#define vtkTerrain_place_GeoreferenceInternals_h

#include "core/place/SceneFrame.h"
#include "raster/CoordinateSystem.h"
#include "vtkTerrainGeoid.h"
#include "vtkTerrainGeoreference.h"

#include "vtkNew.h"

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

namespace terrain::PlaceExtent
{
/// "x 1 to 2, y 3 to 4"
std::string ToText(const double extent[4]);
/// False for the empty extent, which stands for an unknown one.
bool IsKnown(const double extent[4]);
/// Corners and further points of the border of an extent, three doubles each.
std::vector<double> Border(const double extent[4]);
}

class vtkTerrainGeoreference::vtkInternals
{
public:
  std::mutex Mutex;
  std::atomic<vtkMTimeType> PreparedTime{ 0 };
  std::string SystemRead;
  std::string SystemWhyNot;
  terrain::CoordinateSystem System;
  vtkNew<vtkTerrainGeoid> Geoid;
  std::string WhyNot;
  std::string Warning;
  terrain::SceneFrame Frame;
  bool HasFrame = false;
  double HeightUnit = 1.0;
  HeightType FileHeights = HeightType::AsIs;
  /// Metres of geoid height to add to heights on their way from file to scene: -1, 0 or 1 times.
  double GeoidSign = 0.0;
  double MiddleX = 0.0;
  /// The frame Grid: scene = (file - GridOrigin) * GridScale.
  double GridOrigin[2] = { 0.0, 0.0 };
  double GridScale[2] = { 1.0, 1.0 };

  void GridToScene(double* point) const
  {
    point[0] = (point[0] - this->GridOrigin[0]) * this->GridScale[0];
    point[1] = (point[1] - this->GridOrigin[1]) * this->GridScale[1];
  }
  void SceneToGrid(double* point) const
  {
    point[0] = this->GridOrigin[0] + point[0] / this->GridScale[0];
    point[1] = this->GridOrigin[1] + point[1] / this->GridScale[1];
  }

  /// Brings x and y of count points from one unit of angles to another.
  static void ScaleDegrees(double* points, vtkIdType count, double factor)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      points[3 * i] *= factor;
      points[3 * i + 1] *= factor;
    }
  }
};

#endif
