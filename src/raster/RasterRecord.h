// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What was taken from where when a raster was opened, and what there is to warn of. Private to the
 * module.
 */
#ifndef vtkTerrain_raster_RasterRecord_h
#define vtkTerrain_raster_RasterRecord_h

#include <stdexcept>
#include <string>
#include <vector>

namespace terrain
{
/// Why a raster cannot be used: one sentence without the file's name.
class RasterError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Sites of a folder that are far from each other, and the one that was taken for covering most.
struct RasterSites
{
  int Count = 1;
  int Taken = 1;
  /// Empty where there is one, or one was named.
  std::string Warning;
};

/// Lines "topic: value (source)" in the order in which they were found, one a topic, and sentences
/// of warning, each once.
class RasterRecord
{
public:
  /// Notes a value; a later one of the same topic replaces it.
  void Take(const std::string& topic, const std::string& value, const std::string& source);
  /// One sentence that names what is doubtful and what to do about it, without the file's name.
  void Warn(const std::string& sentence);
  /// Drops GDAL's warnings that hold a text: what they tell of has been seen to.
  void Forget(const std::string& text);
  /// True if GDAL has warned with this text.
  bool HasWarned(const std::string& text) const;

  /// "topic: value (source)".
  std::vector<std::string> GetLines() const;
  const std::vector<std::string>& GetWarnings() const
  {
    return this->Warnings;
  }
  /// Not among the warnings: whoever draws all sites does not tell of it.
  void SetSites(const RasterSites& sites)
  {
    this->Sites = sites;
  }
  const RasterSites& GetSites() const
  {
    return this->Sites;
  }

private:
  struct Entry
  {
    std::string Topic;
    std::string Value;
    std::string Source;
  };
  std::vector<Entry> Entries;
  std::vector<std::string> Warnings;
  RasterSites Sites;
};

/// A number as people write it, up to 10 digits.
std::string NumberText(double value);
/// Names with commas between them, at most `most` of them, then how many are left out.
std::string ListText(const std::vector<std::string>& names, std::size_t most);
}
#endif
