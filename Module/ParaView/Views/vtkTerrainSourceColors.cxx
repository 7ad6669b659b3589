// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainSourceColors.h"

#include "vtkColorTransferFunction.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTerrainColors.h"
#include "vtkTerrainLook.h"

namespace
{
constexpr double kSteepest = 60.0; // degrees of the last colour

bool IsSource(int source, vtkTerrainLook::ColorSources what)
{
  return source == static_cast<int>(what);
}
}

//------------------------------------------------------------------------------
vtkTerrainSourceColors::vtkTerrainSourceColors()
{
  const vtkNew<vtkTerrainColors> colors;
  colors->SetScheme("viridis");
  this->Slopes = colors->MakeTable(0.0, kSteepest);
  const auto circle = vtkSmartPointer<vtkColorTransferFunction>::New();
  circle->SetColorSpaceToHSV();
  circle->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  circle->AddRGBPoint(120.0, 0.0, 1.0, 0.0);
  circle->AddRGBPoint(240.0, 0.0, 0.0, 1.0);
  circle->AddRGBPoint(360.0, 1.0, 0.0, 0.0);
  this->Aspects = circle;
  this->Bar->SetNumberOfLabels(4);
  this->Bar->SetLabelFormat("%.0f");
  this->Bar->SetUnconstrainedFontSize(true);
  this->Bar->SetWidth(0.1);
  this->Bar->SetHeight(0.4);
  this->Bar->SetPosition(0.03, 0.05);
  this->Bar->SetPickable(false);
}

//------------------------------------------------------------------------------
vtkTerrainSourceColors::~vtkTerrainSourceColors() = default;

//------------------------------------------------------------------------------
vtkScalarsToColors* vtkTerrainSourceColors::GetTable(int source)
{
  using Sources = vtkTerrainLook::ColorSources;
  return IsSource(source, Sources::Slope) ? this->Slopes
    : IsSource(source, Sources::Aspect)   ? this->Aspects
                                          : nullptr;
}

//------------------------------------------------------------------------------
void vtkTerrainSourceColors::ShowBar(vtkPVRenderView* view, int source)
{
  vtkScalarsToColors* table = this->GetTable(source);
  if (!table || !view)
  {
    this->HideBar();
    return;
  }
  this->Bar->SetLookupTable(table);
  this->Bar->SetTitle(IsSource(source, vtkTerrainLook::ColorSources::Slope) ? "Slope (degrees)\n"
                                                                            : "Aspect (degrees)\n");
  if (!this->Renderer)
  {
    this->Renderer = view->GetNonCompositedRenderer();
    this->Renderer->AddViewProp(this->Bar);
  }
}

//------------------------------------------------------------------------------
void vtkTerrainSourceColors::HideBar()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveViewProp(this->Bar);
    this->Renderer = nullptr;
  }
}
