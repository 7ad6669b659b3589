# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""The smallest script that draws terrain: render.py HEIGHTS PICTURE.png"""
import sys

from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

from vtkterrain import vtkTerrainActor, vtkTerrainRasterReader

heights = vtkTerrainRasterReader()  # or vtkTerrainSource, or vtkterrain.heights_from_array(array)
heights.SetFileName(sys.argv[1])
heights.Update()
if heights.GetErrorMessage():
    sys.exit(1)  # VTK has printed it

terrain = vtkTerrainActor()
terrain.SetInputConnection(heights.GetOutputPort())
terrain.SetVerticalExaggeration(1.5)

renderer = vtkRenderer()
renderer.AddActor(terrain)
renderer.SetBackground(0.6, 0.7, 0.8)
renderer.ResetCamera()
renderer.GetActiveCamera().Elevation(-50.0)  # from the south
renderer.GetActiveCamera().Zoom(1.2)
renderer.ResetCameraClippingRange()
window = vtkRenderWindow()  # X, EGL or OSMesa, whichever there is
window.SetOffScreenRendering(1)
window.SetSize(1280, 720)
window.AddRenderer(renderer)
window.Render()

capture = vtkWindowToImageFilter()
capture.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(capture.GetOutputPort())
writer.SetFileName(sys.argv[2])
writer.Write()
