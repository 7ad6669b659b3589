// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/ReaderPlan.h"
#include "raster/GDALTable.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace terrain
{
namespace
{
/// The window that four numbers mean, or an error.
RasterWindow ResolveWindow(const RasterFile& file, const int window[4])
{
  RasterWindow resolved{ window[0], window[1], window[2], window[3] };
  resolved.Width = window[2] == 0 ? file.GetWidth() - resolved.X : resolved.Width;
  resolved.Height = window[3] == 0 ? file.GetHeight() - resolved.Y : resolved.Height;
  if (resolved.X < 0 || resolved.Y < 0 || resolved.Width < 1 || resolved.Height < 1 ||
    resolved.X + resolved.Width > file.GetWidth() ||
    resolved.Y + resolved.Height > file.GetHeight())
  {
    std::ostringstream text;
    text << "the window of " << resolved.Width << " x " << resolved.Height << " pixels at ("
         << resolved.X << ", " << resolved.Y << ") is not within its " << file.GetWidth() << " x "
         << file.GetHeight() << " pixels";
    throw RasterError(text.str());
  }
  return resolved;
}

/// Samples of the window under the two limits; as many as there are pixels if none applies.
void ReduceSize(RasterRequest& request, int maximumSize, vtkIdType maximumNumber)
{
  const auto width = static_cast<double>(request.Window.Width);
  const auto height = static_cast<double>(request.Window.Height);
  double reduction = 1.0;
  if (maximumSize > 0)
  {
    reduction = std::max(reduction, std::max(width, height) / maximumSize);
  }
  if (maximumNumber > 0)
  {
    reduction = std::max(reduction, std::sqrt(width * height / static_cast<double>(maximumNumber)));
    // A single row or column: the other side alone can shrink.
    const double shorter = std::min(width, height);
    if (reduction > shorter)
    {
      reduction = std::max(width, height) / static_cast<double>(maximumNumber);
    }
  }
  const auto shrink = [reduction](double size)
  { return std::max<std::int64_t>(static_cast<std::int64_t>(size / reduction + 1e-9), 1); };
  request.Width = shrink(width);
  request.Height = shrink(height);
}

int ScalarTypeOf(const RasterFile& file)
{
  if (file.IsSignedByte())
  {
    return VTK_SIGNED_CHAR;
  }
  switch (file.GetType())
  {
    case GDT_Byte:
      return VTK_UNSIGNED_CHAR;
    case GDT_UInt16:
      return VTK_UNSIGNED_SHORT;
    case GDT_Int16:
      return VTK_SHORT;
    case GDT_UInt32:
      return VTK_UNSIGNED_INT;
    case GDT_Int32:
      return VTK_INT;
    case GDT_Float32:
      return VTK_FLOAT;
    default:
      return VTK_DOUBLE;
  }
}

/// Scale and offset from file values to metres, and the scalars' type under them.
void ResolveHeights(vtkTerrainRasterPlan& plan)
{
  RasterRequest& request = plan.Request;
  plan.File->GetScaleAndOffset(request.Scale, request.Offset);
  plan.VerticalUnit = plan.File->GetHeights().Unit;
  plan.VerticalScale = plan.File->GetHeights().Factor;
  plan.ScalarType = ScalarTypeOf(*plan.File);
  const bool scaled = request.Scale != 1.0 || request.Offset != 0.0;
  if (scaled && plan.File->IsInteger())
  {
    const bool wide = plan.ScalarType == VTK_INT || plan.ScalarType == VTK_UNSIGNED_INT;
    plan.ScalarType = wide ? VTK_DOUBLE : VTK_FLOAT;
  }
  plan.Name = plan.File->GetBandDescription();
  plan.Name = plan.Name.empty() ? kDefaultName : plan.Name;
}

std::string SizeText(const RasterFile& file)
{
  return std::to_string(file.GetWidth()) + " x " + std::to_string(file.GetHeight()) + " samples, " +
    (file.IsSignedByte() ? "Int8" : GDALGetDataTypeName(file.GetType()));
}
}

//------------------------------------------------------------------------------
void CompletePlan(
  vtkTerrainRasterPlan& plan, const int window[4], int maximumSize, vtkIdType maximumNumber)
{
  plan.Layout = plan.File->GetLayout();
  plan.Request.Window = ResolveWindow(*plan.File, window);
  plan.Request.NorthFirst = plan.Layout.NorthFirst;
  plan.Request.EastFirst = plan.Layout.EastFirst;
  ReduceSize(plan.Request, maximumSize, maximumNumber);
  ResolveHeights(plan);
}

//------------------------------------------------------------------------------
void PlaceSamples(vtkTerrainRasterPlan& plan)
{
  const RasterRequest& request = plan.Request;
  const RasterWindow& window = request.Window;
  std::array<double, 6> transform = plan.Layout.GeoTransform;
  if (!plan.Layout.HasGeoTransform)
  {
    const bool north = plan.Layout.NorthFirst;
    transform = { -0.5, 1.0, 0.0, north ? static_cast<double>(plan.File->GetHeight()) - 0.5 : -0.5,
      0.0, north ? -1.0 : 1.0 };
  }
  const std::int64_t west = request.EastFirst ? window.X + window.Width : window.X;
  const std::int64_t south = request.NorthFirst ? window.Y + window.Height : window.Y;
  const double corner[2] = { transform[0] + transform[1] * static_cast<double>(west),
    transform[3] + transform[5] * static_cast<double>(south) };
  const double cell[2] = { std::fabs(transform[1]), std::fabs(transform[5]) };
  const double reduction[2] = { static_cast<double>(window.Width) /
      static_cast<double>(request.Width),
    static_cast<double>(window.Height) / static_cast<double>(request.Height) };
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    plan.Spacing[axis] = cell[axis] * plan.Layout.Scale[a] * reduction[axis];
    plan.Origin[axis] =
      (corner[axis] - plan.Layout.Origin[a]) * plan.Layout.Scale[a] + 0.5 * plan.Spacing[axis];
  }
}

