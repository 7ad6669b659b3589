# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""One ground in every format of rasters that can be written here: by GDAL, or byte by byte.

Each ``Format`` has a function that writes a file into a folder and returns its name, and what is true of
the file. Sidecars of GDAL (.aux.xml) are not written: a file says what its format can say, no more.
"""
import dataclasses
import gzip
import os
import struct
import tarfile
import zipfile

import numpy as np
from osgeo import gdal, osr

ROWS, COLUMNS = 24, 32
HOLE = (slice(15, 17), slice(20, 23))
UTM = ((500000.0, 30.0, 0.0, 5000000.0, 0.0, -30.0), "EPSG:32631")
DEGREES = ((9.995, 0.01, 0.0, 50.005, 0.0, -0.01), "EPSG:4326")
KINDS = {"u1": gdal.GDT_Byte, "u2": gdal.GDT_UInt16, "i2": gdal.GDT_Int16, "i4": gdal.GDT_Int32,
         "f4": gdal.GDT_Float32, "f8": gdal.GDT_Float64}
FOOT = 0.3048


def ground(rows=ROWS, columns=COLUMNS):
    """Row 0 in the north: rises to the east and the south, a block in the north-west; whole numbers below 256."""
    row, column = np.mgrid[0:rows, 0:columns]
    heights = 20.0 + np.floor(64.0 * column / columns) + np.floor(24.0 * row / rows)
    heights[rows // 8:rows // 4, columns // 8:columns // 4] = 240.0
    return heights


@dataclasses.dataclass
class Format:
    title: str
    driver: str
    write: object
    by_hand: str = ""
    heights: object = None
    """Row 0 in the north, metres, NaN without data; of resampled ones a function of x and y of the CRS."""
    place: object = None
    """GDAL's transform of the samples; None where the format has none."""
    options: dict = dataclasses.field(default_factory=dict)
    """Settings of the reader."""
    tolerance: float = 1e-4
    needs: tuple = ()
    """Modules of Python that write it."""


def with_hole(heights):
    heights = heights.copy()
    heights[HOLE] = np.nan
    return heights


def dataset(heights, kind="f4", place=UTM, nodata=None, unit=None, bands=1):
    """A raster in memory: samples, place and what a band says."""
    rows, columns = heights.shape
    memory = gdal.GetDriverByName("MEM").Create("", columns, rows, bands, KINDS[kind])
    transform, system = place or (None, None)
    if transform:
        memory.SetGeoTransform(transform)
    if system:
        reference = osr.SpatialReference()
        reference.SetFromUserInput(system)
        memory.SetProjection(reference.ExportToWkt())
    for number in range(1, bands + 1):
        band = memory.GetRasterBand(number)
        band.WriteArray(np.where(np.isnan(heights), -9999.0 if nodata is None else nodata, heights))
        if nodata is not None:
            band.SetNoDataValue(nodata)
        if unit:
            band.SetUnitType(unit)
    return memory


def copy(title, driver, extension, kind="f4", place=UTM, nodata=None, unit=None, options=(), heights=None,
         by_hand="", tolerance=1e-4, **reader):
    """A format that GDAL writes."""
    samples = ground() if heights is None else heights
    if nodata is not None:
        samples = with_hole(samples)

    def write(folder):
        path = os.path.join(folder, "dem." + extension)
        memory = dataset(samples, kind, place, nodata, unit)
        gdal.SetConfigOption("GDAL_PAM_ENABLED", "NO")
        try:
            gdal.GetDriverByName(driver).CreateCopy(path, memory, options=list(options))
        finally:
            gdal.SetConfigOption("GDAL_PAM_ENABLED", None)
        return path

    factor = {None: 1.0, "ft": FOOT}[unit]
    opened = {"COG": "GTiff"}.get(driver, driver)
    return Format(title, opened, write, by_hand, factor * samples, place[0] if place else None,
                  reader, tolerance)


def text_file(name, text, encoding="ascii"):
    def write(folder):
        path = os.path.join(folder, name)
        with open(path, "w", encoding=encoding, newline="") as file:
            file.write(text())
        return path
    return write


def rows_of(heights):
    return "".join(" ".join("-9999" if np.isnan(z) else f"{z:g}" for z in row) + "\n" for row in heights)


