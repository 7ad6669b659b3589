// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/HeightSlopes.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
using Sum = HeightSlopes::Sum;

/// The sums of a level, row by row.
struct SumLevel
{
  glm::ivec2 Size{ 0, 0 };
  std::vector<Sum> Sums;
};

std::size_t TexelIndex(glm::ivec2 size, int x, int y)
{
  return static_cast<std::size_t>(x) +
    static_cast<std::size_t>(size.x) * static_cast<std::size_t>(y);
}

/// The place, of `count`, next to which part `index` of `parts` equal parts begins.
std::int64_t PartBegin(std::int64_t index, std::int64_t parts, std::int64_t count)
{
  return (2 * index * count + parts) / (2 * parts);
}

/// The part of `parts` that place `index` of `count` lies in.
std::int64_t PartOf(std::int64_t index, std::int64_t parts, std::int64_t count)
{
  std::int64_t part = std::min(index * parts / count, parts - 1);
  part -= PartBegin(part, parts, count) > index ? 1 : 0;
  part += PartBegin(part + 1, parts, count) <= index ? 1 : 0;
  return part;
}

/// The sum of the cells first <= (i, j) < end.
template <typename T>
Sum SumCells(const HeightfieldView<T>& view, const glm::i64vec2& first, const glm::i64vec2& end)
{
  glm::dvec2 slope(0.0);
  double count = 0.0;
  for (std::int64_t j = first.y; j < end.y; ++j)
  {
    for (std::int64_t i = first.x; i < end.x; ++i)
    {
      if (view.IsCellValid(i, j))
      {
        const T* southWest = view.Samples + view.Index(i, j);
        const T* northWest = southWest + view.RowStep();
        const double rising = static_cast<double>(northWest[1]) - static_cast<double>(southWest[0]);
        const double falling =
          static_cast<double>(southWest[1]) - static_cast<double>(northWest[0]);
        slope += 0.5 * glm::dvec2(rising + falling, rising - falling);
        count += 1.0;
      }
    }
  }
  return { glm::vec2(slope), static_cast<float>(count) };
}

/// The next level up: parts of what is below, by how much of it they cover.
SumLevel SumLevelBelow(const SumLevel& below)
{
  SumLevel level;
  level.Size = glm::max(below.Size / 2, glm::ivec2(1));
  for (int y = 0; y < level.Size.y; ++y)
  {
    for (int x = 0; x < level.Size.x; ++x)
    {
      const glm::dvec2 low = glm::dvec2(x, y) * glm::dvec2(below.Size) / glm::dvec2(level.Size);
      const glm::dvec2 high =
        glm::dvec2(x + 1, y + 1) * glm::dvec2(below.Size) / glm::dvec2(level.Size);
      glm::dvec2 slope(0.0);
      double count = 0.0;
      for (int j = static_cast<int>(low.y); j < std::min(std::ceil(high.y), 1.0 * below.Size.y);
           ++j)
      {
        for (int i = static_cast<int>(low.x); i < std::min(std::ceil(high.x), 1.0 * below.Size.x);
             ++i)
        {
          const double part = std::max(std::min(high.x, i + 1.0) - std::max(low.x, 1.0 * i), 0.0) *
            std::max(std::min(high.y, j + 1.0) - std::max(low.y, 1.0 * j), 0.0);
          const Sum& texel = below.Sums[TexelIndex(below.Size, i, j)];
          slope += part * glm::dvec2(texel.Slope);
          count += part * static_cast<double>(texel.Count);
        }
      }
      level.Sums.push_back({ glm::vec2(slope), static_cast<float>(count) });
    }
  }
  return level;
}

glm::dvec2 Mean(const Sum& sum)
{
  return glm::dvec2(sum.Slope) / std::max(static_cast<double>(sum.Count), 1e-30);
}

/// The steepest of a level either way.
double Steepest(const SumLevel& level)
{
  double steepest = 0.0;
  for (const Sum& sum : level.Sums)
  {
    const glm::dvec2 slope = glm::abs(Mean(sum));
    steepest = std::max({ steepest, slope.x, slope.y });
  }
  return steepest;
}

