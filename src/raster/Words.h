// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Names in lower case. Private to the module.
 */
#ifndef vtkTerrain_raster_Words_h
#define vtkTerrain_raster_Words_h

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>

namespace terrain
{
/// ASCII letters in lower case.
inline std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

inline bool IsOneOf(const std::string& text, std::initializer_list<const char*> names)
{
  return std::any_of(
    names.begin(), names.end(), [&text](const char* other) { return text == other; });
}
}
#endif
