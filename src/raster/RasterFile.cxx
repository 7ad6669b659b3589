// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterFile.h"

#include "raster/GDALTable.h"
#include "raster/RasterArray.h"
#include "raster/RasterRepairs.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

namespace terrain
{
namespace
{
// GDAL >= 3.7 and >= 3.11; the numbers are part of its interface.
constexpr int kTypeInt8 = 14;
constexpr int kTypeFloat16 = 15;

bool IsColor(GDALColorInterp color)
{
  return color == GCI_RedBand || color == GCI_GreenBand || color == GCI_BlueBand ||
    color == GCI_PaletteIndex;
}
}

//------------------------------------------------------------------------------
RasterFile::RasterFile(std::string fileName, const std::string& part, FolderOpener openFolder)
  : Name(std::move(fileName))
{
  this->Dataset = OpenRaster(this->Name, part, this->Record, this->Held, openFolder);
  GDALDriverH driver = GDALGetDatasetDriver(this->Dataset);
  this->Replaced = driver && std::strcmp(GDALGetDriverShortName(driver), "MEM") == 0;
  if (driver && !this->Replaced)
  {
    this->Record.Take("format", GDALGetDriverLongName(driver), "GDAL");
  }
}

//------------------------------------------------------------------------------
RasterFile::RasterFile(const RasterMemory& memory)
  : Name(memory.Name)
  , Attributes(memory.Attributes)
  , Coordinates(std::make_unique<GridCoordinates>(memory.Coordinates))
  , CoordinatesSystem(memory.CoordinateSystem)
{
  RegisterDrivers();
  const GDALMessages messages;
  this->Dataset = MakeMemoryRaster(memory.Width, memory.Height, memory.Type, memory.Samples);
  GDALRasterBandH band = GDALGetRasterBand(this->Dataset, 1);
  GDALSetDescription(band, memory.Name.c_str());
  const auto number = [&memory](const char* name, double& value)
  {
    const auto found = memory.Attributes.find(name);
    char* end = nullptr;
    value = found == memory.Attributes.end() ? 0.0 : std::strtod(found->second.c_str(), &end);
    return found != memory.Attributes.end() && end != found->second.c_str();
  };
  double value = 0.0;
  if (number("scale_factor", value))
  {
    GDALSetRasterScale(band, value);
  }
  if (number("add_offset", value))
  {
    GDALSetRasterOffset(band, value);
  }
  for (const char* name : { "_FillValue", "nodatavals", "nodata" })
  {
    if (number(name, value))
    {
      this->MoreNoData.push_back(value);
    }
  }
  this->Record.Take("format", "samples in memory", "");
}

//------------------------------------------------------------------------------
RasterFile::~RasterFile()
{
  if (this->Reference)
  {
    OSRRelease(this->Reference);
  }
  const GDALMessages messages;
  if (this->Dataset)
  {
    GDALClose(this->Dataset);
  }
  this->Array.reset();
}

//------------------------------------------------------------------------------
void RasterFile::SelectBand(int band)
{
  const GDALMessages messages;
  const int count = GDALGetRasterCount(this->Dataset);
  if (band < 0 || band > count)
  {
    throw RasterError(
      "it has no band " + std::to_string(band) + ", its bands are 1 to " + std::to_string(count));
  }
  this->NumberOfBands = count;
  while (this->NumberOfBands > 1 &&
    GDALGetRasterColorInterpretation(GDALGetRasterBand(this->Dataset, this->NumberOfBands)) ==
      GCI_AlphaBand)
  {
    --this->NumberOfBands;
  }
  this->BandNumber = this->FindColors(band);
  this->Band = GDALGetRasterBand(this->Dataset, this->BandNumber);
  if (!this->Band)
  {
    throw RasterError(messages.GetFailure());
  }
  const GDALDataType type = GDALGetRasterDataType(this->Band);
  if (GDALDataTypeIsComplex(type))
  {
    throw RasterError("its samples are complex numbers, which are no heights; take their real part "
                      "(gdal_translate DERIVED_SUBDATASET:REAL:IN OUT.tif), or AMPLITUDE or PHASE "
                      "in place of REAL");
  }
  if (type == GDT_Unknown || this->GetWidth() < 1 || this->GetHeight() < 1)
  {
    throw RasterError("it has no samples");
  }
  if (count > 1)
  {
    const std::string description = GDALGetDescription(this->Band);
    this->Record.Take("band",
      std::to_string(this->BandNumber) + " of " + std::to_string(count) +
        (description.empty() ? "" : ", " + description),
      band > 0 ? "given" : "the first that is no colour");
  }
  if (band == 0 && this->BandNumber > 1 && this->FindNamedBand() == this->BandNumber)
  {
    this->Record.Warn("of its " + std::to_string(count) + " bands number " +
      std::to_string(this->BandNumber) + " is taken, which is called '" +
      this->GetBandDescription() + "' (--band 1 takes '" +
      GDALGetDescription(GDALGetRasterBand(this->Dataset, 1)) + "')");
  }
}

//------------------------------------------------------------------------------
// The band to take for 0: throws for colour images, unless one band only is none of their colours.
int RasterFile::FindColors(int band) const
{
  if (band > 0)
  {
    return band;
  }
  const int count = GDALGetRasterCount(this->Dataset);
  int opaque = 0;
  int plain = 0;
  int plainBand = 1;
  bool bytes = true;
  bool colors = false;
  for (int k = 1; k <= count; ++k)
  {
    GDALRasterBandH other = GDALGetRasterBand(this->Dataset, k);
    const GDALColorInterp color = GDALGetRasterColorInterpretation(other);
    if (color == GCI_AlphaBand)
    {
      continue;
    }
    const bool isByte = GDALGetRasterDataType(other) == GDT_Byte;
    ++opaque;
    bytes = bytes && isByte;
    colors = colors || IsColor(color);
    plain += isByte || IsColor(color) ? 0 : 1;
    plainBand = isByte || IsColor(color) ? plainBand : k;
  }
  if (colors && plain == 1)
  {
    return plainBand;
  }
  if (colors || (opaque > 2 && bytes))
  {
    throw RasterError("it looks like a colour image of " + std::to_string(count) +
      (count == 1 ? " band" : " bands") +
      ", not like heights; choose a band to use it as heights (--band 1), unless heights are "
      "packed into the colours: unpack those first, terrarium by gdal_calc.py -A IN --A_band=1 -B "
      "IN --B_band=2 -C IN --C_band=3 --type=Float32 --outfile=OUT.tif "
      "--calc='A*256.+B+C/256.-32768', terrain-RGB by the same with "
      "--calc='(A*65536.+B*256.+C)*.1-10000'");
  }
  return this->FindNamedBand();
}

//------------------------------------------------------------------------------
// The first band, or the only one that is called as heights are where the first is called
// otherwise.
int RasterFile::FindNamedBand() const
{
  const auto isHeights = [this](int band)
  { return HasWordOfHeights(GDALGetDescription(GDALGetRasterBand(this->Dataset, band))); };
  int found = 1;
  int count = 0;
  const char* first = GDALGetDescription(GDALGetRasterBand(this->Dataset, 1));
  const bool isOther = first && *first != '\0' && !isHeights(1);
  for (int band = 2; isOther && band <= this->NumberOfBands; ++band)
  {
    found = isHeights(band) ? band : found;
    count += isHeights(band) ? 1 : 0;
  }
  return count == 1 ? found : 1;
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
  if (this->GetType() != GDT_Byte)
  {
    return false;
  }
  const GDALMessages messages; // later versions of GDAL complain about the question
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
  scale *= this->Heights.Factor;
  offset = this->Heights.Factor * offset + this->Heights.Offset;
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

//------------------------------------------------------------------------------
// Throws for any failure that GDAL reports, whatever it returns.
void RasterFile::ReadWindow(GDALRasterBandH band, const RasterWindow& window, void* buffer,
  GDALDataType type, std::int64_t pixelBytes, std::int64_t lineBytes)
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
      (messages.GetFailure().empty() ? "" : " (" + messages.GetFailure() + ")") +
      ": the file may be incomplete");
  }
}

namespace
{
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
