// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/MinMaxPyramid.h"

#include <algorithm>
#include <type_traits>

namespace terrain
{
namespace
{
// Bounds of one row of cells, maxima and minima apart: loops over them run in SIMD registers.
template <typename T>
struct CellRow
{
  std::vector<T> Maximum;
  std::vector<T> Minimum;
  // 1 where a sample of the row below, above has no height, else 0; same width as T, see above.
  std::vector<T> InvalidBelow;
  std::vector<T> InvalidAbove;

  explicit CellRow(std::int64_t count)
    : Maximum(static_cast<std::size_t>(count))
    , Minimum(static_cast<std::size_t>(count))
  {
  }
};

// invalid[k] = 1 if sample first + k of a row has no height, else 0: the vector form of IsValid().
template <typename T>
void MarkInvalid(const HeightfieldView<T>& view, std::int64_t first, std::int64_t count,
  std::int64_t row, std::vector<T>& invalid)
{
  invalid.assign(static_cast<std::size_t>(count), T{ 0 });
  const T* samples = view.Samples + view.Index(first, row);
  T* out = invalid.data();
  if constexpr (std::is_floating_point_v<T>)
  {
    for (std::int64_t k = 0; k < count; ++k)
    {
      out[k] = IsHeight(samples[k]) ? T{ 0 } : T{ 1 };
    }
  }
  if (view.HasNoData)
  {
    for (std::int64_t k = 0; k < count; ++k)
    {
      out[k] = samples[k] == view.NoData ? T{ 1 } : out[k];
    }
  }
  if (view.Mask)
  {
    const unsigned char* mask = view.Mask + view.Index(first, row);
    for (std::int64_t k = 0; k < count; ++k)
    {
      out[k] = (mask[k] & view.MaskBits) != 0 ? T{ 1 } : out[k];
    }
  }
}

// Bounds of the cells first .. first+count-1 of a row, from the samples alone.
template <typename T>
void BoundSamples(const HeightfieldView<T>& view, std::int64_t first, std::int64_t count,
  std::int64_t row, CellRow<T>& cells)
{
  const T* below = view.Samples + view.Index(first, row);
  const T* above = below + view.RowStep();
  T* maximum = cells.Maximum.data();
  T* minimum = cells.Minimum.data();
  for (std::int64_t k = 0; k < count; ++k)
  {
    maximum[k] = std::max(std::max(below[k], below[k + 1]), std::max(above[k], above[k + 1]));
    minimum[k] = std::min(std::min(below[k], below[k + 1]), std::min(above[k], above[k + 1]));
  }
}

// Bounds of the cells first .. first+count-1 of a row; cells without surface are empty.
template <typename T>
void BoundCells(const HeightfieldView<T>& view, std::int64_t first, std::int64_t count,
  std::int64_t row, CellRow<T>& cells)
{
  BoundSamples(view, first, count, row, cells);
  if (!std::is_floating_point_v<T> && !view.HasNoData && !view.Mask)
  {
    return;
  }
  MarkInvalid(view, first, count + 1, row, cells.InvalidBelow);
  MarkInvalid(view, first, count + 1, row + 1, cells.InvalidAbove);
  constexpr PyramidNode<T> empty = PyramidNode<T>::Empty();
  const T* below = cells.InvalidBelow.data();
  const T* above = cells.InvalidAbove.data();
  T* maximum = cells.Maximum.data();
  T* minimum = cells.Minimum.data();
  for (std::int64_t k = 0; k < count; ++k)
  {
    const bool valid =
      std::max(std::max(below[k], below[k + 1]), std::max(above[k], above[k + 1])) == T{ 0 };
    maximum[k] = valid ? maximum[k] : empty.Maximum;
    minimum[k] = valid ? minimum[k] : empty.Minimum;
  }
}

// Widens the bounds of one row of cells by those of another.
template <typename T>
void MergeRows(const CellRow<T>& other, std::int64_t count, CellRow<T>& cells)
{
  const T* otherMaximum = other.Maximum.data();
  const T* otherMinimum = other.Minimum.data();
  T* maximum = cells.Maximum.data();
  T* minimum = cells.Minimum.data();
  for (std::int64_t k = 0; k < count; ++k)
  {
    maximum[k] = std::max(maximum[k], otherMaximum[k]);
    minimum[k] = std::min(minimum[k], otherMinimum[k]);
  }
}

template <typename T>
PyramidNode<T> Union(const PyramidNode<T>& a, const PyramidNode<T>& b)
{
  return { std::max(a.Maximum, b.Maximum), std::min(a.Minimum, b.Minimum) };
}

// The children of stored node x of a level, of which `count` are stored, as first and end.
struct ChildRange
{
  int First;
  int End;

