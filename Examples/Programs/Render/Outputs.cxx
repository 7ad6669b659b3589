// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Outputs.h"

#include "Failure.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>

#include <cstddef>
#include <limits>
#include <memory>

namespace
{

/// The rows of the image from the top down, into the band.
CPLErr WriteRows(GDALRasterBandH band, vtkImageData* depths)
{
  const int* dimensions = depths->GetDimensions();
  CPLErr error = CE_None;
  for (int row = 0; row < dimensions[1] && error == CE_None; ++row)
  {
    error = GDALRasterIO(band, GF_Write, 0, row, dimensions[0], 1,
      depths->GetScalarPointer(0, dimensions[1] - 1 - row, 0), dimensions[0], 1, GDT_Float32, 0, 0);
  }
  return error;
}
}

//------------------------------------------------------------------------------
PendingFile::PendingFile(const std::string& path)
  : Path(path)
  , Wanted(!path.empty())
{
  // Made at once: what cannot be written is said before the work, not after it.
  if (this->Wanted && !this->File->Open(path))
  {
    throw Failure(this->File->GetErrorMessage());
  }
}

//------------------------------------------------------------------------------
void PendingFile::Write(const void* bytes, std::size_t size) const
{
  if (!this->File->Write(bytes, size))
  {
    throw Failure(this->File->GetErrorMessage());
  }
}

//------------------------------------------------------------------------------
void PendingFile::Fail(const std::string& reason) const
{
  throw Failure(this->Path, reason);
}

//------------------------------------------------------------------------------
void PendingFile::Commit() const
{
  if (this->Wanted && !this->File->Commit())
  {
    throw Failure(this->File->GetErrorMessage());
  }
}

//------------------------------------------------------------------------------
void WritePicture(vtkRenderWindow* window, const PendingFile& file)
{
  const vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->SetInputBufferTypeToRGB();
  capture->ReadFrontBufferOff();
  capture->ShouldRerenderOff();
  const vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(capture->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (!bytes || bytes->GetNumberOfValues() == 0)
  {
    file.Fail("the picture could not be encoded");
  }
  file.Write(bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

//------------------------------------------------------------------------------
void WriteDepths(vtkImageData* depths, const PendingFile& file)
{
  const int* dimensions = depths->GetDimensions();
  GDALAllRegister();
  CPLPushErrorHandler(CPLQuietErrorHandler);
  CPLErrorReset();
  GDALDriverH driver = GDALGetDriverByName("GTiff");
  // In memory first: what a file system lacks is told by the one writer of outputs.
  const std::string name = "/vsimem/vtkTerrain/depths.tif";
  const char* creationOptions[] = { "COMPRESS=DEFLATE", "PREDICTOR=3", nullptr };
  GDALDatasetH dataset = driver ? GDALCreate(driver, name.c_str(), dimensions[0], dimensions[1], 1,
                                    GDT_Float32, const_cast<char**>(creationOptions))
                                : nullptr;
  bool written = false;
  if (dataset)
  {
    GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
    written = GDALSetRasterNoDataValue(band, std::numeric_limits<double>::quiet_NaN()) == CE_None &&
      WriteRows(band, depths) == CE_None;
    GDALClose(dataset);
  }
  const bool failed = !written || CPLGetLastErrorType() >= CE_Failure;
  const std::string reason = CPLGetLastErrorMsg();
  CPLPopErrorHandler();
  if (failed)
  {
    file.Fail(reason.empty() ? "the depths could not be encoded" : reason);
  }
  vsi_l_offset size = 0;
  const std::unique_ptr<GByte, void (*)(void*)> bytes(
    VSIGetMemFileBuffer(name.c_str(), &size, TRUE), CPLFree);
  file.Write(bytes.get(), size);
}

//------------------------------------------------------------------------------
void WriteText(const std::string& text, const PendingFile& file)
{
  file.Write(text.data(), text.size());
}
