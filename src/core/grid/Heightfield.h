// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Non-owning view of the samples of a heightfield (Coordinates.h).
 */
#ifndef terrain_Heightfield_h
#define terrain_Heightfield_h

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace terrain
{
/// Magnitudes from this one on are no heights but fill: sums and products of those below it are
/// finite in double, sums of a few in float.
constexpr double kHeightLimit = 1e30;

/// False for what is no height whatever else is known: NaN, infinities, and kHeightLimit or more.
template <typename T>
constexpr bool IsHeight(T value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return value < static_cast<T>(kHeightLimit) && value > -static_cast<T>(kHeightLimit);
  }
  return true;
}

/// View of W x H samples of arithmetic type T, row by row from the south or from the north; never
/// owns them. Everything counts rows from the south: an index may be below 0.
template <typename T>
struct HeightfieldView
{
  /// The south-western sample; that of (i, j) is Samples[Index(i, j)]. In height units.
  const T* Samples = nullptr;
  /// Number of samples east and north, >= 0.
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  /// Optional, one byte a sample: no data where (Mask[index] & MaskBits) != 0.
  const unsigned char* Mask = nullptr;
  unsigned char MaskBits = 0xff;
  /// If HasNoData, samples equal to NoData have no height either (height codes: HeightCodes.h).
  bool HasNoData = false;
  T NoData{};
  /// Whether the next row to the north lies before a row in memory, instead of behind it.
  bool RowsFromNorth = false;

  /// What the index grows by from a row to the next one north.
  std::int64_t RowStep() const
  {
    return this->RowsFromNorth ? -this->Width : this->Width;
  }

  std::int64_t Index(std::int64_t i, std::int64_t j) const
  {
    return i + this->RowStep() * j;
  }

  /// True where there is a height: not masked, not NoData, and IsHeight().
  bool IsValid(std::int64_t index) const
  {
    if (this->Mask && (this->Mask[index] & this->MaskBits))
    {
      return false;
    }
    if (this->HasNoData && this->Samples[index] == this->NoData)
    {
      return false;
    }
    return IsHeight(this->Samples[index]);
  }

  /// Height of sample (i, j) in height units, NaN for no data; 0 <= i < Width, 0 <= j < Height.
  double At(std::int64_t i, std::int64_t j) const
  {
    const std::int64_t index = this->Index(i, j);
    return this->IsValid(index) ? static_cast<double>(this->Samples[index])
                                : std::numeric_limits<double>::quiet_NaN();
  }

  /// True if the four samples of cell (i, j) have heights; 0 <= i < Width-1, 0 <= j < Height-1.
  bool IsCellValid(std::int64_t i, std::int64_t j) const
  {
    const std::int64_t index = this->Index(i, j);
    const std::int64_t north = index + this->RowStep();
    return this->IsValid(index) && this->IsValid(index + 1) && this->IsValid(north) &&
      this->IsValid(north + 1);
  }
};
}

#endif
