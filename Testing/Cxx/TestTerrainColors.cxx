// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainColors: schemes, files of five kinds, ranges, seas, refusals. gdaldem judges its own.
#include "vtkTerrainColors.h"

#include "vtkTerrainTesting.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <gdal.h>
#include <gdal_utils.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

namespace
{
std::string WriteText(const std::string& name, const std::string& text)
{
  const std::filesystem::path folder =
    std::filesystem::path(testing::TempDir()) / "TestTerrainColors";
  std::filesystem::create_directories(folder);
  std::string path = (folder / name).string();
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::array<double, 3> ColorAt(vtkColorTransferFunction* table, double value)
{
  std::array<double, 3> color{};
  table->GetColor(value, color.data());
  return color;
}

void ExpectColor(
  vtkColorTransferFunction* table, double value, double red, double green, double blue)
{
  const std::array<double, 3> color = ColorAt(table, value);
  EXPECT_NEAR(color[0], red, 0.003) << value;
  EXPECT_NEAR(color[1], green, 0.003) << value;
  EXPECT_NEAR(color[2], blue, 0.003) << value;
}
}

TEST(TerrainColors, RefusesInOneSentence)
{
  vtkNew<vtkTerrainColors> colors;
  EXPECT_FALSE(colors->SetScheme("virids"));
  EXPECT_NE(colors->GetErrorMessage().find("viridis"), std::string::npos);
  EXPECT_FALSE(colors->ReadFile("none.cpt"));
  EXPECT_NE(colors->GetErrorMessage().find("none.cpt"), std::string::npos);
  EXPECT_FALSE(colors->ReadFile("photo.png"));
  EXPECT_FALSE(colors->ReadFile(WriteText("cut.qml", "<qgis><colorrampshader><item value=")));
  EXPECT_FALSE(colors->ReadFile(WriteText("empty.qml", "<qgis></qgis>")));
  EXPECT_FALSE(colors->ReadFile(
    WriteText("bad.xml", "<ColorMap><Point x='0' r='2' g='0' b='0'/></ColorMap>")));
  EXPECT_FALSE(colors->ReadFile(WriteText("empty.cpt", "")));
  EXPECT_FALSE(colors->ReadFile(testing::TempDir()));
  EXPECT_FALSE(colors->SetSchemeOrFile("nothing"));
  // what was there before stays
  ExpectColor(colors->MakeTable(0.0, 1.0), 1.0, 0.97, 0.97, 0.98);
}

// Cut at every byte, a file of each kind is read or refused with one line; documents are refused.
TEST(TerrainColors, FilesCutShortAreReadOrRefused)
{
  const std::string item = "<item alpha='255' value='10' label='low' color='#ff0000'/>";
  const std::vector<std::pair<std::string, std::string>> files = {
    { "cut.cpt", "# COLOR_MODEL = RGB\n0 255/0/0 10 0/255/0\n10 0/255/0 20 0/0/255\nB 0/0/0\n" },
    { "cut.txt", "0 255 0 0\n50% 0 255 0\nnv 0 0 0 0\n" },
    { "cut.clr", "ncols 4\n0 255 0 0\n10 0 255 0\n" },
    { "cut.csv", "value,colour,name\n1,#ff0000,low\n2,blue,high\n" },
    { "cut.qml",
      "<qgis><colorrampshader colorRampType='DISCRETE'>" + item + "</colorrampshader></qgis>" },
    { "cut.json", R"([{"ColorSpace": "Lab", "RGBPoints": [0, 0, 0, 1, 1, 1, 0, 0]}])" },
    { "cut.xml", "<ColorMap space='RGB'><Point x='0' o='1' r='0' g='0' b='1'/></ColorMap>" },
  };
  for (const auto& [name, text] : files)
  {
    const bool isDocument = text.front() == '<' || text.front() == '[';
    for (std::size_t end = 0; end < text.size(); ++end)
    {
      vtkNew<vtkTerrainColors> colors;
      const bool isRead = colors->ReadFile(WriteText(name, text.substr(0, end)));
      const std::string why = colors->GetErrorMessage();
      EXPECT_EQ(isRead, why.empty()) << name << " " << end;
      EXPECT_EQ(why.find('\n'), std::string::npos) << why;
      EXPECT_TRUE(isRead || why.find(name) != std::string::npos) << why;
      EXPECT_FALSE(isRead && isDocument) << name << " " << end;
      EXPECT_TRUE(std::isfinite(ColorAt(colors->MakeTable(0.0, 1.0), 0.5)[0]));
    }
  }
}

TEST(TerrainColors, LaysSchemesOverRangesAndSeas)
{
  vtkNew<vtkTerrainColors> colors;
  for (int k = 0; k < vtkTerrainColors::GetNumberOfSchemes(); ++k)
  {
    ASSERT_TRUE(colors->SetScheme(vtkTerrainColors::GetSchemeName(k)));
    const auto table = colors->MakeTable(-3000.0, 1500.0);
    const double* range = table->GetRange();
    EXPECT_EQ(range[0], -3000.0);
    EXPECT_EQ(range[1], 1500.0);
  }
  ASSERT_TRUE(colors->SetScheme("oleron"));
  EXPECT_GT(ColorAt(colors->MakeTable(-3000.0, 1500.0), -10.0)[2], 0.9);  // shallow
  EXPECT_LT(ColorAt(colors->MakeTable(-10.0, 1500.0), -10.0)[2], 0.1);    // a dry pit
  EXPECT_GT(ColorAt(colors->MakeTable(-3000.0, -100.0), -200.0)[2], 0.9); // a survey of the sea
  colors->SetSea(vtkTerrainColors::SeaMode::Never);
  EXPECT_LT(ColorAt(colors->MakeTable(-3000.0, 1500.0), -3000.0)[2], 0.1);
  colors->SetSea(vtkTerrainColors::SeaMode::Always);
  EXPECT_GT(ColorAt(colors->MakeTable(-10.0, 1500.0), -1.0)[2], 0.9);
  colors->SetScheme("grey");
  colors->SetRange(100.0, 200.0);
  colors->ReverseOn();
  ExpectColor(colors->MakeTable(0.0, 1.0), 100.0, 0.97, 0.97, 0.97);
  ExpectColor(colors->MakeTable(0.0, 1.0), 200.0, 0.15, 0.15, 0.15);
}

TEST(TerrainColors, ReadsStylesAndColorMaps)
{
  vtkNew<vtkTerrainColors> colors;
  const std::string items = "<item alpha='255' value='10' label='low' color='#ff0000'/>"
                            "<item alpha='255' value='20' label='high' color='#0000ff'/>";
  ASSERT_TRUE(colors->ReadFile(WriteText("style.qml",
    "<!DOCTYPE qgis><qgis><pipe><rasterrenderer><rastershader>"
    "<colorrampshader colorRampType='INTERPOLATED'>" +
      items + "</colorrampshader></rastershader></rasterrenderer></pipe></qgis>")))
    << colors->GetErrorMessage();
  ExpectColor(colors->MakeTable(0.0, 1.0), 15.0, 0.5, 0.0, 0.5);
  EXPECT_EQ(colors->GetNumberOfCategories(), 2);
  EXPECT_EQ(colors->GetCategoryName(1), "high");
  EXPECT_EQ(colors->GetCategoryValue(1), 20.0);
  ASSERT_TRUE(colors->ReadFile(WriteText("steps.qml",
    "<qgis><colorrampshader colorRampType='DISCRETE'>" + items + "</colorrampshader></qgis>")));
  ExpectColor(colors->MakeTable(0.0, 1.0), 9.0, 1.0, 0.0, 0.0);
  ExpectColor(colors->MakeTable(0.0, 1.0), 11.0, 0.0, 0.0, 1.0);

  ASSERT_TRUE(colors->ReadFile(WriteText("map.xml",
    "<ColorMaps><ColorMap name='x' space='RGB'><Point x='-1' o='1' r='0' g='0' b='1'/>"
    "<Point x='1' o='1' r='1' g='0' b='0'/><NaN r='0' g='1' b='0'/></ColorMap></ColorMaps>")));
  const vtkSmartPointer<vtkColorTransferFunction> table = colors->MakeTable(50.0, 150.0);
  ExpectColor(table, 50.0, 0.0, 0.0, 1.0);
  ExpectColor(table, 100.0, 0.5, 0.0, 0.5);
  EXPECT_EQ(table->GetNanColor()[1], 1.0);
}

// ParaView's presets mix as VTK does in the space that they name.
TEST(TerrainColors, ReadsPresetsOfParaView)
{
  const std::vector<std::array<double, 4>> points = { { -5.0, 0.2, 0.3, 0.75 },
    { 5.0, 0.9, 0.85, 0.3 }, { 20.0, 0.7, 0.02, 0.15 } };
  std::string list;
  vtkNew<vtkColorTransferFunction> expected;
  for (const auto& point : points)
  {
    for (const double number : point)
    {
      list += (list.empty() ? "" : ", ") + std::to_string(number);
    }
    expected->AddRGBPoint(point[0], point[1], point[2], point[3]);
  }
  vtkNew<vtkTerrainColors> colors;
  const auto read = [&](const std::string& space)
  {
    EXPECT_TRUE(colors->ReadFile(WriteText("map.json",
      R"([{"Name": "One", "ColorSpace": ")" + space + R"(", "NanColor": [1, 1, 0], )" +
        R"("UseAboveRangeColor": 1, "AboveRangeColor": [0, 1, 0], "BelowRangeColor": [1, 0, 0], )" +
        R"("RGBPoints": [)" + list + R"(]}, {"Name": "Two", "RGBPoints": [0, 1, 1, 1]}])")))
      << colors->GetErrorMessage();
    const vtkSmartPointer<vtkColorTransferFunction> table = colors->MakeTable(100.0, 350.0);
    for (int k = 0; k <= 100; ++k)
    {
      const std::array<double, 3> color = ColorAt(expected, -5.0 + 0.25 * k);
      const std::array<double, 3> own = ColorAt(table, 100.0 + 2.5 * k);
      for (std::size_t part = 0; part < 3; ++part)
      {
        EXPECT_NEAR(own[part], color[part], 0.012) << space << " at " << k; // hues have corners
      }
    }
    ExpectColor(table, 351.0, 0.0, 1.0, 0.0);
    ExpectColor(table, 99.0, points[0][1], points[0][2], points[0][3]); // not in use
    EXPECT_EQ(table->GetNanColor()[1], 1.0);
  };
  read("RGB");
  expected->SetColorSpaceToLab();
  read("Lab");
  expected->SetColorSpaceToDiverging();
  read("Diverging");
  expected->SetColorSpaceToHSV();
  expected->HSVWrapOff();
  read("HSV");
}

TEST(TerrainColors, ReadsClassesOfParaView)
{
  vtkNew<vtkTerrainColors> colors;
  ASSERT_TRUE(colors->ReadFile(WriteText("classes.json",
    R"({"IndexedColors": [1, 0, 0, 0, 0, 1, 0, 1, 0], "Annotations": ["7", "low", "5", "high"]})")))
    << colors->GetErrorMessage();
  ASSERT_EQ(colors->GetNumberOfCategories(), 3);
  EXPECT_EQ(colors->GetCategoryName(0), "low");
  EXPECT_EQ(colors->GetCategoryValue(0), 7.0);
  EXPECT_EQ(colors->GetCategoryValue(2), 2.0); // the third has no annotation: its number
  std::array<double, 3> color{};
  colors->GetCategoryColor(0, color.data());
  EXPECT_EQ(color[0], 1.0);
  for (const char* text : { "", "[]", "{}", "3", "\"x\"", "[[[[", R"({"RGBPoints": []})",
         R"({"RGBPoints": [0, 0, 0]})", R"({"RGBPoints": [0, 0, 2, 0]})",
         R"({"RGBPoints": ["a", 0, 0, 0]})", R"({"RGBPoints": [1e999, 0, 0, 0]})",
         R"([3, {"RGBPoints": [0, 0, 0, 0]}])", R"({"IndexedColors": [0, 0]})" })
  {
    EXPECT_FALSE(colors->ReadFile(WriteText("bad.json", text))) << text;
    EXPECT_NE(colors->GetErrorMessage().find("bad.json"), std::string::npos);
  }
  EXPECT_FALSE(colors->ReadFile(WriteText("deep.json", std::string(1000000, '['))));
}

// The value of a step has the upper colour; just below it lies the lower one.
TEST(TerrainColors, FillsTables)
{
  vtkNew<vtkTerrainColors> colors;
  vtkNew<vtkColorTransferFunction> table;
  ASSERT_TRUE(colors->SetScheme("grey"));
  colors->FillTable(table, 10.0, 20.0);
  EXPECT_EQ(table->GetRange()[1], 20.0);
  EXPECT_EQ(ColorAt(table, 13.0), ColorAt(colors->MakeTable(10.0, 20.0), 13.0));
  colors->FillTable(nullptr, 10.0, 20.0);
}

TEST(TerrainColors, StepsAtAValue)
{
  vtkNew<vtkTerrainColors> colors;
  ASSERT_TRUE(
    colors->ReadFile(WriteText("sea.cpt", "-100 0 0 255 0 0 0 255\n0 0 128 0 100 white\n")));
  const vtkSmartPointer<vtkColorTransferFunction> table = colors->MakeTable(0.0, 1.0);
  ExpectColor(table, 0.0, 0.0, 128.0 / 255.0, 0.0);
  ExpectColor(table, -1e-9, 0.0, 0.0, 1.0);
}

// The same text and the same values through gdaldem, away from steps.
TEST(TerrainColors, AgreesWithGdaldem)
{
  const std::string text =
    WriteText("relief.txt", "0 10 20 200\n100 30:160:40\n250.5,200,180,90\n900 white\nnv 1 2 3\n");
  constexpr int kCount = 901;
  std::vector<float> ramp(kCount);
  for (int k = 0; k < kCount; ++k)
  {
    ramp[static_cast<std::size_t>(k)] = static_cast<float>(k);
  }
  GDALAllRegister();
  GDALDatasetH source =
    GDALCreate(GDALGetDriverByName("MEM"), "", kCount, 1, 1, GDT_Float32, nullptr);
  ASSERT_EQ(GDALRasterIO(GDALGetRasterBand(source, 1), GF_Write, 0, 0, kCount, 1, ramp.data(),
              kCount, 1, GDT_Float32, 0, 0),
    CE_None);
  std::array<char, 4> option{ "-of" };
  std::array<char, 4> format{ "MEM" };
  std::array<char*, 3> arguments{ option.data(), format.data(), nullptr };
  GDALDEMProcessingOptions* options = GDALDEMProcessingOptionsNew(arguments.data(), nullptr);
  GDALDatasetH relief =
    GDALDEMProcessing("", source, "color-relief", text.c_str(), options, nullptr);
  ASSERT_TRUE(relief);
  vtkNew<vtkTerrainColors> colors;
  ASSERT_TRUE(colors->ReadFile(text)) << colors->GetErrorMessage();
  const vtkSmartPointer<vtkColorTransferFunction> table = colors->MakeTable(0.0, 1.0);
  for (int band = 0; band < 3; ++band)
  {
    std::vector<unsigned char> bytes(kCount);
    ASSERT_EQ(GDALRasterIO(GDALGetRasterBand(relief, band + 1), GF_Read, 0, 0, kCount, 1,
                bytes.data(), kCount, 1, GDT_Byte, 0, 0),
      CE_None);
    for (int k = 0; k < kCount; ++k)
    {
      const double own = 255.0 * ColorAt(table, k)[static_cast<std::size_t>(band)];
      ASSERT_NEAR(own, bytes[static_cast<std::size_t>(k)], 1.0) << "at " << k;
    }
  }
  GDALClose(relief);
  GDALClose(source);
  GDALDEMProcessingOptionsFree(options);
}
