// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainLook
 * @brief   all settings of how a terrain looks, copied by one call
 *
 * Every vtkOpenGLTerrainMapper has a look, GetLook(), and the same setters, which pass on to it.
 * DeepCopy() makes one terrain look like another one. The heights, the mesh, the colours' table and
 * what is drawn of the grid are the mapper's; lights and material are the actor's.
 *
 * Every setting is a uniform of the shader or chooses a program (see vtkOpenGLTerrainMapper): to
 * change one uploads no heights and builds no buffers. A value out of its range is an error, and
 * changes nothing, unless the setting says that it is clamped.
 *
 * @sa vtkOpenGLTerrainMapper vtkTerrainActor
 */
#ifndef vtkTerrainLook_h
#define vtkTerrainLook_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"  // For a member
#include "vtkTerrainModule.h" // For export macro

#include <array> // For members

class vtkImageData;

class VTKTERRAIN_EXPORT vtkTerrainLook : public vtkObject
{
public:
  static vtkTerrainLook* New();
  vtkTypeMacro(vtkTerrainLook, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Takes over every setting of another look. The draped picture is shared, not copied.
  void DeepCopy(vtkTerrainLook* other);

  /// How the surface is drawn. Pyramid is exact: rays pass through a pyramid of minimum and maximum
  /// heights. Linear, Exponential and Equidistant are Fehér's searches, by steps along the ray.
  /// Mesh draws polygons with normals from the heights; Strips likewise, where the polygons are
  /// those of vtkTerrainStrips: a vtkTerrainActor refines them for the camera at each frame.
  enum class Techniques
  {
    Mesh,
    Linear,
    Exponential,
    Equidistant,
    Pyramid,
    Strips
  };
  ///@{
  /// The technique; default Pyramid.
  void SetTechnique(Techniques technique);
  Techniques GetTechnique() const;
  ///@}

  ///@{
  /// Drawn height over true height, > 0; default 1. Heights are exaggerated from the image's origin
  /// in z. In a round scene that would exaggerate the earth's curve: leave it at 1 there, and set
  /// vtkTerrainGeoreference::SetVerticalExaggeration before heights are resampled.
  void SetVerticalExaggeration(double exaggeration);
  double GetVerticalExaggeration() const;
  ///@}

  ///@{
  /// Detail cells along a cell of the heights: a power of two from 1 to MostDetailCells, default
  /// 16.
  void SetDetailCells(int cells);
  int GetDetailCells() const;
  static constexpr int MostDetailCells = 1024;
  ///@}

  ///@{
  /// Factor of the detail's heights, clamped to >= 0; default 1.
  void SetDetailScale(double scale);
  double GetDetailScale() const;
  ///@}

  ///@{
  /// The searches: steps of the first length, then steps of double length (Equidistant only), then
  /// secant steps. 0 and less choose (the default): Fehér's 5 steps for Linear and 10 for
  /// Exponential, each with 2 secant steps; for Equidistant as many as the longest ray needs, and 6
  /// secant steps. Fehér has 5 steps, 10 long ones and 2 secant steps there. At most 256 steps of
  /// Linear and Exponential, 10^6 of Equidistant and 32 secant steps are taken: more count as that.
  void SetSteps(int steps);
  int GetSteps() const;
  void SetLongSteps(int steps);
  int GetLongSteps() const;
  void SetSecantSteps(int steps);
  int GetSecantSteps() const;
  ///@}

  ///@{
  /// Length of a step of Equidistant, in cells; 0, less and NaN choose (the default, 1.5). Heights
  /// count as cells that are as high as wide. A step of less than 2 cells passes by nothing; longer
  /// ones pass by what is thinner than a step. Fehér's value is 0.025 of the terrain's side for
  /// 32 x 32 quads. Less than 1/8 counts as 1/8, more than 10^6 as 10^6.
  void SetStepLength(double cells);
  double GetStepLength() const;
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
  Surfaces GetSurface() const;
  ///@}

  ///@{
  /// The technique Pyramid may end its search at a square of at least 2 x 2 cells that, in its side
  /// and in its relief, projects to less than this number of pixels, clamped to >= 0: the surface
  /// is then drawn where the ray enters the box around that square. Default 0: exact; of tiles half
  /// a pixel. It has an effect only where a cell is smaller than half of this many pixels. Measured
  /// on hills seen at 45 degrees, along the ray: with 1, half of the pixels were off by less than
  /// 0.4 pixels, 95 % by less than 2.5; with 4 by 1.2 and 4.3. No hit comes later than the exact
  /// one; what a ray passes by within such a box, such as a rim, is seen as hit. Large tolerances
  /// show dark specks where the box is entered above a cell that faces away.
  void SetPixelTolerance(double pixels);
  double GetPixelTolerance() const;
  ///@}

  ///@{
  /// Draw, in place of the surface's colour, how many nodes or samples each pixel's ray took: blue
  /// for none to red for the given number, > 0, and above. Default off, 64.
  void SetShowCrossings(bool show);
  bool GetShowCrossings() const;
  void SetMaximumShownCrossings(int crossings);
  int GetMaximumShownCrossings() const;
  ///@}

  /// Where rays are cast.
  enum class ComputeModes
  {
    Automatic,
    Off,
    On
  };
  ///@{
  /// Cast the rays in a compute shader ahead of drawing, where OpenGL 4.3
  /// is there, instead of in the fragment shader: the same picture. Compute shaders have the whole
  /// chip where drawing has a part of it, and cast no ray twice in passes that draw the view more
  /// than once. Automatic, the default: on, but for software rendering.
  void SetComputeMode(ComputeModes mode);
  ComputeModes GetComputeMode() const;
  ///@}

  ///@{
  /// Let the rays begin where those of a tile of 8 x 8 pixels can first
  /// meet the surface, which a compute shader finds ahead of drawing where OpenGL 4.3 is there: the
  /// same picture, in software rendering up to a third sooner, on graphics cards up to a tenth.
  /// Default on.
  void SetUseBeams(bool use);
  bool GetUseBeams() const;
  ///@}

  /// Where the values come from that colour the surface while the mapper's ScalarVisibility is on.
  /// They pass through the lookup table or transfer function and the scalar range as in any mapper;
  /// values are interpolated, then mapped. Array is the array of the heights' image that
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
  ///@{
  /// Default Array.
  void SetColorSource(ColorSources source);
  ColorSources GetColorSource() const;
  ///@}

  ///@{
  /// Lays a picture over the colours of the surface, below lights and contour lines: W x H x 1
  /// points of 1 to 4 unsigned chars (grey, grey and alpha, RGB, RGBA), row 0 southernmost. What is
  /// transparent, and what lies beside the picture, keeps the surface's colour. bounds are west <
  /// east and south < north of the picture's outer edges in the coordinates of the heights; without
  /// them, the image's own: pixel centres at origin + index * spacing. Filtered with mipmaps,
  /// anisotropic up to 16 (but for llvmpipe). nullptr takes the picture away. (An actor's own
  /// vtkTexture spans the terrain: texture coordinates 0 at the first sample, 1 at the last.)
  void SetDrape(vtkImageData* picture, const double bounds[4]);
  void SetDrape(vtkImageData* picture);
  vtkImageData* GetDrape() const;
  void GetDrapeBounds(double bounds[4]) const;
  ///@}

  ///@{
  /// Draw contour lines: at multiples of an interval in the unit of heights, > 0 (default 100), of
  /// a width in pixels, >= 0 (default 1.5), with smooth edges, in a colour of parts 0..1 (default
  /// opaque black). Of an index n, every nth line, counted from height 0, is twice as wide; default
  /// 0: none. Lines closer than about twice their width fade, those between index lines first.
  /// Default off.
  void SetContours(bool show);
  bool GetContours() const;
  void SetContourInterval(double heights);
  double GetContourInterval() const;
  void SetContourWidth(double pixels);
  double GetContourWidth() const;
  void SetContourIndex(int every);
  int GetContourIndex() const;
  void SetContourColor(double red, double green, double blue, double opacity = 1.0);
  void GetContourColor(double rgba[4]) const;
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
  /// Draw a solid block from the surface down to a height (default 0), with the technique Pyramid:
  /// walls along the borders of what is drawn, a floor, and faces where clipping planes cut, all
  /// without contour lines. Holes without data have no walls. Default off.
  void SetBlock(bool show);
  bool GetBlock() const;
  void SetBlockBase(double height);
  double GetBlockBase() const;
  ///@}

  ///@{
  /// Most surfaces behind each other that a translucent terrain shows (opacity below 1, translucent
  /// colours), >= 1, with the technique Pyramid. Each casts all rays again. Default 4.
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
  /// The surface lies in its own shadow: what it hides from a light gets none of that light. Each
  /// point looks for each light of the renderer along a ray over the drawn (exaggerated) surface,
  /// from any distance; there is no map and no bias. Lights that are off, headlights and lights
  /// whose ShadowAttenuation is 0 cast no shadows; 8 lights do at most. A light below the horizon
  /// is hidden by the ground like any other: it lights slopes that look down on it. The ground is
  /// solid: no light passes under it from a hole, which itself lets light through. What clipping
  /// planes cut off casts no shadow. Shadows of other actors are those of vtkShadowMapPass; both
  /// combine. Tiles cast the shadows of the levels that the view has loaded. The underside has
  /// none. Default off.
  void SetSunShadows(bool cast);
  bool GetSunShadows() const;
  ///@}

  ///@{
  /// Angular diameter in degrees, 0 to 90, of lights that are infinitely far away: the sun's is
  /// 0.53. Their shadows have soft edges then: a point sees the share of the disc that is above the
  /// horizon in the middle of the disc, taken to be level across it (area of a circular segment).
  /// Default 0: a point, and hard edges. It matters with SunShadows only.
  void SetSunAngle(double degrees);
  double GetSunAngle() const;
  ///@}

  ///@{
  /// Light of an evenly bright sky, as a part of that of a light of intensity 1: each point gets
  /// the share of it that it sees over the drawn surface, times its diffuse colour. The share is
  /// the SkyView of vtkTerrainHorizon, from horizons in 16 directions, once for all views; of more
  /// than 2^20 samples, from the means of squares of 2^k samples. 0 is none. Detail and other
  /// actors hide none of the sky. Default 0.
  void SetSkyLight(double light);
  double GetSkyLight() const;
  ///@}

  vtkTerrainLook(const vtkTerrainLook&) = delete;
  void operator=(const vtkTerrainLook&) = delete;

protected:
  vtkTerrainLook() = default;
  ~vtkTerrainLook() override = default;

private:
  /// Every setting, so that a copy forgets none.
  struct Settings
  {
    Techniques Technique = Techniques::Pyramid;
    double VerticalExaggeration = 1.0;
    int DetailCells = 16;
    double DetailScale = 1.0;
    int Steps = 0;
    int LongSteps = 0;
    int SecantSteps = 0;
    double StepLength = 0.0;
    Surfaces Surface = Surfaces::Bilinear;
    double PixelTolerance = 0.0;
    bool ShowCrossings = false;
    int MaximumShownCrossings = 64;
    ComputeModes ComputeMode = ComputeModes::Automatic;
    bool UseBeams = true;
    ColorSources ColorSource = ColorSources::Array;
    vtkSmartPointer<vtkImageData> Drape;
    std::array<double, 4> DrapeBounds{};
    bool Contours = false;
    double ContourInterval = 100.0;
    double ContourWidth = 1.5;
    int ContourIndex = 0;
    std::array<double, 4> ContourColor{ 0.0, 0.0, 0.0, 1.0 };
    bool Hillshade = false;
    double HillshadeAzimuth = 315.0;
    double HillshadeAltitude = 45.0;
    bool Block = false;
    double BlockBase = 0.0;
    int MaximumLayers = 4;
    bool SampleShading = false;
    bool SunShadows = false;
    double SunAngle = 0.0;
    double SkyLight = 0.0;
  };
  Settings Values;
};

#endif
