// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainGeoid
 * @brief   height of sea level above the ellipsoid, from installed geoid data
 *
 * A height above the ellipsoid (h, what GPS measures) and above sea level (H, what maps show)
 * differ by the geoid's own height: h = H + N, between -107 m and +86 m. N is interpolated (cubic)
 * from data in GeographicLib's format (NAME.pgm), which are not part of this module: GetWhyNot
 * names the missing file and how to get it.
 *
 * Reading happens at the first question. Files up to 64 MiB are held in memory and asked by any
 * number of threads at once; larger ones are read where needed, by one thread at a time.
 *
 * Source: C. F. F. Karney, GeographicLib::Geoid. Error of the interpolation: at most 0.14 m (5
 * minutes, EGM96), see there.
 *
 * @sa vtkTerrainGeoreference
 */
#ifndef vtkTerrainGeoid_h
#define vtkTerrainGeoid_h

#include "vtkObject.h"
#include "vtkTerrainModule.h" // For export macro

#include <memory>
#include <string>

class VTKTERRAIN_EXPORT vtkTerrainGeoid : public vtkObject
{
public:
  static vtkTerrainGeoid* New();
  vtkTypeMacro(vtkTerrainGeoid, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// "egm84", "egm96" or "egm2008" take the finest grid of that model that is installed; a full
  /// name ("egm96-15", or any NAME of a file NAME.pgm) takes just that. Default "egm96".
  void SetModel(const std::string& model);
  const std::string& GetModel() const
  {
    return this->Model;
  }
  ///@}

  ///@{
  /// Folder of the data; empty, the default, is GeographicLib's: GEOGRAPHICLIB_GEOID_PATH, else
  /// geoids/ in GEOGRAPHICLIB_DATA, else the folder given when GeographicLib was built.
  void SetDirectory(VTK_FILEPATH const std::string& directory);
  const std::string& GetDirectory() const
  {
    return this->Directory;
  }
  ///@}

  /// Empty if heights can be had, else one sentence: the missing file, and how to get it.
  std::string GetWhyNot();

  /// Path of the file in use; empty if there is none.
  std::string GetFileName();

  /// Height N of sea level above the WGS84 ellipsoid in metres; longitude and latitude in degrees.
  /// NaN without data and for latitudes beyond 90 degrees.
  double GetHeight(double longitude, double latitude);

  /// As above for count places of three doubles (the third is not read).
  void GetHeights(const double* places, double* heights, vtkIdType count)
    VTK_SIZEHINT(places, 3 * count) VTK_SIZEHINT(heights, count);

  vtkTerrainGeoid(const vtkTerrainGeoid&) = delete;
  void operator=(const vtkTerrainGeoid&) = delete;

protected:
  vtkTerrainGeoid();
  ~vtkTerrainGeoid() override;

private:
  class vtkInternals;
  void Load();

  std::string Model = "egm96";
  std::string Directory;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
