// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkTerrainReproject that finds out where the inputs lie and what grid they need.
#include "place/ReprojectInternals.h"

#include "core/grid/HeightSampling.h"
#include "data/FieldData.h"
#include "data/ImageHeights.h"
#include "vtkTerrainGeoid.h"

#include "vtkInformationVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace
{
using Frame = vtkTerrainGeoreference::FrameType;

// Points along each side, and inside along each axis, by which the image of a tile is found.
constexpr int kSidePoints = 129;
constexpr int kInnerPoints = 33;

std::string ShortText(double value)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}
}

std::string vtkTerrainReproject::ReadTile(vtkImageData* image, Tile& tile) const
{
  std::string why = terrain::ImageHeights::WhyNotHeights(image);
  if (!why.empty())
  {
    return why;
  }
  tile.Image = image;
  tile.Geometry = terrain::ImageHeights::Geometry(image);
  if (!(tile.Geometry.Spacing.x > 0.0) || !(tile.Geometry.Spacing.y > 0.0))
  {
    return "the spacing of the heights is not positive";
  }
  tile.Layout = terrain::FieldData::GetLayout(image);
  tile.IsInMetres = image->GetFieldData()->GetAbstractArray("VerticalScale") != nullptr;
  tile.Reference->SetCoordinateSystem(this->CoordinateSystem);
  tile.Reference->SetFromHeights(image);
  tile.System = tile.Reference->GetCoordinateSystem();
  std::copy_n(tile.Reference->GetExtent(), 4, tile.Extent);
  image->GetPointData()->GetScalars()->GetFiniteRange(tile.Heights);
  tile.Reference->SetFrame(tile.System.empty() ? Frame::Grid : Frame::Geocentric);
  return {};
}

void vtkTerrainReproject::ShareScene(Tile& tile)
{
  vtkTerrainGeoreference* scene = this->Internals->Georeference;
  if (scene->GetFrame() == Frame::Grid && !scene->IsOnEarth())
  {
    tile.Reference->SetFrame(Frame::Grid);
  }
  tile.Reference->SetHeightUnit(tile.IsInMetres ? 1.0 : scene->GetHeightUnit());
  tile.Reference->SetFileHeights(scene->GetFileHeights());
  tile.Reference->SetSceneHeights(scene->GetSceneHeights());
  tile.Reference->GetGeoid()->SetModel(scene->GetGeoid()->GetModel());
  tile.Reference->GetGeoid()->SetDirectory(scene->GetGeoid()->GetDirectory());
}

void vtkTerrainReproject::PlanTurn(Tile& tile)
{
  // One sample after the last: where the first one is, if the samples go round the earth.
  const double columns = tile.Image->GetDimensions()[0];
  const double y = 0.5 * (tile.Extent[2] + tile.Extent[3]);
  const double step = tile.Geometry.Spacing.x / tile.Layout.Scale[0];
  double places[9] = { tile.Extent[0], y, 0.0, tile.Extent[1] + step, y, 0.0, tile.Extent[0] + step,
    y, 0.0 };
  if (!tile.Reference->FileToPlaces(places, places, 3))
  {
    return;
  }
  const double gap = std::remainder(places[3] - places[0], 360.0);
  const double cell = std::remainder(places[6] - places[0], 360.0);
  constexpr double kLeastColumns = 3.0;
  constexpr double kShareOfCell = 1e-3;
  tile.Turn =
    columns >= kLeastColumns && std::abs(gap) < kShareOfCell * std::abs(cell) ? columns : 0.0;
}

