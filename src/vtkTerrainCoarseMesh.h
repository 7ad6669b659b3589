// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainCoarseMesh
 * @brief   makes a low-resolution mesh that lies nowhere below a heightfield
 *
 * Input: vtkImageData of W x H x 1 points whose scalars are heights (one component, any numeric
 * type). NaN, magnitudes from 1e30 on, and hidden points (vtkGhostType) have no height.
 *
 * Output: vtkPolyData of triangles, counterclockwise seen from outside, with
 *   - points in model coordinates: x, y of the samples that are vertices, z = origin.z + height;
 *   - point data "GridCoordinates", float32 of 2 components: column and row of the vertex in cells
 *     from sample (0, 0), exact. Shaders need no large coordinates;
 *   - field data, one tuple each: "LargestGap", "CellsPerQuad", and "HeightRange" (2 components),
 *     as the methods below.
 *
 * Method: Feher's three steps.
 *   1. Subsample the heights.
 *   2. Push every quad up by the largest amount by which the surface rises above its two triangles
 *      (eq. 1-2).
 *   3. Raise each shared vertex to the highest of its quads.
 * The paper bounds samples. This filter bounds the bilinear patches (core/mesh/CoarseMesh.h): in
 * grid coordinates no point of any patch lies above the mesh. That includes the rounding of the
 * output's z. x and y are the nearest numbers of the output's precision.
 *
 * The last quads of a row or column are smaller where the grid does not divide. A quad is left out
 * if none of its cells has a surface. A vertex whose sample has no height takes one from its quad.
 * A grid of fewer than 2 x 2 samples, or without cells, gives an empty mesh.
 *
 * ClosedHull closes the pushed-up mesh by vertical walls and a floor just below the lowest height.
 * Rays from the side and from below then enter through a front face as well. The hull is a closed
 * manifold without T-junctions. Its mesh comes first, in points and in triangles.
 *
 * With PushUp off and CellsPerQuad 1 the output is the full mesh: every cell two triangles.
 *
 * The result does not depend on the number of threads (vtkSMPTools). Input with another shape is
 * an error (see the message).
 *
 * @sa vtkOpenGLTerrainMapper
 */
#ifndef vtkTerrainCoarseMesh_h
#define vtkTerrainCoarseMesh_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

class VTKTERRAIN_EXPORT vtkTerrainCoarseMesh : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainCoarseMesh* New();
  vtkTypeMacro(vtkTerrainCoarseMesh, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainCoarseMesh(const vtkTerrainCoarseMesh&) = delete;
  void operator=(const vtkTerrainCoarseMesh&) = delete;

  ///@{
  /// Cells along a side of a quad, >= 0. 0, the default, chooses the smallest power of two, at
  /// least 4, that leaves at most 128 quads along the longer side.
  vtkSetClampMacro(CellsPerQuad, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(CellsPerQuad, vtkIdType);
  ///@}

  ///@{
  /// Old names of CellsPerQuad, with a warning.
  void SetSamplesPerQuad(vtkIdType cells);
  vtkIdType GetSamplesPerQuad();
  vtkIdType GetEffectiveSamplesPerQuad();
  ///@}

  ///@{
  /// Whether the mesh is lifted above the surface (default), or only subsampled.
  vtkSetMacro(PushUp, bool);
  vtkGetMacro(PushUp, bool);
  vtkBooleanMacro(PushUp, bool);
  ///@}

  ///@{
  /// Whether a pushed-up mesh is closed by walls and a floor; default on. Without effect when
  /// PushUp is off.
  vtkSetMacro(ClosedHull, bool);
  vtkGetMacro(ClosedHull, bool);
  vtkBooleanMacro(ClosedHull, bool);
  ///@}

  ///@{
  /// Type of the output points: vtkAlgorithm::SINGLE_PRECISION, or DOUBLE_PRECISION (default; so is
  /// DEFAULT_PRECISION).
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /// Whether the output has the image's point arrays, as they are at its vertices' samples; none is
  /// active. Default off.
  vtkSetMacro(PassPointArrays, bool);
  vtkGetMacro(PassPointArrays, bool);
  vtkBooleanMacro(PassPointArrays, bool);
  ///@}

  /// Cells along a side of a quad in the last output; 0 before the first.
  vtkIdType GetEffectiveCellsPerQuad() const
  {
    return this->EffectiveCellsPerQuad;
  }

  /// Largest vertical distance between mesh and surface in the last output, in height units.
  double GetLargestGap() const
  {
    return this->LargestGap;
  }

  /// Lowest and highest sample of the surface below the last output, in height units; lowest >
  /// highest if it is empty.
  vtkGetVector2Macro(HeightRange, double);

  /// Height of the hull's floor below the lowest sample, as a fraction of the height range; at
  /// least the same fraction of the smaller spacing.
  static constexpr double FloorMargin = 1.0 / 1024.0;

protected:
  vtkTerrainCoarseMesh() = default;
  ~vtkTerrainCoarseMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkIdType CellsPerQuad = 0;
  bool PushUp = true;
  bool ClosedHull = true;
  bool PassPointArrays = false;
  int OutputPointsPrecision = DOUBLE_PRECISION;
  vtkIdType EffectiveCellsPerQuad = 0;
  double LargestGap = 0.0;
  double HeightRange[2] = { 0.0, -1.0 };
};

#endif
