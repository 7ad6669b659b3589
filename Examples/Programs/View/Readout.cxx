// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Readout.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkTerrainPicker.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace
{
void ReadPair(vtkImageData* image, const char* name, std::array<double, 2>& pair)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  if (array && array->GetNumberOfValues() == 2)
  {
    pair = { array->GetVariantValue(0).ToDouble(), array->GetVariantValue(1).ToDouble() };
  }
}
}

//------------------------------------------------------------------------------
Readout::Readout(vtkImageData* heights)
{
  ReadPair(heights, "LayoutOrigin", this->LayoutOrigin);
  ReadPair(heights, "LayoutScale", this->LayoutScale);
  this->Georeference->SetFromHeights(heights);
  this->IsOnEarth = this->Georeference->GetWhyNot().empty() && this->Georeference->IsOnEarth();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTerrainViewpoint> Readout::MakeViewpoint() const
{
  auto viewpoint = vtkSmartPointer<vtkTerrainViewpoint>::New();
  viewpoint->SetGeoreference(this->Georeference);
  return viewpoint;
}

//------------------------------------------------------------------------------
bool Readout::ToPlace(const double point[2], double place[2]) const
{
  std::array<double, 3> at{ this->ToFile(0, point[0]), this->ToFile(1, point[1]), 0.0 };
  const bool isKnown = this->IsOnEarth && this->Georeference->FileToPlaces(at.data(), at.data(), 1);
  std::copy_n(at.begin(), 2, place);
  return isKnown;
}

//------------------------------------------------------------------------------
bool Readout::FromPlace(const double place[2], double point[2]) const
{
  std::array<double, 3> at{ place[0], place[1], 0.0 };
  const bool isKnown = this->IsOnEarth && this->Georeference->PlacesToFile(at.data(), at.data(), 1);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    point[axis] = (at[axis] - this->LayoutOrigin[axis]) * this->LayoutScale[axis];
  }
  return isKnown;
}

//------------------------------------------------------------------------------
std::string Readout::Describe(vtkTerrainPicker* picker) const
{
  if (!picker->IsTerrainPicked())
  {
    return {};
  }
  const double height = picker->GetHeight();
  std::array<double, 3> point{};
  picker->GetMapperPosition(point.data());
  for (int axis = 0; axis < 2; ++axis)
  {
    point[axis] = this->ToFile(axis, point[axis]);
  }
  point[2] = height;
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "column %.2f  row %.2f  x %.9g  y %.9g  height %.2f",
    picker->GetGridPosition()[0], picker->GetGridPosition()[1], point[0], point[1], height);
  std::string lines = text.data();
  if (this->IsOnEarth && this->Georeference->FileToScene(point.data(), point.data(), 1))
  {
    lines += "\n" + this->Georeference->GetReadout(point.data());
  }
  return lines;
}
