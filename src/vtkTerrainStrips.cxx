// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainStrips.h"

#include "core/strips/Refinement.h"
#include "core/surface/DetailHeights.h"
#include "data/HierarchyData.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"
#include "data/StripsOutput.h"
#include "vtkTerrainHierarchy.h"

#include "vtkCamera.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimeStamp.h"

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
  std::shared_ptr<const terrain::HierarchyData> Data;
  /// None without detail.
  std::shared_ptr<const terrain::DetailHierarchy> Detail;
  terrain::RefinementView View;
  terrain::RefinementOptions Options;

  bool operator==(const StripJob& other) const
  {
    return this->Data == other.Data && this->Detail == other.Detail &&
      this->View.DetailScale == other.View.DetailScale && this->View.Eye == other.View.Eye &&
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
    if (!this->Refiner || this->Data != job.Data || this->Detail != job.Detail)
    {
      this->Refiner = std::make_unique<terrain::Refiner>(
        job.Data->View(), job.Detail.get(), terrain::SMPParallelFor);
      this->Data = job.Data;
      this->Detail = job.Detail;
    }
    this->Refiner->Refine(job.View, job.Options, mesh);
  }

private:
  std::shared_ptr<const terrain::HierarchyData> Data;
  std::shared_ptr<const terrain::DetailHierarchy> Detail;
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

/// True if this is one of several pieces of the terrain, and has no samples.
bool IsEmptyPiece(vtkInformationVector* input, vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkImageData* image = vtkImageData::GetData(input);
  vtkInformation* info = output->GetInformationObject(0);
  return image && image->GetNumberOfPoints() == 0 &&
    info->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) &&
    info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1;
}

/// Heights of an image as float, none if a sample has no height.
std::vector<float> HeightsOf(vtkImageData* image)
{
  std::vector<float> heights;
  terrain::ImageHeights::Dispatch(image,
    [&heights](const auto& view)
    {
      heights.reserve(static_cast<std::size_t>(view.Width * view.Height));
      for (std::int64_t j = 0; j < view.Height; ++j)
      {
        for (std::int64_t i = 0; i < view.Width; ++i)
        {
          heights.push_back(static_cast<float>(view.At(i, j)));
        }
      }
    });
  const bool complete =
    std::all_of(heights.begin(), heights.end(), [](float height) { return std::isfinite(height); });
  return complete ? heights : std::vector<float>();
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
  std::shared_ptr<const terrain::DetailHierarchy> Detail;
  vtkTimeStamp DetailTime;
  vtkImageData* DetailImage = nullptr;

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
  this->SetNumberOfInputPorts(2);
}

vtkTerrainStrips::~vtkTerrainStrips() = default;

void vtkTerrainStrips::SetLevelColors(bool colors)
{
  vtkWarningMacro("SetLevelColors() is now called SetDepthColors()");
  this->SetDepthColors(colors);
}

bool vtkTerrainStrips::GetLevelColors()
{
  vtkWarningMacro("GetLevelColors() is now called GetDepthColors()");
  return this->DepthColors;
}

void vtkTerrainStrips::LevelColorsOn()
{
  this->SetLevelColors(true);
}

void vtkTerrainStrips::LevelColorsOff()
{
  this->SetLevelColors(false);
}

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
     << indent << "PointExaggeration: " << this->PointExaggeration << "\n"
     << indent << "KeepBorder: " << this->KeepBorder << "\n"
     << indent << "DetailCells: " << this->DetailCells << "\n"
     << indent << "DetailScale: " << this->DetailScale << "\n"
     << indent << "Morphing: " << this->Morphing << "\n"
     << indent << "Culling: " << static_cast<int>(this->Culling) << "\n"
     << indent << "PlainRefinement: " << this->PlainRefinement << "\n"
     << indent << "Normals: " << this->Normals << "\n"
     << indent << "TextureCoordinates: " << this->TextureCoordinates << "\n"
     << indent << "DepthColors: " << this->DepthColors << "\n"
     << indent << "HeightScalars: " << this->HeightScalars << "\n"
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

void vtkTerrainStrips::SetDetailData(vtkImageData* detail)
{
  this->SetInputDataInternal(1, detail);
}

vtkImageData* vtkTerrainStrips::GetDetail()
{
  return this->GetNumberOfInputConnections(1) > 0
    ? vtkImageData::SafeDownCast(this->GetExecutive()->GetInputData(1, 0))
    : nullptr;
}

