// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/HierarchyBands.h"

#include "core/grid/Heightfield.h"
#include "core/strips/HierarchyNesting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terrain
{
namespace
{
/// Tiles that cover the vertices of all pairs finer than the tiles, along one axis.
std::int64_t TilesFor(const HierarchyLayout& layout, int axis, int side)
{
  std::int64_t last = 0;
  for (int pair = 0; pair < layout.Pairs(); ++pair)
  {
    if (layout.Step(pair) < side)
    {
      last = std::max(last, (layout.Count(pair, axis) - 1) * layout.Step(pair));
    }
  }
  return (last + side - 1) / side;
}

/// Corners of tiles along an axis of `size` samples, the last one moved onto the last sample.
std::int64_t LatticeSize(std::int64_t size, int side)
{
  return (size - 1 + side - 1) / side + 1;
}

float Slope(float low, float middle, float high, double spacing)
{
  if (std::isfinite(low) && std::isfinite(high))
  {
    return static_cast<float>((static_cast<double>(high) - low) / (2.0 * spacing));
  }
  if (!std::isfinite(middle))
  {
    return 0.0f;
  }
  const double difference = std::isfinite(high) ? static_cast<double>(high) - middle
    : std::isfinite(low)                        ? static_cast<double>(middle) - low
                                                : 0.0;
  return static_cast<float>(difference / spacing);
}
}

HierarchyBands::HierarchyBands(
  HierarchyTarget& target, const HeightRows& rows, const ParallelFor& parallelFor)
  : Target(target)
  , Layout(*target.Layout)
  , Source(rows)
  , Parallel(parallelFor)
  , Side(static_cast<int>(std::min<std::int64_t>(HierarchyTile::MaximumSide, Layout.Cells())))
  , BandCount(TilesFor(Layout, 1, Side))
  , Tiles(static_cast<std::size_t>(TilesFor(Layout, 0, Side)), Tile(Side))
  , LowRow(Layout.Height())
  , LatticeColumns(LatticeSize(Layout.Width(), Side))
  , Lattice(static_cast<std::size_t>(LatticeColumns * LatticeSize(Layout.Height(), Side)),
      std::numeric_limits<float>::quiet_NaN())
  , LatticeGradients(Lattice.size())
{
}

std::string HierarchyBands::Process(std::int64_t band)
{
  std::string error = this->LoadRows(band);
  if (!error.empty())
  {
    return error;
  }
  const auto tiles = static_cast<std::int64_t>(this->Tiles.size());
  this->Parallel(tiles,
    [this, band](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t column = begin; column < end; ++column)
      {
        this->PrepareTile(band, column);
      }
    });
  this->KeepLattice(band);
  this->Parallel(tiles,
    [this, band](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t column = begin; column < end; ++column)
      {
        this->WriteTile(band, column);
      }
    });
  for (Tile& tile : this->Tiles)
  {
    for (int x = 0; x <= this->Side; ++x)
    {
      tile.NorthErrors[x] = tile.Errors.ErrorAt(x, 0);
    }
    HierarchySummary& summary = this->Target.Summary;
    summary.HasHoles = summary.HasHoles || tile.HasNoData;
    if (tile.HasData)
    {
      const bool first = summary.MinimumHeight > summary.MaximumHeight;
      summary.MinimumHeight = first ? tile.Minimum : std::min(summary.MinimumHeight, tile.Minimum);
      summary.MaximumHeight = first ? tile.Maximum : std::max(summary.MaximumHeight, tile.Maximum);
    }
  }
  return {};
}

