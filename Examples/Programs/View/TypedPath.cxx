// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TypedPath.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace
{
constexpr char kBackspace = 8;
constexpr char kDelete = 127;
constexpr char kEscape = 27;

/// Names in a folder that begin with some letters, folders with a stroke behind them.
std::vector<std::string> NamesIn(const fs::path& folder, const std::string& begin)
{
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end;
       !error && entry != end; entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    const bool isHidden = name.front() == '.' && begin.empty();
    if (!isHidden && name.compare(0, begin.size(), begin) == 0)
    {
      std::error_code unknown;
      names.push_back(name + (entry->is_directory(unknown) ? "/" : ""));
    }
  }
  return names;
}
}

//------------------------------------------------------------------------------
void TypedPath::Begin()
{
  this->Now = State::Typing;
  this->Text.clear();
}

//------------------------------------------------------------------------------
TypedPath::State TypedPath::Take(char key)
{
  if (key == '\r' || key == '\n')
  {
    this->Now = this->Text.empty() ? State::Off : State::Done;
  }
  else if (key == kEscape)
  {
    this->Now = State::Off;
  }
  else if (key == '\t')
  {
    this->Complete();
  }
  else if ((key == kBackspace || key == kDelete) && !this->Text.empty())
  {
    this->Text.pop_back();
  }
  else if (static_cast<unsigned char>(key) >= ' ' && key != kDelete)
  {
    this->Text += key;
  }
  return this->Now;
}

//------------------------------------------------------------------------------
std::string TypedPath::GetPath() const
{
  const char* home = std::getenv("HOME");
  return home && this->Text.compare(0, 2, "~/") == 0 ? home + this->Text.substr(1) : this->Text;
}

//------------------------------------------------------------------------------
std::string TypedPath::GetPrompt() const
{
  return "open: " + this->Text + "_   (Tab completes, Return opens, Escape leaves)";
}

//------------------------------------------------------------------------------
void TypedPath::Complete()
{
  const fs::path path = this->GetPath();
  const std::string begin = path.filename().string();
  const std::vector<std::string> names = NamesIn(path.parent_path(), begin);
  if (names.empty())
  {
    return;
  }
  std::string common = names.front();
  for (const std::string& name : names)
  {
    const auto unlike = std::mismatch(common.begin(), common.end(), name.begin(), name.end()).first;
    common.erase(unlike, common.end());
  }
  this->Text += common.substr(begin.size());
}
