// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that appear complete or not at all.
 */
#ifndef terrain_render_Outputs_h
#define terrain_render_Outputs_h

#include <string>

class vtkImageData;
class vtkRenderWindow;

/**
 * A file under a temporary name beside its own, removed unless it is committed. Several are written
 * first and committed then, so that a failure of the last leaves none of them behind.
 */
class PendingFile
{
public:
  /// Throws a Failure if the file cannot be made where `path` says; an empty path stands for no
  /// file at all.
  explicit PendingFile(std::string path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// True unless the path is empty.
  bool IsWanted() const
  {
    return !this->Path.empty();
  }
  const std::string& GetPath() const
  {
    return this->Path;
  }
  /// Where the content goes until Commit().
  const std::string& GetTemporaryPath() const
  {
    return this->TemporaryPath;
  }

  /// Gives the file its own name; what was there is replaced. Throws a Failure.
  void Commit();

private:
  std::string Path;
  std::string TemporaryPath;
};

/// Writes the colours of the window as PNG. Throws a Failure.
void WritePicture(vtkRenderWindow* window, const PendingFile& file);

/// Writes an image of float scalars, its lowest row first, as a GeoTIFF of float32 whose row 0 is
/// on top and whose NoData value is NaN. Throws a Failure.
void WriteDepths(vtkImageData* depths, const PendingFile& file);

/// Writes a text. Throws a Failure.
void WriteText(const std::string& text, const PendingFile& file);

#endif
