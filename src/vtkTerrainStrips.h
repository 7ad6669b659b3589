// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTerrainStrips
 * @brief Refines a heightfield for a camera into one triangle strip
 *
 * Input: a vtkTerrainHierarchy (SetHierarchy), or an image of heights on port 0, which is prepared
 * in memory once. The hierarchy wins. A camera, a viewport and the tolerance in pixels say how fine
 * the strip is. From camera and viewport comes lambda, the most pixels that a unit of length takes
 * at unit distance: viewport height / (2 tan(view angle / 2) cos^2(angle from the middle of the
 * picture to a corner)).
 *
 * Output: vtkPolyData with one generalized triangle strip (or triangles, with TriangleOutput), each
 * point once, counter-clockwise from above, without cracks or T-junctions. Any mapper draws it, any
 * filter takes it. Point data, each on request:
 *   Normals              float 3, unit length, from central differences of the heights
 *   TextureCoordinates   float 2, 0 to 1 from the first to the last sample east and north
 *   Depth                unsigned char 3, the depth in the hierarchy as a colour (DepthColors)
 *   Height               float, the height, not exaggerated (HeightScalars)
 * Points are double, in model coordinates (those of the heights), z = origin z + exaggeration *
 * height (see Exaggeration, PointExaggeration).
 *
 * With detail (port 1) the surface is the heights plus DetailScale times the detail, repeated all
 * over them as vtkOpenGLTerrainMapper does. Refinement runs on below the samples of the heights,
 * where the errors of the detail say so, without a crack. Memory is taken for the heights and one
 * period, never for their product. Texture coordinates stay those of the heights. Normals are the
 * slopes of both, added. Where the period does not divide by four detail cells, all triangles of a
 * depth below the samples have one error. Larger powers of two are better, see
 * core/strips/DetailHierarchy.h.
 *
 * Every triangle larger than half a cell is within the tolerance: rho = error * lambda / d <=
 * Tolerance. Here d is the distance from the eye to the nearest point of a sphere round the
 * triangles. The error is their largest vertical distance to the bilinear surface of the heights.
 * So no point of the surface is drawn further than the tolerance from its place, anywhere in the
 * picture. Half cells cannot be split. A triangle is not drawn if a part of it has no data, so
 * holes and their surroundings may be up to the tolerance larger.
 *
 * A mapper that draws the output must not move it: the camera is in the same coordinates. The
 * filter executes again when the camera moves. The camera's clipping range plays no role; what is
 * behind the sides of its view is left coarse. Bounds of the output change with the view: give the
 * renderer those of the hierarchy if its clipping range must not.
 *
 * Asynchronous: a thread refines while the last finished mesh is drawn. Update() starts it and
 * returns the newest mesh that is complete, empty before the first one. The filter counts as
 * modified when a mesh is finished, so the next Render takes it; IsBuilding() tells when to stop
 * rendering. For a still camera the result is exactly that of synchronous building.
 *
 * Method, sources and departures: core/strips/Refinement.h.
 *
 * @code
 * vtkNew<vtkTerrainStrips> strips;
 * strips->SetInputConnection(reader->GetOutputPort());
 * strips->SetCamera(renderer->GetActiveCamera());
 * strips->SetViewportSize(1280, 720);
 * mapper->SetInputConnection(strips->GetOutputPort());
 * @endcode
 *
 * @sa vtkTerrainHierarchy vtkOpenGLTerrainMapper
 */
#ifndef vtkTerrainStrips_h
#define vtkTerrainStrips_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainModule.h"

#include <memory>

class vtkCamera;
class vtkImageData;
class vtkTerrainHierarchy;