/// Makes Rows hold the band's rows and one more to the north and south.
std::string HierarchyBands::LoadRows(std::int64_t band)
{
  const std::int64_t last = this->Layout.Height() - 1;
  const std::int64_t width = this->Layout.Width();
  const std::int64_t high = std::min(last, (band + 1) * this->Side + 1);
  const std::int64_t low =
    std::max<std::int64_t>(0, std::min(band * this->Side - 1, this->Layout.Height() - 2));
  const std::int64_t kept = std::max<std::int64_t>(0, high + 1 - this->LowRow);
  std::vector<float> rows(static_cast<std::size_t>((high - low + 1) * width));
  std::copy_n(this->Rows.begin(), kept * width, rows.end() - kept * width);
  this->Rows.swap(rows);
  const std::int64_t fresh = high - low + 1 - kept;
  this->LowRow = low;
  std::string error = fresh > 0 ? this->Source(low, fresh, this->Rows.data()) : std::string();
  std::replace_if(
    this->Rows.begin(), this->Rows.begin() + fresh * width,
    [](float height) { return !IsHeight(height); }, std::numeric_limits<float>::quiet_NaN());
  return error;
}

/// Copies the tile's heights and computes its errors.
void HierarchyBands::PrepareTile(std::int64_t band, std::int64_t column)
{
  Tile& tile = this->Tiles[column];
  const std::int64_t left = column * this->Side;
  const std::int64_t bottom = band * this->Side;
  tile.HasData = false;
  tile.HasNoData = false;
  tile.Filling = 0.0f;
  for (int y = -1; y <= this->Side + 1; ++y)
  {
    const std::int64_t row = std::min(bottom + y, this->Layout.Height() - 1);
    for (int x = -1; x <= this->Side + 1; ++x)
    {
      const std::int64_t i = std::min(left + x, this->Layout.Width() - 1);
      const float height =
        i < 0 || row < 0 ? std::numeric_limits<float>::quiet_NaN() : this->SampleAt(i, row);
      tile.Errors.HeightAt(x, y) = height;
    }
  }
  for (int y = 0; y <= this->Side; ++y)
  {
    for (int x = 0; x <= this->Side; ++x)
    {
      const float height = tile.Errors.HeightAt(x, y);
      if (!std::isfinite(height))
      {
        tile.HasNoData = true;
        continue;
      }
      tile.Minimum = tile.HasData ? std::min(tile.Minimum, height) : height;
      tile.Maximum = tile.HasData ? std::max(tile.Maximum, height) : height;
      tile.Filling = tile.HasData ? tile.Filling : height;
      tile.HasData = true;
    }
  }
  const int parent = static_cast<int>((column + band) & 1);
  tile.Errors.ComputeErrors(std::max<std::int64_t>(0, this->Layout.Width() - 1 - left),
    std::max<std::int64_t>(0, this->Layout.Height() - 1 - bottom), parent == 0);
}

/// Keeps heights and slopes at the northern corners of the band's tiles, and in the last band at
/// the southern ones.
void HierarchyBands::KeepLattice(std::int64_t band)
{
  const auto keep = [this](std::int64_t latticeRow)
  {
    const std::int64_t row = std::min(latticeRow * this->Side, this->Layout.Height() - 1);
    for (std::int64_t i = 0; i < this->LatticeColumns; ++i)
    {
      const std::int64_t x = std::min(i * this->Side, this->Layout.Width() - 1);
      this->Lattice[latticeRow * this->LatticeColumns + i] = this->SampleAt(x, row);
      this->LatticeGradients[latticeRow * this->LatticeColumns + i] = this->GradientAt(x, row);
    }
  };
  if (band * this->Side < this->Layout.Height() - 1)
  {
    keep(band + 1);
  }
  if (band == 0)
  {
    keep(0);
  }
}

void HierarchyBands::WriteTile(std::int64_t band, std::int64_t column)
{
  for (int y = band == 0 ? 0 : 1; y <= this->Side; ++y)
  {
    for (int x = column == 0 ? 0 : 1; x <= this->Side; ++x)
    {
      this->WriteVertex(band, column, x, y);
    }
  }
}

