// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of global rasters of every kind, drawn on a globe by terrain-render: depths against brute
// force from the samples of the file.
#include "../Cxx/vtkTerrainTestGlobeJudge.h"
#include "TerrainRenderFixture.h"

#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
using vtkTerrainTesting::DegreesRaster;
using vtkTerrainTesting::GlobeJudge;
using vtkTerrainTesting::Point;

/// How much larger than true heights are drawn, so that a wrong place shows.
constexpr double kDrawnHigher = 15.0;
/// Slope of what is drawn, away from the axis.
constexpr double kSteepest = 6.0;
/// Largest difference of depths: a part of them, and metres.
constexpr double kPart = 1e-5;
constexpr double kMetres = 20.0;
/// Of ExpectJudged: every so many pixels each way.
constexpr int kPixels = 8;

double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Point Unit(const Point& a)
{
  const double length = std::sqrt(Dot(a, a));
  return { a[0] / length, a[1] / length, a[2] / length };
}

/// A camera of the program: its eye, and the directions of its pixels.
struct Eye
{
  Point From;
  Point Way;
  Point Up;

  Eye(const Point& from, const Point& to)
    : From(from)
    , Way(Unit({ to[0] - from[0], to[1] - from[1], to[2] - from[2] }))
    , Up(Unit(Cross(Cross(this->Way, { 0.3, 0.2, 0.9 }), this->Way)))
  {
  }
  /// Of 160 x 120 pixels, row 0 on top; as long as it takes to come one metre forward.
  Point At(double column, double row) const
  {
    const double half = std::tan(15.0 * vtkTerrainTesting::kJudgeDegree);
    const double x = (column / 80.0 - 1.0) * half * 160.0 / 120.0;
    const double y = (1.0 - row / 60.0) * half;
    const Point right = Cross(this->Way, this->Up);
    return { this->Way[0] + x * right[0] + y * this->Up[0],
      this->Way[1] + x * right[1] + y * this->Up[1],
      this->Way[2] + x * right[2] + y * this->Up[2] };
  }
  std::string Text() const
  {
    std::ostringstream text;
    text.precision(12);
    for (const Point& part : { this->From,
           Point{ this->From[0] + 1e6 * this->Way[0], this->From[1] + 1e6 * this->Way[1],
             this->From[2] + 1e6 * this->Way[2] },
           this->Up })
    {
      for (const double number : part)
      {
        text << (text.str().empty() ? "" : ",") << number;
      }
    }
    return text.str();
  }
};

class TerrainRenderGlobeInput : public TerrainRenderFixture
{
protected:
  std::string Write(const DegreesRaster& raster)
  {
    RasterDescription file;
    file.Width = raster.Columns;
    file.Height = raster.Rows;
    file.CoordinateSystem = raster.Equatorial == 6378137.0
      ? "EPSG:4326"
      : "+proj=longlat +a=" + std::to_string(raster.Equatorial) +
        " +b=" + std::to_string(raster.Polar) + " +no_defs";
    file.HasNoData = true;
    file.GeoTransform = { raster.West - 0.5 * raster.Step, raster.Step, 0.0,
      raster.South + (raster.Rows - 0.5) * raster.Step, 0.0, -raster.Step };
    file.Sample = [&raster](int i, int row)
    {
      const double height = raster.Sample(i, raster.Rows - 1 - row);
      return std::isnan(height) ? -32767.0 : height;
    };
    return this->WriteRaster("globe.tif", file);
  }

