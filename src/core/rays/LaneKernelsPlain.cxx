// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/HorizonLanes.h"
#include "core/rays/PacketLanes.h"
#include "core/rays/ViewshedFan.h"

namespace terrain
{
extern const LaneKernels kLaneKernelsPlain;
const LaneKernels kLaneKernelsPlain{ "plain", TERRAIN_LANES_BYTES, CastHorizons<float>,
  CastHorizons<double>, LookAlongFan, CastPacket };
} // namespace terrain
