// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLTerrainMapper
 * @brief   draws a heightfield by casting rays, without a mesh of its samples
 *
 * Draws the exact bilinear surface of a heightfield without a mesh of its samples. Two inputs:
 *
 *   port 0  vtkPolyData. For the technique Mesh, the mesh to draw. Rays need none: they start from
 *           the box of the heights, which is there by default.
 *   port 1  vtkImageData, the heights: W x H x 1 points whose active point scalars have one
 *           component of any numeric type. Rows run south to north; spacing and origin are in the
 *           unit of the heights. NaN, magnitudes from 1e30 on and hidden samples
 *           (HIDDENPOINT of vtkDataSetAttributes) have no height; a cell that touches one has no
 *           surface. Optional for the technique Mesh, which then has the normals of the mesh.
 *
 * The fragment shader finds the hit where VTK sets the depth and hands VTK its position, normal and
 * depth; lights, materials, clipping planes, translucency and render passes then work on the hit.
 *
 * How the surface looks is a vtkTerrainLook, GetLook(); the setters here pass on to it.
 *
 * Techniques: Pyramid, the default, is exact: rays pass through a pyramid of minimum and maximum
 * heights and meet the bilinear patches (Park and Oh, "GPU-only Terrain Rendering for
 * Walk-through"). Linear, Exponential and Equidistant are the searches of Fehér ("Terrain Rendering
 * with the Combination of Mesh Simplification and Displacement Mapping"): steps along the ray, then
 * secant steps. They step where the pyramid lets the surface be, which takes 1/6 to 1/140 of the
 * time of steps from the paper's coarse mesh on. Equidistant by default misses nothing; its hits
 * are off by EquidistantError. Linear and Exponential have the few steps of the paper
 * and the holes that it shows. Mesh draws the polygons of port 0 with normals from the heights;
 * so does Strips, which tells a vtkTerrainActor to put vtkTerrainStrips there.
 *
 * Where the eye or the near plane comes into the box of the terrain, the rays start at the near
 * plane and the far sides of that box are drawn instead of its near sides, so that the eye may be
 * anywhere.
 *
 * Precision: rays are set up in double precision relative to a cell near the hit. The distance of a
 * hit of Pyramid is right to HitError where ARB_gpu_shader_fp64 is there, at any size of
 * coordinates.
 *
 * Changes: colours and their sources, contours, hillshade, crossings, flat normals, culling, the
 * places of clipping planes and extracts, exaggeration and the steps of searches are uniforms: the
 * next frame takes as long as any. Another program is built the first time that something needs
 * one:
 *
 *   of the surface: a technique, columns, blocks, detail, a pixel tolerance, heights of another
 *     format, the first clipping plane or extract, the eye in the box of the terrain;
 *   of its colours: the first paint of any kind, drapes, textures, kinds of material;
 *   of the scene: other numbers and kinds of lights, render passes, translucency, depth offsets,
 *     selection.
 *
 * Building takes 0.4 to 0.7 s in software rendering (7 to 11 frames of 640 x 360 pixels and 4096 x
 * 4096 samples). The program is kept: from the second time on, such a change costs no more than a
 * frame. A first array is uploaded, which takes as long as 3 to 4 frames.
 *
 * Limits: heights up to the driver's largest texture (16384 samples a side on Mesa), or of any size
 * by SetTileSource. Direction matrices are refused. Lines and points of port 0 are drawn as always.
 *
 * Of what VTK does to a surface, these cannot work with rays or do something else:
 *   - Edges (EdgeVisibility) are those of a proxy, and are not drawn; the representations wireframe
 *     and points draw port 0 itself, in the colours of the surface if the technique is Mesh or
 *     Strips, else in the actor's own.
 *   - Normal maps and anisotropic reflection need tangents of a mesh; they are ignored. So is a
 *     general texture transform.
 *   - Flat shading takes the normals of bilinear patches; Gouraud is Phong shading.
 *   - The searches show the first surface only: let translucent terrain be drawn by the technique
 *     Pyramid.
 *   - vtkValuePass draws what has its array in port 0 (vtkTerrainCoarseMesh::PassPointArrays), and
 *     tells no mapper which array that is: in its floating-point mode the values are those that
 *     colours are made of here (SelectColorArray), at the surface's points; NaN where there is
 *     none.
 *   - A z-buffer of 24 bits is as coarse for a hit as for a mesh; vtkTerrainPicker and
 *     vtkTerrainDepthPass are exact.
 *
 * GetMTime() is that of what buffers and programs are built for; the look has its own, and each
 * change of it invokes the mapper's ModifiedEvent.
 *
 * @sa vtkTerrainLook vtkTerrainCoarseMesh vtkTerrainRasterReader vtkTerrainSource
 */
#ifndef vtkOpenGLTerrainMapper_h
#define vtkOpenGLTerrainMapper_h

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h"  // For vtkSmartPointer
#include "vtkTerrainLook.h"   // For its settings
#include "vtkTerrainModule.h" // For export macro

#include <memory> // For members
#include <string> // For std::string
#include <vector> // For ProcessSelectorPixelBuffers

class vtkImageData;
namespace terrain
{
class TileSource;
struct Features;
}

class VTKTERRAIN_EXPORT vtkOpenGLTerrainMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkOpenGLTerrainMapper* New();
  vtkTypeMacro(vtkOpenGLTerrainMapper, vtkOpenGLPolyDataMapper)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The heights, port 1.
  void SetHeightsConnection(vtkAlgorithmOutput* port)
  {
    this->SetInputConnection(1, port);
  }
  void SetHeightsData(vtkImageData* heights);
  vtkImageData* GetHeights();
  ///@}

  /// Says that of the heights' image only the samples of these columns and rows, both ends included
  /// and numbered as in its extent, have changed since they were last drawn or this was last
  /// called: just they, and the nodes of the pyramid above them, are brought up to date, on the
  /// graphics card too. To be called after the image's Modified(). Where the new heights leave the
  /// range of the old ones, all are taken anew; the range itself, and the bounds, do not shrink
  /// before that. A coarse mesh on port 0 is not concerned: the technique Pyramid needs none.
  void HeightsModified(int firstColumn, int lastColumn, int firstRow, int lastRow);

  /// Lowest and highest height, up to date, not exaggerated; lowest > highest if there is none.
  void GetHeightRange(double range[2]);

  /// Takes the mesh from port 0 and puts the box of the heights there, as by default.
  void RemoveMesh();

  ///@{
  /// One period of detail heights, port 2; optional. The surface is then the heights plus
  /// DetailScale times the detail, repeated from sample (0, 0) on with DetailCells cells along a
  /// cell of the heights, both bilinear. A period is as many samples as the image has; every one
  /// needs a height. The graphics card holds both images, not their product. The spacing of the
  /// detail does not count.
  void SetDetailConnection(vtkAlgorithmOutput* port)
  {
    this->SetInputConnection(2, port);
  }
  void SetDetailData(vtkImageData* detail);
  vtkImageData* GetDetail();
  ///@}

  /// Heights of any size by tiles, of which the image is one level: vtkTerrainRasterReader opens
  /// them (GetTileSource()). The technique Pyramid then draws the tiles that a view needs, read by
  /// threads, where the surface is bilinear and has no detail; all else shows the image. The
  /// tolerance is PixelTolerance, or half a pixel where that is 0 (vtkTerrainLook). Null, the
  /// default, for none.
  void SetTileSource(const std::shared_ptr<terrain::TileSource>& source)
  {
    if (this->Tiles != source)
    {
      this->Tiles = source;
      this->Modified();
    }
  }

  ///@{
  /// Whether frames wait for all the tiles that they need (default), or show those that are there;
  /// GetComplete() tells whether the last one had them all. It counts from the next frame on.
  void SetWaitForTiles(bool wait)
  {
    this->WaitForTiles = wait;
  }
  bool GetWaitForTiles() const
  {
    return this->WaitForTiles;
  }
  ///@}
  ///@{
  /// Pixels, >= 0, by which the next frames may be off at least, whatever the PixelTolerance of the
  /// look; default 0. For frames in haste (vtkTerrainActor): it is no setting of the picture,
  /// changes no time and tells no observer.
  void SetHastyTolerance(double pixels)
  {
    this->HastyTolerance = pixels;
  }
  double GetHastyTolerance() const
  {
    return this->HastyTolerance;
  }
  ///@}
  /// False if the last frame lacked tiles: another frame shows more.
  bool GetComplete() const;
  /// Tiles that the last frame needed.
  int GetNumberOfTiles() const;

  ///@{
  /// Most bytes of tiles in the host's memory and on the graphics card; defaults 1 GiB and 512 MiB.
  /// What a frame needs is kept on the host even beyond the budget. A budget of the card that is
  /// too small for a view coarsens it, with a warning.
  vtkSetClampMacro(HostMemoryBudget, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(HostMemoryBudget, vtkIdType);
  vtkSetClampMacro(CardMemoryBudget, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(CardMemoryBudget, vtkIdType);
  ///@}

  /// All settings of how the surface looks, never null; copy them by its DeepCopy().
  vtkTerrainLook* GetLook()
  {
    return this->Look;
  }
  /// Time of the last change of the picture that needs no other buffers: of the look, of the
  /// extract, of a part of the heights. vtkTerrainActor counts it as its own.
  vtkMTimeType GetLookTime();

  ///@{
  /// As vtkTerrainLook has it.
  using Techniques = vtkTerrainLook::Techniques;
  using Surfaces = vtkTerrainLook::Surfaces;
  using ComputeModes = vtkTerrainLook::ComputeModes;
  using ColorSources = vtkTerrainLook::ColorSources;
  static constexpr int MostDetailCells = vtkTerrainLook::MostDetailCells;
  ///@}
  /// Largest error of the distance of a hit of Pyramid, as a part of it, away from silhouettes:
  /// 1/250 of a pixel where 1080 lines show 30 degrees; of columns twice that. See the class
  /// comment.
  static constexpr double HitError = 2e-6;
  /// Largest error of the depth of a hit of Equidistant by default, in cells, times the sine of the
  /// ray's angle with the surface, away from silhouettes; measured 2e-3.
  static constexpr double EquidistantError = 4e-3;
  ///@{
  /// A setting of the look, as the method of vtkTerrainLook that has this name, where its unit,
  /// range and default are documented.
  void SetTechnique(vtkTerrainLook::Techniques technique);
  vtkTerrainLook::Techniques GetTechnique() const;
  void SetVerticalExaggeration(double exaggeration);
  double GetVerticalExaggeration() const;
  void SetDetailCells(int cells);
  int GetDetailCells() const;
  void SetDetailScale(double scale);
  double GetDetailScale() const;
  void SetSteps(int steps);
  int GetSteps() const;
  void SetLongSteps(int steps);
  int GetLongSteps() const;
  void SetSecantSteps(int steps);
  int GetSecantSteps() const;
  void SetStepLength(double cells);
  double GetStepLength() const;
  void SetSurface(vtkTerrainLook::Surfaces surface);
  vtkTerrainLook::Surfaces GetSurface() const;
  void SetPixelTolerance(double pixels);
  double GetPixelTolerance() const;
  void SetShowCrossings(bool show);
  bool GetShowCrossings() const;
  void SetMaximumShownCrossings(int crossings);
  int GetMaximumShownCrossings() const;
  void SetComputeMode(vtkTerrainLook::ComputeModes mode);
  vtkTerrainLook::ComputeModes GetComputeMode() const;
  void SetUseBeams(bool use);
  bool GetUseBeams() const;
  void SetColorSource(vtkTerrainLook::ColorSources source);
  vtkTerrainLook::ColorSources GetColorSource() const;
  void SetDrape(vtkImageData* picture, const double bounds[4])
  {
    this->Look->SetDrape(picture, bounds);
  }
  void SetDrape(vtkImageData* picture);
  vtkImageData* GetDrape() const;
  void SetContours(bool show);
  bool GetContours() const;
  void SetContourInterval(double heights);
  double GetContourInterval() const;
  void SetContourWidth(double pixels);
  double GetContourWidth() const;
  void SetContourIndex(int every);
  int GetContourIndex() const;
  void SetContourColor(double red, double green, double blue, double opacity = 1.0)
  {
    this->Look->SetContourColor(red, green, blue, opacity);
  }
  void SetHillshade(bool show);
  bool GetHillshade() const;
  void SetHillshadeAzimuth(double degrees);
  double GetHillshadeAzimuth() const;
  void SetHillshadeAltitude(double degrees);
  double GetHillshadeAltitude() const;
  void SetBlock(bool show);
  bool GetBlock() const;
  void SetBlockBase(double height);
  double GetBlockBase() const;
  void SetMaximumLayers(int layers);
  int GetMaximumLayers() const;
  void SetSampleShading(bool shade);
  bool GetSampleShading() const;
  void SetSunShadows(bool cast);
  bool GetSunShadows() const;
  void SetSunAngle(double degrees);
  double GetSunAngle() const;
  void SetSkyLight(double light);
  double GetSkyLight() const;
  ///@}

  ///@{
  /// Draw the samples first[0] <= i <= last[0], first[1] <= j <= last[1] only. Default all of them:
  /// GetExtract() is false then, and changes nothing.
  void SetExtract(const int first[2], const int last[2]);
  bool GetExtract(int first[2], int last[2]) const;
  void ExtractAll();
  ///@}

  ///@{
  /// As vtkMapper, with the heights' arrays.
  bool HasTranslucentPolygonalGeometry() override;
  ///@}

  /// For vtkHardwareSelector: with rays, cells and points are those of the grid of heights,
  /// i + (W - 1) * j and i + W * j, and a point is the sample nearest to the hit. The technique
  /// Mesh has the cells and points of port 0.
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, std::vector<unsigned int>& offsets, vtkProp* prop) override;

  /// Nodes of the pyramid and cells that the ray of each pixel visited in the last drawing: W x H
  /// points of int, row 0 at the bottom, where the view is W x H pixels. Null unless the compute
  /// shader has cast the rays (SetComputeMode()).
  vtkSmartPointer<vtkImageData> ReadCrossings();

  /// Number of times all heights went to the graphics card.
  int GetNumberOfHeightUploads() const;

  /// Number of texels that went to the graphics card, those of the pyramid included.
  vtkIdType GetNumberOfUploadedTexels() const;

  /// Number of times that bounds of a sun's rays over the heights were built, which tell for most
  /// points whether they are in shadow.
  int GetNumberOfShadowBoundsBuilds() const;

  ///@{
  /// Number of times that shaders and vertex buffers were built.
  int GetNumberOfShaderBuilds() const;
  int GetNumberOfBufferBuilds() const;
  ///@}

  /// Bytes of textures on the graphics card.
  vtkIdType GetTextureMemorySize() const;

  ///@{
  /// Bounds of the exaggerated heights in model coordinates.
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override
  {
    this->Superclass::GetBounds(bounds);
  }
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window) override;

  vtkOpenGLTerrainMapper(const vtkOpenGLTerrainMapper&) = delete;
  void operator=(const vtkOpenGLTerrainMapper&) = delete;

protected:
  vtkOpenGLTerrainMapper();
  ~vtkOpenGLTerrainMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void ComputeBounds() override;

  void RenderPiece(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceStart(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceDraw(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceFinish(vtkRenderer* ren, vtkActor* act) override;

  void BuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;
  bool GetNeedToRebuildShaders(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;

  /// Shaders of a program by their stage, as VTK passes them.
  using ShaderMap = std::map<vtkShader::Type, vtkShader*>;
  void BuildShaders(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderValues(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderPositionVC(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderDepth(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderNormal(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderColor(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderLight(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderTCoord(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderClip(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderPicking(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderCoincidentOffset(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  bool DrawingEdges(vtkRenderer* ren, vtkActor* act) override;
  void UpdateMaximumPointCellIds(vtkRenderer* ren, vtkActor* act) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;
  void SetCameraShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;

private:
  class vtkInternals;

  // The recipe of a frame: update, prepare, draw.
  bool UpdateSurface();
  void DrawLayers(vtkRenderer* ren, vtkActor* act);

  terrain::Features FindFeatures(vtkRenderer* ren, vtkActor* act);
  void ReportWords(const std::string& words);
  /// Marks a change that is one of uniforms: of the picture, of no buffer and no program.
  void PictureModified();

  vtkSmartPointer<vtkTerrainLook> Look;
  std::shared_ptr<terrain::TileSource> Tiles;
  bool WaitForTiles = true;
  double HastyTolerance = 0.0;
  vtkIdType HostMemoryBudget = vtkIdType{ 1 } << 30;
  vtkIdType CardMemoryBudget = vtkIdType{ 1 } << 29;
  vtkTimeStamp PictureTime;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
