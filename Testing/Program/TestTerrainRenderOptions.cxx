// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line of terrain-render: what is refused, and with which sentence.
#include "TerrainRenderFixture.h"

#include <string>
#include <vector>

namespace
{
/// Arguments, and what the sentence about them has to mention.
struct WrongArguments
{
  std::vector<std::string> Arguments;
  std::string Mention;
};

class TerrainRenderOptions : public TerrainRenderFixture
{
};

const std::vector<WrongArguments> kWrong = { { { "--size", "0x720" }, "--size" },
  { { "--size", "1280x0" }, "--size" }, { { "--size", "-4x720" }, "--size" },
  { { "--size", "1000000000x1000000000" }, "1000000000" }, { { "--size", "1e9x1e9" }, "--size" },
  { { "--size", "99999999999999999999x1" }, "--size" }, { { "--size", "nanxnan" }, "nan" },
  { { "--size", "12.5x10" }, "whole number" }, { { "--size", "1280" }, "WIDTHxHEIGHT" },
  { { "--size", "1280x720x3" }, "720x3" }, { { "--size" }, "--size" },
  { { "--mesh-cells", "0" }, "--mesh-cells" }, { { "--mesh-cells", "-1" }, "--mesh-cells" },
  { { "--mesh-cells", "1e9" }, "--mesh-cells" }, { { "--mesh-cells", "many" }, "many" },
  { { "--frames", "0" }, "--frames" }, { { "--frames", "1e9" }, "--frames" },
  { { "--frames", "inf" }, "--frames" }, { { "--exaggeration", "nan" }, "--exaggeration" },
  { { "--exaggeration", "-inf" }, "--exaggeration" },
  { { "--exaggeration", "0" }, "--exaggeration" }, { { "--exaggeration", "-2" }, "--exaggeration" },
  { { "--exaggeration", "1e9" }, "--exaggeration" }, { { "--view-angle", "0" }, "--view-angle" },
  { { "--view-angle", "180" }, "--view-angle" }, { { "--view-angle", "wide" }, "wide" },
  { { "--technique", "quick" }, "quick" }, { { "--window", "wayland" }, "wayland" },
  { { "--camera", "1,2,3" }, "6 or 9" }, { { "--camera", "1,2,3,4,5,6,7" }, "6 or 9" },
  { { "--camera", "1,2,3,4,5,six" }, "six" }, { { "--camera", "1,2,3,4,5," }, "6 or 9" },
  { { "--camera", "1,2,3,4,,6" }, "--camera" }, { { "--camera", "nan,2,3,4,5,6" }, "nan" },
  { { "--camera", "1,2,3,1,2,3" }, "focal point" },
  { { "--camera", "0,0,9,0,0,0,0,0,1" }, "up vector" },
  { { "--camera", "0,0,9,0,0,0,0,0,0" }, "up vector" }, { { "--output", "" }, "--output" },
  { { "--output", "a.png", "--depth", "a.png" }, "a.png" },
  { { "a.tif", "--output", "a.tif" }, "a.tif" }, { { "a.tif", "b.tif" }, "b.tif" },
  { { "--pixel-tolerance", "-1" }, "--pixel-tolerance" },
  { { "--pixel-tolerance", "1", "--technique", "linear" }, "pyramid" },
  { { "--tolerance", "0", "--technique", "strips" }, "strips" },
  { { "--tolerance", "nan", "--technique", "strips" }, "tolerance" },
  { { "--steps", "5" }, "linear, exponential and equidistant" },
  { { "--steps", "0", "--technique", "linear" }, "--steps" },
  { { "--steps", "-3", "--technique", "equidistant" }, "--steps" },
  { { "--steps", "1e9", "--technique", "equidistant" }, "--steps" },
  { { "--steps", "257", "--technique", "exponential" }, "256" },
  { { "--steps", "nan", "--technique", "linear" }, "nan" },
  { { "--secant-steps", "1e9", "--technique", "linear" }, "--secant-steps" },
  { { "--secant-steps", "2", "--technique", "mesh" }, "--secant-steps" },
  { { "--long-steps", "4", "--technique", "linear" }, "equidistant" },
  { { "--step-length", "2", "--technique", "exponential" }, "equidistant" },
  { { "--step-length", "0", "--technique", "equidistant" }, "--step-length" },
  { { "--step-length", "inf", "--technique", "equidistant" }, "--step-length" },
  { { "--wireframe" }, "strips" }, { { "--levels", "--technique", "mesh" }, "strips" },
  { { "--crossings", "--technique", "strips" }, "strips casts no rays" },
  { { "--fast" }, "--fast" }, { { "--crs", "EPSG:99999999" }, "--crs" },
  { { "--crs", "ENGCRS[]" }, "--crs" }, { { "--frame", "mercator" }, "mercator" },
  { { "--origin", "8" }, "LON,LAT" }, { { "--origin", "8,91" }, "LON,LAT" },
  { { "--origin", "8,47,0,0" }, "LON,LAT" }, { { "--origin", "8,north" }, "north" },
  { { "--origin", "8,47", "--frame", "utm" }, "--origin" }, { { "--utm-zone", "45" }, "N or S" },
  { { "--utm-zone", "61N" }, "--utm-zone" }, { { "--utm-zone", "N" }, "--utm-zone" },
  { { "--utm-zone", "" }, "--utm-zone" },
  { { "--utm-zone", "45N", "--frame", "plane" }, "--frame" },
  { { "--curvature", "--frame", "grid" }, "--curvature" }, { { "--cell", "0" }, "--cell" },
  { { "--cell", "-30" }, "--cell" }, { { "--cell", "nan" }, "nan" },
  { { "--vertical", "sea" }, "sea" }, { { "--geoid", "" }, "--geoid" },
  { { "--look-from", "8,47,500agl" }, "--look-at" }, { { "--look-at", "8,47" }, "--look-from" },
  { { "--look-from", "8,47,high", "--look-at", "8,47" }, "high" },
  { { "--look-from", "8,97,500", "--look-at", "8,47" }, "8,97" },
  { { "--look-from", "8,47,500", "--look-at", "there" }, "--look-at" },
  { { "--look-from", "8,47,500", "--look-at", "8,47", "--camera", "1,2,3,4,5,6" }, "--camera" },
  { { "--sun", "noon" }, "noon" }, { { "--sun", "2024-02-30T12:00" }, "calendar" },
  { { "--sun", "1850-02-28T12:00" }, "1850" }, { { "--graticule", "miles" }, "miles" },
  { { "--track-mode", "flying" }, "flying" },
  { { "--drape", "a.png", "--output", "a.png" }, "a.png" },
  { { "--drape", "a.png", "--technique", "strips", "--levels" }, "--levels" },
  { { "--track", "a.json", "--stats", "a.json" }, "a.json" },
  { { "--detail-cells", "8" }, "needs --detail" }, { { "--detail-height", "8" }, "needs --detail" },
  { { "--detail", "builtin", "--detail-cells", "12" }, "power of two" },
  { { "--detail", "builtin", "--detail-cells", "0" }, "--detail-cells" },
  { { "--detail", "builtin", "--detail-cells", "1e9" }, "--detail-cells" },
  { { "--detail", "builtin", "--detail-height", "-1" }, "--detail-height" },
  { { "--detail", "a.png", "--output", "a.png" }, "a.png" } };
}

