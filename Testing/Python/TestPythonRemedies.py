# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""What messages tell to do is done as it is told, and works; and what needs no remedy any more: texts of points in any
order and with any names, tiles over one another, rational polynomials. Skipped without GDAL."""
import os
import re
import subprocess

import numpy as np
import vtkTerrainTesting
from vtkTerrainRasters import COLUMNS, ROWS, RasterCase, gdal, ground

from vtkterrain import heights_from_array, vtkTerrainHierarchy

UTM = (5e5, 10.0, 0.0, 5e6, 0.0, -10.0)
EAST = (5e5 + 10.0 * COLUMNS, *UTM[1:])


def points(x=500000.0, y=5000000.0, step=10.0):
    """x, y, z of the ground, row by row."""
    row, column = np.mgrid[0:ROWS, 0:COLUMNS]
    return np.column_stack([(x + step * column).ravel(), (y - step * row).ravel(), ground().ravel()])


class RemedyCase(RasterCase):
    def type(self, told, name):
        """Does what a message tells for a file, in its folder."""
        for command in re.split("; (?=ogr2ogr|gdal)", told):
            tool, words = command.split(" ", 1)
            words = re.sub(r"\bIN\b", name, words)
            if tool == "gdal_translate":
                *options, source, target = words.split(" ")
                gdal.Translate(self.path(target), self.place(source), options=" ".join(options))
            elif tool == "ogr2ogr":
                *options, target, source = words.split(" ")
                opened = gdal.OpenEx(self.path(source), gdal.OF_VECTOR, open_options=options[1::2])  # -oo A -oo B
                gdal.VectorTranslate(self.path(target), opened)
            elif tool == "gdal_grid":
                *options, source, target = words.split(" ")
                gdal.Grid(self.path(target), self.path(source), options=" ".join(options))
            else:
                subprocess.run(f"{tool} {words}", shell=True, check=True, cwd=self.folder)

    def place(self, source):
        """A name for GDAL of a file in the folder."""
        kind, colon, name = source.rpartition(":")
        return kind + colon + self.path(name)

    def text(self, name, rows, header="", separator=" "):
        with open(self.path(name), "w", encoding="ascii") as file:
            file.write(header + "\n" if header else "")
            np.savetxt(file, rows, "%.10g", separator)
        return self.path(name)


class TestTexts(RemedyCase):
    def test_columns_of_any_name_and_order(self):
        x, y, z = points().T
        number = np.arange(x.size)
        for header, columns in {
                "easting,northing,elev": (x, y, z), "id,easting,northing,elev": (number, x, y, z),
                "FID;POINT_X;POINT_Y;GRID_CODE": (number, x, y, z), "elev\tnorth\teast": (z, y, x),
                "Name,X [m],Y [m],Z [m]": (number, x, y, z), "Rechtswert;Hochwert;Hoehe": (x, y, z),
                "z,y,x": (z, y, x), "id,z,x,y": (number, z, x, y)}.items():
            separator = re.search("[,;\t]", header)[0]
            heights, image, told = self.read(self.text("a.csv", np.column_stack(columns), header, separator))
            self.assertNotIn("GDAL", told, header)
            np.testing.assert_allclose(heights, ground(), err_msg=header)
            self.assertEqual(image.GetBounds()[:4], (5e5, 5e5 + 10.0 * (COLUMNS - 1), 5e6 - 10.0 * (ROWS - 1), 5e6))

    def test_degrees_by_name_in_any_order(self):
        x, y, z = points(7.0, 46.0, 0.001).T
        for header, columns in {"lat;lon;z": (y, x, z), "id;lat;lon;elev": (np.arange(x.size), y, x, z),
                                "elevation;longitude;latitude": (z, x, y)}.items():
            heights, image, _ = self.read(self.text("a.csv", np.column_stack(columns), header, ";"))
            np.testing.assert_allclose(heights, ground(), err_msg=header)
            self.assertIn("WGS 84", image.GetFieldData().GetAbstractArray("CRS").GetValue(0))
            np.testing.assert_allclose(image.GetSpacing()[1], 111.15, atol=0.1)

    def test_points_in_any_order_with_gaps_words_and_decimal_commas(self):
        rows = points()
        is_there = np.random.default_rng(7).random(len(rows)) > 0.1
        expected = np.where(is_there.reshape(ROWS, COLUMNS), ground(), np.nan)
        shuffled = np.random.default_rng(8).permutation(rows[is_there])
        np.testing.assert_allclose(self.read(self.text("a.xyz", shuffled))[0], expected)
        with open(self.path("b.csv"), "w", encoding="utf-8-sig") as file:
            file.write("Punkt;Ost;Nord;Hoehe\n")
            for x, y, z in shuffled:
                file.write(f"P {x:.0f};{x:.1f};{y:.1f};{z:.2f}\n".replace(".", ","))
        np.testing.assert_allclose(self.read(self.path("b.csv"))[0], expected)

    def test_rounded_degrees_in_any_order(self):
        step = 1.0 / 3600.0
        rows = points(7.0, 46.0, step)
        shuffled = np.random.default_rng(9).permutation(rows)
        np.savetxt(self.path("a.xyz"), shuffled, "%.5f %.5f %.3f")
        heights, image, _ = self.read(self.path("a.xyz"), CoordinateSystem="EPSG:4326")
        np.testing.assert_allclose(heights, ground())
        np.testing.assert_allclose(image.GetSpacing()[1], 30.87, atol=0.02)

    def test_shuffled_tiles_of_a_folder(self):
        rng = np.random.default_rng(10)
        self.text("tiles/a.csv", rng.permutation(points()), "id_x,id_y,id_z", ",")
        self.text("tiles/b.txt", rng.permutation(points(EAST[0])))
        heights, _, _ = self.read(self.path("tiles"))
        np.testing.assert_allclose(heights, np.hstack([ground(), ground()]))

    def test_several_points_at_one_place_are_told_and_the_remedy_works(self):
        rows = points()
        path = self.text("a.xyz", np.vstack([rows, rows[5:7] + (0.0, 0.0, 50.0)]))
        told = self.read(path)[2]
        self.assertIn("2 of its 2002 points lie where others do", told)
        self.type(re.search(r"\((awk .*) keeps the first\)", told)[1], "a.xyz")
        os.rename(self.path("OUT"), self.path("b.xyz"))
        np.testing.assert_allclose(self.read(self.path("b.xyz"))[0], ground())

    def test_points_on_no_grid_and_the_remedy(self):
        x, y = 1000.0 * np.random.default_rng(11).random((2, 900))
        rows = np.column_stack([x, y, 100.0 + 0.1 * x + 0.05 * y])
        for name, header, separator in (("a.xyz", "", " "), ("b.csv", "x;y;z", ";"), ("c.csv", "x,y,z", ",")):
            told = self.refusal(self.text(name, rows, header, separator))
            self.type(re.search(r"make one of them \((.*)\)", told)[1], name)
            heights, image, _ = self.read(self.path("OUT.tif"))
            x0, x1, y0, y1 = image.GetBounds()[:4]
            places = np.meshgrid(np.linspace(x0, x1, heights.shape[1]), np.linspace(y1, y0, heights.shape[0]))
            np.testing.assert_allclose(heights[100:150, 100:150],
                                       (100.0 + 0.1 * places[0] + 0.05 * places[1])[100:150, 100:150], atol=0.5)
            for made in filter(lambda each: each.startswith("P."), os.listdir(self.folder)):
                os.remove(self.path(made))

    def test_columns_that_names_do_not_tell(self):
        rows = np.column_stack([np.arange(ROWS * COLUMNS), points()])
        told = self.refusal(self.text("a.csv", rows, "a,b,c,d", ","))
        self.assertIn("the columns a, b, c, d are places and heights: call them x, y and z", told)
        np.testing.assert_allclose(self.read(self.text("a.csv", rows, "a,x,y,z", ","))[0], ground())

    def test_exchanged_columns_of_degrees(self):
        rows = points(120.0, 24.0, 0.001)[:, [1, 0, 2]]
        for name, header, separator in (("a.xyz", "", " "), ("b.csv", "lon,lat,z", ","), ("c.csv", "lon;lat;z", ";")):
            told = self.refusal(self.text(name, rows, header, separator), CoordinateSystem="EPSG:4326")
            self.type(re.search(r"are exchanged, (.*) puts", told)[1], name)
            heights, image, _ = self.read(self.path("OUT.csv"))
            np.testing.assert_allclose(heights, ground())
            np.testing.assert_allclose(image.GetFieldData().GetArray("LayoutOrigin").GetTuple(0),
                                       (120.0 + 0.0005 * (COLUMNS - 1), 24.0 - 0.0005 * (ROWS - 1)), atol=1e-9)


class TestPlaces(RemedyCase):
    def test_degrees_in_a_crs_of_metres(self):
        place = (7.0, 0.001, 0.0, 46.0, 0.0, -0.001)
        for system in ("EPSG:32632", "EPSG:2056", "EPSG:3857"):
            path = self.write("a.tif", ground(), place, system)
            told = self.read(path)[2]
            self.assertIn("looks like degrees (--crs EPSG:4326 for longitude", told)
            self.assertNotIn("three times", told)
            _, image, told = self.read(path, CoordinateSystem="EPSG:4326")
            self.assertEqual(told, "")
            np.testing.assert_allclose(image.GetSpacing()[1], 111.15, atol=0.1)

    def test_metres_near_the_origin_are_no_degrees(self):
        path = self.write("a.tif", 0.01 * ground(), (5.0, 0.1, 0.0, 20.0, 0.0, -0.1),
                          "+proj=tmerc +lat_0=46 +lon_0=7 +datum=WGS84 +units=m")
        self.assertEqual(self.read(path)[2], "")

    def test_exchanged_longitude_and_latitude(self):
        self.write("a.tif", ground(), (24.0, 0.001, 0.0, 120.0, 0.0, -0.001), "EPSG:4326")
        told = self.refusal(self.path("a.tif"))
        self.type(re.search(r"(gdal_translate -a_ullr .*) puts", told)[1], "a.tif")
        heights, image, told = self.read(self.path("OUT.tif"))
        np.testing.assert_allclose(heights, ground())
        self.assertEqual(told, "")
        transform = image.GetFieldData().GetArray("GeoTransform")
        np.testing.assert_allclose([transform.GetValue(k) for k in (0, 3)], (120.0, 24.0))
        # within 90 degrees the area that a CRS is for tells
        told = self.read(self.write("b.tif", ground(), (46.0, 0.001, 0.0, 7.0, 0.0, -0.001), "EPSG:4258"))[2]
        self.type(re.search(r"(gdal_translate -a_ullr .*) puts", told)[1], "b.tif")
        self.assertEqual(self.read(self.path("OUT.tif"))[2], "")
        self.assertEqual(self.read(self.write("c.tif", ground(), (46.0, 0.001, 0.0, 7.0, 0.0, -0.001), "EPSG:4326"))[2],
                         "")

    def test_complex_samples(self):
        memory = gdal.GetDriverByName("GTiff").Create(self.path("a.tif"), COLUMNS, ROWS, 1, gdal.GDT_CFloat32)
        memory.SetGeoTransform(UTM)
        memory.GetRasterBand(1).WriteArray(ground() + 3j)
        memory = None
        told = self.refusal(self.path("a.tif"))
        self.type(re.search(r"\((gdal_translate .*)\)", told)[1], "a.tif")
        np.testing.assert_allclose(self.read(self.path("OUT.tif"))[0], ground())

    def write_polynomials(self, name):
        """Rows run north, columns east; what is higher is seen farther west."""
        row, column = np.mgrid[0:ROWS, 0:COLUMNS]
        self.write(name, 100.0 + 2.0 * column + row, (0.0, 1.0, 0.0, 0.0, 0.0, 1.0), None)
        with open(self.path(name[:-4] + "_RPC.TXT"), "w") as file:
            for word, value in {"LINE_OFF": 20, "SAMP_OFF": 25, "LAT_OFF": 50, "LONG_OFF": 10, "HEIGHT_OFF": 0,
                                "LINE_SCALE": 20, "SAMP_SCALE": 25, "LAT_SCALE": 0.1, "LONG_SCALE": 0.1,
                                "HEIGHT_SCALE": 500}.items():
                file.write(f"{word}: {value}\n")
            for word, places in {"LINE_NUM": {2: 1.0}, "LINE_DEN": {0: 1.0}, "SAMP_NUM": {1: 1.0, 3: 0.2},
                                 "SAMP_DEN": {0: 1.0}}.items():
                for k in range(20):
                    file.write(f"{word}_COEFF_{k + 1}: {places.get(k, 0.0)}\n")
        return self.path(name)

    def test_rational_polynomials_place_each_sample_at_its_height(self):
        heights, image, told = self.read(self.write_polynomials("rpc.tif"))
        self.assertIn("gdalwarp -rpc", told)
        scale, origin = (image.GetFieldData().GetArray(name).GetTuple(0) for name in ("LayoutScale", "LayoutOrigin"))
        j, i = np.mgrid[0:heights.shape[0], 0:heights.shape[1]]
        x = origin[0] + (image.GetOrigin()[0] + i * image.GetSpacing()[0]) / scale[0]
        y = origin[1] + (image.GetOrigin()[1] + (heights.shape[0] - 1 - j) * image.GetSpacing()[1]) / scale[1]
        # column = 25 + 25 (longitude + 0.2 height), height = 100 + 2 column + row, normalized
        expected = (170.0 + 50.0 * (x - 10.0) / 0.1 + 20.0 * (y - 50.0) / 0.1) / (1.0 - 2.0 * 25.0 * 0.2 / 500.0)
        is_known = np.isfinite(heights)
        self.assertGreater(is_known.sum(), 1500)
        np.testing.assert_allclose(heights[is_known], expected[is_known], atol=0.05)
        # GDAL's warper lays all at one height
        gdal.Warp(self.path("out.tif"), self.path("rpc.tif"), options="-rpc -to RPC_HEIGHT=150 -dstnodata -9999")
        warped, at_one, _ = self.read(self.path("out.tif"))
        self.assertAlmostEqual(np.nanmax(warped), np.nanmax(heights), delta=5.0)


class TestOverlaps(RemedyCase):
    def copy(self, name, heights, transform=UTM, **words):
        return self.write(name, heights, transform, **words)

    def test_two_heights_of_one_place_are_told_and_the_remedy_works(self):
        self.copy("land/dtm.tif", ground())
        self.copy("land/dsm_new.tif", ground() + np.where(ground() > 180.0, 12.5, 0.0))
        self.copy("land/east.tif", ground(), EAST)
        heights, _, told = self.read(self.path("land"))
        np.testing.assert_allclose(heights[:, :COLUMNS], ground())
        for text in ("dsm_new.tif and dtm.tif", "up to 12.5 m", "dtm.tif is on top, as the last by name"):
            self.assertIn(text, told)
        self.assertEqual(told.count("overlap"), 1)
        other = re.search(r"name (\S+) alone", told)[1]
        np.testing.assert_allclose(self.read(other)[0].max(), 412.5)
        os.remove(self.path("land/dsm_new.tif"))
        self.assertNotIn("overlap", self.read(self.path("land"))[2])

    def test_tiles_that_agree_are_not_told(self):
        whole = 200.0 + np.add.outer(-0.5 * np.arange(60), 0.7 * np.arange(120))
        self.copy("same/a.tif", whole[:, :70])
        self.copy("same/b.tif", whole[:, 50:], (UTM[0] + 500.0, *UTM[1:]))  # a border of 20
        self.copy("same/c.tif", np.round(whole[:, :70]), kind=gdal.GDT_Int16)
        self.copy("same/d.tif", whole[:, :70] / 0.3048, unit="ft")
        holes = whole[:, :70].copy()
        holes[20:30, 20:30] = -9999.0
        self.copy("same/e.tif", holes, nodata=-9999.0)
        self.copy("same/f.tif", whole[:, :70] + 0.1, (UTM[0] + 2.0, *UTM[1:]))  # off the grid
        self.assertNotIn("overlap", self.read(self.path("same"))[2])
        self.copy("same/g.tif", whole[:, :70] + 5.0, (UTM[0] + 2.0, *UTM[1:]))
        self.assertIn("g.tif is on top", self.read(self.path("same"))[2])

    def test_borders_that_differ_in_most_of_their_samples_are_told(self):
        whole = 200.0 + np.add.outer(-0.5 * np.arange(60), 0.7 * np.arange(120))
        self.copy("step/a.tif", whole[:, :70])
        east = whole[:, 60:].copy()
        east[:3] += 20.0
        self.copy("step/b.tif", east, (UTM[0] + 600.0, *UTM[1:]))
        self.assertNotIn("overlap", self.read(self.path("step"))[2])
        self.copy("step/b.tif", whole[:, 60:] + 20.0, (UTM[0] + 600.0, *UTM[1:]))
        told = self.read(self.path("step"))[2]
        self.assertIn("differ there by up to 20 m (in 100 %", told)
        self.assertIn("gdal_calc.py -A b.tif --calc='A-(20)'", told)

    def test_finer_heights_over_coarser_ones_are_not_told(self):
        self.copy("fine/a.tif", ground())
        self.copy("fine/b.tif", ground()[:10, :10] + 50.0, (UTM[0], 5.0, 0.0, UTM[3], 0.0, -5.0))
        self.assertNotIn("overlap", self.read(self.path("fine"))[2])

    def test_what_the_band_says_to_be_no_height_is_left_out(self):
        for name, description, unit in (("a", "slope", None), ("b", "", "degrees"), ("c", "Aspect (deg)", None),
                                        ("d", "", "%")):
            self.copy(f"{name}/dem.tif", ground())
            file = gdal.Open(self.copy(f"{name}/z.tif", 0.1 * ground(), unit=unit), gdal.GA_Update)
            file.GetRasterBand(1).SetDescription(description)
            file = None
            heights, _, told = self.read(self.path(name))
            np.testing.assert_allclose(heights, ground(), err_msg=name)
            self.assertIn("z.tif (open one alone", told)
            np.testing.assert_allclose(self.read(self.path(f"{name}/z.tif"))[0], 0.1 * ground(), rtol=1e-6)

    def test_a_prepared_file_among_tiles_is_left_out(self):
        self.copy("made/a.tif", ground())
        self.copy("made/b.tif", ground(), EAST)
        hierarchy = vtkTerrainHierarchy()
        hierarchy.SetHeights(heights_from_array(ground(), spacing=(10.0, 10.0), first_row="north"))
        self.assertTrue(hierarchy.WriteFile(self.path("made/all.tif")))
        heights, _, told = self.read(self.path("made"))
        np.testing.assert_allclose(heights, np.hstack([ground(), ground()]))
        self.assertIn("all.tif is a file of terrain-prepare (name it alone", told)
        np.testing.assert_allclose(self.read(self.path("made/all.tif"))[0], ground())


if __name__ == "__main__":
    vtkTerrainTesting.run()
