// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGeoid.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainTesting.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>

#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace
{
using Frame = vtkTerrainGeoreference::FrameType;

constexpr double kRoundTrip = vtkTerrainGeoreference::PlaceError;
// What it promises against GDAL's own transform, in cells.
constexpr double kAgainstGDAL = 0.01;

constexpr double kDegrees = 57.295779513082321;

struct NamedExtent
{
  const char* System;
  double Extent[4];
};

/// At least one of every family; all between 3 and 100 km wide.
const std::vector<NamedExtent> kSystems{
  { "EPSG:4326", { 86.0, 87.0, 27.0, 28.0 } },                      // geographic, latitude first
  { "EPSG:4267", { -122.3, -122.1, 46.1, 46.3 } },                  // geographic, another datum
  { "EPSG:32645", { 470000.0, 500000.0, 3080000.0, 3110000.0 } },   // UTM north
  { "EPSG:32733", { 780000.0, 800000.0, 6300000.0, 6330000.0 } },   // UTM south
  { "EPSG:32661", { 1900000.0, 2100000.0, 1900000.0, 2100000.0 } }, // UPS, over the pole
  { "EPSG:3857", { 9660000.0, 9690000.0, 3240000.0, 3270000.0 } },  // web Mercator
  { "EPSG:2154", { 990000.0, 1010000.0, 6530000.0, 6550000.0 } },   // Lambert, France
  { "EPSG:3031", { 300000.0, 400000.0, -1300000.0, -1200000.0 } },  // polar stereographic
  { "EPSG:2263", { 980000.0, 1010000.0, 180000.0, 210000.0 } },     // New York, US survey feet
  { "EPSG:2180", { 560000.0, 580000.0, 150000.0, 170000.0 } },      // Poland, northing first
  { "EPSG:26710", { 557000.0, 567000.0, 5108000.0, 5122000.0 } },   // UTM on NAD27
  { "EPSG:3413", { -300000.0, -250000.0, -2200000.0, -2150000.0 } },
};

/// Metres between two places.
double Apart(const double* a, const double* b)
{
  double p[3];
  double q[3];
  const GeographicLib::Geocentric& earth = GeographicLib::Geocentric::WGS84();
  earth.Forward(a[1], a[0], a[2], p[0], p[1], p[2]);
  earth.Forward(b[1], b[0], b[2], q[0], q[1], q[2]);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// The corners and ten points inside, with heights.
std::vector<double> PointsOf(const double extent[4])
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<double> points;
  for (int i = 0; i < 14; ++i)
  {
    const double u = i < 4 ? i % 2 : share(random);
    const double v = i < 4 ? static_cast<double>(i > 1) : share(random);
    points.push_back((1.0 - u) * extent[0] + u * extent[1]);
    points.push_back((1.0 - v) * extent[2] + v * extent[3]);
    points.push_back(1000.0 * share(random));
  }
  return points;
}

/// The places of points in a CRS as OGR has them: nothing of the module in between.
std::vector<double> PlacesByGDAL(const std::string& system, std::vector<double> points)
{
  OGRSpatialReferenceH from = OSRNewSpatialReference(nullptr);
  OGRSpatialReferenceH to = OSRNewSpatialReference(nullptr);
  EXPECT_EQ(OSRSetFromUserInput(from, system.c_str()), OGRERR_NONE);
  OSRImportFromEPSG(to, 4326);
  OSRSetAxisMappingStrategy(from, OAMS_TRADITIONAL_GIS_ORDER);
  OSRSetAxisMappingStrategy(to, OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationH transformation = OCTNewCoordinateTransformation(from, to);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    double z = 0.0;
    EXPECT_TRUE(OCTTransform(transformation, 1, &points[i], &points[i + 1], &z));
  }
  OCTDestroyCoordinateTransformation(transformation);
  OSRRelease(from);
  OSRRelease(to);
  return points;
}

void Define(vtkTerrainGeoreference* reference, const NamedExtent& system)
{
  const double* e = system.Extent;
  reference->SetCoordinateSystem(system.System);
  reference->SetExtent(e[0], e[1], e[2], e[3]);
}

std::string WhyNot(const char* system, const NamedExtent& extent, Frame frame = Frame::Plane)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, extent);
  reference->SetCoordinateSystem(system);
  reference->SetFrame(frame);
  return reference->GetWhyNot();
}

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}

