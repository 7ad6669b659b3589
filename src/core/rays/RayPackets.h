// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Many rays against a heightfield on the CPU: what core/rays/RayQuery.h finds for each, several
 * times as fast.
 */
#ifndef terrain_RayPackets_h
#define terrain_RayPackets_h

#include "core/grid/Coordinates.h"
#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"
#include "core/rays/LaneKernels.h"
#include "core/rays/PixelRays.h"
#include "core/rays/RayQuery.h"
#include "core/surface/MinMaxPyramid.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace terrain
{
/// Pixels by rows from the lowest up: the distance of the hit, infinity for none, and the unit
/// normal of the surface there, upward, in model coordinates.
struct PacketPicture
{
  std::vector<float> Distance;
  std::vector<glm::vec3> Normal;
};

/**
 * Packets of rays against the bilinear surface of a heightfield; immutable. 4, 8 or 16 rays go
 * through the pyramid in step (PacketLanes.h), one in each lane of what the processor has (SSE2,
 * AVX2, AVX-512). All kinds of processors find the same, to the bit.
 *
 * Twin: RayQuery, in double. Hits are those of RayQuery to the rounding of floats: distances, times
 * the length of the direction in cells, and heights are right to kPacketError of the distance from
 * where the rays begin, of the relief and of one cell, over the sine at which the ray meets the
 * surface. A ray that passes the surface by less may meet or miss it.
 *
 * Only straight rays, only the bilinear surface, no planes. Heights of 16-bit integers without
 * holes are kept as they are, others as floats.
 *
 * Memory: 4 bytes a sample for 16-bit integers, pyramids included, 8 for others.
 */
class RayPackets
{
public:
  /// Reads and copies the heights. At least 2 x 2 and fewer than 2^31 samples, or nothing is hit.
  template <typename T>
  RayPackets(
    const HeightfieldView<T>& view, const GridGeometry& frame, const ParallelFor& parallelFor)
    : RayPackets(
        view.Width, view.Height, [&view](std::int64_t i, std::int64_t j) { return view.At(i, j); },
        frame, parallelFor)
  {
  }

  /// What each of some rays meets first; Bend must be 0. Neighbours should be near each other.
  /// kernels: one of RunnableLaneKernels(), the fastest if not given.
  void First(const QueryRay* rays, std::int64_t count, SurfaceHit* hits,
    const LaneKernels& kernels = RunnableLaneKernels().back()) const;

  /// The hits of all pixels of a view, between two distances along the viewing direction. rays: in
  /// the grid coordinates of the heights, z in height units. Tiles of pixels share a safe start.
  /// Runs in parallel over rows of tiles.
  void Picture(const PixelRays& rays, const glm::ivec2& size, double near, double far,
    PacketPicture& picture, const ParallelFor& parallelFor,
    const LaneKernels& kernels = RunnableLaneKernels().back()) const;

  /// Bytes that it holds.
  std::size_t MemorySize() const;

private:
  using HeightAt = std::function<double(std::int64_t i, std::int64_t j)>;
  struct Tile;
  RayPackets(std::int64_t width, std::int64_t height, const HeightAt& heights,
    const GridGeometry& frame, const ParallelFor& parallelFor);
  void KeepCodes(const HeightAt& heights, const ParallelFor& parallelFor);
  void KeepFloats(const HeightAt& heights, const ParallelFor& parallelFor);
  template <typename Texel>
  void KeepLevels(const MinMaxPyramid<Texel>& pyramid);
  void CastTile(const Tile& tile, const glm::ivec2& corner, PacketPicture& picture) const;
  void CastPixels(
    const Tile& tile, const glm::ivec2& first, double start, PacketPicture& picture) const;
  float TileStart(const Tile& tile, const glm::dvec2& middle, double pixels, double begin) const;

  GridGeometry Frame;
  PacketGrid Grid;
  std::vector<std::uint16_t> Codes;
  std::vector<float> Floats;
  std::vector<std::uint32_t> Nodes;
  MinMaxPyramid<std::uint16_t> CodePyramid;
  MinMaxPyramid<float> FloatPyramid;
};

/// Error of positions and heights, see above.
constexpr double kPacketError = 2e-6;
}

#endif
