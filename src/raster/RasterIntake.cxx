// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of RasterFile that finds what the samples mean: holes, unit, sense; and that puts an
// even raster in the place of an uneven one.
#include "raster/RasterFile.h"

#include "raster/CoordinateSystem.h"
#include "raster/GDALTable.h"
#include "raster/GridResample.h"
#include "raster/RasterArray.h"
#include "raster/RasterHoles.h"
#include "raster/RasterReference.h"
#include "raster/RasterRepairs.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace terrain
{
namespace
{
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
// Values that can only be fill in bands of signed numbers without a scale, seen or not.
constexpr std::array<double, 2> kImpossibleHeights{ { -32768.0, -32767.0 } };
constexpr double kUnlikelyHeight = -9999.0;
// Where heights reach below this, kUnlikelyHeight may be one.
constexpr double kDeepSea = -8000.0;
constexpr double kDeepestSea = -12000.0;
// Floating-point values beyond this are fill, declared or not.
constexpr double kFillLimit = 1e30;
// How much of a file is looked at: all of a small one, else blocks of the whole of it, the same
// ones for each of its pieces.
constexpr std::int64_t kSmallFile = std::int64_t{ 1 } << 20;
constexpr std::int64_t kSampledPixels = std::int64_t{ 1 } << 21;
constexpr std::int64_t kMostBlocks = 48;
// Of the blocks of a large file every third sample, for sorting them takes longer than reading.
constexpr std::size_t kSampleStep = 3;
// Samples of an even raster in memory.
constexpr std::int64_t kMostSamples = std::int64_t{ 1 } << 28;
// Beyond this latitude a grid of longitude and latitude is of no use.
constexpr double kPolarLatitude = 80.0;

bool IsSigned(GDALDataType type)
{
  return type == GDT_Int16 || type == GDT_Int32 || type == GDT_Float32 || type == GDT_Float64;
}

bool Holds(const std::vector<double>& values, double value)
{
  return std::find(values.begin(), values.end(), value) != values.end();
}

std::string ListNumbers(const std::vector<double>& values)
{
  constexpr std::size_t kListedValues = 4;
  std::vector<std::string> names;
  names.reserve(values.size());
  for (const double value : values)
  {
    names.push_back(NumberText(value));
  }
  return ListText(names, kListedValues);
}

/// Values that are no heights in bands of signed numbers of metres among these samples.
std::vector<double> ListImpossible(const std::vector<double>& samples)
{
  std::vector<double> values(kImpossibleHeights.begin(), kImpossibleHeights.end());
  const bool isDeep = std::any_of(samples.begin(), samples.end(),
    [](double value)
    { return value < kDeepSea && value > kDeepestSea && value != kUnlikelyHeight; });
  values.insert(values.end(), isDeep ? 0 : 1, kUnlikelyHeight);
  return values;
}

/// Adds what becomes of values in samples of 16 bits with a mantissa of 11, rounded or cut off.
void AddHalves(std::vector<double>& values)
{
  constexpr int kMantissa = 10;
  const std::vector<double> whole = values;
  for (const double value : whole)
  {
    if (std::isfinite(value) && value != 0.0)
    {
      const double step = std::ldexp(1.0, std::ilogb(value) - kMantissa);
      values.push_back(step * std::round(value / step));
      values.push_back(step * std::trunc(value / step));
    }
  }
}

/// Longitudes of neighbours differ by less than half a turn.
void UnwrapField(std::vector<double>& x, std::size_t width)
{
  for (std::size_t k = 1; k < x.size(); ++k)
  {
    const double before = k % width == 0 ? x[k - width] : x[k - 1];
    if (std::isfinite(before) && std::isfinite(x[k]))
    {
      x[k] -= 360.0 * std::round((x[k] - before) / 360.0);
    }
  }
}

/// A polar stereographic CRS for a field near a pole, whose places become metres of it; empty for
/// others.
std::string ProjectPolarField(std::vector<double>& x, std::vector<double>& y)
{
  double low = 90.0;
  double high = -90.0;
  for (const double latitude : y)
  {
    low = std::isfinite(latitude) ? std::min(low, latitude) : low;
    high = std::isfinite(latitude) ? std::max(high, latitude) : high;
  }
  const bool north = high > kPolarLatitude && low > 0.0;
  const bool south = low < -kPolarLatitude && high < 0.0;
  if (!north && !south)
  {
    return {};
  }
  std::string system = std::string("+proj=stere +lat_0=") + (north ? "90" : "-90") +
    " +lon_0=0 +datum=WGS84 +units=m +type=crs";
  CoordinateSystem projection;
  if (!projection.Read(system).empty())
  {
    return {};
  }
  std::vector<double> points;
  for (std::size_t k = 0; k < x.size(); ++k)
  {
    points.insert(points.end(), { x[k], y[k] });
  }
  projection.FromPlaces(points.data(), static_cast<std::int64_t>(x.size()), 0.0, 2);
  for (std::size_t k = 0; k < x.size(); ++k)
  {
    x[k] = points[2 * k];
    y[k] = points[2 * k + 1];
  }
  return system;
}
}

//------------------------------------------------------------------------------
void RasterFile::Replace(GDALDatasetH dataset)
{
  GDALClose(this->Dataset);
  this->Dataset = dataset;
  this->BandNumber = 1;
  this->Band = GDALGetRasterBand(dataset, 1);
  this->Replaced = true;
}

//------------------------------------------------------------------------------
std::vector<double> RasterFile::GetDeclaredNoData() const
{
  std::vector<double> values;
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
  if (declared)
  {
    values.push_back(value);
  }
  values.insert(values.end(), this->MoreNoData.begin(), this->MoreNoData.end());
  const char* bits = GDALGetMetadataItem(this->Band, "NBITS", "IMAGE_STRUCTURE");
  if (bits && std::atoi(bits) == 16 && this->GetType() == GDT_Float32)
  {
    AddHalves(values);
  }
  for (double& each : values)
  {
    if (type == GDT_Byte && this->IsSignedByte() && each > 127.0)
    {
      each -= 256.0;
    }
    if (type == GDT_Float32)
    {
      // The tag may be a decimal rounding of the value, beyond the type's range even.
      const bool fits = std::fabs(each) <= std::numeric_limits<float>::max();
      each = fits ? static_cast<double>(static_cast<float>(each)) : kNaN;
    }
  }
  values.erase(
    std::remove_if(values.begin(), values.end(), [](double each) { return std::isnan(each); }),
    values.end());
  return values;
}

//------------------------------------------------------------------------------
// Samples of some blocks, NaN where they are declared or masked to have no data.
std::vector<double> RasterFile::SampleBand() const
{
  int blockWidth = 1;
  int blockHeight = 1;
  GDALGetBlockSize(this->Band, &blockWidth, &blockHeight);
  const bool isSmall = this->GetWidth() * this->GetHeight() <= kSmallFile;
  const std::int64_t width = isSmall ? this->GetWidth() : std::max(blockWidth, 1);
  const std::int64_t height = isSmall ? this->GetHeight() : std::max(blockHeight, 1);
  const std::int64_t across = (this->GetWidth() + width - 1) / width;
  const std::int64_t count = across * ((this->GetHeight() + height - 1) / height);
  const std::int64_t samples =
    std::min(count, std::clamp<std::int64_t>(kSampledPixels / (width * height), 2, kMostBlocks));
  const bool masked = this->HasMask();
  const std::size_t step = isSmall ? 1 : kSampleStep;
  std::vector<double> values;
  std::vector<double> read;
  std::vector<unsigned char> mask;
  for (std::int64_t k = 0; k < samples; ++k)
  {
    const std::int64_t block = (2 * k + 1) * count / (2 * samples);
    RasterWindow window{ block % across * width, block / across * height, width, height };
    window.Width = std::min(width, this->GetWidth() - window.X);
    window.Height = std::min({ height, this->GetHeight() - window.Y,
      std::max<std::int64_t>(kSampledPixels / window.Width, 1) });
    read.resize(static_cast<std::size_t>(window.Width * window.Height));
    this->Read(-1, window, read.data(), GDT_Float64, 8, 8 * window.Width);
    if (masked)
    {
      mask.resize(read.size());
      this->ReadMask(-1, window, mask.data(), 1, window.Width);
    }
    for (std::size_t sample = 0; sample < read.size(); sample += step)
    {
      const double value = read[sample];
      const bool hidden = (masked && mask[sample] == 0) || Holds(this->Holes.Declared, value);
      values.push_back(hidden ? kNaN : value);
    }
  }
  return values;
}

//------------------------------------------------------------------------------
void RasterFile::FindHoles(const RasterOptions& options)
{
  this->TakeMissingValues();
  this->Holes.Declared = this->GetDeclaredNoData();
  if (!this->Holes.Declared.empty())
  {
    this->Record.Take("no data", ListNumbers(this->Holes.Declared), "declared");
  }
  if (this->HasMask())
  {
    this->Record.Take("mask", "hides samples", "the file's mask");
  }
  const bool isDeclared = !this->Holes.Declared.empty();
  if (options.UseNoData)
  {
    // what messages tell has fewer digits than the samples
    const bool rounds = this->GetType() == GDT_Float32 &&
      std::abs(options.NoData) <= std::numeric_limits<float>::max();
    this->Holes.Declared.push_back(
      rounds ? static_cast<double>(static_cast<float>(options.NoData)) : options.NoData);
    this->Record.Take("no data, too", NumberText(options.NoData), "given");
  }
  this->FindValidRange();
  const std::vector<double> samples = this->SampleBand();
  this->Holes.Seen = FindFill(samples);
  const auto width = static_cast<std::size_t>(this->GetWidth());
  if (samples.size() == width * static_cast<std::size_t>(this->GetHeight()))
  {
    FindLone(samples, width, this->Holes.Seen);
  }
  this->Holes.Low = this->Holes.Seen.Low;
  this->Holes.High = this->Holes.Seen.High;
  if (!options.DetectNoData || options.UseNoData)
  {
    return;
  }
  this->Holes.Undeclared = this->Holes.Seen.Values;
  std::vector<double> seen = this->Holes.Undeclared;
  double scale = 1.0;
  double offset = 0.0;
  this->GetScaleAndOffset(scale, offset);
  if (!isDeclared && IsSigned(this->GetType()) && scale == 1.0 && offset == 0.0)
  {
    for (const double value : ListImpossible(samples))
    {
      if (!Holds(this->Holes.Undeclared, value))
      {
        this->Holes.Undeclared.push_back(value);
        seen.insert(seen.end(), Holds(samples, value) ? 1 : 0, value);
      }
    }
  }
  this->Holes.UndeclaredOccurs = !seen.empty();
  if (this->Holes.UndeclaredOccurs)
  {
    this->Record.Take("fill", ListNumbers(seen), "taken for no data, which nobody declares");
  }
}

//------------------------------------------------------------------------------
void RasterFile::FindHeights(const RasterOptions& options)
{
  HeightFacts facts = FactsOfBand(this->Dataset, this->Band, this->Reference);
  facts.Option = options.HeightUnit;
  const auto attribute = [this](const char* name, std::string& fact)
  {
    const auto found = this->Attributes.find(name);
    fact = fact.empty() && found != this->Attributes.end() ? found->second : fact;
  };
  attribute("NETCDF_VARNAME", facts.Variable);
  attribute("units", facts.BandUnit);
  attribute("positive", facts.Positive);
  attribute("standard_name", facts.StandardName);
  attribute("long_name", facts.LongName);
  double scale = 1.0;
  double offset = 0.0;
  this->GetScaleAndOffset(scale, offset);
  if (this->Holes.Low <= this->Holes.High)
  {
    facts.Low = offset + scale * (scale > 0.0 ? this->Holes.Low : this->Holes.High);
    facts.High = offset + scale * (scale > 0.0 ? this->Holes.High : this->Holes.Low);
  }
  if (scale != 1.0 || offset != 0.0)
  {
    this->Record.Take(
      "scale", NumberText(offset) + " + " + NumberText(scale) + " x sample", "band");
  }
  this->Heights = FindHeightMeaning(facts, this->Record);
  this->TakeRadii();
}

//------------------------------------------------------------------------------
// Distances from the centre of a body, as grids of planets have them, become heights above the
// ellipsoid of the CRS, or above the offset that the band itself names.
void RasterFile::TakeRadii()
{
  constexpr double kLeastRadius = 0.9;
  constexpr double kSmallestBody = 1e4; // metres
  double scale = 1.0;
  double offset = 0.0;
  this->GetScaleAndOffset(scale, offset);
  OGRErr error = OGRERR_NONE;
  const double named = this->Reference ? OSRGetSemiMajor(this->Reference, &error) : 0.0;
  const double radius = error == OGRERR_NONE && named > 0.0 ? named : offset;
  const double low = offset + std::min(scale * this->Holes.Low, scale * this->Holes.High);
  const double high = offset + std::max(scale * this->Holes.Low, scale * this->Holes.High);
  if (this->Holes.Low > this->Holes.High || radius < kSmallestBody || low < kLeastRadius * radius ||
    high > radius / kLeastRadius)
  {
    return;
  }
  this->Heights.Offset = -radius;
  const bool isNamed = radius != offset;
  this->Record.Take("radii",
    "heights are distances from the centre less " + NumberText(radius) + " m",
    isNamed ? "ellipsoid of the CRS" : "offset of the band");
  const double inverse = isNamed ? OSRGetInvFlattening(this->Reference, &error) : 0.0;
  if (inverse > 0.0)
  {
    this->Record.Warn("its heights are distances from the centre of a flattened body: they are "
                      "drawn above a sphere of its largest radius, " +
      NumberText(radius) + " m, so that they fall towards the poles by up to " +
      NumberText(radius / inverse) + " m (gdal_calc.py subtracts the radius of each latitude)");
  }
}

//------------------------------------------------------------------------------
// All samples as doubles, NaN for holes; tells of the undeclared ones.
std::vector<double> RasterFile::ReadHeights()
{
  const std::int64_t width = this->GetWidth();
  const std::int64_t height = this->GetHeight();
  if (width * height > kMostSamples)
  {
    throw RasterError(
      "its samples are not evenly spaced, and it is too large to be resampled in memory; "
      "read a part of it");
  }
  std::vector<double> values(static_cast<std::size_t>(width * height));
  const RasterWindow all{ 0, 0, width, height };
  this->Read(-1, all, values.data(), GDT_Float64, 8, 8 * width);
  std::vector<unsigned char> mask;
  if (this->HasMask())
  {
    mask.resize(values.size());
    this->ReadMask(-1, all, mask.data(), 1, width);
  }
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    const bool hidden = (!mask.empty() && mask[k] == 0) || Holds(this->Holes.Declared, values[k]) ||
      Holds(this->Holes.Undeclared, values[k]) || !(std::abs(values[k]) < kFillLimit);
    values[k] = hidden ? kNaN : values[k];
  }
  return values;
}

