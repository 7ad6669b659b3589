// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How the techniques agree with a ray caster in double precision (core/rays/ReferenceRayCaster.h):
 *
 *   ReportAccuracy [--size WxH] [--techniques T,T,...] [--exaggeration F] HEIGHTS...
 *
 * Defaults: 320x180; equidistant,pyramid; 1. Other techniques: linear, exponential, mesh. Each file
 * is seen by six cameras. Printed for each, and summed for each technique:
 *
 *   agree    share of pixels that agree on hit or miss
 *   misses   pixels with a surface that the technique does not see; extras: the other way round
 *   1e-4, 1e-3  shares of the hits of both whose distances agree to that, relative
 *   largest  largest relative difference of distances among those hits
 *   off      disagreements (misses, extras, hits not within 1e-3) whose ray does not pass a
 * silhouette within 1e-3 of a cell
 *
 * The exit status is 1 if a file cannot be read or a picture not drawn.
 */
#include "core/rays/ReferenceRayCaster.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainDepthPass.h"
#include "vtkTerrainRasterReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

struct Options
{
  int Width = 320;
  int Height = 180;
  double Exaggeration = 1.0;
  std::vector<std::string> Names{ "equidistant", "pyramid" };
  std::vector<std::string> Files;
};

/// What a picture is compared by; see the file's comment.
struct Agreement
{
  std::int64_t Pixels = 0;
  std::int64_t Misses = 0;
  std::int64_t Extras = 0;
  std::int64_t Hits = 0;
  std::int64_t Closest = 0;
  std::int64_t Close = 0;
  std::int64_t Off = 0;
  double Largest = 0.0;

  void Add(const Agreement& other)
  {
    this->Pixels += other.Pixels;
    this->Misses += other.Misses;
    this->Extras += other.Extras;
    this->Hits += other.Hits;
    this->Closest += other.Closest;
    this->Close += other.Close;
    this->Off += other.Off;
    this->Largest = std::max(this->Largest, other.Largest);
  }
};

struct View
{
  const char* Name;
  glm::dvec3 Eye;
  glm::dvec3 FocalPoint;
};

constexpr double kViewAngle = 30.0;
constexpr double kClosestDistance = 1e-4;
constexpr double kCloseDistance = 1e-3;
constexpr double kSilhouetteCells = 1e-3;

Techniques ToTechnique(const std::string& name)
{
  return name == "mesh"     ? Techniques::Mesh
    : name == "linear"      ? Techniques::Linear
    : name == "exponential" ? Techniques::Exponential
    : name == "pyramid"     ? Techniques::Pyramid
                            : Techniques::Equidistant;
}

/// Model position of the surface's sample at, or after, a share of the columns and rows.
template <typename Heights>
glm::dvec3 SurfaceAt(
  const Heights& heights, const terrain::GridGeometry& geometry, double shareX, double shareY)
{
  const auto i0 = static_cast<std::int64_t>(shareX * static_cast<double>(heights.Width - 1));
  const auto j0 = static_cast<std::int64_t>(shareY * static_cast<double>(heights.Height - 1));
  const std::int64_t count = heights.Width * heights.Height;
  for (std::int64_t k = 0; k < count; ++k)
  {
    const std::int64_t index = (heights.Index(i0, j0) + k) % count;
    if (heights.IsValid(index))
    {
      return geometry.ToModel({ index % heights.Width, index / heights.Width },
        static_cast<double>(heights.Samples[index]));
    }
  }
  return geometry.Origin;
}

/// Six cameras: from outside and above; in a valley, along it; straight down; along the summits;
/// from below; between the coarse mesh and the surface.
template <typename Heights>
std::vector<View> MakeViews(
  const Heights& heights, const terrain::GridGeometry& geometry, vtkTerrainCoarseMesh* coarseMesh)
{
  const glm::dvec2 size(static_cast<double>(heights.Width - 1) * geometry.Spacing.x,
    static_cast<double>(heights.Height - 1) * geometry.Spacing.y);
  const double side = std::max(size.x, size.y);
  const double cell = std::min(geometry.Spacing.x, geometry.Spacing.y);
  const double low = geometry.ToModel({ 0, 0 }, coarseMesh->GetHeightRange()[0]).z;
  const double high = geometry.ToModel({ 0, 0 }, coarseMesh->GetHeightRange()[1]).z;
  const double gap = coarseMesh->GetLargestGap() * geometry.Exaggeration;
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const glm::dvec3 south(geometry.Origin.x + 0.5 * size.x, geometry.Origin.y, 0.5 * (low + high));
  const glm::dvec3 middle = south + glm::dvec3(0.0, 0.5 * size.y, 0.0);
  const glm::dvec3 valley = SurfaceAt(heights, geometry, 0.45, 0.42) + 2.0 * cell * up;
  const glm::dvec3 ahead = SurfaceAt(heights, geometry, 0.62, 0.71) + 2.0 * cell * up;
  const glm::dvec3 ground = SurfaceAt(heights, geometry, 0.3, 0.3);
  return { { "oblique", middle + glm::dvec3(-0.3, -1.2, 0.8) * side, middle },
    { "valley", valley, ahead }, { "down", middle + glm::dvec3(0.001, 0.002, 1.5) * side, middle },
    { "grazing",
      glm::dvec3(
        geometry.Origin.x - 0.2 * side, geometry.Origin.y - 0.15 * side, high + 0.01 * side),
      middle },
    { "below", south + glm::dvec3(0.0, -0.3 * side, -0.6 * side - 0.5 * (high - low)), middle },
    { "between", ground + (0.3 * gap + 0.1 * cell) * up, middle } };
}

