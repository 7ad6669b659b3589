// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// terrain-bench: that its report is whole, opens without a network, and that bad input ends in a
// sentence. No time is judged.
#include "TerrainRenderFixture.h"

#include <vtk_jsoncpp.h>

#include <memory>

namespace
{
class TerrainBench : public TerrainRenderFixture
{
protected:
  RunResult Bench(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), TERRAIN_BENCH_PROGRAM);
    return this->RunCommand(arguments);
  }
};

TEST_F(TerrainBench, ReportIsWhole)
{
  const RunResult result = this->Bench({ "--report", "report", "--smoke" });
  ASSERT_EQ(result.Status, 0) << result.Errors;
  EXPECT_NE(result.Output.find("report/index.html"), std::string::npos);
  const std::string text = this->ReadText("report/report.json");
  Json::Value report;
  const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
  ASSERT_TRUE(reader->parse(text.data(), text.data() + text.size(), &report, nullptr)) << text;
  ASSERT_EQ(report["sections"].size(), 5U);
  unsigned int tables = 0;
  unsigned int plots = 0;
  for (const Json::Value& section : report["sections"])
  {
    for (const Json::Value& table : section["tables"])
    {
      ++tables;
      EXPECT_GT(table["rows"].size(), 0U) << table["title"];
      for (const Json::Value& row : table["rows"])
      {
        EXPECT_EQ(row.size(), table["header"].size()) << table["title"];
      }
    }
    for (const Json::Value& plot : section["plots"])
    {
      ++plots;
      for (const Json::Value& curve : plot["curves"])
      {
        EXPECT_GT(curve["points"].size(), 0U) << curve["name"];
        for (const Json::Value& point : curve["points"])
        {
          EXPECT_TRUE(point[0].isNumeric() && point[1].isNumeric()) << curve["name"];
        }
      }
    }
  }
  EXPECT_GE(tables, 5U);
  EXPECT_GE(plots, 4U);

  const std::string page = this->ReadText("report/index.html");
  for (const char* link : { "href=", "src=", "url(", "@import", "<script" })
  {
    EXPECT_EQ(page.find(link), std::string::npos) << link;
  }
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("8800 GT"), std::string::npos);
  EXPECT_NE(page.find("</html>"), std::string::npos);
}

TEST_F(TerrainBench, SearchesOfTheReportAreRight)
{
  const RunResult result = this->Bench({ "--report", "report", "--smoke", "--only", "searches" });
  ASSERT_EQ(result.Status, 0) << result.Errors;
  Json::Value report;
  const std::string text = this->ReadText("report/report.json");
  const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
  ASSERT_TRUE(reader->parse(text.data(), text.data() + text.size(), &report, nullptr));
  ASSERT_EQ(report["sections"].size(), 1U);
  int rows = 0;
  for (const Json::Value& row : report["sections"][0]["tables"][1]["rows"])
  {
    if (row[1] == "equidistant")
    {
      ++rows;
      EXPECT_LE(std::stod(row[6].asString()), 0.05);
      EXPECT_LE(std::stod(row[7].asString()), 0.5);
    }
  }
  EXPECT_EQ(rows, 2);
}

TEST_F(TerrainBench, RefusesWhatItCannotDo)
{
  const std::vector<std::pair<std::vector<std::string>, std::string>> refused{ { {}, "--report" },
    { { "--report" }, "--report" }, { { "--report", "r", "--largest", "5" }, "--largest" },
    { { "--report", "r", "--frames", "0" }, "--frames" },
    { { "--report", "r", "--frames", "nan" }, "--frames" }, { { "--report=", "r" }, "--report" },
    { { "--report", "r", "--only", "everything" }, "everything" } };
  for (const auto& [arguments, word] : refused)
  {
    const RunResult result = this->Bench(arguments);
    EXPECT_EQ(result.Status, 2) << word;
    EXPECT_NE(result.Errors.find(word), std::string::npos) << result.Errors;
  }
  this->WriteHill();
  const std::string file = this->ListFiles().front();
  const RunResult result = this->Bench({ "--report", file + "/report", "--smoke" });
  EXPECT_EQ(result.Status, 1);
  EXPECT_NE(result.Errors.find(file), std::string::npos) << result.Errors;
}
}
