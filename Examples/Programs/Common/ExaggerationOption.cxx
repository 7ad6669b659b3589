// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExaggerationOption.h"

#include "Failure.h"
#include "Messages.h"

#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkTerrainActor.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <sstream>

namespace
{
const char* const kAuto = "auto";
constexpr double kLeastFactor = 1e-3;
constexpr double kMostFactor = 1e3;
/// Shares of the extent below which terrain looks like a sheet, and above which like towers.
constexpr double kFlat = 0.01;
constexpr double kSteep = 1.0;

std::string WhyNoFactor(const std::string& text)
{
  double factor = 0.0;
  if (text == kAuto)
  {
    return {};
  }
  if (!CLI::detail::lexical_cast(text, factor) || !std::isfinite(factor))
  {
    return "'" + text + "' is neither a finite number nor auto";
  }
  return factor < kLeastFactor || factor > kMostFactor ? text + " is not between 0.001 and 1000"
                                                       : std::string();
}

/// A share as a text: "2.1 %".
std::string Percents(double share)
{
  std::ostringstream text;
  text.precision(2);
  text << 100.0 * share << " %";
  return text.str();
}
}

//------------------------------------------------------------------------------
std::string FactorText(double factor)
{
  std::ostringstream text;
  text << factor;
  return text.str();
}

//------------------------------------------------------------------------------
void ExaggerationOption::Declare(CLI::App& app)
{
  app
    .add_option("--exaggeration", this->Text,
      "drawn height over true height; auto: so that relief is seen; default 1")
    ->type_name("FACTOR|auto")
    ->check(CLI::Validator(WhyNoFactor, ""));
}

//------------------------------------------------------------------------------
bool ExaggerationOption::IsAuto() const
{
  return this->Text == kAuto;
}

//------------------------------------------------------------------------------
double ExaggerationOption::Choose(vtkImageData* heights, bool isGlobe) const
{
  if (!this->IsAuto())
  {
    return std::stod(this->Text);
  }
  if (!heights->GetPointData()->GetScalars())
  {
    throw Failure("--exaggeration auto",
      "the technique strips does not read the samples of a prepared file: give a number");
  }
  const double share = vtkTerrainActor::GetReliefShare(heights);
  const double factor = vtkTerrainActor::SuggestExaggeration(heights, isGlobe);
  Tell("exaggeration " + FactorText(factor) + ", for the relief is " + Percents(share) +
    " of the extent");
  return factor;
}

//------------------------------------------------------------------------------
void ExaggerationOption::TellIfOdd(vtkImageData* heights, double factor) const
{
  const double share = vtkTerrainActor::GetReliefShare(heights);
  const double drawn = share * factor;
  if (this->IsAuto() || share <= 0.0 || (drawn >= kFlat && drawn <= kSteep))
  {
    return;
  }
  const double better = vtkTerrainActor::SuggestExaggeration(heights);
  Tell("hint: the relief is drawn " + Percents(drawn) + " of the extent high, which looks like a " +
    (drawn < kFlat ? "sheet" : "tower") + ": --exaggeration auto takes " + FactorText(better));
}
