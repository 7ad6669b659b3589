// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colours of what stands on the background without a box of its own.
 */
#ifndef terrain_render_MarkColors_h
#define terrain_render_MarkColors_h

#include "vtkRenderer.h"

#include <array>
#include <cmath>

/// Dark and light, red, green, blue, 0 to 1.
constexpr std::array<double, 3> kDarkMark = { 0.08, 0.10, 0.16 };
constexpr std::array<double, 3> kLightMark = { 0.96, 0.97, 0.98 };

/// True if light marks have more contrast than dark ones on a colour (relative luminance of sRGB).
inline bool IsDarkColor(const double color[3])
{
  constexpr std::array<double, 3> kWeights = { 0.2126, 0.7152, 0.0722 };
  constexpr double kMiddle = 0.19;
  double luminance = 0.0;
  for (std::size_t k = 0; k < kWeights.size(); ++k)
  {
    luminance += kWeights[k] * std::pow(color[k], 2.2);
  }
  return luminance < kMiddle;
}

/// True if marks at the upper or else the lower border stand on something dark. What a transparent
/// picture will stand on is not known: paper.
inline bool IsDarkBehind(vtkRenderer* renderer, bool isUpper)
{
  const bool isGradient = isUpper && renderer->GetGradientBackground();
  return renderer->GetBackgroundAlpha() > 0.0 &&
    IsDarkColor(isGradient ? renderer->GetBackground2() : renderer->GetBackground());
}

#endif
