// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A planet by rays, and as VTK draws it without this module: vtkPolyDataMapper of a sphere of
 * triangles with the same samples as vertices.
 *
 *   BenchmarkGlobe rays|mesh COLUMNS     COLUMNS x COLUMNS / 2 samples; a process for each
 *   BenchmarkGlobe errors COLUMNS        of both, in metres
 *
 * Prints seconds from the array of heights to the first picture of 640 x 480 pixels, the median and
 * the extremes of eleven frames about the planet, as time and as processor time of all threads, and
 * the most memory of the process in MiB, of which the array is a part.
 */
#include "../Unit/UnitTestGlobe.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShortArray.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainGlobe.h"
#include "vtkTypeInt64Array.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

namespace
{
constexpr int kFrames = 11;

/// Samples in the middle of cells, the western- and southernmost first.
struct Samples
{
  int Columns;
  int Rows;
  double Step; ///< degrees
  std::vector<short> Heights;

  explicit Samples(int columns)
    : Columns(columns)
    , Rows(columns / 2)
    , Step(360.0 / columns)
  {
    std::vector<double> waves(static_cast<std::size_t>(columns));
    for (int i = 0; i < columns; ++i)
    {
      waves[static_cast<std::size_t>(i)] =
        std::sin(3.0 * this->Step * i * terrain::kDegree) + 0.4 * std::sin(0.5 * i);
    }
    this->Heights.reserve(static_cast<std::size_t>(columns) * this->Rows);
    for (int j = 0; j < this->Rows; ++j)
    {
      const double cosine = std::sin((j + 0.5) * this->Step * terrain::kDegree);
      const double along = cosine * waves[static_cast<std::size_t>(j)];
      for (const double wave : waves)
      {
        this->Heights.push_back(static_cast<short>(1500.0 * cosine * wave + 1000.0 * along));
      }
    }
  }
  double Height(int i, int j) const
  {
    return this->Heights[static_cast<std::size_t>(i % this->Columns) +
      static_cast<std::size_t>(this->Columns) * static_cast<std::size_t>(j)];
  }
  glm::dvec3 Position(int i, int j) const
  {
    return terrain::Ellipsoid().ToPosition({ terrain::kDegree * (-180.0 + (i + 0.5) * this->Step),
      terrain::kDegree * (-90.0 + (j + 0.5) * this->Step), this->Height(i, j) });
  }
};

vtkSmartPointer<vtkActor> MakeRays(Samples& samples)
{
  const vtkNew<vtkShortArray> heights;
  heights->SetArray(samples.Heights.data(), static_cast<vtkIdType>(samples.Heights.size()), 1);
  const vtkNew<vtkImageData> image;
  image->SetDimensions(samples.Columns, samples.Rows, 1);
  image->SetOrigin(-180.0 + 0.5 * samples.Step, -90.0 + 0.5 * samples.Step, 0.0);
  image->SetSpacing(samples.Step, samples.Step, 1.0);
  image->GetPointData()->SetScalars(heights);
  const vtkNew<vtkTerrainGlobe> globe;
  globe->SetInputData(image);
  const vtkNew<vtkTerrainActor> actor;
  actor->SetInputConnection(globe->GetOutputPort());
  return actor;
}

vtkSmartPointer<vtkActor> MakeMesh(const Samples& samples)
{
  const vtkIdType columns = samples.Columns;
  const vtkIdType count = columns * samples.Rows;
  const vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  const vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfValues(count);
  for (vtkIdType k = 0; k < count; ++k)
  {
    const glm::dvec3 position =
      samples.Position(static_cast<int>(k % columns), static_cast<int>(k / columns));
    coordinates->SetTuple(k, &position.x);
    scalars->SetValue(k, samples.Heights[static_cast<std::size_t>(k)]);
  }
  const vtkIdType triangles = 2 * columns * (samples.Rows - 1);
  const vtkNew<vtkTypeInt64Array> corners;
  corners->SetNumberOfValues(3 * triangles);
  const vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(triangles + 1);
  vtkTypeInt64* corner = corners->GetPointer(0);
  for (vtkIdType k = 0; k < columns * (samples.Rows - 1); ++k)
  {
    const vtkIdType next = k % columns == columns - 1 ? k + 1 - columns : k + 1;
    for (const vtkIdType id : { k, next, k + columns, next, next + columns, k + columns })
    {
      *corner++ = id;
    }
  }
  for (vtkIdType k = 0; k <= triangles; ++k)
  {
    offsets->SetValue(k, 3 * k);
  }
  const vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  const vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  const vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetPointData()->SetScalars(scalars);
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetScalarRange(-4000.0, 4000.0);
  const vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  return actor;
}

/// Seconds, and those of the processor.
class Watch
{
public:
  std::array<double, 2> Seconds() const
  {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - this->Begin;
    return { time.count(), static_cast<double>(std::clock() - this->Clock) / CLOCKS_PER_SEC };
  }

private:
  std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now();
  std::clock_t Clock = std::clock();
};

void Measure(const std::string& way, Samples& samples)
{
  const Watch whole;
  const vtkNew<vtkRenderer> renderer;
  renderer->AddActor(way == "mesh" ? MakeMesh(samples) : MakeRays(samples));
  const vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(640, 480);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(2.4e7, 0.0, 8e6);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  window->Render();
  window->WaitForCompletion();
  const std::array<double, 2> first = whole.Seconds();
  std::array<std::vector<double>, 2> frames;
  for (int frame = 0; frame < kFrames; ++frame)
  {
    renderer->GetActiveCamera()->Azimuth(360.0 / kFrames);
    renderer->ResetCameraClippingRange();
    const Watch watch;
    window->Render();
    window->WaitForCompletion();
    const std::array<double, 2> seconds = watch.Seconds();
    frames[0].push_back(seconds[0]);
    frames[1].push_back(seconds[1]);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%s %d x %d: memory %.0f MiB\n", way.c_str(), samples.Columns, samples.Rows,
    static_cast<double>(usage.ru_maxrss) / 1024.0);
  const char* const names[] = { "time", "processor" };
  for (std::size_t k = 0; k < 2; ++k)
  {
    std::sort(frames[k].begin(), frames[k].end());
    std::printf("  %s: first %.3f s, frame %.4f (%.4f to %.4f) s\n", names[k], first[k],
      frames[k][kFrames / 2], frames[k].front(), frames[k].back());
  }
}

/// Height of a mesh at a place over that of the bilinear surface, along the vertical, metres.
double MeshError(const Samples& samples, const glm::ivec2& cell, const glm::dvec2& part)
{
  const auto corner = [&](int i, int j)
  { return glm::dvec3(glm::vec3(samples.Position(cell.x + i, cell.y + j))); };
  const auto height = [&](int i, int j) { return samples.Height(cell.x + i, cell.y + j); };
  const double surface = glm::mix(glm::mix(height(0, 0), height(1, 0), part.x),
    glm::mix(height(0, 1), height(1, 1), part.x), part.y);
  const glm::dvec2 place = terrain::kDegree *
    glm::dvec2(-180.0 + (cell.x + 0.5 + part.x) * samples.Step,
      -90.0 + (cell.y + 0.5 + part.y) * samples.Step);
  const glm::dvec3 foot = terrain::Ellipsoid().ToPosition({ place, 0.0 });
  const glm::dvec3 up = terrain::Ellipsoid().ToPosition({ place, 1.0 }) - foot;
  // each triangle whose prism the vertical meets
  const bool first = part.x + part.y <= 1.0;
  const glm::dvec3 a = first ? corner(0, 0) : corner(1, 0);
  const glm::dvec3 b = first ? corner(1, 0) : corner(1, 1);
  const glm::dvec3 c = corner(0, 1);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  return glm::dot(normal, a - foot) / glm::dot(normal, up) - surface;
}

/// The same of rays in float as shaders cast them, from 1000 km straight above, about an anchor
/// 100 km aside.
double RayError(const terrain::World<std::uint16_t>& world, const terrain::GlobeReference& judge,
  const glm::dvec2& place)
{
  const terrain::Ellipsoid& body = world.Grid.Body;
  const glm::dvec3 foot = body.ToPosition({ place, 0.0 });
  terrain::GlobeReferenceRay ray;
  ray.Direction = foot - body.ToPosition({ place, 1.0 });
  ray.Origin = foot - 1e6 * ray.Direction;
  ray.End = 1.2e6;
  const terrain::WorldTracer<float, std::uint16_t> tracer(world, foot + glm::dvec3(7e4, -5e4, 5e4));
  const auto hit = tracer.Trace(ray);
  const auto expected = judge.Cast(ray);
  return hit.Found && expected.Found ? static_cast<double>(hit.T) - expected.T : terrain::kNaN;
}

void PrintErrors(const Samples& samples)
{
  const int columns = samples.Columns;
  const terrain::TestGlobe globe{ "samples",
    terrain::MakeGrid({}, -180.0 + 0.5 * samples.Step, samples.Step, columns + 1,
      terrain::Parallels(-90.0 + 0.5 * samples.Step, samples.Step, samples.Rows)),
    [&samples](int i, int j) { return samples.Height(i, j); } };
  const terrain::World<std::uint16_t> world(globe.Grid, globe.Field());
  const terrain::GlobeReference judge = world.Reference();
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const bool atPole : { false, true })
  {
    double mesh = 0.0;
    double rays = 0.0;
    constexpr int count = 300;
    for (int k = 0; k < count; ++k)
    {
      const glm::ivec2 cell(static_cast<int>(uniform(generator) * columns),
        atPole ? samples.Rows - 2 - k % 10 : samples.Rows / 4 + k % (samples.Rows / 2));
      const glm::dvec2 part(uniform(generator), uniform(generator));
      mesh = std::max(mesh, std::abs(MeshError(samples, cell, part)));
      rays = std::max(rays,
        std::abs(RayError(world, judge,
          { globe.Grid.West + (cell.x + part.x) * globe.Grid.Step,
            glm::mix(globe.Grid.Latitudes[static_cast<std::size_t>(cell.y)],
              globe.Grid.Latitudes[static_cast<std::size_t>(cell.y) + 1], part.y) })));
    }
    std::printf("%s: mesh %.3f m, rays %.4f m at most\n",
      atPole ? "last ten rows" : "45 degrees south to north", mesh, rays);
  }
}
}

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::fprintf(stderr, "BenchmarkGlobe rays|mesh|errors COLUMNS\n");
    return EXIT_FAILURE;
  }
  const std::string way = argv[1];
  Samples samples(std::max(std::atoi(argv[2]), 16));
  if (way == "errors")
  {
    PrintErrors(samples);
  }
  else
  {
    Measure(way, samples);
  }
  return EXIT_SUCCESS;
}
