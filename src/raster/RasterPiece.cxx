// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterPiece.h"

#include "core/grid/Heightfield.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace terrain
{
namespace
{
// Pixels read at once, if the file's blocks allow it.
constexpr std::int64_t kStripePixels = std::int64_t{ 1 } << 22;
// A reduced sample has a height where at least this share of its area has.
constexpr double kLeastShare = 0.5 - 1e-9;

template <typename T>
constexpr GDALDataType TypeOf(const RasterFile& file)
{
  if constexpr (std::is_same_v<T, float>)
  {
    return GDT_Float32;
  }
  else if constexpr (std::is_same_v<T, double>)
  {
    return GDT_Float64;
  }
  else
  {
    return file.GetType();
  }
}

/// Rows of the file that are read together, the next ones from `row` on.
std::int64_t CountStripeRows(
  std::int64_t row, std::int64_t end, std::int64_t width, std::int64_t blockRows)
{
  const std::int64_t blocks = std::max<std::int64_t>(kStripePixels / (width * blockRows), 1);
  const std::int64_t next = (row / blockRows + blocks) * blockRows;
  return std::min(next, end) - row;
}

/// The rectangle of the file's pixels (or reduced samples) that an extent of samples is.
RasterWindow FindSource(const RasterRequest& request)
{
  const std::int64_t* extent = request.Extent;
  return { request.EastFirst ? request.Width - 1 - extent[1] : extent[0],
    request.NorthFirst ? request.Height - 1 - extent[3] : extent[2], extent[1] - extent[0] + 1,
    extent[3] - extent[2] + 1 };
}

/// Marks samples without a height, and brings the others to the unit of heights.
template <typename T>
class Classifier
{
public:
  Classifier(const RasterRequest& request, T* samples)
    : Request(request)
    , Samples(samples)
    , IsScaled(request.Scale != 1.0 || request.Offset != 0.0)
  {
    this->Keep(request.NoData, this->NoData);
    this->Keep(request.UndeclaredNoData, this->UndeclaredNoData);
  }

  /// Samples [index, index + count); mask (one byte each, 0 is no data) may be null.
  void Classify(std::int64_t index, std::int64_t count, const unsigned char* mask)
  {
    if (mask)
    {
      for (std::int64_t k = 0; k < count; ++k)
      {
        if (mask[k] == 0)
        {
          this->SetNone(index + k);
        }
      }
    }
    for (const T value : this->NoData)
    {
      this->SetNoneWhere(index, count, value);
    }
    for (const T value : this->UndeclaredNoData)
    {
      const std::int64_t found = this->SetNoneWhere(index, count, value);
      if (found > 0)
      {
        this->Findings.Undeclared[static_cast<double>(value)] += found;
      }
    }
    this->SetNoneWhereNotFinite(index, count);
    this->ScaleHeights(index, count);
  }

  void SetNone(std::int64_t index)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      this->Samples[index] = std::numeric_limits<T>::quiet_NaN();
    }
    else
    {
      if (!this->Hidden)
      {
        this->Hidden = this->Request.Hidden();
      }
      this->Hidden[index] = this->Request.HiddenMark;
      this->Samples[index] = T{ 0 };
    }
  }

  RasterFindings Findings;

private:
  void Keep(const std::vector<double>& values, std::vector<T>& kept) const
  {
    for (const double value : values)
    {
      if (value >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
        value <= static_cast<double>(std::numeric_limits<T>::max()) &&
        static_cast<double>(static_cast<T>(value)) == value)
      {
        kept.push_back(static_cast<T>(value));
      }
    }
  }

  std::int64_t SetNoneWhere(std::int64_t index, std::int64_t count, T value)
  {
    const T* samples = this->Samples + index;
    std::int64_t found = std::count(samples, samples + count, value);
    if (found == 0)
    {
      return 0;
    }
    found = 0;
    for (std::int64_t k = 0; k < count; ++k)
    {
      // A sample that the mask has set to 0 already is none of these.
      if (samples[k] == value && !(this->Hidden && this->Hidden[index + k]))
      {
        this->SetNone(index + k);
        ++found;
      }
    }
    return found;
  }

  void SetNoneWhereNotFinite(std::int64_t index, std::int64_t count)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      for (std::int64_t k = index; k < index + count; ++k)
      {
        const T value = this->Samples[k];
        this->Samples[k] = IsHeight(value) ? value : std::numeric_limits<T>::quiet_NaN();
      }
    }
  }

  void ScaleHeights(std::int64_t index, std::int64_t count)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      for (std::int64_t k = index; this->IsScaled && k < index + count; ++k)
      {
        this->Samples[k] = static_cast<T>(
          this->Request.Offset + this->Request.Scale * static_cast<double>(this->Samples[k]));
      }
    }
  }

  const RasterRequest& Request;
  T* Samples;
  bool IsScaled;
  std::vector<T> NoData;
  std::vector<T> UndeclaredNoData;
  unsigned char* Hidden = nullptr;
};

