// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/PixelRays.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr int Pixels = 200; // each way

/// Cells of 10 x 20 units, codes of 0.5 units.
glm::dmat4 GridToView()
{
  const glm::dmat4 view = glm::lookAt(
    glm::dvec3(0.0, -300.0, 400.0), glm::dvec3(20.0, 10.0, 0.0), glm::dvec3(0.0, 0.0, 1.0));
  return glm::scale(view, glm::dvec3(10.0, 20.0, 0.5));
}

TEST(PixelRays, ExtentsInPerspectiveGrowWithDistance)
{
  const double angle = 0.5;
  const terrain::PixelRays rays = terrain::MakePixelRays(
    GridToView(), glm::perspective(angle, 1.0, 1.0, 1000.0), glm::dvec4(0.0, 0.0, Pixels, Pixels));
  const glm::dvec4 extent = terrain::PixelExtent(rays, GridToView(), 3.0);
  const double pixel = 2.0 * std::tan(0.5 * angle) / Pixels; // units per unit of distance
  EXPECT_NEAR(extent.x, 0.0, 1e-12);
  EXPECT_NEAR(extent.y, 0.0, 1e-12);
  EXPECT_NEAR(extent.z, 3.0 * pixel / 20.0, 1e-12); // the longer side of a cell counts
  EXPECT_NEAR(extent.w, 3.0 * pixel / 0.5, 1e-12);
}

TEST(PixelRays, ExtentsInParallelAreTheSameEverywhere)
{
  const terrain::PixelRays rays = terrain::MakePixelRays(GridToView(),
    glm::ortho(-80.0, 80.0, -60.0, 60.0, 1.0, 1000.0), glm::dvec4(7.0, 9.0, Pixels, Pixels));
  const glm::dvec4 extent = terrain::PixelExtent(rays, GridToView(), 2.0);
  EXPECT_NEAR(extent.x, 2.0 * (120.0 / Pixels) / 20.0, 1e-12); // the shorter side of a pixel
  EXPECT_NEAR(extent.y, 2.0 * (120.0 / Pixels) / 0.5, 1e-12);
  EXPECT_NEAR(extent.z, 0.0, 1e-12);
  EXPECT_NEAR(extent.w, 0.0, 1e-12);
}
}
