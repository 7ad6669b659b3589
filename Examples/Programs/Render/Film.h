// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From frames to a film, by ffmpeg.
 */
#ifndef terrain_render_Film_h
#define terrain_render_Film_h

#include <string>

/// True if ffmpeg can be run.
bool HasFilmMaker();

/// Makes a film of the frames of a folder, `frame-00001.png` and so on, at so many frames a second;
/// its kind is that of the extension: .mp4 (H.264), .webm (VP9) or .gif (with a palette of its
/// own). It appears complete or not at all. Throws a Failure: the frames stay.
void MakeFilm(const std::string& folder, double rate, const std::string& output);

#endif
