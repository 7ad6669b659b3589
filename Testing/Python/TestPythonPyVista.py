# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrain in PyVista's plotters; skipped without PyVista."""
import importlib.util
import pathlib
import subprocess
import sys
import types
import unittest
import warnings

import numpy as np
import vtkTerrainTesting

try:
    import pyvista

    from vtkterrain import plotting
except ImportError:
    pyvista = None
try:
    import xarray
except ImportError:
    xarray = None

SIZE = (320, 240)


def hill(rows=48, columns=64):
    """A round hill, whose top is at column 40, row 30."""
    j, i = np.mgrid[0:rows, 0:columns].astype(np.float32)
    return 12.0 * np.exp(-((i - 40.0) ** 2 + (j - 30.0) ** 2) / 120.0)


def draw(heights, **options):
    """Picture of a terrain from the south-west, with the terrain and its plotter."""
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
    plotter.disable_anti_aliasing()
    options.setdefault("show_scalar_bar", False)
    terrain = plotting.add_terrain(plotter, heights, **options)
    plotter.camera_position = [(-40.0, -50.0, 50.0), (32.0, 22.0, 0.0), (0.0, 0.0, 1.0)]
    picture = plotter.screenshot(return_img=True)
    return picture, terrain, plotter


@unittest.skipIf(pyvista is None, "PyVista is not installed")
class TestPyVista(unittest.TestCase):
    def test_picture(self):
        picture, _, _ = draw(hill(), exaggeration=1.5, cmap="terrain")
        vtkTerrainTesting.compare_with_baseline(self, picture, "PythonPyVista")
        self.assertAlmostEqual((picture != picture[0, 0]).any(axis=2).mean(), 0.312, delta=0.005)

    def test_globe(self):
        latitude, longitude = np.mgrid[-89.5:90:1.0, -179.5:180:1.0]
        heights = 3000.0 * np.cos(np.radians(3.0 * longitude)) * np.cos(np.radians(latitude))
        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
        terrain = plotting.add_terrain(
            plotter, heights.astype(np.float32), frame="globe", spacing=(1.0, 1.0), origin=(-179.5, -89.5),
            coordinate_system="EPSG:4326", show_scalar_bar=False)
        self.assertGreater(terrain.GetBounds()[1], 6378137.0)
        plotter.camera_position = [(3.0e7, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
        picture = plotter.screenshot(return_img=True)
        shown = (picture != picture[0, 0]).any(axis=2)
        self.assertTrue(shown[120, 160])
        # a ball: as wide as it is high
        self.assertLess(abs(int(shown.any(axis=0).sum()) - int(shown.any(axis=1).sum())), 3)
        scene = [0.0, 0.0, 0.0]
        plotting.terrain_scene(plotter).PlacesToScene([90.0, 0.0, 0.0], scene, 1)
        self.assertAlmostEqual(scene[1], 6378137.0)
        with self.assertRaisesRegex(ValueError, "longitude and latitude"):
            plotting.add_terrain(plotter, hill(), frame="globe", coordinate_system="EPSG:32633")
        with self.assertRaisesRegex(ValueError, "frame must be"):
            plotting.add_terrain(plotter, hill(), frame="flat")

    def test_every_kind_of_heights_gives_the_same_picture(self):
        heights = hill()
        expected, _, _ = draw(heights)
        self.assertGreater((expected != expected[0, 0]).any(axis=2).mean(), 0.2)
        grid = pyvista.ImageData(dimensions=(64, 48, 1))
        grid["heights"] = heights.ravel()
        path = pathlib.Path(vtkTerrainTesting.output_path("pyvista-hill.asc"))
        vtkTerrainTesting.write_ascii_grid(path, heights)
        kinds = [grid, heights.tolist(), path, str(path)]
        if xarray is not None:
            kinds.append(xarray.DataArray(heights, dims=("y", "x")))
        for kind in kinds:
            picture, _, _ = draw(kind)
            self.assertLess((np.abs(picture.astype(int) - expected) > 2).mean(), 1e-4, type(kind))

    def test_every_technique_draws_the_surface(self):
        expected, _, _ = draw(hill())
        for technique in ("linear", "exponential", "equidistant", "mesh", "strips"):
            picture, _, _ = draw(hill(), technique=technique)
            self.assertLess((np.abs(picture.astype(int) - expected) > 8).mean(), 0.01, technique)

    def test_prepared_files(self):
        expected, _, _ = draw(hill())
        path = vtkTerrainTesting.output_path("pyvista.prepared")
        hierarchy = plotting.vtkTerrainHierarchy()
        self.assertTrue(hierarchy.SetHeights(plotting.heights_from(hill())), hierarchy.GetErrorMessage())
        self.assertTrue(hierarchy.WriteFile(path), hierarchy.GetErrorMessage())
        for technique in ("pyramid", "strips"):
            picture, _, _ = draw(path, technique=technique)
            self.assertLess((np.abs(picture.astype(int) - expected) > 24).mean(), 0.02, technique)
        with open(path, "r+b") as file:
            file.truncate(5000)
        for technique in ("pyramid", "strips"):
            with self.assertRaisesRegex(OSError, "5000 bytes"):
                draw(path, technique=technique)

    def test_options(self):
        plain, terrain, plotter = draw(hill(), exaggeration=2.0, clim=(2.0, 8.0), name="hill")
        self.assertAlmostEqual(terrain.GetBounds()[5], 2.0 * hill().max(), 4)
        self.assertEqual(terrain.GetLookupTable().GetRange(), (2.0, 8.0))
        self.assertIs(plotter.actors["hill"], terrain)
        with_bar, _, barred = draw(hill(), exaggeration=2.0, clim=(2.0, 8.0), show_scalar_bar=True,
                                   scalar_bar_args={"title": "Height (m)"})
        self.assertEqual(list(barred.scalar_bars.keys()), ["Height (m)"])
        changed = (plain != with_bar).any(axis=2)
        self.assertTrue(changed[-70:].any())
        self.assertFalse(changed[:-80].any())
        red, _, _ = draw(hill(), color="red")
        self.assertEqual(red[..., 1][red[..., 0] > red[..., 2].astype(int) + 50].max(), 0)
        clear, _, _ = draw(hill(), exaggeration=2.0, clim=(2.0, 8.0), opacity=0.4)
        self.assertTrue((clear != plain).any())

    def test_texture_spans_the_terrain_with_its_upper_edge_in_the_north(self):
        quarters = np.full((40, 60, 3), 255, dtype=np.uint8)
        quarters[:20, :30] = (255, 0, 0)  # north-west
        quarters[20:, 30:] = (0, 0, 255)  # south-east
        path = vtkTerrainTesting.output_path("quarters.png")
        vtkTerrainTesting.write_picture(path, quarters)
        for texture in (quarters, pyvista.Texture(quarters), path):
            _, _, plotter = draw(np.zeros((48, 64)), texture=texture)
            plotter.view_xy()
            plotter.enable_parallel_projection()
            picture = plotter.screenshot(return_img=True).astype(int)
            seen = np.argwhere((picture[..., 0] > 100) & (picture[..., 2] < 50))
            self.assertGreater(len(seen), 1000)
            self.assertTrue((seen.mean(axis=0) < (SIZE[1] / 2, SIZE[0] / 2)).all())
            seen = np.argwhere((picture[..., 2] > 100) & (picture[..., 0] < 50))
            self.assertTrue((seen.mean(axis=0) > (SIZE[1] / 2, SIZE[0] / 2)).all())

    def test_a_named_terrain_replaces_the_one_before(self):
        _, _, plotter = draw(hill(), name="hill", show_scalar_bar=True)
        again = plotting.add_terrain(plotter, hill() * 2.0, name="hill")
        self.assertIs(plotter.actors["hill"], again)
        self.assertEqual(sum(type(actor) is type(again) for actor in plotter.actors.values()), 1)

    def test_picking(self):
        _, terrain, plotter = draw(hill())
        picked = []
        plotting.enable_terrain_picking(plotter, lambda point, picker: picked.append(
            (point, picker.GetHeight(), picker.GetActor())), side="left")
        plotter.renderer.SetWorldPoint(40.0, 30.0, float(hill().max()), 1.0)
        plotter.renderer.WorldToDisplay()
        x, y, _ = plotter.renderer.GetDisplayPoint()
        plotter.iren._mouse_left_button_click(round(x), round(y))
        self.assertEqual(len(picked), 1)
        point, height, actor = picked[0]
        np.testing.assert_allclose(point, (40.0, 30.0, 12.0), atol=0.7)
        self.assertAlmostEqual(height, point[2], 6)
        self.assertIs(actor, terrain)
        plotter.iren._mouse_left_button_click(1, SIZE[1] - 2)
        self.assertEqual(len(picked), 1)

    def test_component_of_the_plotter(self):
        if not hasattr(pyvista, "register_plotter_component"):
            component = plotting.TerrainComponent(pyvista.Plotter(off_screen=True))
        else:
            component = pyvista.Plotter(off_screen=True).terrain
        self.assertTrue(component.add(hill()).HasSurface())
        component.enable_picking(print)

    def test_gallery(self):
        folder = pathlib.Path(vtkTerrainTesting.output_path("gallery"))
        folder.mkdir(exist_ok=True)
        script = pathlib.Path(__file__).parents[2] / "Examples" / "Python" / "gallery.py"
        subprocess.run([sys.executable, script, folder], check=True)
        for name in ("relief", "from_numpy", "picking"):
            picture = vtkTerrainTesting.read_picture(folder / f"{name}.png")
            self.assertEqual(picture.shape, (540, 960, 3))
            self.assertGreater(len(np.unique(picture.reshape(-1, 3), axis=0)), 500, name)

    @unittest.skipUnless(importlib.util.find_spec("trame_vtk"), "trame-vtk is not installed")
    def test_a_browser_that_renders_by_itself_gets_a_mesh_and_a_warning(self):
        from trame_vtk.modules.vtk import serializers

        _, terrain, plotter = draw(hill(), exaggeration=2.0)
        serializers.initialize_serializers()
        context = serializers.SynchronizationContext()
        with self.assertWarnsRegex(RuntimeWarning, 'use the mode "server"'):
            sent = serializers.serialize(plotter.renderer, terrain, "terrain", context, 0)
        mesh = next(part for part in sent["dependencies"] if part["type"] == "vtkMapper")["dependencies"][0]
        count = mesh["properties"]["points"]["size"] // 3
        self.assertEqual(count, terrain.surface.n_points)
        self.assertGreater(count, 100)
        self.assertAlmostEqual(terrain.surface.bounds[5], 24.0, delta=1.0)

    def test_each_view_of_a_browser_is_told_once(self):
        """What stands in for trame's views, which Debian's VTK cannot make: the words that are asked of them."""

        class State(dict):
            has = dict.__contains__

        class View:
            def __init__(self, is_of_server):
                plotter = types.SimpleNamespace(_id_name="P_1")
                self._plotter = lambda: plotter
                self.server = types.SimpleNamespace(state=State(P_1_use_server_rendering=is_of_server))

            def update_geometry(self):
                plotting._warn_of_browsers("terrain")

        first, second, of_server = View(False), View(False), View(True)
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("default")
            for view, count in ((first, 1), (first, 1), (of_server, 1), (second, 2)):
                view.update_geometry()
                self.assertEqual(len(told), count)  # the same words of each, not only of the first in a process
        self.assertRegex(str(told[1].message), 'mode "client".* cannot show terrain: use the mode "server"')

    def test_refusals(self):
        plotter = pyvista.Plotter(off_screen=True)
        with self.assertRaisesRegex(ValueError, "technique"):
            plotting.add_terrain(plotter, hill(), technique="fast")
        with self.assertRaisesRegex(ValueError, "above 0"):
            plotting.add_terrain(plotter, hill(), exaggeration=0.0)
        with self.assertRaisesRegex(ValueError, "no surface"):
            plotting.add_terrain(plotter, np.full((3, 3), np.nan))
        with self.assertRaisesRegex(OSError, "/nowhere.tif"):
            plotting.add_terrain(plotter, "/nowhere.tif")
        with self.assertRaisesRegex(TypeError, "spacing"):
            plotting.add_terrain(plotter, pyvista.ImageData(dimensions=(2, 2, 1)), spacing=(1.0, 1.0))
        self.assertEqual(len(plotter.actors), 0)


if __name__ == "__main__":
    vtkTerrainTesting.run()
