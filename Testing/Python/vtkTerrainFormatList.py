# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""The formats of docs/formats.md, each with what writes it and what is true of the file."""
import vtkTerrainFormats as made
from vtkTerrainFormats import COLUMNS, DEGREES, ROWS, UTM, Format, copy, ground, raw, text_file, with_hole

CRS = "`--crs`"
PLACE = "a world file, or `gdal_translate -a_ullr`"
UTM_GRID = {"CoordinateSystem": "EPSG:32631"}


def of_utm(title, driver, write, by_hand="", hole=True, **options):
    return Format(title, driver, write, by_hand, with_hole(ground()) if hole else ground(), UTM[0], **options)


def of_degrees(title, driver, write, by_hand="", heights=None, **options):
    return Format(title, driver, write, by_hand, ground() if heights is None else heights, DEGREES[0], **options)


def of_nowhere(title, driver, write, by_hand=PLACE, **options):
    return Format(title, driver, write, by_hand, ground(), None, **options)


def written_by_gdal():
    large = ground(128, 128)
    return [
        copy("GeoTIFF", "GTiff", "tif", nodata=-9999, unit="ft"),
        copy("cloud-optimized GeoTIFF", "COG", "tif", "i2", nodata=-9999),
        copy("Erdas Imagine .img", "HFA", "img", nodata=-9999),
        copy("NITF", "NITF", "ntf", "i2", DEGREES),
        copy("ELAS", "ELAS", "elas", CoordinateSystem=UTM[1], by_hand=CRS),
        copy("DTED level 0", "DTED", "dt0", "i2",
             ((6.0 - 1 / 240, 1 / 120, 0, 46.0 + 1 / 240, 0, -1 / 120), "EPSG:4326"), -32767, heights=ground(121, 121)),
        copy("PCIDSK", "PCIDSK", "pix"),
        copy("PCRaster", "PCRaster", "map", nodata=-9999, options=["PCRASTER_VALUESCALE=VS_SCALAR"],
             CoordinateSystem=UTM[1], by_hand=CRS),
        copy("ILWIS", "ILWIS", "mpr", nodata=-9999),
        copy("Terragen", "Terragen", "ter", place=((0.0, 30.0, 0, 30.0 * ROWS, 0, -30.0), None), tolerance=0.01,
             options=["MINUSERPIXELVALUE=0", "MAXUSERPIXELVALUE=240"], by_hand="`gdal_translate -a_ullr`"),
        copy("netCDF of GDAL", "netCDF", "nc", nodata=-9999),
        copy("HDF 4 of GDAL", "HDF4Image", "hdf", nodata=-9999),
        copy("ISIS 2 cube", "ISIS2", "cub", place=None, by_hand=PLACE),
        copy("ISIS 3 cube", "ISIS3", "cub", "i2", ((0, 100, 0, 0, 0, -100), "+proj=eqc +R=1737400 +units=m"), -32768),
        copy("PDS 4", "PDS4", "xml", "f4", ((0, 100, 0, 0, 0, -100), "+proj=eqc +R=3396190 +units=m"), -9999,
             options=["VAR_LATITUDE_TYPE=Planetocentric"]),
        copy("VICAR", "VICAR", "vic", place=None, by_hand=PLACE),
        copy("FITS", "FITS", "fits", place=None, by_hand=PLACE),
        copy("ERMapper .ers", "ERS", "ers", nodata=-9999, CoordinateSystem=UTM[1], by_hand=CRS),
        copy("JPEG 2000, lossless", "JP2OpenJPEG", "jp2", "u2", options=["REVERSIBLE=YES", "QUALITY=100"]),
        copy("FIT", "FIT", "fit", place=None, by_hand=PLACE),
        copy("GRIB 2", "GRIB", "grib2", "f4", DEGREES, by_hand="`--band` for another field", tolerance=0.01,
             options=["DATA_ENCODING=IEEE_FLOATING_POINT"]),
        copy("Matrix of heights of RMF", "RMF", "mtw", "i4", options=["MTW=YES"]),
        copy("Idrisi .rst", "RST", "rst", nodata=-9999),
        copy("Surfer 6 binary", "GSBG", "grd", nodata=1.701410009187828e38, CoordinateSystem=UTM[1], by_hand=CRS),
        copy("Surfer 7", "GS7BG", "grd", "f8", nodata=1.70141e38, CoordinateSystem=UTM[1], by_hand=CRS),
        copy("Surfer ASCII", "GSAG", "grd", nodata=1.70141e38, CoordinateSystem=UTM[1], by_hand=CRS),
        copy("R, binary or ASCII", "R", "rda", "f8", place=None, by_hand=PLACE),
        copy("Meta Raster Format", "MRF", "mrf", "u2", options=["COMPRESS=PNG"]),
        copy("Portable greymap", "PNM", "pgm", "u2", place=None, by_hand=PLACE),
        copy("PCI .aux raw", "PAux", "raw", "u2", CoordinateSystem=UTM[1], by_hand=CRS),
        copy("Vexcel MFF", "MFF", "hdr", "f4"),
        copy("Vexcel MFF 2", "MFF2", "mff2", "f4"),
        copy("Binary Terrain .bt", "BT", "bt", "f4"),
        copy("Erdas .lan", "LAN", "lan", "u1", CoordinateSystem=UTM[1], by_hand=CRS),
        of_utm("FARSITE landscape .lcp", "LCP", made.landscape, "`--band` for another layer", hole=False),
        copy("VDatum .gtx", "GTX", "gtx", "f4", DEGREES),
        copy("KOLOR .kro", "KRO", "kro", "f4", place=None, by_hand=PLACE),
        copy("ROI_PAC", "ROI_PAC", "dem", "i2", DEGREES),
        copy("ISCE", "ISCE", "isce", "f4", DEGREES),
        copy("R raster .grd", "RRASTER", "grd", nodata=-9999),
        copy("geoid of Canada .byn", "BYN", "byn", "i4", DEGREES, by_hand="", tolerance=0.01),
        copy("Azavea .arg", "ARG", "arg", "f4", ((500000.0, 30.0, 0, 5000000.0, 0, -30.0), "EPSG:3857")),
        copy("USGS DEM", "USGSDEM", "dem", "i2", DEGREES, -32767),
        copy("Bathymetry Attributed Grid .bag", "BAG", "bag", "f4", UTM, 1e6),
        copy("Northwood, Vertical Mapper .grd", "NWT_GRD", "grd", "f4", UTM, -1e37, options=["ZMIN=0", "ZMAX=300"],
             tolerance=0.01),
        copy("SAGA .sdat", "SAGA", "sdat", nodata=-99999),
        copy("HF2", "HF2", "hf2", "f4", tolerance=0.02),
        copy("ZMap+", "ZMap", "dat", "f8", UTM, -99999, CoordinateSystem=UTM[1], by_hand=CRS),
        copy("SIGDEM", "SIGDEM", "sigdem", "f8", UTM, -9999),
        copy("ENVI", "ENVI", "bin", nodata=-9999),
        copy("Zarr 2", "Zarr", "zarr", nodata=-9999),
        copy("Rasterlite", "Rasterlite", "sqlite", "f4"),
        copy("GeoPackage", "GPKG", "gpkg", "f4", UTM, -9999, options=["TILE_FORMAT=TIFF"]),
        copy("Magellan .blx", "BLX", "blx", "i2", ((10.0, 0.01, 0, 50.0, 0, -0.01), "EPSG:4326"), heights=large),
        copy("SGI image", "SGI", "sgi", "u1", place=None, by_hand=PLACE),
        of_utm("PNG of 16 bits", "PNG", made.with_world_file("PNG", "png", "u2", "pgw"),
               "`--crs`; `--height-unit` for what a step is worth", False, options=UTM_GRID),
        of_utm("JPEG in grey", "JPEG", made.with_world_file("JPEG", "jpg", "u1", "jgw"),
               "`--crs`; `--height-unit`; better none: JPEG is lossy", False, options=UTM_GRID, tolerance=40.0),
        of_utm("virtual raster", "VRT", made.virtual),
    ]


