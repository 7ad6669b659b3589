// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A terrain's model coordinates and the world's: scales, exaggeration, cameras. Private to the
 * module.
 */
#ifndef vtkTerrain_render_ModelCamera_h
#define vtkTerrain_render_ModelCamera_h

class vtkCamera;
class vtkMatrix4x4;

namespace terrain
{
/// Length of what a matrix makes of a unit of one axis.
double AxisScale(vtkMatrix4x4* matrix, int axis);

/// Makes a matrix that places what is drawn one that places what has true heights, which are
/// exaggerated from a z on.
void Exaggerate(vtkMatrix4x4* toWorld, double originZ, double exaggeration);

/// Makes a camera see a model as another one sees it in the world; toWorld: turns, shifts, and
/// scales all axes by as much.
void PlaceInModel(vtkCamera* world, vtkMatrix4x4* toWorld, vtkCamera* model);
}
#endif
