// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainPieces.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerrainActor.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>

namespace
{
/// Those datasets of a type in another one, which may be one itself, that have points.
template <typename DataSet>
std::vector<DataSet*> FindParts(vtkDataObject* data)
{
  std::vector<DataSet*> parts;
  const auto add = [&parts](vtkDataObject* object)
  {
    auto* part = DataSet::SafeDownCast(object);
    if (part && part->GetNumberOfPoints() > 0)
    {
      parts.push_back(part);
    }
  };
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    add(data);
    return parts;
  }
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    add(iterator->GetCurrentDataObject());
  }
  return parts;
}
}

namespace vtkTerrainPieces
{
//------------------------------------------------------------------------------
std::vector<vtkImageData*> FindImages(vtkDataObject* data)
{
  return FindParts<vtkImageData>(data);
}

//------------------------------------------------------------------------------
std::vector<vtkPolyData*> FindSurfaces(vtkDataObject* data)
{
  return FindParts<vtkPolyData>(data);
}

//------------------------------------------------------------------------------
bool HasCells(vtkImageData* heights)
{
  const int* dimensions = heights->GetDimensions();
  return dimensions[0] > 1 && dimensions[1] > 1 && heights->GetPointData()->GetScalars();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> CellsAsSamples(vtkImageData* image)
{
  auto samples = vtkSmartPointer<vtkImageData>::New();
  std::array<int, 6> extent{};
  image->GetExtent(extent.data());
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  samples->SetExtent(extent[0], extent[1] - 1, extent[2], extent[3] - 1, extent[4], extent[4]);
  samples->SetSpacing(spacing[0], spacing[1], spacing[2]);
  samples->SetOrigin(origin[0] + spacing[0] / 2.0, origin[1] + spacing[1] / 2.0, origin[2]);
  samples->GetPointData()->ShallowCopy(image->GetCellData());
  samples->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return samples;
}

//------------------------------------------------------------------------------
void OwnSamples(vtkImageData* image, std::array<int, 2>& first, std::array<int, 2>& last)
{
  const int* dimensions = image->GetDimensions();
  first = { 0, 0 };
  last = { dimensions[0] - 1, dimensions[1] - 1 };
  vtkUnsignedCharArray* ghosts = image->GetCellGhostArray();
  if (!ghosts)
  {
    return;
  }
  const vtkIdType columns = dimensions[0] - 1;
  const auto isOwn = [ghosts](vtkIdType cell)
  { return !(ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL); };
  vtkIdType low = 0;
  vtkIdType high = ghosts->GetNumberOfValues() - 1;
  while (low < high && !isOwn(low))
  {
    ++low;
  }
  while (high > low && !isOwn(high))
  {
    --high;
  }
  first = { static_cast<int>(low % columns), static_cast<int>(low / columns) };
  last = { static_cast<int>(high % columns) + 1, static_cast<int>(high / columns) + 1 };
}

//------------------------------------------------------------------------------
bool AreSame(vtkImageData* a, vtkImageData* b)
{
  const auto areSameArrays = [](vtkFieldData* first, vtkFieldData* second)
  {
    bool same = first->GetNumberOfArrays() == second->GetNumberOfArrays();
    for (int i = 0; same && i < first->GetNumberOfArrays(); ++i)
    {
      same = first->GetAbstractArray(i) == second->GetAbstractArray(i);
    }
    return same;
  };
  const auto areSameNumbers = [](const auto* first, const auto* second, int count)
  { return std::equal(first, first + count, second); };
  return areSameNumbers(a->GetExtent(), b->GetExtent(), 6) &&
    areSameNumbers(a->GetOrigin(), b->GetOrigin(), 3) &&
    areSameNumbers(a->GetSpacing(), b->GetSpacing(), 3) &&
    a->GetPointData()->GetScalars() == b->GetPointData()->GetScalars() &&
    areSameArrays(a->GetPointData(), b->GetPointData()) &&
    areSameArrays(a->GetCellData(), b->GetCellData()) &&
    areSameArrays(a->GetFieldData(), b->GetFieldData());
}

//------------------------------------------------------------------------------
std::array<double, 2> HeightRange(const std::vector<vtkImageData*>& images)
{
  std::array<double, 2> all{ VTK_DOUBLE_MAX, VTK_DOUBLE_MIN };
  for (vtkImageData* image : images)
  {
    if (vtkDataArray* heights = image->GetPointData()->GetScalars())
    {
      double range[2];
      heights->GetFiniteRange(range, 0);
      all = { std::min(all[0], range[0]), std::max(all[1], range[1]) };
    }
  }
  return all;
}

//------------------------------------------------------------------------------
void AddBox(const double bounds[6], vtkMatrix4x4* toWorld, vtkBoundingBox& box)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    const double point[4] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
      bounds[4 + (corner >> 2)], 1.0 };
    double moved[4];
    toWorld->MultiplyPoint(point, moved);
    box.AddPoint(moved);
  }
}

//------------------------------------------------------------------------------
bool IsOnGlobe(vtkImageData* heights)
{
  return heights->GetFieldData()->HasArray("GlobeLatitudes");
}

//------------------------------------------------------------------------------
void AddOwnBox(vtkImageData* heights, vtkTerrainActor* terrain, vtkBoundingBox& box)
{
  if (IsOnGlobe(heights))
  {
    vtkNew<vtkTerrainActor> globe;
    globe->SetInputData(heights);
    globe->SetVerticalExaggeration(terrain->GetVerticalExaggeration());
    terrain->ComputeMatrix();
    AddBox(globe->GetBounds(), terrain->GetMatrix(), box);
    return;
  }
  std::array<int, 2> first{};
  std::array<int, 2> last{};
  OwnSamples(heights, first, last);
  const int* extent = heights->GetExtent();
  const double* origin = heights->GetOrigin();
  const double* spacing = heights->GetSpacing();
  double range[2];
  heights->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
  if (range[0] > range[1])
  {
    return;
  }
  double bounds[6];
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double start = origin[axis] + extent[2 * axis] * spacing[axis];
    bounds[2 * axis] = start + first[axis] * spacing[axis];
    bounds[2 * axis + 1] = start + last[axis] * spacing[axis];
    bounds[4 + axis] = origin[2] + range[axis];
  }
  vtkNew<vtkActor> placed;
  terrain->PlaceAsDrawn(placed, origin[2]);
  placed->ComputeMatrix();
  AddBox(bounds, placed->GetMatrix(), box);
}

//------------------------------------------------------------------------------
void MakeColumn(double bounds[6], vtkMatrix4x4* matrix)
{
  matrix->Identity();
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    return;
  }
  constexpr double end = 1e9; // in metres: beyond the earth
  matrix->SetElement(2, 2, (bounds[5] - bounds[4]) / (2.0 * end));
  matrix->SetElement(2, 3, (bounds[5] + bounds[4]) / 2.0);
  bounds[4] = -end;
  bounds[5] = end;
}
}
