// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/Peaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace terrain
{
namespace
{
using Index = std::uint32_t;

/// Samples as a graph, and the islands of those that were raised so far.
class Islands
{
public:
  Islands(const std::vector<double>& heights, std::size_t width)
    : Heights(heights)
    , Width(width)
    , Rows(width > 0 ? heights.size() / width : 0)
    , Parent(heights.size())
  {
    std::iota(this->Parent.begin(), this->Parent.end(), Index{ 0 });
  }

  /// Samples that have heights, the highest first.
  std::vector<Index> Order() const
  {
    std::vector<Index> order;
    order.reserve(this->Heights.size());
    for (std::size_t k = 0; k < this->Heights.size(); ++k)
    {
      if (!std::isnan(this->Heights[k]))
      {
        order.push_back(static_cast<Index>(k));
      }
    }
    std::sort(order.begin(), order.end(), [this](Index a, Index b) { return this->Above(a, b); });
    return order;
  }

  /// Raises a sample after all above it; summits that meet another one here are appended.
  void Raise(Index sample, std::vector<Peak>& peaks)
  {
    this->ForNeighbours(sample,
      [&](Index neighbour)
      {
        if (!this->Above(neighbour, sample))
        {
          return;
        }
        Index low = this->Summit(neighbour);
        Index high = this->Summit(sample);
        if (low == high)
        {
          return;
        }
        if (this->Above(low, high))
        {
          std::swap(low, high);
        }
        // one of the same height is the same summit, or the sample itself, which is none
        if (this->Heights[low] > this->Heights[sample])
        {
          this->Add(low, this->Heights[sample], peaks);
        }
        this->Parent[low] = high;
      });
  }

  /// The summit of the island of a sample.
  Index Summit(Index sample)
  {
    while (this->Parent[sample] != sample)
    {
      this->Parent[sample] = this->Parent[this->Parent[sample]];
      sample = this->Parent[sample];
    }
    return sample;
  }

  /// Appends a summit, unless ground may rise beside it.
  void Add(Index summit, double pass, std::vector<Peak>& peaks) const
  {
    int neighbours = 0;
    this->ForNeighbours(
      summit, [&](Index neighbour) { neighbours += std::isnan(this->Heights[neighbour]) ? 0 : 1; });
    if (neighbours == 8)
    {
      const double height = this->Heights[summit];
      peaks.push_back({ summit % this->Width, summit / this->Width, height, height - pass });
    }
  }

private:
  /// A strict order: of samples alike the first is above.
  bool Above(Index a, Index b) const
  {
    return this->Heights[a] > this->Heights[b] || (this->Heights[a] == this->Heights[b] && a < b);
  }

  template <typename Function>
  void ForNeighbours(Index sample, const Function& function) const
  {
    const std::size_t column = sample % this->Width;
    const std::size_t row = sample / this->Width;
    const std::size_t firstRow = row > 0 ? row - 1 : 0;
    const std::size_t firstColumn = column > 0 ? column - 1 : 0;
    for (std::size_t j = firstRow; j <= std::min(row + 1, this->Rows - 1); ++j)
    {
      for (std::size_t i = firstColumn; i <= std::min(column + 1, this->Width - 1); ++i)
      {
        if (i != column || j != row)
        {
          function(static_cast<Index>(j * this->Width + i));
        }
      }
    }
  }

  const std::vector<double>& Heights;
  std::size_t Width;
  std::size_t Rows;
  /// Towards the summit of an island, which is its own.
  std::vector<Index> Parent;
};
}

//------------------------------------------------------------------------------
std::vector<Peak> FindPeaks(const std::vector<double>& heights, std::size_t width)
{
  std::vector<Peak> peaks;
  if (width == 0 || heights.size() < width)
  {
    return peaks;
  }
  Islands islands(heights, width);
  const std::vector<Index> order = islands.Order();
  for (const Index sample : order)
  {
    islands.Raise(sample, peaks);
  }
  // the lowest sample of each island that is left: the first one from below
  std::vector<bool> isDone(heights.size(), false);
  for (auto sample = order.rbegin(); sample != order.rend(); ++sample)
  {
    const Index summit = islands.Summit(*sample);
    if (!isDone[summit])
    {
      isDone[summit] = true;
      islands.Add(summit, heights[*sample], peaks);
    }
  }
  std::sort(peaks.begin(), peaks.end(),
    [](const Peak& a, const Peak& b)
    {
      return a.Prominence != b.Prominence ? a.Prominence > b.Prominence
        : a.Row != b.Row                  ? a.Row < b.Row
                                          : a.Column < b.Column;
    });
  return peaks;
}
}
