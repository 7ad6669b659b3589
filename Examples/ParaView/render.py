# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws terrain in ParaView: pvbatch render.py PLUGIN.so HEIGHTS PICTURE.png

On one rank and on many: mpiexec -n 4 pvbatch ... has each rank read and draw its own piece.
"""
import sys

from paraview import simple

plugin, heights, picture = sys.argv[1:4]
simple.LoadPlugin(plugin, remote=True, ns=vars(simple))
terrain = simple.TerrainRasterReader(FileName=heights)  # or a directory of tiles, or files in time
terrain.UpdatePipeline()

view = simple.CreateRenderView(ViewSize=[1280, 720])
display = simple.Show(terrain, view)
display.SetRepresentationType("Terrain")
display.TerrainVerticalExaggeration = 1.5
display.TerrainHillshade = 1
display.TerrainHillshadeAltitude = 60.0
array = terrain.PointData[0]
simple.ColorBy(display, ("POINTS", array.Name))
colors = simple.GetColorTransferFunction(array.Name)
lowest, highest = array.GetRange()
relief = [(0.0, 0.4, 0.6, 0.4), (0.3, 0.6, 0.7, 0.4), (0.7, 0.8, 0.7, 0.5), (1.0, 1.0, 1.0, 1.0)]
colors.RGBPoints = [number for part, *color in relief
                    for number in (lowest + part * (highest - lowest), *color)]
colors.ColorSpace = "RGB"
display.SetScalarBarVisibility(view, True)

simple.Render(view)
view.ResetCamera()
camera = view.GetActiveCamera()
camera.Elevation(-50.0)  # from the south
camera.Zoom(1.2)
simple.SaveScreenshot(picture, view)
