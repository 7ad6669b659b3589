// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Texts as scenes beside command lines, as the programs read them: one sentence, or options that
// are the same once they are written and read again.
#include "FuzzFile.h"

#include "EmptyValues.h"
#include "NotNumbers.h"
#include "SceneFile.h"
#include "SceneText.h"

#include <sstream>
#include <vector>

namespace
{
/// Options of every kind that the programs have.
struct Options
{
  std::string Heights;
  std::string Title;
  std::string Drape;
  std::string Colors;
  std::string Legend;
  std::string Word;
  double Number = 0.0;
  int Count = 0;
  bool Flag = false;
  std::vector<std::string> Tracks;

  void Declare(CLI::App& app)
  {
    app.add_option("HEIGHTS", this->Heights, "")
      ->check([](const std::string& name)
        { return std::string(name.empty() ? "needs the name of a file" : ""); });
    app.add_option("--title", this->Title, "");
    app.add_option("--drape", this->Drape, "");
    app.add_option("--colors,--palette", this->Colors, "");
    app.add_flag("--legend{usual}", this->Legend, "");
    app.add_option("--technique", this->Word, "")->check(CLI::IsMember({ "pyramid", "strips" }));
    app.add_option("--interval", this->Number, "")->check(CLI::Range(0.0, 1e9));
    app.add_option("--frames", this->Count, "")->check(CLI::Range(1, 1000));
    app.add_flag("--shadows", this->Flag, "");
    app.add_option("--track", this->Tracks, "")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.set_version_flag("--version", "1");
  }
};

SceneNames NamesOf(bool keepsUnknown)
{
  SceneNames names;
  names.Files = { "heights", "drape", "track" };
  names.FilesOrWords = { "colors" };
  names.Others = { "help", "version" };
  names.Rivals = { { "title", "drape" } };
  names.KeepsUnknown = keepsUnknown;
  return names;
}

/// Empty, or what is wrong; the scene that the options make goes to `text`.
std::string Parse(std::vector<std::string> words, bool keepsUnknown, std::string& text)
{
  Options options;
  SceneFile scene;
  CLI::App app("", "fuzz");
  try
  {
    options.Declare(app);
    scene.Declare(app, NamesOf(keepsUnknown));
    std::vector<const char*> argv{ "fuzz" };
    for (const std::string& word : words)
    {
      argv.push_back(word.c_str());
    }
    const int argc = static_cast<int>(argv.size());
    RefuseEmptyValues(argc, argv.data());
    app.parse(argc, argv.data());
    RefuseNoValue(app, { "--title" });
    RefuseNotANumber(app);
    Require(std::isfinite(options.Number) && options.Number >= 0.0);
    text = scene.ToText("/tmp/fuzz.toml");
    return {};
  }
  catch (const CLI::ParseError& error)
  {
    return "refused: " + scene.Explain(error.what());
  }
}

void CheckText(const std::string& text)
{
  std::istringstream stream(text);
  const SceneEntries read = ReadSceneText(stream);
  Require(read.Error.empty() == (read.Line == 0));
  for (const SceneEntry& entry : read.Entries)
  {
    std::istringstream again(SceneLine(entry.Key, entry.Values));
    const SceneEntries reread = ReadSceneText(again);
    Require(reread.Error.empty() && reread.Entries.size() == 1 &&
      reread.Entries.front().Key == entry.Key && reread.Entries.front().Values == entry.Values);
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  const std::string text = input.Text();
  CheckText(text);
  const FuzzFile file(text);
  std::vector<std::string> words{ "--scene", file.Path() };
  const bool keepsUnknown = input.Left() == 0 || input.Number(2) != 0;
  while (input.Left() > 0 && words.size() < 20)
  {
    const std::string word = input.Text();
    words.push_back(word.substr(0, word.find('\0')));
    if (words.back().find("--s") == 0) // another scene, or a scene to save
    {
      words.pop_back();
    }
  }
  std::string written;
  if (Parse(words, keepsUnknown, written).empty())
  {
    const FuzzFile again(written);
    std::string rewritten;
    Require(Parse({ "--scene", again.Path() }, true, rewritten).empty());
  }
  return 0;
}
