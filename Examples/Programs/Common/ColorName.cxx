// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorName.h"

#include <vtkColor.h>
#include <vtkNamedColors.h>
#include <vtkNew.h>

#include <cctype>
#include <cstddef>

//------------------------------------------------------------------------------
std::optional<RGB> ParseColor(const std::string& text)
{
  const vtkNew<vtkNamedColors> names;
  bool isCode = text.size() == 7 && text[0] == '#';
  for (std::size_t k = 1; isCode && k < text.size(); ++k)
  {
    isCode = std::isxdigit(static_cast<unsigned char>(text[k])) != 0;
  }
  if (!isCode && (text.empty() || !names->ColorExists(text)))
  {
    return std::nullopt;
  }
  const vtkColor3ub color = isCode ? names->HTMLColorToRGB(text) : names->GetColor3ub(text);
  constexpr double kFull = 255.0;
  return RGB{ color.GetRed() / kFull, color.GetGreen() / kFull, color.GetBlue() / kFull };
}
