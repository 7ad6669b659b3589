// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainMinMaxPyramid
 * @brief   bounds of a heightfield's surface over squares of 2^k x 2^k cells
 *
 * Input: vtkImageData of W x H x 1 points whose scalars are heights (one component, any numeric
 * type). NaN, magnitudes from 1e30 on, and hidden points (vtkGhostType) have no height.
 *
 * Output: vtkMultiBlockDataSet. Block k is level k, named "Level k", a vtkImageData of
 * ceil((W-1) / 2^k) x ceil((H-1) / 2^k) cells in one layer of points,
 * with the input's origin and 2^k times its spacing, and cell data in the type of the heights:
 *   - "Maximum", the active scalars, and "Minimum": highest and lowest height of the bilinear
 *     surface over the cell, in height units;
 *   - "vtkGhostType", only where some cells have no surface: HIDDENCELL for these. Their maximum is
 *     the lowest number of the type, their minimum the largest.
 * Level 0, the bounding map of the paper, has one cell for each cell of the heights; the last level
 * at most 2 x 2. The cells of the last column and row reach beyond the heights where these do not
 * divide, and may have wider bounds than they need (core/surface/MinMaxPyramid.h), never narrower
 * ones.
 *
 * Method: S. Park, K. Oh, "GPU-only Terrain Rendering for Walk-through", sections 4 and 5, with
 * minima beside the maxima. Runs on the threads of vtkSMPTools; the result does not depend on them.
 *
 * Fewer than 2 x 2 heights have no cells: the output is empty. Input of another shape is an error
 * (see the message).
 *
 * @sa vtkTerrainCoarseMesh vtkOpenGLTerrainMapper
 */
#ifndef vtkTerrainMinMaxPyramid_h
#define vtkTerrainMinMaxPyramid_h

#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

class VTKTERRAIN_EXPORT vtkTerrainMinMaxPyramid : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkTerrainMinMaxPyramid* New();
  vtkTypeMacro(vtkTerrainMinMaxPyramid, vtkMultiBlockDataSetAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainMinMaxPyramid(const vtkTerrainMinMaxPyramid&) = delete;
  void operator=(const vtkTerrainMinMaxPyramid&) = delete;

protected:
  vtkTerrainMinMaxPyramid() = default;
  ~vtkTerrainMinMaxPyramid() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
};

#endif
