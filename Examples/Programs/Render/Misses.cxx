// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Misses.h"

#include "Canvas.h"

#include "vtkImageData.h"
#include "vtkOpenGLTerrainMapper.h"

#include <cmath>
#include <cstdint>
#include <iostream>

namespace
{
/// Part of the distance that a depth may be off.
constexpr double kRightDepth = 1e-3;

struct Misses
{
  std::int64_t Missed = 0;
  std::int64_t Wrong = 0;
  std::int64_t Surface = 0;
};

Misses Compare(vtkImageData* found, vtkImageData* exact)
{
  Misses misses;
  const auto* a = static_cast<const float*>(found->GetScalarPointer());
  const auto* b = static_cast<const float*>(exact->GetScalarPointer());
  for (vtkIdType i = 0; i < exact->GetNumberOfPoints(); ++i)
  {
    misses.Surface += std::isnan(b[i]) ? 0 : 1;
    if (std::isnan(a[i]) != std::isnan(b[i]))
    {
      ++misses.Missed;
    }
    else if (std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])) >
      kRightDepth * static_cast<double>(b[i]))
    {
      ++misses.Wrong;
    }
  }
  return misses;
}
}

//------------------------------------------------------------------------------
void CountMisses(
  const Terrain& terrain, const Options& options, Canvas& canvas, Statistics& statistics)
{
  const bool steps = options.Search == Technique::Linear ||
    options.Search == Technique::Exponential ||
    (options.Search == Technique::Equidistant && !options.Steps.AreDefault());
  if (!steps)
  {
    return;
  }
  auto* mapper = vtkOpenGLTerrainMapper::SafeDownCast(terrain.Actor->GetMapper());
  const auto technique = mapper->GetTechnique();
  const vtkSmartPointer<vtkImageData> found = canvas.DrawDepths(terrain.Actor);
  mapper->SetTechnique(vtkOpenGLTerrainMapper::Techniques::Pyramid);
  const vtkSmartPointer<vtkImageData> exact = canvas.DrawDepths(terrain.Actor);
  mapper->SetTechnique(technique);
  const Misses misses = Compare(found, exact);
  statistics.SetCount("surface_pixels", misses.Surface);
  statistics.SetCount("missed_pixels", misses.Missed);
  statistics.SetCount("wrong_pixels", misses.Wrong);
  std::cerr << "terrain-render: of " << misses.Surface << " pixels of the surface the technique "
            << NameOf(options.Search) << " misses " << misses.Missed << " and has " << misses.Wrong
            << " at a wrong depth; pyramid and equidistant are exact\n";
}
