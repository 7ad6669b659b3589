// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tracks, summits and pictures on a globe: where they lie, by the ellipsoid's own closed forms.
#include "vtkTerrainTestGlobe.h"
#include "vtkTerrainTesting.h"

#include "vtkTerrainDrape.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainImageWarp.h"
#include "vtkTerrainPeaks.h"
#include "vtkTerrainViewpoint.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <gdal.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
using FrameType = vtkTerrainGeoreference::FrameType;
using Place = std::array<double, 3>;

double Hills(int i, int j)
{
  return std::floor(2000.0 + 1500.0 * std::sin(0.4 * i) * std::cos(0.3 * j));
}

/// Heights on the earth's ellipsoid with their scene.
struct Earth
{
  explicit Earth(vtkImageData* degrees)
  {
    const vtkNew<vtkStringArray> system;
    system->SetName("CRS");
    system->InsertNextValue("EPSG:4326");
    degrees->GetFieldData()->AddArray(system);
    this->Heights = vtkTerrainTesting::LayOnGlobe(degrees);
    this->Scene->SetFromHeights(this->Heights);
    this->Scene->SetFrame(FrameType::Globe);
    this->Ground->SetGeoreference(this->Scene);
    this->Ground->SetHeights(this->Heights);
  }

  /// Degrees and metres of a scene point.
  Place PlaceOf(const double* point) const
  {
    Place place{};
    this->Scene->SceneToPlaces(point, place.data(), 1);
    return place;
  }

  /// Height of the ground at degrees; NaN beside it.
  double HeightAt(double longitude, double latitude) const
  {
    Place point{};
    const std::string text = std::to_string(longitude) + "," + std::to_string(latitude);
    return this->Ground->FindPlace(text, point.data()).empty() ? this->PlaceOf(point.data())[2]
                                                               : std::nan("");
  }

  vtkSmartPointer<vtkImageData> Heights;
  vtkNew<vtkTerrainGeoreference> Scene;
  vtkNew<vtkTerrainViewpoint> Ground;
};

/// The whole earth in cells of a degree, rows of half a degree at the poles.
Earth MakeEarth()
{
  return Earth(vtkTerrainTesting::MakeDegrees(-179.5, -89.5, 1.0, 360, 180, Hills));
}

/// A line through places, with a number of its own.
vtkSmartPointer<vtkPolyData> MakeLine(const Earth& earth, const std::vector<Place>& places)
{
  auto line = vtkSmartPointer<vtkPolyData>::New();
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<vtkIdType>(places.size()));
  for (const Place& place : places)
  {
    Place point{};
    earth.Scene->PlacesToScene(place.data(), point.data(), 1);
    cells->InsertCellPoint(points->InsertNextPoint(point.data()));
  }
  const vtkNew<vtkIntArray> number;
  number->SetName("Number");
  number->InsertNextValue(7);
  line->SetPoints(points);
  line->SetLines(cells);
  line->GetCellData()->AddArray(number);
  return line;
}

vtkSmartPointer<vtkPolyData> Lay(const Earth& earth, vtkPolyData* line,
  vtkTerrainDrape::ModeType mode = vtkTerrainDrape::ModeType::Clamped, double exaggeration = 1.0)
{
  const vtkNew<vtkTerrainDrape> drape;
  drape->SetInputData(line);
  drape->SetHeightsData(earth.Heights);
  drape->SetGeoreference(earth.Scene);
  drape->SetMode(mode);
  drape->SetExaggeration(exaggeration);
  drape->Update();
  return drape->GetOutput();
}