/// Every pixel a sample: stripes of the file straight into place.
template <typename T>
RasterFindings ReadFull(const RasterFile& file, const RasterRequest& request, T* samples)
{
  constexpr auto kBytes = static_cast<std::int64_t>(sizeof(T));
  Classifier<T> classifier(request, samples);
  RasterWindow source = FindSource(request);
  const std::int64_t width = source.Width;
  source.X += request.Window.X;
  source.Y += request.Window.Y;
  const std::int64_t end = source.Y + source.Height;
  const bool masked = file.HasMask();
  std::vector<unsigned char> mask;
  for (std::int64_t row = source.Y; row < end;)
  {
    const std::int64_t rows = CountStripeRows(row, end, width, file.GetBlockRows(-1));
    // Output rows [first, first + rows), of which the file's first one goes to the last or the
    // first.
    const std::int64_t first = request.NorthFirst ? end - row - rows : row - source.Y;
    const std::int64_t corner =
      (request.NorthFirst ? width * (rows - 1) : 0) + (request.EastFirst ? width - 1 : 0);
    const std::int64_t pixelStep = request.EastFirst ? -1 : 1;
    const std::int64_t lineStep = request.NorthFirst ? -width : width;
    const RasterWindow stripe{ source.X, row, width, rows };
    file.Read(-1, stripe, samples + width * first + corner, TypeOf<T>(file), pixelStep * kBytes,
      lineStep * kBytes);
    if (masked)
    {
      mask.resize(static_cast<std::size_t>(width * rows));
      file.ReadMask(-1, stripe, mask.data() + corner, pixelStep, lineStep);
    }
    classifier.Classify(width * first, width * rows, masked ? mask.data() : nullptr);
    row += rows;
    if (!request.Progress(
          static_cast<double>(row - source.Y) / static_cast<double>(end - source.Y)))
    {
      classifier.Findings.Completed = false;
      break;
    }
  }
  return classifier.Findings;
}

/// Pixels that a sample covers along one axis, with the share of each.
struct Footprint
{
  std::int64_t First;
  std::int64_t Last;
  double FirstShare;
  double LastShare;

  Footprint(double begin, double end, std::int64_t size)
  {
    this->First = std::min(static_cast<std::int64_t>(begin), size - 1);
    this->Last = std::clamp(static_cast<std::int64_t>(std::ceil(end)) - 1, this->First, size - 1);
    if (this->First == this->Last)
    {
      this->FirstShare = this->LastShare = end - begin;
      return;
    }
    this->FirstShare = static_cast<double>(this->First + 1) - begin;
    this->LastShare = end - static_cast<double>(this->Last);
  }

  double Share(std::int64_t pixel) const
  {
    if (pixel == this->First)
    {
      return this->FirstShare;
    }
    return pixel == this->Last ? this->LastShare : 1.0;
  }
};

/// Rows of pixels as double with NaN for no data; reads stripes, gives them row by row.
class StripeReader
{
public:
  StripeReader(const RasterFile& file, RasterRequest request, int overview,
    std::int64_t firstColumn, std::int64_t columns, std::int64_t lastRow)
    : File(file)
    , Request(std::move(request))
    , Overview(overview)
    , FirstColumn(firstColumn)
    , Columns(columns)
    , LastRow(lastRow)
  {
    this->Request.Scale = 1.0;
    this->Request.Offset = 0.0;
  }

