// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the samples of an array lie, from the variables of coordinates beside it; and even grids of
// uneven ones, against a search of all cells.
#include "raster/GridCoordinates.h"
#include "raster/GridResample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{
using terrain::EvenGrid;
using terrain::FindGridPlace;
using terrain::GridAxis;
using terrain::GridCoordinates;
using terrain::GridPlace;
using terrain::RasterRecord;

GridAxis Axis(
  const std::string& name, const std::string& units, double first, double step, std::size_t count)
{
  GridAxis axis;
  axis.Name = name;
  axis.Attributes["units"] = units;
  for (std::size_t k = 0; k < count; ++k)
  {
    axis.Values.push_back(first + step * static_cast<double>(k));
  }
  return axis;
}

GridCoordinates Grid(const GridAxis& rows, const GridAxis& columns)
{
  GridCoordinates grid;
  grid.RowCount = rows.Values.size();
  grid.ColumnCount = columns.Values.size();
  grid.Rows = rows;
  grid.Columns = columns;
  return grid;
}

TEST(UnitTestGridCoordinates, DegreesByUnitsOrNames)
{
  for (const auto& [y, x] :
    { std::pair<GridAxis, GridAxis>(
        Axis("a", "degrees_north", 40.0, 0.5, 10), Axis("b", "degrees_east", 5.0, 0.5, 20)),
      std::pair<GridAxis, GridAxis>(Axis("lat", "", 40.0, 0.5, 10), Axis("lon", "", 5.0, 0.5, 20)),
      std::pair<GridAxis, GridAxis>(
        Axis("Latitude", "degreeN", 40.0, 0.5, 10), Axis("LONGITUDE", "", 5.0, 0.5, 20)) })
  {
    RasterRecord record;
    const GridPlace place = FindGridPlace(Grid(y, x), record);
    ASSERT_TRUE(place.HasGeoTransform) << y.Name;
    EXPECT_TRUE(place.IsGeographic);
    EXPECT_FALSE(place.IsTransposed);
    EXPECT_EQ(place.CoordinateSystem, "EPSG:4326");
    const std::array<double, 6> expected{ { 4.75, 0.5, 0.0, 39.75, 0.0, 0.5 } };
    EXPECT_EQ(place.GeoTransform, expected);
  }
}

TEST(UnitTestGridCoordinates, MinutesAndSecondsOfArc)
{
  for (const auto& [unit, parts] :
    { std::pair("arc_minute", 60.0), std::pair("arc_seconds", 3600.0) })
  {
    RasterRecord record;
    const GridPlace place = FindGridPlace(Grid(Axis("lat", unit, 40.0 * parts, 0.5 * parts, 10),
                                            Axis("lon", unit, 5.0 * parts, 0.5 * parts, 20)),
      record);
    ASSERT_TRUE(place.HasGeoTransform) << unit;
    EXPECT_TRUE(place.IsGeographic);
    const std::array<double, 6> expected{ { 4.75, 0.5, 0.0, 39.75, 0.0, 0.5 } };
    for (std::size_t k = 0; k < expected.size(); ++k)
    {
      EXPECT_NEAR(place.GeoTransform[k], expected[k], 1e-9) << unit;
    }
  }
}

TEST(UnitTestGridCoordinates, OrderAndSense)
{
  RasterRecord record;
  const GridPlace turned =
    FindGridPlace(Grid(Axis("lon", "", 5.0, 0.5, 20), Axis("lat", "", 45.0, -0.5, 10)), record);
  EXPECT_TRUE(turned.IsTransposed);
  EXPECT_DOUBLE_EQ(turned.GeoTransform[5], -0.5);
  EXPECT_DOUBLE_EQ(turned.GeoTransform[3], 45.25);
}

TEST(UnitTestGridCoordinates, KilometresAndTheDateLine)
{
  RasterRecord record;
  const GridPlace place =
    FindGridPlace(Grid(Axis("y", "km", 10.0, 1.0, 5), Axis("x", "km", -3.0, 1.0, 7)), record);
  EXPECT_DOUBLE_EQ(place.GeoTransform[1], 1000.0);
  GridAxis longitude = Axis("lon", "", 179.0, 0.5, 6);
  for (double& value : longitude.Values)
  {
    value -= value > 180.0 ? 360.0 : 0.0;
  }
  const GridPlace fiji = FindGridPlace(Grid(Axis("lat", "", -18.0, 0.5, 5), longitude), record);
  ASSERT_TRUE(fiji.HasGeoTransform);
  EXPECT_DOUBLE_EQ(fiji.GeoTransform[1], 0.5);
}

TEST(UnitTestGridCoordinates, NumbersOfSamplesGiveWayToFields)
{
  GridCoordinates grid = Grid(Axis("y", "1", 0.0, 1.0, 4), Axis("x", "", 0.0, 1.0, 5));
  RasterRecord record;
  EXPECT_TRUE(FindGridPlace(grid, record).HasGeoTransform);
  grid.Fields = { Axis("nav_lon", "degrees_east", 5.0, 0.1, 20),
    Axis("nav_lat", "degrees_north", 40.0, 0.1, 20) };
  EXPECT_TRUE(FindGridPlace(grid, record).IsField);
  // coordinates in metres do not
  grid.Columns = Axis("x", "m", 0.0, 1.0, 5);
  EXPECT_FALSE(FindGridPlace(grid, record).IsField);
}

