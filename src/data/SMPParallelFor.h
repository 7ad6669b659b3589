// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * ParallelFor over vtkSMPTools. Private to the module.
 */
#ifndef vtkTerrain_data_SMPParallelFor_h
#define vtkTerrain_data_SMPParallelFor_h

#include "core/grid/ParallelFor.h"

#include "vtkSMPTools.h"

namespace terrain
{
/// Runs body over [0, count) on the threads of vtkSMPTools.
inline void SMPParallelFor(std::int64_t count, const RangeBody& body)
{
  if (count > 0)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(count),
      [&body](vtkIdType begin, vtkIdType end) { body(begin, end); });
  }
}
}
#endif
