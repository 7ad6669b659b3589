// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What --stats writes: counts, sizes and times.
 */
#ifndef terrain_render_Statistics_h
#define terrain_render_Statistics_h

#include <cstdint>
#include <map>
#include <string>
#include <vector>

/**
 * Collects numbers and times, and gives them as a JSON object: texts, counts and lists of counts
 * under their names, every stage that was timed under its name as {"min", "median", "max"} in
 * milliseconds, and the peak of the memory held by the process so far as "peak_memory_bytes".
 */
class Statistics
{
public:
  void SetText(const std::string& name, const std::string& text);
  void SetCount(const std::string& name, std::int64_t count);
  /// Counts under one name, such as those of a histogram: entry k tells how many had k.
  void SetList(const std::string& name, const std::vector<std::int64_t>& counts);
  void SetNumber(const std::string& name, double number);
  /// Numbers under one name.
  void SetNumbers(const std::string& name, const std::vector<double>& numbers);
  /// Texts under one name.
  void SetTexts(const std::string& name, const std::vector<std::string>& texts);
  /// One more text under a name.
  void AddText(const std::string& name, const std::string& text);
  /// One more duration of a stage, in milliseconds.
  void AddTime(const std::string& stage, double milliseconds);

  std::string ToJson() const;

private:
  std::map<std::string, std::string> Texts;
  std::map<std::string, std::int64_t> Counts;
  std::map<std::string, std::vector<std::int64_t>> Lists;
  std::map<std::string, double> SingleNumbers;
  std::map<std::string, std::vector<double>> Numbers;
  std::map<std::string, std::vector<std::string>> ManyTexts;
  std::map<std::string, std::vector<double>> Times;
};

/// Measures from its construction on.
class Stopwatch
{
public:
  Stopwatch();
  double GetMilliseconds() const;

private:
  std::int64_t BeginNanoseconds = 0;
};

#endif
