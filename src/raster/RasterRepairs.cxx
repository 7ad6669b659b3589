// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterRepairs.h"

#include "raster/GDALTable.h"
#include "raster/RasterArray.h"
#include "raster/RasterMessages.h"
#include "raster/RasterReference.h"
#include "raster/Words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>

namespace terrain
{
namespace
{
// GDAL's name for a file without the 3 bytes of the mark of UTF-8.
const char* const kBehindMark = "/vsisubfile/3,";

// Samples of a raster that is held in memory whole, at most.
constexpr std::int64_t kMostHeldSamples = std::int64_t{ 1 } << 29;

/// First bytes of a file as text.
std::string ReadHead(const std::string& file)
{
  constexpr std::size_t kHead = 4096;
  std::string head(kHead, '\0');
  VSILFILE* stream = VSIFOpenL(file.c_str(), "rb");
  if (!stream)
  {
    return {};
  }
  head.resize(VSIFReadL(head.data(), 1, head.size(), stream));
  VSIFCloseL(stream);
  return head;
}

std::vector<std::string> Split(const std::string& text, const char* separators)
{
  std::vector<std::string> words;
  char** list =
    CSLTokenizeString2(text.c_str(), separators, CSLT_STRIPLEADSPACES | CSLT_STRIPENDSPACES);
  for (char** word = list; word && *word; ++word)
  {
    words.emplace_back(*word);
  }
  CSLDestroy(list);
  return words;
}

/// A file of arrays, or nothing.
class ArrayFile
{
public:
  explicit ArrayFile(const std::string& file)
  {
    const char* const drivers[] = { "netCDF", "HDF5", nullptr };
    this->File = GDALOpenEx(
      file.c_str(), GDAL_OF_MULTIDIM_RASTER | GDAL_OF_READONLY, drivers, nullptr, nullptr);
    this->Root = this->File ? GDALDatasetGetRootGroup(this->File) : nullptr;
  }
  ~ArrayFile()
  {
    if (this->Root)
    {
      GDALGroupRelease(this->Root);
    }
    if (this->File)
    {
      GDALClose(this->File);
    }
  }
  ArrayFile(const ArrayFile&) = delete;
  void operator=(const ArrayFile&) = delete;

  /// All values of an array of one dimension; empty if there is none.
  std::vector<double> Read(const char* name, std::string* units = nullptr) const
  {
    GDALMDArrayH array = this->Root ? GDALGroupOpenMDArray(this->Root, name, nullptr) : nullptr;
    if (!array)
    {
      return {};
    }
    std::vector<double> values(static_cast<std::size_t>(GDALMDArrayGetTotalElementsCount(array)));
    const GUInt64 start = 0;
    const std::size_t count = values.size();
    GDALExtendedDataTypeH type = GDALExtendedDataTypeCreate(GDT_Float64);
    const bool read = GDALMDArrayGetDimensionCount(array) == 1 && count <= kMostHeldSamples &&
      GDALMDArrayRead(array, &start, &count, nullptr, nullptr, type, values.data(), values.data(),
        values.size() * sizeof(double)) != 0;
    GDALExtendedDataTypeRelease(type);
    const char* unit = GDALMDArrayGetUnit(array);
    if (units && unit)
    {
      *units = unit;
    }
    GDALMDArrayRelease(array);
    return read ? values : std::vector<double>();
  }

  /// An attribute of an array, or of the whole file where the name is null.
  double Number(const char* name, const char* attribute, double otherwise) const
  {
    GDALMDArrayH array = name ? GDALGroupOpenMDArray(this->Root, name, nullptr) : nullptr;
    GDALAttributeH found = array ? GDALMDArrayGetAttribute(array, attribute)
      : name                     ? nullptr
                                 : GDALGroupGetAttribute(this->Root, attribute);
    const double value = found ? GDALAttributeReadAsDouble(found) : otherwise;
    if (found)
    {
      GDALAttributeRelease(found);
    }
    if (array)
    {
      GDALMDArrayRelease(array);
    }
    return value;
  }