TEST(UnitTestGridCoordinates, WhatCannotBe)
{
  RasterRecord record;
  GridAxis back = Axis("lat", "", 40.0, 0.5, 10);
  std::swap(back.Values[4], back.Values[5]);
  EXPECT_THROW(
    FindGridPlace(Grid(back, Axis("lon", "", 5.0, 0.5, 20)), record), terrain::RasterError);
  EXPECT_THROW(
    FindGridPlace(Grid(Axis("lat", "", 4e6, 30.0, 10), Axis("lon", "", 5e5, 30.0, 20)), record),
    terrain::RasterError);
}

TEST(UnitTestGridCoordinates, UnevenAxesAreResampledOnTheirLines)
{
  std::vector<double> x;
  std::vector<double> y;
  for (int k = 0; k < 40; ++k)
  {
    x.push_back(10.0 * k);
    y.push_back(std::pow(1.05, k) * 100.0);
  }
  std::vector<double> heights;
  for (const double north : y)
  {
    for (const double east : x)
    {
      heights.push_back(2.0 * east + 3.0 * north);
    }
  }
  const EvenGrid grid = terrain::PlanEvenGrid(x, y, 1U << 20U);
  ASSERT_GT(grid.Height, y.size());
  const std::vector<double> even = terrain::ResampleAxes(x, y, heights, grid);
  for (std::size_t row = 0; row < grid.Height; ++row)
  {
    for (std::size_t column = 0; column < grid.Width; ++column)
    {
      EXPECT_NEAR(even[row * grid.Width + column], 2.0 * grid.X(column) + 3.0 * grid.Y(row), 1e-6);
    }
  }
}

/// Barycentric height in the cell that holds a point, from all cells; NaN outside.
double BySearch(const std::vector<double>& x, const std::vector<double>& y,
  const std::vector<double>& z, std::size_t width, double px, double py)
{
  const std::size_t height = x.size() / width;
  for (std::size_t j = 0; j + 1 < height; ++j)
  {
    for (std::size_t i = 0; i + 1 < width; ++i)
    {
      const std::size_t corner[4] = { j * width + i, j * width + i + 1, (j + 1) * width + i,
        (j + 1) * width + i + 1 };
      // Newton's method on the bilinear map of the cell
      double u = 0.5;
      double v = 0.5;
      const auto at = [&](const std::vector<double>& values)
      {
        return (1 - u) * (1 - v) * values[corner[0]] + u * (1 - v) * values[corner[1]] +
          (1 - u) * v * values[corner[2]] + u * v * values[corner[3]];
      };
      const auto along = [&](const std::vector<double>& values, bool isU)
      {
        return isU ? (1 - v) * (values[corner[1]] - values[corner[0]]) +
            v * (values[corner[3]] - values[corner[2]])
                   : (1 - u) * (values[corner[2]] - values[corner[0]]) +
            u * (values[corner[3]] - values[corner[1]]);
      };
      for (int step = 0; step < 30; ++step)
      {
        const double dx = px - at(x);
        const double dy = py - at(y);
        const double a = along(x, true);
        const double b = along(x, false);
        const double c = along(y, true);
        const double d = along(y, false);
        const double determinant = a * d - b * c;
        u += (d * dx - b * dy) / determinant;
        v += (a * dy - c * dx) / determinant;
      }
      if (u >= -1e-9 && u <= 1 + 1e-9 && v >= -1e-9 && v <= 1 + 1e-9)
      {
        return at(z);
      }
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(UnitTestGridCoordinates, CurvedGridsAgainstASearchOfAllCells)
{
  constexpr std::size_t kWidth = 13;
  constexpr std::size_t kHeight = 11;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> z;
  std::vector<double> columns; // places in the grid, as heights
  std::vector<double> rows;
  std::mt19937 random(11);
  constexpr double kRelief = 1000.0;
  std::uniform_real_distribution<double> height(0.0, kRelief);
  for (std::size_t j = 0; j < kHeight; ++j)
  {
    for (std::size_t i = 0; i < kWidth; ++i)
    {
      const auto u = static_cast<double>(i);
      const auto v = static_cast<double>(j);
      x.push_back(10.0 + 0.9 * u + 0.3 * v + 0.02 * u * v); // turned and sheared
      y.push_back(45.0 - 0.25 * u + 0.8 * v + 0.01 * u * u);
      z.push_back(height(random));
      columns.push_back(u);
      rows.push_back(v);
    }
  }
  const EvenGrid grid = terrain::PlanEvenGrid(x, y, kWidth, false, 1U << 20U);
  const auto resample = [&](const std::vector<double>& values)
  { return terrain::ResampleField(x, y, values, kWidth, HUGE_VAL, grid); };
  const std::vector<double> even = resample(z);
  const std::vector<double> evenColumns = resample(columns);
  const std::vector<double> evenRows = resample(rows);
  std::size_t with = 0;
  for (std::size_t row = 0; row < grid.Height; ++row)
  {
    for (std::size_t column = 0; column < grid.Width; ++column)
    {
      const auto search = [&](const std::vector<double>& values)
      { return BySearch(x, y, values, kWidth, grid.X(column), grid.Y(row)); };
      const std::size_t at = row * grid.Width + column;
      const double expected = search(z);
      ASSERT_EQ(std::isnan(even[at]), std::isnan(expected));
      if (!std::isnan(expected))
      {
        ++with;
        ASSERT_NEAR(evenColumns[at], search(columns), terrain::kGridResampleError);
        ASSERT_NEAR(evenRows[at], search(rows), terrain::kGridResampleError);
        // no edge of a cell rises by more than the relief
        ASSERT_NEAR(even[at], expected, 2.0 * kRelief * terrain::kGridResampleError);
      }
    }
  }
  EXPECT_GT(with, kWidth * kHeight / 2);
}
}