//------------------------------------------------------------------------------
std::string DescribePlan(const vtkTerrainRasterPlan& plan)
{
  RasterFile& file = *plan.File;
  const RasterRequest& request = plan.Request;
  std::string text = "size: " + SizeText(file) + "\n";
  text += "cell: " + NumberText(plan.Spacing[0]) + " x " + NumberText(plan.Spacing[1]) + " m\n";
  text += "bounds: x " + NumberText(plan.Origin[0]) + " to " +
    NumberText(plan.Origin[0] + plan.Spacing[0] * static_cast<double>(request.Width - 1)) + ", y " +
    NumberText(plan.Origin[1]) + " to " +
    NumberText(plan.Origin[1] + plan.Spacing[1] * static_cast<double>(request.Height - 1)) + " m\n";
  const RasterHoles& holes = file.GetHoles();
  if (holes.Low <= holes.High)
  {
    const double ends[2] = { request.Offset + request.Scale * holes.Low,
      request.Offset + request.Scale * holes.High };
    text += "heights: " + NumberText(std::min(ends[0], ends[1])) + " to " +
      NumberText(std::max(ends[0], ends[1])) + " m (of the samples that were looked at)\n";
  }
  for (const std::string& line : file.GetRecord().GetLines())
  {
    text += line + "\n";
  }
  if (holes.UndeclaredOccurs && !holes.Undeclared.empty())
  {
    text +=
      "warning: samples are taken for no data, which the file does not declare (--nodata none "
      "if they are heights)\n";
  }
  for (const std::string& warning : file.GetRecord().GetWarnings())
  {
    text += "warning: " + warning + "\n";
  }
  const std::string& sites = file.GetRecord().GetSites().Warning;
  text += sites.empty() ? "" : "warning: " + sites + "\n";
  return text;
}
}
