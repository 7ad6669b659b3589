# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""add_terrain beside add_mesh: bars, kinds of grids, words, attributes, and what lies on the ground."""
import pathlib
import re
import unittest
import warnings

import numpy as np
import vtkTerrainTesting
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkTerrainTesting import hill, look

try:
    import pyvista

    from vtkterrain import plotting
except ImportError as error:
    pyvista = None
    WHY_NOT = str(error)

SIZE = (240, 180)


def ends_of(table):
    return [tuple(np.rint(255 * np.array(table.GetTableValue(k))).astype(int)) for k in (0, 255)]


def table_of(bar):
    return ends_of(bar.GetLookupTable())


def colors_of(terrain):
    return ends_of(terrain.GetLookupTable())


@unittest.skipIf(pyvista is None, "PyVista is not installed")
class ParityTest(unittest.TestCase):
    def plotter(self, **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE, **options)
        self.addCleanup(plotter.close)
        return plotter

    def add(self, heights=None, plotter=None, **options):
        options.setdefault("show_scalar_bar", False)
        return plotting.add_terrain(plotter or self.plotter(), hill() if heights is None else heights, **options)

    def draw(self, heights=None, **options):
        plotter = self.plotter()
        terrain = self.add(heights, plotter, **options)
        return look(plotter), terrain


class TestSeenByOthers(ParityTest):
    """What a terrain tells others, and what it refuses, as a mesh of PyVista does."""

    def test_vectors_are_their_magnitude(self):
        heights = hill()
        rows, columns = heights.shape
        y, x = np.mgrid[0:1:rows * 1j, 0:1:columns * 1j]
        vectors = np.dstack([0.0 * x + 1.0, 20.0 * y, 5.0 * x])
        for component, values in ((None, np.linalg.norm(vectors, axis=2)), (1, vectors[..., 1]), (2, vectors[..., 2])):
            drawn, terrain = self.draw(heights, scalars=vectors, component=component, cmap="viridis")
            expected, _ = self.draw(heights, scalars=values, cmap="viridis")
            np.testing.assert_allclose(drawn, expected, atol=4)
            np.testing.assert_allclose(terrain.mapper.scalar_range, (values.min(), values.max()))
            self.assertGreater(len(np.unique(drawn.reshape(-1, 3), axis=0)), 50)

    def test_exporters_leave_ranges_as_they_are(self):
        for suffix, export in (("wrl", "export_vrml"), ("gltf", "export_gltf")):
            plotter = self.plotter()
            terrain = self.add(plotter=plotter)
            before, range_before = look(plotter), terrain.mapper.scalar_range
            getattr(plotter, export)(vtkTerrainTesting.output_path(f"range.{suffix}"))
            self.assertEqual(terrain.mapper.scalar_range, range_before)
            np.testing.assert_array_equal(look(plotter), before)

    def test_opacities_are_checked(self):
        terrain = self.add()
        for wrong in (-1, 2, 7.0, np.nan, np.inf):
            with self.assertRaisesRegex(ValueError, "opacity must be a number from 0, not seen, to 1, opaque, not"):
                self.add(opacity=wrong)
            with self.assertRaisesRegex(ValueError, "opacity must be a number from 0"):
                terrain.opacity = wrong
        terrain.opacity = 0.25
        self.assertEqual(terrain.opacity, 0.25)

    def test_walls_that_cannot_be_closed(self):
        heights = hill().astype(float)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", DeprecationWarning)  # of others
            self.add(heights, block=-3.0)
            inner = heights.copy()
            inner[20:25, 20:25] = np.nan
            self.add(inner, block=-3.0)
            heights[:8] = np.nan
            self.add(heights)
            last = heights.shape[1] - 1, heights.shape[0] - 1
            self.add(heights, block=-3.0, extract=((0, last[0]), (8, last[1])))
        with self.assertWarnsRegex(UserWarning, "the block has no wall where there is no height along its sides"):
            self.add(heights, block=-3.0)

    def test_a_bar_goes_with_the_colors(self):
        plotter = self.plotter()
        terrain = self.add(plotter=plotter, show_scalar_bar=True)
        (bar,) = plotter.scalar_bars.values()
        terrain.texture = pyvista.Texture(np.full((2, 2, 3), 90, np.uint8))
        self.assertFalse(bar.GetVisibility())
        terrain.texture = None
        self.assertTrue(bar.GetVisibility())

    def test_a_bar_below_a_drape(self):
        places = pathlib.Path(__file__).parents[2] / "Examples" / "Places"
        plotter = self.plotter()
        terrain = self.add(str(places / "heights.tif"), plotter, drape=str(places / "photo.tif"), show_scalar_bar=None)
        drape, covered = terrain.GetTerrainMapper().GetDrape(), plotting.is_covered(terrain)
        self.assertEqual(len(plotter.scalar_bars), 0 if covered else 1)
        opaque = drape.NewInstance()
        opaque.DeepCopy(drape)
        vtk_to_numpy(opaque.GetPointData().GetScalars())[:, 3] = 255
        west, east, south, north = terrain.GetHeights().GetBounds()[:4]
        terrain.GetTerrainMapper().SetDrape(opaque, (west, east, south, north))
        self.assertTrue(plotting.is_covered(terrain))
        terrain.GetTerrainMapper().SetDrape(opaque, (west + (east - west) / 2, east, south, north))
        self.assertFalse(plotting.is_covered(terrain))