def corner(place=UTM):
    """West, south, east, north, cell."""
    t = place[0]
    return t[0], t[3] + ROWS * t[5], t[0] + COLUMNS * t[1], t[3], t[1]


def ascii_grid(words=("xllcorner", "yllcorner"), shift=(0.0, 0.0)):
    west, south, _, _, cell = corner()
    return (f"ncols {COLUMNS}\nnrows {ROWS}\n{words[0]} {west + shift[0] * cell:.1f}\n{words[1]} "
            f"{south + shift[1] * cell:.1f}\ncellsize {cell:g}\nNODATA_value -9999\n" + rows_of(with_hole(ground())))


def grass_ascii():
    west, south, east, north, _ = corner()
    return (f"north: {north}\nsouth: {south}\neast: {east}\nwest: {west}\nrows: {ROWS}\ncols: {COLUMNS}\nnull: -9999\n"
            "type: float\n" + rows_of(with_hole(ground())))


def isg():
    west, south, east, north, cell = corner(DEGREES)
    return ("begin_of_head ================================================\nmodel name : made\nmodel type : hybrid\n"
            f"units : meters\nreference : WGS84\nlat min = {south:.3f}\nlat max = {north:.3f}\nlon min = {west:.3f}\n"
            f"lon max = {east:.3f}\ndelta lat = {cell:g}\ndelta lon = {cell:g}\nnrows = {ROWS}\nncols = {COLUMNS}\n"
            "nodata = -9999.0\nISG format = 1.0\n"
            "end_of_head ==================================================\n" + rows_of(with_hole(ground())))


def gxf():
    west, south, _, _, cell = corner()
    head = {"POINTS": COLUMNS, "ROWS": ROWS, "PTSEPARATION": cell, "RWSEPARATION": cell, "XORIGIN": west + cell / 2,
            "YORIGIN": south + cell / 2, "ROTATION": 0, "SENSE": 1, "DUMMY": -9999}
    return "".join(f"#{key}\n{value}\n" for key, value in head.items()) + "#GRID\n" + rows_of(
        with_hole(ground())[::-1])


def jdem():
    """Tenths of metres in records of a line, after a header of 1011 bytes; angles as DDDMMSS."""
    def angle(value):
        seconds = round(value * 3600)
        return f"{seconds // 3600:03d}{seconds // 60 % 60:02d}{seconds % 60:02d}"

    west, south, east, north, _ = (value + 0.005 for value in corner(((139.995, 0.01, 0, 36.235, 0, -0.01), "")))
    head = "53394500000" + "199019911992" + f"{COLUMNS:3d}{ROWS:3d}" + "".join(
        angle(value) for value in (south, west, north, east))
    lines = "".join("533945" + f"{k + 1:3d}" + "".join(f"{round(10 * z):5d}" for z in row) + "\r\n"
                    for k, row in enumerate(ground()))
    return head.ljust(1011) + lines


def xyz(header="", separator=" ", decimal="."):
    t = UTM[0]
    points = ((t[0] + t[1] * (c + 0.5), t[3] + t[5] * (r + 0.5), z)
              for r, row in enumerate(ground()) for c, z in enumerate(row))
    lines = (separator.join(f"{number:.2f}" for number in point) for point in points)
    return header + "\n".join(lines).replace(".", decimal) + "\n"


def lat_lon():
    t = DEGREES[0]
    return "lat,lon,z\n" + "".join(f"{t[3] + t[5] * (r + 0.5):.4f},{t[0] + t[1] * (c + 0.5):.4f},{z:g}\n"
                                   for r, row in enumerate(ground()) for c, z in enumerate(row))


def raw(name, data, opened=None, **sidecars):
    """Bytes beside a header; the name of the file that is opened, if it is not that of the bytes."""
    def write(folder):
        for extension, text in sidecars.items():
            with open(os.path.join(folder, f"dem.{extension}"), "w") as file:
                file.write(text)
        path = os.path.join(folder, name)
        with open(path, "wb") as file:
            file.write(data() if callable(data) else data)
        return os.path.join(folder, opened or name)
    return write


def esri_header(layout, pixel, bits, order="I"):
    west, _, _, north, cell = corner()
    return (f"BYTEORDER {order}\nLAYOUT {layout}\nNROWS {ROWS}\nNCOLS {COLUMNS}\nNBANDS 1\nNBITS {bits}\n"
            f"PIXELTYPE {pixel}\nULXMAP {west + cell / 2}\nULYMAP {north - cell / 2}\nXDIM {cell}\nYDIM {cell}\n"
            "NODATA -9999\n")


