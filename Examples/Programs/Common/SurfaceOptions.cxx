// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceOptions.h"

#include "LightOptions.h"

#include <vtkOpenGLTerrainMapper.h>
#include <vtkTerrainActor.h>

#include <CLI/CLI.hpp>

namespace
{
constexpr double kLeast = 1e-3;
constexpr double kMost = 1e6;
}

//------------------------------------------------------------------------------
void SurfaceOptions::Declare(CLI::App& app)
{
  app.add_option("--contours", this->Contours, "contour lines so many metres apart")
    ->type_name("INTERVAL")
    ->check(CLI::Range(kLeast, kMost).description(""));
  app.add_flag("--hillshade", this->Hillshade,
    "shade as on maps, from the north-west, in place of sun and lights");
  app
    .add_option(
      "--block", this->Block, "a solid block down to so many metres below the lowest height")
    ->type_name("DEPTH")
    ->check(CLI::Range(kLeast, kMost).description(""));
}

//------------------------------------------------------------------------------
void SurfaceOptions::CheckLight(const LightOptions& light) const
{
  if (this->Hillshade && (light.Shadows || light.SkyLight > 0.0 || !light.Sun.empty()))
  {
    throw CLI::ValidationError(
      "--hillshade", "has no sun and no lights: leave out --sun, --shadows and --sky-light");
  }
}

//------------------------------------------------------------------------------
void SurfaceOptions::Apply(vtkTerrainActor* terrain, double lowest) const
{
  vtkOpenGLTerrainMapper* mapper = terrain->GetTerrainMapper();
  mapper->SetContours(this->Contours > 0.0);
  if (this->Contours > 0.0)
  {
    mapper->SetContourInterval(this->Contours);
  }
  mapper->SetHillshade(this->Hillshade);
  mapper->SetBlock(this->Block > 0.0);
  mapper->SetBlockBase(lowest - this->Block);
}
