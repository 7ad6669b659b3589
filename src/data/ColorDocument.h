// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colour files that are XML or JSON. Private to the module.
 */
#ifndef vtkTerrain_data_ColorDocument_h
#define vtkTerrain_data_ColorDocument_h

#include "core/colors/ColorFile.h"

#include <string>

namespace terrain
{
/// A QGIS style: the items of its first colour ramp shader (INTERPOLATED, DISCRETE or EXACT).
ColorFileResult ReadStyle(const std::string& text);

/// A ParaView colour map: the points of the first one, its colour of no data, values as shares,
/// mixed in its colour space (MixedIn()).
ColorFileResult ReadColorMapDocument(const std::string& text);

/// ParaView's presets as it exports them: JSON, a colour map or a list of them, of which the first
/// counts. "RGBPoints" and "NanColor", "BelowRangeColor" and "AboveRangeColor" where they are in
/// use, values as shares; or, without points, "IndexedColors" at the values of "Annotations", with
/// their texts (at 0, 1, 2, ... where these are no numbers).
ColorFileResult ReadColorMapPresets(const std::string& text);

/// A scheme of shares for colours that are mixed in one of ParaView's spaces: "HSV", "Lab",
/// "Lab/CIEDE2000", "Diverging", "Step", else RGB. Other spaces than RGB become kStopsOfSpace stops
/// between two, mixed by vtkColorTransferFunction. Stops must be finite.
constexpr int kStopsOfSpace = 64;
ColorFileResult MixedIn(ColorScheme scheme, const std::string& space);
}

#endif
