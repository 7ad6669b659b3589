// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Heights as colours show them: in a round scene z is not the height.
 */
#ifndef terrain_render_ShownHeights_h
#define terrain_render_ShownHeights_h

#include <array>

class vtkDataArray;
class vtkImageData;
class vtkTerrainActor;

/// The array of heights: in a round scene that of heights that vtkTerrainReproject adds, else z.
vtkDataArray* HeightsOf(vtkImageData* heights);

/// Lowest and highest of these, of all of the terrain.
std::array<double, 2> HeightRange(vtkTerrainActor* actor, vtkImageData* heights);

/// Makes the colours of a round scene those of its heights; nothing in other scenes.
void ColorByPlaceHeight(vtkTerrainActor* actor, vtkImageData* heights);

#endif
