// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/TileOverlaps.h"

#include "raster/GDALTable.h"
#include "raster/RasterMessages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace terrain
{
namespace
{
constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();
// Of the smaller tile's place: rows and columns that neighbours repeat are less. Borders round
// tiles are less than the second.
constexpr double kLeastShared = 0.02;
constexpr double kMuchShared = 0.25;
// Cells of one size differ by less than this.
constexpr double kSameCell = 0.01;
// Of a cell: tiles that are shifted by less lie on one grid.
constexpr double kSameGrid = 1e-3;
// Pairs that are found, and that are compared.
constexpr std::size_t kMostFound = 4096;
constexpr std::size_t kMostCompared = 32;
// Windows along a side of what is shared, and samples along a side of a window.
constexpr int kWindows = 3;
constexpr int kWindowSize = 32;
// Heights differ by more than a metre, or than this share of what the samples span; and in more
// than this share of the samples, in borders the second.
constexpr double kLargestSame = 1.0;
constexpr double kSameOfSpan = 0.01;
constexpr double kFewSamples = 0.002;
constexpr double kFewInBorders = 0.1;

/// Two tiles by their numbers, the lower one first.
using Pair = std::pair<std::size_t, std::size_t>;

/// West, south, east, north of what two tiles share; nothing is shared where west >= east.
std::array<double, 4> SharedPlace(const RasterTile& a, const RasterTile& b)
{
  return { { std::max(a.West(), b.West()), std::max(a.South(), b.South()),
    std::min(a.East(), b.East()), std::min(a.North(), b.North()) } };
}

/// What two tiles share, of the smaller one's place.
double ShareOf(const RasterTile& a, const RasterTile& b)
{
  const std::array<double, 4> place = SharedPlace(a, b);
  const double smaller = std::min((a.East() - a.West()) * (a.North() - a.South()),
    (b.East() - b.West()) * (b.North() - b.South()));
  return place[0] < place[2] && place[1] < place[3]
    ? (place[2] - place[0]) * (place[3] - place[1]) / smaller
    : 0.0;
}

bool AreOver(const RasterTile& a, const RasterTile& b)
{
  const auto isSame = [](double x, double y) { return std::abs(x - y) <= kSameCell * x; };
  return ShareOf(a, b) >= kLeastShared && isSame(a.GeoTransform[1], b.GeoTransform[1]) &&
    isSame(-a.GeoTransform[5], -b.GeoTransform[5]);
}

/// Pairs of tiles that overlap, found from west to east.
std::vector<Pair> FindPairs(const std::vector<RasterTile>& tiles)
{
  std::vector<std::size_t> order(tiles.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::sort(order.begin(), order.end(),
    [&tiles](std::size_t a, std::size_t b) { return tiles[a].West() < tiles[b].West(); });
  std::vector<Pair> pairs;
  std::vector<std::size_t> open;
  for (const std::size_t k : order)
  {
    open.erase(std::remove_if(open.begin(), open.end(),
                 [&](std::size_t other) { return tiles[other].East() <= tiles[k].West(); }),
      open.end());
    for (const std::size_t other : open)
    {
      if (pairs.size() < kMostFound && AreOver(tiles[k], tiles[other]))
      {
        pairs.emplace_back(std::min(k, other), std::max(k, other));
      }
    }
    open.push_back(k);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// A tile that is open.
class OpenTile
{
public:
  explicit OpenTile(const RasterTile& tile)
    : Tile(tile)
    , Dataset(
        GDALOpenEx(tile.Path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr))
    , Band(this->Dataset ? GDALGetRasterBand(this->Dataset, 1) : nullptr)
  {
  }
  ~OpenTile()
  {
    if (this->Dataset)
    {
      GDALClose(this->Dataset);
    }
  }
  OpenTile(const OpenTile&) = delete;
  void operator=(const OpenTile&) = delete;

  /// Column and row of a place, 0 in the middle of the first sample.
  std::array<double, 2> IndexOf(double x, double y) const
  {
    return { { (x - this->Tile.West()) / this->Tile.GeoTransform[1] - 0.5,
      (y - this->Tile.North()) / this->Tile.GeoTransform[5] - 0.5 } };
  }

  /// Heights of a window in metres, NaN for none; empty if it cannot be read.
  std::vector<double> Read(int column, int row, int width, int height) const
  {
    std::vector<double> heights(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (!this->Band ||
      GDALRasterIO(this->Band, GF_Read, column, row, width, height, heights.data(), width, height,
        GDT_Float64, 0, 0) != CE_None)
    {
      return {};
    }
    std::vector<unsigned char> mask(heights.size(), 255);
    if (this->Tile.HasMask &&
      GDALRasterIO(GDALGetMaskBand(this->Band), GF_Read, column, row, width, height, mask.data(),
        width, height, GDT_Byte, 0, 0) != CE_None)
    {
      return {};
    }
    for (std::size_t k = 0; k < heights.size(); ++k)
    {
      const bool isNone = mask[k] == 0 || (this->Tile.HasNoData && heights[k] == this->Tile.NoData);
      heights[k] = isNone ? kNoHeight : this->Tile.Offset + this->Tile.Scale * heights[k];
    }
    return heights;
  }

  /// Metres by which a height may be rounded.
  double Rounding() const
  {
    const bool isWhole = this->Tile.Type != GDT_Float32 && this->Tile.Type != GDT_Float64;
    return isWhole ? 0.5 * std::abs(this->Tile.Scale) : 0.0;
  }

  const RasterTile& Tile;

private:
  GDALDatasetH Dataset;
  GDALRasterBandH Band;
};

/// What is found where two tiles are compared.
struct Difference
{
  std::size_t Samples = 0;
  std::size_t Different = 0;
  double Largest = 0.0;
  /// By how much the upper one is higher, all together.
  double Step = 0.0;
  /// Of the samples that may differ.
  double Few = kFewSamples;

  bool IsOne() const
  {
    return static_cast<double>(this->Different) > this->Few * static_cast<double>(this->Samples);
  }
};

/// The sample at or before a position, and the share of the way to the next one.
std::pair<int, double> Split(double index)
{
  const double whole = std::floor(index + kSameGrid);
  const double share = index - whole;
  return { static_cast<int>(whole), share < kSameGrid ? 0.0 : share };
}

std::size_t SampleAt(int row, int column, int columns)
{
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
    static_cast<std::size_t>(column);
}

/// Highest less lowest.
double SpanOf(const std::vector<double>& heights)
{
  double lowest = HUGE_VAL;
  double highest = -HUGE_VAL;
  for (const double each : heights)
  {
    lowest = std::isnan(each) ? lowest : std::min(lowest, each);
    highest = std::isnan(each) ? highest : std::max(highest, each);
  }
  return std::max(highest - lowest, 0.0);
}

/// Compares the samples of a window of one tile with the other's at the same places.
void CompareWindow(const OpenTile& a, const OpenTile& b, const std::array<int, 4>& window,
  double rounding, Difference& found)
{
  const auto [column, row, width, height] = window;
  const double x = a.Tile.West() + (column + 0.5) * a.Tile.GeoTransform[1];
  const double y = a.Tile.North() + (row + 0.5) * a.Tile.GeoTransform[5];
  const std::array<double, 2> first = b.IndexOf(x, y);
  const auto [left, u] = Split(first[0]);
  const auto [top, v] = Split(first[1]);
  const int more[2] = { u > 0.0 ? 1 : 0, v > 0.0 ? 1 : 0 };
  const int wide = std::min(width + more[0], b.Tile.Width - left);
  const int high = std::min(height + more[1], b.Tile.Height - top);
  if (left < 0 || top < 0 || wide <= more[0] || high <= more[1])
  {
    return;
  }
  const std::vector<double> low = a.Read(column, row, width, height);
  const std::vector<double> other = b.Read(left, top, wide, high);
  if (low.empty() || other.empty())
  {
    return;
  }
  const double same = rounding + std::min(kLargestSame, kSameOfSpan * SpanOf(low));
  for (int r = 0; r < high - more[1]; ++r)
  {
    for (int c = 0; c < wide - more[0]; ++c)
    {
      const std::size_t corner = SampleAt(r, c, wide);
      const std::size_t south = corner + SampleAt(more[1], 0, wide);
      const auto east = static_cast<std::size_t>(more[0]);
      const std::array<double, 4> z{ { other[corner], other[corner + east], other[south],
        other[south + east] } };
      const double own = low[SampleAt(r, c, width)];
      const double between =
        (1.0 - v) * ((1.0 - u) * z[0] + u * z[1]) + v * ((1.0 - u) * z[2] + u * z[3]);
      const double off = std::abs(between - own);
      // between samples a surface may run as it likes
      const auto [lowest4, highest4] = std::minmax_element(z.begin(), z.end());
      const double slack = u + v > 0.0 ? *highest4 - *lowest4 : 0.0;
      found.Samples += std::isnan(off) ? 0 : 1;
      found.Step += std::isnan(off) ? 0.0 : between - own;
      if (off > same + slack)
      {
        ++found.Different;
        found.Largest = std::max(found.Largest, off);
      }
    }
  }
}

Difference Compare(const RasterTile& below, const RasterTile& above)
{
  const GDALMessages messages;
  const OpenTile a(below);
  const OpenTile b(above);
  const std::array<double, 4> place = SharedPlace(below, above);
  const std::array<double, 2> north = a.IndexOf(place[0], place[3]);
  const std::array<double, 2> south = a.IndexOf(place[2], place[1]);
  const auto least = [](double index) { return static_cast<int>(std::ceil(index - kSameGrid)); };
  const std::array<int, 2> from{ { std::max(least(north[0]), 0), std::max(least(north[1]), 0) } };
  const std::array<int, 2> size{ { std::min(least(south[0]), below.Width) - from[0],
    std::min(least(south[1]), below.Height) - from[1] } };
  Difference found;
  found.Few = ShareOf(below, above) < kMuchShared ? kFewInBorders : kFewSamples;
  const int wide = std::min(size[0], kWindowSize);
  const int high = std::min(size[1], kWindowSize);
  for (int k = 0; k < kWindows * kWindows && wide > 0 && high > 0; ++k)
  {
    const std::array<int, 4> window{ { from[0] + (size[0] - wide) * (k % kWindows) / (kWindows - 1),
      from[1] + (size[1] - high) * (k / kWindows) / (kWindows - 1), wide, high } };
    CompareWindow(a, b, window, a.Rounding() + b.Rounding(), found);
  }
  return found;
}

/// How to shift a tile that is too high, or too low, by the same everywhere; empty for others.
std::string RemedyOfStep(const RasterTile& above, const Difference& difference)
{
  constexpr double kAlike = 0.9;
  const double step = difference.Step / static_cast<double>(difference.Samples);
  return std::abs(step) < kAlike * difference.Largest || above.Scale != 1.0 ? std::string()
                                                                            : "; gdal_calc.py -A " +
      above.FileName() + CPLSPrintf(" --calc='A-(%.6g)' --type=Float32 --outfile=OUT.tif", step) +
      " takes the step away, if one is of another datum";
}

std::string Describe(const RasterTile& below, const RasterTile& above, const Difference& difference)
{
  const bool isFiner = below.CellArea() > above.CellArea() * (1.0 + 1e-6);
  const double share =
    100.0 * static_cast<double>(difference.Different) / static_cast<double>(difference.Samples);
  const bool hasPath = below.Path.rfind("/vsimem/", 0) != 0;
  return below.FileName() + " and " + above.FileName() +
    " of the folder overlap, and their heights differ there by up to " +
    CPLSPrintf("%.3g", difference.Largest) + " m (in " + NumberText(std::ceil(share)) +
    " % of the samples that were compared): " + above.FileName() + " is on top, as " +
    (isFiner ? "the finer one" : "the last by name of equally fine ones") + "; name " +
    (hasPath ? below.Path : below.FileName()) +
    " alone to see the other, or take one out of the folder" + RemedyOfStep(above, difference);
}
}

//------------------------------------------------------------------------------
void TellOfOverlaps(const std::vector<RasterTile>& tiles, RasterRecord& record)
{
  const std::vector<Pair> pairs = FindPairs(tiles);
  const std::size_t count = std::min(pairs.size(), kMostCompared);
  std::string text;
  std::size_t more = 0;
  for (std::size_t k = 0; k < count; ++k)
  {
    const auto [below, above] = pairs[(2 * k + 1) * pairs.size() / (2 * count)];
    const Difference difference = Compare(tiles[below], tiles[above]);
    if (difference.IsOne() && text.empty())
    {
      text = Describe(tiles[below], tiles[above], difference);
    }
    else if (difference.IsOne())
    {
      ++more;
    }
  }
  if (!text.empty())
  {
    record.Warn(text +
      (more > 0 ? " (as do " + std::to_string(more) + " more of the " + std::to_string(count) +
            " pairs that were compared)"
                : ""));
  }
}
}
