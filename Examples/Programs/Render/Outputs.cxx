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

#include <cpl_error.h>
#include <gdal.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <limits>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{

/// Writes bytes to the temporary file, and makes sure that all of them arrived.
void WriteBytes(const void* bytes, std::size_t size, const PendingFile& file)
{
  std::FILE* stream = std::fopen(file.GetTemporaryPath().c_str(), "wb");
  bool written = stream != nullptr;
  if (stream)
  {
    written = std::fwrite(bytes, 1, size, stream) == size;
    const int error = errno;
    if (std::fclose(stream) != 0)
    {
      written = false;
    }
    else if (!written)
    {
      errno = error;
    }
  }
  if (!written)
  {
    throw Failure(file.GetPath(), std::strerror(errno));
  }
}

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
PendingFile::PendingFile(std::string path)
  : Path(std::move(path))
{
  if (this->Path.empty())
  {
    return;
  }
  struct stat status = {};
  if (stat(this->Path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
  {
    throw Failure(this->Path, S_ISDIR(status.st_mode) ? "is a directory" : "is no regular file");
  }
  // Made and removed at once: what cannot be written is said before the work, not after it.
  this->TemporaryPath = this->Path + ".part" + std::to_string(getpid());
  const int file = open(this->TemporaryPath.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (file < 0)
  {
    throw Failure(this->Path, std::strerror(errno));
  }
  close(file);
  std::remove(this->TemporaryPath.c_str());
}

//------------------------------------------------------------------------------
PendingFile::~PendingFile()
{
  if (!this->TemporaryPath.empty())
  {
    std::remove(this->TemporaryPath.c_str());
  }
}

//------------------------------------------------------------------------------
void PendingFile::Commit()
{
  if (this->TemporaryPath.empty())
  {
    return;
  }
  if (std::rename(this->TemporaryPath.c_str(), this->Path.c_str()) != 0)
  {
    throw Failure(this->Path, std::strerror(errno));
  }
  this->TemporaryPath.clear();
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
    throw Failure(file.GetPath(), "the picture could not be encoded");
  }
  WriteBytes(bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()), file);
}

//------------------------------------------------------------------------------
void WriteDepths(vtkImageData* depths, const PendingFile& file)
{
  const int* dimensions = depths->GetDimensions();
  GDALAllRegister();
  CPLPushErrorHandler(CPLQuietErrorHandler);
  CPLErrorReset();
  GDALDriverH driver = GDALGetDriverByName("GTiff");
  const char* creationOptions[] = { "COMPRESS=DEFLATE", "PREDICTOR=3", nullptr };
  GDALDatasetH dataset = driver
    ? GDALCreate(driver, file.GetTemporaryPath().c_str(), dimensions[0], dimensions[1], 1,
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
    throw Failure(file.GetPath(), reason.empty() ? "the depths could not be written" : reason);
  }
}

//------------------------------------------------------------------------------
void WriteText(const std::string& text, const PendingFile& file)
{
  WriteBytes(text.data(), text.size(), file);
}
