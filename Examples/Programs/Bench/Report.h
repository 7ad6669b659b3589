// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a report holds, and how it is written: a page that opens without a network, and JSON.
 */
#ifndef terrain_bench_Report_h
#define terrain_bench_Report_h

#include <string>
#include <utility>
#include <vector>

/// Rows of texts below a header; all of one length.
struct Table
{
  std::string Title;
  /// What is measured, and beside what: sentences.
  std::string Caption;
  std::vector<std::string> Header;
  std::vector<std::vector<std::string>> Rows;
};

/// Points in order of x. Both are > 0 on a logarithmic axis.
struct Series
{
  std::string Name;
  std::vector<std::pair<double, double>> Points;
};

/// Curves over one x axis.
struct Plot
{
  std::string Title;
  std::string Caption;
  std::string XLabel;
  std::string YLabel;
  bool IsXLogarithmic = true;
  bool IsYLogarithmic = true;
  std::vector<Series> Curves;
};

/// Tables and plots under one heading.
struct Section
{
  std::string Title;
  std::string Text;
  std::vector<Table> Tables;
  std::vector<Plot> Plots;
};

struct Report
{
  /// Names and values: machine, driver, date, settings.
  std::vector<std::pair<std::string, std::string>> Facts;
  std::vector<Section> Sections;
};

/// A number with three digits that count, such as 0.0123, 1.23, 123, 12300.
std::string Digits(double value);

/// Numbers with three digits, "1.20 to 3.40"; one number where both read alike.
std::string Range(double low, double high);

/// The report as one page without links to anything.
std::string ToHtml(const Report& report);

/// The report as JSON: facts, and sections of tables and plots.
std::string ToJson(const Report& report);

/// A plot as an SVG element.
std::string ToSvg(const Plot& plot);

#endif
