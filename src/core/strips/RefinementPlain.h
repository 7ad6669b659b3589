// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The plain procedure of Refinement.h: vertices and strip in one pass.
 */
#ifndef terrain_RefinementPlain_h
#define terrain_RefinementPlain_h

#include "core/strips/RefinementSinks.h"

#include <cstdint>
#include <vector>

namespace terrain
{
class PlainRefinement
{
public:
  /// Makes a mesh by the screen-space error.
  void MakeMesh(
    const RefinementFrame& frame, const SquareSites& square, bool morphing, StripMesh& mesh);
  /// Makes a strip by the distance to the eye; returns the number of triangles.
  std::int64_t MakeStrip(
    const RefinementFrame& frame, const SquareSites& square, std::vector<std::uint32_t>& strip);

private:
  template <typename Switch, typename Sink>
  std::int64_t Run(const RefinementFrame& frame, const SquareSites& square, Sink& sink,
    std::uint32_t centre, const std::array<std::uint32_t, 4>& corners);

  MeshSink Mesh;
  WaitingVertices Waiting;
};
}

#endif
