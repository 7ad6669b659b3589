// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataRim.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace
{
using Facing = DataRim::Facing;

/// Sides of one direction in a row that are a wall of the ground, not a step of the grid.
constexpr int kWallCells = 8;
/// Sides before and behind that share in the facing of a step.
constexpr int kSmoothedSides = 10;

void Add(Facing& sum, const Facing& more)
{
  sum[0] += more[0];
  sum[1] += more[1];
}

Facing Scaled(const Facing& facing)
{
  const double length = std::hypot(facing[0], facing[1]);
  return length > 0.0 ? Facing{ facing[0] / length, facing[1] / length } : facing;
}

/// True for sides that have so many others before and behind them which face as they do.
std::vector<bool> FindWalls(
  const std::vector<DataRim::Side>& sides, const std::vector<Facing>& facings)
{
  std::unordered_multimap<vtkIdType, std::size_t> beginning;
  for (std::size_t k = 0; k < sides.size(); ++k)
  {
    beginning.emplace(sides[k].From, k);
  }
  std::vector<bool> areWalls(sides.size(), false);
  for (std::size_t k = 0; k < sides.size(); ++k)
  {
    std::vector<std::size_t> run{ k };
    for (bool goesOn = true; goesOn && run.size() < kWallCells;)
    {
      const auto [first, end] = beginning.equal_range(sides[run.back()].To);
      const auto next = std::find_if(
        first, end, [&](const auto& side) { return facings[side.second] == facings[k]; });
      goesOn = next != end;
      if (goesOn)
      {
        run.push_back(next->second);
      }
    }
    for (std::size_t side = 0; run.size() == kWallCells && side < run.size(); ++side)
    {
      areWalls[run[side]] = true;
    }
  }
  return areWalls;
}

/// Sums of the facings of the sides around each sample, those near by more than those far away.
std::unordered_map<vtkIdType, Facing> SumFacings(
  const std::vector<DataRim::Side>& sides, const std::vector<Facing>& facings)
{
  std::unordered_map<vtkIdType, Facing> sums;
  for (std::size_t k = 0; k < sides.size(); ++k)
  {
    Add(sums[sides[k].From], facings[k]);
    Add(sums[sides[k].To], facings[k]);
  }
  for (int pass = 0; pass < kSmoothedSides; ++pass)
  {
    const std::unordered_map<vtkIdType, Facing> before = sums;
    for (const DataRim::Side& side : sides)
    {
      Add(sums[side.From], before.at(side.To));
      Add(sums[side.To], before.at(side.From));
    }
  }
  return sums;
}
}

//------------------------------------------------------------------------------
DataRim::DataRim(vtkImageData* heights)
  : Heights(heights)
  , Samples(heights->GetPointData()->GetScalars())
  , Ghosts(heights->GetPointGhostArray())
  , Width(heights->GetDimensions()[0])
  , Height(heights->GetDimensions()[1])
{
  std::vector<bool> samples(static_cast<std::size_t>(this->Width * this->Height));
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    samples[k] = this->HasHeight(static_cast<vtkIdType>(k));
  }
  this->AreCells.resize(samples.size());
  const auto width = static_cast<std::size_t>(this->Width);
  for (std::size_t k = 0; k + width + 1 < samples.size(); ++k)
  {
    const bool isLastColumn = k % width == width - 1;
    this->AreCells[k] =
      !isLastColumn && samples[k] && samples[k + 1] && samples[k + width] && samples[k + width + 1];
  }
}

//------------------------------------------------------------------------------
bool DataRim::HasHeight(vtkIdType sample) const
{
  const bool hidden =
    this->Ghosts && (this->Ghosts->GetValue(sample) & vtkDataSetAttributes::HIDDENPOINT) != 0;
  return !hidden && std::isfinite(this->Samples->GetComponent(sample, 0));
}

