// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The smallest program that draws terrain: terrain-pipeline HEIGHTS PICTURE.png
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainRasterReader.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    return EXIT_FAILURE;
  }

  vtkNew<vtkTerrainRasterReader> heights; // or vtkTerrainSource, or any vtkImageData of heights
  heights->SetFileName(argv[1]);

  vtkNew<vtkTerrainActor> terrain;
  terrain->SetInputConnection(heights->GetOutputPort());
  terrain->SetVerticalExaggeration(1.5);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(terrain);
  renderer->SetBackground(0.6, 0.7, 0.8);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Elevation(-50.0); // from the south
  renderer->GetActiveCamera()->Zoom(1.2);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window; // X, EGL or OSMesa, whichever there is
  window->SetOffScreenRendering(1);
  window->SetSize(1280, 720);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(capture->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return EXIT_SUCCESS;
}
