// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the camera stands that nobody has placed, and between which distances it sees.
 */
#ifndef terrain_render_DefaultView_h
#define terrain_render_DefaultView_h

class vtkBoundingBox;
class vtkCamera;
class vtkLight;
struct PlacedHeights;

/// What of a picture the terrain may take, over what is right of its middle and above it.
struct ViewRoom
{
  double Right = 1.0;
  double Top = 1.0;
};

/// From the south, as near as shows all of the terrain in its box; aspect: width over height of the
/// picture. On a globe, from the south of the middle of the heights, the wider they are the
/// steeper; a planet of which more than 120 degrees are there is seen as a whole. Room is left in
/// flat scenes only.
void LookAtAll(vtkCamera* camera, const vtkBoundingBox& box, const PlacedHeights& heights,
  double aspect, const ViewRoom& room = {});

/// Light on a globe from over the left shoulder of who looks at it.
void LightGlobe(vtkCamera* camera, vtkLight* sun);

/// True if an eye is below all of the ground of a globe, whose underside is not drawn.
bool IsInsidePlanet(vtkCamera* camera, const PlacedHeights& heights);

/// From as near as the contract of the near plane allows to beyond the farthest corner; on a globe
/// to the horizon of its highest heights, and as near as a hundred-thousandth of that.
void SetClippingRange(vtkCamera* camera, const vtkBoundingBox& box, const PlacedHeights& heights);

#endif
