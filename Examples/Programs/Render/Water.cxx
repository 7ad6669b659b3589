// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Water.h"

#include "ColorName.h"
#include "DataRim.h"
#include "DefaultView.h"
#include "Failure.h"
#include "Options.h"
#include "Placing.h"
#include "Terrain.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTerrainActor.h"
#include "vtkTexture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
constexpr RGB kShallowWater = { 0.36, 0.62, 0.68 };
constexpr RGB kDeepWater = { 0.04, 0.16, 0.33 };
constexpr RGB kWaterSide = { 0.12, 0.34, 0.50 };
constexpr double kSideOpacity = 0.62;
/// Opacity at the shore, and in water without end.
constexpr double kLeastOpacity = 0.35;
constexpr double kMostOpacity = 0.94;
/// Depth at which 1/e of the way to the deepest colour is left, in parts of the greatest depth.
constexpr double kClearDepth = 0.3;
/// Texels a side that every graphics driver has.
constexpr int kMostTexels = 8192;

/// Water over one terrain, in the coordinates of its heights.
class WaterBody
{
public:
  WaterBody(vtkImageData* heights, double level)
    : Heights(heights)
    , Rim(heights)
    , Level(level)
  {
  }

  /// False if all of the ground is higher.
  bool IsAnywhere()
  {
    const vtkIdType count = this->Heights->GetNumberOfPoints();
    for (vtkIdType k = 0; k < count; ++k)
    {
      if (this->Rim.HasHeight(k))
      {
        this->Deepest = std::max(this->Deepest, this->Level - this->Rim.GetHeight(k));
      }
    }
    return this->Deepest > 0.0;
  }

  /// A rectangle over all samples, whose texels are these.
  vtkSmartPointer<vtkActor> MakeTop() const
  {
    const vtkSmartPointer<vtkImageData> picture = this->MakePicture();
    std::array<double, 6> bounds{};
    this->Heights->GetBounds(bounds.data());
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const vtkNew<vtkFloatArray> at;
    at->SetNumberOfComponents(2);
    for (int corner = 0; corner < 4; ++corner)
    {
      const bool isEast = corner == 1 || corner == 2;
      const bool isNorth = corner > 1;
      points->InsertNextPoint(
        bounds[isEast ? 1 : 0], bounds[isNorth ? 3 : 2], bounds[4] + this->Level);
      const auto place = [&](int axis, bool isLast)
      {
        const double half = 0.5 / picture->GetDimensions()[axis];
        return isLast ? 1.0 - half : half;
      };
      at->InsertNextTuple2(place(0, isEast), place(1, isNorth));
    }
    const vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({ 0, 1, 2, 3 });
    const vtkNew<vtkPolyData> plane;
    plane->SetPoints(points);
    plane->SetPolys(cells);
    plane->GetPointData()->SetTCoords(at);
    const vtkNew<vtkTexture> texture;
    texture->SetInputData(picture);
    texture->RepeatOff(); // else opposite borders run into each other
    texture->EdgeClampOn();
    texture->InterpolateOn();
    texture->MipmapOn();
    texture->SetColorModeToDirectScalars();
    vtkSmartPointer<vtkActor> top = MakeActor(plane);
    top->SetTexture(texture);
    return top;
  }

