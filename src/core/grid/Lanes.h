// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Numbers side by side as one value, by the vectors of GCC and Clang: a register of what a file is
 * compiled for, 64 bytes with AVX-512, 32 with AVX2, else 16 (SSE2, NEON). Arithmetic is that of
 * each lane alone, the same for all (files that use this are compiled without contraction).
 *
 * What is compiled for one kind of processor stays in a namespace of its own, and calls no function
 * that other files share: a linker would keep one of the copies for all processors.
 */
#ifndef terrain_Lanes_h
#define terrain_Lanes_h

#include <cstdint>

#if defined(__AVX512F__)
#include <immintrin.h>
#define TERRAIN_LANES_KIND lanes_avx512
#define TERRAIN_LANES_BYTES 64
#elif defined(__AVX2__)
#include <immintrin.h>
#define TERRAIN_LANES_KIND lanes_avx2
#define TERRAIN_LANES_BYTES 32
#else
#define TERRAIN_LANES_KIND lanes_plain
#define TERRAIN_LANES_BYTES 16
#endif

/// For functions of lanes, which are slow through memory.
#define TERRAIN_LANES_INLINE [[gnu::always_inline]] inline

// Vectors are only ever passed inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace terrain
{
inline namespace TERRAIN_LANES_KIND
{
/// What goes with the element type Real, float or double.
template <typename Real>
struct LaneTypes;

template <>
struct LaneTypes<float>
{
  static constexpr int Count = TERRAIN_LANES_BYTES / 4;
  using Value [[gnu::vector_size(TERRAIN_LANES_BYTES)]] = float;
  using Mask [[gnu::vector_size(TERRAIN_LANES_BYTES)]] = std::int32_t;
};

template <>
struct LaneTypes<double>
{
  static constexpr int Count = TERRAIN_LANES_BYTES / 8;
  using Value [[gnu::vector_size(TERRAIN_LANES_BYTES)]] = double;
  using Mask [[gnu::vector_size(TERRAIN_LANES_BYTES)]] = std::int64_t;
};

/// Functions of lanes of Real. A mask has all bits of a lane set, or none.
template <typename Real>
struct Lanes
{
  static constexpr int Count = LaneTypes<Real>::Count;
  using Value = typename LaneTypes<Real>::Value;
  using Mask = typename LaneTypes<Real>::Mask;

  TERRAIN_LANES_INLINE static Value All(Real a)
  {
    return a - Value{};
  }
  /// Count numbers from anywhere in memory.
  TERRAIN_LANES_INLINE static Value Load(const Real* from)
  {
    Value value;
    __builtin_memcpy(&value, from, sizeof(value));
    return value;
  }
  TERRAIN_LANES_INLINE static void Store(Value value, Real* to)
  {
    __builtin_memcpy(to, &value, sizeof(value));
  }
  /// The larger; b where one is not a number.
  TERRAIN_LANES_INLINE static Value Maximum(Value a, Value b)
  {
    return a > b ? a : b;
  }
  TERRAIN_LANES_INLINE static bool Any(Mask mask)
  {
#if defined(__AVX512F__)
    return _mm512_test_epi32_mask((__m512i)mask, (__m512i)mask) != 0;
#elif defined(__AVX2__)
    return _mm256_testz_si256((__m256i)mask, (__m256i)mask) == 0;
#else
    using Words [[gnu::vector_size(16)]] = std::int64_t;
    const Words words = (Words)mask;
    return (words[0] | words[1]) != 0;
#endif
  }
  TERRAIN_LANES_INLINE static Value Root(Value a)
  {
    for (int k = 0; k < Count; ++k)
    {
      a[k] = SquareRoot(a[k]);
    }
    return a;
  }
  TERRAIN_LANES_INLINE static Real SquareRoot(Real a)
  {
    return sizeof(Real) == sizeof(float) ? __builtin_sqrtf(a) : __builtin_sqrt(a);
  }
};
}
}

#endif
