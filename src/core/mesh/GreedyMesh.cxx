// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/GreedyMesh.h"

#include "core/grid/SampleTypes.h"
#include "core/mesh/GreedyTile.h"
#include "core/mesh/HeightExtremes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace terrain
{
namespace
{
constexpr double kNothingAsked = std::numeric_limits<double>::quiet_NaN();

/// What the cells around samples say, and heights where something is asked of the mesh.
template <typename T>
class Samples
{
public:
  /// isComplete: whether all samples have heights.
  Samples(const HeightfieldView<T>& view, bool isComplete, const ParallelFor& parallelFor)
    : View(view)
    , Cells(isComplete ? 0 : (view.Width - 1) * (view.Height - 1))
  {
    parallelFor(isComplete ? 0 : view.Height - 1,
      [this](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t j = begin; j < end; ++j)
        {
          for (std::int64_t i = 0; i < this->View.Width - 1; ++i)
          {
            this->Cells[i + (this->View.Width - 1) * j] = this->View.IsCellValid(i, j);
          }
        }
      });
  }

  bool HasCell(std::int64_t i, std::int64_t j) const
  {
    return this->Cells.empty() || this->Cells[i + (this->View.Width - 1) * j] != 0;
  }

  /// Number of cells with a surface around sample (i, j), and of those without one.
  std::pair<int, int> CountCells(std::int64_t i, std::int64_t j) const
  {
    int with = 0;
    int without = 0;
    for (std::int64_t y = std::max<std::int64_t>(j - 1, 0); y <= j && y < this->View.Height - 1;
         ++y)
    {
      for (std::int64_t x = std::max<std::int64_t>(i - 1, 0); x <= i && x < this->View.Width - 1;
           ++x)
      {
        ++(this->HasCell(x, y) ? with : without);
      }
    }
    return { with, without };
  }

  /// True if something is asked of the mesh at the sample.
  bool IsAsked(std::int64_t i, std::int64_t j) const
  {
    return this->Cells.empty() || this->CountCells(i, j).first > 0;
  }

  bool IsOnHole(std::int64_t i, std::int64_t j) const
  {
    if (this->Cells.empty())
    {
      return false;
    }
    const auto [with, without] = this->CountCells(i, j);
    return with > 0 && without > 0;
  }

  /// The height where something is asked, else NaN.
  double At(std::int64_t i, std::int64_t j) const
  {
    return this->IsAsked(i, j) ? this->View.At(i, j) : kNothingAsked;
  }

  const HeightfieldView<T>& View;

private:
  std::vector<unsigned char> Cells; ///< empty: all have a surface
};

/// Which samples of a line become vertices: its ends, what is kept already, and the worst sample
/// between two of them until none is off by more than the tolerance.
void SimplifyLine(const std::vector<double>& heights, double tolerance, std::vector<char>& kept)
{
  const auto count = static_cast<std::int64_t>(heights.size());
  kept.front() = kept.back() = 1;
  std::vector<std::pair<std::int64_t, std::int64_t>> parts;
  for (std::int64_t begin = 0, end = 1; end < count; ++end)
  {
    if (kept[end])
    {
      parts.emplace_back(begin, end);
      begin = end;
    }
  }
  while (!parts.empty())
  {
    const auto [begin, end] = parts.back();
    parts.pop_back();
    const double slope = (heights[end] - heights[begin]) / static_cast<double>(end - begin);
    std::int64_t worst = -1;
    double largest = tolerance;
    for (std::int64_t k = begin + 1; k < end; ++k)
    {
      const double error =
        std::abs(heights[k] - (heights[begin] + slope * static_cast<double>(k - begin)));
      if (error > largest)
      {
        largest = error;
        worst = k;
      }
    }
    if (worst >= 0)
    {
      kept[worst] = 1;
      parts.emplace_back(begin, worst);
      parts.emplace_back(worst, end);
    }
  }
}

/// Lines between tiles: positions 0, step, 2 step, ..., and the last sample.
struct TileLines
{
  TileLines(std::int64_t samples, std::int64_t step)
  {
    for (std::int64_t at = 0; at < samples - 1; at += step)
    {
      this->Positions.push_back(at);
    }
    this->Positions.push_back(samples - 1);
  }
  std::int64_t Tiles() const
  {
    return static_cast<std::int64_t>(this->Positions.size()) - 1;
  }
  std::vector<std::int64_t> Positions;
};

/// A grid cut into tiles, whose borders are made.
template <typename T>
class TileBuilder
{
public:
  TileBuilder(const HeightfieldView<T>& view, int cellsPerTile, double tolerance, bool isComplete,
    const ParallelFor& parallelFor)
    : At(view, isComplete, parallelFor)
    , Tolerance(tolerance)
    , Columns(view.Width, cellsPerTile)
    , Rows(view.Height, cellsPerTile)
    , NumbersOfColumn(
        this->Columns.Positions.size(), std::vector<std::int32_t>(view.Height, kNoNumber))
    , NumbersOfRow(this->Rows.Positions.size(), std::vector<std::int32_t>(view.Width, kNoNumber))
  {
  }

  std::int64_t NumberOfTiles() const
  {
    return this->Columns.Tiles() * this->Rows.Tiles();
  }

  void MakeBorders(const ParallelFor& parallelFor)
  {
    const auto vertical = static_cast<std::int64_t>(this->Columns.Positions.size());
    const auto horizontal = static_cast<std::int64_t>(this->Rows.Positions.size());
    this->KeptOfColumn.resize(vertical);
    this->KeptOfRow.resize(horizontal);
    parallelFor(vertical + horizontal,
      [this, vertical](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t line = begin; line < end; ++line)
        {
          const bool isColumn = line < vertical;
          this->MakeLine(isColumn, isColumn ? line : line - vertical);
        }
      });
  }

  /// Triangles of a tile as samples of the grid.
  GridMesh Build(std::int64_t tile) const
  {
    const std::int64_t tileX = tile % this->Columns.Tiles();
    const std::int64_t tileY = tile / this->Columns.Tiles();
    const std::int64_t x0 = this->Columns.Positions[tileX];
    const std::int64_t y0 = this->Rows.Positions[tileY];
    const int width = static_cast<int>(this->Columns.Positions[tileX + 1] - x0) + 1;
    const int height = static_cast<int>(this->Rows.Positions[tileY + 1] - y0) + 1;
    std::vector<double> heights(static_cast<std::size_t>(width) * height);
    std::vector<glm::ivec2> fixed;
    for (int y = 0; y < height; ++y)
    {
      const bool isOnRow = y == 0 || y == height - 1;
      for (int x = 0; x < width; ++x)
      {
        heights[x + static_cast<std::size_t>(width) * y] = this->At.At(x0 + x, y0 + y);
        const bool isOnColumn = x == 0 || x == width - 1;
        const bool isVertex = isOnRow ? this->KeptOfRow[tileY + (y > 0)][x0 + x]
          : isOnColumn                ? this->KeptOfColumn[tileX + (x > 0)][y0 + y]
                                      : this->At.IsOnHole(x0 + x, y0 + y);
        if (isVertex)
        {
          fixed.emplace_back(x, y);
        }
      }
    }
    GreedyTile triangulation(width, height, heights);
    SortCoarseFirst(fixed);
    for (const glm::ivec2& position : fixed)
    {
      triangulation.Insert(position);
    }
    triangulation.Refine(this->Tolerance);
    return this->Keep(triangulation, { static_cast<int>(x0), static_cast<int>(y0) });
  }

  /// Appends the mesh of a tile; vertices on lines between tiles are shared with those that came
  /// before.
  void Append(std::int64_t tile, const GridMesh& part, GridMesh& mesh)
  {
    std::vector<std::int32_t> numbers(part.Vertices.size(), kNoNumber);
    for (const std::int32_t corner : part.Triangles)
    {
      std::int32_t& number = numbers[corner];
      if (number == kNoNumber)
      {
        const glm::ivec2& sample = part.Vertices[corner];
        std::int32_t* shared = this->SharedNumber(tile, sample);
        number = shared ? *shared : kNoNumber;
        if (number == kNoNumber)
        {
          number = static_cast<std::int32_t>(mesh.Vertices.size());
          mesh.Vertices.push_back(sample);
        }
        if (shared)
        {
          *shared = number;
        }
      }
      mesh.Triangles.push_back(number);
    }
  }

private:
  static constexpr std::int32_t kNoNumber = -1;

  /// Where the number of a vertex of a tile is kept if it lies on a line; else null.
  std::int32_t* SharedNumber(std::int64_t tile, const glm::ivec2& sample)
  {
    const std::int64_t tileX = tile % this->Columns.Tiles();
    const std::int64_t tileY = tile / this->Columns.Tiles();
    for (std::int64_t side = 0; side < 2; ++side)
    {
      if (sample.x == this->Columns.Positions[tileX + side])
      {
        return &this->NumbersOfColumn[tileX + side][sample.y];
      }
    }
    for (std::int64_t side = 0; side < 2; ++side)
    {
      if (sample.y == this->Rows.Positions[tileY + side])
      {
        return &this->NumbersOfRow[tileY + side][sample.x];
      }
    }
    return nullptr;
  }

  void MakeLine(bool isColumn, std::int64_t line)
  {
    const std::int64_t at = (isColumn ? this->Columns : this->Rows).Positions[line];
    const std::int64_t count = isColumn ? this->At.View.Height : this->At.View.Width;
    std::vector<double> heights(count);
    std::vector<char>& kept = (isColumn ? this->KeptOfColumn : this->KeptOfRow)[line];
    kept.assign(count, 0);
    for (std::int64_t k = 0; k < count; ++k)
    {
      const std::int64_t i = isColumn ? at : k;
      const std::int64_t j = isColumn ? k : at;
      heights[k] = this->At.At(i, j);
      kept[k] = this->At.IsOnHole(i, j);
    }
    for (const std::int64_t crossing : (isColumn ? this->Rows : this->Columns).Positions)
    {
      kept[crossing] = 1;
    }
    SimplifyLine(heights, this->Tolerance, kept);
  }

  /// An order in which each sample lies near the one before, and the first ones spread over the
  /// tile: triangles stay compact while fixed samples come in.
  static void SortCoarseFirst(std::vector<glm::ivec2>& samples)
  {
    const auto key = [](const glm::ivec2& p)
    {
      const unsigned bits = static_cast<unsigned>(p.x) | static_cast<unsigned>(p.y);
      return std::make_pair(-static_cast<int>(bits & (~bits + 1U)), std::make_pair(p.y, p.x));
    };
    std::sort(samples.begin(), samples.end(),
      [&key](const glm::ivec2& a, const glm::ivec2& b) { return key(a) < key(b); });
  }

  /// Those triangles that lie in cells with a surface.
  GridMesh Keep(const GreedyTile& triangulation, const glm::ivec2& origin) const
  {
    GridMesh kept;
    for (const glm::ivec2& vertex : triangulation.GetVertices())
    {
      kept.Vertices.push_back(origin + vertex);
    }
    const std::vector<int>& corners = triangulation.GetTriangles();
    for (std::size_t k = 0; k < corners.size(); k += 3)
    {
      // any cell that the triangle reaches into tells, since none crosses the border of a hole
      const glm::dvec2 middle = glm::dvec2(kept.Vertices[corners[k]] +
                                  kept.Vertices[corners[k + 1]] + kept.Vertices[corners[k + 2]]) /
        3.0;
      if (this->At.HasCell(
            static_cast<std::int64_t>(middle.x), static_cast<std::int64_t>(middle.y)))
      {
        kept.Triangles.insert(kept.Triangles.end(), { corners[k], corners[k + 1], corners[k + 2] });
      }
    }
    return kept;
  }

  Samples<T> At;
  double Tolerance;
  TileLines Columns;
  TileLines Rows;
  std::vector<std::vector<char>> KeptOfColumn;
  std::vector<std::vector<char>> KeptOfRow;
  std::vector<std::vector<std::int32_t>> NumbersOfColumn; ///< of vertices in the mesh of all tiles
  std::vector<std::vector<std::int32_t>> NumbersOfRow;
};

