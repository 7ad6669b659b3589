// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldOptions.h"

#include "ColorName.h"

#include "vtkNew.h"
#include "vtkTerrainColors.h"

#include <CLI/CLI.hpp>

namespace
{
constexpr const char* kUsualScheme = "inferno";

std::string WhyNoColors(const std::string& text)
{
  const vtkNew<vtkTerrainColors> colors;
  return ParseColor(text) || colors->SetSchemeOrFile(text)
    ? std::string()
    : colors->GetErrorMessage() + ", and it is no colour";
}
}

//------------------------------------------------------------------------------
void FieldOptions::DeclareField(
  CLI::App& app, const std::string& option, const std::string& more, const std::string& group)
{
  app
    .add_option(this->GetFieldOption(), this->ColorBy,
      "field of the features of " + option +
        " that chooses their colours: numbers, or texts as classes" + more +
        ". With --legend the colours are told")
    ->type_name("FIELD")
    ->group(group);
  app
    .add_option("--" + this->Word + "-colors", this->Colors,
      "a colour, or with " + this->GetFieldOption() +
        " a scheme or a file, as those of --colors; default inferno")
    ->type_name("COLOUR|NAME|FILE")
    ->group(group)
    ->check(CLI::Validator(WhyNoColors, ""));
}

//------------------------------------------------------------------------------
void FieldOptions::CheckField() const
{
  if (!this->Colors.empty() && this->ColorBy.empty() != ParseColor(this->Colors).has_value())
  {
    throw CLI::ValidationError("--" + this->Word + "-colors",
      this->ColorBy.empty()
        ? "is a scheme or file: " + this->GetFieldOption() + " says what it shows"
        : "is one colour: leave out " + this->GetFieldOption());
  }
}

//------------------------------------------------------------------------------
std::string FieldOptions::GetFieldOption() const
{
  return "--" + this->Word + "-color-by";
}

//------------------------------------------------------------------------------
std::string FieldOptions::GetFileName() const
{
  const vtkNew<vtkTerrainColors> colors;
  return this->ColorBy.empty() || this->Colors.empty() || colors->SetScheme(this->Colors)
    ? std::string()
    : this->Colors;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTerrainColors> FieldOptions::MakeColors() const
{
  auto colors = vtkSmartPointer<vtkTerrainColors>::New();
  colors->SetSchemeOrFile(this->Colors.empty() ? kUsualScheme : this->Colors);
  colors->SetSea(vtkTerrainColors::SeaMode::Never);
  return colors;
}
