// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainDetailSource
 * @brief   makes a small tileable heightfield of stony ground
 *
 * Output: vtkImageData of Size x Size x 1 points with the point scalars "Detail", float heights
 * from -Relief / 2 to Relief / 2: one period of the detail that vtkOpenGLTerrainMapper repeats all
 * over coarser heights. The sample after the last one is the first one. Spacing 1, origin 0: how
 * large a period is drawn is up to who uses it.
 *
 * The same parameters give the same bits on every machine. Cost: about 0.1 us a sample and octave.
 *
 * @sa vtkOpenGLTerrainMapper
 */
#ifndef vtkTerrainDetailSource_h
#define vtkTerrainDetailSource_h

#include "vtkImageAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

class VTKTERRAIN_EXPORT vtkTerrainDetailSource : public vtkImageAlgorithm
{
public:
  static vtkTerrainDetailSource* New();
  vtkTypeMacro(vtkTerrainDetailSource, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainDetailSource(const vtkTerrainDetailSource&) = delete;
  void operator=(const vtkTerrainDetailSource&) = delete;

  ///@{
  /// Samples along a side, 1 to 16384; default 512. A power of two has the tightest bounds.
  vtkSetClampMacro(Size, int, 1, 16384);
  vtkGetMacro(Size, int);
  ///@}

  ///@{
  /// Another seed, other ground; default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /// Highest minus lowest height, in the unit of heights, >= 0; default 1.
  vtkSetClampMacro(Relief, double, 0.0, 1e9);
  vtkGetMacro(Relief, double);
  ///@}

protected:
  vtkTerrainDetailSource();
  ~vtkTerrainDetailSource() override = default;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Size = 512;
  int Seed = 1;
  double Relief = 1.0;
};

#endif
