// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files in memory that a raster is read from, in the place of tiles that cannot be read as they
 * stand. Private to the module.
 */
#ifndef vtkTerrain_raster_HeldFiles_h
#define vtkTerrain_raster_HeldFiles_h

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace terrain
{
/// A name in GDAL's file system in memory. What is written there is removed with this.
class HeldFile
{
public:
  /// A name that nobody else has, which ends as that of the file it stands for; `samples` are how
  /// many it holds.
  HeldFile(std::string source, std::int64_t samples);
  ~HeldFile();
  HeldFile(const HeldFile&) = delete;
  void operator=(const HeldFile&) = delete;

  const std::string& GetPath() const
  {
    return this->Path;
  }
  /// The file that it stands for.
  const std::string& GetSource() const
  {
    return this->Source;
  }
  std::int64_t GetSamples() const
  {
    return this->Samples;
  }

private:
  std::string Source;
  std::string Path;
  std::int64_t Samples = 0;
};

/// They live as long as the raster that is read from them.
using HeldFiles = std::vector<std::shared_ptr<const HeldFile>>;
}
#endif
