// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterOpen.h"

#include "core/files/OutputFile.h"
#include "raster/FolderFiles.h"
#include "raster/GDALTable.h"
#include "raster/PointText.h"
#include "raster/RasterMessages.h"
#include "raster/RasterRemedies.h"
#include "raster/RasterRepairs.h"
#include "raster/Words.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace terrain
{
namespace
{
// Names that are listed in a message.
constexpr std::size_t kListedParts = 12;

std::string Extension(const std::string& name)
{
  return LowerCase(CPLGetExtension(name.c_str()));
}

bool Exists(const std::string& name)
{
  VSIStatBufL status;
  return VSIStatL(name.c_str(), &status) == 0;
}

bool IsDirectory(const std::string& name)
{
  VSIStatBufL status;
  return VSIStatL(name.c_str(), &status) == 0 && VSI_ISDIR(status.st_mode);
}

bool IsTextOfIntegers(GDALDatasetH dataset)
{
  GDALDriverH driver = GDALGetDatasetDriver(dataset);
  return driver && EQUAL(GDALGetDriverShortName(driver), "AAIGrid") &&
    GDALGetRasterDataType(GDALGetRasterBand(dataset, 1)) == GDT_Int32;
}

/// A grid of text whose numbers GDAL takes for whole ones, among which a "nan" becomes 0: opened
/// once more, as numbers with a fraction.
GDALDatasetH WithNaN(GDALDatasetH dataset, const std::string& name)
{
  if (!IsTextOfIntegers(dataset) || !NamesNaN(name))
  {
    return dataset;
  }
  GDALClose(dataset);
  const char* const options[] = { "DATATYPE=Float64", nullptr };
  return GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, options, nullptr);
}

GDALDatasetH OpenPlain(const std::string& name)
{
  GDALDatasetH dataset = GDALOpenEx(name.c_str(),
    GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr, nullptr);
  return dataset ? WithNaN(dataset, name) : nullptr;
}

/// The archive as a folder of GDAL's virtual file systems; empty if it is none.
std::string ArchiveFolder(const std::string& name)
{
  const std::string lower = LowerCase(name);
  const auto ends = [&lower](const std::string& end)
  {
    return lower.size() > end.size() &&
      lower.compare(lower.size() - end.size(), end.size(), end) == 0;
  };
  if (ends(".zip"))
  {
    return "/vsizip/{" + name + "}";
  }
  return ends(".tar") || ends(".tgz") || ends(".tar.gz") ? "/vsitar/{" + name + "}" : std::string();
}

/// Several rasters as one, of which `part` says the site; it becomes empty.
GDALDatasetH OpenSeveral(const std::string& folder, std::string& part, RasterRecord& record,
  HeldFiles& held, FolderOpener openFolder)
{
  if (!openFolder)
  {
    throw RasterError("it is a folder or an archive, not one raster");
  }
  GDALDatasetH dataset = openFolder(folder, part, record, held);
  part.clear();
  return dataset;
}

GDALDatasetH OpenArchive(std::string& name, std::string& part, RasterRecord& record,
  HeldFiles& held, FolderOpener openFolder)
{
  if (Extension(name) == "gz" && ArchiveFolder(name).empty())
  {
    const std::string inside = "/vsigzip/" + name;
    GDALDatasetH dataset = OpenPlain(inside);
    if (dataset)
    {
      name = inside;
      record.Take("file", inside, "unpacked");
    }
    return dataset;
  }
  const std::string folder = ArchiveFolder(name);
  if (folder.empty() || !Exists(name))
  {
    return nullptr;
  }
  const FolderFiles files = FindFolderFiles(folder);
  if (files.Rasters.size() > 1)
  {
    GDALDatasetH dataset = OpenSeveral(folder, part, record, held, openFolder);
    name = folder;
    return dataset;
  }
  const std::vector<std::string>& others =
    files.OtherRasters.empty() ? files.Archives : files.OtherRasters;
  if (files.Rasters.empty() && others.size() != 1)
  {
    const std::string inside = DescribeOthers(files);
    throw RasterError(
      "it is an archive without a raster in it" + (inside.empty() ? "" : ", but with " + inside));
  }
  name = files.Rasters.empty() ? others.front() : files.Rasters.front();
  record.Take("file", name, "the one raster in the archive");
  GDALDatasetH dataset = OpenPlain(name);
  return dataset ? dataset : OpenArchive(name, part, record, held, openFolder);
}

/// A text behind the byte order mark that it begins with; null if there is none.
GDALDatasetH OpenBehindMark(std::string& name, RasterRecord& record)
{
  if (name.empty() || IsDirectory(name) || !HasByteOrderMark(name))
  {
    return nullptr;
  }
  const std::string inside = BehindByteOrderMark(name);
  GDALDatasetH dataset = OpenPlain(inside);
  if (dataset)
  {
    name = inside;
    record.Take("file", inside, "the text behind its byte order mark");
  }
  return dataset;
}

/// Files that lie beside the data that they are for: the extensions of those, first come first
/// tried.
struct Header
{
  const char* Extension;
  std::vector<const char*> Data;
  /// True if GDAL may open the header itself, which is right then.
  bool MayBeData;
};

const std::vector<Header>& ListHeaders()
{
  static const std::vector<Header> headers{ { "sgrd", { "sdat" }, true },
    { "mgrd", { "sdat" }, false },
    { "prj", { "sdat", "asc", "flt", "bil", "bip", "bsq", "dem", "xyz", "tif" }, false },
    { "hdr",
      { "flt", "bil", "bip", "bsq", "img", "dem", "bin", "dat", "raw", "gri", "bt", "sdat", "" },
      true },
    { "gri", { "grd" }, true }, { "aux", { "img" }, true }, { "img", { "lbl", "xml" }, true },
    { "dat", { "lbl", "xml" }, true }, { "tfw", { "tif", "tiff" }, false },
    { "pgw", { "png" }, false }, { "jgw", { "jpg", "jpeg" }, false },
    { "wld", { "tif", "png", "jpg", "bmp", "gif" }, false }, { "blw", { "bil" }, false },
    { "stx", { "bil", "flt" }, false }, { "clr", { "bil", "asc" }, false },
    { "tab", { "grd", "grc", "tif" }, false }, { "rdc", { "rst" }, false },
    { "rsc", { "" }, false }, { "rrd", { "img" }, false }, { "ige", { "img" }, false },
    { "ers", { "" }, true } };
  return headers;
}

/// The data that a file stands beside, if GDAL opens them: of "a.bil.aux.xml" it is "a.bil".
GDALDatasetH OpenBeside(std::string& name, bool isFailed, RasterRecord& record)
{
  std::vector<std::string> others;
  const std::string extension = Extension(name);
  for (const Header& header : ListHeaders())
  {
    for (std::size_t k = 0;
         extension == header.Extension && k < header.Data.size() && (isFailed || !header.MayBeData);
         ++k)
    {
      const char* const other = header.Data[k];
      others.emplace_back(*other != '\0' ? CPLResetExtension(name.c_str(), other)
                                         : name.substr(0, name.size() - extension.size() - 1));
    }
  }
  const std::string aux = ".aux.xml";
  if (name.size() > aux.size() && LowerCase(name.substr(name.size() - aux.size())) == aux)
  {
    others.push_back(name.substr(0, name.size() - aux.size()));
  }
  for (const std::string& beside : others)
  {
    const bool isThere = beside != name && Exists(beside) && !IsDirectory(beside);
    GDALDatasetH dataset = isThere ? OpenPlain(beside) : nullptr;
    if (dataset)
    {
      record.Take(
        "file", beside, "the data that " + std::string(CPLGetFilename(name.c_str())) + " is for");
      name = beside;
      return dataset;
    }
  }
  return nullptr;
}

/// One part of a file of several.
struct Part
{
  std::string Name;
  /// The last word of its name: that of a variable, a table, a layer.
  std::string Label;
};

std::vector<Part> ListParts(GDALDatasetH dataset)
{
  std::vector<Part> parts;
  const char* const* list = GDALGetMetadata(dataset, "SUBDATASETS");
  for (int k = 1;; ++k)
  {
    const char* name = CSLFetchNameValue(list, CPLSPrintf("SUBDATASET_%d_NAME", k));
    if (!name)
    {
      return parts;
    }
    const std::string whole = name;
    const std::size_t cut = whole.find_last_of(":/");
    parts.push_back({ whole, cut == std::string::npos ? whole : whole.substr(cut + 1) });
  }
}

bool IsCalledHeights(const std::string& label)
{
  return IsOneOf(LowerCase(label),
    { "z", "elevation", "height", "altitude", "topo", "topography", "dem", "dsm", "dtm", "orog",
      "orography", "hgt", "hgt_m", "surface_altitude", "bathymetry", "depth", "bed", "rosetta",
      "relief", "elev", "heights", "ter", "terrain", "band1", "z_surface", "hsurf", "bathy",
      "deptho" });
}

std::string ListLabels(const std::vector<Part>& parts)
{
  std::vector<std::string> labels;
  labels.reserve(parts.size());
  for (const Part& part : parts)
  {
    labels.push_back(part.Label);
  }
  return ListText(labels, kListedParts);
}

const Part& ChoosePart(
  const std::vector<Part>& parts, const std::string& wanted, RasterRecord& record)
{
  if (!wanted.empty())
  {
    char* end = nullptr;
    const long number = std::strtol(wanted.c_str(), &end, 10);
    if (*end == '\0' && number >= 1 && number <= static_cast<long>(parts.size()))
    {
      return parts[static_cast<std::size_t>(number - 1)];
    }
    for (const Part& part : parts)
    {
      if (part.Label == wanted || part.Name == wanted)
      {
        return part;
      }
    }
    throw RasterError(
      "it has no part '" + wanted + "': its parts are " + ListLabels(parts) + " (--part NAME)");
  }
  const Part* found = nullptr;
  int count = 0;
  for (const Part& part : parts)
  {
    const bool fits = IsCalledHeights(part.Label);
    found = fits ? &part : found;
    count += fits ? 1 : 0;
  }
  if (parts.size() == 1)
  {
    return parts.front();
  }
  if (count != 1)
  {
    throw RasterError("it has no band of its own, but " + std::to_string(parts.size()) +
      " parts: choose one (--part NAME) of " + ListLabels(parts));
  }
  record.Warn("of its " + std::to_string(parts.size()) + " parts '" + found->Label +
    "' is taken, which is called as heights are (--part chooses another of " + ListLabels(parts) +
    ")");
  return *found;
}

/// True for a format that may be an S-102 product.
bool IsHDF5(GDALDatasetH dataset)
{
  GDALDriverH driver = GDALGetDatasetDriver(dataset);
  const std::string name = driver ? GDALGetDriverShortName(driver) : "";
  return IsOneOf(name, { "HDF5", "HDF5Image", "netCDF" });
}

/// A text of points of which GDAL took other columns than its first line names, read by those.
GDALDatasetH OpenByNames(
  GDALDatasetH dataset, const std::string& name, const GDALMessages& messages, RasterRecord& record)
{
  const std::vector<std::string>& warnings = messages.GetWarnings();
  const bool isDefaulted = std::any_of(warnings.begin(), warnings.end(),
    [](const std::string& warning)
    { return warning.find(kDefaultedColumns) != std::string::npos; });
  const std::optional<PointColumns> columns =
    isDefaulted ? FindPointColumns(ReadColumnNames(name)) : std::nullopt;
  if (!columns || *columns == PointColumns{ { 0, 1, 2 } })
  {
    return dataset;
  }
  GDALDatasetH points = OpenPointText(name, record);
  if (points)
  {
    GDALClose(dataset);
  }
  return points ? points : dataset;
}

GDALDatasetH OpenAny(std::string& name, std::string& part, RasterRecord& record, HeldFiles& held,
  FolderOpener openFolder);

/// The one raster of a folder, or several as one.
GDALDatasetH OpenFolder(std::string& name, std::string& part, RasterRecord& record, HeldFiles& held,
  FolderOpener openFolder)
{
  FolderFiles files = FindFolderFiles(name);
  if (files.Rasters.empty() && files.OtherRasters.size() == 1)
  {
    files.Rasters.swap(files.OtherRasters);
  }
  if (files.Rasters.size() != 1)
  {
    return OpenSeveral(name, part, record, held, openFolder);
  }
  TellOfOthers(files, record);
  name = files.Rasters.front();
  record.Take("file", name, "the one raster in the folder");
  return OpenAny(name, part, record, held, openFolder);
}

/// Any dataset under this name, with or without bands. `part` becomes empty where it was used.
GDALDatasetH OpenAny(std::string& name, std::string& part, RasterRecord& record, HeldFiles& held,
  FolderOpener openFolder)
{
  const GDALMessages messages;
  GDALDatasetH dataset = OpenBeside(name, false, record);
  bool isByNames = false;
  if (!dataset && !name.empty())
  {
    dataset = OpenPlain(name);
    GDALDatasetH points = dataset ? OpenByNames(dataset, name, messages, record) : nullptr;
    isByNames = points != dataset;
    dataset = points;
  }
  if (!dataset && IsDirectory(name)) // of no format that is a directory
  {
    return OpenFolder(name, part, record, held, openFolder);
  }
  if (!dataset && !name.empty())
  {
    dataset = OpenGMTGrid(name, record);
  }
  if (!dataset)
  {
    dataset = OpenBehindMark(name, record);
  }
  if (!dataset)
  {
    dataset = OpenArchive(name, part, record, held, openFolder);
  }
  if (!dataset)
  {
    dataset = OpenBeside(name, true, record);
  }
  if (!dataset && IsCalledPoints(name) && Exists(name))
  {
    dataset = OpenPointText(name, record);
    isByNames = dataset != nullptr;
  }
  if (!dataset)
  {
    throw RasterError(WhyNotOpened(name, messages.GetFailure()));
  }
  for (const std::string& warning : messages.GetWarnings())
  {
    record.Warn("GDAL: " + warning);
  }
  if (isByNames)
  {
    record.Forget(kDefaultedColumns);
  }
  return dataset;
}
}

