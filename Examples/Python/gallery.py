# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrain in PyVista, one picture a function: gallery.py [FOLDER]"""
import pathlib
import sys

import numpy as np
import pyvista

from vtkterrain import vtkTerrainSource
from vtkterrain.plotting import add_terrain, enable_terrain_picking


def landscape():
    """Heights of a landscape, 40 km wide: any raster's file name does as well."""
    source = vtkTerrainSource()
    source.SetDimensions(513, 513)
    source.Update()
    return source.GetOutput()


def new_plotter():
    """A plotter that draws into memory, with a sky."""
    plotter = pyvista.Plotter(off_screen=True, window_size=(960, 540))
    plotter.set_background("#e6edf2", top="#80a8d6")
    return plotter


def look_from_the_south(plotter):
    """Puts the camera above the southern edge, looking down by 35 degrees."""
    plotter.view_vector((0.0, -0.82, 0.57), viewup=(0.0, 0.0, 1.0))
    plotter.camera.zoom(1.5)


def relief(plotter):
    """A landscape in the colours of a relief map, twice as high as it is."""
    add_terrain(plotter, landscape(), exaggeration=2.0,
                scalar_bar_args={"title": "Elevation (m)", "fmt": "%.0f"})
    look_from_the_south(plotter)


def from_numpy(plotter):
    """A function of x and y, and a mesh that cuts through it."""
    y, x = np.mgrid[-10.0:10.0:200j, -10.0:10.0:200j]
    ripples = 3.0 * np.sin(np.hypot(x, y) * 1.5) / (1.0 + 0.3 * np.hypot(x, y))
    spacing = (20.0 / 199.0, 20.0 / 199.0)
    add_terrain(plotter, ripples, spacing=spacing, origin=(-10.0, -10.0), cmap="viridis",
                scalar_bar_args={"title": "z"})
    plotter.add_mesh(pyvista.Sphere(radius=2.0, center=(3.0, -3.0, 0.0)), color="tomato")
    look_from_the_south(plotter)


def picking(plotter):
    """A flag wherever the terrain is clicked; here three clicks are made by the script."""
    add_terrain(plotter, landscape(), exaggeration=2.0, color="wheat", show_scalar_bar=False)
    look_from_the_south(plotter)

    def plant_flag(point, picker):
        plotter.add_point_labels([point], [f"{picker.GetHeight():.0f} m"], shape_color="white",
                                 point_color="firebrick", point_size=12, always_visible=True)

    enable_terrain_picking(plotter, plant_flag, side="left")
    plotter.show(auto_close=False, interactive=False)
    for place in ((300, 240), (520, 200), (640, 310)):
        plotter.iren._mouse_left_button_click(*place)


folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
for draw in (relief, from_numpy, picking):
    canvas = new_plotter()
    draw(canvas)
    canvas.screenshot(folder / f"{draw.__name__}.png")
    canvas.close()
