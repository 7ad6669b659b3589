// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/HeightMeans.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
using Sum = HeightMeans::Sum;

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

/// The sum of the samples first <= (i, j) < end.
template <typename T>
Sum SumSamples(
  const HeightfieldView<T>& view, double bias, const glm::i64vec2& first, const glm::i64vec2& end)
{
  double codes = 0.0;
  double count = 0.0;
  for (std::int64_t j = first.y; j < end.y; ++j)
  {
    for (std::int64_t index = view.Index(first.x, j); index < view.Index(end.x, j); ++index)
    {
      const bool valid = view.IsValid(index);
      codes += valid ? static_cast<double>(view.Samples[index]) - bias : 0.0;
      count += valid ? 1.0 : 0.0;
    }
  }
  return { static_cast<float>(codes), static_cast<float>(count) };
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
      glm::dvec2 sum(0.0);
      for (int j = static_cast<int>(low.y); j < std::min(std::ceil(high.y), 1.0 * below.Size.y);
           ++j)
      {
        for (int i = static_cast<int>(low.x); i < std::min(std::ceil(high.x), 1.0 * below.Size.x);
             ++i)
        {
          const double part = std::max(std::min(high.x, i + 1.0) - std::max(low.x, 1.0 * i), 0.0) *
            std::max(std::min(high.y, j + 1.0) - std::max(low.y, 1.0 * j), 0.0);
          const Sum& texel = below.Sums[TexelIndex(below.Size, i, j)];
          sum += part * glm::dvec2(texel.Codes, texel.Count);
        }
      }
      level.Sums.push_back({ static_cast<float>(sum.x), static_cast<float>(sum.y) });
    }
  }
  return level;
}

/// Texels of a level; those without heights are of the level above it, if there is one.
MeanLevel Encode(const SumLevel& sums, const HeightCodes& codes, const MeanLevel* above)
{
  MeanLevel level;
  level.Size = sums.Size;
  level.Texels.reserve(sums.Sums.size());
  const double scale = 65535.0 / std::max(codes.MaximumCode, 1e-300);
  for (int y = 0; y < level.Size.y; ++y)
  {
    for (int x = 0; x < level.Size.x; ++x)
    {
      const Sum& sum = sums.Sums[TexelIndex(level.Size, x, y)];
      std::uint16_t texel = 0;
      if (sum.Count > 0.0f)
      {
        texel = static_cast<std::uint16_t>(
          std::clamp(scale * static_cast<double>(sum.Codes) / static_cast<double>(sum.Count) + 0.5,
            0.0, 65535.0));
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
void HeightMeans::MakeLevels(const HeightCodes& codes)
{
  std::vector<SumLevel> sums{ { this->Size, this->Sums } };
  while (std::max(sums.back().Size.x, sums.back().Size.y) > 1)
  {
    sums.push_back(SumLevelBelow(sums.back()));
  }
  this->Levels.resize(sums.size());
  for (std::size_t k = sums.size(); k-- > 0;)
  {
    this->Levels[k] = Encode(sums[k], codes, k + 1 < sums.size() ? &this->Levels[k + 1] : nullptr);
  }
}

//------------------------------------------------------------------------------
template <typename T>
void HeightMeans::Build(
  const HeightfieldView<T>& view, const HeightCodes& codes, const ParallelFor& parallelFor)
{
  this->Levels.clear();
  this->Sums.clear();
  if (view.Width < 2 || view.Height < 2 || !codes.HasData)
  {
    return;
  }
  this->Size = glm::max(
    glm::ivec2(view.Width >> kFirstMeanLevel, view.Height >> kFirstMeanLevel), glm::ivec2(1));
  this->Sums.resize(
    static_cast<std::size_t>(this->Size.x) * static_cast<std::size_t>(this->Size.y));
  const GridRectangle all{ { 0, 0 }, { view.Width, view.Height } };
  this->Update(view, codes, all, parallelFor);
}

//------------------------------------------------------------------------------
template <typename T>
void HeightMeans::Update(const HeightfieldView<T>& view, const HeightCodes& codes,
  const GridRectangle& samples, const ParallelFor& parallelFor)
{
  if (this->Sums.empty() || samples.IsEmpty())
  {
    return;
  }
  const glm::i64vec2 size(this->Size);
  const glm::i64vec2 count(view.Width, view.Height);
  const glm::i64vec2 first(
    PartOf(samples.First.x, size.x, count.x), PartOf(samples.First.y, size.y, count.y));
  const glm::i64vec2 last(
    PartOf(samples.End.x - 1, size.x, count.x), PartOf(samples.End.y - 1, size.y, count.y));
  parallelFor(last.y + 1 - first.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t y = first.y + begin; y < first.y + end; ++y)
      {
        for (std::int64_t x = first.x; x <= last.x; ++x)
        {
          const glm::i64vec2 from(PartBegin(x, size.x, count.x), PartBegin(y, size.y, count.y));
          const glm::i64vec2 to(
            PartBegin(x + 1, size.x, count.x), PartBegin(y + 1, size.y, count.y));
          this->Sums[static_cast<std::size_t>(x + size.x * y)] =
            SumSamples(view, codes.Bias, from, to);
        }
      }
    });
  this->MakeLevels(codes);
}

#define TERRAIN_INSTANTIATE(T)                                                                     \
  template void HeightMeans::Build(                                                                \
    const HeightfieldView<T>&, const HeightCodes&, const ParallelFor&);                            \
  template void HeightMeans::Update(                                                               \
    const HeightfieldView<T>&, const HeightCodes&, const GridRectangle&, const ParallelFor&)
TERRAIN_INSTANTIATE(std::uint16_t);
TERRAIN_INSTANTIATE(float);
#undef TERRAIN_INSTANTIATE
}
