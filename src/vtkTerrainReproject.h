// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainReproject
 * @brief   resamples heights of any CRS onto a regular grid of a metric scene
 *
 * Input: one or more vtkImageData of heights (port 0 is repeatable: neighbouring tiles; where they
 * overlap the earlier one counts). Their CRS is the field array CRS, their place in it the arrays
 * LayoutOrigin and LayoutScale, as vtkTerrainRasterReader writes them; without these arrays it is
 * CoordinateSystem, and the image lies at its own coordinates. Tiles may differ in CRS.
 *
 * Output: vtkImageData of W x H x 1 points, float (double if an input is), heights in metres, NaN
 * where the surface of no input is; square cells. Sample positions are whole multiples of the
 * spacing, so that pieces of one scene made at different times fit. Field data as
 * vtkTerrainRasterReader's, with the CRS of the scene where it has one.
 *
 * The scene is that of Georeference, whose CRS and extent are filled in if they are not set.
 *   - Plane, Zone, Grid: the earth is flat; z = height. If that is wrong by more than a cell over
 *     the extent, a warning says by how much (GetFlatError).
 *   - Local: the earth is round. z includes the earth's drop, x and y the tilt of the vertical, so
 *     that distant summits sink as they do in nature: each sample is where the vertical line of the
 *     scene meets the terrain, found to VerticalTolerance. The Georeference's exaggeration is in
 *     these heights, which are drawn as they are. Where exaggerated terrain overhangs in the scene,
 *     the sample is one of its points. What is left of the heights for colours is the point array
 *     "PlaceHeight" (float): metres as in flat frames.
 *   - Geocentric is refused: z is not up in it.
 *
 * Samples are taken from the bilinear surface, or by cubic convolution (smoother; where a
 * neighbour has no data it falls back to the surface). Heights are not averaged: where the spacing
 * is much wider than the input's, reduce the input first (vtkTerrainRasterReader::MaximumSize).
 * Samples lie where they should to RegistrationError. A raster that goes round the earth is closed
 * between its last and its first column.
 *
 * Runs on the threads of vtkSMPTools, in blocks, with progress and abort. Cost: 0.1 to 0.3
 * microseconds a sample and core from degrees, 0.5 to 2 from other CRSs.
 *
 * Inputs are updated as a whole when the output's size is asked for, because it depends on them.
 *
 * @sa vtkTerrainGeoreference vtkTerrainImageWarp
 */
#ifndef vtkTerrainReproject_h
#define vtkTerrainReproject_h

#include "vtkImageAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

#include <memory>
#include <string>
#include <vector>

class vtkTerrainGeoreference;

class VTKTERRAIN_EXPORT vtkTerrainReproject : public vtkImageAlgorithm
{
public:
  static vtkTerrainReproject* New();
  vtkTypeMacro(vtkTerrainReproject, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Largest error of the place that a sample is taken from, in cells of the input.
  static constexpr double RegistrationError = 0.01;
  /// Largest vertical error of the search in Local frames, in metres.
  static constexpr double VerticalTolerance = 1e-3;

  ///@{
  /// The scene; never null, a Plane round the middle of the data by default. Null restores that.
  void SetGeoreference(vtkTerrainGeoreference* georeference);
  vtkTerrainGeoreference* GetGeoreference() const;
  ///@}

  ///@{
  /// CRS of inputs that do not name theirs: WKT, "EPSG:n", or a PROJ string. Default: none.
  void SetCoordinateSystem(const std::string& definition);
  const std::string& GetCoordinateSystem() const
  {
    return this->CoordinateSystem;
  }
  ///@}

  ///@{
  /// Distance of output samples in metres; 0 (default): that of the finest input in its middle,
  /// cells keeping their area.
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// How far the surface of an input goes on beyond its outer samples, straight, in cells of the
  /// input: 0 (the default) to 1. With 1 neighbouring tiles that are resampled one by one meet.
  vtkSetClampMacro(EdgeCells, double, 0.0, 1.0);
  vtkGetMacro(EdgeCells, double);
  ///@}

  /// How heights between samples are found.
  enum class InterpolationType
  {
    Bilinear,
    Cubic
  };
  ///@{
  /// Default Bilinear.
  void SetInterpolation(InterpolationType interpolation);
  InterpolationType GetInterpolation() const
  {
    return this->Interpolation;
  }
  ///@}

  ///@{
  /// Most output samples; an automatic spacing grows until they suffice, a chosen one that needs
  /// more is refused. Default 2^28 (1 GiB of float).
  vtkSetClampMacro(MaximumNumberOfSamples, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfSamples, vtkIdType);
  ///@}

  /// Why the last update failed, one sentence; empty if it did not.
  const std::string& GetErrorMessage() const
  {
    return this->ErrorMessage;
  }
  /// What the last update warned of; empty if nothing.
  const std::string& GetWarningMessage() const
  {
    return this->WarningMessage;
  }

  vtkMTimeType GetMTime() override;

  vtkTerrainReproject(const vtkTerrainReproject&) = delete;
  void operator=(const vtkTerrainReproject&) = delete;

protected:
  vtkTerrainReproject();
  ~vtkTerrainReproject() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  struct Tile;
  class vtkInternals;

  std::string Plan(vtkInformationVector* inputs);
  std::string ReadTile(vtkImageData* image, Tile& tile) const;
  static void PlanTurn(Tile& tile);
  std::string PlanScene();
  std::string PlanGrid();
  void PlanBounds(Tile& tile);
  std::string FitGrid(const double bounds[4]);
  void PlanSpacing(const Tile& tile);
  void CheckFlatness();
  void ShareScene(Tile& tile);
  void FileToScene(const Tile& tile, double* points, vtkIdType count);
  void PlaceBlock(const int extent[4], std::vector<double>& scene) const;
  void FillBlock(const int extent[4], double* heights, double* placeHeights);
  void SampleTiles(const std::vector<double>& scene, const std::vector<double>& places,
    const double bounds[4], double* heights);
  void AddFieldData(vtkImageData* output) const;

  std::string CoordinateSystem;
  double Spacing = 0.0;
  double EdgeCells = 0.0;
  InterpolationType Interpolation = InterpolationType::Bilinear;
  vtkIdType MaximumNumberOfSamples = vtkIdType(1) << 28;
  std::string ErrorMessage;
  std::string WarningMessage;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
