// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays on one core beside those of Embree 3, whose grid has two triangles a cell, in turns, as
// processor time.
//
//   BenchmarkEmbree rays [SAMPLES [FRAMES]]
//     640 x 480 primary rays, hits and unit normals, of the four views of BenchmarkTechniques over
//     the procedural landscape: RayPackets::Picture beside coherent packets of 16.
//   BenchmarkEmbree horizon DEM
//     16 directions of every sample: HorizonGrid beside packets of 16 shadow rays, each direction's
//     angle halved until it is known to 0.25 degrees, as HORAYZON casts them (C. R. Steger and
//     others, Geosci. Model Dev. 15, 2022), and to 0.01 degrees; and how far the two are apart.
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainSource.h"

#include "core/grid/Constants.h"
#include "core/rays/Horizon.h"
#include "core/rays/RayPackets.h"

#include "vtkImageCast.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using terrain::GridGeometry;

constexpr int kLanes = 16;
constexpr glm::ivec2 kPixels(640, 480);
constexpr int kDirections = 16;
/// Embree leaves out what lies nearer, in metres: samples do not hide themselves.
constexpr float kLift = 0.1F;

double Milliseconds(const std::function<void()>& work)
{
  const std::clock_t begin = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Heights as floats, and where they are, in metres.
struct Ground
{
  vtkNew<vtkImageData> Image;
  terrain::HeightfieldView<float> View;
  GridGeometry Frame;
};

std::unique_ptr<Ground> Take(vtkImageAlgorithm* source)
{
  vtkNew<vtkImageCast> cast;
  cast->SetInputConnection(source->GetOutputPort());
  cast->SetOutputScalarTypeToFloat();
  cast->Update();
  auto ground = std::make_unique<Ground>();
  ground->Image->ShallowCopy(cast->GetOutput());
  ground->View.Samples = static_cast<const float*>(ground->Image->GetScalarPointer());
  ground->View.Width = ground->Image->GetDimensions()[0];
  ground->View.Height = ground->Image->GetDimensions()[1];
  const double* spacing = ground->Image->GetSpacing();
  ground->Frame.Spacing = { spacing[0], spacing[1] };
  return ground;
}

/// The heights as Embree's grid.
class Peer
{
public:
  /// isRobust: rays along edges pass between no two triangles.
  Peer(const Ground& ground, bool isRobust)
    : Device(rtcNewDevice("threads=1"))
    , Scene(rtcNewScene(this->Device))
  {
    const auto& view = ground.View;
    RTCGeometry grid = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_GRID);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(grid, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), static_cast<std::size_t>(view.Width * view.Height)));
    for (std::int64_t j = 0; j < view.Height; ++j)
    {
      for (std::int64_t i = 0; i < view.Width; ++i)
      {
        *vertex++ = static_cast<float>(ground.Frame.Spacing.x * static_cast<double>(i));
        *vertex++ = static_cast<float>(ground.Frame.Spacing.y * static_cast<double>(j));
        *vertex++ = view.At(i, j);
      }
    }
    auto* cells = static_cast<RTCGrid*>(
      rtcSetNewGeometryBuffer(grid, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid), 1));
    *cells = { 0, static_cast<unsigned int>(view.Width), static_cast<unsigned short>(view.Width),
      static_cast<unsigned short>(view.Height) };
    rtcCommitGeometry(grid);
    rtcAttachGeometry(this->Scene, grid);
    rtcReleaseGeometry(grid);
    rtcSetSceneFlags(this->Scene, isRobust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcCommitScene(this->Scene);
  }
  ~Peer()
  {
    rtcReleaseScene(this->Scene);
    rtcReleaseDevice(this->Device);
  }
  Peer(const Peer&) = delete;
  void operator=(const Peer&) = delete;

  void Intersect(const std::array<int, kLanes>& valid, RTCRayHit16& rays) const
  {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid.data(), this->Scene, &context, &rays);
  }

  void Occluded(const std::array<int, kLanes>& valid, RTCRay16& rays) const
  {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded16(valid.data(), this->Scene, &context, &rays);
  }

