// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainGeoreference
 * @brief   where on earth a raster lies, and where in the scene
 *
 * Three kinds of points, each three doubles:
 *
 * | points | x, y | z |
 * | --- | --- | --- |
 * | file   | in the raster's coordinate reference system (CRS), east and north | its heights |
 * | place  | longitude, latitude in degrees on WGS84 | metres |
 * | scene  | metres, in the chosen frame | metres |
 *
 * Frames of the scene:
 *
 * | frame | is | the earth in it |
 * | --- | --- | --- |
 * | Plane      | east, north at the origin (orthographic, EPSG method 9840), z = height  | flat  |
 * | Local      | east, north, up at the origin (GeographicLib::LocalCartesian)           | round |
 * | Geocentric | X, Y, Z from the earth's centre                                         | round |
 * | Zone       | UTM, or UPS near the poles (GeographicLib::UTMUPS), z = height          | flat  |
 * | Grid       | the file's own grid, in metres                                          | flat  |
 * | Globe      | as Geocentric, on the ellipsoid of the file's CRS, of any world         | round |
 *
 * Places of CRSs other than WGS84 come from PROJ through GDAL/OGR's C API. Without grids of datum
 * shifts installed, old datums (NAD27) are as good as PROJ's parameters: some metres.
 *
 * In the frame Globe the file may be of another world than the earth; places are then its own
 * longitudes, eastward, and latitudes. vtkTerrainGlobe lays its heights onto that globe.
 *
 * Heights: those of the file times HeightUnit are metres. SceneHeights other than AsIs converts
 * between sea level and ellipsoid, see vtkTerrainGeoid. Local, Geocentric and Globe take every
 * height as ellipsoidal.
 *
 * Every transforming function takes whole arrays, runs on the threads of vtkSMPTools, may be called
 * from several threads, allows input and output to be the same array, and returns false if
 * GetWhyNot has a reason. Points without image are NaN.
 *
 * Error: places and back to PlaceError up to 1,000 km from the origin. Cost, for Local and Plane:
 * about 30 ns a point and core to the scene, 100 ns back; other CRSs add what PROJ takes, 250 to
 * 700 ns.
 *
 * @code
 *   vtkNew<vtkTerrainGeoreference> place;
 *   place->SetCoordinateSystem("EPSG:32645");
 *   place->SetExtent(478000.0, 502000.0, 3088000.0, 3108000.0);
 *   double everest[3] = { 86.925, 27.988, 8849.0 };
 *   place->PlacesToScene(everest, everest, 1);
 * @endcode
 *
 * @sa vtkTerrainReproject vtkTerrainGeoTransform vtkTerrainGeoid
 */
#ifndef vtkTerrainGeoreference_h
#define vtkTerrainGeoreference_h

#include "vtkObject.h"
#include "vtkTerrainModule.h" // For export macro

#include <memory>
#include <string>

class vtkImageData;
class vtkTerrainGeoid;

