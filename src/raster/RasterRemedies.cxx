// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterRemedies.h"

#include "raster/GDALTable.h"
#include "raster/PointText.h"
#include "raster/RasterMessages.h"
#include "raster/RasterRecord.h"
#include "raster/RasterRepairs.h"
#include "raster/Words.h"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace terrain
{
namespace
{
// Names that are listed in a message.
constexpr std::size_t kListedColumns = 12;

/// True if GDAL knows a file as points, lines or areas.
bool IsVector(const std::string& name)
{
  const GDALMessages messages;
  return GDALIdentifyDriverEx(name.c_str(), GDAL_OF_VECTOR, nullptr, nullptr) != nullptr;
}

/// What to do about a file of another kind, by its extension; empty if nothing is known.
std::string RemedyOf(const std::string& name)
{
  const std::string extension = LowerCase(CPLGetExtension(name.c_str()));
  if (IsOneOf(extension, { "raw", "dat", "bin" }) && !IsVector(name))
  {
    return "it is not a raster that GDAL can open; numbers without a header need one beside them, "
           "of the same name with .hdr and the lines 'ENVI', 'samples = COLUMNS', 'lines = ROWS', "
           "'bands = 1', 'data type = 4' (2 for 16 bits, 5 for 64) and 'byte order = 0'";
  }
  if (IsOneOf(extension, { "las", "laz", "e57", "copc", "pcd", "ply" }))
  {
    return "it holds points, not a raster: make a grid of them first (pdal's writers.gdal)";
  }
  if (IsOneOf(extension, { "geojson", "shp", "gpx", "kml", "kmz", "dxf", "gml", "osm" }))
  {
    return "it holds points or lines, not a raster: make a grid of them first (gdal_grid)";
  }
  if (IsOneOf(extension, { "obj", "stl", "glb", "gltf", "vtp", "vtk", "vti" }))
  {
    return "it holds a mesh or an image of VTK, which GDAL does not open: read it with VTK's "
           "readers";
  }
  if (extension == "hgt")
  {
    return "it is no square of 1201, 1801, 3601 or 7201 samples of 2 bytes, as .hgt files are: it "
           "may be incomplete, get it again";
  }
  if (IsOneOf(extension, { "7z", "rar", "bz2", "xz" }))
  {
    return "it is an archive of a kind that GDAL does not open: unpack it first";
  }
  if (IsOneOf(extension, { "zarr" }))
  {
    return "this GDAL (" + std::string(GDALVersionInfo("RELEASE_NAME")) +
      ") opens no such Zarr; version 3 of the format needs GDAL 3.8 or later";
  }
  return {};
}

/// What to do with points that lie on no grid.
std::string WhyNoGrid(const std::string& name)
{
  const std::vector<std::string> names = ReadColumnNames(name);
  const bool hasNames = !names.empty();
  if (hasNames && !FindPointColumns(names))
  {
    return "its first line does not tell which of the columns " + ListText(names, kListedColumns) +
      " are places and heights: call them x, y and z there, or lon, lat and z";
  }
  return "the points in its first three columns, or in those that its first line calls x, y and "
         "z, do not lie on a grid: make one of them (" +
    std::string(
      hasNames ? "tr ';\\t' ',,' < IN > P.csv" : "(echo x,y,z; tr -s ' ;\\t' , < IN) > P.csv") +
    "; ogr2ogr -oo X_POSSIBLE_NAMES=x -oo Y_POSSIBLE_NAMES=y P.shp P.csv; gdal_grid -zfield z -a "
    "linear P.shp OUT.tif)";
}
}

//------------------------------------------------------------------------------
std::string WhyNotOpened(const std::string& name, const std::string& failure)
{
  if (name.empty())
  {
    return "no file name is given";
  }
  VSIStatBufL status;
  std::memset(&status, 0, sizeof(status));
  errno = 0;
  if (VSIStatL(name.c_str(), &status) != 0)
  {
    if (errno == EACCES)
    {
      return "there is no permission to read it";
    }
    const bool plainName = name.find(':') == std::string::npos && name[0] != '<';
    return plainName || failure.empty() ? "there is no such file" : failure;
  }
  if (name.compare(0, 4, "/vsi") != 0 && faccessat(AT_FDCWD, name.c_str(), R_OK, AT_EACCESS) != 0)
  {
    return "there is no permission to read it";
  }
  if (status.st_size == 0)
  {
    return "it is empty";
  }
  std::string remedy = RemedyOf(name);
  if (remedy.empty() && HasComments(name))
  {
    remedy = "it is a text with lines before its first point or header that GDAL does not skip: "
             "take them out (sed '/^[#%/!]/d' IN > OUT.xyz)";
  }
  const bool isText = IsCalledPoints(name) && !ReadColumnNames(name).empty();
  if (remedy.empty() && (isText || failure.find("Ungridded") != std::string::npos))
  {
    return WhyNoGrid(name);
  }
  if (remedy.empty() && IsVector(name))
  {
    return "it holds points or lines, not a raster: make a grid of them first (gdal_grid)";
  }
  return remedy.empty()
    ? "it is not a raster that GDAL can open" + (failure.empty() ? "" : " (" + failure + ")")
    : remedy;
}
}
