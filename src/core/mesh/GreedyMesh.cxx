// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/GreedyMesh.h"

#include "core/grid/SampleTypes.h"
#include "core/mesh/GreedyTile.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
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
  Samples(const HeightfieldView<T>& view, const ParallelFor& parallelFor)
    : View(view)
    , Cells(std::max<std::int64_t>((view.Width - 1) * (view.Height - 1), 0))
  {
    parallelFor(view.Height - 1,
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
    this->HasHoles = std::find(this->Cells.begin(), this->Cells.end(), 0) != this->Cells.end();
  }

  bool HasCell(std::int64_t i, std::int64_t j) const
  {
    return this->Cells[i + (this->View.Width - 1) * j] != 0;
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
    return !this->HasHoles || this->CountCells(i, j).first > 0;
  }

  bool IsOnHole(std::int64_t i, std::int64_t j) const
  {
    if (!this->HasHoles)
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
  std::vector<unsigned char> Cells;
  bool HasHoles = false;
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
  TileBuilder(const HeightfieldView<T>& view, const GreedyMeshOptions& options, double tolerance,
    const ParallelFor& parallelFor)
    : At(view, parallelFor)
    , Tolerance(tolerance)
    , Columns(view.Width, options.CellsPerTile)
    , Rows(view.Height, options.CellsPerTile)
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

  bool IsOnLine(const glm::ivec2& vertex) const
  {
    return std::binary_search(
             this->Columns.Positions.begin(), this->Columns.Positions.end(), vertex.x) ||
      std::binary_search(this->Rows.Positions.begin(), this->Rows.Positions.end(), vertex.y);
  }

private:
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
};

std::uint64_t KeyOf(const glm::ivec2& sample)
{
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(sample.y)) << 32) |
    static_cast<std::uint32_t>(sample.x);
}

/// Appends the mesh of a tile; vertices on lines between tiles are shared with those that came
/// before.
template <typename T>
void Append(const TileBuilder<T>& tiles, const GridMesh& part,
  std::unordered_map<std::uint64_t, std::int32_t>& shared, GridMesh& mesh)
{
  std::vector<std::int32_t> numbers(part.Vertices.size(), -1);
  for (const std::int32_t corner : part.Triangles)
  {
    std::int32_t& number = numbers[corner];
    if (number < 0)
    {
      const glm::ivec2& sample = part.Vertices[corner];
      number = static_cast<std::int32_t>(mesh.Vertices.size());
      if (tiles.IsOnLine(sample))
      {
        number = shared.emplace(KeyOf(sample), number).first->second;
      }
      if (number == static_cast<std::int32_t>(mesh.Vertices.size()))
      {
        mesh.Vertices.push_back(sample);
      }
    }
    mesh.Triangles.push_back(number);
  }
}

/// Memory for all parts, so that it need not grow by doubling.
void ReserveFor(const std::vector<GridMesh>& parts, GridMesh& mesh)
{
  std::size_t vertices = 0;
  std::size_t corners = 0;
  for (const GridMesh& part : parts)
  {
    vertices += part.Vertices.size();
    corners += part.Triangles.size();
  }
  mesh.Vertices.reserve(vertices);
  mesh.Triangles.reserve(corners);
}

template <typename T>
double LargestHeight(const HeightfieldView<T>& view)
{
  double largest = 0.0;
  for (std::int64_t j = 0; j < view.Height; ++j)
  {
    for (std::int64_t i = 0; i < view.Width; ++i)
    {
      const std::int64_t index = view.Index(i, j);
      if (view.IsValid(index))
      {
        largest = std::max(largest, std::abs(static_cast<double>(view.Samples[index])));
      }
    }
  }
  return largest;
}
}

