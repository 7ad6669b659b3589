// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Palettes.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkTerrainActor.h"

#include <array>

namespace
{
using Color = std::array<double, 3>;

constexpr std::array<Color, 2> kGrey = { { { 0.15, 0.15, 0.15 }, { 0.97, 0.97, 0.97 } } };
constexpr std::array<Color, 5> kSpectrum = { { { 0.16, 0.18, 0.55 }, { 0.10, 0.53, 0.62 },
  { 0.36, 0.72, 0.36 }, { 0.93, 0.77, 0.25 }, { 0.76, 0.18, 0.14 } } };

template <std::size_t N>
void ApplyColors(
  const std::array<Color, N>& colors, const std::array<double, 2>& range, vtkTerrainActor* terrain)
{
  const vtkNew<vtkColorTransferFunction> function;
  for (std::size_t k = 0; k < N; ++k)
  {
    const double share = static_cast<double>(k) / static_cast<double>(N - 1);
    function->AddRGBPoint(
      range[0] + share * (range[1] - range[0]), colors[k][0], colors[k][1], colors[k][2]);
  }
  terrain->SetLookupTable(function);
}
}

//------------------------------------------------------------------------------
Palette NextPalette(Palette palette)
{
  return palette == Palette::Plain ? Palette::Relief
                                   : static_cast<Palette>(static_cast<int>(palette) + 1);
}

//------------------------------------------------------------------------------
const char* NameOf(Palette palette)
{
  constexpr std::array<const char*, 4> kNames{ "relief", "grey", "spectrum", "plain" };
  return kNames[static_cast<std::size_t>(palette)];
}

//------------------------------------------------------------------------------
void ApplyPalette(Palette palette, const std::array<double, 2>& range, vtkTerrainActor* terrain)
{
  terrain->SetColorByHeight(palette != Palette::Plain);
  terrain->GetProperty()->SetColor(0.78, 0.74, 0.66);
  terrain->SetLookupTable(vtkTerrainActor::MakeReliefColors(range[0], range[1]));
  if (palette == Palette::Grey)
  {
    ApplyColors(kGrey, range, terrain);
  }
  else if (palette == Palette::Spectrum)
  {
    ApplyColors(kSpectrum, range, terrain);
  }
}
