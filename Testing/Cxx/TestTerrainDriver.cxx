// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A word of VTKTERRAIN_DRIVER that is none, is told once.
#include "vtkTerrainTesting.h"

#include "vtkTerrainActor.h"
#include "vtkTerrainSource.h"

#include "vtkNew.h"
#include "vtkStringOutputWindow.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

TEST(TerrainDriver, UnknownWordsAreOneWarning)
{
  setenv("VTKTERRAIN_DRIVER", "nonsense", 1);
  const vtkNew<vtkStringOutputWindow> told;
  vtkOutputWindow::SetInstance(told);
  const vtkNew<vtkTerrainSource> source;
  source->SetDimensions(33, 33);
  const vtkNew<vtkTerrainActor> terrain;
  terrain->SetInputConnection(source->GetOutputPort());
  vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(40, 30);
  scene.Renderer->AddActor(terrain);
  scene.Renderer->ResetCamera();
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_GT(vtkTerrainTesting::DrawnShare(vtkTerrainTesting::Render(scene.Window)), 0.1);
  }
  vtkOutputWindow::SetInstance(nullptr);
  const std::string output = told->GetOutput();
  const std::string word = "VTKTERRAIN_DRIVER has \"nonsense\"";
  const std::size_t first = output.find(word);
  ASSERT_NE(first, std::string::npos) << output;
  EXPECT_EQ(output.find(word, first + 1), std::string::npos) << output;
}
