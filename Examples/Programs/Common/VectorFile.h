// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Points, lines and polygons from vector files.
 */
#ifndef terrain_common_VectorFile_h
#define terrain_common_VectorFile_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;
class vtkTerrainGeoreference;

/// What becomes of polygons.
enum class Polygons
{
  Outlines, ///< lines, holes as well
  Areas,    ///< polygons, without their holes
  Rings     ///< closed lines, holes as well, and kPolygonOfRing; points and lines are left out
};

/// Cell array of Polygons::Rings: the number of the polygon that a ring belongs to, from 0 on. What
/// an odd number of its rings encloses belongs to a polygon.
constexpr const char* kPolygonOfRing = "Polygon";

/**
 * Points, lines and polygons of every layer of a file that GDAL opens as vectors, as vertices,
 * lines and polygons in the coordinates of a scene. Of GPX files waypoints, routes and tracks are
 * taken, not once more the points these consist of. Heights that a file does not have are 0.
 * Throws a Failure: no file, no geometry, no coordinate system.
 */
vtkSmartPointer<vtkPolyData> ReadVectors(
  const std::string& path, vtkTerrainGeoreference* scene, Polygons polygons = Polygons::Outlines);

/// The same with a field of the features, as the array of texts "Field" of the points: those of the
/// feature that they belong to, empty where it has none. "height" stands for the points' own
/// heights, as the file has them. Throws a Failure that names the fields if no feature has it.
/// Without a name of a field as ReadVectors().
vtkSmartPointer<vtkPolyData> ReadVectorsWithField(const std::string& path,
  vtkTerrainGeoreference* scene, const std::string& field, Polygons polygons = Polygons::Outlines);

/// The points of the tracks of a GPX file, in their order, as vertices, with their times as the
/// array of texts "Field" of the points: "2024/06/21 10:03:05+00", empty for none. Without any
/// points for other files.
vtkSmartPointer<vtkPolyData> ReadTrackPoints(
  const std::string& path, vtkTerrainGeoreference* scene);

#endif
