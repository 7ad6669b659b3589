// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The heights of a raster file at full resolution, read by several threads at once. Private to the
 * module.
 */
#ifndef vtkTerrain_raster_RasterHeights_h
#define vtkTerrain_raster_RasterHeights_h

#include "raster/RasterFile.h"
#include "raster/RasterPiece.h"

#include "core/surface/TileFile.h"

#include <glm/glm.hpp>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace terrain
{
/// Which heights of which file; see vtkTerrainRasterReader.
struct RasterHeightsSettings
{
  std::string FileName;
  std::string Part;
  int Band = 0;
  RasterOptions Options;
};

/// Each thread that reads has a handle of its own, for GDAL's may be used by one at a time.
class RasterHeights
{
public:
  /// Opens the file and finds out how its heights are stored. Throws RasterError.
  explicit RasterHeights(RasterHeightsSettings settings);

  std::int64_t GetWidth() const
  {
    return this->Request.Width;
  }
  std::int64_t GetHeight() const
  {
    return this->Request.Height;
  }
  /// The smallest type that holds the heights: float for scaled ones and for more than 16 bits.
  StoredType GetType() const
  {
    return this->Type;
  }
  /// Size, time and some content of the file and of those it is made of, and the settings.
  TileFileKey FindKey() const;

  /// Reads samples [first, first + size) row by row from the south, NoStoredHeight<T>() where there
  /// is none. T: that of GetType(), or float. Returns an error message, empty if all is well.
  template <typename T>
  std::string Read(glm::i64vec2 first, glm::i64vec2 size, T* samples) const;

  /// Reads whole rows, by blocks of the file on several threads.
  template <typename T>
  std::string ReadRows(
    std::int64_t first, std::int64_t count, T* samples, const ParallelFor& parallelFor) const;
  /// Number of rows from `first` on that are whole blocks of the file.
  std::int64_t CountRows(std::int64_t first) const;

private:
  class Handle;
  std::unique_ptr<RasterFile> Open() const;
  template <typename T>
  void ReadFrom(const RasterFile& file, glm::i64vec2 first, glm::i64vec2 size, T* samples) const;
  template <typename Sample, typename T>
  void ReadAs(const RasterFile& file, glm::i64vec2 first, glm::i64vec2 size, T* samples) const;

  RasterHeightsSettings Settings;
  RasterRequest Request;
  StoredType Type = StoredType::Float;
  GDALDataType FileType = GDT_Float32;
  bool IsSignedByte = false;
  glm::i64vec2 Block{ 1, 1 };
  mutable std::mutex Mutex;
  mutable std::vector<std::unique_ptr<RasterFile>> Idle;
};
}
#endif
