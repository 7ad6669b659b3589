// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a vtkTerrainHierarchy holds. Private to the module.
 */
#ifndef vtkTerrainHierarchyData_h
#define vtkTerrainHierarchyData_h

#include "core/HierarchyFile.h"

#include <string>

/// A hierarchy in memory or in a file; shared with threads that refine it.
struct vtkTerrainHierarchyData
{
  terrain::MemoryHierarchy Memory;
  terrain::HierarchyFile File;
  bool IsFile = false;
  /// The coordinate reference system as text, empty if it is not known.
  std::string CoordinateSystem;

  terrain::HierarchyView View() const
  {
    return this->IsFile ? this->File.View() : this->Memory.View();
  }
  bool IsDamaged() const
  {
    return this->IsFile && this->File.IsDamaged();
  }
};

#endif
