// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Stands in for the module's class where a target is built without VTK.
 */
#ifndef vtkTerrainOutputFile_h
#define vtkTerrainOutputFile_h

#include <string>

struct vtkTerrainOutputFile
{
  static std::string WhyNotInput(const std::string&)
  {
    return {};
  }
};

#endif
