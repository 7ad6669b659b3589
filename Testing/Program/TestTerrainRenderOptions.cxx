// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line of terrain-render: what is refused, and with which sentence.
#include "TerrainRenderFixture.h"

#include <ostream>

namespace
{
/// Arguments, and what the sentence about them has to mention.
struct WrongArguments
{
  std::vector<std::string> Arguments;
  std::string Mention;
};

void PrintTo(const WrongArguments& wrong, std::ostream* stream)
{
  for (const std::string& argument : wrong.Arguments)
  {
    *stream << argument << ' ';
  }
}

class TerrainRenderOptions
  : public TerrainRenderFixture
  , public ::testing::WithParamInterface<WrongArguments>
{
};
}

TEST_P(TerrainRenderOptions, AreRefused)
{
  const RunResult result = this->Run(this->GetParam().Arguments);
  ExpectRefused(result, 2, this->GetParam().Mention);
  EXPECT_TRUE(this->ListFiles().empty());
}

INSTANTIATE_TEST_SUITE_P(Wrong, TerrainRenderOptions,
  ::testing::Values( //
    WrongArguments{ { "--size", "0x720" }, "--size" },
    WrongArguments{ { "--size", "1280x0" }, "--size" },
    WrongArguments{ { "--size", "-4x720" }, "--size" },
    WrongArguments{ { "--size", "1000000000x1000000000" }, "1000000000" },
    WrongArguments{ { "--size", "1e9x1e9" }, "--size" },
    WrongArguments{ { "--size", "99999999999999999999x1" }, "--size" },
    WrongArguments{ { "--size", "nanxnan" }, "nan" },
    WrongArguments{ { "--size", "12.5x10" }, "whole number" },
    WrongArguments{ { "--size", "1280" }, "WIDTHxHEIGHT" },
    WrongArguments{ { "--size", "1280x720x3" }, "720x3" },
    WrongArguments{ { "--size" }, "--size" }, //
    WrongArguments{ { "--mesh-cells", "0" }, "--mesh-cells" },
    WrongArguments{ { "--mesh-cells", "-1" }, "--mesh-cells" },
    WrongArguments{ { "--mesh-cells", "1e9" }, "--mesh-cells" },
    WrongArguments{ { "--mesh-cells", "many" }, "many" },
    WrongArguments{ { "--frames", "0" }, "--frames" },
    WrongArguments{ { "--frames", "1e9" }, "--frames" },
    WrongArguments{ { "--frames", "inf" }, "--frames" },
    WrongArguments{ { "--exaggeration", "nan" }, "--exaggeration" },
    WrongArguments{ { "--exaggeration", "-inf" }, "--exaggeration" },
    WrongArguments{ { "--exaggeration", "0" }, "--exaggeration" },
    WrongArguments{ { "--exaggeration", "-2" }, "--exaggeration" },
    WrongArguments{ { "--exaggeration", "1e9" }, "--exaggeration" },
    WrongArguments{ { "--view-angle", "0" }, "--view-angle" },
    WrongArguments{ { "--view-angle", "180" }, "--view-angle" },
    WrongArguments{ { "--view-angle", "wide" }, "wide" },
    WrongArguments{ { "--technique", "quick" }, "quick" },
    WrongArguments{ { "--window", "wayland" }, "wayland" },
    WrongArguments{ { "--camera", "1,2,3" }, "6 or 9" },
    WrongArguments{ { "--camera", "1,2,3,4,5,6,7" }, "6 or 9" },
    WrongArguments{ { "--camera", "1,2,3,4,5,six" }, "six" },
    WrongArguments{ { "--camera", "1,2,3,4,5," }, "6 or 9" },
    WrongArguments{ { "--camera", "1,2,3,4,,6" }, "--camera" },
    WrongArguments{ { "--camera", "nan,2,3,4,5,6" }, "nan" },
    WrongArguments{ { "--camera", "1,2,3,1,2,3" }, "focal point" },
    WrongArguments{ { "--camera", "0,0,9,0,0,0,0,0,1" }, "up vector" },
    WrongArguments{ { "--camera", "0,0,9,0,0,0,0,0,0" }, "up vector" },
    WrongArguments{ { "--output", "" }, "--output" },
    WrongArguments{ { "--output", "a.png", "--depth", "a.png" }, "a.png" },
    WrongArguments{ { "a.tif", "--output", "a.tif" }, "a.tif" },
    WrongArguments{ { "a.tif", "b.tif" }, "b.tif" }, //
    WrongArguments{ { "--fast" }, "--fast" }));

TEST_F(TerrainRenderFixture, HelpAndVersionAreNoErrors)
{
  const RunResult help = this->Run({ "--help" });
  EXPECT_EQ(help.Status, 0);
  for (const char* option :
    { "HEIGHTS", "--output", "--size", "--technique", "--mesh-cells", "--camera", "--view-angle",
      "--exaggeration", "--depth", "--window", "--frames", "--stats" })
  {
    EXPECT_NE(help.Output.find(option), std::string::npos) << option;
  }
  EXPECT_EQ(this->Run({ "--version" }).Status, 0);
  EXPECT_TRUE(this->ListFiles().empty());
}
