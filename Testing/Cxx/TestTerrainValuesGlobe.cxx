// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainTestGlobe.h"
#include "vtkTerrainTesting.h"
#include "vtkTerrainValues.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"

#include <gdal.h>
#include <ogr_srs_api.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
using Frame = vtkTerrainGeoreference::FrameType;

const char* const kEarth = "EPSG:4326";
const char* const kMoon = "+proj=longlat +R=1737400 +no_defs +type=crs";

struct Raster
{
  std::string System;
  std::array<double, 6> Transform{};
  int Columns = 0;
  int Rows = 0;
  /// Of a longitude and a latitude, degrees.
  std::function<double(double, double)> Fill;
  GDALDataType Type = GDT_Float32;
};

OGRSpatialReferenceH MakeReference(const std::string& system)
{
  OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
  OSRSetFromUserInput(reference, system.c_str());
  OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

/// Values by the places of the pixels' middles, which OGR finds.
std::string Write(const std::string& name, const Raster& raster)
{
  GDALAllRegister();
  std::string path = vtkTerrainTesting::OutputPath(name);
  GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), raster.Columns,
    raster.Rows, 1, raster.Type, nullptr);
  std::array<double, 6> transform = raster.Transform;
  GDALSetGeoTransform(file, transform.data());
  OGRSpatialReferenceH own = MakeReference(raster.System);
  GDALSetSpatialRef(file, own);
  OGRSpatialReferenceH degrees = OSRCloneGeogCS(own);
  OSRSetAxisMappingStrategy(degrees, OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationH toDegrees = OCTNewCoordinateTransformation(own, degrees);
  std::vector<double> values;
  for (int row = 0; row < raster.Rows; ++row)
  {
    for (int column = 0; column < raster.Columns; ++column)
    {
      double x = 0.0;
      double y = 0.0;
      GDALApplyGeoTransform(transform.data(), column + 0.5, row + 0.5, &x, &y);
      EXPECT_TRUE(OCTTransform(toDegrees, 1, &x, &y, nullptr));
      values.push_back(raster.Fill(x, y));
    }
  }
  EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(file, 1), GF_Write, 0, 0, raster.Columns, raster.Rows,
              values.data(), raster.Columns, raster.Rows, GDT_Float64, 0, 0),
    CE_None);
  OCTDestroyCoordinateTransformation(toDegrees);
  OSRRelease(degrees);
  OSRRelease(own);
  GDALClose(file);
  return path;
}

/// A smooth function of places, without a seam at any longitude or pole: -123 to 123.
double Smooth(double longitude, double latitude)
{
  const double turn = longitude * vtkMath::Pi() / 180.0;
  const double rise = latitude * vtkMath::Pi() / 180.0;
  return std::cos(rise) * (100.0 * std::cos(turn) + 60.0 * std::sin(turn)) + 40.0 * std::sin(rise);
}

// Classes 11 and 90 in squares of 10 degrees.
double Squares(double longitude, double latitude)
{
  const auto square = [](double degrees) { return static_cast<int>(std::floor(degrees / 10.0)); };
  return (square(longitude) + square(latitude)) % 2 ? 90.0 : 11.0;
}

vtkSmartPointer<vtkImageData> MakeGlobe(
  double west, double south, double step, int columns, int rows, const std::string& system = kEarth)
{
  const auto heights = vtkTerrainTesting::MakeDegrees(
    west, south, step, columns, rows, [](int i, int j) { return 500 + 3 * (i % 7) + 2 * (j % 5); });
  const vtkNew<vtkStringArray> name;
  name->SetName("CRS");
  name->InsertNextValue(system);
  heights->GetFieldData()->AddArray(name);
  return vtkTerrainTesting::LayOnGlobe(heights);
}

