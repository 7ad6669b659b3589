// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainRasterReader where it reads a level of tiles in place of the samples themselves.
#include "parts/RasterReaderInternals.h"

#include "data/SMPParallelFor.h"
#include "raster/RasterTileSource.h"

#include "core/surface/LevelSamples.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <sstream>
#include <thread>

namespace
{
/// Bytes that reading and drawing take for each byte of samples: the image, its texels, their
/// pyramid, and an image in between.
constexpr vtkIdType kMemoryPerByte = 4;
/// Shares of the progress.
constexpr double kPrepareShare = 0.9;

/// Tells progress from several threads: VTK's observers run on the thread that updates.
class LevelProgress
{
public:
  explicit LevelProgress(vtkTerrainRasterReader* reader)
    : Reader(reader)
  {
  }
  bool Tell(double done)
  {
    if (std::this_thread::get_id() == this->Thread && done - this->Told >= 0.01)
    {
      this->Told = done;
      this->Reader->UpdateProgress(done);
    }
    return !this->Reader->GetAbortExecute();
  }

private:
  vtkTerrainRasterReader* Reader;
  std::thread::id Thread = std::this_thread::get_id();
  double Told = 0.0;
};

/// Where the samples of an extent go: codes become scalars, and marks where there is none.
template <typename T>
class LevelScalars
{
public:
  LevelScalars(vtkImageData* image, const terrain::HeightCodes& codes)
    : Image(image)
    , Codes(codes)
    , Scalars(static_cast<T*>(image->GetScalarPointer()))
  {
    image->GetExtent(this->Extent);
  }

  void Take(std::int64_t x, std::int64_t y, std::int64_t count, const float* codes)
  {
    const std::int64_t width = this->Extent[1] - this->Extent[0] + 1;
    const std::int64_t first = x - this->Extent[0] + width * (y - this->Extent[2]);
    for (std::int64_t k = 0; k < count; ++k)
    {
      if (codes[k] < 0.0F)
      {
        this->SetNone(first + k);
        continue;
      }
      const double height = this->Codes.ToHeight(static_cast<double>(codes[k]));
      this->Scalars[first + k] =
        static_cast<T>(std::is_integral_v<T> ? std::floor(height + 0.5) : height);
    }
  }

private:
  void SetNone(std::int64_t index)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      this->Scalars[index] = std::numeric_limits<T>::quiet_NaN();
    }
    else
    {
      std::call_once(this->Once,
        [this]
        {
          const vtkNew<vtkUnsignedCharArray> ghosts;
          ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
          ghosts->SetNumberOfValues(this->Image->GetNumberOfPoints());
          ghosts->FillValue(0);
          this->Image->GetPointData()->AddArray(ghosts);
          this->Hidden = ghosts->GetPointer(0);
        });
      this->Hidden[index] = vtkDataSetAttributes::HIDDENPOINT;
      this->Scalars[index] = T{ 0 };
    }
  }

  vtkImageData* Image;
  const terrain::HeightCodes& Codes;
  T* Scalars;
  int Extent[6] = {};
  std::once_flag Once;
  unsigned char* Hidden = nullptr;
};

/// Reads the image's extent of a level. Returns an error message, empty if all is well.
template <typename T>
std::string ReadScalars(
  const terrain::TileSource& source, int level, vtkImageData* image, LevelProgress& progress)
{
  const terrain::HeightCodes codes = source.GetCodes();
  LevelScalars<T> scalars(image, codes);
  int extent[6];
  image->GetExtent(extent);
  const glm::i64vec2 first(extent[0], extent[2]);
  const glm::i64vec2 size(extent[1] - extent[0] + 1, extent[3] - extent[2] + 1);
  return terrain::ReadLevel(
    source, level, first, size, terrain::SMPParallelFor,
    [&progress](double done)
    { return progress.Tell(kPrepareShare + (1.0 - kPrepareShare) * done); },
    [&scalars](std::int64_t x, std::int64_t y, std::int64_t count, const float* row)
    { scalars.Take(x, y, count, row); });
}
}

