// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the window keeps what it shows for the next time.
 */
#ifndef terrain_view_Session_h
#define terrain_view_Session_h

#include <string>

/// Path of the scene that was shown last: vtkterrain/terrain-view.toml in the folder
/// XDG_STATE_HOME, or ~/.local/state. Empty if there is no such folder. Source: XDG Base Directory
/// Specification 0.8.
std::string GetSessionPath();

#endif
