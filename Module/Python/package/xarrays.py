# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""xarray's DataArrays as terrain, as rioxarray, odc-geo and CF conventions describe them.

Importing this module gives every DataArray ``.terrain``:

>>> import vtkterrain.xarrays
>>> rioxarray.open_rasterio("dem.tif", masked=True).terrain.plot(exaggeration=1.5)
"""
import numpy as np
import xarray

from . import analysis
from ._intake import describe_samples, lay_out, make_reader, read, tell_of_samples
from .heights import _fill_masked, _to_vtk_type, heights_from_array

_UNEVEN = 0.1  # of a step: what a coordinate may be off
_NAMES_OF_X = ("x", "lon", "longitude", "easting", "rlon")
_NAMES_OF_Y = ("y", "lat", "latitude", "northing", "rlat")


def _grid_mapping(data):
    """Attributes of the grid mapping (CF) or of rioxarray's coordinate; empty without."""
    names = [data.encoding.get("grid_mapping", data.attrs.get("grid_mapping")), "spatial_ref", "crs"]
    for name in names:
        if name is not None and name in data.coords:
            return dict(data.coords[name].attrs)
    return {}


def _coordinate_system(data, mapping):
    """CRS of a DataArray as text; None if it has none."""
    for key in ("crs_wkt", "spatial_ref"):
        if mapping.get(key):
            return str(mapping[key])
    system = data.attrs.get("crs")
    if system is not None:
        return system.to_wkt() if hasattr(system, "to_wkt") else str(system)
    return None


def _is_numeric(values):
    return np.issubdtype(values.dtype, np.number)


def _without_place(data, mapping):
    """The array without coordinates, row 0 in the south, if those are rioxarray's of a file without a place."""
    transform = [float(number) for number in str(mapping.get("GeoTransform", "")).split()]
    if transform != [0.0, 1.0, 0.0, 0.0, 0.0, 1.0] or _coordinate_system(data, mapping):
        return data
    return data.drop_vars([name for name in data.dims if name in data.coords])[::-1]


def _axis(data, dimension, name):
    if dimension not in data.coords:
        return name, {}, np.arange(data.sizes[dimension], dtype=float)
    coordinate = data.coords[dimension]
    if coordinate.size < 2:
        raise ValueError(f"{dimension} must have at least two coordinates")
    values = np.asarray(coordinate.values)
    return str(dimension), dict(coordinate.attrs), values if _is_numeric(values) else None


def _fields(data):
    """Coordinates with a value for each sample."""
    fields = []
    for name, coordinate in data.coords.items():
        if coordinate.ndim == 2 and set(coordinate.dims) == set(data.dims) and _is_numeric(coordinate):
            fields.append((str(name), dict(coordinate.attrs), coordinate.transpose(*data.dims).values))
    return fields


def _flatten(data):
    """The array with its two dimensions of places alone."""
    named = [name for name in data.dims if str(name).lower() in _NAMES_OF_X + _NAMES_OF_Y]
    data = data.squeeze([name for name in data.dims if name not in named and data.sizes[name] == 1])
    if data.ndim != 2:
        raise ValueError(f"heights must have two dimensions, not {data.dims}: select one of the others")
    return data


def _check_names(data, fields):
    for names in (_NAMES_OF_X, _NAMES_OF_Y):
        is_known = any(str(dimension).lower() in names or str(data.coords[dimension].attrs.get(
            "standard_name", "")) if dimension in data.coords else str(dimension).lower() in names
            for dimension in data.dims)
        if not is_known and not fields:
            raise ValueError(f"no dimension of {data.dims} is one of {', '.join(names)}")


def heights_from_dataarray(data, *, crs=None, nodata=None, height_unit=None, flip=False, scene=None):
    """A ``vtkImageData`` of heights from an ``xarray.DataArray``.

    The array has two dimensions of places and others of length 1 at most. What it holds is found as
    it is for the same data in a file (``vtkTerrainRasterReader``): place by coordinates, rising,
    falling, unevenly spaced or two-dimensional (``coordinates`` of CF), CRS by rioxarray's
    ``spatial_ref``, the grid mapping of CF or the attribute ``crs``, WGS84 for longitude and latitude
    without any; heights by the attributes ``scale_factor``, ``add_offset``, ``units``, ``positive``,
    ``standard_name``; holes by ``_FillValue``, ``missing_value``, NaN, and fill that nobody declares.
    Without coordinates samples lie 1 apart, the first row in the south, as xarray plots them; but of a file
    without a place that rioxarray has opened the first row lies in the north, as it does by name.

    Heights whose own grid is not in metres or not true to scale are resampled onto a metric grid
    round their middle (``vtkTerrainReproject``), or that of the scene. Others share the memory of the
    array where ``heights_from_array`` can. ``crs``, ``nodata``, ``height_unit`` and ``flip`` say what the
    array does not, as in ``heights_from_array``.
    """
    return lay_out(_own_heights(_flatten(data), crs, nodata, height_unit, flip), scene)


