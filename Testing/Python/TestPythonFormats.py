# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every row of the table in docs/formats.md, from a file that is written here: heights, orientation, place, holes,
unit; by name, as a DataArray, and as a tile of a folder.

    python3 TestPythonFormats.py --table     prints the rows as this machine finds them

Skipped without GDAL's Python module; rows whose driver or module is missing are left out.
"""
import importlib.util
import os
import re
import shutil
import sys
import tempfile
import unittest

import numpy as np
import vtkTerrainTesting
from vtkmodules.vtkCommonCore import vtkObject

from vtkterrain import _intake, array_from_heights, vtkTerrainRasterReader

try:
    from osgeo import gdal
    from vtkTerrainFormatList import FORMATS

    gdal.UseExceptions()
    gdal.PushErrorHandler("CPLQuietErrorHandler")
except ImportError:
    FORMATS = []

DOCUMENT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "formats.md")
FEWEST_ROWS = 60
# archives, what may be made of the tiles, bytes, a header called as others' are, a folder
NO_TILES = (".zip", ".tar", ".tgz", ".gz", ".vrt", ".jpg", ".lan", ".hdr", ".mff2")


def is_missing(form):
    drivers = [name for name in re.split(r"[, ]+", form.driver) if name.isupper() or gdal.GetDriverByName(name)]
    here = form.driver.startswith("(none)") or any(gdal.GetDriverByName(name) for name in drivers)
    return not here or any(importlib.util.find_spec(name) is None for name in form.needs)


def make_reader(path, form):
    reader = vtkTerrainRasterReader()
    reader.SetFileName(path)
    for name, value in form.options.items():
        getattr(reader, f"Set{name}")(value)
    return reader


def read(path, form):
    reader = make_reader(path, form)
    reader.Update()
    if reader.GetErrorMessage():
        raise AssertionError(f"{form.title}: {reader.GetErrorMessage()}")
    return reader.GetOutput(), reader


def numbers(image, name, default):
    array = image.GetFieldData().GetArray(name)
    return np.array(array.GetTuple(0)) if array else np.array(default)


def place_of(image):
    """GDAL's transform of what was read, from where its samples lie."""
    if not image.GetFieldData().GetArray("LayoutScale"):
        return None
    origin, scale = numbers(image, "LayoutOrigin", (0, 0)), numbers(image, "LayoutScale", (1, 1))
    step = np.array(image.GetSpacing()[:2]) / scale
    first = origin + np.array(image.GetOrigin()[:2]) / scale
    north = first[1] + (image.GetDimensions()[1] - 0.5) * step[1]
    return first[0] - 0.5 * step[0], step[0], 0.0, north, 0.0, -step[1]


def lines_of(image, name):
    texts = image.GetFieldData().GetAbstractArray(name)
    return [texts.GetValue(k) for k in range(texts.GetNumberOfValues())] if texts else []


def check_resampled(form, image):
    """A plane keeps its heights wherever it is sampled."""
    west, dx, _, north, _, dy = place_of(image)
    heights = array_from_heights(image)[::-1].astype(float)
    row, column = np.mgrid[0:heights.shape[0], 0:heights.shape[1]]
    expected = form.heights(west + (column + 0.5) * dx, north + (row + 0.5) * dy)
    is_known = np.isfinite(heights)
    assert is_known.mean() > 0.8, form.title
    np.testing.assert_allclose(heights[is_known], expected[is_known], atol=form.tolerance, err_msg=form.title)
    return "heights, orientation, cell, CRS"


