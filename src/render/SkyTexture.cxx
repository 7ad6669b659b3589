// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/SkyTexture.h"

#include "core/rays/Horizon.h"
#include "core/rays/SkyView.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"
#include "render/Driver.h"
#include "render/Uniforms.h"

#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace terrain
{
namespace
{
/// Means of heights over squares of samples, row by row; NaN where there are none.
struct MeanHeights
{
  int Level = 0;
  glm::i64vec2 Size{ 0 };
  std::vector<float> Heights;
};

template <typename T>
float MeanOf(const HeightfieldView<T>& view, const glm::i64vec2& square, int level)
{
  const glm::i64vec2 first = square << glm::i64vec2(level);
  const glm::i64vec2 last =
    glm::min(first + (std::int64_t{ 1 } << level), glm::i64vec2(view.Width, view.Height));
  double sum = 0.0;
  int count = 0;
  for (std::int64_t j = first.y; j < last.y; ++j)
  {
    for (std::int64_t i = first.x; i < last.x; ++i)
    {
      const double height = view.At(i, j);
      sum += std::isfinite(height) ? height : 0.0;
      count += std::isfinite(height) ? 1 : 0;
    }
  }
  return count > 0 ? static_cast<float>(sum / count) : static_cast<float>(kNaN);
}

template <typename T>
MeanHeights MeansOf(const HeightfieldView<T>& view)
{
  MeanHeights means;
  const glm::i64vec2 whole(view.Width, view.Height);
  const auto sizeOf = [&](int level)
  { return (whole + (std::int64_t{ 1 } << level) - std::int64_t{ 1 }) >> glm::i64vec2(level); };
  while (sizeOf(means.Level).x * sizeOf(means.Level).y > kMostSkySamples)
  {
    ++means.Level;
  }
  means.Size = sizeOf(means.Level);
  means.Heights.resize(static_cast<std::size_t>(means.Size.x * means.Size.y));
  SMPParallelFor(means.Size.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t j = begin; j < end; ++j)
      {
        for (std::int64_t i = 0; i < means.Size.x; ++i)
        {
          means.Heights[static_cast<std::size_t>(i + means.Size.x * j)] =
            MeanOf(view, { i, j }, means.Level);
        }
      }
    });
  return means;
}

/// Shares of the sky; 1 where there is no height.
std::vector<float> SharesOf(const MeanHeights& means, const glm::dvec2& spacing)
{
  HeightfieldView<float> view;
  view.Samples = means.Heights.data();
  view.Width = means.Size.x;
  view.Height = means.Size.y;
  const HorizonGrid grid(view, SMPParallelFor);
  HorizonOptions options;
  options.Spacing = spacing * std::exp2(means.Level);
  std::vector<float> horizons(means.Heights.size());
  std::vector<float> shares(means.Heights.size(), 0.0f);
  for (int k = 0; k < kSkyDirections; ++k)
  {
    grid.Cast(
      360.0 * k / kSkyDirections, options, { 0, means.Size.y }, horizons.data(), SMPParallelFor);
    for (std::size_t i = 0; i < shares.size(); ++i)
    {
      const double part = std::isnan(horizons[i]) ? 1.0 : SkyViewPart(horizons[i]);
      shares[i] += static_cast<float>(part / kSkyDirections);
    }
  }
  return shares;
}
}

//------------------------------------------------------------------------------
bool SkyTexture::Upload(vtkOpenGLRenderWindow* window, vtkImageData* heights, double exaggeration)
{
  if (this->Texture->GetContext() == window && this->Texture->GetHandle() &&
    this->Heights == heights && this->HeightsTime == heights->GetMTime() &&
    this->Exaggeration == exaggeration)
  {
    return true;
  }
  this->ReleaseGraphicsResources(this->Texture->GetContext());
  MeanHeights means;
  ImageHeights::Dispatch(heights, [&](const auto& view) { means = MeansOf(view); });
  const double* spacing = heights->GetSpacing();
  const GridGeometry drawn{ {}, {}, exaggeration };
  std::vector<float> shares =
    SharesOf(means, { drawn.RiseToHeights(spacing[0]), drawn.RiseToHeights(spacing[1]) });
  this->Scale = 1.0 / (std::exp2(means.Level) * glm::dvec2(means.Size));
  this->Heights = heights;
  this->HeightsTime = heights->GetMTime();
  this->Exaggeration = exaggeration;
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  return this->Texture->Create2DFromRaw(static_cast<unsigned int>(means.Size.x),
    static_cast<unsigned int>(means.Size.y), 1, VTK_FLOAT, shares.data());
}

//------------------------------------------------------------------------------
void SkyTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Heights = nullptr;
}

//------------------------------------------------------------------------------
void SkyTexture::Activate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Activate();
  }
}

//------------------------------------------------------------------------------
void SkyTexture::Deactivate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void SkyTexture::SetUniforms(Uniforms& uniforms)
{
  if (uniforms.Uses("terrainSky") && this->Texture->GetHandle())
  {
    uniforms.Set("terrainSky", this->Texture->GetTextureUnit());
    uniforms.Set("terrainSkyScale", glm::vec2(this->Scale));
  }
}
}
