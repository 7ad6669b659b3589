# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shows heights in a browser: python -m vtkterrain FILE"""
import argparse
import os
import sys


def main():
    """Reads the file, and serves its page until it is interrupted."""
    parser = argparse.ArgumentParser(prog="python -m vtkterrain", description=__doc__)
    parser.add_argument("file", help="any raster that GDAL opens, or a directory of tiles")
    parser.add_argument("--host", default="127.0.0.1",
                        help="address to listen at; 127.0.0.1, the default, lets in this machine alone")
    parser.add_argument("--port", type=int, default=0, help="port to listen at; 0, the default, is any that is free")
    parser.add_argument("--no-browser", action="store_true", help="only print the address")
    arguments = parser.parse_args()
    sys.argv = sys.argv[:1]  # trame reads them too
    os.environ.setdefault("WSLINK_READY_MSG", "")
    try:
        from .viewer import read_heights

        heights = read_heights(arguments.file)
        try:
            from .server import Page
        except ImportError as error:
            sys.exit(f"vtkterrain: the browser needs more packages ({error}): pip install 'vtkterrain[browser]'")
        page = Page(heights, os.path.basename(os.path.normpath(arguments.file)))
        page.start(arguments.host, arguments.port, not arguments.no_browser,
                   lambda address: print(address, flush=True))
    except (OSError, RuntimeError, ValueError) as error:
        sys.exit(f"vtkterrain: {error}")


if __name__ == "__main__":
    main()
