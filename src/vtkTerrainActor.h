// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainActor
 * @brief   a terrain as one prop: heights in, everything else chosen
 *
 * @code
 *   vtkNew<vtkTerrainActor> terrain;
 *   terrain->SetInputConnection(reader->GetOutputPort());
 *   renderer->AddActor(terrain);
 * @endcode
 *
 * Input: vtkImageData, heights as vtkOpenGLTerrainMapper takes them.
 *
 * It is a vtkActor with a vtkOpenGLTerrainMapper, whose property, matrix, texture and pickability
 * are a vtkActor's; what the mapper can do beyond the methods below is set on GetTerrainMapper().
 * It draws matt (diffuse 1, no specular) and in the colours of a relief map over the range of the
 * heights, unless told otherwise; both follow the heights when these change.
 *
 * A mesh is made when it is first needed: the full one for the technique Mesh, a coarse one where
 * techniques that cast rays are drawn as wireframe or points, and none for their surface.
 *
 * The technique Strips draws what vtkTerrainStrips refines for the camera at each frame: triangles
 * within a tolerance. They are lit and coloured by the heights themselves, as all else. An actor
 * whose scales in x and y differ makes their tolerance as much larger.
 *
 * Prepared heights (SetHierarchy, or a file of terrain-prepare by SetFileName) save Strips the
 * preparation. Without an image of heights beside them, Strips draws them alone, so that a file may
 * be larger than memory: normals and colours are then those of the triangles' corners, and what
 * the mapper does with heights (drapes, contour lines, hillshade) is not there. All other
 * techniques need the image.
 *
 * Level of detail: while the renderer allots this actor less than LongestInteraction seconds a
 * frame, as interactors do while the mouse is down, and the last frame took more, the pixel
 * tolerance of the mapper is doubled, up to CoarsestTolerance; where a frame takes less than a
 * third, it is halved again. The first frame that is allotted more is drawn with the tolerance of
 * the mapper itself, by default exactly. Only the technique Pyramid has a tolerance.
 *
 * @sa vtkOpenGLTerrainMapper vtkTerrainPicker vtkTerrainCoarseMesh vtkTerrainStrips
 * vtkTerrainRasterReader
 */
#ifndef vtkTerrainActor_h
#define vtkTerrainActor_h

#include "vtkOpenGLActor.h"
#include "vtkOpenGLTerrainMapper.h" // For Techniques
#include "vtkSmartPointer.h"        // For members
#include "vtkTerrainModule.h"       // For export macro

#include <array>  // For members
#include <string> // For names of files

class vtkAlgorithm;
class vtkAlgorithmOutput;
class vtkColorTransferFunction;
class vtkImageData;
class vtkPolyData;
class vtkScalarsToColors;
class vtkTexture;
class vtkTerrainCoarseMesh;
class vtkTerrainHierarchy;
class vtkTerrainMesh;
class vtkTerrainRasterReader;
class vtkTerrainStrips;

class VTKTERRAIN_EXPORT vtkTerrainActor : public vtkOpenGLActor
{
public:
  static vtkTerrainActor* New();
  vtkTypeMacro(vtkTerrainActor, vtkOpenGLActor)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The heights, in place of a file's (SetFileName). The mapper's tile source becomes null: set
  /// one for these heights afterwards.
  void SetInputConnection(vtkAlgorithmOutput* heights);
  void SetInputData(vtkImageData* heights);
  vtkImageData* GetHeights();
  ///@}

  ///@{
  /// Heights prepared for the technique Strips, in memory or in a file; null, the default, to let
  /// the actor prepare the image. If there is an image, too, both must be of the same heights.
  void SetHierarchy(vtkTerrainHierarchy* hierarchy);
  vtkTerrainHierarchy* GetHierarchy();
  ///@}

  /// Takes the heights from a file, whose content decides what it is, in place of all other input.
  /// A file of terrain-prepare is not read as an image while the technique is Strips, and is read
  /// once another one needs it. Any other is a raster that vtkTerrainRasterReader reads, of any
  /// size: one of more than 16384 samples a side is drawn from tiles by the technique Pyramid, and
  /// at the finest level that fits by the others. It is prepared on first use
  /// (vtkTerrainRasterReader::SetUseLevels()). Frames that are allotted little time show the tiles
  /// that are there. Returns false, after an error of one line that GetErrorMessage() has, too, if
  /// the file cannot be used; the actor is left as it was then.
  bool SetFileName(VTK_FILEPATH const std::string& path);
  /// Why the last file could not be used, one line; empty if it could.
  const char* GetErrorMessage() const
  {
    return this->ErrorMessage.c_str();
  }

