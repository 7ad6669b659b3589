// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainPicker
 * @brief   picks the exact point of a terrain's surface
 *
 * A vtkCellPicker that meets the surface which vtkOpenGLTerrainMapper draws, not the mesh on the
 * mapper's port 0. All other props are picked as vtkCellPicker does, and the nearest wins. Use it
 * wherever VTK takes a picker: vtkRenderWindowInteractor::SetPicker, vtkRenderer::PickProp.
 *
 * On a terrain, with x and y of Pick in pixels (the centre of a pixel is at + 0.5):
 *   - GetPickPosition, GetPickNormal: in world coordinates, GetMapperPosition, GetMapperNormal: in
 *     model coordinates, exaggerated as drawn; normals point upward, also when picked from below;
 *   - GetDataSet: the image of heights; GetCellId, GetCellIJK, GetPCoords: its cell and the
 *     position in it; GetPointId, GetPointIJK: the nearest sample;
 *   - the methods below: position in the grid, height, values of the image's arrays.
 *
 * Whatever the technique, the bilinear surface is picked, from both sides; cells without data and
 * what clipping planes or an extract of the mapper cut away are not. Face culling plays no role.
 * Not picked are the walls of a block, and what a surface of columns or a detail adds.
 *
 * Error: that of double arithmetic, about 1e-15 of the coordinates, wherever the eye is. Cost: the
 * heights are scanned once after each change of their image (not of exaggeration, actor or camera);
 * a ray then passes tiles of 32 x 32 cells that it clears as one, some microseconds a ray.
 *
 * VTK's other pickers: vtkCellPicker meets the triangles of the mapper's port 0, the coarse mesh
 * above the surface, or nothing but the box of the heights: this class replaces it. vtkPropPicker
 * and vtkWorldPointPicker read the depth buffer and give a point of the surface to its precision,
 * 1e-7 of the depth range. vtkHardwareSelector gives cells and points of the heights' grid.
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

  /// Column and row of the last pick on a terrain, in cells from the first sample, with their
  /// fractions; NaN without one.
  vtkGetVector2Macro(GridPosition, double);

  /// Height of the surface there, in the unit of the heights, not exaggerated; NaN without one.
  double GetHeight() const;

  /// Value of an array of the heights' image there: point data interpolated as the heights are,
  /// else the value of the cell. NaN if there is no such array or component, and without a pick.
  double GetValue(const std::string& arrayName, int component = 0) const;

  ///@{
  /// True if no part of a terrain's surface lies between two points in world coordinates, which may
  /// lie on the surface: what is within SightMargin of them does not count. A line that touches the
  /// surface, as between two points on a plain, is none: raise one of them. Otherwise, and if
  /// given, obstacle is the point of the surface nearest to the first. Also false if the actor has
  /// no terrain or a point is not finite.
  bool HasLineOfSight(vtkActor* terrain, const double from[3], const double to[3]);
  bool HasLineOfSight(
    vtkActor* terrain, const double from[3], const double to[3], double obstacle[3]);
  ///@}
  /// In cells.
  static constexpr double SightMargin = 1e-4;

  /// The surface below the straight way between two points in world coordinates: lines, cut where
  /// there is no surface, of points in world coordinates with point data (double)
  ///   "Distance"  from the first point, along the ground plane of the terrain, in model units;
  ///   "Height"    in the unit of the heights, not exaggerated.
  /// There is a point wherever the way crosses a line of the grid and where the surface is highest
  /// or lowest in between: both extremes of the profile are among them. The surface itself is a
  /// parabola between neighbours. False, with an empty profile, if the actor has no terrain or a
  /// point is not finite.
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
  double IntersectActorWithLine(const double p1[3], const double p2[3], double t1, double t2,
    double tol, vtkProp3D* prop, vtkMapper* mapper) override;

private:
  class vtkInternals;

  double Interpolate(vtkDataArray* array, int component) const;

  bool TerrainPicked = false;
  double GridPosition[2];
  int NumberOfScans = 0;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
