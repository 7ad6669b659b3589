// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainImageWarp.h"
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainReproject.h"
#include "vtkTerrainTesting.h"

#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"

#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
using Frame = vtkTerrainGeoreference::FrameType;

// The picture of most tests: 200 x 150 pixels of 30 m in UTM 45 N, upper left corner here.
constexpr int kWidth = 200;
constexpr int kHeight = 150;
constexpr double kWest = 480000.0;
constexpr double kNorth = 3095000.0;
constexpr double kPixel = 30.0;

using Fill = std::function<double(int band, int column, int row)>;

/// Writes a GeoTIFF; a value of the NoData tag where noData >= 0.
std::string Write(const std::string& name, int bands, GDALDataType type, const Fill& fill,
  const char* system = "EPSG:32645", double noData = -1.0, bool alpha = false)
{
  GDALAllRegister();
  std::string path = vtkTerrainTesting::OutputPath(name);
  char grey[] = "PHOTOMETRIC=MINISBLACK";
  char rgb[] = "PHOTOMETRIC=RGB";
  char alphaOption[] = "ALPHA=YES";
  char* options[] = { bands >= 3 ? rgb : grey, alpha ? alphaOption : nullptr, nullptr };
  GDALDatasetH file =
    GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), kWidth, kHeight, bands, type, options);
  double transform[6] = { kWest, kPixel, 0.0, kNorth, 0.0, -kPixel };
  OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
  if (system && OSRSetFromUserInput(reference, system) == OGRERR_NONE)
  {
    GDALSetSpatialRef(file, reference);
    GDALSetGeoTransform(file, transform);
  }
  OSRRelease(reference);
  for (int band = 1; band <= bands; ++band)
  {
    std::vector<double> values;
    for (int row = 0; row < kHeight; ++row)
    {
      for (int column = 0; column < kWidth; ++column)
      {
        values.push_back(fill(band, column, row));
      }
    }
    if (noData >= 0.0)
    {
      GDALSetRasterNoDataValue(GDALGetRasterBand(file, band), noData);
    }
    EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(file, band), GF_Write, 0, 0, kWidth, kHeight,
                values.data(), kWidth, kHeight, GDT_Float64, 0, 0),
      CE_None);
  }
  GDALClose(file);
  return path;
}

double Position(int band, int column, int row)
{
  return band == 1 ? column : (band == 2 ? row : 77.0);
}

/// Heights in degrees under the picture and beyond its northern and eastern border, in a scene.
void MakeScene(vtkTerrainReproject* scene, Frame frame, double height = 0.0)
{
  vtkNew<vtkImageData> heights;
  heights->SetDimensions(61, 61, 1);
  heights->SetOrigin(86.79, 27.94, 0.0);
  heights->SetSpacing(0.001, 0.001, 1.0);
  heights->AllocateScalars(VTK_FLOAT, 1);
  auto* samples = static_cast<float*>(heights->GetScalarPointer());
  std::fill_n(samples, heights->GetNumberOfPoints(), static_cast<float>(height));
  vtkNew<vtkStringArray> system;
  system->SetName("CRS");
  system->InsertNextValue("EPSG:4326");
  heights->GetFieldData()->AddArray(system);
  scene->SetInputData(heights);
  scene->GetGeoreference()->SetFrame(frame);
  scene->Update();
}

/// Where in a file's pixels a scene point at a height lies, by OGR alone.
std::array<double, 2> PixelByGDAL(
  vtkTerrainGeoreference* scene, double x, double y, double z, OGRCoordinateTransformationH to)
{
  double point[3] = { x, y, z };
  EXPECT_TRUE(scene->SceneToPlaces(point, point, 1));
  EXPECT_TRUE(OCTTransform(to, 1, &point[0], &point[1], nullptr));
  return { point[0], point[1] };
}

