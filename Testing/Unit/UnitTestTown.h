// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A town as a surface model with a sample a metre: things that are thinner than a ray's step.
 */
#ifndef UnitTestTown_h
#define UnitTestTown_h

#include "UnitTestFields.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace terrain
{
/// Square town of size x size samples, 1 m apart: blocks of houses 6 to 30 m high with flat and
/// gabled roofs and walls one cell thin, chimneys and masts of one sample, trees whose crowns are
/// rough, streets between. The ground rises by 8 m. Heights in metres, to the centimetre.
inline TestField MakeTown(int size)
{
  TestField field("town", size, size,
    [](int i, int j) { return 100.0 + 4.0 * std::sin(0.004 * i) * std::cos(0.005 * j); });
  std::mt19937 generator(20261129u);
  const auto random = [&generator](double low, double high)
  { return low + (high - low) * (static_cast<double>(generator()) / 4294967296.0); };
  const auto raise = [&field, size](int i, int j, double height)
  {
    if (i >= 0 && j >= 0 && i < size && j < size)
    {
      double& sample =
        field.Samples[static_cast<std::size_t>(i) + static_cast<std::size_t>(size) * j];
      sample = std::max(sample, 0.01 * std::round(100.0 * height));
    }
  };
  for (int blockY = 0; blockY < size; blockY += 25)
  {
    for (int blockX = 0; blockX < size; blockX += 25)
    {
      const int width = static_cast<int>(random(6.0, 18.0));
      const int depth = static_cast<int>(random(6.0, 18.0));
      const double wall = 100.0 + random(6.0, 30.0);
      const double gable = random(-4.0, 5.0);
      for (int j = 0; j < depth; ++j)
      {
        for (int i = 0; i < width; ++i)
        {
          const double slope = 1.0 - std::abs(2.0 * i / (width - 1.0) - 1.0);
          raise(blockX + i + 2, blockY + j + 2, wall + std::max(gable, 0.0) * slope);
        }
      }
      raise(blockX + 4, blockY + 5, wall + random(1.0, 8.0));
      for (int tree = 0; tree < 3; ++tree)
      {
        const double x = blockX + random(0.0, 25.0);
        const double y = blockY + random(0.0, 25.0);
        const double radius = random(1.5, 4.5);
        const double top = random(5.0, 20.0);
        for (int j = static_cast<int>(y - radius); j <= y + radius; ++j)
        {
          for (int i = static_cast<int>(x - radius); i <= x + radius; ++i)
          {
            const double part = std::hypot(i - x, j - y) / radius;
            if (part < 1.0)
            {
              raise(i, j, 100.0 + top * (0.5 + 0.5 * std::sqrt(1.0 - part)) + random(-1.0, 1.0));
            }
          }
        }
      }
    }
  }
  return field;
}
}

#endif