class TestBars(ParityTest):
    def test_each_terrain_has_its_own(self):
        plotter = self.plotter()
        first = self.add(plotter=plotter, cmap="hot", show_scalar_bar=True)
        second = self.add(hill() + 20.0, plotter, cmap="viridis", show_scalar_bar=True, name="east",
                          origin=(60.0, 0.0))
        third = self.add(hill() + 40.0, plotter, cmap="gray", show_scalar_bar=True, origin=(120.0, 0.0))
        bars = plotter.scalar_bars
        self.assertEqual(list(bars.keys()), ["Elevation", "Elevation of east", "Elevation 2"])
        for terrain, title in zip((first, second, third), bars.keys()):
            self.assertEqual(table_of(bars[title]), colors_of(terrain))
            self.assertEqual(bars[title].GetLookupTable().GetRange(), terrain.mapper.scalar_range)

    def test_it_goes_with_the_terrain(self):
        for order in ((0, 1, 2), (1, 0, 2), (2, 1, 0)):
            plotter = self.plotter()
            terrains = [self.add(hill() + 20.0 * k, plotter, show_scalar_bar=True) for k in range(3)]
            titles = list(plotter.scalar_bars.keys())
            for k in order:
                plotter.remove_actor(terrains[k])
                titles[k] = None
                self.assertEqual(list(plotter.scalar_bars.keys()), [title for title in titles if title])
            self.assertEqual(plotter.renderer.GetActors2D().GetNumberOfItems(), 0)

    def test_a_terrain_that_replaces_another_has_one_bar(self):
        plotter = self.plotter()
        for cmap in ("hot", "viridis"):
            terrain = self.add(plotter=plotter, cmap=cmap, name="hill", show_scalar_bar=True)
        self.assertEqual(list(plotter.scalar_bars.keys()), ["Elevation"])
        self.assertEqual(table_of(plotter.scalar_bars["Elevation"]), colors_of(terrain))

    def test_beside_a_mesh_and_in_subplots(self):
        plotter = self.plotter(shape=(1, 2))
        sphere = pyvista.Sphere()
        sphere["Elevation"] = sphere.points[:, 2]
        plotter.add_mesh(sphere, cmap="gray")
        plotter.subplot(0, 1)
        terrain = self.add(plotter=plotter, cmap="hot", show_scalar_bar=True)
        self.assertEqual(list(plotter.scalar_bars.keys()), ["Elevation", "Elevation 2"])
        np.testing.assert_allclose(plotter.scalar_bars["Elevation"].GetLookupTable().GetRange(), (-0.5, 0.5), atol=0.01)
        self.assertEqual(plotter.renderers[1].HasViewProp(plotter.scalar_bars["Elevation 2"]), 1)
        plotter.remove_actor(terrain)
        self.assertEqual(list(plotter.scalar_bars.keys()), ["Elevation"])

    def test_slope_and_aspect(self):
        plotter = self.plotter()
        for scalars in ("slope", "aspect"):
            self.add(plotter=plotter, scalars=scalars, show_scalar_bar=True)
        self.assertEqual([bar.GetLookupTable().GetRange() for bar in plotter.scalar_bars.values()],
                         [(0.0, 30.0), (0.0, 360.0)])

    def test_numbers_can_be_read(self):
        from vtkterrain._bars import label_format

        for (low, high), expected in (((212.155, 1900.0), ["212", "634", "1056", "1478", "1900"]),
                                      ((1.06, 9.5), ["1.1", "3.2", "5.3", "7.4", "9.5"]),
                                      ((0.0, 0.01), ["0.0000", "0.0025", "0.0050", "0.0075", "0.0100"]),
                                      ((0.0, 60.0), ["0", "15", "30", "45", "60"])):
            labels = [label_format(low, high) % value for value in np.linspace(low, high, 5)]
            self.assertEqual(labels, expected)

    def test_ranges_follow(self):
        plotter = self.plotter()
        terrain = self.add(plotter=plotter, show_scalar_bar=True)
        plotter.update_scalar_bar_range((0.0, 5.0))
        self.assertEqual(terrain.mapper.scalar_range, (0.0, 5.0))
        terrain.set_heights(2.0 * hill())
        self.assertEqual(terrain.mapper.scalar_range, (0.0, 5.0))
        terrain.set_heights(2.0 * hill(), follow=True)
        bar = plotter.scalar_bars["Elevation"]
        for of in (terrain.mapper.scalar_range, bar.GetLookupTable().GetRange()):
            np.testing.assert_allclose(of, (2.0 * hill().min(), 2.0 * hill().max()), rtol=1e-6)


    def test_ranges_of_other_scalars_do_not_follow_the_heights(self):
        values = np.linspace(-1.0, 1.0, 41 * 51).reshape(41, 51)
        for scalars, expected in (("slope", (0.0, 30.0)), ("aspect", (0.0, 360.0)), (values, (-1.0, 1.0))):
            plotter = self.plotter()
            terrain = self.add(plotter=plotter, scalars=scalars, show_scalar_bar=True)
            terrain.set_heights(20.0 * hill(), follow=True)
            for of in (terrain.mapper, *(bar.GetLookupTable() for bar in plotter.scalar_bars.values())):
                np.testing.assert_allclose(of.scalar_range, expected)


