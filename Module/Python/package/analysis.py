# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""What terrain hides and how it leans, sample by sample: arrays of rows from the south, and columns.

All functions take heights as ``heights_from_array`` and ``vtkTerrainRasterReader`` make them, in metres;
heights of longitude and latitude get the width of their cells from their own latitude. The results are
float32 with NaN where there is no answer. docs/analysis.md has methods and sources.
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._intake import _run
from .heights import array_from_heights
from .places import Placement
from .vtkTerrain import vtkTerrainGeoreference, vtkTerrainHorizon, vtkTerrainViewshed

_ECCENTRICITY2 = 0.00669438  # of WGS84
_FARTHEST_NORTH = 89.9  # degrees: cells keep a width


def is_in_degrees(heights):
    """Whether heights lie in longitude and latitude."""
    reference = vtkTerrainGeoreference()
    reference.SetFromHeights(heights)
    return reference.IsGeographic()


def _widths(heights):
    """Width of a cell in metres, of each row from the south."""
    rows, step = heights.GetDimensions()[1], heights.GetSpacing()[0]
    if not is_in_degrees(heights):
        return np.full(rows, step)
    placement = Placement(heights)
    y = np.linspace(*heights.GetBounds()[2:4], rows)
    latitudes = placement.to_coordinates(np.column_stack([np.zeros(rows), y]))[:, 1]

    def circle(latitude):
        phi = np.radians(np.clip(latitude, -_FARTHEST_NORTH, _FARTHEST_NORTH))
        return np.cos(phi) / np.sqrt(1.0 - _ECCENTRICITY2 * np.sin(phi)**2)

    return step * circle(latitudes) / circle(placement.to_coordinates(np.zeros((1, 2)))[0, 1])


def _windows(heights):
    """Heights round each inner sample as [row][column] from the south-west, double; NaN for no data."""
    samples = array_from_heights(heights).astype(np.float64)
    samples[~(np.abs(samples) < 1e30)] = np.nan
    rows, columns = samples.shape
    return [[samples[j:max(rows - 2 + j, j), i:max(columns - 2 + i, i)] for i in range(3)] for j in range(3)]


def _from_inner(heights, values, window):
    """A value for each sample of what was found for inner ones whose neighbours all have heights."""
    result = np.full(heights.GetDimensions()[1::-1], np.nan, np.float32)
    has_all = np.isfinite(sum(samples for row in window for samples in row))
    if min(result.shape) > 2:
        result[1:-1, 1:-1] = np.where(has_all, values, np.nan)
    return result


def _slopes(heights, window):
    """Rise to the east and to the north over 3 x 3 samples (B. K. P. Horn, Proc. IEEE 69, 1981)."""
    (sw, s, se), (w, _, e), (nw, n, ne) = window
    east = (se + 2 * e + ne - sw - 2 * w - nw) / (8.0 * _widths(heights)[1:-1, None])
    return east, (nw + 2 * n + ne - sw - 2 * s - se) / (8.0 * heights.GetSpacing()[1])


def slope(heights):
    """Angle of the surface with the horizontal in degrees, 0 to 90, by Horn's method."""
    window = _windows(heights)
    return _from_inner(heights, np.degrees(np.arctan(np.hypot(*_slopes(heights, window)))), window)


def aspect(heights):
    """Where the surface goes down, degrees clockwise from grid north, 0 to 360; NaN where it is level."""
    window = _windows(heights)
    east, north = _slopes(heights, window)
    degrees = np.degrees(np.arctan2(-east, -north)) % 360.0
    return _from_inner(heights, np.where((east == 0) & (north == 0), np.nan, degrees), window)


def curvature(heights):
    """Curvature along and across the slope, each 1/m, 0 on level ground; positive where hollow.

    By the quadric of L. W. Zevenbergen and C. R. Thorne, Earth Surf. Process. Landforms 12, 1987.
    """
    window = _windows(heights)
    (sw, s, se), (w, here, e), (nw, n, ne) = window
    width, length = _widths(heights)[1:-1, None], heights.GetSpacing()[1]
    xx = (0.5 * (w + e) - here) / width**2
    yy = (0.5 * (s + n) - here) / length**2
    xy = (ne - nw - se + sw) / (4.0 * width * length)
    x, y = (e - w) / (2.0 * width), (n - s) / (2.0 * length)
    steepness = x**2 + y**2

    def along(a, b):
        part = 2.0 * (xx * a * a + yy * b * b + xy * a * b)
        return np.divide(part, steepness, out=np.where(np.isnan(part), np.nan, 0.0), where=steepness > 0)

    return _from_inner(heights, along(x, y), window), _from_inner(heights, along(-y, x), window)


