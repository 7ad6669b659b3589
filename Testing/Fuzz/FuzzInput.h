// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Numbers from the bytes of a fuzzer; zeros after their end.
 */
#ifndef FuzzInput_h
#define FuzzInput_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

class FuzzInput
{
public:
  FuzzInput(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Size(size)
  {
  }
  /// 0 to limit - 1.
  std::uint32_t Number(std::uint32_t limit)
  {
    return this->Take<std::uint16_t>() % limit;
  }
  /// -1 to 1.
  double Real()
  {
    return this->Take<std::int16_t>() / 32768.0;
  }
  /// Any bytes as a value.
  template <typename T>
  T Take()
  {
    T value{};
    const std::size_t count = std::min(sizeof(T), this->Left());
    std::memcpy(&value, this->Rest(), count);
    this->Position += count;
    return value;
  }
  std::size_t Left() const
  {
    return this->Size - this->Position;
  }
  const std::uint8_t* Rest() const
  {
    return this->Data + this->Position;
  }

private:
  const std::uint8_t* Data;
  std::size_t Size;
  std::size_t Position = 0;
};

#endif
