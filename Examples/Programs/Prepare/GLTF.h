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

#include <string>

class vtkPolyData;

/// The file's bytes. mesh: triangles; normals and texture coordinates are written if it has them.
/// texture: bytes of a PNG or JPEG file, or empty. Positions are relative to the middle of the
/// bounds, rounded to metres; the node's matrix moves them there and turns z up into glTF's y up.
std::string MakeGLB(vtkPolyData* mesh, const std::string& texture);

#endif
