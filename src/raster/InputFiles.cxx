// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/InputFiles.h"

#include "core/files/OutputFile.h"
#include "raster/GDALTable.h"
#include "raster/RasterFile.h"
#include "raster/RasterRepairs.h"
#include "raster/RasterTiles.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace terrain
{
namespace
{
namespace fs = std::filesystem;

/// The file on disk behind a name of GDAL's: of "/vsizip//data/a.zip/b.tif" and of
/// "/vsizip/{/data/a.zip}/b.tif" it is "/data/a.zip".
std::string FileOnDisk(std::string name)
{
  name = BeforeByteOrderMark(name);
  while (name.compare(0, 4, "/vsi") == 0 && name.find('/', 1) != std::string::npos)
  {
    name = name.substr(name.find('/', 1) + 1);
    if (name.compare(0, 1, "{") == 0)
    {
      name = name.substr(1, name.rfind('}') - 1);
    }
  }
  std::error_code error;
  fs::path path(name);
  while (!fs::exists(path, error) && path.has_relative_path())
  {
    path = path.parent_path();
  }
  return path.string();
}

std::vector<std::string> ListFiles(GDALDatasetH dataset)
{
  std::vector<std::string> files;
  char** list = GDALGetFileList(dataset);
  for (char** file = list; file && *file; ++file)
  {
    files.emplace_back(*file);
  }
  CSLDestroy(list);
  return files;
}

std::vector<std::string> FilesOfVectors(const std::string& name)
{
  const GDALMessages messages;
  GDALDatasetH dataset =
    GDALOpenEx(name.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
  std::vector<std::string> files;
  if (dataset)
  {
    files = ListFiles(dataset);
    GDALClose(dataset);
  }
  return files;
}

std::vector<std::string> FilesOf(const std::string& name)
{
  if (!WhyNoGDAL().empty())
  {
    return {};
  }
  try
  {
    return RasterFile(name, {}, OpenRasterTiles).GetFileNames();
  }
  catch (const RasterError&)
  {
    return FilesOfVectors(name);
  }
}

/// True if `path` is called after `file`, and lies beside it: it may belong to it.
bool IsBeside(const fs::path& path, const fs::path& file)
{
  const std::string stem = file.stem().string();
  return IsSameFile(fs::absolute(path).parent_path(), fs::absolute(file).parent_path()) &&
    path.filename().string().compare(0, stem.size(), stem) == 0;
}

/// True if a file of a directory, or of one below it, is `path`.
bool IsInDirectory(const std::string& path, const std::string& directory)
{
  std::error_code error;
  fs::recursive_directory_iterator entry(
    directory, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
  {
    if (IsSameFile(path, entry->path().string()))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> RasterFile::GetFileNames() const
{
  const GDALMessages messages;
  std::vector<std::string> files = ListFiles(this->Dataset);
  files.erase(std::remove_if(files.begin(), files.end(),
                [](const std::string& file) { return file.compare(0, 8, "/vsimem/") == 0; }),
    files.end());
  for (const auto& held : this->Held)
  {
    files.push_back(held->GetSource());
  }
  return files;
}

//------------------------------------------------------------------------------
bool IsPartOfInput(const std::string& path, const std::string& input)
{
  std::error_code error;
  if (input.empty() || !fs::exists(path, error))
  {
    return false;
  }
  if (IsSameFile(path, FileOnDisk(input)))
  {
    return true;
  }
  // A directory is looked through before its tiles are opened, which takes longer.
  if (!WhyNotInput(input).empty() ||
    (fs::is_directory(input, error) && !IsInDirectory(path, input)))
  {
    return false;
  }
  const auto isPath = [&path](const std::string& file)
  { return IsSameFile(path, FileOnDisk(file)); };
  const std::vector<std::string> files = FilesOf(input);
  return std::any_of(files.begin(), files.end(),
    [&](const std::string& file)
    {
      if (isPath(file))
      {
        return true;
      }
      // Of the parts of a virtual raster GDAL tells the name only.
      const std::vector<std::string> more =
        IsBeside(path, file) ? FilesOf(file) : std::vector<std::string>();
      return std::any_of(more.begin(), more.end(), isPath);
    });
}
}