def filled(kind, heights=None):
    samples = with_hole(ground()) if heights is None else heights
    return np.where(np.isnan(samples), -9999, samples).astype(kind).tobytes()


def grid_float():
    west, south, _, _, cell = corner()
    return (f"ncols {COLUMNS}\nnrows {ROWS}\nxllcorner {west}\nyllcorner {south}\ncellsize {cell}\n"
            "NODATA_value -9999\nbyteorder LSBFIRST\n")


def generic_binary():
    west, south, east, north, cell = corner()
    return (f"BANDS: 1\nROWS: {ROWS}\nCOLS: {COLUMNS}\nDATATYPE: F32\nBYTE_ORDER: LSB\nINTERLEAVING: BIL\n"
            f"UL_X_COORDINATE: {west + cell / 2}\nUL_Y_COORDINATE: {north - cell / 2}\n"
            f"LR_X_COORDINATE: {east - cell / 2}\nLR_Y_COORDINATE: {south + cell / 2}\n"
            "PROJECTION_NAME: UTM\nPROJECTION_ZONE: 31\nDATUM_NAME: WGS84\n")


def ngs_geoid():
    """Little-endian; rows from the south, longitudes from 0 to 360."""
    west, south, _, _, cell = corner(DEGREES)
    head = struct.pack("<ddddiii", south + cell / 2, west + cell / 2, cell, cell, ROWS, COLUMNS, 1)
    return head + ground()[::-1].astype("<f4").tobytes()


def pds3():
    record = 4 * COLUMNS
    radius, cell = 3396190.0, 100.0
    label = f"""PDS_VERSION_ID = PDS3
RECORD_TYPE = FIXED_LENGTH
RECORD_BYTES = {record}
LABEL_RECORDS = 16
^IMAGE = 17
OBJECT = IMAGE
  LINES = {ROWS}
  LINE_SAMPLES = {COLUMNS}
  BANDS = 1
  SAMPLE_TYPE = PC_REAL
  SAMPLE_BITS = 32
  MISSING_CONSTANT = -9999.0
END_OBJECT = IMAGE
OBJECT = IMAGE_MAP_PROJECTION
  MAP_PROJECTION_TYPE = "SIMPLE CYLINDRICAL"
  A_AXIS_RADIUS = {radius / 1000} <KM>
  B_AXIS_RADIUS = {radius / 1000} <KM>
  C_AXIS_RADIUS = {radius / 1000} <KM>
  CENTER_LATITUDE = 0.0 <DEG>
  CENTER_LONGITUDE = 0.0 <DEG>
  MAP_SCALE = {cell} <METERS/PIXEL>
  LINE_PROJECTION_OFFSET = 99.5
  SAMPLE_PROJECTION_OFFSET = -49.5
END_OBJECT = IMAGE_MAP_PROJECTION
END
"""
    return label.replace("\n", "\r\n").ljust(16 * record).encode() + filled("<f4")


def radar_heights(size, name):
    """A tile of points of the Shuttle mission: big-endian, its corner samples on degrees."""
    heights = ground(size, size)
    heights[100:103, 50:60] = np.nan
    samples = np.where(np.isnan(heights), -32768, heights).astype(">i2").tobytes()
    step = 1.0 / (size - 1)
    return heights, raw(name, samples), (10.0 - step / 2, step, 0.0, 62.0 + step / 2, 0.0, -step)


