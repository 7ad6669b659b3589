// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/GlobeSurface.h"

#include "data/GlobeData.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
/// Parts of a cell by which a place on the border of a globe may be rounded.
constexpr double kBorder = 1e-7;
}

//------------------------------------------------------------------------------
bool GlobeSurface::SetImage(vtkImageData* image)
{
  if (!GlobeData::Has(image) || !ImageHeights::WhyNotHeights(image).empty())
  {
    return false;
  }
  if (this->Image == image && this->ImageTime == image->GetMTime())
  {
    return true;
  }
  std::unique_ptr<GlobeGrid> grid = GlobeData::Get(image);
  if (!grid || !grid->WhyNot().empty() ||
    static_cast<int>(grid->Latitudes.size()) != image->GetDimensions()[1])
  {
    return false;
  }
  this->Grid = std::move(grid);
  this->Image = image;
  this->ImageTime = image->GetMTime();
  this->Texels.resize(static_cast<std::size_t>(image->GetNumberOfPoints()));
  ImageHeights::Dispatch(image,
    [this](const auto& view)
    {
      this->Codes = ChooseHeightCodes(FindHeightRange(view, SMPParallelFor));
      this->Codes.Format = HeightCodes::TexelFormat::Float32;
      this->Codes.Bias = 0;
      EncodeHeights(
        view, this->Codes, 0, view.Width, 0, view.Height, this->Texels.data(), SMPParallelFor);
    });
  HeightfieldView<float> view;
  view.Samples = this->Texels.data();
  view.Width = image->GetDimensions()[0];
  view.Height = image->GetDimensions()[1];
  view.HasNoData = this->Codes.HasNoData;
  view.NoData = kNoDataCode;
  this->Pyramid.Build(view, SMPParallelFor);
  return true;
}

//------------------------------------------------------------------------------
glm::dvec4 GlobeSurface::CellHeights(const glm::ivec2& cell) const
{
  const auto height = [this, &cell](int i, int j)
  {
    const auto at = static_cast<std::size_t>(cell.x + i) +
      static_cast<std::size_t>(cell.y + j) * static_cast<std::size_t>(this->Grid->Columns);
    const float code = this->Texels[at];
    return code < 0.0f ? kNaN : this->Codes.ToHeight(static_cast<double>(code));
  };
  return { height(0, 0), height(1, 0), height(0, 1), height(1, 1) };
}

//------------------------------------------------------------------------------
double GlobeSurface::HeightAt(double longitude, double latitude) const
{
  const GlobeGrid& grid = *this->Grid;
  const std::vector<double>& rows = grid.Latitudes;
  // a place on the border may be rounded to either side of it
  const double turn = kTurn / grid.Step;
  double column = (longitude * kDegree - grid.West) / grid.Step;
  column -= std::floor((column + kBorder) / turn) * turn;
  const double last = grid.Cells().x;
  const double north = std::clamp(latitude * kDegree, rows.front(), rows.back());
  if (!(column <= last + kBorder) || !(std::abs(north - latitude * kDegree) <= kBorder * grid.Step))
  {
    return kNaN;
  }
  column = std::clamp(column, 0.0, last);
  const auto row =
    static_cast<int>(std::upper_bound(rows.begin(), rows.end() - 1, north) - rows.begin() - 1);
  const glm::ivec2 cell(
    std::min(static_cast<int>(column), grid.Cells().x - 1), std::min(row, grid.Cells().y - 1));
  const auto j = static_cast<std::size_t>(cell.y);
  const glm::dvec2 fraction(column - cell.x, (north - rows[j]) / (rows[j + 1] - rows[j]));
  const glm::dvec4 h = this->CellHeights(cell);
  return glm::mix(glm::mix(h.x, h.y, fraction.x), glm::mix(h.z, h.w, fraction.x), fraction.y);
}

//------------------------------------------------------------------------------
GlobeHit<double> GlobeSurface::Trace(const glm::dvec3& origin, const glm::dvec3& direction,
  double begin, double end, double exaggeration) const
{
  const GridGeometry drawn = DrawnOnGlobe(exaggeration);
  const GlobeRange range{ drawn.RiseToModel(this->Codes.Offset),
    drawn.RiseToModel(this->Codes.ToHeight(this->Codes.MaximumCode)) };
  const GlobeAnchor anchor(*this->Grid, range, origin);
  const GlobeLines<double> lines(*this->Grid, anchor);
  GlobeTraversal<double, float> traversal;
  traversal.lines = &lines;
  traversal.heights = { this->Texels.data(),
    { this->Grid->Columns, static_cast<int>(this->Grid->Latitudes.size()) }, 0,
    static_cast<float>(this->Codes.MaximumCode) };
  traversal.pyramid = &this->Pyramid;
  traversal.SetHeights(range.Lowest, drawn.RiseToModel(this->Codes.Scale), anchor.Height);
  return traversal.Trace({ glm::dvec3(0.0), anchor.ToAxes(direction), begin, end });
}

//------------------------------------------------------------------------------
GlobeHit<double> GlobeSurface::TraceSeen(const glm::dvec3& origin, const glm::dvec3& direction,
  double begin, double end, double exaggeration) const
{
  constexpr double pace = 10.0; // metres, as in shaders/vtkTerrainCast.glsl
  GlobeHit<double> hit = this->Trace(origin, direction, begin, end, exaggeration);
  while (hit.Found && !hit.Front)
  {
    const double on = hit.T + pace / glm::length(direction);
    hit = this->Trace(origin, direction, on, end, exaggeration);
  }
  return hit;
}

//------------------------------------------------------------------------------
glm::dvec3 GlobeSurface::PositionAt(
  const glm::ivec2& cell, const glm::dvec2& fraction, double exaggeration, glm::dvec3& normal) const
{
  const GlobeGrid& grid = *this->Grid;
  const auto row = static_cast<std::size_t>(cell.y);
  const double rows = grid.Latitudes[row + 1] - grid.Latitudes[row];
  const glm::dvec4 h = this->CellHeights(cell) * DrawnOnGlobe(exaggeration).RiseToModel(1.0);
  const double height =
    glm::mix(glm::mix(h.x, h.y, fraction.x), glm::mix(h.z, h.w, fraction.x), fraction.y);
  const glm::dvec3 place(
    grid.West + (cell.x + fraction.x) * grid.Step, grid.Latitudes[row] + fraction.y * rows, height);
  const double sine = std::sin(place.y);
  const double cosine = std::max(std::cos(place.y), 1e-9);
  const glm::dvec2 slope(glm::mix(h.y - h.x, h.w - h.z, fraction.y) /
      (grid.Step * (grid.Body.PrimeVertical(sine) + height) * cosine),
    glm::mix(h.z - h.x, h.w - h.y, fraction.x) / (rows * (grid.Body.Meridional(sine) + height)));
  const glm::dvec3 out(std::cos(place.x), std::sin(place.x), 0.0);
  const glm::dvec3 axis(0.0, 0.0, 1.0);
  const glm::dvec3 up = cosine * out + sine * axis;
  const glm::dvec3 north = cosine * axis - sine * out;
  const glm::dvec3 east(-out.y, out.x, 0.0);
  normal = glm::normalize(up - slope.x * east - slope.y * north);
  return grid.Body.ToPosition(place);
}
}
