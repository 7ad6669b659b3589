// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlightFrames.h"

#include "Failure.h"
#include "Film.h"
#include "FlightOptions.h"
#include "Outputs.h"
#include "Statistics.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace
{
/// Frames that wait while one is written.
constexpr std::size_t kMostWaiting = 3;
/// Seconds of film and of drawing that a part takes: what is lost where a flight is stopped.
constexpr double kPartOfFilm = 5.0;
constexpr double kPartOfDrawing = 20.0;

bool Exists(const std::string& path)
{
  std::error_code error;
  return fs::exists(path, error);
}

/// Each frame as a PNG.
class PictureFrames : public FlightFrames
{
public:
  explicit PictureFrames(FlightOutput output)
    : Output(std::move(output))
  {
  }

  bool Has(std::size_t frame) const override
  {
    return Exists(this->NameOf(frame));
  }
  bool HasAll() const
  {
    std::size_t frame = 0;
    while (frame < this->Output.Frames && this->Has(frame))
    {
      ++frame;
    }
    return frame == this->Output.Frames;
  }
  void Write(std::size_t frame, vtkImageData* picture) override
  {
    try
    {
      const PendingFile file(this->NameOf(frame));
      WriteEncoded(EncodePicture(picture, this->Output.Dots, PictureUse::Passing), file);
      file.Commit();
    }
    catch (const Failure& failure)
    {
      throw Failure(std::string(failure.what()) + "; the frames before it are kept in '" +
        this->Output.Folder + "', and the same command goes on");
    }
  }
  void Finish() override
  {
    if (IsFilm(this->Output.Name))
    {
      const std::string& folder = this->Output.Folder;
      MakeFilm(folder, this->Output.Rate, this->Output.Name, "the frames are in '" + folder + "'");
    }
  }

private:
  std::string NameOf(std::size_t frame) const
  {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame-%05zu.png", frame + 1);
    return (fs::path(this->Output.Folder) / name.data()).string();
  }

  FlightOutput Output;
};

/// A film in parts of consecutive frames: `frames-00001-00150.mp4` and so on.
class FilmFrames : public FlightFrames
{
public:
  explicit FilmFrames(FlightOutput output)
    : Output(std::move(output))
    , Kind(fs::path(this->Output.Name).extension().string())
  {
    for (const fs::directory_entry& entry : fs::directory_iterator(this->Output.Folder))
    {
      this->Find(entry.path());
    }
  }

  bool Has(std::size_t frame) const override
  {
    const auto next = this->Parts.upper_bound(frame);
    return next != this->Parts.begin() && frame < std::prev(next)->second;
  }

  void Write(std::size_t frame, vtkImageData* picture) override
  {
    if (!this->Part)
    {
      this->Begin(frame);
    }
    ++this->Written;
    // what takes no more has failed, and says why
    if (!this->Part->Add(picture) || frame + 1 == this->End)
    {
      this->EndPart();
    }
  }

  void Finish() override
  {
    std::vector<std::pair<std::string, double>> parts;
    parts.reserve(this->Parts.size());
    for (const auto& [first, end] : this->Parts)
    {
      parts.emplace_back(
        this->NameOf(first, end), static_cast<double>(end - first) / this->Output.Rate);
    }
    JoinParts(parts, this->Output.Name, this->TellKept());
  }

private:
  std::string NameOf(std::size_t first, std::size_t end) const
  {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frames-%05zu-%05zu", first + 1, end);
    return (fs::path(this->Output.Folder) / (name.data() + this->Kind)).string();
  }

  /// Takes note of a file if it is a part.
  void Find(const fs::path& path)
  {
    std::size_t first = 0;
    std::size_t end = 0;
    if (std::sscanf(path.stem().c_str(), "frames-%5zu-%5zu", &first, &end) == 2 && first > 0 &&
      end >= first && end <= this->Output.Frames &&
      path.filename() == fs::path(this->NameOf(first - 1, end)).filename())
    {
      this->Parts[first - 1] = end;
    }
  }

  /// Begins a part that ends before the next one, after some seconds of film, or after some seconds
  /// of drawing as it went until now.
  void Begin(std::size_t frame)
  {
    const double seconds = this->Watch.GetMilliseconds() / 1e3;
    const double drawn = kPartOfDrawing / seconds * static_cast<double>(this->Written + 1);
    const double length = std::clamp(std::min(kPartOfFilm * this->Output.Rate, drawn), 1.0, 1e5);
    const auto next = this->Parts.upper_bound(frame);
    this->First = frame;
    this->End = std::min(frame + static_cast<std::size_t>(length),
      next == this->Parts.end() ? this->Output.Frames : next->first);
    this->Part = std::make_unique<FilmPart>(
      this->NameOf(frame, this->End), this->Output.Size, this->Output.Rate);
  }

  void EndPart()
  {
    const std::string why = this->Part->Finish();
    this->Part.reset();
    if (!why.empty())
    {
      throw Failure(this->Output.Name, why + "; " + this->TellKept());
    }
    this->Parts[this->First] = this->End;
  }

  std::string TellKept() const
  {
    std::size_t kept = 0;
    for (const auto& [first, end] : this->Parts)
    {
      kept += end - first;
    }
    return kept == 0 ? "no frame is kept"
                     : std::to_string(kept) + " of " + std::to_string(this->Output.Frames) +
        " frames are kept in '" + this->Output.Folder + "', and the same command goes on";
  }

  FlightOutput Output;
  std::string Kind;
  /// First frames of the parts that are there, and the frames behind their last ones.
  std::map<std::size_t, std::size_t> Parts;
  std::unique_ptr<FilmPart> Part;
  std::size_t First = 0;
  std::size_t End = 0;
  std::size_t Written = 0;
  Stopwatch Watch;
};
}

