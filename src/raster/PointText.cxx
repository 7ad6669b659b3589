// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/PointText.h"

#include "raster/GDALTable.h"
#include "raster/RasterReference.h"
#include "raster/RasterRepairs.h"
#include "raster/Words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>

namespace terrain
{
namespace
{
// Points that are held in memory: 1.5 GiB.
constexpr std::size_t kMostPoints = std::size_t{ 1 } << 26;
// Cells of a grid for each of its points, and how far points may be off it, in cells.
constexpr double kMostCellsPerPoint = 10.0;
constexpr double kLargestSlip = 0.1;
// Lines that are no points, before which a file is taken for no text of points.
constexpr int kMostOtherLines = 100;

struct Points
{
  std::vector<double> X;
  std::vector<double> Y;
  std::vector<double> Z;
};

/// Even places along an axis.
struct EvenAxis
{
  double First = 0.0;
  double Step = 1.0;
  std::size_t Count = 1;

  double IndexOf(double value) const
  {
    return (value - this->First) / this->Step;
  }
};

/// 1 for a name of x or longitude, 2 for one of y or latitude, 3 for one of heights, 0 for others.
int KindOfColumn(const std::string& name)
{
  std::string word;
  for (const char c : LowerCase(name.substr(0, name.find_first_of("[(")))) // without a unit
  {
    word += std::isalnum(static_cast<unsigned char>(c)) != 0 ? std::string(1, c) : std::string();
  }
  const auto begins = [&word](const char* text) { return word.rfind(text, 0) == 0; };
  if (begins("lon") || begins("east") ||
    IsOneOf(word,
      { "x", "e", "lng", "pointx", "xcoord", "xcoordinate", "coordx", "utmx", "utme", "xutm",
        "rechtswert", "rw", "ostwert", "ost", "est", "este" }))
  {
    return 1;
  }
  if (begins("lat") || begins("north") ||
    IsOneOf(word,
      { "y", "n", "pointy", "ycoord", "ycoordinate", "coordy", "utmy", "utmn", "yutm", "hochwert",
        "hw", "nordwert", "nord", "norte" }))
  {
    return 2;
  }
  return begins("elev") || begins("alt") || begins("height") || begins("depth") ||
      IsOneOf(word, { "z", "h", "masl", "msl", "hoehe", "pointz", "zcoord", "gridcode", "value" })
    ? 3
    : 0;
}

/// What stands between the numbers of a line: ';', a tab, ',' or a space for any number of them.
/// Commas stand within numbers where there is another.
char FindSeparator(std::string_view line)
{
  for (const char c : { ';', '\t' })
  {
    if (line.find(c) != std::string_view::npos)
    {
      return c;
    }
  }
  const std::size_t comma = line.find(',');
  const bool isBehindAll = line.find(", ") != std::string_view::npos;
  return comma != std::string_view::npos &&
      (isBehindAll || line.find(' ') == std::string_view::npos)
    ? ','
    : ' ';
}

std::string_view Trimmed(std::string_view text)
{
  constexpr const char* kBlanks = " \t\r\"";
  const std::size_t first = text.find_first_not_of(kBlanks);
  return first == std::string_view::npos
    ? std::string_view()
    : text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

/// The number of a field; NaN if it is none.
double NumberOf(std::string_view field, char separator)
{
  constexpr std::size_t kLongest = 64;
  std::array<char, kLongest> text{};
  field = Trimmed(field);
  if (field.empty() || field.size() >= kLongest)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::transform(field.begin(), field.end(), text.begin(),
    [separator](char c) { return c == ',' && separator != ',' ? '.' : c; });
  char* end = nullptr;
  const double number = std::strtod(text.data(), &end);
  return *end == '\0' ? number : std::numeric_limits<double>::quiet_NaN();
}

/// x, y and height of a line; NaN for what it does not hold.
std::array<double, 3> ReadPoint(std::string_view line, char separator, const PointColumns& columns)
{
  constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
  std::array<double, 3> point{ { kNoNumber, kNoNumber, kNoNumber } };
  line = Trimmed(line);
  for (std::size_t column = 0; !line.empty(); ++column)
  {
    const std::size_t end = std::min(line.find(separator), line.size());
    for (std::size_t k = 0; k < point.size(); ++k)
    {
      point[k] = columns[k] == column ? NumberOf(line.substr(0, end), separator) : point[k];
    }
    line.remove_prefix(std::min(end + 1, line.size()));
    while (separator == ' ' && !line.empty() && line.front() == ' ')
    {
      line.remove_prefix(1);
    }
  }
  return point;
}

/// Calls `take` with each line of a file, without its end, until it returns false.
template <typename Take>
bool ForEachLine(const std::string& file, Take take)
{
  constexpr std::size_t kPiece = std::size_t{ 1 } << 20;
  VSILFILE* stream = VSIFOpenL(file.c_str(), "rb");
  if (!stream)
  {
    return false;
  }
  std::string text;
  std::string piece(kPiece, '\0');
  bool goesOn = true;
  while (goesOn)
  {
    const std::size_t count = VSIFReadL(piece.data(), 1, piece.size(), stream);
    text.append(piece, 0, count);
    text += count < piece.size() ? "\n" : "";
    std::size_t first = 0;
    for (std::size_t end = text.find('\n'); goesOn && end != std::string::npos;
         first = end + 1, end = text.find('\n', first))
    {
      goesOn = take(std::string_view(text).substr(first, end - first));
    }
    text.erase(0, first);
    if (count < piece.size())
    {
      break;
    }
    goesOn = goesOn && text.size() < kPiece; // no line is as long as that
  }
  VSIFCloseL(stream);
  return goesOn;
}

/// All points of a text; none if it is no text of points. Lines without a height are left out.
Points ReadPoints(const std::string& file, const PointColumns& columns)
{
  Points points;
  int others = 0;
  char separator = '\0';
  const bool isDone = ForEachLine(file,
    [&](std::string_view line)
    {
      line.remove_prefix(line.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
      const char own = separator == '\0' ? FindSeparator(Trimmed(line)) : separator;
      const std::array<double, 3> point = ReadPoint(line, own, columns);
      if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
      {
        return ++others < kMostOtherLines && line.find('\0') == std::string_view::npos;
      }
      separator = own;
      if (std::isfinite(point[2]))
      {
        points.X.push_back(point[0]);
        points.Y.push_back(point[1]);
        points.Z.push_back(point[2]);
      }
      return points.X.size() < kMostPoints;
    });
  return isDone ? points : Points();
}

/// The even places on which all values lie; nothing if there are none.
std::optional<EvenAxis> FindEvenAxis(std::vector<double> values)
{
  const std::vector<double> all = values;
  std::sort(values.begin(), values.end());
  const double range = values.back() - values.front();
  const double slip = 1e-9 * std::max(std::abs(values.front()), std::abs(values.back()));
  std::vector<double> steps;
  for (std::size_t k = 1; k < values.size(); ++k)
  {
    const double step = values[k] - values[k - 1];
    if (step > std::max(slip, 1e-7 * range))
    {
      steps.push_back(step);
    }
  }
  if (steps.empty())
  {
    return std::nullopt;
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  for (const double count : { static_cast<double>(steps.size()), std::round(range / *middle),
         std::round(range / *std::min_element(steps.begin(), steps.end())) })
  {
    const EvenAxis axis{ values.front(), range / count, static_cast<std::size_t>(count) + 1 };
    if (std::all_of(all.begin(), all.end(),
          [&axis](double value)
          {
            const double index = axis.IndexOf(value);
            const double place = std::round(index);
            // a step of few bits may lead beyond the last place
            return std::abs(index - place) <= kLargestSlip && place >= 0.0 &&
              place < static_cast<double>(axis.Count);
          }))
    {
      return axis;
    }
  }
  return std::nullopt;
}

/// Heights row by row from the north; counts the points that lie where others do.
std::vector<double> LayOut(
  const Points& points, const EvenAxis& x, const EvenAxis& y, std::size_t& doubles)
{
  std::vector<double> heights(x.Count * y.Count, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < points.Z.size(); ++k)
  {
    const auto column = static_cast<std::size_t>(std::round(x.IndexOf(points.X[k])));
    const auto row = static_cast<std::size_t>(std::round(y.IndexOf(points.Y[k])));
    double& height = heights[(y.Count - 1 - row) * x.Count + column];
    doubles += std::isnan(height) ? 0 : 1;
    height = points.Z[k];
  }
  return heights;
}

GDALDatasetH MakeRaster(
  std::vector<double> heights, const EvenAxis& x, const EvenAxis& y, bool isDegrees)
{
  const auto width = static_cast<int>(x.Count);
  const auto height = static_cast<int>(y.Count);
  GDALDatasetH dataset = MakeMemoryRaster(width, height, GDT_Float64, nullptr);
  if (GDALRasterIO(GDALGetRasterBand(dataset, 1), GF_Write, 0, 0, width, height, heights.data(),
        width, height, GDT_Float64, 0, 0) != CE_None)
  {
    GDALClose(dataset);
    return nullptr;
  }
  if (OGRSpatialReferenceH places = isDegrees ? MakeReference("EPSG:4326") : nullptr)
  {
    GDALSetSpatialRef(dataset, places);
    OSRRelease(places);
  }
  const double north = y.First + (static_cast<double>(y.Count) - 0.5) * y.Step;
  std::array<double, 6> transform{ x.First - 0.5 * x.Step, x.Step, 0.0, north, 0.0, -y.Step };
  GDALSetGeoTransform(dataset, transform.data());
  return dataset;
}
}

//------------------------------------------------------------------------------
std::optional<PointColumns> FindPointColumns(const std::vector<std::string>& names)
{
  constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);
  PointColumns columns{ { kNoColumn, kNoColumn, kNoColumn } };
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    const int kind = KindOfColumn(names[k]);
    std::size_t* const column = kind > 0 ? &columns[static_cast<std::size_t>(kind - 1)] : nullptr;
    if (column && *column == kNoColumn)
    {
      *column = k;
    }
  }
  if (columns[0] == kNoColumn || columns[1] == kNoColumn)
  {
    return std::nullopt;
  }
  columns[2] = columns[2] == kNoColumn ? std::max(columns[0], columns[1]) + 1 : columns[2];
  return columns[2] < names.size() ? std::optional<PointColumns>(columns) : std::nullopt;
}

//------------------------------------------------------------------------------
bool IsCalledPoints(const std::string& file)
{
  return IsOneOf(LowerCase(CPLGetExtension(file.c_str())),
    { "xyz", "txt", "csv", "dat", "tsv", "asc", "pts", "xyzi" });
}

//------------------------------------------------------------------------------
bool AreDegrees(const std::vector<std::string>& names, const PointColumns& columns)
{
  return LowerCase(names[columns[0]]).rfind("lon", 0) == 0 &&
    LowerCase(names[columns[1]]).rfind("lat", 0) == 0;
}

//------------------------------------------------------------------------------
GDALDatasetH OpenPointText(const std::string& file, RasterRecord& record)
{
  const std::vector<std::string> names = ReadColumnNames(file);
  const std::optional<PointColumns> named = FindPointColumns(names);
  const Points points = ReadPoints(file, named.value_or(PointColumns{ { 0, 1, 2 } }));
  if (points.X.size() < 4)
  {
    return nullptr;
  }
  const std::optional<EvenAxis> x = FindEvenAxis(points.X);
  const std::optional<EvenAxis> y = FindEvenAxis(points.Y);
  if (!x || !y ||
    static_cast<double>(x->Count) * static_cast<double>(y->Count) >
      kMostCellsPerPoint * static_cast<double>(points.X.size()))
  {
    return nullptr;
  }
  std::size_t doubles = 0;
  const bool isDegrees = named && AreDegrees(names, *named);
  GDALDatasetH dataset = MakeRaster(LayOut(points, *x, *y, doubles), *x, *y, isDegrees);
  record.Take("format", "text of points, each put into its cell", "its lines");
  if (named)
  {
    record.Take("columns",
      names[(*named)[0]] + ", " + names[(*named)[1]] + ", " + names[(*named)[2]] + " as x, y, z",
      "first line");
  }
  if (doubles > 0)
  {
    record.Warn(std::to_string(doubles) + " of its " + std::to_string(points.X.size()) +
      " points lie where others do, of which the last counts (awk -F'[ ,;\\t]+' '!seen[$1,$2]++' "
      "IN > OUT keeps the "
      "first)");
  }
  return dataset;
}
}
