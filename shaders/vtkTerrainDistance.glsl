// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkTerrainDepthPass draws instead of a colour.

// The distance of a position in view coordinates from the eye along the viewing direction, in world
// units, as red.
vec4 terrainDistanceColor(vec4 positionVC)
{
  return vec4(-positionVC.z, 0.0, 0.0, 1.0);
}
