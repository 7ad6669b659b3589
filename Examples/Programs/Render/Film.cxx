// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Film.h"

#include "Failure.h"

#include "vtkImageData.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
using Words = std::vector<std::string>;

const char* const kFilmMaker = "ffmpeg";

void Append(Words& words, const Words& more)
{
  words.insert(words.end(), more.begin(), more.end());
}

std::string KindOf(const std::string& output)
{
  return fs::path(output).extension().string();
}

/// ffmpeg's words before its input: it asks nothing, tells errors, and ends with the first.
Words Begin()
{
  return { kFilmMaker, "-loglevel", "error", "-xerror", "-y" };
}

/// Makes sides even, as films of .mp4 and .webm need them.
const char* const kEven = "pad=ceil(iw/2)*2:ceil(ih/2)*2";

/// What encodes: ffmpeg's words for the kinds of film, after a filter of the frames.
Words EncoderOf(const std::string& extension, const std::string& filter)
{
  // players take colours without a matrix for those of BT.709
  const std::string filters = filter + ",scale=out_color_matrix=bt709:out_range=tv";
  const Words colors = { "-pix_fmt", "yuv420p", "-colorspace", "bt709", "-color_primaries", "bt709",
    "-color_trc", "bt709" };
  Words words;
  if (extension == ".mp4")
  {
    words = { "-vf", filters, "-c:v", "libx264", "-preset", "ultrafast", "-crf", "22" };
    Append(words, colors);
    Append(words, { "-f", "mp4" });
  }
  else if (extension == ".webm")
  {
    words = { "-vf", filters, "-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-row-mt", "1" };
    Append(words, colors);
    Append(words, { "-f", "webm" });
  }
  else if (extension == ".webp")
  {
    words = { "-c:v", "libwebp_anim", "-quality", "80", "-compression_level", "3", "-loop", "0",
      "-f", "webp" };
  }
  else
  {
    words = { "-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=bayer", "-f", "gif" };
  }
  return words;
}

/// Why ffmpeg wrote no file; empty if it did.
std::string WhyNone(const Child::Ending& ending, const std::string& file)
{
  std::error_code error;
  const bool isEmpty = fs::file_size(file, error) == 0 || error;
  const std::string line = LastLine(ending.Said);
  return ending.Status == 0 && !isEmpty ? std::string()
    : line.empty()                      ? "ffmpeg made no film"
                                        : "ffmpeg made no film (" + line + ")";
}

/// A path as a list of ffmpeg's demuxer "concat" has it.
std::string ListedPath(const std::string& path)
{
  std::string text = "file 'file:";
  for (const char letter : fs::absolute(path).string())
  {
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return text + "'\n";
}

/// Runs ffmpeg with an input of text; the film is what the last word names.
void Make(Words words, const std::string& input, const std::string& output, const std::string& kept)
{
  const vtkNew<vtkTerrainOutputFile> file;
  if (!file->Open(output))
  {
    throw Failure(file->GetErrorMessage());
  }
  words.push_back(file->GetPartialFileName());
  Child maker(words);
  maker.Feed(input.data(), input.size());
  const std::string why = WhyNone(maker.Wait(), file->GetPartialFileName());
  if (!why.empty())
  {
    throw Failure(output, why + "; " + kept);
  }
  if (!file->Commit())
  {
    throw Failure(file->GetErrorMessage());
  }
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
bool HasParts(const std::string& extension)
{
  return extension == ".mp4" || extension == ".webm";
}

//------------------------------------------------------------------------------
void MakeFilm(
  const std::string& folder, double rate, const std::string& output, const std::string& kept)
{
  Words words = Begin();
  Append(words,
    { "-nostdin", "-framerate", std::to_string(rate), "-i",
      (fs::path(folder) / "frame-%05d.png").string() });
  Append(words, EncoderOf(KindOf(output), kEven));
  if (KindOf(output) == ".mp4")
  {
    Append(words, { "-movflags", "+faststart" });
  }
  Make(words, {}, output, kept);
}

//------------------------------------------------------------------------------
void JoinParts(const std::vector<std::pair<std::string, double>>& parts, const std::string& output,
  const std::string& kept)
{
  Words words = Begin();
  Append(words,
    { "-f", "concat", "-safe", "0", "-protocol_whitelist", "file,pipe,fd", "-i", "pipe:0", "-c",
      "copy", "-f", KindOf(output).substr(1) });
  if (KindOf(output) == ".mp4")
  {
    Append(words, { "-movflags", "+faststart" });
  }
  std::string list;
  for (const auto& [name, seconds] : parts)
  {
    // files round their durations to milliseconds
    list += ListedPath(name) + "duration " + std::to_string(seconds) + '\n';
  }
  Make(words, list, output, kept);
}

//------------------------------------------------------------------------------
FilmPart::FilmPart(const std::string& name, const std::array<int, 2>& size, double rate)
{
  if (!this->File->Open(name))
  {
    throw Failure(this->File->GetErrorMessage());
  }
  Words words = Begin();
  Append(words,
    { "-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size",
      std::to_string(size[0]) + "x" + std::to_string(size[1]), "-framerate", std::to_string(rate),
      "-i", "pipe:0" });
  // the lowest row is VTK's first
  const bool isEven = size[0] % 2 == 0 && size[1] % 2 == 0;
  Append(words, EncoderOf(KindOf(name), isEven ? "vflip" : std::string("vflip,") + kEven));
  words.push_back(this->File->GetPartialFileName());
  this->Encoder = std::make_unique<Child>(words);
}

//------------------------------------------------------------------------------
bool FilmPart::Add(vtkImageData* picture)
{
  const std::size_t size = static_cast<std::size_t>(picture->GetNumberOfPoints()) *
    static_cast<std::size_t>(picture->GetNumberOfScalarComponents());
  return this->Encoder->Feed(picture->GetScalarPointer(), size);
}

//------------------------------------------------------------------------------
std::string FilmPart::Finish()
{
  const std::string why = WhyNone(this->Encoder->Wait(), this->File->GetPartialFileName());
  const bool isThere = why.empty() && this->File->Commit();
  return isThere || !why.empty() ? why : this->File->GetErrorMessage();
}
