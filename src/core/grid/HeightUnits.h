// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Units of heights by the names that files give them.
 */
#ifndef terrain_HeightUnits_h
#define terrain_HeightUnits_h

#include <string>

namespace terrain
{
/// Metres of a unit of length by its name, case, underscores and quotes ignored: metre, foot, US
/// survey foot, centimetre, kilometre and their abbreviations; 0 if the name is not known.
double MetresOfUnit(const std::string& name);
}

#endif
