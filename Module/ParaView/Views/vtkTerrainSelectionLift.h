// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Selected cells and points of a terrain, drawn where the surface is. Private.
 */
#ifndef vtkTerrainSelectionLift_h
#define vtkTerrainSelectionLift_h

#include "vtkNew.h"         // For a member
#include "vtkWeakPointer.h" // For a member

class vtkPVDataRepresentation;
class vtkSelectionRepresentation;
class vtkView;
class vtkWarpScalar;

/**
 * ParaView draws a selection as the cells of the data, which lie in the plane of the image. While a
 * terrain is drawn, they are lifted by their heights on the way there.
 */
class vtkTerrainSelectionLift
{
public:
  vtkTerrainSelectionLift();
  ~vtkTerrainSelectionLift();

  /// Lifts what is selected of a representation's data, by the point array of heights times the
  /// exaggeration; null lifts nothing. Called before each update of the view.
  void Lift(
    vtkView* view, vtkPVDataRepresentation* terrain, const char* heights, double exaggeration);

  /// Draws the selection where the data are.
  void Lay();

  vtkTerrainSelectionLift(const vtkTerrainSelectionLift&) = delete;
  void operator=(const vtkTerrainSelectionLift&) = delete;

private:
  vtkNew<vtkWarpScalar> Warp;
  vtkWeakPointer<vtkSelectionRepresentation> Selection;
};

#endif
