// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the X server still has to tell about a window.
 */
#ifndef terrain_view_WindowEvents_h
#define terrain_view_WindowEvents_h

class vtkRenderWindow;

/// Forgets all events of a window that is about to close, and asks for no more: VTK destroys the
/// window at once (vtkXRenderWindowInteractor::TerminateApp), handles what is left of its events
/// after that, and asks the server where the pointer is in a window that is gone, which ends the
/// program. Does nothing where the program was built without X11.
void ForgetEvents(vtkRenderWindow* window);

#endif