  /// What draws; the actor keeps its port 0, technique and colours as the methods here say.
  vtkOpenGLTerrainMapper* GetTerrainMapper();
  /// What makes the coarse mesh when it is needed: set its CellsPerQuad here.
  vtkTerrainCoarseMesh* GetCoarseMesh();

  /// What refines for the technique Strips: set its Tolerance or TriangleBudget here. The actor
  /// keeps its heights, camera, viewport, culling, exaggeration, normals and height scalars.
  vtkTerrainStrips* GetStrips();

  /// The mesh that the technique and the representation need: the full one or the coarse mesh.
  /// Null if they need none, and with strips.
  vtkTerrainCoarseMesh* GetUsedMesh();

  /// As vtkTerrainLook has it.
  using Techniques = vtkTerrainLook::Techniques;
  ///@{
  /// How the surface is drawn; default Pyramid.
  void SetTechnique(vtkTerrainLook::Techniques technique);
  vtkTerrainLook::Techniques GetTechnique() const;
  ///@}

  ///@{
  /// Drawn height over true height, > 0; default 1.
  void SetVerticalExaggeration(double exaggeration);
  double GetVerticalExaggeration() const;
  ///@}
  /// An exaggeration with which a view of all the heights shows their relief, a round number: 1 for
  /// mountains, 5 for a country of hills, 20 for a continent (terrain::SuggestExaggeration). Less
  /// for a globe, whose relief is seen against the sky: for heights on one (vtkTerrainGlobe), or
  /// that will be drawn so. Heights and spacing of others must have the same unit. 1 where there
  /// are no heights or they are all alike.
  static double SuggestExaggeration(vtkImageData* heights, bool onGlobe = false);
  /// The relief, without the highest and lowest 2 % of the samples, over the extent: the square
  /// root of the area. 0 where there is none.
  static double GetReliefShare(vtkImageData* heights);
  /// Where a scale of colours that shows the slopes of heights ends, in degrees, a round number:
  /// about 98 % of the slopes lie below (terrain::SuggestSteepest). Slopes are those in the middle
  /// of cells; heights and spacing must have the same unit. 60 where there is no cell.
  static double SuggestSteepestSlope(vtkImageData* heights);

  ///@{
  /// Shadows of the surface on itself, the angular diameter of their sun and the light of the sky:
  /// as vtkTerrainLook has them. Default none.
  void SetSunShadows(bool cast);
  bool GetSunShadows() const;
  void SetSunAngle(double degrees);
  double GetSunAngle() const;
  void SetSkyLight(double light);
  double GetSkyLight() const;
  ///@}
  ///@{
  /// Largest vertical distance between a sample and the mesh of GetSurface(), in height units,
  /// >= 0; 0 for all samples. Below 0, the default, for SurfaceErrorShare of the range of the
  /// heights.
  void SetSurfaceError(double error);
  double GetSurfaceError() const
  {
    return this->SurfaceError;
  }
  double GetUsedSurfaceError();
  static constexpr double SurfaceErrorShare = 1e-3;
  ///@}
  ///@{
  /// The surface as an adaptive mesh (vtkTerrainMesh), exaggerated, with normals, texture
  /// coordinates and the point arrays of the heights; and a plain actor that shows it with this
  /// actor's matrix, property, texture and colours. Exporters and VTK's pickers get it by
  /// themselves in place of the box that rays start from, through InitPathTraversal(): a picker's
  /// GetActor() is the terrain. vtkTerrainPicker does without and is exact. The mesh is made when
  /// somebody asks, and again after changes: about 0.2 microseconds a sample. It is cut by the
  /// extract, and has the walls and the floor of a block that lies below all heights; it has no
  /// detail, and is cut by clipping planes only where its actor is drawn or picked. Null without an
  /// image of heights (strips of a prepared file alone) and on a globe (vtkTerrainGlobe), where
  /// exporters and VTK's pickers find nothing.
  vtkPolyData* GetSurface();
  vtkActor* GetSurfaceActor();
  ///@}
  void InitPathTraversal() override;
  void BuildPaths(vtkAssemblyPaths* paths, vtkAssemblyPath* path) override;

  ///@{
  /// Whether heights are shown in colours (default), or everything in that of the property.
  void SetColorByHeight(bool color);
  bool GetColorByHeight() const
  {
    return this->ColorByHeight;
  }
  ///@}

  ///@{
  /// Colours of the heights, over the table's own range; null, the default, for a relief map's over
  /// the range of the heights.
  void SetLookupTable(vtkScalarsToColors* colors);
  /// The colours in use, for a scalar bar: without a table of one's own, the same object for good,
  /// which follows the heights.
  vtkScalarsToColors* GetLookupTable();
  ///@}

