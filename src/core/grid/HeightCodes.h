// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Heights as the codes that the GPU stores: h = Offset + Scale * code, without loss in the smallest
 * format. A texel is a code plus Bias. Valid codes are >= 0, so that one comparison tells no data.
 *
 *   UInt16   integers whose range fits 16 bits: code = h - Offset, Scale = 1. Where there are no
 *            data, Bias = 1 and the texel 0 means none.
 *   Float32  everything else: code = h - Offset, rounded to float. Offset is the lowest height, so
 *            that small relief on a large height keeps its precision. The texel -1 means none.
 */
#ifndef terrain_HeightCodes_h
#define terrain_HeightCodes_h

#include "core/grid/Heightfield.h"
#include "core/grid/ParallelFor.h"

#include <algorithm>
#include <mutex>

namespace terrain
{
/// Code of a sample without height, as terrainCellCodes() gives it.
constexpr float kNoDataCode = -1.0f;

/// How heights are coded, see above.
struct HeightCodes
{
  enum class TexelFormat
  {
    UInt16,
    Float32
  };
  TexelFormat Format = TexelFormat::UInt16;
  /// Height of code 0 and height units a code, h = Offset + Scale * code.
  double Offset = 0.0;
  double Scale = 1.0;
  /// Texel minus code: 1 if texel 0 is kept for no data, else 0. Always 0 for Float32.
  int Bias = 0;
  /// Largest code; the smallest is 0.
  double MaximumCode = 0.0;
  bool HasNoData = false;
  /// False if no sample has a height.
  bool HasData = false;

  double ToCode(double height) const
  {
    return (height - this->Offset) / this->Scale;
  }
  double ToHeight(double code) const
  {
    return this->Offset + this->Scale * code;
  }
};

/// Lowest and highest height of a view and whether some samples have none; minimum > maximum if
/// all.
template <typename T>
struct HeightRange
{
  T Minimum = std::numeric_limits<T>::max();
  T Maximum = std::numeric_limits<T>::lowest();
  bool HasNoData = false;
};

template <typename T>
HeightRange<T> FindHeightRange(const HeightfieldView<T>& view, const ParallelFor& parallelFor)
{
  HeightRange<T> range;
  std::mutex mutex;
  parallelFor(view.Height,
    [&](std::int64_t begin, std::int64_t end)
    {
      HeightRange<T> local;
      const std::int64_t first = std::min(view.Index(0, begin), view.Index(0, end - 1));
      for (std::int64_t index = first; index < first + view.Width * (end - begin); ++index)
      {
        if (!view.IsValid(index))
        {
          local.HasNoData = true;
          continue;
        }
        local.Minimum = std::min(local.Minimum, view.Samples[index]);
        local.Maximum = std::max(local.Maximum, view.Samples[index]);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      range.Minimum = std::min(range.Minimum, local.Minimum);
      range.Maximum = std::max(range.Maximum, local.Maximum);
      range.HasNoData = range.HasNoData || local.HasNoData;
    });
  return range;
}

/// The codes for heights of type T within a range; lossless but for doubles, which become floats.
template <typename T>
HeightCodes ChooseHeightCodes(const HeightRange<T>& range)
{
  HeightCodes codes;
  codes.HasNoData = range.HasNoData;
  codes.HasData = range.Minimum <= range.Maximum;
  if (codes.HasData)
  {
    codes.Offset = static_cast<double>(range.Minimum);
    codes.MaximumCode = static_cast<double>(range.Maximum) - codes.Offset;
  }
  codes.Bias = range.HasNoData ? 1 : 0;
  if (!std::is_integral_v<T> || codes.MaximumCode + codes.Bias > 65535.0)
  {
    codes.Format = HeightCodes::TexelFormat::Float32;
    codes.Bias = 0;
  }
  return codes;
}

/// True if codes chosen for other heights hold those of rows [begin, end) of columns [first, last),
/// too: each is within their range, or none where they know of none.
template <typename T>
bool HoldHeights(const HeightCodes& codes, const HeightfieldView<T>& view, std::int64_t first,
  std::int64_t last, std::int64_t begin, std::int64_t end)
{
  for (std::int64_t row = begin; row < end; ++row)
  {
    for (std::int64_t index = view.Index(first, row); index < view.Index(last, row); ++index)
    {
      const double code =
        view.IsValid(index) ? codes.ToCode(static_cast<double>(view.Samples[index])) : 0.0;
      if (!(code >= 0.0 && code <= codes.MaximumCode) || !(view.IsValid(index) || codes.HasNoData))
      {
        return false;
      }
    }
  }
  return true;
}

/// Writes the texels of rows [begin, end) of columns [first, last) to texels, row by row without
/// gaps. Texel is std::uint16_t or float, as codes.Format says.
template <typename T, typename Texel>
void EncodeHeights(const HeightfieldView<T>& view, const HeightCodes& codes, std::int64_t first,
  std::int64_t last, std::int64_t begin, std::int64_t end, Texel* texels,
  const ParallelFor& parallelFor)
{
  const Texel noData =
    codes.Format == HeightCodes::TexelFormat::UInt16 ? Texel{} : static_cast<Texel>(kNoDataCode);
  parallelFor(end - begin,
    [&](std::int64_t rowBegin, std::int64_t rowEnd)
    {
      for (std::int64_t row = rowBegin; row < rowEnd; ++row)
      {
        Texel* out = texels + row * (last - first);
        for (std::int64_t i = first; i < last; ++i)
        {
          const std::int64_t index = view.Index(i, begin + row);
          *out++ = view.IsValid(index)
            ? static_cast<Texel>(
                codes.ToCode(static_cast<double>(view.Samples[index])) + codes.Bias)
            : noData;
        }
      }
    });
}
}

#endif
