// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/landscape/StreamErosion.h"

#include "core/landscape/LatticeNoise.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>

namespace terrain
{
namespace
{
constexpr double kDiagonal = 1.4142135623730951;
constexpr double kInverseDiagonal = 0.7071067811865476;

struct Neighbour
{
  int X;
  int Y;
  double InverseDistance; // in cells
};

constexpr std::array<Neighbour, 8> kNeighbours{ { { 1, 0, 1.0 }, { 1, 1, kInverseDiagonal },
  { 0, 1, 1.0 }, { -1, 1, kInverseDiagonal }, { -1, 0, 1.0 }, { -1, -1, kInverseDiagonal },
  { 0, -1, 1.0 }, { 1, -1, kInverseDiagonal } } };
}

StreamErosion::StreamErosion(
  std::int64_t width, std::int64_t height, double cellSize, std::uint32_t seed)
  : Heights(static_cast<std::size_t>(width * height), 0.0)
  , Uplift(Heights.size(), 0.0)
  , Width(width)
  , Height(height)
  , CellSize(cellSize)
  , Seed(seed)
  , Receivers(Heights.size(), 0)
  , Areas(Heights.size(), 0.0)
{
  this->Order.reserve(Heights.size());
}

void StreamErosion::Step(double timeStep)
{
  if (!this->Drained)
  {
    this->Flood();
    this->DrainPits();
    this->Drained = true;
  }
  this->ChooseReceivers();
  this->SortDownstreamFirst();
  this->AccumulateAreas();
  this->Incise(timeStep);
  this->Diffuse();
  this->DrainPits();
}

// Orders the nodes as water would reach them if it rose from the border (ties by index). The node
// from which a node is reached is its receiver: so pits drain over their lowest sill.
void StreamErosion::Flood()
{
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<char> seen(this->Heights.size(), 0);
  this->Order.clear();
  for (std::int64_t j = 0; j < this->Height; ++j)
  {
    for (std::int64_t i = 0; i < this->Width; ++i)
    {
      if (this->IsBorder(i, j))
      {
        const auto node = static_cast<std::size_t>(i + this->Width * j);
        seen[node] = 1;
        this->Receivers[node] = static_cast<std::int32_t>(node);
        open.emplace(this->Heights[node], static_cast<std::int32_t>(node));
      }
    }
  }
  while (!open.empty())
  {
    const double level = open.top().first;
    const std::int32_t node = open.top().second;
    open.pop();
    this->Order.push_back(node);
    const std::int64_t i = node % this->Width;
    const std::int64_t j = node / this->Width;
    for (const Neighbour& step : kNeighbours)
    {
      const std::int64_t x = i + step.X;
      const std::int64_t y = j + step.Y;
      if (x < 0 || y < 0 || x >= this->Width || y >= this->Height)
      {
        continue;
      }
      const auto next = static_cast<std::size_t>(x + this->Width * y);
      if (!seen[next])
      {
        seen[next] = 1;
        this->Receivers[next] = node;
        const double height = this->Heights[next];
        open.emplace(height > level ? height : level, static_cast<std::int32_t>(next));
      }
    }
  }
}

// The steepest way down. Each way's slope is weighted at random, always the same for one way, so
// that rivers do not all run in the grid's eight directions.
void StreamErosion::ChooseReceivers()
{
  for (std::int64_t j = 1; j < this->Height - 1; ++j)
  {
    for (std::int64_t i = 1; i < this->Width - 1; ++i)
    {
      const std::int64_t node = i + this->Width * j;
      const auto index = static_cast<std::size_t>(node);
      const std::uint32_t bits = LatticeHash(i, j, this->Seed);
      double steepest = 0.0;
      for (std::size_t k = 0; k < kNeighbours.size(); ++k)
      {
        const Neighbour& step = kNeighbours[k];
        const std::int64_t next = node + step.X + this->Width * step.Y;
        const double drop = this->Heights[index] - this->Heights[static_cast<std::size_t>(next)];
        const double weight = 0.6 + 0.05 * static_cast<double>((bits >> (4 * k)) & 15U);
        const double slope = weight * drop * step.InverseDistance;
        if (slope > steepest)
        {
          steepest = slope;
          this->Receivers[index] = static_cast<std::int32_t>(next);
        }
      }
    }
  }
}

// Each node after its receiver: lists of donors, then a walk up from the border (Braun and Willett
// 2013, section 2.2).
void StreamErosion::SortDownstreamFirst()
{
  const std::size_t count = this->Heights.size();
  this->FirstDonors.assign(count + 1, 0);
  for (std::size_t node = 0; node < count; ++node)
  {
    const auto receiver = static_cast<std::size_t>(this->Receivers[node]);
    this->FirstDonors[receiver + 1] += receiver != node ? 1 : 0;
  }
  for (std::size_t node = 0; node < count; ++node)
  {
    this->FirstDonors[node + 1] += this->FirstDonors[node];
  }
  this->Donors.resize(count);
  std::vector<std::int32_t> next(this->FirstDonors.begin(), this->FirstDonors.end() - 1);
  this->Order.clear();
  for (std::size_t node = 0; node < count; ++node)
  {
    const auto receiver = static_cast<std::size_t>(this->Receivers[node]);
    if (receiver == node)
    {
      this->Order.push_back(static_cast<std::int32_t>(node));
    }
    else
    {
      this->Donors[static_cast<std::size_t>(next[receiver]++)] = static_cast<std::int32_t>(node);
    }
  }
  for (std::size_t k = 0; k < this->Order.size(); ++k)
  {
    const auto node = static_cast<std::size_t>(this->Order[k]);
    this->Order.insert(this->Order.end(), this->Donors.begin() + this->FirstDonors[node],
      this->Donors.begin() + this->FirstDonors[node + 1]);
  }
}

void StreamErosion::AccumulateAreas()
{
  this->Areas.assign(this->Areas.size(), this->CellSize * this->CellSize);
  for (auto node = this->Order.rbegin(); node != this->Order.rend(); ++node)
  {
    const auto index = static_cast<std::size_t>(*node);
    const auto receiver = static_cast<std::size_t>(this->Receivers[index]);
    if (receiver != index)
    {
      this->Areas[receiver] += this->Areas[index];
    }
  }
}

// Downstream first, each node's new height from the new height of its receiver, within the slope
// that holds.
void StreamErosion::Incise(double timeStep)
{
  for (const std::int32_t node : this->Order)
  {
    const auto index = static_cast<std::size_t>(node);
    const auto receiver = static_cast<std::size_t>(this->Receivers[index]);
    if (receiver == index)
    {
      continue;
    }
    const std::int32_t difference = node - this->Receivers[index];
    const bool straight = difference == 1 || difference == -1 || difference == this->Width ||
      difference == -this->Width;
    const double distance = this->CellSize * (straight ? 1.0 : kDiagonal);
    const double factor = this->Erodibility * timeStep * std::sqrt(this->Areas[index]) / distance;
    const double raised = this->Heights[index] + timeStep * this->Uplift[index];
    const double base = this->Heights[receiver];
    const double height = (raised + factor * base) / (1.0 + factor);
    const double limit = base + this->SteepestSlope * distance;
    this->Heights[index] = height < limit ? height : limit;
  }
}

void StreamErosion::Diffuse()
{
  std::vector<double> smooth = this->Heights;
  for (std::int64_t j = 1; j < this->Height - 1; ++j)
  {
    for (std::int64_t i = 1; i < this->Width - 1; ++i)
    {
      const auto index = static_cast<std::size_t>(i + this->Width * j);
      const auto width = static_cast<std::size_t>(this->Width);
      const std::vector<double>& h = this->Heights;
      const double mean =
        (h[index - 1] + h[index + 1] + h[index - width] + h[index + width]) * 0.2 +
        (h[index - width - 1] + h[index - width + 1] + h[index + width - 1] +
          h[index + width + 1]) *
          0.05;
      smooth[index] = h[index] + this->Creep * (mean - h[index]);
    }
  }
  this->Heights.swap(smooth);
}

// Lifts what creep has left at or below its receiver just above it.
void StreamErosion::DrainPits()
{
  const double step = 1e-6 * this->CellSize;
  for (const std::int32_t node : this->Order)
  {
    const auto index = static_cast<std::size_t>(node);
    const auto receiver = static_cast<std::size_t>(this->Receivers[index]);
    if (receiver != index && this->Heights[index] <= this->Heights[receiver])
    {
      this->Heights[index] = this->Heights[receiver] + step;
    }
  }
}
}
