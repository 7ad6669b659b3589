// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

namespace
{
/// Text as it stands in HTML and SVG.
std::string Escaped(const std::string& text)
{
  std::string result;
  for (const char character : text)
  {
    switch (character)
    {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += character;
    }
  }
  return result;
}

/// Text as a string of JSON.
std::string Quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char character : text)
  {
    if (character == '"' || character == '\\')
    {
      result += '\\';
      result += character;
    }
    else if (static_cast<unsigned char>(character) < 0x20)
    {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\u%04x", static_cast<unsigned>(character));
      result += code.data();
    }
    else
    {
      result += character;
    }
  }
  return result + '"';
}

std::string Number(double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9g", value);
  return std::isfinite(value) ? text.data() : "null";
}

/// "[a,b,...]" of what `write` makes of each item.
template <typename Items, typename Write>
std::string List(const Items& items, Write&& write)
{
  std::string result = "[";
  for (const auto& item : items)
  {
    result += (result.size() > 1 ? "," : "") + write(item);
  }
  return result + "]";
}

/// One axis: from values to pixels.
struct Axis
{
  bool IsLogarithmic = false;
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();
  double Begin = 0.0;
  double End = 1.0;

  double Scaled(double value) const
  {
    return this->IsLogarithmic ? std::log10(std::max(value, 1e-300)) : value;
  }
  void Include(double value)
  {
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
  }
  /// Widened to whole decades, or from 0 on.
  void Round()
  {
    if (this->IsLogarithmic)
    {
      this->Low = std::pow(10.0, std::floor(std::log10(this->Low) + 1e-9));
      this->High = std::pow(10.0, std::ceil(std::log10(this->High) - 1e-9));
      this->High = this->High > this->Low ? this->High : 10.0 * this->Low;
    }
    else
    {
      this->Low = std::min(this->Low, 0.0);
      this->High = this->High > this->Low ? this->High : this->Low + 1.0;
    }
  }
  double At(double value) const
  {
    const double low = this->Scaled(this->Low);
    const double part = (this->Scaled(value) - low) / (this->Scaled(this->High) - low);
    return this->Begin + part * (this->End - this->Begin);
  }
  std::vector<double> Ticks() const
  {
    std::vector<double> ticks;
    if (this->IsLogarithmic)
    {
      for (double tick = this->Low; tick <= 1.001 * this->High; tick *= 10.0)
      {
        ticks.push_back(tick);
      }
      return ticks;
    }
    for (int i = 0; i <= 5; ++i)
    {
      ticks.push_back(this->Low + 0.2 * i * (this->High - this->Low));
    }
    return ticks;
  }
};

constexpr std::array<const char*, 8> kColors{ "#1b6ca8", "#c0392b", "#1e8449", "#8e44ad", "#b9770e",
  "#117a65", "#5d6d7e", "#d81b60" };
constexpr double kWidth = 720.0;
constexpr double kHeight = 400.0;
constexpr double kLeft = 70.0;
constexpr double kRight = 210.0;
constexpr double kTop = 20.0;
constexpr double kBottom = 50.0;

void AddText(std::ostream& svg, double x, double y, const char* anchor, const std::string& text)
{
  svg << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\">"
      << Escaped(text) << "</text>\n";
}

void AddLine(std::ostream& svg, double x1, double y1, double x2, double y2)
{
  svg << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2
      << "\" stroke=\"#ccc\"/>\n";
}

void AddAxes(std::ostream& svg, const Plot& plot, const Axis& x, const Axis& y)
{
  for (const double tick : x.Ticks())
  {
    AddLine(svg, x.At(tick), y.Begin, x.At(tick), y.End);
    AddText(svg, x.At(tick), y.Begin + 16.0, "middle", Digits(tick));
  }
  for (const double tick : y.Ticks())
  {
    AddLine(svg, x.Begin, y.At(tick), x.End, y.At(tick));
    AddText(svg, x.Begin - 6.0, y.At(tick) + 4.0, "end", Digits(tick));
  }
  AddText(svg, 0.5 * (x.Begin + x.End), kHeight - 10.0, "middle", plot.XLabel);
  svg << "<text transform=\"translate(14 " << 0.5 * (y.Begin + y.End)
      << ") rotate(-90)\" text-anchor=\"middle\">" << Escaped(plot.YLabel) << "</text>\n";
}

void AddCurve(std::ostream& svg, const Series& series, const Axis& x, const Axis& y, int index)
{
  const char* color = kColors[static_cast<std::size_t>(index) % kColors.size()];
  svg << R"(<polyline fill="none" stroke-width="2" stroke=")" << color << "\" points=\"";
  for (const auto& [a, b] : series.Points)
  {
    svg << x.At(a) << "," << y.At(b) << " ";
  }
  svg << "\"/>\n";
  for (const auto& [a, b] : series.Points)
  {
    svg << R"(<circle r="3" fill=")" << color << "\" cx=\"" << x.At(a) << "\" cy=\"" << y.At(b)
        << "\"><title>" << Escaped(series.Name) << ": " << Digits(a) << ", " << Digits(b)
        << "</title></circle>\n";
  }
  const double line = y.End + 8.0 + 18.0 * index;
  svg << "<rect x=\"" << x.End + 12.0 << "\" y=\"" << line << R"(" width="14" height="4" fill=")"
      << color << "\"/>\n";
  AddText(svg, x.End + 32.0, line + 6.0, "start", series.Name);
}