def check(form, path):
    """Reads a file by its name; returns what its format was checked for."""
    image, _ = read(path, form)
    if callable(form.heights):
        return check_resampled(form, image)
    heights = array_from_heights(image)[::-1].astype(float)
    np.testing.assert_array_equal(heights.shape, form.heights.shape, err_msg=form.title)
    np.testing.assert_array_equal(np.isnan(heights), np.isnan(form.heights), err_msg=f"{form.title}: holes")
    np.testing.assert_allclose(heights, form.heights, atol=form.tolerance, err_msg=form.title)
    lines = lines_of(image, "Record")
    record = "\n".join(lines)
    checked = ["heights", "orientation"]
    if form.place is not None:
        np.testing.assert_allclose(place_of(image), form.place, rtol=1e-6, atol=1e-5, err_msg=f"{form.title}: place")
        checked.append("cell")
        is_named = "CRS: " in record and "(given)" not in record
        checked += ["CRS"] if is_named else []
    if np.isnan(form.heights).any():
        checked.append("NoData")
    checked += ["unit"] if any(line.startswith("height unit:") and "assumed" not in line for line in lines) else []
    checked += ["scale"] if "scale: " in record else []
    checked += ["sense"] if "positive down" in record else []
    return ", ".join(checked)


def attributes_of(array):
    """What netCDF says of a variable."""
    names = [each.GetName() for each in array.GetAttributes(["SHOW_ALL=YES"])]
    return {name: array.GetAttribute(name).Read() for name in names if array.GetAttribute(name) is not None}


def dataarray_of_netcdf(path, name="topo"):
    """As xarray.open_dataset gives it, without its decoding."""
    import xarray

    file = gdal.OpenEx(path, gdal.OF_MULTIDIM_RASTER)
    root = file.GetRootGroup()
    variables = {}
    for key in root.GetMDArrayNames():
        array = root.OpenMDArray(key)
        dims = [dimension.GetName() for dimension in array.GetDimensions()]
        variables[key] = (dims, array.ReadAsArray(), attributes_of(array))
    heights = variables.pop(name)
    attributes = {key: value for key, value in heights[2].items() if key != "coordinates"}
    return xarray.DataArray(heights[1], dims=heights[0], attrs=attributes, name=name, coords=variables)


def dataarray_of_raster(path, form):
    """As rioxarray gives it: coordinates of pixels, the CRS in spatial_ref, the band's tags as attributes."""
    import xarray

    file = gdal.Open(path)
    band = file.GetRasterBand(4 if form.driver == "NWT_GRD" else 1)
    samples, t = band.ReadAsArray(), file.GetGeoTransform()
    attributes = {"units": band.GetUnitType(), "scale_factor": band.GetScale(), "add_offset": band.GetOffset(),
                  "_FillValue": band.GetNoDataValue()}
    system = {"GeoTransform": " ".join(str(number) for number in t)}
    if file.GetSpatialRef():
        system["crs_wkt"] = file.GetSpatialRef().ExportToWkt(["FORMAT=WKT2_2019"])
    coords = {"x": t[0] + t[1] * (np.arange(samples.shape[1]) + 0.5),
              "y": t[3] + t[5] * (np.arange(samples.shape[0]) + 0.5), "spatial_ref": ((), 0, system)}
    kept = {key: value for key, value in attributes.items() if value not in (None, "")}
    return xarray.DataArray(samples, dims=("y", "x"), coords=coords, attrs=kept, name="heights")


def row_of(form, checked):
    return f"| {form.title} | {form.driver} | {checked} | {form.by_hand} |"


def rows_in_document():
    with open(DOCUMENT, encoding="utf-8") as file:
        table = file.read().partition("| format | driver | checked | by hand |")[2]
    return [line for line in table.splitlines()[2:] if line.startswith("|")]


