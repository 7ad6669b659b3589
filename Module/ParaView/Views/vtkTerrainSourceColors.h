// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colours of what the surface itself tells, and their bar. Private.
 */
#ifndef vtkTerrainSourceColors_h
#define vtkTerrainSourceColors_h

#include "vtkNew.h"          // For members
#include "vtkSmartPointer.h" // For members
#include "vtkWeakPointer.h"  // For members

class vtkPVRenderView;
class vtkRenderer;
class vtkScalarBarActor;
class vtkScalarsToColors;

/**
 * Slope and aspect are no arrays: ParaView has neither a table nor a bar for them. Slopes have the
 * scheme viridis from 0 to 60 degrees, aspects the colours of a circle from 0 to 360.
 */
class vtkTerrainSourceColors
{
public:
  vtkTerrainSourceColors();
  ~vtkTerrainSourceColors();

  /// The table of a source (vtkTerrainLook::ColorSources as a number); null if it has none of its
  /// own.
  vtkScalarsToColors* GetTable(int source);

  /// Shows the bar of a source in a view, or none.
  void ShowBar(vtkPVRenderView* view, int source);
  void HideBar();

  vtkTerrainSourceColors(const vtkTerrainSourceColors&) = delete;
  void operator=(const vtkTerrainSourceColors&) = delete;

private:
  vtkSmartPointer<vtkScalarsToColors> Slopes;
  vtkSmartPointer<vtkScalarsToColors> Aspects;
  vtkNew<vtkScalarBarActor> Bar;
  vtkWeakPointer<vtkRenderer> Renderer;
};

#endif
