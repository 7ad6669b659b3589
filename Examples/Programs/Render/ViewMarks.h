// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is drawn onto and over the terrain and depends on where the camera stands.
 */
#ifndef terrain_render_ViewMarks_h
#define terrain_render_ViewMarks_h

#include "Annotations.h"
#include "ContourPlaces.h"
#include "HeightScale.h"
#include "Inset.h"
#include "LabelPlacer.h"
#include "Labels.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTerrainGraticule.h"
#include "vtkTerrainViewpoint.h"

#include <optional>
#include <vector>

class Statistics;
class vtkActor;
struct Options;
struct PlacedHeights;
struct PolygonLayer;

/**
 * Track, outlines of polygons, graticule, scale bar, north arrow, title, caption, labels. Lines and
 * points are drawn nearer than they are, so that the ground beside them does not hide them; their
 * place in the picture stays the same. Texts stand where the eye sees their points, and cover one
 * another nowhere: labels of a file come first, then summits, then those of the graticule. A
 * shoulder that hides a place by less than the height of a text does not count, for round summits
 * are never seen from below. All of it is brought up to date by Refresh() after the camera was set.
 */
class ViewMarks
{
public:
  /// Of a terrain that lies in a box.
  ViewMarks(vtkRenderer* renderer, const PlacedHeights& heights, const ScaledBox& box,
    const Options& options);

  /// Shows a map in a corner, of heights in the colours of a table.
  void ShowInset(vtkScalarsToColors* colors);

  ViewMarks(const ViewMarks&) = delete;
  ViewMarks& operator=(const ViewMarks&) = delete;

  /// Reads what the options ask for. Throws a Failure.
  void Read(Statistics& statistics);

  /// Adds the outlines of polygons. Throws a Failure.
  void AddOutlines(const PolygonLayer& polygons);

  /// For the camera as it is.
  void Refresh();

  /// What the colours of tracks tell; no table if they have one colour.
  const LegendKey& GetTrackKey() const
  {
    return this->TrackKey;
  }

  /// Texts of the labels that Refresh() has placed, each with the pixels of its left, low, right
  /// and high border: "2,549 m: 100 200 180 220".
  const std::vector<std::string>& GetPlaced() const
  {
    return this->Placed;
  }

private:
  /// Lines and points as they are, and as they are drawn.
  struct Nearer
  {
    vtkSmartPointer<vtkPoints> Points;
    vtkSmartPointer<vtkPoints> Drawn;
  };

  vtkActor* AddLines(vtkPolyData* lines, const double color[3], double width, double pointSize);
  void ReadGraticule(vtkTerrainGraticule::GridType grid);
  void ReadTracks(Statistics& statistics);
  void AddTrack(vtkPolyData* track, const std::string& path);
  void AddTitles(LabelPlacer& placer) const;
  void AddLabels(LabelPlacer& placer);
  /// Heights on contour lines, turned along them.
  void AddContourLabels(LabelPlacer& placer);
  /// Keeps what a label says, and where.
  void Tell(const std::string& text, const PixelBox& box);
  void ReadOutline();
  /// Warns of labels that have no place in the picture wherever they stand, once.
  void TellWide(const LabelPlacer& placer);
  void AddGraticuleLabels(LabelPlacer& placer) const;
  /// Where a point of the ground is in the picture, if the eye sees it or what is so many pixels
  /// above it; else empty.
  std::optional<std::array<double, 2>> Find(
    LabelPlacer& placer, const double point[3], double pixels) const;

  vtkSmartPointer<vtkRenderer> Renderer;
  const PlacedHeights& Heights;
  const Options& Wanted;
  vtkSmartPointer<vtkTerrainViewpoint> Sight;
  std::vector<Nearer> Lines;
  ScaledBox Box;
  std::optional<InsetMap> Inset;
  LegendKey TrackKey;
  vtkIdType TrackPoints = 0;
  std::vector<Label> Labels;
  std::vector<ContourPlace> ContourPlaces;
  bool HasToldWide = false;
  std::vector<std::string> Placed;
  /// Of the graticule; null for none.
  vtkSmartPointer<vtkPolyData> GraticuleLabels;
  /// What is made anew for each view.
  std::vector<vtkSmartPointer<vtkProp>> OfThisView;
};

#endif
