// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Places on the surface of a scene. Private to the module.
 */
#ifndef vtkTerrain_place_GroundPlaces_h
#define vtkTerrain_place_GroundPlaces_h

#include <vector>

class vtkImageData;
class vtkTerrainGeoreference;

namespace terrain
{
/// Gives places (longitude, latitude, height: three doubles each) the height of the surface below
/// them, NaN where there is none. In round frames the vertical of a place is not that of the scene;
/// the height is then right to kGroundTolerance in the scene. The image holds heights, and the
/// georeference has places.
void LowerToGround(
  vtkTerrainGeoreference* georeference, vtkImageData* heights, std::vector<double>& places);

/// In metres.
constexpr double kGroundTolerance = 1e-3;
}
#endif