private:
  RTCDevice Device;
  RTCScene Scene;
};

template <typename Rays>
void SetRay(Rays& rays, int lane, const glm::dvec3& from, const glm::dvec3& direction, float begin)
{
  rays.org_x[lane] = static_cast<float>(from.x);
  rays.org_y[lane] = static_cast<float>(from.y);
  rays.org_z[lane] = static_cast<float>(from.z);
  rays.dir_x[lane] = static_cast<float>(direction.x);
  rays.dir_y[lane] = static_cast<float>(direction.y);
  rays.dir_z[lane] = static_cast<float>(direction.z);
  rays.tnear[lane] = begin;
  rays.tfar[lane] = static_cast<float>(terrain::kInfinity);
  rays.mask[lane] = ~0U;
  rays.time[lane] = 0.0F;
  rays.flags[lane] = 0;
  rays.id[lane] = static_cast<unsigned int>(lane);
}

//------------------------------------------------------------------------------
/// Eye and focal point as fractions of the terrain's side, z in metres.
struct View
{
  const char* Name;
  glm::dvec3 Eye;
  glm::dvec3 Focus;
  bool AboveGround;
};

const std::array<View, 4> kViews{
  { { "oblique", { 0.5, -0.6, 20000.0 }, { 0.5, 0.45, 0.0 }, false },
    { "fly", { 0.3, 0.25, 4000.0 }, { 0.6, 0.6, 500.0 }, false },
    { "walk", { 0.42, 0.4, 2.0 }, { 0.7, 0.6, 200.0 }, true },
    { "down", { 0.5, 0.5, 30000.0 }, { 0.5, 0.501, 0.0 }, false } }
};

/// A camera of VTK's 30 degrees.
struct Camera
{
  glm::dvec3 Eye;
  terrain::PixelVector Direction;
};

Camera Look(const View& view, const Ground& ground)
{
  const double side = ground.Frame.Spacing.x * static_cast<double>(ground.View.Width - 1);
  const auto at = [&](double part)
  { return static_cast<std::int64_t>(part * static_cast<double>(ground.View.Width - 1)); };
  const double base = view.AboveGround ? ground.View.At(at(view.Eye.x), at(view.Eye.y)) : 0.0;
  const glm::dvec3 scale(side, side, 1.0);
  const glm::dvec3 up(0.0, 0.0, base);
  const glm::dvec3 eye = scale * view.Eye + up;
  const glm::dvec3 ahead = glm::normalize(scale * view.Focus + up - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0.0, 0.0, 1.0)));
  const double tangent = std::tan(glm::radians(15.0));
  const glm::dvec3 x = 2.0 * tangent / kPixels.y * right;
  const glm::dvec3 y = 2.0 * tangent / kPixels.y * glm::cross(right, ahead);
  return { eye, { ahead - 0.5 * kPixels.x * x - 0.5 * kPixels.y * y, x, y } };
}

void CastOurs(const terrain::RayPackets& packets, const GridGeometry& frame, const Camera& camera,
  terrain::PacketPicture& picture)
{
  terrain::PixelRays rays;
  rays.OriginGC = { frame.ToGrid(camera.Eye), glm::dvec3(0.0), glm::dvec3(0.0) };
  rays.DirectionGC = { frame.DirectionToGrid(camera.Direction[0]),
    frame.DirectionToGrid(camera.Direction[1]), frame.DirectionToGrid(camera.Direction[2]) };
  packets.Picture(rays, kPixels, 0.0, 1e7, picture, terrain::SerialFor);
}