  ChildRange(int node, int size, int childSize)
    : First(2 * node)
    , End(node == size - 1 ? childSize : 2 * node + 2)
  {
  }
};
}

namespace
{
std::int64_t CountNodes(const glm::ivec2& size)
{
  return std::int64_t{ size.x } * size.y;
}

// The least Halves with which no level reaches into the one before it.
std::int64_t FindHalves(const std::vector<glm::ivec2>& sizes, std::int64_t quarters)
{
  PyramidLayout layout{ quarters, 0, static_cast<int>(sizes.size()) };
  std::int64_t halves = 0;
  for (int level = 1; level < layout.Top; ++level)
  {
    const std::int64_t room = layout.Begin(level) - layout.Begin(level + 1);
    const std::int64_t missing = CountNodes(sizes[static_cast<std::size_t>(level)]) - room;
    halves = std::max(halves, missing > 0 ? (missing + 1) << level : 0);
  }
  return halves;
}
}

PyramidLayout PyramidLayout::Of(const std::vector<glm::ivec2>& sizes)
{
  const int top = static_cast<int>(sizes.size());
  PyramidLayout best{ 0, FindHalves(sizes, 0), top };
  for (int part = 1; part <= 16; ++part)
  {
    const std::int64_t quarters = (CountNodes(sizes[0]) * part / 16 + 2) / 3;
    const PyramidLayout layout{ quarters, FindHalves(sizes, quarters), top };
    best = layout.Begin(1) < best.Begin(1) ? layout : best;
  }
  return best;
}

template <typename T>
void MinMaxPyramid<T>::CellExtremes(const HeightfieldView<T>& view, std::int64_t first,
  std::int64_t end, std::int64_t row, Node* nodes)
{
  CellRow<T> cells(end - first);
  BoundCells(view, first, end - first, row, cells);
  for (std::size_t k = 0; k < cells.Maximum.size(); ++k)
  {
    nodes[k] = { cells.Maximum[k], cells.Minimum[k] };
  }
}

template <typename T>
void MinMaxPyramid<T>::Build(const HeightfieldView<T>& view, const ParallelFor& parallelFor)
{
  this->Cells = { static_cast<int>(view.Width) - 1, static_cast<int>(view.Height) - 1 };
  this->Sizes.clear();
  this->Layout = PyramidLayout();
  this->NodeCount = 0;
  this->Nodes.reset();
  if (this->Cells.x < 1 || this->Cells.y < 1)
  {
    this->Cells = { 0, 0 };
    return;
  }
  glm::ivec2 size = (this->Cells + 1) / 2;
  for (bool top = false; !top; size = glm::max(size / 2, glm::ivec2(1)))
  {
    this->Sizes.push_back(size);
    top = size.x == 1 && size.y == 1;
  }
  this->Layout = PyramidLayout::Of(this->Sizes);
  const glm::i64vec2 first(this->LevelSize(1));
  this->NodeCount = static_cast<std::size_t>(this->Layout.Begin(1) + first.x * first.y);
  // Left unwritten here: the threads that build the levels touch the memory first.
  this->Nodes = MakeLargeArray<Node>(this->NodeCount);
  this->BuildFirstLevel(view, { { 0, 0 }, this->LevelSize(1) }, parallelFor);
  for (int level = 2; level <= this->LevelCount(); ++level)
  {
    this->BuildLevel(level, { { 0, 0 }, this->LevelSize(level) }, parallelFor);
  }
}

template <typename T>
std::vector<GridRectangle> MinMaxPyramid<T>::Update(
  const HeightfieldView<T>& view, const GridRectangle& samples, const ParallelFor& parallelFor)
{
  std::vector<GridRectangle> written(this->Sizes.size());
  // A sample belongs to the cells on both sides.
  const glm::ivec2 first = glm::max(samples.First - 1, glm::ivec2(0));
  const glm::ivec2 end = glm::min(samples.End, this->Cells);
  if (samples.IsEmpty() || first.x >= end.x || first.y >= end.y)
  {
    return written;
  }
  for (int level = 1; level <= this->LevelCount(); ++level)
  {
    const glm::ivec2 last = this->LevelSize(level) - 1;
    GridRectangle& nodes = written[static_cast<std::size_t>(level) - 1];
    nodes.First = glm::min(first >> level, last);
    nodes.End = glm::min((end - 1) >> level, last) + 1;
    if (level == 1)
    {
      this->BuildFirstLevel(view, nodes, parallelFor);
    }
    else
    {
      this->BuildLevel(level, nodes, parallelFor);
    }
  }
  return written;
}

template <typename T>
void MinMaxPyramid<T>::BuildFirstLevel(
  const HeightfieldView<T>& view, const GridRectangle& nodes, const ParallelFor& parallelFor)
{
  const std::int64_t width = this->LevelSize(1).x;
  const std::int64_t first = 2 * static_cast<std::int64_t>(nodes.First.x);
  const std::int64_t count = std::min<std::int64_t>(2 * nodes.End.x, this->Cells.x) - first;
  Node* const out = this->WritableNodes(1);
  parallelFor(nodes.End.y - nodes.First.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      // One element more: the last node may have one column of cells only.
      CellRow<T> south(count + 1);
      CellRow<T> north(count + 1);
      for (std::int64_t y = nodes.First.y + begin; y < nodes.First.y + end; ++y)
      {
        BoundCells(view, first, count, 2 * y, south);
        if (2 * y + 1 < this->Cells.y)
        {
          BoundCells(view, first, count, 2 * y + 1, north);
          MergeRows(north, count, south);
        }
        T* maximum = south.Maximum.data();
        T* minimum = south.Minimum.data();
        maximum[count] = maximum[count - 1];
        minimum[count] = minimum[count - 1];
        Node* row = out + width * y + nodes.First.x;
        for (std::int64_t x = 0; x < nodes.End.x - nodes.First.x; ++x)
        {
          row[x].Maximum = std::max(maximum[2 * x], maximum[2 * x + 1]);
          row[x].Minimum = std::min(minimum[2 * x], minimum[2 * x + 1]);
        }
      }
    });
}

