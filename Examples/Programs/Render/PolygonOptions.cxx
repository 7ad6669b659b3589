// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOptions.h"

#include <CLI/CLI.hpp>

//------------------------------------------------------------------------------
void PolygonOptions::Declare(CLI::App& app)
{
  const char* const group = "Polygons";
  app
    .add_option("--polygons", this->Files,
      "areas to fill and outline on the ground: GeoJSON, GeoPackage, Shapefile, or any vector file "
      "GDAL opens; may be given more than once")
    ->type_name("FILE")
    ->group(group)
    ->allow_extra_args(false)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  this->DeclareField(app, "--polygons", "", group);
  app
    .add_option("--polygon-opacity", this->Opacity, "of what fills them, 0 for none; default 0.45")
    ->type_name("PART")
    ->group(group)
    ->check(CLI::Range(0.0, 1.0).description(""));
  app
    .add_option("--polygon-width", this->Width,
      "of their outlines in pixels of a picture 720 pixels high, 0 for none; default 2")
    ->type_name("PIXELS")
    ->group(group)
    ->check(CLI::Range(0.0, 100.0).description(""));
}

//------------------------------------------------------------------------------
void PolygonOptions::Check() const
{
  for (const auto& [option, text] : { std::pair(this->GetFieldOption(), this->ColorBy),
         std::pair(std::string("--polygon-colors"), this->Colors) })
  {
    if (!text.empty() && this->Files.empty())
    {
      throw CLI::ValidationError(option, "there is no polygon: give --polygons FILE, too");
    }
  }
  this->CheckField();
}
