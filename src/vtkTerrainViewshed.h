// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainViewshed
 * @brief   how many of some observers see each sample of a heightfield
 *
 * Input: port 0, vtkImageData of W x H x 1 points whose scalars are heights. Port 1, vtkPointSet in
 * the same coordinates: an observer stands at every point, on the ground whatever its z is, along
 * the lines of vtkPolyData (a road), and at the samples inside of its polygons (an area), see
 * ObserverSpacing. Points that are corners of polygons alone are no observers.
 *
 * Output: the image with the point arrays
 * | array | what |
 * | --- | --- |
 * | Observers | unsigned int: how many see the point TargetHeight above the sample |
 * | RiseToBeSeen | float, if OutputRise is on: metres that point must rise to be seen by one |
 *
 * Observers is 0 where there is no height. RiseToBeSeen is 0 where somebody sees the point, and NaN
 * where no rise would do within the limits of distance, azimuth and elevation, or where there is no
 * height.
 *
 * Exact for the bilinear surface, but for float arithmetic (core/rays/Viewshed.h). What there are
 * no data for hides nothing, or everything behind it: NoDataBlocks. An observer outside the
 * heights, or where there is none, is an error; of an area those places are left out.
 *
 * Heights are in metres, as the spacing. Heights laid out from degrees are seen as if their cells
 * were as wide everywhere as in their middle: bring them to a metric CRS (vtkTerrainReproject)
 * where that matters.
 *
 * Cost: docs/analysis.md has numbers. Runs on the threads of vtkSMPTools; results do not depend on
 * them. Between some observers progress is reported, and AbortExecute ends it.
 *
 * @code{.py}
 * viewshed = vtkTerrainViewshed(EyeHeight=1.75, DistanceRange=(0.0, 5000.0))
 * viewshed.SetInputConnection(0, reader.GetOutputPort())
 * viewshed.SetInputData(1, road)
 * @endcode
 *
 * @sa vtkTerrainHorizon vtkTerrainViewpoint
 */
#ifndef vtkTerrainViewshed_h
#define vtkTerrainViewshed_h

#include "vtkImageAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

#include <string>

class vtkAlgorithmOutput;
class vtkFloatArray;
class vtkImageData;
class vtkPointSet;
class vtkUnsignedIntArray;

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
  /// Greatest distance between observers along lines, and the distance of those in areas, in
  /// metres. 0, the default, is one cell: every sample of an area. At most 10 million observers.
  vtkSetClampMacro(ObserverSpacing, double, 0.0, 1e9);
  vtkGetMacro(ObserverSpacing, double);
  ///@}

  ///@{
  /// Whether nobody sees across cells without data; default off: they hide nothing.
  vtkSetMacro(NoDataBlocks, bool);
  vtkGetMacro(NoDataBlocks, bool);
  vtkBooleanMacro(NoDataBlocks, bool);
  ///@}

  ///@{
  /// Whether the array RiseToBeSeen is made; default off. Takes a few times as long.
  vtkSetMacro(OutputRise, bool);
  vtkGetMacro(OutputRise, bool);
  vtkBooleanMacro(OutputRise, bool);
  ///@}

  ///@{
  /// Whether the ground falls away with the distance, the share of it that refraction takes back (0
  /// to 1), and the planet's radius in metres, as vtkTerrainHorizon's. Defaults: off, 0.13,
  /// 6371008.8.
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
  /// last, over at most 360; default 0 to 360, all.
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
  std::string WhyNot() const;
  std::string LookAround(
    vtkImageData* heights, vtkPointSet* places, vtkUnsignedIntArray* counts, vtkFloatArray* rises);

  double EyeHeight = 1.75;
  double TargetHeight = 0.0;
  bool Curvature = false;
  double Refraction = 0.13;
  double PlanetRadius = 6371008.8;
  double ObserverSpacing = 0.0;
  bool NoDataBlocks = false;
  bool OutputRise = false;
  double DistanceRange[2] = { 0.0, VTK_DOUBLE_MAX };
  double AzimuthRange[2] = { 0.0, 360.0 };
  double ElevationRange[2] = { -90.0, 90.0 };
  std::string ErrorMessage;
};

#endif
