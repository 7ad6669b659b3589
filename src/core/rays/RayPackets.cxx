// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/RayPackets.h"

#include "core/rays/PyramidBeam.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace terrain
{
namespace
{
/// Pixels along a side of a tile, which shares a start, and of a wider one, where that is looked
/// for first.
constexpr int kTile = 8;
constexpr int kWideTile = 32;
/// Pixels along a side of a packet.
constexpr int kPacket = 4;

/// What no height may be, as floats over the lowest; PacketGrid::Samples.
constexpr float kNoHeight = -1.0f;

/// Lowest and highest height, and whether 16 bits hold all of them over the lowest.
struct HeightSurvey
{
  double Low = kInfinity;
  double High = -kInfinity;
  bool Whole = true; ///< all samples are whole numbers

  void Take(double height)
  {
    this->Low = height < this->Low ? height : this->Low;
    this->High = height > this->High ? height : this->High;
    this->Whole = this->Whole && std::floor(height) == height; // not so for NaN
  }
  void Take(const HeightSurvey& other)
  {
    this->Low = std::min(this->Low, other.Low);
    this->High = std::max(this->High, other.High);
    this->Whole = this->Whole && other.Whole;
  }
  bool FitsCodes() const
  {
    return this->Whole && this->High - this->Low <= 65535.0;
  }
};

HeightSurvey Survey(const std::function<double(std::int64_t i, std::int64_t j)>& heights,
  std::int64_t width, std::int64_t height, const ParallelFor& parallelFor)
{
  HeightSurvey survey;
  std::mutex mutex;
  parallelFor(height,
    [&](std::int64_t begin, std::int64_t end)
    {
      HeightSurvey part;
      for (std::int64_t j = begin; j < end; ++j)
      {
        for (std::int64_t i = 0; i < width; ++i)
        {
          part.Take(heights(i, j));
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      survey.Take(part);
    });
  return survey;
}

/// A view of samples of a grid.
template <typename Texel>
HeightfieldView<Texel> ViewOf(const std::vector<Texel>& samples, std::int64_t width)
{
  HeightfieldView<Texel> view;
  view.Samples = samples.data();
  view.Width = width;
  view.Height = static_cast<std::int64_t>(samples.size()) / width;
  return view;
}

template <typename Texel>
CodedPyramid<Texel> CodedOf(
  const std::vector<Texel>& samples, const PacketGrid& grid, const MinMaxPyramid<Texel>& pyramid)
{
  CodedPyramid<Texel> coded;
  coded.heights = { samples.data(), { grid.CellsX + 1, grid.CellsY + 1 }, 0, grid.Highest };
  coded.pyramid = &pyramid;
  return coded;
}
}

/// What all tiles of a picture share.
struct RayPackets::Tile
{
  const PixelRays& Rays; ///< their heights are those of the grid of packets
  glm::ivec2 Size;
  double Near;
  double Far;
  const LaneKernels& Kernels;
  CodedPyramid<std::uint16_t> Codes;
  CodedPyramid<float> Floats;
};

RayPackets::RayPackets(std::int64_t width, std::int64_t height, const HeightAt& heights,
  const GridGeometry& frame, const ParallelFor& parallelFor)
  : Frame(frame)
{
  if (width < 2 || height < 2 || width > std::numeric_limits<std::int32_t>::max() / height)
  {
    return;
  }
  const HeightSurvey survey = Survey(heights, width, height, parallelFor);
  if (!(survey.Low <= survey.High))
  {
    return;
  }
  this->Grid.CellsX = static_cast<int>(width - 1);
  this->Grid.CellsY = static_cast<int>(height - 1);
  this->Grid.Stride = static_cast<int>(width);
  this->Grid.Base = survey.Low;
  this->Grid.Highest = static_cast<float>(survey.High - survey.Low);
  if (survey.FitsCodes())
  {
    this->KeepCodes(heights, parallelFor);
  }
  else
  {
    this->KeepFloats(heights, parallelFor);
  }
}

void RayPackets::KeepCodes(const HeightAt& heights, const ParallelFor& parallelFor)
{
  const std::int64_t width = this->Grid.Stride;
  // one more, since two are read at once
  this->Codes.resize(static_cast<std::size_t>(width * (this->Grid.CellsY + 1)));
  parallelFor(this->Grid.CellsY + 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t j = begin; j < end; ++j)
      {
        for (std::int64_t i = 0; i < width; ++i)
        {
          this->Codes[static_cast<std::size_t>(i + width * j)] =
            static_cast<std::uint16_t>(heights(i, j) - this->Grid.Base);
        }
      }
    });
  this->Grid.Samples = this->Codes.data();
  this->CodePyramid.Build(ViewOf(this->Codes, width), parallelFor);
  this->KeepLevels(this->CodePyramid);
}

void RayPackets::KeepFloats(const HeightAt& heights, const ParallelFor& parallelFor)
{
  const std::int64_t width = this->Grid.Stride;
  this->Floats.resize(static_cast<std::size_t>(width * (this->Grid.CellsY + 1)));
  parallelFor(this->Grid.CellsY + 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t j = begin; j < end; ++j)
      {
        for (std::int64_t i = 0; i < width; ++i)
        {
          const double height = heights(i, j) - this->Grid.Base;
          this->Floats[static_cast<std::size_t>(i + width * j)] =
            std::isnan(height) ? kNoHeight : static_cast<float>(height);
        }
      }
    });
  this->Grid.FloatSamples = true;
  this->Grid.Samples = this->Floats.data();
  this->Grid.NodeStep = this->Grid.Highest > 0.0f ? this->Grid.Highest / 65535.0f : 1.0f;
  HeightfieldView<float> view = ViewOf(this->Floats, width);
  view.HasNoData = true;
  view.NoData = kNoHeight;
  this->FloatPyramid.Build(view, parallelFor);
  this->KeepLevels(this->FloatPyramid);
}

