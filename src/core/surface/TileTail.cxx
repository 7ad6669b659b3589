// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/TileTail.h"

#include <algorithm>
#include <cstddef>

namespace terrain
{
namespace
{
using Node = PyramidNode<float>;

Node Join(const Node& a, const Node& b)
{
  return { std::max(a.Maximum, b.Maximum), std::min(a.Minimum, b.Minimum) };
}

/// Bounds of a cell of the coarsest tile, which has no nodes where it is of level 0.
Node BoundsOfCell(const Tile& tile, int column, int row)
{
  if (column >= tile.Cells.x || row >= tile.Cells.y)
  {
    return Node::Empty();
  }
  const auto at = [column, row](int width)
  { return static_cast<std::size_t>(column) + static_cast<std::size_t>(width) * row; };
  if (!tile.Nodes.empty())
  {
    return tile.Nodes[at(tile.Cells.x)];
  }
  const float* south = &tile.Samples[at(tile.Cells.x + 1)];
  const float* north = south + tile.Cells.x + 1;
  const auto [lowest, highest] = std::minmax({ south[0], south[1], north[0], north[1] });
  return lowest < 0.0F ? Node::Empty() : Node{ highest, lowest };
}
}

//------------------------------------------------------------------------------
std::vector<Node> MakeTileTail(const Tile& top, int tileLevel)
{
  const int side = 1 << tileLevel;
  std::vector<Node> square(static_cast<std::size_t>(side) * side, Node::Empty());
  const auto node = [&square, side](int column, int row) -> Node&
  { return square[static_cast<std::size_t>(column) + static_cast<std::size_t>(side) * row]; };
  for (int above = 1; above <= tileLevel; ++above)
  {
    const int begin = TileTailColumn(tileLevel, above);
    const int finer = TileTailColumn(tileLevel, above - 1);
    const auto below = [&](int column, int row)
    { return above == 1 ? BoundsOfCell(top, column, row) : node(finer + column, row); };
    for (int row = 0; row < side >> above; ++row)
    {
      for (int column = 0; column < side >> above; ++column)
      {
        node(begin + column, row) =
          Join(Join(below(2 * column, 2 * row), below(2 * column + 1, 2 * row)),
            Join(below(2 * column, 2 * row + 1), below(2 * column + 1, 2 * row + 1)));
      }
    }
  }
  return square;
}
}
