// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/RefinementPlain.h"

#include "core/strips/RefinementPlainKernel.h"

#include <type_traits>

namespace terrain
{
namespace
{
template <bool UseDistance, bool UseCulling, bool UseHoles, bool UseDetail>
struct Switches
{
  static constexpr bool Distance = UseDistance;
  static constexpr bool Culling = UseCulling;
  static constexpr bool Holes = UseHoles;
  static constexpr bool Detail = UseDetail;
};
}

template <typename Switch, typename Sink>
std::int64_t PlainRefinement::Run(const RefinementFrame& frame, const SquareSites& square,
  Sink& sink, std::uint32_t centre, const std::array<std::uint32_t, 4>& corners)
{
  sink.Reserve();
  PlainKernel<Switch, Sink> kernel(frame, sink, this->Waiting);
  return kernel.Run(square.Centre.Position, centre, square.Centre.Record.Drawn(), corners);
}

void PlainRefinement::MakeMesh(
  const RefinementFrame& frame, const SquareSites& square, bool morphing, StripMesh& mesh)
{
  MeshSink& sink = this->Mesh;
  sink.Begin(mesh);
  sink.Morphing = false;
  std::array<std::uint32_t, 4> corners{};
  for (int corner = 0; corner < 4; ++corner)
  {
    corners[corner] = sink.Corner(frame, square.Corners[corner]);
  }
  const std::uint32_t centre = sink.Vertex(frame, square.Centre, 0, 0);
  sink.Morphing = morphing;
  // Each kernel takes the compiler seconds.
  const auto run = [&](auto culls, auto holes, auto detail)
  {
    return this->Run<Switches<false, culls.value, holes.value, detail.value>>(
      frame, square, sink, centre, corners);
  };
  const auto withDetail = [&](auto culls, auto holes)
  {
    return frame.FirstDetail ? run(culls, holes, std::true_type())
                             : run(culls, holes, std::false_type());
  };
  const auto withHoles = [&](auto culls)
  {
    return frame.HasHoles ? withDetail(culls, std::true_type())
                          : withDetail(culls, std::false_type());
  };
  mesh.Triangles =
    frame.PlaneCount == 0 ? withHoles(std::false_type()) : withHoles(std::true_type());
  sink.Finish(mesh);
}

std::int64_t PlainRefinement::MakeStrip(
  const RefinementFrame& frame, const SquareSites& square, std::vector<std::uint32_t>& strip)
{
  SampleSink sink;
  sink.Strip.Begin(strip);
  const std::int64_t triangles =
    this->Run<Switches<true, false, false, false>>(frame, square, sink, square.SampleAt(4),
      { { square.SampleAt(0), square.SampleAt(1), square.SampleAt(2), square.SampleAt(3) } });
  sink.Strip.Finish(strip);
  return triangles;
}
}