void vtkTerrainStrips::SetDetailCells(int cells)
{
  if (cells < 1 || cells > MostDetailCells || (cells & (cells - 1)) != 0)
  {
    vtkErrorMacro("DetailCells must be a power of two from 1 to " << MostDetailCells << ", not "
                                                                  << cells << ".");
    return;
  }
  if (this->DetailCells != cells)
  {
    this->DetailCells = cells;
    this->Modified();
  }
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
  if (image != internals.PreparedImage || internals.PreparedTime.GetMTime() < image->GetMTime() ||
    internals.Prepared->GetKeepBorder() != this->KeepBorder)
  {
    internals.Prepared = vtkSmartPointer<vtkTerrainHierarchy>::New();
    internals.Prepared->SetKeepBorder(this->KeepBorder);
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

/// Prepares the image of port 1, if there is one, unless that is done.
bool vtkTerrainStrips::PrepareDetail(vtkInformationVector* input)
{
  Internals& internals = *this->Private;
  vtkImageData* image = vtkImageData::GetData(input);
  const int level = terrain::LevelOfCells(this->DetailCells);
  if (image && internals.Detail && image == internals.DetailImage &&
    internals.Detail->Level() == level && internals.DetailTime.GetMTime() >= image->GetMTime())
  {
    return true;
  }
  internals.Detail.reset();
  internals.DetailImage = nullptr;
  if (!image)
  {
    return true;
  }
  auto detail = std::make_shared<terrain::DetailHierarchy>();
  std::string error = terrain::ImageHeights::WhyNotHeights(image);
  if (error.empty())
  {
    const std::vector<float> heights = HeightsOf(image);
    error = heights.empty()
      ? "every sample needs a height"
      : detail->Build(heights.data(), { image->GetDimensions()[0], image->GetDimensions()[1] },
          level, terrain::SMPParallelFor);
  }
  if (!error.empty())
  {
    vtkErrorMacro("detail: " << error << ".");
    return false;
  }
  internals.Detail = detail;
  internals.DetailImage = image;
  internals.DetailTime.Modified();
  return true;
}

// Base and detail are images of different sizes. Of the base that piece is needed that is asked
// for, of the detail all.
int vtkTerrainStrips::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    vtkInformation* input = inputVector[port]->GetInformationObject(0);
    if (input && input->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
    {
      int extent[6];
      input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
      input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
    }
  }
  if (vtkInformation* detail = inputVector[1]->GetInformationObject(0))
  {
    detail->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    detail->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    detail->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

//------------------------------------------------------------------------------
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
  if (IsEmptyPiece(inputVector[0], outputVector))
  {
    return 1;
  }
  if (!this->PrepareInput(inputVector[0]) || !this->PrepareDetail(inputVector[1]))
  {
    return 0;
  }
  if (!this->Refine())
  {
    return 0;
  }
  if (!this->Private->HasMesh)
  {
    return 1;
  }
  return this->FillOutput(vtkPolyData::GetData(outputVector)) ? 1 : 0;
}

//------------------------------------------------------------------------------
// Builds the strip of the settings' view, or asks for it and takes the last one that is ready.
bool vtkTerrainStrips::Refine()
{
  Internals& internals = *this->Private;
  StripJob job;
  job.Data = internals.Prepared->GetData();
  if (!job.Data)
  {
    vtkErrorMacro("The hierarchy is empty.");
    return false;
  }
  job.Detail = internals.Detail;
  job.View = ViewOf(this->Camera, this->ViewportSize, this->Exaggeration);
  job.View.DetailScale = this->DetailScale;
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
    return false;
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
  return true;
}

//------------------------------------------------------------------------------
// The strip that was built, if its heights are those of the file.
bool vtkTerrainStrips::FillOutput(vtkPolyData* output)
{
  Internals& internals = *this->Private;
  const terrain::StripsSource source{ internals.MeshJob.Data->View(),
    internals.MeshJob.Detail.get() };
  terrain::FillStrips(internals.Mesh, source,
    { this->PointExaggeration > 0.0 ? this->PointExaggeration : internals.MeshJob.View.Exaggeration,
      internals.MeshJob.View.DetailScale, this->Normals, this->TextureCoordinates,
      this->DepthColors, this->HeightScalars, this->TriangleOutput },
    output);
  const bool isDamaged = internals.MeshJob.Data->IsFile &&
    !terrain::AreHeightsKnown(internals.Mesh, source, internals.MeshJob.View.DetailScale);
  if (isDamaged || internals.MeshJob.Data->IsDamaged())
  {
    internals.HasMesh = false;
    output->Initialize();
    vtkErrorMacro(<< (isDamaged ? "The hierarchy's file is damaged: it has heights that no sample "
                                  "has. Prepare it again."
                                : "The hierarchy's file has lost data since it was opened."));
    return false;
  }
  this->NumberOfTriangles = internals.Mesh.Triangles;
  this->UsedTolerance = internals.Mesh.Tolerance;
  return true;
}
