// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainViewshed
 * @brief   how many of some observers see each sample of a heightfield
 *
 * Input: port 0, vtkImageData of W x H x 1 points whose scalars are heights. Port 1, vtkPointSet in
 * the same coordinates: an observer stands at every point, on the ground whatever its z is, and
 * along the lines of vtkPolyData not farther apart than a cell.
 *
 * Output: the image with the point array "Observers" (vtkUnsignedIntArray): how many observers see
 * the point TargetHeight above the sample. 0 where there is no height.
 *
 * Exact for the bilinear surface, but for float arithmetic (core/rays/Viewshed.h). No data hide
 * nothing. An observer outside the heights, or where there is none, is an error.
 *
 * Heights are in metres, as the spacing. Heights laid out from degrees are seen as if their cells
 * were as wide everywhere as in their middle: bring them to a metric CRS (vtkTerrainReproject)
 * where that matters.
 *
 * Cost: about 45 ns a sample and observer on one core with AVX-512, on rough terrain. Runs on the
 * threads of vtkSMPTools; results do not depend on them.
 *
 * @sa vtkTerrainHorizon vtkTerrainViewpoint
 */
#ifndef vtkTerrainViewshed_h
#define vtkTerrainViewshed_h

#include "vtkImageAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

#include <string>

class vtkAlgorithmOutput;

class VTKTERRAIN_EXPORT vtkTerrainViewshed : public vtkImageAlgorithm
{
public:
  static vtkTerrainViewshed* New();
  vtkTypeMacro(vtkTerrainViewshed, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where observers are, port 1.
  void SetObserversConnection(vtkAlgorithmOutput* observers);

  ///@{
  /// Height of the eyes and of what is looked at above the ground in metres, >= 0; default 1.75, 0.
  vtkSetClampMacro(EyeHeight, double, 0.0, 1e9);
  vtkGetMacro(EyeHeight, double);
  vtkSetClampMacro(TargetHeight, double, 0.0, 1e9);
  vtkGetMacro(TargetHeight, double);
  ///@}

  ///@{
  /// As vtkTerrainHorizon's. Defaults: off, 0.13, 6371008.8.
  vtkSetMacro(Curvature, bool);
  vtkGetMacro(Curvature, bool);
  vtkBooleanMacro(Curvature, bool);
  vtkSetClampMacro(Refraction, double, 0.0, 1.0);
  vtkGetMacro(Refraction, double);
  vtkSetClampMacro(PlanetRadius, double, 1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PlanetRadius, double);
  ///@}

  ///@{
  /// Least and greatest horizontal distance of what is seen, in metres; default 0 to infinity.
  vtkSetVector2Macro(DistanceRange, double);
  vtkGetVector2Macro(DistanceRange, double);
  ///@}

  ///@{
  /// Directions of what is seen, degrees clockwise from grid north, from the first clockwise to the
  /// last; default 0 to 360, all.
  vtkSetVector2Macro(AzimuthRange, double);
  vtkGetVector2Macro(AzimuthRange, double);
  ///@}

  ///@{
  /// Least and greatest elevation of the sight in degrees; default -90 to 90.
  vtkSetVector2Macro(ElevationRange, double);
  vtkGetVector2Macro(ElevationRange, double);
  ///@}

  /// Why the last update failed, one sentence; empty if it did not.
  const std::string& GetErrorMessage() const
  {
    return this->ErrorMessage;
  }

  vtkTerrainViewshed(const vtkTerrainViewshed&) = delete;
  void operator=(const vtkTerrainViewshed&) = delete;

protected:
  vtkTerrainViewshed();
  ~vtkTerrainViewshed() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double EyeHeight = 1.75;
  double TargetHeight = 0.0;
  bool Curvature = false;
  double Refraction = 0.13;
  double PlanetRadius = 6371008.8;
  double DistanceRange[2] = { 0.0, VTK_DOUBLE_MAX };
  double AzimuthRange[2] = { 0.0, 360.0 };
  double ElevationRange[2] = { -90.0, 90.0 };
  std::string ErrorMessage;
};

#endif