/// Texels of a level; those without a surface are of the level above it, if there is one.
SlopeLevel Encode(const SumLevel& sums, double scale, const SlopeLevel* above)
{
  SlopeLevel level;
  level.Size = sums.Size;
  level.Texels.reserve(sums.Sums.size());
  for (int y = 0; y < level.Size.y; ++y)
  {
    for (int x = 0; x < level.Size.x; ++x)
    {
      const Sum& sum = sums.Sums[TexelIndex(level.Size, x, y)];
      SlopeTexel texel(0);
      if (sum.Count > 0.0f)
      {
        texel = SlopeTexel(glm::round(
          glm::clamp(32767.0 / scale * Mean(sum), glm::dvec2(-32767.0), glm::dvec2(32767.0))));
      }
      else if (above)
      {
        const glm::ivec2 at = glm::ivec2(x, y) * above->Size / level.Size;
        texel = above->Texels[TexelIndex(above->Size, at.x, at.y)];
      }
      level.Texels.push_back(texel);
    }
  }
  return level;
}
}

//------------------------------------------------------------------------------
void HeightSlopes::MakeLevels()
{
  std::vector<SumLevel> sums{ { this->Size, this->Sums } };
  this->Scale = std::max(Steepest(sums[0]), 1e-30);
  while (std::max(sums.back().Size.x, sums.back().Size.y) > 1)
  {
    sums.push_back(SumLevelBelow(sums.back()));
  }
  this->Levels.resize(sums.size());
  for (std::size_t k = sums.size(); k-- > 0;)
  {
    this->Levels[k] =
      Encode(sums[k], this->Scale, k + 1 < sums.size() ? &this->Levels[k + 1] : nullptr);
  }
}

//------------------------------------------------------------------------------
template <typename T>
void HeightSlopes::Build(
  const HeightfieldView<T>& view, const HeightCodes& codes, const ParallelFor& parallelFor)
{
  this->Levels.clear();
  this->Sums.clear();
  if (view.Width < 2 || view.Height < 2 || !codes.HasData)
  {
    return;
  }
  this->Size = glm::max(
    glm::ivec2((view.Width - 1) >> kFirstSlopeLevel, (view.Height - 1) >> kFirstSlopeLevel),
    glm::ivec2(1));
  this->Sums.resize(
    static_cast<std::size_t>(this->Size.x) * static_cast<std::size_t>(this->Size.y));
  this->Update(view, { { 0, 0 }, { view.Width, view.Height } }, parallelFor);
}

//------------------------------------------------------------------------------
template <typename T>
void HeightSlopes::Update(
  const HeightfieldView<T>& view, const GridRectangle& samples, const ParallelFor& parallelFor)
{
  if (this->Sums.empty() || samples.IsEmpty())
  {
    return;
  }
  const glm::i64vec2 size(this->Size);
  const glm::i64vec2 cells(view.Width - 1, view.Height - 1);
  const glm::i64vec2 firstCell(glm::max(samples.First - 1, glm::ivec2(0)));
  const glm::i64vec2 lastCell = glm::min(glm::i64vec2(samples.End), cells) - glm::i64vec2(1);
  const glm::i64vec2 first(
    PartOf(firstCell.x, size.x, cells.x), PartOf(firstCell.y, size.y, cells.y));
  const glm::i64vec2 last(PartOf(lastCell.x, size.x, cells.x), PartOf(lastCell.y, size.y, cells.y));
  parallelFor(last.y + 1 - first.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t y = first.y + begin; y < first.y + end; ++y)
      {
        for (std::int64_t x = first.x; x <= last.x; ++x)
        {
          const glm::i64vec2 from(PartBegin(x, size.x, cells.x), PartBegin(y, size.y, cells.y));
          const glm::i64vec2 to(
            PartBegin(x + 1, size.x, cells.x), PartBegin(y + 1, size.y, cells.y));
          this->Sums[static_cast<std::size_t>(x + size.x * y)] = SumCells(view, from, to);
        }
      }
    });
  this->MakeLevels();
}

#define TERRAIN_INSTANTIATE(T)                                                                     \
  template void HeightSlopes::Build(                                                               \
    const HeightfieldView<T>&, const HeightCodes&, const ParallelFor&);                            \
  template void HeightSlopes::Update(                                                              \
    const HeightfieldView<T>&, const GridRectangle&, const ParallelFor&)
TERRAIN_INSTANTIATE(std::uint16_t);
TERRAIN_INSTANTIATE(float);
#undef TERRAIN_INSTANTIATE
}
