# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rasters that do not lie as others do: tiles of folders that GDAL alone shows turned over, transposed or not at all,
folders of several CRSs, rows that do not run east, distances from the centre of a planet. Skipped without GDAL."""
import importlib.util
import os
import unittest
import zipfile

import numpy as np
import vtkTerrainTesting
from vtkTerrainRasters import COLUMNS, ROWS, RasterCase, gdal, ground

from vtkterrain import _intake, array_from_heights, heights_from_array, vtkTerrainRasterReader

UTM = (5e5, 10.0, 0.0, 5e6, 0.0, -10.0)
MOON = "+proj=eqc +lat_ts=0 +R=1737400 +units=m"
RADIUS = 1737400.0


def places_of(image):
    """x and y of each sample, in the CRS, row 0 in the north."""
    origin, step = np.array(image.GetOrigin()[:2]), np.array(image.GetSpacing()[:2])
    columns, rows, _ = image.GetDimensions()
    scale = image.GetFieldData().GetArray("LayoutScale").GetTuple(0)
    shift = image.GetFieldData().GetArray("LayoutOrigin").GetTuple(0)
    x = shift[0] + (origin[0] + step[0] * np.arange(columns)) / scale[0]
    y = shift[1] + (origin[1] + step[1] * np.arange(rows)[::-1]) / scale[1]
    return np.meshgrid(x, y)


def slope(x, y):
    return 100.0 + 0.02 * (x - 5e5) - 0.01 * (y - 5e6)


def north_up(columns, rows, transform):
    """The slope at each cell of a grid."""
    x = transform[0] + (np.arange(columns) + 0.5) * transform[1]
    y = transform[3] + (np.arange(rows) + 0.5) * transform[5]
    return slope(*np.meshgrid(x, y))


class TestFolders(RasterCase):
    def check_tile(self, name, system, transform, tolerance=1e-3):
        """A tile is in a folder what it is alone, beside one east of it."""
        alone, _, _ = self.read(self.path(name))
        np.testing.assert_allclose(alone, ground(), atol=tolerance, err_msg=name)
        west, dx, _, north, _, dy = transform
        self.write(os.path.join(os.path.dirname(name), "zz_east.tif"), np.full((ROWS, 8), 7.0),
                   (west + COLUMNS * dx, dx, 0.0, north, 0.0, dy), system)
        heights, image, _ = self.read(os.path.dirname(self.path(name)))
        np.testing.assert_allclose(heights[:, :COLUMNS], alone, atol=1e-4, err_msg=name)
        np.testing.assert_allclose(heights[:, COLUMNS:], 7.0, err_msg=name)
        np.testing.assert_allclose(places_of(image)[0][0, 0], west + 0.5 * dx, rtol=1e-9)

    def test_a_tile_whose_rows_run_from_the_south(self):
        self.write("south/up.tif", ground()[::-1], (5e5, 10.0, 0.0, 5e6 - 10.0 * ROWS, 0.0, 10.0))
        self.check_tile("south/up.tif", "EPSG:32631", UTM)

    def test_a_tile_that_is_transposed(self):
        y, x = 20 + 0.01 * np.arange(ROWS), 10 + 0.01 * np.arange(COLUMNS)
        self.netcdf("lonlat/z.nc", ground()[::-1].T, y, x, order=("lon", "lat"))
        self.check_tile("lonlat/z.nc", "EPSG:4326", (9.995, 0.01, 0.0, 20.395, 0.0, -0.01))

    def test_a_tile_of_arrays_without_a_crs(self):
        number = gdal.ExtendedDataType.Create(gdal.GDT_Float64)
        file = gdal.GetDriverByName("netCDF").CreateMultiDimensional(self.path("plain/z.nc"))
        group = file.GetRootGroup()
        axes = []
        places = {"y": 5e6 - 10.0 * (np.arange(ROWS) + 0.5), "x": 5e5 + 10.0 * (np.arange(COLUMNS) + 0.5)}
        for name, values in places.items():
            axes.append(group.CreateDimension(name, None, None, values.size))
            group.CreateMDArray(name, [axes[-1]], number).Write(values)
        group.CreateMDArray("z", axes, number).Write(ground())
        del group, file
        self.check_tile("plain/z.nc", None, UTM)

    def test_a_tile_whose_heights_are_not_its_first_band(self):
        self.write("mapper/z.grd", ground(), driver="NWT_GRD")
        self.check_tile("mapper/z.grd", "EPSG:32631", UTM, tolerance=0.01)

    def test_a_tile_that_a_label_is_for(self):
        z = ground().astype("i2")
        z_path = self.write("label/z.xml", z, (0, 100, 0, 0, 0, -100), MOON, gdal.GDT_Int16, driver="PDS4")
        self.assertTrue(os.path.exists(z_path[:-4] + ".img"))
        self.check_tile("label/z.xml", MOON, (0, 100, 0, 0, 0, -100))

    def test_depths_by_name_are_turned_in_a_folder_too(self):
        for name, shift in (("depths/a.tif", 0.0), ("depths/b.tif", 10.0 * COLUMNS)):
            path = self.write(name, ground(), (5e5 + shift, 10.0, 0.0, 5e6, 0.0, -10.0))
            file = gdal.Open(path, gdal.GA_Update)
            file.GetRasterBand(1).SetDescription("water depth")
            file = None
        alone, _, _ = self.read(self.path("depths/a.tif"))
        np.testing.assert_allclose(alone, -ground())
        heights, _, warning = self.read(self.path("depths"))
        np.testing.assert_allclose(heights, -np.hstack([ground(), ground()]))
        self.assertIn("--height-unit 1", warning)

    def test_a_broken_tile_is_named(self):
        self.write("broken/a.tif", ground())
        with open(self.path("broken/b.tif"), "wb") as file:
            file.write(b"II*\0")
        self.assertIn("b.tif", self.refusal(self.path("broken")))

    def test_what_is_not_looked_into_is_told(self):
        self.write("packed/a.tif", ground())
        with zipfile.ZipFile(self.path("packed/b.zip"), "w") as archive:
            archive.write(self.path("packed/a.tif"), "b.tif")
        self.assertIn("b.zip", self.read(self.path("packed"))[2])
        os.remove(self.path("packed/a.tif"))
        self.assertIn("unpack", self.refusal(self.path("packed")))

    def write_zones(self, **holes):
        """Tiles of one slope in two zones; holes are put into the second."""
        self.write("zones/a.tif", north_up(60, 60, UTM), UTM)
        wide = (500600.0, 10.0, 0.0, 5000100.0, 0.0, -10.0)
        z = north_up(80, 80, wide)
        second = self.write("second.tif", z, wide)
        gdal.Warp(self.path("zones/b.tif"), second, dstSRS="EPSG:32632", dstNodata=-9999, xRes=10, yRes=10,
                  resampleAlg="bilinear", outputType=gdal.GDT_Float64)
        file = gdal.Open(self.path("zones/b.tif"), gdal.GA_Update)
        band = file.GetRasterBand(1)
        values = band.ReadAsArray()
        is_hole = values == -9999
        is_hole[30:34, 40:44] = True
        values[is_hole] = holes.get("fill", -9999)
        band.WriteArray(values)
        if "fill" in holes:
            band.DeleteNoDataValue()

    def test_several_systems(self):
        for holes in ({}, {"fill": -32767.0}, {"fill": 1e32}):
            self.write_zones(**holes)
            heights, image, warning = self.read(self.path("zones"))
            self.assertIn("several CRSs: 1 of 2 are resampled into WGS 84 / UTM zone 31N", warning)
            x, y = places_of(image)
            is_known = np.isfinite(heights)
            # half a cell beyond the last samples the heights are theirs
            np.testing.assert_allclose(heights[is_known], slope(x, y)[is_known], atol=0.12, err_msg=str(holes))
            is_inside = (x > 500640) & (x < 501360) & (y < 5000060) & (y > 4999340)
            self.assertGreater(is_known[is_inside].mean(), 0.98)
            self.assertLess(is_known[is_inside].mean(), 1.0)
            # the grid is that of the first
            np.testing.assert_allclose((x[0, 0] - 5e5 - 5.0) % 10.0, 0.0, atol=1e-6)

    def test_integers_of_another_system_have_nothing_round_them(self):
        self.write_zones()
        turned = gdal.Open(self.path("zones/b.tif"))
        shape, transform = (turned.RasterYSize, turned.RasterXSize), turned.GetGeoTransform()
        del turned
        self.write("zones/b.tif", np.full(shape, 500), transform, "EPSG:32632", gdal.GDT_Int16)
        heights, image, _ = self.read(self.path("zones"))
        beside = heights[places_of(image)[0] > 500610.0]
        self.assertGreater(np.isnan(beside).sum(), 10)
        np.testing.assert_allclose(beside[np.isfinite(beside)], 500.0)

    def test_a_tile_without_a_system_beside_others_is_refused_and_the_remedy_works(self):
        self.write("half/a.tif", ground())
        self.write("half/b.tif", ground(), (5e5 + 10.0 * COLUMNS, 10.0, 0.0, 5e6, 0.0, -10.0), None)
        self.assertIn("gdal_translate -a_srs", self.refusal(self.path("half")))
        gdal.Translate(self.path("b.tif"), self.path("half/b.tif"), outputSRS="EPSG:32631")
        os.replace(self.path("b.tif"), self.path("half/b.tif"))
        np.testing.assert_allclose(self.read(self.path("half"))[0], np.hstack([ground(), ground()]))

    def test_rows_that_do_not_run_east(self):
        column, row = np.meshgrid(np.arange(60) + 0.5, np.arange(40) + 0.5)
        for t in ((5e5, 8.0, 3.0, 5e6, 3.0, -8.0), (5e5, 10.0, 2.0, 5e6, 0.0, -10.0),
                  (5e5, 0.0, 10.0, 5e6, -10.0, 0.0)):
            z = slope(t[0] + column * t[1] + row * t[2], t[3] + column * t[4] + row * t[5])
            path = self.write("sheared.tif", z, t)
            for options in ({}, {"CoordinateSystem": "EPSG:32632"}):
                heights, image, _ = self.read(path, **options)
                is_known = np.isfinite(heights)
                np.testing.assert_allclose(heights[is_known], slope(*places_of(image))[is_known], atol=1e-3)
                area = is_known.sum() * abs(image.GetSpacing()[0] * image.GetSpacing()[1])
                self.assertGreater(area, 0.9 * z.size * abs(t[1] * t[5] - t[2] * t[4]))

    @unittest.skipIf(importlib.util.find_spec("rioxarray") is None, "rioxarray is not installed")
    def test_rows_that_do_not_run_east_in_an_array(self):
        import rioxarray

        from vtkterrain.xarrays import heights_from_dataarray

        for t, system in (((5e5, 8.0, 3.0, 5e6, 3.0, -8.0), "EPSG:32631"),
                          ((7.0, 0.001, 0.0003, 50.0, 0.0003, -0.001), "EPSG:4326")):
            path = self.write("sheared.tif", ground(), t, system)
            by_name = _intake.lay_out(self.read(path)[1])
            array = heights_from_dataarray(rioxarray.open_rasterio(path)[0])
            np.testing.assert_allclose(array.GetBounds(), by_name.GetBounds(), atol=1e-3)
            np.testing.assert_allclose(array_from_heights(array), array_from_heights(by_name), atol=1e-2)

    def test_a_place_that_is_none_is_refused(self):
        self.assertIn("degenerate", self.refusal(self.write("flat.tif", ground(), (5e5, 10.0, 0.0, 5e6, 10.0, 0.0))))


class TestFill(RasterCase):
    def test_what_is_too_large_for_a_height_is_none_by_every_road(self):
        for fill in (-3.4028234663852886e38, 9.969209968386869e36, 1.70141e38, np.inf, -np.inf):
            z = np.where(ground() > 190.0, fill, ground()).astype("f4")
            by_name, _, _ = self.read(self.write("fill.tif", z))
            arrays = [array_from_heights(heights_from_array(z, first_row="north"))[::-1]]
            if importlib.util.find_spec("xarray"):
                import xarray

                from vtkterrain.xarrays import heights_from_dataarray

                data = xarray.DataArray(z, dims=("y", "x"), coords={
                    "y": 5e6 - 10.0 * np.arange(ROWS), "x": 5e5 + 10.0 * np.arange(COLUMNS)})
                arrays.append(array_from_heights(heights_from_dataarray(data))[::-1])
            for heights in (by_name, *arrays):
                np.testing.assert_array_equal(np.isnan(heights), ground() > 190.0, err_msg=str(fill))


@unittest.skipIf(importlib.util.find_spec("pyvista") is None, "PyVista is not installed")
class TestSites(RasterCase):
    def test_each_site_is_a_terrain_of_one_scene(self):
        import pyvista

        from vtkterrain.plotting import add_terrain

        lowest = {"a": 0.0, "b": 500.0, "c": 1000.0}
        for name, base in lowest.items():
            for tile in range(2 if name == "b" else 1):
                west = 5e5 + 30.0 * base + 10.0 * COLUMNS * tile
                self.write(f"isles/{name}{tile}.tif", ground() + base, (west, 10.0, 0.0, 5e6 + 30.0 * base, 0.0, -10.0))
        plotter = pyvista.Plotter(off_screen=True)
        with self.assertWarnsRegex(UserWarning, "3 sites far from each other"):
            first = add_terrain(plotter, self.path("isles"), name="isles")
        terrains = [actor for actor in plotter.renderer.actors.values() if isinstance(actor, type(first))]
        self.assertIs(terrains[0], first)
        bounds = sorted(actor.GetBounds() for actor in terrains)
        expected = [(5e5 + 30.0 * base + 5.0, base + 100.0) for base in lowest.values()]
        np.testing.assert_allclose([(each[0], each[4]) for each in bounds], expected)
        self.assertAlmostEqual(first.GetBounds()[4], 600.0)  # two tiles cover most
        for actor in terrains:
            np.testing.assert_allclose(actor.GetLookupTable().GetRange(), (100.0, 1400.0))
            colors = [np.zeros(3), np.zeros(3)]
            for each, color in zip((actor, first), colors):
                each.GetLookupTable().GetColor(1300.0, color)
            np.testing.assert_allclose(*colors)
        plotter.close()

    def test_a_view_that_would_show_specks_shows_the_largest_site(self):
        import pyvista

        from vtkterrain.plotting import add_terrain

        self.write("far/a.tif", ground())
        self.write("far/b.tif", ground()[:20], (6e5, 10.0, 0.0, 5.9e6, 0.0, -10.0))
        plotter = pyvista.Plotter(off_screen=True)
        with self.assertWarnsRegex(UserWarning, "shows the one that covers most"):
            first = add_terrain(plotter, self.path("far"))
        focus = np.array(plotter.camera.focal_point)
        self.assertLess(np.linalg.norm(focus - np.array(first.center)), 10.0)
        self.assertLess(plotter.camera.distance, 5e3)
        plotter.close()
        plotter = pyvista.Plotter(off_screen=True)
        plotter.camera_position = "xy"
        camera = plotter.camera.position
        add_terrain(plotter, self.path("far"), reset_camera=False)
        self.assertEqual(plotter.camera.position, camera)
        plotter.close()

    def test_one_site_alone(self):
        import pyvista

        from vtkterrain.plotting import add_terrain

        self.write("isles/a.tif", ground())
        self.write("isles/b.tif", ground() + 10.0, (6e5, 10.0, 0.0, 5.1e6, 0.0, -10.0))
        plotter = pyvista.Plotter(off_screen=True)
        actor = add_terrain(plotter, self.path("isles"), part=2)
        self.assertAlmostEqual(actor.GetBounds()[0], 6e5 + 5.0)
        self.assertEqual(sum(isinstance(each, type(actor)) for each in plotter.renderer.actors.values()), 1)
        plotter.close()


class TestRadii(RasterCase):
    def write_radii(self, name, system=MOON):
        path = self.write(name, np.round(ground() * 2.0), (0, 100, 0, 0, 0, -100), system, gdal.GDT_Int16)
        file = gdal.Open(path, gdal.GA_Update)
        file.GetRasterBand(1).SetScale(0.5)
        file.GetRasterBand(1).SetOffset(RADIUS)
        return path

    def test_heights_from_the_centre(self):
        for name, system in (("moon.tif", MOON), ("plain.tif", None)):
            path = self.write_radii(name, system)
            heights, image, warning = self.read(path)
            np.testing.assert_allclose(heights, ground(), atol=0.1)
            self.assertEqual(warning, "")
            reader = vtkTerrainRasterReader()
            reader.SetFileName(path)
            self.assertIn("radii: heights are distances from the centre less 1737400 m", reader.Describe())
            np.testing.assert_allclose(array_from_heights(_intake.lay_out(image))[::-1], ground(), atol=0.1)

    def test_heights_from_the_centre_in_a_folder(self):
        self.write_radii("radii/a.tif")
        heights, _, _ = self.read(self.path("radii"))
        np.testing.assert_allclose(heights, ground(), atol=0.1)

    @unittest.skipIf(importlib.util.find_spec("rioxarray") is None, "rioxarray is not installed")
    def test_heights_from_the_centre_in_an_array(self):
        import rioxarray

        from vtkterrain.xarrays import heights_from_dataarray

        array = heights_from_dataarray(rioxarray.open_rasterio(self.write_radii("moon.tif"))[0])
        np.testing.assert_allclose(array_from_heights(array)[::-1], ground(), atol=0.1)

    def test_a_flattened_body_is_told(self):
        mars = "+proj=eqc +lat_ts=0 +a=3396190 +b=3376200 +units=m"
        path = self.write("mars.tif", ground() + 3396190.0, (0, 100, 0, 0, 0, -100), mars, gdal.GDT_Float64)
        heights, _, warning = self.read(path)
        np.testing.assert_allclose(heights, ground(), atol=1e-3)
        self.assertIn("flattened", warning)


if __name__ == "__main__":
    vtkTerrainTesting.run()
