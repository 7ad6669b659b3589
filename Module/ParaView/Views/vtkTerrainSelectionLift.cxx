// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainSelectionLift.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkGeometryRepresentation.h"
#include "vtkPVCompositeRepresentation.h"
#include "vtkSelectionRepresentation.h"
#include "vtkView.h"
#include "vtkWarpScalar.h"

namespace
{
/// ParaView's classes give their parts to none but their subclasses.
struct CompositeParts : vtkPVCompositeRepresentation
{
  static vtkSelectionRepresentation* SelectionOf(vtkPVCompositeRepresentation* composite)
  {
    return composite->*(&CompositeParts::SelectionRepresentation);
  }
};

struct SelectionParts : vtkSelectionRepresentation
{
  static vtkGeometryRepresentation* GeometryOf(vtkSelectionRepresentation* selection)
  {
    return selection->*(&SelectionParts::GeometryRepresentation);
  }
};

/// What draws the selection of the data that a representation draws; null if there is none.
vtkSelectionRepresentation* FindSelection(vtkView* view, vtkPVDataRepresentation* terrain)
{
  for (int i = 0; view && i < view->GetNumberOfRepresentations(); ++i)
  {
    auto* composite = vtkPVCompositeRepresentation::SafeDownCast(view->GetRepresentation(i));
    if (composite && composite->GetActiveRepresentation() == terrain)
    {
      return CompositeParts::SelectionOf(composite);
    }
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
vtkTerrainSelectionLift::vtkTerrainSelectionLift()
{
  this->Warp->UseNormalOn();
  this->Warp->SetNormal(0.0, 0.0, 1.0);
  this->Warp->SetScaleFactor(0.0);
  this->Warp->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
}

//------------------------------------------------------------------------------
vtkTerrainSelectionLift::~vtkTerrainSelectionLift() = default;

//------------------------------------------------------------------------------
void vtkTerrainSelectionLift::Lift(
  vtkView* view, vtkPVDataRepresentation* terrain, const char* heights, double exaggeration)
{
  vtkSelectionRepresentation* selection = FindSelection(view, terrain);
  vtkAlgorithmOutput* cells = selection
    ? SelectionParts::GeometryOf(selection)->GetNumberOfInputConnections(0) > 0
      ? SelectionParts::GeometryOf(selection)->GetInputConnection(0, 0)
      : nullptr
    : nullptr;
  if (!cells)
  {
    return;
  }
  this->Selection = selection;
  const vtkMTimeType before = this->Warp->GetMTime();
  if (cells->GetProducer() != this->Warp.Get())
  {
    this->Warp->SetInputConnection(cells);
    selection->SetInputConnection(this->Warp->GetOutputPort());
  }
  this->Warp->SetScaleFactor(heights ? exaggeration : 0.0);
  if (heights)
  {
    this->Warp->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, heights);
  }
  if (this->Warp->GetMTime() != before)
  {
    selection->MarkModified();
  }
}

//------------------------------------------------------------------------------
void vtkTerrainSelectionLift::Lay()
{
  if (this->Selection && this->Warp->GetScaleFactor() != 0.0)
  {
    this->Warp->SetScaleFactor(0.0);
    this->Selection->MarkModified();
  }
}