def written_by_hand():
    small, write, place = made.radar_heights(1201, "N61E010.hgt")
    ace = ground(180, 180)
    raw_image = (f"IMAGINE_RAW_FILE\nWIDTH {COLUMNS}\nHEIGHT {ROWS}\nNUM_LAYERS 1\nPIXEL_FILES dem.raw\nFORMAT BIL\n"
                 "DATATYPE F32\nBYTE_ORDER LSB\nDATA_OFFSET 0\n")
    return [
        of_utm("ESRI ASCII grid", "AAIGrid", text_file("dem.asc", made.ascii_grid), CRS, options=UTM_GRID),
        of_utm("ESRI ASCII grid, centre and corner mixed", "AAIGrid", text_file("mixed.asc", lambda: made.ascii_grid(
            ("xllcenter", "yllcorner"), (0.5, 0.0))), CRS, options=UTM_GRID),
        of_utm("ESRI ASCII grid, decimal commas", "AAIGrid", text_file(
            "commas.asc", lambda: made.ascii_grid().replace(".", ",")), CRS, options=UTM_GRID),
        of_utm("GRASS ASCII", "GRASSASCIIGrid", text_file("dem.grass", made.grass_ascii), CRS, options=UTM_GRID),
        of_degrees("geoid .isg", "ISG", text_file("dem.isg", made.isg), heights=with_hole(ground())),
        of_utm("Geosoft .gxf", "GXF", text_file("dem.gxf", made.gxf), CRS, options=UTM_GRID),
        Format("Japanese DEM .mem", "JDEM", text_file("dem.mem", made.jdem), "", ground(),
               (140.0, 0.01, 0.0, 36.24, 0.0, -0.01), tolerance=0.01),
        of_utm("text x y z", "XYZ", text_file("dem.xyz", made.xyz), CRS, False, options=UTM_GRID),
        of_utm("text with names of columns", "XYZ", text_file("named.csv", lambda: made.xyz(
            "easting;northing;height\n", ";")), CRS, False, options=UTM_GRID),
        of_utm("text, decimal commas", "XYZ", text_file("commas.xyz", lambda: made.xyz(separator=";", decimal=",")),
               CRS, False, options=UTM_GRID),
        of_degrees("text lat, lon, z", "XYZ", text_file("latlon.csv", made.lat_lon)),
        Format("SRTM .hgt", "SRTMHGT", write, "", small, place),
        of_utm("ESRI .bil", "EHdr", raw("dem.bil", lambda: made.filled("<i2"), hdr=made.esri_header(
            "BIL", "SIGNEDINT", 16)), CRS, options=UTM_GRID),
        of_utm("ESRI .bip, big-endian", "EHdr", raw("dem.bip", lambda: made.filled(">i2"), hdr=made.esri_header(
            "BIP", "SIGNEDINT", 16, "M")), CRS, options=UTM_GRID),
        of_utm("ESRI .bsq", "EHdr", raw("dem.bsq", lambda: made.filled("<f4"), hdr=made.esri_header(
            "BSQ", "FLOAT", 32)), CRS, options=UTM_GRID),
        of_utm("ESRI GridFloat", "EHdr", raw("dem.flt", lambda: made.filled("<f4"), hdr=made.grid_float()), CRS,
               options=UTM_GRID),
        of_nowhere("Erdas raw", "EIR", raw("dem.raw", lambda: made.filled("<f4", ground()), "dem.eir", eir=raw_image)),
        of_utm("generic binary", "GenBin", raw("dem.gen", lambda: made.filled("<f4", ground()),
                                               hdr=made.generic_binary()), hole=False),
        of_degrees("NGS geoid .bin", "NGSGEOID", raw("dem.bin", made.ngs_geoid)),
        Format("ACE 2", "ACE2", raw("30N105E_5M.ACE2", lambda: made.filled("<f4", ace)), "", ace,
               (105.0, 1 / 12, 0.0, 45.0, 0.0, -1 / 12)),
        Format("PDS 3", "PDS", raw("dem.img", made.pds3), "", with_hole(ground()), (4900.0, 100.0, 0.0, 10000.0, 0.0,
                                                                                     -100.0)),
        of_degrees("netCDF, CF or COARDS", "netCDF", made.cf, "`--part` where several variables may be heights"),
        of_degrees("netCDF with scale_factor", "netCDF", made.cf_packed),
        of_degrees("netCDF, longitude first", "netCDF", made.cf_turned),
        of_utm("netCDF in metres", "netCDF", made.cf_metres, CRS, False, options=UTM_GRID),
        of_degrees("netCDF of depths", "netCDF", made.cf_depth, heights=-ground()),
        of_degrees("netCDF, latitudes unevenly spaced", "netCDF", made.cf_mercator, heights=made.slope, tolerance=0.1),
        of_degrees("netCDF, a longitude and latitude for each sample", "netCDF", made.cf_curved, heights=made.slope,
                   tolerance=0.1),
        of_utm("GMT 3", "(none)", made.gmt3, CRS, False, options=UTM_GRID),
        of_degrees("S-102", "(none), S102 from GDAL 3.8 on", made.s102, heights=-with_hole(ground()), needs=("h5py",)),
        of_utm("GeoTIFF in a .zip", "GTiff", made.packed("zip")),
        of_utm("GeoTIFF in a .tar", "GTiff", made.packed("tar")),
        of_utm("GeoTIFF in a .tgz", "GTiff", made.packed("tgz")),
        of_utm("GeoTIFF in a .gz", "GTiff", made.packed("tif.gz")),
        of_utm("folder of tiles", "VRT", made.folder_of_tiles),
    ]


FORMATS = written_by_gdal() + written_by_hand()