class VTKTERRAIN_EXPORT vtkTerrainGeoreference : public vtkObject
{
public:
  static vtkTerrainGeoreference* New();
  vtkTypeMacro(vtkTerrainGeoreference, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Largest error of a place in the scene and back, in metres.
  static constexpr double PlaceError = 1e-3;

  /// Kind of the scene's coordinates (class comment).
  enum class FrameType
  {
    Plane,
    Local,
    Geocentric,
    Zone,
    Grid,
    Globe
  };

  /// What a height counts from.
  enum class HeightType
  {
    /// Of the file: not known, taken as sea level. Of the scene: no conversion.
    AsIs,
    /// The ellipsoid of WGS84.
    Ellipsoid,
    /// Sea level: the geoid.
    Geoid
  };

  ///@{
  /// CRS of the file: WKT, "EPSG:n", or a PROJ string. A compound CRS or one with ellipsoidal
  /// heights also says what FileHeights and HeightUnit are, unless they are set. Default: none.
  void SetCoordinateSystem(const std::string& definition);
  const std::string& GetCoordinateSystem() const
  {
    return this->CoordinateSystem;
  }
  ///@}

  ///@{
  /// Where the file's data lie, in its own x and y. The automatic origin is the middle; a CRS that
  /// contradicts it is refused. Default: unknown (xMin > xMax).
  void SetExtent(double xMin, double xMax, double yMin, double yMax);
  const double* GetExtent() const VTK_SIZEHINT(4)
  {
    return this->Extent;
  }
  ///@}

  /// CRS and extent of heights, from the field data that vtkTerrainRasterReader adds to them
  /// (LayoutOrigin, LayoutScale; without these an image lies at its own coordinates). The CRS is
  /// kept if the heights name none. Heights on a globe (vtkTerrainGlobe) also say its semi-axes,
  /// which the frame Globe then takes in place of those of the CRS.
  void SetFromHeights(vtkImageData* heights);

  /// The frame that suits heights where nobody chooses one: Grid where their own grid is in metres
  /// and true to scale in its middle (within ScaleError), and where nothing is known of it, or
  /// where they reach so far that no flat frame is of use (the earth falls by more than 200 km);
  /// else Plane.
  static FrameType SuggestFrame(vtkImageData* heights);
  /// What the scale of a grid may be off by, as a part of it, where SuggestFrame calls it true.
  static constexpr double ScaleError = 0.01;

  ///@{
  /// Frame of the scene; default Plane.
  void SetFrame(FrameType frame);
  FrameType GetFrame() const
  {
    return this->Frame;
  }
  ///@}

  ///@{
  /// Origin of Plane and Local: longitude, latitude in degrees, height in metres. Default, and
  /// after SetAutomaticOrigin: the middle of the extent, at height 0.
  void SetOrigin(double longitude, double latitude, double height);
  void SetAutomaticOrigin();
  ///@}
  /// The origin in use, automatic or not; NaN if there is none.
  void GetOrigin(double origin[3]);

  ///@{
  /// How much higher than on earth heights are in the round frame Local, > 0; default 1. Heights
  /// above the ellipsoid are meant, those of the origin included; the earth's curve below them
  /// stays as it is. No other frame uses this: a flat scene is exaggerated where it is drawn
  /// (vtkTerrainActor::SetVerticalExaggeration), which needs no other heights.
  vtkSetClampMacro(VerticalExaggeration, double, 1e-30, VTK_DOUBLE_MAX);
  vtkGetMacro(VerticalExaggeration, double);
  /// How much higher in the scene a point is whose place is higher by so many metres.
  double GetSceneRise(double metres);
  ///@}

  /// Zone of the frame Zone: 1 to 60 UTM, 0 UPS, -1 (default) the standard zone of the middle of
  /// the extent. northern tells the hemisphere; it is not used with -1.
  void SetZone(int zone, bool northern);
  ///@{
  /// The zone in use; -1 if there is none.
  int GetZone();
  bool GetNorthern();
  ///@}

  /// Metres per unit of the file's heights, > 0; 0 (default): what the CRS says, else 1.
  void SetHeightUnit(double metres);
  /// The unit in use in metres.
  double GetHeightUnit();
  /// Metres of a unit by its name ("m", "metre", "ft", "US survey foot", ...); 0 if it is not
  /// known.
  static double HeightUnitFromName(const std::string& name);

  ///@{
  /// What the file's heights count from; AsIs (default): what the CRS says, else sea level.
  void SetFileHeights(HeightType heights);
  HeightType GetFileHeights();
  ///@}
  ///@{
  /// What the heights of places and of the scene count from; default AsIs: as the file's.
  void SetSceneHeights(HeightType heights);
  HeightType GetSceneHeights() const
  {
    return this->SceneHeights;
  }
  ///@}
  /// Geoid that converts heights; never null, EGM96 by default.
  vtkTerrainGeoid* GetGeoid();

  /// Empty if points of the file can be brought into the scene, else one sentence that says why
  /// not.
  std::string GetWhyNot();
  /// True if the CRS is tied to the earth.
  bool IsOnEarth();
  /// True if the CRS is of a planet or moon. The frame is Grid then; places are longitude and
  /// latitude on its own ellipsoid, and there are no zones, no MGRS, no geoid.
  bool IsOnOtherWorld();
  /// True if there are places, on the earth or elsewhere. Without them, with the frame Grid, only
  /// file and scene can be transformed.
  bool HasPlaces();
  /// True if x and y of the file are longitude and latitude.
  bool IsGeographic();
  /// One sentence about something suspicious that is no error; empty as a rule.
  std::string GetWarning();
  /// Name of the file's CRS as people know it.
  std::string GetCoordinateSystemName();
  /// WKT of the scene's x and y; empty for Local and for a grid without CRS or not in metres.
  std::string GetSceneCoordinateSystem();

  ///@{
  /// Bring count points from one kind to another (class comment).
  bool FileToPlaces(const double* file, double* places, vtkIdType count)
    VTK_SIZEHINT(file, 3 * count) VTK_SIZEHINT(places, 3 * count);
  bool PlacesToFile(const double* places, double* file, vtkIdType count)
    VTK_SIZEHINT(places, 3 * count) VTK_SIZEHINT(file, 3 * count);
  bool PlacesToScene(const double* places, double* scene, vtkIdType count)
    VTK_SIZEHINT(places, 3 * count) VTK_SIZEHINT(scene, 3 * count);
  bool SceneToPlaces(const double* scene, double* places, vtkIdType count)
    VTK_SIZEHINT(scene, 3 * count) VTK_SIZEHINT(places, 3 * count);
  bool FileToScene(const double* file, double* scene, vtkIdType count) VTK_SIZEHINT(file, 3 * count)
    VTK_SIZEHINT(scene, 3 * count);
  bool SceneToFile(const double* scene, double* file, vtkIdType count)
    VTK_SIZEHINT(scene, 3 * count) VTK_SIZEHINT(file, 3 * count);
  ///@}

  /// Brings heights of the file to those of the scene's places: unit, sea level, ellipsoid. One
  /// height and one place of three doubles a point.
  bool FileHeightsToPlaces(const double* places, double* heights, vtkIdType count)
    VTK_SIZEHINT(places, 3 * count) VTK_SIZEHINT(heights, count);

  /// Unit vectors east, north and up at a place, in scene axes.
  bool GetAxes(const double place[3], double east[3], double north[3], double up[3]);

  /// By how much a flat scene is wrong over the extent, in metres: horizontally, the largest
  /// difference of distances from the middle to those along the ellipsoid; vertically, the drop of
  /// the earth below the horizon of the middle. Both are 0 in Local, Geocentric and Globe, NaN if
  /// unknown.
  void GetFlatError(double& horizontal, double& vertical);

  /// Longitude, latitude, height and, on earth, UTM and MGRS of a scene point as one line of text.
  std::string GetReadout(const double scene[3]);
  /// MGRS reference of a place; precision 5 = metres. "-" if it is not on earth.
  static std::string GetMGRS(double longitude, double latitude, int precision = 5);
  /// Place of a text: MGRS, UTM, UPS, or degrees with the longitude first. Returns one sentence if
  /// it is none of these, else nothing; place[2] is kept.
  static std::string PlaceFromText(const std::string& text, double place[3]);

  vtkTerrainGeoreference(const vtkTerrainGeoreference&) = delete;
  void operator=(const vtkTerrainGeoreference&) = delete;

  /// Also that of the geoid.
  vtkMTimeType GetMTime() override;

protected:
  vtkTerrainGeoreference();
  ~vtkTerrainGeoreference() override;

private:
  class vtkInternals;
  void Prepare();
  void PrepareUnits();
  void PrepareFrame();
  void SetGlobe(double equatorial, double polar);
  std::string WhyNotExtent();
  bool Middle(double place[3]);
  void ConvertHeights(double* places, vtkIdType count, bool toScene);
  std::string WhyNoFrame();
  std::string PlaceFrame();
  template <typename Function>
  bool InBatches(
    const double* in, double* out, vtkIdType count, bool needsPlaces, Function&& function);

  std::string CoordinateSystem;
  double Extent[4] = { 1.0, -1.0, 1.0, -1.0 };
  /// Of heights in degrees of another world: how the reader has laid them out in metres.
  double LayoutOrigin[2] = { 0.0, 0.0 };
  double LayoutScale[2] = { 1.0, 1.0 };
  /// Semi-axes of the globe that heights lie on, metres; 0 for those of the CRS.
  double Globe[2] = { 0.0, 0.0 };
  FrameType Frame = FrameType::Plane;
  bool IsOriginGiven = false;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double VerticalExaggeration = 1.0;
  int Zone = -1;
  bool Northern = true;
  double HeightUnit = 0.0;
  HeightType FileHeights = HeightType::AsIs;
  HeightType SceneHeights = HeightType::AsIs;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
