// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainPicker
 * @brief   picks the exact point of a terrain's surface
 *
 * This vtkCellPicker meets the surface that vtkOpenGLTerrainMapper draws, not the mesh on the
 * mapper's port 0. It picks all other props as vtkCellPicker does. The nearest wins. Use it
 * wherever VTK takes a picker: vtkRenderWindowInteractor::SetPicker, vtkRenderer::PickProp.
 *
 * On a terrain, with x and y of Pick in pixels (the centre of a pixel is at + 0.5):
 *   - GetPickPosition, GetPickNormal: in world coordinates, GetMapperPosition, GetMapperNormal: in
 *     model coordinates, exaggerated as drawn. Normals of the surface point upward, also when it is
 *     picked from below; those of walls point outward;
 *   - GetDataSet: the image of heights; GetCellId, GetCellIJK, GetPCoords: its cell and the
 *     position in it; GetPointId, GetPointIJK: the nearest sample;
 *   - the methods below: position in the grid, height, values of the image's arrays.
 *
 * What is picked is what is drawn:
 *   - the bilinear surface, from both sides, whatever the technique;
 *   - with the technique Pyramid also columns, and the walls, the floor and the cut faces of a
 * block;
 *   - the surface with its detail, if it has any, with techniques that cast rays.
 * Not picked are cells without data and what clipping planes or an extract of the mapper cut away.
 * Face culling plays no role.
 *
 * Method: core/rays/RayQuery.h. Error: that of double arithmetic, 1e-13 of the largest
 * coordinate in cells (kQueryError), wherever the eye is. Cost: the heights are scanned once after
 * each change of their image (not of exaggeration, actor or camera), and their bounds take 4 % of
 * the heights' memory. A ray then takes some microseconds.
 *
 * VTK's other pickers: vtkCellPicker meets the adaptive mesh of vtkTerrainActor::GetSurface(), and
 * is off by up to its error; it makes that mesh. On a globe it finds nothing. vtkPropPicker and
 * vtkWorldPointPicker read the depth buffer and give a point of the surface to its precision, 1e-7
 * of the depth range. vtkHardwareSelector gives cells and points of the heights' grid.
 *
 * On a globe (vtkTerrainGlobe) the same holds but for clipping planes, which picks do not see, and
 * profiles, which vtkTerrainViewpoint has; the grid is that of the heights on the globe.
 * Longitude and latitude of a pick are vtkTerrainGeoreference::SceneToPlaces() in its frame Globe.
 *
 * On earth: the position of a pick is a scene point of vtkTerrainGeoreference::GetReadout
 * (longitude, latitude, UTM, MGRS) and vtkTerrainViewpoint (geodesic distances, areas, profiles,
 * lines of sight over the round earth).
 *
 * @sa vtkOpenGLTerrainMapper vtkTerrainActor vtkTerrainDrape
 */
#ifndef vtkTerrainPicker_h
#define vtkTerrainPicker_h

#include "vtkCellPicker.h"
#include "vtkTerrainModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

namespace terrain
{
class GlobeSurface;
}
class vtkImageData;

class vtkActor;
class vtkDataArray;
class vtkPolyData;

class VTKTERRAIN_EXPORT vtkTerrainPicker : public vtkCellPicker
{
public:
  static vtkTerrainPicker* New();
  vtkTypeMacro(vtkTerrainPicker, vtkCellPicker)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// True if the last pick met a terrain.
  bool IsTerrainPicked() const
  {
    return this->TerrainPicked;
  }

  /// Column and row of the last pick on a terrain, in cells from the south-western sample, with
  /// their fractions; NaN without one.
  vtkGetVector2Macro(GridPosition, double);

  /// Height of the picked point, in the unit of the heights, not exaggerated; NaN without one.
  vtkGetMacro(Height, double);

  /// Value of an array of the heights' image there: point data interpolated as the heights are,
  /// else the value of the cell. NaN if there is no such array or component, and without a pick.
  double GetValue(const std::string& arrayName, int component = 0) const;

  ///@{
  /// True if no part of a terrain, as it is picked, lies between two points in world coordinates.
  /// The points may lie on the surface: what is within SightMargin of them does not count. A line
  /// that touches the surface counts as blocked. Between two points on a plain, raise one end a
  /// little. If the line is blocked, obstacle is the point of the terrain nearest to the first
  /// point. Also false if the actor has no terrain or a point is not finite. The line is straight:
  /// vtkTerrainViewpoint knows lines of sight over the round earth.
  bool HasLineOfSight(vtkActor* terrain, const double from[3], const double to[3]);
  bool HasLineOfSight(
    vtkActor* terrain, const double from[3], const double to[3], double obstacle[3]);
  ///@}
  /// In cells.
  static constexpr double SightMargin = 1e-4;

  /// The surface below the straight way between two points in world coordinates. The profile has
  /// lines, cut where there is no surface, of points in world coordinates with point data (double)
  ///   "Distance"  from the first point, along the ground plane of the terrain, in model units;
  ///   "Height"    in the unit of the heights, not exaggerated.
  /// There is a point wherever the way crosses a line of the grid, or the wall of a column, and
  /// where the surface is highest or lowest in between. Both extremes of the profile are among
  /// them. The surface itself is a parabola between neighbours. Clipping planes, extracts and
  /// blocks do not count. False, with an empty profile, if the actor has no terrain or a point is
  /// not finite.
  bool GetProfile(
    vtkActor* terrain, const double from[3], const double to[3], vtkPolyData* profile);

  /// Number of times that heights were scanned, for tests that count them.
  vtkGetMacro(NumberOfScans, int);

  vtkTerrainPicker(const vtkTerrainPicker&) = delete;
  void operator=(const vtkTerrainPicker&) = delete;

protected:
  vtkTerrainPicker();
  ~vtkTerrainPicker() override;

  void ResetPickInfo() override;
  int Pick3DInternal(vtkRenderer* renderer, double p1World[4], double p2World[4]) override;
  double IntersectActorWithLine(const double p1[3], const double p2[3], double t1, double t2,
    double tol, vtkProp3D* prop, vtkMapper* mapper) override;

private:
  class vtkInternals;

  double Interpolate(vtkDataArray* array, int component) const;
  void SetPick(vtkProp3D* prop, vtkMapper* mapper, vtkImageData* heights, const double position[2],
    double height, const double point[3], const double normal[3]);
  double PickGlobe(const terrain::GlobeSurface& globe, const double p1[3], const double p2[3],
    vtkProp3D* prop, vtkMapper* mapper);
  bool SeesOnGlobe(const terrain::GlobeSurface& globe, vtkActor* terrain, const double from[3],
    const double to[3], double obstacle[3]);

  bool TerrainPicked = false;
  double GridPosition[2];
  double Height;
  int NumberOfScans = 0;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
