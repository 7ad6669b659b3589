// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "place/PlacedRaster.h"

#include "core/files/OutputFile.h"
#include "core/grid/HeightSampling.h"
#include "data/GlobePaths.h"
#include "data/ImageHeights.h"
#include "raster/RasterMessages.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace terrain
{
namespace
{
using Frame = vtkTerrainGeoreference::FrameType;

/// A pixel coordinate on the outer border of a raster, or beyond it by rounding, inside: the warper
/// takes no border in the east and south.
double InsideBorder(double pixel, double size)
{
  constexpr double kBorder = 1e-6; // pixels
  return pixel > -kBorder && pixel < size + kBorder ? std::clamp(pixel, 0.0, size - kBorder)
                                                    : pixel;
}

/// The part of a raster that an output needs is not found by its border where that runs round a
/// globe: points of a grid find it, and what may lie between two of them is added.
void SearchInside(GDALWarpOptions* options)
{
  constexpr int kSteps = 101;
  constexpr int kFewest = 16;
  const int longest =
    std::max(GDALGetRasterXSize(options->hSrcDS), GDALGetRasterYSize(options->hSrcDS));
  for (const auto& [name, value] : { std::pair("SAMPLE_GRID", std::string("YES")),
         std::pair("SAMPLE_STEPS", std::to_string(kSteps)),
         std::pair("SOURCE_EXTRA", std::to_string(kFewest + 2 * longest / kSteps)) })
  {
    options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, name, value.c_str());
  }
}
}

Dataset Own(GDALDatasetH dataset)
{
  return { dataset,
    [](void* open)
    {
      if (open)
      {
        GDALClose(open);
      }
    } };
}

std::string PlacedRaster::Open(const std::string& name, const std::string& system)
{
  if (!WhyNoGDAL().empty())
  {
    return WhyNoGDAL();
  }
  const std::string whyNot = WhyNotInput(name);
  if (!whyNot.empty())
  {
    return "'" + name + "': " + whyNot;
  }
  GDALAllRegister();
  const GDALMessages messages;
  this->File =
    Own(GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  if (!this->File || GDALGetRasterCount(this->File.get()) < 1)
  {
    const std::string& reason = messages.GetFailure();
    return "'" + name + "' is no picture that can be read" +
      (reason.empty() ? "" : " (" + reason + ")");
  }
  if (this->Globe && this->Scene->GetFrame() != Frame::Globe &&
    this->Scene->GetFrame() != Frame::Geocentric)
  {
    return "the heights lie on a globe, and the frame of their georeference is another one: Globe";
  }
  const char* own = GDALGetProjectionRef(this->File.get());
  const std::string definition = own && *own ? own : system;
  this->IsOfHeights = this->Scene && !this->Globe && !this->Scene->IsOnEarth() &&
    definition == this->Scene->GetCoordinateSystem();
  if (definition.empty() && !this->IsOfHeights)
  {
    return "'" + name + "' has no coordinate system";
  }
  if (GDALGetGeoTransform(this->File.get(), this->ToFile.data()) != CE_None ||
    !GDALInvGeoTransform(this->ToFile.data(), this->FromFile.data()))
  {
    return "'" + name + "' has no georeference";
  }
  if (!this->IsOfHeights)
  {
    this->SetPicture(definition);
  }
  const std::string why = this->IsOfHeights ? std::string() : this->Picture->GetWhyNot();
  return why.empty() ? why : "'" + name + "': " + why;
}

/// Tells the picture's georeference its CRS and where in that its corners are.
void PlacedRaster::SetPicture(const std::string& definition)
{
  const double width = GDALGetRasterXSize(this->File.get());
  const double height = GDALGetRasterYSize(this->File.get());
  double extent[4] = { HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL };
  for (int i = 0; i < 4; ++i)
  {
    double x = 0.0;
    double y = 0.0;
    GDALApplyGeoTransform(
      this->ToFile.data(), i % 2 == 0 ? 0.0 : width, i < 2 ? 0.0 : height, &x, &y);
    extent[0] = std::min(extent[0], x);
    extent[1] = std::max(extent[1], x);
    extent[2] = std::min(extent[2], y);
    extent[3] = std::max(extent[3], y);
  }
  this->Picture->SetCoordinateSystem(definition);
  this->Picture->SetExtent(extent[0], extent[1], extent[2], extent[3]);
  this->Picture->SetFrame(
    this->Scene && this->Scene->IsOnOtherWorld() ? Frame::Globe : Frame::Geocentric);
}

bool PlacedRaster::PixelsToScene(std::vector<double>& points)
{
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    GDALApplyGeoTransform(
      this->ToFile.data(), points[i], points[i + 1], &points[i], &points[i + 1]);
  }
  const auto count = static_cast<vtkIdType>(points.size() / 3);
  if (this->IsOfHeights)
  {
    return this->Scene->FileToScene(points.data(), points.data(), count);
  }
  if (!this->Picture->FileToPlaces(points.data(), points.data(), count) ||
    !this->Scene->PlacesToScene(points.data(), points.data(), count))
  {
    return false;
  }
  if (this->Globe)
  {
    GlobePaths::ToFlat(points.data(), points.size() / 3, *this->Globe, this->Heights);
  }
  return true;
}

