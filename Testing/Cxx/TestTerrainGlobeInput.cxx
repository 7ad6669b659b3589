// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Global rasters as files have them, laid on a globe and drawn, and eyes inside the planet: against
// brute force from the samples of the file.
#include "vtkTerrainTestGlobeDrawing.h"
#include "vtkTerrainTestGlobeJudge.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkTerrainActor.h"
#include "vtkTestErrorObserver.h"

using namespace vtkTerrainTesting;

namespace
{
/// How much larger than true heights are drawn, so that a wrong place shows.
constexpr double kDrawnHigher = 15.0;
/// Slope of what is drawn, away from the axis.
constexpr double kSteepest = 6.0;
/// Largest difference of distances: a part of them, and metres.
constexpr double kPart = 1e-5;
constexpr double kMetres = 20.0;

vtkSmartPointer<vtkImageData> MakeImage(const DegreesRaster& raster)
{
  const auto image =
    MakeDegrees(raster.West, raster.South, raster.Step, raster.Columns, raster.Rows,
      [&raster](int i, int j)
      {
        const double height = raster.Sample(i, j);
        return std::isnan(height) ? 0.0 : height;
      });
  vtkUnsignedCharArray* ghosts = image->AllocatePointGhostArray();
  for (int k = 0; k < raster.Columns * raster.Rows; ++k)
  {
    const bool hidden = std::isnan(raster.Sample(k % raster.Columns, k / raster.Columns));
    ghosts->SetValue(k, hidden ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  return image;
}

/// Height of the output of the filter at a place in degrees, by its field data; NaN without.
double HeightOnGlobe(vtkImageData* globe, double longitude, double latitude)
{
  vtkDataArray* columns = globe->GetFieldData()->GetArray("GlobeLongitudes");
  vtkDataArray* rows = globe->GetFieldData()->GetArray("GlobeLatitudes");
  const int* size = globe->GetDimensions();
  double x = longitude - columns->GetComponent(0, 0);
  x = (x - 360.0 * std::floor(x / 360.0)) / columns->GetComponent(0, 1);
  const int i = static_cast<int>(x);
  int j = 0;
  while (j < size[1] && rows->GetComponent(j, 0) <= latitude)
  {
    ++j;
  }
  if (j == 0 || j == size[1] || i + 1 >= size[0])
  {
    return terrain::kNaN;
  }
  const double south = rows->GetComponent(j - 1, 0);
  const double y = (latitude - south) / (rows->GetComponent(j, 0) - south);
  const auto at = [globe](int column, int row)
  {
    return globe->GetPointGhostArray() &&
        globe->GetPointGhostArray()->GetValue(column + globe->GetDimensions()[0] * row) != 0
      ? terrain::kNaN
      : globe->GetScalarComponentAsDouble(column, row, 0, 0);
  };
  return (at(i, j - 1) * (i + 1 - x) + at(i + 1, j - 1) * (x - i)) * (1.0 - y) +
    (at(i, j) * (i + 1 - x) + at(i + 1, j) * (x - i)) * y;
}

struct Judged
{
  int Hits = 0;
  int Wrong = 0;
  double Largest = 0.0;
};

/// Every fifth pixel of a picture each way. Pixels on a border, where the judge tells another story
/// a fifth of a pixel beside, may be either.
Judged Judge(Globe& globe, const GlobeJudge& judge)
{
  vtkImageData* distances = globe.Shown.Distances();
  const terrain::PixelRays rays = globe.Rays();
  Judged result;
  for (int k = 0; k < DrawingWidth / 5 * (DrawingHeight / 5); ++k)
  {
    const glm::ivec2 pixel(2 + 5 * (k % (DrawingWidth / 5)), 2 + 5 * (k / (DrawingWidth / 5)));
    const auto cast = [&](double x, double y)
    {
      const glm::dvec2 at(pixel.x + 0.5 + x, pixel.y + 0.5 + y);
      const glm::dvec3 from = terrain::AtPixel(rays.OriginGC, at);
      const glm::dvec3 way = terrain::AtPixel(rays.DirectionGC, at);
      return judge.Cast({ from.x, from.y, from.z }, { way.x, way.y, way.z });
    };
    const double drawn = distances->GetScalarComponentAsDouble(pixel.x, pixel.y, 0, 0);
    const double expected = cast(0.0, 0.0);
    const bool both = !std::isnan(drawn) && !std::isnan(expected);
    const double off = both ? std::abs(drawn - expected) : 0.0;
    result.Hits += both ? 1 : 0;
    const bool right =
      std::isnan(drawn) == std::isnan(expected) && (!both || off <= kPart * expected + kMetres);
    if (right)
    {
      result.Largest = std::max(result.Largest, off);
      continue;
    }
    double nearest = terrain::kInfinity;
    double farthest = -terrain::kInfinity;
    bool agrees = false;
    for (int side = 0; side < 9; ++side)
    {
      const double beside = cast(0.2 * (side % 3 - 1), 0.2 * (side / 3 - 1));
      agrees = agrees || std::isnan(beside) == std::isnan(drawn);
      nearest = std::isnan(beside) ? nearest : std::min(nearest, beside);
      farthest = std::isnan(beside) ? farthest : std::max(farthest, beside);
    }
    const bool within =
      std::isnan(drawn) || (drawn >= nearest - kMetres && drawn <= farthest + kMetres);
    const bool isBorder = farthest - nearest > 0.02 * farthest || !both;
    result.Wrong += agrees && within && isBorder ? 0 : 1;
  }
  return result;
}

/// Places of a raster at which eyes look straight or aslant down.
std::vector<Point> ViewsOf(const DegreesRaster& raster)
{
  const double east = raster.West + raster.Step * (raster.Columns - 1);
  const double north = raster.South + raster.Step * (raster.Rows - 1);
  if (raster.Around == 0)
  {
    return { { 0.5 * (raster.West + east), 0.5 * (raster.South + north), 0.7 },
      { east, north, 0.5 } };
  }
  return { { raster.West, 10.0, 1.2 }, { 180.0, -30.0, 0.6 }, { 0.0, 90.0, 0.5 },
    { 77.0, -88.0, 0.3 } };
}
}

//------------------------------------------------------------------------------
// Samples lie where the file says, whatever was added, left out or divided.
TEST(TerrainGlobeInput, SamplesLieWhereTheFileSays)
{
  for (const DegreesRaster& raster : KindsOfDegrees())
  {
    SCOPED_TRACE(raster.Name);
    const auto globe = LayOnGlobe(MakeImage(raster), raster.Equatorial, raster.Polar);
    ASSERT_GT(globe->GetNumberOfPoints(), 0);
    int heights = 0;
    for (int k = 0; k < 4000; ++k)
    {
      const double longitude = -180.0 + std::fmod(k * 222.49223594996215, 360.0);
      const double latitude = -90.0 + (k + 0.5) * 180.0 / 4000.0;
      const double expected = raster.HeightAt(longitude, latitude);
      const double found = HeightOnGlobe(globe, longitude, latitude);
      ASSERT_EQ(std::isnan(found), std::isnan(expected)) << longitude << " " << latitude;
      heights += std::isnan(found) ? 0 : 1;
      if (!std::isnan(found))
      {
        // means of a row are whole numbers; a rounded step drifts by a part of a cell
        ASSERT_NEAR(found, expected, 1.0) << longitude << " " << latitude;
      }
    }
    EXPECT_GT(heights, raster.Around > 0 ? 3999 : 20);
  }
}

TEST(TerrainGlobeInput, IsDrawnWhereTheFileSays)
{
  for (const DegreesRaster& raster : KindsOfDegrees())
  {
    SCOPED_TRACE(raster.Name);
    const double scale = raster.Equatorial / 6378137.0;
    const double higher = kDrawnHigher * scale;
    Globe globe(LayOnGlobe(MakeImage(raster), raster.Equatorial, raster.Polar));
    globe.Shown.Mapper->SetVerticalExaggeration(higher);
    const GlobeJudge judged(raster, higher, kSteepest);
    for (const Point& view : ViewsOf(raster))
    {
      SCOPED_TRACE(view[0]);
      const double up = view[2] * raster.Equatorial;
      globe.Look({ view[0] - 20.0 * view[2], std::max(view[1] - 25.0 * view[2], -90.0), up },
        { view[0], view[1], 0.0 });
      const Judged result = Judge(globe, judged);
      EXPECT_GE(result.Hits, 15);
      EXPECT_EQ(result.Wrong, 0);
      RecordProperty("largest", std::to_string(result.Largest));
    }
  }
}

// From within the planet what lies above the ground beyond is seen, and nothing of the underside.
TEST(TerrainGlobeInput, EyesMayBeInside)
{
  const std::vector<DegreesRaster> kinds = KindsOfDegrees();
  for (const std::size_t kind : { std::size_t(0), std::size_t(7), kinds.size() - 1 })
  {
    const DegreesRaster& raster = kinds[kind];
    SCOPED_TRACE(raster.Name);
    const double higher = kDrawnHigher * raster.Equatorial / 6378137.0;
    Globe globe(LayOnGlobe(MakeImage(raster), raster.Equatorial, raster.Polar));
    globe.Shown.Mapper->SetVerticalExaggeration(higher);
    const GlobeJudge judged(raster, higher, kSteepest);
    const double low = -2.0 * judged.Highest;
    for (const auto& [eye, focus, far] :
      { std::tuple(Point{ 0.0, 0.0, -raster.Equatorial }, Point{ 170.0, 0.0, 0.0 }, false),
        std::tuple(Point{ 0.0, 90.0, -0.5 * raster.Polar }, Point{ 0.0, 90.0, 0.0 }, false),
        std::tuple(Point{ 0.0, 90.0, -0.5 * raster.Polar }, Point{ 0.0, -90.0, 0.0 }, false),
        std::tuple(Point{ 170.0, -20.0, low }, Point{ 171.0, -19.0, 0.0 }, false),
        std::tuple(Point{ 170.0, -20.0, low }, Point{ 10.0, 19.0, 0.0 }, false),
        std::tuple(Point{ 170.0, -20.0, -10.0 }, Point{ 172.0, -19.0, 2e4 }, true) })
    {
      SCOPED_TRACE(eye[1]);
      globe.Look({ eye[0], eye[1], eye[2] }, { focus[0], focus[1], focus[2] });
      globe.Shown.Camera()->SetClippingRange(1.0, 5.0 * raster.Equatorial);
      const Judged result = Judge(globe, judged);
      EXPECT_EQ(result.Wrong, 0);
      EXPECT_TRUE(far || result.Hits == 0) << result.Hits;
    }
  }
}

// What is left out does not make the filter work again at each update.
TEST(TerrainGlobeInput, WorksOnce)
{
  for (const DegreesRaster& raster : KindsOfDegrees())
  {
    SCOPED_TRACE(raster.Name);
    const vtkNew<vtkTerrainGlobe> globe;
    globe->SetInputData(MakeImage(raster));
    int runs = 0;
    const vtkNew<vtkCallbackCommand> count;
    count->SetClientData(&runs);
    count->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
    globe->AddObserver(vtkCommand::EndEvent, count);
    globe->Update();
    globe->Update();
    globe->UpdateWholeExtent();
    EXPECT_EQ(runs, 1);
  }
}

// What cannot be mended is refused with a remedy.
TEST(TerrainGlobeInput, RefusesWhatContradictsItself)
{
  const auto refusal = [](const DegreesRaster& raster)
  {
    const vtkNew<vtkTest::ErrorObserver> errors;
    const vtkNew<vtkTerrainGlobe> globe;
    globe->AddObserver(vtkCommand::ErrorEvent, errors);
    globe->SetInputData(MakeImage(raster));
    globe->Update();
    EXPECT_EQ(globe->GetOutput()->GetNumberOfPoints(), 0);
    return globe->GetErrorMessage();
  };
  const auto raster = [](double west, double south, double step, int columns, int rows)
  {
    DegreesRaster made;
    made.West = west;
    made.South = south;
    made.Step = step;
    made.Columns = columns;
    made.Rows = rows;
    made.Sample = [](int i, int j) { return i + j; };
    return made;
  };
  const auto has = [](const std::string& why, const char* word)
  { return why.find(word) != std::string::npos; };
  // the second round is another one; steps of which no number goes round
  EXPECT_TRUE(has(refusal(raster(-359.0, -89.0, 2.0, 360, 90)), "more than once"));
  EXPECT_TRUE(has(refusal(raster(-359.0, -89.0, 0.77, 600, 90)), "more than once"));
  DegreesRaster same = raster(-359.0, -89.0, 0.77, 600, 90);
  same.Sample = [](int, int) { return 5.0; };
  EXPECT_TRUE(has(refusal(same), "more than once"));
  // heights beyond the poles
  EXPECT_TRUE(has(refusal(raster(-179.0, -93.0, 2.0, 180, 94)), "-90 to 90"));
  EXPECT_TRUE(has(refusal(raster(0.0, 89.0, 0.5, 10, 4)), "-90 to 90"));
  // all of it beyond, and empty
  DegreesRaster off = raster(0.0, 91.0, 1.0, 10, 10);
  off.Sample = [](int, int) { return terrain::kNaN; };
  EXPECT_TRUE(has(refusal(off), "at least two meridians and two parallels"));
  // one meridian, one parallel, one sample
  EXPECT_TRUE(has(refusal(raster(10.0, -89.0, 1.0, 1, 180)), "two meridians"));
  EXPECT_TRUE(has(refusal(raster(-180.0, 10.0, 1.0, 360, 1)), "two parallels"));
  EXPECT_TRUE(has(refusal(raster(0.0, 0.0, 1.0, 1, 1)), "two meridians"));
}

//------------------------------------------------------------------------------
// Slopes count metres both ways, although the grid counts degrees.
TEST(TerrainGlobeInput, ScalesOfSlopesAreThoseOfTheGround)
{
  constexpr double kRadius = 6371000.0;
  constexpr double kStep = 0.02; // heights are 16-bit numbers
  const double rise = kRadius * kStep * terrain::kDegree * std::tan(12.0 * terrain::kDegree);
  const auto north =
    MakeDegrees(10.0, 60.0, kStep, 60, 60, [rise](int, int j) { return rise * j; });
  const auto east = MakeDegrees(10.0, 60.0, kStep, 60, 60, [rise](int i, int) { return rise * i; });
  for (const auto& [image, steepest] : { std::pair(north, 15.0), std::pair(east, 25.0) })
  {
    const auto globe = LayOnGlobe(image, kRadius, kRadius);
    // to the east cells are 0.48 to 0.50 times as wide
    EXPECT_EQ(vtkTerrainActor::SuggestSteepestSlope(globe), steepest);
  }
}