std::string vtkTerrainReproject::PlanScene()
{
  vtkInternals& internals = *this->Internals;
  vtkTerrainGeoreference* scene = internals.Georeference;
  const Tile& first = *internals.Tiles.front();
  if (scene->GetCoordinateSystem().empty() || scene->GetCoordinateSystem() == internals.OwnSystem)
  {
    scene->SetCoordinateSystem(first.System);
    internals.OwnSystem = first.System;
  }
  const double* given = scene->GetExtent();
  const bool isOwn = given[0] > given[1] || std::equal(given, given + 4, internals.OwnExtent);
  if (isOwn && scene->GetCoordinateSystem() == first.System)
  {
    double* extent = internals.OwnExtent;
    std::copy_n(first.Extent, 4, extent);
    for (const std::unique_ptr<Tile>& tile : internals.Tiles)
    {
      if (tile->System == first.System)
      {
        extent[0] = std::min(extent[0], tile->Extent[0]);
        extent[1] = std::max(extent[1], tile->Extent[1]);
        extent[2] = std::min(extent[2], tile->Extent[2]);
        extent[3] = std::max(extent[3], tile->Extent[3]);
      }
    }
    scene->SetExtent(extent[0], extent[1], extent[2], extent[3]);
  }
  internals.OwnTime = scene->GetMTime();
  if (scene->GetFrame() == Frame::Geocentric)
  {
    return "heights cannot be resampled in the geocentric frame, where z is not up";
  }
  std::string why = scene->GetWhyNot();
  for (const std::unique_ptr<Tile>& tile : internals.Tiles)
  {
    this->ShareScene(*tile);
    if (why.empty() && scene->IsOnEarth() && tile->System.empty())
    {
      why = "the heights have no coordinate system";
    }
    why = why.empty() ? tile->Reference->GetWhyNot() : why;
    this->PlanTurn(*tile);
  }
  return why;
}

void vtkTerrainReproject::FileToScene(const Tile& tile, double* points, vtkIdType count)
{
  vtkTerrainGeoreference* scene = this->Internals->Georeference;
  if (scene->IsOnEarth())
  {
    tile.Reference->FileToPlaces(points, points, count);
    scene->PlacesToScene(points, points, count);
  }
  else
  {
    tile.Reference->FileToScene(points, points, count);
  }
}

void vtkTerrainReproject::PlanSpacing(const Tile& tile)
{
  // The cell in the middle, as vectors of the scene.
  const double x = 0.5 * (tile.Extent[0] + tile.Extent[1]);
  const double y = 0.5 * (tile.Extent[2] + tile.Extent[3]);
  double points[9] = { x, y, 0.0, x + tile.Geometry.Spacing.x / tile.Layout.Scale[0], y, 0.0, x,
    y + tile.Geometry.Spacing.y / tile.Layout.Scale[1], 0.0 };
  this->FileToScene(tile, points, 3);
  const double area = std::abs((points[3] - points[0]) * (points[7] - points[1]) -
    (points[4] - points[1]) * (points[6] - points[0]));
  if (std::isfinite(area) && area > 0.0)
  {
    double& spacing = this->Internals->Spacing;
    spacing = spacing > 0.0 ? std::min(spacing, std::sqrt(area)) : std::sqrt(area);
  }
}

void vtkTerrainReproject::PlanBounds(Tile& tile)
{
  std::vector<double> points;
  const double edgeX =
    tile.Turn > 0.0 ? 0.0 : this->EdgeCells * tile.Geometry.Spacing.x / tile.Layout.Scale[0];
  const double edgeY =
    tile.Turn > 0.0 ? 0.0 : this->EdgeCells * tile.Geometry.Spacing.y / tile.Layout.Scale[1];
  const auto add = [&points, &tile, edgeX, edgeY](double u, double v)
  {
    for (double height : tile.Heights)
    {
      points.push_back((1.0 - u) * (tile.Extent[0] - edgeX) + u * (tile.Extent[1] + edgeX));
      points.push_back((1.0 - v) * (tile.Extent[2] - edgeY) + v * (tile.Extent[3] + edgeY));
      points.push_back(height);
    }
  };
  for (int i = 0; i < kSidePoints; ++i)
  {
    const double t = static_cast<double>(i) / (kSidePoints - 1);
    add(t, 0.0);
    add(t, 1.0);
    add(0.0, t);
    add(1.0, t);
  }
  for (int i = 0; i < kInnerPoints * kInnerPoints; ++i)
  {
    add(static_cast<double>(i % kInnerPoints) / (kInnerPoints - 1),
      std::floor(static_cast<double>(i) / kInnerPoints) / (kInnerPoints - 1));
  }
  this->FileToScene(tile, points.data(), static_cast<vtkIdType>(points.size() / 3));
  double* bounds = tile.Bounds;
  bounds[0] = bounds[2] = HUGE_VAL;
  bounds[1] = bounds[3] = -HUGE_VAL;
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    for (std::size_t axis = 0; axis < 2 && std::isfinite(points[i]); ++axis)
    {
      bounds[2 * axis] = std::min(bounds[2 * axis], points[i + axis]);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], points[i + axis]);
    }
  }
}

