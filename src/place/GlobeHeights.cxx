// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "place/GlobeHeights.h"

#include "core/grid/Constants.h"
#include "data/FieldData.h"
#include "data/GlobeData.h"
#include "data/HiddenSamples.h"
#include "data/ImageHeights.h"
#include "raster/CoordinateSystem.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace terrain
{
namespace
{
/// Degrees by which coordinates of files are rounded.
constexpr double kRounding = 1e-6;
/// Parts of a cell by which rounded steps add up over a planet.
constexpr double kDrift = 0.05;
/// Widest cells that are not divided, degrees.
constexpr double kWidest = 1.0;

/// Where the samples lie, degrees.
struct Degrees
{
  glm::dvec2 First{ 0.0 };
  glm::dvec2 Step{ 0.0 };
  glm::ivec2 Count{ 0 };
};

Degrees DegreesOf(vtkImageData* heights, double unit)
{
  const FieldData::Layout layout = FieldData::GetLayout(heights);
  const GridGeometry geometry = ImageHeights::Geometry(heights);
  Degrees degrees;
  for (int axis = 0; axis < 2; ++axis)
  {
    degrees.First[axis] = unit * (layout.Origin[axis] + geometry.Origin[axis] / layout.Scale[axis]);
    degrees.Step[axis] = unit * geometry.Spacing[axis] / layout.Scale[axis];
    degrees.Count[axis] = heights->GetDimensions()[axis];
  }
  return degrees;
}

/// Lines between lines, so that none are wider apart than kWidest.
std::vector<GlobePlan::Line> Divide(const std::vector<GlobePlan::Line>& lines, int parts)
{
  std::vector<GlobePlan::Line> divided;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    for (int part = 0; part < (i + 1 < lines.size() ? parts : 1); ++part)
    {
      divided.push_back({ static_cast<int>(i), part / static_cast<double>(parts) });
    }
  }
  return divided;
}

/// True if columns from a number on are those from the first on, with the same samples.
bool RepeatsColumns(vtkImageData* heights, int around)
{
  bool repeats = true;
  ImageHeights::Dispatch(heights,
    [&repeats, around](const auto& view)
    {
      for (std::int64_t j = 0; j < view.Height && repeats; ++j)
      {
        for (std::int64_t i = around; i < view.Width && repeats; ++i)
        {
          const double first = view.At(i - around, j);
          const double again = view.At(i, j);
          repeats = first == again || (std::isnan(first) && std::isnan(again));
        }
      }
    });
  return repeats;
}

/// Columns that are used: those of one round, where more of them repeat the first.
int CountColumns(vtkImageData* heights, const Degrees& degrees, GlobePlan& plan)
{
  const int count = degrees.Count.x;
  const double step = degrees.Step.x;
  if (!(count * step > 360.0 + 1.5 * step))
  {
    return count;
  }
  const auto around = static_cast<int>(std::lround(360.0 / step));
  if (around < 3 || !(std::abs(around * step - 360.0) < kDrift * step) ||
    !RepeatsColumns(heights, around))
  {
    return count;
  }
  plan.IsPlain = false;
  return around;
}

std::string PlanColumns(vtkImageData* heights, const Degrees& degrees, GlobePlan& plan)
{
  GlobeGrid& grid = plan.Grid;
  const int count = CountColumns(heights, degrees, plan);
  const double slack = 0.5 * degrees.Step.x;
  grid.West = degrees.First.x * kDegree;
  grid.Step = degrees.Step.x * kDegree;
  for (int i = 0; i < count; ++i)
  {
    plan.Columns.push_back({ i, 0.0 });
  }
  if (count > 2 && std::abs(count * degrees.Step.x - 360.0) < slack)
  {
    plan.Columns.push_back({ 0, 0.0 });
    grid.Step = kTurn / count;
    plan.IsPlain = false;
  }
  else if (count > 2 && std::abs((count - 1) * degrees.Step.x - 360.0) < slack)
  {
    grid.Step = kTurn / (count - 1);
  }
  grid.Columns = static_cast<int>(plan.Columns.size());
  return count < 2 || degrees.Step.x > 120.0
    ? "a globe needs at least two meridians of heights within 120 degrees of each other: give a "
      "raster with more columns"
    : std::string();
}

/// Rows that are used, the first and the last: those beyond a pole are left out where they are
/// empty.
glm::ivec2 RowsOnPlanet(
  vtkImageData* heights, const std::vector<double>& latitudes, GlobePlan& plan)
{
  glm::ivec2 used(0, static_cast<int>(latitudes.size()) - 1);
  const auto isOff = [&latitudes](int j)
  { return std::abs(latitudes[static_cast<std::size_t>(j)]) > 90.0; };
  if (!isOff(used[0]) && !isOff(used[1]))
  {
    return used;
  }
  ImageHeights::Dispatch(heights,
    [&](const auto& view)
    {
      const auto isEmpty = [&view](int j)
      {
        bool empty = true;
        for (std::int64_t i = 0; i < view.Width && empty; ++i)
        {
          empty = std::isnan(static_cast<double>(view.At(i, j)));
        }
        return empty;
      };
      for (; used[0] <= used[1] && isOff(used[0]) && isEmpty(used[0]); ++used[0])
      {
      }
      for (; used[0] < used[1] && isOff(used[1]) && isEmpty(used[1]); --used[1])
      {
      }
    });
  plan.IsPlain = plan.IsPlain && used[0] == 0 && used[1] + 1 == static_cast<int>(latitudes.size());
  return used;
}

void PlanRows(vtkImageData* heights, const Degrees& degrees, GlobePlan& plan)
{
  const bool joined = plan.Grid.IsJoined();
  std::vector<double> all;
  for (int j = 0; j < degrees.Count.y; ++j)
  {
    const double latitude = degrees.First.y + j * degrees.Step.y;
    const double beyond = std::abs(latitude) - 90.0;
    const bool isPole =
      std::abs(beyond) < kRounding || (beyond > 0.0 && beyond < kDrift * degrees.Step.y);
    all.push_back(isPole ? std::copysign(90.0, latitude) : latitude);
  }
  plan.Used = RowsOnPlanet(heights, all, plan);
  std::vector<double>& latitudes = plan.Grid.Latitudes;
  const double most = 90.0 - 1.01 * degrees.Step.y;
  const auto isNear = [joined, most](double latitude)
  { return joined && latitude < 90.0 && latitude > most; };
  for (int j = plan.Used[0]; j <= plan.Used[1]; ++j)
  {
    latitudes.push_back(all[static_cast<std::size_t>(j)]);
    plan.Rows.push_back({ j, 0.0 });
  }
  if (!latitudes.empty() && isNear(-latitudes.front()))
  {
    latitudes.insert(latitudes.begin(), -90.0);
    plan.Rows.insert(plan.Rows.begin(), { plan.Used[0] - 1, 0.0 });
    plan.IsPlain = false;
  }
  if (!latitudes.empty() && isNear(latitudes.back()))
  {
    latitudes.push_back(90.0);
    plan.Rows.push_back({ plan.Used[1] + 1, 0.0 });
    plan.IsPlain = false;
  }
  for (double& latitude : latitudes)
  {
    latitude *= kDegree;
  }
}

/// Divides wide cells; lines of the plan are then those of the undivided one.
void DivideCells(const Degrees& degrees, GlobePlan& plan)
{
  const int across = static_cast<int>(std::ceil(degrees.Step.x / kWidest - kRounding));
  const int along = static_cast<int>(std::ceil(degrees.Step.y / kWidest - kRounding));
  if (across <= 1 && along <= 1)
  {
    return;
  }
  plan.IsPlain = false;
  plan.IsDivided = true;
  const std::vector<GlobePlan::Line> columns = Divide(plan.Columns, across);
  const std::vector<GlobePlan::Line> rows = Divide(plan.Rows, along);
  std::vector<double> latitudes;
  for (const GlobePlan::Line& row : rows)
  {
    const auto first = static_cast<std::size_t>(row.First);
    const double south = plan.Grid.Latitudes[first];
    const double north = row.At > 0.0 ? plan.Grid.Latitudes[first + 1] : south;
    latitudes.push_back(south + row.At * (north - south));
  }
  plan.Grid.Latitudes = latitudes;
  plan.Grid.Step /= across;
  plan.Grid.Columns = static_cast<int>(columns.size());
  // lines refer to those of the plan, which refer to samples: one step of each
  const auto resolve =
    [](const std::vector<GlobePlan::Line>& lines, const std::vector<GlobePlan::Line>& whole)
  {
    std::vector<GlobePlan::Line> resolved;
    resolved.reserve(lines.size());
    for (const GlobePlan::Line& line : lines)
    {
      resolved.push_back({ whole[static_cast<std::size_t>(line.First)].First, line.At });
    }
    return resolved;
  };
  plan.Columns = resolve(columns, plan.Columns);
  plan.Rows = resolve(rows, plan.Rows);
}

/// The samples of one row of the heights, as doubles with NaN for none; before the first row that
/// is used and behind the last one the mean of that.
template <typename T>
std::vector<double> RowOf(const HeightfieldView<T>& view, int row, const glm::ivec2& used)
{
  const int at = std::clamp(row, used[0], used[1]);
  std::vector<double> samples(static_cast<std::size_t>(view.Width));
  double sum = 0.0;
  int count = 0;
  for (std::int64_t i = 0; i < view.Width; ++i)
  {
    const double height = view.At(i, at);
    samples[static_cast<std::size_t>(i)] = height;
    sum += std::isnan(height) ? 0.0 : height;
    count += std::isnan(height) ? 0 : 1;
  }
  if (at != row)
  {
    const double mean = count > 0 ? sum / count : kNaN;
    std::fill(samples.begin(), samples.end(), std::is_integral_v<T> ? std::round(mean) : mean);
  }
  return samples;
}

/// Bilinear between two rows, which may be the same.
double SampleAt(const std::vector<double>& south, const std::vector<double>& north, double along,
  const GlobePlan::Line& column)
{
  const auto first = static_cast<std::size_t>(column.First);
  const std::size_t next = column.At > 0.0 ? (first + 1) % south.size() : first;
  const double below = south[first] * (1.0 - column.At) + south[next] * column.At;
  const double above = north[first] * (1.0 - column.At) + north[next] * column.At;
  return below * (1.0 - along) + above * along;
}

/// The lowest of the samples of a grid within half a width of a longitude, and between two rows;
/// NaN if some have no height, or the grid does not reach so far.
template <typename T>
double LowestWithin(const HeightfieldView<T>& view, const GlobeGrid& grid, double longitude,
  double half, const glm::dvec2& rows)
{
  double east = longitude - half - grid.West;
  east -= kTurn * std::floor(east / kTurn);
  const auto first = static_cast<std::int64_t>(std::floor(east / grid.Step));
  const auto last = static_cast<std::int64_t>(std::ceil((east + 2.0 * half) / grid.Step));
  const auto south = static_cast<std::int64_t>(std::floor(rows[0]));
  const auto north = static_cast<std::int64_t>(std::ceil(rows[1]));
  if (south < 0 || north >= view.Height || last >= view.Width)
  {
    return kNaN;
  }
  double lowest = kInfinity;
  for (std::int64_t j = south; j <= north; ++j)
  {
    for (std::int64_t i = first; i <= last; ++i)
    {
      const double height = view.At(i, j);
      lowest = std::isnan(height) ? kNaN : std::min(height, lowest);
      if (std::isnan(lowest))
      {
        return lowest;
      }
    }
  }
  return lowest;
}
}

