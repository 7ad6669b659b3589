// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colour files that are XML. Private to the module.
 */
#ifndef vtkTerrain_data_ColorDocument_h
#define vtkTerrain_data_ColorDocument_h

#include "core/colors/ColorFile.h"

#include <string>

namespace terrain
{
/// A QGIS style: the items of its first colour ramp shader (INTERPOLATED, DISCRETE or EXACT).
ColorFileResult ReadStyle(const std::string& text);

/// A ParaView colour map: the points of the first one, its colour of no data, values as shares.
ColorFileResult ReadColorMapDocument(const std::string& text);
}

#endif