TEST_F(TerrainRenderOptions, WrongOnesAreRefused)
{
  for (const WrongArguments& wrong : kWrong)
  {
    const RunResult result = this->Run(wrong.Arguments);
    SCOPED_TRACE(::testing::PrintToString(wrong.Arguments));
    ExpectRefused(result, 2, wrong.Mention);
  }
  EXPECT_TRUE(this->ListFiles().empty());
}

TEST_F(TerrainRenderOptions, HelpAndVersionAreNoErrors)
{
  const RunResult help = this->Run({ "--help" });
  EXPECT_EQ(help.Status, 0);
  for (const char* option : { "HEIGHTS", "--output", "--size", "--technique", "--mesh-cells",
         "--camera", "--view-angle", "--exaggeration", "--depth", "--window", "--frames", "--stats",
         "--crs", "--frame", "--curvature", "--origin", "--utm-zone", "--cell", "--cubic",
         "--vertical", "--geoid", "--drape", "--track", "--track-mode", "--look-from", "--look-at",
         "--sun", "--graticule", "--scale-bar", "--north-arrow", "--pixel-tolerance", "--crossings",
         "--steps", "--long-steps", "--step-length", "--secant-steps" })
  {
    EXPECT_NE(help.Output.find(option), std::string::npos) << option;
  }
  EXPECT_EQ(this->Run({ "--version" }).Status, 0);
  EXPECT_TRUE(this->ListFiles().empty());
}
