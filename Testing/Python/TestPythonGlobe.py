# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planets from files in PyVista's plotters, against numbers from the samples; skipped without PyVista and GDAL."""
import unittest

import numpy as np
import vtkTerrainTesting

try:
    import pyvista

    from vtkterrain import plotting
    from vtkterrain.vtkTerrain import vtkTerrainPicker
except ImportError:
    pyvista = None
try:
    from osgeo import gdal, osr
except ImportError:
    gdal = None

SIZE = 300
ANGLE = np.radians(30.0)


class World:
    """A planet in a file: its semi-axes, the longitude of its western edge, what its samples count from."""

    def __init__(self, name, crs, equatorial, polar, west, datum=0.0):
        self.name, self.crs, self.equatorial, self.polar = name, crs, equatorial, polar
        self.west, self.datum, self.step = west, datum, 2.0
        self.latitude, self.longitude = np.meshgrid(
            np.arange(-89.0, 90.0, 2.0), west + np.arange(1.0, 360.0, 2.0), indexing="ij")
        x, y = np.radians(self.longitude), np.radians(self.latitude)
        self.heights = np.round(
            1e-3 * equatorial * (0.4 * np.cos(y) ** 2 * np.sin(x + 0.7) + 0.2 * np.cos(y) ** 2 * np.sin(5.0 * x)
                                 + 0.15 * np.sin(2.0 * y + 0.3)))

    def write(self):
        path = vtkTerrainTesting.output_path(f"globe-{self.name}.tif")
        rows, columns = self.heights.shape
        file = gdal.GetDriverByName("GTiff").Create(path, columns, rows, 1, gdal.GDT_Float32)
        file.SetGeoTransform((self.west, self.step, 0.0, 90.0, 0.0, -self.step))
        system = osr.SpatialReference()
        system.SetFromUserInput(self.crs)
        file.SetProjection(system.ExportToWkt())
        file.GetRasterBand(1).WriteArray((self.heights[::-1] + self.datum).astype(np.float32))
        file.FlushCache()
        return path

    def place_of(self, point):
        """Longitude, latitude in degrees and height of a geocentric point, by iteration."""
        off, squared = np.hypot(*point[:2]), 1.0 - (self.polar / self.equatorial) ** 2
        latitude = np.arctan2(point[2], off * (1.0 - squared))
        for _ in range(20):
            normal = self.equatorial / np.sqrt(1.0 - squared * np.sin(latitude) ** 2)
            latitude = np.arctan2(point[2] + squared * normal * np.sin(latitude), off)
        height = off * np.cos(latitude) + point[2] * np.sin(latitude) - self.equatorial**2 / normal
        return np.degrees(np.arctan2(point[1], point[0])), np.degrees(latitude), height

    def point_of(self, longitude, latitude, height):
        x, y = np.radians(longitude), np.radians(latitude)
        squared = 1.0 - (self.polar / self.equatorial) ** 2
        normal = self.equatorial / np.sqrt(1.0 - squared * np.sin(y) ** 2)
        return np.array([(normal + height) * np.cos(y) * np.cos(x), (normal + height) * np.cos(y) * np.sin(x),
                         (normal * (1.0 - squared) + height) * np.sin(y)])

    def height_at(self, longitude, latitude):
        """Of the samples, bilinear; between the last rows."""
        x = (longitude - self.west - 1.0) / self.step % 180.0
        y = np.clip((latitude + 89.0) / self.step, 0.0, 88.999)
        i, j = int(x), int(y)
        rows = self.heights[j : j + 2][:, [i, (i + 1) % 180]]
        south, north = rows @ [i + 1 - x, x - i]
        return south * (j + 1 - y) + north * (y - j)


WORLDS = (
    World("earth", "EPSG:4326", 6378137.0, 6356752.314245179, -180.0),
    World("mars", "IAU_2015:49900", 3396190.0, 3396190.0, 0.0),
    World("moon", "IAU_2015:30100", 1737400.0, 1737400.0, -180.0, datum=1737400.0),
)


