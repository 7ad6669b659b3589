// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Film.h"

#include "Failure.h"

#include "vtkNew.h"
#include "vtkTerrainOutputFile.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
const char* const kFilmMaker = "ffmpeg";
/// Exit status of a child that could not become the program.
constexpr int kNotRun = 127;

/// What encodes: ffmpeg's words for the kinds of film.
std::vector<std::string> EncoderOf(const std::string& extension)
{
  // sides of films of these kinds are even
  const std::string even = "pad=ceil(iw/2)*2:ceil(ih/2)*2";
  if (extension == ".mp4")
  {
    return { "-vf", even, "-c:v", "libx264", "-preset", "veryfast", "-crf", "18", "-pix_fmt",
      "yuv420p", "-movflags", "+faststart", "-f", "mp4" };
  }
  if (extension == ".webm")
  {
    return { "-vf", even, "-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-row-mt", "1",
      "-pix_fmt", "yuv420p", "-f", "webm" };
  }
  if (extension == ".webp")
  {
    return { "-c:v", "libwebp_anim", "-quality", "80", "-compression_level", "3", "-loop", "0",
      "-f", "webp" };
  }
  return { "-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=bayer", "-f", "gif" };
}

/// Runs a program of the PATH. Returns its exit status and what it says on stderr.
std::pair<int, std::string> RunProgram(std::vector<std::string> words)
{
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0)
  {
    return { kNotRun, "no pipe can be had" };
  }
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0)
  {
    dup2(ends[1], STDERR_FILENO);
    close(ends[0]);
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    execvp(pointers[0], pointers.data());
    _exit(kNotRun);
  }
  close(ends[1]);
  std::string said;
  std::array<char, 4096> part{};
  for (ssize_t count = 1; child > 0 && count > 0;)
  {
    count = read(ends[0], part.data(), part.size());
    said.append(part.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    count = count < 0 && errno == EINTR ? 1 : count;
  }
  close(ends[0]);
  int status = -1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }
  return { child > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : kNotRun, said };
}

/// The last line of a text that is not empty.
std::string LastLine(const std::string& text)
{
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
  {
    last = line.empty() ? last : line;
  }
  return last;
}
}

//------------------------------------------------------------------------------
bool HasFilmMaker()
{
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    const std::string program = (fs::path(folder) / kFilmMaker).string();
    std::error_code error;
    if (fs::is_regular_file(program, error) && access(program.c_str(), X_OK) == 0)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void MakeFilm(const std::string& folder, double rate, const std::string& output)
{
  const vtkNew<vtkTerrainOutputFile> file;
  if (!file->Open(output))
  {
    throw Failure(file->GetErrorMessage());
  }
  std::vector<std::string> words = { kFilmMaker, "-nostdin", "-loglevel", "error", "-y",
    "-framerate", std::to_string(rate), "-i", (fs::path(folder) / "frame-%05d.png").string() };
  for (const std::string& word : EncoderOf(fs::path(output).extension().string()))
  {
    words.push_back(word);
  }
  words.push_back(file->GetPartialFileName());
  const auto [status, said] = RunProgram(words);
  std::error_code error;
  const bool isEmpty = fs::file_size(file->GetPartialFileName(), error) == 0 || error;
  if (status != 0 || isEmpty)
  {
    const std::string line = LastLine(said);
    throw Failure(output,
      "ffmpeg made no film" + (line.empty() ? "" : " (" + line + ")") + "; the frames are in '" +
        folder + "'");
  }
  if (!file->Commit())
  {
    throw Failure(file->GetErrorMessage());
  }
}
