// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How one surface is seen in one view: matrices, rays and clipping planes; uniforms of
 * shaders/vtkTerrainView.glsl. Private to the module.
 */
#ifndef vtkTerrain_render_View_h
#define vtkTerrain_render_View_h

#include "core/grid/Coordinates.h"
#include "core/grid/HeightCodes.h"
#include "core/rays/PixelRays.h"
#include "core/surface/TileSelection.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkMatrix4x4;
class vtkRenderer;

namespace terrain
{
class Uniforms;

/// A matrix that acts on column vectors.
glm::dmat4 ToGlm(vtkMatrix4x4* matrix);

/// Matrix from grid coordinates, z in height codes, to model coordinates.
glm::dmat4 ModelFromGrid(const GridGeometry& geometry, const HeightCodes& codes);

/// The matrices of a renderer's camera: world to view to display coordinates.
struct CameraMatrices
{
  explicit CameraMatrices(vtkRenderer* renderer);

  glm::dmat4 ViewFromWorld;
  glm::dmat4 DisplayFromView;
};

/// A box in grid coordinates.
using BoxGC = std::array<glm::dvec3, 2>;

class View
{
public:
  /// Looks at a surface in a box through a renderer's camera and the viewport in use.
  void Update(
    vtkRenderer* renderer, vtkActor* actor, const glm::dmat4& modelFromGrid, const BoxGC& box);

  /// The planes that cut the surface: a mapper's, at most six, then others in grid coordinates;
  /// kept is dot(plane, (x, y, z, 1)) >= 0.
  void SetClippingPlanes(
    vtkMapper* mapper, vtkActor* actor, const std::vector<glm::dvec4>& planesGC);

  void SetUniforms(Uniforms& uniforms) const;
  /// What is seen, for the selection of tiles, and what projects to so many pixels.
  TileView GetTileView(double pixels) const;
  /// The uniform terrainTolerance: what projects to so many pixels.
  void SetTolerance(Uniforms& uniforms, double pixels) const;

  /// True if some point of the near plane, or the eye, lies in the box.
  bool IsEyeInBox() const
  {
    return this->EyeInBox;
  }
  /// False if triangles turn round on their way from the grid to the view.
  bool KeepsOrientation() const
  {
    return this->OrientationKept;
  }
  ///@{
  /// Matrices from view to grid and to model coordinates, and the height of a code in the model.
  const glm::dmat4& GetGridFromView() const
  {
    return this->GridFromView;
  }
  const glm::dmat4& GetModelFromView() const
  {
    return this->ModelFromView;
  }
  double GetHeightOfCode() const
  {
    return this->HeightOfCode;
  }
  ///@}
  /// Width and height in pixels.
  glm::ivec2 GetSize() const
  {
    return { this->Viewport.z, this->Viewport.w };
  }

  /// Most planes of a mapper; VTK's.
  static constexpr int MostMapperPlanes = 6;

private:
  PixelRays Rays;
  glm::dmat4 GridFromView{ 1.0 };
  glm::dmat4 DisplayFromGrid{ 1.0 };
  glm::dmat4 ModelFromView{ 1.0 };
  double HeightOfCode = 1.0;
  glm::ivec4 Viewport{ 0 };
  BoxGC Box{};
  std::vector<glm::vec4> PlanesVC;
  bool EyeInBox = false;
  bool OrientationKept = true;
};
}
#endif
