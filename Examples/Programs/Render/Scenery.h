// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is around the terrain: background, fog.
 */
#ifndef terrain_render_Scenery_h
#define terrain_render_Scenery_h

class vtkRenderer;
struct Options;

/// Sets the background of a renderer; a sky is that of the direction of its camera, brighter
/// towards the horizon, with the same colour below it.
void SetBackground(vtkRenderer* renderer, const Options& options);

/// Lets all actors of a renderer fade into its background: at a distance d along the viewing
/// direction, 0.5^(d / Fog) of their colour is left. Texts and shapes in pixels do not.
void AddFog(vtkRenderer* renderer, const Options& options);

#endif
