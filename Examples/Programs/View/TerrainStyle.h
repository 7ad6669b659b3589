// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How the mouse moves the view: VTK's terrain style, about and towards the point of the terrain
 * under the pointer.
 */
#ifndef terrain_view_TerrainStyle_h
#define terrain_view_TerrainStyle_h

#include "vtkInteractorStyleTerrain.h"
#include "vtkTerrainPicker.h"

#include <functional>

/// Left drags turn the view about the point that was pressed on, middle drags move it, right drags
/// and the wheel go towards the point under the pointer. Turns end 3 degrees before the vertical.
/// Keys are handed on.
class TerrainStyle : public vtkInteractorStyleTerrain
{
public:
  static TerrainStyle* New();
  vtkTypeMacro(TerrainStyle, vtkInteractorStyleTerrain)

  TerrainStyle(const TerrainStyle&) = delete;
  void operator=(const TerrainStyle&) = delete;

  /// Called with each character typed.
  std::function<void(char)> KeyTyped;

  void OnChar() override;
  void OnLeftButtonDown() override;
  void OnMiddleButtonDown() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void Rotate() override;

protected:
  TerrainStyle() = default;
  ~TerrainStyle() override = default;

private:
  /// The picker of the interactor, after a pick under the pointer; null if nothing is there.
  vtkTerrainPicker* PickUnderPointer();
  void TurnAboutPointer();
  void GoTowardsPointer(double share);
};

#endif
