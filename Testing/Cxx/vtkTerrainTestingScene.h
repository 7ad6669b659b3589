// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Scenes with a terrain drawn by rays, judged by the same scenes with the terrain as a mesh: every
 * cell of the heights as 2 x 5 x 5 triangles on its bilinear patch, so that a picture of 200 x 150
 * pixels does not tell the two surfaces apart. The mesh is drawn twice: by the technique Mesh,
 * which shares shaders with the rays, and by a stock vtkPolyDataMapper, lit by normals that are
 * computed here in double precision.
 */
#ifndef vtkTerrainTestingScene_h
#define vtkTerrainTestingScene_h

#include "vtkTerrainTesting.h"

#include "vtkOpenGLTerrainMapper.h"

#include "vtkActor.h"
#include "vtkPolyData.h"

#include <array>
#include <functional>
#include <vector>

class vtkMapper;

namespace vtkTerrainTesting
{
/// Hills of 41 x 33 samples at spacings 10 and 12, about 60 to 140 high, origin (0, 0, 0); with a
/// hole of NaN around sample (22, 18) if asked.
vtkSmartPointer<vtkImageData> MakeHills(bool withHole = false);

/// The surface of heights as triangles, parts x parts x 2 in each cell, row by row from the south.
/// With the image's arrays, those of points interpolated; texture coordinates 0..1 from the first
/// to the last sample; and cell arrays "Slope" and "Aspect" in degrees, of the bilinear patch.
vtkSmartPointer<vtkPolyData> MakeFineMesh(vtkImageData* heights, int parts = 5);

/// A fine mesh of exaggerated heights with the normals that the surface is lit by: those of central
/// differences of the bilinear surface over a cell's width, which end at the border, and at the
/// point where there are no heights.
vtkSmartPointer<vtkPolyData> MakeLitMesh(vtkImageData* heights, double exaggeration);

/// A terrain of a scene.
struct TerrainProp
{
  vtkSmartPointer<vtkOpenGLTerrainMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
};

/**
 * A window of 200 x 150 pixels with one renderer. The camera looks south over the hills, so that a
 * mesh is drawn from far to near.
 */
class TerrainScene
{
public:
  explicit TerrainScene(vtkOpenGLTerrainMapper::Techniques technique);

  /// Makes a terrain, drawn as the scene's technique says, and adds it to the renderer.
  TerrainProp AddTerrain(vtkImageData* heights);

  /// A sphere of a radius around a position, added to the renderer.
  vtkSmartPointer<vtkActor> AddSphere(double x, double y, double z, double radius);

  /// Sets eye and focal point.
  void Look(const std::array<double, 3>& eye, const std::array<double, 3>& focus);

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<TerrainProp> Terrains;

private:
  vtkOpenGLTerrainMapper::Techniques Technique;
};

/// Adds to a scene that holds the terrain of MakeHills().
using SceneFunction = std::function<void(TerrainScene& scene, const TerrainProp& terrain)>;

/// What is demanded of a scene.
struct Demands
{
  /// Technique that is judged.
  vtkOpenGLTerrainMapper::Techniques Technique = vtkOpenGLTerrainMapper::Techniques::Pyramid;
  /// Share of the pixels away from silhouettes that must agree within 8 of 255.
  double Share = 0.999;
  /// Share of the pixels that the scene function must change, lest nothing be tested.
  double Effect = 0.01;
  /// Largest mean difference of the pixels away from silhouettes to those of a stock mapper, of
  /// 255; 0: the scene has colours that a stock mapper does not know, and is not drawn by one.
  double StockMean = 0.5;
  /// Parts of a cell's side in the mesh that DrawsAsThePlainMesh() compares with.
  int Parts = 5;
  /// Heights of the first terrain; null for MakeHills().
  vtkSmartPointer<vtkImageData> Heights;
};

/// Settings that a terrain and a mesh have in common.
using PropFunction = std::function<void(vtkMapper* mapper, vtkActor* actor)>;

/// Draws a terrain by rays and its fine mesh by a plain vtkPolyDataMapper, without lights, and
/// compares as DrawsAsTheMesh().
testing::AssertionResult DrawsAsThePlainMesh(
  const PropFunction& terrain, const PropFunction& mesh, const Demands& demands = Demands());

/// The picture of a scene.
vtkSmartPointer<vtkImageData> DrawScene(const SceneFunction& function,
  vtkOpenGLTerrainMapper::Techniques technique = vtkOpenGLTerrainMapper::Techniques::Pyramid,
  vtkImageData* heights = nullptr);

/// Draws a scene by rays and as a mesh by a stock mapper and compares as DrawsAsTheMesh().
testing::AssertionResult DrawsAsStock(
  const SceneFunction& function, const Demands& demands = Demands());

/// Draws a scene by rays and as a mesh, of ours and of a stock mapper, and compares the pictures
/// outside of a band of one pixel at silhouettes. Where they differ, both and their difference are
/// written to the output directory.
testing::AssertionResult DrawsAsTheMesh(
  const SceneFunction& function, const Demands& demands = Demands());
}

#endif