def _own_heights(data, crs=None, nodata=None, height_unit=None, flip=False):
    """Heights in metres in the grid that the array says."""
    fields = _fields(data)
    _check_names(data, fields)
    mapping = _grid_mapping(data)
    data = _without_place(data, mapping)
    axes = [_axis(data, dimension, name) for dimension, name in zip(data.dims, "yx")]
    system = _coordinate_system(data, mapping)
    samples = _to_vtk_type(_fill_masked(np.ma.asanyarray(data.values)
                                        if np.ma.isMaskedArray(data.values) else data.values))
    name = str(data.name or "Elevation")
    described = describe_samples(samples, data.name, crs=system, attributes=data.attrs, rows=axes[0],
                                 columns=axes[1], fields=fields, grid_mapping=mapping)
    reader = make_reader(described, crs=crs, nodata=nodata, height_unit=height_unit, flip=flip)
    if reader.GetSamplesAreHeights() and not flip:
        tell_of_samples(reader)
        return _share(samples, axes, name, crs or system)
    return read(reader, ValueError)


def _share(samples, axes, name, system):
    """An image of the samples in place, which are heights in an even grid of metres."""
    firsts, steps = [], []
    for axis, size in zip(axes, samples.shape):
        values = axis[2] if axis[2] is not None else np.arange(size)
        step = (float(values[-1]) - float(values[0])) / max(size - 1, 1)
        firsts.append(min(float(values[0]), float(values[-1])))
        steps.append(step)
    samples = samples[::1 if steps[0] > 0 else -1, ::1 if steps[1] > 0 else -1]
    return heights_from_array(samples, (abs(steps[1]), abs(steps[0])), (firsts[1], firsts[0]), name=name,
                              coordinate_system=system, nodata="none")


def _is_x(data, dimension):
    attributes = data.coords[dimension].attrs if dimension in data.coords else {}
    return (str(dimension).lower() in _NAMES_OF_X or attributes.get("axis") == "X"
            or attributes.get("standard_name") in ("longitude", "projection_x_coordinate", "grid_longitude"))


class _Grid:
    """The grid of a DataArray: its heights there, and the way back from what is computed of them."""

    def __init__(self, data):
        self._data = _flatten(data)
        self.heights = _own_heights(self._data)
        self._is_turned = _is_x(self._data, self._data.dims[0])
        shape = self.heights.GetDimensions()[1::-1]
        is_even = all(map(self._is_even, self._data.dims))
        if not is_even or shape != (self._data.shape[::-1] if self._is_turned else self._data.shape):
            raise ValueError("results need a grid of even coordinates: resample the array first")

    def _coordinate(self, dimension):
        if dimension not in self._data.coords or not _is_numeric(self._data.coords[dimension]):
            return np.arange(self._data.sizes[dimension])
        return self._data.coords[dimension].values

    def _is_falling(self, dimension):
        coordinate = self._coordinate(dimension)
        return coordinate[-1] < coordinate[0]

    def _is_even(self, dimension):
        coordinate = self._coordinate(dimension)
        even = np.linspace(coordinate[0], coordinate[-1], len(coordinate))
        return np.abs(coordinate - even).max() <= _UNEVEN * abs(even[-1] - even[0]) / len(even)

    def wrap(self, values, name, units, long_name, further=()):
        """A DataArray, like the one of heights, of values by rows from the south, columns and ``further``.

        ``further`` is a dimension and its coordinates, put first.
        """
        dims = self._data.dims
        values = values.swapaxes(0, 1) if self._is_turned else values
        values = values[tuple(slice(None, None, -1 if self._is_falling(dimension) else 1) for dimension in dims)]
        coords = dict(self._data.coords)
        if further:
            values = np.moveaxis(values, 2, 0)
            coords[further[0]] = list(further[1])
        result = xarray.DataArray(np.ascontiguousarray(values), coords=coords, dims=(*further[:1], *dims), name=name,
                                  attrs={"units": units, "long_name": long_name})
        for source, target in ((self._data.attrs, result.attrs), (self._data.encoding, result.encoding)):
            target.update({key: source[key] for key in ("crs", "grid_mapping") if key in source})
        return result


