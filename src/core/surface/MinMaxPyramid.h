// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The min-max pyramid over the cells of a heightfield: bounds of the bilinear surface over squares
 * of 2^k x 2^k cells, by which rays skip what they cannot meet.
 *
 * Source: S. Park, K. Oh, "GPU-only Terrain Rendering for Walk-through": the bounding map of its
 * section 5 is level 0 here, its pyramid of maxima (section 4) the levels above. Departures: minima
 * too, so that the surface is met from below; any size of grid; cells without data.
 *
 * Node (x, y) of level k covers the cells x * 2^k <= i < (x + 1) * 2^k, y likewise. Level 0 is not
 * stored: its nodes are single cells, whose four samples a ray needs anyway (see CellExtremes()).
 * Stored are the levels from 1 to LevelCount(), in the sizes of a mip-mapped texture, so that a GPU
 * takes level k as mip level k - 1:
 *
 *   size of level 1      ceil(cells / 2)
 *   size of level k + 1  max(1, floor(size of level k / 2)); the top level is 1 x 1
 *
 * The last column and row of a level also answer for the node that the rounding down cuts off: node
 * x is stored at min(x, size - 1), as the union of the nodes that share the place. A bound may thus
 * be wider than it must be there, never narrower. Memory: 2/3 of the heights' own, and up to a
 * hundredth of that between levels of unusual sizes.
 */
#ifndef terrain_MinMaxPyramid_h
#define terrain_MinMaxPyramid_h

#include "core/grid/Heightfield.h"
#include "core/grid/LargeArray.h"
#include "core/grid/ParallelFor.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace terrain
{
/// Highest and lowest sample of the cells of a node that have a surface; maximum < minimum if none.
template <typename T>
struct PyramidNode
{
  T Maximum;
  T Minimum;

  /// The node without surface: no height lies between its bounds.
  static constexpr PyramidNode Empty()
  {
    return { std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max() };
  }
  bool IsEmpty() const
  {
    return this->Maximum < this->Minimum;
  }
};

/// First <= position < End in both directions; empty if End <= First in one.
struct GridRectangle
{
  glm::ivec2 First{ 0, 0 };
  glm::ivec2 End{ 0, 0 };

  bool IsEmpty() const
  {
    return this->End.x <= this->First.x || this->End.y <= this->First.y;
  }
};

/// Where the levels begin in the array of all nodes, from the top down: by a formula that shaders
/// evaluate faster than they look up a table. Twin: terrainLevelBegin() in
/// shaders/vtkTerrainPyramid.glsl.
struct PyramidLayout
{
  std::int64_t Quarters = 0; ///< nodes above the first level, where levels shrink both ways
  std::int64_t Halves = 0;   ///< more of them, where levels shrink one way
  int Top = 0;

  /// The shortest for levels of these sizes, from level 1 up.
  static PyramidLayout Of(const std::vector<glm::ivec2>& sizes);
  /// 1 <= level <= Top.
  std::int64_t Begin(int level) const
  {
    return (this->Quarters >> (2 * level - 2)) + (this->Halves >> (level - 1)) +
      2 * std::int64_t{ this->Top - level };
  }
};

/// T is the type of the samples: any arithmetic type, or the texels of HeightCodes.h.
template <typename T>
class MinMaxPyramid
{
public:
  using Node = PyramidNode<T>;

  /// Builds all levels; a grid of less than 2 x 2 samples has none. O(samples), in parallel.
  void Build(const HeightfieldView<T>& view, const ParallelFor& parallelFor);

  /**
   * Brings the pyramid up to date after the samples of a rectangle have changed; the view must have
   * the size given to Build(). Touches only the nodes above the samples and returns, for the levels
   * from 1 up, the rectangle of nodes that was written. The rectangle is clipped to the grid.
   */
  std::vector<GridRectangle> Update(
    const HeightfieldView<T>& view, const GridRectangle& samples, const ParallelFor& parallelFor);

  /// The nodes of another pyramid, each converted.
  template <typename U, typename Convert>
  void BuildFrom(const MinMaxPyramid<U>& other, Convert&& convert)
  {
    this->Cells = other.CellCount();
    this->Layout = other.GetLayout();
    this->NodeCount = other.NumberOfNodes();
    this->Sizes.clear();
    this->Nodes = MakeLargeArray<Node>(this->NodeCount);
    for (int level = 1; level <= other.LevelCount(); ++level)
    {
      const glm::i64vec2 size(other.LevelSize(level));
      this->Sizes.push_back(other.LevelSize(level));
      std::transform(other.LevelNodes(level), other.LevelNodes(level) + size.x * size.y,
        this->WritableNodes(level), convert);
    }
  }

  /// Number of stored levels, hence the top level; 0 without cells.
  int LevelCount() const
  {
    return static_cast<int>(this->Sizes.size());
  }
  /// Cells of the grid, (W-1) x (H-1).
  glm::ivec2 CellCount() const
  {
    return this->Cells;
  }
  /// Stored nodes of a level; 1 <= level <= LevelCount().
  glm::ivec2 LevelSize(int level) const
  {
    return this->Sizes[static_cast<std::size_t>(level) - 1];
  }
  /// The nodes of a level row by row, maximum and minimum interleaved; 1 <= level <= LevelCount().
  const Node* LevelNodes(int level) const
  {
    return this->Nodes.get() + this->Layout.Begin(level);
  }
  /// The array of all nodes, of which some between levels are unused, and where levels begin in it.
  const Node* AllNodes() const
  {
    return this->Nodes.get();
  }
  std::size_t NumberOfNodes() const
  {
    return this->NodeCount;
  }
  const PyramidLayout& GetLayout() const
  {
    return this->Layout;
  }
  /// Bounds of node (x, y) of a level, 0 <= x < ceil(cells / 2^level); 1 <= level <= LevelCount().
  const Node& At(glm::ivec2 node, int level) const
  {
    const glm::ivec2 size = this->LevelSize(level);
    const glm::ivec2 texel = glm::min(node, size - 1);
    return this->LevelNodes(level)[texel.x + static_cast<std::int64_t>(size.x) * texel.y];
  }
  /// Bytes of all stored levels.
  std::size_t MemorySize() const
  {
    return this->NodeCount * sizeof(Node);
  }

  /**
   * Level 0, the bounding map: bounds of the cells (first .. end-1, row) of a view, written to
   * nodes[0 .. end-first-1]. Cells that touch a sample without data are empty.
   */
  static void CellExtremes(const HeightfieldView<T>& view, std::int64_t first, std::int64_t end,
    std::int64_t row, Node* nodes);

private:
  void BuildFirstLevel(
    const HeightfieldView<T>& view, const GridRectangle& nodes, const ParallelFor&);
  void BuildLevel(int level, const GridRectangle& nodes, const ParallelFor&);
  Node* WritableNodes(int level)
  {
    return this->Nodes.get() + this->Layout.Begin(level);
  }

  glm::ivec2 Cells{ 0, 0 };
  std::vector<glm::ivec2> Sizes;
  PyramidLayout Layout;
  LargeArray<Node> Nodes;
  std::size_t NodeCount = 0;
};
}

#endif
