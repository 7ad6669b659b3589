// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "place/ImageWarp.h"

#include "core/files/OutputFile.h"
#include "core/grid/HeightSampling.h"
#include "data/GlobePaths.h"
#include "data/ImageHeights.h"
#include "raster/RasterMessages.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
// Points along each side of the picture by which it is found in the scene.
constexpr int kOutlinePoints = 65;

/// The picture as three bands of 8 bits, and alpha if there is any; a view of the file.
Dataset AsColors(GDALDatasetH file)
{
  const int bands = GDALGetRasterCount(file);
  GDALRasterBandH first = GDALGetRasterBand(file, 1);
  const bool hasAlpha =
    GDALGetRasterColorInterpretation(GDALGetRasterBand(file, bands)) == GCI_AlphaBand;
  std::vector<std::string> arguments{ "-of", "VRT" };
  if (bands == 1 && GDALGetRasterColorTable(first))
  {
    arguments.insert(arguments.end(), { "-expand", "rgba" });
  }
  else
  {
    const int colors = hasAlpha ? bands - 1 : bands;
    for (int i = 1; i <= 3; ++i)
    {
      arguments.insert(arguments.end(), { "-b", std::to_string(colors >= 3 ? i : 1) });
    }
    if (hasAlpha)
    {
      arguments.insert(arguments.end(), { "-b", std::to_string(bands) });
    }
    if (GDALGetRasterDataType(first) != GDT_Byte)
    {
      arguments.insert(arguments.end(), { "-ot", "Byte", "-scale_1", "-scale_2", "-scale_3" });
    }
  }
  char** list = nullptr;
  for (const std::string& argument : arguments)
  {
    list = CSLAddString(list, argument.c_str());
  }
  GDALTranslateOptions* options = GDALTranslateOptionsNew(list, nullptr);
  CSLDestroy(list);
  int failed = 0;
  Dataset colors = Own(GDALTranslate("", file, options, &failed));
  GDALTranslateOptionsFree(options);
  return colors;
}
}

std::string ImageWarp::OpenColors(const std::string& name, const std::string& system)
{
  this->Colors = Own(nullptr);
  std::string why = this->Open(name, system);
  if (!why.empty())
  {
    return why;
  }
  const GDALMessages messages;
  this->Colors = AsColors(this->File.get());
  return this->Colors ? ""
                      : "'" + name + "' cannot be read as colours (" + messages.GetFailure() + ")";
}

/// The overlap with the heights: west, east, south, north. Without one, west >= east or
/// south >= north.
std::array<double, 4> ImageWarp::FindOverlap()
{
  // In a round scene what lies high, or is exaggerated, stands elsewhere than its foot.
  const double lowest = this->Globe ? 0.0 : -11000.0;
  const double highest = this->Globe ? 0.0 : 9000.0;
  const double width = GDALGetRasterXSize(this->File.get());
  const double height = GDALGetRasterYSize(this->File.get());
  std::vector<double> points;
  for (int j = 0; j < kOutlinePoints; ++j)
  {
    for (int i = 0; i < kOutlinePoints; ++i)
    {
      const double x = width * i / (kOutlinePoints - 1);
      const double y = height * j / (kOutlinePoints - 1);
      points.insert(points.end(), { x, y, lowest, x, y, highest });
    }
  }
  this->PixelsToScene(points);
  double bounds[6];
  this->Heights->GetBounds(bounds);
  std::array<double, 4> own{ HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL };
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    if (std::isfinite(points[i]))
    {
      own[0] = std::min(own[0], points[i]);
      own[1] = std::max(own[1], points[i]);
      own[2] = std::min(own[2], points[i + 1]);
      own[3] = std::max(own[3], points[i + 1]);
    }
  }
  if (this->Globe)
  {
    this->WidenOnGlobe(points, own);
  }
  return { std::max(bounds[0], own[0]), std::min(bounds[1], own[1]), std::max(bounds[2], own[2]),
    std::min(bounds[3], own[3]) };
}

/// A picture that goes on beyond the longitudes of the heights on their other side, or has a pole
/// in it, lies at all longitudes; points: of its outline and inside, two at each place.
void ImageWarp::WidenOnGlobe(const std::vector<double>& points, std::array<double, 4>& own)
{
  constexpr std::size_t stride = 6;
  const double half = 0.5 * kTurn / this->Globe->Step * this->Heights->GetSpacing()[0];
  bool isRound = false;
  for (std::size_t i = stride; i < points.size(); i += stride)
  {
    const bool isNewRow = i / stride % kOutlinePoints == 0;
    isRound = isRound || (!isNewRow && std::abs(points[i] - points[i - stride]) > half);
  }
  const double width = GDALGetRasterXSize(this->File.get());
  const double height = GDALGetRasterYSize(this->File.get());
  for (const double side : { -1.0, 1.0 })
  {
    std::vector<double> pole{ 0.0, 90.0 * side, 0.0 };
    this->Picture->PlacesToFile(pole.data(), pole.data(), 1);
    GDALApplyGeoTransform(this->FromFile.data(), pole[0], pole[1], &pole[0], &pole[1]);
    if (pole[0] >= 0.0 && pole[0] <= width && pole[1] >= 0.0 && pole[1] <= height)
    {
      isRound = true;
      own[side < 0.0 ? 2 : 3] = side * HUGE_VAL;
    }
  }
  if (isRound)
  {
    own[0] = -HUGE_VAL;
    own[1] = HUGE_VAL;
  }
}

