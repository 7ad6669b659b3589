// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/GridResample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace terrain
{
namespace
{
constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();
constexpr double kSlack = kGridResampleError;
constexpr int kMostSteps = 12;

/// Index of the interval that holds a coordinate, and the share of the way through it.
struct Interval
{
  std::size_t Index = 0;
  double Share = 0.0;
  bool IsInside = false;
};

Interval FindInterval(const std::vector<double>& values, double at)
{
  const bool rises = values.back() > values.front();
  const auto found = std::upper_bound(values.begin(), values.end(), at,
    [rises](double a, double b) { return rises ? a < b : a > b; });
  const auto index = std::clamp<std::ptrdiff_t>(
    found - values.begin() - 1, 0, static_cast<std::ptrdiff_t>(values.size()) - 2);
  Interval interval;
  interval.Index = static_cast<std::size_t>(index);
  interval.Share =
    (at - values[interval.Index]) / (values[interval.Index + 1] - values[interval.Index]);
  interval.IsInside = interval.Share >= -kSlack && interval.Share <= 1.0 + kSlack;
  interval.Share = std::clamp(interval.Share, 0.0, 1.0);
  return interval;
}

double Blend(const double* corners, double u, double v)
{
  // a corner without weight may have no data
  double sum = 0.0;
  const std::array<double, 4> weights{ { (1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v,
    u * v } };
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    sum += weights[k] == 0.0 ? 0.0 : weights[k] * corners[k];
  }
  return sum;
}

double SmallestStep(const std::vector<double>& values)
{
  double smallest = std::abs(values.back() - values.front());
  for (std::size_t k = 1; k < values.size(); ++k)
  {
    smallest = std::min(smallest, std::abs(values[k] - values[k - 1]));
  }
  return smallest;
}

/// Samples from low to high, both of them samples, about a step apart.
std::size_t CountSteps(double low, double high, double step)
{
  return static_cast<std::size_t>(std::max(std::ceil((high - low) / step - 1e-6), 1.0)) + 1;
}

EvenGrid MakeGrid(
  std::array<double, 2> x, std::array<double, 2> y, std::array<double, 2> step, std::size_t most)
{
  EvenGrid grid;
  do
  {
    grid.Width = CountSteps(x[0], x[1], step[0]);
    grid.Height = CountSteps(y[0], y[1], step[1]);
    step = { step[0] * 1.01, step[1] * 1.01 };
  } while (grid.Width * grid.Height > most);
  const double dx = (x[1] - x[0]) / static_cast<double>(grid.Width - 1);
  const double dy = (y[1] - y[0]) / static_cast<double>(grid.Height - 1);
  grid.GeoTransform = { x[0] - 0.5 * dx, dx, 0.0, y[1] + 0.5 * dy, 0.0, -dy };
  return grid;
}

std::array<double, 2> RangeOf(const std::vector<double>& values)
{
  std::array<double, 2> range{ { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() } };
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      range = { std::min(range[0], value), std::max(range[1], value) };
    }
  }
  return range;
}

/// A cell of a curvilinear grid: corners south-west, south-east, north-west, north-east of its own.
struct Quad
{
  std::array<double, 4> X;
  std::array<double, 4> Y;
  std::array<double, 4> Z;

  /// Position in the cell, each from 0 to 1; false if the point is not in it.
  bool Find(double x, double y, double& u, double& v) const
  {
    u = v = 0.5;
    for (int step = 0; step < kMostSteps; ++step)
    {
      const double ex = Blend(this->X.data(), u, v) - x;
      const double ey = Blend(this->Y.data(), u, v) - y;
      const double xu = (1.0 - v) * (this->X[1] - this->X[0]) + v * (this->X[3] - this->X[2]);
      const double yu = (1.0 - v) * (this->Y[1] - this->Y[0]) + v * (this->Y[3] - this->Y[2]);
      const double xv = (1.0 - u) * (this->X[2] - this->X[0]) + u * (this->X[3] - this->X[1]);
      const double yv = (1.0 - u) * (this->Y[2] - this->Y[0]) + u * (this->Y[3] - this->Y[1]);
      const double determinant = xu * yv - xv * yu;
      if (determinant == 0.0)
      {
        return false;
      }
      const double du = (ex * yv - ey * xv) / determinant;
      const double dv = (ey * xu - ex * yu) / determinant;
      u -= du;
      v -= dv;
      if (std::abs(du) + std::abs(dv) < 1e-9)
      {
        break;
      }
    }
    const bool inside = u >= -kSlack && u <= 1.0 + kSlack && v >= -kSlack && v <= 1.0 + kSlack;
    u = std::clamp(u, 0.0, 1.0);
    v = std::clamp(v, 0.0, 1.0);
    return inside;
  }

