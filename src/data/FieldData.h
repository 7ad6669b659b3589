// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The field data that travel with heights (vtkTerrainRasterReader). Private to the module.
 */
#ifndef vtkTerrain_data_FieldData_h
#define vtkTerrain_data_FieldData_h

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <string>
#include <vector>

namespace terrain::FieldData
{
/// The first string of a field array; empty if there is none.
inline std::string GetText(vtkImageData* image, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

/// The first two doubles of a field array; false if it is not there. Files of earlier versions have
/// them as two tuples.
inline bool GetPair(vtkImageData* image, const char* name, double pair[2])
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() < 2)
  {
    return false;
  }
  for (int i = 0; i < 2; ++i)
  {
    pair[i] =
      array->GetComponent(i / array->GetNumberOfComponents(), i % array->GetNumberOfComponents());
  }
  return true;
}

/// How heights are laid out: CRS = Origin + (x, y) / Scale.
struct Layout
{
  double Origin[2] = { 0.0, 0.0 };
  double Scale[2] = { 1.0, 1.0 };
};

/// The layout that the field arrays LayoutOrigin and LayoutScale say, else x, y themselves.
inline Layout GetLayout(vtkImageData* image)
{
  Layout layout;
  if (!GetPair(image, "LayoutOrigin", layout.Origin) ||
    !GetPair(image, "LayoutScale", layout.Scale))
  {
    return {};
  }
  return layout;
}

/// Adds numbers that belong together, as a pair or a transform, as one tuple.
inline void AddTuple(vtkImageData* image, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.data());
  image->GetFieldData()->AddArray(array);
}

/// Adds a list of texts; nothing if it is empty.
inline void AddTexts(vtkImageData* image, const char* name, const std::vector<std::string>& texts)
{
  if (texts.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  image->GetFieldData()->AddArray(array);
}

/// Adds a text; nothing if it is empty.
inline void AddText(vtkImageData* image, const char* name, const std::string& text)
{
  if (!text.empty())
  {
    AddTexts(image, name, { text });
  }
}
}
#endif
