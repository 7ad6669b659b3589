// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkTerrainRasterReader on files of vtkTerrainHierarchy.
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainTestRaster.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <numeric>
#include <string>

namespace
{
vtkSmartPointer<vtkTerrainRasterReader> Read(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkTerrainRasterReader>::New();
  reader->SetFileName(path);
  reader->Update();
  EXPECT_STREQ(reader->GetErrorMessage(), "");
  return reader;
}

double Number(vtkImageData* image, const char* array, int component)
{
  vtkDataArray* numbers = image->GetFieldData()->GetArray(array);
  const bool isThere = numbers && numbers->GetNumberOfValues() == 2;
  return isThere ? numbers->GetVariantValue(component).ToDouble()
                 : std::numeric_limits<double>::quiet_NaN();
}
}

// A file of vtkTerrainHierarchy: its heights, whatever its name, with where they lie on earth.
TEST(TerrainRasterReaderPrepared, ReadsPreparedFiles)
{
  vtkTerrainTesting::RasterFile file;
  file.Width = 40;
  file.Height = 30;
  file.Type = GDT_Float32;
  file.Values.resize(1200);
  std::iota(file.Values.begin(), file.Values.end(), 100.0);
  file.Values[417] = std::numeric_limits<double>::quiet_NaN();
  file.EPSG = 4326;
  file.GeoTransform = { 86.0, 0.01, 0.0, 28.0, 0.0, -0.01 };
  const auto raster = Read(file.Write("unprepared.tif"));
  const std::string path = vtkTerrainTesting::TemporaryFile("prepared.tif");
  vtkNew<vtkTerrainHierarchy> hierarchy;
  ASSERT_TRUE(hierarchy->SetHeights(raster->GetOutput())) << hierarchy->GetErrorMessage();
  ASSERT_TRUE(hierarchy->WriteFile(path)) << hierarchy->GetErrorMessage();
  EXPECT_GT(raster->CanReadFile(path.c_str()), 0);
  const auto reader = Read(path);
  vtkImageData* image = reader->GetOutput();
  vtkImageData* expected = raster->GetOutput();
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "Elevation");
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(image->GetDimensions()[axis], expected->GetDimensions()[axis]);
    EXPECT_EQ(image->GetOrigin()[axis], expected->GetOrigin()[axis]);
    EXPECT_EQ(image->GetSpacing()[axis], expected->GetSpacing()[axis]);
  }
  for (vtkIdType id = 0; id < expected->GetNumberOfPoints(); ++id)
  {
    const double given = image->GetPointData()->GetScalars()->GetComponent(id, 0);
    const double height = expected->GetPointData()->GetScalars()->GetComponent(id, 0);
    EXPECT_TRUE(given == height || (std::isnan(given) && std::isnan(height))) << id;
  }
  for (const char* array : { "LayoutOrigin", "LayoutScale" })
  {
    EXPECT_EQ(Number(image, array, 0), Number(expected, array, 0)) << array;
    EXPECT_EQ(Number(image, array, 1), Number(expected, array, 1)) << array;
  }
  EXPECT_EQ(hierarchy->GetCoordinateSystem(),
    vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("CRS"))->GetValue(0));
  const int part[6] = { 5, 20, 10, 29, 0, 0 };
  reader->UpdateExtent(part);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(7, 12, 0, 0),
    expected->GetScalarComponentAsDouble(7, 12, 0, 0));
}

TEST(TerrainRasterReaderPrepared, RefusesWhatPreparedFilesHaveNot)
{
  vtkNew<vtkImageData> heights;
  heights->SetDimensions(20, 20, 1);
  heights->AllocateScalars(VTK_FLOAT, 1);
  heights->GetPointData()->GetScalars()->Fill(3.0);
  const std::string path = vtkTerrainTesting::TemporaryFile("refusing.hierarchy");
  vtkNew<vtkTerrainHierarchy> hierarchy;
  ASSERT_TRUE(hierarchy->SetHeights(heights) && hierarchy->WriteFile(path));
  const auto expectRefused =
    [&](const std::function<void(vtkTerrainRasterReader*)>& change, const std::string& mention)
  {
    vtkNew<vtkTerrainRasterReader> reader;
    vtkNew<vtkTest::ErrorObserver> errors;
    reader->AddObserver(vtkCommand::ErrorEvent, errors);
    reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    reader->SetFileName(path);
    change(reader);
    reader->Update();
    const std::string message = reader->GetErrorMessage();
    EXPECT_NE(message.find(mention), std::string::npos) << message;
    EXPECT_NE(message.find(path), std::string::npos) << message;
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  };
  expectRefused([](auto* reader) { reader->SetWindow(0, 0, 5, 5); }, "read whole");
  expectRefused([](auto* reader) { reader->SetMaximumSize(19); }, "20 x 20");
  expectRefused([](auto* reader) { reader->SetMaximumNumberOfSamples(399); }, "20 x 20");
  expectRefused([](auto* reader) { reader->SetBand(2); }, "one band");
  expectRefused([](auto* reader) { reader->SetCoordinateSystem("EPSG:no"); }, "not understood");
  std::filesystem::resize_file(path, 4500);
  expectRefused([](auto*) {}, "4500 bytes");
}
