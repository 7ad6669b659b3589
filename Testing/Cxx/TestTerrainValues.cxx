// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainColors.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainReproject.h"
#include "vtkTerrainTesting.h"
#include "vtkTerrainValues.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"

#include <cpl_conv.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{
using Frame = vtkTerrainGeoreference::FrameType;
using Kind = vtkTerrainValues::KindType;

// The raster: 200 x 150 pixels of 30 m in UTM 45 N, upper left corner here.
constexpr int kWidth = 200;
constexpr int kHeight = 150;
constexpr double kWest = 480000.0;
constexpr double kNorth = 3095000.0;
constexpr double kPixel = 30.0;

struct Raster
{
  std::function<double(int column, int row)> Fill;
  GDALDataType Type = GDT_Float32;
  std::string System = "EPSG:32645";
  /// Changes the file before it is closed.
  std::function<void(GDALDatasetH)> More;
};

std::string Write(const std::string& name, const Raster& raster)
{
  GDALAllRegister();
  std::string path = vtkTerrainTesting::OutputPath(name);
  GDALDatasetH file = GDALCreate(
    GDALGetDriverByName("GTiff"), path.c_str(), kWidth, kHeight, 2, raster.Type, nullptr);
  double transform[6] = { kWest, kPixel, 0.0, kNorth, 0.0, -kPixel };
  GDALSetGeoTransform(file, transform);
  OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
  if (!raster.System.empty() &&
    OSRSetFromUserInput(reference, raster.System.c_str()) == OGRERR_NONE)
  {
    GDALSetSpatialRef(file, reference);
  }
  OSRRelease(reference);
  if (raster.More)
  {
    raster.More(file); // a colour table comes before the pixels
  }
  std::vector<double> values;
  for (int row = 0; row < kHeight; ++row)
  {
    for (int column = 0; column < kWidth; ++column)
    {
      values.push_back(raster.Fill(column, row));
    }
  }
  for (int band = 1; band <= 2; ++band)
  {
    EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(file, band), GF_Write, 0, 0, kWidth, kHeight,
                values.data(), kWidth, kHeight, GDT_Float64, 0, 0),
      CE_None);
    for (double& value : values)
    {
      value += 1000.0;
    }
  }
  GDALClose(file);
  return path;
}

/// Heights in degrees under the raster and beyond its northern and eastern border, in a scene.
void MakeScene(vtkTerrainReproject* scene, Frame frame)
{
  vtkNew<vtkImageData> heights;
  heights->SetDimensions(61, 61, 1);
  heights->SetOrigin(86.79, 27.94, 0.0);
  heights->SetSpacing(0.001, 0.001, 1.0);
  heights->AllocateScalars(VTK_FLOAT, 1);
  heights->GetPointData()->GetScalars()->Fill(0.0);
  vtkNew<vtkStringArray> system;
  system->SetName("CRS");
  system->InsertNextValue("EPSG:4326");
  heights->GetFieldData()->AddArray(system);
  scene->SetInputData(heights);
  scene->GetGeoreference()->SetFrame(frame);
  scene->Update();
}

/// Gives values the heights and places of a scene, and a raster.
void LayOver(vtkTerrainValues* values, vtkTerrainReproject* scene, const std::string& path)
{
  values->SetInputConnection(scene->GetOutputPort());
  values->SetGeoreference(scene->GetGeoreference());
  values->SetFileName(path);
}

/// Column and row of the raster at a point of a scene of degrees, centres at whole numbers, by OGR.
class PixelsByGDAL
{
public:
  explicit PixelsByGDAL(vtkTerrainGeoreference* scene)
    : Scene(scene)
  {
    OGRSpatialReferenceH to = OSRNewSpatialReference(nullptr);
    OGRSpatialReferenceH from = OSRNewSpatialReference(nullptr);
    OSRImportFromEPSG(to, 32645);
    OSRImportFromEPSG(from, 4326);
    OSRSetAxisMappingStrategy(from, OAMS_TRADITIONAL_GIS_ORDER);
    this->ToRaster = OCTNewCoordinateTransformation(from, to);
    OSRRelease(to);
    OSRRelease(from);
  }
  ~PixelsByGDAL()
  {
    OCTDestroyCoordinateTransformation(this->ToRaster);
  }
  PixelsByGDAL(const PixelsByGDAL&) = delete;
  void operator=(const PixelsByGDAL&) = delete;