def netcdf(folder, name, y, x, heights, units, order=("y", "x"), attributes=None, fields=()):
    """A netCDF of coordinates and heights, as programs write them that know nothing of GDAL."""
    text, number = gdal.ExtendedDataType.CreateString(), gdal.ExtendedDataType.Create(gdal.GDT_Float64)
    path = os.path.join(folder, name)
    file = gdal.GetDriverByName("netCDF").CreateMultiDimensional(path, options=["FORMAT=NC4"])
    group = file.GetRootGroup()
    values = {"y": y, "x": x}
    axes = {}
    for axis, unit, standard in zip("yx", units[:2], units[2:] or ("", "")):
        label = {"degrees_north": "lat", "degrees_east": "lon"}.get(unit, axis)
        axes[axis] = group.CreateDimension(label, None, None, len(values[axis]))
        array = group.CreateMDArray(label, [axes[axis]], number)
        array.CreateAttribute("units", [], text).Write(unit)
        if standard:
            array.CreateAttribute("standard_name", [], text).Write(standard)
        array.Write(np.asarray(values[axis], dtype=np.float64))
    for label, unit, field in fields:
        array = group.CreateMDArray(label, [axes["y"], axes["x"]], number)
        array.CreateAttribute("units", [], text).Write(unit)
        array.Write(np.ascontiguousarray(field))
    z = group.CreateMDArray("topo", [axes[axis] for axis in order], number)
    for key, value in (attributes or {}).items():
        kind = text if isinstance(value, str) else number
        z.CreateAttribute(key, [], kind).Write(value)
    z.Write(np.ascontiguousarray(heights if order == ("y", "x") else heights.T, dtype=np.float64))
    return path


def degrees_of_rows():
    t = DEGREES[0]
    return t[3] + t[5] * (np.arange(ROWS) + 0.5), t[0] + t[1] * (np.arange(COLUMNS) + 0.5)


def metres_of_rows():
    t = UTM[0]
    return t[3] + t[5] * (np.arange(ROWS) + 0.5), t[0] + t[1] * (np.arange(COLUMNS) + 0.5)


def cf(folder):
    y, x = degrees_of_rows()
    return netcdf(folder, "cf.nc", y[::-1], x, ground()[::-1], ("degrees_north", "degrees_east"))


def cf_packed(folder):
    y, x = degrees_of_rows()
    return netcdf(folder, "packed.nc", y, x, (ground() - 10.0) / 2.0, ("degrees_north", "degrees_east"),
                  attributes={"scale_factor": 2.0, "add_offset": 10.0})


def cf_turned(folder):
    y, x = degrees_of_rows()
    return netcdf(folder, "turned.nc", y[::-1], x, ground()[::-1], ("degrees_north", "degrees_east"), ("x", "y"))


def cf_metres(folder):
    y, x = metres_of_rows()
    return netcdf(folder, "metres.nc", y[::-1], x, ground()[::-1],
                  ("m", "m", "projection_y_coordinate", "projection_x_coordinate"))


def cf_depth(folder):
    y, x = degrees_of_rows()
    return netcdf(folder, "depth.nc", y, x, ground(), ("degrees_north", "degrees_east"),
                  attributes={"positive": "down", "units": "m"})


def slope(x, y):
    """A plane over longitude and latitude."""
    return 100.0 + 200.0 * (x - 10.0) + 100.0 * (50.0 - y)


def cf_mercator(folder):
    """Latitudes that lie evenly in the Mercator projection."""
    _, x = degrees_of_rows()
    y = np.degrees(2.0 * np.arctan(np.exp(np.radians(50.0 + 0.5 * np.arange(ROWS)))) - np.pi / 2.0)
    lat, lon = np.meshgrid(y, x, indexing="ij")
    return netcdf(folder, "mercator.nc", y, x, slope(lon, lat), ("degrees_north", "degrees_east"))


def cf_curved(folder):
    """A grid of longitude and latitude whose coordinates are written for each sample."""
    y, x = degrees_of_rows()
    lat, lon = np.meshgrid(y[::-1], x, indexing="ij")
    lon = lon + 0.02 * (lat - y[0])  # sheared: no even grid
    return netcdf(folder, "curved.nc", np.arange(ROWS), np.arange(COLUMNS), slope(lon, lat), ("1", "1"),
                  attributes={"coordinates": "XLAT XLONG"},
                  fields=(("XLAT", "degrees_north", lat), ("XLONG", "degrees_east", lon)))


