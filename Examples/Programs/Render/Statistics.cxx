// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics.h"

#include "vtk_jsoncpp.h"

#include <algorithm>
#include <chrono>
#include <fstream>

namespace
{
std::int64_t NowNanoseconds()
{
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
    std::chrono::steady_clock::now().time_since_epoch())
    .count();
}

/// Largest resident size of the process so far, in bytes; 0 if the system does not tell.
std::int64_t PeakMemoryBytes()
{
  // Not getrusage: its maximum includes that of the process this one was started from.
  constexpr std::int64_t kBytesPerUnit = 1024;
  const std::string name = "VmHWM:";
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    std::int64_t kilobytes = 0;
    if (word == name && status >> kilobytes)
    {
      return kilobytes * kBytesPerUnit;
    }
  }
  return 0;
}

/// The lower of the two in the middle if their number is even.
Json::Value Summary(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  Json::Value summary(Json::objectValue);
  summary["min"] = times.front();
  summary["median"] = times[(times.size() - 1) / 2];
  summary["max"] = times.back();
  return summary;
}
}

//------------------------------------------------------------------------------
void Statistics::SetText(const std::string& name, const std::string& text)
{
  this->Texts[name] = text;
}

//------------------------------------------------------------------------------
void Statistics::SetCount(const std::string& name, std::int64_t count)
{
  this->Counts[name] = count;
}

//------------------------------------------------------------------------------
void Statistics::SetList(const std::string& name, const std::vector<std::int64_t>& counts)
{
  this->Lists[name] = counts;
}

//------------------------------------------------------------------------------
void Statistics::SetNumber(const std::string& name, double number)
{
  this->SingleNumbers[name] = number;
}

//------------------------------------------------------------------------------
void Statistics::SetNumbers(const std::string& name, const std::vector<double>& numbers)
{
  this->Numbers[name] = numbers;
}

//------------------------------------------------------------------------------
void Statistics::SetTexts(const std::string& name, const std::vector<std::string>& texts)
{
  this->ManyTexts[name] = texts;
}

//------------------------------------------------------------------------------
void Statistics::AddText(const std::string& name, const std::string& text)
{
  this->ManyTexts[name].push_back(text);
}

//------------------------------------------------------------------------------
void Statistics::AddTime(const std::string& stage, double milliseconds)
{
  this->Times[stage].push_back(milliseconds);
}

//------------------------------------------------------------------------------
std::string Statistics::ToJson() const
{
  Json::Value root(Json::objectValue);
  for (const auto& [name, text] : this->Texts)
  {
    root[name] = text;
  }
  for (const auto& [name, count] : this->Counts)
  {
    root[name] = static_cast<Json::Int64>(count);
  }
  for (const auto& [name, counts] : this->Lists)
  {
    Json::Value& list = root[name] = Json::Value(Json::arrayValue);
    for (const std::int64_t count : counts)
    {
      list.append(static_cast<Json::Int64>(count));
    }
  }
  for (const auto& [name, number] : this->SingleNumbers)
  {
    root[name] = number;
  }
  for (const auto& [name, numbers] : this->Numbers)
  {
    Json::Value& list = root[name] = Json::Value(Json::arrayValue);
    for (const double number : numbers)
    {
      list.append(number);
    }
  }
  for (const auto& [name, texts] : this->ManyTexts)
  {
    Json::Value& list = root[name] = Json::Value(Json::arrayValue);
    for (const std::string& text : texts)
    {
      list.append(text);
    }
  }
  for (const auto& [stage, times] : this->Times)
  {
    root[stage] = Summary(times);
  }
  root["peak_memory_bytes"] = static_cast<Json::Int64>(PeakMemoryBytes());
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "  ";
  return Json::writeString(builder, root) + "\n";
}

//------------------------------------------------------------------------------
Stopwatch::Stopwatch()
  : BeginNanoseconds(NowNanoseconds())
{
}

//------------------------------------------------------------------------------
double Stopwatch::GetMilliseconds() const
{
  constexpr double kNanosecondsPerMillisecond = 1e6;
  return static_cast<double>(NowNanoseconds() - this->BeginNanoseconds) /
    kNanosecondsPerMillisecond;
}