class TestGrids(ParityTest):
    """Every regular grid gives the picture of the plain array."""

    def setUp(self):
        self.heights = hill()
        self.x, self.y = np.linspace(10.0, 60.0, 51), np.linspace(-20.0, 20.0, 41)
        self.values = np.cos(np.arange(51) / 6.0) + np.arange(41)[:, None] / 20.0
        self.expected, _ = self.draw(x=self.x, y=self.y)
        self.colored, _ = self.draw(x=self.x, y=self.y, scalars=self.values, cmap="plasma")

    def check(self, grid, name=None):
        for picture, options in ((self.expected, {}), (self.colored, {"scalars": "values", "cmap": "plasma"})):
            np.testing.assert_allclose(self.draw(grid, **options)[0], picture, atol=3, err_msg=name)

    def test_structured(self):
        for flip_x in (1, -1):
            for flip_y in (1, -1):
                x, y = np.meshgrid(self.x[::flip_x], self.y[::flip_y])
                z, values = self.heights[::flip_y, ::flip_x], self.values[::flip_y, ::flip_x]
                grid = pyvista.StructuredGrid(x, y, z.astype(float))
                grid["values"] = values.ravel(order="F")
                self.check(grid, f"rows first {flip_x} {flip_y}")
                grid = pyvista.StructuredGrid(x.T, y.T, z.T.astype(float))
                grid["values"] = values.T.ravel(order="F")
                self.check(grid, f"columns first {flip_x} {flip_y}")

    def test_rectilinear(self):
        grid = pyvista.RectilinearGrid(self.x, self.y)
        grid["values"] = self.values.ravel()
        grid["heights"] = self.heights.ravel()
        grid.set_active_scalars("heights")
        self.check(grid)

    def test_coordinates_of_meshgrid(self):
        x, y = np.meshgrid(self.x, self.y)
        np.testing.assert_allclose(self.draw(x=x, y=y)[0], self.expected, atol=3)
        np.testing.assert_allclose(self.draw(self.heights[::-1], x=x, y=y[::-1])[0], self.expected, atol=3)

    def test_coordinates_must_be_those_of_the_heights(self):
        x, y = np.meshgrid(self.x, self.y)
        for options, pattern in (
                ({"x": self.x[:50]}, "x has 50 numbers, the heights have 51 columns"),
                ({"x": self.x, "y": self.x}, "y has 51 numbers, the heights have 41 rows"),
                ({"x": np.arange(41.0), "y": np.arange(51.0)}, "x has 41 numbers"),
                ({"x": x[:, :50], "y": y[:, :50]}, "of the heights, 41 x 51, .* x is 41 x 50"),
                ({"x": x}, "41 x 51"), ({"x": 3.0}, "x has 1 numbers"),
                ({"x": self.x, "spacing": (2.0, 2.0)}, "leave out spacing"),
                ({"y": self.y, "origin": (0.0, 0.0)}, "leave out origin"),
                ({"y": self.y, "first_row": "north"}, "leave out first_row"),
                ({"x": self.x}, "x needs y: give the coordinates of both"), ({"y": self.y}, "y needs x"),
                ({"x": self.x, "first_row": "north"}, "x needs y")):
            with self.assertRaisesRegex(ValueError, pattern):
                self.add(**options)

    def test_blanked_points_are_holes(self):
        grid = pyvista.StructuredGrid(*np.meshgrid(self.x, self.y), self.heights.astype(float))
        grid.hide_points(range(5))
        _, terrain = self.draw(grid)
        self.assertEqual(np.isnan(terrain.heights["Elevation"]).sum(), 5)

    def test_refusals(self):
        x, y = np.meshgrid(self.x, self.y)
        cells = pyvista.ImageData(dimensions=(5, 5, 1))
        cells.cell_data["a"] = np.zeros(16)
        colors = pyvista.ImageData(dimensions=(5, 5, 1))
        colors["a"] = np.zeros((25, 3))
        block = pyvista.ImageData(dimensions=(5, 5, 5))
        block["a"] = np.zeros(125)
        wall = pyvista.ImageData(dimensions=(5, 1, 5))
        wall["a"] = np.zeros(25)
        for heights, kind, pattern in (
                (None, TypeError, "not NoneType"), (pyvista.Sphere(), TypeError, "not PolyData"),
                ({}, TypeError, "not dict"), (cells, ValueError, "arrays are of cells"),
                (colors, ValueError, "'a' of this ImageData has 3"), (block, ValueError, "5 x 5 x 5 points"),
                (wall, ValueError, "5 x 1 x 5 points"),
                (pyvista.ImageData(dimensions=(5, 5, 1)), ValueError, "no active point scalars"),
                (pyvista.StructuredGrid(x + 0.1 * y, y, x), ValueError, "no regular grid"),
                (pyvista.StructuredGrid(x**2, y, x), ValueError, "x coordinates of this StructuredGrid"),
                (np.zeros((2, 20000), np.float32), ValueError, "2 x 20000 samples .* 16384")):
            plotter = self.plotter()
            with self.assertRaisesRegex(kind, pattern):
                plotting.add_terrain(plotter, heights)
            self.assertEqual(len(plotter.actors), 0)
        with self.assertRaisesRegex(TypeError, "the plotter is a ndarray"):
            plotting.add_terrain(hill(), self.plotter())