TEST(TerrainGeoreference, NumbersWithoutMeasureAreNoPlaces)
{
  for (const char* system : { "EPSG:3857", "EPSG:32633", "EPSG:4807", "EPSG:4326" })
  {
    const vtkNew<vtkTerrainGeoreference> georeference;
    georeference->SetCoordinateSystem(system);
    georeference->SetFrame(vtkTerrainGeoreference::FrameType::Geocentric);
    for (const double far : { 1e13, -1e308, HUGE_VAL, std::nan("") })
    {
      double places[6] = { far, 0.0, 0.0, 0.0, far, 0.0 };
      ASSERT_TRUE(georeference->FileToPlaces(places, places, 2));
      EXPECT_TRUE(std::isnan(places[4])) << system << " " << far;
      const bool isTurned = std::string(system) == "EPSG:4326" && std::isfinite(far);
      EXPECT_EQ(std::isnan(places[0]), !isTurned) << system << " " << far;
    }
  }
}

TEST(TerrainGeoreference, PlacesAreGDALs)
{
  for (const NamedExtent& system : kSystems)
  {
    vtkNew<vtkTerrainGeoreference> reference;
    Define(reference, system);
    ASSERT_EQ(reference->GetWhyNot(), "") << system.System;
    const std::vector<double> points = PointsOf(system.Extent);
    const std::vector<double> expected = PlacesByGDAL(system.System, points);
    std::vector<double> places(points.size());
    ASSERT_TRUE(reference->FileToPlaces(points.data(), places.data(), 14));
    for (std::size_t i = 0; i < points.size(); i += 3)
    {
      EXPECT_LE(Apart(&places[i], &expected[i]), 1e-6) << system.System << " point " << i / 3;
    }
    ASSERT_TRUE(reference->PlacesToFile(places.data(), places.data(), 14));
    const double metre =
      std::string(system.System) < "EPSG:4300" && std::string(system.System) > "EPSG:4200" ? 1e-5
                                                                                           : 1.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      EXPECT_NEAR(places[i], points[i], kRoundTrip * metre) << system.System << " value " << i;
    }
  }
}

TEST(TerrainGeoreference, EveryFrameThereAndBack)
{
  for (const NamedExtent& system : kSystems)
  {
    for (Frame frame : { Frame::Plane, Frame::Local, Frame::Geocentric, Frame::Zone, Frame::Grid })
    {
      vtkNew<vtkTerrainGeoreference> reference;
      Define(reference, system);
      reference->SetFrame(frame);
      if (frame == Frame::Grid && std::abs(system.Extent[0]) < 360.0)
      {
        EXPECT_TRUE(Contains(reference->GetWhyNot(), "in degrees")) << reference->GetWhyNot();
        continue;
      }
      ASSERT_EQ(reference->GetWhyNot(), "") << system.System;
      const std::vector<double> file = PointsOf(system.Extent);
      std::vector<double> places(file.size());
      std::vector<double> scene(file.size());
      std::vector<double> back(file.size());
      ASSERT_TRUE(reference->FileToPlaces(file.data(), places.data(), 14));
      ASSERT_TRUE(reference->FileToScene(file.data(), scene.data(), 14));
      ASSERT_TRUE(reference->SceneToPlaces(scene.data(), back.data(), 14));
      for (std::size_t i = 0; i < file.size(); i += 3)
      {
        EXPECT_LE(Apart(&back[i], &places[i]), kRoundTrip) << system.System;
      }
      ASSERT_TRUE(reference->PlacesToScene(places.data(), back.data(), 14));
      for (std::size_t i = 0; i < file.size(); ++i)
      {
        EXPECT_NEAR(back[i], scene[i], kRoundTrip) << system.System;
      }
      ASSERT_TRUE(reference->SceneToFile(scene.data(), back.data(), 14));
      ASSERT_TRUE(reference->FileToScene(back.data(), back.data(), 14));
      for (std::size_t i = 0; i < file.size(); ++i)
      {
        EXPECT_NEAR(back[i], scene[i], kRoundTrip) << system.System;
      }
    }
  }
}

