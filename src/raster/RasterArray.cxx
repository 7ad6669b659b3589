// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterArray.h"

#include "raster/GDALTable.h"
#include "raster/RasterMessages.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace terrain
{
namespace
{
// Values of coordinates that are read whole, at most.
constexpr std::size_t kMostValues = std::size_t{ 1 } << 28;

struct Dimensions
{
  explicit Dimensions(GDALMDArrayH array)
    : List(GDALMDArrayGetDimensions(array, &this->Count))
  {
  }
  ~Dimensions()
  {
    GDALReleaseDimensions(this->List, this->Count);
  }
  Dimensions(const Dimensions&) = delete;
  void operator=(const Dimensions&) = delete;

  std::size_t Size(std::size_t k) const
  {
    return static_cast<std::size_t>(GDALDimensionGetSize(this->List[k]));
  }

  std::size_t Count = 0;
  GDALDimensionH* List;
};

/// The numbers of an attribute, with commas between them.
std::string ListOfNumbers(GDALAttributeH attribute)
{
  std::size_t count = 0;
  double* numbers = GDALAttributeReadAsDoubleArray(attribute, &count);
  std::string text;
  for (std::size_t k = 0; k < count; ++k)
  {
    text += (k > 0 ? "," : "") + std::string(CPLSPrintf("%.17g", numbers[k]));
  }
  CPLFree(numbers);
  return text;
}

std::vector<std::string> NamesOfArrays(GDALGroupH group)
{
  std::vector<std::string> names;
  char** list = GDALGroupGetMDArrayNames(group, nullptr);
  for (char** name = list; name && *name; ++name)
  {
    names.emplace_back(*name);
  }
  CSLDestroy(list);
  return names;
}

/// Full names of arrays of two dimensions and more, in a group and those below it.
std::vector<std::string> FindRasterArrays(GDALGroupH group, int depth = 0)
{
  constexpr int kDeepest = 8;
  std::vector<std::string> found;
  for (const std::string& name : NamesOfArrays(group))
  {
    GDALMDArrayH array = GDALGroupOpenMDArray(group, name.c_str(), nullptr);
    if (array && GDALMDArrayGetDimensionCount(array) >= 2)
    {
      found.emplace_back(GDALMDArrayGetFullName(array));
    }
    if (array)
    {
      GDALMDArrayRelease(array);
    }
  }
  char** list = depth < kDeepest ? GDALGroupGetGroupNames(group, nullptr) : nullptr;
  for (char** name = list; name && *name; ++name)
  {
    if (GDALGroupH below = GDALGroupOpenGroup(group, *name, nullptr))
    {
      const std::vector<std::string> more = FindRasterArrays(below, depth + 1);
      found.insert(found.end(), more.begin(), more.end());
      GDALGroupRelease(below);
    }
  }
  CSLDestroy(list);
  return found;
}

std::map<std::string, std::string> ReadAttributes(GDALMDArrayH array)
{
  std::map<std::string, std::string> attributes;
  std::size_t count = 0;
  GDALAttributeH* list = GDALMDArrayGetAttributes(array, &count, nullptr);
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::string name = GDALAttributeGetName(list[k]);
    const char* text = GDALAttributeReadAsString(list[k]);
    attributes[name] = name == "valid_range" ? ListOfNumbers(list[k]) : text ? text : "";
  }
  GDALReleaseAttributes(list, count);
  const char* unit = GDALMDArrayGetUnit(array);
  if (unit && *unit)
  {
    attributes["units"] = unit;
  }
  return attributes;
}

/// All values of an array as double; empty if there are too many or none can be read.
std::vector<double> ReadValues(GDALMDArrayH array)
{
  const Dimensions dimensions(array);
  std::vector<GUInt64> start(dimensions.Count, 0);
  std::vector<std::size_t> count;
  std::size_t total = 1;
  for (std::size_t k = 0; k < dimensions.Count; ++k)
  {
    count.push_back(dimensions.Size(k));
    total *= std::max<std::size_t>(count.back(), 1);
    if (total > kMostValues)
    {
      return {};
    }
  }
  std::vector<double> values(total);
  GDALExtendedDataTypeH type = GDALExtendedDataTypeCreate(GDT_Float64);
  const bool read = GDALMDArrayRead(array, start.data(), count.data(), nullptr, nullptr, type,
                      values.data(), values.data(), values.size() * sizeof(double)) != 0;
  GDALExtendedDataTypeRelease(type);
  int hasScale = 0;
  int hasOffset = 0;
  const double scale = GDALMDArrayGetScale(array, &hasScale);
  const double offset = GDALMDArrayGetOffset(array, &hasOffset);
  if (hasScale || hasOffset)
  {
    std::for_each(values.begin(), values.end(),
      [&](double& value)
      { value = (hasOffset ? offset : 0.0) + (hasScale ? scale : 1.0) * value; });
  }
  return read ? values : std::vector<double>();
}

GridAxis ReadAxis(GDALDimensionH dimension)
{
  GridAxis axis;
  axis.Name = GDALDimensionGetName(dimension);
  if (GDALMDArrayH variable = GDALDimensionGetIndexingVariable(dimension))
  {
    axis.Attributes = ReadAttributes(variable);
    const Dimensions own(variable);
    axis.Values = own.Count == 1 ? ReadValues(variable) : std::vector<double>();
    GDALMDArrayRelease(variable);
  }
  return axis;
}

/// The first group that has an array of this name, as a new handle; null if none has.
GDALMDArrayH FindArray(GDALGroupH group, const std::string& name)
{
  if (GDALMDArrayH array = GDALGroupOpenMDArrayFromFullname(group, name.c_str(), nullptr))
  {
    return array;
  }
  return GDALGroupResolveMDArray(group, name.c_str(), "/", nullptr);
}

std::vector<std::string> Words(const std::string& text)
{
  std::vector<std::string> words;
  char** list = CSLTokenizeString2(text.c_str(), " ", 0);
  for (char** word = list; word && *word; ++word)
  {
    words.emplace_back(*word);
  }
  CSLDestroy(list);
  return words;
}
}

