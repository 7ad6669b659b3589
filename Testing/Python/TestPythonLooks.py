# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Options of add_terrain and attributes of the actor, against PyVista's own add_mesh where it has them."""
import importlib.machinery
import pathlib
import sys
import types
import unittest
import unittest.mock
import warnings

import numpy as np
import vtkTerrainTesting
from vtkTerrainTesting import hill, look

try:
    import pyvista
    from matplotlib.colors import ListedColormap

    from vtkterrain import plotting
except ImportError:
    pyvista = None

HEIGHTS = pathlib.Path(__file__).parents[2] / "Examples" / "Places" / "heights.tif"
PICTURE = pathlib.Path(__file__).parents[2] / "Examples" / "Places" / "photo.tif"
SIZE = (240, 180)


@unittest.skipIf(pyvista is None, "PyVista is not installed")
class LooksTest(unittest.TestCase):
    def plotter(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
        self.addCleanup(plotter.close)
        return plotter

    def draw(self, heights=None, **options):
        plotter = self.plotter()
        options.setdefault("show_scalar_bar", False)
        terrain = plotting.add_terrain(plotter, hill() if heights is None else heights, **options)
        return look(plotter), terrain

    def draw_mesh(self, scalars, **options):
        """The same hill as PyVista's own mesh, cells split so that both surfaces are the same to the eye."""
        plotter = self.plotter()
        z = hill()
        y, x = np.mgrid[0:z.shape[0], 0:z.shape[1]].astype(float)
        mesh = pyvista.StructuredGrid(x, y, z.astype(float))
        mesh["values"] = np.asarray(scalars, dtype=float).ravel(order="F")
        plotter.add_mesh(mesh, scalars="values", show_scalar_bar=False, smooth_shading=True, ambient=0.0, diffuse=1.0,
                         interpolate_before_map=True, **options)
        return look(plotter)

    def assert_alike(self, first, second, share=0.97, tolerance=24):
        same = (np.abs(first - second).max(axis=2) <= tolerance).mean()
        self.assertGreater(same, share)

    def assert_differ(self, first, second, share=0.01):
        self.assertGreater((np.abs(first - second).max(axis=2) > 8).mean(), share)


class TestColors(LooksTest):
    def test_as_add_mesh(self):
        heights = hill()
        for options in ({"cmap": "viridis"}, {"cmap": "viridis", "flip_scalars": True},
                        {"cmap": "viridis", "n_colors": 5}, {"cmap": "viridis", "log_scale": True, "clim": (1.0, 9.0)},
                        {"cmap": "viridis", "clim": (3.0, 6.0), "below_color": "red", "above_color": "blue"}):
            with self.subTest(options):
                self.assert_alike(self.draw(**options)[0], self.draw_mesh(heights, **options), 0.95)

    def test_a_sun_and_a_first_label(self):
        with self.assertRaisesRegex(TypeError, "no option sun; a sun is that of hillshade="):
            self.draw(sun=(300, 20))
        _, terrain = self.draw(np.linspace(-0.15, 1047.0, 48 * 64).reshape(48, 64), show_scalar_bar=True)
        self.assertEqual(terrain.mapper.scalar_range[0], 0.0)

    def test_no_label_is_zero_with_a_sign(self):
        for low, high in ((-0.15, 1047.0), (-0.9996, 0.9993), (-0.33334, 1.0), (-0.5002, 0.5), (-3.00003, 1.0),
                          (-1.0, -0.0001)):
            heights = np.linspace(low, high, 48 * 64).reshape(48, 64)
            plotter = self.plotter()
            terrain = plotting.add_terrain(plotter, heights, show_scalar_bar=True)
            bar = next(iter(plotter.scalar_bars.values()))
            labels = [bar.GetLabelFormat() % value for value in np.linspace(*terrain.mapper.scalar_range, 5)]
            self.assertEqual(bar.GetNumberOfLabels(), 5)
            self.assertFalse([label for label in labels if label[0] == "-" and float(label) == 0.0], labels)
            self.assertLess(np.abs(np.subtract(terrain.mapper.scalar_range, (low, high))).max(), 0.01 * (high - low))

    def test_color_maps_by_name(self):
        import matplotlib

        table = {name: self.draw(cmap=name)[1].mapper.lookup_table.values for name in (
            "viridis", "viridis_r", "oleron", "oleron_r", "relief")}
        expected = np.rint(255 * np.array(matplotlib.colormaps["viridis"](np.arange(256)))).astype(int)
        self.assertLessEqual(np.abs(table["viridis"].astype(int) - expected).max(), 1)
        for name in ("viridis", "oleron"):
            self.assertTrue((table[name] == table[f"{name}_r"][::-1]).all())
        self.assertGreater(int(table["oleron"][100, 2]), int(table["oleron"][100, 0]))  # its sea
        self.assertTrue((table["relief"] == self.draw()[1].mapper.lookup_table.values).all())
        for name, words in (("virdis", "colour map 'virdis', but 'viridis'"), ("no such", "colour map 'no such'")):
            self.assertRaisesRegex(ValueError, words, self.draw, cmap=name)

    def test_color_maps_of_packages(self):
        """Packages that have what is looked up in theirs stand in for them, installed or not."""
        red_and_lime = ListedColormap(["red", "lime"])
        for package, part, names in (("cmocean", "cmap_d", ("topo", "cmocean.topo", "cmo.topo")),
                                     ("cmcrameri", "cmaps", ("hawaii", "cmc.hawaii"))):
            stand_in = types.ModuleType(package)
            stand_in.__spec__ = importlib.machinery.ModuleSpec(package, None)
            stand_in.cm = types.SimpleNamespace(**{part: {names[0]: red_and_lime}})
            with unittest.mock.patch.dict(sys.modules, {package: stand_in}):
                for name in names:
                    values = self.draw(cmap=name)[1].mapper.lookup_table.values
                    self.assertEqual(values[[0, -1], :3].tolist(), [[255, 0, 0], [0, 255, 0]], name)

    def test_packages_that_are_not_there_are_named(self):
        with (unittest.mock.patch("importlib.util.find_spec", lambda name: name == "matplotlib"),
              self.assertRaisesRegex(ValueError, "pip install colorcet cmocean cmcrameri$")):
            self.draw(cmap="topo")

    def test_an_array_beside_the_heights(self):
        values = np.cos(np.arange(51) / 6.0) + np.arange(41)[:, None] / 20.0
        expected = self.draw_mesh(values, cmap="plasma")
        self.assert_alike(self.draw(scalars=values, cmap="plasma")[0], expected, 0.95)
        north = self.draw(hill()[::-1].copy(), first_row="north", scalars=values, cmap="plasma")[0]
        self.assert_alike(north, expected, 0.95)
        image = plotting.heights_from(hill())
        wrapped = pyvista.wrap(image)
        wrapped["values"] = values.ravel()
        wrapped.set_active_scalars("Elevation")
        self.assert_alike(self.draw(wrapped, scalars="values", cmap="plasma")[0], expected, 0.95)
        self.assertEqual(sorted(wrapped.point_data), ["Elevation", "values"])

    def test_nan_and_hidden_values(self):
        values = hill().astype(float)
        values[:20] = np.nan
        self.assert_alike(self.draw(scalars=values, cmap="viridis", nan_color="magenta")[0],
                          self.draw_mesh(values, cmap="viridis", nan_color="magenta"), 0.93)
        heights, wild = hill(), hill().astype(float)
        heights[5, 5] = np.nan
        wild[5, 5] = -3.4028e38
        _, terrain = self.draw(heights, scalars=wild, cmap="viridis")
        np.testing.assert_allclose(terrain.mapper.scalar_range, (np.nanmin(heights), np.nanmax(heights)), atol=0.1)

    def test_bytes_are_values(self):
        values = (hill() * 20.0).astype(np.uint8)
        options = {"cmap": "viridis", "clim": (20.0, 190.0)}
        expected = self.draw_mesh(values, **options)
        image = pyvista.wrap(plotting.heights_from(hill()))
        image["bytes"] = values.ravel()
        image.set_active_scalars("Elevation")
        for picture in (self.draw(scalars=values, **options)[0], self.draw(image, scalars="bytes", **options)[0]):
            self.assert_alike(picture, expected, 0.95)
        is_high = hill() > 4.0
        for options in ({"cmap": ["blue", "lime"]}, {"cmap": ["blue", "lime"], "categories": True}):
            flags, _ = self.draw(scalars=is_high, lighting=False, **options)
            np.testing.assert_array_equal(flags, self.draw(scalars=is_high.astype(float), lighting=False, **options)[0])
        faint = {"cmap": "viridis", "opacity": np.full((41, 51), 0.5)}
        np.testing.assert_array_equal(self.draw(scalars=values, **faint)[0],
                                      self.draw(scalars=values.astype(float), **faint)[0])

    def test_heights_in_bytes(self):
        heights = (hill() * 20.0).astype(np.uint8)
        for technique in ("pyramid", "linear", "mesh", "strips"):
            for options in ({}, {"cmap": "viridis"}, {"cmap": "viridis", "clim": (60.0, 120.0)},
                            {"cmap": "viridis", "opacity": "linear"}):
                with self.subTest(technique=technique, **options):
                    of_bytes, of_floats = (self.draw(of, technique=technique, exaggeration=0.1, **options)[0]
                                           for of in (heights, heights.astype(np.float32)))
                    self.assert_alike(of_bytes, of_floats, 0.995, 4)

    def test_colours_as_they_are(self):
        colors = np.zeros((41, 51, 3), np.uint8)
        colors[:, 25:] = (255, 0, 0)
        picture, _ = self.draw(scalars=colors, rgb=True, lighting=False)
        np.testing.assert_array_equal(self.draw(scalars=colors, lighting=False, show_scalar_bar=None)[0], picture)
        reds = (np.abs(picture - (255, 0, 0)).max(axis=2) < 8)
        self.assertGreater(reds.mean(), 0.1)
        self.assertFalse(reds[:, :SIZE[0] // 4].any())

    def test_a_texture_keeps_its_colours(self):
        picture = np.full((8, 8, 3), (200, 100, 50), np.uint8)
        for options, expected in (({}, (200, 100, 50)), ({"color": "red"}, (200, 0, 0))):
            drawn, terrain = self.draw(texture=picture, lighting=False, **options)
            self.assertGreater((np.abs(drawn - expected).max(axis=2) < 4).mean(), 0.15, options)
        self.assertEqual(terrain.prop.color, pyvista.Color("red"))

    def test_a_texture_that_is_set_later(self):
        picture = np.full((8, 8, 3), (200, 100, 50), np.uint8)
        plotter = self.plotter()
        terrain = plotting.add_terrain(plotter, hill(), lighting=False, cmap="viridis", show_scalar_bar=False)
        before, color = look(plotter), terrain.prop.color
        terrain.texture = pyvista.Texture(picture)
        drawn = look(plotter)
        self.assertGreater((np.abs(drawn - (200, 100, 50)).max(axis=2) < 4).mean(), 0.15)
        copied = terrain.copy()
        for other in (copied, terrain):
            other.texture = None
            self.assertEqual(other.prop.color, color)
            self.assertTrue(other.GetColorByHeight())
        np.testing.assert_array_equal(look(plotter), before)

    def test_edges_of_a_theme(self):
        theme = pyvista.themes.DocumentTheme()
        theme.show_edges = True
        theme.edge_color = "red"
        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE, theme=theme)
        self.addCleanup(plotter.close)
        with self.assertWarnsRegex(UserWarning, "rays have none"):
            terrain = plotting.add_terrain(plotter, hill())
        self.assertFalse(terrain.prop.show_edges)
        with warnings.catch_warnings():
            warnings.simplefilter("error", UserWarning)
            plotting.add_terrain(plotter, hill(), show_edges=False)
            meshed = plotting.add_terrain(plotter, hill(), technique="mesh")
        self.assertTrue(meshed.prop.show_edges)
        self.assertEqual(meshed.prop.edge_color, pyvista.Color("red"))

    def test_opacity_of_colours(self):
        solid, _ = self.draw(cmap="viridis")
        faint, _ = self.draw(cmap="viridis", opacity=0.4)
        linear, _ = self.draw(cmap="viridis", opacity="linear")
        self.assert_differ(solid, faint)
        self.assert_differ(solid, linear)
        self.assert_differ(faint, linear)

    def test_a_texture_without_a_place_is_no_warning(self):
        path = vtkTerrainTesting.output_path("texture.png")
        vtkTerrainTesting.write_picture(path, np.full((8, 8, 3), (200, 100, 50), np.uint8))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", DeprecationWarning)  # of others
            picture, _ = self.draw(texture=str(path), lighting=False)
        self.assertGreater((np.abs(picture - (200, 100, 50)).max(axis=2) < 4).mean(), 0.15)

    def test_rows_that_differ_in_length(self):
        ragged = [[1.0, 2.0, 3.0], [4.0, 5.0]]
        plotter = self.plotter()
        terrain = plotting.add_terrain(plotter, hill(), show_scalar_bar=False)
        for what, call in (("heights", lambda: plotting.add_terrain(plotter, ragged)),
                           ("heights", lambda: plotting.add_terrain(plotter, ragged, x=[0, 1, 2])),
                           ("heights", lambda: terrain.set_heights(ragged)),
                           ("scalars", lambda: plotting.add_terrain(plotter, hill(), scalars=ragged)),
                           ("opacity", lambda: plotting.add_terrain(plotter, hill(), opacity=ragged))):
            with self.assertRaisesRegex(ValueError, f"^{what} must be .*: these rows differ in length$"):
                call()

    def test_slope_and_aspect(self):
        slope, terrain = self.draw(scalars="slope")
        self.assertEqual(terrain.mapper.scalar_range, (0.0, 30.0))  # 2 % are steeper
        self.assert_differ(slope, self.draw(scalars="aspect")[0])

    def test_refusals(self):
        plotter = self.plotter()
        for options, pattern in (({"clim": (4, -1)}, "clim"), ({"clim": (np.nan, 2)}, "clim"), ({"clim": "H"}, "clim"),
                                 ({"scalars": "nothing"}, "nothing"), ({"scalars": np.zeros((3, 3))}, "41 x 51"),
                                 ({"log_scale": True, "clim": (-1, 3)}, "log_scale"), ({"contours": -1}, "contours"),
                                 ({"block": 99.0}, "block"), ({"hillshade": 3}, "hillshade"),
                                 ({"exaggeration": np.inf}, "exaggeration"),
                                 ({"x": np.arange(51.0)**2, "y": np.arange(41.0)}, "x must"),
                                 ({"x": np.arange(51.0)}, "x needs y")):
            with self.assertRaisesRegex(ValueError, pattern):
                plotting.add_terrain(plotter, hill(), **options)
        with self.assertRaisesRegex(TypeError, "add_terrain has no option colour"):
            plotting.add_terrain(plotter, hill(), colour="red")
        with self.assertRaisesRegex(TypeError, "drape"):
            plotting.add_terrain(plotter, hill(), drape=np.zeros((2, 2)))
        self.assertEqual(len(plotter.actors), 0)


class TestOwnOptions(LooksTest):
    def test_each_changes_the_picture(self):
        plain, _ = self.draw()
        for options in ({"contours": True}, {"contours": 0.7}, {"hillshade": True}, {"hillshade": (90, 20)},
                        {"block": True}, {"block": -5.0}, {"extract": ((10, 30), (10, 30))}, {"lighting": False},
                        {"ambient": 0.9}, {"specular": 1.0, "specular_power": 4.0},
                        {"user_matrix": np.diag([1.0, 1.0, 3.0, 1.0])}, {"culling": "back", "opacity": 0.5}):
            with self.subTest(options):
                self.assert_differ(plain, self.draw(**options)[0])

    def test_lines_and_points(self):
        options = {"cmap": "viridis", "lighting": False}
        for style, size in (("wireframe", {"line_width": 3.0}), ("points", {"point_size": 5.0})):
            expected = self.draw_mesh(hill(), style=style, **size, **options)
            drawn, terrain = self.draw(technique="mesh", style=style, **size, **options)
            background = expected[0, 0]
            both = (expected != background).any(axis=2) & (drawn != background).any(axis=2)
            self.assertGreater(both.mean(), 0.05)
            self.assertGreater((np.abs(drawn - expected)[both].max(axis=1) < 40).mean(), 0.95, style)
            self.assert_differ(drawn, self.draw(technique="strips", style=style, **size, **options)[0])
            terrain.prop.style = "surface"
            for technique in ("pyramid", "linear"):
                with self.assertRaisesRegex(ValueError, f"style='{style}' needs technique=\"mesh\""):
                    self.draw(technique=technique, style=style)
                _, rays = self.draw(technique=technique)
                for of in (rays, rays.copy()):
                    with self.assertRaisesRegex(ValueError, "rays have neither lines nor points"):
                        of.prop.style = style
                    with self.assertRaisesRegex(ValueError, "rays have no edges"):
                        of.prop.show_edges = True
                    self.assertEqual((of.prop.style.lower(), of.prop.show_edges), ("surface", False))
                with self.assertRaisesRegex(ValueError, "rays have neither"):
                    rays.prop = pyvista.Property(style=style)

    def test_coordinates(self):
        for x, y in ((np.linspace(100, 200, 51), np.linspace(50, 90, 41)),
                     (np.linspace(100, 200, 51), np.linspace(90, 50, 41))):
            _, terrain = self.draw(x=x, y=y)
            np.testing.assert_allclose(terrain.bounds[:4], (100, 200, 50, 90))
            at = terrain.heights.find_closest_point((100.0, y[0], 0.0))
            self.assertEqual(terrain.heights["Elevation"][at], hill()[0, 0])

    @unittest.skipUnless(PICTURE.exists(), "there is no orthophoto")
    def test_a_drape_lies_in_its_place(self):
        plain, _ = self.draw(str(HEIGHTS))
        draped, _ = self.draw(str(HEIGHTS), drape=str(PICTURE))
        self.assert_differ(plain, draped, 0.05)
        with self.assertWarnsRegex(UserWarning, "photo.tif' knows its place.*drape='.*photo.tif'"):
            self.draw(str(HEIGHTS), texture=str(PICTURE))
        with self.assertRaisesRegex(ValueError, "drape '/nowhere.tif'"):
            self.draw(str(HEIGHTS), drape="/nowhere.tif")


class TestActor(LooksTest):
    def test_attributes_do_what_they_say(self):
        plotter = self.plotter()
        terrain = plotting.add_terrain(plotter, hill(), show_scalar_bar=False)
        before = look(plotter)
        for name, value in (("opacity", 0.2), ("visibility", False), ("exaggeration", 3.0), ("scale", (1, 1, 2)),
                            ("position", (10.0, 0.0, 0.0)), ("orientation", (0.0, 0.0, 45.0)),
                            ("user_matrix", np.diag([1, 1, 2, 1]))):
            old = getattr(terrain, name)
            setattr(terrain, name, value)
            plotter.render()
            self.assert_differ(plotter.screenshot(return_img=True).astype(int), before)
            setattr(terrain, name, old)
        plotter.render()
        np.testing.assert_array_equal(plotter.screenshot(return_img=True).astype(int), before)

    def test_unknown_ones_are_refused(self):
        _, terrain = self.draw()
        with self.assertRaisesRegex(AttributeError, "no attribute 'opasity'.*opacity"):
            terrain.opasity = 0.2
        terrain.exaggeration = "auto"
        self.assertEqual(terrain.exaggeration, terrain.SuggestExaggeration(terrain.GetHeights()))
        with self.assertRaisesRegex(ValueError, "exaggeration"):
            terrain.exaggeration = -1.0

    def test_what_pyvista_asks_of_it(self):
        plotter = self.plotter()
        terrain = plotting.add_terrain(plotter, hill(), exaggeration=2.0, name="hill")
        self.assertIs(plotter.actors["hill"], terrain)
        self.assertAlmostEqual(terrain.bounds[5], 2.0 * hill().max(), 4)
        self.assertGreater(plotter.meshes[0].n_points, 100)
        self.assertLessEqual(plotter.meshes[0].bounds[5], terrain.bounds[5] + 1e-3)
        plotter.show_bounds(mesh=terrain)
        plotter.add_silhouette(terrain.surface)
        plotter.screenshot(return_img=True)

    def test_other_heights(self):
        plotter = self.plotter()
        terrain = plotting.add_terrain(plotter, hill(), show_scalar_bar=False)
        before = look(plotter)
        terrain.set_heights(hill() + np.linspace(0.0, 5.0, 51, dtype=np.float32))
        plotter.render()
        self.assert_differ(plotter.screenshot(return_img=True).astype(int), before)
        with self.assertRaisesRegex(ValueError, "41 x 51"):
            terrain.set_heights(np.zeros((3, 3)))

    def test_pickers_of_pyvista(self):
        plotter = self.plotter()
        plotting.add_terrain(plotter, hill(), exaggeration=2.0, show_scalar_bar=False)
        look(plotter)
        found = []
        plotter.enable_surface_point_picking(callback=lambda point, *_: found.append(point), left_clicking=True,
                                             show_message=False, show_point=False)
        plotter.iren._mouse_left_button_press(120, 90)
        plotter.iren._mouse_left_button_release(120, 90)
        self.assertEqual(len(found), 1)
        x, y, z = found[0]
        at = hill()
        i, j = int(x), int(y)
        self.assertLessEqual(2.0 * at[j:j + 2, i:i + 2].min() - 0.1, z)
        self.assertGreaterEqual(2.0 * at[j:j + 2, i:i + 2].max() + 0.1, z)

    def test_a_picked_mesh_is_one_of_pyvistas(self):
        plotter = self.plotter()
        terrain = plotting.add_terrain(plotter, hill(), exaggeration=2.0, show_scalar_bar=False)
        look(plotter)
        found = []
        plotter.enable_mesh_picking(callback=found.append, left_clicking=True, show_message=False, show=False)
        plotter.iren._mouse_left_button_press(120, 90)
        plotter.iren._mouse_left_button_release(120, 90)
        self.assertIs(found[0], terrain.surface)
        self.assertGreater(found[0].n_points, 100)


if __name__ == "__main__":
    vtkTerrainTesting.run()
