// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Outputs.h"

#include "Failure.h"

#include "vtkImageData.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

namespace
{
/// Bytes of a PNG before the first chunk that may follow its header.
constexpr std::size_t kBeforeDots = 33;

void AppendNumber(std::vector<unsigned char>& bytes, std::uint32_t number)
{
  for (int shift = 24; shift >= 0; shift -= 8)
  {
    bytes.push_back(static_cast<unsigned char>(number >> shift));
  }
}

/// Checksum of PNG (ISO 3309) of all bytes from the given one on.
std::uint32_t ChecksumFrom(const std::vector<unsigned char>& bytes, std::size_t first)
{
  constexpr std::uint32_t kPolynomial = 0xEDB88320U;
  std::uint32_t sum = 0xFFFFFFFFU;
  for (std::size_t k = first; k < bytes.size(); ++k)
  {
    sum ^= bytes[k];
    for (int bit = 0; bit < 8; ++bit)
    {
      sum = (sum >> 1) ^ ((sum & 1U) != 0 ? kPolynomial : 0U);
    }
  }
  return ~sum;
}

/// Adds the chunk pHYs, which has pixels per metre.
void TellDotsOfPNG(std::vector<unsigned char>& png, double dots)
{
  constexpr double kMetresPerInch = 0.0254;
  constexpr std::uint32_t kDotsLength = 9;
  const auto perMetre = static_cast<std::uint32_t>(std::lround(dots / kMetresPerInch));
  std::vector<unsigned char> chunk;
  AppendNumber(chunk, kDotsLength);
  chunk.insert(chunk.end(), { 'p', 'H', 'Y', 's' });
  AppendNumber(chunk, perMetre);
  AppendNumber(chunk, perMetre);
  chunk.push_back(1);
  AppendNumber(chunk, ChecksumFrom(chunk, sizeof(std::uint32_t)));
  png.insert(png.begin() + static_cast<std::ptrdiff_t>(std::min(kBeforeDots, png.size())),
    chunk.begin(), chunk.end());
}

/// Sets the density in the header of JFIF: a unit, then columns and rows an inch.
void TellDotsOfJPEG(std::vector<unsigned char>& jpeg, double dots)
{
  constexpr std::size_t kUnit = 13;
  constexpr std::size_t kNumbers = 4;
  const auto whole = static_cast<std::uint16_t>(std::lround(dots));
  if (jpeg.size() > kUnit + kNumbers)
  {
    jpeg[kUnit] = 1;
    for (std::size_t k = 1; k <= kNumbers; ++k)
    {
      jpeg[kUnit + k] = static_cast<unsigned char>(k % 2 == 1 ? whole >> 8 : whole & 0xFF);
    }
  }
}

/// In small letters.
std::string SuffixOf(const std::string& name)
{
  std::string suffix = std::filesystem::path(name).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return suffix;
}

/// The bytes of a file with a picture; none if it cannot be encoded.
template <typename Writer>
std::vector<unsigned char> Encode(vtkImageData* picture, Writer* writer)
{
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* result = writer->GetResult();
  const vtkIdType size = result ? result->GetNumberOfValues() : 0;
  return size > 0 ? std::vector<unsigned char>(result->GetPointer(0), result->GetPointer(0) + size)
                  : std::vector<unsigned char>();
}

std::vector<unsigned char> EncodeJPEG(vtkImageData* picture, double dots)
{
  const vtkNew<vtkJPEGWriter> writer;
  std::vector<unsigned char> bytes = Encode(picture, writer.Get());
  if (dots > 0.0)
  {
    TellDotsOfJPEG(bytes, dots);
  }
  return bytes;
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
std::string PictureName(const std::string& output, std::size_t number, std::size_t count)
{
  const std::filesystem::path path(output);
  const std::size_t digits = std::max<std::size_t>(std::to_string(count).size(), 3);
  std::string text = std::to_string(number);
  text.insert(0, digits - text.size(), '0');
  const std::string name = path.stem().string() + "-" + text + path.extension().string();
  return (path.parent_path() / name).string();
}

//------------------------------------------------------------------------------
void TellName(const std::string& file)
{
  std::cout << std::filesystem::absolute(file).lexically_normal().string() << '\n';
}

//------------------------------------------------------------------------------
bool IsJPEG(const std::string& name)
{
  const std::string suffix = SuffixOf(name);
  return suffix == ".jpg" || suffix == ".jpeg";
}

//------------------------------------------------------------------------------
std::string WhyNotPicture(const std::string& name)
{
  const std::string suffix = SuffixOf(name);
  return suffix.empty() || suffix == ".png" || IsJPEG(name)
    ? std::string()
    : "'" + name + "' is neither .png nor .jpg: pictures are written as PNG or JPEG";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> CapturePicture(vtkRenderWindow* window, bool withAlpha)
{
  const vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  if (withAlpha)
  {
    capture->SetInputBufferTypeToRGBA();
  }
  capture->ReadFrontBufferOff();
  capture->ShouldRerenderOff();
  capture->Update();
  return capture->GetOutput();
}

//------------------------------------------------------------------------------
std::vector<unsigned char> EncodePicture(vtkImageData* picture, double dots, PictureUse use)
{
  const vtkNew<vtkPNGWriter> writer;
  writer->SetCompressionLevel(use == PictureUse::Passing ? 1 : 5);
  std::vector<unsigned char> bytes = Encode(picture, writer.Get());
  if (dots > 0.0 && !bytes.empty())
  {
    TellDotsOfPNG(bytes, dots);
  }
  return bytes;
}

//------------------------------------------------------------------------------
void WriteEncoded(const std::vector<unsigned char>& bytes, const PendingFile& file)
{
  if (bytes.empty())
  {
    file.Fail("the picture could not be encoded");
  }
  file.Write(bytes.data(), bytes.size());
}

//------------------------------------------------------------------------------
void WritePicture(vtkImageData* picture, double dots, const PendingFile& file)
{
  WriteEncoded(IsJPEG(file.GetPath()) ? EncodeJPEG(picture, dots)
                                      : EncodePicture(picture, dots, PictureUse::Lasting),
    file);
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
