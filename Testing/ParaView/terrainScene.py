# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""A view of a terrain in ParaView, for the tests."""
import os
import pathlib

from paraview import simple

SIZE = (240, 160)


def load_plugin():
    """Loads the plugin that the environment names, here and where the data are."""
    path = os.environ["VTKTERRAIN_PARAVIEW_PLUGIN"]
    if simple.servermanager.ActiveConnection.IsRemote():
        simple.LoadPlugin(path, remote=False, ns=vars(simple))
    simple.LoadPlugin(path, remote=True, ns=vars(simple))


def new_view():
    """A view without what would make pictures differ by more than the terrain."""
    view = simple.CreateRenderView()
    view.ViewSize = list(SIZE)
    view.UseFXAA = 0
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.6, 0.7, 0.8]
    view.RemoteRenderThreshold = 0
    return view


def show_terrain(source, view, **options):
    """Shows a source as terrain, coloured by its heights; returns what ParaView calls the display."""
    camera = [list(view.CameraPosition), list(view.CameraFocalPoint)]
    display = simple.Show(source, view)  # looks at the whole of the first source that is shown
    view.CameraPosition, view.CameraFocalPoint = camera
    display.SetRepresentationType("Terrain")
    simple.ColorBy(display, ("POINTS", "Elevation"))
    colors = simple.GetColorTransferFunction("Elevation")
    colors.RGBPoints = [0.0, 0.3, 0.0, 0.3, 1250.0, 0.1, 0.6, 0.5, 2500.0, 1.0, 0.9, 0.1]
    colors.ColorSpace = "RGB"
    for name, value in options.items():
        setattr(display, name, value)
    return display


def look_from_the_south(view, width=40960.0):
    """Puts the camera above the southern edge of a terrain that begins at the origin."""
    view.CameraPosition = [0.5 * width, -1.0 * width, 0.8 * width]
    view.CameraFocalPoint = [0.5 * width, 0.45 * width, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]


def save(view, path):
    """Draws the view into a PNG file, of which none is left if that fails."""
    pathlib.Path(path).unlink(missing_ok=True)
    simple.Render(view)
    simple.SaveScreenshot(path, view, ImageResolution=list(SIZE))
    assert pathlib.Path(path).exists(), path