GlobePlan PlanGlobe(vtkImageData* heights, const double radii[2])
{
  GlobePlan plan;
  plan.WhyNot = ImageHeights::WhyNotHeights(heights);
  CoordinateSystem system;
  if (plan.WhyNot.empty())
  {
    plan.WhyNot = system.Read(FieldData::GetText(heights, "CRS"));
  }
  if (plan.WhyNot.empty() && system.GetKind() != CoordinateSystem::Kind::None)
  {
    plan.WhyNot = system.WhyNotLongitudeLatitude();
  }
  if (!plan.WhyNot.empty())
  {
    return plan;
  }
  plan.Grid.Body = radii[0] > 0.0 ? Ellipsoid{ radii[0], radii[1] }
                                  : Ellipsoid{ system.GetSemiMajor(), system.GetSemiMinor() };
  const Degrees degrees = DegreesOf(heights, system.GetDegrees());
  plan.WhyNot = PlanColumns(heights, degrees, plan);
  PlanRows(heights, degrees, plan);
  if (plan.WhyNot.empty())
  {
    plan.WhyNot = plan.Grid.WhyNot();
  }
  if (plan.WhyNot.empty())
  {
    DivideCells(degrees, plan);
  }
  return plan;
}

glm::dvec2 GlobeReach(vtkImageData* heights, bool& isEarth)
{
  CoordinateSystem system;
  isEarth = true;
  const std::string text = FieldData::GetText(heights, "CRS");
  if (text.empty() || !system.Read(text).empty() || !system.IsInDegrees())
  {
    return glm::dvec2(0.0);
  }
  isEarth = system.IsOnEarth();
  const Degrees degrees = DegreesOf(heights, system.GetDegrees());
  return degrees.Step * glm::dvec2(degrees.Count);
}