def ruggedness(heights):
    """Root of the sum of squared differences to the eight neighbours (S. J. Riley et al., 1999), metres."""
    window = _windows(heights)
    return _from_inner(heights, np.sqrt(sum((part - window[1][1])**2 for row in window for part in row)), window)


def _point_array(algorithm, name):
    output = algorithm.GetOutput()
    values = vtk_to_numpy(output.GetPointData().GetArray(name))
    values = values.reshape(*output.GetDimensions()[1::-1], -1)
    return values[::-1] if output.GetDirectionMatrix().GetElement(1, 1) < 0 else values


def _update(algorithm):
    _run(algorithm, algorithm.Update)
    if algorithm.GetErrorMessage():
        raise ValueError(algorithm.GetErrorMessage())


def _set_earth(algorithm, eye_height, curvature, refraction):
    algorithm.SetEyeHeight(eye_height)
    algorithm.SetCurvature(curvature)
    algorithm.SetRefraction(refraction)


def _horizon(heights, directions, eye_height, curvature, refraction):
    filter_ = vtkTerrainHorizon()
    filter_.SetInputData(heights)
    filter_.SetNumberOfDirections(directions)
    _set_earth(filter_, eye_height, curvature, refraction)
    return filter_


def horizon(heights, directions=16, *, eye_height=0.0, curvature=False, refraction=0.13):
    """Elevation of the horizon in degrees, rows x columns x directions (``vtkTerrainHorizon``).

    Direction k looks to azimuth 360 k / ``directions``, clockwise from grid north.
    """
    filter_ = _horizon(heights, directions, eye_height, curvature, refraction)
    filter_.OutputSkyViewOff()
    _update(filter_)
    return _point_array(filter_, "Horizon")


def sky_view(heights, directions=16, *, eye_height=0.0, curvature=False, refraction=0.13):
    """Share of an even sky's light on a level plate, 0 to 1 (``vtkTerrainHorizon``)."""
    filter_ = _horizon(heights, directions, eye_height, curvature, refraction)
    filter_.OutputHorizonOff()
    _update(filter_)
    return _point_array(filter_, "SkyView")[..., 0]


def sunlight(heights, date, *, time_step=10.0, turbidity=3.0, eye_height=0.0, curvature=False, refraction=0.13):
    """The direct sun of a day, "2024-06-21", on each sample, a dict (``vtkTerrainHorizon``).

    "hours" of sun, "first" and "last" in hours UTC since the date began, and "irradiation" of a clear
    sky on the surface, Wh/m^2. The heights need a CRS.
    """
    filter_ = _horizon(heights, 1, eye_height, curvature, refraction)
    filter_.OutputHorizonOff()
    filter_.OutputSkyViewOff()
    filter_.SetDate(str(date))
    filter_.SetTimeStep(time_step)
    filter_.SetTurbidity(turbidity)
    _update(filter_)
    names = {"hours": "SunHours", "first": "FirstSun", "last": "LastSun", "irradiation": "DirectIrradiation"}
    return {key: _point_array(filter_, name)[..., 0] for key, name in names.items()}


def viewshed(heights, observers, *, eye_height=1.75, target_height=0.0, max_distance=None, curvature=False,
             refraction=0.13):
    """How many observers see each sample, uint32 (``vtkTerrainViewshed``).

    ``observers`` are N x 2 coordinates in the heights' own system, or a GeoPandas frame of points. Each
    stands on the ground; ``max_distance`` is in metres. Heights in degrees are refused.
    """
    if is_in_degrees(heights):
        raise ValueError("a viewshed needs heights in a metric CRS, these are in degrees: reproject them, "
                         "with rioxarray by data.rio.reproject(data.rio.estimate_utm_crs())")
    points = Placement(heights).place(observers) if len(observers) else observers
    if not len(points) or not np.isfinite(points).all():
        raise ValueError("observers must be places on the map of the heights")
    coordinates = vtkPoints()
    coordinates.SetDataTypeToDouble()
    coordinates.SetData(numpy_to_vtk(np.column_stack([points, np.zeros(len(points))]), deep=True))
    stand = vtkPolyData()
    stand.SetPoints(coordinates)
    filter_ = vtkTerrainViewshed()
    filter_.SetInputData(heights)
    filter_.SetInputData(1, stand)
    _set_earth(filter_, eye_height, curvature, refraction)
    filter_.SetTargetHeight(target_height)
    if max_distance is not None:
        filter_.SetDistanceRange(0.0, max_distance)
    _update(filter_)
    return _point_array(filter_, "Observers")[..., 0]