  GDALDatasetH File = nullptr;
  GDALGroupH Root = nullptr;
};

void SetSystem(GDALDatasetH dataset, const std::string& definition)
{
  OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
  OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER);
  if (DefineReference(reference, definition))
  {
    GDALSetSpatialRef(dataset, reference);
  }
  OSRRelease(reference);
}
/// A raster in memory of these samples; null if it cannot be made.
template <typename T>
GDALDatasetH MakeRasterOf(std::vector<T>& samples, int width, int height, GDALDataType type)
{
  GDALDatasetH dataset = MakeMemoryRaster(width, height, type, nullptr);
  if (GDALRasterIO(GDALGetRasterBand(dataset, 1), GF_Write, 0, 0, width, height, samples.data(),
        width, height, type, 0, 0) != CE_None)
  {
    GDALClose(dataset);
    return nullptr;
  }
  return dataset;
}

/// Place of a coverage of S-102; false if there is none.
bool ReadS102Place(
  const ArrayFile& arrays, const std::string& path, std::array<double, 6>& transform)
{
  GDALGroupH instance =
    arrays.Root ? GDALGroupOpenGroupFromFullname(arrays.Root, path.c_str(), nullptr) : nullptr;
  if (!instance)
  {
    return false;
  }
  const auto number = [instance](const char* name)
  {
    GDALAttributeH attribute = GDALGroupGetAttribute(instance, name);
    const double value = attribute ? GDALAttributeReadAsDouble(attribute) : std::nan("");
    if (attribute)
    {
      GDALAttributeRelease(attribute);
    }
    return value;
  };
  const double x = number("gridOriginLongitude");
  const double y = number("gridOriginLatitude");
  const double dx = number("gridSpacingLongitudinal");
  const double dy = number("gridSpacingLatitudinal");
  GDALGroupRelease(instance);
  // origin and rows: the centre of the south-western cell first (S-100 part 10c)
  transform = { x - 0.5 * dx, dx, 0.0, y - 0.5 * dy, 0.0, dy };
  return std::isfinite(x + y) && dx > 0.0 && dy > 0.0;
}

/// Depths of a coverage of S-102; null if there are none.
GDALDatasetH ReadS102Depths(const ArrayFile& arrays, const std::string& path)
{
  GDALMDArrayH values =
    GDALGroupOpenMDArrayFromFullname(arrays.Root, (path + "/Group_001/values").c_str(), nullptr);
  GDALMDArrayH depths = values ? GDALMDArrayGetView(values, "['depth']") : nullptr;
  GDALDatasetH view = depths ? GDALMDArrayAsClassicDataset(depths, 1, 0) : nullptr;
  GDALDatasetH dataset = nullptr;
  if (view)
  {
    const int width = GDALGetRasterXSize(view);
    const int height = GDALGetRasterYSize(view);
    std::vector<float> samples(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (GDALRasterIO(GDALGetRasterBand(view, 1), GF_Read, 0, 0, width, height, samples.data(),
          width, height, GDT_Float32, 0, 0) == CE_None)
    {
      dataset = MakeRasterOf(samples, width, height, GDT_Float32);
    }
    GDALClose(view);
  }
  for (GDALMDArrayH array : { depths, values })
  {
    if (array)
    {
      GDALMDArrayRelease(array);
    }
  }
  return dataset;
}
}

//------------------------------------------------------------------------------
GDALDatasetH MakeMemoryRaster(int width, int height, GDALDataType type, void* samples)
{
  GDALDatasetH dataset =
    GDALCreate(GDALGetDriverByName("MEM"), "", width, height, samples ? 0 : 1, type, nullptr);
  if (dataset && samples)
  {
    char** options = CSLSetNameValue(nullptr, "DATAPOINTER",
      CPLSPrintf(
        "%llu", static_cast<unsigned long long>(reinterpret_cast<std::uintptr_t>(samples))));
    const CPLErr added = GDALAddBand(dataset, type, options);
    CSLDestroy(options);
    if (added != CE_None)
    {
      GDALClose(dataset);
      dataset = nullptr;
    }
  }
  if (!dataset)
  {
    throw RasterError("there is not enough memory for its samples; limit their number");
  }
  return dataset;
}

//------------------------------------------------------------------------------
void CopyBandFacts(GDALRasterBandH from, GDALRasterBandH to)
{
  int given = 0;
  const double scale = GDALGetRasterScale(from, &given);
  if (given)
  {
    GDALSetRasterScale(to, scale);
  }
  const double offset = GDALGetRasterOffset(from, &given);
  if (given)
  {
    GDALSetRasterOffset(to, offset);
  }
  const double nodata = GDALGetRasterNoDataValue(from, &given);
  if (given)
  {
    GDALSetRasterNoDataValue(to, nodata);
  }
  GDALSetRasterUnitType(to, GDALGetRasterUnitType(from));
  GDALSetDescription(to, GDALGetDescription(from));
  GDALSetMetadata(to, GDALGetMetadata(from, nullptr), nullptr);
}

//------------------------------------------------------------------------------
GDALDatasetH MakeTransposed(GDALDatasetH dataset, int band)
{
  GDALRasterBandH from = GDALGetRasterBand(dataset, band);
  const int width = GDALGetRasterXSize(dataset);
  const int height = GDALGetRasterYSize(dataset);
  if (std::int64_t{ width } * height > kMostHeldSamples)
  {
    throw RasterError("its columns run north, and it is too large to be turned over in memory; "
                      "gdalwarp turns it");
  }
  const GDALDataType type = GDALGetRasterDataType(from);
  const int bytes = GDALGetDataTypeSizeBytes(type);
  GDALDatasetH turned = MakeMemoryRaster(height, width, type, nullptr);
  GDALRasterBandH to = GDALGetRasterBand(turned, 1);
  CopyBandFacts(from, to);
  // columns of the one are rows of the other: GDAL writes them to any steps in memory
  std::vector<char> samples(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
    static_cast<std::size_t>(bytes));
  const GDALMessages messages;
  const CPLErr read = GDALRasterIOEx(from, GF_Read, 0, 0, width, height, samples.data(), width,
    height, type, GSpacing{ bytes } * height, bytes, nullptr);
  const CPLErr written =
    GDALRasterIO(to, GF_Write, 0, 0, height, width, samples.data(), height, width, type, 0, 0);
  if (read != CE_None || written != CE_None)
  {
    GDALClose(turned);
    throw RasterError("its samples cannot be read (" + messages.GetFailure() + ")");
  }
  return turned;
}

//------------------------------------------------------------------------------
GDALDatasetH OpenGMTGrid(const std::string& file, RasterRecord& record)
{
  const ArrayFile arrays(file);
  std::string unit;
  const std::vector<double> x = arrays.Read("x_range", &unit);
  const std::vector<double> y = arrays.Read("y_range");
  const std::vector<double> size = arrays.Read("dimension");
  if (x.size() != 2 || y.size() != 2 || size.size() != 2 || !(size[0] >= 1.0) || !(size[1] >= 1.0))
  {
    return nullptr;
  }
  std::string heightUnit;
  std::vector<double> z = arrays.Read("z", nullptr);
  arrays.Read("z_range", &heightUnit);
  if (z.size() != static_cast<std::size_t>(size[0] * size[1]))
  {
    return nullptr;
  }
  const double scale = arrays.Number("z", "scale_factor", 1.0);
  const double offset = arrays.Number("z", "add_offset", 0.0);
  std::for_each(z.begin(), z.end(), [&](double& height) { height = offset + scale * height; });
  const bool isPixel = arrays.Number("z", "node_offset", 0.0) == 1.0;
  const double dx = (x[1] - x[0]) / (isPixel ? size[0] : std::max(size[0] - 1.0, 1.0));
  const double dy = (y[1] - y[0]) / (isPixel ? size[1] : std::max(size[1] - 1.0, 1.0));
  const double half = isPixel ? 0.0 : 0.5;
  GDALDatasetH dataset =
    MakeRasterOf(z, static_cast<int>(size[0]), static_cast<int>(size[1]), GDT_Float64);
  if (!dataset)
  {
    return nullptr;
  }
  double transform[6] = { x[0] - half * dx, dx, 0.0, y[1] + half * dy, 0.0, -dy };
  GDALSetGeoTransform(dataset, transform);
  GDALSetRasterUnitType(GDALGetRasterBand(dataset, 1), heightUnit.c_str());
  const std::string lower = LowerCase(unit);
  if (lower.find("degree") != std::string::npos || lower.find("longitude") != std::string::npos)
  {
    SetSystem(dataset, "EPSG:4326");
    record.Take("CRS", "WGS 84", "unit '" + unit + "' of x_range");
  }
  record.Take("format", "grid of GMT 3", "variables x_range, y_range, dimension");
  return dataset;
}

//------------------------------------------------------------------------------
GDALDatasetH OpenS102(const std::string& file, RasterRecord& record)
{
  const GDALMessages messages; // of groups that are not there
  const ArrayFile arrays(file);
  const std::string path = "/BathymetryCoverage/BathymetryCoverage.01";
  std::array<double, 6> transform{};
  GDALDatasetH dataset =
    ReadS102Place(arrays, path, transform) ? ReadS102Depths(arrays, path) : nullptr;
  if (!dataset)
  {
    return nullptr;
  }
  GDALSetGeoTransform(dataset, transform.data());
  const auto code = static_cast<int>(arrays.Number(nullptr, "horizontalCRS", 0.0));
  SetSystem(dataset, "EPSG:" + std::to_string(code));
  GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  GDALSetRasterNoDataValue(band, 1e6); // S-102, 10.2.7
  GDALSetRasterUnitType(band, "m");
  GDALSetDescription(band, "depth");
  GDALSetMetadataItem(band, "positive", "down", nullptr);
  record.Take("format", "S-102 bathymetry", "group BathymetryCoverage.01");
  return dataset;
}

//------------------------------------------------------------------------------
bool ReadGridHeader(const std::string& file, std::array<double, 6>& transform)
{
  std::map<std::string, double> header;
  for (const std::string& line : Split(ReadHead(file), "\n"))
  {
    const std::vector<std::string> words = Split(line, " \t\r");
    if (words.size() != 2 || std::isalpha(static_cast<unsigned char>(words[0][0])) == 0)
    {
      break;
    }
    std::string number = words[1];
    std::replace(number.begin(), number.end(), ',', '.');
    header[LowerCase(words[0])] = CPLAtof(number.c_str());
  }
  const auto has = [&header](const char* name) { return header.find(name) != header.end(); };
  const bool centreX = has("xllcenter");
  const bool centreY = has("yllcenter");
  const double dx = has("dx") ? header["dx"] : header["cellsize"];
  const double dy = has("dy") ? header["dy"] : header["cellsize"];
  if (centreX == centreY || !(centreX || has("xllcorner")) || !(centreY || has("yllcorner")) ||
    !(dx > 0.0) || !(dy > 0.0))
  {
    return false;
  }
  const double x = centreX ? header["xllcenter"] - 0.5 * dx : header["xllcorner"];
  const double y = centreY ? header["yllcenter"] - 0.5 * dy : header["yllcorner"];
  transform = { x, dx, 0.0, y + header["nrows"] * dy, 0.0, -dy };
  return true;
}

//------------------------------------------------------------------------------
bool NamesNaN(const std::string& file)
{
  const std::vector<std::string> words = Split(LowerCase(ReadHead(file)), " \t\r\n");
  return std::find(words.begin(), words.end(), "nan") != words.end();
}

//------------------------------------------------------------------------------
bool HasComments(const std::string& file)
{
  const std::string head = ReadHead(file);
  return std::string("#%/!").find(head.c_str()[0]) != std::string::npos &&
    head.c_str()[0] != '\0' && head.find('\0') == std::string::npos;
}

//------------------------------------------------------------------------------
bool HasByteOrderMark(const std::string& file)
{
  return ReadHead(file).compare(0, 3, "\xEF\xBB\xBF") == 0;
}

//------------------------------------------------------------------------------
std::string BehindByteOrderMark(const std::string& file)
{
  return kBehindMark + file;
}

//------------------------------------------------------------------------------
std::string BeforeByteOrderMark(const std::string& name)
{
  const std::string prefix = kBehindMark;
  return name.compare(0, prefix.size(), prefix) == 0 ? name.substr(prefix.size()) : name;
}

//------------------------------------------------------------------------------
std::string SystemBeside(const std::string& file)
{
  std::string text = ReadHead(CPLResetExtension(BeforeByteOrderMark(file).c_str(), "prj"));
  text.erase(0, text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0);
  for (const char* word :
    { "PROJCS[", "GEOGCS[", "COMPD_CS[", "PROJCRS[", "GEOGCRS[", "COMPOUNDCRS[" })
  {
    if (STARTS_WITH_CI(text.c_str(), word))
    {
      return "ESRI::" + text;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::vector<std::string> ReadColumnNames(const std::string& file)
{
  const std::string head = ReadHead(file);
  std::string line = LowerCase(head.substr(0, head.find_first_of("\r\n")));
  line.erase(0, std::min(line.find_first_not_of("#%/! \t\xEF\xBB\xBF"), line.size()));
  if (line.find_first_of("abcdefghijklmnopqrstuvwxyz") == std::string::npos)
  {
    return {};
  }
  // spaces stand within names where there is another separator
  const char* separator = " ";
  for (const char* other : { ";", "\t", "," })
  {
    separator = *separator == ' ' && line.find(other) != std::string::npos ? other : separator;
  }
  std::vector<std::string> names;
  for (std::string name : Split(line, separator))
  {
    name.erase(std::remove(name.begin(), name.end(), '"'), name.end());
    names.push_back(name);
  }
  return names;
}
}
