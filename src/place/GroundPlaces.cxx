// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "place/GroundPlaces.h"

#include "core/grid/HeightSampling.h"
#include "core/place/VerticalSearch.h"
#include "data/ImageHeights.h"
#include "vtkTerrainGeoreference.h"

#include <limits>

namespace terrain
{
namespace
{
/// Puts points of the scene on the surface above or below them.
void ToSurface(vtkImageData* image, std::vector<double>& scene)
{
  const GridGeometry geometry = ImageHeights::Geometry(image);
  ImageHeights::Dispatch(image,
    [&](const auto& heights)
    {
      for (std::size_t i = 0; i < scene.size(); i += 3)
      {
        const glm::dvec2 grid(geometry.ToGrid({ scene[i], scene[i + 1], 0.0 }));
        scene[i + 2] = geometry.ToModel(grid, SampleBilinear(heights, grid.x, grid.y)).z;
      }
    });
}
}

//------------------------------------------------------------------------------
void LowerToGround(
  vtkTerrainGeoreference* georeference, vtkImageData* heights, std::vector<double>& places)
{
  const auto count = static_cast<vtkIdType>(places.size() / 3);
  // heights from which a search begins anew where it meets no terrain: up to the highest summits
  constexpr double highest = 9000.0;
  const bool round = georeference->GetFrame() == vtkTerrainGeoreference::FrameType::Local;
  std::vector<VerticalSearch> searches(
    static_cast<std::size_t>(count), VerticalSearch(0.0, highest, round ? 8 : 0));
  std::vector<double> ground(places.size());
  bool isMoving = true;
  while (isMoving)
  {
    isMoving = false;
    for (std::size_t k = 0; k < searches.size(); ++k)
    {
      places[3 * k + 2] = searches[k].GetZ();
    }
    georeference->PlacesToScene(places.data(), ground.data(), count);
    ToSurface(heights, ground);
    georeference->SceneToPlaces(ground.data(), ground.data(), count);
    for (std::size_t k = 0; k < searches.size(); ++k)
    {
      const double rise = ground[3 * k + 2] - places[3 * k + 2];
      isMoving = searches[k].Take(rise, kGroundTolerance) || isMoving;
    }
  }
  for (std::size_t k = 0; k < searches.size(); ++k)
  {
    places[3 * k + 2] =
      searches[k].IsFound() ? searches[k].GetZ() : std::numeric_limits<double>::quiet_NaN();
  }
}
}
