// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/FolderFiles.h"

#include "raster/GDALTable.h"
#include "raster/PointText.h"
#include "raster/RasterMessages.h"
#include "raster/Words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace terrain
{
namespace
{
// Names that are listed in a message.
constexpr std::size_t kNamedFiles = 5;
// Folders below each other that are looked into.
constexpr int kDeepestFolder = 6;
// Files of no known kind that GDAL is asked about, for each is opened.
constexpr std::size_t kMostAsked = 500;

/// Of rasters that are heights or pictures: each is opened, however many there are.
bool IsAmbiguous(const std::string& extension)
{
  return IsOneOf(extension, { "png", "gpkg", "mrf", "h5", "hdf5", "zarr", "ers" });
}

bool IsText(const std::string& extension)
{
  return IsOneOf(extension, { "txt", "csv", "dat", "tsv" });
}

bool IsArchive(const std::string& extension)
{
  return IsOneOf(extension, { "zip", "tar", "tgz", "gz", "7z", "rar", "bz2", "xz" });
}

bool IsShape(const std::string& extension)
{
  return IsOneOf(extension,
    { "las", "laz", "e57", "copc", "pcd", "ply", "geojson", "shp", "gpx", "kml", "kmz", "dxf",
      "gml", "osm", "obj", "stl", "glb", "gltf", "vtp", "vtk", "vti" });
}

/// What belongs to another file: places, systems, headers, overviews, masks, colours, indices.
bool IsSidecar(const std::string& extension)
{
  return IsOneOf(extension,
    { "prj", "hdr", "tfw", "tifw", "pgw", "jgw", "wld", "blw", "bpw", "bqw", "j2w", "gfw", "stx",
      "clr", "ovr", "msk", "aux", "rrd", "ige", "rdc", "rsc", "tab", "sgrd", "mgrd", "gri", "shx",
      "dbf", "cpg", "sbn", "sbx", "qpj", "qml", "tfwx", "adf", "lrc", "idx", "ppg", "pjg" });
}

bool OpensAsRaster(const std::string& path)
{
  const GDALMessages messages;
  GDALDatasetH dataset =
    GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
  const bool opens = dataset && GDALGetRasterCount(dataset) > 0;
  if (dataset)
  {
    GDALClose(dataset);
  }
  return opens;
}

/// True if a text holds points on a grid.
bool OpensAsPoints(const std::string& path)
{
  const GDALMessages messages;
  RasterRecord record;
  GDALDatasetH dataset = OpenPointText(path, record);
  if (dataset)
  {
    GDALClose(dataset);
  }
  return dataset != nullptr;
}

/// True if a raster may be heights: it has a place and more than bytes, or parts of its own, and is
/// not virtual, for then its sources may lie beside it.
bool MayBeHeights(const std::string& path)
{
  const GDALMessages messages;
  GDALDatasetH dataset =
    GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
  if (!dataset)
  {
    return false;
  }
  const std::string driver = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
  std::array<double, 6> transform{};
  const bool isAlone = GDALGetRasterCount(dataset) > 0;
  const bool isPlaced = GDALGetGeoTransform(dataset, transform.data()) == CE_None;
  const bool isWide = isAlone && GDALGetRasterDataType(GDALGetRasterBand(dataset, 1)) != GDT_Byte;
  GDALClose(dataset);
  return isAlone ? driver != "VRT" && isPlaced && isWide
                 : IsOneOf(driver, { "Zarr", "HDF5", "GPKG" });
}

bool IsKnownRaster(const std::string& path)
{
  const GDALMessages messages;
  return GDALIdentifyDriverEx(path.c_str(), GDAL_OF_RASTER, nullptr, nullptr) != nullptr;
}

bool IsInStore(const std::string& name)
{
  return name.find(".zarr/") != std::string::npos;
}

/// Puts a file into the list that it belongs to, if any.
void SortFile(const std::string& path, FolderFiles& files, std::size_t& asked)
{
  const std::string name = LowerCase(CPLGetFilename(path.c_str()));
  const std::string extension = LowerCase(CPLGetExtension(path.c_str()));
  const bool isAuxiliary = name.size() > 8 && name.rfind(".aux.xml") == name.size() - 8;
  if (IsCalledTile(path) || (IsText(extension) && (OpensAsRaster(path) || OpensAsPoints(path))))
  {
    files.Rasters.push_back(path);
  }
  else if (IsArchive(extension))
  {
    files.Archives.push_back(path);
  }
  else if (IsShape(extension))
  {
    files.Shapes.push_back(path);
  }
  else if (!isAuxiliary && !IsSidecar(extension) && name.front() != '.')
  {
    const bool isAsked = !IsText(extension) && (IsAmbiguous(extension) || ++asked <= kMostAsked);
    const bool isRaster = isAsked && IsKnownRaster(path);
    std::vector<std::string>& rasters =
      isRaster && MayBeHeights(path) ? files.Rasters : files.OtherRasters;
    (isRaster ? rasters : files.Documents).push_back(path);
  }
}

/// "2 archives (a.zip, b.zip; REMEDY)", after what is there already.
void AddGroup(std::string& text, const std::vector<std::string>& paths, const char* one,
  const char* several, const char* remedy)
{
  if (paths.empty())
  {
    return;
  }
  std::vector<std::string> names;
  names.reserve(paths.size());
  for (const std::string& path : paths)
  {
    names.emplace_back(CPLGetFilename(path.c_str()));
  }
  text += (text.empty() ? "" : ", ") + std::to_string(paths.size()) + " " +
    (paths.size() == 1 ? one : several) + " (" + ListText(names, kNamedFiles) + remedy + ")";
}
}

//------------------------------------------------------------------------------
bool IsCalledTile(const std::string& path)
{
  return LowerCase(CPLGetFilename(path.c_str())) == "hdr.adf" ||
    IsOneOf(LowerCase(CPLGetExtension(path.c_str())),
      { "tif", "tiff", "hgt", "dem", "asc", "img", "dt0", "dt1", "dt2", "bil", "bip", "bsq", "flt",
        "grd", "jp2", "sdat", "nc", "xyz", "bag", "bt", "cub", "gxf", "grb", "grib", "grib2", "hf2",
        "mtw", "ntf", "rst", "sigdem" });
}

//------------------------------------------------------------------------------
FolderFiles FindFolderFiles(const std::string& directory)
{
  VSIDIR* entries = VSIOpenDir(directory.c_str(), kDeepestFolder, nullptr);
  if (!entries)
  {
    throw RasterError("it is a directory that cannot be listed, or an empty one");
  }
  std::vector<std::string> paths;
  FolderFiles files;
  while (const VSIDIREntry* entry = VSIGetNextDirEntry(entries))
  {
    const std::string path = CPLFormFilename(directory.c_str(), entry->pszName, nullptr);
    const bool isFolder = VSI_ISDIR(entry->nMode);
    const bool isStore = isFolder && EQUAL(CPLGetExtension(entry->pszName), "zarr");
    if ((isStore || !isFolder) && !IsInStore(entry->pszName))
    {
      paths.push_back(path);
    }
  }
  VSICloseDir(entries);
  std::sort(paths.begin(), paths.end());
  std::size_t asked = 0;
  for (const std::string& path : paths)
  {
    SortFile(path, files, asked);
  }
  return files;
}

//------------------------------------------------------------------------------
std::string DescribeOthers(const FolderFiles& files)
{
  std::string text;
  AddGroup(text, files.Archives, "archive", "archives", "; unpack them, or open one alone");
  AddGroup(text, files.OtherRasters, "raster that is not called as elevation tiles are",
    "rasters that are not called as elevation tiles are",
    "; open one alone, or several through gdalbuildvrt OUT.vrt FILES");
  AddGroup(text, files.Shapes, "file of points, lines or meshes",
    "files of points, lines or meshes", "; make a raster of them first: pdal, gdal_grid");
  return text;
}

//------------------------------------------------------------------------------
void TellOfOthers(const FolderFiles& files, RasterRecord& record)
{
  const std::string others = DescribeOthers(files);
  if (!others.empty())
  {
    record.Warn("left out of the folder: " + others);
  }
  std::string documents;
  AddGroup(documents, files.Documents, "file", "files", "");
  if (!documents.empty())
  {
    record.Take("left out", documents, "no rasters");
  }
}
}
