// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What refinement knows of one vertex of the hierarchy (HierarchyLayout.h), in eight bytes.
 *
 * Errors and radii are rounded up when they are packed, by less than 1/64 and 1/32 of their value:
 * a bound stays a bound, and rounding keeps the order, so nested values stay nested.
 */
#ifndef terrain_HierarchyRecord_h
#define terrain_HierarchyRecord_h

#include <cstdint>
#include <cstring>
#include <limits>

namespace terrain
{
/// Bits of a float, and back.
inline std::uint32_t FloatBits(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}
inline float BitsFloat(std::uint32_t bits)
{
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

/// Largest relative excess of a packed error and of a packed radius over the value that was given.
constexpr double kPackedErrorExcess = 1.0 / 64;
constexpr double kPackedRadiusExcess = 1.0 / 32;

/**
 * One vertex: its height, the object-space error of the surface without it, the radius of the
 * sphere around it that holds the surface of its diamond and those of all its descendants, and
 * which of the four triangles that meet in it (one depth finer) may be drawn.
 */
struct HierarchyRecord
{
  /// Height of the sample, in height units; a finite filling where there is no data.
  float Height = 0.0f;
  /// Bits 31-18: error, 17-5: radius, 4: rough, 3-0: drawn triangles.
  std::uint32_t Packed = 0;

  static constexpr std::uint32_t RoughBit = 16;
  static constexpr std::uint32_t DrawnBits = 15;

  /// Object-space error in height units, >= 0; infinite while it is not known.
  float Error() const
  {
    return BitsFloat((this->Packed >> 1) & 0x7ffe0000u);
  }
  /// True if the error is not 0.
  bool HasError() const
  {
    return this->Packed >= (1u << 18);
  }
  /// Radius in model units without exaggeration, >= 0.
  float Radius() const
  {
    return BitsFloat((this->Packed << 13) & 0x7ffc0000u);
  }
  /// Bit d: the triangle in direction d (HierarchyLayout.h) has the surface everywhere.
  std::uint32_t Drawn() const
  {
    return this->Packed & DrawnBits;
  }
  /// True if a hole or the raster's border crosses the diamond of the vertex or of a descendant.
  bool IsRough() const
  {
    return (this->Packed & RoughBit) != 0;
  }

  void SetError(float error)
  {
    this->Packed = (this->Packed & 0x0003ffffu) | (RoundUp(error, 17) << 1);
  }
  void SetRadius(float radius)
  {
    this->Packed = (this->Packed & 0xfffc001fu) | (RoundUp(radius, 18) >> 13);
  }
  void SetDrawn(std::uint32_t drawn)
  {
    this->Packed = (this->Packed & ~DrawnBits) | drawn;
  }
  void SetRough(bool rough)
  {
    this->Packed = (this->Packed & ~RoughBit) | (rough ? RoughBit : 0u);
  }

private:
  /// Bits of the smallest float >= value >= 0 whose lowest `low` bits are 0.
  static std::uint32_t RoundUp(float value, int low)
  {
    const std::uint32_t mask = (1u << low) - 1u;
    const std::uint32_t infinite = FloatBits(std::numeric_limits<float>::infinity());
    const std::uint32_t bits = FloatBits(value);
    return bits >= infinite ? infinite : (bits + mask) & ~mask;
  }
};
static_assert(sizeof(HierarchyRecord) == 8, "a record is read from files as it is");

/// Slopes dh/dx and dh/dy of the surface at a sample, each rounded to 8 significant bits.
struct HierarchyGradient
{
  std::uint32_t Packed = 0;

  float X() const
  {
    return BitsFloat(this->Packed & 0xffff0000u);
  }
  float Y() const
  {
    return BitsFloat(this->Packed << 16);
  }
  void Set(float x, float y)
  {
    this->Packed = Round(x) | (Round(y) >> 16);
  }

private:
  static std::uint32_t Round(float value)
  {
    return (FloatBits(value) + 0x8000u) & 0xffff0000u;
  }
};
}

#endif
