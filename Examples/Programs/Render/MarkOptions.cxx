// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarkOptions.h"

#include <CLI/CLI.hpp>

namespace
{
constexpr int kMostPeaks = 1000;
const char* const kMarks = "Texts";
}

//------------------------------------------------------------------------------
void MarkOptions::Declare(CLI::App& app)
{
  app
    .add_option("--labels", this->Labels,
      "points with names: GeoJSON, any vector file GDAL opens, or CSV with the columns lon, lat, "
      "name and, if it is to be shown, height; those that ridges hide or others cover are left out")
    ->type_name("FILE")
    ->group(kMarks);
  app
    .add_option(
      "--peaks", this->Peaks, "heights of so many summits, the most prominent first; 1 to 1000")
    ->type_name("N")
    ->group(kMarks)
    ->check(CLI::Range(1, kMostPeaks).description(""));
  app
    .add_flag("--contour-labels", this->ContourLabels,
      "heights on the wide contour lines of --contours, turned along them")
    ->group(kMarks);
  app
    .add_flag("--outline{box}", this->Outline,
      "the edges of the box around the terrain; --outline=edge for the edge of the data")
    ->group(kMarks)
    ->check(CLI::IsMember({ "box", "edge" }).description(""));
  app.add_flag("--height-scale", this->HeightScale, "a ruler of heights at the corner on the left")
    ->group(kMarks);
  app
    .add_flag("--inset", this->Inset,
      "a small map in the corner, with the ground that is seen and where the eye is")
    ->group(kMarks);
  app.add_option("--title", this->Title, "text at the upper border")
    ->type_name("TEXT")
    ->group(kMarks);
  app.add_option("--caption", this->Caption, "text at the lower border")
    ->type_name("TEXT")
    ->group(kMarks);
}
