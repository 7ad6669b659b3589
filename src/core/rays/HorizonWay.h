// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The way of a ray (HorizonPath.h) as tables for lanes, and the tree of its stretches.
 */
#ifndef terrain_HorizonWay_h
#define terrain_HorizonWay_h

#include "core/grid/Constants.h"
#include "core/rays/HorizonPath.h"
#include "core/rays/LaneKernels.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace terrain
{
/// The tables of a way. Not to be copied: views refer to them.
template <typename Real>
struct HorizonWay
{
  /// Nodes of the pyramid across a stretch, about.
  static constexpr int NodesAcross = 2;

  std::vector<WayStep<Real>> Steps;
  std::vector<std::vector<WayStretch<Real>>> Stretches;
  std::vector<const WayStretch<Real>*> Tree;
  std::vector<int> StepsOfColumns;
  std::vector<int> StepsOfRows;
  LaneWay<Real> View;

  /// stride: samples from one row of memory to the next. lanes: rays side by side.
  HorizonWay(
    const HorizonPath& path, double drop, std::int64_t stride, int lanes, const glm::i64vec2& size)
  {
    constexpr int leafSteps = LaneWay<Real>::LeafSteps;
    for (const HorizonCell& cell : path.Cells())
    {
      this->AddStep(cell, drop, stride);
    }
    this->StepsOfColumns = this->CountSteps(path, 0, size.x);
    this->StepsOfRows = this->CountSteps(path, 1, size.y);
    const int count = static_cast<int>(this->Steps.size());
    for (int steps = leafSteps; steps == leafSteps || steps < 2 * count; steps *= 2)
    {
      this->Stretches.emplace_back();
      for (int first = 0; first < count; first += steps)
      {
        this->AddStretch(path.Cells(), first, std::min(first + steps, count) - 1, drop, lanes);
      }
    }
    for (const auto& level : this->Stretches)
    {
      this->Tree.push_back(level.data());
    }
    this->View = { this->Steps.data(), static_cast<int>(this->Tree.size()), this->Tree.data(),
      this->StepsOfColumns.data(), this->StepsOfRows.data(), path.GetSpeed().x >= 0.0,
      path.GetSpeed().y >= 0.0, static_cast<Real>(path.GetSpeed().x * path.GetSpeed().y),
      static_cast<Real>(drop) };
  }
  HorizonWay(const HorizonWay&) = delete;
  void operator=(const HorizonWay&) = delete;

private:
  void AddStep(const HorizonCell& cell, double drop, std::int64_t stride)
  {
    const auto offset = [stride](glm::ivec2 sample) { return sample.x + stride * sample.y; };
    const double length = cell.Exit - cell.Enter;
    this->Steps.push_back({ offset(cell.Cell), offset(cell.Beside), offset(cell.ExitBegin),
      offset(cell.ExitEnd), static_cast<Real>(cell.Fraction),
      static_cast<Real>(drop * cell.Exit * cell.Exit), static_cast<Real>(1.0 / cell.Exit),
      static_cast<Real>(cell.Exit), static_cast<Real>(cell.Enter * cell.Enter),
      static_cast<Real>(cell.Enter * cell.Exit), static_cast<Real>(cell.Exit * cell.Exit),
      static_cast<Real>(cell.Enter / length), static_cast<Real>(cell.Exit / length),
      static_cast<Real>(std::min(length * length / (4.0 * cell.Enter), 1e30)) });
  }

  std::vector<int> CountSteps(const HorizonPath& path, int axis, std::int64_t samples) const
  {
    const double speed = path.GetSpeed()[axis];
    std::vector<int> counts(static_cast<std::size_t>(samples), 0);
    int steps = 0;
    for (std::size_t ahead = 0; ahead < counts.size(); ++ahead)
    {
      const auto inside = [&](const HorizonCell& cell)
      {
        const int cells = speed < 0.0 ? -1 - cell.Cell[axis] : cell.Cell[axis];
        return speed == 0.0 || cells < static_cast<int>(ahead);
      };
      while (steps < static_cast<int>(path.Cells().size()) &&
        inside(path.Cells()[static_cast<std::size_t>(steps)]))
      {
        ++steps;
      }
      counts[ahead] = steps;
    }
    return counts;
  }

  void AddStretch(
    const std::vector<HorizonCell>& cells, int first, int last, double drop, int lanes)
  {
    const HorizonCell& begin = cells[static_cast<std::size_t>(first)];
    const HorizonCell& end = cells[static_cast<std::size_t>(last)];
    const glm::ivec2 low =
      glm::min(glm::min(begin.Cell, end.Cell), glm::min(begin.Beside, end.Beside));
    const glm::ivec2 high = glm::max(begin.Cell, end.Cell) + glm::ivec2(lanes - 1, 0);
    WayStretch<Real> stretch;
    stretch.West = low.x;
    stretch.East = high.x;
    stretch.South = low.y;
    stretch.North = high.y;
    while ((NodesAcross << stretch.Level) < std::max(high.x - low.x, high.y - low.y) + 1)
    {
      ++stretch.Level;
    }
    stretch.Drop = static_cast<Real>(drop * begin.Enter * begin.Enter);
    stretch.InverseEnter = static_cast<Real>(begin.Enter > 0.0 ? 1.0 / begin.Enter : 1e30);
    stretch.InverseExit = static_cast<Real>(1.0 / end.Exit);
    this->Stretches.back().push_back(stretch);
  }
};
}

#endif
