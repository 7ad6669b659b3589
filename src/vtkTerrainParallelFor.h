// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * terrain::ParallelFor over vtkSMPTools. Private to the module.
 */
#ifndef vtkTerrainParallelFor_h
#define vtkTerrainParallelFor_h

#include "core/ParallelFor.h"

#include "vtkSMPTools.h"

/// Runs body over [0, count) on the threads of vtkSMPTools.
inline void vtkTerrainParallelFor(std::int64_t count, const terrain::RangeBody& body)
{
  if (count > 0)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(count),
      [&body](vtkIdType begin, vtkIdType end) { body(begin, end); });
  }
}

#endif
