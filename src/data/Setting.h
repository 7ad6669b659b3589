// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Setters of VTK objects for members that VTK's macros do not fit. Private to the module.
 */
#ifndef vtkTerrain_data_Setting_h
#define vtkTerrain_data_Setting_h

#include "vtkObject.h"

namespace terrain::Setting
{
/// Gives a member of an object a value; the object is modified if that is a new one.
template <typename Member, typename Value>
void Set(vtkObject* object, Member& member, const Value& value)
{
  if (member != value)
  {
    member = value;
    object->Modified();
  }
}
}
#endif
