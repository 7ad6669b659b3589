// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonFill.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
constexpr int kLinesPerPixel = 4;

/// Where rings cross the lines of a picture, in pixels from the left border of the first one.
class RingCrossings
{
public:
  RingCrossings(vtkImageData* picture, const PlaneRings& rings)
    : Origin{ picture->GetOrigin()[0], picture->GetOrigin()[1] }
    , Spacing{ picture->GetSpacing()[0], picture->GetSpacing()[1] }
    , OfLines(static_cast<std::size_t>(picture->GetDimensions()[1]) * kLinesPerPixel)
  {
    for (const auto& ring : rings)
    {
      for (std::size_t k = 0; k < ring.size(); ++k)
      {
        this->AddSide(ring[k], ring[(k + 1) % ring.size()]);
      }
    }
  }

  /// Adds the part of each pixel of a row that lies inside, 0 to 1.
  void Cover(int row, std::vector<double>& parts)
  {
    for (std::size_t k = 0; k < kLinesPerPixel; ++k)
    {
      const std::size_t number = static_cast<std::size_t>(row) * kLinesPerPixel + k;
      std::vector<double>& line = this->OfLines[number];
      std::sort(line.begin(), line.end());
      for (std::size_t at = 0; at + 1 < line.size(); at += 2)
      {
        CoverSpan(line[at], line[at + 1], parts);
      }
    }
  }

private:
  void AddSide(const std::array<double, 2>& from, const std::array<double, 2>& to)
  {
    const auto lineOf = [this](double y)
    { return ((y - this->Origin[1]) / this->Spacing[1] + 0.5) * kLinesPerPixel - 0.5; };
    const std::array<double, 2> low = from[1] < to[1] ? from : to;
    const std::array<double, 2> high = from[1] < to[1] ? to : from;
    const double begin = std::ceil(lineOf(low[1]));
    const double end = std::ceil(lineOf(high[1]));
    const double last = std::min(end, static_cast<double>(this->OfLines.size()));
    for (double line = std::max(begin, 0.0); line < last; ++line)
    {
      const double share = (line - lineOf(low[1])) / (lineOf(high[1]) - lineOf(low[1]));
      const double x = low[0] + share * (high[0] - low[0]);
      this->OfLines[static_cast<std::size_t>(line)].push_back(
        (x - this->Origin[0]) / this->Spacing[0] + 0.5);
    }
  }

  static void CoverSpan(double begin, double end, std::vector<double>& parts)
  {
    begin = std::clamp(begin, 0.0, static_cast<double>(parts.size()));
    end = std::clamp(end, 0.0, static_cast<double>(parts.size()));
    for (auto k = static_cast<std::size_t>(begin); static_cast<double>(k) < end; ++k)
    {
      const auto left = static_cast<double>(k);
      const double part = std::min(end, left + 1.0) - std::max(begin, left);
      parts[k] += part / kLinesPerPixel;
    }
  }

  std::array<double, 2> Origin;
  std::array<double, 2> Spacing;
  std::vector<std::vector<double>> OfLines;
};

/// A colour over a pixel of which it covers a part.
void Blend(unsigned char* pixel, const std::array<double, 4>& color, double part)
{
  const double over = std::min(part, 1.0) * color[3];
  const double below = pixel[3] / 255.0 * (1.0 - over);
  const double alpha = over + below;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double mixed = (over * 255.0 * color[k] + below * pixel[k]) / std::max(alpha, 1e-9);
    pixel[k] = static_cast<unsigned char>(std::lround(mixed));
  }
  pixel[3] = static_cast<unsigned char>(std::lround(255.0 * alpha));
}
}

//------------------------------------------------------------------------------
void FillRings(vtkImageData* picture, const PlaneRings& rings, const std::array<double, 4>& color)
{
  RingCrossings crossings(picture, rings);
  const int* size = picture->GetDimensions();
  std::vector<double> parts(static_cast<std::size_t>(size[0]));
  for (int row = 0; row < size[1]; ++row)
  {
    std::fill(parts.begin(), parts.end(), 0.0);
    crossings.Cover(row, parts);
    auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(0, row, 0));
    for (std::size_t k = 0; k < parts.size(); ++k, pixel += 4)
    {
      if (parts[k] > 0.0)
      {
        Blend(pixel, color, parts[k]);
      }
    }
  }
}
