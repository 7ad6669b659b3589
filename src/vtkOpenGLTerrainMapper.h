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
 *           unit of the heights. NaN, infinite and hidden samples (HIDDENPOINT of
 *           vtkDataSetAttributes) have no height; a cell that touches one has no surface. Optional
 *           for the technique Mesh, which then has the normals of the mesh.
 *
 * The fragment shader finds the hit where VTK sets the depth and hands VTK its position, normal and
 * depth; lights, materials, clipping planes, translucency and render passes then work on the hit.
 *
 * Techniques: Pyramid, the default, is exact: rays pass through a pyramid of minimum and maximum
 * heights and meet the bilinear patches (Park and Oh, "GPU-only Terrain Rendering for
 * Walk-through"). Linear, Exponential and Equidistant are the searches of Fehér ("Terrain Rendering
 * with the Combination of Mesh Simplification and Displacement Mapping"): steps along the ray, then
 * secant steps. They step where the pyramid lets the surface be, which takes 1/6 to 1/140 of the
 * time of steps from the paper's coarse mesh on. Equidistant by default misses nothing; its depths
 * are those of Pyramid to 1e-3 of a cell. Linear and Exponential have the few steps of the paper
 * and the holes that it shows. Mesh draws the polygons of port 0 with normals from the heights.
 *
 * Where the eye or the near plane comes into the box of the terrain, the rays start at the near
 * plane and the far sides of that box are drawn instead of its near sides, so that the eye may be
 * anywhere.
 *
 * Precision: rays are set up in double precision relative to a cell near the hit; the distance of a
 * hit is right to 1e-6 relative where ARB_gpu_shader_fp64 is there, at any size of coordinates.
 *
 * Changes: colours and their sources, contours, hillshade, crossings, flat normals, culling, the
 * places of clipping planes and extracts, exaggeration and the steps of searches are uniforms: the
 * next frame takes as long as any. Another program is built the first time that something needs
 * one: the first paint of any kind, the first clipping plane or extract, drapes, textures and kinds
 * of material, other numbers and kinds of lights, render passes, translucency, columns, a pixel
 * tolerance, blocks, techniques, the eye in the box of the terrain, detail, heights of another
 * format, depth offsets, selection. That takes 0.4 to 0.7 s in software rendering (7 to 11 frames
 * of 640 x 360 pixels and 4096 x 4096 samples), and the program is kept: from the second time on,
 * such a change costs no more than a frame, either. A first array is uploaded: 3 to 4 frames.
 *
 * Limits: heights up to the largest texture of the driver (16384 samples a side on Mesa). A
 * direction matrix of the image is refused. Lines and points of port 0 are drawn as they are.
 *
 * Of what VTK does to a surface, these cannot work with rays or do something else:
 *   - Edges (EdgeVisibility) are those of a proxy, and are not drawn; the representations wireframe
 *     and points draw port 0 itself.
 *   - Normal maps and anisotropic reflection need tangents of a mesh; they are ignored. So is a
 *     general texture transform.
 *   - Flat shading takes the normals of bilinear patches; Gouraud is Phong shading.
 *   - The searches show the first surface only: let translucent terrain be drawn by the technique
 *     Pyramid.
 *   - vtkValuePass draws what has its array in port 0 (vtkTerrainCoarseMesh::PassPointArrays), and
 *     tells no mapper which array that is: in its floating-point mode the values are those that
 *     colours are made of here (SelectColorArray), at the surface's points; NaN where there is
 * none.
 *   - A z-buffer of 24 bits is as coarse for a hit as for a mesh; vtkTerrainPicker and
 *     vtkTerrainDepthPass are exact.
 *
 * @sa vtkTerrainCoarseMesh vtkTerrainRasterReader vtkTerrainSource
 */
#ifndef vtkOpenGLTerrainMapper_h
#define vtkOpenGLTerrainMapper_h

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h"  // For vtkSmartPointer
#include "vtkTerrainModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For ProcessSelectorPixelBuffers

class vtkImageData;
namespace terrain
{
class ComputeTexture;
}
namespace terrain
{
class Uniforms;
}
namespace terrain
{
struct SampleRectangle;
}

class VTKTERRAIN_EXPORT vtkOpenGLTerrainMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkOpenGLTerrainMapper* New();
  vtkTypeMacro(vtkOpenGLTerrainMapper, vtkOpenGLPolyDataMapper)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How the surface is drawn, see the class description.
  enum class Techniques
  {
    Mesh,
    Linear,
    Exponential,
    Equidistant,
    Pyramid
  };

  ///@{
  /// The technique; default Pyramid.
  void SetTechnique(Techniques technique);
  Techniques GetTechnique() const
  {
    return this->Technique;
  }
  ///@}

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

  ///@{
  /// Detail cells along a cell of the heights: a power of two from 1 to MostDetailCells, default
  /// 16. Changing it builds and uploads nothing.
  void SetDetailCells(int cells);
  int GetDetailCells() const
  {
    return this->DetailCells;
  }
  static constexpr int MostDetailCells = 1024;
  ///@}

  ///@{
  /// Factor of the detail's heights, >= 0; default 1. Changing it builds and uploads nothing.
  void SetDetailScale(double scale);
  double GetDetailScale() const
  {
    return this->DetailScale;
  }
  ///@}

  ///@{
  /// Drawn height over true height, > 0; default 1. Heights are exaggerated from the image's origin
  /// in z. A uniform of the shader: changing it builds and uploads nothing.
  void SetVerticalExaggeration(double exaggeration);
  double GetVerticalExaggeration() const
  {
    return this->VerticalExaggeration;
  }
  ///@}

  ///@{
  /// The searches: steps of the first length, then steps of double length (Equidistant only), then
  /// secant steps. 0 and less choose (the default): Fehér's 5 steps for Linear and 10 for
  /// Exponential, each with 2 secant steps; for Equidistant as many as the longest ray needs, and 4
  /// secant steps. Fehér has 5 steps, 10 long ones and 2 secant steps there. At most 256 steps of
  /// Linear and Exponential, 10^6 of Equidistant and 32 secant steps are taken: more count as that.
  void SetSteps(int steps);
  int GetSteps() const
  {
    return this->Steps;
  }
  void SetLongSteps(int steps);
  int GetLongSteps() const
  {
    return this->LongSteps;
  }
  void SetSecantSteps(int steps);
  int GetSecantSteps() const
  {
    return this->SecantSteps;
  }
  ///@}

  ///@{
  /// Length of a step of Equidistant, in cells; 0, less and NaN choose (the default, 1.5). Heights
  /// count as cells that are as high as wide. A step of less than 2 cells passes by nothing; longer
  /// ones pass by what is thinner than a step. Fehér's value is 0.025 of the terrain's side for
  /// 32 x 32 quads. Less than 1/8 counts as 1/8, more than 10^6 as 10^6.
  void SetStepLength(double cells);
  double GetStepLength() const
  {
    return this->StepLength;
  }
  ///@}

  /// The surface between the samples: bilinear patches, or columns of constant height around the
  /// samples, the nearest sample's height.
  enum class Surfaces
  {
    Bilinear,
    Columns
  };
  ///@{
  /// The surface that the technique Pyramid draws; the other techniques know only the bilinear one.
  /// Default Bilinear.
  void SetSurface(Surfaces surface);
  Surfaces GetSurface() const
  {
    return this->Surface;
  }
  ///@}

  ///@{
  /// The technique Pyramid may end its search at a square of at least 2 x 2 cells that, in its side
  /// and in its relief, projects to less than this number of pixels, >= 0: the surface is then
  /// drawn where the ray enters the box around that square. Default 0: exact. It tells where cells
  /// are smaller than half of it. Measured on hills seen at 45 degrees, along the ray: with 1, half
  /// of the pixels were off by less than 0.4 pixels, 95 % by less than 2.5; with 4 by 1.2 and 4.3.
  /// No hit comes later than the exact one; what a ray passes by within such a box, such as a rim,
  /// is seen as hit. Large tolerances show dark specks where the box is entered above a cell that
  /// faces away.
  void SetPixelTolerance(double pixels);
  double GetPixelTolerance() const
  {
    return this->PixelTolerance;
  }
  ///@}

  ///@{
  /// Draw, in place of the surface's colour, how many nodes or samples each pixel's ray took: blue
  /// for none to red for the given number and above. Default off, 64.
  void SetShowCrossings(bool show);
  bool GetShowCrossings() const;
  void SetMaximumShownCrossings(int crossings);
  int GetMaximumShownCrossings() const;
  ///@}

  ///@{
  /// Cast the rays in a compute shader ahead of drawing, where OpenGL 4.3 is there, instead of in
  /// the fragment shader: the same picture. Compute shaders have the whole
  /// chip where drawing has a part of it, and cast no ray twice in passes that draw the view more
  /// than once. Default on, but for software rendering.
  enum class ComputeModes
  {
    Automatic,
    Off,
    On
  };
  void SetComputeMode(ComputeModes mode);
  ComputeModes GetComputeMode() const
  {
    return this->ComputeMode;
  }
  ///@}

  ///@{
  /// Let the rays begin where those of a tile of 8 x 8 pixels can first
  /// meet the surface, which a compute shader finds ahead of drawing where OpenGL 4.3 is there: the
  /// same picture, in software rendering up to a third sooner, on graphics cards up to a tenth.
  /// Default on.
  void SetUseBeams(bool use);
  bool GetUseBeams() const
  {
    return this->UseBeams;
  }
  ///@}

  /// Where the values come from that colour the surface while ScalarVisibility is on. They pass
  /// through the lookup table or transfer function and the scalar range as in any mapper; values
  /// are interpolated, then mapped. Array, the default, is the array of the heights' image that
  /// ScalarMode, SelectColorArray and the table's vector mode select, of its points or its cells;
  /// the heights themselves unless told otherwise. Colours (unsigned chars by default,
  /// SetColorModeToDirectScalars) and tables of annotated values are mixed after mapping. Height
  /// makes hypsometric tints whatever ScalarMode says. Slope is in degrees from the horizontal;
  /// Aspect is the direction downhill in degrees clockwise from north, NaN where it is level; both
  /// without exaggeration.
  enum class ColorSources
  {
    Array,
    Height,
    Slope,
    Aspect
  };
  void SetColorSource(ColorSources source);
  ColorSources GetColorSource() const;
  ///@}

  ///@{
  /// Lays a picture over the colours of the surface, below lights and contour lines: W x H x 1
  /// points of 1 to 4 unsigned chars (grey, grey and alpha, RGB, RGBA), row 0 southernmost. What is
  /// transparent, and what lies beside the picture, keeps the surface's colour. bounds are west,
  /// east, south and north of the picture's outer edges in the coordinates of the heights; without
  /// them, the image's own: pixel centres at origin + index * spacing. Filtered with mipmaps,
  /// anisotropic up to 16 (but for llvmpipe). nullptr takes the picture away. (An actor's own
  /// vtkTexture spans the terrain: texture coordinates 0 at the first sample, 1 at the last.)
  void SetDrape(vtkImageData* picture, const double bounds[4]);
  void SetDrape(vtkImageData* picture);
  vtkImageData* GetDrape() const;
  ///@}

  ///@{
  /// Draw contour lines: at multiples of an interval in the unit of heights (default 100), of a
  /// width in pixels (default 1.5) with smooth edges, in a colour (default opaque black). Lines
  /// closer than their width run into a grey that fades as they come closer still. Default off.
  void SetContours(bool show);
  bool GetContours() const;
  void SetContourInterval(double heights);
  double GetContourInterval() const;
  void SetContourWidth(double pixels);
  double GetContourWidth() const;
  void SetContourColor(double red, double green, double blue, double opacity = 1.0);
  ///@}

  ///@{
  /// Multiply the colours with the cosine of the angle between the surface and a sun, which needs
  /// no lights (turn the property's lighting off). Azimuth in degrees clockwise from north (default
  /// 315), altitude in degrees above the horizon (default 45). Default off.
  void SetHillshade(bool show);
  bool GetHillshade() const;
  void SetHillshadeAzimuth(double degrees);
  double GetHillshadeAzimuth() const;
  void SetHillshadeAltitude(double degrees);
  double GetHillshadeAltitude() const;
  ///@}

  ///@{
  /// Draw the samples first[0] <= i <= last[0], first[1] <= j <= last[1] only. Default all of them.
  void SetExtract(const int first[2], const int last[2]);
  void ExtractAll();
  ///@}

  ///@{
  /// Draw a solid block from the surface down to a height (default 0), with the technique Pyramid:
  /// walls along the borders of what is drawn, a floor, and faces where clipping planes cut. Holes
  /// without data have no walls. Default off.
  void SetBlock(bool show);
  bool GetBlock() const;
  void SetBlockBase(double height);
  double GetBlockBase() const;
  ///@}

  ///@{
  /// Most surfaces behind each other that a translucent terrain shows (opacity below 1, translucent
  /// colours), with the technique Pyramid. Each casts all rays again. Default 4.
  void SetMaximumLayers(int layers);
  int GetMaximumLayers() const;
  ///@}

  ///@{
  /// Cast a ray for each sample where the window has multisamples, which makes silhouettes smooth,
  /// for as many times the work. Without it, multisampling smooths the edges of other actors, not
  /// those of the terrain: the fragments of its proxy cover whole pixels. Default off.
  void SetSampleShading(bool shade);
  bool GetSampleShading() const;
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

  vtkMTimeType GetMTime() override;
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
  bool GetNeedToRebuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;
  bool GetNeedToRebuildShaders(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;

  using ShaderMap = std::map<vtkShader::Type, vtkShader*>;
  void ReplaceShaderValues(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderPositionVC(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderDepth(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderNormal(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderColor(ShaderMap shaders, vtkRenderer* ren, vtkActor* act) override;
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

  /// Marks a change of something that is a uniform: the picture changes, no buffer and no shader
  /// does.
  void UniformModified();

  bool UpdateHeights();
  void UpdateBox();
  bool CastsRays(vtkActor* act) const;
  bool UsesSurface(vtkActor* act) const;
  bool ShiftsDepth(vtkRenderer* ren, vtkActor* act);
  bool IsTextured(vtkActor* act);
  void UpdateColors(vtkRenderer* ren);
  void UpdateProxy(vtkActor* act);
  int LayersToDraw(vtkRenderer* ren, vtkActor* act);
  void DrawLayers(vtkRenderer* ren, vtkActor* act);
  terrain::SampleRectangle DrawnRectangle() const;
  void FollowDepth(ShaderMap shaders, vtkActor* act);
  void FollowValues(ShaderMap shaders);
  std::string HeightDefines() const;
  std::string CastDefines() const;
  std::string BeamDefines() const;
  std::string ShaderDefines(vtkActor* act);
  void UpdateView(vtkRenderer* ren, vtkActor* act);
  bool UsesCompute(vtkActor* act) const;
  std::string CastFunctions() const;
  bool UsesBeams(vtkActor* act) const;
  void ComputeBeams(vtkRenderer* ren, vtkActor* act);
  void ComputeSightings(vtkRenderer* ren, vtkActor* act);
  void Compute(vtkRenderer* ren, vtkActor* act, terrain::ComputeTexture& texture,
    const std::string& defines, const std::string& functions, int pixels, int components);
  void SetSurfaceUniforms(terrain::Uniforms& uniforms, vtkActor* act);
  void SetViewUniforms(terrain::Uniforms& uniforms);
  void SetSearchUniforms(terrain::Uniforms& uniforms);
  void SetClipUniforms(terrain::Uniforms& uniforms, vtkActor* act);
  void SetVertexUniforms(terrain::Uniforms& uniforms);

  Techniques Technique = Techniques::Pyramid;
  double VerticalExaggeration = 1.0;
  int Steps = 0;
  int LongSteps = 0;
  int SecantSteps = 0;
  double StepLength = 0.0;
  int DetailCells = 16;
  double DetailScale = 1.0;
  Surfaces Surface = Surfaces::Bilinear;
  double PixelTolerance = 0.0;
  ComputeModes ComputeMode = ComputeModes::Automatic;
  bool UseBeams = true;
  vtkTimeStamp UniformTime;
  bool IgnoresUniformTime = false;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
