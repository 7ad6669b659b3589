// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Draping.h"

#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "Statistics.h"
#include "Terrain.h"

#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainImageWarp.h"

//------------------------------------------------------------------------------
void DrapePicture(const Terrain& terrain, const PlacedHeights& heights, const Options& options,
  Statistics& statistics)
{
  if (options.Place.Drape.empty())
  {
    return;
  }
  const Stopwatch watch;
  const vtkNew<vtkTerrainImageWarp> warp;
  warp->SetInputData(heights.Image);
  warp->SetGeoreference(heights.Georeference);
  warp->SetFileName(options.Place.Drape);
  warp->Update();
  ThrowOnError(options.Place.Drape);
  vtkImageData* picture = warp->GetOutput();
  terrain.Actor->GetTerrainMapper()->SetDrape(picture);
  statistics.AddTime("drape", watch.GetMilliseconds());
  statistics.SetCount("drape_columns", picture->GetDimensions()[0]);
  statistics.SetCount("drape_rows", picture->GetDimensions()[1]);
}