/// Terrain on the screen, by one technique.
class Drawing
{
public:
  Drawing(const Options& options, vtkTerrainRasterReader* reader, vtkTerrainCoarseMesh* coarseMesh,
    Techniques technique)
  {
    if (technique == Techniques::Mesh)
    {
      this->FullMesh->SetInputConnection(reader->GetOutputPort());
      this->FullMesh->SetCellsPerQuad(1);
      this->FullMesh->PushUpOff();
      this->Mapper->SetInputConnection(this->FullMesh->GetOutputPort());
    }
    else
    {
      this->Mapper->SetInputConnection(coarseMesh->GetOutputPort());
    }
    this->Mapper->SetHeightsConnection(reader->GetOutputPort());
    this->Mapper->SetTechnique(technique);
    this->Mapper->SetVerticalExaggeration(options.Exaggeration);
    vtkNew<vtkActor> actor;
    actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(actor);
    this->Renderer->SetPass(this->Pass);
    this->Window->AddRenderer(this->Renderer);
    this->Window->SetMultiSamples(0);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(options.Width, options.Height);
  }

  ~Drawing()
  {
    this->Renderer->SetPass(nullptr);
  }

  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  /// Distances of all pixels, row 0 on top, and the same camera for the reference; null if nothing
  /// could be drawn.
  bool Draw(const View& view, std::vector<float>& distances, terrain::ReferenceCamera& reference)
  {
    const int* size = this->Window->GetSize();
    const glm::dvec3 up(0.0, 0.01, 1.0);
    reference =
      terrain::MakeReferenceCamera(view.Eye, view.FocalPoint, up, kViewAngle, size[0], size[1]);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(view.Eye.x, view.Eye.y, view.Eye.z);
    camera->SetFocalPoint(view.FocalPoint.x, view.FocalPoint.y, view.FocalPoint.z);
    camera->SetViewUp(up.x, up.y, up.z);
    camera->SetViewAngle(kViewAngle);
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
    reference.Near = camera->GetClippingRange()[0];
    reference.Far = camera->GetClippingRange()[1];

    vtkImageData* image = this->Pass->GetDistances();
    auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
    if (!values || values->GetNumberOfValues() != reference.Width * reference.Height)
    {
      return false;
    }
    distances.resize(reference.Width * reference.Height);
    for (std::int64_t y = 0; y < reference.Height; ++y)
    {
      const float* row = values->GetPointer(reference.Width * (reference.Height - 1 - y));
      std::copy(row, row + reference.Width, distances.begin() + reference.Width * y);
    }
    return true;
  }

private:
  vtkNew<vtkTerrainCoarseMesh> FullMesh;
  vtkNew<vtkOpenGLTerrainMapper> Mapper;
  vtkNew<vtkTerrainDepthPass> Pass;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

/// Compares one pixel.
template <typename T>
void AddPixel(const terrain::ReferenceRayCaster<T>& caster, const terrain::ReferenceRay& ray,
  double distance, Agreement& agreement)
{
  const terrain::ReferenceHit hit = caster.Cast(ray);
  const bool drawn = !std::isnan(distance);
  ++agreement.Pixels;
  bool agrees = hit.Found == drawn;
  agreement.Misses += hit.Found && !drawn ? 1 : 0;
  agreement.Extras += drawn && !hit.Found ? 1 : 0;
  if (hit.Found && drawn)
  {
    const double difference = std::abs(distance - hit.Distance) / hit.Distance;
    agrees = difference <= kCloseDistance;
    ++agreement.Hits;
    agreement.Closest += difference <= kClosestDistance ? 1 : 0;
    agreement.Close += agrees ? 1 : 0;
    agreement.Largest = std::max(agreement.Largest, difference);
  }
  agreement.Off += agrees || caster.IsNearSilhouette(ray, kSilhouetteCells) ? 0 : 1;
}

template <typename T>
Agreement Compare(const terrain::ReferenceRayCaster<T>& caster,
  const terrain::ReferenceCamera& camera, const std::vector<float>& distances)
{
  std::vector<Agreement> rows(camera.Height);
  terrain::SMPParallelFor(camera.Height,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t y = begin; y < end; ++y)
      {
        for (std::int64_t x = 0; x < camera.Width; ++x)
        {
          AddPixel(caster, camera.PixelRay(x, y),
            static_cast<double>(distances[x + camera.Width * y]), rows[y]);
        }
      }
    });
  Agreement sum;
  for (const Agreement& row : rows)
  {
    sum.Add(row);
  }
  return sum;
}