OGRCoordinateTransformationH PlacesTo(const char* system)
{
  OGRSpatialReferenceH to = OSRNewSpatialReference(nullptr);
  OGRSpatialReferenceH from = OSRNewSpatialReference(nullptr);
  OSRSetFromUserInput(to, system);
  OSRImportFromEPSG(from, 4326);
  OSRSetAxisMappingStrategy(from, OAMS_TRADITIONAL_GIS_ORDER);
  OSRSetAxisMappingStrategy(to, OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationH transformation = OCTNewCoordinateTransformation(from, to);
  OSRRelease(to);
  OSRRelease(from);
  return transformation;
}

const unsigned char* Pixel(vtkImageData* image, int i, int j)
{
  return static_cast<const unsigned char*>(image->GetScalarPointer(i, j, 0));
}

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// How many of a sample and the eight around it have heights.
int CountHeightsAround(vtkImageData* terrain, int i, int j)
{
  int count = 0;
  for (int k = 0; k < 9; ++k)
  {
    count +=
      std::isnan(terrain->GetScalarComponentAsDouble(i + k % 3 - 1, j + k / 3 - 1, 0, 0)) ? 0 : 1;
  }
  return count;
}

/// The first band of a picture, and where it lies.
struct RedBand
{
  int Width = 0;
  int Height = 0;
  std::array<double, 6> Transform{};
  std::vector<float> Values;

  /// Between the pixels from (column, row) on, at fractions u and v.
  double At(int column, int row, double u, double v) const
  {
    const float* p =
      &this->Values[static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Width) +
        static_cast<std::size_t>(column)];
    return (1 - v) * ((1 - u) * p[0] + u * p[1]) +
      v * ((1 - u) * p[this->Width] + u * p[this->Width + 1]);
  }
};

RedBand ReadRed(const std::string& picture)
{
  GDALAllRegister();
  GDALDatasetH file = GDALOpen(picture.c_str(), GA_ReadOnly);
  RedBand red;
  red.Width = GDALGetRasterXSize(file);
  red.Height = GDALGetRasterYSize(file);
  GDALGetGeoTransform(file, red.Transform.data());
  red.Values.resize(static_cast<std::size_t>(red.Width) * static_cast<std::size_t>(red.Height));
  EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(file, 1), GF_Read, 0, 0, red.Width, red.Height,
              red.Values.data(), red.Width, red.Height, GDT_Float32, 0, 0),
    CE_None);
  GDALClose(file);
  return red;
}
}

namespace
{
// High above the sea, where verticals that lean by 0.1 degrees matter by 15 m.
constexpr double kSceneHeight = 9000.0;

/// Warps a picture onto a scene and gives all opaque pixels, but those beside the picture's border,
/// with the column and row of the picture where GDAL alone places them; returns how many.
int ForEveryPixel(const std::string& path, Frame frame,
  const std::function<void(const unsigned char* color, double column, double row)>& body)
{
  vtkNew<vtkTerrainReproject> scene;
  scene->GetGeoreference()->SetOrigin(86.7, 27.9, 0.0);
  MakeScene(scene, frame, kSceneHeight);
  vtkNew<vtkTerrainImageWarp> warp;
  warp->SetInputConnection(scene->GetOutputPort());
  warp->SetGeoreference(scene->GetGeoreference());
  warp->SetFileName(path);
  warp->Update();
  EXPECT_EQ(warp->GetErrorMessage(), "");
  vtkImageData* image = warp->GetOutput();
  EXPECT_NEAR(image->GetSpacing()[0], kPixel, 0.05 * kPixel);
  OGRCoordinateTransformationH toPicture = PlacesTo("EPSG:32645");
  int seen = 0;
  for (int j = 0; j < image->GetDimensions()[1]; ++j)
  {
    for (int i = 0; i < image->GetDimensions()[0]; ++i)
    {
      const unsigned char* color = Pixel(image, i, j);
      if (color[3] < 255)
      {
        continue;
      }
      const double x = image->GetOrigin()[0] + i * image->GetSpacing()[0];
      const double y = image->GetOrigin()[1] + j * image->GetSpacing()[1];
      const double fall = frame == Frame::Local ? -(x * x + y * y) / (2.0 * 6.37e6) : 0.0;
      const std::array<double, 2> metres =
        PixelByGDAL(scene->GetGeoreference(), x, y, kSceneHeight + fall, toPicture);
      const double column = (metres[0] - kWest) / kPixel - 0.5;
      const double row = (kNorth - metres[1]) / kPixel - 0.5;
      if (column > 1.0 && column < kWidth - 2.0 && row > 1.0 && row < kHeight - 2.0)
      {
        body(color, column, row);
        ++seen;
      }
    }
  }
  OCTDestroyCoordinateTransformation(toPicture);
  return seen;
}
}