//------------------------------------------------------------------------------
void SplitArrayName(const std::string& name, std::string& file, std::string& variable)
{
  file = name;
  variable.clear();
  const bool prefixed = STARTS_WITH_CI(name.c_str(), "NETCDF:") ||
    STARTS_WITH_CI(name.c_str(), "ZARR:") || STARTS_WITH_CI(name.c_str(), "HDF5:");
  if (!prefixed)
  {
    return;
  }
  const std::string rest = name.substr(name.find(':') + 1);
  const bool quoted = !rest.empty() && rest.front() == '"';
  const std::size_t end = quoted ? rest.find('"', 1) : rest.rfind(':');
  file = rest.substr(quoted ? 1 : 0, end == std::string::npos ? end : end - (quoted ? 1 : 0));
  const std::size_t colon = end == std::string::npos ? end : rest.find(':', end);
  variable = colon == std::string::npos ? std::string() : rest.substr(colon + 1);
  if (variable.rfind("//", 0) == 0)
  {
    variable.erase(0, 1);
  }
}

//------------------------------------------------------------------------------
std::unique_ptr<RasterArray> RasterArray::Open(const std::string& file, const std::string& variable)
{
  std::unique_ptr<RasterArray> opened(new RasterArray);
  opened->File =
    GDALOpenEx(file.c_str(), GDAL_OF_MULTIDIM_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
  opened->Root = opened->File ? GDALDatasetGetRootGroup(opened->File) : nullptr;
  std::string name = variable;
  if (opened->Root && name.empty())
  {
    const std::vector<std::string> all = FindRasterArrays(opened->Root);
    name = all.size() == 1 ? all.front() : name;
  }
  opened->Array = opened->Root && !name.empty() ? FindArray(opened->Root, name) : nullptr;
  if (!opened->Array || Dimensions(opened->Array).Count < 2)
  {
    return nullptr;
  }
  opened->ChooseDimensions();
  return opened;
}

//------------------------------------------------------------------------------
RasterArray::~RasterArray()
{
  if (this->Array)
  {
    GDALMDArrayRelease(this->Array);
  }
  if (this->Root)
  {
    GDALGroupRelease(this->Root);
  }
  if (this->File)
  {
    GDALClose(this->File);
  }
}

//------------------------------------------------------------------------------
void RasterArray::ChooseDimensions()
{
  const Dimensions dimensions(this->Array);
  this->RowDimension = dimensions.Count - 2;
  this->ColumnDimension = dimensions.Count - 1;
  std::size_t x = dimensions.Count;
  std::size_t y = dimensions.Count;
  for (std::size_t k = 0; k < dimensions.Count; ++k)
  {
    const int side = GridSideOf(ReadAxis(dimensions.List[k]));
    x = side == 1 ? k : x;
    y = side == 2 ? k : y;
  }
  if (x < dimensions.Count && y < dimensions.Count)
  {
    this->RowDimension = std::min(x, y);
    this->ColumnDimension = std::max(x, y);
  }
}

//------------------------------------------------------------------------------
void RasterArray::SetHints(const std::string& coordinates, const std::string& gridMapping)
{
  const std::map<std::string, std::string> attributes = this->GetAttributes();
  const auto choose = [&attributes](const char* name, const std::string& hint)
  {
    const auto found = attributes.find(name);
    return hint.empty() && found != attributes.end() ? found->second : hint;
  };
  this->CoordinatesHint = choose("coordinates", coordinates);
  const std::vector<std::string> mapping = Words(choose("grid_mapping", gridMapping));
  this->GridMappingHint = mapping.empty() ? std::string() : mapping.front();
}

//------------------------------------------------------------------------------
GridCoordinates RasterArray::GetCoordinates() const
{
  const Dimensions dimensions(this->Array);
  GridCoordinates grid;
  grid.RowCount = dimensions.Size(this->RowDimension);
  grid.ColumnCount = dimensions.Size(this->ColumnDimension);
  grid.Rows = ReadAxis(dimensions.List[this->RowDimension]);
  grid.Columns = ReadAxis(dimensions.List[this->ColumnDimension]);
  this->FindAxesByName(grid);
  std::vector<std::string> names = Words(this->CoordinatesHint);
  // what models call them, where no attribute names them
  names.insert(names.end(),
    { "XLONG", "XLAT", "XLONG_M", "XLAT_M", "lon", "lat", "longitude", "latitude", "nav_lon",
      "nav_lat", "TLONG", "TLAT", "lon_rho", "lat_rho" });
  for (const std::string& name : names)
  {
    GDALMDArrayH field = FindArray(this->Root, name);
    if (!field)
    {
      continue;
    }
    const Dimensions own(field);
    std::size_t total = 1;
    for (std::size_t k = 0; k < own.Count; ++k)
    {
      total *= own.Size(k);
    }
    const std::size_t layer = grid.RowCount * grid.ColumnCount;
    if (own.Count >= 2 && total >= layer && layer > 0 && total % layer == 0 &&
      own.Size(own.Count - 1) == grid.ColumnCount && own.Size(own.Count - 2) == grid.RowCount)
    {
      GridAxis axis{ name, ReadAttributes(field), ReadValues(field) };
      axis.Values.resize(std::min(axis.Values.size(), layer)); // of the first time
      grid.Fields.push_back(std::move(axis));
    }
    GDALMDArrayRelease(field);
  }
  const std::string& mapping = this->GridMappingHint;
  if (GDALMDArrayH variable = mapping.empty() ? nullptr : FindArray(this->Root, mapping))
  {
    grid.GridMapping = ReadAttributes(variable);
    GDALMDArrayRelease(variable);
  }
  return grid;
}

//------------------------------------------------------------------------------
// Arrays of one dimension beside the array, as long as its rows or columns and called as their
// coordinates are, where the file does not tell which are its axes.
void RasterArray::FindAxesByName(GridCoordinates& grid) const
{
  if (!grid.Rows.Values.empty() || !grid.Columns.Values.empty())
  {
    return;
  }
  const std::string path = GDALMDArrayGetFullName(this->Array);
  const std::string folder = path.substr(0, path.rfind('/'));
  GDALGroupH group = folder.empty()
    ? this->Root
    : GDALGroupOpenGroupFromFullname(this->Root, folder.c_str(), nullptr);
  for (const std::string& name : group ? NamesOfArrays(group) : std::vector<std::string>())
  {
    GDALMDArrayH array = GDALGroupOpenMDArray(group, name.c_str(), nullptr);
    const bool isLine = array && GDALMDArrayGetDimensionCount(array) == 1;
    const auto count =
      isLine ? static_cast<std::size_t>(GDALMDArrayGetTotalElementsCount(array)) : 0;
    GridAxis axis;
    axis.Name = name;
    axis.Attributes = isLine ? ReadAttributes(array) : axis.Attributes;
    const int side = isLine ? GridSideOf(axis) : 0;
    GridAxis* target = side == 1 && count == grid.ColumnCount ? &grid.Columns
      : side == 2 && count == grid.RowCount                   ? &grid.Rows
                                                              : nullptr;
    if (target && target->Values.empty())
    {
      axis.Values = ReadValues(array);
      *target = std::move(axis);
    }
    if (array)
    {
      GDALMDArrayRelease(array);
    }
  }
  if (group && group != this->Root)
  {
    GDALGroupRelease(group);
  }
}

//------------------------------------------------------------------------------
std::string RasterArray::GetUnitOfColumns() const
{
  const Dimensions dimensions(this->Array);
  GDALMDArrayH variable = GDALDimensionGetIndexingVariable(dimensions.List[this->ColumnDimension]);
  const char* unit = variable ? GDALMDArrayGetUnit(variable) : nullptr;
  std::string text = unit ? unit : "";
  if (variable)
  {
    GDALMDArrayRelease(variable);
  }
  return text;
}

//------------------------------------------------------------------------------
std::map<std::string, std::string> RasterArray::GetAttributes() const
{
  return ReadAttributes(this->Array);
}

//------------------------------------------------------------------------------
GDALDatasetH RasterArray::ToDataset(bool isTransposed) const
{
  const GDALMessages messages;
  GDALDatasetH dataset = GDALMDArrayAsClassicDataset(this->Array,
    isTransposed ? this->RowDimension : this->ColumnDimension,
    isTransposed ? this->ColumnDimension : this->RowDimension);
  if (!dataset)
  {
    throw RasterError(
      "its array cannot be read as rows and columns (" + messages.GetFailure() + ")");
  }
  return dataset;
}
}