void FillGlobe(
  vtkImageData* heights, const GlobePlan& plan, double offset, bool asFloats, vtkImageData* output)
{
  const bool isFloat = asFloats || plan.IsDivided || offset != 0.0;
  output->SetDimensions(plan.Grid.Columns, static_cast<int>(plan.Grid.Latitudes.size()), 1);
  output->AllocateScalars(
    isFloat ? VTK_FLOAT : heights->GetPointData()->GetScalars()->GetDataType(), 1);
  vtkDataArray* scalars = output->GetPointData()->GetScalars();
  const char* name = heights->GetPointData()->GetScalars()->GetName();
  scalars->SetName(name ? name : "Heights");
  output->AllocatePointGhostArray();
  vtkUnsignedCharArray* ghosts = output->GetPointGhostArray();
  ImageHeights::Dispatch(heights,
    [&](const auto& view)
    {
      vtkSMPTools::For(0, static_cast<vtkIdType>(plan.Rows.size()),
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType j = begin; j < end; ++j)
          {
            const GlobePlan::Line& row = plan.Rows[static_cast<std::size_t>(j)];
            const std::vector<double> south = RowOf(view, row.First, plan.Used);
            const std::vector<double> north =
              row.At > 0.0 ? RowOf(view, row.First + 1, plan.Used) : south;
            for (int i = 0; i < plan.Grid.Columns; ++i)
            {
              const double height =
                SampleAt(south, north, row.At, plan.Columns[static_cast<std::size_t>(i)]);
              const vtkIdType at = j * plan.Grid.Columns + i;
              const bool none = std::isnan(height);
              scalars->SetComponent(at, 0, none ? 0.0 : height - offset);
              ghosts->SetValue(at, none ? vtkDataSetAttributes::HIDDENPOINT : 0);
            }
          }
        });
    });
  FillHidden(output);
}

