// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A draped picture as one that spans a terrain, for meshes, which have one texture each. Private to
 * the module.
 */
#ifndef terrain_parts_DrapePicture_h
#define terrain_parts_DrapePicture_h

#include "vtkSmartPointer.h"

#include <array>

class vtkImageData;
class vtkUnsignedCharArray;

namespace terrain
{
/// Most pixels a side.
constexpr int kMostDrapePixels = 8192;

/// West, east, south, north of the samples of an image of heights.
std::array<double, 4> FindSampleBounds(vtkImageData* heights);

/// The picture, of these bounds, over the whole terrain, RGB, its pixels as large as its own
/// (larger beyond kMostDrapePixels a side). Where it has nothing to show there are the colours of
/// the points of the heights, or white without any. Null if the picture is none
/// (vtkTerrainLook::SetDrape()).
vtkSmartPointer<vtkImageData> MakeDrapePicture(vtkImageData* drape,
  const std::array<double, 4>& drapeBounds, vtkImageData* heights, vtkUnsignedCharArray* colors);
}
#endif
