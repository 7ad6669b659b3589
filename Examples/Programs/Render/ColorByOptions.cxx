// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorByOptions.h"

#include <CLI/CLI.hpp>

//------------------------------------------------------------------------------
void ColorByOptions::Declare(CLI::App& app)
{
  app
    .add_option("--color-by", this->By,
      "what the colours show in place of heights: slope, aspect, or the values of another raster "
      "of any CRS; classes have the colours and names of its own table or of --colors FILE")
    ->type_name("slope|aspect|FILE");
  app.add_option("--color-band", this->Band, "band of that raster, from 1 on; default 1")
    ->type_name("N")
    ->check(CLI::Range(1, 65536).description(""));
}

//------------------------------------------------------------------------------
bool ColorByOptions::IsFile() const
{
  return this->IsGiven() && !this->IsSlope() && !this->IsAspect();
}

//------------------------------------------------------------------------------
bool ColorByOptions::IsSlope() const
{
  return this->By == "slope";
}

//------------------------------------------------------------------------------
bool ColorByOptions::IsAspect() const
{
  return this->By == "aspect";
}
