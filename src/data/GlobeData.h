// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The field data by which heights lie on a globe (vtkTerrainGlobe). Private to the module.
 *
 *   GlobeRadii       equatorial and polar semi-axis, metres
 *   GlobeLongitudes  of the first column and from a column to the next, degrees
 *   GlobeLatitudes   of each row, from the south, degrees
 */
#ifndef vtkTerrain_data_GlobeData_h
#define vtkTerrain_data_GlobeData_h

#include "core/globe/GlobeGrid.h"
#include "core/grid/Constants.h"
#include "data/FieldData.h"

#include <memory>

namespace terrain::GlobeData
{
/// True if heights lie on a globe.
inline bool Has(vtkImageData* image)
{
  return image && image->GetFieldData()->GetArray("GlobeLatitudes") != nullptr;
}

/// Their grid; null if they lie on none.
inline std::unique_ptr<GlobeGrid> Get(vtkImageData* image)
{
  double radii[2];
  double longitudes[2];
  if (!Has(image) || !FieldData::GetPair(image, "GlobeRadii", radii) ||
    !FieldData::GetPair(image, "GlobeLongitudes", longitudes))
  {
    return nullptr;
  }
  auto grid = std::make_unique<GlobeGrid>();
  grid->Body = { radii[0], radii[1] };
  grid->West = longitudes[0] * kDegree;
  grid->Step = longitudes[1] * kDegree;
  grid->Columns = image->GetDimensions()[0];
  vtkDataArray* latitudes = image->GetFieldData()->GetArray("GlobeLatitudes");
  for (vtkIdType row = 0; row < latitudes->GetNumberOfTuples(); ++row)
  {
    grid->Latitudes.push_back(latitudes->GetComponent(row, 0) * kDegree);
  }
  return grid;
}

inline void Add(vtkImageData* image, const GlobeGrid& grid)
{
  FieldData::AddTuple(image, "GlobeRadii", { grid.Body.Equatorial, grid.Body.Polar });
  FieldData::AddTuple(image, "GlobeLongitudes", { grid.West / kDegree, grid.Step / kDegree });
  vtkNew<vtkDoubleArray> latitudes; // a row a tuple
  latitudes->SetName("GlobeLatitudes");
  for (const double latitude : grid.Latitudes)
  {
    latitudes->InsertNextValue(latitude / kDegree);
  }
  image->GetFieldData()->AddArray(latitudes);
}
}
#endif