/// Every point of the lines, and the middle of every chord between two.
void VisitChords(vtkPolyData* lines, const std::function<void(const double*, bool)>& visit)
{
  for (vtkIdType cell = 0; cell < lines->GetNumberOfLines(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    lines->GetLines()->GetCellAtId(cell, count, ids);
    Place last{};
    for (vtkIdType k = 0; k < count; ++k)
    {
      Place point{};
      lines->GetPoint(ids[k], point.data());
      visit(point.data(), false);
      if (k > 0)
      {
        const Place middle{ 0.5 * (last[0] + point[0]), 0.5 * (last[1] + point[1]),
          0.5 * (last[2] + point[2]) };
        visit(middle.data(), true);
      }
      last = point;
    }
  }
}

/// A picture of one band in a CRS.
std::string WritePicture(const std::string& name, const std::string& system, int size,
  const std::array<double, 6>& transform, const std::function<double(double, double)>& color)
{
  GDALAllRegister();
  const std::string path = vtkTerrainTesting::OutputPath(name);
  GDALDatasetH file =
    GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), size, size / 2, 1, GDT_Byte, nullptr);
  OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
  EXPECT_EQ(OSRSetFromUserInput(reference, system.c_str()), OGRERR_NONE);
  GDALSetSpatialRef(file, reference);
  std::array<double, 6> copy = transform;
  GDALSetGeoTransform(file, copy.data());
  OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReferenceH degrees = OSRNewSpatialReference(nullptr);
  OSRImportFromEPSG(degrees, 4326);
  OSRSetAxisMappingStrategy(degrees, OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationH way = OCTNewCoordinateTransformation(reference, degrees);
  std::vector<unsigned char> bytes;
  for (int row = 0; row < size / 2; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      double x = transform[0] + (column + 0.5) * transform[1];
      double y = transform[3] + (row + 0.5) * transform[5];
      OCTTransform(way, 1, &x, &y, nullptr);
      bytes.push_back(static_cast<unsigned char>(color(x, y)));
    }
  }
  EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(file, 1), GF_Write, 0, 0, size, size / 2, bytes.data(),
              size, size / 2, GDT_Byte, 0, 0),
    CE_None);
  OCTDestroyCoordinateTransformation(way);
  OSRRelease(degrees);
  OSRRelease(reference);
  GDALClose(file);
  return path;
}

/// Smooth over the date line and the poles.
double ShadeAt(double longitude, double latitude)
{
  const double up = vtkMath::RadiansFromDegrees(latitude);
  const double around = vtkMath::RadiansFromDegrees(longitude);
  return std::round(120.0 + 60.0 * std::sin(up) + 50.0 * std::cos(up) * std::cos(around - 1.0));
}
}

// Over the date line and near a pole: on the ground at every point, and within the tolerance of a
// metre between them.
TEST(TerrainGlobePaths, TracksFollowTheGround)
{
  const Earth earth = MakeEarth();
  const auto track = Lay(
    earth, MakeLine(earth, { { 176.3, 10.2, 5.0 }, { -175.1, 13.7, 9.0 }, { -171.0, 89.9, 0.0 } }));
  ASSERT_EQ(track->GetNumberOfLines(), 2) << "cut where the heights begin";
  EXPECT_EQ(track->GetCellData()->GetArray("Number")->GetComponent(1, 0), 7.0);
  double west = 0.0;
  double east = 0.0;
  double north = 0.0;
  VisitChords(track,
    [&](const double* point, bool isMiddle)
    {
      const Place place = earth.PlaceOf(point);
      west = place[0] > 0.0 ? std::max(west, 180.0 - place[0]) : west;
      east = place[0] < 0.0 ? std::max(east, 180.0 + place[0]) : east;
      north = std::max(north, place[1]);
      EXPECT_NEAR(place[2], earth.HeightAt(place[0], place[1]), isMiddle ? 2.1 : 0.02);
    });
  EXPECT_NEAR(west, 3.7, 1e-6);
  EXPECT_NEAR(east, 9.0, 1e-6);
  EXPECT_NEAR(north, 89.9, 1e-6);
}

// Heights above the ground, absolute ones, exaggerated ones; what lies beside the heights.
TEST(TerrainGlobePaths, TracksHaveTheirModes)
{
  const Earth part(vtkTerrainTesting::MakeDegrees(170.0, -15.0, 0.5, 61, 61, Hills));
  const auto line = MakeLine(part, { { 165.0, 0.0, 800.0 }, { -178.0, 2.0, 800.0 } });
  const auto above = Lay(part, line, vtkTerrainDrape::ModeType::AboveGround, 3.0);
  ASSERT_EQ(above->GetNumberOfLines(), 1);
  const auto at = [&part](vtkPolyData* lines, vtkIdType id)
  { return part.PlaceOf(lines->GetPoint(id)); };
  const Place first = at(above, 0);
  EXPECT_NEAR(first[0], 170.0, 1e-6);
  EXPECT_NEAR(first[2], 3.0 * (part.HeightAt(170.0, first[1]) + 800.0), 0.1);

  const auto absolute = Lay(part, line, vtkTerrainDrape::ModeType::Absolute, 3.0);
  ASSERT_EQ(absolute->GetNumberOfLines(), 1);
  EXPECT_NEAR(at(absolute, 0)[0], 165.0, 1e-6);
  VisitChords(absolute,
    [&](const double* point, bool) { EXPECT_NEAR(part.PlaceOf(point)[2], 2400.0, 1.01); });

  const auto beside = Lay(part, MakeLine(part, { { 0.0, 0.0, 0.0 }, { 9.0, 9.0, 0.0 } }));
  EXPECT_EQ(beside->GetNumberOfLines(), 0);
}

