// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From frames to a film, by ffmpeg.
 */
#ifndef terrain_render_Film_h
#define terrain_render_Film_h

#include "Child.h"

#include "vtkNew.h"
#include "vtkTerrainOutputFile.h"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;

/// True if ffmpeg can be run.
bool HasFilmMaker();

/// True for kinds of film that can be put together of parts, by their extension: .mp4 and .webm. A
/// GIF has one palette of all frames.
bool HasParts(const std::string& extension);

/// Makes a film of the frames of a folder, `frame-00001.png` and so on, at so many frames a second;
/// its kind is that of the extension: .mp4 (H.264), .webm (VP9), .webp or .gif (with a palette of
/// its own). It appears complete or not at all. Throws a Failure that ends with `kept`.
void MakeFilm(
  const std::string& folder, double rate, const std::string& output, const std::string& kept);

/// Makes a film of parts, names and seconds in their order, without encoding them anew. As
/// MakeFilm().
void JoinParts(const std::vector<std::pair<std::string, double>>& parts, const std::string& output,
  const std::string& kept);

/// A part of a film that is encoded while its frames are drawn. It appears complete or not at all.
class FilmPart
{
public:
  /// Begins a part of a kind that HasParts(). Throws a Failure.
  FilmPart(const std::string& name, const std::array<int, 2>& size, double rate);

  /// Hands a frame of three bytes a pixel to ffmpeg. False if it takes no more: Finish() has why.
  bool Add(vtkImageData* picture);
  /// Waits for ffmpeg, and gives the part its name. Returns why there is none, empty if there is.
  std::string Finish();

private:
  vtkNew<vtkTerrainOutputFile> File;
  std::unique_ptr<Child> Encoder;
};

#endif