/// Writes the vertex at local (x, y) of a tile, unless it is a corner of the tile or unreachable.
void HierarchyBands::WriteVertex(std::int64_t band, std::int64_t column, int x, int y)
{
  const std::int64_t gx = column * this->Side + x;
  const std::int64_t gy = band * this->Side + y;
  const int inside = (x | y) & (this->Side - 1);
  const int pair = this->Layout.PairOf(inside, inside);
  const int shift = inside == 0 ? 0 : this->Layout.Shift(pair);
  if (inside == 0 || (gx >> shift) >= this->Layout.Count(pair, 0) ||
    (gy >> shift) >= this->Layout.Count(pair, 1))
  {
    return;
  }
  const Tile& tile = this->Tiles[column];
  std::int32_t error = tile.Errors.ErrorAt(x, y);
  if (x == this->Side && column + 1 < static_cast<std::int64_t>(this->Tiles.size()))
  {
    error = std::max(error, this->Tiles[column + 1].Errors.ErrorAt(0, y));
  }
  if (y == this->Side)
  {
    error = std::max(error, tile.NorthErrors[x]);
  }
  const std::int64_t index = this->Layout.Index(pair, gx >> shift, gy >> shift);
  HierarchyRecord& record = this->Target.Records[index];
  const float height = tile.Errors.HeightAt(x, y);
  record.Height = std::isfinite(height) ? height : tile.Filling;
  const glm::i64vec2 sample = this->Layout.Sample(gx, gy);
  this->Target.Gradients[index] = this->GradientAt(sample.x, sample.y);
  if (pair == this->Layout.Pairs() - 1 && ((x & y) & 1) == 0)
  {
    this->WriteLeaf(record, tile, x, y, { gx, gy }, error);
    return;
  }
  record.SetError(BitsFloat(static_cast<std::uint32_t>(error)));
}

/// Error of a vertex of the finest depth: the one that its square has, where that is known.
float HierarchyBands::LeafError(const HierarchyRecord& record, const Tile& tile,
  const glm::ivec2& at, const glm::i64vec2& position, const DiamondState& state, float peak,
  float error) const
{
  const int dx = at.x & 1;
  const int dy = at.y & 1;
  if (!state.HasSurface)
  {
    return 0.0f;
  }
  if (state.IsMixed)
  {
    const glm::dvec2 spacing = this->Target.Geometry.Spacing;
    return static_cast<float>(2.0 * (dx != 0 ? spacing.x : spacing.y));
  }
  if (std::isfinite(error))
  {
    return error;
  }
  // One triangle has no surface, or the raster ends here: the other triangle's own bound.
  const float ends = 0.5f *
    (tile.Errors.HeightAt(at.x - dx, at.y - dy) + tile.Errors.HeightAt(at.x + dx, at.y + dy));
  const bool across = this->Layout.IsAcrossBorder(this->Layout.Pairs() - 1, position.x, position.y);
  const bool isLast =
    !(position.x + dx < this->Layout.Width() && position.y + dy < this->Layout.Height());
  return peak + (across && isLast ? 0.0f : std::abs(record.Height - ends));
}

/// Completes a vertex of the finest depth: its four half cells tell everything.
void HierarchyBands::WriteLeaf(HierarchyRecord& record, const Tile& tile, int x, int y,
  glm::i64vec2 position, std::int32_t errorBits)
{
  // South-west, south-east, north-east, north-west: the cell's corner, the diamond's two corners.
  static constexpr int cells[4][2] = { { -1, -1 }, { 0, -1 }, { 0, 0 }, { -1, 0 } };
  std::uint32_t drawn = 0;
  std::uint32_t outside = 0;
  double radius2 = 0.0;
  float peak = 0.0f;
  for (int bit = 0; bit < 4; ++bit)
  {
    const int cx = x + cells[bit][0];
    const int cy = y + cells[bit][1];
    const std::int64_t gx = position.x + cells[bit][0];
    const std::int64_t gy = position.y + cells[bit][1];
    if (gx < 0 || gy < 0 || gx >= this->Layout.Width() - 1 || gy >= this->Layout.Height() - 1)
    {
      outside |= 1u << bit;
      continue;
    }
    const HierarchyTile& heights = tile.Errors;
    const float twist = (heights.HeightAt(cx, cy) + heights.HeightAt(cx + 1, cy + 1)) -
      (heights.HeightAt(cx + 1, cy) + heights.HeightAt(cx, cy + 1));
    if (!std::isfinite(twist))
    {
      continue;
    }
    drawn |= 1u << bit;
    peak = std::max(peak, 0.25f * std::abs(twist));
    const double east = static_cast<double>(heights.HeightAt(2 * cx + 1 - x, y)) - record.Height;
    const double north = static_cast<double>(heights.HeightAt(x, 2 * cy + 1 - y)) - record.Height;
    const glm::dvec2 spacing = this->Target.Geometry.Spacing;
    radius2 = std::max(
      { radius2, spacing.x * spacing.x + east * east, spacing.y * spacing.y + north * north });
  }
  const int direction = (x & 1) != 0 ? 2 : 0;
  const DiamondState state(direction, false, drawn, outside);
  record.SetError(this->LeafError(record, tile, { x, y }, position, state, peak,
    BitsFloat(static_cast<std::uint32_t>(errorBits))));
  record.SetRadius(static_cast<float>((std::sqrt(radius2) + peak) * (1.0 + kRadiusSlack)));
  record.SetDrawn(drawn);
  record.SetRough(state.IsMixed ||
    (state.HasSurface &&
      this->Layout.IsAcrossBorder(this->Layout.Pairs() - 1, position.x, position.y)));
}

