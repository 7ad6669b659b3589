// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From an array of heights to the first complete picture; FirstPicture.py does the same in Python:
 *
 *   BenchmarkFirstPicture [SIDE]     default 4096
 *
 * Prints milliseconds for SIDE x SIDE floats and 640 x 480 pixels.
 */
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainActor.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

int main(int argc, char* argv[])
{
  const int side = argc > 1 ? std::atoi(argv[1]) : 4096;
  std::vector<float> waves(side);
  for (int i = 0; i < side; ++i)
  {
    waves[i] = static_cast<float>(10.0 * std::sin(0.01 * i));
  }
  std::vector<float> field;
  field.reserve(static_cast<std::size_t>(side) * side);
  for (const float north : waves)
  {
    for (const float east : waves)
    {
      field.push_back(north + east);
    }
  }

  const auto begin = std::chrono::steady_clock::now();
  vtkNew<vtkFloatArray> heights;
  heights->SetArray(field.data(), static_cast<vtkIdType>(field.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, 1);
  image->GetPointData()->SetScalars(heights);
  vtkNew<vtkTerrainActor> terrain;
  terrain->SetInputData(image);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(terrain);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(640, 480);
  window->AddRenderer(renderer);
  window->Render();
  window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
  std::printf("%.1f\n", time.count());
  return EXIT_SUCCESS;
}
