// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainColors
 * @brief   colours of heights, or of any other values, by the name of a scheme or from a file
 *
 * Schemes: "relief" (the default: green, brown, white, and blue below sea level), "oleron" and
 * "bukavu" (hypsometric, with a sea), "viridis", "cividis", "inferno", "batlow", "lapaz", "davos",
 * "oslo" (perceptually even), "twilight" (which ends as it begins, for directions) and "grey".
 * Sources: core/colors/ColorScheme.h.
 *
 * Files:
 *
 * | suffix | what                                                                              |
 * | ---    | ---                                                                               |
 * | .cpt   | GMT's colour palette table                                                        |
 * | .txt   | gdaldem's colour text, or a colour map that QGIS exported                         |
 * | .clr   | a colour map of ESRI or QGIS                                                      |
 * | .qml   | the colour ramp of a single-band raster in a QGIS style                           |
 * | .xml   | a ParaView colour map; its values are shares of the range, as ParaView takes them |
 * | .json  | the same, or its classes (IndexedColors with Annotations): the first of the file  |
 * | .csv   | classes: value, colour and name a line                                            |
 *
 * Colours are mixed in RGB, those of ParaView in the space that the file names. Where a file has
 * two colours for one value it is a step: the value itself has the upper colour (matplotlib and
 * GMT agree; vtkColorTransferFunction drops one of the two, gdaldem mixes them). Opacities in
 * files are not used.
 *
 * MakeTable() lays the colours over a range of data:
 * - a scheme goes from the lowest to the highest value; with a sea (SetSea()) its land begins at 0;
 * - a file's own values stay where they are, unless SetRange() stretches them.
 *
 * @code
 *   vtkNew<vtkTerrainColors> colors;
 *   if (colors->ReadFile("geo.cpt"))
 *   {
 *     actor->SetLookupTable(colors->MakeTable(lowest, highest));
 *   }
 * @endcode
 *
 * @sa vtkTerrainActor
 */
#ifndef vtkTerrainColors_h
#define vtkTerrainColors_h

#include "vtkColorTransferFunction.h" // For the table
#include "vtkObject.h"
#include "vtkSmartPointer.h"  // For the table
#include "vtkTerrainModule.h" // For export macro

#include <memory> // For internals
#include <string> // For names

class vtkDataArray;
class vtkFloatArray;

class VTKTERRAIN_EXPORT vtkTerrainColors : public vtkObject
{
public:
  static vtkTerrainColors* New();
  vtkTypeMacro(vtkTerrainColors, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainColors(const vtkTerrainColors&) = delete;
  void operator=(const vtkTerrainColors&) = delete;

  ///@{
  /// Names of the schemes, 0 <= index < GetNumberOfSchemes(); empty beyond.
  static int GetNumberOfSchemes();
  static std::string GetSchemeName(int index);
  ///@}

  /// Takes a scheme by its name. False, with GetErrorMessage(), if there is none of that name; the
  /// colours stay as they are then.
  bool SetScheme(const std::string& name);

  /// Takes the colours of a file. False, with GetErrorMessage(), if it cannot be read.
  bool ReadFile(VTK_FILEPATH const std::string& path);

  /// Takes the colour table of a band of a raster, as classes with the names that the file has for
  /// them, in names of categories or in an attribute table; colours of that table where there is no
  /// other. False, with GetErrorMessage(), if it has none.
  bool ReadRaster(VTK_FILEPATH const std::string& path, int band = 1);

  /// A scheme if there is one of that name, else a file.
  bool SetSchemeOrFile(const std::string& nameOrPath);

  ///@{
  /// Whether the first colour is the last; default off.
  vtkSetMacro(Reverse, bool);
  vtkGetMacro(Reverse, bool);
  vtkBooleanMacro(Reverse, bool);
  ///@}

  ///@{
  /// Values of the first and last colour, in the unit of the data. Default: those of the file, or
  /// of the data. The default holds unless lowest < highest.
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  ///@{
  /// Whether values below 0 have the colours of the sea, if the scheme has any: Automatic (default)
  /// where at least a tenth of the range lies below 0, or all of it; Always; Never.
  enum class SeaMode
  {
    Automatic,
    Always,
    Never
  };
  void SetSea(SeaMode sea);
  SeaMode GetSea() const
  {
    return this->Sea;
  }
  ///@}

  /// The table for data from lowest to highest; colours below and above are set where the file has
  /// them. No data are light grey where the file has no colour for them.
  vtkSmartPointer<vtkColorTransferFunction> MakeTable(double lowest, double highest);
  /// Fills a table with what MakeTable() makes: for Python, as VTK 9.1 hands no smart pointers on.
  void FillTable(vtkColorTransferFunction* table, double lowest, double highest);

  ///@{
  /// Names of the file's classes, with the value at which each begins, or is, and with its colour,
  /// 0 <= index < GetNumberOfCategories(). A class that begins nowhere has minus infinity.
  int GetNumberOfCategories() const;
  std::string GetCategoryName(int index) const;
  double GetCategoryValue(int index) const;
  void GetCategoryColor(int index, double rgb[3]) const;
  ///@}

  /// Whether the colours are those of classes: none is mixed of two others.
  bool IsDiscrete() const;

  /// Index of the file's class that each of some values belongs to, as floats; NaN for values of no
  /// class. Of the first component.
  vtkSmartPointer<vtkFloatArray> FindCategories(vtkDataArray* values) const;

  /// Why the last call failed, one sentence that names the file or scheme; empty after success.
  const std::string& GetErrorMessage() const
  {
    return this->ErrorMessage;
  }

protected:
  vtkTerrainColors();
  ~vtkTerrainColors() override;

private:
  class vtkInternals;

  std::unique_ptr<vtkInternals> Internals;
  bool Reverse = false;
  double Range[2] = { 0.0, 0.0 };
  SeaMode Sea = SeaMode::Automatic;
  std::string ErrorMessage;
};

#endif