/// Values on a globe, with its longitudes and latitudes.
class OnGlobe
{
public:
  OnGlobe(vtkImageData* globe, const std::string& path)
  {
    this->Scene->SetFromHeights(globe);
    this->Scene->SetFrame(Frame::Globe);
    this->Values->SetInputData(globe);
    this->Values->SetGeoreference(this->Scene);
    this->Values->SetFileName(path);
    this->Values->Update();
    EXPECT_EQ(this->Values->GetErrorMessage(), "");
    this->Image = this->Values->GetOutput();
    this->Longitudes = globe->GetFieldData()->GetArray("GlobeLongitudes");
    this->Latitudes = globe->GetFieldData()->GetArray("GlobeLatitudes");
  }
  double Longitude(double column) const
  {
    return this->Longitudes->GetComponent(0, 0) + column * this->Longitudes->GetComponent(0, 1);
  }
  double Latitude(int row) const
  {
    return this->Latitudes->GetComponent(row, 0);
  }
  int Columns() const
  {
    return this->Image->GetDimensions()[0];
  }
  int Rows() const
  {
    return this->Image->GetDimensions()[1];
  }
  double At(int column, int row) const
  {
    vtkDataArray* array = this->Image->GetPointData()->GetArray("Values");
    return array->GetComponent(column + vtkIdType{ this->Columns() } * row, 0);
  }

  vtkNew<vtkTerrainGeoreference> Scene;
  vtkNew<vtkTerrainValues> Values;
  vtkImageData* Image = nullptr;

private:
  vtkDataArray* Longitudes = nullptr;
  vtkDataArray* Latitudes = nullptr;
};

/// The largest difference to the function, of samples north of a latitude; all must have a value.
/// At a pole a raster has one value for each longitude, and the difference is that of a pixel.
double LargestError(const OnGlobe& values, double south)
{
  double largest = 0.0;
  for (int row = 0; row < values.Rows(); ++row)
  {
    for (int column = 0; column < values.Columns() && values.Latitude(row) >= south; ++column)
    {
      const bool isPole = std::abs(values.Latitude(row)) > 89.99;
      const double expected = Smooth(values.Longitude(column), values.Latitude(row));
      const double error = (isPole ? 0.5 : 1.0) * std::abs(values.At(column, row) - expected);
      largest = std::isnan(error) ? HUGE_VAL : std::max(largest, error);
    }
  }
  return largest;
}
}

// The raster begins at 180 degrees west, at longitude 0, or within its pixels: the values of the
// world are those of their places, over its seam and at the poles.
TEST(TerrainValuesGlobe, AWholeWorldHasTheValuesOfItsPlaces)
{
  // half a pixel beyond the last middle: 0.25 degrees of 117 a radian
  constexpr double kRim = 0.55;
  const auto world = MakeGlobe(-179.0, -89.0, 2.0, 180, 90);
  for (const double west : { -180.0, 0.0, -180.25 })
  {
    SCOPED_TRACE(west);
    const std::string path =
      Write("globe-world.tif", { kEarth, { west, 0.5, 0.0, 90.0, 0.0, -0.5 }, 720, 360, Smooth });
    const OnGlobe values(world, path);
    EXPECT_LT(LargestError(values, -90.0), kRim);
    // Mount Everest's, by hand
    double nearest = HUGE_VAL;
    double value = 0.0;
    for (int k = 0; k < values.Rows() * values.Columns(); ++k)
    {
      const int column = k % values.Columns();
      const int row = k / values.Columns();
      const double distance =
        std::hypot(values.Longitude(column) - 86.925, values.Latitude(row) - 27.988);
      value = distance < nearest ? values.At(column, row) : value;
      nearest = std::min(nearest, distance);
    }
    EXPECT_LT(nearest, 1.0);
    EXPECT_NEAR(value, 76.4, 2.0);
  }
}

// A picture round the pole meets heights at all longitudes; beyond it there is no value.
TEST(TerrainValuesGlobe, ARasterRoundAPoleIsAllAround)
{
  const auto cap = MakeGlobe(-179.5, 40.5, 1.0, 360, 50);
  const std::string path = Write("globe-pole.tif",
    { "EPSG:3995", { -2.5e6, 2.5e4, 0.0, 2.5e6, 0.0, -2.5e4 }, 200, 200, Smooth });
  const OnGlobe values(cap, path);
  EXPECT_LT(LargestError(values, 69.0), 0.1);
  EXPECT_TRUE(std::isnan(values.At(0, 0)));
}

