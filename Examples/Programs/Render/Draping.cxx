// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Draping.h"

#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "PolygonLayer.h"
#include "Statistics.h"
#include "Terrain.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainImageWarp.h"

namespace
{
/// The picture that the options name, brought onto heights; null if they name none.
vtkSmartPointer<vtkImageData> WarpPicture(
  const PlacedHeights& heights, const Options& options, Statistics& statistics)
{
  if (options.Place.Drape.empty())
  {
    return nullptr;
  }
  const Stopwatch watch;
  const vtkNew<vtkTerrainImageWarp> warp;
  warp->SetInputData(heights.Image);
  warp->SetGeoreference(heights.Georeference);
  warp->SetFileName(options.Place.Drape);
  warp->Update();
  ThrowOnError(options.Place.Drape);
  vtkImageData* picture = warp->GetOutput();
  statistics.AddTime("drape", watch.GetMilliseconds());
  statistics.SetCount("drape_columns", picture->GetDimensions()[0]);
  statistics.SetCount("drape_rows", picture->GetDimensions()[1]);
  return picture;
}
}

//------------------------------------------------------------------------------
void DrapePolygons(const Terrain& site, const PolygonLayer& polygons, const Options& options)
{
  if (const auto filled = FillPolygons(polygons, site.Actor->GetHeights(), nullptr, options))
  {
    site.Actor->GetTerrainMapper()->SetDrape(filled);
  }
}

//------------------------------------------------------------------------------
void DrapePicture(const Terrain& terrain, const PlacedHeights& heights,
  const PolygonLayer& polygons, const Options& options, Statistics& statistics)
{
  vtkSmartPointer<vtkImageData> picture = WarpPicture(heights, options, statistics);
  if (const auto filled = FillPolygons(polygons, heights.Image, picture, options))
  {
    picture = filled;
  }
  if (picture)
  {
    terrain.Actor->GetTerrainMapper()->SetDrape(picture);
  }
}
