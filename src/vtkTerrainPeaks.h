// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainPeaks
 * @brief   the most prominent summits of heights, as points
 *
 * Input: vtkImageData of W x H x 1 points, heights as vtkOpenGLTerrainMapper takes them. Output:
 * points on the surface, the most prominent first, as vertices, with the point arrays "Height" and
 * "Prominence" in height units.
 *
 * A summit is a sample none of whose eight neighbours is higher. Its prominence is its height over
 * the highest pass from which the way leads on to something higher; that of the highest summit is
 * its height over the lowest sample. Samples at the border and beside holes are no summits, for the
 * ground may rise beyond (terrain::FindPeaks).
 *
 * Error: exact for the samples. Cost: O(n log n), about 0.3 microseconds and 16 bytes a sample. At
 * most 2^32 - 1 samples.
 *
 * @sa vtkTerrainViewpoint
 */
#ifndef vtkTerrainPeaks_h
#define vtkTerrainPeaks_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

class VTKTERRAIN_EXPORT vtkTerrainPeaks : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainPeaks* New();
  vtkTypeMacro(vtkTerrainPeaks, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainPeaks(const vtkTerrainPeaks&) = delete;
  void operator=(const vtkTerrainPeaks&) = delete;

  ///@{
  /// Most summits, >= 0; default 10.
  vtkSetClampMacro(NumberOfPeaks, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfPeaks, int);
  ///@}

  ///@{
  /// Least prominence, in height units, >= 0; default 0.
  vtkSetClampMacro(MinimumProminence, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumProminence, double);
  ///@}

  ///@{
  /// Vertical exaggeration of the points: drawn height over true height, > 0; default 1.
  vtkSetClampMacro(Exaggeration, double, 1e-30, VTK_DOUBLE_MAX);
  vtkGetMacro(Exaggeration, double);
  ///@}

protected:
  vtkTerrainPeaks() = default;
  ~vtkTerrainPeaks() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  int NumberOfPeaks = 10;
  double MinimumProminence = 0.0;
  double Exaggeration = 1.0;
};

#endif
