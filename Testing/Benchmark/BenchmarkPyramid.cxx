// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The min-max pyramid and its traversal on the CPU:
 *
 *   BenchmarkPyramid [SAMPLES [START]]     default 4097 5
 *
 * over a procedural landscape of SAMPLES x SAMPLES, START being the level of the first node.
 * Printed are the time to build the pyramid (the best of five, by the clock and as the processor
 * time of all threads); then for views that
 * fly and views that walk, 640 x 480 rays each, the spectrum of nodes visited a ray (Park & Oh,
 * figure 13: the part of rays within 16 and 35 and beyond 85), the mean over groups of 4 x 2 pixels
 * of the slowest ray's, and million rays a second on one thread; and the same when the rays of
 * tiles of K x K pixels start where a beam for the tile ends, with the beam's steps a pixel.
 */
#include "core/rays/PyramidBeam.h"

#include "core/landscape/ProceduralTerrain.h"
#include "data/SMPParallelFor.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;
using Texel = std::uint16_t;

constexpr int PixelsX = 640;
constexpr int PixelsY = 480;
constexpr double Relief = 2500.0;
constexpr double Length = 16.0 * Relief;
constexpr double CodesPerMetre = 10.0;
constexpr double Near = 1.0;
constexpr double Far = 1e6;

double SecondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct Landscape
{
  int Samples = 0;
  std::vector<Texel> Texels;
  terrain::MinMaxPyramid<Texel> Pyramid;
  terrain::CodedPyramid<Texel> Coded;

  explicit Landscape(int samples)
    : Samples(samples)
    , Texels(static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples))
  {
    terrain::ProceduralTerrainParameters parameters;
    parameters.Width = parameters.Height = samples;
    parameters.Relief = Relief;
    std::vector<float> heights(this->Texels.size());
    terrain::ProceduralTerrain(parameters)
      .Sample(0, 0, samples, samples, heights.data(), terrain::SMPParallelFor);
    std::transform(heights.begin(), heights.end(), this->Texels.begin(),
      [](float height) { return static_cast<Texel>(height * CodesPerMetre); });
    const Texel highest = *std::max_element(this->Texels.begin(), this->Texels.end());
    this->Coded.heights = { this->Texels.data(), { samples, samples }, 0,
      static_cast<float>(highest) };
    this->Coded.pyramid = &this->Pyramid;
  }
  void Build()
  {
    terrain::HeightfieldView<Texel> view;
    view.Samples = this->Texels.data();
    view.Width = view.Height = this->Samples;
    this->Pyramid.Build(view, terrain::SMPParallelFor);
  }
  double Spacing() const
  {
    return Length / (this->Samples - 1);
  }
  /// Position in metres at parts of the length, metres above the ground.
  glm::dvec3 AboveGround(double x, double y, double height) const
  {
    const int i = static_cast<int>(x * (this->Samples - 1));
    const int j = static_cast<int>(y * (this->Samples - 1));
    const auto index = static_cast<std::size_t>(i) +
      static_cast<std::size_t>(j) * static_cast<std::size_t>(this->Samples);
    return { x * Length, y * Length, this->Texels[index] / CodesPerMetre + height };
  }
};

/// A view of a landscape; position(s) = Eye + s * (Corner + x * East + y * Up) in grid coordinates.
struct View
{
  const char* Name = "";
  glm::dvec3 Eye{};
  glm::dvec3 Corner{};
  glm::dvec3 East{};
  glm::dvec3 Up{};

  View(const Landscape& landscape, const char* name, const glm::dvec3& eye, const glm::dvec3& focal,
    double angle)
    : Name(name)
  {
    const glm::dvec3 forward = glm::normalize(focal - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 0.0, 1.0)));
    const double pixel = 2.0 * std::tan(glm::radians(angle) / 2.0) / PixelsY;
    const glm::dvec3 toGrid(1.0 / landscape.Spacing(), 1.0 / landscape.Spacing(), CodesPerMetre);
    this->Eye = eye * toGrid;
    this->East = pixel * right * toGrid;
    this->Up = pixel * glm::cross(right, forward) * toGrid;
    this->Corner = forward * toGrid - 0.5 * PixelsX * this->East - 0.5 * PixelsY * this->Up;
  }
  terrain::TerrainRay Ray(double x, double y, double start) const
  {
    const glm::dvec3 direction = this->Corner + x * this->East + y * this->Up;
    const glm::dvec3 begin = this->Eye + start * direction;
    terrain::TerrainRay ray;
    ray.anchorCell = glm::ivec2(glm::floor(glm::dvec2(begin)));
    ray.originGC = glm::vec3(begin - glm::dvec3(ray.anchorCell.x, ray.anchorCell.y, 0.0));
    ray.directionGC = glm::vec3(direction);
    ray.sEnd = static_cast<float>(Far - start);
    return ray;
  }
  terrain::TerrainBeam Beam(double x, double y, double half) const
  {
    const glm::dvec3 growth = half * (glm::abs(this->East) + glm::abs(this->Up));
    return { this->Ray(x, y, Near), glm::vec3(Near * growth), glm::vec3(growth) };
  }
};

