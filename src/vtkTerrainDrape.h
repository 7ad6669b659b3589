// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainDrape
 * @brief   lays points and lines onto the terrain
 *
 * Input port 0: vtkPolyData in scene coordinates (vtkTerrainGeoTransform brings longitudes and
 * latitudes there): vertices, lines, and polygons, whose outlines become lines. Input port 1:
 * heights, a vtkImageData of W x H x 1 points whose point scalars are heights.
 *
 * Output: vtkPolyData of vertices and lines (double points). Clamped and AboveGround lines follow
 * the bilinear surface cell by cell: a point is inserted wherever a line crosses a grid line.
 * Between two grid lines the surface above a line is a parabola. Further points keep its distance
 * from the chords within Tolerance. Where there is no surface (outside, no data), lines are cut and
 * points are left out. A hole swallows the cells that touch it. Point data are interpolated, cell
 * data copied.
 *
 * In the round frame Local the vertical of a place is not that of the scene. With a Georeference,
 * points go up and down their own vertical, and z counts from the surface along it; without one,
 * that of the scene, which shifts a place by its height times the angle between the two.
 *
 * Heights on a globe (vtkTerrainGlobe) take geocentric points. Between two points a line is
 * straight in longitude and latitude, the shorter way round; points are added so that its chords
 * follow the curve of the body within Tolerance. It is cut where it passes the longitude at which
 * the heights begin. Heights count from the ellipsoid.
 *
 * All heights are asked for, whatever piece of the lines is.
 *
 * Error: Tolerance; 0 height at inserted points. Cost: proportional to the cells crossed.
 *
 * @sa vtkTerrainGeoTransform vtkTerrainGraticule
 */
#ifndef vtkTerrainDrape_h
#define vtkTerrainDrape_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"  // For members
#include "vtkTerrainModule.h" // For export macro

class vtkImageData;
class vtkTerrainGeoreference;

class VTKTERRAIN_EXPORT vtkTerrainDrape : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainDrape* New();
  vtkTypeMacro(vtkTerrainDrape, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The heights, input port 1.
  void SetHeightsData(vtkImageData* heights);
  void SetHeightsConnection(vtkAlgorithmOutput* heights);
  ///@}

  ///@{
  /// The scene of points and heights, which matters in the frame Local; null (default): flat.
  void SetGeoreference(vtkTerrainGeoreference* georeference);
  vtkTerrainGeoreference* GetGeoreference() const;
  ///@}

  /// What z of the input means.
  enum class ModeType
  {
    /// On the surface; z of the input does not matter.
    Clamped,
    /// z of the input counts from the surface.
    AboveGround,
    /// z of the input is the height: nothing is inserted or cut.
    Absolute
  };
  ///@{
  /// Default Clamped.
  void SetMode(ModeType mode);
  ModeType GetMode() const
  {
    return this->Mode;
  }
  ///@}

  ///@{
  /// Added to every height, in height units; default 0. A little above 0 keeps lines visible.
  vtkSetMacro(Offset, double);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /// Largest vertical distance of a line from where it should be, in height units, > 0; 0 (default)
  /// is a hundredth of the grid's spacing, on a globe of at most a metre.
  vtkSetClampMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// Vertical exaggeration of the terrain as drawn; default 1.
  vtkSetMacro(Exaggeration, double);
  vtkGetMacro(Exaggeration, double);
  ///@}

  /// Also that of the georeference.
  vtkMTimeType GetMTime() override;

  vtkTerrainDrape(const vtkTerrainDrape&) = delete;
  void operator=(const vtkTerrainDrape&) = delete;

protected:
  vtkTerrainDrape();
  ~vtkTerrainDrape() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  ModeType Mode = ModeType::Clamped;
  double Offset = 0.0;
  double Tolerance = 0.0;
  double Exaggeration = 1.0;
  vtkSmartPointer<vtkTerrainGeoreference> Georeference;
};

#endif
