// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the frames of a flight are kept, so that the flight goes on where it stopped.
 */
#ifndef terrain_render_FlightFrames_h
#define terrain_render_FlightFrames_h

#include "vtkSmartPointer.h"

#include <array>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

class vtkImageData;

/// What a flight is written to.
struct FlightOutput
{
  /// Where frames are kept.
  std::string Folder;
  /// Name of the film, or of the folder.
  std::string Name;
  std::size_t Frames = 0;
  std::array<int, 2> Size{};
  /// Frames a second.
  double Rate = 30.0;
  /// Dots an inch that pictures tell; 0 for none.
  double Dots = 0.0;
};

/// The frames of one flight. Frames are counted from 0 on.
class FlightFrames
{
public:
  virtual ~FlightFrames() = default;

  /// True if a frame is kept from an earlier run.
  virtual bool Has(std::size_t frame) const = 0;
  /// Keeps a frame; the next one lies behind it. Throws a Failure.
  virtual void Write(std::size_t frame, vtkImageData* picture) = 0;
  /// Makes the film, once all frames are kept. Throws a Failure.
  virtual void Finish() = 0;
};

/// Pictures for a folder, a GIF and a WebP; parts of the film, encoded while the frames are drawn,
/// for the other films, unless the folder has all pictures from an earlier run.
std::unique_ptr<FlightFrames> OpenFrames(const FlightOutput& output);

/// Writes frames in a thread of its own, while the next ones are drawn.
class FrameQueue
{
public:
  explicit FrameQueue(FlightFrames& frames);
  /// Leaves alone what is not written yet.
  ~FrameQueue();
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  /// Takes a frame over; waits while many wait. Throws what the writing of an earlier one threw.
  void Add(std::size_t frame, const vtkSmartPointer<vtkImageData>& picture);
  /// Waits until all are written. Throws what writing threw.
  void Finish();

private:
  void Run();

  FlightFrames& Frames;
  std::mutex Mutex;
  std::condition_variable Changed;
  std::deque<std::pair<std::size_t, vtkSmartPointer<vtkImageData>>> Waiting;
  bool IsLast = false;
  bool IsGivenUp = false;
  std::exception_ptr Error;
  std::thread Writer;
};

#endif
