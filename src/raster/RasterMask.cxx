// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of RasterFile that says which samples are hidden.
#include "raster/RasterFile.h"

#include "raster/GDALTable.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace terrain
{
namespace
{
/// A number of an attribute, from `*text` on, which moves behind it; `otherwise` if there is none.
double NextNumber(const char** text, double otherwise)
{
  char* end = nullptr;
  const double value = std::strtod(*text, &end);
  const bool found = end != *text;
  *text = *end == ',' ? end + 1 : end;
  return found ? value : otherwise;
}
}

//------------------------------------------------------------------------------
bool RasterFile::HasFileMask() const
{
  // Neither all valid nor by one value: per dataset, an alpha band, or the special values of ISIS
  // and PDS4, which have no flag.
  return (GDALGetMaskFlags(this->Band) & (GMF_ALL_VALID | GMF_NODATA)) == 0;
}

//------------------------------------------------------------------------------
bool RasterFile::HasValidRange() const
{
  return std::isfinite(this->Holes.ValidLow) || std::isfinite(this->Holes.ValidHigh);
}

//------------------------------------------------------------------------------
// The alpha band at the end, of any type: GDAL makes masks of those of 8 and 16 bits only.
GDALRasterBandH RasterFile::FindAlpha() const
{
  const int last = GDALGetRasterCount(this->Dataset);
  GDALRasterBandH band = last > 1 ? GDALGetRasterBand(this->Dataset, last) : nullptr;
  return band && last != this->BandNumber && GDALGetRasterColorInterpretation(band) == GCI_AlphaBand
    ? band
    : nullptr;
}

//------------------------------------------------------------------------------
bool RasterFile::HasMask() const
{
  return this->HasFileMask() || this->FindAlpha() || this->HasValidRange();
}

//------------------------------------------------------------------------------
void RasterFile::ReadMask(int overview, const RasterWindow& window, unsigned char* buffer,
  std::int64_t pixelBytes, std::int64_t lineBytes) const
{
  GDALRasterBandH alpha = this->HasFileMask() ? nullptr : this->FindAlpha();
  GDALRasterBandH mask = alpha && overview >= 0 ? GDALGetOverview(alpha, overview) : alpha;
  if (alpha && !mask)
  {
    throw RasterError("the overview of its alpha band cannot be read");
  }
  ReadWindow(mask ? mask : GDALGetMaskBand(this->FindBand(overview)), window, buffer, GDT_Byte,
    pixelBytes, lineBytes);
  if (!this->HasValidRange())
  {
    return;
  }
  std::vector<double> samples(static_cast<std::size_t>(window.Width * window.Height));
  this->Read(overview, window, samples.data(), GDT_Float64, 8, 8 * window.Width);
  for (std::int64_t row = 0; row < window.Height; ++row)
  {
    for (std::int64_t column = 0; column < window.Width; ++column)
    {
      const double sample = samples[static_cast<std::size_t>(row * window.Width + column)];
      unsigned char& shown = buffer[row * lineBytes + column * pixelBytes];
      const bool isValid = sample >= this->Holes.ValidLow && sample <= this->Holes.ValidHigh;
      shown = isValid ? shown : 0;
    }
  }
}

//------------------------------------------------------------------------------
// CF's missing_value, one number or several, beside _FillValue, of which alone GDAL knows.
void RasterFile::TakeMissingValues()
{
  const char* item = GDALGetMetadataItem(this->Band, "missing_value", nullptr);
  const auto found = this->Attributes.find("missing_value");
  const std::string own = item ? item : "";
  const std::string written = found != this->Attributes.end() ? found->second : own;
  int declared = 0;
  const double known = GDALGetRasterNoDataValue(this->Band, &declared);
  const char* text = written.c_str();
  text += *text == '{' || *text == '[' ? 1 : 0;
  for (double value = NextNumber(&text, HUGE_VAL); value != HUGE_VAL;
       value = NextNumber(&text, HUGE_VAL))
  {
    const auto& more = this->MoreNoData;
    if (!(declared && known == value) && std::find(more.begin(), more.end(), value) == more.end())
    {
      this->MoreNoData.push_back(value);
    }
  }
}

//------------------------------------------------------------------------------
// CF's valid_range, valid_min and valid_max, in the numbers of the file.
void RasterFile::FindValidRange()
{
  double low = -HUGE_VAL;
  double high = HUGE_VAL;
  const auto attribute = [this](const char* name)
  {
    const auto found = this->Attributes.find(name);
    return found == this->Attributes.end() ? "" : found->second.c_str();
  };
  const char* range = attribute("valid_range");
  low = NextNumber(&range, low);
  high = NextNumber(&range, high);
  const char* least = attribute("valid_min");
  const char* most = attribute("valid_max");
  low = NextNumber(&least, low);
  high = NextNumber(&most, high);
  if (!std::isfinite(low) && !std::isfinite(high))
  {
    return;
  }
  const std::vector<double> samples = this->SampleBand();
  const auto seen = std::count_if(
    samples.begin(), samples.end(), [](double sample) { return std::isfinite(sample); });
  const auto outside = std::count_if(samples.begin(), samples.end(),
    [low, high](double sample) { return sample < low || sample > high; });
  const std::string text = NumberText(low) + " to " + NumberText(high);
  if (2 * outside > seen)
  {
    this->Record.Warn("it says that its valid values are " + text +
      ", but most of its samples lie beyond: that is not used (--nodata names what is no height)");
    return;
  }
  this->Holes.ValidLow = low;
  this->Holes.ValidHigh = high;
  this->Record.Take("valid values", text, "attributes");
}
}
