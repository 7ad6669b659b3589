// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that appear complete or not at all.
 */
#ifndef terrain_render_Outputs_h
#define terrain_render_Outputs_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainOutputFile.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkImageData;
class vtkRenderWindow;

/**
 * An output that is removed unless it is committed. Several are written first and committed then,
 * so that a failure of the last leaves none of them behind.
 */
class PendingFile
{
public:
  /// Throws a Failure if the file cannot be made where `path` says; an empty path stands for no
  /// file at all.
  explicit PendingFile(const std::string& path);

  /// True unless the path is empty.
  bool IsWanted() const
  {
    return this->Wanted;
  }
  /// Appends bytes. Throws a Failure.
  void Write(const void* bytes, std::size_t size) const;
  /// Throws a Failure about this file.
  [[noreturn]] void Fail(const std::string& reason) const;
  /// Gives the file its own name; what was there is replaced. Throws a Failure.
  void Commit() const;

  /// As it was given.
  const std::string& GetPath() const
  {
    return this->Path;
  }

private:
  std::string Path;
  bool Wanted;
  vtkNew<vtkTerrainOutputFile> File;
};

/// Name of picture `number`, from 1 on, of so many: "terrain-007.png".
std::string PictureName(const std::string& output, std::size_t number, std::size_t count);

/// Prints the whole name of a file that has been written.
void TellName(const std::string& file);

/// True for the name of a JPEG file.
bool IsJPEG(const std::string& name);

/// Why a picture cannot have a name: its suffix is that of another format. Empty if it can.
std::string WhyNotPicture(const std::string& name);

/// The colours of the window, as it was drawn: bytes, three components, four with alpha.
vtkSmartPointer<vtkImageData> CapturePicture(vtkRenderWindow* window, bool withAlpha);

/// Whether a picture is to be small, or written fast.
enum class PictureUse
{
  Lasting,
  Passing
};

/// A picture of bytes as PNG; dots per inch of 0 are not told. Empty if it cannot be encoded.
std::vector<unsigned char> EncodePicture(vtkImageData* picture, double dots, PictureUse use);

/// Writes an encoded picture. Throws a Failure.
void WriteEncoded(const std::vector<unsigned char>& bytes, const PendingFile& file);

/// Encodes and writes a picture, as JPEG for .jpg and .jpeg, else as PNG. Throws a Failure.
void WritePicture(vtkImageData* picture, double dots, const PendingFile& file);

/// Writes an image of float scalars, its lowest row first, as a GeoTIFF of float32 whose row 0 is
/// on top and whose NoData value is NaN. Throws a Failure.
void WriteDepths(vtkImageData* depths, const PendingFile& file);

/// Writes a text. Throws a Failure.
void WriteText(const std::string& text, const PendingFile& file);

#endif
