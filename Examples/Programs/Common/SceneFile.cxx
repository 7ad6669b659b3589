// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneFile.h"

#include "SceneText.h"

#include <vtkTerrainOutputFile.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace
{
/// Name of an option in a scene.
std::string NameOf(const CLI::Option* option)
{
  std::string name =
    option->get_lnames().empty() ? option->get_single_name() : option->get_lnames().front();
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char letter) { return std::tolower(letter); });
  return name;
}

/// The option of a key; null if there is none.
CLI::Option* FindOption(CLI::App& app, const std::string& key)
{
  const std::vector<CLI::Option*> options = app.get_options();
  const auto found = std::find_if(options.begin(), options.end(),
    [&key](const CLI::Option* option) { return NameOf(option) == key; });
  return found == options.end() ? nullptr : *found;
}

[[noreturn]] void Fail(const std::string& path, int line, const std::string& reason)
{
  throw CLI::ValidationError(path + ", line " + std::to_string(line), reason);
}

std::string WhyNoScene(const std::string& path)
{
  std::error_code error;
  if (!fs::is_regular_file(path, error))
  {
    return "'" + path + "' is no file of a scene (--save-scene writes one)";
  }
  return vtkTerrainOutputFile::WhyNotInput(path);
}

/// A file as it is called in a scene of a folder.
std::string ToScene(const std::string& file, const fs::path& folder)
{
  const fs::path whole = fs::absolute(file).lexically_normal();
  const fs::path relative = whole.lexically_relative(folder);
  const auto first = [](const fs::path& path)
  { return path.begin() == path.end() ? fs::path() : *std::next(path.begin()); };
  // folders that have no more than the root in common have nothing to do with each other
  return relative.empty() || first(whole) != first(folder / "x") ? whole.string()
                                                                 : relative.string();
}
}

/// Turns a file into options, as CLI11 takes them.
class SceneFile::Reader : public CLI::Config
{
public:
  explicit Reader(SceneFile* scene)
    : Scene(*scene)
  {
  }

  std::string to_config(const CLI::App*, bool, bool, std::string) const override
  {
    return {};
  }

  std::vector<CLI::ConfigItem> from_config(std::istream& input) const override
  {
    const std::string path = this->Scene.App->get_option("--scene")->as<std::string>();
    const SceneEntries read = ReadSceneText(input);
    if (!read.Error.empty())
    {
      Fail(path, read.Line, read.Error);
    }
    std::vector<CLI::ConfigItem> found;
    for (const SceneEntry& entry : read.Entries)
    {
      this->Check(path, entry);
      (*this->Scene.Lines)[entry.Key] = entry.Line;
      const CLI::Option* option = FindOption(*this->Scene.App, entry.Key);
      if (!option)
      {
        for (const std::string& value : entry.Values)
        {
          (*this->Scene.Unknown)[entry.Key].push_back(this->FromScene(entry.Key, value, path));
        }
        continue;
      }
      if (option->empty() && !this->HasRival(entry.Key))
      {
        this->Scene.Brought->insert(entry.Key);
        CLI::ConfigItem item;
        item.name = option->get_lnames().empty() ? option->get_single_name() : entry.Key;
        for (const std::string& value : entry.Values)
        {
          item.inputs.push_back(this->FromScene(entry.Key, value, path));
        }
        found.push_back(item);
      }
    }
    return found;
  }

  std::string to_flag(const CLI::ConfigItem& item) const override
  {
    // empty: what the flag stands for without a value
    return item.inputs.front() == "true" ? std::string() : item.inputs.front();
  }

private:
  void Check(const std::string& path, const SceneEntry& entry) const
  {
    const auto line = this->Scene.Lines->find(entry.Key);
    if (line != this->Scene.Lines->end())
    {
      Fail(path, entry.Line,
        "'" + entry.Key + "' stands in line " + std::to_string(line->second) + " already");
    }
    CLI::Option* option = FindOption(*this->Scene.App, entry.Key);
    if (!option && this->Scene.Names.KeepsUnknown)
    {
      return;
    }
    if (!option || this->Scene.Names.Others.count(entry.Key) > 0)
    {
      Fail(path, entry.Line, "'" + entry.Key + "' is no option of a scene (--help lists them)");
    }
    if (entry.Values.empty())
    {
      Fail(path, entry.Line, "'" + entry.Key + "' has an empty list");
    }
    const auto most = static_cast<std::size_t>(option->get_items_expected_max());
    if (entry.Values.size() > std::max<std::size_t>(most, 1) &&
      option->get_multi_option_policy() != CLI::MultiOptionPolicy::TakeAll)
    {
      Fail(path, entry.Line, "'" + entry.Key + "' takes one value, no list");
    }
    if (option->get_expected_min() > 0 && entry.Values.front() == "true")
    {
      Fail(path, entry.Line, "'" + entry.Key + "' needs a value");
    }
  }

