// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Texts as places: one on earth that is written as it was read, or one sentence.
#include "core/place/GridReference.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  glm::dvec3 place(1.0, 2.0, 3.0);
  std::string message;
  if (!terrain::PlaceFromText(text, place, message))
  {
    if (message.empty() || place != glm::dvec3(1.0, 2.0, 3.0))
    {
      std::abort();
    }
    return 0;
  }
  glm::dvec3 again(0.0);
  const bool isRead = terrain::PlaceFromText(terrain::ToDegreesText(place, 12), again, message);
  if (!isRead || !(std::abs(place.y) <= 90.0) || std::abs(again.y - place.y) > 1e-9)
  {
    std::abort();
  }
  return 0;
}
