# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws terrain on all ranks, a picture for each case: drawRanks.py PREFIX [PORT]

Run by pvbatch, or by pvpython with the port of a pvserver.
"""
import sys

import terrainScene
from paraview import simple

TECHNIQUES = ("Equidistant", "Linear", "Exponential", "Mesh", "Strips", "Pyramid")

if len(sys.argv) > 2:
    simple.Connect("localhost", int(sys.argv[2]))
terrainScene.load_plugin()
source = simple.TerrainLandscape(Dimensions=[161, 121])
view = terrainScene.new_view()
display = terrainScene.show_terrain(source, view, TerrainVerticalExaggeration=2.0,
                                    TerrainStripsTolerance=0.5)
terrainScene.look_from_the_south(view)
ball = simple.Sphere(Center=[20000.0, 15000.0, 2500.0], Radius=4000.0, ThetaResolution=64,
                     PhiResolution=64)
shown_ball = simple.Show(ball, view)
shown_ball.ColorArrayName = [None, ""]
for technique in TECHNIQUES:
    display.TerrainTechnique = technique
    terrainScene.save(view, f"{sys.argv[1]}-{technique}.png")
display.Opacity = 0.5
display.TerrainMaximumLayers = 8  # one rank must not end sooner than several
terrainScene.save(view, f"{sys.argv[1]}-TranslucentWithBall.png")
simple.Hide(ball, view)
terrainScene.save(view, f"{sys.argv[1]}-Translucent.png")
simple.Hide(source, view)
cell = simple.TerrainLandscape(Dimensions=[2, 2])  # more ranks than cells
shown_cell = terrainScene.show_terrain(cell, view)
terrainScene.save(view, f"{sys.argv[1]}-OneCell.png")
shown_cell.Opacity = 0.5
terrainScene.save(view, f"{sys.argv[1]}-TranslucentCell.png")
simple.Hide(cell, view)
display.Opacity = 1.0
display.TerrainColorSource = "Height"
display.TerrainTechnique = "Pyramid"
simple.Show(source, view)
simple.ColorBy(display, None)
terrainScene.save(view, f"{sys.argv[1]}-Relief.png")
