// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Random ways from points of a surface to look for horizons on.
 */
#ifndef UnitTestOutlooks_h
#define UnitTestOutlooks_h

#include "core/grid/Constants.h"
#include "core/rays/Outlook.h"

#include <glm/glm.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace terrain
{
/// Sets the codes and the height of the point that an outlook is from.
template <typename Rays>
void SetCode(const OutlookSearch<Rays>& search, Outlook& outlook)
{
  outlook.codes = search.CellCodes(outlook.cell);
  outlook.code = search.rays.columns
    ? ColumnCode(outlook.codes, glm::greaterThanEqual(outlook.fraction, glm::vec2(0.5f)))
    : PatchCode(outlook.codes, outlook.fraction);
}

/// From within cells, their borders and their corners; in all directions, along axes and through
/// vertices; with tangents of low and high lights, and without bounds of them; to the end of the
/// grid and less far.
template <typename Rays>
std::vector<Outlook> RandomOutlooks(const OutlookSearch<Rays>& search, unsigned seed)
{
  constexpr int count = 1000;
  std::mt19937 random(seed);
  const auto number = [&](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  const glm::ivec2 cells = search.rays.heights.size - 1;
  const auto relief = static_cast<double>(search.rays.heights.maximumCode) + 1e-3;
  std::vector<Outlook> outlooks;
  for (int k = 0; k < 20 * count && static_cast<int>(outlooks.size()) < count; ++k)
  {
    Outlook outlook;
    outlook.cell = { static_cast<int>(number(0.0, cells.x)),
      static_cast<int>(number(0.0, cells.y)) };
    outlook.cell = glm::min(outlook.cell, cells - 1);
    outlook.fraction = { number(0.0, 1.0), number(0.0, 1.0) };
    outlook.fraction.x = k % 5 == 0 ? std::round(outlook.fraction.x) : outlook.fraction.x;
    outlook.fraction.y = k % 10 == 0 ? std::round(outlook.fraction.y) : outlook.fraction.y;
    SetCode(search, outlook);
    const double turns = k % 7 == 0 ? std::floor(number(0.0, 8.0)) / 8.0 : number(0.0, 1.0);
    const double azimuth = 360.0 * kDegree * turns;
    outlook.direction = { std::sin(azimuth), std::cos(azimuth) };
    outlook.direction.x = std::abs(outlook.direction.x) < 1e-6f ? 0.0f : outlook.direction.x;
    outlook.direction.y = std::abs(outlook.direction.y) < 1e-6f ? 0.0f : outlook.direction.y;
    outlook.low = static_cast<float>(relief * (k % 3 == 0 ? -4.0 : number(-0.02, 0.3)));
    outlook.high = static_cast<float>(k % 3 == 0 ? 4.0 * relief : outlook.low + 0.02 * relief);
    outlook.end = k % 4 == 0 ? static_cast<float>(number(0.0, 20.0)) : 1e30f;
    if (glm::all(glm::greaterThanEqual(outlook.codes, glm::vec4(0.0f))))
    {
      outlooks.push_back(outlook);
    }
  }
  return outlooks;
}
}

#endif
