// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainRepresentation
 * @brief   the representation "Terrain" of images and poly data in ParaView
 *
 * Input: vtkImageData of W x H x 1 points, whose heights are a point or a cell array of one
 * component (SetInputArrayToProcess, index 1; the active point scalars without). Cell heights are
 * samples at the centres of the cells. Or vtkPolyData, a surface that is drawn as it is,
 * exaggerated from z = 0: what needs heights, such as techniques and contour lines, does not
 * concern it. Or a composite dataset of both. Any array may colour the surface (index 0).
 *
 * Distributed images are drawn where they are: each rank draws its piece, ParaView composites by
 * depth. One level of ghost cells is asked for, so that normals at the border of a piece are those
 * of the whole; ghost cells themselves are not drawn. A rank without data draws nothing.
 *
 * Methods that set properties do so on a vtkTerrainActor, see there and at its mapper.
 *
 * @sa vtkTerrainActor vtkOpenGLTerrainMapper
 */
#ifndef vtkTerrainRepresentation_h
#define vtkTerrainRepresentation_h

#include "vtkNew.h" // For members
#include "vtkPVDataRepresentation.h"
#include "vtkSmartPointer.h"               // For members
#include "vtkTerrainParaViewViewsModule.h" // For export macro

#include <array>   // For members
#include <cstddef> // For std::size_t
#include <memory>  // For members
#include <set>     // For members
#include <string>  // For members
#include <vector>  // For members

class vtkActor;
class vtkDataObject;
class vtkImageData;
class vtkMapper;
class vtkMultiBlockDataSet;
class vtkPlane;
class vtkPolyData;
class vtkScalarsToColors;
class vtkTerrainActor;
class vtkTerrainSelectionLift;
class vtkTerrainSourceColors;
class vtkTexture;

class VTKTERRAINPARAVIEWVIEWS_EXPORT vtkTerrainRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkTerrainRepresentation* New();
  vtkTypeMacro(vtkTerrainRepresentation, vtkPVDataRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  void SetVisibility(bool visible) override;

  /// How the surface is drawn: vtkOpenGLTerrainMapper::Techniques as a number, default 4, Pyramid.
  /// With Strips each process refines its own piece.
  void SetTechnique(int technique);
  /// Largest error of Strips in pixels, > 0; default 1.
  void SetStripsTolerance(double pixels);
  /// Parameters of the searches Linear, Exponential and Equidistant, as
  /// vtkOpenGLTerrainMapper::SetSteps() has them; default 0: chosen.
  void SetSteps(int steps, int longSteps, int secantSteps);
  void SetStepLength(double cells);
  /// Most surfaces along a ray that are drawn where they are translucent, >= 1; default 4.
  void SetMaximumLayers(int layers);
  /// Drawn height over true height, > 0; default 1.
  void SetVerticalExaggeration(double exaggeration);
  /// What colours show: vtkOpenGLTerrainMapper::ColorSources as a number; default 0, the array.
  void SetColorSource(int source);

  /// Whether frames are drawn coarser while the view is moved (vtkTerrainActor); default on.
  void SetLevelOfDetail(bool use);

  ///@{
  /// Contour lines: default off, at multiples of 100, 1.5 pixels wide.
  void SetContours(bool show);
  void SetContourInterval(double heights);
  void SetContourWidth(double pixels);
  ///@}

  ///@{
  /// Shading by a sun, in degrees; default off, 315 clockwise from north, 45 above the horizon.
  void SetHillshade(bool show);
  void SetHillshadeAzimuth(double degrees);
  void SetHillshadeAltitude(double degrees);
  ///@}

  ///@{
  /// As vtkTerrainLook has them: shadows, the angular diameter in degrees of lights far away, and
  /// the light of the sky. Default off, 0, 0.
  void SetSunShadows(bool cast);
  void SetSunAngle(double degrees);
  void SetSkyLight(double light);
  ///@}

  ///@{
  /// A solid block down to a height; default off, 0.
  void SetBlock(bool show);
  void SetBlockBase(double height);
  ///@}

  ///@{
  /// What of the terrain is drawn: the samples of these columns and rows of the whole image (all
  /// where a last one is below 0, the default), and what lies on the side of a plane in world
  /// coordinates that its normal points to (default off, the origin, east).
  void SetExtract(int firstColumn, int lastColumn, int firstRow, int lastRow);
  void SetClip(bool clip);
  void SetClipOrigin(double x, double y, double z);
  void SetClipNormal(double x, double y, double z);
  ///@}

  /// The file of a picture that knows its place, laid over the terrain there (vtkTerrainImageWarp);
  /// empty (default) for none. Each process that draws reads it.
  void SetDrape(const char* fileName);

  ///@{
  /// As those of vtkActor, vtkProperty and vtkMapper.
  void SetLookupTable(vtkScalarsToColors* colors);
  void SetOpacity(double opacity);
  void SetAmbientColor(double red, double green, double blue);
  void SetDiffuseColor(double red, double green, double blue);
  void SetSpecular(double specular);
  void SetSpecularPower(double power);
  void SetTexture(vtkTexture* texture);
  void SetPosition(double x, double y, double z);
  void SetScale(double x, double y, double z);
  void SetOrientation(double x, double y, double z);
  void SetOrigin(double x, double y, double z);
  void SetPickable(int pickable);
  ///@}

  vtkTerrainRepresentation(const vtkTerrainRepresentation&) = delete;
  void operator=(const vtkTerrainRepresentation&) = delete;

protected:
  vtkTerrainRepresentation();
  ~vtkTerrainRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  void AddPiece(vtkImageData* image);
  void AddSurface(vtkPolyData* surface);
  void ShareHeightRange();
  void PassPieces(vtkInformation* inInfo, vtkInformation* outInfo);
  void TellOfOtherScenes();
  std::vector<vtkImageData*> FindPlacedImages();
  void GetOwnBounds(double bounds[6]);
  void TakePieces(vtkDataObject* delivered);
  void TakeSurfaces(vtkDataObject* delivered);
  void PlaceSurface(vtkActor* actor);
  void DrapePiece(vtkTerrainActor* actor, vtkImageData* piece, bool isOneOfSeveral);
  void LiftSelection();
  const char* GetColorArray(bool& isOfCells);
  void UpdateColors(vtkTerrainActor* actor);
  void UpdateColors(vtkMapper* mapper);

  /// Looks as the properties say, and draws the first piece; the others look like it.
  vtkNew<vtkTerrainActor> Actor;
  std::vector<vtkSmartPointer<vtkTerrainActor>> OtherActors;
  std::vector<vtkSmartPointer<vtkActor>> SurfaceActors;
  /// The heights and surfaces of this process.
  vtkSmartPointer<vtkMultiBlockDataSet> Pieces;
  /// Of the heights of all processes, as far as they are known; the colours of that range, shown
  /// where no others are.
  std::array<double, 2> HeightRange{ 1.0, 0.0 };
  vtkSmartPointer<vtkScalarsToColors> ReliefColors;
  vtkSmartPointer<vtkScalarsToColors> LookupTable;
  std::unique_ptr<vtkTerrainSourceColors> SourceColors;
  std::unique_ptr<vtkTerrainSelectionLift> Selection;
  std::array<int, 4> Extract{ 0, -1, 0, -1 };
  vtkNew<vtkPlane> ClipPlane;
  bool Clip = false;
  std::string Drape;
  /// Whether extract or drape have changed since the pieces were taken.
  bool HasOtherParts = false;
  /// What was said of terrains that do not lie in one scene.
  std::set<std::string> Told;
};

#endif
