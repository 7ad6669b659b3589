// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourPlaces.h"

#include "DataRim.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
constexpr vtkIdType kMostRows = 300;

/// Crossings of one pair of neighbouring samples.
class Crossings
{
public:
  Crossings(vtkImageData* heights, double interval)
    : Heights(heights)
    , Rim(heights)
    , Interval(interval)
    , Width(heights->GetDimensions()[0])
    , Height(heights->GetDimensions()[1])
  {
  }

  std::vector<ContourPlace> Find()
  {
    const vtkIdType rows = std::max<vtkIdType>(1, this->Height / kMostRows);
    const vtkIdType columns = std::max<vtkIdType>(1, this->Width / kMostRows);
    for (vtkIdType j = 1; j + 1 < this->Height; ++j)
    {
      for (vtkIdType i = 1; i + 1 < this->Width; ++i)
      {
        if (j % rows == 0)
        {
          this->Add(i, j, 1);
        }
        if (i % columns == 0)
        {
          this->Add(i, j, this->Width);
        }
      }
    }
    this->Scatter();
    return std::move(this->Places);
  }

private:
  void Add(vtkIdType i, vtkIdType j, vtkIdType step)
  {
    const vtkIdType from = i + this->Width * j;
    const bool isInside = this->Rim.IsCell(i, j) && this->Rim.IsCell(i - 1, j) &&
      this->Rim.IsCell(i, j - 1) && this->Rim.IsCell(i - 1, j - 1);
    if (!isInside)
    {
      return;
    }
    const double low = this->Rim.GetHeight(from);
    const double high = this->Rim.GetHeight(from + step);
    const double level = this->Interval * std::ceil(std::min(low, high) / this->Interval);
    if (low == high || level > std::max(low, high))
    {
      return;
    }
    const double t = (level - low) / (high - low);
    const std::array<double, 3> a = this->Rim.GetPoint(from, 0.0);
    const std::array<double, 3> b = this->Rim.GetPoint(from + step, 0.0);
    const double* spacing = this->Heights->GetSpacing();
    const double turned = this->Rim.GetPoint(from + this->Width, 0.0)[1] < a[1] ? -1.0 : 1.0;
    const double east =
      (this->Rim.GetHeight(from + 1) - this->Rim.GetHeight(from - 1)) / spacing[0];
    const double north = turned *
      (this->Rim.GetHeight(from + this->Width) - this->Rim.GetHeight(from - this->Width)) /
      spacing[1];
    const double length = std::hypot(east, north);
    if (length > 0.0)
    {
      this->Places.push_back({ { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) },
        { -north / length * spacing[0], east / length * spacing[0] }, level });
    }
  }

  /// Neighbours in the list are far from each other afterwards.
  void Scatter()
  {
    constexpr double kGolden = 0.6180339887498949;
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < this->Places.size(); ++k)
    {
      order.emplace_back(std::fmod(static_cast<double>(k) * kGolden, 1.0), k);
    }
    std::sort(order.begin(), order.end());
    std::vector<ContourPlace> places;
    places.reserve(order.size());
    for (const auto& [ignored, k] : order)
    {
      places.push_back(this->Places[k]);
    }
    this->Places = std::move(places);
  }

  vtkImageData* Heights;
  DataRim Rim;
  double Interval;
  vtkIdType Width;
  vtkIdType Height;
  std::vector<ContourPlace> Places;
};
}

//------------------------------------------------------------------------------
std::vector<ContourPlace> FindContourPlaces(vtkImageData* heights, double interval)
{
  return Crossings(heights, interval).Find();
}