//------------------------------------------------------------------------------
// The level, and the size that comes of it, where levels are asked for and needed.
void vtkTerrainRasterReader::ChooseLevel(vtkTerrainRasterPlan& plan) const
{
  terrain::RasterRequest& request = plan.Request;
  const terrain::RasterWindow& window = request.Window;
  const bool isReduced = request.Width < window.Width || request.Height < window.Height;
  const bool isWhole =
    window.Width == plan.File->GetWidth() && window.Height == plan.File->GetHeight();
  plan.Level = 0;
  if (!this->UseLevels || this->Internals->Samples || plan.File->IsReplaced() ||
    this->BandsAsTimeSteps || !isReduced || !isWhole)
  {
    return;
  }
  const terrain::TileLayout layout{ window.Width, window.Height, terrain::kRasterTileLevel };
  std::int64_t most = this->MaximumNumberOfSamples;
  if (this->MemoryBudget > 0)
  {
    const std::int64_t bytes = vtkDataArray::GetDataTypeSize(plan.ScalarType);
    const std::int64_t allowed =
      std::max<std::int64_t>(this->MemoryBudget / (kMemoryPerByte * bytes), 1);
    most = most > 0 ? std::min(most, allowed) : allowed;
  }
  plan.Level = terrain::FindLevel(layout, this->MaximumSize, most);
  const glm::i64vec2 size =
    plan.Level > 0 ? layout.Samples(plan.Level) : glm::i64vec2(request.Width, request.Height);
  request.Width = size.x;
  request.Height = size.y;
}

//------------------------------------------------------------------------------
// Samples of a level lie at samples of the file, from the south-western one on.
void vtkTerrainRasterReader::PlaceLevel(vtkTerrainRasterPlan& plan) const
{
  if (plan.Level == 0)
  {
    return;
  }
  const terrain::RasterRequest& request = plan.Request;
  const double ratio[2] = { static_cast<double>(request.Window.Width) /
      static_cast<double>(request.Width),
    static_cast<double>(request.Window.Height) / static_cast<double>(request.Height) };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double fine = plan.Spacing[axis] / ratio[axis];
    plan.Origin[axis] += 0.5 * (fine - plan.Spacing[axis]);
    plan.Spacing[axis] = std::ldexp(fine, plan.Level);
  }
}

//------------------------------------------------------------------------------
terrain::RasterTileSettings vtkTerrainRasterReader::GetTileSettings() const
{
  terrain::RasterTileSettings settings;
  settings.Heights.FileName = this->FileName;
  settings.Heights.Part = this->Part;
  settings.Heights.Band = this->Band;
  settings.Heights.Options = this->GetOptions();
  settings.UseCache = this->UseCache;
  settings.For = terrain::SMPParallelFor;
  return settings;
}

//------------------------------------------------------------------------------
bool vtkTerrainRasterReader::PrepareLevels()
{
  this->ErrorMessage.clear();
  LevelProgress progress(this);
  terrain::RasterTileSettings settings = this->GetTileSettings();
  settings.Progress = [&progress](double done) { return progress.Tell(done); };
  try
  {
    terrain::PrepareTileFile(settings, terrain::TileFileBeside(this->FileName));
    return true;
  }
  catch (const std::exception& error)
  {
    return this->Fail(error.what()) != 0;
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::ReadTiles(vtkTerrainRasterPlan& plan, vtkImageData* image)
{
  const std::int64_t* extent = plan.Request.Extent;
  if (extent[1] < extent[0] || extent[3] < extent[2])
  {
    return;
  }
  LevelProgress progress(this);
  terrain::RasterTileSettings settings = this->GetTileSettings();
  settings.Progress = [&progress](double done) { return progress.Tell(kPrepareShare * done); };
  terrain::PreparedRaster tiles;
  try
  {
    tiles = terrain::OpenTiles(settings);
  }
  catch (const terrain::RasterError&)
  {
    if (!this->GetAbortExecute())
    {
      throw;
    }
    return;
  }
  std::string error;
  switch (plan.ScalarType)
  {
    vtkTemplateMacro(error = ReadScalars<VTK_TT>(*tiles.Source, plan.Level, image, progress));
  }
  if (!error.empty())
  {
    throw terrain::RasterError(error);
  }
  this->Tiles = tiles.Source;
  if (this->WarnOfLevels || !tiles.Message.empty())
  {
    this->WarnOfLevel(plan, tiles.Message);
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::WarnOfLevel(
  const vtkTerrainRasterPlan& plan, const std::string& message)
{
  const int cells = 1 << plan.Level;
  std::ostringstream text;
  text << "its " << plan.Request.Window.Width << " x " << plan.Request.Window.Height
       << " samples are reduced to " << plan.Request.Width << " x " << plan.Request.Height
       << ", level " << plan.Level << ", a cell of which is " << cells << " x " << cells
       << " of its own; cut out a part of it to see that in full";
  if (!message.empty())
  {
    text << "; " << message;
  }
  this->Warn(text.str());
}