HierarchyGradient HierarchyBands::GradientAt(std::int64_t x, std::int64_t y) const
{
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  const std::int64_t lastX = this->Layout.Width() - 1;
  const std::int64_t lastY = this->Layout.Height() - 1;
  const float middle = this->SampleAt(x, y);
  const std::int64_t highRow =
    this->LowRow + static_cast<std::int64_t>(this->Rows.size()) / this->Layout.Width() - 1;
  HierarchyGradient gradient;
  gradient.Set(Slope(x > 0 ? this->SampleAt(x - 1, y) : none, middle,
                 x < lastX ? this->SampleAt(x + 1, y) : none, this->Target.Geometry.Spacing.x),
    Slope(y > this->LowRow ? this->SampleAt(x, y - 1) : none, middle,
      y < std::min(lastY, highRow) ? this->SampleAt(x, y + 1) : none,
      this->Target.Geometry.Spacing.y));
  return gradient;
}

std::int64_t HierarchyBands::LatticeIndex(std::int64_t x, std::int64_t y) const
{
  const std::int64_t rows = static_cast<std::int64_t>(this->Lattice.size()) / this->LatticeColumns;
  return std::min(y / this->Side, rows - 1) * this->LatticeColumns +
    std::min(x / this->Side, this->LatticeColumns - 1);
}

void HierarchyBands::Finish()
{
  HierarchySummary& summary = this->Target.Summary;
  const bool hasData = summary.MinimumHeight <= summary.MaximumHeight;
  const float filling = hasData ? summary.MinimumHeight : 0.0f;
  for (float& height : this->Lattice)
  {
    height = std::isfinite(height) ? height : filling;
  }
  for (int pair = 0; pair < this->Layout.Pairs() && this->Layout.Step(pair) >= this->Side; ++pair)
  {
    const std::int64_t step = this->Layout.Step(pair);
    for (std::int64_t y = 0; y < this->Layout.Count(pair, 1); ++y)
    {
      // In even rows only the odd columns belong to this pair.
      const std::int64_t skip = (y & 1) ^ 1;
      for (std::int64_t x = skip; x < this->Layout.Count(pair, 0); x += 1 + skip)
      {
        const std::int64_t index = this->Layout.Index(pair, x, y);
        const std::int64_t node = this->LatticeIndex(x * step, y * step);
        this->Target.Records[index].Height = this->Lattice[node];
        this->Target.Records[index].SetError(std::numeric_limits<float>::infinity());
        this->Target.Gradients[index] = this->LatticeGradients[node];
      }
    }
  }
  for (int corner = 0; corner < 4; ++corner)
  {
    const std::int64_t cells = this->Layout.Cells();
    const std::int64_t node =
      this->LatticeIndex((corner & 1) != 0 ? cells : 0, (corner & 2) != 0 ? cells : 0);
    summary.Corners[corner] = this->Lattice[node];
    summary.CornerGradients[corner] = this->LatticeGradients[node];
  }
}
}
