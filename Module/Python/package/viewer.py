# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""A terrain, its camera and its settings, drawn into memory: what the page of server.py shows."""
import math
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkLight,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

from . import _supply
from ._colors import sample_colors, scheme_names
from ._intake import _run, make_reader
from .places import Placement
from .vtkTerrain import vtkTerrainActor, vtkTerrainColors, vtkTerrainPicker

TECHNIQUES = ("Pyramid", "Linear", "Exponential", "Equidistant", "Mesh")
COLORS = ("relief", "grey", "heat", "plain")
_STOPS = {"grey": ((0.1, 0.1, 0.1), (1.0, 1.0, 1.0)),
          "heat": ((0.1, 0.0, 0.2), (0.7, 0.1, 0.4), (1.0, 0.6, 0.1), (1.0, 1.0, 0.8))}
_SECONDS_OF_A_HASTY_PICTURE = 0.045
_SMALLEST_SHARE = 0.35  # of the width, in a hasty picture
_WHOLE = 0.92  # of the free part of a picture: how far a view of all reaches
_STEEPEST, _FLATTEST = 89.0, -10.0  # degrees of the camera above the horizon


def read_heights(path, **place):
    """The heights of a file; ``place`` are options of ``make_reader``. Raises OSError with a sentence."""
    reader = make_reader(path, **place)
    _run(reader, reader.Update)
    if reader.GetErrorMessage():
        raise OSError(reader.GetErrorMessage())
    return reader.GetOutput()


def round_interval(extent):
    """A distance of contour lines, 1, 2 or 5 times a power of ten, about a fifteenth of an extent."""
    wanted = max(extent, 1e-9) / 15.0
    power = 10.0 ** math.floor(math.log10(wanted))
    return next(step * power for step in (1.0, 2.0, 5.0, 10.0) if step * power >= wanted)