std::string GiveWay(vtkImageData* globe, vtkImageData* finer)
{
  const std::unique_ptr<GlobeGrid> own = GlobeData::Get(globe);
  const std::unique_ptr<GlobeGrid> grid = GlobeData::Get(finer);
  if (!grid)
  {
    return "what it gives way to lies on no globe: take the output of another vtkTerrainGlobe";
  }
  if (grid->Body.Equatorial != own->Body.Equatorial || grid->Body.Polar != own->Body.Polar)
  {
    return "what it gives way to lies on another body: bring both to one coordinate system";
  }
  const double margin = 0.01 * own->Step * own->Body.Equatorial;
  auto* heights = vtkFloatArray::SafeDownCast(globe->GetPointData()->GetScalars());
  const int rows = static_cast<int>(own->Latitudes.size());
  ImageHeights::Dispatch(finer,
    [&](const auto& view)
    {
      vtkSMPTools::For(1, rows - 1,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType j = begin; j < end; ++j)
          {
            const auto row = static_cast<std::size_t>(j);
            const glm::dvec2 along(
              grid->RowOf(own->Latitudes[row - 1]), grid->RowOf(own->Latitudes[row + 1]));
            for (int i = 0; i < own->Columns; ++i)
            {
              const double lowest =
                LowestWithin(view, *grid, own->West + i * own->Step, own->Step, along);
              const vtkIdType at = j * own->Columns + i;
              if (!std::isnan(lowest))
              {
                heights->SetValue(
                  at, std::min(heights->GetValue(at), static_cast<float>(lowest - margin)));
              }
            }
          }
          if (own->IsJoined())
          {
            for (vtkIdType j = begin; j < end; ++j)
            {
              heights->SetValue((j + 1) * own->Columns - 1, heights->GetValue(j * own->Columns));
            }
          }
        });
    });
  return {};
}
}