bool PlacedRaster::SceneToPixels(std::vector<double>& points)
{
  const auto count = static_cast<vtkIdType>(points.size() / 3);
  if (this->Globe)
  {
    GlobePaths::FromFlat(points.data(), points.size() / 3, *this->Globe, this->Heights);
  }
  const bool isDone = this->IsOfHeights
    ? this->Scene->SceneToFile(points.data(), points.data(), count)
    : this->Scene->SceneToPlaces(points.data(), points.data(), count) &&
      this->Picture->PlacesToFile(points.data(), points.data(), count);
  if (!isDone)
  {
    return false;
  }
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    GDALApplyGeoTransform(
      this->FromFile.data(), points[i], points[i + 1], &points[i], &points[i + 1]);
  }
  return true;
}

/// GDAL's transformer: pixels of the output to and from pixels of the picture.
int PlacedRaster::Transform(
  void* self, int dstToSrc, int count, double* x, double* y, double*, int* success)
{
  auto& internals = *static_cast<PlacedRaster*>(self);
  std::vector<double> points(3 * static_cast<std::size_t>(count), 0.0);
  for (int i = 0; i < count; ++i)
  {
    double* point = points.data() + 3 * static_cast<std::ptrdiff_t>(i);
    point[0] = dstToSrc ? internals.Corner[0] + x[i] * internals.Spacing[0] : x[i];
    point[1] = dstToSrc ? internals.Corner[1] + y[i] * internals.Spacing[1] : y[i];
  }
  if (dstToSrc)
  {
    if (internals.Scene->GetFrame() == Frame::Local)
    {
      // Beyond the surface, the last height before its border: pixels there only blend into it.
      const GridGeometry geometry = ImageHeights::Geometry(internals.Heights);
      double last = internals.MiddleHeight;
      ImageHeights::Dispatch(internals.Heights,
        [&](const auto& heights)
        {
          for (std::size_t i = 0; i < points.size(); i += 3)
          {
            const glm::dvec3 grid = geometry.ToGrid({ points[i], points[i + 1], 0.0 });
            const double z = SampleBilinear(heights, grid.x, grid.y);
            last = std::isnan(z) ? last : z + geometry.Origin.z;
            points[i + 2] = last;
          }
        });
    }
    internals.SceneToPixels(points);
  }
  else
  {
    internals.PixelsToScene(points);
  }
  const double width = GDALGetRasterXSize(internals.File.get());
  const double height = GDALGetRasterYSize(internals.File.get());
  for (int i = 0; i < count; ++i)
  {
    const double* point = points.data() + 3 * static_cast<std::ptrdiff_t>(i);
    success[i] = std::isfinite(point[0]) && std::isfinite(point[1]) ? 1 : 0;
    x[i] = success[i] ? (dstToSrc ? InsideBorder(point[0], width)
                                  : (point[0] - internals.Corner[0]) / internals.Spacing[0])
                      : HUGE_VAL;
    y[i] = success[i] ? (dstToSrc ? InsideBorder(point[1], height)
                                  : (point[1] - internals.Corner[1]) / internals.Spacing[1])
                      : HUGE_VAL;
  }
  return 1; // points that fail are told one by one
}

std::string PlacedRaster::Warp(GDALWarpOptions* options, int columns, int rows)
{
  const GDALMessages messages;
  void* approximate = nullptr;
  options->pfnTransformer = PlacedRaster::Transform;
  options->pTransformerArg = this;
  if (this->Scene->GetFrame() != Frame::Local)
  {
    approximate = GDALCreateApproxTransformer(PlacedRaster::Transform, this, kInterpolationError);
    options->pfnTransformer = GDALApproxTransform;
    options->pTransformerArg = approximate;
  }
  if (this->Globe)
  {
    SearchInside(options);
  }
  GDALWarpOperationH operation = GDALCreateWarpOperation(options);
  CPLErr result = CE_Failure;
  if (operation)
  {
    result = GDALChunkAndWarpImage(operation, 0, 0, columns, rows);
    GDALDestroyWarpOperation(operation);
  }
  GDALDestroyWarpOptions(options);
  if (approximate)
  {
    GDALDestroyApproxTransformer(approximate);
  }
  return result == CE_None ? "" : "it cannot be warped (" + messages.GetFailure() + ")";
}
}