TEST(TerrainGeoreference, OneMillimetreWithin1000Kilometres)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (double latitude : { -90.0, -45.0, 0.0, 30.0, 75.0, 90.0 })
  {
    vtkNew<vtkTerrainGeoreference> reference;
    reference->SetCoordinateSystem("EPSG:4326");
    reference->SetOrigin(179.5, latitude, 100.0);
    reference->SetFrame(Frame::Local);
    const GeographicLib::LocalCartesian exact(latitude, 179.5, 100.0);
    for (int i = 0; i < 500; ++i)
    {
      double place[3] = { 0.0, 0.0, 0.0 };
      exact.Reverse(7e5 * share(random), 7e5 * share(random), 9e3 * share(random), place[1],
        place[0], place[2]);
      double expected[3];
      double scene[3];
      double back[3];
      exact.Forward(place[1], place[0], place[2], expected[0], expected[1], expected[2]);
      ASSERT_TRUE(reference->PlacesToScene(place, scene, 1));
      ASSERT_TRUE(reference->SceneToPlaces(scene, back, 1));
      EXPECT_LE(std::hypot(scene[0] - expected[0], scene[1] - expected[1], scene[2] - expected[2]),
        kRoundTrip);
      EXPECT_LE(Apart(place, back), kRoundTrip);
    }
  }
}

TEST(TerrainGeoreference, SceneHasACoordinateSystemOfItsOwn)
{
  // What GDAL makes of the WKT of the scene is what the class computed by itself.
  for (const NamedExtent& system : kSystems)
  {
    for (Frame frame : { Frame::Plane, Frame::Zone, Frame::Grid })
    {
      vtkNew<vtkTerrainGeoreference> reference;
      Define(reference, system);
      reference->SetFrame(frame);
      const std::string wkt = reference->GetSceneCoordinateSystem();
      if (!reference->GetWhyNot().empty() || std::string(system.System) == "EPSG:2263")
      {
        EXPECT_TRUE(frame == Frame::Grid ? wkt.empty() : !wkt.empty()) << wkt;
        continue;
      }
      const std::vector<double> file = PointsOf(system.Extent);
      std::vector<double> scene(file.size());
      std::vector<double> places(file.size());
      ASSERT_TRUE(reference->FileToScene(file.data(), scene.data(), 14));
      ASSERT_TRUE(reference->SceneToPlaces(scene.data(), places.data(), 14));
      const std::vector<double> expected = PlacesByGDAL(wkt, scene);
      for (std::size_t i = 0; i < file.size(); i += 3)
      {
        EXPECT_LE(Apart(&places[i], &expected[i]), kRoundTrip) << system.System << wkt;
      }
    }
  }
  vtkNew<vtkTerrainGeoreference> local;
  Define(local, kSystems[0]);
  local->SetFrame(Frame::Local);
  EXPECT_EQ(local->GetSceneCoordinateSystem(), "");
}

TEST(TerrainGeoreference, AutomaticOriginAndZone)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, kSystems[0]);
  double origin[3];
  reference->GetOrigin(origin);
  EXPECT_DOUBLE_EQ(origin[0], 86.5);
  EXPECT_DOUBLE_EQ(origin[1], 27.5);
  EXPECT_EQ(origin[2], 0.0);
  reference->SetOrigin(86.0, 27.0, 5.0);
  reference->GetOrigin(origin);
  EXPECT_EQ(origin[0], 86.0);
  reference->SetAutomaticOrigin();
  reference->GetOrigin(origin);
  EXPECT_DOUBLE_EQ(origin[0], 86.5);
  reference->SetFrame(Frame::Zone);
  EXPECT_EQ(reference->GetZone(), 45);
  EXPECT_TRUE(reference->GetNorthern());
  reference->SetZone(44, true);
  EXPECT_EQ(reference->GetZone(), 44);
  Define(reference, kSystems[7]);
  reference->SetZone(-1, true);
  EXPECT_EQ(reference->GetZone(), 58) << "164 E";
  EXPECT_FALSE(reference->GetNorthern());
}

TEST(TerrainGeoreference, AxesLean)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, kSystems[0]);
  reference->SetFrame(Frame::Local);
  const double place[3] = { 87.5, 27.5, 0.0 };
  double east[3];
  double north[3];
  double up[3];
  ASSERT_TRUE(reference->GetAxes(place, east, north, up));
  // One degree of longitude east of the origin, up leans east by about cos(latitude) degrees.
  EXPECT_NEAR(up[0], std::cos(27.5 / kDegrees) * std::sin(1.0 / kDegrees), 1e-9);
  EXPECT_NEAR(east[0] * north[0] + east[1] * north[1] + east[2] * north[2], 0.0, 1e-9);
}

