// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What several actors of one representation have in common, and what each draws. Private.
 */
#ifndef vtkTerrainLooks_h
#define vtkTerrainLooks_h

class vtkActor;
class vtkImageData;
class vtkTerrainActor;

namespace vtkTerrainLooks
{
/// Makes an actor look and stand like another one.
void ShareActor(vtkActor* from, vtkActor* to);

/// Makes a terrain look like another one, but for its colours.
void ShareTerrain(vtkTerrainActor* from, vtkTerrainActor* to);

/// Makes a terrain draw, of a piece's samples, those that are no copies of others'. One of several
/// pieces has strips that meet its neighbours'.
void TakePiece(vtkTerrainActor* actor, vtkImageData* piece, bool isOneOfSeveral);
}

#endif