class TestWords(ParityTest):
    def test_errors_name_what_was_typed(self):
        for options, pattern in (
                ({"spacing": 0.1}, "spacing"), ({"origin": 3}, "origin"), ({"scalar_bar_args": "H"}, "scalar_bar_args"),
                ({"name": 3}, "name"), ({"exaggeration": "2"}, "exaggeration"), ({"extract": 3}, "extract"),
                ({"detail": 3}, "detail"), ({"texture": 3}, "texture"), ({"user_matrix": 3}, "user_matrix"),
                ({"nodata": "x"}, "nodata"), ({"n_colors": 0}, "n_colors"), ({"component": 7}, "component"),
                ({"scalars": hill(), "component": 7}, "component"), ({"rgb": True}, "rgb"),
                ({"scalars": hill(), "rgb": True}, "rgb"), ({"scene": 3}, "scene"), ({"sun_angle": "x"}, "sun_angle"),
                ({"smooth_shading": False}, "smooth_shading"), ({"show_edges": True}, 'technique="mesh"'),
                ({"opacity": np.full((41, 51), 2.0)}, "0 to 1"), ({"opacity": np.zeros((3, 3))}, "41 x 51"),
                ({"opacity": "linear", "color": "red"}, "opacity"),
                ({"scalars": "slope", "categories": True}, "categories")):
            with self.assertRaisesRegex((TypeError, ValueError), pattern):
                self.add(**options)

    def test_categories(self):
        classes = np.digitize(hill(), (3.0, 5.0))
        picture, terrain = self.draw(scalars=classes, cmap=["red", "lime", "blue"], categories=True, lighting=False)
        self.assertEqual(terrain.mapper.lookup_table.n_values, 3)
        for color in ((255, 0, 0), (0, 255, 0), (0, 0, 255)):
            self.assertGreater((np.abs(picture - color).max(axis=2) < 8).mean(), 0.003, color)
        self.assertEqual(self.add(categories=4).GetLookupTable().n_values, 4)

    def test_opacity_of_samples(self):
        alpha = np.zeros((41, 51))
        alpha[:, 26:] = 1.0
        solid, _ = self.draw(cmap="viridis")
        background = solid[0, 0]
        half, _ = self.draw(cmap="viridis", opacity=alpha)
        image = pyvista.wrap(plotting.heights_from(hill()))
        image["alpha"] = alpha.ravel()
        image.set_active_scalars("Elevation")
        named, _ = self.draw(image, cmap="viridis", opacity="alpha")
        np.testing.assert_array_equal(half, named)
        seen = (solid != background).any(axis=2)
        left, right = seen.copy(), seen.copy()
        middle = SIZE[0] // 2
        left[:, middle - 20:], right[:, :middle + 20] = False, False
        self.assertTrue((half[left] == background).all())
        self.assertLess(np.quantile(np.abs(half[right] - solid[right]), 0.98), 6)  # all but the border

    def test_edges_of_techniques_that_have_some(self):
        for technique in ("mesh", "strips"):
            plain, _ = self.draw(technique=technique)
            edges, _ = self.draw(technique=technique, show_edges=True, edge_color="red")
            self.assertGreater((edges != plain).any(axis=2).mean(), 0.02)

    def test_silhouette(self):
        pictures = []
        for options in ({}, {"silhouette": {"color": "red", "line_width": 3.0}}):
            plotter = self.plotter()
            self.add(plotter=plotter, exaggeration=3.0, **options)
            plotter.view_vector((0.2, -1.0, 0.2), viewup=(0.0, 0.0, 1.0))
            pictures.append(plotter.screenshot(return_img=True).astype(int))
        self.assertGreater((np.abs(pictures[1] - pictures[0]).max(axis=2) > 60).sum(), 60)

    def test_themes(self):
        theme = pyvista.plotting.themes.DocumentTheme()
        relief = self.add(plotter=self.plotter(theme=theme)).GetLookupTable().values
        theme.cmap, theme.nan_color = "hot", "magenta"
        table = self.add(plotter=self.plotter(theme=theme)).GetLookupTable()
        np.testing.assert_array_equal(table.values, pyvista.LookupTable("hot").values)
        self.assertEqual(table.nan_color, pyvista.Color("magenta"))
        self.assertTrue((relief != table.values).any())