TEST(TerrainGeoreference, FlatErrors)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, kSystems[0]);
  double horizontal = -1.0;
  double vertical = -1.0;
  reference->GetFlatError(horizontal, vertical);
  // Half a diagonal of the degree square is d = 74 km: d^2 / 2R = 432 m, d^3 / 6R^2 = 1.7 m.
  EXPECT_NEAR(vertical, 432.0, 5.0);
  EXPECT_NEAR(horizontal, 1.7, 0.2);
  reference->SetFrame(Frame::Local);
  reference->GetFlatError(horizontal, vertical);
  EXPECT_EQ(horizontal, 0.0);
  EXPECT_EQ(vertical, 0.0);
  // Web Mercator's own grid is stretched by 1 / cos(latitude).
  Define(reference, kSystems[5]);
  reference->SetFrame(Frame::Grid);
  reference->GetFlatError(horizontal, vertical);
  EXPECT_GT(horizontal, 2000.0);
}

TEST(TerrainGeoreference, ReadoutAndText)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, kSystems[0]);
  const double scene[3] = { 0.0, 0.0, 123.45 };
  EXPECT_EQ(reference->GetReadout(scene),
    "27.500000N 86.500000E  123.5 m  45n 450613 3041916  45RVL5061341916");
  const double nowhere[3] = { 1e8, 0.0, 0.0 };
  EXPECT_EQ(reference->GetReadout(nowhere), "-");
  double place[3] = { 0.0, 0.0, 9.0 };
  EXPECT_EQ(
    vtkTerrainGeoreference::PlaceFromText(vtkTerrainGeoreference::GetMGRS(86.5, 27.5, 8), place),
    "");
  EXPECT_NEAR(place[0], 86.5, 1e-7);
  EXPECT_NEAR(place[1], 27.5, 1e-7);
  EXPECT_EQ(place[2], 9.0);
  EXPECT_NE(vtkTerrainGeoreference::PlaceFromText("Lhotse", place), "");
}

TEST(TerrainGeoreference, HeightUnits)
{
  EXPECT_EQ(vtkTerrainGeoreference::HeightUnitFromName("metre"), 1.0);
  EXPECT_EQ(vtkTerrainGeoreference::HeightUnitFromName("Feet"), 0.3048);
  EXPECT_EQ(vtkTerrainGeoreference::HeightUnitFromName("US_survey_foot"), 1200.0 / 3937.0);
  EXPECT_EQ(vtkTerrainGeoreference::HeightUnitFromName("furlong"), 0.0);
  EXPECT_EQ(vtkTerrainGeoreference::HeightUnitFromName(""), 0.0);
  vtkNew<vtkTerrainGeoreference> reference;
  // NAD83 / New York Long Island (ftUS) + NAVD88 height (ftUS).
  Define(reference, kSystems[8]);
  reference->SetCoordinateSystem("EPSG:2263+6360");
  EXPECT_EQ(reference->GetWhyNot(), "");
  EXPECT_NEAR(reference->GetHeightUnit(), 1200.0 / 3937.0, 1e-12);
  EXPECT_EQ(reference->GetFileHeights(), vtkTerrainGeoreference::HeightType::Geoid);
  double file[3] = { 990000.0, 200000.0, 1000.0 };
  ASSERT_TRUE(reference->FileToScene(file, file, 1));
  EXPECT_NEAR(file[2], 1000.0 * 1200.0 / 3937.0, 1e-9);
  reference->SetHeightUnit(1.0);
  EXPECT_EQ(reference->GetHeightUnit(), 1.0);
  reference->SetCoordinateSystem("EPSG:4979");
  reference->SetExtent(10.0, 11.0, 45.0, 46.0);
  EXPECT_EQ(reference->GetFileHeights(), vtkTerrainGeoreference::HeightType::Ellipsoid);
}