  /// Along the rim, from the ground up to the level; null if the ground is higher all along it.
  vtkSmartPointer<vtkActor> MakeSides() const
  {
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const vtkNew<vtkCellArray> cells;
    for (const DataRim::Side& side : this->Rim.FindSides())
    {
      std::vector<std::array<double, 3>> corners;
      this->AddGround(side.From, side.To, corners);
      if (corners.size() < 2)
      {
        continue;
      }
      const double level = this->Heights->GetOrigin()[2] + this->Level;
      const std::array<double, 3> first = corners.front();
      const std::array<double, 3> last = corners.back();
      corners.push_back({ last[0], last[1], level });
      corners.push_back({ first[0], first[1], level });
      cells->InsertNextCell(static_cast<int>(corners.size()));
      for (const std::array<double, 3>& corner : corners)
      {
        cells->InsertCellPoint(points->InsertNextPoint(corner.data()));
      }
    }
    if (cells->GetNumberOfCells() == 0)
    {
      return nullptr;
    }
    const vtkNew<vtkPolyData> walls;
    walls->SetPoints(points);
    walls->SetPolys(cells);
    auto sides = MakeActor(walls);
    sides->GetProperty()->SetColor(kWaterSide[0], kWaterSide[1], kWaterSide[2]);
    sides->GetProperty()->SetOpacity(kSideOpacity);
    sides->GetProperty()->BackfaceCullingOn(); // those behind are seen through the water already
    return sides;
  }

private:
  static vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* shape)
  {
    const vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(shape);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    return actor;
  }

  /// The ground between two samples, as far as it is below the level.
  void AddGround(vtkIdType from, vtkIdType to, std::vector<std::array<double, 3>>& corners) const
  {
    const std::array<double, 2> heights = { this->Rim.GetHeight(from), this->Rim.GetHeight(to) };
    const std::array<std::array<double, 3>, 2> ends = { this->Rim.GetPoint(from, heights[0]),
      this->Rim.GetPoint(to, heights[1]) };
    if (heights[0] < this->Level)
    {
      corners.push_back(ends[0]);
    }
    if ((heights[0] < this->Level) != (heights[1] < this->Level))
    {
      const double t = (this->Level - heights[0]) / (heights[1] - heights[0]);
      std::array<double, 3> shore{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        shore[axis] = ends[0][axis] + t * (ends[1][axis] - ends[0][axis]);
      }
      corners.push_back(shore);
    }
    if (heights[1] < this->Level)
    {
      corners.push_back(ends[1]);
    }
  }

  /// True for ground below the level.
  bool IsWet(vtkIdType i, vtkIdType j) const
  {
    const int* dims = this->Heights->GetDimensions();
    const vtkIdType sample = i + dims[0] * j;
    return i >= 0 && j >= 0 && i < dims[0] && j < dims[1] && this->Rim.HasHeight(sample) &&
      this->Rim.GetHeight(sample) < this->Level;
  }

  /// Clear where there is no ground, and under land, but for what is next to water.
  void PaintTexel(unsigned char* texel, vtkIdType i, vtkIdType j) const
  {
    constexpr double kFull = 255.0;
    const vtkIdType sample = i + this->Heights->GetDimensions()[0] * j;
    const bool hasHeight = this->Rim.HasHeight(sample);
    const double depth = hasHeight ? this->Level - this->Rim.GetHeight(sample) : 0.0;
    const double left = std::exp(-std::max(depth, 0.0) / (kClearDepth * this->Deepest));
    for (std::size_t k = 0; k < 3; ++k)
    {
      texel[k] = static_cast<unsigned char>(
        std::lround(kFull * (kDeepWater[k] + left * (kShallowWater[k] - kDeepWater[k]))));
    }
    bool isShore = false;
    for (int k = 0; hasHeight && k < 9; ++k)
    {
      isShore = isShore || this->IsWet(i + k % 3 - 1, j + k / 3 - 1);
    }
    const double opacity = kMostOpacity + left * (kLeastOpacity - kMostOpacity);
    texel[3] = static_cast<unsigned char>(std::lround(isShore ? kFull * opacity : 0.0));
  }

  /// A texel for each sample, or for every n-th of very many.
  vtkSmartPointer<vtkImageData> MakePicture() const
  {
    const int* dims = this->Heights->GetDimensions();
    const std::array<int, 2> size = { std::min(dims[0], kMostTexels),
      std::min(dims[1], kMostTexels) };
    auto picture = vtkSmartPointer<vtkImageData>::New();
    picture->SetDimensions(size[0], size[1], 1);
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto* texels = static_cast<unsigned char*>(picture->GetScalarPointer());
    const auto sampleAt = [&](int texel, int axis)
    {
      return size[axis] < 2
        ? vtkIdType{ 0 }
        : static_cast<vtkIdType>(std::llround(double(texel) * (dims[axis] - 1) / (size[axis] - 1)));
    };
    std::array<double, 3> first{};
    std::array<double, 3> last{};
    this->Heights->GetPoint(0, first.data());
    this->Heights->GetPoint(this->Heights->GetNumberOfPoints() - 1, last.data());
    for (int j = 0; j < size[1]; ++j)
    {
      const int row = last[1] < first[1] ? size[1] - 1 - j : j;
      for (int i = 0; i < size[0]; ++i, texels += 4)
      {
        this->PaintTexel(texels, sampleAt(i, 0), sampleAt(row, 1));
      }
    }
    return picture;
  }

  vtkSmartPointer<vtkImageData> Heights;
  DataRim Rim;
  double Level;
  double Deepest = 0.0;
};
}

//------------------------------------------------------------------------------
void AddWater(vtkRenderer* renderer, Terrain& terrain, const std::vector<Terrain>& sites,
  const PlacedHeights& heights, const Options& options)
{
  using FrameType = vtkTerrainGeoreference::FrameType;
  if (!options.Scenery.Water)
  {
    return;
  }
  const FrameType frame = heights.Georeference->GetFrame();
  if (frame == FrameType::Local || frame == FrameType::Geocentric || frame == FrameType::Globe)
  {
    throw Failure("--water", "is a plane, and this scene is round: choose --frame plane or map");
  }
  std::vector<vtkTerrainActor*> grounds = { terrain.Actor };
  for (const Terrain& site : sites)
  {
    grounds.push_back(site.Actor);
  }
  for (vtkTerrainActor* ground : grounds)
  {
    vtkImageData* image =
      ground == terrain.Actor.Get() ? heights.Image.Get() : ground->GetHeights();
    if (!image || !image->GetPointData()->GetScalars())
    {
      throw Failure("--water", "needs the heights: choose another --technique than strips alone");
    }
    WaterBody water(image, *options.Scenery.Water - image->GetOrigin()[2]);
    if (!water.IsAnywhere())
    {
      continue;
    }
    for (const vtkSmartPointer<vtkActor>& part : { water.MakeSides(), water.MakeTop() })
    {
      if (part)
      {
        ground->PlaceAsDrawn(part, image->GetOrigin()[2]);
        renderer->AddActor(part);
        terrain.Bounds.AddBounds(part->GetBounds());
      }
    }
  }
  SetClippingRange(renderer->GetActiveCamera(), terrain.Bounds, heights);
  // VTK's other way to draw translucent surfaces takes opacity from what lies behind them
  renderer->SetUseDepthPeeling(options.Scenery.IsTransparent());
}