// A small raster in metres in the middle of a continent, and the whole world.
TEST(TerrainValuesGlobe, ASmallRasterIsFoundOnTheWorld)
{
  const std::string path = Write("globe-zone.tif",
    { "EPSG:32645", { 480000.0, 300.0, 0.0, 3095000.0, 0.0, -300.0 }, 200, 150, Smooth });
  const OnGlobe near(MakeGlobe(86.82, 27.65, 0.005, 101, 61), path);
  EXPECT_LT(LargestError(near, -90.0), 0.01);
  const OnGlobe far(MakeGlobe(-179.9, -89.9, 0.2, 1800, 900), path);
  int inside = 0;
  for (int row = 0; row < far.Rows(); ++row)
  {
    for (int column = 0; column < far.Columns(); ++column)
    {
      const double x = far.Longitude(column);
      const double y = far.Latitude(row);
      const bool isNear = x > 86.7 && x < 87.5 && y > 27.5 && y < 28.1;
      const double value = far.At(column, row);
      ASSERT_TRUE(isNear || std::isnan(value)) << x << ' ' << y;
      inside += std::isfinite(value) ? 1 : 0;
      ASSERT_TRUE(std::isnan(value) || std::abs(value - Smooth(x, y)) < 0.01);
    }
  }
  EXPECT_GE(inside, 4);
}

TEST(TerrainValuesGlobe, CellsHaveTheClassesOfTheirPlaces)
{
  const std::string path = Write("globe-classes.tif",
    { kEarth, { -180.0, 1.0, 0.0, 90.0, 0.0, -1.0 }, 360, 180, Squares, GDT_Byte });
  const auto world = MakeGlobe(-180.0, -90.0, 0.5, 721, 361);
  vtkNew<vtkTerrainGeoreference> scene;
  scene->SetFromHeights(world);
  scene->SetFrame(Frame::Globe);
  vtkNew<vtkTerrainValues> values;
  values->SetInputData(world);
  values->SetGeoreference(scene);
  values->SetFileName(path);
  values->SetKind(vtkTerrainValues::KindType::Classes);
  values->Update();
  ASSERT_EQ(values->GetErrorMessage(), "");
  vtkDataArray* array = values->GetOutput()->GetCellData()->GetArray("Values");
  ASSERT_TRUE(array);
  ASSERT_EQ(array->GetNumberOfTuples(), 720 * 360);
  for (int k = 0; k < 720 * 360; ++k)
  {
    const double longitude = -179.75 + 0.5 * (k % 720);
    const double latitude = -89.75 + 0.5 * static_cast<int>(k / 720);
    ASSERT_EQ(array->GetComponent(k, 0), Squares(longitude, latitude))
      << longitude << ' ' << latitude;
  }
}

// Its longitudes and latitudes are its own; a raster of the earth has no place there.
TEST(TerrainValuesGlobe, AnotherWorldHasItsOwnPlaces)
{
  const auto moon = MakeGlobe(-179.5, -89.5, 1.0, 360, 180, kMoon);
  const std::string path =
    Write("globe-moon.tif", { kMoon, { -180.0, 0.5, 0.0, 90.0, 0.0, -0.5 }, 720, 360, Smooth });
  const OnGlobe values(moon, path);
  EXPECT_LT(LargestError(values, -90.0), 0.55);
}

TEST(TerrainValuesGlobe, AnotherFrameIsRefused)
{
  const auto world = MakeGlobe(-179.5, -89.5, 1.0, 360, 180);
  const std::string path =
    Write("globe-frame.tif", { kEarth, { -180.0, 5.0, 0.0, 90.0, 0.0, -5.0 }, 72, 36, Smooth });
  vtkNew<vtkTerrainGeoreference> scene;
  scene->SetFromHeights(world);
  scene->SetFrame(Frame::Plane);
  vtkNew<vtkTerrainValues> values;
  vtkNew<vtkTest::ErrorObserver> observer;
  values->AddObserver(vtkCommand::ErrorEvent, observer);
  values->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  values->SetInputData(world);
  values->SetGeoreference(scene);
  values->SetFileName(path);
  values->Update();
  EXPECT_TRUE(observer->GetError());
  EXPECT_NE(values->GetErrorMessage().find("on a globe"), std::string::npos);
}
