// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The colours of a surface on the GPU: textures and uniforms of shaders/vtkTerrainColor.glsl, made
 * from a look and from the scalars that a mapper selects. Private to the module.
 */
#ifndef vtkTerrain_render_Paint_h
#define vtkTerrain_render_Paint_h

#include "render/Features.h"
#include "vtkTerrainLook.h"

#include "core/grid/Coordinates.h"
#include "core/grid/HeightCodes.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <glm/glm.hpp>

#include <array>
#include <string>

class vtkDataArray;
class vtkMapper;
class vtkOpenGLRenderWindow;

namespace terrain
{
class Uniforms;

class Paint
{
public:
  /// Brings textures up to date with the look, the mapper's scalars and lookup table, and the
  /// heights' image. Returns an empty string, or one sentence that says what cannot be shown.
  std::string Update(vtkMapper* mapper, vtkImageData* heights, const vtkTerrainLook* look,
    vtkOpenGLRenderWindow* window);

  /// Whether the shader paints. Once it has, it goes on, if with nothing but the material's colour:
  /// to switch colours off costs no other program.
  bool Paints() const
  {
    return this->Painted;
  }
  /// Components of the draped picture; 0 for none.
  int GetDrapeComponents() const
  {
    return this->DrapeTexture.Used ? this->DrapeComponents : 0;
  }

  /// True if some colours of the surface may let see through.
  static bool IsTranslucent(vtkMapper* mapper, vtkImageData* heights, const vtkTerrainLook* look);

  void Activate();
  void Deactivate();
  void SetUniforms(Uniforms& uniforms, const HeightCodes& codes, const GridGeometry& geometry,
    const vtkTerrainLook* look) const;
  void ReleaseGraphicsResources(vtkWindow* window);

  /// Number of uploads of values, direct colours and drapes so far, for tests that count them.
  int GetNumberOfUploads() const
  {
    return this->NumberOfUploads;
  }

private:
  /// A texture and what it was made from.
  struct Made
  {
    vtkNew<vtkTextureObject> Texture;
    std::string From;
    bool Used = false;
  };

  /// Puts something small in the place of textures that were never made: the program names them
  /// all.
  void FillIn();
  std::string UpdateScalars();
  std::string UpdateArray(vtkDataArray* array, bool cells);
  void UpdateValues(vtkDataArray* array, int component, int width, int height);
  void UpdateColors(vtkDataArray* array, int width, int height);
  void UpdateColorMap();
  std::string UpdateDrape();
  bool StartsToMake(Made& made, const std::string& from);
  glm::dvec2 ValueScale(const HeightCodes& codes) const;
  void SetColorUniforms(Uniforms& uniforms, const HeightCodes& codes) const;
  void SetLineUniforms(Uniforms& uniforms, const HeightCodes& codes, const GridGeometry& geometry,
    const vtkTerrainLook* look) const;
  std::array<Made*, 4> Textures()
  {
    return { &this->ColorMap, &this->Values, &this->Colors, &this->DrapeTexture };
  }

  /// What Update() was called with, during it.
  vtkMapper* Mapper = nullptr;
  vtkImageData* Heights = nullptr;
  const vtkTerrainLook* Look = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;

  PaintKinds Kind = PaintKinds::Material;
  bool Painted = false;
  /// Whether values or colours are those of cells.
  bool OfCells = false;
  Made ColorMap;
  Made Values;
  Made Colors;
  Made DrapeTexture;
  std::array<glm::vec4, 3> SpecialColors{};
  /// Position in the colour map = x * value, or its logarithm, + y.
  glm::dvec2 ColorScale{ 1.0, 0.0 };
  bool Logarithm = false;
  double ValueOffset = 0.0;
  int DrapeComponents = 0;
  int NumberOfUploads = 0;
};
}
#endif
