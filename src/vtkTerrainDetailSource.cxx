// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainDetailSource.h"

#include "data/SMPParallelFor.h"

#include "core/landscape/DetailNoise.h"

#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkTerrainDetailSource);

//------------------------------------------------------------------------------
vtkTerrainDetailSource::vtkTerrainDetailSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
int vtkTerrainDetailSource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputs), vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  const int extent[6] = { 0, this->Size - 1, 0, this->Size - 1, 0, 0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), 1.0, 1.0, 1.0);
  info->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainDetailSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputs), vtkInformationVector* outputs)
{
  const std::vector<float> heights = terrain::MakeDetailNoise(
    this->Size, static_cast<std::uint32_t>(this->Seed), terrain::SMPParallelFor);
  vtkImageData* image = vtkImageData::GetData(outputs);
  image->SetExtent(0, this->Size - 1, 0, this->Size - 1, 0, 0);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->SetName("Detail");
  const auto relief = static_cast<float>(this->Relief);
  std::transform(heights.begin(), heights.end(), static_cast<float*>(image->GetScalarPointer()),
    [relief](float height) { return relief * height; });
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainDetailSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Relief: " << this->Relief << "\n";
}
