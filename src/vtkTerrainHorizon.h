// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainHorizon
 * @brief   horizon angles of every sample, and what of sky and sun is seen over them
 *
 * Input: vtkImageData of W x H x 1 points whose scalars are heights, as vtkTerrainRasterReader
 * makes them.
 *
 * Output: the image with the point arrays (float, NaN where there is no height)
 * | array | what |
 * | --- | --- |
 * | Horizon | degrees above the horizontal, one component a direction, if OutputHorizon is on |
 * | SkyView | sky view factor, 0 to 1, if OutputSkyView is on |
 * | SunHours | hours of direct sun on Date |
 * | FirstSun, LastSun | when, in hours of universal time since Date began; NaN for never |
 * | DirectIrradiation | Wh/m^2 of direct sun on the surface under a clear sky on Date |
 *
 * Component k of Horizon looks to the azimuth 360 k / NumberOfDirections, in degrees clockwise from
 * grid north. The horizon is the supremum of the elevation of the bilinear surface, not only of its
 * samples, over all distances above 0 (core/rays/Horizon.h). It is negative where all terrain ahead
 * lies lower, and -90 where there is none ahead: at the border of the data. No data stand in
 * nobody's way. Error: terrain::kHorizonError, 0.01 degrees.
 *
 * SkyView is the light of an evenly bright sky on a level plate (core/rays/SkyView.h).
 *
 * The sun is looked for every TimeStep minutes, in its own direction each time, from the middle of
 * the data; it needs their CRS. Irradiation follows the European Solar Radiation Atlas
 * (core/place/ClearSky.h), on the plane that touches the surface in the sample.
 *
 * Heights are in metres, as the spacing. Heights in degrees (vtkTerrainRasterReader lays them out
 * in metres at their middle latitude) get the width of their cells from their own latitude, for
 * bands of rows in which it is right to SpacingError; rays run straight in the plane of each.
 *
 * The earth is flat unless Curvature is on: then the ground falls by (1 - Refraction) d^2 / (2
 * PlanetRadius) at a distance d.
 *
 * Cost: about 60 ns a sample and direction on one core with AVX-512, 85 with AVX2, on rough terrain
 * of 1024^2 samples. Runs on the threads of vtkSMPTools; results do not depend on them. Memory,
 * beside the output: 8 bytes a sample.
 *
 * @code{.py}
 * horizon = vtkTerrainHorizon(NumberOfDirections=16)
 * horizon.SetInputConnection(reader.GetOutputPort())
 * @endcode
 *
 * @sa vtkTerrainViewpoint
 */
#ifndef vtkTerrainHorizon_h
#define vtkTerrainHorizon_h

#include "vtkImageAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

#include <memory>
#include <string>

class vtkFloatArray;
class vtkImageData;

class VTKTERRAIN_EXPORT vtkTerrainHorizon : public vtkImageAlgorithm
{
public:
  static vtkTerrainHorizon* New();
  vtkTypeMacro(vtkTerrainHorizon, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Largest error of the width of cells in degrees, as a share of it.
  static constexpr double SpacingError = 5e-4;
  /// Most directions.
  static constexpr int MaximumDirections = 3600;

  ///@{
  /// Directions of the horizon, 1 to MaximumDirections; others are an error. Default 16.
  vtkSetMacro(NumberOfDirections, int);
  vtkGetMacro(NumberOfDirections, int);
  ///@}

  ///@{
  /// Height of the eye above the ground in metres, >= 0; default 0.
  vtkSetClampMacro(EyeHeight, double, 0.0, 1e9);
  vtkGetMacro(EyeHeight, double);
  ///@}

  ///@{
  /// Whether the ground falls away with distance as on a round planet; default off.
  vtkSetMacro(Curvature, bool);
  vtkGetMacro(Curvature, bool);
  vtkBooleanMacro(Curvature, bool);
  ///@}

  ///@{
  /// Share of the curvature that refraction takes from a line of sight, 0 to 1; default 0.13.
  vtkSetClampMacro(Refraction, double, 0.0, 1.0);
  vtkGetMacro(Refraction, double);
  ///@}

  ///@{
  /// Of the planet in metres, > 0; default 6371008.8, the earth's mean radius. Matters with
  /// Curvature only.
  vtkSetClampMacro(PlanetRadius, double, 1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PlanetRadius, double);
  ///@}

  ///@{
  /// Which arrays are made; default both.
  vtkSetMacro(OutputHorizon, bool);
  vtkGetMacro(OutputHorizon, bool);
  vtkBooleanMacro(OutputHorizon, bool);
  vtkSetMacro(OutputSkyView, bool);
  vtkGetMacro(OutputSkyView, bool);
  vtkBooleanMacro(OutputSkyView, bool);
  ///@}

  ///@{
  /// The day of the arrays of the sun, "2024-06-21", 1950 to 2050; empty, the default, for none. It
  /// lasts from midnight to midnight by the sun in the middle of the data.
  void SetDate(const std::string& date);
  const std::string& GetDate() const
  {
    return this->Date;
  }
  ///@}

  ///@{
  /// Minutes between two looks at the sun, 0.1 to 120; default 10.
  vtkSetClampMacro(TimeStep, double, 0.1, 120.0);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /// Linke's turbidity of the air, 1 to 10; default 3.
  vtkSetClampMacro(Turbidity, double, 1.0, 10.0);
  vtkGetMacro(Turbidity, double);
  ///@}

  /**
   * Horizon angles of all samples of an image of heights in one direction, in degrees clockwise
   * from grid north, without the pipeline and with the settings above. Heights are prepared once
   * and kept until they change. Empty, or one sentence that says why not.
   */
  std::string ComputeHorizon(vtkImageData* heights, double azimuth, vtkFloatArray* degrees);

  /// Why the last update failed, one sentence; empty if it did not.
  const std::string& GetErrorMessage() const
  {
    return this->ErrorMessage;
  }

  vtkTerrainHorizon(const vtkTerrainHorizon&) = delete;
  void operator=(const vtkTerrainHorizon&) = delete;

protected:
  vtkTerrainHorizon();
  ~vtkTerrainHorizon() override;

  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  struct vtkInternals;
  std::string WhyNot(vtkImageData* heights) const;
  std::string AddHorizons(vtkImageData* heights, vtkImageData* output);
  std::string AddSun(vtkImageData* heights, vtkImageData* output);

  int NumberOfDirections = 16;
  double EyeHeight = 0.0;
  bool Curvature = false;
  double Refraction = 0.13;
  double PlanetRadius = 6371008.8;
  bool OutputHorizon = true;
  bool OutputSkyView = true;
  std::string Date;
  double TimeStep = 10.0;
  double Turbidity = 3.0;
  std::string ErrorMessage;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
