// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainStrips.h"

#include "core/Refinement.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainHierarchyData.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTimeStamp.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>

vtkStandardNewMacro(vtkTerrainStrips);

namespace
{
/// All that a mesh depends on.
struct StripJob
{
  std::shared_ptr<const vtkTerrainHierarchyData> Data;
  terrain::RefinementView View;
  terrain::RefinementOptions Options;

  bool operator==(const StripJob& other) const
  {
    return this->Data == other.Data && this->View.Eye == other.View.Eye &&
      this->View.PixelsPerUnit == other.View.PixelsPerUnit &&
      this->View.Parallel == other.View.Parallel &&
      this->View.Exaggeration == other.View.Exaggeration &&
      this->View.Planes == other.View.Planes &&
      this->Options.Tolerance == other.Options.Tolerance &&
      this->Options.TriangleBudget == other.Options.TriangleBudget &&
      this->Options.Method == other.Options.Method &&
      this->Options.Culling == other.Options.Culling &&
      this->Options.Morphing == other.Options.Morphing;
  }
};

/// Refines jobs; keeps the refiner of the last hierarchy.
class StripBuilder
{
public:
  void Build(const StripJob& job, terrain::StripMesh& mesh)
  {
    if (!this->Refiner || this->Data != job.Data)
    {
      this->Refiner = std::make_unique<terrain::Refiner>(job.Data->View());
      this->Data = job.Data;
    }
    this->Refiner->Refine(job.View, job.Options, mesh);
  }

private:
  std::shared_ptr<const vtkTerrainHierarchyData> Data;
  std::unique_ptr<terrain::Refiner> Refiner;
};

terrain::RefinementView ViewOf(vtkCamera* camera, const int size[2], double exaggeration)
{
  terrain::RefinementView view;
  const double* eye = camera->GetPosition();
  view.Eye = { eye[0], eye[1], eye[2] };
  view.Exaggeration = exaggeration;
  view.Parallel = camera->GetParallelProjection() != 0;
  const double aspect = static_cast<double>(size[0]) / size[1];
  if (view.Parallel)
  {
    view.PixelsPerUnit = size[1] / (2.0 * camera->GetParallelScale());
  }
  else
  {
    const double half = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    const double tangentY = camera->GetUseHorizontalViewAngle() != 0 ? half / aspect : half;
    const double tangentX = aspect * tangentY;
    // A length at an angle from the middle of the picture, and as far from the eye, is drawn up to
    // 1 / cos^2 = 1 + tan^2 of it longer; most so in the corners.
    const double stretch = 1.0 + tangentX * tangentX + tangentY * tangentY;
    view.PixelsPerUnit = stretch * size[1] / (2.0 * tangentY);
  }
  // Left, right, bottom and top; near and far planes depend on what is drawn.
  double planes[24];
  camera->GetFrustumPlanes(aspect, planes);
  for (int i = 0; i < 4; ++i)
  {
    const double* plane = planes + std::ptrdiff_t{ 4 } * i;
    view.Planes.emplace_back(plane[0], plane[1], plane[2], plane[3]);
  }
  return view;
}

/// Colour of a depth: neighbouring depths differ clearly, hues repeat after twelve.
void DepthColor(int depth, unsigned char* color)
{
  double rgb[3];
  const double hue = std::fmod(0.137 + 0.4166666667 * depth, 1.0);
  vtkMath::HSVToRGB(
    hue, (depth & 1) != 0 ? 0.55 : 0.85, (depth & 1) != 0 ? 1.0 : 0.8, rgb, rgb + 1, rgb + 2);
  for (int i = 0; i < 3; ++i)
  {
    color[i] = static_cast<unsigned char>(std::lround(255.0 * rgb[i]));
  }
}
}

/// The thread and what it shares with the filter. Members below Mutex are guarded by it.
struct vtkTerrainStrips::Internals
{
  StripBuilder Builder;
  terrain::StripMesh Mesh;
  StripJob MeshJob;
  bool HasMesh = false;
  vtkSmartPointer<vtkTerrainHierarchy> Prepared;
  vtkTimeStamp PreparedTime;
  vtkImageData* PreparedImage = nullptr;

