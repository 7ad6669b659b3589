// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Texts as colour files that are XML or JSON: styles and colour maps with colours in order, or a
// sentence.
#include "FuzzInput.h"

#include "data/ColorDocument.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const auto& result : { terrain::ReadStyle(text), terrain::ReadColorMapDocument(text),
         terrain::ReadColorMapPresets(text) })
  {
    Require(!result.WhyNot.empty() || !result.Scheme.Stops.empty());
    double last = -HUGE_VAL;
    for (const terrain::ColorStop& stop : result.Scheme.Stops)
    {
      Require(std::isfinite(stop.Value) && stop.Value >= last);
      for (int k = 0; k < 3; ++k)
      {
        Require(stop.Shade[k] >= 0.0 && stop.Shade[k] <= 1.0);
      }
      last = stop.Value;
    }
  }
  return 0;
}
