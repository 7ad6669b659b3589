// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parts/DrapePicture.h"

#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"

#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace terrain
{
namespace
{
/// The nearest pixel of a drape.
class DrapeReader
{
public:
  DrapeReader(vtkImageData* drape, const std::array<double, 4>& bounds)
    : Size(drape->GetDimensions()[0], drape->GetDimensions()[1])
    , West(bounds[0])
    , South(bounds[2])
    , Pixel((bounds[1] - bounds[0]) / this->Size.x, (bounds[3] - bounds[2]) / this->Size.y)
  {
    auto* texels = vtkUnsignedCharArray::SafeDownCast(drape->GetPointData()->GetScalars());
    this->Components = texels->GetNumberOfComponents();
    this->Texels = texels->GetPointer(0);
  }

  const glm::dvec2& PixelSize() const
  {
    return this->Pixel;
  }

  /// Colour over another.
  glm::vec3 Over(const glm::dvec2& place, const glm::vec3& below) const
  {
    const glm::dvec2 pixel = (place - glm::dvec2(this->West, this->South)) / this->Pixel;
    const glm::dvec2 size(this->Size);
    if (!(pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < size.x && pixel.y < size.y))
    {
      return below; // also where pixels are too small for a number
    }
    const glm::ivec2 at(pixel);
    const unsigned char* texel =
      this->Texels + this->Components * (at.x + std::int64_t{ this->Size.x } * at.y);
    const bool isGrey = this->Components < 3;
    const glm::vec3 color(texel[0], texel[isGrey ? 0 : 1], texel[isGrey ? 0 : 2]);
    const float alpha =
      this->Components % 2 == 0 ? static_cast<float>(texel[this->Components - 1]) / 255.0f : 1.0f;
    return glm::mix(below, color, alpha);
  }

private:
  glm::ivec2 Size;
  double West;
  double South;
  glm::dvec2 Pixel;
  int Components = 0;
  const unsigned char* Texels = nullptr;
};

/// Colours of all samples, three bytes each, from the south.
std::vector<unsigned char> ColorsOfSamples(vtkImageData* heights, vtkUnsignedCharArray* ofPoints)
{
  const auto count = static_cast<std::size_t>(heights->GetNumberOfPoints());
  std::vector<unsigned char> colors(3 * count, 255);
  const int width = heights->GetDimensions()[0];
  for (std::size_t k = 0; ofPoints && k < count; ++k)
  {
    const auto sample = static_cast<vtkIdType>(k);
    const vtkIdType point = ImageHeights::PointOfSample(heights, sample % width, sample / width);
    const int components = ofPoints->GetNumberOfComponents();
    const unsigned char* color = ofPoints->GetPointer(components * point);
    const bool isGrey = components < 3;
    colors[3 * k] = color[0];
    colors[3 * k + 1] = color[isGrey ? 0 : 1];
    colors[3 * k + 2] = color[isGrey ? 0 : 2];
  }
  return colors;
}

bool IsPicture(vtkImageData* drape)
{
  auto* texels =
    drape ? vtkUnsignedCharArray::SafeDownCast(drape->GetPointData()->GetScalars()) : nullptr;
  return texels && drape->GetNumberOfPoints() > 0 && drape->GetDimensions()[2] == 1 &&
    texels->GetNumberOfComponents() <= 4;
}
}

//------------------------------------------------------------------------------
std::array<double, 4> FindSampleBounds(vtkImageData* heights)
{
  const GridGeometry geometry = ImageHeights::Geometry(heights);
  const glm::dvec2 last(heights->GetDimensions()[0] - 1, heights->GetDimensions()[1] - 1);
  const glm::dvec3 corner = geometry.ToModel(last, 0.0);
  return { geometry.Origin.x, corner.x, geometry.Origin.y, corner.y };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeDrapePicture(vtkImageData* drape,
  const std::array<double, 4>& drapeBounds, vtkImageData* heights, vtkUnsignedCharArray* colors)
{
  if (!IsPicture(drape))
  {
    return nullptr;
  }
  const DrapeReader reader(drape, drapeBounds);
  const std::array<double, 4> bounds = FindSampleBounds(heights);
  const glm::dvec2 corner(bounds[0], bounds[2]);
  const glm::dvec2 extent = glm::dvec2(bounds[1], bounds[3]) - corner;
  const glm::dvec2 pixels = glm::ceil(extent / reader.PixelSize() - 1e-6);
  const glm::ivec2 size(glm::min(glm::max(glm::dvec2(1.0), pixels), 1.0 * kMostDrapePixels));
  const std::vector<unsigned char> below = ColorsOfSamples(heights, colors);
  const glm::ivec2 samples(heights->GetDimensions()[0], heights->GetDimensions()[1]);

  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size.x, size.y, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* target = static_cast<unsigned char*>(picture->GetScalarPointer());
  SMPParallelFor(size.y,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t k = size.x * begin; k < size.x * end; ++k)
      {
        const glm::dvec2 part = (glm::dvec2(k % size.x, k / size.x) + 0.5) / glm::dvec2(size);
        const glm::ivec2 sample(glm::round(part * glm::dvec2(samples - 1)));
        const unsigned char* color =
          below.data() + 3 * (sample.x + std::int64_t{ samples.x } * sample.y);
        const glm::vec3 shown =
          reader.Over(corner + part * extent, glm::vec3(color[0], color[1], color[2]));
        for (int channel = 0; channel < 3; ++channel)
        {
          target[3 * k + channel] = static_cast<unsigned char>(std::lround(shown[channel]));
        }
      }
    });
  return picture;
}
}
