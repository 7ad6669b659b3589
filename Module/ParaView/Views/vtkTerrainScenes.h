// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether heights that know their places lie in one scene. Private.
 */
#ifndef vtkTerrainScenes_h
#define vtkTerrainScenes_h

#include <string>

class vtkImageData;

namespace vtkTerrainScenes
{
/// Why other heights do not lie where they belong beside the first ones, and what helps, in one
/// sentence. Empty if they do, by the wider spacing of both, and where that cannot be known:
/// without a coordinate system, on other worlds by another one than the first.
std::string WhyApart(vtkImageData* first, vtkImageData* other);
}

#endif
