// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainGraticule
 * @brief   lines of longitude and latitude, or of the UTM grid, on the terrain
 *
 * Input: heights of a scene (vtkImageData of W x H x 1 points) in the frame of Georeference.
 *
 * Output 0: vtkPolyData, lines that follow the surface cell by cell (vtkTerrainDrape), cut where
 * there is none. Cell arrays: "Value" (1 double: degrees, or metres) and "Axis" (1 int: 0 for lines
 * of constant longitude or easting, 1 for latitude or northing). Output 1: vtkPolyData, one vertex
 * a line at its southern or western end on the surface, with the point array "Label" (strings:
 * "86°30'E", "480 km E"). On a globe (vtkTerrainGlobe), which is seen from any side, labels of
 * meridians stand half a step north of the equator, those of parallels at each quarter turn.
 *
 * Steps are round numbers: degrees, minutes and seconds, or 1, 2, 5 times a power of ten in metres.
 *
 * @sa vtkTerrainDrape vtkTerrainGeoreference
 */
#ifndef vtkTerrainGraticule_h
#define vtkTerrainGraticule_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"  // For members
#include "vtkTerrainModule.h" // For export macro

#include <vector> // For private methods

class vtkImageData;
class vtkTerrainGeoreference;

class VTKTERRAIN_EXPORT vtkTerrainGraticule : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainGraticule* New();
  vtkTypeMacro(vtkTerrainGraticule, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The scene of the heights; none by default.
  void SetGeoreference(vtkTerrainGeoreference* georeference);
  vtkTerrainGeoreference* GetGeoreference() const;
  ///@}

  /// What the lines are lines of.
  enum class GridType
  {
    /// Longitude and latitude.
    Geographic,
    /// Easting and northing of the UTM (or UPS) zone of the middle of the heights.
    UTM
  };
  ///@{
  /// Default Geographic.
  void SetGrid(GridType grid);
  GridType GetGrid() const
  {
    return this->Grid;
  }
  ///@}

  ///@{
  /// Distance of lines in degrees (Geographic) or metres (UTM); 0 (default): the round number that
  /// gives at least NumberOfLines lines along the longer side.
  vtkSetClampMacro(Step, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Step, double);
  ///@}

  ///@{
  /// Lines along the longer side that an automatic step aims at, 1 to 1000; default 4.
  vtkSetClampMacro(NumberOfLines, int, 1, 1000);
  vtkGetMacro(NumberOfLines, int);
  ///@}

  ///@{
  /// Height of the lines above the surface, and vertical exaggeration of the terrain as drawn;
  /// defaults 0 and 1.
  vtkSetMacro(Offset, double);
  vtkGetMacro(Offset, double);
  vtkSetMacro(Exaggeration, double);
  vtkGetMacro(Exaggeration, double);
  ///@}

  /// The step of the last update, in degrees or metres.
  double GetStepInUse() const
  {
    return this->StepInUse;
  }

  vtkMTimeType GetMTime() override;

  vtkTerrainGraticule(const vtkTerrainGraticule&) = delete;
  void operator=(const vtkTerrainGraticule&) = delete;

protected:
  vtkTerrainGraticule();
  ~vtkTerrainGraticule() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  struct Frame;
  bool FindExtent(vtkImageData* heights, Frame& frame);
  vtkSmartPointer<vtkPolyData> MakeLines(const Frame& frame);
  std::vector<double> LabelPlaces(const Frame& frame, int axis, double value) const;
  void Label(vtkPolyData* lines, const Frame& frame, vtkPolyData* labels) const;

  vtkSmartPointer<vtkTerrainGeoreference> Georeference;
  GridType Grid = GridType::Geographic;
  double Step = 0.0;
  int NumberOfLines = 4;
  double Offset = 0.0;
  double Exaggeration = 1.0;
  double StepInUse = 0.0;
};

#endif
