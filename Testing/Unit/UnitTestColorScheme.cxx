// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/colors/ColorFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{
using namespace terrain;

void ExpectColor(const ColorScheme& scheme, double value, const Color& expected)
{
  const Color color = ColorOf(scheme, value);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(color[c], expected[c] / 255.0, 1e-12) << "at " << value << ", channel " << c;
  }
}

ColorRange Range(double lowest, double highest, bool hasSea)
{
  ColorRange range;
  range.Lowest = lowest;
  range.Highest = highest;
  range.HasSea = hasSea;
  return range;
}
}

//--------------------------------------------------------------------------------------------------
TEST(ColorScheme, KnowsItsNames)
{
  for (const std::string& name : ColorSchemeNames())
  {
    const std::optional<ColorScheme> scheme = FindColorScheme(name);
    ASSERT_TRUE(scheme) << name;
    EXPECT_GE(scheme->Stops.size(), 2U) << name;
  }
  EXPECT_FALSE(FindColorScheme(""));
  EXPECT_FALSE(FindColorScheme("Viridis "));
}

// Ends as their authors' tables have them.
TEST(ColorScheme, HasTheColoursOfItsSources)
{
  ExpectColor(*FindColorScheme("viridis"), 0.0, { 0x44, 0x01, 0x54 });
  ExpectColor(*FindColorScheme("viridis"), 0.5, { 0x21, 0x91, 0x8C });
  ExpectColor(*FindColorScheme("viridis"), 1.0, { 0xFD, 0xE7, 0x25 });
  ExpectColor(*FindColorScheme("batlow"), 1.0, { 0xFA, 0xCC, 0xFA });
}

TEST(ColorScheme, LaysTheSeaBelowZero)
{
  const ColorScheme scheme = *FindColorScheme("oleron");
  const ColorScheme both = LaidOver(scheme, Range(-4000.0, 1000.0, true));
  ExpectColor(both, -4000.0, { 0x1A, 0x26, 0x59 });
  ExpectColor(both, 1000.0, { 0xFD, 0xFD, 0xE6 });
  ExpectColor(both, 0.0, { 0x1A, 0x4C, 0x00 }); // the shore is land
  const Color water = ColorOf(both, -1e-9);
  EXPECT_GT(water.b, 0.9);
  const ColorScheme dry = LaidOver(scheme, Range(-4000.0, 1000.0, false));
  ExpectColor(dry, -4000.0, { 0x1A, 0x4C, 0x00 });
  const ColorScheme deep = LaidOver(scheme, Range(-4000.0, -100.0, true));
  ExpectColor(deep, -4000.0, { 0x1A, 0x26, 0x59 });
  EXPECT_GT(ColorOf(deep, -100.0).b, ColorOf(deep, -100.0).r);
  const ColorScheme high = LaidOver(scheme, Range(200.0, 300.0, true));
  ExpectColor(high, 200.0, { 0x1A, 0x4C, 0x00 });
}

TEST(ColorScheme, SurvivesEmptyRanges)
{
  const ColorScheme flat = LaidOver(*FindColorScheme("grey"), Range(5.0, 5.0, false));
  ASSERT_EQ(flat.Stops.size(), 1U);
  EXPECT_TRUE(std::isfinite(ColorOf(flat, 5.0).r));
  EXPECT_TRUE(std::isfinite(ColorOf(Stretched(flat, 1.0, 1.0), 1.0).r));
  EXPECT_EQ(ColorOf(ColorScheme(), 1.0), Color(0.0));
  EXPECT_EQ(ColorOf(flat, std::numeric_limits<double>::quiet_NaN()), Color(0.0));
}

TEST(ColorScheme, TurnsRound)
{
  const ColorScheme scheme = *FindColorScheme("oleron");
  const ColorScheme turned = LaidOver(Reversed(scheme), Range(-10.0, 10.0, true));
  const ColorScheme straight = LaidOver(scheme, Range(-10.0, 10.0, true));
  for (const double value : { 1.0, 3.3, 7.5 })
  {
    EXPECT_LT(glm::length(ColorOf(turned, value) - ColorOf(straight, 10.0 - value)), 1e-9);
    EXPECT_LT(glm::length(ColorOf(turned, -value) - ColorOf(straight, value - 10.0)), 1e-9);
  }
}

