# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of the kinds that people bring, each written here: heights, places and holes. Skipped without GDAL."""
import os

import numpy as np
import vtkTerrainTesting
from vtkTerrainRasters import COLUMNS, ROWS, RasterCase, gdal, ground

from vtkterrain import array_from_heights, heights_from_array, vtkTerrainRasterReader


class TestIntake(RasterCase):
    def test_units_by_name_and_by_number(self):
        for unit, metres in (("fathom", 1.8288), ("US feet", 1200 / 3937), ("Feet (US)", 1200 / 3937), ("yd", 0.9144),
                             ("mm", 1e-3), ("international feet", 0.3048)):
            heights, _, warning = self.read(self.write(f"{unit[:4]}.tif", ground(), unit=unit))
            np.testing.assert_allclose(heights, metres * ground(), rtol=1e-6, err_msg=unit)
        irish = self.write("irish.tif", ground(), (3e5, 30, 0, 2.5e5, 0, -30), "EPSG:29903+5754")
        heights, _, warning = self.read(irish)
        np.testing.assert_allclose(heights, 0.3048007491 * ground(), rtol=1e-6)
        self.assertEqual(warning, "")

    def test_feet_that_nobody_names_are_guessed_and_told(self):
        path = self.write("feet.tif", ground(), (985000.0, 30.0, 0.0, 210000.0, 0.0, -30.0), "EPSG:2263")
        heights, _, warning = self.read(path)
        np.testing.assert_allclose(heights, 1200 / 3937 * ground(), rtol=1e-6)
        self.assertIn("--height-unit m", warning)
        np.testing.assert_allclose(self.read(path, HeightUnit="m")[0], ground())

    def test_depths_are_turned(self):
        for path in (self.write("depth.tif", ground(), system="EPSG:32631+5715"),
                     self.netcdf("depth.nc", ground()[::-1], 20 + 0.01 * np.arange(ROWS),
                                 10 + 0.01 * np.arange(COLUMNS), positive="down", units="m")):
            np.testing.assert_allclose(self.read(path)[0], -ground())
            np.testing.assert_allclose(self.read(path, HeightUnit="1")[0], ground())

    def test_degrees_without_grid_mapping_and_turned_dimensions(self):
        y, x = 20 + 0.5 * np.arange(ROWS), 10 + 0.5 * np.arange(COLUMNS)
        plain = self.read(self.netcdf("plain.nc", ground()[::-1], y, x))
        turned = self.read(self.netcdf("turned.nc", ground()[::-1].T, y, x, order=("lon", "lat")))
        for heights, image, _ in (plain, turned):
            np.testing.assert_allclose(heights, ground())
            self.assertGreater(image.GetSpacing()[0], 40000.0)
            self.assertGreater(image.GetSpacing()[1], 55000.0)

    def test_uneven_latitudes_are_where_they_are(self):
        y = np.degrees(2 * np.arctan(np.exp(np.radians(50 + np.arange(300) / 10))) - np.pi / 2)
        mercator = self.netcdf("mercator.nc", np.repeat(y[:, None] * 100, 20, 1), y, np.arange(20) * 0.1)
        heights, image, _ = self.read(mercator)
        expected = np.linspace(y[-1], y[0], heights.shape[0]) * 100
        np.testing.assert_allclose(heights[:, 7], expected, atol=1e-6)

    def test_undeclared_fill_is_none_and_plausible_heights_stay(self):
        holes = np.zeros((ROWS, COLUMNS), bool)
        holes[30:, 20:30] = True
        kinds = [(fill, gdal.GDT_Float32) for fill in (1e20, 1e6, -999.0, -10000.0, -99999.0, -9999.0)]
        for fill, kind in kinds + [(32767, gdal.GDT_Int16), (65535, gdal.GDT_UInt16)]:
            heights, _, warning = self.read(self.write("fill.tif", np.where(holes, fill, ground()), kind=kind))
            np.testing.assert_array_equal(np.isnan(heights), holes, err_msg=str(fill))
            self.assertIn("--nodata none", warning)
        sea = ground() * -20.0  # from -2000 to -8000 and on: -9999 is a depth there
        sea[holes] = -9999.0
        sea[20:30] = np.linspace(-8100.0, -9990.0, 10)[:, None]
        self.assertEqual(np.isnan(self.read(self.write("sea.tif", sea))[0]).sum(), 0)
        array = np.where(holes, -32768, ground()).astype(np.int16)
        np.testing.assert_array_equal(np.isnan(array_from_heights(heights_from_array(array))), holes)

    def test_folders_honour_each_tile(self):
        z = ground()
        self.write("units/metres.tif", z[:, :25])
        self.write("units/deeper/feet.tif", z[:, 25:] / 0.3048, (500250.0, 10.0, 0.0, 5e6, 0.0, -10.0), unit="ft")
        self.write("units/metres_hillshade.tif", z % 255, kind=gdal.GDT_Byte)
        heights, _, warning = self.read(self.path("units"))
        np.testing.assert_allclose(heights, z, rtol=1e-6)
        self.assertIn("hillshade", warning)

    def test_the_date_line_is_joined(self):
        z, step = ground(), 0.01
        self.write("fiji/west.tif", z[:, :25], (179.75, step, 0.0, -16.5, 0.0, -step), "EPSG:4326")
        self.write("fiji/east.tif", z[:, 25:], (-180.0, step, 0.0, -16.5, 0.0, -step), "EPSG:4326")
        heights, _, _ = self.read(self.path("fiji"))
        np.testing.assert_allclose(heights, z)

    def test_axes_that_point_west_and_south(self):
        source = self.write("source.tif", ground(), (18.42, 0.001, 0.0, -33.92, 0.0, -0.001), "EPSG:4326")
        krovak = self.write("source2.tif", ground(), (14.42, 0.001, 0.0, 50.08, 0.0, -0.001), "EPSG:4326")
        for path, system in ((source, "EPSG:2048"), (krovak, "EPSG:5513")):
            gdal.Warp(self.path("turned.tif"), path, dstSRS=system, dstNodata=-9999)
            heights, image, _ = self.read(self.path("turned.tif"))
            row, column = np.argwhere(heights == 400.0).mean(0)
            self.assertLess(row, 0.3 * heights.shape[0])
            self.assertLess(column, 0.3 * heights.shape[1])
            self.assertLess(image.GetBounds()[1], 0.0)

    def test_masks_without_flags(self):
        z = ground().astype("i2")
        z[20, :5] = -32768, -32767, -32766, -32765, -32764
        moon = "+proj=eqc +lat_ts=0 +R=1737400 +units=m"
        path = self.write("special.cub", z, (0, 100, 0, 0, 0, -100), moon, gdal.GDT_Int16, driver="ISIS3")
        self.assertEqual(np.isnan(self.read(path)[0]).sum(), 5)

    def test_sites_of_a_folder(self):
        z, step = ground(), 0.0003
        self.write("sites/a.tif", z[:20], (-97.0, step, 0.0, 30.0, 0.0, -step), "EPSG:4326")
        self.write("sites/b.tif", z + 5.0, (-81.0, step, 0.0, 27.0, 0.0, -step), "EPSG:4326")
        self.write("sites/c.tif", z, (-81.0 + COLUMNS * step, step, 0.0, 27.0, 0.0, -step), "EPSG:4326")
        # a raster round all of them would have more than 4 million samples
        heights, _, warning = self.read(self.path("sites"))
        self.assertIn("--part N", warning)
        np.testing.assert_allclose(heights, np.hstack([z + 5.0, z]))
        heights, _, warning = self.read(self.path("sites"), Part="1")
        self.assertNotIn("--part", warning)
        np.testing.assert_allclose(heights, z[:20])
        reader = vtkTerrainRasterReader()
        reader.SetFileName(self.path("sites"))
        reader.SetPart("3")
        reader.Update()
        self.assertIn("sites are 1 to 2", reader.GetErrorMessage())

    def test_sidecars_stand_for_their_data(self):
        path = self.write("data.bil", ground(), driver="EHdr")
        for name in ("data.hdr", "data.prj", "data.bil.aux.xml"):
            if os.path.exists(self.path(name)):
                np.testing.assert_allclose(self.read(self.path(name))[0], ground(), err_msg=name)
        self.assertTrue(os.path.exists(path))

    def test_texts_by_the_names_of_their_columns(self):
        row, column = np.mgrid[0:ROWS, 0:COLUMNS]
        lines = {"x": 5e5 + 10.0 * column, "y": 5e6 - 10.0 * row, "z": ground(), "id": row * COLUMNS + column}
        for names in ("x,y,z", "id,x,y,z", "y,x,z", "easting,northing,height", "northing,easting,height",
                      "id,x,y,masl", "id,northing,easting,elevation", "h,n,e"):
            keys = [{"e": "x", "n": "y", "h": "z", "m": "z"}.get(name[0], name) for name in names.split(",")]
            keys = ["z" if name == "elevation" else key for name, key in zip(names.split(","), keys)]
            with open(self.path("points.csv"), "w", encoding="ascii") as file:
                file.write(names + "\n")
                np.savetxt(file, np.column_stack([lines[key].ravel() for key in keys]), "%.10g", ",")
            heights, image, _ = self.read(self.path("points.csv"))
            np.testing.assert_allclose(heights, ground(), err_msg=names)
            self.assertEqual(image.GetBounds()[:2], (5e5, 5e5 + 10.0 * (COLUMNS - 1)), names)

    def test_flip_and_describe(self):
        path = self.write("flip.tif", ground())
        heights, image, _ = self.read(path, Flip=True)
        np.testing.assert_allclose(heights, ground()[::-1])
        self.assertEqual(image.GetBounds(), self.read(path)[1].GetBounds())
        reader = vtkTerrainRasterReader()
        reader.SetFileName(path)
        self.assertIn("CRS: WGS 84 / UTM zone 31N (file)", reader.Describe())


if __name__ == "__main__":
    vtkTerrainTesting.run()
