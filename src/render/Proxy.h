// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is rasterized so that the rays of a surface start: its box. Private to the module.
 */
#ifndef vtkTerrain_render_Proxy_h
#define vtkTerrain_render_Proxy_h

#include "render/View.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <glm/glm.hpp>

#include <array>

class vtkOpenGLVertexBufferObjectGroup;

namespace terrain
{
class Uniforms;

/// Matrix from the coordinates of a vertex buffer, which VTK may shift and scale, to model
/// coordinates.
glm::dmat4 ModelFromBuffer(vtkOpenGLVertexBufferObjectGroup* buffers);

class Proxy
{
public:
  /// Makes the box of a surface: size samples, from the lowest height that is drawn to the largest
  /// code, with a margin for rounding. The geometry is not exaggerated: the matrices of vertices do
  /// that.
  void Update(const GridGeometry& geometry, const HeightCodes& codes, const glm::ivec2& size,
    double lowestHeight);
  /// Makes a box in model coordinates, that of a globe, whose bounds follow the view's anchor
  /// (Globe::GetAnchoredBounds()).
  void Update(const BoxGC& boxMC);
  /// Empties the box.
  void Clear();

  vtkPolyData* GetBox()
  {
    return this->Box;
  }
  /// The box of a flat surface with its margin, cells and height codes.
  const BoxGC& GetBounds() const
  {
    return this->Bounds;
  }

  /// The mesh with texture coordinates, which VTK's code for textures asks for.
  vtkPolyData* WithTextureCoordinates(vtkPolyData* mesh);

private:
  vtkNew<vtkPolyData> Box;
  BoxGC Bounds{};
  std::array<glm::dvec3, 2> CornersMC{};
  vtkNew<vtkPolyData> Textured;
  vtkMTimeType TexturedTime = 0;
};
}
#endif
