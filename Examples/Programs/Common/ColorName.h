// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colours of command lines.
 */
#ifndef terrain_common_ColorName_h
#define terrain_common_ColorName_h

#include <array>
#include <optional>
#include <string>

/// Red, green, blue, 0 to 1.
using RGB = std::array<double, 3>;

/// A colour by its name in CSS, or "#rrggbb"; empty for all other text.
std::optional<RGB> ParseColor(const std::string& text);

#endif