TEST(TerrainGeoreference, SaysWhyNot)
{
  const NamedExtent& degrees = kSystems[0];
  const NamedExtent& utm = kSystems[2];
  EXPECT_TRUE(Contains(WhyNot("", degrees), "no coordinate system"));
  EXPECT_EQ(WhyNot("", degrees, Frame::Grid), "");
  EXPECT_TRUE(Contains(WhyNot("EPSG:999999", degrees), "not understood"));
  EXPECT_TRUE(Contains(WhyNot("https://example.org/crs", degrees), "not understood"));
  // GDAL reads definitions from files, those of a network and of its own file systems, too
  std::string text = "EPSG:4326";
  VSIFCloseL(VSIFileFromMemBuffer(
    "/vsimem/crs.txt", reinterpret_cast<GByte*>(text.data()), text.size(), FALSE));
  EXPECT_TRUE(Contains(WhyNot("/vsimem/crs.txt", degrees), "not understood"));
  VSIUnlink("/vsimem/crs.txt");
  EXPECT_TRUE(Contains(WhyNot("EPSG:4978", degrees), "neither a map projection"));
  EXPECT_TRUE(Contains(WhyNot("EPSG:5773", degrees), "neither a map projection"));
  const char* mine =
    "ENGCRS[\"mine\",EDATUM[\"shaft\"],CS[Cartesian,2],AXIS[\"x\",east],AXIS[\"y\",north],"
    "LENGTHUNIT[\"metre\",1]]";
  EXPECT_TRUE(Contains(WhyNot(mine, utm), "tied to no place"));
  EXPECT_EQ(WhyNot(mine, utm, Frame::Grid), "");
  EXPECT_TRUE(Contains(WhyNot("EPSG:4326", utm), "those are no degrees"));
  EXPECT_TRUE(Contains(WhyNot("EPSG:4326", { "", { 27.0, 28.0, 96.0, 97.0 } }), "swapped"));
  EXPECT_TRUE(Contains(WhyNot("EPSG:4326", { "", { -200.0, 200.0, 0.0, 1.0 } }), "no degrees"));
  EXPECT_TRUE(Contains(WhyNot("EPSG:32645", { "", { 1e12, 2e12, 1e12, 2e12 } }), "does not reach"));
  EXPECT_TRUE(Contains(WhyNot("EPSG:4326", { "", { 1.0, -1.0, 1.0, -1.0 } }), "neither an origin"));

  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, { "EPSG:32645", { 86.0, 87.0, 27.0, 28.0 } });
  EXPECT_EQ(reference->GetWhyNot(), "");
  EXPECT_TRUE(Contains(reference->GetWarning(), "looks like degrees"));
  Define(reference, utm);
  EXPECT_EQ(reference->GetWarning(), "");
  reference->SetOrigin(0.0, 100.0, 0.0);
  EXPECT_TRUE(Contains(reference->GetWhyNot(), "not on earth"));
  double point[3] = { 0.0, 0.0, 0.0 };
  EXPECT_FALSE(reference->FileToScene(point, point, 1));
  EXPECT_FALSE(reference->PlacesToScene(point, point, 1));
}

TEST(TerrainGeoreference, AntimeridianAndPole)
{
  // Fiji: 177 to 183 degrees, in one piece.
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, { "EPSG:4326", { 177.0, 183.0, -19.0, -16.0 } });
  double file[3] = { 181.0, -17.0, 0.0 };
  double place[3];
  double back[3];
  ASSERT_TRUE(reference->FileToPlaces(file, place, 1));
  EXPECT_DOUBLE_EQ(place[0], -179.0);
  ASSERT_TRUE(reference->PlacesToFile(place, back, 1));
  EXPECT_DOUBLE_EQ(back[0], 181.0);
  double scene[3];
  ASSERT_TRUE(reference->FileToScene(file, scene, 1));
  EXPECT_NEAR(scene[0], 106500.0, 200.0);
  // A cap round the pole, in degrees and in UPS: the same scene.
  vtkNew<vtkTerrainGeoreference> cap;
  Define(cap, { "EPSG:4326", { -180.0, 180.0, 88.0, 90.0 } });
  cap->SetOrigin(0.0, 90.0, 0.0);
  vtkNew<vtkTerrainGeoreference> ups;
  Define(ups, kSystems[4]);
  ups->SetOrigin(0.0, 90.0, 0.0);
  double pole[3] = { 123.0, 90.0, 0.0 };
  ASSERT_TRUE(cap->FileToScene(pole, scene, 1));
  EXPECT_NEAR(std::hypot(scene[0], scene[1]), 0.0, 1e-6);
  double upsPole[3] = { 2000000.0, 2000000.0, 0.0 };
  ASSERT_TRUE(ups->FileToScene(upsPole, scene, 1));
  EXPECT_NEAR(std::hypot(scene[0], scene[1]), 0.0, 1e-6);
}

