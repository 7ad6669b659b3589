// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/HorizonLanes.h"
#include "core/rays/PacketLanes.h"
#include "core/rays/ViewshedFan.h"

namespace terrain
{
extern const LaneKernels kLaneKernelsAvx2;
const LaneKernels kLaneKernelsAvx2{ "avx2", TERRAIN_LANES_BYTES, CastHorizons<float>,
  CastHorizons<double>, LookAlongFan, CastPacket };
} // namespace terrain