// The colour at a doubled value is the upper one's, in files of every kind.
TEST(ColorScheme, StepsAtAValue)
{
  const ColorFileResult palette =
    ReadColorPaletteTable("-10 0 0 255 0 0 128 255\n0 0 100 0 10 255 255 255\n");
  ASSERT_EQ(palette.WhyNot, "");
  const ColorFileResult relief =
    ReadColorReliefText("-10 0 0 255\n0 0 128 255\n0 0 100 0\n10 white\n");
  ASSERT_EQ(relief.WhyNot, "");
  const ColorFileResult map = ReadColorMapText("INTERPOLATION:INTERPOLATED\n-10,0,0,255,255,deep\n"
                                               "0,0,128,255,255,shore\n0,0,100,0,255,land\n"
                                               "10,255,255,255,255,top\n");
  ASSERT_EQ(map.WhyNot, "");
  for (const ColorScheme& scheme : { palette.Scheme, relief.Scheme, map.Scheme })
  {
    ExpectColor(scheme, -10.0, { 0, 0, 255 });
    ExpectColor(scheme, -5.0, { 0, 64, 255 });
    ExpectColor(scheme, 0.0, { 0, 100, 0 });
    ExpectColor(scheme, 10.0, { 255, 255, 255 });
    EXPECT_NEAR(ColorOf(scheme, -1e-12).b, 1.0, 1e-9);
  }
  EXPECT_EQ(map.Scheme.Classes.size(), 4U);
}

//--------------------------------------------------------------------------------------------------
TEST(ColorFile, ReadsPaletteTablesAsGMTWritesThem)
{
  const ColorFileResult result = ReadColorPaletteTable("# COLOR_MODEL = HSV\n#\n"
                                                       "0\t120-1-1\t100\t240-1-1\n"
                                                       "100\t0 1 1\t200\t60 1 1 L\n"
                                                       "B\tblack\nF\twhite\nN\t127.5\n");
  ASSERT_EQ(result.WhyNot, "");
  ExpectColor(result.Scheme, 0.0, { 0, 255, 0 });
  ExpectColor(result.Scheme, 100.0, { 255, 0, 0 });
  ExpectColor(result.Scheme, 200.0, { 255, 255, 0 });
  ExpectColor(result.Scheme, -1.0, { 0, 0, 0 });
  ExpectColor(result.Scheme, 201.0, { 255, 255, 255 });
  ExpectColor(result.Scheme, std::nan(""), { 127.5, 127.5, 127.5 });

  const ColorFileResult names =
    ReadColorPaletteTable("0 steelblue 50 #102030\n50 10/20/30 90 0/50/100/0\n");
  ASSERT_EQ(names.WhyNot, "");
  ExpectColor(names.Scheme, 0.0, { 70, 130, 180 });
  ExpectColor(names.Scheme, 50.0, { 10, 20, 30 });
  ExpectColor(names.Scheme, 90.0, { 255, 127.5, 0 });

  const ColorFileResult classes =
    ReadColorPaletteTable("1 red ;rock\n2 green ;grass\n4 blue ;water\n");
  ASSERT_EQ(classes.WhyNot, "");
  ExpectColor(classes.Scheme, 1.4, { 255, 0, 0 });
  ExpectColor(classes.Scheme, 2.0, { 0, 255, 0 });
  ExpectColor(classes.Scheme, 3.5, { 0, 0, 255 });
  ASSERT_EQ(classes.Scheme.Classes.size(), 3U);
  EXPECT_EQ(classes.Scheme.Classes[1].Name, "grass");
}

