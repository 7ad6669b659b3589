// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainGlobe
 * @brief   lays heights in longitude and latitude onto a globe
 *
 * The input are heights as vtkTerrainRasterReader gives them, in a coordinate system of longitude
 * and latitude; the output are the same samples with field data by which vtkOpenGLTerrainMapper and
 * vtkTerrainActor draw them on the ellipsoid, with the technique Pyramid: nothing is resampled. The
 * scene is geocentric, in metres: x through longitude 0, z through the north pole. The surface is
 * the height bilinear in longitude and latitude, above the ellipsoid along its normal.
 *
 * - The ellipsoid is that of the coordinate system, of any planet or moon, or that of SetRadii().
 * - Samples that go round are joined at the date line: where they stand for cells, the first column
 *   is repeated.
 * - Columns that go on after a full round with the samples of the first ones are left out; so are
 *   rows beyond a pole without a height. Where there are others, there is no globe.
 * - Samples that go round and end within a cell of a pole are closed there by the mean of the last
 *   row. Where the last row lies at a pole, it stays as it is.
 * - Heights that are radii (all of them above half the polar one) count from a sphere's surface.
 * - Cells wider than a degree are divided; the surface stays the same.
 *
 * Several rasters of one planet are several terrains. A coarse one gives way to finer ones on input
 * port 1, the outputs of their own filters: its samples are lowered below them where they cover its
 * cells, so that the finest is seen. Its cells along the border of a finer one fall to there as
 * walls: no gap opens, and in a strip of two of its cells along the border the higher of both is
 * seen. Where the finer one has no data it stays as it is.
 *
 * Output: origin and spacing in degrees; point scalars of the input's type, or floats where cells
 * are divided, radii given or samples lowered; vtkGhostType; the field data of the input and
 * GlobeRadii (equatorial and polar, metres), GlobeLongitudes (of the first column and to the next)
 * and GlobeLatitudes (of the rows, degrees). Other arrays are not passed on.
 *
 * Memory: a copy of the heights where columns or rows are added, else none.
 *
 * @sa vtkTerrainGeoreference
 */
#ifndef vtkTerrainGlobe_h
#define vtkTerrainGlobe_h

#include "vtkImageAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

#include <string> // For std::string

class VTKTERRAIN_EXPORT vtkTerrainGlobe : public vtkImageAlgorithm
{
public:
  static vtkTerrainGlobe* New();
  vtkTypeMacro(vtkTerrainGlobe, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Semi-axes of the ellipsoid in metres, with a flattening of 0 to 0.1; 0 (default): those of the
  /// heights' coordinate system, of WGS84 where they have none.
  void SetRadii(double equatorial, double polar);
  const double* GetRadii() const VTK_SIZEHINT(2)
  {
    return this->Radii;
  }

  ///@{
  /// Heights on the same globe that this one gives way to, input port 1; any number.
  void AddFinerData(vtkImageData* globe);
  void AddFinerConnection(vtkAlgorithmOutput* globe);
  ///@}

  /// Empty, or one sentence that says why there is no output; VTK's error says it, too.
  const std::string& GetErrorMessage() const
  {
    return this->ErrorMessage;
  }

  /// True if a globe suits heights where nobody chooses a frame: they are in longitude and latitude
  /// and reach over more than 60 degrees of one, or lie on another world than the earth.
  static bool Suits(vtkImageData* heights);

  vtkTerrainGlobe(const vtkTerrainGlobe&) = delete;
  void operator=(const vtkTerrainGlobe&) = delete;

protected:
  vtkTerrainGlobe();
  ~vtkTerrainGlobe() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  bool Fail(vtkImageData* output, const std::string& why);

  std::string ErrorMessage;
  double Radii[2] = { 0.0, 0.0 };
};

#endif