//------------------------------------------------------------------------------
bool DataRim::IsCell(vtkIdType column, vtkIdType row) const
{
  return column >= 0 && row >= 0 && column + 1 < this->Width && row + 1 < this->Height &&
    this->AreCells[static_cast<std::size_t>(column + this->Width * row)];
}

//------------------------------------------------------------------------------
double DataRim::GetHeight(vtkIdType sample) const
{
  return this->Samples->GetComponent(sample, 0);
}

//------------------------------------------------------------------------------
std::array<double, 3> DataRim::GetPoint(vtkIdType sample, double height) const
{
  std::array<double, 3> point{};
  this->Heights->GetPoint(sample, point.data());
  point[2] += height;
  return point;
}

//------------------------------------------------------------------------------
std::vector<DataRim::Side> DataRim::FindSides() const
{
  // rows may run south: the cell is to the left all the same
  const bool turned = this->Heights->GetDirectionMatrix()->GetElement(1, 1) < 0.0;
  std::vector<Side> sides;
  for (vtkIdType j = 0; j + 1 < this->Height; ++j)
  {
    for (vtkIdType i = 0; i + 1 < this->Width; ++i)
    {
      if (!this->IsCell(i, j))
      {
        continue;
      }
      const vtkIdType first = i + this->Width * j;
      const vtkIdType across = first + this->Width;
      const auto add = [&](bool isCell, bool isBorder, vtkIdType from, vtkIdType to)
      {
        if (!isCell)
        {
          sides.push_back(turned ? Side{ to, from, isBorder } : Side{ from, to, isBorder });
        }
      };
      add(this->IsCell(i, j - 1), j == 0, first, first + 1);
      add(this->IsCell(i + 1, j), i + 2 == this->Width, first + 1, across + 1);
      add(this->IsCell(i, j + 1), j + 2 == this->Height, across + 1, across);
      add(this->IsCell(i - 1, j), i == 0, across, first);
    }
  }
  return sides;
}

//------------------------------------------------------------------------------
std::vector<std::array<DataRim::Facing, 2>> DataRim::FindFacings(
  const std::vector<Side>& sides) const
{
  std::vector<Facing> own;
  own.reserve(sides.size());
  for (const Side& side : sides)
  {
    const std::array<double, 3> from = this->GetPoint(side.From, 0.0);
    const std::array<double, 3> to = this->GetPoint(side.To, 0.0);
    // exactly the same for all sides of one direction
    const auto sign = [](double step) { return static_cast<double>((step > 0.0) - (step < 0.0)); };
    const bool isAlongX = std::abs(to[0] - from[0]) > std::abs(to[1] - from[1]);
    own.push_back(
      isAlongX ? Facing{ 0.0, sign(from[0] - to[0]) } : Facing{ sign(to[1] - from[1]), 0.0 });
  }
  const std::vector<bool> areWalls = FindWalls(sides, own);
  const std::unordered_map<vtkIdType, Facing> sums = SumFacings(sides, own);
  std::vector<std::array<Facing, 2>> facings;
  facings.reserve(sides.size());
  for (std::size_t k = 0; k < sides.size(); ++k)
  {
    const auto at = [&](vtkIdType sample)
    {
      const Facing smooth = sides[k].IsBorder || areWalls[k] ? own[k] : Scaled(sums.at(sample));
      return std::hypot(smooth[0], smooth[1]) > 0.0 ? smooth : own[k];
    };
    facings.push_back({ at(sides[k].From), at(sides[k].To) });
  }
  return facings;
}

//------------------------------------------------------------------------------
std::vector<std::array<vtkIdType, 2>> DataRim::FindRuns(vtkIdType row) const
{
  std::vector<std::array<vtkIdType, 2>> runs;
  for (vtkIdType i = 0; i + 1 < this->Width; ++i)
  {
    if (this->IsCell(i, row) && this->IsCell(i - 1, row))
    {
      runs.back()[1] = i;
    }
    else if (this->IsCell(i, row))
    {
      runs.push_back({ i, i });
    }
  }
  return runs;
}