  /// True if another option is given that leaves no room for this one.
  bool HasRival(const std::string& key) const
  {
    for (const std::set<std::string>& rivals : this->Scene.Names.Rivals)
    {
      for (const std::string& rival : rivals)
      {
        if (rivals.count(key) > 0 && !FindOption(*this->Scene.App, rival)->empty())
        {
          return true;
        }
      }
    }
    return false;
  }

  std::string FromScene(
    const std::string& key, const std::string& value, const std::string& scene) const
  {
    const bool isFile = this->Scene.Names.Files.count(key) > 0;
    if (!isFile && this->Scene.Names.FilesOrWords.count(key) == 0)
    {
      return value;
    }
    const fs::path there = fs::path(scene).parent_path() / value;
    std::error_code error;
    // GDAL has names with colons that are no paths
    const bool isMeant = isFile && value.find(':') == std::string::npos;
    return isMeant || fs::exists(there, error) ? there.string() : value;
  }

  SceneFile& Scene;
};

//------------------------------------------------------------------------------
void SceneFile::Declare(CLI::App& app, SceneNames names)
{
  const char* const group = "Scenes";
  this->App = &app;
  this->Names = std::move(names);
  for (CLI::Option* option : app.get_options())
  {
    const std::string name = NameOf(option);
    if (this->Names.Others.count(name) == 0)
    {
      // put before all others: it sees what was given, not what becomes of that
      option->transform(
        [given = this->Given, name](const std::string& value)
        {
          (*given)[name].push_back(value);
          return value;
        });
    }
  }
  app.set_config("--scene", "", "options from a file of TOML; those given beside it win")
    ->type_name("FILE")
    ->group(group)
    ->check(CLI::Validator(WhyNoScene, ""))
    ->each([this](const std::string& path) { this->Input = path; });
  app.config_formatter(std::make_shared<Reader>(this));
  app
    .add_option("--save-scene", this->Output,
      "write the options that are given to a file, names of files relative to it")
    ->type_name("FILE")
    ->group(group);
  this->Names.Others.insert({ "scene", "save-scene" });
}

//------------------------------------------------------------------------------
std::vector<std::string> SceneFile::GetUnknown() const
{
  std::vector<std::string> names;
  for (const auto& [name, values] : *this->Unknown)
  {
    names.push_back(name);
  }
  return names;
}

//------------------------------------------------------------------------------
void SceneFile::Replace(const std::string& name, const std::vector<std::string>& values)
{
  if (values.empty())
  {
    this->Given->erase(name);
  }
  else
  {
    (*this->Given)[name] = values;
  }
}

//------------------------------------------------------------------------------
std::string SceneFile::ToLine(
  const std::string& name, std::vector<std::string> values, const fs::path& folder) const
{
  for (std::string& value : values)
  {
    std::error_code error;
    const bool isFile = this->Names.Files.count(name) > 0 ||
      (this->Names.FilesOrWords.count(name) > 0 && fs::exists(value, error));
    if (isFile && (value.find(':') == std::string::npos || fs::exists(value, error)))
    {
      value = ToScene(value, folder);
    }
  }
  return SceneLine(name, values);
}

//------------------------------------------------------------------------------
std::string SceneFile::ToText(const std::string& path, const std::set<std::string>& without) const
{
  std::string text = "# " + this->App->get_name() + " --scene FILE\n";
  const fs::path folder = fs::absolute(path).lexically_normal().parent_path();
  for (const CLI::Option* option : this->App->get_options())
  {
    const std::string name = NameOf(option);
    const auto given = this->Given->find(name);
    if (given == this->Given->end() || without.count(name) > 0)
    {
      continue;
    }
    text += this->ToLine(name, given->second, folder);
  }
  for (const auto& [name, values] : *this->Unknown)
  {
    text += this->ToLine(name, values, folder);
  }
  return text;
}

//------------------------------------------------------------------------------
std::string SceneFile::Explain(const std::string& error) const
{
  const std::size_t begin = error.compare(0, 2, "--") == 0 ? 2 : 0;
  const std::string key = error.substr(begin, error.find(':') - begin);
  if (this->Brought->count(key) == 0)
  {
    return error;
  }
  std::string text = error;
  return text.append(" (")
    .append(this->Input)
    .append(", line ")
    .append(std::to_string(this->Lines->at(key)))
    .append(")");
}