/// Nodes in 16 bits, whose bounds are no narrower.
template <typename Texel>
void RayPackets::KeepLevels(const MinMaxPyramid<Texel>& pyramid)
{
  this->Nodes.resize(pyramid.NumberOfNodes());
  this->Grid.Levels = std::min(pyramid.LevelCount(), PacketGrid::MostLevels);
  const auto code = [this](Texel height, double rounding)
  {
    const double steps = static_cast<double>(height) / static_cast<double>(this->Grid.NodeStep);
    return static_cast<std::uint32_t>(std::clamp(std::floor(steps + rounding), 0.0, 65535.0));
  };
  const double out = std::is_integral_v<Texel> ? 0.0 : 1.0;
  for (int level = 1; level <= this->Grid.Levels; ++level)
  {
    const auto k = static_cast<std::size_t>(level);
    const glm::ivec2 size = pyramid.LevelSize(level);
    const PyramidNode<Texel>* from = pyramid.LevelNodes(level);
    const std::int64_t begin = pyramid.GetLayout().Begin(level);
    this->Grid.LevelBegins[k] = static_cast<std::int32_t>(begin);
    this->Grid.LevelWidths[k] = size.x;
    this->Grid.LevelHeights[k] = size.y;
    for (std::int64_t node = 0; node < std::int64_t{ size.x } * size.y; ++node)
    {
      this->Nodes[static_cast<std::size_t>(begin + node)] = from[node].IsEmpty()
        ? 0xffff0000u
        : code(from[node].Maximum, out) | code(from[node].Minimum, -out) << 16;
    }
  }
  this->Grid.Nodes = this->Nodes.data();
}

void RayPackets::First(
  const QueryRay* rays, std::int64_t count, SurfaceHit* hits, const LaneKernels& kernels) const
{
  PacketRays packet;
  PacketHits found;
  for (std::int64_t first = 0; first < count; first += PacketRays::Most)
  {
    packet.Count = static_cast<int>(std::min<std::int64_t>(count - first, PacketRays::Most));
    for (int k = 0; k < PacketRays::Most; ++k)
    {
      const QueryRay& ray = rays[first + std::min(k, packet.Count - 1)];
      const glm::dvec3 origin = this->Frame.ToGrid(ray.Origin + ray.Begin * ray.Direction);
      const glm::dvec3 direction = this->Frame.DirectionToGrid(ray.Direction);
      const bool usable = this->Grid.Levels > 0 &&
        std::isfinite(glm::dot(origin, glm::dvec3(1.0))) &&
        std::isfinite(glm::dot(direction, glm::dvec3(1.0)));
      for (int axis = 0; axis < 3; ++axis)
      {
        packet.Origin[axis][k] = usable ? origin[axis] : 0.0;
        packet.Direction[axis][k] = usable ? direction[axis] : 0.0;
      }
      packet.End[k] = usable ? ray.End - ray.Begin : -1.0;
    }
    kernels.Packet(this->Grid, packet, found);
    for (int k = 0; k < packet.Count; ++k)
    {
      SurfaceHit& hit = hits[first + k];
      hit = {};
      if (found.CellX[k] < 0)
      {
        continue;
      }
      const glm::dvec2 slopes(
        static_cast<double>(found.SlopeX[k]), static_cast<double>(found.SlopeY[k]));
      const double distance = static_cast<double>(found.Distance[k]);
      hit.Found = true;
      hit.Distance = rays[first + k].Begin + distance;
      hit.Cell = { found.CellX[k], found.CellY[k] };
      hit.Fraction = { static_cast<double>(found.FractionX[k]),
        static_cast<double>(found.FractionY[k]) };
      hit.Height = packet.Origin[2][k] + distance * packet.Direction[2][k];
      hit.Normal = glm::normalize(this->Frame.NormalToModel(glm::dvec3(-slopes, 1.0)));
      hit.FromAbove = packet.Direction[2][k] <=
        slopes.x * packet.Direction[0][k] + slopes.y * packet.Direction[1][k];
    }
  }
}

