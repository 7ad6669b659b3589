// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rasters in degrees as files have them, and what a ray meets of them on a planet: brute force in
 * double precision that shares no line with the module. It steps along the ray by less than its
 * height above the surface, which is found from the samples of the file by their longitudes and
 * latitudes. For tests of the class and of the programs.
 */
#ifndef vtkTerrainTestGlobeJudge_h
#define vtkTerrainTestGlobeJudge_h

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace vtkTerrainTesting
{
using Point = std::array<double, 3>;

constexpr double kJudgeDegree = 3.14159265358979323846 / 180.0;

/// Samples at West + i Step, South + j Step degrees, and how they should be taken.
struct DegreesRaster
{
  std::string Name;
  double West = 0.0;
  double South = 0.0;
  double Step = 1.0;
  int Columns = 2;
  int Rows = 2;
  std::function<double(int, int)> Sample; ///< row 0 in the south; NaN for none
  int Around = 0;                         ///< columns of a full round; 0 for a part of the planet
  int FirstRow = 0;                       ///< the first that counts
  int LastRow = 0;                        ///< likewise
  bool Mean = false;                      ///< poles are closed by the means of both
  double Equatorial = 6378137.0;
  double Polar = 6356752.314245179;

  double MeanOf(int row) const
  {
    double sum = 0.0;
    for (int i = 0; i < this->Columns; ++i)
    {
      sum += this->Sample(i, row);
    }
    return sum / this->Columns;
  }
  /// Bilinear in longitude and latitude, degrees; NaN where there is nothing.
  double HeightAt(double longitude, double latitude) const
  {
    const double round = this->Around > 0 ? this->Around : 360.0 / this->Step;
    double x = (longitude - this->West) / this->Step;
    x -= round * std::floor(x / round);
    const int i = std::min(static_cast<int>(x), this->Columns - 1);
    const int next = this->Around > 0 ? (i + 1) % this->Around : i + 1;
    if (next >= this->Columns)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const auto along = [&](int j)
    { return this->Sample(i, j) * (i + 1 - x) + this->Sample(next, j) * (x - i); };
    const double y = (latitude - this->South) / this->Step;
    for (const auto& [row, pole] :
      { std::pair(this->FirstRow, -90.0), std::pair(this->LastRow, 90.0) })
    {
      const double end = (pole - this->South) / this->Step;
      const double part = (y - row) / (end - row);
      if (this->Mean && part > 0.0)
      {
        return along(row) * (1.0 - part) + this->MeanOf(row) * part;
      }
    }
    const int j = std::min(static_cast<int>(std::floor(y)), this->LastRow - 1);
    return y < this->FirstRow || y > this->LastRow
      ? std::numeric_limits<double>::quiet_NaN()
      : along(j) * (j + 1 - y) + along(j + 1) * (y - j);
  }
};

class GlobeJudge
{
public:
  /// steepest: slope of the surface as drawn, rise over run.
  GlobeJudge(const DegreesRaster& raster, double exaggeration, double steepest)
    : Raster(raster)
    , Exaggeration(exaggeration)
    , Steepest(steepest)
  {
    for (int k = 0; k < raster.Columns * raster.Rows; ++k)
    {
      const double height = exaggeration * raster.Sample(k % raster.Columns, k / raster.Columns);
      this->Lowest = std::min(this->Lowest, std::isnan(height) ? 0.0 : height);
      this->Highest = std::max(this->Highest, std::isnan(height) ? 0.0 : height);
    }
  }

  /// Longitude and latitude in degrees, height in metres, of a point above half the planet's depth:
  /// the latitude by iteration.
  Point ToPlace(const Point& point) const
  {
    const double a = this->Raster.Equatorial;
    const double e2 = 1.0 - std::pow(this->Raster.Polar / a, 2);
    const double off = std::hypot(point[0], point[1]);
    double latitude = std::atan2(point[2], off * (1.0 - e2));
    double before = 10.0;
    for (int k = 0; k < 40 && std::abs(latitude - before) > 1e-14; ++k)
    {
      before = latitude;
      const double s = std::sin(latitude);
      latitude = std::atan2(point[2] + e2 * a / std::sqrt(1.0 - e2 * s * s) * s, off);
    }
    const double s = std::sin(latitude);
    return { std::atan2(point[1], point[0]) / kJudgeDegree, latitude / kJudgeDegree,
      off * std::cos(latitude) + point[2] * s - a * std::sqrt(1.0 - e2 * s * s) };
  }
  Point ToPoint(const Point& place) const
  {
    const double a = this->Raster.Equatorial;
    const double e2 = 1.0 - std::pow(this->Raster.Polar / a, 2);
    const double s = std::sin(kJudgeDegree * place[1]);
    const double c = std::cos(kJudgeDegree * place[1]);
    const double normal = a / std::sqrt(1.0 - e2 * s * s);
    const double off = (normal + place[2]) * c;
    return { off * std::cos(kJudgeDegree * place[0]), off * std::sin(kJudgeDegree * place[0]),
      (normal * (1.0 - e2) + place[2]) * s };
  }
  /// Height of a point above the surface, metres; NaN where there is none.
  double Above(const Point& point) const
  {
    const double radius = std::hypot(point[0], point[1], point[2]);
    if (radius < 0.7 * this->Raster.Polar)
    {
      return radius - this->Raster.Polar - this->Highest; // deep in the planet
    }
    const Point place = this->ToPlace(point);
    return place[2] - this->Exaggeration * this->Raster.HeightAt(place[0], place[1]);
  }
  /// Distance, in lengths of the direction, at which a ray comes to the surface from above; NaN if
  /// it does not.
  double Cast(const Point& origin, const Point& direction) const
  {
    const auto at = [&](double t) -> Point
    {
      return { origin[0] + t * direction[0], origin[1] + t * direction[1],
        origin[2] + t * direction[2] };
    };
    const auto dot = [](const Point& a, const Point& b)
    { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const double shell = this->Raster.Equatorial + this->Highest + 10.0;
    const double d2 = dot(direction, direction);
    const double half = dot(origin, direction) / d2;
    const double root = half * half - (dot(origin, origin) - shell * shell) / d2;
    if (!(root > 0.0))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const double metre = 1.0 / std::sqrt(d2);
    const double end = std::sqrt(root) - half;
    const double grain = 0.02 * this->Raster.Step * kJudgeDegree * this->Raster.Equatorial;
    double before = 0.0;
    bool wasAbove = false;
    for (double t = std::max(0.0, -std::sqrt(root) - half); t < end;)
    {
      const double above = this->Above(at(t));
      if (wasAbove && above < 0.0)
      {
        double high = t;
        for (int k = 0; k < 60; ++k)
        {
          const double middle = 0.5 * (before + high);
          (this->Above(at(middle)) < 0.0 ? high : before) = middle;
        }
        return high;
      }
      wasAbove = above >= 0.0;
      before = t;
      t += metre *
        (std::isnan(above) ? grain : std::max(std::abs(above) / (2.0 + this->Steepest), 0.5));
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  double Lowest = 0.0;
  double Highest = 0.0;

private:
  DegreesRaster Raster;
  double Exaggeration;
  double Steepest;
};

/// Hills that say where on a planet they are, in whole metres.
inline double JudgedHills(double longitude, double latitude)
{
  const double x = kJudgeDegree * longitude;
  const double y = kJudgeDegree * latitude;
  return std::round(2500.0 * std::cos(y) * std::cos(y) * std::sin(x + 0.7) +
    1200.0 * std::cos(y) * std::cos(y) * std::sin(4.0 * x) * std::cos(3.0 * y) +
    900.0 * std::sin(2.0 * y + 0.3));
}

/// Kinds of global rasters that files come in: wherever longitudes begin, more than once round,
/// rows beyond the poles, at them or beside them.
inline std::vector<DegreesRaster> KindsOfDegrees()
{
  std::vector<DegreesRaster> kinds;
  const auto add = [&kinds](const std::string& name, double west, double south, double step,
                     int columns, int rows, int around)
  {
    DegreesRaster raster;
    raster.Name = name;
    raster.West = west;
    raster.South = south;
    raster.Step = step;
    raster.Columns = columns;
    raster.Rows = rows;
    raster.Around = around;
    raster.LastRow = rows - 1;
    raster.Mean = around > 0 && south > -90.0;
    raster.Sample = [=](int i, int j)
    { return JudgedHills(west + step * (around > 0 ? i % around : i), south + step * j); };
    kinds.push_back(raster);
  };
  add("0 to 360, cells", 1.0, -89.0, 2.0, 180, 90, 180);
  add("0 to 360, nodes", 0.0, -90.0, 2.0, 181, 91, 180);
  add("-180 to 180, nodes but the last", -180.0, -90.0, 2.0, 180, 91, 180);
  add("-180 to 180, cells, nodes at the poles", -179.0, -90.0, 2.0, 180, 91, 180);
  add("-200 to 160, cells", -199.0, -89.0, 2.0, 180, 90, 180);
  add("twice round", -359.0, -89.0, 2.0, 360, 90, 180);
  add("two columns more than a round", -181.0, -89.0, 2.0, 182, 90, 180);
  add("a part beyond 180", 150.0, -40.0, 2.0, 41, 41, 0);
  add("a part at a pole", -60.0, 50.0, 2.0, 61, 21, 0);
  add("two columns and two rows", 20.0, 10.0, 20.0, 2, 2, 0);

  add("rows beyond the poles without data", -179.0, -93.0, 2.0, 180, 94, 180);
  DegreesRaster& beyond = kinds.back();
  beyond.FirstRow = 2;
  beyond.LastRow = 91;
  beyond.Mean = true;
  beyond.Sample = [](int i, int j)
  {
    return j < 2 || j > 91 ? std::numeric_limits<double>::quiet_NaN()
                           : JudgedHills(-179.0 + 2.0 * i, -93.0 + 2.0 * j);
  };
  add("a rounded step that leads beyond a pole", -180.0, -90.0, 2.00002, 180, 91, 180);

  add("polar rows that differ", -180.0, -90.0, 2.0, 181, 91, 180);
  kinds.back().Sample = [](int i, int j)
  {
    const double away = std::round(1000.0 * std::sin(4.0 * kJudgeDegree * (i % 180)));
    return JudgedHills(-180.0 + 2.0 * (i % 180), -90.0 + 2.0 * j) +
      (j == 0 || j == 90 ? away : 0.0);
  };
  add("flattened by a tenth", 0.0, -90.0, 2.0, 181, 91, 180);
  kinds.back().Equatorial = 1e6;
  kinds.back().Polar = 9e5;
  return kinds;
}
}

#endif