//--------------------------------------------------------------------------------------------------
template <typename T>
GridMesh BuildGreedyMesh(
  const HeightfieldView<T>& view, const GreedyMeshOptions& options, const ParallelFor& parallelFor)
{
  GridMesh mesh;
  if (view.Width < 2 || view.Height < 2)
  {
    return mesh;
  }
  GreedyMeshOptions used = options;
  if (options.CellsPerTile == 0)
  {
    used.CellsPerTile = kFewTileCells;
    mesh = BuildGreedyMesh(view, used, parallelFor);
    const std::int64_t tiles =
      TileLines(view.Width, kFewTileCells).Tiles() * TileLines(view.Height, kFewTileCells).Tiles();
    if (tiles == 1 || static_cast<std::int64_t>(mesh.Vertices.size()) >= kFewTileVertices * tiles)
    {
      return mesh;
    }
    used.CellsPerTile = kManyTileCells;
  }
  used.CellsPerTile = std::clamp(used.CellsPerTile, 1, kMostTileCells);
  mesh = GridMesh();
  const double slack = kMeshErrorSlack * LargestHeight(view);
  const double tolerance = std::max(slack, options.MaximumError - slack);
  TileBuilder<T> tiles(view, used, tolerance, parallelFor);
  tiles.MakeBorders(parallelFor);
  std::vector<GridMesh> parts(tiles.NumberOfTiles());
  parallelFor(tiles.NumberOfTiles(),
    [&tiles, &parts](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t tile = begin; tile < end; ++tile)
      {
        parts[tile] = tiles.Build(tile);
      }
    });
  ReserveFor(parts, mesh);
  std::unordered_map<std::uint64_t, std::int32_t> shared;
  for (GridMesh& part : parts)
  {
    Append(tiles, part, shared, mesh);
    part = GridMesh();
  }
  return mesh;
}

namespace
{
/// > 0 if three points are counter-clockwise: twice their area.
double Cross(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r)
{
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Height of the plane through three points at a position.
double HeightOnPlane(const glm::dvec3* points, const glm::dvec2& p)
{
  const double u = Cross(points[1], points[2], p);
  const double v = Cross(points[2], points[0], p);
  const double w = Cross(points[0], points[1], p);
  return (u * points[0].z + v * points[1].z + w * points[2].z) /
    Cross(points[0], points[1], points[2]);
}

/// Largest vertical distance of the samples on a triangle, whose samples are marked as covered.
template <typename T>
double CompareTriangle(const HeightfieldView<T>& view, const glm::ivec2* corners,
  const VertexRounding& rounding, std::vector<std::atomic<bool>>& covered)
{
  glm::dvec3 points[3];
  for (int k = 0; k < 3; ++k)
  {
    points[k] = { corners[k], view.At(corners[k].x, corners[k].y) };
    points[k] = rounding ? rounding(points[k]) : points[k];
  }
  const glm::ivec2 low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
  const glm::ivec2 high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
  double largest = 0.0;
  for (int y = low.y; y <= high.y; ++y)
  {
    for (int x = low.x; x <= high.x; ++x)
    {
      const glm::dvec2 p(x, y);
      if (Cross(corners[1], corners[2], p) >= 0.0 && Cross(corners[2], corners[0], p) >= 0.0 &&
        Cross(corners[0], corners[1], p) >= 0.0)
      {
        covered[x + view.Width * y].store(true, std::memory_order_relaxed);
        largest = std::max(largest, std::abs(HeightOnPlane(points, p) - view.At(x, y)));
      }
    }
  }
  return largest;
}
}

template <typename T>
double FindMeshError(const HeightfieldView<T>& view, const GridMesh& mesh,
  const ParallelFor& parallelFor, const VertexRounding& rounding)
{
  std::vector<std::atomic<bool>> covered(view.Width * view.Height);
  std::mutex mutex;
  double largest = 0.0;
  parallelFor(static_cast<std::int64_t>(mesh.Triangles.size() / 3),
    [&](std::int64_t begin, std::int64_t end)
    {
      double ofRange = 0.0;
      for (std::int64_t k = 3 * begin; k < 3 * end; k += 3)
      {
        const glm::ivec2 corners[3] = { mesh.Vertices[mesh.Triangles[k]],
          mesh.Vertices[mesh.Triangles[k + 1]], mesh.Vertices[mesh.Triangles[k + 2]] };
        ofRange = std::max(ofRange, CompareTriangle(view, corners, rounding, covered));
      }
      const std::lock_guard<std::mutex> lock(mutex);
      largest = std::max(largest, ofRange);
    });
  const Samples<T> samples(view, parallelFor);
  for (std::int64_t j = 0; j < view.Height; ++j)
  {
    for (std::int64_t i = 0; i < view.Width; ++i)
    {
      if (!covered[i + view.Width * j] && samples.CountCells(i, j).first > 0)
      {
        return std::numeric_limits<double>::infinity();
      }
    }
  }
  return largest;
}

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
    const HeightfieldView<T>&, const GreedyMeshOptions&, const ParallelFor&);                      \
  template double FindMeshError(                                                                   \
    const HeightfieldView<T>&, const GridMesh&, const ParallelFor&, const VertexRounding&);
TERRAIN_FOR_EACH_SAMPLE_TYPE(TERRAIN_INSTANTIATE)
#undef TERRAIN_INSTANTIATE
}
