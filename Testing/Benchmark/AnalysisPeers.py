# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""terrain-analyze beside GRASS, GDAL and topocalc, whole processes by turns, as processor time.

  AnalysisPeers.py PROGRAM DEM [TIMES]        default 3

PROGRAM is terrain-analyze, DEM a raster of samples as wide as high, in metres. Prints medians in seconds,
with the smallest and the largest, and their ratios to ours; then how far the peers' results are from ours.
Takes rasterio; what of r.horizon, r.viewshed (GRASS), gdal_viewshed and the Python package topocalc is not
there is left out. TOPOCALC names a Python that has topocalc, if this one has not.
"""
import os
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

import numpy as np
import rasterio

_DIRECTIONS = 16
_EYE = 1.75
# hcos of 16 directions; topocalc counts azimuths from south, through east
_TOPOCALC = """
import sys, numpy as np, rasterio
from topocalc.horizon import horizon
with rasterio.open(sys.argv[1]) as file:
    heights, step = file.read(1).astype(float), file.res[0]
found = []
for k in range(16):
    azimuth = 180.0 - 22.5 * k
    found.append(np.degrees(np.pi / 2 - np.arccos(horizon(azimuth, heights, step))).astype(np.float32))
np.save(sys.argv[2], found)
"""


def processor_seconds(command):
    """Runs a command; its processor time, that of its children included."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def take_turns(commands, times):
    """Prints the medians of commands, the first ours, and their ratios to it."""
    took = {name: [] for name in commands}
    for _ in range(times):
        for name, command in commands.items():
            took[name].append(processor_seconds(command))
    ours = statistics.median(next(iter(took.values())))
    for name, seconds in took.items():
        median = statistics.median(seconds)
        print(f"{name}: {median:.3g} s ({min(seconds):.3g} to {max(seconds):.3g}), {median / ours:.3g} times ours",
              flush=True)


def grass(folder, script):
    """A command that runs a script in a GRASS session whose raster 'dem' and region are those of the DEM."""
    path = folder / f"{abs(hash(script))}.sh"
    path.write_text(script, encoding="utf-8")
    return ["grass", folder / "grass" / "PERMANENT", "--exec", "sh", path]


def prepare_grass(folder, dem):
    """A location of GRASS that holds the DEM."""
    subprocess.run(["grass", "-c", dem, "-e", folder / "grass"], check=True, capture_output=True)
    processor_seconds(grass(folder, f"r.in.gdal -o --quiet input={dem} output=dem; g.region raster=dem"))


def topocalc_python():
    """A Python that has topocalc; None."""
    python = os.environ.get("TOPOCALC", sys.executable)
    found = subprocess.run([python, "-c", "import topocalc, rasterio"], check=False, capture_output=True)
    return python if found.returncode == 0 else None


def compare_horizons(program, dem, folder, times):
    """Times of 16 directions, and how far the peers are apart from ours, in degrees."""
    print(f"horizon, {_DIRECTIONS} directions")
    ours = folder / "horizon.tif"
    commands = {"terrain-analyze": [program, "horizon", dem, "--quiet", "--directions", str(_DIRECTIONS),
                                    "--output", ours]}
    python = topocalc_python()
    if python:
        commands["topocalc"] = [python, "-c", _TOPOCALC, dem, folder / "horizon.npy"]
    if shutil.which("grass"):
        commands["GRASS, start alone"] = grass(folder, "true")
        commands["r.horizon"] = grass(
            folder, f"r.horizon --overwrite --quiet -d elevation=dem step={360 / _DIRECTIONS} output=horizon\n")
    take_turns(commands, times)
    with rasterio.open(ours) as file:
        exact = file.read()
    if python:
        # it knows no angles below the horizontal
        apart = np.abs(np.load(folder / "horizon.npy") - np.maximum(exact, 0.0))
        print(f"topocalc apart from ours: median {np.median(apart):.2g}, 99 % {np.percentile(apart, 99):.3g} degrees")


def compare_viewsheds(program, dem, folder, times):
    """Times of one observer in the middle, and the share of cells seen by either that differ."""
    with rasterio.open(dem) as file:
        place = file.xy(file.height // 2, file.width // 2)
    print("viewshed, one observer")
    outputs = {name: folder / f"{name}.tif" for name in ("ours", "gdal", "cog", "grass")}
    x, y = map(str, place)
    commands = {
        "terrain-analyze": [program, "viewshed", dem, "--quiet", "--eye-height", str(_EYE), "--observer", f"{x},{y}",
                            "--output", outputs["ours"]],
        "gdal_viewshed": ["gdal_viewshed", "-q", "-oz", str(_EYE), "-ox", x, "-oy", y, "-cc", "0", dem,
                          outputs["gdal"]],
        "gdal_translate of that to a COG": ["gdal_translate", "-q", "-of", "COG", outputs["gdal"], outputs["cog"]],
    }
    if shutil.which("grass"):
        commands["r.viewshed"] = grass(
            folder, f"r.viewshed --overwrite --quiet -b input=dem output=seen coordinates={x},{y} "
            f"observer_elevation={_EYE} memory=4000\n")
    take_turns(commands, times)
    if shutil.which("grass"):
        processor_seconds(grass(folder, f"r.out.gdal --quiet --overwrite input=seen output={outputs['grass']}"))
    with rasterio.open(outputs["ours"]) as file:
        seen = file.read(1) > 0
    for name in ("gdal", "grass"):
        if outputs[name].exists():
            with rasterio.open(outputs[name]) as file:
                other = file.read(1) > 0
            either = np.count_nonzero(seen | other)
            print(f"{name} differs from ours in {100 * np.count_nonzero(seen ^ other) / either:.2f} % of the cells "
                  "that either sees")


def main():
    """Compares what is there."""
    program, dem = sys.argv[1], str(pathlib.Path(sys.argv[2]).resolve())
    times = int((sys.argv[3:4] or ["3"])[0])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if shutil.which("grass"):
            prepare_grass(folder, dem)
        compare_horizons(program, dem, folder, times)
        compare_viewsheds(program, dem, folder, times)


if __name__ == "__main__":
    main()