  std::array<double, 2> At(double x, double y) const
  {
    double point[3] = { x, y, 0.0 };
    EXPECT_TRUE(this->Scene->SceneToPlaces(point, point, 1));
    EXPECT_TRUE(OCTTransform(this->ToRaster, 1, &point[0], &point[1], nullptr));
    return { (point[0] - kWest) / kPixel - 0.5, (kNorth - point[1]) / kPixel - 0.5 };
  }

private:
  vtkTerrainGeoreference* Scene;
  OGRCoordinateTransformationH ToRaster;
};

/// True for pixels that lie inside the raster, by a margin.
bool IsInside(const std::array<double, 2>& pixel, double margin)
{
  return pixel[0] > margin && pixel[0] < kWidth - 1.0 - margin && pixel[1] > margin &&
    pixel[1] < kHeight - 1.0 - margin;
}

/// True for those that lie beside it, by a margin.
bool IsBeside(const std::array<double, 2>& pixel, double margin)
{
  return pixel[0] < -margin || pixel[0] > kWidth - 1.0 + margin || pixel[1] < -margin ||
    pixel[1] > kHeight - 1.0 + margin;
}

// Classes 11 and 90 in squares of 20 x 20 pixels.
double FillClasses(int column, int row)
{
  return (column / 20 + row / 20) % 2 ? 90.0 : 11.0;
}

// The path of a raster of these, with a table of colours and a name for one of them.
std::string WriteClasses(const std::string& file)
{
  const auto paint = [](GDALDatasetH raster)
  {
    GDALColorTableH table = GDALCreateColorTable(GPI_RGB);
    const GDALColorEntry red = { 200, 10, 20, 255 };
    GDALSetColorEntry(table, 11, &red);
    const GDALColorEntry blue = { 10, 20, 200, 255 };
    GDALSetColorEntry(table, 90, &blue);
    GDALSetRasterColorTable(GDALGetRasterBand(raster, 1), table);
    GDALDestroyColorTable(table);
    std::vector<std::string> names(91);
    names[11] = "Forest";
    std::vector<char*> list;
    for (std::string& one : names)
    {
      list.push_back(&one[0]);
    }
    list.push_back(nullptr);
    GDALSetRasterCategoryNames(GDALGetRasterBand(raster, 1), list.data());
  };
  return Write(file, { FillClasses, GDT_Byte, "EPSG:32645", paint });
}
}

// A plane is interpolated without an error, wherever samples lie among pixels.
TEST(TerrainValues, EverySampleHasTheValueOfItsPlace)
{
  const std::string path = Write("values-plane.tif",
    { [](int column, int row) { return 3.0 * column - 2.0 * row; }, GDT_Float32, "EPSG:32645",
      [](GDALDatasetH file)
      {
        GDALSetRasterScale(GDALGetRasterBand(file, 2), 0.5);
        GDALSetRasterOffset(GDALGetRasterBand(file, 2), 7.0);
        GDALSetRasterUnitType(GDALGetRasterBand(file, 2), "mm");
        GDALSetDescription(GDALGetRasterBand(file, 2), "Rain");
      } });
  for (const Frame frame : { Frame::Plane, Frame::Zone, Frame::Local })
  {
    vtkNew<vtkTerrainReproject> scene;
    MakeScene(scene, frame);
    const PixelsByGDAL pixels(scene->GetGeoreference());
    for (const int band : { 1, 2 })
    {
      vtkNew<vtkTerrainValues> values;
      LayOver(values, scene, path);
      values->SetBand(band);
      values->Update();
      ASSERT_EQ(values->GetErrorMessage(), "");
      EXPECT_FALSE(values->AreClasses());
      EXPECT_EQ(values->GetTitle(), band == 2 ? "Rain" : "values-plane");
      EXPECT_EQ(values->GetUnit(), band == 2 ? "mm" : "");
      vtkImageData* image = values->GetOutput();
      EXPECT_EQ(
        image->GetPointData()->GetScalars(), scene->GetOutput()->GetPointData()->GetScalars());
      vtkDataArray* array = image->GetPointData()->GetArray("Values");
      ASSERT_TRUE(array);
      int inside = 0;
      int beside = 0;
      for (vtkIdType k = 0; k < image->GetNumberOfPoints(); ++k)
      {
        const double* point = image->GetPoint(k);
        const std::array<double, 2> pixel = pixels.At(point[0], point[1]);
        const double expected = 3.0 * pixel[0] - 2.0 * pixel[1];
        const double value = array->GetComponent(k, 0);
        if (IsInside(pixel, 1.5))
        {
          // what an approximated transformation is off by, and the fall of a round scene
          EXPECT_NEAR(value, band == 2 ? 0.5 * (expected + 1000.0) + 7.0 : expected, 0.5);
          ++inside;
        }
        else if (IsBeside(pixel, 1.5))
        {
          EXPECT_TRUE(std::isnan(value));
          ++beside;
        }
      }
      EXPECT_GT(inside, 500);
      EXPECT_GT(beside, 500);
    }
  }
}