@xarray.register_dataarray_accessor("terrain")
class TerrainAccessor:
    """A DataArray of heights as terrain: ``data.terrain``.

    ``plot`` and ``add_to`` draw it. The others compute an array on the same grid, with its coordinates
    and CRS; their options are those of the functions of ``vtkterrain.analysis``.
    """

    def __init__(self, data):
        self._data = data
        self._heights = None
        self._grid = None

    def _own(self):
        if self._grid is None:
            self._grid = _Grid(self._data)
        return self._grid

    def slope(self):
        """Angle of the surface with the horizontal, degrees."""
        return self._own().wrap(analysis.slope(self._own().heights), "slope", "degree", "slope")

    def aspect(self):
        """Where the surface goes down, degrees clockwise from grid north; NaN where it is level."""
        return self._own().wrap(analysis.aspect(self._own().heights), "aspect", "degree", "aspect")

    def curvature(self):
        """A Dataset of "profile" and "plan" curvature, 1/m."""
        both = zip(("profile", "plan"), analysis.curvature(self._own().heights))
        return xarray.Dataset({name: self._own().wrap(values, name, "m-1", f"{name} curvature")
                               for name, values in both})

    def ruggedness(self):
        """Root of the sum of squared differences to the eight neighbours, metres."""
        return self._own().wrap(analysis.ruggedness(self._own().heights), "ruggedness", "m", "terrain ruggedness index")

    def horizon(self, directions=16, **options):
        """Elevation of the horizon in degrees, with a first dimension "azimuth" in degrees from grid north."""
        values = analysis.horizon(self._own().heights, directions, **options)
        return self._own().wrap(values, "horizon", "degree", "elevation of the horizon",
                                ("azimuth", 360.0 * np.arange(directions) / directions))

    def sky_view(self, directions=16, **options):
        """Share of an even sky's light on a level plate, 0 to 1."""
        return self._own().wrap(analysis.sky_view(self._own().heights, directions, **options), "sky_view", "1",
                                "sky view factor")

    def sunlight(self, date, **options):
        """A Dataset of the direct sun of a day: "hours", "first", "last" and "irradiation"."""
        units = {"hours": "h", "first": "h", "last": "h", "irradiation": "W h m-2"}
        results = analysis.sunlight(self._own().heights, date, **options)
        return xarray.Dataset({name: self._own().wrap(values, name, units[name], f"{name} of direct sun on {date}")
                               for name, values in results.items()})

    def viewshed(self, observers, **options):
        """How many observers, coordinates of the array's or a GeoPandas frame of points, see each sample."""
        return self._own().wrap(analysis.viewshed(self._own().heights, observers, **options), "viewshed", "1",
                                "observers that see the place")

    @property
    def heights(self):
        """The ``vtkImageData`` that ``heights_from_dataarray`` makes of it, made once."""
        if self._heights is None:
            self._heights = heights_from_dataarray(self._data)
        return self._heights

    def add_to(self, plotter, *, tracks=None, points=None, **options):
        """Adds it to a ``pyvista.Plotter`` with the options of ``vtkterrain.plotting.add_terrain``.

        ``tracks`` and ``points`` are GeoPandas frames that are laid onto it. Returns the
        ``vtkTerrainActor``.
        """
        from .plotting import add_terrain

        terrain = add_terrain(plotter, self._data, **options)
        if tracks is not None or points is not None:
            from .features import add_points, add_tracks

            if tracks is not None:
                add_tracks(plotter, terrain, tracks)
            if points is not None:
                add_points(plotter, terrain, points)
        return terrain

    def plot(self, *, screenshot=None, window_size=None, jupyter_backend=None, **options):
        """Shows it in a window, in a notebook, or writes a picture; options as those of ``add_to``.

        screenshot : str or path, optional
            File of a picture to write in place of showing a window.
        window_size : (int, int), optional
            Width and height in pixels.
        jupyter_backend : str, optional
            How a notebook shows it, see ``pyvista.Plotter.show``.
        """
        import pyvista

        plotter = pyvista.Plotter(off_screen=True if screenshot else None, window_size=window_size)
        try:
            self.add_to(plotter, **options)
        except TypeError as error:
            if "has no option" not in str(error):
                raise
            raise TypeError(str(error).replace("add_terrain", "plot", 1)) from None
        plotter.view_vector((0.0, -0.82, 0.57), viewup=(0.0, 0.0, 1.0))
        if screenshot:
            plotter.screenshot(screenshot)
            plotter.close()
            return None
        return plotter.show(jupyter_backend=jupyter_backend)
