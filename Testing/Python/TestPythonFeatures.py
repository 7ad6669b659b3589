# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeoPandas frames on a terrain, and DataArrays as terrain; skipped without them."""
import pathlib
import unittest

import numpy as np
import vtkTerrainTesting

try:
    import geopandas
    import pyproj
    import pyvista
    import shapely
    import xarray

    from vtkterrain import features, places, plotting, xarrays
except ImportError:
    geopandas = None

WEST, SOUTH, STEP = 480_000.0, 3_090_000.0, 30.0


def surface(x, y):
    """A plane: bilinear interpolation is exact on it."""
    return 100.0 + 0.1 * (x - WEST) - 0.05 * (y - SOUTH)


def heights(system="EPSG:32645"):
    x, y = WEST + STEP * np.arange(50), SOUTH + STEP * np.arange(40)
    return xarray.DataArray(surface(x, y[:, None]), dims=("y", "x"), coords={"y": y, "x": x},
                            attrs={"crs": system} if system else {})


@unittest.skipIf(geopandas is None, "GeoPandas, PyVista or xarray is not installed")
class TestFeatures(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(200, 150))
        self.terrain = plotting.add_terrain(self.plotter, heights(), exaggeration=2.0)

    def tearDown(self):
        self.plotter.close()

    def test_places_are_those_of_pyproj(self):
        to_map = pyproj.Transformer.from_crs(4326, 32645, always_xy=True)
        lonlat = np.array([[86.80, 27.935], [86.805, 27.94]])
        placed = places.Placement(self.terrain.GetHeights()).from_places(lonlat)
        np.testing.assert_allclose(placed, np.column_stack(to_map.transform(*lonlat.T)), atol=1e-3)

    def test_tracks_lie_on_the_surface_whatever_their_system(self):
        line = shapely.LineString([(WEST + 100, SOUTH + 100), (WEST + 900, SOUTH + 700)])
        square = shapely.box(WEST + 300, SOUTH + 300, WEST + 400, SOUTH + 400)
        frame = geopandas.GeoDataFrame({"n": [1, 2]}, geometry=[line, shapely.MultiPolygon([square])], crs=32645)
        for other in (frame, frame.to_crs(4326), frame.to_crs(3857), frame.set_crs(None, allow_override=True)):
            mesh = features.tracks_from_frame(self.terrain, other, offset=0.0)
            self.assertEqual(sorted(set(mesh.cell_data["row"])), [0, 1])
            x, y, z = mesh.points.T
            np.testing.assert_allclose(z, 2.0 * surface(x, y), atol=0.05)
            self.assertGreater(mesh.n_points, 30)
            np.testing.assert_allclose(mesh.bounds[:4], (WEST + 100, WEST + 900, SOUTH + 100, SOUTH + 700), atol=0.01)

    def test_points_off_the_surface_are_left_out(self):
        frame = geopandas.GeoDataFrame({"name": ["hut", "sea", "top"]}, crs=32645, geometry=[
            shapely.Point(WEST + 50, SOUTH + 50), shapely.Point(WEST - 5000, SOUTH),
            shapely.Point(WEST + 600, SOUTH + 600)])
        mesh = features.points_from_frame(self.terrain, frame.to_crs(4326), offset=3.0)
        self.assertEqual(mesh.point_data["row"].tolist(), [0, 2])
        x, y, z = mesh.points.T
        np.testing.assert_allclose(z, 2.0 * (surface(x, y) + 3.0), atol=0.05)
        features.add_points(self.plotter, self.terrain, frame, labels="name")

    def test_what_is_drawn_is_seen(self):
        before = self.plotter.screenshot(return_img=True)
        line = shapely.LineString([(WEST, SOUTH), (WEST + 1400, SOUTH + 1100)])
        features.add_tracks(self.plotter, self.terrain, geopandas.GeoDataFrame(geometry=[line], crs=32645),
                            color="magenta", line_width=5)
        after = self.plotter.screenshot(return_img=True).astype(int)
        magenta = (after[..., 0] > 200) & (after[..., 1] < 60) & (after[..., 2] > 200)
        self.assertGreater(magenta.sum(), 50)
        self.assertGreater((before != after).sum(), 100)

    def test_refusals(self):
        nothing = geopandas.GeoDataFrame(geometry=[], crs=4326)
        self.assertRaisesRegex(ValueError, "no line", features.tracks_from_frame, self.terrain, nothing)
        self.assertRaisesRegex(ValueError, "no point", features.points_from_frame, self.terrain, nothing)
        nowhere = plotting.add_terrain(self.plotter, heights(system=None))
        frame = geopandas.GeoDataFrame(geometry=[shapely.Point(86.8, 27.9)], crs=4326)
        with self.assertRaisesRegex(ValueError, "coordinate system"):
            features.points_from_frame(nowhere, frame)

    def test_points_in_words(self):
        placement = places.Placement(self.terrain.GetHeights())
        text = placement.describe(WEST + 300.0, SOUTH + 300.0, 115.0)
        self.assertRegex(text, r"86\.79|86°47")
        self.assertRegex(text, r"^Height 115\.0 m  Place 27\.\d+N 86\.\d+E  UTM 45n \d+ \d+  MGRS 45R\w+$")
        alone = places.Placement(xarrays.heights_from_dataarray(heights(system=None)))
        self.assertFalse(alone.is_on_earth)
        self.assertEqual(alone.describe(1.0, 2.0, 3.0), "x 1  y 2  height 3.00")


@unittest.skipIf(geopandas is None, "GeoPandas, PyVista or xarray is not installed")
class TestAccessor(unittest.TestCase):
    def test_it_is_made_once_and_shares_memory(self):
        data = heights().astype(np.float32)
        self.assertIs(data.terrain.heights, data.terrain.heights)
        from vtkterrain import array_from_heights

        self.assertTrue(np.shares_memory(array_from_heights(data.terrain.heights), data.values))

    def test_plot_writes_a_picture(self):
        path = vtkTerrainTesting.output_path("accessor.png")
        line = shapely.LineString([(WEST, SOUTH), (WEST + 1400, SOUTH + 1100)])
        frame = geopandas.GeoDataFrame(geometry=[line], crs=32645)
        points = geopandas.GeoDataFrame(geometry=[shapely.Point(WEST + 700, SOUTH + 500)], crs=32645)
        heights().terrain.plot(screenshot=path, window_size=(300, 200), tracks=frame, points=points)
        picture = vtkTerrainTesting.read_picture(path)
        self.assertEqual(picture.shape[:2], (200, 300))
        self.assertGreater(len(np.unique(picture.reshape(-1, picture.shape[2]), axis=0)), 100)

    def test_rioxarray(self):
        try:
            import rioxarray
        except ImportError:
            self.skipTest("rioxarray is not installed")
        path = pathlib.Path(__file__).parents[2] / "Examples" / "Places" / "heights.tif"
        data = rioxarray.open_rasterio(path, masked=True)
        image = data.terrain.heights
        lowest, highest = image.GetScalarRange()
        self.assertAlmostEqual(highest, float(data.max()), delta=0.05 * highest)
        self.assertGreaterEqual(lowest, float(data.min()) - 1.0)
        self.assertTrue(places.Placement(image).is_on_earth)


if __name__ == "__main__":
    vtkTerrainTesting.run()
