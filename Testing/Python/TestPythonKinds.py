# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kinds of files whose heights GDAL alone gives otherwise than they are meant: ranges of valid values, alpha bands of
floats, halves, units of coordinates, arrays in groups, archives in archives, places beside the samples, lost signs,
bands by name. By name, in a folder beside a second tile, and as a DataArray. Skipped without GDAL."""
import importlib.util
import os
import re
import subprocess
import unittest
import zipfile

import numpy as np
import vtkTerrainTesting
from vtkTerrainRasters import COLUMNS, ROWS, RasterCase, gdal, ground, osr

from vtkterrain import array_from_heights, heights_from_array

UTM = (5e5, 10.0, 0.0, 5e6, 0.0, -10.0)
DEGREES = (10.0, 0.01, 0.0, 50.0, 0.0, -0.01)
HOLE = (slice(20, 24), slice(30, 35))


def holed():
    heights = ground()
    heights[HOLE] = np.nan
    return heights


def number(kind=None):
    return gdal.ExtendedDataType.Create(gdal.GDT_Float64 if kind is None else kind)


class TestKinds(RasterCase):
    def check(self, path, truth, place=UTM, tolerance=1e-3, **options):
        """Heights, holes and place of a file; what it warns of."""
        heights, image, warning = self.read(path, **options)
        np.testing.assert_allclose(heights, truth, atol=tolerance, err_msg=path)
        if place is not None:
            transform = image.GetFieldData().GetArray("GeoTransform")
            got = [transform.GetValue(k) for k in range(6)]
            step = abs(place[1])
            np.testing.assert_allclose(np.array(got) / step, np.array(place) / step, atol=1e-3, err_msg=path)
        return warning

    def check_tile(self, name, truth):
        """A tile is in a folder what it is alone, beside one east of it."""
        self.write(os.path.join(os.path.dirname(name), "zz_east.tif"), np.full((ROWS, 8), 7.0),
                   (UTM[0] + COLUMNS * UTM[1], *UTM[1:]))
        heights, _, warning = self.read(os.path.dirname(self.path(name)))
        np.testing.assert_allclose(heights[:, :COLUMNS], truth, atol=1e-3, err_msg=name)
        np.testing.assert_allclose(heights[:, COLUMNS:], 7.0)
        return warning

    def arrays(self, name, heights, y, x, units=("degrees_north", "degrees_east"), group=None, driver="netCDF",
               crs=None, **attributes):
        """A file of arrays y, x and elevation."""
        text = gdal.ExtendedDataType.CreateString()
        file = gdal.GetDriverByName(driver).CreateMultiDimensional(self.path(name))
        root = file.GetRootGroup()
        parent = root.CreateGroup(group) if group else root
        axes = []
        for label, values, unit in zip("yx", (y, x), units):
            axes.append(parent.CreateDimension(label, None, None, len(values)))
            axis = parent.CreateMDArray(label, [axes[-1]], number())
            axis.CreateAttribute("units", [], text).Write(unit)
            axis.Write(np.ascontiguousarray(values, dtype=np.float64))
        z = parent.CreateMDArray("elevation", axes, number())
        z.Write(np.ascontiguousarray(heights, dtype=np.float64))
        for key, value in attributes.items():
            if isinstance(value, str):
                z.CreateAttribute(key, [], text).Write(value)
            else:
                z.CreateAttribute(key, [np.size(value)] if np.size(value) > 1 else [], number()).Write(value)
        if crs:
            mapping = root.CreateMDArray("crs", [], number(gdal.GDT_Int32))
            mapping.CreateAttribute("crs_wkt", [], text).Write(crs)
            mapping.CreateAttribute("grid_mapping_name", [], text).Write("transverse_mercator")
            z.CreateAttribute("grid_mapping", [], text).Write("crs")
        return self.path(name)

    def test_values_beyond_the_valid_range_are_none(self):
        y, x = 49.995 - 0.01 * np.arange(ROWS), 10.005 + 0.01 * np.arange(COLUMNS)
        heights = np.where(np.isnan(holed()), 12345.0, ground())
        for name, words in {"range.nc": {"valid_range": [-500.0, 9000.0]},
                            "ends.nc": {"valid_min": -500.0, "valid_max": 9000.0},
                            "most.nc": {"valid_max": 9000.0}}.items():
            self.check(self.arrays(name, heights, y, x, **words), holed(), DEGREES)

    def test_a_valid_range_of_other_numbers_is_told_and_not_used(self):
        y, x = 49.995 - 0.01 * np.arange(ROWS), 10.005 + 0.01 * np.arange(COLUMNS)
        path = self.arrays("wrong.nc", ground(), y, x, valid_range=[-1.0, 1.0])
        self.assertIn("valid values are -1 to 1", self.check(path, ground(), DEGREES))

    @unittest.skipIf(importlib.util.find_spec("xarray") is None, "xarray is not installed")
    def test_a_valid_range_of_a_dataarray(self):
        import xarray

        from vtkterrain.xarrays import heights_from_dataarray

        heights = np.where(np.isnan(holed()), 12345.0, ground())
        for words in ({"valid_range": [-500.0, 9000.0]}, {"valid_min": -500.0, "valid_max": 9000.0}):
            data = xarray.DataArray(heights, dims=("y", "x"), attrs=words, coords={
                "y": UTM[3] - 10.0 * (np.arange(ROWS) + 0.5), "x": UTM[0] + 10.0 * (np.arange(COLUMNS) + 0.5)})
            image = heights_from_dataarray(data, crs="EPSG:32631")
            np.testing.assert_allclose(array_from_heights(image)[::-1], holed())

    def test_missing_values_beside_the_fill_value(self):
        y, x = 49.995 - 0.01 * np.arange(ROWS), 10.005 + 0.01 * np.arange(COLUMNS)
        heights = np.where(np.isnan(holed()), -500.0, ground())
        self.check(self.arrays("one.nc", heights, y, x, missing_value=-500.0), holed(), DEGREES)
        heights[HOLE][::2] = -600.0
        self.check(self.arrays("two.nc", heights, y, x, missing_value=[-500.0, -600.0]), holed(), DEGREES)

    def test_one_value_far_from_all_others_is_told(self):
        holes = ground()
        holes[5:15, 5:25] = np.nan
        heights = np.where(np.isnan(holes), -9999 * 0.3048, ground())
        path = self.write("feet.tif", heights)
        words = self.check(path, np.float32(heights))
        self.assertIn("below all others by more than these span", words)
        given = float(words.split("--nodata ")[1].split(" ")[0])
        self.check(path, holes, NoDataValue=given, UseNoDataValue=True)
        with self.assertWarnsRegex(UserWarning, "below all others by more than these span"):
            heights_from_array(np.float32(heights), spacing=(10.0, 10.0))

    @unittest.skipIf(importlib.util.find_spec("xarray") is None, "xarray is not installed")
    def test_kilometres_of_a_dataarray(self):
        import xarray

        from vtkterrain.xarrays import heights_from_dataarray

        kilometres = {"units": "km"}
        data = xarray.DataArray(np.float32(ground()), dims=("y", "x"), coords={
            "y": ("y", (UTM[3] - 10.0 * (np.arange(ROWS) + 0.5)) / 1e3, kilometres),
            "x": ("x", (UTM[0] + 10.0 * (np.arange(COLUMNS) + 0.5)) / 1e3, kilometres)})
        for crs in (None, "EPSG:32631"):
            image = heights_from_dataarray(data, crs=crs)
            np.testing.assert_allclose(image.GetSpacing()[:2], 10.0, rtol=1e-6)
            np.testing.assert_allclose(array_from_heights(image)[::-1], np.float32(ground()))

    def write_with_alpha(self, name):
        file = gdal.GetDriverByName("GTiff").Create(self.path(name), COLUMNS, ROWS, 2, gdal.GDT_Float32,
                                                    options=["ALPHA=YES"])
        file.SetGeoTransform(UTM)
        file.SetProjection(osr.GetUserInputAsWKT("EPSG:32631"))
        file.GetRasterBand(1).WriteArray(np.nan_to_num(holed()))
        file.GetRasterBand(2).WriteArray(np.where(np.isnan(holed()), 0.0, 255.0))
        file.GetRasterBand(2).SetColorInterpretation(gdal.GCI_AlphaBand)
        return self.path(name)

    def test_an_alpha_band_of_floats(self):
        self.check(self.write_with_alpha("alpha.tif"), holed())
        self.write_with_alpha("alpha/a.tif")
        self.check_tile("alpha/a.tif", holed())

    def test_nodata_of_halves(self):
        memory = gdal.GetDriverByName("MEM").Create("", COLUMNS, ROWS, 1, gdal.GDT_Float32)
        memory.SetGeoTransform(UTM)
        memory.GetRasterBand(1).WriteArray(np.nan_to_num(holed(), nan=-9999.0))
        memory.GetRasterBand(1).SetNoDataValue(-9999.0)
        gdal.GetDriverByName("GTiff").CreateCopy(self.path("half.tif"), memory, options=["NBITS=16"])
        self.check(self.path("half.tif"), holed(), tolerance=0.3)
        os.makedirs(self.path("half"))
        os.rename(self.path("half.tif"), self.path("half/a.tif"))
        self.write("half/b.tif", ground(), (UTM[0] + 10.0 * COLUMNS, *UTM[1:]), None)
        heights = self.read(self.path("half"))[0]
        np.testing.assert_allclose(heights[:, :COLUMNS], holed(), atol=0.3)

    def test_kilometres_in_a_crs_of_metres(self):
        y, x = (UTM[3] - 10.0 * (np.arange(ROWS) + 0.5)) / 1e3, (UTM[0] + 10.0 * (np.arange(COLUMNS) + 0.5)) / 1e3
        system = osr.GetUserInputAsWKT("EPSG:32631")
        path = self.arrays("km/a.nc", ground(), y, x, units=("km", "km"), crs=system)
        self.assertIn("taken as the coordinates say", self.check(path, ground()))
        self.check_tile("km/a.nc", ground())

    def test_arrays_in_a_group_of_zarr(self):
        y, x = 49.995 - 0.01 * np.arange(ROWS), 10.005 + 0.01 * np.arange(COLUMNS)
        path = self.arrays("a.zarr", ground(), y, x, driver="Zarr", group="land")
        self.check(path, ground(), DEGREES)
        with zipfile.ZipFile(self.path("a.zarr.zip"), "w") as archive:
            for folder, _, names in os.walk(path):
                for name in names:
                    whole = os.path.join(folder, name)
                    archive.write(whole, os.path.relpath(whole, self.folder))
        self.check(self.path("a.zarr.zip"), ground(), DEGREES)

    def test_an_archive_in_an_archive(self):
        self.write("a.tif", ground())
        for outer, inner in (("in.zip", "a.tif"), ("out.zip", "in.zip")):
            with zipfile.ZipFile(self.path(outer), "w") as archive:
                archive.write(self.path(inner), inner)
        self.check(self.path("out.zip"), ground())

    def test_a_lost_sign_is_told(self):
        self.write("lost.tif", (ground() - 150.0).astype("i2").view("u2"), kind=gdal.GDT_UInt16)
        warning = self.read(self.path("lost.tif"))[2]
        self.assertIn("without a sign", warning)
        self.assertIn("PIXELTYPE SIGNEDINT", warning)
        self.write("kept.tif", ground(), kind=gdal.GDT_UInt16, nodata=65535)
        self.assertNotIn("without a sign", self.read(self.path("kept.tif"))[2])

    def write_points(self, name, shift=0.0):
        memory = gdal.GetDriverByName("MEM").Create("", COLUMNS, ROWS, 1, gdal.GDT_Float32)
        memory.GetRasterBand(1).WriteArray(ground())
        points = [gdal.GCP(UTM[0] + 10.0 * c, UTM[3] - 10.0 * r + shift * r * c, 0.0, c, r)
                  for r in range(0, ROWS + 1, 8) for c in range(0, COLUMNS + 1, 10)]
        memory.SetGCPs(points, osr.GetUserInputAsWKT("EPSG:32631"))
        gdal.GetDriverByName("GTiff").CreateCopy(self.path(name), memory)
        return self.path(name)

    def test_ground_control_points(self):
        self.check(self.write_points("points/a.tif"), ground())
        self.check_tile("points/a.tif", ground())

    def test_points_that_no_affine_transform_fits(self):
        path = self.write_points("bent/a.tif", 0.02)
        heights, image, warning = self.read(path)
        self.assertIn("thin plate spline", warning)
        # where a sample lies by the formula of the points, off the block and the border
        scale, shift = (image.GetFieldData().GetArray(name).GetTuple(0) for name in ("LayoutScale", "LayoutOrigin"))
        j, i = np.mgrid[0:heights.shape[0], 0:heights.shape[1]]
        x = shift[0] + (image.GetOrigin()[0] + i * image.GetSpacing()[0]) / scale[0]
        y = shift[1] + (image.GetOrigin()[1] + (heights.shape[0] - 1 - j) * image.GetSpacing()[1]) / scale[1]
        column = (x - UTM[0]) / 10.0
        row = (UTM[3] - y) / (10.0 - 0.02 * column)
        is_plain = ((row > 1.5) & (row < ROWS - 1.5) & (column > 1.5) & (column < COLUMNS - 1.5)
                    & ((row > 10.0) | (column > 10.0)))
        self.assertGreater(is_plain.sum(), 1000)
        np.testing.assert_allclose(heights[is_plain], (100.0 + 2.0 * (column - 0.5) + row - 0.5)[is_plain], atol=0.2)
        # and in a folder
        self.write("bent/b.tif", np.full((8, 8), 7.0), (UTM[0] + 2000.0, *UTM[1:]))
        both = self.read(self.path("bent"))[0]
        self.assertAlmostEqual(np.nanmax(both[:, :COLUMNS]), np.nanmax(heights), delta=5.0)

    def test_what_is_told_of_points_and_polynomials_works(self):
        path = self.write_points("bent.tif", 0.02)
        for told in (self.read(path)[2], self.rational()):
            options = re.search(r"gdalwarp (.*?) IN OUT.tif", told)[1]
            out = self.path("out.tif")
            gdal.Warp(out, self.path("rpc.tif") if "rpc" in options else path, options=options)
            heights, _, warning = self.read(out)
            self.assertGreater(np.isfinite(heights).sum(), 1000)
            self.assertNotIn("gdalwarp", warning)

    def rational(self):
        """What is told of a raster that is placed by rational polynomials."""
        self.write("rpc.tif", ground(), (0.0, 1.0, 0.0, 0.0, 0.0, 1.0), None)
        with open(self.path("rpc_RPC.TXT"), "w") as file:
            for word, value in {"LINE_OFF": 20, "SAMP_OFF": 25, "LAT_OFF": 50, "LONG_OFF": 10, "HEIGHT_OFF": 0,
                                "LINE_SCALE": 20, "SAMP_SCALE": 25, "LAT_SCALE": 0.1, "LONG_SCALE": 0.1,
                                "HEIGHT_SCALE": 500}.items():
                file.write(f"{word}: {value}\n")
            for word, place in {"LINE_NUM": 2, "LINE_DEN": 0, "SAMP_NUM": 1, "SAMP_DEN": 0}.items():
                for k in range(20):
                    file.write(f"{word}_COEFF_{k + 1}: {1 if k == place else 0}\n")
        return self.read(self.path("rpc.tif"))[2]

    def test_a_crs_beside_the_file(self):
        for name in ("beside/a.tif", "text/a.xyz"):
            if name.endswith("tif"):
                self.write(name, ground(), UTM, None)
            else:
                self.write(name, ground(), UTM, None, driver="XYZ")
            with open(self.path(name[:-3] + "prj"), "w") as file:
                reference = osr.SpatialReference()
                reference.ImportFromEPSG(32631)
                reference.MorphToESRI()
                file.write(reference.ExportToWkt())
            _, image, _ = self.read(self.path(name))
            self.assertIn("UTM", image.GetFieldData().GetAbstractArray("CRS").GetValue(0))
            self.check_tile(name, ground())

    def test_nan_in_a_grid_of_whole_numbers(self):
        def text(value):
            return "nan" if np.isnan(value) else f"{value:g}"

        os.makedirs(self.path("nan"))
        with open(self.path("nan/a.asc"), "w") as file:
            file.write(f"ncols {COLUMNS}\nnrows {ROWS}\nxllcorner {UTM[0]}\nyllcorner {UTM[3] - 10 * ROWS}\n"
                       "cellsize 10\nNODATA_value nan\n")
            file.writelines(" ".join(text(value) for value in row) + "\n" for row in holed())
        self.check(self.path("nan/a.asc"), holed())
        with open(self.path("nan/a.prj"), "w") as file:
            file.write(osr.GetUserInputAsWKT("EPSG:32631"))
        self.check_tile("nan/a.asc", holed())

    def test_geopotential_of_grib(self):
        template = "3 {} 2 0 81 0 0 0 1 0 0 0 0 1 0 0 0 0 0 255 0 0 0 0 0"
        memory = gdal.GetDriverByName("MEM").Create("", COLUMNS, ROWS, 1, gdal.GDT_Float64)
        memory.SetGeoTransform((10.0, 0.25, 0.0, 60.0, 0.0, -0.25))
        memory.SetProjection(osr.GetUserInputAsWKT("EPSG:4326"))
        for element, factor in ((4, 9.80665), (5, 1.0)):
            memory.GetRasterBand(1).WriteArray(ground() * factor)
            path = self.path(f"{element}.grib2")
            gdal.GetDriverByName("GRIB").CreateCopy(path, memory, options=[
                "DISCIPLINE=0", "IDS=CENTER=7", "PDS_PDTN=0", "PDS_TEMPLATE_NUMBERS=" + template.format(element)])
            self.check(path, ground(), None, tolerance=0.05)

    @unittest.skipIf(importlib.util.find_spec("h5py") is None, "h5py is not installed")
    def test_depths_of_s102_beside_their_quality(self):
        import h5py

        values = np.zeros((ROWS, COLUMNS), [("depth", "<f4"), ("uncertainty", "<f4")])
        values["depth"] = np.nan_to_num(holed(), nan=1e6)[::-1]
        with h5py.File(self.path("a.h5"), "w") as file:
            file.attrs["horizontalCRS"] = np.int32(32631)
            depths = file.create_group("BathymetryCoverage/BathymetryCoverage.01")
            for word, value in {"gridOriginLongitude": UTM[0] + 5, "gridOriginLatitude": UTM[3] - 10 * ROWS + 5,
                                "gridSpacingLongitudinal": 10.0, "gridSpacingLatitudinal": 10.0}.items():
                depths.attrs[word] = value
            depths.create_group("Group_001").create_dataset("values", data=values)
            quality = "QualityOfBathymetryCoverage/QualityOfBathymetryCoverage.01/Group_001/values"
            file.create_dataset(quality, data=np.ones((ROWS, COLUMNS), "u4"))
        self.check(self.path("a.h5"), -holed(), (*UTM[:3], UTM[3] - 10 * ROWS, 0.0, 10.0))

    @unittest.skipIf(importlib.util.find_spec("h5py") is None, "h5py is not installed")
    def test_axes_by_their_names(self):
        import h5py

        with h5py.File(self.path("a.h5"), "w") as file:
            file["elevation"] = ground()[::-1]
            file["x"] = UTM[0] + 10.0 * (np.arange(COLUMNS) + 0.5)
            file["y"] = UTM[3] - 10.0 * (np.arange(ROWS)[::-1] + 0.5)
        heights, image, _ = self.read(self.path("a.h5"))
        np.testing.assert_allclose(heights, ground())
        np.testing.assert_allclose(image.GetSpacing()[:2], 10.0)

    def write_bands(self, name, names):
        file = gdal.GetDriverByName("GTiff").Create(self.path(name), COLUMNS, ROWS, len(names), gdal.GDT_Float32)
        file.SetGeoTransform(UTM)
        file.SetProjection(osr.GetUserInputAsWKT("EPSG:32631"))
        for k, word in enumerate(names, 1):
            file.GetRasterBand(k).WriteArray(ground() if "elev" in word else np.full((ROWS, COLUMNS), 3.0 * k))
            file.GetRasterBand(k).SetDescription(word)
        return self.path(name)

    def test_the_band_that_is_called_as_heights_are(self):
        path = self.write_bands("bands/a.tif", ["slope", "aspect", "elevation (m)"])
        self.assertIn("--band 1 takes 'slope'", self.check(path, ground()))
        self.check(path, np.full((ROWS, COLUMNS), 3.0), Band=1)
        self.check_tile("bands/a.tif", ground())
        # two, or none, of them: the first
        self.check(self.write_bands("two.tif", ["slope", "dem", "height"]), np.full((ROWS, COLUMNS), 3.0))
        self.check(self.write_bands("none.tif", ["slope", "aspect"]), np.full((ROWS, COLUMNS), 3.0))

    def test_the_remedy_for_heights_in_colours_unpacks_them(self):
        codes = {"terrarium": np.round((ground() + 32768.0) * 256.0), "terrain-RGB": np.round((ground() + 1e4) * 10.0)}
        for k, (kind, code) in enumerate(codes.items()):
            bands = [(code.astype("i8") >> shift & 255).astype("u1") for shift in (16, 8, 0)]
            file = gdal.GetDriverByName("GTiff").Create(self.path("rgb.tif"), COLUMNS, ROWS, 3, gdal.GDT_Byte,
                                                        options=["PHOTOMETRIC=RGB"])
            for number, band in enumerate(bands, 1):
                file.GetRasterBand(number).WriteArray(band)
            file = None
            told = self.refusal(self.path("rgb.tif"))
            formula = re.findall("--calc='([^']*)'", told)[k]
            self.assertIn(kind, told)
            names = dict(zip("ABC", bands))
            np.testing.assert_allclose(eval(formula, names), ground(), atol=0.05)

    def test_a_geocentric_crs_is_told(self):
        self.write("a.tif", ground(), (4e6, 10.0, 0.0, 5e5, 0.0, -10.0), "EPSG:4978")
        self.assertIn("geocentric", self.read(self.path("a.tif"))[2])
        self.write("b.tif", ground(), DEGREES, "EPSG:4979")
        self.assertNotIn("geocentric", self.read(self.path("b.tif"))[2])

    def test_a_remedy_for_what_is_incomplete_or_packed(self):
        with open(self.path("N45E007.hgt"), "wb") as file:
            file.write(bytes(2 * 1201 * 1000))
        self.assertIn("incomplete", self.refusal(self.path("N45E007.hgt")))
        with open(self.path("a.tif.bz2"), "wb") as file:
            file.write(b"BZh91AY")
        self.assertIn("unpack", self.refusal(self.path("a.tif.bz2")))

    def test_the_header_that_is_told_reads_numbers_without_one(self):
        with open(self.path("a.dat"), "wb") as file:
            file.write(ground().astype("<f4").tobytes())
        lines = re.findall("'([^']*)'", self.refusal(self.path("a.dat")).split("the lines ")[1])
        with open(self.path("a.hdr"), "w") as file:
            file.write("\n".join(lines).replace("COLUMNS", str(COLUMNS)).replace("ROWS", str(ROWS)) + "\n")
        np.testing.assert_allclose(self.read(self.path("a.dat"))[0], ground())
        gdal.GetDriverByName("GPKG").Create(self.path("points.gpkg"), 0, 0, 0).CreateLayer("points")
        self.assertIn("gdal_grid", self.refusal(self.path("points.gpkg")))

    def test_comments_before_texts(self):
        with open(self.path("a.xyz"), "w") as file:
            file.write("# made by hand\n# x y z\n" + "".join(f"{c} {r} 5\n" for r in range(4) for c in range(4)))
        np.testing.assert_allclose(self.read(self.path("a.xyz"))[0], np.full((4, 4), 5.0))
        with open(self.path("a.asc"), "w") as file:
            file.write("# made by hand\nncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n")
        remedy = re.search(r"\((sed .*) IN > OUT.xyz\)", self.refusal(self.path("a.asc")))[1]
        subprocess.run(f"{remedy} a.asc > b.asc", shell=True, check=True, cwd=self.folder)
        np.testing.assert_allclose(self.read(self.path("b.asc"))[0], [[1.0, 2.0], [3.0, 4.0]])

    def test_texts_are_read_behind_a_byte_order_mark(self):
        rows = "\n".join(" ".join(f"{value:.6f}" for value in row) for row in ground())
        header = f"ncols {COLUMNS}\nnrows {ROWS}\nxllcorner {UTM[0]}\nyllcorner {UTM[3] - 10 * ROWS}\ncellsize 10\n"
        with open(self.path("a.asc"), "w", encoding="utf-8-sig") as file:
            file.write(header + rows + "\n")
        with open(self.path("a.prj"), "w", encoding="utf-8-sig") as file:
            reference = osr.SpatialReference()
            reference.ImportFromEPSG(32631)
            reference.MorphToESRI()
            file.write(reference.ExportToWkt())
        self.check(self.path("a.asc"), ground())
        self.write("east.tif", np.full((ROWS, 8), 7.0), (UTM[0] + 10.0 * COLUMNS, *UTM[1:]))
        heights, _, _ = self.read(self.folder)
        np.testing.assert_allclose(heights, np.hstack([ground(), np.full((ROWS, 8), 7.0)]), atol=1e-3)
        points = "\n".join(f"{UTM[0] + 10 * i},{UTM[3] - 10 * j},{ground()[j, i]}" for j in range(ROWS)
                           for i in range(COLUMNS))
        with open(self.path("points.csv"), "w", encoding="utf-8-sig") as file:
            file.write("x,y,z\n" + points + "\n")
        np.testing.assert_allclose(self.read(self.path("points.csv"))[0], ground(), atol=1e-3)


class TestFolderFiles(RasterCase):
    def test_texts_of_points_are_tiles(self):
        self.write("texts/a.txt", ground(), UTM, None, driver="XYZ")
        self.write("texts/b.txt", ground() + 1.0, (UTM[0] + 10.0 * COLUMNS, *UTM[1:]), None, driver="XYZ")
        with open(self.path("texts/readme.txt"), "w") as file:
            file.write("Heights of two places, made by hand.\n")
        heights, image, _ = self.read(self.path("texts"))
        np.testing.assert_allclose(heights, np.hstack([ground(), ground() + 1.0]), atol=1e-3)
        record = image.GetFieldData().GetAbstractArray("Record")
        lines = [record.GetValue(k) for k in range(record.GetNumberOfValues())]
        self.assertTrue(any("left out: 1 file (readme.txt)" in line for line in lines), lines)

    def write_png(self, name, heights, west, system=None):
        """A grey PNG of 16 bits, its place in a world file beside it."""
        path = self.write(name, heights, kind=gdal.GDT_UInt16, driver="PNG", system=None)
        os.remove(path + ".aux.xml")
        with open(path[:-4] + ".pgw", "w") as file:
            file.write(f"10\n0\n0\n-10\n{west + 5}\n{UTM[3] - 5}\n")
        if system:
            with open(path[:-4] + ".prj", "w") as file:
                file.write(osr.GetUserInputAsWKT(system))

    def test_pictures_of_16_bits_with_a_place_are_tiles(self):
        east = UTM[0] + 10.0 * COLUMNS
        self.write_png("png/a.png", ground(), UTM[0])
        self.write_png("png/b.png", ground() + 1.0, east)
        self.write("png/thumbnail.png", ground() / 2, kind=gdal.GDT_Byte, driver="PNG")
        heights, _, warning = self.read(self.path("png"))
        np.testing.assert_allclose(heights, np.hstack([ground(), ground() + 1.0]))
        self.assertIn("thumbnail.png", warning)
        # beside a tile with a CRS they need one
        self.write("png/c.tif", ground() + 2.0, (east + 10.0 * COLUMNS, *UTM[1:]))
        heights, _, warning = self.read(self.path("png"))
        np.testing.assert_allclose(heights, ground() + 2.0)
        for text in ("a.png names no CRS", "b.png names no CRS", "gdal_translate -a_srs"):
            self.assertIn(text, warning)
        self.write_png("png/a.png", ground(), UTM[0], "EPSG:32631")
        self.write_png("png/b.png", ground() + 1.0, east, "EPSG:32631")
        heights, _, warning = self.read(self.path("png"))
        np.testing.assert_allclose(heights, np.hstack([ground(), ground() + 1.0, ground() + 2.0]))
        self.assertNotIn("CRS", warning)

    def test_pictures_without_a_place_are_none(self):
        self.write("mixed/a.tif", ground())
        file = gdal.GetDriverByName("MEM").Create("", COLUMNS, ROWS, 1, gdal.GDT_UInt16)
        file.GetRasterBand(1).WriteArray(ground())
        gdal.GetDriverByName("PNG").CreateCopy(self.path("mixed/b.png"), file)
        heights, _, warning = self.read(self.path("mixed"))
        np.testing.assert_allclose(heights, ground())
        self.assertIn("b.png", warning)
        os.remove(self.path("mixed/a.tif"))  # but the one raster of a folder
        np.testing.assert_allclose(self.read(self.path("mixed"))[0], ground())

    def test_what_is_left_out_is_told_once_with_its_number(self):
        self.write("all/a.tif", ground())
        self.write("all/picture.png", ground(), kind=gdal.GDT_Byte, driver="PNG")
        gdal.GetDriverByName("VRT").CreateCopy(self.path("all/other.vrt"), gdal.Open(self.path("all/a.tif")))
        for name in ("points.las", "b.zip", "c.tar.gz"):
            with open(self.path("all/" + name), "wb") as file:
                file.write(b"not looked at")
        warning = self.read(self.path("all"))[2]
        self.assertEqual(warning.count("left out of the folder"), 1, warning)
        for text in ("2 archives (b.zip, c.tar.gz", "2 rasters that", "picture.png", "other.vrt",
                     "1 file of points, lines or meshes (points.las"):
            self.assertIn(text, warning)
        self.assertNotIn("aux.xml", warning)

    def test_radii_beside_heights(self):
        moon = "+proj=eqc +lat_ts=0 +R=1737400 +units=m"
        place = (0.0, 100.0, 0.0, 0.0, 0.0, -100.0)
        beside = (100.0 * COLUMNS, *place[1:])
        self.write("moon/a.tif", ground(), place, moon)
        self.write("moon/b.tif", ground() + 1737400.0, beside, moon, kind=gdal.GDT_Float64)
        heights, _, _ = self.read(self.path("moon"))
        np.testing.assert_allclose(heights, np.hstack([ground(), ground()]), atol=0.01)
        self.write("moon/a.tif", ground() + 1737400.0, place, moon, kind=gdal.GDT_Float64)
        heights, _, _ = self.read(self.path("moon"))
        np.testing.assert_allclose(heights, np.hstack([ground(), ground()]), atol=0.01)


if __name__ == "__main__":
    vtkTerrainTesting.run()
