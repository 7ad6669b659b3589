// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainViewpoint
 * @brief   cameras, sunlight and measures between places of a scene
 *
 * Works on a georeference and the heights of its scene (vtkImageData of W x H x 1 points).
 * Functions return one sentence if they cannot do what they are asked, else an empty text.
 *
 * Places are written "LON,LAT", "LON,LAT,HEIGHT" or an MGRS or UTM reference with an optional
 * ",HEIGHT"; a HEIGHT in metres is absolute, or above the ground with the suffix "agl": "500agl".
 * Without HEIGHT a place lies on the ground.
 *
 * Sun: terrain::SunPosition (error 0.02 degrees, 1950 to 2050, without refraction).
 * Distances, areas: geodesic on WGS84 (terrain::GeodesicBetween, 15 nm).
 *
 * @sa vtkTerrainGeoreference
 */
#ifndef vtkTerrainViewpoint_h
#define vtkTerrainViewpoint_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"  // For members
#include "vtkTerrainModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

namespace terrain
{
class GlobeSurface;
}
class vtkCamera;
class vtkImageData;
class vtkLight;
class vtkPoints;
class vtkPolyData;
class vtkTerrainGeoreference;

class VTKTERRAIN_EXPORT vtkTerrainViewpoint : public vtkObject
{
public:
  static vtkTerrainViewpoint* New();
  vtkTypeMacro(vtkTerrainViewpoint, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The scene, and its heights; both none by default.
  void SetGeoreference(vtkTerrainGeoreference* georeference);
  vtkTerrainGeoreference* GetGeoreference() const;
  void SetHeights(vtkImageData* heights);
  vtkImageData* GetHeights() const;
  ///@}

  /// Further heights of the scene, on whose ground FindPlace and Look find places that lie on none
  /// before them; all else counts with those of SetHeights, which takes these away.
  void AddHeights(vtkImageData* heights);

  ///@{
  /// Vertical exaggeration of the terrain as drawn, which scene points given and returned include;
  /// default 1. That of the georeference, which round scenes have, is not meant and counts anyway.
  vtkSetMacro(Exaggeration, double);
  vtkGetMacro(Exaggeration, double);
  ///@}

  ///@{
  /// Share of the earth's curvature that refraction takes from a line of sight, 0 to 1; default
  /// 0.13.
  vtkSetClampMacro(Refraction, double, 0.0, 1.0);
  vtkGetMacro(Refraction, double);
  ///@}

  /// Scene z of the surface at scene x, y; NaN where there is none.
  double GetGround(double x, double y);

  ///@{
  /// One sentence if a text is no place or no time as the functions below take them, else empty.
  static std::string GetWhyNoPlace(const std::string& text);
  static std::string GetWhyNoTime(const std::string& text);
  ///@}

  /// Scene point of a place's text.
  std::string FindPlace(const std::string& text, double scene[3]);

  /// Puts a camera at one place, looking at another, the vertical of the eye upright.
  std::string Look(const std::string& from, const std::string& at, vtkCamera* camera);

  /// Unit vector to the sun in the scene, at a scene point and time ("2024-06-21T06:30Z").
  std::string GetSun(const double scene[3], const std::string& time, double direction[3]);
  /// Makes a light of the sun as seen from the middle of the heights; off while it is below the
  /// horizon.
  std::string SetSun(const std::string& time, vtkLight* light);

  /// Shortest way between two scene points along the ellipsoid: metres, and the direction at its
  /// start in degrees clockwise from north. NaN where a point is not on earth.
  double GetDistance(const double from[3], const double to[3], double* azimuth = nullptr);
  /// Area in square metres and perimeter in metres of a polygon of scene points.
  double GetArea(vtkPoints* corners, double* perimeter = nullptr);

  /// Profile along the geodesic between two scene points: count >= 2 points on the surface as one
  /// line, with point arrays "Distance" from the start and "Height", both in metres (NaN where
  /// there is no surface; such points keep the height of the chord).
  std::string GetProfile(const double from[3], const double to[3], int count, vtkPolyData* profile);

  /// Whether the straight line of sight between two scene points meets the terrain. In flat frames
  /// the earth's curvature is added, in all refraction is taken off. Exact for the bilinear
  /// surface; obstruction, if given, is the scene point that stands highest above the line. On a
  /// globe the line is straight, without refraction, and obstruction is where it meets the ground.
  bool IsVisible(const double from[3], const double to[3], double obstruction[3] = nullptr);

  vtkTerrainViewpoint(const vtkTerrainViewpoint&) = delete;
  void operator=(const vtkTerrainViewpoint&) = delete;

protected:
  vtkTerrainViewpoint();
  ~vtkTerrainViewpoint() override;

private:
  class vtkInternals;

  std::string WhyNot() const;
  bool PutOnGround(vtkImageData* heights, double height, const double place[3], double scene[3]);
  void PutAtHeight(vtkImageData* heights, const double place[3], double scene[3]) const;
  bool ToPlace(const double scene[3], double place[3]);
  bool ToEarth(const double scene[3], double place[3]);
  double GetGlobeGround(const terrain::GlobeSurface& globe, const double place[3]) const;

  vtkSmartPointer<vtkTerrainGeoreference> Georeference;
  vtkSmartPointer<vtkImageData> Heights;
  std::vector<vtkSmartPointer<vtkImageData>> MoreHeights;
  double Exaggeration = 1.0;
  double Refraction = 0.13;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
