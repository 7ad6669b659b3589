// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line of terrain-render: what is refused, and with which sentence.
#include "TerrainRenderFixture.h"

#include <cmath>
#include <filesystem>
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
  { { "--wireframe" }, "strips" }, { { "--depths", "--technique", "mesh" }, "strips" },
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
  { { "--drape", "a.png", "--technique", "strips", "--depths" }, "--depths" },
  { { "--track", "a.json", "--stats", "a.json" }, "a.json" },
  { { "--detail-cells", "8" }, "needs --detail" }, { { "--detail-height", "8" }, "needs --detail" },
  { { "--detail", "builtin", "--detail-cells", "12" }, "power of two" },
  { { "--detail", "builtin", "--detail-cells", "0" }, "--detail-cells" },
  { { "--detail", "builtin", "--detail-cells", "1e9" }, "--detail-cells" },
  { { "--detail", "builtin", "--detail-height", "-1" }, "--detail-height" },
  { { "--detail", "a.png", "--output", "a.png" }, "a.png" },
  { { "--colors", "virids" }, "viridis" }, { { "--colors", "none.cpt" }, "none.cpt" },
  { { "--range", "5" }, "LOWEST,HIGHEST" }, { { "--range", "5,1" }, "LOWEST,HIGHEST" },
  { { "--range", "nan,1" }, "LOWEST,HIGHEST" }, { { "--range", "5,5" }, "LOWEST,HIGHEST" },
  { { "--range", "5," }, "LOWEST,HIGHEST" }, { { "--size", "32769x100" }, "--size" },
  { { "--below-sea", "often" }, "--below-sea" }, { { "--sun", "400,10" }, "AZIMUTH,ALTITUDE" },
  { { "--sun", "90,nan" }, "AZIMUTH,ALTITUDE" },
  { { "--sun", "2024-06-21T06:30Z/2024-06-21T04:30Z/30" }, "before" },
  { { "--sun", "2024-06-21T06:30Z/2024-06-22T04:30Z/0" }, "minutes" },
  { { "--sun", "2024-06-21T06:30Z/2034-06-22T04:30Z/1" }, "pictures" },
  { { "--sun-angle", "91" }, "--sun-angle" }, { { "--sky-light=-1" }, "--sky-light" },
  { { "--contours", "0" }, "--contours" }, { { "--block", "-5" }, "--block" },
  { { "--block", "100", "--technique", "mesh" }, "pyramid" },
  { { "--hillshade", "--shadows" }, "--hillshade" }, { { "" }, "HEIGHTS" },
  { { "--legend=" }, "--legend" }, { { "--output=", "a.png" }, "--output" },
  { { "--output", "a.webp" }, ".jpg" }, { { "--output", "a.tif" }, ".png" },
  { { "--contours", "nan" }, "--contours" }, { { "--block", "NaN" }, "--block" },
  { { "--sun-angle", "-nan" }, "--sun-angle" }, { { "--sky-light=nan" }, "--sky-light" } };
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

// Where no number is wanted it is a word like others.
TEST_F(TerrainRenderOptions, NanIsAName)
{
  ASSERT_TRUE(std::filesystem::copy_file(this->WriteHill(), this->Path("nan")));
  const RunResult result = this->Run({ "nan", "--size", "32x32", "--legend=nan" });
  EXPECT_EQ(result.Status, 0) << result.Errors;
}

TEST_F(TerrainRenderOptions, HelpAndVersionAreNoErrors)
{
  const RunResult help = this->Run({ "--help" });
  EXPECT_EQ(help.Status, 0);
  for (const char* option :
    { "HEIGHTS", "--output", "--size", "--technique", "--mesh-cells", "--camera", "--view-angle",
      "--exaggeration", "--depth", "--window", "--frames", "--stats", "--crs", "--frame",
      "--curvature", "--origin", "--utm-zone", "--cell", "--cubic", "--vertical", "--geoid",
      "--drape", "--track", "--track-mode", "--look-from", "--look-at", "--sun", "--graticule",
      "--scale-bar", "--north-arrow", "--pixel-tolerance", "--crossings", "--steps", "--long-steps",
      "--step-length", "--secant-steps", "--colors", "--range", "--reverse", "--below-sea",
      "--shadows", "--sun-angle", "--sky-light", "--contours", "--hillshade", "--block", "--legend",
      "a folder or an archive", "height_range", "cell_unit" })
  {
    EXPECT_NE(help.Output.find(option), std::string::npos) << option;
  }
  EXPECT_EQ(this->Run({ "--version" }).Status, 0);
  EXPECT_TRUE(this->ListFiles().empty());
}

// Lights make colours darker or lighter, and leave red red. Rays and strips, a file and a range.
TEST_F(TerrainRenderOptions, ColoursAreThoseAskedFor)
{
  const std::string hill = this->WriteHill();
  this->WriteText("red.cpt", "0 red 100 red\n");
  this->WriteText("low.txt", "0 255 0 0\n1000 0 0 255\n");
  for (const char* technique : { "pyramid", "strips" })
  {
    for (const std::vector<std::string>& colors : { std::vector<std::string>{ "red.cpt" },
           std::vector<std::string>{ "low.txt", "--range", "1000,2000" } })
    {
      std::vector<std::string> arguments{ "--technique", technique, "--colors" };
      arguments.insert(arguments.end(), colors.begin(), colors.end());
      const RunResult result = this->Draw(hill, arguments);
      ASSERT_EQ(result.Status, 0) << result.Errors;
      const Picture picture = this->ReadPicture();
      const Depths depths = this->ReadDepths("depth.tif");
      int red = 0;
      int other = 0;
      for (int y = 1; y < picture.Height - 1; ++y)
      {
        for (int x = 1; x < picture.Width - 1; ++x)
        {
          const bool isOther = picture.At(x, y, 1) > 0 || picture.At(x, y, 2) > 0;
          const bool isInside = std::isfinite(depths.At(x - 1, y)) &&
            std::isfinite(depths.At(x + 1, y)) && std::isfinite(depths.At(x, y - 1)) &&
            std::isfinite(depths.At(x, y + 1)) && std::isfinite(depths.At(x, y));
          red += isInside && !isOther && picture.At(x, y, 0) > 40 ? 1 : 0;
          other += isInside && isOther ? 1 : 0;
        }
      }
      EXPECT_GT(red, 1000) << technique << " " << colors[0];
      EXPECT_EQ(other, 0) << technique << " " << colors[0];
    }
  }
}