void CastPeer(const Peer& peer, const Camera& camera, terrain::PacketPicture& picture)
{
  std::array<int, kLanes> valid{};
  valid.fill(-1);
  for (int y = 0; y < kPixels.y; y += 4)
  {
    for (int x = 0; x < kPixels.x; x += 4)
    {
      RTCRayHit16 rays{};
      for (int lane = 0; lane < kLanes; ++lane)
      {
        const glm::dvec2 pixel(x + lane % 4 + 0.5, y + lane / 4 + 0.5);
        SetRay(rays.ray, lane, camera.Eye, terrain::AtPixel(camera.Direction, pixel), 0.0F);
        rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      }
      peer.Intersect(valid, rays);
      for (int lane = 0; lane < kLanes; ++lane)
      {
        const std::size_t k = static_cast<std::size_t>(y + lane / 4) * kPixels.x +
          static_cast<std::size_t>(x + lane % 4);
        const bool isHit = rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
        picture.Distance[k] = isHit ? rays.ray.tfar[lane] : std::numeric_limits<float>::infinity();
        picture.Normal[k] =
          glm::normalize(glm::vec3(rays.hit.Ng_x[lane], rays.hit.Ng_y[lane], rays.hit.Ng_z[lane]));
      }
    }
  }
}

/// Percent of the pixels in which both hit or miss, at distances within a thousandth.
double Agreement(const terrain::PacketPicture& one, const terrain::PacketPicture& other)
{
  std::size_t same = 0;
  for (std::size_t k = 0; k < one.Distance.size(); ++k)
  {
    const bool isHit = std::isfinite(one.Distance[k]);
    same += isHit == std::isfinite(other.Distance[k]) &&
      (!isHit || std::abs(one.Distance[k] - other.Distance[k]) < 1e-3F * one.Distance[k]);
  }
  return 100.0 * static_cast<double>(same) / static_cast<double>(one.Distance.size());
}

void CompareRays(int samples, int frames)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(samples, samples);
  const std::unique_ptr<Ground> ground = Take(source);
  const terrain::HeightfieldView<float>& view = ground->View;
  std::vector<std::uint16_t> codes;
  std::transform(view.Samples, view.Samples + view.Width * view.Height, std::back_inserter(codes),
    [](float height) { return static_cast<std::uint16_t>(std::lround(height)); });
  terrain::HeightfieldView<std::uint16_t> whole;
  whole.Samples = codes.data();
  whole.Width = view.Width;
  whole.Height = view.Height;
  std::copy(codes.begin(), codes.end(), static_cast<float*>(ground->Image->GetScalarPointer()));
  const terrain::RayPackets packets(whole, ground->Frame, terrain::SerialFor);
  const Peer peer(*ground, false);
  terrain::PacketPicture ours;
  terrain::PacketPicture theirs;
  const std::size_t pixels = static_cast<std::size_t>(kPixels.x) * kPixels.y;
  theirs.Distance.resize(pixels);
  theirs.Normal.resize(pixels);
  std::cout << "view: million rays a second, RayPackets, Embree; times Embree's; percent alike\n";
  for (const View& seen : kViews)
  {
    const Camera camera = Look(seen, *ground);
    std::vector<double> times[2];
    for (int frame = -1; frame < frames; ++frame)
    {
      const double first = Milliseconds([&] { CastOurs(packets, ground->Frame, camera, ours); });
      const double second = Milliseconds([&] { CastPeer(peer, camera, theirs); });
      if (frame >= 0)
      {
        times[0].push_back(first);
        times[1].push_back(second);
      }
    }
    const double rays = 1e-3 * static_cast<double>(pixels);
    std::cout << seen.Name << ": " << rays / Median(times[0]) << ", " << rays / Median(times[1])
              << "; " << Median(times[1]) / Median(times[0]) << "; " << Agreement(ours, theirs)
              << "\n";
  }
}