  const double* GetRow(std::int64_t row)
  {
    if (row < this->Begin || row >= this->End)
    {
      this->ReadStripe(row);
    }
    return &this->Values[static_cast<std::size_t>(this->Columns * (row - this->Begin))];
  }

  RasterFindings Findings;

private:
  void ReadStripe(std::int64_t row)
  {
    const std::int64_t rows = CountStripeRows(
      row, this->LastRow + 1, this->Columns, this->File.GetBlockRows(this->Overview));
    this->Begin = row;
    this->End = row + rows;
    const auto count = static_cast<std::size_t>(this->Columns * rows);
    this->Values.resize(count);
    const RasterWindow stripe{ this->FirstColumn, row, this->Columns, rows };
    this->File.Read(this->Overview, stripe, this->Values.data(), GDT_Float64, 8, 8 * this->Columns);
    const bool masked = this->File.HasMask();
    if (masked)
    {
      this->Mask.resize(count);
      this->File.ReadMask(this->Overview, stripe, this->Mask.data(), 1, this->Columns);
    }
    Classifier<double> classifier(this->Request, this->Values.data());
    classifier.Classify(0, this->Columns * rows, masked ? this->Mask.data() : nullptr);
    for (const auto& [value, found] : classifier.Findings.Undeclared)
    {
      this->Findings.Undeclared[value] += found;
    }
  }

  const RasterFile& File;
  RasterRequest Request;
  int Overview;
  std::int64_t FirstColumn;
  std::int64_t Columns;
  std::int64_t LastRow;
  std::int64_t Begin = 0;
  std::int64_t End = 0;
  std::vector<double> Values;
  std::vector<unsigned char> Mask;
};

/// Sum of heights and of areas with heights under one row of samples.
class RowAverage
{
public:
  RowAverage(std::vector<Footprint> columns, std::int64_t firstColumn)
    : Columns(std::move(columns))
    , FirstColumn(firstColumn)
    , Sums(this->Columns.size())
    , Areas(this->Columns.size())
  {
  }

  void Clear()
  {
    std::fill(this->Sums.begin(), this->Sums.end(), 0.0);
    std::fill(this->Areas.begin(), this->Areas.end(), 0.0);
  }

  void Add(const double* row, double share)
  {
    for (std::size_t k = 0; k < this->Columns.size(); ++k)
    {
      const Footprint& column = this->Columns[k];
      for (std::int64_t c = column.First; c <= column.Last; ++c)
      {
        const double value = row[c - this->FirstColumn];
        const double area = std::isnan(value) ? 0.0 : share * column.Share(c);
        this->Sums[k] += area > 0.0 ? area * value : 0.0;
        this->Areas[k] += area;
      }
    }
  }

  /// Mean of sample k, NaN where less than half of `area` has heights.
  double Mean(std::size_t k, double area) const
  {
    return this->Areas[k] >= kLeastShare * area ? this->Sums[k] / this->Areas[k]
                                                : std::numeric_limits<double>::quiet_NaN();
  }

private:
  std::vector<Footprint> Columns;
  std::int64_t FirstColumn;
  std::vector<double> Sums;
  std::vector<double> Areas;
};

/// Samples as areas of an overview or of the full resolution, along one axis: pixels of that level.
struct Reduction
{
  double Begin; // of the window
  double Size;  // of a sample
  std::int64_t Pixels;

  Footprint Find(std::int64_t sample) const
  {
    const double begin = this->Begin + this->Size * static_cast<double>(sample);
    return { begin, begin + this->Size, this->Pixels };
  }
};

Reduction MakeReduction(std::int64_t levelSize, std::int64_t fullSize, std::int64_t begin,
  std::int64_t size, std::int64_t samples)
{
  const double ratio = static_cast<double>(levelSize) / static_cast<double>(fullSize);
  return { static_cast<double>(begin) * ratio,
    static_cast<double>(size) * ratio / static_cast<double>(samples), levelSize };
}