TEST(TerrainValues, ClassesAreNotMixed)
{
  vtkNew<vtkTerrainReproject> scene;
  MakeScene(scene, Frame::Plane);
  const PixelsByGDAL pixels(scene->GetGeoreference());
  vtkNew<vtkTerrainValues> values;
  LayOver(values, scene, WriteClasses("values-classes.tif"));
  values->Update();
  ASSERT_EQ(values->GetErrorMessage(), "");
  EXPECT_TRUE(values->AreClasses());
  vtkImageData* image = values->GetOutput();
  EXPECT_FALSE(image->GetPointData()->HasArray("Values"));
  const vtkSmartPointer<vtkDataArray> array = image->GetCellData()->GetArray("Values");
  ASSERT_TRUE(array);
  ASSERT_EQ(array->GetNumberOfTuples(), image->GetNumberOfCells());
  int inside = 0;
  int wrong = 0;
  for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
  {
    const double value = array->GetComponent(k, 0);
    EXPECT_TRUE(std::isnan(value) || value == 11.0 || value == 90.0) << value;
    double bounds[6];
    image->GetCellBounds(k, bounds);
    const std::array<double, 2> pixel =
      pixels.At(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]));
    if (IsInside(pixel, 1.0))
    {
      ++inside;
      const double expected = FillClasses(
        static_cast<int>(std::lround(pixel[0])), static_cast<int>(std::lround(pixel[1])));
      wrong += value == expected ? 0 : 1;
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_LE(wrong, inside / 50); // where the most frequent one of a cell is not that of its middle
  // as numbers, where that is asked for
  values->SetKind(Kind::Values);
  values->Update();
  EXPECT_FALSE(values->AreClasses());
  EXPECT_TRUE(values->GetOutput()->GetPointData()->HasArray("Values"));
}

TEST(TerrainValues, ClassesHaveTheColorsOfTheirTable)
{
  const std::string path = WriteClasses("values-table.tif");
  vtkNew<vtkTerrainColors> colors;
  ASSERT_TRUE(colors->ReadRaster(path)) << colors->GetErrorMessage();
  ASSERT_EQ(colors->GetNumberOfCategories(), 256); // a TIFF has no fewer
  EXPECT_TRUE(colors->IsDiscrete());
  EXPECT_EQ(colors->GetCategoryName(11), "Forest");
  EXPECT_EQ(colors->GetCategoryName(90), "90");
  EXPECT_EQ(colors->GetCategoryValue(90), 90.0);
  double rgb[3];
  colors->GetCategoryColor(11, rgb);
  EXPECT_NEAR(rgb[0], 200.0 / 255.0, 1e-9);
  vtkNew<vtkFloatArray> array;
  for (const float value : { 90.0F, std::numeric_limits<float>::quiet_NaN(), 11.0F, 90.0F })
  {
    array->InsertNextValue(value);
  }
  const vtkSmartPointer<vtkFloatArray> numbers = colors->FindCategories(array);
  for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
  {
    const double value = array->GetComponent(k, 0);
    EXPECT_TRUE(
      std::isnan(value) ? std::isnan(numbers->GetValue(k)) : numbers->GetValue(k) == value);
  }
  EXPECT_FALSE(colors->ReadRaster(path, 3));
  EXPECT_NE(colors->GetErrorMessage().find("no band 3"), std::string::npos);
  EXPECT_FALSE(colors->ReadRaster(vtkTerrainTesting::OutputPath("nowhere.tif")));
}

