// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonLayer.h"

#include "Failure.h"
#include "FieldColors.h"
#include "Options.h"
#include "Placing.h"
#include "PolygonFill.h"
#include "Statistics.h"
#include "VectorFile.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"
#include "vtkTerrainGeoreference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
constexpr RGB kPolygonColor = { 0.16, 0.38, 0.78 };
/// Pixels of the fill's picture for each cell of the heights, and most and fewest on its longer
/// side.
constexpr double kPixelsPerCell = 4.0;
constexpr double kMostPixels = 4096.0;
constexpr double kFewestPixels = 1024.0;
/// Most pixels a side where a picture that lies below is finer.
constexpr double kMostPixelsOfPicture = 16384.0;

void RefuseRoundScene(const PlacedHeights& heights)
{
  using Frames = vtkTerrainGeoreference::FrameType;
  const Frames frame = heights.Georeference->GetFrame();
  if (frame == Frames::Local || frame == Frames::Geocentric || frame == Frames::Globe)
  {
    throw Failure(
      "--polygons", "lie in a plane, and this scene is round: choose --frame plane or map");
  }
}

/// A transparent picture over heights, its first row southernmost.
vtkSmartPointer<vtkImageData> MakePicture(vtkImageData* heights, vtkImageData* below)
{
  std::array<double, 6> bounds{};
  heights->GetBounds(bounds.data());
  const std::array<double, 2> length = { bounds[1] - bounds[0], bounds[3] - bounds[2] };
  const int* cells = heights->GetDimensions();
  double longest =
    std::clamp(kPixelsPerCell * (std::max(cells[0], cells[1]) - 1), kFewestPixels, kMostPixels);
  const double side = std::max(length[0], length[1]);
  if (below)
  {
    longest = std::clamp(side / below->GetSpacing()[0], longest, kMostPixelsOfPicture);
  }
  auto picture = vtkSmartPointer<vtkImageData>::New();
  std::array<int, 3> size{ 1, 1, 1 };
  for (int axis = 0; axis < 2; ++axis)
  {
    size[axis] = std::max(1, static_cast<int>(std::lround(longest * length[axis] / side)));
  }
  const std::array<double, 3> spacing = { length[0] / size[0], length[1] / size[1], 1.0 };
  picture->SetDimensions(size.data());
  picture->SetSpacing(spacing.data());
  picture->SetOrigin(bounds[0] + 0.5 * spacing[0], bounds[2] + 0.5 * spacing[1], 0.0);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* first = static_cast<unsigned char*>(picture->GetScalarPointer());
  std::fill_n(first, 4 * picture->GetNumberOfPoints(), static_cast<unsigned char>(0));
  return picture;
}

/// The pixel of another picture at each pixel's place, the nearest one; RGBA.
void CopyPicture(vtkImageData* below, vtkImageData* picture)
{
  const int* size = picture->GetDimensions();
  const int* from = below->GetDimensions();
  const auto nearest = [&](int index, int axis)
  {
    const double at = picture->GetOrigin()[axis] + index * picture->GetSpacing()[axis];
    return static_cast<int>(
      std::lround((at - below->GetOrigin()[axis]) / below->GetSpacing()[axis]));
  };
  for (int j = 0; j < size[1]; ++j)
  {
    const int row = nearest(j, 1);
    auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(0, j, 0));
    for (int i = 0; row >= 0 && row < from[1] && i < size[0]; ++i)
    {
      const int column = nearest(i, 0);
      if (column >= 0 && column < from[0])
      {
        const auto* source = static_cast<unsigned char*>(below->GetScalarPointer(column, row, 0));
        std::copy_n(source, 4, pixel + 4 * static_cast<std::ptrdiff_t>(i));
      }
    }
  }
}

/// Fills the polygons of a file, one after the other.
void FillFile(vtkImageData* picture, vtkPolyData* file, const PolygonLayer& layer, double opacity)
{
  vtkDataArray* polygonOfRing = file->GetCellData()->GetArray(kPolygonOfRing);
  vtkDataArray* values = file->GetPointData()->GetArray(kFieldValue);
  const vtkNew<vtkIdList> ids;
  PlaneRings rings;
  for (vtkIdType ring = 0; ring < file->GetNumberOfCells(); ++ring)
  {
    file->GetCellPoints(ring, ids);
    rings.emplace_back();
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const double* point = file->GetPoint(ids->GetId(k));
      rings.back().push_back({ point[0], point[1] });
    }
    const bool isLast = ring + 1 == file->GetNumberOfCells() ||
      polygonOfRing->GetComponent(ring, 0) != polygonOfRing->GetComponent(ring + 1, 0);
    if (isLast)
    {
      RGB color = layer.Color;
      if (layer.Key.Table)
      {
        layer.Key.Table->GetColor(values->GetComponent(ids->GetId(0), 0), color.data());
      }
      FillRings(picture, rings, { color[0], color[1], color[2], opacity });
      rings.clear();
    }
  }
}
}

//------------------------------------------------------------------------------
PolygonLayer ReadPolygonLayer(
  const PlacedHeights& heights, const Options& options, Statistics& statistics)
{
  PolygonLayer layer;
  const PolygonOptions& wanted = options.Polygon;
  if (wanted.Files.empty())
  {
    return layer;
  }
  RefuseRoundScene(heights);
  layer.Color = ParseColor(wanted.Colors).value_or(kPolygonColor);
  std::int64_t count = 0;
  for (const std::string& path : wanted.Files)
  {
    layer.Files.push_back(
      ReadVectorsWithField(path, heights.Georeference, wanted.ColorBy, Polygons::Rings));
    layer.Files.back()->BuildCells();
    count += static_cast<std::int64_t>(
      layer.Files.back()->GetCellData()->GetArray(kPolygonOfRing)->GetRange()[1] + 1.0);
  }
  if (!wanted.ColorBy.empty())
  {
    layer.Key = ColorByField(layer.Files, wanted);
  }
  statistics.SetCount("polygons", count);
  return layer;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> FillPolygons(
  const PolygonLayer& layer, vtkImageData* heights, vtkImageData* below, const Options& options)
{
  if (layer.Files.empty() || options.Polygon.Opacity == 0.0)
  {
    return nullptr;
  }
  vtkSmartPointer<vtkImageData> picture = MakePicture(heights, below);
  if (below)
  {
    CopyPicture(below, picture);
  }
  for (vtkPolyData* file : layer.Files)
  {
    FillFile(picture, file, layer, options.Polygon.Opacity);
  }
  return picture;
}
