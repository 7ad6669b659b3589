// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The heights of a hierarchy as an image. Private to the module.
 */
#ifndef vtkTerrain_data_HierarchyHeights_h
#define vtkTerrain_data_HierarchyHeights_h

#include "data/HierarchyData.h"

#include <string>

class vtkImageData;

namespace terrain
{
/// Fills an image with the samples of an extent within the hierarchy, as vtkTerrainHierarchy
/// describes it. Returns one sentence if its file is damaged; the image is empty then.
std::string CopyHeights(const HierarchyData& data, const int extent[6], vtkImageData* heights);
}
#endif