// A raster whose western half is 20, and whose eastern half is hidden in some way, and 250.
namespace
{
bool IsShown(double column)
{
  return column < 0.5 * kWidth;
}

std::string WriteHalf(
  const std::string& name, GDALDataType type, const std::function<void(GDALDatasetH)>& hide)
{
  return Write(name,
    { [](int column, int) { return IsShown(column) ? 20.0 : 250.0; }, type, "EPSG:32645", hide });
}

// Makes a band of a mask or of opacities 0 in the eastern half.
void FillWesternHalf(GDALRasterBandH band, double shown)
{
  GDALFillRaster(band, 0.0, 0.0);
  std::vector<double> line(kWidth / 2, shown);
  for (int row = 0; row < kHeight; ++row)
  {
    EXPECT_EQ(GDALRasterIO(band, GF_Write, 0, row, kWidth / 2, 1, line.data(), kWidth / 2, 1,
                GDT_Float64, 0, 0),
      CE_None);
  }
}

std::string WriteMasked()
{
  return WriteHalf("values-mask.tif", GDT_Byte,
    [](GDALDatasetH file)
    {
      CPLSetConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
      GDALCreateDatasetMaskBand(file, GMF_PER_DATASET);
      CPLSetConfigOption("GDAL_TIFF_INTERNAL_MASK", nullptr);
      FillWesternHalf(GDALGetMaskBand(GDALGetRasterBand(file, 1)), 255.0);
    });
}

std::string WriteAlpha(GDALDataType type)
{
  std::string path = WriteHalf("values-alpha.tif", type,
    [](GDALDatasetH file)
    { GDALSetRasterColorInterpretation(GDALGetRasterBand(file, 2), GCI_AlphaBand); });
  GDALDatasetH file = GDALOpen(path.c_str(), GA_Update);
  FillWesternHalf(GDALGetRasterBand(file, 2), type == GDT_UInt16 ? 65535.0 : 255.0);
  GDALClose(file);
  return path;
}

// A TIFF has no colour that is transparent, a VRT of it has.
std::string WriteTransparentEntry()
{
  std::string path = vtkTerrainTesting::OutputPath("values-entry.vrt");
  GDALDatasetH file = GDALOpen(WriteHalf("values-entry.tif", GDT_Byte, {}).c_str(), GA_ReadOnly);
  GDALDatasetH copy = GDALCreateCopy(
    GDALGetDriverByName("VRT"), path.c_str(), file, FALSE, nullptr, nullptr, nullptr);
  GDALColorTableH colors = GDALCreateColorTable(GPI_RGB);
  const GDALColorEntry red = { 200, 10, 20, 255 };
  const GDALColorEntry none = { 0, 0, 0, 0 };
  GDALSetColorEntry(colors, 20, &red);
  GDALSetColorEntry(colors, 250, &none);
  GDALSetRasterColorTable(GDALGetRasterBand(copy, 1), colors);
  GDALDestroyColorTable(colors);
  GDALClose(copy);
  GDALClose(file);
  return path;
}

void ExpectHalfShown(const std::string& path, Kind kind)
{
  vtkNew<vtkTerrainReproject> scene;
  MakeScene(scene, Frame::Plane);
  const PixelsByGDAL pixels(scene->GetGeoreference());
  vtkNew<vtkTerrainValues> values;
  LayOver(values, scene, path);
  values->SetKind(kind);
  values->Update();
  ASSERT_EQ(values->GetErrorMessage(), "");
  vtkImageData* image = values->GetOutput();
  const bool ofPoints = kind == Kind::Values;
  vtkDataArray* array =
    ofPoints ? image->GetPointData()->GetArray("Values") : image->GetCellData()->GetArray("Values");
  int shown = 0;
  int hidden = 0;
  for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
  {
    double bounds[6];
    image->GetCellBounds(k % image->GetNumberOfCells(), bounds);
    const double* point = image->GetPoint(k);
    const std::array<double, 2> pixel = ofPoints
      ? pixels.At(point[0], point[1])
      : pixels.At(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]));
    const double value = array->GetComponent(k, 0);
    EXPECT_TRUE(std::isnan(value) || std::abs(value - 20.0) < 0.01) << path << " " << value;
    if (IsInside(pixel, 4.0) && std::abs(pixel[0] - 0.5 * kWidth) > 5.0)
    {
      EXPECT_EQ(std::isnan(value), !IsShown(pixel[0])) << path << " at " << pixel[0];
      ++(IsShown(pixel[0]) ? shown : hidden);
    }
  }
  EXPECT_GT(shown, 500) << path;
  EXPECT_GT(hidden, 300) << path;
}
}

