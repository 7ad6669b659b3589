// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkTerrainActor that judges how high a terrain is for its extent, and how steep.
#include "vtkTerrainActor.h"

#include "core/grid/Constants.h"
#include "core/grid/Relief.h"
#include "data/GlobeData.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
/// Samples that are looked at, at most about.
constexpr vtkIdType kMostOfRelief = 1000000;

std::vector<double> SomeHeights(vtkImageData* heights)
{
  std::vector<double> samples;
  vtkDataArray* scalars = heights->GetPointData()->GetScalars();
  vtkUnsignedCharArray* ghosts = heights->GetPointGhostArray();
  const vtkIdType count = scalars ? scalars->GetNumberOfTuples() : 0;
  // odd, so that it does not stay in some columns of a raster of even width
  const vtkIdType step = count / kMostOfRelief | 1;
  samples.reserve(static_cast<std::size_t>(count / step + 1));
  for (vtkIdType k = 0; k < count; k += step)
  {
    if (!ghosts || (ghosts->GetValue(k) & vtkDataSetAttributes::HIDDENPOINT) == 0)
    {
      samples.push_back(scalars->GetComponent(k, 0));
    }
  }
  return samples;
}

/// Sides of a cell, in the unit of heights; on a globe in metres.
std::array<double, 2> SidesOfCell(vtkImageData* heights, const terrain::GlobeGrid* globe, int row)
{
  const double* spacing = heights->GetSpacing();
  if (!globe)
  {
    return { spacing[0], spacing[1] };
  }
  const double south = globe->Latitudes[static_cast<std::size_t>(row)];
  const double north = globe->Latitudes[static_cast<std::size_t>(row) + 1];
  const double radius = globe->Body.Equatorial;
  return { globe->Step * radius * std::cos(0.5 * (south + north)), (north - south) * radius };
}

/// Slope in the middle of a cell of some sides, in degrees; NaN where one of its samples has no
/// height.
double SlopeOfCell(vtkImageData* heights, const std::array<double, 2>& sides, int column, int row)
{
  vtkDataArray* scalars = heights->GetPointData()->GetScalars();
  vtkUnsignedCharArray* ghosts = heights->GetPointGhostArray();
  const vtkIdType columns = heights->GetDimensions()[0];
  const auto height = [&](int i, int j)
  {
    const vtkIdType at = (row + j) * columns + column + i;
    const bool isHidden = ghosts && (ghosts->GetValue(at) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    return isHidden ? std::numeric_limits<double>::quiet_NaN() : scalars->GetComponent(at, 0);
  };
  const double east = height(1, 0) + height(1, 1) - height(0, 0) - height(0, 1);
  const double north = height(0, 1) + height(1, 1) - height(0, 0) - height(1, 0);
  return std::atan(0.5 * std::hypot(east / sides[0], north / sides[1])) / terrain::kDegree;
}

/// Of cells in columns and rows at equal distances.
std::vector<double> SomeSlopes(vtkImageData* heights)
{
  std::vector<double> slopes;
  const int* dimensions = heights->GetDimensions();
  if (!heights->GetPointData()->GetScalars())
  {
    return slopes;
  }
  const double share = static_cast<double>(heights->GetNumberOfPoints()) / kMostOfRelief;
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(share))));
  const auto found = terrain::GlobeData::Get(heights);
  const terrain::GlobeGrid* globe = found && found->WhyNot().empty() ? found.get() : nullptr;
  for (int row = 0; row + 1 < dimensions[1]; row += step)
  {
    const std::array<double, 2> sides = SidesOfCell(heights, globe, row);
    for (int column = 0; column + 1 < dimensions[0]; column += step)
    {
      slopes.push_back(SlopeOfCell(heights, sides, column, row));
    }
  }
  return slopes;
}

/// In the unit of heights; on a globe along the lines of its grid through the middle of them.
double ExtentOf(vtkImageData* heights)
{
  if (const auto globe = terrain::GlobeData::Get(heights); globe && globe->WhyNot().empty())
  {
    const double south = globe->Latitudes.front();
    const double north = globe->Latitudes.back();
    const double radius = globe->Body.Equatorial;
    const double across = globe->Cells().x * globe->Step * radius * std::cos(0.5 * (south + north));
    return std::sqrt(across * (north - south) * radius);
  }
  const int* dimensions = heights->GetDimensions();
  const double* spacing = heights->GetSpacing();
  return std::sqrt(std::abs(spacing[0] * (dimensions[0] - 1) * spacing[1] * (dimensions[1] - 1)));
}
}

//------------------------------------------------------------------------------
double vtkTerrainActor::GetReliefShare(vtkImageData* heights)
{
  const double extent = heights ? ExtentOf(heights) : 0.0;
  if (!(extent > 0.0))
  {
    return 0.0;
  }
  std::vector<double> samples = SomeHeights(heights);
  return terrain::ReliefOf(samples) / extent;
}

//------------------------------------------------------------------------------
double vtkTerrainActor::SuggestExaggeration(vtkImageData* heights, bool onGlobe)
{
  // all the world is as wide as the way round it, 3.1 diameters
  constexpr double kOfGlobe = 2.0;
  const bool round = onGlobe || terrain::GlobeData::Has(heights);
  return terrain::SuggestExaggeration(GetReliefShare(heights), round ? 1.0 / kOfGlobe : 1.0);
}

//------------------------------------------------------------------------------
double vtkTerrainActor::SuggestSteepestSlope(vtkImageData* heights)
{
  std::vector<double> slopes = heights ? SomeSlopes(heights) : std::vector<double>();
  return terrain::SuggestSteepest(slopes);
}
