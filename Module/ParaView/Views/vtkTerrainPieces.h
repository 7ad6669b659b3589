// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The images of heights and the surfaces that a process of ParaView holds, and what of them is its
 * own. Private.
 */
#ifndef vtkTerrainPieces_h
#define vtkTerrainPieces_h

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkBoundingBox;
class vtkDataObject;
class vtkImageData;
class vtkMatrix4x4;
class vtkPolyData;
class vtkTerrainActor;

namespace vtkTerrainPieces
{
/// The images with points in a dataset, which may be one itself, a composite one, or null.
std::vector<vtkImageData*> FindImages(vtkDataObject* data);

/// The poly data with points in a dataset, likewise.
std::vector<vtkPolyData*> FindSurfaces(vtkDataObject* data);

/// Whether there is a cell between samples.
bool HasCells(vtkImageData* heights);

/// Cells as samples at their centres, sharing the arrays.
vtkSmartPointer<vtkImageData> CellsAsSamples(vtkImageData* image);

/// First and last sample, counted from the first one of the image, of the cells that are not copies
/// of another process's.
void OwnSamples(vtkImageData* image, std::array<int, 2>& first, std::array<int, 2>& last);

/// True of heights of vtkTerrainGlobe.
bool IsOnGlobe(vtkImageData* heights);

/// Whether two images show the same heights and colours: the same arrays on the same grid.
bool AreSame(vtkImageData* a, vtkImageData* b);

/// Lowest and highest scalar of all images; the first is above the second if there is none.
std::array<double, 2> HeightRange(const std::vector<vtkImageData*>& images);

/// Adds to a box in world coordinates the corners of another one that is placed there.
void AddBox(const double bounds[6], vtkMatrix4x4* toWorld, vtkBoundingBox& box);

/// Adds to a box in world coordinates that of the own samples, if any has a height, where a terrain
/// that is placed and exaggerated like another one draws them.
void AddOwnBox(vtkImageData* heights, vtkTerrainActor* terrain, vtkBoundingBox& box);

/// Makes of a box a column as high as that of any other process, and the matrix that brings it
/// back.
///
/// ParaView orders the processes by the boxes as they are, and cuts what else is drawn along their
/// sides, each process drawing what lies in its own: what reached above or below the terrain would
/// be in none of them. The camera sees the boxes through the matrix.
void MakeColumn(double bounds[6], vtkMatrix4x4* matrix);
}

#endif