TEST(ColorFile, ReadsColorReliefTexts)
{
  const ColorFileResult result =
    ReadColorReliefText("# heights\n100 255:0:0\n0,0,0,255,255\nnv 1 2 3\n");
  ASSERT_EQ(result.WhyNot, "");
  ExpectColor(result.Scheme, 0.0, { 0, 0, 255 });
  ExpectColor(result.Scheme, 50.0, { 127.5, 0, 127.5 });
  ExpectColor(result.Scheme, std::nan(""), { 1, 2, 3 });
  const ColorFileResult shares = ReadColorReliefText("0% black\n100% white\n");
  ASSERT_EQ(shares.WhyNot, "");
  ExpectColor(LaidOver(shares.Scheme, Range(10.0, 20.0, false)), 15.0, { 127.5, 127.5, 127.5 });
}

TEST(ColorFile, ReadsColorMapsOfQGISAndESRI)
{
  const ColorFileResult discrete = ReadColorMapText("# QGIS Generated Color Map Export File\n"
                                                    "INTERPOLATION:DISCRETE\n10,255,0,0,255,low\n"
                                                    "20,0,255,0,255,high\ninf,0,0,255,255,rest\n");
  ASSERT_EQ(discrete.WhyNot, "");
  ExpectColor(discrete.Scheme, -5.0, { 255, 0, 0 });
  ExpectColor(discrete.Scheme, 9.999, { 255, 0, 0 });
  ExpectColor(discrete.Scheme, 15.0, { 0, 255, 0 });
  ExpectColor(discrete.Scheme, 1e6, { 0, 0, 255 });
  const ColorFileResult esri = ReadColorMapText("1 255 0 0\n2 0 255 0\n");
  ASSERT_EQ(esri.WhyNot, "");
  ExpectColor(esri.Scheme, 1.2, { 255, 0, 0 });
  ExpectColor(esri.Scheme, 1.8, { 0, 255, 0 });
}

TEST(ColorFile, RefusesWithTheLine)
{
  for (const char* text : { "", "# nothing\n", "\n\n" })
  {
    EXPECT_NE(ReadColorPaletteTable(text).WhyNot, "");
    EXPECT_NE(ReadColorReliefText(text).WhyNot, "");
    EXPECT_NE(ReadColorMapText(text).WhyNot, "");
  }
  EXPECT_NE(ReadColorPaletteTable("0 0 0 0 10\n").WhyNot.find("line 1"), std::string::npos);
  EXPECT_NE(
    ReadColorPaletteTable("0 red 1 blue\n1 no 2 red\n").WhyNot.find("line 2"), std::string::npos);
  EXPECT_NE(ReadColorPaletteTable("0 0 0 300 1 0 0 0\n").WhyNot, "");
  EXPECT_NE(ReadColorPaletteTable("5 red 1 blue\n").WhyNot, "");
  EXPECT_NE(ReadColorReliefText("0 1 2\n").WhyNot.find("line 1"), std::string::npos);
  EXPECT_NE(ReadColorReliefText("nan 1 2 3\n").WhyNot, "");
  EXPECT_NE(ReadColorReliefText("0% red\n10 blue\n").WhyNot.find("mixed"), std::string::npos);
  EXPECT_NE(ReadColorMapText("INTERPOLATION:CUBIC\n0,1,2,3,255,a\n").WhyNot.find("cubic"),
    std::string::npos);
}

//--------------------------------------------------------------------------------------------------
// "inf" ends the last class of DISCRETE, and stands for nothing elsewhere; values whose differences
// would be infinite are none.
TEST(ColorFile, RefusesWhatHasNoEnd)
{
  const std::string twice = "inf,255,0,0,255,a\ninf,0,255,0,255,b\n";
  for (const std::string& kind : { std::string("INTERPOLATED"), std::string("DISCRETE") })
  {
    EXPECT_NE(ReadColorMapText("INTERPOLATION:" + kind + "\n" + twice).WhyNot.find("'inf'"),
      std::string::npos);
  }
  EXPECT_NE(ReadColorMapText("10,255,0,0,255,a\ninf,0,255,0,255,b\n").WhyNot.find("DISCRETE"),
    std::string::npos);
  EXPECT_NE(ReadColorReliefText("-1.7e308 red\n1.7e308 blue\n").WhyNot, "");
  const ColorFileResult widest = ReadColorReliefText("-1e300 red\n1e300 blue\n");
  ASSERT_EQ(widest.WhyNot, "");
  EXPECT_EQ(Stretched(widest.Scheme, 0.0, 1.0).Stops.back().Value, 1.0);
}