std::vector<View> MakeViews(const Landscape& landscape)
{
  const glm::dvec3 valley = landscape.AboveGround(0.52, 0.31, 2.0);
  const glm::dvec3 slope = landscape.AboveGround(0.33, 0.62, 2.0);
  const glm::dvec3 tower = landscape.AboveGround(0.7, 0.45, 30.0);
  const auto at = [](double x, double y, double z)
  { return glm::dvec3(x * Length, y * Length, z); };
  return { View(landscape, "fly outside", at(-0.2, -0.2, 14e3), at(0.5, 0.5, 0.0), 30.0),
    View(landscape, "fly oblique", at(0.1, 0.1, 5500.0), at(0.5, 0.55, 800.0), 45.0),
    View(landscape, "fly down", at(0.5, 0.5, 9e3), at(0.5, 0.501, 0.0), 60.0),
    View(landscape, "fly low", at(0.2, 0.3, 3200.0), at(0.8, 0.6, 1500.0), 45.0),
    View(landscape, "walk valley", valley, valley + glm::dvec3(1.0, 0.4, 0.02), 50.0),
    View(landscape, "walk slope", slope, slope + glm::dvec3(-0.3, 1.0, -0.01), 50.0),
    View(landscape, "walk tower", tower, tower + glm::dvec3(-0.9, -0.2, -0.03), 50.0) };
}

/// Nodes visited by every ray of a view, in tiles of K x K pixels with a beam each, 0 for none.
struct Spectrum
{
  std::vector<int> Visits = std::vector<int>(std::size_t{ PixelsX } * PixelsY);
  int kBeamSteps = 0;
  double Seconds = 0.0;

  Spectrum(const Landscape& landscape, const View& view, int tile)
  {
    const terrain::PyramidBeam<Texel> beams(landscape.Coded);
    const int side = std::max(tile, 1);
    const Clock::time_point begin = Clock::now();
    for (int y = 0; y < PixelsY; y += side)
    {
      for (int x = 0; x < PixelsX; x += side)
      {
        const double half = 0.5 * side;
        const double start = tile == 0
          ? Near
          : Near + beams.BeamStart(view.Beam(x + half, y + half, half), this->kBeamSteps);
        for (int k = 0; k < side * side && start < Far; ++k)
        {
          const int i = x + k % side;
          const int j = y + k / side;
          this->Visits[static_cast<std::size_t>(j) * PixelsX + static_cast<std::size_t>(i)] =
            landscape.Coded.TracePyramid(view.Ray(i + 0.5, j + 0.5, start)).crossings;
        }
      }
    }
    this->Seconds = SecondsSince(begin);
  }

  double PercentWithin(int visits) const
  {
    const auto within = std::count_if(
      this->Visits.begin(), this->Visits.end(), [=](int value) { return value <= visits; });
    return 100.0 * static_cast<double>(within) / static_cast<double>(this->Visits.size());
  }
  double Mean() const
  {
    double sum = 0.0;
    for (const int value : this->Visits)
    {
      sum += value;
    }
    return sum / static_cast<double>(this->Visits.size());
  }
  /// Mean of the most visits in groups of 4 x 2 pixels, which processors handle together.
  double MeanOfGroups() const
  {
    double sum = 0.0;
    for (int y = 0; y < PixelsY; y += 2)
    {
      for (int x = 0; x < PixelsX; x += 4)
      {
        int most = 0;
        for (int k = 0; k < 8; ++k)
        {
          const int pixel = x + k % 4 + PixelsX * (y + (k > 3 ? 1 : 0));
          most = std::max(most, this->Visits[static_cast<std::size_t>(pixel)]);
        }
        sum += most;
      }
    }
    return sum * 8.0 / (PixelsX * PixelsY);
  }
};

void PrintViews(Landscape& landscape, int start)
{
  for (const View& view : MakeViews(landscape))
  {
    for (const int tile : { 0, 4, 8, 16 })
    {
      landscape.Coded.start = tile == 0 ? start : 2;
      const Spectrum spectrum(landscape, view, tile);
      std::printf("%-12s tile %2d  mean %5.1f  groups of 8 %5.1f  within 16 %5.1f %%  within 35 "
                  "%5.1f %%  over 85 %4.1f %%  beam %4.2f  %5.2f Mrays/s\n",
        view.Name, tile, spectrum.Mean(), spectrum.MeanOfGroups(), spectrum.PercentWithin(16),
        spectrum.PercentWithin(35), 100.0 - spectrum.PercentWithin(85),
        static_cast<double>(spectrum.kBeamSteps) / (PixelsX * PixelsY),
        1e-6 * PixelsX * PixelsY / spectrum.Seconds);
    }
  }
}
}

int main(int argc, char* argv[])
{
  const int samples = argc > 1 ? std::atoi(argv[1]) : 4097;
  const int start = argc > 2 ? std::atoi(argv[2]) : 5;
  if (samples < 2 || start < 1)
  {
    std::fprintf(stderr, "usage: %s [SAMPLES >= 2 [START >= 1]]\n", argv[0]);
    return 2;
  }
  Landscape landscape(samples);
  double best = 1e9;
  double leastWork = 1e9;
  for (int trial = 0; trial < 5; ++trial)
  {
    const std::clock_t cpu = std::clock();
    const Clock::time_point begin = Clock::now();
    landscape.Build();
    leastWork = std::min(leastWork, static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC);
    best = std::min(best, SecondsSince(begin));
  }
  std::printf("%d x %d samples of 16 bits: pyramid of %d levels, %.1f MB, built in %.3f s, %.3f s "
              "of all threads\n",
    samples, samples, landscape.Pyramid.LevelCount(),
    1e-6 * static_cast<double>(landscape.Pyramid.MemorySize()), best, leastWork);
  PrintViews(landscape, start);
  return 0;
}
