// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorOptions.h"

#include <vtkNew.h>
#include <vtkScalarsToColors.h>
#include <vtkTerrainColors.h>

#include <CLI/CLI.hpp>

#include <cmath>

namespace
{
/// Reads "LOWEST,HIGHEST"; false unless both are numbers and the first is less.
bool ReadRange(const std::string& text, double range[2])
{
  const std::size_t comma = text.find(',');
  return comma != std::string::npos && CLI::detail::lexical_cast(text.substr(0, comma), range[0]) &&
    CLI::detail::lexical_cast(text.substr(comma + 1), range[1]) && std::isfinite(range[0]) &&
    std::isfinite(range[1]) && range[0] < range[1];
}

std::string WhyNotRange(const std::string& text)
{
  double range[2];
  return ReadRange(text, range)
    ? std::string()
    : "'" + text + "' must be two heights in metres, the lower one first: LOWEST,HIGHEST";
}

std::string WhyNotColors(const std::string& text)
{
  const vtkNew<vtkTerrainColors> colors;
  return colors->SetSchemeOrFile(text) ? std::string() : colors->GetErrorMessage();
}
}

//------------------------------------------------------------------------------
void ColorOptions::Declare(CLI::App& app, bool hasEach)
{
  std::string schemes;
  for (int k = 0; k < vtkTerrainColors::GetNumberOfSchemes(); ++k)
  {
    schemes.append(k > 0 ? ", " : "").append(vtkTerrainColors::GetSchemeName(k));
  }
  app
    .add_option("--colors", this->Colors,
      "colours of heights: " + schemes +
        "; or a file: .cpt, .txt, .clr, .qml, .xml, .json, .csv (value,colour,name)")
    ->type_name("NAME|FILE")
    ->check(CLI::Validator(WhyNotColors, ""));
  app
    .add_option("--range", this->Range,
      std::string("heights of the first and last colour in metres; default: all heights") +
        (hasEach ? "; each: those of each terrain, with a legend each" : ""))
    ->type_name("LOWEST,HIGHEST")
    ->check(CLI::Validator([hasEach](const std::string& text)
      { return hasEach && text == "each" ? std::string() : WhyNotRange(text); },
      ""));
  app.add_flag("--reverse", this->Reverse, "the last colour first");
  app
    .add_option("--below-sea", this->BelowSea,
      "whether heights below 0 have the sea's colours: auto (default), always, never")
    ->type_name("WHEN")
    ->check(CLI::IsMember({ "auto", "always", "never" }).description(""));
}

//------------------------------------------------------------------------------
std::string ColorOptions::GetFileName() const
{
  const vtkNew<vtkTerrainColors> colors;
  return colors->SetScheme(this->Colors) ? std::string() : this->Colors;
}

//------------------------------------------------------------------------------
bool ColorOptions::IsGiven() const
{
  return !this->Colors.empty() || !this->Range.empty() || this->Reverse || this->BelowSea != "auto";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTerrainColors> ColorOptions::MakeColors(const std::string& usual) const
{
  using SeaMode = vtkTerrainColors::SeaMode;
  auto colors = vtkSmartPointer<vtkTerrainColors>::New();
  const std::string& chosen = this->Colors.empty() ? usual : this->Colors;
  if (!chosen.empty())
  {
    colors->SetSchemeOrFile(chosen);
  }
  double range[2];
  if (ReadRange(this->Range, range))
  {
    colors->SetRange(range);
  }
  colors->SetReverse(this->Reverse);
  colors->SetSea(this->BelowSea == "always" ? SeaMode::Always
      : this->BelowSea == "never"           ? SeaMode::Never
                                            : SeaMode::Automatic);
  return colors;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkScalarsToColors> ColorOptions::MakeTable(double lowest, double highest) const
{
  return this->MakeColors()->MakeTable(lowest, highest);
}
