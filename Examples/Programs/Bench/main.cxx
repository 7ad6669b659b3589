// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// terrain-bench --report DIR: measures this machine, and writes DIR/index.html and DIR/report.json.
//
// Exit status 0; 2 for a wrong command line; 1 otherwise, with one line on stderr.
#include "EmptyValues.h"
#include "Ending.h"
#include "Failure.h"
#include "Messages.h"
#include "NotNumbers.h"
#include "Sections.h"
#include "Stage.h"

#include <CLI/CLI.hpp>

#include "vtkVersion.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <thread>

namespace
{
struct Options
{
  std::string Directory;
  std::vector<std::string> Only;
  Plan Measured;
};

struct Part
{
  const char* Name;
  Section (*Measure)(const Plan&);
};

constexpr std::array<Part, 5> kParts{ { { "searches", MeasureSearches },
  { "pyramid", MeasurePyramid }, { "processor", MeasureProcessor }, { "today", MeasureToday },
  { "growth", MeasureGrowth } } };

/// The value of the first line that begins with a key, after its colon.
std::string ValueIn(const char* path, const std::string& key)
{
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t colon = line.find(':');
    if (line.rfind(key, 0) == 0 && colon != std::string::npos)
    {
      return line.substr(std::min(colon + 2, line.size()));
    }
  }
  return "unknown";
}

std::string Today()
{
  const std::time_t now = std::time(nullptr);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", std::gmtime(&now));
  return text.data();
}

std::vector<std::pair<std::string, std::string>> Facts(const Plan& plan)
{
  const Stage stage(16, 16);
  return { { "date", Today() }, { "processor", ValueIn("/proc/cpuinfo", "model name") },
    { "processors", std::to_string(std::thread::hardware_concurrency()) },
    { "renderer", stage.RendererName() }, { "VTK", vtkVersion::GetVTKVersion() },
    { "vtkTerrain", TERRAIN_BENCH_VERSION },
    { "times of frames",
      stage.IsSoftware() ? "processor time of all threads, software rendering"
                         : "timer of the graphics card" },
    { "frames of each", std::to_string(plan.Frames) + ", median" },
    { "landscape", "built in, 123 km a side" } };
}

void Write(const std::filesystem::path& path, const std::string& text)
{
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file)
  {
    throw Failure(path.string(), "cannot be written");
  }
}

void Run(const Options& options)
{
  const std::filesystem::path directory(options.Directory);
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
  {
    throw Failure(options.Directory, error.message());
  }
  Write(directory / "report.json", "{}\n"); // what cannot be written is said before the work
  Report report;
  report.Facts = Facts(options.Measured);
  ThrowOnError("cannot draw");
  for (const Part& part : kParts)
  {
    const auto& only = options.Only;
    if (only.empty() || std::find(only.begin(), only.end(), part.Name) != only.end())
    {
      std::cerr << "terrain-bench: " << part.Name << '\n';
      report.Sections.push_back(part.Measure(options.Measured));
      ThrowOnError(part.Name);
    }
    Write(directory / "index.html", ToHtml(report));
    Write(directory / "report.json", ToJson(report));
  }
  std::cout << std::filesystem::absolute(directory / "index.html").lexically_normal().string()
            << '\n';
}

void Declare(CLI::App& app, Options& options)
{
  std::vector<std::string> names;
  names.reserve(kParts.size());
  for (const Part& part : kParts)
  {
    names.emplace_back(part.Name);
  }
  app.add_option("--report", options.Directory, "folder for index.html and report.json")
    ->required()
    ->type_name("DIR");
  app
    .add_option(
      "--largest", options.Measured.Largest, "largest side of a landscape in samples; default 4097")
    ->check(CLI::Range(257, 16385))
    ->type_name("N");
  app.add_option("--frames", options.Measured.Frames, "of each measurement; default 7")
    ->check(CLI::Range(1, 1000))
    ->type_name("N");
  app.add_option("--only", options.Only, "parts: searches, pyramid, processor, today, growth")
    ->check(CLI::IsMember(names))
    ->type_name("PART...");
  app.add_flag("--smoke", options.Measured.IsSmoke,
    "tiny landscapes and pictures, one frame: to see that all runs, in seconds");
  app.set_version_flag("--version", TERRAIN_BENCH_VERSION);
}

/// The program between the command line and its exit status.
int RunCommandLine(int argc, char** argv)
{
  CLI::App app("Measures the drawing of terrain on this machine, beside the papers' figures.",
    "terrain-bench");
  Options options;
  Declare(app, options);
  try
  {
    RefuseEmptyValues(argc, argv);
    app.parse(argc, argv);
    RefuseNotANumber(app);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      return app.exit(error);
    }
    std::cerr << "terrain-bench: " << error.what() << '\n';
    return 2;
  }
  if (options.Measured.IsSmoke)
  {
    options.Measured.Frames = 1;
    options.Measured.Seconds = 0.001;
  }
  CatchMessages("terrain-bench");
  Run(options);
  return EXIT_SUCCESS;
}
}

int main(int argc, char* argv[])
{
  EndOnSignals("terrain-bench: ended by a signal\n");
  try
  {
    return RunCommandLine(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "terrain-bench: %s\n", error.what());
  }
  return EXIT_FAILURE;
}
