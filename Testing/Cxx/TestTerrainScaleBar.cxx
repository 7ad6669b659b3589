// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainScaleBar.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

TEST(TerrainScaleBar, RoundUnits)
{
  vtkNew<vtkTerrainScaleBar> bar;
  bar->SetMaximumLength(2345.0);
  bar->SetUnitsPerMetre(0.1);
  EXPECT_EQ(bar->GetLength(), 2000.0);
  EXPECT_EQ(bar->GetLabel(), "2 km");
  bar->Update();
  EXPECT_EQ(bar->GetOutput(0)->GetNumberOfPolys(), 4);
  EXPECT_NEAR(bar->GetOutput(0)->GetBounds()[1], 200.0, 1e-9);
  bar->SetMaximumLength(0.7);
  EXPECT_EQ(bar->GetLabel(), "50 cm");
}

TEST(TerrainScaleBar, ArrowPointsNorth)
{
  vtkNew<vtkTerrainScaleBar> bar;
  bar->SetNorth(3.0, 4.0);
  bar->SetArrowLength(10.0);
  bar->Update();
  double tip[3];
  double west[3];
  bar->GetOutput(1)->GetPoint(0, tip);
  bar->GetOutput(1)->GetPoint(1, west);
  EXPECT_NEAR(tip[0], 6.0, 1e-12);
  EXPECT_NEAR(tip[1], 8.0, 1e-12);
  EXPECT_GT(tip[0] * west[1] - tip[1] * west[0], 0.0) << "west lies to the left";
  bar->SetNorth(0.0, 0.0);
  bar->Update();
  EXPECT_EQ(bar->GetOutput(1)->GetNumberOfPolys(), 2);
}
