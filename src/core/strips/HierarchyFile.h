// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Hierarchies in files that are mapped and paged by the operating system.
 *
 * A file is a header of 4096 bytes, the records, the gradients (both in the order of
 * HierarchyLayout.h), the coordinate reference system as text, and a table with a 64-bit checksum
 * of every MiB of what lies between header and table. The header holds magic, version, byte order,
 * state, sizes, geometry, checksums of itself and of the table, and, where it is known, how the
 * heights are laid out in their coordinate reference system, with a checksum of its own. Numbers
 * are in the byte order of the machine that wrote the file; others refuse it.
 *
 * A file is written as an OutputFile, all of its space reserved first: under its own name it is
 * complete.
 */
#ifndef terrain_HierarchyFile_h
#define terrain_HierarchyFile_h

#include "core/strips/HierarchyBuild.h"
#include "core/strips/MappedFile.h"

#include <string>

namespace terrain
{
/// Version of the files that are written, and the newest that is read.
constexpr std::uint32_t kHierarchyFileVersion = 1;
/// Bytes of a header and of what one checksum covers.
constexpr std::size_t kHierarchyHeaderBytes = 4096;
constexpr std::size_t kHierarchyBlockBytes = std::size_t(1) << 20;

/// Where heights lie on earth. A file keeps it, nothing here depends on it.
struct HierarchyPlacing
{
  /// The coordinate reference system as text; empty if it is not known.
  std::string CoordinateSystem;
  /// How the heights are laid out in it: its coordinates = LayoutOrigin + (x, y) / LayoutScale.
  bool HasLayout = false;
  glm::dvec2 LayoutOrigin{ 0.0, 0.0 };
  glm::dvec2 LayoutScale{ 1.0, 1.0 };
};

/// True if a file begins as a hierarchy file does, whatever its name is and whatever follows.
bool IsHierarchyFile(const std::string& path);

/// An open hierarchy file.
class HierarchyFile
{
public:
  /// Opens and checks header and size, and with `verify` all checksums, which reads the whole file.
  /// Returns an error message, empty if all is well.
  std::string Open(const std::string& path, bool verify);

  /// Message about the first block whose checksum is wrong, or about a record without number;
  /// empty if there is none.
  std::string Verify() const;

  HierarchyView View() const;
  const HierarchyPlacing& Placing() const
  {
    return this->Place;
  }
  std::size_t Size() const
  {
    return this->File.Size();
  }
  /// True if the file has lost pages since it was opened: results are not to be trusted.
  bool IsDamaged() const
  {
    return this->File.IsDamaged();
  }
  /// Gives the memory of the finer depths back to the system.
  void ReleasePages() const;

private:
  MappedFile File;
  HierarchyLayout Layout;
  GridGeometry Geometry;
  HierarchySummary Summary;
  HierarchyPlacing Place;
  std::size_t RecordOffset = 0;
  std::size_t GradientOffset = 0;
  std::size_t TableOffset = 0;
};

/// Prepares a raster of width x height samples into a file. Returns an error message, empty if all
/// is well; nothing is left behind then under the file's name, nor the partial file.
std::string WriteHierarchyFile(const std::string& path, std::int64_t width, std::int64_t height,
  const GridGeometry& geometry, const HierarchyPlacing& placing, const HeightRows& rows,
  const ParallelFor& parallelFor, const BuildProgress& progress);

/// Writes a hierarchy that is in memory.
std::string WriteHierarchyFile(const std::string& path, const HierarchyView& hierarchy,
  const HierarchyPlacing& placing, const BuildProgress& progress);
}

#endif