void AddTable(std::ostream& html, const Table& table)
{
  html << "<h3>" << Escaped(table.Title) << "</h3>\n<p>" << Escaped(table.Caption)
       << "</p>\n<table><thead><tr>";
  for (const std::string& cell : table.Header)
  {
    html << "<th>" << Escaped(cell) << "</th>";
  }
  html << "</tr></thead><tbody>\n";
  for (const auto& row : table.Rows)
  {
    html << "<tr>";
    for (const std::string& cell : row)
    {
      html << "<td>" << Escaped(cell) << "</td>";
    }
    html << "</tr>\n";
  }
  html << "</tbody></table>\n";
}

constexpr const char* kStyle =
  "body{font:15px/1.45 sans-serif;max-width:60em;margin:2em auto;padding:0 1em;color:#222}"
  "table{border-collapse:collapse;margin:1em 0}th,td{border:1px solid #ccc;padding:.25em .6em;"
  "text-align:right}th:first-child,td:first-child{text-align:left}th{background:#f2f4f6}"
  "svg{font:12px sans-serif;max-width:100%;height:auto}h2{margin-top:2em}";
}

//------------------------------------------------------------------------------
std::string Digits(double value)
{
  std::array<char, 40> text{};
  const double size = std::abs(value);
  const int decimals = size == 0.0 || size >= 100.0
    ? 0
    : std::min(6, 2 - static_cast<int>(std::floor(std::log10(size))));
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  std::string result = text.data();
  if (result.find('.') != std::string::npos && size < 1.0)
  {
    result.erase(result.find_last_not_of('0') + 1);
    result.erase(result.find_last_not_of('.') + 1);
  }
  return std::isfinite(value) ? result : "-";
}

//------------------------------------------------------------------------------
std::string Range(double low, double high)
{
  const std::string first = Digits(low);
  const std::string last = Digits(high);
  return first == last ? first : first + " to " + last;
}

//------------------------------------------------------------------------------
std::string ToSvg(const Plot& plot)
{
  Axis x;
  Axis y;
  x.IsLogarithmic = plot.IsXLogarithmic;
  y.IsLogarithmic = plot.IsYLogarithmic;
  for (const Series& series : plot.Curves)
  {
    for (const auto& [a, b] : series.Points)
    {
      x.Include(a);
      y.Include(b);
    }
  }
  if (!(x.Low <= x.High))
  {
    return "<p>Nothing was measured.</p>";
  }
  x.Round();
  y.Round();
  x.Begin = kLeft;
  x.End = kWidth - kRight;
  y.Begin = kHeight - kBottom;
  y.End = kTop;
  std::ostringstream svg;
  svg << R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" << kWidth << "\" height=\"" << kHeight
      << "\" viewBox=\"0 0 " << kWidth << " " << kHeight << R"(" role="img"><title>)"
      << Escaped(plot.Title) << "</title>\n";
  AddAxes(svg, plot, x, y);
  int index = 0;
  for (const Series& series : plot.Curves)
  {
    AddCurve(svg, series, x, y, index++);
  }
  svg << "</svg>\n";
  return svg.str();
}

//------------------------------------------------------------------------------
std::string ToHtml(const Report& report)
{
  std::ostringstream html;
  html << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
          "<title>vtkTerrain, measured</title><style>"
       << kStyle << "</style></head><body>\n<h1>vtkTerrain, measured</h1>\n<table><tbody>\n";
  for (const auto& [name, value] : report.Facts)
  {
    html << "<tr><td>" << Escaped(name) << "</td><td>" << Escaped(value) << "</td></tr>\n";
  }
  html << "</tbody></table>\n";
  for (const Section& section : report.Sections)
  {
    html << "<h2>" << Escaped(section.Title) << "</h2>\n<p>" << Escaped(section.Text) << "</p>\n";
    for (const Table& table : section.Tables)
    {
      AddTable(html, table);
    }
    for (const Plot& plot : section.Plots)
    {
      html << "<h3>" << Escaped(plot.Title) << "</h3>\n<p>" << Escaped(plot.Caption) << "</p>\n"
           << ToSvg(plot);
    }
  }
  html << "</body></html>\n";
  return html.str();
}

//------------------------------------------------------------------------------
std::string ToJson(const Report& report)
{
  const auto texts = [](const std::vector<std::string>& items) { return List(items, Quoted); };
  const auto table = [&texts](const Table& item)
  {
    return "{\"title\":" + Quoted(item.Title) + ",\"caption\":" + Quoted(item.Caption) +
      ",\"header\":" + texts(item.Header) + ",\"rows\":" + List(item.Rows, texts) + "}";
  };
  const auto curve = [](const Series& item)
  {
    const auto point = [](const std::pair<double, double>& at)
    { return "[" + Number(at.first) + "," + Number(at.second) + "]"; };
    return "{\"name\":" + Quoted(item.Name) + ",\"points\":" + List(item.Points, point) + "}";
  };
  const auto plot = [&curve](const Plot& item)
  {
    return "{\"title\":" + Quoted(item.Title) + ",\"x\":" + Quoted(item.XLabel) +
      ",\"y\":" + Quoted(item.YLabel) + ",\"curves\":" + List(item.Curves, curve) + "}";
  };
  const auto section = [&](const Section& item)
  {
    return "{\"title\":" + Quoted(item.Title) + ",\"text\":" + Quoted(item.Text) +
      ",\"tables\":" + List(item.Tables, table) + ",\"plots\":" + List(item.Plots, plot) + "}";
  };
  const auto fact = [](const std::pair<std::string, std::string>& item)
  { return "[" + Quoted(item.first) + "," + Quoted(item.second) + "]"; };
  return "{\"facts\":" + List(report.Facts, fact) +
    ",\"sections\":" + List(report.Sections, section) + "}\n";
}
