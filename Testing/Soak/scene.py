# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""A session in Python: random settings, views and files, one frame after another.

    python3 Testing/Soak/scene.py FOLDER --minutes M --seed N       FOLDER has the files of files.py
    python3 Testing/Soak/scene.py --break                           makes one error of OpenGL, and ends

The seed decides all but the number of steps. What it does is on standard output, a line a step; `rest N` is the
resident memory in kB while nothing but a small terrain is open. What it says on standard error is a finding.
"""
import argparse
import ctypes
import gc
import pathlib
import random
import resource
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkLight, vtkRenderer, vtkRenderWindow

from vtkterrain import (
    heights_from_array,
    vtkTerrainActor,
    vtkTerrainColors,
    vtkTerrainDetailSource,
    vtkTerrainLook,
    vtkTerrainPicker,
)

STEPS_BETWEEN_RESTS = 20
SMALL = (160, 120)
TECHNIQUES = [getattr(vtkTerrainLook.Techniques, name)
              for name in ("Mesh", "Linear", "Exponential", "Equidistant", "Pyramid", "Strips")]
SOURCES = [getattr(vtkTerrainLook.ColorSources, name) for name in ("Array", "Height", "Slope", "Aspect")]
PYRAMID = vtkTerrainLook.Techniques.Pyramid
FILES = ("small.img", "middle.img", "prepared.hierarchy", "large.img")


def resident():
    """Resident memory of this process in kB, after the allocator has given back what it can."""
    ctypes.CDLL(None).malloc_trim(0)
    pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * resource.getpagesize() // 1024


class Session:
    """A window with a terrain, and what may be done to it: methods whose names begin with `do_`."""

    def __init__(self, folder, seed):
        self.folder = pathlib.Path(folder)
        self.random = random.Random(seed)
        self.terrain = None
        self.is_large = False
        self.open_window()
        self.open_file("small.img")
        self.actions = sorted(name for name in dir(self) if name.startswith("do_"))

    def open_window(self):
        """A window of its own context, with a sun."""
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.5, 0.6, 0.8)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SMALL)
        self.window.AddRenderer(self.renderer)
        sun = vtkLight()
        sun.SetLightTypeToSceneLight()
        sun.SetPosition(-1.0, 1.0, 1.2)
        self.renderer.AddLight(sun)
        if self.terrain is not None:
            self.renderer.AddActor(self.terrain)

    def take(self, terrain, is_large=False):
        """Draws this terrain in place of the last one."""
        if self.terrain is not None:
            self.renderer.RemoveActor(self.terrain)
        self.terrain, self.is_large = terrain, is_large
        self.renderer.AddActor(terrain)
        self.look_at_all()

    def open_file(self, name):
        """A terrain of a file of the folder, as it comes."""
        terrain = vtkTerrainActor()
        if not terrain.SetFileName(str(self.folder / name)):
            raise OSError(terrain.GetErrorMessage())
        self.take(terrain, name == "large.img")

    def look_at_all(self):
        """From the south, above."""
        camera = self.renderer.GetActiveCamera()
        camera.SetParallelProjection(False)
        camera.SetPosition(0.0, -1.0, 0.7)
        camera.SetFocalPoint(0.0, 0.0, 0.0)
        camera.SetViewUp(0.0, 0.0, 1.0)
        self.renderer.ResetCamera()

    def rest(self):
        """The resident memory in kB with a new window and a small terrain."""
        self.window.SetSize(*SMALL)
        self.do_another_window()
        self.open_file("small.img")
        self.window.Render()
        gc.collect()
        return resident()

    # what may be done, by name in a random order

    def do_file(self):
        self.open_file(self.random.choice(FILES))

    def do_file_of_the_same_terrain(self):
        name = self.random.choice(FILES)
        if name == "large.img":
            self.terrain.SetTechnique(PYRAMID)
            self.terrain.GetTerrainMapper().SetDetailData(None)
        self.is_large = name == "large.img"
        if not self.terrain.SetFileName(str(self.folder / name)):
            raise OSError(self.terrain.GetErrorMessage())
        self.terrain.GetTerrainMapper().ExtractAll()
        self.look_at_all()

    def do_array(self):
        rows, columns = self.random.randint(2, 300), self.random.randint(2, 300)
        x, y = np.meshgrid(np.linspace(0.0, 9.0, columns), np.linspace(0.0, 7.0, rows))
        heights = (self.random.uniform(1.0, 900.0) * np.sin(x) * np.cos(y)).astype(np.float32)
        terrain = vtkTerrainActor()
        terrain.SetInputData(heights_from_array(heights, (30.0, 30.0)))
        self.take(terrain)

    def do_other_samples(self):
        heights = self.terrain.GetHeights()
        if heights is None or self.is_large:
            return
        columns, rows, _ = heights.GetDimensions()
        samples = vtk_to_numpy(heights.GetPointData().GetScalars()).reshape(rows, columns)
        first = self.random.randrange(rows), self.random.randrange(columns)
        part = samples[first[0]:first[0] + 9, first[1]:first[1] + 9]
        part += np.float32(self.random.uniform(-5.0, 5.0))
        self.terrain.GetTerrainMapper().HeightsModified(
            first[1], first[1] + part.shape[1] - 1, first[0], first[0] + part.shape[0] - 1)

    def do_technique(self):
        if not self.is_large:  # the others draw a level of it, and say so
            self.terrain.SetTechnique(self.random.choice(TECHNIQUES))

    def do_exaggeration(self):
        self.terrain.SetVerticalExaggeration(self.random.uniform(0.2, 6.0))

    def do_contours(self):
        mapper = self.terrain.GetTerrainMapper()
        mapper.SetContours(self.random.random() < 0.7)
        mapper.SetContourInterval(self.random.choice((5.0, 20.0, 100.0)))
        mapper.SetContourIndex(self.random.choice((0, 5)))
        mapper.SetContourWidth(self.random.uniform(0.5, 4.0))

    def do_colors(self):
        self.terrain.GetTerrainMapper().SetColorSource(self.random.choice(SOURCES))
        self.terrain.SetColorByHeight(self.random.random() < 0.8)

    def do_lookup_table(self):
        colors = vtkTerrainColors()
        colors.SetScheme(colors.GetSchemeName(self.random.randrange(colors.GetNumberOfSchemes())))
        low_high = [0.0, 0.0]
        self.terrain.GetHeightRange(low_high)
        table = vtkColorTransferFunction()
        colors.FillTable(table, *low_high)
        self.terrain.SetLookupTable(table)

    def do_hillshade(self):
        mapper = self.terrain.GetTerrainMapper()
        mapper.SetHillshade(self.random.random() < 0.5)
        mapper.SetHillshadeAzimuth(self.random.uniform(0.0, 360.0))
        self.terrain.GetProperty().SetLighting(not mapper.GetHillshade())

    def do_shadows(self):
        self.terrain.SetSunShadows(self.random.random() < 0.5)
        self.terrain.SetSunAngle(self.random.choice((0.0, 0.53, 5.0)))
        self.terrain.SetSkyLight(self.random.choice((0.0, 0.0, 0.6)))

    def do_sun(self):
        sun = self.renderer.GetLights().GetItemAsObject(0)
        sun.SetPosition(*(self.random.uniform(-1.0, 1.0) for _ in "xy"), self.random.uniform(0.1, 1.0))

    def do_block(self):
        mapper = self.terrain.GetTerrainMapper()
        low_high = [0.0, 0.0]
        self.terrain.GetHeightRange(low_high)
        mapper.SetBlock(self.random.random() < 0.5)
        mapper.SetBlockBase(low_high[0] - self.random.uniform(1.0, 500.0))

    def do_drape(self):
        rows, columns = self.random.randint(1, 200), self.random.randint(1, 200)
        look = self.terrain.GetTerrainMapper().GetLook()
        if self.random.random() < 0.4:
            look.SetDrape(None)
            return
        picture = vtkImageData()
        picture.SetDimensions(columns, rows, 1)
        pixels = np.random.default_rng(rows).integers(0, 256, (rows * columns, 4), np.uint8)
        picture.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
        bounds = self.terrain.GetBounds()
        look.SetDrape(picture, bounds[:4])

    def do_detail(self):
        mapper = self.terrain.GetTerrainMapper()
        if self.is_large or self.random.random() < 0.5:
            mapper.SetDetailData(None)
            return
        source = vtkTerrainDetailSource()
        source.SetSize(self.random.choice((32, 64)))
        source.SetSeed(self.random.randrange(9))
        source.Update()
        mapper.SetDetailData(source.GetOutput())

    def do_part(self):
        heights = self.terrain.GetHeights()
        if heights is None or self.is_large or self.random.random() < 0.5:
            self.terrain.GetTerrainMapper().ExtractAll()
            return
        size = heights.GetDimensions()[:2]
        first = [self.random.randrange(max(each - 1, 1)) for each in size]
        last = [self.random.randint(begin + 1, max(each - 1, begin + 1)) for begin, each in zip(first, size)]
        self.terrain.GetTerrainMapper().SetExtract(first, last)

    def do_tolerance(self):
        self.terrain.GetTerrainMapper().SetPixelTolerance(self.random.choice((0.0, 0.5, 2.0)))
        self.terrain.GetStrips().SetTolerance(self.random.choice((0.5, 1.0, 4.0)))
        self.terrain.GetTerrainMapper().SetUseBeams(self.random.random() < 0.5)
        self.terrain.GetTerrainMapper().SetShowCrossings(self.random.random() < 0.2)

    def do_opacity(self):
        self.terrain.GetProperty().SetOpacity(self.random.choice((1.0, 1.0, 0.5)))

    def do_camera(self):
        camera = self.renderer.GetActiveCamera()
        camera.Azimuth(self.random.uniform(-60.0, 60.0))
        camera.Dolly(self.random.uniform(0.6, 1.6))
        camera.SetViewAngle(self.random.uniform(10.0, 70.0))
        camera.SetParallelProjection(self.random.random() < 0.2)

    def do_fly(self):
        bounds = self.terrain.GetBounds()
        camera = self.renderer.GetActiveCamera()
        place = [self.random.uniform(bounds[2 * axis], bounds[2 * axis + 1]) for axis in range(2)]
        aim = [self.random.uniform(bounds[2 * axis], bounds[2 * axis + 1]) for axis in range(2)]
        camera.SetPosition(*place, bounds[5] + 0.02 * (bounds[1] - bounds[0]))
        camera.SetFocalPoint(*aim, bounds[4])
        camera.SetViewUp(0.0, 0.0, 1.0)
        self.renderer.ResetCameraClippingRange()

    def do_view_of_all(self):
        self.look_at_all()

    def do_resize(self):
        self.window.SetSize(self.random.randint(1, 320), self.random.randint(1, 240))

    def do_another_window(self):
        self.renderer.RemoveActor(self.terrain)
        self.window.Finalize()
        self.open_window()
        self.look_at_all()

    def do_pick(self):
        width, height = self.window.GetSize()
        picker = vtkTerrainPicker()
        picker.Pick(self.random.uniform(0, width), self.random.uniform(0, height), 0.0, self.renderer)
        if picker.IsTerrainPicked() and not np.isfinite(picker.GetPickPosition()).all():
            print("A pick is nowhere", file=sys.stderr)

    def do_mesh_of_the_surface(self):
        if not self.is_large and self.terrain.GetSurfaceActor() is not None:
            self.terrain.GetSurface()

    def do_print(self):
        str(self.terrain)
        str(self.terrain.GetTerrainMapper())


def break_opengl():
    """One error of OpenGL in a window, which Mesa tells on standard error."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.Render()
    window.MakeCurrent()
    egl = ctypes.CDLL("libEGL.so.1")
    egl.eglGetProcAddress.restype = ctypes.c_void_p
    bind = ctypes.CFUNCTYPE(None, ctypes.c_uint, ctypes.c_uint)(egl.eglGetProcAddress(b"glBindTexture"))
    bind(0x1908, 0)  # GL_RGBA is no target


def main():
    """Runs a session for its minutes."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", nargs="?")
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--break", dest="breaks", action="store_true")
    options = parser.parse_args()
    if options.breaks:
        break_opengl()
        return
    session = Session(options.folder, options.seed)
    end = time.monotonic() + 60.0 * options.minutes
    step = 0
    while time.monotonic() < end:
        step += 1
        action = session.random.choice(session.actions)
        print(step, action, flush=True)
        getattr(session, action)()
        session.window.Render()
        if step % STEPS_BETWEEN_RESTS == 0:
            print("rest", session.rest(), flush=True)


if __name__ == "__main__":
    main()
