// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/GDALTable.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <link.h>
#include <unistd.h>

namespace terrain
{
namespace
{
constexpr const char* kNoGDAL = "GDAL, which reads files and coordinate systems, is not found: "
                                "'pip install rasterio' brings one to Python, Debian's package "
                                "python3-gdal to the system";
// GDAL 3.0 is libgdal.so.26; each release since has the next number.
constexpr int kFirstRelease = 26;
constexpr int kLastRelease = 60;

struct Line
{
  const char* Name;
  void** Address;
};

const std::vector<Line>& Lines()
{
#define VTKTERRAIN_LINE(name) { #name, &(name).Address },
  static const std::vector<Line> lines{ VTKTERRAIN_GDAL_FUNCTIONS(VTKTERRAIN_LINE) };
#undef VTKTERRAIN_LINE
  return lines;
}

/// What is known of GDAL in this process.
struct Finding
{
  std::mutex Mutex;
  std::vector<std::string> Added;
  std::string File;
  std::string WhyNot;
};

Finding& TheFinding()
{
  static auto* finding = new Finding; // for destructors of statics as well
  return *finding;
}

/// Takes the functions of a library and of those that it is linked to. Returns why it cannot be
/// used; empty if it can.
std::string Fill(void* library)
{
  std::string missing;
  for (const Line& line : Lines())
  {
    *line.Address = dlsym(library, line.Name);
    missing = missing.empty() && !*line.Address ? line.Name : missing;
  }
  return missing.empty() ? "" : "it has no function " + missing;
}

std::string Load(const std::string& path)
{
  void* library = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!library)
  {
    const char* reason = dlerror();
    return reason ? reason : "it cannot be loaded";
  }
  return Fill(library);
}

/// Paths of the libraries called libgdal in this process, in the order they were loaded.
std::vector<std::string> LoadedLibraries()
{
  std::vector<std::string> paths;
  dl_iterate_phdr(
    [](dl_phdr_info* info, std::size_t, void* data)
    {
      const std::string_view path = info->dlpi_name;
      if (path.substr(path.rfind('/') + 1).rfind("libgdal", 0) == 0)
      {
        static_cast<std::vector<std::string>*>(data)->emplace_back(path);
      }
      return 0;
    },
    &paths);
  return paths;
}

bool IsLoaded(const std::string& path)
{
  return Load(path).empty();
}

/// Fills the table. Returns why it is not filled.
std::string Find(const std::vector<std::string>& added)
{
  const char* named = std::getenv("VTKTERRAIN_GDAL");
  if (named && *named)
  {
    const std::string reason = Load(named);
    return reason.empty() ? "" : "VTKTERRAIN_GDAL names no GDAL that can be used: " + reason;
  }
  const std::vector<std::string> loaded = LoadedLibraries();
  bool isFound = Fill(RTLD_DEFAULT).empty() || // one that the program is linked to
    std::any_of(loaded.begin(), loaded.end(), IsLoaded) ||
    std::any_of(added.begin(), added.end(), IsLoaded) || IsLoaded("libgdal.so");
  for (int release = kLastRelease; !isFound && release >= kFirstRelease; --release)
  {
    isFound = IsLoaded("libgdal.so." + std::to_string(release));
  }
  return isFound ? "" : kNoGDAL;
}

/// The data that a package of Python brings beside its GDAL: X.libs/libgdal.so goes with
/// X/proj_data and X/gdal_data.
void FindData(const std::string& file)
{
  constexpr std::string_view kSuffix = ".libs";
  const std::string folder = file.substr(0, file.rfind('/'));
  if (folder.size() <= kSuffix.size() ||
    folder.compare(folder.size() - kSuffix.size(), kSuffix.size(), kSuffix) != 0)
  {
    return;
  }
  const std::string package = folder.substr(0, folder.size() - kSuffix.size());
  const std::string systems = package + "/proj_data";
  if (!std::getenv("PROJ_DATA") && !std::getenv("PROJ_LIB") &&
    access((systems + "/proj.db").c_str(), R_OK) == 0)
  {
    const std::array<const char*, 2> paths{ { systems.c_str(), nullptr } };
    reinterpret_cast<decltype(&::OSRSetPROJSearchPaths)>(OSRSetPROJSearchPaths.Address)(
      paths.data());
  }
  const std::string data = package + "/gdal_data";
  if (!std::getenv("GDAL_DATA") && access(data.c_str(), R_OK) == 0)
  {
    reinterpret_cast<decltype(&::CPLSetConfigOption)>(CPLSetConfigOption.Address)(
      "GDAL_DATA", data.c_str());
  }
}

/// The library that a function is in.
std::string FileOf(const void* function)
{
  Dl_info info{};
  return dladdr(function, &info) != 0 && info.dli_fname ? info.dli_fname : "";
}
}

const std::string& WhyNoGDAL()
{
  static std::once_flag once;
  Finding& finding = TheFinding();
  std::call_once(once,
    [&finding]
    {
      const std::lock_guard<std::mutex> lock(finding.Mutex);
      finding.WhyNot = Find(finding.Added);
      if (finding.WhyNot.empty())
      {
        finding.File = FileOf(GDALOpen.Address);
        FindData(finding.File);
      }
    });
  return finding.WhyNot;
}

void AddGDAL(const std::string& path)
{
  Finding& finding = TheFinding();
  const std::lock_guard<std::mutex> lock(finding.Mutex);
  finding.Added.push_back(path);
}

std::string GetGDALFile()
{
  Finding& finding = TheFinding();
  const std::lock_guard<std::mutex> lock(finding.Mutex);
  return finding.File;
}

void RequireGDAL()
{
  if (!WhyNoGDAL().empty())
  {
    throw std::runtime_error(WhyNoGDAL());
  }
}
}