@unittest.skipIf(pyvista is None or gdal is None, "PyVista or GDAL's Python module is not installed")
class TestGlobe(unittest.TestCase):
    def draw(self, world, eye=(-35.0, 20.0), far=3.0, **options):
        """A planet from above a place, in radii from its centre."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(SIZE, SIZE))
        plotter.disable_anti_aliasing()
        options.setdefault("show_scalar_bar", False)
        terrain = plotting.add_terrain(plotter, world.write(), frame="globe", **options)
        position = world.point_of(*eye, (far - 1.0) * world.equatorial)
        plotter.camera_position = [tuple(position), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
        plotter.camera.view_angle = 30.0
        return plotter.screenshot(return_img=True).astype(int), terrain, plotter

    @staticmethod
    def pixel_of(plotter, point):
        """Row from the top and column of a point of the scene."""
        plotter.renderer.SetWorldPoint(*point, 1.0)
        plotter.renderer.WorldToDisplay()
        column, row = plotter.renderer.GetDisplayPoint()[:2]
        return np.array([SIZE - 1 - row, column])

    def test_pictures_show_the_whole_planet(self):
        for world in WORLDS:
            with self.subTest(world.name):
                picture, terrain, _ = self.draw(world, far=5.0)
                shown = (picture != picture[0, 0]).any(axis=2)
                disc = np.tan(np.arcsin(1.0 / 5.0)) / np.tan(0.5 * ANGLE) * 0.5 * SIZE
                self.assertAlmostEqual(np.sqrt(shown.sum() / np.pi) / disc, 1.0, delta=0.01)
                bounds = np.reshape(terrain.GetBounds(), (3, 2))
                highest = np.abs(world.heights).max()
                self.assertTrue((np.abs(bounds) < world.equatorial + 2.0 * highest).all())

    def test_picks_tell_place_and_height(self):
        for world in WORLDS:
            for exaggeration in (1.0, 8.0):
                with self.subTest(f"{world.name}, {exaggeration}"):
                    _, terrain, plotter = self.draw(world, exaggeration=exaggeration)
                    scene, picker = plotting.terrain_scene(plotter), vtkTerrainPicker()
                    for column, row in ((150, 150), (80, 130), (200, 220), (150, 60), (230, 150)):
                        self.assertTrue(picker.Pick(column, row, 0.0, plotter.renderer))
                        point = np.array(picker.GetPickPosition())
                        longitude, latitude, drawn = world.place_of(point)
                        height = world.height_at(longitude, latitude)
                        self.assertAlmostEqual(picker.GetHeight(), height, delta=0.1)
                        self.assertAlmostEqual(drawn, exaggeration * height, delta=1.0)
                        place = np.zeros(3)
                        self.assertTrue(scene.SceneToPlaces(point, place, 1))
                        np.testing.assert_allclose(place[:2], (longitude, latitude), atol=1e-6)
                        self.assertIs(picker.GetActor(), terrain)

    def test_contours_lie_where_heights_are_theirs(self):
        for world in WORLDS:
            with self.subTest(world.name):
                interval = 2e-4 * world.equatorial
                picture, _, plotter = self.draw(world, color="white", lighting=False, contours=interval)
                picker = vtkTerrainPicker()
                lines, wrong = 0, 0
                for row, column in np.argwhere(picture.max(axis=2) < 60)[::7]:
                    heights = []
                    for beside in ((0, 0), (-2, 0), (2, 0), (0, -2), (0, 2)):
                        if picker.Pick(column + beside[0], SIZE - 1 - row + beside[1], 0.0, plotter.renderer):
                            place = world.place_of(picker.GetPickPosition())
                            heights.append(world.height_at(*place[:2]) / interval)
                    lines += 1
                    wrong += np.floor(min(heights, default=0.1)) == np.floor(max(heights, default=0.1))
                self.assertGreater(lines, 50)
                self.assertLess(wrong, 0.02 * lines)

    def test_colours_and_their_bar(self):
        world = WORLDS[1]
        _, terrain, plotter = self.draw(world, show_scalar_bar=True)
        self.assertEqual(len(plotter.scalar_bars), 1)
        np.testing.assert_allclose(
            terrain.GetLookupTable().GetRange(), (world.heights.min(), world.heights.max()), atol=1.0)

    def test_exaggeration_shows_relief(self):
        for world in WORLDS:
            with self.subTest(world.name):
                _, terrain, _ = self.draw(world, exaggeration="auto")
                # relief of a thousandth of the radius, on a planet
                self.assertGreaterEqual(terrain.exaggeration, 5.0)
                self.assertLessEqual(terrain.exaggeration, 100.0)

    def test_tracks_and_places_lie_on_it(self):
        for world in WORLDS:
            with self.subTest(world.name):
                plain, terrain, plotter = self.draw(world, color="gray")
                line = plotting.track_on(terrain, [(-60.0, 0.0), (-20.0, 50.0)], coordinates="places", offset=50.0)
                self.assertGreater(line.n_points, 20)
                for point in line.points[::5]:
                    longitude, latitude, height = world.place_of(point)
                    self.assertAlmostEqual(height, world.height_at(longitude, latitude) + 50.0, delta=2.0)
                    self.assertAlmostEqual(latitude, (longitude + 60.0) * 50.0 / 40.0, delta=1e-3)
                plotting.add_track(plotter, terrain, [(-60.0, 0.0), (-20.0, 50.0)], coordinates="places", color="red")
                places = [(-30.0, 10.0), (-50.0, 30.0), (150.0, 10.0)]
                plotting.add_places(plotter, terrain, places, coordinates="places", color="blue")
                bare = plotter.screenshot(return_img=True).astype(int)
                plotting.add_places(plotter, terrain, places, coordinates="places", color="blue",
                                    labels=["HERE", "HERE", "BEHIND"])
                picture = plotter.screenshot(return_img=True).astype(int)
                written = np.argwhere((np.abs(picture - bare) > 30).any(axis=2))
                self.assertGreater(len(written), 200)
                behind = self.pixel_of(plotter, world.point_of(*places[-1], 0.0))
                self.assertGreater(np.abs(written - behind).sum(axis=1).min(), 15)
                self.assertGreater((picture[..., 0] > picture[..., 1] + 80).sum(), 60)
                self.assertGreater((picture[..., 2] > picture[..., 1] + 60).sum(), 30)
                self.assertFalse((plain[..., 0] > plain[..., 1] + 80).any())
                behind = plotting.track_on(terrain, [(150.0, 0.0), (170.0, 10.0)], coordinates="places")
                plotter.add_mesh(behind, color="lime", lighting=False, line_width=5.0)
                picture = plotter.screenshot(return_img=True).astype(int)
                self.assertFalse((picture[..., 1] > picture[..., 0] + 80).any())

    def test_refusals(self):
        world = WORLDS[0]
        for options, words in (({"technique": "mesh"}, "pyramid"), ({"sky_light": 0.5}, "sky_light"),
                               ({"block": True}, "block"), ({"silhouette": True}, "silhouette")):
            with self.assertRaisesRegex(ValueError, words):
                self.draw(world, **options)
        _, terrain, _ = self.draw(world)
        with self.assertRaisesRegex(ValueError, "places"):
            plotting.track_on(terrain, [(0.0, 0.0), (1.0, 1.0)])


if __name__ == "__main__":
    vtkTerrainTesting.run()
