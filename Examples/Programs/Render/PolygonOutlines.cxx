// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Outlines of polygons, on the ground.
#include "ViewMarks.h"

#include "Failure.h"
#include "FieldColors.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "PolygonLayer.h"
#include "TextSize.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainDrape.h"

#include <vector>

//------------------------------------------------------------------------------
void ViewMarks::AddOutlines(const PolygonLayer& polygons)
{
  const PolygonOptions& options = this->Wanted.Polygon;
  std::vector<vtkSmartPointer<vtkImageData>> grounds = this->Heights.Sites;
  grounds.insert(grounds.begin(), this->Heights.Image);
  for (std::size_t at = 0; at < polygons.Files.size() * grounds.size(); ++at)
  {
    const std::size_t k = at / grounds.size();
    const vtkNew<vtkTerrainDrape> drape;
    drape->SetInputData(polygons.Files[k]);
    drape->SetHeightsData(grounds[at % grounds.size()]);
    drape->SetGeoreference(this->Heights.Georeference);
    drape->SetExaggeration(this->Heights.Exaggeration);
    drape->Update();
    ThrowOnError(options.Files[k]);
    vtkPolyData* lines = drape->GetOutput();
    if (lines->GetNumberOfCells() > 0 && options.Width > 0.0)
    {
      vtkActor* actor =
        this->AddLines(lines, polygons.Color.data(), LinePixels(options.Width, this->Wanted), 1.0);
      ColorByValue(actor->GetMapper(), polygons.Key.Table);
    }
  }
}
