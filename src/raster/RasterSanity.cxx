// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of RasterFile that warns of what no terrain looks like.
#include "raster/RasterFile.h"

#include "raster/GDALTable.h"
#include "raster/RasterHoles.h"
#include "raster/RasterTile.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
//------------------------------------------------------------------------------
// Warns of bytes that are no heights.
void RasterFile::CheckBytes()
{
  const FillFindings& seen = this->Holes.Seen;
  if (GDALGetRasterDataType(this->Band) == GDT_Byte && !this->IsSignedByte() &&
    (seen.LevelCount == 2 || IsNamedAsProduct(this->Name)))
  {
    this->Record.Warn(seen.LevelCount == 2
        ? "its samples are bytes of two values, " + NumberText(seen.Low) + " and " +
          NumberText(seen.High) + ", as masks have: they are taken for heights in metres"
        : "its name and its bytes are those of a picture or mask made of heights: they are taken "
          "for "
          "heights in metres");
  }
}

//------------------------------------------------------------------------------
// Warns of numbers without a sign that are those of negative heights.
void RasterFile::CheckSigns()
{
  constexpr double kLowestAsUnsigned = 65536.0 - 12000.0;
  if (this->GetType() == GDT_UInt16 && this->Holes.High > kLowestAsUnsigned &&
    std::abs(this->Heights.Factor) == 1.0)
  {
    this->Record.Warn("its samples are numbers of 16 bits without a sign, up to " +
      NumberText(this->Holes.High) +
      ", as negative heights become where the sign is lost: add the line 'PIXELTYPE SIGNEDINT' to "
      "its .hdr, or gdal_calc.py -A IN --calc='A.astype(int16)' --type=Int16 --outfile=OUT.tif");
  }
}

//------------------------------------------------------------------------------
// Warns of values that lie far from all others. range: what there is, in words; cell: metres.
void RasterFile::CheckFarValues(const std::string& range, double scale, double cell)
{
  constexpr double kMostOfOne = 0.9;
  const FillFindings& seen = this->Holes.Seen;
  const double aloof = FindAloof(seen, scale);
  const bool isMost = seen.LowShare > kMostOfOne || seen.HighShare > kMostOfOne;
  if (isMost)
  {
    const bool low = seen.LowShare > kMostOfOne;
    const double value = low ? seen.Low : seen.High;
    this->Record.Warn("more than 90 % of it is " + NumberText(value) + ", its " +
      (low ? "lowest" : "highest") + " value (" + range + "): --nodata " + NumberText(value) +
      " if that is no height");
  }
  if (!isMost && !std::isnan(aloof))
  {
    const bool low = aloof == seen.Low;
    this->Record.Warn("about " +
      NumberText(std::round(100.0 * (low ? seen.LowShare : seen.HighShare))) + " % of it is " +
      NumberText(aloof) + ", " + (low ? "below" : "above") +
      " all others by more than these span (" + range + "): --nodata " + NumberText(aloof) +
      " if that is no height");
  }
  else if (HasZeroVoids(seen))
  {
    this->Record.Warn(NumberText(std::ceil(100.0 * seen.LowShare)) +
      " % of it or less is 0, far below all others (" + range +
      "): --nodata 0 if that is no height");
  }
  else if (AreNeedles(seen, scale, cell))
  {
    this->Record.Warn("few samples lie " + NumberText(std::abs(scale) * seen.WidestGap) +
      " m beyond all others, as needles or a block with sheer sides (" + range + "): --nodata " +
      NumberText(seen.IsGapLow ? seen.Low : seen.High) + " if they are no heights");
  }
}

//------------------------------------------------------------------------------
// Warns of what no terrain looks like.
void RasterFile::CheckSanity()
{
  constexpr double kSteepestRelief = 3.0; // times the longer side
  constexpr double kSmallestRaster = 64.0;
  const FillFindings& seen = this->Holes.Seen;
  if (this->Layout.CRS.rfind("GEODCRS", 0) == 0 &&
    this->Layout.CRS.find("CS[Cartesian,3]") != std::string::npos)
  {
    this->Record.Warn("its CRS is geocentric, X, Y and Z from the centre of the earth, in which no "
                      "raster lies: it is drawn at its x and y (--crs names their CRS)");
  }
  const double samples =
    static_cast<double>(this->GetWidth()) * static_cast<double>(this->GetHeight());
  if (!(seen.High > seen.Low) || samples < kSmallestRaster)
  {
    return;
  }
  this->CheckBytes();
  this->CheckSigns();
  double scale = 1.0;
  double offset = 0.0;
  this->GetScaleAndOffset(scale, offset);
  const double cellX = std::abs(this->Transform[1]) * this->Layout.Scale[0];
  const double cellY = std::abs(this->Transform[5]) * this->Layout.Scale[1];
  const double longest = std::max(
    cellX * static_cast<double>(this->GetWidth()), cellY * static_cast<double>(this->GetHeight()));
  const double ends[2] = { offset + scale * seen.Low, offset + scale * seen.High };
  const std::string range = "heights from " + NumberText(std::min(ends[0], ends[1])) + " to " +
    NumberText(std::max(ends[0], ends[1])) + " m, cells of " + NumberText(cellX) + " x " +
    NumberText(cellY) + " m";
  if (std::abs(scale) * (seen.High - seen.Low) > kSteepestRelief * longest &&
    !this->HasDegreesForMetres())
  {
    this->Record.Warn("it is more than three times as high as it is wide (" + range +
      "): check --height-unit, --nodata, " +
      (this->HasTransform || this->Coordinates
          ? "--crs"
          : "its place (gdal_translate -a_ullr X0 Y1 X1 Y0 IN OUT.tif)"));
  }
  this->CheckFarValues(range, scale, std::max(cellX, cellY));
}
}