//------------------------------------------------------------------------------
bool HasWordOfHeights(const std::string& name)
{
  std::string word;
  for (const char c : name + " ")
  {
    const bool isLetter = std::isalpha(static_cast<unsigned char>(c)) != 0;
    if (!isLetter && !word.empty() && IsCalledHeights(word))
    {
      return true;
    }
    if (isLetter)
    {
      word += c;
    }
    else
    {
      word.clear();
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void RegisterDrivers()
{
  if (!WhyNoGDAL().empty())
  {
    throw RasterError(WhyNoGDAL());
  }
  static std::once_flag once;
  std::call_once(once, [] { GDALAllRegister(); });
}

//------------------------------------------------------------------------------
GDALDatasetH OpenRaster(std::string& name, const std::string& wanted, RasterRecord& record,
  HeldFiles& held, FolderOpener openFolder)
{
  std::string part = wanted;
  RegisterDrivers();
  const std::string whyNot = WhyNotInput(name);
  if (!whyNot.empty())
  {
    throw RasterError(whyNot);
  }
  GDALDatasetH dataset = OpenAny(name, part, record, held, openFolder);
  if (GDALDatasetH depths = IsHDF5(dataset) ? OpenS102(name, record) : nullptr)
  {
    GDALClose(dataset);
    return depths;
  }
  const std::vector<Part> parts = ListParts(dataset);
  if (GDALGetRasterCount(dataset) > 0 && (part.empty() || parts.empty()))
  {
    if (!part.empty())
    {
      GDALClose(dataset);
      throw RasterError("it has no parts to choose from (--part)");
    }
    return dataset;
  }
  GDALClose(dataset);
  if (parts.empty())
  {
    throw RasterError("it has no band and no part that is a raster");
  }
  const Part& chosen = ChoosePart(parts, part, record);
  const GDALMessages messages;
  dataset = OpenPlain(chosen.Name);
  if (!dataset || GDALGetRasterCount(dataset) < 1)
  {
    if (dataset)
    {
      GDALClose(dataset);
    }
    throw RasterError("its part '" + chosen.Label + "' is not a raster that GDAL can open" +
      (messages.GetFailure().empty() ? "" : " (" + messages.GetFailure() + ")"));
  }
  for (const std::string& warning : messages.GetWarnings())
  {
    record.Warn("GDAL: " + warning);
  }
  name = chosen.Name;
  record.Take("part", chosen.Label, part.empty() ? "chosen by its name" : "given");
  return dataset;
}
}