class TestWildValues(ParityTest):
    """A few values that are none spoil no colours but their own."""

    def draw_values(self, values, heights):
        plotter = self.plotter()
        self.add(heights, plotter, scalars=values, clim=(0.0, 1.0), cmap="viridis")
        plotter.view_xy()
        return plotter.screenshot(return_img=True).astype(int)

    def test_hidden_ones_and_seen_ones(self):
        values = np.tile(np.linspace(0.0, 1.0, 51, dtype=np.float32), (41, 1))
        for is_hidden in (True, False):
            heights = hill()
            if is_hidden:
                heights[20, 25] = np.nan
            expected = self.draw_values(values, heights)
            for wild in (-1e17, 1e17, -3.4028e38, 1e35, -9999.0, np.inf, np.nan):
                spoilt = values.copy()
                spoilt[20, 25] = wild
                differ = (np.abs(self.draw_values(spoilt, heights) - expected) > 8).any(axis=2).mean()
                self.assertLess(differ, 1e-6 if is_hidden else 0.003, (is_hidden, wild))

    def test_mostly_hidden(self):
        heights = np.full((41, 51), np.nan, np.float32)
        heights[15:25, 20:30] = hill()[15:25, 20:30]
        values = np.tile(np.linspace(0.0, 1.0, 51, dtype=np.float32), (41, 1))
        expected = self.draw_values(values, heights)
        np.testing.assert_array_equal(self.draw_values(np.where(np.isnan(heights), -1e17, values), heights), expected)

    def test_large_values_close_together(self):
        values = np.tile(np.linspace(0.0, 1.0, 51), (41, 1))
        expected = self.draw_values(values, hill())
        plotter = self.plotter()
        self.add(plotter=plotter, scalars=values + 1e7, clim=(1e7, 1e7 + 1.0), cmap="viridis")
        plotter.view_xy()
        np.testing.assert_allclose(plotter.screenshot(return_img=True).astype(int), expected, atol=3)


