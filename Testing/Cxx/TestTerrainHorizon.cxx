// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The horizon of heights in degrees, whose cells are narrower the farther they lie from the
// equator. On grids of one spacing: Testing/Unit/UnitTestHorizon.cxx.
#include "vtkTerrainHorizon.h"

#include "vtkTerrainTestRaster.h"

#include "vtkTerrainRasterReader.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
constexpr int kColumns = 8;
constexpr int kRows = 201;
constexpr double kCell = 0.01; // degrees
constexpr double kSouth = 50.0;
constexpr double kRise = 600.0; // metres a column, to the east: near 45 degrees
const double kDegree = std::acos(-1.0) / 180.0;

/// Metres east of one cell at a latitude, on the ellipsoid of WGS84.
double CellWidth(double latitude)
{
  const double sine = std::sin(latitude * kDegree);
  const double eccentricity2 = (2.0 - 1.0 / 298.257223563) / 298.257223563;
  return kCell * kDegree * 6378137.0 * std::cos(latitude * kDegree) /
    std::sqrt(1.0 - eccentricity2 * sine * sine);
}
}

// A plane that rises to the east has its own slope for horizon.
TEST(TerrainHorizon, CellsInDegreesHaveTheWidthOfTheirLatitude)
{
  vtkTerrainTesting::RasterFile raster;
  raster.Width = kColumns;
  raster.Height = kRows;
  raster.Type = GDT_Float32;
  raster.EPSG = 4326;
  raster.GeoTransform = { 10.0 - 0.5 * kCell, kCell, 0.0, kSouth + (kRows - 0.5) * kCell, 0.0,
    -kCell };
  for (int k = 0; k < kColumns * kRows; ++k)
  {
    raster.Values.push_back(kRise * (k % kColumns));
  }
  const std::string path = raster.Write("horizon-degrees.tif");
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(path.c_str());
  vtkNew<vtkTerrainHorizon> horizon;
  horizon->SetNumberOfDirections(4);
  horizon->SetInputConnection(reader->GetOutputPort());
  horizon->Update();
  vtkImageData* output = horizon->GetOutput();
  vtkDataArray* degrees = output->GetPointData()->GetArray("Horizon");
  ASSERT_NE(degrees, nullptr);
  ASSERT_EQ(output->GetNumberOfPoints(), kColumns * kRows);
  double worst = 0.0;
  for (int row = 0; row < kRows; ++row)
  {
    const double expected = kRise / CellWidth(kSouth + row * kCell);
    const double found = std::tan(degrees->GetComponent(vtkIdType{ row } * kColumns, 1) * kDegree);
    worst = std::max(worst, std::abs(found / expected - 1.0));
  }
  // The horizon's own error, of an angle, does not show on a plane.
  EXPECT_LE(worst, vtkTerrainHorizon::SpacingError);
  // Bands of rows are what the error is for; with none, rows would be right to rounding.
  EXPECT_GT(worst, 1e-5);
}
