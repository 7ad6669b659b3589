// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/TileSelection.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace terrain
{
namespace
{
// Room around a tile's box for the rounding of rays: cells, and a share of the codes.
constexpr double kCells = 1.0;
constexpr double kCodes = 1e-5;

struct Box
{
  glm::dvec3 Low{ 0.0 };
  glm::dvec3 High{ 0.0 };

  /// The corner that lies farthest along a direction.
  glm::dvec3 Corner(const glm::dvec3& direction) const
  {
    return glm::mix(this->Low, this->High, glm::greaterThan(direction, glm::dvec3(0.0)));
  }
};

class Selector
{
public:
  Selector(const TileSource& source, const TileView& view, const FindRelief& findRelief)
    : Source(source)
    , Layout(source.GetLayout())
    , MaximumCode(source.GetCodes().MaximumCode)
    , View(view)
    , Find(findRelief)
  {
  }

  TileSelection Select(std::size_t most)
  {
    TileSelection selection;
    const TileKey top{ this->Layout.LevelCount() - 1, 0, 0 };
    selection.Tiles.push_back({ top, std::numeric_limits<double>::infinity() });
    this->Consider(top, selection);
    while (!this->Candidates.empty())
    {
      const TileWish coarse = this->Candidates.top();
      this->Candidates.pop();
      const std::vector<TileKey> finer = this->FinerTiles(coarse.Key);
      if (selection.Tiles.size() + finer.size() > most)
      {
        selection.Fits = false;
        break;
      }
      for (const TileKey& key : finer)
      {
        selection.Tiles.push_back({ key, coarse.Urgency });
        this->Consider(key, selection);
      }
    }
    return selection;
  }

private:
  struct LessUrgent
  {
    bool operator()(const TileWish& a, const TileWish& b) const
    {
      return a.Urgency < b.Urgency || (a.Urgency == b.Urgency && b.Key < a.Key);
    }
  };

  Box BoxOf(const TileKey& key) const
  {
    const PyramidNode<float> bounds = this->Source.GetBounds(key);
    const double room = kCodes * this->MaximumCode;
    const glm::dvec2 first(this->Layout.FirstCell(key) << std::int64_t{ key.Level });
    const glm::dvec2 size(this->Layout.CellCount(key) << std::int64_t{ key.Level });
    return { { first.x - kCells, first.y - kCells, static_cast<double>(bounds.Minimum) - room },
      { first.x + size.x + kCells, first.y + size.y + kCells,
        static_cast<double>(bounds.Maximum) + room } };
  }

  bool IsSeen(const TileKey& key) const
  {
    if (this->Source.GetBounds(key).IsEmpty())
    {
      return false;
    }
    const Box box = this->BoxOf(key);
    return std::all_of(this->View.Planes.begin(), this->View.Planes.end(),
      [&box](const glm::dvec4& plane)
      { return glm::dot(glm::dvec3(plane), box.Corner(glm::dvec3(plane))) + plane.w >= 0.0; });
  }

  std::vector<TileKey> FinerTiles(const TileKey& key) const
  {
    std::vector<TileKey> finer;
    for (std::int64_t k = 0; k < 4; ++k)
    {
      const TileKey child{ key.Level - 1, 2 * key.Column + k % 2, 2 * key.Row + k / 2 };
      if (this->Layout.Contains(child) && this->IsSeen(child))
      {
        finer.push_back(child);
      }
    }
    return finer;
  }

  /// Keeps a tile as a candidate if its cells may exceed the tolerance.
  void Consider(const TileKey& key, TileSelection& selection)
  {
    if (key.Level == 0)
    {
      return;
    }
    const float relief = this->Find(key);
    if (relief < 0.0F)
    {
      selection.IsFinal = false;
      return;
    }
    const Box box = this->BoxOf(key);
    const double nearest =
      glm::dot(this->View.Forward, box.Corner(-this->View.Forward) - this->View.Eye);
    const glm::dvec4& tolerance = this->View.Tolerance;
    const glm::dvec2 allowed = glm::dvec2(tolerance.x, tolerance.y) +
      std::max(nearest, 0.0) * glm::dvec2(tolerance.z, tolerance.w);
    const auto cells = static_cast<double>(std::int64_t{ 1 } << key.Level);
    const double urgency = std::max(cells / allowed.x, static_cast<double>(relief) / allowed.y);
    if (!(urgency <= kWithin))
    {
      this->Candidates.push({ key, urgency });
    }
  }

  // A little less than 1: rays compute in float.
  static constexpr double kWithin = 1.0 - 1e-4;

  const TileSource& Source;
  TileLayout Layout;
  double MaximumCode;
  const TileView& View;
  const FindRelief& Find;
  std::priority_queue<TileWish, std::vector<TileWish>, LessUrgent> Candidates;
};
}

//------------------------------------------------------------------------------
TileSelection SelectTiles(
  const TileSource& source, const TileView& view, std::size_t most, const FindRelief& findRelief)
{
  if (source.GetLayout().LevelCount() < 1)
  {
    return {};
  }
  return Selector(source, view, findRelief).Select(most);
}
}
