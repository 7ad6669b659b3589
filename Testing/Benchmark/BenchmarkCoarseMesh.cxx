// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Times of vtkTerrainCoarseMesh on 16-bit heights:
 *
 *   BenchmarkCoarseMesh [WIDTH HEIGHT [CELLS_PER_QUAD [REPEATS]]]    default 8192 5120 128 5
 *
 * Printed are the least and the median time in milliseconds, with the threads of vtkSMPTools as
 * they are and with one.
 */
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkShortArray.h"
#include "vtkTerrainCoarseMesh.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace
{
/// Hills with roughness from a fixed sequence.
void FillHeights(int width, int height, vtkImageData* image)
{
  image->SetDimensions(width, height, 1);
  vtkNew<vtkShortArray> heights;
  heights->SetNumberOfTuples(image->GetNumberOfPoints());
  short* values = heights->GetPointer(0);
  unsigned int state = 1;
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      state = state * 1664525U + 1013904223U;
      const double hills = 2000.0 * std::sin(0.003 * i) * std::cos(0.004 * j);
      *values++ = static_cast<short>(hills + static_cast<double>(state >> 26));
    }
  }
  image->GetPointData()->SetScalars(heights);
}

void Measure(vtkTerrainCoarseMesh* filter, int repeats)
{
  std::vector<double> milliseconds;
  for (int k = 0; k < repeats; ++k)
  {
    filter->Modified();
    const auto begin = std::chrono::steady_clock::now();
    filter->Update();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    milliseconds.push_back(time.count());
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf("%d threads: least %.1f ms, median %.1f ms, %lld triangles\n",
    vtkSMPTools::GetEstimatedNumberOfThreads(), milliseconds.front(),
    milliseconds[milliseconds.size() / 2],
    static_cast<long long>(filter->GetOutput()->GetNumberOfPolys()));
}
}

int main(int argc, char* argv[])
{
  const auto number = [argc, argv](int index, int otherwise)
  { return argc > index ? std::atoi(argv[index]) : otherwise; };
  const int width = number(1, 8192);
  const int height = number(2, 5120);
  const int cellsPerQuad = number(3, 128);
  const int repeats = number(4, 5);
  if (width < 1 || height < 1 || cellsPerQuad < 0 || repeats < 1)
  {
    std::fprintf(stderr, "usage: BenchmarkCoarseMesh [WIDTH HEIGHT [CELLS_PER_QUAD [REPEATS]]]\n");
    return EXIT_FAILURE;
  }
  vtkNew<vtkImageData> image;
  FillHeights(width, height, image);
  vtkNew<vtkTerrainCoarseMesh> filter;
  filter->SetInputData(image);
  filter->SetCellsPerQuad(cellsPerQuad);
  Measure(filter, repeats);
  vtkSMPTools::Initialize(1);
  Measure(filter, repeats);
  return EXIT_SUCCESS;
}
