// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/HorizonLanes.h"
#include "core/rays/PacketLanes.h"
#include "core/rays/ViewshedFan.h"

namespace terrain
{
extern const LaneKernels kLaneKernelsAvx512;
const LaneKernels kLaneKernelsAvx512{ "avx512", TERRAIN_LANES_BYTES, CastHorizons<float>,
  CastHorizons<double>, LookAlongFan, CastPacket };
} // namespace terrain