double Percent(std::int64_t part, std::int64_t whole)
{
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 100.0;
}

void Print(const std::string& technique, const char* view, const Agreement& a)
{
  std::printf("%-12s %-8s %9.4f %7lld %7lld %9lld %9.4f %9.4f %10.2e %6lld\n", technique.c_str(),
    view, Percent(a.Pixels - a.Misses - a.Extras, a.Pixels), static_cast<long long>(a.Misses),
    static_cast<long long>(a.Extras), static_cast<long long>(a.Hits), Percent(a.Closest, a.Hits),
    Percent(a.Close, a.Hits), a.Largest, static_cast<long long>(a.Off));
  std::fflush(stdout);
}

template <typename Heights>
bool ReportHeights(const Options& options, const Heights& heights,
  const terrain::GridGeometry& geometry, vtkTerrainRasterReader* reader,
  vtkTerrainCoarseMesh* coarseMesh)
{
  using T = std::remove_cv_t<std::remove_reference_t<decltype(heights.Samples[0])>>;
  const terrain::ReferenceRayCaster<T> caster(heights, geometry, terrain::SMPParallelFor);
  for (const std::string& name : options.Names)
  {
    Drawing drawing(options, reader, coarseMesh, ToTechnique(name));
    Agreement sum;
    for (const View& view : MakeViews(heights, geometry, coarseMesh))
    {
      std::vector<float> distances;
      terrain::ReferenceCamera camera;
      if (!drawing.Draw(view, distances, camera))
      {
        std::fprintf(stderr, "%s: nothing was drawn\n", name.c_str());
        return false;
      }
      const Agreement agreement = Compare(caster, camera, distances);
      Print(name, view.Name, agreement);
      sum.Add(agreement);
    }
    Print(name, "all", sum);
  }
  return true;
}

bool Report(const Options& options, const std::string& file)
{
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(file);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  if (image->GetNumberOfPoints() < 1)
  {
    std::fprintf(stderr, "%s: no heights\n", file.c_str());
    return false;
  }
  vtkNew<vtkTerrainCoarseMesh> coarseMesh;
  coarseMesh->SetInputConnection(reader->GetOutputPort());
  coarseMesh->Update();
  terrain::GridGeometry geometry = terrain::ImageHeights::Geometry(image);
  geometry.Exaggeration = options.Exaggeration;
  const int* size = image->GetDimensions();
  std::printf("\n%s: %d x %d, heights %g to %g, %lld cells a quad, largest gap %g\n",
    file.substr(file.find_last_of('/') + 1).c_str(), size[0], size[1],
    coarseMesh->GetHeightRange()[0], coarseMesh->GetHeightRange()[1],
    static_cast<long long>(coarseMesh->GetEffectiveCellsPerQuad()), coarseMesh->GetLargestGap());
  std::printf("%-12s %-8s %9s %7s %7s %9s %9s %9s %10s %6s\n", "technique", "view", "agree %",
    "misses", "extras", "hits", "1e-4 %", "1e-3 %", "largest", "off");
  bool done = false;
  terrain::ImageHeights::Dispatch(image,
    [&](const auto& heights)
    { done = ReportHeights(options, heights, geometry, reader, coarseMesh); });
  return done;
}

bool Parse(int argc, char* argv[], Options& options)
{
  for (int k = 1; k < argc; ++k)
  {
    const std::string argument = argv[k];
    if (argument.rfind("--", 0) != 0)
    {
      options.Files.push_back(argument);
      continue;
    }
    if (++k >= argc)
    {
      return false;
    }
    std::istringstream value(argv[k]);
    char times = 0;
    if (argument == "--size")
    {
      value >> options.Width >> times >> options.Height;
    }
    else if (argument == "--exaggeration")
    {
      value >> options.Exaggeration;
    }
    else if (argument == "--techniques")
    {
      options.Names.clear();
      for (std::string name; std::getline(value, name, ',');)
      {
        options.Names.push_back(name);
      }
      value.clear();
    }
    else
    {
      return false;
    }
    if (value.fail())
    {
      return false;
    }
  }
  return !options.Files.empty() && options.Width > 0 && options.Height > 0 &&
    options.Exaggeration > 0.0;
}
}

int main(int argc, char* argv[])
{
  Options options;
  if (!Parse(argc, argv, options))
  {
    std::fprintf(stderr,
      "usage: ReportAccuracy [--size WxH] [--techniques T,...] [--exaggeration F] HEIGHTS...\n");
    return EXIT_FAILURE;
  }
  bool done = true;
  for (const std::string& file : options.Files)
  {
    done = Report(options, file) && done;
  }
  return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