TEST(TerrainGlobePaths, SummitsStandOnIt)
{
  const Earth earth = MakeEarth();
  const vtkNew<vtkTerrainPeaks> peaks;
  peaks->SetInputData(earth.Heights);
  peaks->SetExaggeration(2.0);
  peaks->Update();
  ASSERT_GT(peaks->GetOutput()->GetNumberOfPoints(), 5);
  for (vtkIdType i = 0; i < peaks->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const Place place = earth.PlaceOf(peaks->GetOutput()->GetPoint(i));
    EXPECT_NEAR(std::remainder(place[0] - 0.5, 1.0), 0.0, 1e-6);
    EXPECT_NEAR(std::remainder(place[1] - 0.5, 1.0), 0.0, 1e-6);
    EXPECT_NEAR(place[2], 2.0 * earth.HeightAt(place[0], place[1]), 1e-3);
  }
}

// Pictures in degrees that begin elsewhere, about a pole, and in a zone: the colours that they have
// at the longitudes and latitudes of the heights.
TEST(TerrainGlobePaths, PicturesLieWhereTheyBelong)
{
  struct Case
  {
    const char* System;
    std::array<double, 6> Transform;
    int Size;
    int Least; ///< pixels that are coloured
  };
  const Case cases[] = {
    { "EPSG:4326", { -180.0, 3.0, 0.0, 90.0, 0.0, -3.0 }, 120, 118 * 59 },
    { "EPSG:4326", { 150.0, 1.0, 0.0, 20.0, 0.0, -1.0 }, 60, 58 * 28 },
    { "EPSG:3031", { -3e6, 1e5, 0.0, 1.5e6, 0.0, -1e5 }, 60, 500 },
    { "EPSG:32601", { 2e5, 1e4, 0.0, 7e6, 0.0, -1e4 }, 60, 300 },
  };
  for (const double west : { -180.0, 0.0 })
  {
    const Earth earth(vtkTerrainTesting::MakeDegrees(west, -90.0, 1.0, 361, 181, Hills));
    for (const Case& which : cases)
    {
      SCOPED_TRACE(std::string(which.System) + " " + std::to_string(which.Transform[0]) + " on " +
        std::to_string(west));
      const vtkNew<vtkTerrainImageWarp> warp;
      warp->SetInputData(earth.Heights);
      warp->SetGeoreference(earth.Scene);
      warp->SetFileName(
        WritePicture("globe-picture.tif", which.System, which.Size, which.Transform, ShadeAt));
      warp->Update();
      ASSERT_EQ(warp->GetErrorMessage(), "");
      vtkImageData* picture = warp->GetOutput();
      int seen = 0;
      double worst = 0.0;
      for (int j = 0; j < picture->GetDimensions()[1]; ++j)
      {
        for (int i = 0; i < picture->GetDimensions()[0]; ++i)
        {
          const double x = picture->GetOrigin()[0] + i * picture->GetSpacing()[0];
          const double y = picture->GetOrigin()[1] + j * picture->GetSpacing()[1];
          if (picture->GetScalarComponentAsDouble(i, j, 0, 3) < 255.0)
          {
            continue;
          }
          ++seen;
          worst = std::max(
            worst, std::abs(picture->GetScalarComponentAsDouble(i, j, 0, 0) - ShadeAt(x, y)));
        }
      }
      EXPECT_GE(seen, which.Least);
      EXPECT_LE(worst, 3.0);
    }
  }
}