  std::thread Worker;
  std::mutex Mutex;
  std::condition_variable Wake;
  StripJob Wanted;
  StripJob Finished;
  terrain::StripMesh FinishedMesh;
  bool HasWanted = false;
  bool HasFinished = false;
  bool Working = false;
  bool Stop = false;
  vtkTimeStamp FinishedTime;

  ~Internals()
  {
    if (this->Worker.joinable())
    {
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        this->Stop = true;
      }
      this->Wake.notify_one();
      this->Worker.join();
    }
  }

  /// What the thread does: the newest job, again and again.
  void Work()
  {
    StripBuilder builder;
    terrain::StripMesh mesh;
    std::unique_lock<std::mutex> lock(this->Mutex);
    for (;;)
    {
      this->Wake.wait(lock, [this] { return this->Stop || this->HasWanted; });
      if (this->Stop)
      {
        return;
      }
      const StripJob job = this->Wanted;
      this->HasWanted = false;
      this->Working = true;
      lock.unlock();
      builder.Build(job, mesh);
      lock.lock();
      this->Working = false;
      std::swap(this->FinishedMesh, mesh);
      this->Finished = job;
      this->HasFinished = true;
      this->FinishedTime.Modified();
    }
  }

  /// Takes a finished mesh, and asks for the job's unless it is there. Never waits for refinement.
  void Exchange(const StripJob& job)
  {
    if (!this->Worker.joinable())
    {
      this->Worker = std::thread([this] { this->Work(); });
    }
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->HasFinished)
    {
      std::swap(this->Mesh, this->FinishedMesh);
      this->MeshJob = this->Finished;
      this->HasMesh = true;
      this->HasFinished = false;
    }
    if (!this->HasMesh || !(this->MeshJob == job))
    {
      this->Wanted = job;
      this->HasWanted = true;
      this->Wake.notify_one();
    }
  }
};

vtkTerrainStrips::vtkTerrainStrips()
  : Private(std::make_unique<Internals>())
{
}

vtkTerrainStrips::~vtkTerrainStrips() = default;

void vtkTerrainStrips::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Hierarchy: " << this->Hierarchy.Get() << "\n"
     << indent << "Camera: " << this->Camera.Get() << "\n"
     << indent << "ViewportSize: " << this->ViewportSize[0] << " x " << this->ViewportSize[1]
     << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "TriangleBudget: " << this->TriangleBudget << "\n"
     << indent << "Exaggeration: " << this->Exaggeration << "\n"
     << indent << "Morphing: " << this->Morphing << "\n"
     << indent << "Culling: " << static_cast<int>(this->Culling) << "\n"
     << indent << "PlainRefinement: " << this->PlainRefinement << "\n"
     << indent << "Normals: " << this->Normals << "\n"
     << indent << "TextureCoordinates: " << this->TextureCoordinates << "\n"
     << indent << "LevelColors: " << this->LevelColors << "\n"
     << indent << "TriangleOutput: " << this->TriangleOutput << "\n"
     << indent << "Asynchronous: " << this->Asynchronous << "\n"
     << indent << "UsedTolerance: " << this->UsedTolerance << "\n"
     << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
}

void vtkTerrainStrips::SetHierarchy(vtkTerrainHierarchy* hierarchy)
{
  if (this->Hierarchy != hierarchy)
  {
    this->Hierarchy = hierarchy;
    this->Modified();
  }
}

vtkTerrainHierarchy* vtkTerrainStrips::GetHierarchy()
{
  return this->Hierarchy;
}

void vtkTerrainStrips::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

vtkCamera* vtkTerrainStrips::GetCamera()
{
  return this->Camera;
}

void vtkTerrainStrips::SetCulling(CullingMode mode)
{
  if (this->Culling != mode)
  {
    this->Culling = mode;
    this->Modified();
  }
}

vtkMTimeType vtkTerrainStrips::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Camera)
  {
    time = std::max(time, this->Camera->GetMTime());
  }
  if (this->Hierarchy)
  {
    time = std::max(time, this->Hierarchy->GetMTime());
  }
  if (this->Asynchronous)
  {
    const std::lock_guard<std::mutex> lock(this->Private->Mutex);
    time = std::max(time, this->Private->FinishedTime.GetMTime());
  }
  return time;
}