//------------------------------------------------------------------------------
/// Angles in degrees of a row's samples from i on, in a direction; the wanted accuracy in degrees.
void HalveAngles(const Ground& ground, const Peer& peer, glm::i64vec2 first, double azimuth,
  double accuracy, float* degrees)
{
  const glm::dvec2 ahead(std::sin(glm::radians(azimuth)), std::cos(glm::radians(azimuth)));
  std::array<int, kLanes> valid{};
  std::array<double, kLanes> low{};
  std::array<double, kLanes> high{};
  low.fill(-90.0);
  high.fill(90.0);
  std::array<glm::dvec3, kLanes> from{};
  for (int lane = 0; lane < kLanes && first.x + lane < ground.View.Width; ++lane)
  {
    valid[lane] = -1;
    from[lane] = ground.Frame.ToModel(
      { first.x + lane, first.y }, ground.View.At(first.x + lane, first.y) + kLift);
  }
  for (double width = 180.0; width > accuracy; width *= 0.5)
  {
    RTCRay16 rays{};
    for (int lane = 0; lane < kLanes; ++lane)
    {
      const double angle = glm::radians(0.5 * (low[lane] + high[lane]));
      SetRay(rays, lane, from[lane],
        { std::cos(angle) * ahead.x, std::cos(angle) * ahead.y, std::sin(angle) }, 0.0F);
    }
    peer.Occluded(valid, rays);
    for (int lane = 0; lane < kLanes; ++lane)
    {
      const double middle = 0.5 * (low[lane] + high[lane]);
      (rays.tfar[lane] < 0.0F ? low : high)[lane] = middle;
    }
  }
  for (int lane = 0; lane < kLanes && valid[lane]; ++lane)
  {
    degrees[lane] = static_cast<float>(0.5 * (low[lane] + high[lane]));
  }
}

void CompareHorizons(const char* path)
{
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(path);
  const std::unique_ptr<Ground> ground = Take(reader);
  const std::int64_t width = ground->View.Width;
  const std::int64_t height = ground->View.Height;
  terrain::HorizonOptions options;
  options.Spacing = ground->Frame.Spacing;
  options.EyeHeight = kLift;
  std::vector<float> ours[kDirections];
  const double taken = Milliseconds(
    [&]
    {
      const terrain::HorizonGrid grid(ground->View, terrain::SerialFor);
      for (int k = 0; k < kDirections; ++k)
      {
        ours[k].resize(static_cast<std::size_t>(width * height));
        grid.Cast(
          360.0 * k / kDirections, options, { 0, height }, ours[k].data(), terrain::SerialFor);
      }
    });
  std::cout << "HorizonGrid: " << taken << " ms\n";
  const Peer peer(*ground, true);
  for (const double accuracy : { 0.25, 0.01 })
  {
    double spent = 0.0;
    std::vector<float> apart;
    for (int k = 0; k < kDirections; ++k)
    {
      std::vector<float> theirs(ours[k].size());
      spent += Milliseconds(
        [&]
        {
          for (std::int64_t j = 0; j < height; ++j)
          {
            for (std::int64_t i = 0; i < width; i += kLanes)
            {
              HalveAngles(*ground, peer, { i, j }, 360.0 * k / kDirections, accuracy,
                theirs.data() + j * width + i);
            }
          }
        });
      for (std::size_t s = 0; s < theirs.size(); ++s)
      {
        apart.push_back(std::abs(theirs[s] - ours[k][s]));
      }
    }
    std::sort(apart.begin(), apart.end());
    std::cout << "Embree to " << accuracy << " degrees: " << spent << " ms, " << spent / taken
              << " times as long; degrees apart, median " << apart[apart.size() / 2] << ", 99 % "
              << apart[apart.size() / 100 * 99] << "\n";
  }
}
}

int main(int argc, char* argv[])
{
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "rays")
  {
    CompareRays(argc > 2 ? std::max(2, std::atoi(argv[2])) : 4096,
      argc > 3 ? std::max(1, std::atoi(argv[3])) : 7);
    return 0;
  }
  if (what == "horizon" && argc > 2)
  {
    CompareHorizons(argv[2]);
    return 0;
  }
  std::cerr << "usage: BenchmarkEmbree rays [SAMPLES [FRAMES]] | horizon DEM\n";
  return 2;
}
