// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The colours that the viewer goes through.
 */
#ifndef terrain_view_Palettes_h
#define terrain_view_Palettes_h

#include <array>

class vtkTerrainActor;

enum class Palette
{
  Relief,
  Grey,
  Spectrum,
  Plain
};

/// The palette after another, the first after the last.
Palette NextPalette(Palette palette);

/// What people call it.
const char* NameOf(Palette palette);

/// Colours a terrain by height over a range of heights, or in one colour: Plain.
void ApplyPalette(Palette palette, const std::array<double, 2>& range, vtkTerrainActor* terrain);

#endif
