// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What traces of a globe and its pictures promise; tests assert each.
 */
#ifndef terrain_GlobeErrors_h
#define terrain_GlobeErrors_h

namespace terrain
{
/// Largest error of the distance of a hit along its ray with double, in metres, in cells of one
/// degree: what the series of a meridian leaves out, which falls with the fourth power of the
/// cell's size. Rays that come as near to a summit may be told either way.
constexpr double kGlobeError = 2e-3;
/// The same with float, and beside it a part of the distance: what is rounded of a cell of one
/// degree, and of slopes of 100.
constexpr double kGlobeFloatError = 0.01;
constexpr double kGlobeFloatPartError = 1e-5;
/// Largest error of the place of a hit on the ground, in metres, with double, in cells of a quarter
/// of a degree, from eyes 10 to 20,000 km above.
constexpr double kGlobePickError = 1e-3;
/// Largest errors of pictures, from three radii away to 2 m above the ground: of a drawn distance,
/// as a part of it; of what does not stand still along a flight, in pixels; of shadows away from
/// their edges, as a part of the pixels.
constexpr double kGlobeDrawnError = 1e-4;
constexpr double kGlobeJitterError = 0.35;
constexpr double kGlobeShadowError = 1e-3;
/// Largest error of the shader's terrainGlobeAngle(), in radians, for the angles of cells: up to
/// kGlobeCellAngle. Here it is std::atan().
constexpr double kGlobeAngleError = 1e-8;
/// In radians: 2.5 degrees.
constexpr double kGlobeCellAngle = 0.0436;
}

#endif