// The number behind what is hidden is no value, alone or mixed with others.
TEST(TerrainValues, TransparentPixelsHaveNoValues)
{
  for (const Kind kind : { Kind::Values, Kind::Classes })
  {
    ExpectHalfShown(WriteMasked(), kind);
    for (const GDALDataType type : { GDT_Byte, GDT_UInt16, GDT_Float32 })
    {
      ExpectHalfShown(WriteAlpha(type), kind);
    }
    ExpectHalfShown(
      WriteHalf("values-none.tif", GDT_Byte,
        [](GDALDatasetH file) { GDALSetRasterNoDataValue(GDALGetRasterBand(file, 1), 250.0); }),
      kind);
  }
  ExpectHalfShown(WriteTransparentEntry(), Kind::Classes);
}

// Neither names a place on earth: both lie in the same coordinates.
TEST(TerrainValues, WithoutPlacesOnEarth)
{
  const std::string path = Write(
    "values-local.tif", { [](int column, int) { return double(column); }, GDT_Int16, "", {} });
  vtkNew<vtkImageData> heights;
  heights->SetDimensions(11, 9, 1);
  heights->SetOrigin(kWest + 0.5 * kPixel, kNorth - 100.5 * kPixel, 0.0);
  heights->SetSpacing(2.0 * kPixel, kPixel, 1.0);
  heights->AllocateScalars(VTK_SHORT, 1);
  heights->GetPointData()->GetScalars()->Fill(3.0);
  vtkNew<vtkTerrainGeoreference> scene;
  scene->SetFromHeights(heights);
  scene->SetFrame(Frame::Grid);
  vtkNew<vtkTerrainValues> values;
  values->SetInputData(heights);
  values->SetGeoreference(scene);
  values->SetFileName(path);
  values->SetKind(Kind::Values);
  values->Update();
  ASSERT_EQ(values->GetErrorMessage(), "");
  vtkDataArray* array = values->GetOutput()->GetPointData()->GetArray("Values");
  for (int i = 1; i < 11; ++i)
  {
    EXPECT_NEAR(array->GetComponent(i + 11 * 4, 0), 2.0 * i, 1e-3);
  }
}

TEST(TerrainValues, RefusesWithASentence)
{
  vtkNew<vtkTerrainReproject> scene;
  MakeScene(scene, Frame::Plane);
  const auto why = [&scene](const std::string& path, int band = 1, bool hasScene = true)
  {
    vtkNew<vtkTerrainValues> values;
    vtkNew<vtkTest::ErrorObserver> observer;
    values->AddObserver(vtkCommand::ErrorEvent, observer);
    values->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    values->SetInputConnection(scene->GetOutputPort());
    values->SetGeoreference(hasScene ? scene->GetGeoreference() : nullptr);
    values->SetFileName(path);
    values->SetBand(band);
    values->Update();
    EXPECT_TRUE(observer->GetError());
    EXPECT_EQ(values->GetOutput()->GetNumberOfPoints(), 0);
    return values->GetErrorMessage();
  };
  const auto zero = [](int, int) { return 0.0; };
  const auto contains = [](const std::string& text, const std::string& part)
  { return text.find(part) != std::string::npos; };
  const std::string good = Write("values-good.tif", { zero, GDT_Float32, "EPSG:32645", {} });
  EXPECT_TRUE(contains(why(good, 3), "no band 3"));
  EXPECT_TRUE(contains(why(good, 0), "no band 0"));
  EXPECT_TRUE(contains(why(good, 1, false), "no georeference"));
  EXPECT_TRUE(contains(why(vtkTerrainTesting::OutputPath("values-nowhere.tif")), "nowhere"));
  EXPECT_TRUE(
    contains(why(Write("values-bare.tif", { zero, GDT_Float32, "", {} })), "no coordinate system"));
  EXPECT_TRUE(contains(why(Write("values-far.tif", { zero, GDT_Float32, "EPSG:32633", {} })),
    "no values on the terrain"));
}