//------------------------------------------------------------------------------
std::vector<double> RasterFile::MakeEven(EvenGrid& grid)
{
  GridPlace& place = this->Uneven;
  place.IsGeographic = place.IsGeographic || (this->Reference && OSRIsGeographic(this->Reference));
  const auto width = static_cast<std::size_t>(this->GetWidth());
  const std::vector<double> heights = this->ReadHeights();
  if (!place.IsField)
  {
    grid = PlanEvenGrid(place.X, place.Y, kMostSamples);
    return ResampleAxes(place.X, place.Y, heights, grid);
  }
  const std::string polar =
    place.IsGeographic ? ProjectPolarField(place.X, place.Y) : std::string();
  if (!polar.empty())
  {
    this->SetReference(polar, "stereographic, since longitudes meet at the pole");
  }
  const bool isDegrees = place.IsGeographic && polar.empty();
  if (isDegrees)
  {
    UnwrapField(place.X, width);
  }
  grid = PlanEvenGrid(place.X, place.Y, width, isDegrees, kMostSamples);
  return grid.Width == 0
    ? std::vector<double>()
    : ResampleField(place.X, place.Y, heights, width, isDegrees ? 180.0 : HUGE_VAL, grid);
}

//------------------------------------------------------------------------------
void RasterFile::ReplaceByHeights(std::vector<double> heights, int width, int height)
{
  GDALDatasetH dataset = MakeMemoryRaster(width, height, GDT_Float64, nullptr);
  GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  CopyBandFacts(this->Band, band);
  GDALDeleteRasterNoDataValue(band);
  if (GDALRasterIO(band, GF_Write, 0, 0, width, height, heights.data(), width, height, GDT_Float64,
        0, 0) != CE_None)
  {
    GDALClose(dataset);
    throw RasterError("there is not enough memory for its samples; limit their number");
  }
  this->Replace(dataset);
  this->Array.reset();
}