TEST(TerrainImageWarp, EveryPixelInItsPlace)
{
  const std::string path = Write("warp-position.tif", 3, GDT_Byte, Position);
  for (Frame frame : { Frame::Plane, Frame::Zone, Frame::Local })
  {
    SCOPED_TRACE(static_cast<int>(frame));
    const int seen = ForEveryPixel(path, frame,
      [](const unsigned char* color, double column, double row)
      {
        // Half a step of rounding, and what the warper rounds itself.
        EXPECT_NEAR(color[0], column, 0.7);
        EXPECT_NEAR(color[1], row, 0.7);
        EXPECT_EQ(color[2], 77);
      });
    EXPECT_GT(seen, 3000);
  }
}

// Ramps of four pixels, so steep that a step of colour is a 60th of a pixel.
TEST(TerrainImageWarp, InterpolatesPlacesInFlatFrames)
{
  constexpr double step = 60.0;
  constexpr int ramp = 4;
  const std::string path = Write("warp-ramps.tif", 3, GDT_Byte,
    [](int band, int column, int row)
    { return band == 3 ? 77.0 : step * ((band == 1 ? column : row) % ramp); });
  for (Frame frame : { Frame::Plane, Frame::Zone })
  {
    SCOPED_TRACE(static_cast<int>(frame));
    int compared = 0;
    const auto compare = [&compared](unsigned char color, double place)
    {
      const double margin = vtkTerrainImageWarp::InterpolationError;
      const double on = std::fmod(place, ramp);
      if (on > margin && on < ramp - 1 - margin) // between the first and the last of a ramp
      {
        EXPECT_NEAR(color / step, on, vtkTerrainImageWarp::InterpolationError + 1.0 / step);
        ++compared;
      }
    };
    ForEveryPixel(path, frame,
      [&compare](const unsigned char* color, double column, double row)
      {
        compare(color[0], column);
        compare(color[1], row);
      });
    EXPECT_GT(compared, 3000);
  }
}

TEST(TerrainImageWarp, NoDataAlphaGreyAndPalette)
{
  const auto hole = [](int column, int row) { return column >= 90 && row >= 60 && row < 110; };
  struct Case
  {
    std::string Path;
    bool HasHole;
    unsigned char Color;
  };
  const std::vector<Case> cases{
    { Write(
        "warp-nodata.tif", 3, GDT_Byte,
        [&hole](int, int column, int row) { return hole(column, row) ? 0.0 : 90.0; }, "EPSG:32645",
        0.0),
      true, 90 },
    { Write(
        "warp-alpha.tif", 4, GDT_Byte,
        [&hole](int band, int column, int row)
        { return band < 4 ? 90.0 : (hole(column, row) ? 0.0 : 255.0); },
        "EPSG:32645", -1.0, true),
      true, 90 },
    { Write("warp-grey.tif", 1, GDT_Byte, [](int, int, int) { return 90.0; }), false, 90 },
    { Write("warp-grey16.tif", 1, GDT_UInt16,
        [](int, int column, int row) { return column + row == 0 ? 0.0 : 4095.0; }),
      false, 255 },
  };
  for (const Case& picture : cases)
  {
    vtkNew<vtkTerrainReproject> scene;
    MakeScene(scene, Frame::Plane);
    vtkNew<vtkTerrainImageWarp> warp;
    warp->SetInputConnection(scene->GetOutputPort());
    warp->SetGeoreference(scene->GetGeoreference());
    warp->SetFileName(picture.Path);
    warp->Update();
    ASSERT_EQ(warp->GetErrorMessage(), "") << picture.Path;
    int clear = 0;
    int opaque = 0;
    vtkImageData* image = warp->GetOutput();
    for (int j = 3; j + 3 < image->GetDimensions()[1]; ++j)
    {
      for (int i = 3; i + 3 < image->GetDimensions()[0]; ++i)
      {
        const unsigned char* color = Pixel(image, i, j);
        clear += color[3] == 0 ? 1 : 0;
        if (color[3] == 255)
        {
          ++opaque;
          EXPECT_EQ(color[0], picture.Color) << picture.Path;
          EXPECT_EQ(color[2], picture.Color) << picture.Path;
        }
      }
    }
    EXPECT_GT(opaque, 3000) << picture.Path;
    EXPECT_EQ(clear > 500, picture.HasHole) << picture.Path << " " << clear;
  }
}