/// Mean height to a sample of type T; NaN is no height.
template <typename T>
void StoreMean(const RasterRequest& request, double mean, std::int64_t index,
  Classifier<T>& classifier, T* samples)
{
  if (std::isnan(mean))
  {
    classifier.SetNone(index);
  }
  else if constexpr (std::is_floating_point_v<T>)
  {
    samples[index] = static_cast<T>(request.Offset + request.Scale * mean);
  }
  else
  {
    samples[index] = static_cast<T>(std::floor(mean + 0.5));
  }
}

template <typename T>
RasterFindings ReadReduced(const RasterFile& file, const RasterRequest& request, T* samples)
{
  const double ratioX =
    static_cast<double>(request.Window.Width) / static_cast<double>(request.Width);
  const double ratioY =
    static_cast<double>(request.Window.Height) / static_cast<double>(request.Height);
  const int overview = request.UseOverviews ? file.FindOverview(std::min(ratioX, ratioY)) : -1;
  std::int64_t levelWidth = 0;
  std::int64_t levelHeight = 0;
  file.GetSize(overview, levelWidth, levelHeight);
  const Reduction alongX = MakeReduction(
    levelWidth, file.GetWidth(), request.Window.X, request.Window.Width, request.Width);
  const Reduction alongY = MakeReduction(
    levelHeight, file.GetHeight(), request.Window.Y, request.Window.Height, request.Height);
  const RasterWindow source = FindSource(request);
  std::vector<Footprint> columns;
  for (std::int64_t c = 0; c < source.Width; ++c)
  {
    columns.push_back(alongX.Find(source.X + c));
  }
  const std::int64_t firstColumn = columns.front().First;
  const std::int64_t columnCount = columns.back().Last - firstColumn + 1;
  StripeReader reader(file, request, overview, firstColumn, columnCount,
    alongY.Find(source.Y + source.Height - 1).Last);
  RowAverage average(std::move(columns), firstColumn);
  Classifier<T> classifier(request, samples);
  for (std::int64_t r = 0; r < source.Height; ++r)
  {
    average.Clear();
    const Footprint rows = alongY.Find(source.Y + r);
    for (std::int64_t row = rows.First; row <= rows.Last; ++row)
    {
      average.Add(reader.GetRow(row), rows.Share(row));
    }
    const std::int64_t line = request.NorthFirst ? source.Height - 1 - r : r;
    for (std::int64_t c = 0; c < source.Width; ++c)
    {
      const std::int64_t index =
        source.Width * line + (request.EastFirst ? source.Width - 1 - c : c);
      StoreMean(request, average.Mean(static_cast<std::size_t>(c), alongX.Size * alongY.Size),
        index, classifier, samples);
    }
    if (!request.Progress(static_cast<double>(r + 1) / static_cast<double>(source.Height)))
    {
      reader.Findings.Completed = false;
      break;
    }
  }
  return reader.Findings;
}
}

//------------------------------------------------------------------------------
template <typename T>
RasterFindings ReadRasterPiece(const RasterFile& file, const RasterRequest& request, T* samples)
{
  if (request.Extent[1] < request.Extent[0] || request.Extent[3] < request.Extent[2])
  {
    return {};
  }
  if (request.Width == request.Window.Width && request.Height == request.Window.Height)
  {
    return ReadFull(file, request, samples);
  }
  return ReadReduced(file, request, samples);
}

template RasterFindings ReadRasterPiece(const RasterFile&, const RasterRequest&, signed char*);
template RasterFindings ReadRasterPiece(const RasterFile&, const RasterRequest&, unsigned char*);
template RasterFindings ReadRasterPiece(const RasterFile&, const RasterRequest&, short*);
template RasterFindings ReadRasterPiece(const RasterFile&, const RasterRequest&, unsigned short*);
template RasterFindings ReadRasterPiece(const RasterFile&, const RasterRequest&, int*);
template RasterFindings ReadRasterPiece(const RasterFile&, const RasterRequest&, unsigned int*);
template RasterFindings ReadRasterPiece(const RasterFile&, const RasterRequest&, float*);
template RasterFindings ReadRasterPiece(const RasterFile&, const RasterRequest&, double*);
}
