# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers on the sides of blocks, index contours, and ranges of slopes."""
import unittest

import numpy as np
import vtkTerrainTesting
from vtkTerrainTesting import hill, look

try:
    import pyvista

    from vtkterrain import _strata, plotting
    from vtkterrain.heights import heights_from_array
except ImportError:
    pyvista = None

SIZE = (240, 180)


@unittest.skipIf(pyvista is None, "PyVista is not installed")
class TestStrata(unittest.TestCase):
    def plotter(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
        self.addCleanup(plotter.close)
        return plotter

    def add(self, **options):
        plotter = self.plotter()
        return plotter, plotting.add_terrain(plotter, hill(), show_scalar_bar=False, **options)

    def test_areas_of_layers(self):
        # a plane 10 high over 4 x 3 cells of 2 m: its sides are 28 m round
        heights = heights_from_array(np.full((4, 5), 10.0), spacing=(2.0, 2.0))
        layers = _strata.read_strata("red=3,green=4,blue")
        block = _strata.make_strata(heights, -5.0, layers)
        areas = block.compute_cell_sizes(length=False, volume=False)["Area"]
        colors = np.asarray(block.cell_data["Color"])
        for channel, area in ((0, 28 * 3.0), (1, 28 * 4.0), (2, 28 * 8.0 + 8 * 6)):
            is_one = colors[:, channel] == colors.max(axis=1)
            self.assertAlmostEqual(areas[is_one].sum(), area, 9)

    def test_holes_have_sides(self):
        samples = np.full((5, 5), 10.0)
        samples[2, 2] = np.nan  # swallows four of sixteen cells
        block = _strata.make_strata(heights_from_array(samples), 0.0, _strata.read_strata(["grey"]))
        sizes = block.compute_cell_sizes(length=False, volume=False)["Area"]
        self.assertAlmostEqual(sizes.sum(), 16 * 10.0 + 8 * 10.0 + 12.0, 9)

    def test_layers_are_seen_and_go_with_the_terrain(self):
        plotter, terrain = self.add(block=-6.0, strata=[("red", 3.0), "blue"], name="hill")
        picture = look(plotter)
        for channel in (0, 2):
            others = picture.sum(axis=2) - picture[..., channel]
            self.assertGreater((picture[..., channel] > 2 * others + 40).sum(), 150, channel)
        before = plotter.actors["hill-strata"].bounds
        terrain.exaggeration = 2.0
        after = plotter.actors["hill-strata"].bounds
        self.assertAlmostEqual(after[4], 2.0 * before[4], 6)
        plotter.remove_actor(terrain)
        self.assertFalse(plotter.renderer.HasViewProp(plotter.actors.get("hill-strata")) if "hill-strata" in
                         plotter.actors else False)

    def test_what_is_wrong_is_told(self):
        for strata, mention in (([], "layers"), ([("red", -1.0), "grey"], "above 0"), (["red", "grey"], "none but"),
                                ([("red", "thick")], "above 0")):
            with self.assertRaisesRegex(ValueError, mention):
                self.add(block=-6.0, strata=strata)
        with self.assertRaisesRegex(ValueError, "block, too"):
            self.add(strata=["grey"])

    def test_index_contours_are_wider(self):
        dark = [(look(self.add(contours=0.5, contour_index=index, color="white", lighting=False)[0]).max(axis=2)
                 < 80).sum() for index in (0, 4)]
        self.assertGreater(dark[1], 1.1 * dark[0])
        for index in (-1, 2.5, True):
            with self.assertRaisesRegex(ValueError, "contour_index"):
                self.add(contours=0.5, contour_index=index)

    def test_slopes_reach_over_their_scale(self):
        plotter = self.plotter()
        plane = np.tile(0.5 * np.arange(20.0), (15, 1))  # 26.6 degrees
        terrain = plotting.add_terrain(plotter, plane, scalars="slope", show_scalar_bar=False)
        self.assertEqual(terrain.mapper.scalar_range, (0.0, 30.0))

    def test_tables_of_schemes(self):
        from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

        from vtkterrain.vtkTerrain import vtkTerrainColors
        colors, table = vtkTerrainColors(), vtkColorTransferFunction()
        self.assertTrue(colors.SetScheme("grey"))
        colors.FillTable(table, 0.0, 100.0)
        self.assertEqual(tuple(table.GetRange()), (0.0, 100.0))
        self.assertLess(table.GetColor(0.0)[0], table.GetColor(100.0)[0])


if __name__ == "__main__":
    vtkTerrainTesting.run()
