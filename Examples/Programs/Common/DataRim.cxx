// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataRim.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstddef>

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
