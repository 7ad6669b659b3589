// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What several actors of one representation have in common, and what each draws. Private.
 */
#ifndef vtkTerrainLooks_h
#define vtkTerrainLooks_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>

class vtkAbstractMapper;
class vtkActor;
class vtkImageData;
class vtkPlane;
class vtkTerrainActor;

namespace vtkTerrainLooks
{
/// Makes an actor look and stand like another one.
void ShareActor(vtkActor* from, vtkActor* to);

/// Makes a terrain look like another one, but for its colours.
void ShareTerrain(vtkTerrainActor* from, vtkTerrainActor* to);

/// Finds of a piece's samples those that are no copies of others' and lie between the first and
/// last column and the first and last row of the whole image (all where a last one is below 0).
/// Counted from the piece's first sample. False if no cell is left.
bool FindPart(vtkImageData* piece, const std::array<int, 4>& extract, std::array<int, 2>& first,
  std::array<int, 2>& last);

/// Makes a terrain draw these samples of a piece. One of several pieces has strips that meet its
/// neighbours'.
void TakePiece(vtkTerrainActor* actor, vtkImageData* piece, const std::array<int, 2>& first,
  const std::array<int, 2>& last, bool isOneOfSeveral);

/// Makes a mapper draw one side of a plane; null for both.
void Clip(vtkAbstractMapper* mapper, vtkPlane* plane);

/// The picture of a file where it belongs on heights that know their place; null, with a sentence,
/// if it cannot be brought there.
vtkSmartPointer<vtkImageData> BringPicture(
  const std::string& fileName, vtkImageData* heights, std::string& error);
}

#endif
