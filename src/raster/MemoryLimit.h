// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether samples fit into memory at all. Private to the module.
 */
#ifndef vtkTerrain_raster_MemoryLimit_h
#define vtkTerrain_raster_MemoryLimit_h

#include "vtkDataArray.h"

#include <new>

#include <unistd.h>

namespace terrain
{
/// Throws std::bad_alloc for more than the machine's memory, which the system might still promise.
inline void CheckMemory(const int extent[6], int scalarType)
{
  const double bytes = (static_cast<double>(extent[1]) - extent[0] + 1.0) *
    (static_cast<double>(extent[3]) - extent[2] + 1.0) *
    static_cast<double>(vtkDataArray::GetDataTypeSize(scalarType));
  if (bytes >
    static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)))
  {
    throw std::bad_alloc();
  }
}
}
#endif