/// A distance before which no ray within some pixels of a position meets the surface.
float RayPackets::TileStart(
  const Tile& tile, const glm::dvec2& middle, double pixels, double begin) const
{
  int steps = 0;
  const TerrainBeam beam = TileBeam(tile.Rays, middle, pixels, begin, tile.Far);
  return this->Grid.FloatSamples ? PyramidBeam<float>(tile.Floats).BeamStart(beam, steps)
                                 : PyramidBeam<std::uint16_t>(tile.Codes).BeamStart(beam, steps);
}

void RayPackets::CastPixels(
  const Tile& tile, const glm::ivec2& first, double start, PacketPicture& picture) const
{
  PacketRays packet;
  packet.Count = PacketRays::Most;
  for (int k = 0; k < PacketRays::Most; ++k)
  {
    const int row = k / kPacket;
    const glm::dvec2 pixel(first.x + k % kPacket + 0.5, first.y + row + 0.5);
    const glm::dvec3 direction = AtPixel(tile.Rays.DirectionGC, pixel);
    const glm::dvec3 origin = AtPixel(tile.Rays.OriginGC, pixel) + start * direction;
    for (int axis = 0; axis < 3; ++axis)
    {
      packet.Origin[axis][k] = origin[axis];
      packet.Direction[axis][k] = direction[axis];
    }
    packet.Origin[2][k] += this->Grid.Base;
    packet.End[k] = tile.Far - start;
  }
  PacketHits found;
  tile.Kernels.Packet(this->Grid, packet, found);
  const glm::vec3 scale(this->Frame.Spacing, this->Frame.Exaggeration);
  for (int k = 0; k < PacketRays::Most; ++k)
  {
    const glm::ivec2 pixel(first.x + k % kPacket, first.y + k / kPacket);
    if (found.CellX[k] < 0 || pixel.x >= tile.Size.x || pixel.y >= tile.Size.y)
    {
      continue;
    }
    const auto index =
      static_cast<std::size_t>(pixel.x + static_cast<std::int64_t>(tile.Size.x) * pixel.y);
    picture.Distance[index] = static_cast<float>(start + static_cast<double>(found.Distance[k]));
    const glm::vec3 normal = glm::vec3(-found.SlopeX[k], -found.SlopeY[k], 1.0f) / scale;
    picture.Normal[index] = normal / std::sqrt(glm::dot(normal, normal));
  }
}

void RayPackets::CastTile(const Tile& tile, const glm::ivec2& corner, PacketPicture& picture) const
{
  const glm::dvec2 middle = glm::dvec2(corner) + 0.5 * kWideTile;
  const double wide =
    tile.Near + static_cast<double>(this->TileStart(tile, middle, 0.5 * kWideTile, tile.Near));
  const glm::ivec2 end = glm::min(corner + kWideTile, tile.Size);
  for (int y = corner.y; y < end.y && wide < tile.Far; y += kTile)
  {
    for (int x = corner.x; x < end.x; x += kTile)
    {
      const glm::dvec2 own = glm::dvec2(x, y) + 0.5 * kTile;
      const double start =
        wide + static_cast<double>(this->TileStart(tile, own, 0.5 * kTile, wide));
      for (int k = 0; k < kTile * kTile / PacketRays::Most && start < tile.Far; ++k)
      {
        constexpr int across = kTile / kPacket;
        const glm::ivec2 part(k % across, k / across);
        this->CastPixels(tile, glm::ivec2(x, y) + kPacket * part, start, picture);
      }
    }
  }
}

void RayPackets::Picture(const PixelRays& rays, const glm::ivec2& size, double near, double far,
  PacketPicture& picture, const ParallelFor& parallelFor, const LaneKernels& kernels) const
{
  const auto pixels =
    static_cast<std::size_t>(std::max(size.x, 0)) * static_cast<std::size_t>(std::max(size.y, 0));
  picture.Distance.assign(pixels, std::numeric_limits<float>::infinity());
  picture.Normal.assign(pixels, glm::vec3(0.0f));
  if (this->Grid.Levels < 1 || pixels == 0)
  {
    return;
  }
  PixelRays over = rays;
  over.OriginGC[0].z -= this->Grid.Base;
  const Tile tile{ over, size, near, far, kernels,
    CodedOf(this->Codes, this->Grid, this->CodePyramid),
    CodedOf(this->Floats, this->Grid, this->FloatPyramid) };
  const glm::i64vec2 tiles =
    (glm::i64vec2(size) + std::int64_t{ kWideTile - 1 }) / std::int64_t{ kWideTile };
  parallelFor(tiles.x * tiles.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t k = begin; k < end; ++k)
      {
        this->CastTile(tile,
          glm::ivec2(glm::i64vec2(k % tiles.x, k / tiles.x) * std::int64_t{ kWideTile }), picture);
      }
    });
}

std::size_t RayPackets::MemorySize() const
{
  return sizeof(std::uint16_t) * this->Codes.size() + sizeof(float) * this->Floats.size() +
    sizeof(std::uint32_t) * this->Nodes.size() + this->CodePyramid.MemorySize() +
    this->FloatPyramid.MemorySize();
}
}