//------------------------------------------------------------------------------
std::unique_ptr<FlightFrames> OpenFrames(const FlightOutput& output)
{
  auto pictures = std::make_unique<PictureFrames>(output);
  if (HasParts(fs::path(output.Name).extension().string()) && !pictures->HasAll())
  {
    return std::make_unique<FilmFrames>(output);
  }
  return pictures;
}

//------------------------------------------------------------------------------
FrameQueue::FrameQueue(FlightFrames& frames)
  : Frames(frames)
  , Writer([this] { this->Run(); })
{
}

//------------------------------------------------------------------------------
FrameQueue::~FrameQueue()
{
  if (this->Writer.joinable())
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->IsGivenUp = true;
    }
    this->Changed.notify_all();
    this->Writer.join();
  }
}

//------------------------------------------------------------------------------
void FrameQueue::Add(std::size_t frame, const vtkSmartPointer<vtkImageData>& picture)
{
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait(lock, [this] { return this->Error || this->Waiting.size() < kMostWaiting; });
    if (this->Error)
    {
      std::rethrow_exception(this->Error);
    }
    this->Waiting.emplace_back(frame, picture);
  }
  this->Changed.notify_all();
}

//------------------------------------------------------------------------------
void FrameQueue::Finish()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsLast = true;
  }
  this->Changed.notify_all();
  this->Writer.join();
  if (this->Error)
  {
    std::rethrow_exception(this->Error);
  }
}

//------------------------------------------------------------------------------
void FrameQueue::Run()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  const auto isNext = [this] { return this->IsGivenUp || this->IsLast || !this->Waiting.empty(); };
  for (this->Changed.wait(lock, isNext); !this->IsGivenUp && !this->Waiting.empty();
       this->Changed.wait(lock, isNext))
  {
    const auto [frame, picture] = this->Waiting.front();
    this->Waiting.pop_front();
    lock.unlock();
    this->Changed.notify_all();
    try
    {
      this->Frames.Write(frame, picture);
    }
    catch (...)
    {
      lock.lock();
      this->Error = std::current_exception();
      this->Changed.notify_all();
      return;
    }
    lock.lock();
  }
}
