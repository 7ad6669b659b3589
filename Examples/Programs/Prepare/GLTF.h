// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A mesh as binary glTF 2.0 (ISO/IEC 12113). vtkGLTFExporter and vtkGLTFWriter put large
 * coordinates into float32 and leave z up, so terrains in projected coordinates would tremble and
 * lie on their side.
 */
#ifndef GLTF_h
#define GLTF_h

#include <array>
#include <iosfwd>
#include <string>

class vtkPolyData;

/// Writes the file, some numbers at a time; the state of the stream tells whether that worked.
/// mesh: triangles; normals and texture coordinates are written if it has them. texture: bytes of a
/// PNG or JPEG file, or empty. origin: where that of the mesh lies. Positions are relative to the
/// middle of the bounds, rounded to metres; the node's matrix moves them there and turns z up into
/// glTF's y up. False, and nothing is written, if it would take more than the 4 GiB of the format.
bool WriteGLB(vtkPolyData* mesh, const std::array<double, 3>& origin, const std::string& texture,
  std::ostream& file);

#endif
