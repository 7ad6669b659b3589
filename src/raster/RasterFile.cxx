// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterFile.h"

#include "core/files/OutputFile.h"
#include "raster/RasterTiles.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>

#include <fcntl.h>
#include <unistd.h>

namespace terrain
{
namespace
{
// Fill values that many files hold without declaring them.
constexpr std::array<double, 2> kImpossibleHeights{ { -32768.0, -32767.0 } };
constexpr double kUnlikelyHeight = -9999.0;
// Where heights reach below this, kUnlikelyHeight may be one.
constexpr double kDeepSea = -8000.0;
constexpr double kDeepestSea = -12000.0;
// How much of a file is looked at to know that: blocks of the whole file, the same ones for each of
// its pieces, and pixels of each.
constexpr std::int64_t kSampledBlocks = 16;
constexpr std::int64_t kSampledPixels = std::int64_t{ 1 } << 20;

// GDAL >= 3.7 and >= 3.11; the numbers are part of its interface.
constexpr int kTypeInt8 = 14;
constexpr int kTypeFloat16 = 15;

void RegisterDrivers()
{
  static std::once_flag once;
  std::call_once(once, [] { GDALAllRegister(); });
}

std::string OneLine(const char* text)
{
  std::string line(text ? text : "");
  std::replace(line.begin(), line.end(), '\n', ' ');
  while (!line.empty() && (line.back() == ' ' || line.back() == '.'))
  {
    line.pop_back();
  }
  return line;
}

/// Why a file could not be opened, GDAL's own reason coming last.
std::string WhyNotOpened(const char* fileName, const std::string& failure)
{
  if (!fileName || !*fileName)
  {
    return "no file name is given";
  }
  VSIStatBufL status;
  std::memset(&status, 0, sizeof(status));
  errno = 0;
  if (VSIStatL(fileName, &status) != 0)
  {
    if (errno == EACCES)
    {
      return "there is no permission to read it";
    }
    const bool plainName = std::strchr(fileName, ':') == nullptr && fileName[0] != '<';
    return plainName || failure.empty() ? "there is no such file" : failure;
  }
  if (std::strncmp(fileName, "/vsi", 4) != 0 &&
    faccessat(AT_FDCWD, fileName, R_OK, AT_EACCESS) != 0)
  {
    return "there is no permission to read it";
  }
  if (status.st_size == 0)
  {
    return "it is empty";
  }
  return "it is not a raster that GDAL can open" + (failure.empty() ? "" : " (" + failure + ")");
}

bool IsDirectory(const char* name)
{
  VSIStatBufL status;
  std::memset(&status, 0, sizeof(status));
  return VSIStatL(name, &status) == 0 && VSI_ISDIR(status.st_mode);
}

bool IsColor(GDALColorInterp color)
{
  return color == GCI_RedBand || color == GCI_GreenBand || color == GCI_BlueBand ||
    color == GCI_PaletteIndex;
}
}

//------------------------------------------------------------------------------
GDALMessages::GDALMessages()
{
  CPLPushErrorHandlerEx(&GDALMessages::Collect, this);
  CPLErrorReset();
}

//------------------------------------------------------------------------------
GDALMessages::~GDALMessages()
{
  CPLPopErrorHandler();
  CPLErrorReset();
}

//------------------------------------------------------------------------------
void CPL_STDCALL GDALMessages::Collect(CPLErr kind, CPLErrorNum /*number*/, const char* text)
{
  auto* self = static_cast<GDALMessages*>(CPLGetErrorHandlerUserData());
  if ((kind == CE_Failure || kind == CE_Fatal) && self && self->Failure.empty())
  {
    self->Failure = OneLine(text);
  }
}

//------------------------------------------------------------------------------
RasterFile::RasterFile(const char* fileName)
{
  if (!WhyNoGDAL().empty())
  {
    throw RasterError(WhyNoGDAL());
  }
  RegisterDrivers();
  const GDALMessages messages;
  const std::string whyNot = WhyNotInput(fileName ? fileName : "");
  if (!whyNot.empty())
  {
    throw RasterError(whyNot);
  }
  if (fileName && *fileName)
  {
    this->Dataset = GDALOpenEx(fileName, GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
      nullptr, nullptr, nullptr);
  }
  if (!this->Dataset && fileName && IsDirectory(fileName)) // of no format that is a directory
  {
    this->Dataset = OpenRasterTiles(fileName);
  }
  if (!this->Dataset)
  {
    throw RasterError(WhyNotOpened(fileName, messages.GetFailure()));
  }
}

//------------------------------------------------------------------------------
RasterFile::~RasterFile()
{
  if (this->GivenReference)
  {
    OSRRelease(this->GivenReference);
  }
  if (this->Dataset)
  {
    const GDALMessages messages;
    GDALClose(this->Dataset);
  }
}

//------------------------------------------------------------------------------
void RasterFile::SelectBand(int band)
{
  const GDALMessages messages;
  const int count = GDALGetRasterCount(this->Dataset);
  if (count < 1)
  {
    const char* const* parts = GDALGetMetadata(this->Dataset, "SUBDATASETS");
    const char* first = CSLFetchNameValue(parts, "SUBDATASET_1_NAME");
    throw RasterError("it has no band of its own" +
      (first ? ", open one of its parts, such as " + std::string(first) : std::string()));
  }
  if (band < 0 || band > count)
  {
    throw RasterError(
      "it has no band " + std::to_string(band) + ", its bands are 1 to " + std::to_string(count));
  }
  this->BandNumber = std::max(band, 1);
  this->Band = GDALGetRasterBand(this->Dataset, this->BandNumber);
  if (!this->Band)
  {
    throw RasterError(messages.GetFailure());
  }
  const GDALDataType type = GDALGetRasterDataType(this->Band);
  if (GDALDataTypeIsComplex(type))
  {
    throw RasterError("its samples are complex numbers, which are no heights");
  }
  if (type == GDT_Unknown || this->GetWidth() < 1 || this->GetHeight() < 1)
  {
    throw RasterError("it has no samples");
  }
  if (band == 0)
  {
    this->CheckColors();
  }
}

//------------------------------------------------------------------------------
void RasterFile::CheckColors() const
{
  const int count = GDALGetRasterCount(this->Dataset);
  int opaque = 0;
  bool bytes = true;
  bool colors = false;
  for (int k = 1; k <= count; ++k)
  {
    GDALRasterBandH band = GDALGetRasterBand(this->Dataset, k);
    const GDALColorInterp color = GDALGetRasterColorInterpretation(band);
    if (color != GCI_AlphaBand)
    {
      ++opaque;
      bytes = bytes && GDALGetRasterDataType(band) == GDT_Byte;
      colors = colors || IsColor(color);
    }
  }
  if (colors || (opaque > 2 && bytes))
  {
    throw RasterError("it looks like a colour image of " + std::to_string(count) +
      (count == 1 ? " band" : " bands") + ", not like heights; choose a band to use it as heights");
  }
}

//------------------------------------------------------------------------------
int RasterFile::GetNumberOfBands() const
{
  int count = GDALGetRasterCount(this->Dataset);
  while (count > 1 &&
    GDALGetRasterColorInterpretation(GDALGetRasterBand(this->Dataset, count)) == GCI_AlphaBand)
  {
    --count;
  }
  return count;
}

//------------------------------------------------------------------------------
std::int64_t RasterFile::GetWidth() const
{
  return GDALGetRasterXSize(this->Dataset);
}

//------------------------------------------------------------------------------
std::int64_t RasterFile::GetHeight() const
{
  return GDALGetRasterYSize(this->Dataset);
}

//------------------------------------------------------------------------------
GDALDataType RasterFile::GetType() const
{
  const GDALDataType type = GDALGetRasterDataType(this->Band);
  switch (static_cast<int>(type))
  {
    case GDT_Byte:
    case GDT_UInt16:
    case GDT_Int16:
    case GDT_UInt32:
    case GDT_Int32:
    case GDT_Float32:
    case kTypeInt8:
      return type;
    case kTypeFloat16:
      return GDT_Float32;
    default:
      return GDT_Float64;
  }
}

//------------------------------------------------------------------------------
bool RasterFile::IsSignedByte() const
{
  if (static_cast<int>(this->GetType()) == kTypeInt8)
  {
    return true;
  }
  const char* sign = GDALGetMetadataItem(this->Band, "PIXELTYPE", "IMAGE_STRUCTURE");
  return this->GetType() == GDT_Byte && sign && std::strcmp(sign, "SIGNEDBYTE") == 0;
}

//------------------------------------------------------------------------------
bool RasterFile::IsInteger() const
{
  return this->GetType() != GDT_Float32 && this->GetType() != GDT_Float64;
}

//------------------------------------------------------------------------------
std::string RasterFile::GetBandDescription() const
{
  const char* description = GDALGetDescription(this->Band);
  return description ? description : "";
}

//------------------------------------------------------------------------------
void RasterFile::GetScaleAndOffset(double& scale, double& offset) const
{
  int hasScale = 0;
  int hasOffset = 0;
  scale = GDALGetRasterScale(this->Band, &hasScale);
  offset = GDALGetRasterOffset(this->Band, &hasOffset);
  scale = hasScale && std::isfinite(scale) && scale != 0.0 ? scale : 1.0;
  offset = hasOffset && std::isfinite(offset) ? offset : 0.0;
}

//------------------------------------------------------------------------------
std::vector<double> RasterFile::GetDeclaredNoData() const
{
  int declared = 0;
  double value = 0.0;
  const GDALDataType type = GDALGetRasterDataType(this->Band);
  if (type == GDT_Int64)
  {
    value = static_cast<double>(GDALGetRasterNoDataValueAsInt64(this->Band, &declared));
  }
  else if (type == GDT_UInt64)
  {
    value = static_cast<double>(GDALGetRasterNoDataValueAsUInt64(this->Band, &declared));
  }
  else
  {
    value = GDALGetRasterNoDataValue(this->Band, &declared);
  }
  if (!declared || std::isnan(value))
  {
    return {};
  }
  switch (type)
  {
    case GDT_Byte:
      return { this->IsSignedByte() && value > 127.0 ? value - 256.0 : value };
    case GDT_Float32:
      // The tag may be a decimal rounding of the value, beyond the type's range even.
      return std::fabs(value) > std::numeric_limits<float>::max()
        ? std::vector<double>{}
        : std::vector<double>{ static_cast<double>(static_cast<float>(value)) };
    default:
      return { value }; // no sample equals one that the type cannot hold
  }
}

//------------------------------------------------------------------------------
// The lowest height in some blocks of the file, fill values left out, and whether there are any.
void RasterFile::SampleHeights(double& lowest, bool& fillOccurs) const
{
  int blockWidth = 1;
  int blockHeight = 1;
  GDALGetBlockSize(this->Band, &blockWidth, &blockHeight);
  const std::int64_t width = std::max(blockWidth, 1);
  const std::int64_t height = std::max(blockHeight, 1);
  const std::int64_t across = (this->GetWidth() + width - 1) / width;
  const std::int64_t count = across * ((this->GetHeight() + height - 1) / height);
  const std::int64_t samples = std::min(count, kSampledBlocks);
  lowest = std::numeric_limits<double>::infinity();
  fillOccurs = false;
  std::vector<double> values;
  for (std::int64_t k = 0; k < samples; ++k)
  {
    const std::int64_t block = (2 * k + 1) * count / (2 * samples);
    RasterWindow window{ block % across * width, block / across * height, width, height };
    window.Width = std::min(width, this->GetWidth() - window.X);
    window.Height = std::min({ height, this->GetHeight() - window.Y,
      std::max<std::int64_t>(kSampledPixels / window.Width, 1) });
    values.resize(static_cast<std::size_t>(window.Width * window.Height));
    this->Read(-1, window, values.data(), GDT_Float64, 8, 8 * window.Width);
    for (const double value : values)
    {
      const bool fill = value == kUnlikelyHeight || value < kDeepestSea;
      lowest = !fill && value < lowest ? value : lowest;
      fillOccurs = fillOccurs || fill;
    }
  }
}

//------------------------------------------------------------------------------
std::vector<double> RasterFile::GetUndeclaredNoData(bool& occur) const
{
  const GDALDataType type = this->GetType();
  const bool isSigned =
    type == GDT_Int16 || type == GDT_Int32 || type == GDT_Float32 || type == GDT_Float64;
  occur = false;
  if (!isSigned)
  {
    return {};
  }
  std::vector<double> values(kImpossibleHeights.begin(), kImpossibleHeights.end());
  double lowest = 0.0;
  this->SampleHeights(lowest, occur);
  if (lowest > kDeepSea)
  {
    values.push_back(kUnlikelyHeight);
  }
  return values;
}

//------------------------------------------------------------------------------
bool RasterFile::HasMask() const
{
  const int flags = GDALGetMaskFlags(this->Band);
  return (flags & (GMF_PER_DATASET | GMF_ALPHA)) != 0;
}

//------------------------------------------------------------------------------
GDALRasterBandH RasterFile::FindBand(int overview) const
{
  GDALRasterBandH band = overview < 0 ? this->Band : GDALGetOverview(this->Band, overview);
  if (!band)
  {
    throw RasterError("its overview cannot be read");
  }
  return band;
}

namespace
{
/// Reads a window of a band or throws; any failure that GDAL reports counts, whatever it returns.
void ReadWindow(GDALRasterBandH band, const RasterWindow& window, void* buffer, GDALDataType type,
  std::int64_t pixelBytes, std::int64_t lineBytes)
{
  const GDALMessages messages;
  const auto width = static_cast<int>(window.Width);
  const auto height = static_cast<int>(window.Height);
  const CPLErr result =
    GDALRasterIOEx(band, GF_Read, static_cast<int>(window.X), static_cast<int>(window.Y), width,
      height, buffer, width, height, type, pixelBytes, lineBytes, nullptr);
  // What is read comes in whole blocks, once: to keep it would take as much memory as the samples.
  // (What the tiles of a directory read stays, up to GDAL's limit.)
  GDALFlushRasterCache(band);
  if (result != CE_None || !messages.GetFailure().empty())
  {
    throw RasterError("its samples cannot be read" +
      (messages.GetFailure().empty() ? "" : " (" + messages.GetFailure() + ")"));
  }
}

/// Signed bytes that GDAL has converted as if they had no sign.
template <typename T>
void RestoreSigns(
  const RasterWindow& window, void* buffer, std::int64_t pixelBytes, std::int64_t lineBytes)
{
  for (std::int64_t r = 0; r < window.Height; ++r)
  {
    for (std::int64_t c = 0; c < window.Width; ++c)
    {
      T& value = *reinterpret_cast<T*>(static_cast<char*>(buffer) + r * lineBytes + c * pixelBytes);
      value = value > T{ 127 } ? value - T{ 256 } : value;
    }
  }
}
}

//------------------------------------------------------------------------------
void RasterFile::Read(int overview, const RasterWindow& window, void* buffer, GDALDataType type,
  std::int64_t pixelBytes, std::int64_t lineBytes) const
{
  ReadWindow(this->FindBand(overview), window, buffer, type, pixelBytes, lineBytes);
  const bool signLost = this->GetType() == GDT_Byte && type != GDT_Byte && this->IsSignedByte();
  if (signLost && type == GDT_Float32)
  {
    RestoreSigns<float>(window, buffer, pixelBytes, lineBytes);
  }
  else if (signLost)
  {
    RestoreSigns<double>(window, buffer, pixelBytes, lineBytes);
  }
}

//------------------------------------------------------------------------------
void RasterFile::ReadMask(int overview, const RasterWindow& window, unsigned char* buffer,
  std::int64_t pixelBytes, std::int64_t lineBytes) const
{
  ReadWindow(
    GDALGetMaskBand(this->FindBand(overview)), window, buffer, GDT_Byte, pixelBytes, lineBytes);
}

//------------------------------------------------------------------------------
int RasterFile::FindOverview(double reduction) const
{
  const GDALMessages messages;
  int best = -1;
  auto bestWidth = static_cast<double>(this->GetWidth());
  const int count = GDALGetOverviewCount(this->Band);
  for (int k = 0; k < count; ++k)
  {
    GDALRasterBandH band = GDALGetOverview(this->Band, k);
    const double width = band ? GDALGetRasterBandXSize(band) : 0;
    const double height = band ? GDALGetRasterBandYSize(band) : 0;
    if (width < bestWidth && width * reduction >= static_cast<double>(this->GetWidth()) &&
      height * reduction >= static_cast<double>(this->GetHeight()))
    {
      best = k;
      bestWidth = width;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
void RasterFile::GetSize(int overview, std::int64_t& width, std::int64_t& height) const
{
  GDALRasterBandH band = this->FindBand(overview);
  width = GDALGetRasterBandXSize(band);
  height = GDALGetRasterBandYSize(band);
}

//------------------------------------------------------------------------------
std::int64_t RasterFile::GetBlockRows(int overview) const
{
  int width = 1;
  int height = 1;
  GDALGetBlockSize(this->FindBand(overview), &width, &height);
  return std::max(height, 1);
}

//------------------------------------------------------------------------------
std::int64_t RasterFile::GetBlockColumns(int overview) const
{
  int width = 1;
  int height = 1;
  GDALGetBlockSize(this->FindBand(overview), &width, &height);
  return std::max(width, 1);
}
}