  ///@{
  /// Whether frames that are allotted little time are drawn coarser (class comment); default on.
  void SetLevelOfDetail(bool use);
  bool GetLevelOfDetail() const
  {
    return this->LevelOfDetail;
  }
  ///@}
  /// Tolerance in pixels of the next frame that is allotted little time; 0: that of the mapper.
  double GetInteractionTolerance() const
  {
    return this->InteractionTolerance;
  }
  /// Seconds a frame from which on a frame is drawn without haste.
  static constexpr double LongestInteraction = 1.0;
  /// In pixels.
  static constexpr double CoarsestTolerance = 16.0;

  /// Colours of a relief map from the lowest to the highest point: green, brown, white, and blue
  /// below 0 where a good part of the heights lies there.
  VTK_WRAPEXCLUDE static vtkSmartPointer<vtkColorTransferFunction> MakeReliefColors(
    double lowest, double highest);

  /// True if there is a surface at all: a cell whose four samples have heights.
  bool HasSurface();

  /// Lowest and highest height, not exaggerated, up to date; lowest > highest if there is none.
  void GetHeightRange(double range[2]);

  /// Up to date with the heights.
  using vtkOpenGLActor::GetBounds;
  double* GetBounds() VTK_SIZEHINT(6) override;
  ///@{
  /// Places another prop, whose points have true heights, where this terrain draws its own: with
  /// its matrix and its exaggeration, from the z of its heights' origin or from the z given. The
  /// other's user matrix says so; its own position, orientation and scale are taken back. No matrix
  /// exaggerates on a globe (vtkTerrainGlobe): there another exaggeration than 1 is an error, and
  /// the other is placed by this actor's matrix alone. Multiply the heights of its places instead,
  /// before vtkTerrainGeoTransform brings them into the scene.
  void PlaceAsDrawn(vtkProp3D* other);
  void PlaceAsDrawn(vtkProp3D* other, double originZ);
  ///@}
  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;
  /// As vtkActor, with the mapper's look.
  vtkMTimeType GetRedrawMTime() override;
  /// Takes over how another terrain looks but for its colours: its mapper's look, the tolerance and
  /// the budget of its strips, its level of detail. Property and place are those of any vtkActor.
  void CopyLook(vtkTerrainActor* other);
  /// Refines the strips for the camera of a renderer, as Render does with the technique Strips.
  void RefineStrips(vtkRenderer* renderer);
  /// Shares mapper and mesh with another terrain, and takes over its settings.
  void ShallowCopy(vtkProp* prop) override;

  vtkTerrainActor(const vtkTerrainActor&) = delete;
  void operator=(const vtkTerrainActor&) = delete;

protected:
  vtkTerrainActor();
  ~vtkTerrainActor() override;

private:
  bool DrawsStrips() const;
  bool DrawsStripsAlone() const;
  double GetOriginOfHeights();
  void UpdateInput();
  bool OpenPrepared(const std::string& path);
  bool OpenRaster(const std::string& path);
  void RefineFor(vtkRenderer* renderer);
  void UpdateMesh();
  void UpdateColors();
  bool HasSea();
  void CutSurface();
  void UpdateSurfaceLook(vtkImageData* heights);
  void UpdateSurfacePicture(vtkImageData* heights);
  void RenderInTime(vtkRenderer* renderer, vtkMapper* mapper);

  vtkSmartPointer<vtkOpenGLTerrainMapper> TerrainMapper;
  vtkSmartPointer<vtkTerrainCoarseMesh> CoarseMesh;
  vtkSmartPointer<vtkTerrainCoarseMesh> FullMesh;
  vtkSmartPointer<vtkTerrainStrips> Strips;
  /// What is connected to the mapper's port 0: one of these, or null.
  vtkAlgorithm* ConnectedMesh = nullptr;
  vtkSmartPointer<vtkScalarsToColors> LookupTable;
  vtkSmartPointer<vtkColorTransferFunction> ReliefColors;
  /// Heights that they were made for.
  std::array<double, 2> ReliefRange{};
  /// Reads the prepared file of SetFileName for techniques that need an image; else null.
  vtkSmartPointer<vtkTerrainRasterReader> PreparedReader;
  bool ColorByHeight = true;
  bool LevelOfDetail = true;
  double InteractionTolerance = 0.0;
  std::string ErrorMessage;
  double SurfaceError = -1.0;
  vtkSmartPointer<vtkTerrainMesh> SurfaceMesh; ///< null until somebody asks for the surface
  vtkSmartPointer<vtkActor> SurfaceActor;
  vtkSmartPointer<vtkTexture> SurfacePicture; ///< a draped picture, once somebody asked
  vtkMTimeType SurfacePictureTime = 0;
  vtkSmartPointer<vtkActor> Part; ///< in assemblies; null until one asks
};

#endif