// A grid of 10 m cells at the middle of a transverse Mercator projection, where its scale is k.
TEST(TerrainGeoreference, SuggestsTheOwnGridWhereItsScaleIsTrue)
{
  for (const double off : { 0.0, 0.99, -0.99, 1.01, -1.01 })
  {
    std::ostringstream system;
    system.precision(12);
    system << "+proj=tmerc +lat_0=46 +lon_0=8 +x_0=0 +y_0=0 +ellps=GRS80 +units=m +k="
           << 1.0 / (1.0 + off * vtkTerrainGeoreference::ScaleError);
    vtkNew<vtkImageData> heights;
    heights->SetDimensions(11, 11, 1);
    heights->SetOrigin(-50.0, -50.0, 0.0);
    heights->SetSpacing(10.0, 10.0, 1.0);
    heights->AllocateScalars(VTK_FLOAT, 1);
    vtkNew<vtkStringArray> name;
    name->SetName("CRS");
    name->InsertNextValue(system.str());
    heights->GetFieldData()->AddArray(name);
    EXPECT_EQ(vtkTerrainGeoreference::SuggestFrame(heights),
      std::abs(off) < 1.0 ? Frame::Grid : Frame::Plane)
      << system.str();
  }
}

TEST(TerrainGeoreference, ManyThreadsAgree)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, kSystems[6]);
  std::vector<double> file;
  for (int i = 0; i < 20000; ++i)
  {
    file.insert(file.end(), { 990000.0 + i, 6530000.0 + 0.5 * i, 0.0 });
  }
  std::vector<double> expected(file.size());
  ASSERT_TRUE(reference->FileToScene(file.data(), expected.data(), 20000));
  std::vector<std::vector<double>> results(4, std::vector<double>(file.size()));
  std::vector<std::thread> threads;
  threads.reserve(results.size());
  for (std::vector<double>& result : results)
  {
    threads.emplace_back(
      [&reference, &file, &result] { reference->FileToScene(file.data(), result.data(), 20000); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const std::vector<double>& result : results)
  {
    EXPECT_EQ(result, expected);
  }
}

TEST(TerrainGeoreference, RealFilesAgreeWithGDAL)
{
  const std::vector<const char*> files{ "S33E018.hgt", "S34E018.hgt", "SainteHelens.dem",
    "aconcagua_srtm3_u16.png", "bigtujunga_srtm1_utm11.tif", "craterlake_elev_30m.tif",
    "everest_landsat7_rgb_utm45.tif", "everest_srtm3_voids.tif", "globe_g_8192x5120_i16.tif",
    "greenriver_lidar_1m_utm12_f32.tif", "monterey_topobathy_f32.tif" };
  GDALAllRegister();
  int found = 0;
  for (const char* name : files)
  {
    const std::string path = vtkTerrainTesting::DataPath(name);
    GDALDatasetH dataset = path.empty() ? nullptr : GDALOpen(path.c_str(), GA_ReadOnly);
    if (!dataset)
    {
      continue;
    }
    ++found;
    double t[6];
    GDALGetGeoTransform(dataset, t);
    const std::string wkt = GDALGetProjectionRef(dataset);
    const NamedExtent extent{ wkt.c_str(),
      { t[0], t[0] + t[1] * GDALGetRasterXSize(dataset), t[3] + t[5] * GDALGetRasterYSize(dataset),
        t[3] } };
    GDALClose(dataset);
    vtkNew<vtkTerrainGeoreference> reference;
    Define(reference, extent);
    ASSERT_EQ(reference->GetWhyNot(), "") << name;
    EXPECT_EQ(reference->GetWarning(), "") << name;
    const std::vector<double> points = PointsOf(extent.Extent);
    const std::vector<double> expected = PlacesByGDAL(wkt, points);
    const double cell = t[1] < 0.1 ? t[1] * 111000.0 * 0.5 : t[1];
    for (Frame frame : { Frame::Plane, Frame::Local, Frame::Geocentric, Frame::Zone })
    {
      reference->SetFrame(frame);
      // The globe tile reaches further than a zone does.
      if (frame == Frame::Zone && extent.Extent[1] < 100.0 && extent.Extent[1] > 60.0)
      {
        continue;
      }
      std::vector<double> scene(points.size());
      std::vector<double> places(points.size());
      ASSERT_TRUE(reference->FileToScene(points.data(), scene.data(), 14));
      ASSERT_TRUE(reference->SceneToPlaces(scene.data(), places.data(), 14));
      for (std::size_t i = 0; i < points.size(); i += 3)
      {
        EXPECT_LE(Apart(&places[i], &expected[i]), kAgainstGDAL * cell) << name << " point " << i;
      }
    }
  }
  if (found == 0)
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set, or lacks the files";
  }
}
