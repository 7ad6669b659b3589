// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Texts as points on a grid: no raster, or one of a finite place whose cells, written as points,
// are read as the same raster.
#include "FuzzFile.h"

#include "raster/GDALTable.h"
#include "raster/PointText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

namespace
{
using Dataset = std::unique_ptr<void, void (*)(void*)>;

struct Grid
{
  int Width = 0;
  int Height = 0;
  std::array<double, 6> Transform{};
  std::vector<double> Heights;

  bool IsFull() const
  {
    return std::none_of(
      this->Heights.begin(), this->Heights.end(), [](double z) { return std::isnan(z); });
  }
};

/// Without any cells for what is no text of points.
Grid Read(const std::string& text)
{
  const FuzzFile file(text);
  terrain::RasterRecord record;
  const Dataset dataset(terrain::OpenPointText(file.Path(), record),
    [](void* open)
    {
      if (open)
      {
        GDALClose(open);
      }
    });
  Grid grid;
  if (!dataset)
  {
    return grid;
  }
  grid.Width = GDALGetRasterXSize(dataset.get());
  grid.Height = GDALGetRasterYSize(dataset.get());
  Require(GDALGetGeoTransform(dataset.get(), grid.Transform.data()) == CE_None);
  grid.Heights.resize(static_cast<std::size_t>(grid.Width) * grid.Height);
  Require(GDALRasterIO(GDALGetRasterBand(dataset.get(), 1), GF_Read, 0, 0, grid.Width, grid.Height,
            grid.Heights.data(), grid.Width, grid.Height, GDT_Float64, 0, 0) == CE_None);
  return grid;
}

/// The cells as points, from the north; empty where the rounding of coordinates counts.
std::string TextOf(const Grid& grid)
{
  std::string text;
  for (int j = 0; j < grid.Height; ++j)
  {
    for (int i = 0; i < grid.Width; ++i)
    {
      const double x = grid.Transform[0] + (i + 0.5) * grid.Transform[1];
      const double y = grid.Transform[3] + (j + 0.5) * grid.Transform[5];
      if (std::abs(x) * 1e-8 > grid.Transform[1] || std::abs(y) * 1e-8 > -grid.Transform[5])
      {
        return {};
      }
      char line[100];
      std::snprintf(line, sizeof(line), "%.17g %.17g %.17g\n", x, y,
        grid.Heights[static_cast<std::size_t>(j) * grid.Width + i]);
      text += line;
    }
  }
  return text;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const bool isReady = (GDALAllRegister(), terrain::WhyNoGDAL().empty());
  Require(isReady);
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Grid grid = Read(text);
  if (grid.Heights.empty())
  {
    return 0;
  }
  for (const double number : grid.Transform)
  {
    Require(std::isfinite(number));
  }
  Require(grid.Transform[1] > 0.0 && grid.Transform[5] < 0.0);
  const std::string again = grid.IsFull() ? TextOf(grid) : std::string();
  if (!again.empty())
  {
    const Grid same = Read(again);
    Require(same.Width == grid.Width && same.Height == grid.Height);
    Require(same.Heights == grid.Heights);
  }
  return 0;
}