class VTKTERRAIN_EXPORT vtkTerrainStrips : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainStrips* New();
  vtkTypeMacro(vtkTerrainStrips, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What is left out because it is not seen.
  enum class CullingMode
  {
    Off,    ///< nothing
    Nested, ///< all that is outside; no crack anywhere (default)
    Lazy    ///< small parts are not tested: more triangles along the view's sides
  };

  ///@{
  /// The prepared heightfield; default none.
  void SetHierarchy(vtkTerrainHierarchy* hierarchy);
  vtkTerrainHierarchy* GetHierarchy();
  ///@}
  ///@{
  /// One period of detail heights, port 1; optional. The same as in vtkOpenGLTerrainMapper:
  /// repeated from sample (0, 0) on, with DetailCells cells along a cell of the heights; every
  /// sample needs a height; its spacing does not count.
  void SetDetailConnection(vtkAlgorithmOutput* port)
  {
    this->SetInputConnection(1, port);
  }
  void SetDetailData(vtkImageData* detail);
  vtkImageData* GetDetail();
  ///@}
  ///@{
  /// Detail cells along a cell of the heights: a power of two from 1 to MostDetailCells, default
  /// 16. Changing it prepares the detail anew.
  void SetDetailCells(int cells);
  int GetDetailCells() const
  {
    return this->DetailCells;
  }
  static constexpr int MostDetailCells = 1024;
  ///@}
  ///@{
  /// Factor of the detail's heights, >= 0; default 1. Changing it prepares nothing.
  vtkSetMacro(DetailScale, double);
  vtkGetMacro(DetailScale, double);
  ///@}
  ///@{
  /// The camera; required, default none. Its view angle or parallel scale, position and direction
  /// count, not its clipping range, view shear or user matrices.
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}
  ///@{
  /// Width and height of the viewport in pixels, both > 0; default 300 x 300.
  vtkSetVector2Macro(ViewportSize, int);
  vtkGetVector2Macro(ViewportSize, int);
  ///@}
  ///@{
  /// Largest screen-space error in pixels, > 0; default 1.
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}
  ///@{
  /// Largest number of triangles, at least 4; 0 (default) for any. The tolerance is raised until
  /// they suffice.
  vtkSetMacro(TriangleBudget, vtkIdType);
  vtkGetMacro(TriangleBudget, vtkIdType);
  ///@}
  ///@{
  /// Vertical exaggeration, > 0; default 1.
  vtkSetMacro(Exaggeration, double);
  vtkGetMacro(Exaggeration, double);
  ///@}
  ///@{
  /// Exaggeration of the points of the output, where that is another one than in the view because a
  /// mapper or an actor adds the rest: 1 for points at their true heights. 0 (default): the same.
  vtkSetClampMacro(PointExaggeration, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PointExaggeration, double);
  ///@}
  ///@{
  /// Draws every sample of the border of the image of port 0, see vtkTerrainHierarchy; default off.
  /// Changing it prepares the image anew.
  vtkSetMacro(KeepBorder, bool);
  vtkGetMacro(KeepBorder, bool);
  vtkBooleanMacro(KeepBorder, bool);
  ///@}
  ///@{
  /// Vertices move into their place with the camera instead of jumping; more triangles for the same
  /// tolerance. Default off.
  vtkSetMacro(Morphing, bool);
  vtkGetMacro(Morphing, bool);
  vtkBooleanMacro(Morphing, bool);
  ///@}
  ///@{
  /// Default CullingMode::Nested.
  void SetCulling(CullingMode mode);
  CullingMode GetCulling() const
  {
    return this->Culling;
  }
  ///@}
  ///@{
  /// Refine by the plain procedure of SOAR, for comparison; default off.
  vtkSetMacro(PlainRefinement, bool);
  vtkGetMacro(PlainRefinement, bool);
  vtkBooleanMacro(PlainRefinement, bool);
  ///@}
  ///@{
  /// Adds point normals; default off.
  vtkSetMacro(Normals, bool);
  vtkGetMacro(Normals, bool);
  vtkBooleanMacro(Normals, bool);
  ///@}
  ///@{
  /// Adds texture coordinates; default off.
  vtkSetMacro(TextureCoordinates, bool);
  vtkGetMacro(TextureCoordinates, bool);
  vtkBooleanMacro(TextureCoordinates, bool);
  ///@}
  ///@{
  /// Adds a colour for the depth of each point as scalars; default off.
  vtkSetMacro(DepthColors, bool);
  vtkGetMacro(DepthColors, bool);
  vtkBooleanMacro(DepthColors, bool);
  ///@}
  ///@{
  /// Old names of DepthColors, with a warning.
  void SetLevelColors(bool colors);
  bool GetLevelColors();
  void LevelColorsOn();
  void LevelColorsOff();
  ///@}
  ///@{
  /// Adds the height of each point, as scalars unless DepthColors are; default off.
  vtkSetMacro(HeightScalars, bool);
  vtkGetMacro(HeightScalars, bool);
  vtkBooleanMacro(HeightScalars, bool);
  ///@}
  ///@{
  /// Triangles in place of the strip; default off.
  vtkSetMacro(TriangleOutput, bool);
  vtkGetMacro(TriangleOutput, bool);
  vtkBooleanMacro(TriangleOutput, bool);
  ///@}
  ///@{
  /// Refine in a thread; default off.
  vtkSetMacro(Asynchronous, bool);
  vtkGetMacro(Asynchronous, bool);
  vtkBooleanMacro(Asynchronous, bool);
  ///@}

  /// True while the thread works on a mesh that is not yet the output, or one waits to be taken.
  bool IsBuilding();

  /// Tolerance of the output: Tolerance, or what the budget allowed.
  double GetUsedTolerance() const
  {
    return this->UsedTolerance;
  }
  /// Number of triangles of the output.
  vtkIdType GetNumberOfTriangles() const
  {
    return this->NumberOfTriangles;
  }

  /// Follows the camera, the hierarchy and the thread.
  vtkMTimeType GetMTime() override;

  vtkTerrainStrips(const vtkTerrainStrips&) = delete;
  void operator=(const vtkTerrainStrips&) = delete;

protected:
  vtkTerrainStrips();
  ~vtkTerrainStrips() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  struct Internals;
  bool PrepareInput(vtkInformationVector* input);
  bool PrepareDetail(vtkInformationVector* input);
  bool Refine();
  bool FillOutput(vtkPolyData* output);

  std::unique_ptr<Internals> Private;
  vtkSmartPointer<vtkTerrainHierarchy> Hierarchy;
  vtkSmartPointer<vtkCamera> Camera;
  int ViewportSize[2] = { 300, 300 };
  double Tolerance = 1.0;
  double Exaggeration = 1.0;
  int DetailCells = 16;
  double DetailScale = 1.0;
  vtkIdType TriangleBudget = 0;
  CullingMode Culling = CullingMode::Nested;
  double PointExaggeration = 0.0;
  bool HeightScalars = false;
  bool KeepBorder = false;
  bool Morphing = false;
  bool PlainRefinement = false;
  bool Normals = false;
  bool TextureCoordinates = false;
  bool DepthColors = false;
  bool TriangleOutput = false;
  bool Asynchronous = false;
  double UsedTolerance = 0.0;
  vtkIdType NumberOfTriangles = 0;
};

#endif
