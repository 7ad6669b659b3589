// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where heights end: at the border of their raster, and where it has no data.
 */
#ifndef terrain_common_DataRim_h
#define terrain_common_DataRim_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkUnsignedCharArray;

/// The cells of heights that are drawn, those whose four corners have heights, and their sides that
/// are shared with no other such cell.
class DataRim
{
public:
  explicit DataRim(vtkImageData* heights);

  /// A side of a cell, from sample to sample, the cell to its left seen from above.
  struct Side
  {
    vtkIdType From;
    vtkIdType To;
    /// At the border of the raster, not along missing data.
    bool IsBorder;
  };
  std::vector<Side> FindSides() const;

  /// East and north of a horizontal direction.
  using Facing = std::array<double, 2>;

  /// What walls below sides face, of length 1, at the first and the last sample of each. Steps of
  /// one to seven cells along missing data are the grid's, not the ground's: they face what the rim
  /// faces over some cells, so that they do not alternate between light and dark.
  std::vector<std::array<Facing, 2>> FindFacings(const std::vector<Side>& sides) const;

  /// Cells of a row that follow each other: first and last column.
  std::vector<std::array<vtkIdType, 2>> FindRuns(vtkIdType row) const;

  vtkIdType GetRows() const
  {
    return this->Height - 1;
  }
  bool HasHeight(vtkIdType sample) const;
  /// True if a cell has four heights; false beyond the raster, too.
  bool IsCell(vtkIdType column, vtkIdType row) const;
  /// In metres, from the image's origin.
  double GetHeight(vtkIdType sample) const;
  /// In the image's coordinates, at a height that counts from its origin.
  std::array<double, 3> GetPoint(vtkIdType sample, double height) const;

private:
  vtkSmartPointer<vtkImageData> Heights;
  vtkDataArray* Samples;
  vtkUnsignedCharArray* Ghosts;
  vtkIdType Width;
  vtkIdType Height;
  /// At the number of its first sample.
  std::vector<bool> AreCells;
};

#endif
