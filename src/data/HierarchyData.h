// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a vtkTerrainHierarchy holds. Private to the module.
 */
#ifndef vtkTerrain_data_HierarchyData_h
#define vtkTerrain_data_HierarchyData_h

#include "core/strips/HierarchyFile.h"

#include <string>

namespace terrain
{
/// A hierarchy in memory or in a file; shared with threads that refine it.
struct HierarchyData
{
  MemoryHierarchy Memory;
  HierarchyFile File;
  bool IsFile = false;
  HierarchyPlacing Placing;

  HierarchyView View() const
  {
    return this->IsFile ? this->File.View() : this->Memory.View();
  }
  bool IsDamaged() const
  {
    return this->IsFile && this->File.IsDamaged();
  }
};
}
#endif