@unittest.skipIf(not FORMATS, "GDAL's Python module is not installed")
class TestFormats(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        vtkObject.GlobalWarningDisplayOff()

    def tearDown(self):
        shutil.rmtree(self.folder)

    def written(self):
        """Each format that can be written here, and its file."""
        for number, form in enumerate(FORMATS):
            if is_missing(form):
                continue
            folder = os.path.join(self.folder, str(number))
            os.makedirs(folder)
            yield form, form.write(folder)
            shutil.rmtree(folder)

    def test_table_is_what_is_read(self):
        table = rows_in_document()
        self.assertGreaterEqual(len(table), FEWEST_ROWS)
        self.assertEqual([row.split("|")[1].strip() for row in table], [form.title for form in FORMATS])
        rows = dict(zip((form.title for form in FORMATS), table))
        count = 0
        for form, path in self.written():
            with self.subTest(form.title):
                self.assertEqual(rows[form.title], row_of(form, check(form, path)))
                count += 1
        missing = ", ".join(form.title for form in FORMATS if is_missing(form))
        self.assertGreaterEqual(count, FEWEST_ROWS, f"formats that this GDAL lacks: {missing}")

    def assert_same(self, one, other, title):
        for name in ("GetDimensions", "GetBounds", "GetSpacing"):  # whichever row comes first
            np.testing.assert_allclose(getattr(one, name)(), getattr(other, name)(), rtol=1e-6, atol=1e-4,
                                       err_msg=f"{title}: {name}")
        heights, others = (array_from_heights(image).astype(float) for image in (one, other))
        np.testing.assert_array_equal(np.isnan(heights), np.isnan(others), err_msg=f"{title}: holes")
        np.testing.assert_allclose(heights, others, atol=1e-3, err_msg=title)

    @unittest.skipIf(importlib.util.find_spec("xarray") is None, "xarray is not installed")
    def test_dataarrays_are_what_their_files_are(self):
        from vtkterrain.xarrays import heights_from_dataarray

        count = 0
        for form, path in self.written():
            if form.driver.startswith("(none)") or os.path.isdir(path) and form.driver == "VRT" or path.endswith(
                    (".zip", ".tar", ".tgz", ".gz", "mixed.asc", ".ter")) or "lat, lon" in form.title:
                continue  # what GDAL alone does not open, or not in its place
            with self.subTest(form.title):
                is_array = form.driver == "netCDF" and "of GDAL" not in form.title
                data = dataarray_of_netcdf(path) if is_array else dataarray_of_raster(path, form)
                crs = form.options.get("CoordinateSystem") if form.place is not None else None
                by_name = _intake.lay_out(_intake.read(make_reader(path, form)))
                self.assert_same(heights_from_dataarray(data, crs=crs), by_name, form.title)
                count += 1
        self.assertGreater(count, FEWEST_ROWS)

    def test_tiles_of_folders_are_what_they_are_alone(self):
        count = 0
        for form, path in self.written():
            if form.place is None or path.endswith(NO_TILES) or callable(form.heights):
                continue
            with self.subTest(form.title):
                alone, _ = read(path, form)
                t, columns = form.place, form.heights.shape[1]
                east = gdal.GetDriverByName("GTiff").Create(os.path.join(os.path.dirname(path), "zz_east.tif"), 8,
                                                            form.heights.shape[0], 1, gdal.GDT_Float32)
                east.SetGeoTransform((t[0] + columns * t[1], *t[1:]))
                if "CoordinateSystem" not in form.options:
                    east.SetProjection(lines_of(alone, "CRS")[0])
                east.GetRasterBand(1).WriteArray(np.full((form.heights.shape[0], 8), 7.0))
                east = None
                image, _ = read(os.path.dirname(path), form)
                heights = array_from_heights(image).astype(float)
                self.assertEqual(heights.shape[1], columns + 8)
                np.testing.assert_allclose(heights[:, columns:], 7.0)
                np.testing.assert_allclose(heights[:, :columns], array_from_heights(alone), atol=1e-3)
                np.testing.assert_allclose(place_of(image), t, rtol=1e-6, atol=1e-5)
                count += 1
        self.assertGreater(count, FEWEST_ROWS)


if __name__ == "__main__":
    if "--table" in sys.argv:
        vtkObject.GlobalWarningDisplayOff()
        for each in FORMATS:
            with tempfile.TemporaryDirectory() as place:
                try:
                    print(row_of(each, check(each, each.write(place))))
                except (AssertionError, RuntimeError) as error:
                    print("FAILED", each.title, " ".join(str(error).split())[:300])
        sys.exit()
    vtkTerrainTesting.run()