class TestWarnings(ParityTest):
    def warnings_of(self, heights, **options):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            warnings.simplefilter("ignore", DeprecationWarning)  # of others
            plotting.heights_from(heights, **options)
        return [str(each.message) for each in caught]

    def test_of_arrays(self):
        heights = hill()
        heights[3, 3] = -9999.0
        self.assertEqual(self.warnings_of(heights, spacing=(1.0, 1.0)),
                         ['heights: 1 samples of -9999 are taken for no data (nodata="none" if they are heights)'])
        told = self.warnings_of(heights, spacing=(0.01, 0.01))
        self.assertEqual(len(told), 2, told)
        self.assertIn("check height_unit, nodata, crs", told[0])
        self.assertEqual(self.warnings_of(heights, nodata="none"), [])

    def test_options_are_those_of_python(self):
        from vtkterrain._intake import in_words_of_python

        for said, expected in (
                ("'a.tif': (--crs EPSG:4326 for longitude)", "'a.tif': (crs=\"EPSG:4326\" for longitude)"),
                ("(--height-unit names the unit)", "(height_unit names the unit)"),
                ("(--height-unit m if they are metres)", "(height_unit=\"m\" if they are metres)"),
                ("(--height-unit -1 for depths)", "(height_unit=-1 for depths)"),
                ("(--part NAME)", "(part=NAME)"), ("(--part chooses another)", "(part chooses another)"),
                ("choose a band (--band 1), unless", "choose a band (band=1), unless"),
                ("(--flip if that is wrong)", "(flip if that is wrong)"),
                ("check --height-unit, --nodata, --crs", "check height_unit, nodata, crs"),
                ("(gdalwarp -dstnodata -9999 IN OUT.tif)", "(gdalwarp -dstnodata -9999 IN OUT.tif)"),
                ("'array': as needles: --nodata 5 hides", "heights: as needles: nodata=5 hides")):
            self.assertEqual(in_words_of_python(said), expected)