std::string ImageWarp::Place(int maximumSize)
{
  const std::array<double, 4> bounds = this->FindOverlap();
  if (!(bounds[0] < bounds[1] && bounds[2] < bounds[3]))
  {
    return "the picture does not meet the terrain";
  }
  double range[2];
  this->Heights->GetPointData()->GetScalars()->GetFiniteRange(range);
  this->MiddleHeight = 0.5 * (range[0] + range[1]);
  // A pixel in the middle of the overlap; its size in the scene from the inverse.
  const double x = 0.5 * (bounds[0] + bounds[1]);
  const double y = 0.5 * (bounds[2] + bounds[3]);
  const double step = 0.001 * std::min(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  std::vector<double> cross{ x, y, 0.0, x + step, y, 0.0, x, y + step, 0.0 };
  this->SceneToPixels(cross);
  const double area = std::abs(
    (cross[3] - cross[0]) * (cross[7] - cross[1]) - (cross[4] - cross[1]) * (cross[6] - cross[0]));
  if (!(area > 0.0) || !std::isfinite(area))
  {
    return "the picture has no image in the middle of the terrain";
  }
  const double side = std::max(
    step / std::sqrt(area), std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]) / maximumSize);
  this->Spacing = { side, side };
  const double lengths[2] = { bounds[1] - bounds[0], bounds[3] - bounds[2] };
  this->Corner[0] = bounds[0];
  this->Corner[1] = bounds[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Size[axis] =
      std::clamp(static_cast<int>(std::ceil(lengths[axis] / side - 1e-6)), 1, maximumSize);
  }
  return {};
}

/// What is warped into RGBA, without a transformer; to be destroyed by GDALDestroyWarpOptions().
GDALWarpOptions* ImageWarp::MakeOptions(GDALDatasetH target)
{
  const bool hasAlpha = GDALGetRasterCount(this->Colors.get()) == 4;
  GDALWarpOptions* options = GDALCreateWarpOptions();
  options->hSrcDS = this->Colors.get();
  options->hDstDS = target;
  options->eResampleAlg = GRA_Bilinear;
  options->nBandCount = 3;
  options->panSrcBands = static_cast<int*>(CPLMalloc(3 * sizeof(int)));
  options->panDstBands = static_cast<int*>(CPLMalloc(3 * sizeof(int)));
  for (int i = 0; i < 3; ++i)
  {
    options->panSrcBands[i] = options->panDstBands[i] = i + 1;
  }
  options->nSrcAlphaBand = hasAlpha ? 4 : 0;
  options->nDstAlphaBand = 4;
  int hasNoData = 0;
  const double noData =
    GDALGetRasterNoDataValue(GDALGetRasterBand(this->Colors.get(), 1), &hasNoData);
  if (hasNoData)
  {
    options->padfSrcNoDataReal = static_cast<double*>(CPLMalloc(3 * sizeof(double)));
    std::fill_n(options->padfSrcNoDataReal, 3, noData);
    options->papszWarpOptions =
      CSLSetNameValue(options->papszWarpOptions, "UNIFIED_SRC_NODATA", "YES");
  }
  options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "INIT_DEST", "0");
  return options;
}

std::string ImageWarp::WarpColors(unsigned char* rgba)
{
  const GDALMessages messages;
  const Dataset target = Own(
    GDALCreate(GDALGetDriverByName("MEM"), "", this->Size[0], this->Size[1], 4, GDT_Byte, nullptr));
  if (!target)
  {
    return "the picture needs more memory than there is (" + messages.GetFailure() + ")";
  }
  const std::string why = this->Warp(this->MakeOptions(target.get()), this->Size[0], this->Size[1]);
  if (!why.empty())
  {
    return "the picture: " + why;
  }
  const CPLErr result = GDALDatasetRasterIOEx(target.get(), GF_Read, 0, 0, this->Size[0],
    this->Size[1], rgba, this->Size[0], this->Size[1], GDT_Byte, 4, nullptr, 4,
    4 * static_cast<GSpacing>(this->Size[0]), 1, nullptr);
  return result == CE_None ? "" : "the picture cannot be warped (" + messages.GetFailure() + ")";
}
}
