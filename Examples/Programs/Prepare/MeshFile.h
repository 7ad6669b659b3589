// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Meshes as files of other programs.
 */
#ifndef MeshFile_h
#define MeshFile_h

#include <array>
#include <string>

class vtkPolyData;

/// What a mesh file shows besides triangles.
struct MeshLook
{
  /// PNG or JPEG over the terrain, its pixels like the samples' cells; empty: none. glTF alone has
  /// it.
  std::string Texture;
  /// Where the mesh's origin lies. glTF alone has it, in full precision.
  std::array<double, 3> Origin{ { 0.0, 0.0, 0.0 } };
};

/// Why no mesh can be written under such a name, as one sentence; empty if one can.
std::string WhyNotMeshFile(const std::string& path, const MeshLook& look);

/// Whether such a file has coordinates of 32 bits, about a place of the mesh's own.
bool IsSinglePrecision(const std::string& path);

/// Whether such a file takes texture coordinates.
bool HasTextureCoordinates(const std::string& path, const MeshLook& look);

/**
 * Bytes of a mesh (triangles, with normals and texture coordinates if it has them) go to `partial`,
 * in the format that the suffix of `path` names:
 *   .glb           glTF 2.0: y up, metres; positions are float32 about the middle of the mesh,
 *                  which the node's matrix holds in full precision
 *   .ply .obj .vtp the mesh's own coordinates in full precision
 *   .stl           float32, x and y from the mesh's south-western corner (MakeSTL())
 * Returns one sentence if that failed, else nothing.
 */
std::string WriteMeshFile(
  vtkPolyData* mesh, const std::string& path, const std::string& partial, const MeshLook& look);

#endif