class Viewer:
    """Draws heights, a ``vtkImageData``, as its settings say."""

    def __init__(self, heights):
        reason = _supply.why_no_opengl()
        if reason:
            raise RuntimeError(reason)
        self.placement = Placement(heights)
        self.terrain = vtkTerrainActor()
        self.terrain.SetInputData(heights)
        if not self.terrain.HasSurface():
            raise ValueError("there is no surface to draw: no four neighbouring samples all have heights")
        self._relief = self.terrain.GetLookupTable()
        self._range = self._relief.GetRange()
        self.terrain.GetTerrainMapper().SetContourInterval(round_interval(self._range[1] - self._range[0]))
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.90, 0.93, 0.95)
        self.renderer.SetBackground2(0.50, 0.66, 0.84)
        self.renderer.GradientBackgroundOn()
        self.renderer.AddActor(self.terrain)
        self.renderer.AutomaticLightCreationOff()
        self._sun = vtkLight()
        self._sun.SetLightTypeToSceneLight()
        self._sun.PositionalOff()
        self.renderer.AddLight(self._sun)
        sky = vtkLight()
        sky.SetLightTypeToHeadlight()
        sky.SetIntensity(0.25)
        self.renderer.AddLight(sky)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.AddRenderer(self.renderer)
        self._capture = vtkWindowToImageFilter()
        self._capture.SetInput(self.window)
        self._capture.ReadFrontBufferOff()
        self._capture.ShouldRerenderOff()
        self._size = (800, 600)
        self._covered = 0
        self._is_whole = True
        self._share = 1.0
        self.set_sun(315.0, 45.0)
        self.reset_view()

    def set_exaggeration(self, factor):
        """Drawn height over true height, above 0. The middle of the view stays on the ground."""
        before = self.terrain.GetVerticalExaggeration()
        self.terrain.SetVerticalExaggeration(factor)
        camera = self.renderer.GetActiveCamera()
        x, y, z = camera.GetFocalPoint()
        self._move(0.0, 0.0, z * (factor / before - 1.0))

    def set_technique(self, name):
        """One of TECHNIQUES."""
        self.terrain.SetTechnique(getattr(type(self.terrain.GetTechnique()), name))

    def set_colors(self, name):
        """One of COLORS ("plain" is one colour for all heights), or any that ``sample_colors`` knows.

        Land of a scheme with a sea begins at 0, as in terrain-render.
        """
        table = vtkColorTransferFunction()
        schemes = vtkTerrainColors()
        if name in ("relief", "plain"):
            table = self._relief
        elif name not in COLORS and name in scheme_names():
            schemes.SetScheme(name)
            schemes.FillTable(table, *self._range)
        else:
            stops = _STOPS[name] if name in _STOPS else sample_colors(name)
            for place, color in zip(np.linspace(*self._range, len(stops)), stops):
                table.AddRGBPoint(place, *color)
        self.terrain.SetColorByHeight(name != "plain")
        self.terrain.SetLookupTable(table)

    def set_contours(self, show):
        """Whether contour lines are drawn, as far apart as fits the heights."""
        self.terrain.GetTerrainMapper().SetContours(bool(show))

    def set_sun(self, azimuth, altitude):
        """Where the light comes from: degrees clockwise from north, and above the horizon."""
        azimuth, altitude = math.radians(azimuth), math.radians(altitude)
        self._sun.SetFocalPoint(0.0, 0.0, 0.0)
        self._sun.SetPosition(math.sin(azimuth) * math.cos(altitude), math.cos(azimuth) * math.cos(altitude),
                              math.sin(altitude))

    def reset_view(self):
        """Looks at all of it from the south, from 35 degrees above."""
        camera = self.renderer.GetActiveCamera()
        bounds = np.reshape(self.terrain.GetBounds(), (3, 2))
        middle = bounds.mean(axis=1)
        corners = np.stack(np.meshgrid(*bounds), axis=-1).reshape(-1, 3) - middle
        back = np.array([0.0, -math.cos(math.radians(35.0)), math.sin(math.radians(35.0))])
        width, height = self._size
        half = math.tan(math.radians(camera.GetViewAngle()) / 2.0)
        seen = np.abs([corners[:, 0] * height / (width - self._covered), corners @ (0.0, -back[2], back[1])])
        distance = (corners @ back + seen.max(axis=0) / (half * _WHOLE)).max()
        camera.SetFocalPoint(middle)
        camera.SetPosition(middle + distance * back)
        camera.SetViewUp(0.0, 0.0, 1.0)
        camera.SetWindowCenter(self._covered / width, 0.0)
        self._is_whole = True

    def cover(self, pixels):
        """How much of the picture, from its right border, something lies on."""
        self._covered = pixels
        self._fit()

    def _fit(self):
        if self._covered > 0.5 * self._size[0]:
            self._covered = 0
        if self._is_whole:
            self.reset_view()
        else:
            self.renderer.GetActiveCamera().SetWindowCenter(self._covered / self._size[0], 0.0)

    def _move(self, x, y, z):
        camera = self.renderer.GetActiveCamera()
        for place, setter in ((camera.GetPosition(), camera.SetPosition),
                              (camera.GetFocalPoint(), camera.SetFocalPoint)):
            setter(place[0] + x, place[1] + y, place[2] + z)

    def turn(self, right, up):
        """Turns the camera round the middle of the view, by degrees; the horizon stays level."""
        self._is_whole = False
        camera = self.renderer.GetActiveCamera()
        camera.Azimuth(-right)
        focus, eye = np.array(camera.GetFocalPoint()), np.array(camera.GetPosition())
        distance = np.linalg.norm(eye - focus)
        altitude = math.degrees(math.asin(np.clip((eye - focus)[2] / distance, -1.0, 1.0)))
        camera.Elevation(np.clip(altitude - up, _FLATTEST, _STEEPEST) - altitude)
        camera.SetViewUp(0.0, 0.0, 1.0)

    def pan(self, right, up):
        """Moves the terrain with the pointer, in parts of the picture's height."""
        self._is_whole = False
        camera = self.renderer.GetActiveCamera()
        focus, eye = np.array(camera.GetFocalPoint()), np.array(camera.GetPosition())
        scale = 2.0 * np.linalg.norm(eye - focus) * math.tan(math.radians(camera.GetViewAngle()) / 2.0)
        ahead = (focus - eye)[:2] / max(np.linalg.norm((focus - eye)[:2]), 1e-12)
        x, y = -right * scale * np.array([ahead[1], -ahead[0]]) - up * scale * ahead
        self._move(x, y, 0.0)

    def zoom(self, factor):
        """Goes nearer to the middle of the view by a factor above 1, or farther from it."""
        self._is_whole = False
        self.renderer.GetActiveCamera().Dolly(np.clip(factor, 0.1, 10.0))

    def resize(self, width, height):
        """The size of a picture, in pixels."""
        self._size = (int(np.clip(width, 16, 4096)), int(np.clip(height, 16, 4096)))
        self._fit()

    @property
    def size(self):
        """Width and height of a picture that is drawn without haste."""
        return self._size

    def draw(self, hasty=False):
        """A picture: an array of rows from the top, columns and three colours.

        A hasty one is as much smaller and coarser as it takes to follow the pointer.
        """
        share = self._share if hasty else 1.0
        self.window.SetSize(*(max(16, round(length * share)) for length in self._size))
        self.window.SetDesiredUpdateRate(1.0 / _SECONDS_OF_A_HASTY_PICTURE if hasty else 0.0001)
        begin = time.perf_counter()
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        self._capture.Modified()
        self._capture.Update()
        if hasty:
            spent = time.perf_counter() - begin
            wanted = share * math.sqrt(_SECONDS_OF_A_HASTY_PICTURE / spent)
            self._share = float(np.clip(0.5 * (share + wanted), _SMALLEST_SHARE, 1.0))
        image = self._capture.GetOutput()
        columns, rows, _ = image.GetDimensions()
        pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)
        return np.ascontiguousarray(pixels[::-1])

    def describe(self, column, row):
        """What is at a pixel, counted from the lower left corner, in words; empty where it is the sky."""
        self.window.SetSize(*self._size)
        picker = vtkTerrainPicker()
        picker.Pick(column, row, 0.0, self.renderer)
        if not picker.IsTerrainPicked():
            return ""
        x, y, _ = picker.GetMapperPosition()
        return self.placement.describe(x, y, picker.GetHeight())
