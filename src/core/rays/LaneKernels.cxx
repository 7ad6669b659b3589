// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/LaneKernels.h"

namespace terrain
{
extern const LaneKernels kLaneKernelsPlain;
#if defined(TERRAIN_LANES_X86)
extern const LaneKernels kLaneKernelsAvx2;
extern const LaneKernels kLaneKernelsAvx512;
#endif

const std::vector<LaneKernels>& RunnableLaneKernels()
{
  static const std::vector<LaneKernels> kernels = []
  {
    std::vector<LaneKernels> found{ kLaneKernelsPlain };
#if defined(TERRAIN_LANES_X86)
    if (__builtin_cpu_supports("avx2"))
    {
      found.push_back(kLaneKernelsAvx2);
    }
    if (__builtin_cpu_supports("avx512f"))
    {
      found.push_back(kLaneKernelsAvx512);
    }
#endif
    return found;
  }();
  return kernels;
}
}
