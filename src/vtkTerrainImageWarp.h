// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainImageWarp
 * @brief   brings a picture of any CRS onto the terrain of a scene
 *
 * Input: heights of the scene, vtkImageData of W x H x 1 points (vtkTerrainReproject, or any
 * heights in the frame of Georeference). FileName: any raster that GDAL opens: grey, palette, RGB,
 * with alpha, with NoData, with a mask; samples of more than 8 bits are stretched from their
 * smallest to their largest value.
 *
 * Output: vtkImageData of unsigned char RGBA, the first row southernmost, pixel centres at origin +
 * (i, j) * spacing in the scene, limited to where the picture and the heights overlap. Alpha is 0
 * where the picture has no data. Resolution is that of the picture itself in the middle of the
 * overlap, unless MaximumSize is less.
 *
 * Method: GDAL's warper (bilinear, averaging where it reduces) with a transformation of our own, by
 * way of longitude and latitude. In the round frame Local each pixel is taken from where the
 * vertical line of the scene meets the terrain, so that the picture stays on its summits. In flat
 * frames the transformation is interpolated, to InterpolationError.
 *
 * Errors: one sentence in GetErrorMessage and an empty output: no file, no CRS, no overlap.
 *
 * @sa vtkTerrainReproject vtkTerrainGeoreference
 */
#ifndef vtkTerrainImageWarp_h
#define vtkTerrainImageWarp_h

#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h"  // For members
#include "vtkTerrainModule.h" // For export macro

#include <memory>
#include <string>

class vtkTerrainGeoreference;

class VTKTERRAIN_EXPORT vtkTerrainImageWarp : public vtkImageAlgorithm
{
public:
  static vtkTerrainImageWarp* New();
  vtkTypeMacro(vtkTerrainImageWarp, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Largest error of the place that a pixel is taken from in flat frames, in pixels of the
  /// picture.
  static constexpr double InterpolationError = 0.05;

  ///@{
  /// The picture.
  void SetFileName(VTK_FILEPATH const std::string& fileName);
  const std::string& GetFileName() const
  {
    return this->FileName;
  }
  ///@}

  ///@{
  /// The scene of the heights; none by default.
  void SetGeoreference(vtkTerrainGeoreference* georeference);
  vtkTerrainGeoreference* GetGeoreference() const;
  ///@}

  ///@{
  /// CRS of a picture that does not name its own. Default: none.
  void SetCoordinateSystem(const std::string& definition);
  const std::string& GetCoordinateSystem() const
  {
    return this->CoordinateSystem;
  }
  ///@}

  ///@{
  /// Most pixels a side; default 16384, which graphics cards hold in one texture.
  vtkSetClampMacro(MaximumSize, int, 1, 1 << 20);
  vtkGetMacro(MaximumSize, int);
  ///@}

  /// Why the last update failed, one sentence; empty if it did not.
  const std::string& GetErrorMessage() const
  {
    return this->ErrorMessage;
  }

  vtkMTimeType GetMTime() override;

  vtkTerrainImageWarp(const vtkTerrainImageWarp&) = delete;
  void operator=(const vtkTerrainImageWarp&) = delete;

protected:
  vtkTerrainImageWarp();
  ~vtkTerrainImageWarp() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  class vtkInternals;

  std::string FileName;
  std::string CoordinateSystem;
  int MaximumSize = 16384;
  std::string ErrorMessage;
  vtkSmartPointer<vtkTerrainGeoreference> Georeference;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