class TestTerrainAttributes(ParityTest):
    def test_it_has_those_of_an_actor(self):
        terrain = self.add()
        missing = [name for name in dir(pyvista.Actor()) if name[0].islower() and not hasattr(terrain, name)]
        # newer PyVista's are of shaders and points, which are ours, and of volumes
        missing = [name for name in missing if not re.search("shader_replacement|point_sprite|maximum_intensity", name)]
        self.assertLessEqual(set(missing), {"check_attribute", "rotation_from"})
        with self.assertRaisesRegex(AttributeError, "no attribute 'scalar_rang'"):
            terrain.mapper.scalar_rang = (0, 1)

    def test_copies_look_the_same(self):
        plotter = self.plotter()
        values = np.cos(np.arange(51) / 6.0) + np.arange(41)[:, None] / 20.0
        for options in ({}, {"scalars": values, "cmap": "plasma"}, {"color": "red", "specular": 1.0},
                        {"contours": 1.0, "exaggeration": 2.0},
                        {"scalars": "slope", "user_matrix": np.diag([1, 2, 1, 1])}):
            terrain = self.add(plotter=plotter, **options)
            expected = look(plotter)
            plotter.remove_actor(terrain)
            copy = terrain.copy()
            plotter.add_actor(copy)
            np.testing.assert_array_equal(look(plotter), expected)
            copy.prop.opacity = 0.3
            self.assertEqual(terrain.prop.opacity, 1.0)
            plotter.remove_actor(copy)

    def test_transforms(self):
        terrain, actor = self.add(), pyvista.Actor()
        for step in ((lambda of: of.rotate_x(20.0)), (lambda of: of.rotate_z(30.0)), (lambda of: of.rotate_y(-10.0))):
            step(terrain)
            step(actor)
        np.testing.assert_allclose(terrain.orientation, actor.orientation)
        for mode in ("post", "pre"):
            for of in (terrain, actor):
                of.transform(np.diag([1.0, 2.0, 3.0, 1.0]), mode, inplace=True)
                of.transform([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]], mode, inplace=True)
            np.testing.assert_allclose(terrain.user_matrix, actor.user_matrix)

    def test_axes_tell_true_heights(self):
        plotter = self.plotter()
        terrain = self.add(plotter=plotter, exaggeration=3.0)
        plotter.show_bounds(mesh=terrain, axes_ranges=terrain.axes_ranges)
        axes = plotter.renderer.cube_axes_actor
        np.testing.assert_allclose(axes.GetZAxisRange(), (hill().min(), hill().max()), rtol=1e-6)
        np.testing.assert_allclose(axes.GetBounds()[4:], (3.0 * hill().min(), 3.0 * hill().max()), rtol=1e-6)

    def test_integers_with_holes_come_with_nan(self):
        heights = pyvista.ImageData(dimensions=(10, 10, 1))
        heights["Elevation"] = np.full(100, 700, np.int16)
        heights["Elevation"][:50] = 900
        ghosts = np.zeros(100, np.uint8)
        ghosts[45], heights["Elevation"][45] = 2, 0
        heights.GetPointData().AddArray(pyvista.convert_array(ghosts, name="vtkGhostType"))
        terrain = self.add(heights)
        of_filters = terrain.heights
        self.assertEqual(of_filters.get_data_range(), (700.0, 900.0))
        self.assertEqual(np.flatnonzero(np.isnan(of_filters["Elevation"])).tolist(), [45])
        self.assertEqual(of_filters.threshold(650, invert=True).n_cells, 0)
        self.assertEqual(heights["Elevation"].dtype, np.int16)

    def test_other_heights_may_have_fill(self):
        holes = np.zeros((41, 51), bool)
        holes[5:8, 5:8] = True
        for fill, nodata in ((-9999.0, None), (-9999, -9999), (3.0, 3.0)):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                warnings.simplefilter("ignore", DeprecationWarning)  # of others
                terrain = self.add()
                terrain.set_heights(np.where(holes, fill, hill()), follow=True, nodata=nodata)
            samples = terrain.heights["Elevation"].reshape(41, 51)
            np.testing.assert_array_equal(np.isnan(samples), holes)
            self.assertAlmostEqual(terrain.mapper.scalar_range[0], hill()[~holes].min(), 4)
            self.assertEqual(["nodata=" in str(each.message) for each in caught], [True] * (nodata is None))
        terrain.set_heights(np.where(holes, -9999.0, hill()), follow=True, nodata="none")
        self.assertEqual(terrain.mapper.scalar_range[0], -9999.0)
        with self.assertRaisesRegex(ValueError, "nodata"):
            terrain.set_heights(hill(), nodata="x")

    def test_other_heights_keep_other_arrays(self):
        values = np.cos(np.arange(51) / 6.0) + np.arange(41)[:, None] / 20.0
        for first_row in ("south", "north"):
            plotter = self.plotter()
            heights = hill() if first_row == "south" else hill()[::-1].copy()
            terrain = self.add(heights, plotter, first_row=first_row, scalars=values, cmap="plasma")
            expected = look(plotter)
            terrain.set_heights(hill())
            np.testing.assert_allclose(look(plotter), expected, atol=3)


