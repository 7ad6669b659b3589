// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A checksum of bytes in memory, for files that are ours.
 */
#ifndef terrain_Checksum_h
#define terrain_Checksum_h

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace terrain
{
/// A 64-bit checksum: four lanes of multiply and rotate over words, then mixed. Finds any changed
/// word, not meant against intent.
inline std::uint64_t Checksum(const unsigned char* data, std::size_t size)
{
  constexpr std::uint64_t factor = 0x9fb21c651e98df25u;
  std::uint64_t lanes[4] = { 1, 2, 3, size };
  std::size_t position = 0;
  for (; position + 32 <= size; position += 32)
  {
    for (int lane = 0; lane < 4; ++lane)
    {
      std::uint64_t word = 0;
      std::memcpy(&word, data + position + std::ptrdiff_t{ 8 } * lane, 8);
      lanes[lane] = (lanes[lane] ^ word) * factor;
      lanes[lane] ^= lanes[lane] >> 29;
    }
  }
  for (; position < size; ++position)
  {
    lanes[0] = (lanes[0] ^ data[position]) * factor;
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t lane : lanes)
  {
    sum = ((sum << 23) | (sum >> 41)) ^ lane;
    sum *= factor;
  }
  return sum ^ (sum >> 32);
}
}

#endif
