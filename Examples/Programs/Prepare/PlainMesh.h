// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Meshes in binary formats without structure. vtkPLYWriter and vtkSTLWriter would round coordinates
 * to 32-bit floats, which are 0.5 m apart at a UTM northing.
 */
#ifndef PlainMesh_h
#define PlainMesh_h

#include <string>

class vtkPolyData;

/// Bytes of a binary PLY file: 64-bit positions, 32-bit normals and texture coordinates (s, t) if
/// the mesh has them.
std::string MakePLY(vtkPolyData* mesh);

/// Bytes of a binary STL file. It holds 32-bit floats, so positions count from (x, y) of the mesh's
/// south-western corner rounded down to a whole number; z is kept.
std::string MakeSTL(vtkPolyData* mesh);

#endif