TEST(ColorFile, ReadsTablesOfClasses)
{
  const ColorFileResult plain =
    ReadClassTable("1,#FF0000,rock\n2,green,\"grass, wet\"\n4,0 0 255\n");
  ASSERT_EQ(plain.WhyNot, "");
  EXPECT_TRUE(IsDiscrete(plain.Scheme));
  ExpectColor(plain.Scheme, 1.4, { 255, 0, 0 });
  ExpectColor(plain.Scheme, 2.0, { 0, 255, 0 });
  ExpectColor(plain.Scheme, 3.5, { 0, 0, 255 });
  ASSERT_EQ(plain.Scheme.Classes.size(), 3U);
  EXPECT_EQ(plain.Scheme.Classes[1].Name, "grass, wet");
  EXPECT_EQ(plain.Scheme.Classes[2].Name, "");
  const ColorFileResult named =
    ReadClassTable("# of a survey\nname;note;colour;value\nrock;x;red;7\nlake;y;#0000ff;3\n");
  ASSERT_EQ(named.WhyNot, "");
  ExpectColor(named.Scheme, 3.0, { 0, 0, 255 });
  ExpectColor(named.Scheme, 7.0, { 255, 0, 0 });
  EXPECT_EQ(named.Scheme.Classes[0].Name, "rock");
  EXPECT_EQ(ReadClassTable("").WhyNot, "there are no colours in it");
  EXPECT_NE(ReadClassTable("1,#FF00,rock\n").WhyNot.find("line 1"), std::string::npos);
  EXPECT_NE(ReadClassTable("1,red,a\n2\n").WhyNot.find("line 2"), std::string::npos);
  EXPECT_NE(ReadClassTable("a,b,c\n1,red,a\n").WhyNot.find("line 1"), std::string::npos);
  EXPECT_NE(
    ReadClassTable("1,red,a\n1,blue,b\n").WhyNot.find("1 is there twice"), std::string::npos);
}

TEST(ColorScheme, FindsClasses)
{
  using Numbers = std::vector<int>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ColorScheme keys = ReadClassTable("5,red,five\n1,green,one\n").Scheme;
  EXPECT_EQ(
    ClassesOf(keys, { 1.0, 2.9, 3.1, 5.0, 90.0, -90.0, nan }), (Numbers{ 1, 1, 0, 0, 0, 1, -1 }));
  // up to 10, up to 20, and the rest; a class begins where the one below it ends
  const ColorScheme zones = ReadColorMapText("INTERPOLATION:DISCRETE\n10,255,0,0,255,low\n"
                                             "20,0,255,0,255,high\ninf,0,0,255,255,rest\n")
                              .Scheme;
  ASSERT_EQ(zones.Classes.size(), 3U);
  EXPECT_EQ(zones.Classes[2].Name, "rest");
  EXPECT_EQ(zones.Classes[1].Value, 10.0);
  EXPECT_EQ(ClassesOf(zones, { -1e9, 9.0, 11.0, 19.0, 1e9 }), (Numbers{ 0, 0, 1, 1, 2 }));
  const ColorScheme slices =
    ReadColorPaletteTable("0 red 10 red ;low\n10 blue 20 blue ;high\n").Scheme;
  EXPECT_TRUE(IsDiscrete(slices));
  EXPECT_EQ(ClassesOf(slices, { 0.0, 9.9, 10.0, 20.0 }), (Numbers{ 0, 0, 1, 1 }));
  EXPECT_FALSE(IsDiscrete(*FindColorScheme("relief")));
  EXPECT_FALSE(IsDiscrete(ReadColorPaletteTable("0 red 10 blue\n").Scheme));
  EXPECT_TRUE(ClassesOf({}, {}).empty());
  EXPECT_EQ(ClassesOf({}, { 1.0 }), (Numbers{ -1 }));
}
