// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The colours of a terrain: settings, textures and uniforms of shaders/vtkTerrainColor.glsl.
 * vtkOpenGLTerrainMapper documents the settings. Private to the module.
 */
#ifndef vtkTerrain_render_Coloring_h
#define vtkTerrain_render_Coloring_h

#include "vtkOpenGLTerrainMapper.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <glm/glm.hpp>

#include <array>
#include <string>

class vtkDataArray;
class vtkOpenGLRenderWindow;

namespace terrain
{
class HeightTexture;
class Uniforms;

class Coloring
{
public:
  /// Settings.
  vtkOpenGLTerrainMapper::ColorSources Source = vtkOpenGLTerrainMapper::ColorSources::Array;
  vtkSmartPointer<vtkImageData> Drape;
  std::array<double, 4> DrapeBounds{ 0.0, 0.0, 0.0, 0.0 };
  bool Contours = false;
  double ContourInterval = 100.0;
  double ContourWidth = 1.5;
  glm::dvec4 ContourColor{ 0.0, 0.0, 0.0, 1.0 };
  bool Hillshade = false;
  double HillshadeAzimuth = 315.0;
  double HillshadeAltitude = 45.0;
  bool ShowCrossings = false;
  int MaximumShownCrossings = 64;

  /// Brings textures up to date with the settings, the mapper's scalars and lookup table, and the
  /// heights' image. Returns an empty string, or one sentence that says what cannot be shown.
  std::string Update(vtkOpenGLTerrainMapper* mapper, vtkOpenGLRenderWindow* window);

  /// Whether the shader paints. Once it has, it goes on, if with nothing but the material's colour:
  /// to switch colours off costs no other program.
  bool Paints() const
  {
    return this->Painted;
  }
  /// Defines of the shader.
  std::string Defines() const;

  /// True if some colours of the surface may let see through.
  static bool IsTranslucent(vtkOpenGLTerrainMapper* mapper);

  void Activate();
  void Deactivate();
  void SetUniforms(Uniforms& uniforms, const HeightTexture& heights, double exaggeration) const;
  void ReleaseGraphicsResources(vtkWindow* window);

  /// Number of uploads of values, direct colours and drapes so far, for tests that count them.
  int GetNumberOfUploads() const
  {
    return this->NumberOfUploads;
  }

private:
  /// What the colour of a place is made from; twin in shaders/vtkTerrainColor.glsl.
  enum class Kinds
  {
    Material,
    Height,
    Slope,
    Aspect,
    Values,
    Colors,
    Crossings
  };
  /// A texture and what it was made from.
  struct Made
  {
    vtkNew<vtkTextureObject> Texture;
    std::string From;
    bool Used = false;
  };

  /// Puts something small in the place of textures that were never made: the program names them
  /// all.
  void FillIn(const int heights[2], vtkOpenGLRenderWindow* window);
  std::string UpdateScalars(vtkOpenGLTerrainMapper* mapper, vtkOpenGLRenderWindow* window);
  std::string UpdateArray(
    vtkOpenGLTerrainMapper* mapper, vtkDataArray* array, bool cells, vtkOpenGLRenderWindow* window);
  void UpdateValues(
    vtkDataArray* array, int component, int width, int height, vtkOpenGLRenderWindow* window);
  void UpdateColors(vtkOpenGLTerrainMapper* mapper, vtkDataArray* array, int width, int height,
    vtkOpenGLRenderWindow* window);
  void UpdateColorMap(vtkOpenGLTerrainMapper* mapper, vtkOpenGLRenderWindow* window);
  std::string UpdateDrape(vtkOpenGLRenderWindow* window);
  bool StartsToMake(Made& made, const std::string& from, vtkOpenGLRenderWindow* window);
  glm::dvec2 ValueScale(const HeightTexture& heights) const;
  std::array<Made*, 4> Textures()
  {
    return { &this->ColorMap, &this->Values, &this->Colors, &this->DrapeTexture };
  }

  Kinds Kind = Kinds::Material;
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
