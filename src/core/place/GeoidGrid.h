// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A grid of geoid heights, read by GeographicLib::Geoid. Without std::string, as GeographicText.h.
 */
#ifndef terrain_GeoidGrid_h
#define terrain_GeoidGrid_h

#include <cstddef>
#include <memory>

namespace terrain
{
/// Room for a folder or a message, its end included.
constexpr std::size_t kGeoidTextSize = 4096;

class GeoidGrid
{
public:
  GeoidGrid() = default;
  virtual ~GeoidGrid() = default;
  GeoidGrid(const GeoidGrid&) = delete;
  void operator=(const GeoidGrid&) = delete;

  /// Height of the geoid above the WGS84 ellipsoid in metres, cubic interpolation; NaN if the file
  /// cannot be read any more. Latitude -90 to 90, longitude in degrees. Several threads may call
  /// this at a time only if the grid is held in memory.
  virtual double GetHeight(double latitude, double longitude) const = 0;

  /// Opens DIRECTORY/NAME.pgm; null, with the reason in message, if that fails.
  static std::unique_ptr<GeoidGrid> Open(
    const char* name, const char* directory, bool holdInMemory, char (&message)[kGeoidTextSize]);

  /// Where GeographicLib looks for grids: GEOGRAPHICLIB_GEOID_PATH, or its own folder.
  static void GetDefaultDirectory(char (&directory)[kGeoidTextSize]);
};
}

#endif
