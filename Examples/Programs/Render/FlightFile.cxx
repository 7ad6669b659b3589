// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlightFile.h"

#include "Failure.h"
#include "Messages.h"
#include "Placing.h"
#include "VectorFile.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTerrainDrape.h"
#include "vtkTerrainViewpoint.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace
{
/// Array of the times of points, in seconds.
constexpr const char* kTime = "Time";

using Row = std::map<std::string, std::string>;

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return std::tolower(letter); });
  return text;
}

std::vector<std::string> CellsOf(const std::string& line)
{
  const char separator = line.find(';') != std::string::npos ? ';' : ',';
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, separator);)
  {
    const std::size_t first = cell.find_first_not_of(" \t\r\"");
    const std::size_t last = cell.find_last_not_of(" \t\r\"");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

/// One line of the table; what is wrong with it names the line.
class TableLine
{
public:
  TableLine(const std::string& path, int number, const Row& row, const PlacedHeights& heights)
    : Path(path)
    , Number(number)
    , Cells(row)
    , Heights(heights)
  {
  }

  [[noreturn]] void Fail(const std::string& reason) const
  {
    throw Failure(this->Path + ", line " + std::to_string(this->Number), reason);
  }

  double Get(const std::string& name) const
  {
    const auto cell = this->Cells.find(name);
    double value = 0.0;
    if (cell == this->Cells.end() || !CLI::detail::lexical_cast(cell->second, value) ||
      !std::isfinite(value))
    {
      this->Fail("'" + (cell == this->Cells.end() ? "" : cell->second) + "' is no " + name);
    }
    return value;
  }

  /// True if the table has a place of such names.
  bool HasPlace(const std::string& prefix) const
  {
    return this->Cells.count(prefix + "lon") > 0 || this->Cells.count(prefix + "x") > 0;
  }

  Place3 GetPlace(const std::string& prefix) const
  {
    if (this->Cells.count(prefix + "lon") == 0)
    {
      return { this->Get(prefix + "x"), this->Get(prefix + "y"), this->Get(prefix + "z") };
    }
    if (!this->Heights.WhyNoPlaces.empty())
    {
      this->Fail("places need a raster that is somewhere, but " + this->Heights.WhyNoPlaces);
    }
    std::ostringstream text;
    text.precision(12);
    text << this->Get(prefix + "lon") << ',' << this->Get(prefix + "lat");
    const auto height = this->Cells.find(prefix + "height");
    if (height != this->Cells.end() && !height->second.empty())
    {
      text << ',' << height->second;
    }
    const vtkNew<vtkTerrainViewpoint> viewpoint;
    viewpoint->SetGeoreference(this->Heights.Georeference);
    viewpoint->SetHeights(this->Heights.Image);
    viewpoint->SetExaggeration(this->Heights.Exaggeration);
    Place3 place{};
    const std::string why = viewpoint->FindPlace(text.str(), place.data());
    if (!why.empty())
    {
      this->Fail(why);
    }
    return place;
  }

private:
  const std::string& Path;
  int Number;
  const Row& Cells;
  const PlacedHeights& Heights;
};

/// The camera looks at where it will be at the next key, and from the last one straight on.
void LookAhead(std::vector<FlightKey>& keys)
{
  for (std::size_t k = 0; k < keys.size(); ++k)
  {
    const std::size_t from = std::min(k, keys.size() - 2);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      keys[k].View.Focus[axis] =
        keys[k].View.Eye[axis] + keys[from + 1].View.Eye[axis] - keys[from].View.Eye[axis];
    }
  }
}

void CheckTimes(const std::string& path, const std::vector<FlightKey>& keys)
{
  if (keys.size() < 2)
  {
    throw Failure(path,
      "a flight needs two places or more, there " +
        (keys.empty() ? std::string("are none") : std::string("is one")));
  }
  for (std::size_t k = 1; k < keys.size(); ++k)
  {
    if (!(keys[k].Time > keys[k - 1].Time))
    {
      throw Failure(
        path, "seconds must rise from line to line, and do not at place " + std::to_string(k + 1));
    }
  }
}

/// Seconds since 1970 of a time as GDAL writes it; NaN for other texts.
double ToSeconds(const std::string& text)
{
  std::tm time{};
  double seconds = 0.0;
  constexpr int kFields = 6;
  const int read = std::sscanf(text.c_str(), "%d/%d/%d %d:%d:%lf", &time.tm_year, &time.tm_mon,
    &time.tm_mday, &time.tm_hour, &time.tm_min, &seconds);
  time.tm_year -= 1900;
  time.tm_mon -= 1;
  return read == kFields ? static_cast<double>(timegm(&time)) + seconds
                         : std::numeric_limits<double>::quiet_NaN();
}

