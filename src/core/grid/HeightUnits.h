// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Units of heights by the names that files and people give them.
 */
#ifndef terrain_HeightUnits_h
#define terrain_HeightUnits_h

#include <string>

namespace terrain
{
/// Metres of a unit of length by its name, or by a factor and a name; 0 if the name is not known.
/// Case, brackets, quotes, underscores and hyphens do not matter, plurals are known: metre, foot
/// (of surveys too), inch, yard, fathom, mile, and their abbreviations, from nanometre to
/// kilometre.
double MetresOfUnit(const std::string& name);

/// What an option about the unit of heights says: metres a unit, as a number ("0.3048", "-1") or a
/// name ("ft"; "-ft" counts down). Below 0 heights count down. False if it is neither.
bool HeightFactorFromText(const std::string& text, double& metres, bool& isNumber);
}

#endif