bool vtkTerrainStrips::IsBuilding()
{
  const std::lock_guard<std::mutex> lock(this->Private->Mutex);
  return this->Private->HasWanted || this->Private->Working || this->Private->HasFinished;
}

int vtkTerrainStrips::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

/// Prepares the image of port 0 unless that is done, or there is a hierarchy.
bool vtkTerrainStrips::PrepareInput(vtkInformationVector* input)
{
  if (this->Hierarchy)
  {
    this->Private->Prepared = this->Hierarchy;
    this->Private->PreparedImage = nullptr;
    return true;
  }
  vtkImageData* image = vtkImageData::GetData(input);
  if (!image)
  {
    vtkErrorMacro("Neither a hierarchy nor heights are given.");
    return false;
  }
  Internals& internals = *this->Private;
  if (image != internals.PreparedImage || internals.PreparedTime.GetMTime() < image->GetMTime())
  {
    internals.Prepared = vtkSmartPointer<vtkTerrainHierarchy>::New();
    internals.PreparedImage = nullptr;
    if (!internals.Prepared->SetHeights(image))
    {
      vtkErrorMacro("No hierarchy: " << internals.Prepared->GetErrorMessage() << ".");
      return false;
    }
    internals.PreparedImage = image;
    internals.PreparedTime.Modified();
  }
  return true;
}

namespace
{
/// What the output has besides points and strip.
struct OutputOptions
{
  double Exaggeration;
  bool Normals;
  bool TextureCoordinates;
  bool LevelColors;
  bool TriangleOutput;
};

void AddPoints(
  const terrain::StripMesh& mesh, const terrain::GridGeometry& geometry, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Vertices.size()));
  auto* positions = static_cast<double*>(points->GetVoidPointer(0));
  for (const terrain::StripVertex& vertex : mesh.Vertices)
  {
    const glm::dvec3 position = geometry.ToModel(
      { vertex.Column, vertex.Row }, static_cast<double>(vertex.Height) + vertex.Displacement);
    positions = std::copy_n(&position.x, 3, positions);
  }
  output->SetPoints(points);
}

/// Cells of the output: one strip, or its triangles that are not degenerate.
void AddCells(const terrain::StripMesh& mesh, bool triangles, vtkPolyData* output)
{
  vtkNew<vtkCellArray> cells;
  const std::vector<std::uint32_t>& strip = mesh.Strip;
  if (!triangles && strip.size() >= 3)
  {
    cells->AllocateExact(1, static_cast<vtkIdType>(strip.size()));
    cells->InsertNextCell(static_cast<int>(strip.size()));
    for (const std::uint32_t index : strip)
    {
      cells->InsertCellPoint(index);
    }
  }
  if (triangles)
  {
    cells->AllocateExact(mesh.Triangles, 3 * mesh.Triangles);
    for (std::size_t i = 2; i < strip.size(); ++i)
    {
      vtkIdType corners[3] = { strip[i - 2], strip[i - 1], strip[i] };
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[0] != corners[2])
      {
        if ((i & 1) != 0)
        {
          std::swap(corners[0], corners[1]);
        }
        cells->InsertNextCell(3, corners);
      }
    }
    output->SetPolys(cells);
    return;
  }
  output->SetStrips(cells);
}

void AddNormals(const terrain::StripMesh& mesh, const terrain::HierarchyView& hierarchy,
  double exaggeration, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Vertices.size()));
  float* out = normals->GetPointer(0);
  for (const terrain::StripVertex& vertex : mesh.Vertices)
  {
    const terrain::HierarchyGradient gradient = vertex.Record >= terrain::StripVertex::NoRecord
      ? hierarchy.Summary.CornerGradients[vertex.Record - terrain::StripVertex::NoRecord]
      : hierarchy.Gradients[vertex.Record];
    const glm::dvec3 normal =
      glm::normalize(glm::dvec3(-exaggeration * gradient.X(), -exaggeration * gradient.Y(), 1.0));
    for (int i = 0; i < 3; ++i)
    {
      *out++ = static_cast<float>(normal[i]);
    }
  }
  output->GetPointData()->SetNormals(normals);
}