/// The points of the tracks of a GPX file as one line with the array kTime; null if they have no
/// times that can be followed.
vtkSmartPointer<vtkPolyData> ReadTimedLine(const std::string& path, const PlacedHeights& heights)
{
  const vtkSmartPointer<vtkPolyData> points = ReadTrackPoints(path, heights.Georeference);
  auto* texts = vtkStringArray::SafeDownCast(points->GetPointData()->GetAbstractArray("Field"));
  const vtkIdType count = points->GetNumberOfPoints();
  const vtkNew<vtkDoubleArray> times;
  times->SetName(kTime);
  const vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(count));
  for (vtkIdType k = 0; k < count; ++k)
  {
    const double time = ToSeconds(texts->GetValue(k));
    if (std::isnan(time))
    {
      return nullptr;
    }
    if (k > 0 && time < times->GetValue(k - 1))
    {
      Warn(path + ": its times go back at " + texts->GetValue(k) + ": the flight is at even speed");
      return nullptr;
    }
    times->InsertNextValue(time);
    line->InsertCellPoint(k);
  }
  if (count < 2 || times->GetValue(0) == times->GetValue(count - 1))
  {
    return nullptr;
  }
  auto timed = vtkSmartPointer<vtkPolyData>::New();
  timed->SetPoints(points->GetPoints());
  timed->SetLines(line);
  timed->GetPointData()->AddArray(times);
  return timed;
}
}

//------------------------------------------------------------------------------
bool IsFlightTable(const std::string& path)
{
  return LowerCase(std::filesystem::path(path).extension().string()) == ".csv";
}

//------------------------------------------------------------------------------
std::vector<FlightKey> ReadFlightTable(const std::string& path, const PlacedHeights& heights)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = CellsOf(LowerCase(line));
  const auto has = [&names](const char* name)
  { return std::find(names.begin(), names.end(), name) != names.end(); };
  if (!has("seconds") || (!(has("lon") && has("lat")) && !(has("x") && has("y") && has("z"))))
  {
    throw Failure(path,
      "its first line must name the columns seconds, lon, lat and height, or "
      "seconds, x, y and z");
  }
  std::vector<FlightKey> keys;
  bool looksAhead = false;
  for (int number = 2; std::getline(file, line); ++number)
  {
    const std::vector<std::string> cells = CellsOf(line);
    if (cells.empty() || (cells.size() == 1 && cells.front().empty()))
    {
      continue;
    }
    Row row;
    for (std::size_t k = 0; k < std::min(names.size(), cells.size()); ++k)
    {
      row[names[k]] = cells[k];
    }
    const TableLine at(path, number, row, heights);
    FlightKey key;
    key.Time = at.Get("seconds");
    key.View.Eye = at.GetPlace("");
    looksAhead = !at.HasPlace("look_");
    if (!looksAhead)
    {
      key.View.Focus = at.GetPlace("look_");
    }
    keys.push_back(key);
  }
  CheckTimes(path, keys);
  if (looksAhead)
  {
    LookAhead(keys);
  }
  return keys;
}

//------------------------------------------------------------------------------
FlightTrack ReadFlightTrack(const std::string& path, const PlacedHeights& heights, bool isTimed)
{
  if (!heights.WhyNoPlaces.empty())
  {
    throw Failure(path, "a track needs a raster that is somewhere, but " + heights.WhyNoPlaces);
  }
  const vtkSmartPointer<vtkPolyData> timed = isTimed ? ReadTimedLine(path, heights) : nullptr;
  const vtkNew<vtkTerrainDrape> drape;
  drape->SetInputData(timed ? timed : ReadVectors(path, heights.Georeference));
  drape->SetHeightsData(heights.Image);
  drape->SetGeoreference(heights.Georeference);
  drape->SetMode(vtkTerrainDrape::ModeType::Clamped);
  drape->SetExaggeration(heights.Exaggeration);
  drape->Update();
  ThrowOnError(path);
  vtkPolyData* lines = drape->GetOutput();
  vtkDataArray* times = lines->GetPointData()->GetArray(kTime);
  FlightTrack track;
  const vtkNew<vtkIdList> line;
  for (lines->GetLines()->InitTraversal(); lines->GetLines()->GetNextCell(line) != 0;)
  {
    for (vtkIdType k = 0; k < line->GetNumberOfIds(); ++k)
    {
      Place3 point{};
      lines->GetPoint(line->GetId(k), point.data());
      track.Points.push_back(point);
      if (times)
      {
        track.Times.push_back(times->GetComponent(line->GetId(k), 0));
      }
    }
  }
  const bool isOnePlace = std::all_of(track.Points.begin(), track.Points.end(),
    [&track](const Place3& point)
    { return point[0] == track.Points[0][0] && point[1] == track.Points[0][1]; });
  if (isOnePlace)
  {
    throw Failure(path, "a flight needs a line of two places or more on the terrain");
  }
  return track;
}