std::uint64_t KeyOf(const glm::ivec2& sample)
{
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(sample.y)) << 32) |
    static_cast<std::uint32_t>(sample.x);
}

/// Memory for parts that bring the share that is done to `done`, and by their number for the rest:
/// a mesh that grows by doubling takes three times as much.
void ReserveFor(const std::vector<GridMesh>& parts, double done, GridMesh& mesh)
{
  std::size_t vertices = mesh.Vertices.size();
  std::size_t corners = mesh.Triangles.size();
  for (const GridMesh& part : parts)
  {
    vertices += part.Vertices.size();
    corners += part.Triangles.size();
  }
  const auto reserve = [done](auto& vector, std::size_t count)
  {
    constexpr double kMargin = 1.1; // of what is not used nothing is touched
    if (vector.capacity() < count)
    {
      const double rest = (1.0 / done - 1.0) * kMargin;
      vector.reserve(count + static_cast<std::size_t>(rest * static_cast<double>(count)));
    }
  };
  reserve(mesh.Vertices, vertices);
  reserve(mesh.Triangles, corners);
}

template <typename T>
GridMesh BuildInTiles(const HeightfieldView<T>& view, int cellsPerTile, double tolerance,
  bool isComplete, const ParallelFor& parallelFor)
{
  // few enough for little memory, enough to keep many threads busy
  constexpr std::int64_t kTilesAtOnce = 256;
  TileBuilder<T> tiles(view, cellsPerTile, tolerance, isComplete, parallelFor);
  tiles.MakeBorders(parallelFor);
  GridMesh mesh;
  const std::int64_t count = tiles.NumberOfTiles();
  for (std::int64_t first = 0; first < count; first += kTilesAtOnce)
  {
    std::vector<GridMesh> parts(std::min(kTilesAtOnce, count - first));
    const auto size = static_cast<std::int64_t>(parts.size());
    parallelFor(size,
      [&tiles, &parts, first](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t k = begin; k < end; ++k)
        {
          parts[k] = tiles.Build(first + k);
        }
      });
    ReserveFor(parts, static_cast<double>(first + size) / static_cast<double>(count), mesh);
    for (std::int64_t k = 0; k < size; ++k)
    {
      tiles.Append(first + k, parts[k], mesh);
    }
  }
  return mesh;
}
}