  /// Fills the samples of the grid that lie in it, and have no height yet.
  void Fill(const EvenGrid& grid, std::vector<double>& heights) const
  {
    const auto [west, east] = std::minmax_element(this->X.begin(), this->X.end());
    const auto [south, north] = std::minmax_element(this->Y.begin(), this->Y.end());
    const auto column = [&grid](double x)
    { return (x - grid.GeoTransform[0]) / grid.GeoTransform[1] - 0.5; };
    const auto row = [&grid](double y)
    { return (y - grid.GeoTransform[3]) / grid.GeoTransform[5] - 0.5; };
    const auto begin = [](double at)
    { return static_cast<std::size_t>(std::max(std::ceil(at - 1e-5), 0.0)); };
    const auto end = [](double at, std::size_t size)
    {
      return static_cast<std::size_t>(
        std::clamp(std::floor(at + 1e-5) + 1.0, 0.0, static_cast<double>(size)));
    };
    const std::size_t lastColumn = end(column(*east), grid.Width);
    const std::size_t lastRow = end(row(*south), grid.Height);
    for (std::size_t r = begin(row(*north)); r < lastRow; ++r)
    {
      for (std::size_t c = begin(column(*west)); c < lastColumn; ++c)
      {
        double u = 0.0;
        double v = 0.0;
        double& height = heights[r * grid.Width + c];
        if (std::isnan(height) && this->Find(grid.X(c), grid.Y(r), u, v))
        {
          height = Blend(this->Z.data(), u, v);
        }
      }
    }
  }
};
}

//------------------------------------------------------------------------------
EvenGrid PlanEvenGrid(const std::vector<double>& x, const std::vector<double>& y, std::size_t most)
{
  return MakeGrid(RangeOf(x), RangeOf(y), { SmallestStep(x), SmallestStep(y) }, most);
}

//------------------------------------------------------------------------------
EvenGrid PlanEvenGrid(const std::vector<double>& x, const std::vector<double>& y, std::size_t width,
  bool isGeographic, std::size_t most)
{
  const std::array<double, 2> rangeX = RangeOf(x);
  const std::array<double, 2> rangeY = RangeOf(y);
  const double middle = 0.5 * (rangeY[0] + rangeY[1]) * std::acos(-1.0) / 180.0;
  const double shape = isGeographic ? std::max(std::cos(middle), 0.05) : 1.0;
  std::vector<double> areas;
  const std::size_t rows = x.size() / width;
  const std::size_t stride = std::max<std::size_t>(x.size() / 10000, 1);
  for (std::size_t k = 0; k + width + 1 < x.size(); k += stride)
  {
    if (k % width + 1 < width && k / width + 1 < rows)
    {
      const double area = std::abs((x[k + 1] - x[k]) * (y[k + width] - y[k]) -
                            (x[k + width] - x[k]) * (y[k + 1] - y[k])) *
        (isGeographic ? std::max(std::cos(y[k] * std::acos(-1.0) / 180.0), 0.05) : 1.0);
      if (std::isfinite(area) && area > 0.0)
      {
        areas.push_back(area);
      }
    }
  }
  if (areas.empty() || !(rangeX[1] > rangeX[0]) || !(rangeY[1] > rangeY[0]))
  {
    return {};
  }
  std::nth_element(
    areas.begin(), areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2), areas.end());
  const double step = std::sqrt(areas[areas.size() / 2]);
  return MakeGrid(rangeX, rangeY, { step / shape, step }, most);
}

//------------------------------------------------------------------------------
std::vector<double> ResampleAxes(const std::vector<double>& x, const std::vector<double>& y,
  const std::vector<double>& heights, const EvenGrid& grid)
{
  std::vector<Interval> columns;
  for (std::size_t c = 0; c < grid.Width; ++c)
  {
    columns.push_back(FindInterval(x, grid.X(c)));
  }
  std::vector<double> even(grid.Width * grid.Height, kNoHeight);
  for (std::size_t r = 0; r < grid.Height; ++r)
  {
    const Interval row = FindInterval(y, grid.Y(r));
    for (std::size_t c = 0; c < grid.Width && row.IsInside; ++c)
    {
      const Interval& column = columns[c];
      const double* corner = &heights[row.Index * x.size() + column.Index];
      const std::array<double, 4> corners{ { corner[0], corner[1], corner[x.size()],
        corner[x.size() + 1] } };
      even[r * grid.Width + c] =
        column.IsInside ? Blend(corners.data(), column.Share, row.Share) : kNoHeight;
    }
  }
  return even;
}

//------------------------------------------------------------------------------
std::vector<double> ResampleField(const std::vector<double>& x, const std::vector<double>& y,
  const std::vector<double>& heights, std::size_t width, double widest, const EvenGrid& grid)
{
  std::vector<double> even(grid.Width * grid.Height, kNoHeight);
  const std::size_t rows = x.size() / width;
  for (std::size_t r = 0; r + 1 < rows; ++r)
  {
    for (std::size_t c = 0; c + 1 < width; ++c)
    {
      const std::size_t k = r * width + c;
      const std::array<std::size_t, 4> at{ { k, k + 1, k + width, k + width + 1 } };
      Quad quad{};
      for (std::size_t corner = 0; corner < at.size(); ++corner)
      {
        quad.X[corner] = x[at[corner]];
        quad.Y[corner] = y[at[corner]];
        quad.Z[corner] = heights[at[corner]];
      }
      const auto isFinite = [](double value) { return std::isfinite(value); };
      const auto [west, east] = std::minmax_element(quad.X.begin(), quad.X.end());
      if (std::all_of(quad.X.begin(), quad.X.end(), isFinite) &&
        std::all_of(quad.Y.begin(), quad.Y.end(), isFinite) && *east - *west <= widest)
      {
        quad.Fill(grid, even);
      }
    }
  }
  return even;
}
}
