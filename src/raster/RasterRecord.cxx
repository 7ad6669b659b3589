// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterRecord.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace terrain
{
//------------------------------------------------------------------------------
void RasterRecord::Take(
  const std::string& topic, const std::string& value, const std::string& source)
{
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [&topic](const Entry& entry) { return entry.Topic == topic; });
  if (found != this->Entries.end())
  {
    *found = { topic, value, source };
    return;
  }
  this->Entries.push_back({ topic, value, source });
}

//------------------------------------------------------------------------------
void RasterRecord::Warn(const std::string& sentence)
{
  if (!sentence.empty() &&
    std::find(this->Warnings.begin(), this->Warnings.end(), sentence) == this->Warnings.end())
  {
    this->Warnings.push_back(sentence);
  }
}

//------------------------------------------------------------------------------
void RasterRecord::Forget(const std::string& text)
{
  const auto isMoot = [&text](const std::string& warning)
  { return warning.compare(0, 5, "GDAL:") == 0 && warning.find(text) != std::string::npos; };
  this->Warnings.erase(
    std::remove_if(this->Warnings.begin(), this->Warnings.end(), isMoot), this->Warnings.end());
}

//------------------------------------------------------------------------------
bool RasterRecord::HasWarned(const std::string& text) const
{
  return std::any_of(this->Warnings.begin(), this->Warnings.end(),
    [&text](const std::string& warning)
    { return warning.compare(0, 5, "GDAL:") == 0 && warning.find(text) != std::string::npos; });
}

//------------------------------------------------------------------------------
std::vector<std::string> RasterRecord::GetLines() const
{
  std::vector<std::string> lines;
  lines.reserve(this->Entries.size());
  for (const Entry& entry : this->Entries)
  {
    lines.push_back(entry.Topic + ": " + entry.Value +
      (entry.Source.empty() ? std::string() : " (" + entry.Source + ")"));
  }
  return lines;
}

//------------------------------------------------------------------------------
std::string NumberText(double value)
{
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

//------------------------------------------------------------------------------
std::string ListText(const std::vector<std::string>& names, std::size_t most)
{
  std::string text;
  for (std::size_t k = 0; k < names.size() && k < most; ++k)
  {
    text += (k == 0 ? "" : ", ") + names[k];
  }
  return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more"
                             : text;
}
}
