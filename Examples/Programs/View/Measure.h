// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measuring on the ground: points that are clicked make a line or an area, with a profile.
 */
#ifndef terrain_view_Measure_h
#define terrain_view_Measure_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class Readout;
class vtkBlockItem;
class vtkChartXY;
class vtkContextActor;
class vtkContourWidget;
class vtkOrientedGlyphContourRepresentation;
class vtkPolyData;
class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkTerrainActor;
class vtkTerrainPicker;

/// VTK's widget of contours over points of the terrain. Left clicks add points, a click on the
/// first one closes an area, a right click ends the line; points can be dragged, and Delete takes
/// the last one away.
class Measure
{
public:
  /// On a terrain, whose places are known if they are; `changed` is called after each change.
  Measure(vtkTerrainPicker* picker, vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
    vtkTerrainActor* terrain, const Readout& places, std::function<void()> changed);
  ~Measure();
  Measure(const Measure&) = delete;
  Measure& operator=(const Measure&) = delete;

  bool IsOn() const;
  /// Begins with no points, or takes everything away.
  void Switch();

  /// Lengths, heights and the area of what was clicked, one or two lines; empty without two points.
  std::string Describe() const;

  /// Lays the line onto the terrain as it is drawn now.
  void Refresh();

private:
  class Placer;
  class Ground;

  void PointsChanged();
  /// Metres on the earth, or in the plane of the terrain without places.
  double DistanceOf(const double from[3], const double to[3]) const;
  double AreaOf(double& border) const;
  void ShowProfile(const std::vector<double>& distances, const std::vector<double>& heights);

  vtkTerrainActor* Terrain;
  const Readout& Places;
  std::function<void()> Changed;
  vtkSmartPointer<vtkTerrainPicker> Picker;
  vtkNew<vtkContourWidget> Widget;
  vtkNew<vtkOrientedGlyphContourRepresentation> Line;
  vtkNew<vtkContextActor> Plot;
  vtkNew<vtkBlockItem> Panel;
  vtkNew<vtkChartXY> Chart;
  std::string Told;
};

#endif
