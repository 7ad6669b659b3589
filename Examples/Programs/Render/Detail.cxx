// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Detail.h"

#include "Arguments.h"
#include "Failure.h"
#include "Messages.h"
#include "Statistics.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainDetailSource.h"
#include "vtkTerrainRasterReader.h"

#include <CLI/CLI.hpp>

namespace
{
constexpr const char* kBuiltIn = "builtin";

vtkSmartPointer<vtkImageData> ReadDetail(const DetailOptions& options)
{
  if (options.File == kBuiltIn)
  {
    const vtkNew<vtkTerrainDetailSource> source;
    source->Update();
    return source->GetOutput();
  }
  const vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(options.File);
  reader->Update();
  if (*reader->GetErrorMessage())
  {
    throw Failure(reader->GetErrorMessage());
  }
  ThrowOnError(options.File);
  return reader->GetOutput();
}
}

//------------------------------------------------------------------------------
void DetailArguments::Declare(CLI::App& app, DetailOptions& options)
{
  app
    .add_option("--detail", options.File,
      "detail that is repeated all over the heights: a raster of one period, or builtin")
    ->type_name("FILE");
  app
    .add_option("--detail-cells", this->Cells,
      "detail cells along a cell of the heights, a power of two; default 16")
    ->type_name("N");
  app
    .add_option("--detail-height", this->Height,
      "highest minus lowest height of the detail; default: as in the file")
    ->type_name("HEIGHT");
}

//------------------------------------------------------------------------------
void DetailArguments::Interpret(DetailOptions& options) const
{
  constexpr double kHighest = 1e6;
  if (!this->Cells.empty())
  {
    options.Cells =
      ParseInteger("--detail-cells", this->Cells, 1, vtkOpenGLTerrainMapper::MostDetailCells);
    if ((options.Cells & (options.Cells - 1)) != 0)
    {
      Refuse("--detail-cells", this->Cells + " is not a power of two");
    }
  }
  if (!this->Height.empty())
  {
    options.Height = ParseNumber("--detail-height", this->Height, 0.0, kHighest);
  }
  if (options.File.empty() && !(this->Cells.empty() && this->Height.empty()))
  {
    Refuse(this->Cells.empty() ? "--detail-height" : "--detail-cells", "needs --detail");
  }
}

//------------------------------------------------------------------------------
std::array<double, 2> PreparedDetail::Range() const
{
  std::array<double, 2> range{};
  if (this->Image)
  {
    this->Image->GetScalarRange(range.data());
  }
  return { this->Scale * range[0], this->Scale * range[1] };
}

//------------------------------------------------------------------------------
PreparedDetail PrepareDetail(
  vtkImageData* heights, const DetailOptions& options, Statistics& statistics)
{
  if (options.File.empty())
  {
    return {};
  }
  const vtkSmartPointer<vtkImageData> detail = ReadDetail(options);
  double range[2];
  detail->GetScalarRange(range);
  const double relief = range[1] - range[0];
  double height = options.File == kBuiltIn ? 0.5 * heights->GetSpacing()[0] : relief;
  height = options.Height.value_or(height);
  const int* size = heights->GetDimensions();
  statistics.SetCount("detail_cells", options.Cells);
  statistics.SetCount("effective_samples",
    ((std::int64_t{ size[0] } - 1) * options.Cells + 1) *
      ((std::int64_t{ size[1] } - 1) * options.Cells + 1));
  return { detail, options.Cells, relief > 0.0 ? height / relief : 0.0 };
}
