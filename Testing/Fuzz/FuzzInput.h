// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Numbers and texts from the bytes of a fuzzer; zeros after their end.
 */
#ifndef FuzzInput_h
#define FuzzInput_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

/// Ends the process, which is a finding, unless something holds; names the line of the caller.
inline void Require(bool holds, int line = __builtin_LINE())
{
  if (!holds)
  {
    std::fprintf(stderr, "Not so: what line %d requires\n", line);
    std::abort();
  }
}

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
  /// What follows up to a byte 0xff, which is skipped.
  std::string Text()
  {
    const std::uint8_t* begin = this->Rest();
    const std::uint8_t* end = std::find(begin, begin + this->Left(), std::uint8_t{ 0xff });
    this->Position += static_cast<std::size_t>(end - begin);
    this->Position += this->Left() > 0 ? 1 : 0;
    return { begin, end };
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
