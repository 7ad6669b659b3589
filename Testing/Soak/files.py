# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the files of the soak in a folder: rasters, one of them drawn from tiles, a prepared file and pictures."""
import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vtkterrain import vtkTerrainHierarchy, vtkTerrainSource

LARGE = 17000  # samples a side: more than a texture has
SIZES = {"small": (65, 49), "middle": (513, 400), "large": (LARGE, 700)}


def landscape(columns, rows, seed):
    """Heights of the built-in landscape in metres, rows from the south."""
    source = vtkTerrainSource()
    source.SetDimensions(columns, rows)
    source.SetSeed(seed)
    source.Update()
    image = source.GetOutput()
    return image, vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns)


def write_raster(path, samples):
    """An ENVI raster in UTM zone 45 north, 30 m: samples as they are and a text beside them."""
    rows, columns = samples.shape
    samples[::-1].tofile(path)
    kinds = {"int16": 2, "float32": 4}
    path.with_suffix(".hdr").write_text(
        f"ENVI\nsamples = {columns}\nlines = {rows}\nbands = 1\nheader offset = 0\nfile type = ENVI Standard\n"
        f"data type = {kinds[samples.dtype.name]}\ninterleave = bsq\nbyte order = 0\n"
        "map info = {UTM, 1, 1, 493000, 3095000, 30, 30, 45, North, WGS-84}\n", encoding="ascii")


def main():
    """Makes what is not there yet."""
    folder = pathlib.Path(sys.argv[1])
    for seed, (name, (columns, rows)) in enumerate(SIZES.items(), 1):
        path = folder / f"{name}.img"
        if path.exists():
            continue
        image, heights = landscape(columns, rows, seed)
        write_raster(path, heights.astype(np.int16 if name == "large" else np.float32))
        if name == "middle":
            hierarchy = vtkTerrainHierarchy()
            hierarchy.SetHeights(image)
            if not hierarchy.WriteFile(str(folder / "prepared.hierarchy")):
                sys.exit(hierarchy.GetErrorMessage())


if __name__ == "__main__":
    main()
