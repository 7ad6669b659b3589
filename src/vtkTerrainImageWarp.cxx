// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainImageWarp.h"

#include "data/GlobeData.h"
#include "data/ImageHeights.h"
#include "data/Setting.h"
#include "place/ImageWarp.h"
#include "vtkTerrainGeoreference.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

class vtkTerrainImageWarp::vtkInternals : public terrain::ImageWarp
{
};

static_assert(vtkTerrainImageWarp::InterpolationError == terrain::kInterpolationError);

vtkStandardNewMacro(vtkTerrainImageWarp);

vtkTerrainImageWarp::vtkTerrainImageWarp()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkTerrainImageWarp::~vtkTerrainImageWarp() = default;

void vtkTerrainImageWarp::SetFileName(const std::string& fileName)
{
  terrain::Setting::Set(this, this->FileName, fileName);
}

void vtkTerrainImageWarp::SetGeoreference(vtkTerrainGeoreference* georeference)
{
  terrain::Setting::Set(this, this->Georeference, georeference);
}

vtkTerrainGeoreference* vtkTerrainImageWarp::GetGeoreference() const
{
  return this->Georeference;
}

void vtkTerrainImageWarp::SetCoordinateSystem(const std::string& definition)
{
  terrain::Setting::Set(this, this->CoordinateSystem, definition);
}

vtkMTimeType vtkTerrainImageWarp::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Georeference ? std::max(time, this->Georeference->GetMTime()) : time;
}

int vtkTerrainImageWarp::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkTerrainImageWarp::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // The size of the output depends on the heights and on a scene that they may define.
  if (vtkAlgorithmOutput* connection = this->GetInputConnection(0, 0))
  {
    connection->GetProducer()->Update(connection->GetIndex());
  }
  vtkInternals& internals = *this->Internals;
  internals.Heights = vtkImageData::GetData(inputs[0]);
  internals.Scene = this->Georeference;
  internals.Globe = terrain::GlobeData::Get(internals.Heights);
  this->ErrorMessage = terrain::ImageHeights::WhyNotHeights(internals.Heights);
  if (this->ErrorMessage.empty())
  {
    this->ErrorMessage = !this->Georeference ? "there is no georeference of the heights"
                                             : this->Georeference->GetWhyNot();
  }
  if (this->ErrorMessage.empty() && !this->Georeference->IsOnEarth() &&
    !(internals.Globe && this->Georeference->HasPlaces()))
  {
    this->ErrorMessage = "a picture cannot be placed: the heights have no coordinate system";
  }
  if (this->ErrorMessage.empty())
  {
    this->ErrorMessage = internals.OpenColors(this->FileName, this->CoordinateSystem);
  }
  if (this->ErrorMessage.empty())
  {
    const std::string why = internals.Place(this->MaximumSize);
    this->ErrorMessage = why.empty() ? "" : "'" + this->FileName + "': " + why;
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  if (!this->ErrorMessage.empty())
  {
    const int empty[6] = { 0, -1, 0, -1, 0, -1 };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), empty, 6);
    vtkErrorMacro(<< this->ErrorMessage);
    return 0;
  }
  const double s = internals.Spacing[0];
  const int extent[6] = { 0, internals.Size[0] - 1, 0, internals.Size[1] - 1, 0, 0 };
  const double origin[3] = { internals.Corner[0] + 0.5 * s, internals.Corner[1] + 0.5 * s, 0.0 };
  const double spacing[3] = { s, s, 1.0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, 4);
  return 1;
}

int vtkTerrainImageWarp::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
}

int vtkTerrainImageWarp::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outputs);
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    return 0;
  }
  // The whole picture, whatever part was asked for.
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  output->SetExtent(extent);
  output->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  output->SetSpacing(info->Get(vtkDataObject::SPACING()));
  output->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  output->GetPointData()->GetScalars()->SetName("Colors");
  this->ErrorMessage =
    this->Internals->WarpColors(static_cast<unsigned char*>(output->GetScalarPointer()));
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< "'" << this->FileName << "': " << this->ErrorMessage);
    return 0;
  }
  return 1;
}

void vtkTerrainImageWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "MaximumSize: " << this->MaximumSize << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  os << indent << "Georeference: " << this->Georeference.Get() << "\n";
}