//--------------------------------------------------------------------------------------------------
template <typename T>
GridMesh BuildGreedyMesh(
  const HeightfieldView<T>& view, const GreedyMeshOptions& options, const ParallelFor& parallelFor)
{
  if (view.Width < 2 || view.Height < 2)
  {
    return {};
  }
  const HeightExtremes extremes = FindHeightExtremes(view, parallelFor);
  const double slack = kMeshErrorSlack * extremes.Height;
  const double tolerance = std::max(slack, options.MaximumError - slack);
  const auto build = [&](int cellsPerTile)
  { return BuildInTiles(view, cellsPerTile, tolerance, extremes.IsComplete, parallelFor); };
  if (options.CellsPerTile != 0)
  {
    return build(std::clamp(options.CellsPerTile, 1, kMostTileCells));
  }
  GridMesh mesh = build(kFewTileCells);
  const std::int64_t tiles =
    TileLines(view.Width, kFewTileCells).Tiles() * TileLines(view.Height, kFewTileCells).Tiles();
  if (tiles > 1 && static_cast<std::int64_t>(mesh.Vertices.size()) < kFewTileVertices * tiles)
  {
    mesh = build(kManyTileCells);
  }
  return mesh;
}

//--------------------------------------------------------------------------------------------------
std::vector<glm::ivec2> FindBorderEdges(const GridMesh& mesh)
{
  std::unordered_map<std::uint64_t, glm::ivec2> open;
  for (std::size_t k = 0; k < mesh.Triangles.size(); ++k)
  {
    const std::size_t next = k % 3 == 2 ? k - 2 : k + 1;
    const glm::ivec2 edge(mesh.Triangles[k], mesh.Triangles[next]);
    if (open.erase(KeyOf({ edge.y, edge.x })) == 0)
    {
      open.emplace(KeyOf(edge), edge);
    }
  }
  std::vector<glm::ivec2> border;
  border.reserve(open.size());
  for (const auto& [key, edge] : open)
  {
    border.push_back(edge);
  }
  std::sort(border.begin(), border.end(),
    [](const glm::ivec2& a, const glm::ivec2& b)
    { return std::make_pair(a.x, a.y) < std::make_pair(b.x, b.y); });
  return border;
}

#define TERRAIN_INSTANTIATE(T)                                                                     \
  template GridMesh BuildGreedyMesh(                                                               \
    const HeightfieldView<T>&, const GreedyMeshOptions&, const ParallelFor&);
TERRAIN_FOR_EACH_SAMPLE_TYPE(TERRAIN_INSTANTIATE)
#undef TERRAIN_INSTANTIATE
}
