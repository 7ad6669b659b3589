// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainOutputFile
 * @brief   a file that appears complete or not at all, and in place of nothing that must stay
 *
 * The content goes to a partial file beside the output, under a name that no other process uses;
 * Commit() flushes it to the disk and gives it its own name. Until then what was there before stays
 * as it is. The partial file is removed by Discard(), by the destructor, and by
 * RemovePartialFiles(), which a program calls in the handlers of the signals that end it.
 *
 * Refused, with one sentence: a path that is one of the inputs (AddInput); what exists and is no
 * regular file, such as a device, a pipe or a directory; a file that may not be written; a symbolic
 * link to nothing. Other symbolic links are followed: the target is replaced, and the link stays.
 * A file that is replaced hands its permissions on. What GDAL kept beside it (.aux.xml, .ovr, .msk:
 * its statistics, overviews and mask) goes with it, unless it is an input.
 *
 * @code{.cpp}
 * vtkNew<vtkTerrainOutputFile> file;
 * file->AddInput("heights.tif");
 * if (!file->Open("picture.png") || !file->Write(bytes, size) || !file->Commit())
 * {
 *   std::cerr << file->GetErrorMessage() << '\n';
 * }
 * @endcode
 *
 * @sa vtkTerrainHierarchy
 */
#ifndef vtkTerrainOutputFile_h
#define vtkTerrainOutputFile_h

#include "vtkObject.h"
#include "vtkTerrainModule.h" // For export macro

#include <cstddef> // For sizes
#include <memory>  // For internals
#include <string>  // For paths

class VTKTERRAIN_EXPORT vtkTerrainOutputFile : public vtkObject
{
public:
  static vtkTerrainOutputFile* New();
  vtkTypeMacro(vtkTerrainOutputFile, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainOutputFile(const vtkTerrainOutputFile&) = delete;
  void operator=(const vtkTerrainOutputFile&) = delete;

  /// A raster, a directory of tiles or a file of vectors, by any name that GDAL opens, that is to
  /// stay: with all files that are read with it. Empty names are ignored.
  void AddInput(VTK_FILEPATH const std::string& name);

  /// Name of the input that `path` is a file of, compared by device and inode; empty if of none.
  std::string FindInput(VTK_FILEPATH const std::string& path) const;

  /// Makes the partial file, empty. False, with GetErrorMessage(), if it cannot be made, or if the
  /// output would replace what must stay. A partial file before it is discarded.
  bool Open(VTK_FILEPATH const std::string& path);

  /// Where the content goes until Commit(), for those who do not use Write(); empty before Open().
  std::string GetPartialFileName() const;

  /// Appends `size` bytes. False, with GetErrorMessage(), if they cannot all be written.
  VTK_WRAPEXCLUDE bool Write(const void* bytes, std::size_t size);

  /// Flushes the content to the disk and gives the file its name. False, with GetErrorMessage(), on
  /// failure; the partial file is removed then.
  bool Commit();

  /// Removes the partial file; nothing if there is none.
  void Discard();

  /// Why the last of the calls above failed, one sentence that names the path; empty after success.
  const std::string& GetErrorMessage() const
  {
    return this->ErrorMessage;
  }

  /// Removes the partial files of all outputs of this process, hierarchies included. Safe in signal
  /// handlers.
  static void RemovePartialFiles();

  /// Why a file cannot be read, as one sentence; empty unless it exists and is neither a regular
  /// file nor a directory. Opening a pipe would wait for its writer without an end.
  static std::string WhyNotInput(VTK_FILEPATH const std::string& path);

protected:
  vtkTerrainOutputFile();
  ~vtkTerrainOutputFile() override;

private:
  class vtkInternals;
  bool Finish(const std::string& error);

  std::unique_ptr<vtkInternals> Internals;
  std::string ErrorMessage;
};

#endif
