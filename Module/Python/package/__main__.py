# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shows heights in a browser: python -m vtkterrain FILE"""
import argparse
import os
import sys


def port_number(text):
    """A port as typed."""
    if not text.isascii() or not text.isdigit() or int(text) > 65535:
        raise argparse.ArgumentTypeError(f"a port is a number from 0 to 65535, not {text!r}")
    return int(text)


def add_input_options(parser):
    """What the file does not say, or says wrongly, as the programs take it."""
    parser.add_argument("--crs", help="coordinate system, such as EPSG:32633")
    parser.add_argument("--band", type=int, help="band of the file, from 1")
    parser.add_argument("--part", help="part of a file or site of a folder")
    parser.add_argument("--nodata", help='a value that is no height, or "none"')
    parser.add_argument("--height-unit", help="unit of the heights, such as ft, or metres a unit")
    parser.add_argument("--flip", action="store_true", help="the file is upside down")


def main():
    """Reads the file, and serves its page until it is interrupted."""
    parser = argparse.ArgumentParser(prog="python -m vtkterrain", description=__doc__)
    parser.add_argument("file", help="any raster that GDAL opens, or a directory of tiles")
    parser.add_argument("--host", default="127.0.0.1",
                        help="address to listen at; 127.0.0.1, the default, lets in this machine alone")
    parser.add_argument("--port", type=port_number, default=0,
                        help="port to listen at; 0, the default, is any that is free")
    parser.add_argument("--no-browser", action="store_true", help="only print the address")
    parser.add_argument("--colors", default="relief",
                        help="first colours: a scheme (oleron, batlow, ...) or a colour map of matplotlib, colorcet, "
                             "cmocean or cmcrameri, where Python has them")
    add_input_options(parser)
    arguments = parser.parse_args()
    sys.argv = sys.argv[:1]  # trame reads them too
    os.environ.setdefault("WSLINK_READY_MSG", "")
    try:
        from .viewer import read_heights

        heights = read_heights(arguments.file, **{name: getattr(arguments, name) for name in (
            "crs", "band", "part", "nodata", "height_unit", "flip")})
        try:
            from .server import Page
        except ImportError as error:
            sys.exit(f"vtkterrain: the browser needs more packages ({error}): pip install 'vtkterrain[browser]'")
        page = Page(heights, os.path.basename(os.path.normpath(arguments.file)), arguments.colors)
        page.start(arguments.host, arguments.port, not arguments.no_browser,
                   lambda address: print(address, flush=True))
    except (OSError, RuntimeError, ValueError) as error:
        sys.exit(f"vtkterrain: {error}")


if __name__ == "__main__":
    main()