  /// Draws a file from an eye and judges the depths. Pixels on a border, where the judge tells
  /// another story a fifth of a pixel beside, may be either.
  void ExpectJudged(
    const std::string& path, const GlobeJudge& judge, const Eye& eye, double higher, int least)
  {
    const RunResult result = this->Draw(path,
      { "--frame", "globe", "--exaggeration", std::to_string(higher), "--camera", eye.Text() });
    this->ExpectDrawn(result, least);
    if (result.Status != 0)
    {
      return;
    }
    const Depths depths = this->ReadDepths();
    int wrong = 0;
    int hits = 0;
    for (int row = kPixels / 2; row < depths.Height; row += kPixels)
    {
      for (int column = kPixels / 2; column < depths.Width; column += kPixels)
      {
        const auto cast = [&](double x, double y)
        { return judge.Cast(eye.From, eye.At(column + 0.5 + x, row + 0.5 + y)); };
        const double drawn = depths.At(column, row);
        const double expected = cast(0.0, 0.0);
        hits += std::isnan(expected) ? 0 : 1;
        const bool same = std::isnan(drawn)
          ? std::isnan(expected)
          : std::abs(drawn - expected) <= kPart * expected + kMetres;
        bool isBorder = false;
        for (int side = 0; side < 9 && !same; ++side)
        {
          const double beside = cast(0.2 * (side % 3 - 1), 0.2 * (side / 3 - 1));
          isBorder = isBorder || std::isnan(beside) != std::isnan(expected) ||
            std::abs(beside - expected) > 0.02 * expected;
        }
        wrong += same || isBorder ? 0 : 1;
      }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GE(hits, least / (kPixels * kPixels) / 2);
  }
};
}

TEST_F(TerrainRenderGlobeInput, FilesOfEveryKindAreDrawnWhereTheySay)
{
  for (const DegreesRaster& raster : vtkTerrainTesting::KindsOfDegrees())
  {
    SCOPED_TRACE(raster.Name);
    const std::string path = this->Write(raster);
    const double higher = kDrawnHigher * raster.Equatorial / 6378137.0;
    const GlobeJudge judge(raster, higher, kSteepest);
    const double east = raster.West + raster.Step * (raster.Columns - 1);
    const Point middle{ 0.5 * (raster.West + east),
      raster.South + 0.5 * raster.Step * (raster.Rows - 1), 0.0 };
    std::vector<Point> places{ middle };
    if (raster.Around > 0)
    {
      places = { { raster.West, 20.0, 0.0 }, { 0.0, 89.0, 0.0 } };
    }
    for (const Point& place : places)
    {
      SCOPED_TRACE(place[1]);
      const Point eye = judge.ToPoint({ place[0] + 10.0, place[1] - 15.0, raster.Equatorial });
      this->ExpectJudged(path, judge, Eye(eye, judge.ToPoint(place)), higher, 2000);
    }
  }
}

// From within the planet nothing is seen of the underside, which the program says.
TEST_F(TerrainRenderGlobeInput, EyesMayBeInside)
{
  const DegreesRaster raster = vtkTerrainTesting::KindsOfDegrees().front();
  const std::string path = this->Write(raster);
  for (const Point& from :
    { Point{ 0.0, 0.0, 0.0 }, Point{ 0.0, 0.0, -5e6 }, Point{ 6e6, 1e5, 0.0 } })
  {
    const Eye eye(from, { 6378137.0, 1e6, 2e6 });
    const RunResult result = this->Draw(path, { "--camera", eye.Text() });
    this->ExpectDrawn(result, 0);
    EXPECT_NE(result.Errors.find("inside the planet"), std::string::npos) << result.Errors;
    EXPECT_EQ(this->ReadDepths().CountHits(), 0);
  }
}

// What cannot be mended is refused with a remedy.
TEST_F(TerrainRenderGlobeInput, FilesThatContradictThemselvesAreRefused)
{
  struct Case
  {
    double West, South, Step;
    int Columns, Rows;
    const char* Mention;
  };
  for (const Case& bad : { Case{ -359.0, -89.0, 2.0, 360, 90, "gdal_translate -projwin" },
         Case{ -359.0, -89.0, 2.0, 540, 90, "--crs" },
         Case{ -179.0, -99.0, 2.0, 180, 100, "gdal_translate -projwin" },
         Case{ 10.0, -89.0, 1.0, 1, 180, "two meridians" },
         Case{ -179.5, 0.0, 1.0, 360, 1, "two parallels" } })
  {
    SCOPED_TRACE(bad.Mention);
    DegreesRaster raster;
    raster.West = bad.West;
    raster.South = bad.South;
    raster.Step = bad.Step;
    raster.Columns = bad.Columns;
    raster.Rows = bad.Rows;
    raster.Sample = [](int i, int j) { return i + j; };
    const RunResult result = this->Draw(this->Write(raster), { "--frame", "globe" });
    EXPECT_NE(result.Status, 0);
    EXPECT_NE(result.Errors.find(bad.Mention), std::string::npos) << result.Errors;
  }
}