TEST(TerrainImageWarp, MaximumSize)
{
  vtkNew<vtkTerrainReproject> scene;
  MakeScene(scene, Frame::Plane);
  vtkNew<vtkTerrainImageWarp> warp;
  warp->SetInputConnection(scene->GetOutputPort());
  warp->SetGeoreference(scene->GetGeoreference());
  warp->SetFileName(Write("warp-size.tif", 3, GDT_Byte, Position));
  warp->SetMaximumSize(20);
  warp->Update();
  EXPECT_EQ(
    std::max(warp->GetOutput()->GetDimensions()[0], warp->GetOutput()->GetDimensions()[1]), 20);
}

TEST(TerrainImageWarp, RefusesWithASentence)
{
  vtkNew<vtkTerrainReproject> scene;
  MakeScene(scene, Frame::Plane);
  const auto why = [&scene](const std::string& path, bool withScene = true)
  {
    vtkNew<vtkTerrainImageWarp> warp;
    vtkNew<vtkTest::ErrorObserver> observer;
    warp->AddObserver(vtkCommand::ErrorEvent, observer);
    warp->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    warp->SetInputConnection(scene->GetOutputPort());
    warp->SetGeoreference(withScene ? scene->GetGeoreference() : nullptr);
    warp->SetFileName(path);
    warp->Update();
    EXPECT_EQ(warp->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_TRUE(observer->GetError());
    return warp->GetErrorMessage();
  };
  const std::string good = Write("warp-good.tif", 3, GDT_Byte, Position);
  EXPECT_TRUE(Contains(why("nowhere.tif"), "'nowhere.tif' is no picture"));
  EXPECT_TRUE(Contains(
    why(Write("warp-bare.tif", 3, GDT_Byte, Position, nullptr)), "has no coordinate system"));
  EXPECT_TRUE(Contains(
    why(Write("warp-far.tif", 3, GDT_Byte, Position, "EPSG:32633")), "does not meet the terrain"));
  EXPECT_TRUE(Contains(
    why(Write("warp-wrong.tif", 3, GDT_Byte, Position, "EPSG:4326")), "those are no degrees"));
  EXPECT_TRUE(Contains(why(good, false), "no georeference"));
}

TEST(TerrainImageWarp, CraterLakeOnItsHeights)
{
  const std::string heights = vtkTerrainTesting::DataPath("craterlake_elev_30m.tif");
  const std::string picture = vtkTerrainTesting::DataPath("craterlake_imagery_30m.tif");
  if (heights.empty() || picture.empty())
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set, or lacks the files";
  }
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(heights);
  vtkNew<vtkTerrainReproject> scene;
  scene->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkTerrainImageWarp> warp;
  warp->SetInputConnection(scene->GetOutputPort());
  warp->SetGeoreference(scene->GetGeoreference());
  warp->SetFileName(picture);
  warp->Update();
  ASSERT_EQ(warp->GetErrorMessage(), "");
  // The picture is clear exactly where the file has no height: the same border to a cell, but for
  // single voids that half a cell of alpha outweighs. Two pixels aside it fits far worse.
  vtkImageData* image = warp->GetOutput();
  vtkImageData* terrain = scene->GetOutput();
  int compared = 0;
  int different = 0;
  int aside = 0;
  for (int j = 1; j + 1 < terrain->GetDimensions()[1]; ++j)
  {
    for (int i = 1; i + 1 < terrain->GetDimensions()[0]; ++i)
    {
      const int around = CountHeightsAround(terrain, i, j);
      const bool all = around == 9;
      const bool none = around == 0;
      const double x = terrain->GetOrigin()[0] + i * terrain->GetSpacing()[0];
      const double y = terrain->GetOrigin()[1] + j * terrain->GetSpacing()[1];
      const auto column =
        static_cast<int>(std::lround((x - image->GetOrigin()[0]) / image->GetSpacing()[0]));
      const auto row =
        static_cast<int>(std::lround((y - image->GetOrigin()[1]) / image->GetSpacing()[1]));
      if ((all || none) && column >= 0 && row >= 0 && column < image->GetDimensions()[0] &&
        row < image->GetDimensions()[1])
      {
        ++compared;
        const auto differs = [&](int shift)
        {
          const int shifted = std::min(column + shift, image->GetDimensions()[0] - 1);
          const unsigned char alpha = Pixel(image, shifted, row)[3];
          return (all && alpha < 128) || (none && alpha >= 128);
        };
        different += differs(0) ? 1 : 0;
        aside += differs(2) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, 90000);
  EXPECT_LE(different, compared / 5000);
  EXPECT_GT(aside, 20 * different);
}

TEST(TerrainImageWarp, EverestAcrossTwoSystems)
{
  const std::string heights = vtkTerrainTesting::DataPath("everest_srtm3_voids.tif");
  const std::string picture = vtkTerrainTesting::DataPath("everest_landsat7_rgb_utm45.tif");
  if (heights.empty() || picture.empty())
  {
    GTEST_SKIP() << "VTKTERRAIN_DATA_DIR is not set, or lacks the files";
  }
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(heights);
  reader->SetWindow(900, 0, 301, 120);
  vtkNew<vtkTerrainReproject> scene;
  scene->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkTerrainImageWarp> warp;
  warp->SetInputConnection(scene->GetOutputPort());
  warp->SetGeoreference(scene->GetGeoreference());
  warp->SetFileName(picture);
  warp->Update();
  ASSERT_EQ(warp->GetErrorMessage(), "");
  const RedBand red = ReadRed(picture);
  const std::array<double, 6>& t = red.Transform;
  // The colours that the file has there, by OGR; also a pixel aside, which must fit worse.
  OGRCoordinateTransformationH toPicture = PlacesTo("EPSG:32645");
  vtkImageData* image = warp->GetOutput();
  double here = 0.0;
  double aside = 0.0;
  int count = 0;
  for (int j = 5; j + 5 < image->GetDimensions()[1]; j += 3)
  {
    for (int i = 5; i + 5 < image->GetDimensions()[0]; i += 3)
    {
      const unsigned char* color = Pixel(image, i, j);
      const std::array<double, 2> metres =
        PixelByGDAL(scene->GetGeoreference(), image->GetOrigin()[0] + i * image->GetSpacing()[0],
          image->GetOrigin()[1] + j * image->GetSpacing()[1], 0.0, toPicture);
      const double column = (metres[0] - t[0]) / t[1] - 0.5;
      const double row = (metres[1] - t[3]) / t[5] - 0.5;
      const auto c = static_cast<int>(std::floor(column));
      const auto r = static_cast<int>(std::floor(row));
      if (color[3] < 255 || c < 1 || r < 1 || c + 3 > red.Width || r + 3 > red.Height)
      {
        continue;
      }
      here += std::abs(color[0] - red.At(c, r, column - c, row - r));
      aside += std::abs(color[0] - red.At(c + 1, r, column - c, row - r));
      ++count;
    }
  }
  OCTDestroyCoordinateTransformation(toPicture);
  EXPECT_GT(count, 5000);
  EXPECT_LE(here / count, 1.0);
  EXPECT_GT(aside, 3.0 * here);
}
