// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTerrainHierarchy
 * @brief A heightfield prepared for view-dependent refinement, in memory or in a file
 *
 * Holds nested errors, radii and slopes of the samples of a heightfield, which vtkTerrainStrips
 * refines for a camera. Made from an image (SetHeights), or from a file (OpenFile) that is mapped
 * and paged by the operating system. Files are written from memory (WriteFile) or row by row
 * without holding the raster (PrepareFile).
 *
 * Heights: vtkImageData of W x H x 1 points, 1 <= W, H <= 32769, point scalars of one component and
 * any type; NaN, magnitudes from 1e30 on and hidden points are no data. They are kept as float32.
 * Model coordinates are those of the image: x and y of its points, z = origin z + height.
 *
 * Memory: 12 bytes a sample, sides rounded up to 64 samples at each depth. A file keeps the same
 * bytes, checksums included 12 + 1e-5. A file that loses pages while it is open, because it was
 * truncated or its disk failed, never ends the process: IsDamaged() tells, and vtkTerrainStrips
 * reports an error, as it does for damage that shows in heights. OpenFile with verify finds all
 * damage there was before. Not noticed is what another program writes into a file that is open:
 * replace it by renaming another one, as WriteFile and PrepareFile do. Method and bounds:
 * core/strips/HierarchyBuild.h, core/strips/HierarchyFile.h.
 *
 * @sa vtkTerrainStrips vtkTerrainRasterReader
 */
#ifndef vtkTerrainHierarchy_h
#define vtkTerrainHierarchy_h

#include "vtkObject.h"
#include "vtkTerrainModule.h" // For export macro

#include <functional>
#include <memory>
#include <string>

class vtkImageData;
namespace terrain
{
struct HierarchyData;
}

class VTKTERRAIN_EXPORT vtkTerrainHierarchy : public vtkObject
{
public:
  static vtkTerrainHierarchy* New();
  vtkTypeMacro(vtkTerrainHierarchy, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Is told the part that is done, 0 to 1; false stops the work.
  using ProgressFunction = std::function<bool(double)>;
  /// Fills rows [first, first + count), south row first, with float heights, NaN for no data. Each
  /// row is asked for once, from the north to the south. Returns an error message or nothing.
  using RowFunction = std::function<std::string(vtkIdType first, vtkIdType count, float* heights)>;

  ///@{
  /// Prepares an image in memory. Returns false, with GetErrorMessage(), if it holds no heights,
  /// the memory does not suffice or progress stopped it; the hierarchy is empty then.
  bool SetHeights(vtkImageData* heights)
  {
    return this->SetHeights(heights, nullptr);
  }
  bool SetHeights(vtkImageData* heights, const ProgressFunction& progress);
  ///@}

  ///@{
  /// Whether what SetHeights prepares is refined down to every sample of the border, so that strips
  /// of neighbouring pieces of a terrain, which share that row or column, meet without a gap.
  /// Default off.
  vtkSetMacro(KeepBorder, bool);
  vtkGetMacro(KeepBorder, bool);
  vtkBooleanMacro(KeepBorder, bool);
  ///@}

  /// Opens a file. Checks its header and size, and all of its checksums if verify is true, which
  /// reads the whole file. Returns false, with GetErrorMessage(), if it cannot be used.
  bool OpenFile(VTK_FILEPATH const std::string& path, bool verify = false);

  ///@{
  /// Writes the hierarchy to a file, which appears under its name only when it is complete.
  /// Returns false, with GetErrorMessage(), on failure, and leaves no file behind.
  bool WriteFile(VTK_FILEPATH const std::string& path)
  {
    return this->WriteFile(path, nullptr);
  }
  bool WriteFile(const std::string& path, const ProgressFunction& progress);
  ///@}

  /// Prepares a raster of width x height samples straight into a file; this object stays as it is.
  /// Sample (i, j) lies at origin + (i, j) * spacing. The field data CRS, LayoutOrigin and
  /// LayoutScale of an image, which may be null, are kept (see vtkTerrainRasterReader). Returns
  /// false, with GetErrorMessage(), on failure, and leaves no file behind.
  bool PrepareFile(const std::string& path, int width, int height, const double origin[3],
    const double spacing[2], vtkImageData* placed, const RowFunction& rows,
    const ProgressFunction& progress = nullptr);

  /// True if a file begins as prepared files do, whatever its name is.
  static bool IsPreparedFile(VTK_FILEPATH const std::string& path);

  /// The heights as they were prepared: the samples of an extent (see vtkImageData) of the whole,
  /// as float point scalars "Elevation". A sample is NaN if none of its cells has a surface. Field
  /// data are CRS, LayoutOrigin and LayoutScale, where they are known. Returns false, with
  /// GetErrorMessage(), if the extent is not within the whole, or the file is damaged.
  bool GetHeights(const int extent[6], vtkImageData* heights);
  /// All of them.
  bool GetHeights(vtkImageData* heights);

  /// Why the last of the calls above failed, one sentence; empty after success.
  const std::string& GetErrorMessage() const
  {
    return this->ErrorMessage;
  }

  /// True if there is nothing to refine.
  bool IsEmpty() const
  {
    return !this->Data;
  }
  /// True if the open file has lost pages since it was opened.
  bool IsDamaged() const;
  /// Number of samples in x and y, 0 if empty.
  void GetDimensions(int dimensions[2]) const;
  /// Bounds of the surface; uninitialised (1, -1, ...) if nothing is drawn.
  void GetBounds(double bounds[6]) const;
  /// The coordinate reference system as text: the file's, or the field data array CRS of the image
  /// (see vtkTerrainRasterReader); empty if there is none.
  std::string GetCoordinateSystem() const;
  /// Gives memory of an open file back to the system; it is read again when it is needed.
  void ReleasePages();

  /// For vtkTerrainStrips: what is refined, never changed once it is there.
  std::shared_ptr<const terrain::HierarchyData> GetData() const
  {
    return this->Data;
  }

  vtkTerrainHierarchy(const vtkTerrainHierarchy&) = delete;
  void operator=(const vtkTerrainHierarchy&) = delete;

protected:
  vtkTerrainHierarchy();
  ~vtkTerrainHierarchy() override;

private:
  bool Finish(const std::string& error);

  std::shared_ptr<terrain::HierarchyData> Data;
  std::string ErrorMessage;
  bool KeepBorder = false;
};

#endif