void AddTextureCoordinates(
  const terrain::StripMesh& mesh, const terrain::HierarchyLayout& layout, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Vertices.size()));
  float* out = coordinates->GetPointer(0);
  const double width = std::max<double>(1.0, static_cast<double>(layout.Width() - 1));
  const double height = std::max<double>(1.0, static_cast<double>(layout.Height() - 1));
  for (const terrain::StripVertex& vertex : mesh.Vertices)
  {
    *out++ = static_cast<float>(vertex.Column / width);
    *out++ = static_cast<float>(vertex.Row / height);
  }
  output->GetPointData()->SetTCoords(coordinates);
}

void AddDepthColors(
  const terrain::StripMesh& mesh, const terrain::HierarchyLayout& layout, vtkPolyData* output)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Depth");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Vertices.size()));
  unsigned char* out = colors->GetPointer(0);
  for (const terrain::StripVertex& vertex : mesh.Vertices)
  {
    const bool isCorner = vertex.Record >= terrain::StripVertex::NoRecord;
    DepthColor(isCorner ? 0 : layout.DepthOf(vertex.Record), out);
    out += 3;
  }
  output->GetPointData()->SetScalars(colors);
}

void FillOutput(const terrain::StripMesh& mesh, const terrain::HierarchyView& hierarchy,
  const OutputOptions& options, vtkPolyData* output)
{
  terrain::GridGeometry geometry = hierarchy.Geometry;
  geometry.Exaggeration = options.Exaggeration;
  AddPoints(mesh, geometry, output);
  AddCells(mesh, options.TriangleOutput, output);
  if (options.Normals)
  {
    AddNormals(mesh, hierarchy, options.Exaggeration, output);
  }
  if (options.TextureCoordinates)
  {
    AddTextureCoordinates(mesh, *hierarchy.Layout, output);
  }
  if (options.LevelColors)
  {
    AddDepthColors(mesh, *hierarchy.Layout, output);
  }
}
}

int vtkTerrainStrips::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfTriangles = 0;
  if (!this->Camera)
  {
    vtkErrorMacro("No camera is given.");
    return 0;
  }
  if (this->ViewportSize[0] < 1 || this->ViewportSize[1] < 1)
  {
    vtkErrorMacro("The viewport must have pixels, it has " << this->ViewportSize[0] << " x "
                                                           << this->ViewportSize[1] << ".");
    return 0;
  }
  if (!this->PrepareInput(inputVector[0]))
  {
    return 0;
  }
  Internals& internals = *this->Private;
  StripJob job;
  job.Data = internals.Prepared->GetData();
  if (!job.Data)
  {
    vtkErrorMacro("The hierarchy is empty.");
    return 0;
  }
  job.View = ViewOf(this->Camera, this->ViewportSize, this->Exaggeration);
  job.Options.Tolerance = this->Tolerance;
  job.Options.TriangleBudget = this->TriangleBudget;
  job.Options.Morphing = this->Morphing;
  job.Options.Culling = static_cast<terrain::CullingMethod>(this->Culling);
  job.Options.Method =
    this->PlainRefinement ? terrain::RefinementMethod::Plain : terrain::RefinementMethod::Improved;
  const std::string error = terrain::Refiner::WhyNotRefine(job.View, job.Options);
  if (!error.empty())
  {
    vtkErrorMacro("Cannot refine: " << error << ".");
    return 0;
  }
  if (this->Asynchronous)
  {
    internals.Exchange(job);
  }
  else
  {
    internals.Builder.Build(job, internals.Mesh);
    internals.MeshJob = job;
    internals.HasMesh = true;
  }
  if (!internals.HasMesh)
  {
    return 1;
  }
  FillOutput(internals.Mesh, internals.MeshJob.Data->View(),
    { internals.MeshJob.View.Exaggeration, this->Normals, this->TextureCoordinates,
      this->LevelColors, this->TriangleOutput },
    vtkPolyData::GetData(outputVector));
  if (internals.MeshJob.Data->IsDamaged())
  {
    internals.HasMesh = false;
    vtkPolyData::GetData(outputVector)->Initialize();
    vtkErrorMacro("The hierarchy's file has lost data since it was opened.");
    return 0;
  }
  this->NumberOfTriangles = internals.Mesh.Triangles;
  this->UsedTolerance = internals.Mesh.Tolerance;
  return 1;
}