//------------------------------------------------------------------------------
void RasterFile::Resample()
{
  if (this->Uneven.X.empty())
  {
    return;
  }
  EvenGrid grid;
  std::vector<double> even = this->MakeEven(grid);
  if (even.empty())
  {
    throw RasterError("the coordinates of its samples span no area");
  }
  this->ReplaceByHeights(
    std::move(even), static_cast<int>(grid.Width), static_cast<int>(grid.Height));
  this->MoreNoData.clear();
  this->Holes.Declared.clear();
  if (!this->Holes.Undeclared.empty() && this->Holes.UndeclaredOccurs)
  {
    this->Record.Warn("samples of " + NumberText(this->Holes.Undeclared.front()) +
      " are taken for no data, which the file does not declare (--nodata none if they are "
      "heights)");
  }
  this->Holes.Undeclared.clear();
  this->Transform = grid.GeoTransform;
  this->HasTransform = true;
  this->Record.Take("resampled",
    "to " + std::to_string(grid.Width) + " x " + std::to_string(grid.Height) + " samples, " +
      NumberText(grid.GeoTransform[1]) + " x " + NumberText(-grid.GeoTransform[5]) + " apart",
    "bilinear, through the coordinates");
}

//------------------------------------------------------------------------------
void RasterFile::TakeIn(const RasterOptions& options)
{
  const GDALMessages messages;
  this->FindPlace(options);
  this->TurnFileAxes();
  this->PlaceSheared();
  this->FindHoles(options);
  this->FindHeights(options);
  this->PlaceByPolynomials();
  this->Resample();
  if (options.Flip)
  {
    std::array<double, 6>& t = this->Transform;
    t = { t[0], t[1], t[2], t[3] + static_cast<double>(this->GetHeight()) * t[5], t[4], -t[5] };
    this->Record.Take("rows", "turned over", "given");
  }
  this->MakeLayout();
  this->WarnOfPlace();
  this->Layout.NorthFirst = this->HasTransform ? this->Layout.NorthFirst : !options.Flip;
  this->CheckSanity();
  for (const std::string& warning : messages.GetWarnings())
  {
    this->Record.Warn("GDAL: " + warning);
  }
}
}