class TestGround(ParityTest):
    def setUp(self):
        self.plot = self.plotter()
        self.terrain = self.add(plotter=self.plot, exaggeration=2.0, user_matrix=np.diag([1.0, 1.0, 1.5, 1.0]))

    def expected(self, points):
        """z of the bilinear surface as drawn, 0.4 lifted above it."""
        i, j = np.minimum(points[:, 0].astype(int), 49), np.minimum(points[:, 1].astype(int), 39)
        u, v = points[:, 0] - i, points[:, 1] - j
        h = hill().astype(float)
        heights = ((1 - v) * ((1 - u) * h[j, i] + u * h[j, i + 1])
                   + v * ((1 - u) * h[j + 1, i] + u * h[j + 1, i + 1]))
        return 3.0 * (heights + 0.4)

    def test_a_track(self):
        corners = [(2.0, 3.0), (30.5, 20.25), (48.0, 38.0)]
        track = plotting.track_on(self.terrain, corners, offset=0.4)
        self.assertGreater(track.n_points, 60)
        np.testing.assert_allclose(track.points[:, 2], self.expected(track.points), atol=1e-3)
        np.testing.assert_allclose(track.points[[0, -1], :2], [corners[0], corners[-1]])
        before = look(self.plot)
        actor = plotting.add_track(self.plot, self.terrain, corners, color="magenta")
        drawn = look(self.plot)
        self.assertGreater((np.abs(drawn - (255, 0, 255)).max(axis=2) < 60).sum(), 60)
        self.plot.remove_actor(actor)
        np.testing.assert_array_equal(look(self.plot), before)
        lines = pyvista.MultipleLines(np.array([(*corner, 99.0) for corner in corners]))
        np.testing.assert_allclose(plotting.track_on(self.terrain, lines, offset=0.4).points, track.points, atol=1e-6)

    def test_places(self):
        places = np.array([(5.0, 5.0), (25.0, 16.0), (500.0, 5.0), (40.0, 30.5)])
        actor = plotting.add_places(self.plot, self.terrain, places, labels=["a", "b", "c", "d"], offset=0.4)
        laid = actor.mapper.dataset
        np.testing.assert_allclose(laid.points[:, :2], places[[0, 1, 3]])
        np.testing.assert_allclose(laid.points[:, 2], self.expected(places[[0, 1, 3]]), atol=1e-3)
        self.assertEqual(laid["place"].tolist(), [0, 1, 3])

    def test_in_longitude_and_latitude(self):
        plotter = self.plotter()
        terrain = self.add(np.full((20, 20), 5.0), plotter, spacing=(100.0, 100.0), origin=(500000.0, 5540000.0),
                           crs="EPSG:32632")
        track = plotting.track_on(terrain, [(9.005, 50.013), (9.02, 50.02)], coordinates="places", offset=0.0)
        for place, point in zip([(9.005, 50.013), (9.02, 50.02)], track.points[[0, -1]]):
            scene = [*place, 0.0]
            plotting.terrain_scene(plotter).PlacesToScene([*place, 0.0], scene, 1)
            np.testing.assert_allclose(point[:2], scene[:2], atol=0.01)

    def test_refusals(self):
        for points, options, pattern in (([(1, 2, 3, 4)], {}, "N x 2"), ([(1, 2)], {}, "two points"),
                                         ([(900, 2), (901, 3)], {}, "lies on the terrain"),
                                         ([(1, 2), (3, 4)], {"coordinates": "map"}, '"scene"'),
                                         ([(1, 2), (3, 4)], {"coordinates": "places"}, "coordinate system")):
            with self.assertRaisesRegex(ValueError, pattern):
                plotting.add_track(self.plot, self.terrain, points, **options)
        with self.assertRaisesRegex(ValueError, "2 places, not 1"):
            plotting.add_places(self.plot, self.terrain, [(1, 2), (3, 4)], labels=["a"])

    def test_a_plane_that_cuts(self):
        before = look(self.plot)
        plotting.add_clip_plane(self.plot, self.terrain, normal="x", implicit=False)
        self.plot.clear_plane_widgets()
        cut = look(self.plot)
        background = before[0, 0]
        gone = ((before != background).any(axis=2) & (cut == background).all(axis=2))
        share = gone.sum() / (before != background).any(axis=2).sum()
        self.assertTrue(0.3 < share < 0.7, share)
        self.assertFalse(gone[:, :SIZE[0] // 2 - 30].any())


if __name__ == "__main__":
    vtkTerrainTesting.run()