std::string vtkTerrainReproject::FitGrid(const double bounds[4])
{
  vtkInternals& internals = *this->Internals;
  const auto first = [bounds](std::size_t axis, double spacing)
  { return std::floor(bounds[2 * axis] / spacing + terrain::kSamplingSlack); };
  const auto last = [bounds](std::size_t axis, double spacing)
  { return std::ceil(bounds[2 * axis + 1] / spacing - terrain::kSamplingSlack); };
  const auto samples = [&first, &last](double spacing)
  {
    return (last(0, spacing) - first(0, spacing) + 1.0) *
      (last(1, spacing) - first(1, spacing) + 1.0);
  };
  const double most = static_cast<double>(this->MaximumNumberOfSamples);
  if (this->Spacing > 0.0 && !(samples(this->Spacing) <= most))
  {
    return "a spacing of " + ShortText(this->Spacing) + " m needs " +
      ShortText(samples(this->Spacing)) + " samples, more than the " + ShortText(most) +
      " that are allowed";
  }
  while (samples(internals.Spacing) > most)
  {
    internals.Spacing *= 1.01;
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    internals.Origin[axis] = first(axis, internals.Spacing) * internals.Spacing;
    internals.Extent[2 * axis] = 0;
    internals.Extent[2 * axis + 1] =
      static_cast<int>(last(axis, internals.Spacing) - first(axis, internals.Spacing));
  }
  internals.Extent[4] = internals.Extent[5] = 0;
  return {};
}

std::string vtkTerrainReproject::PlanGrid()
{
  vtkInternals& internals = *this->Internals;
  double bounds[4] = { HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL };
  internals.Spacing = this->Spacing;
  for (std::unique_ptr<Tile>& tile : internals.Tiles)
  {
    this->PlanBounds(*tile);
    for (int side = 0; side < 4; ++side)
    {
      bounds[side] = side % 2 == 0 ? std::min(bounds[side], tile->Bounds[side])
                                   : std::max(bounds[side], tile->Bounds[side]);
    }
    if (!(this->Spacing > 0.0))
    {
      this->PlanSpacing(*tile);
    }
  }
  if (!(bounds[0] <= bounds[1]) || !(internals.Spacing > 0.0))
  {
    return "the heights have no image in the scene";
  }
  return this->FitGrid(bounds);
}

void vtkTerrainReproject::CheckFlatness()
{
  vtkTerrainGeoreference* scene = this->Internals->Georeference;
  this->WarningMessage = scene->GetWarning();
  double horizontal = 0.0;
  double vertical = 0.0;
  scene->GetFlatError(horizontal, vertical);
  const double error = std::hypot(horizontal, vertical);
  // A map of a degree falls by 0.6 % of its reach, which nobody sees.
  constexpr double kSmallDrop = 0.01;
  const int* e = this->Internals->Extent;
  const double reach = 0.5 * this->Internals->Spacing * std::hypot(e[1] - e[0], e[3] - e[2]);
  if (horizontal > this->Internals->Spacing ||
    vertical > std::max(this->Internals->Spacing, kSmallDrop * reach))
  {
    this->WarningMessage += (this->WarningMessage.empty() ? "" : "; ") +
      std::string("the flat scene is wrong by up to ") + ShortText(error) + " m (" +
      ShortText(horizontal) + " m sideways, " + ShortText(vertical) +
      " m of the earth's curvature), its cells are " + ShortText(this->Internals->Spacing) +
      " m: the frame Local is exact";
  }
}

std::string vtkTerrainReproject::Plan(vtkInformationVector* inputs)
{
  vtkInternals& internals = *this->Internals;
  internals.Tiles.clear();
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    internals.Tiles.push_back(std::make_unique<Tile>());
    std::string why = this->ReadTile(vtkImageData::GetData(inputs, i), *internals.Tiles.back());
    if (!why.empty())
    {
      return why;
    }
  }
  if (internals.Tiles.empty())
  {
    return "no heights are given";
  }
  std::string why = this->PlanScene();
  return why.empty() ? this->PlanGrid() : why;
}
