// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainSource.h"

#include "core/landscape/ProceduralTerrain.h"
#include "data/SMPParallelFor.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
// Length of the longer side when no spacing is given, in metres.
constexpr double kDefaultLength = 40960.0;
// Samples between two looks at the abort flag.
constexpr std::int64_t kPieceSamples = std::int64_t{ 1 } << 22;

template <typename T>
void RoundHeights(const std::vector<float>& heights, std::int64_t count, T* rounded)
{
  constexpr auto highest = static_cast<float>(std::numeric_limits<T>::max());
  terrain::SMPParallelFor(count,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t k = begin; k < end; ++k)
      {
        // Heights are not negative: the cast is the floor.
        const float height = heights[static_cast<std::size_t>(k)] + 0.5F;
        rounded[k] = static_cast<T>(std::min(height, highest));
      }
    });
}
}

struct vtkTerrainSource::Landscape
{
  terrain::ProceduralTerrainParameters Parameters;
  terrain::ProceduralTerrain Terrain;

  explicit Landscape(const terrain::ProceduralTerrainParameters& parameters)
    : Parameters(parameters)
    , Terrain(parameters)
  {
  }
};

vtkStandardNewMacro(vtkTerrainSource);

//------------------------------------------------------------------------------
vtkTerrainSource::vtkTerrainSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkTerrainSource::~vtkTerrainSource() = default;

//------------------------------------------------------------------------------
void vtkTerrainSource::SetOutputScalarTypeToFloat()
{
  this->SetOutputScalarType(VTK_FLOAT);
}

//------------------------------------------------------------------------------
void vtkTerrainSource::SetOutputScalarTypeToShort()
{
  this->SetOutputScalarType(VTK_SHORT);
}

//------------------------------------------------------------------------------
void vtkTerrainSource::SetOutputScalarTypeToUnsignedShort()
{
  this->SetOutputScalarType(VTK_UNSIGNED_SHORT);
}

//------------------------------------------------------------------------------
double vtkTerrainSource::EffectiveSpacing() const
{
  if (this->Spacing > 0.0)
  {
    return this->Spacing;
  }
  return kDefaultLength / std::max({ this->Dimensions[0] - 1, this->Dimensions[1] - 1, 1 });
}

//------------------------------------------------------------------------------
int vtkTerrainSource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputs), vtkInformationVector* outputs)
{
  if (this->Dimensions[0] < 1 || this->Dimensions[1] < 1)
  {
    vtkErrorMacro("a landscape needs at least 1 x 1 samples, not " << this->Dimensions[0] << " x "
                                                                   << this->Dimensions[1]);
    return 0;
  }
  if (this->OutputScalarType != VTK_FLOAT && this->OutputScalarType != VTK_SHORT &&
    this->OutputScalarType != VTK_UNSIGNED_SHORT)
  {
    vtkErrorMacro("the scalar type must be float, short or unsigned short, not "
      << vtkImageScalarTypeNameMacro(this->OutputScalarType));
    return 0;
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  const int extent[6] = { 0, this->Dimensions[0] - 1, 0, this->Dimensions[1] - 1, 0, 0 };
  const double spacing = this->EffectiveSpacing();
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), spacing, spacing, 1.0);
  info->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  info->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(info, this->OutputScalarType, 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainSource::PrepareLandscape()
{
  terrain::ProceduralTerrainParameters parameters;
  parameters.Width = this->Dimensions[0];
  parameters.Height = this->Dimensions[1];
  parameters.Seed = static_cast<std::uint32_t>(this->Seed);
  parameters.Relief = this->Relief;
  const int longer = std::max({ this->Dimensions[0] - 1, this->Dimensions[1] - 1, 1 });
  parameters.Aspect = longer * this->EffectiveSpacing() / this->Relief;
  parameters.Roughness = this->Roughness;
  if (!this->Raised || !(this->Raised->Parameters == parameters))
  {
    this->Raised = std::make_unique<Landscape>(parameters);
  }
}

//------------------------------------------------------------------------------
int vtkTerrainSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputs), vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  this->AllocateOutputData(image, info, extent);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->SetName("Elevation");
  const std::int64_t width = std::int64_t{ extent[1] } - extent[0] + 1;
  const std::int64_t height = std::int64_t{ extent[3] } - extent[2] + 1;
  if (width < 1 || height < 1)
  {
    return 1;
  }
  this->PrepareLandscape();
  const std::int64_t blockRows = std::clamp<std::int64_t>(kPieceSamples / width, 1, height);
  const bool rounds = this->OutputScalarType != VTK_FLOAT;
  std::vector<float> block(rounds ? static_cast<std::size_t>(width * blockRows) : 0);
  for (std::int64_t row = 0; row < height && !this->GetAbortExecute(); row += blockRows)
  {
    const std::int64_t rows = std::min(blockRows, height - row);
    void* target = scalars->GetVoidPointer(width * row);
    this->Raised->Terrain.Sample(extent[0], extent[2] + row, width, rows,
      rounds ? block.data() : static_cast<float*>(target), terrain::SMPParallelFor);
    if (this->OutputScalarType == VTK_SHORT)
    {
      RoundHeights(block, width * rows, static_cast<short*>(target));
    }
    else if (rounds)
    {
      RoundHeights(block, width * rows, static_cast<unsigned short*>(target));
    }
    this->UpdateProgress(static_cast<double>(row + rows) / static_cast<double>(height));
  }
  if (this->GetAbortExecute())
  {
    image->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << " x " << this->Dimensions[1] << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "Spacing: " << this->Spacing << "\n"
     << indent << "Relief: " << this->Relief << "\n"
     << indent << "Roughness: " << this->Roughness << "\n"
     << indent << "OutputScalarType: " << vtkImageScalarTypeNameMacro(this->OutputScalarType)
     << "\n";
}