def gmt3(folder):
    """A grid of GMT 3: one row of numbers from the north-west, and what they are in three pairs."""
    text, number = gdal.ExtendedDataType.CreateString(), gdal.ExtendedDataType.Create(gdal.GDT_Float64)
    path = os.path.join(folder, "gmt3.grd")
    file = gdal.GetDriverByName("netCDF").CreateMultiDimensional(path, options=["FORMAT=NC"])
    group = file.GetRootGroup()
    side = group.CreateDimension("side", None, None, 2)
    size = group.CreateDimension("xysize", None, None, ROWS * COLUMNS)
    y, x = metres_of_rows()
    for name, values in (("x_range", (x[0], x[-1])), ("y_range", (y[-1], y[0])), ("z_range", (20.0, 240.0)),
                         ("spacing", (30.0, 30.0)), ("dimension", (COLUMNS, ROWS))):
        array = group.CreateMDArray(name, [side], number)
        array.CreateAttribute("units", [], text).Write("meters" if name != "dimension" else "1")
        array.Write(np.array(values, dtype=np.float64))
    z = group.CreateMDArray("z", [size], number)
    for key, value in (("scale_factor", 1.0), ("add_offset", 0.0), ("node_offset", 0.0)):
        z.CreateAttribute(key, [], number).Write(value)
    z.Write(np.ascontiguousarray(ground().reshape(-1)))
    return path


def s102(folder):
    import h5py

    west, south, _, _, cell = corner(DEGREES)
    path = os.path.join(folder, "s102.h5")
    samples = with_hole(ground())[::-1]
    values = np.zeros(samples.shape, dtype=[("depth", "f4"), ("uncertainty", "f4")])
    values["depth"] = np.where(np.isnan(samples), 1e6, samples)
    with h5py.File(path, "w") as file:
        file.attrs["productSpecification"] = "INT.IHO.S-102.2.1"
        file.attrs["horizontalCRS"] = 4326
        coverage = file.create_group("BathymetryCoverage/BathymetryCoverage.01")
        for key, value in (("gridOriginLongitude", west + cell / 2), ("gridOriginLatitude", south + cell / 2),
                           ("gridSpacingLongitudinal", cell), ("gridSpacingLatitudinal", cell)):
            coverage.attrs[key] = value
        coverage.attrs["numPointsLongitudinal"], coverage.attrs["numPointsLatitudinal"] = COLUMNS, ROWS
        coverage.create_group("Group_001")["values"] = values
    return path


def packed(archive):
    def write(folder):
        source = copy("", "GTiff", "tif", nodata=-9999).write(folder)
        path = os.path.join(folder, "dem." + archive)
        if archive == "zip":
            with zipfile.ZipFile(path, "w") as file:
                file.write(source, "dem.tif")
        elif archive == "tif.gz":
            with open(source, "rb") as file, gzip.open(path, "wb") as target:
                target.write(file.read())
        else:
            with tarfile.open(path, "w:gz" if archive == "tgz" else "w") as file:
                file.add(source, "dem.tif")
        os.remove(source)
        return path
    return write


def folder_of_tiles(folder):
    path = os.path.join(folder, "tiles")
    os.makedirs(os.path.join(path, "east"))
    t, system = UTM
    half = COLUMNS // 2
    for name, part, x in (("west.tif", slice(0, half), t[0]), ("east/east.tif", slice(half, None), t[0] + half * t[1])):
        memory = dataset(with_hole(ground())[:, part], "f4", ((x, *t[1:]), system), -9999)
        gdal.GetDriverByName("GTiff").CreateCopy(os.path.join(path, name), memory)
    return path


def virtual(folder):
    source = copy("", "GTiff", "tif", nodata=-9999).write(folder)
    path = os.path.join(folder, "dem.vrt")
    gdal.Translate(path, source, format="VRT")
    return path


def landscape(folder):
    """FARSITE's landscape: elevation, slope, aspect, fuel, canopy cover."""
    path = os.path.join(folder, "dem.lcp")
    memory = dataset(ground(), "i2", bands=5)
    gdal.GetDriverByName("LCP").CreateCopy(path, memory, options=[
        "ELEVATION_UNIT=METERS", "SLOPE_UNIT=DEGREES", "ASPECT_UNIT=AZIMUTH_DEGREES", "CANOPY_COV_UNIT=PERCENT",
        "FUEL_MODEL_OPTION=NO_CUSTOM_AND_NO_FILE", "LATITUDE=45", "LINEAR_UNIT=METER"])
    return path


def with_world_file(driver, extension, kind, world):
    def write(folder):
        path = copy("", driver, extension, kind, None).write(folder)
        t = UTM[0]
        with open(os.path.join(folder, "dem." + world), "w") as file:
            file.write("".join(f"{value}\n" for value in (t[1], 0, 0, t[5], t[0] + t[1] / 2, t[3] + t[5] / 2)))
        return path
    return write
