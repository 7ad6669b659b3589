// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainValues
 * @brief   brings the values of another raster of any CRS to the samples of heights
 *
 * Input: heights of a scene, vtkImageData of W x H x 1 points (vtkTerrainReproject,
 * vtkTerrainGlobe, or any heights in the frame of Georeference). FileName: any raster that GDAL
 * opens, such as rain, geology, land cover, or another band of the file of heights.
 *
 * Output: the heights, sharing their samples, with the array "Values" (float): band's value times
 * its scale plus its offset, NaN where the raster has none: beside it, at its NoData value, where
 * its mask or its last band, if that is alpha, is 0, and at classes of a transparent colour.
 *   - Values: an array of the points, resampled bilinearly, averaged where the raster is finer.
 *   - Classes: an array of the cells, the nearest value of each, the most frequent one where the
 *     raster is finer. Numbers between two classes stand for nothing.
 *   - Automatic (default): classes where the band has integers and a colour table, names of
 *     categories, or a thematic attribute table; else values.
 *
 * A raster without a CRS lies in the coordinates of the heights' own file where that has none
 * either. Method: GDAL's warper, as in vtkTerrainImageWarp.
 *
 * @code
 *   vtkNew<vtkTerrainValues> values;
 *   values->SetInputData(heights);
 *   values->SetGeoreference(scene);
 *   values->SetFileName("rain.tif");
 *   values->Update();
 *   actor->SetInputData(values->GetOutput());
 *   actor->GetTerrainMapper()->SetScalarModeToUsePointFieldData();
 *   actor->GetTerrainMapper()->SelectColorArray("Values");
 * @endcode
 *
 * Errors: one sentence in GetErrorMessage and an empty output: no file, no such band, no CRS, no
 * value on the terrain, heights on a globe in a scene of another frame.
 *
 * @sa vtkTerrainImageWarp vtkTerrainColors
 */
#ifndef vtkTerrainValues_h
#define vtkTerrainValues_h

#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h"  // For members
#include "vtkTerrainModule.h" // For export macro

#include <string>

class vtkTerrainGeoreference;

class VTKTERRAIN_EXPORT vtkTerrainValues : public vtkImageAlgorithm
{
public:
  static vtkTerrainValues* New();
  vtkTypeMacro(vtkTerrainValues, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The raster.
  void SetFileName(VTK_FILEPATH const std::string& fileName);
  const std::string& GetFileName() const
  {
    return this->FileName;
  }
  ///@}

  ///@{
  /// Number of its band, from 1 on; default 1.
  vtkSetMacro(Band, int);
  vtkGetMacro(Band, int);
  ///@}

  ///@{
  /// The scene of the heights; none by default.
  void SetGeoreference(vtkTerrainGeoreference* georeference);
  vtkTerrainGeoreference* GetGeoreference() const;
  ///@}

  ///@{
  /// CRS of a raster that does not name its own. Default: none.
  void SetCoordinateSystem(const std::string& definition);
  const std::string& GetCoordinateSystem() const
  {
    return this->CoordinateSystem;
  }
  ///@}

  /// What the numbers are.
  enum class KindType
  {
    Automatic,
    Values,
    Classes
  };
  ///@{
  /// Default Automatic.
  void SetKind(KindType kind);
  KindType GetKind() const
  {
    return this->Kind;
  }
  ///@}

  ///@{
  /// After an update: whether the numbers are classes; what the file calls them, or its own name
  /// without folder and suffix; their unit, empty for none.
  bool AreClasses() const
  {
    return this->Classes;
  }
  const std::string& GetTitle() const
  {
    return this->Title;
  }
  const std::string& GetUnit() const
  {
    return this->Unit;
  }
  ///@}

  /// Why the last update failed, one sentence; empty if it did not.
  const std::string& GetErrorMessage() const
  {
    return this->ErrorMessage;
  }

  vtkMTimeType GetMTime() override;

  vtkTerrainValues(const vtkTerrainValues&) = delete;
  void operator=(const vtkTerrainValues&) = delete;

protected:
  vtkTerrainValues();
  ~vtkTerrainValues() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  /// Adds the array to an image that shares the heights. Returns one sentence on failure.
  std::string AddValues(vtkImageData* image);

  std::string FileName;
  int Band = 1;
  std::string CoordinateSystem;
  KindType Kind = KindType::Automatic;
  bool Classes = false;
  std::string Title;
  std::string Unit;
  std::string ErrorMessage;
  vtkSmartPointer<vtkTerrainGeoreference> Georeference;
};

#endif