template <typename T>
void MinMaxPyramid<T>::BuildLevel(
  int level, const GridRectangle& nodes, const ParallelFor& parallelFor)
{
  const glm::ivec2 size = this->LevelSize(level);
  const glm::ivec2 childSize = this->LevelSize(level - 1);
  const Node* const children = this->LevelNodes(level - 1);
  Node* const out = this->WritableNodes(level);
  parallelFor(nodes.End.y - nodes.First.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (int y = nodes.First.y + static_cast<int>(begin); y < nodes.First.y + end; ++y)
      {
        const ChildRange rows(y, size.y, childSize.y);
        for (int x = nodes.First.x; x < nodes.End.x; ++x)
        {
          const ChildRange columns(x, size.x, childSize.x);
          Node node = Node::Empty();
          for (int j = rows.First; j < rows.End; ++j)
          {
            const Node* row = children + static_cast<std::int64_t>(childSize.x) * j;
            for (int i = columns.First; i < columns.End; ++i)
            {
              node = Union(node, row[i]);
            }
          }
          out[x + static_cast<std::int64_t>(size.x) * y] = node;
        }
      }
    });
}

// The numeric types of VTK; std::uint16_t and float are the texels too.
template class MinMaxPyramid<char>;
template class MinMaxPyramid<signed char>;
template class MinMaxPyramid<unsigned char>;
template class MinMaxPyramid<short>;
template class MinMaxPyramid<unsigned short>;
template class MinMaxPyramid<int>;
template class MinMaxPyramid<unsigned int>;
template class MinMaxPyramid<long>;
template class MinMaxPyramid<unsigned long>;
template class MinMaxPyramid<long long>;
template class MinMaxPyramid<unsigned long long>;
template class MinMaxPyramid<float>;
template class MinMaxPyramid<double>;
}
