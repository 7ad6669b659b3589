# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""xarray's DataArrays as terrain, as rioxarray, odc-geo and CF conventions describe them.

Importing this module gives every DataArray ``.terrain``:

>>> import vtkterrain.xarrays
>>> rioxarray.open_rasterio("dem.tif", masked=True).terrain.plot(exaggeration=1.5)
"""
import numpy as np
import xarray

from ._intake import describe_samples, lay_out, make_reader, read
from .heights import _fill_masked, _to_vtk_type, heights_from_array

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
    data = _flatten(data)
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
        return lay_out(_share(samples, axes, name, crs or system), scene)
    return lay_out(read(reader, ValueError), scene)


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


@xarray.register_dataarray_accessor("terrain")
class TerrainAccessor:
    """A DataArray of heights as terrain: ``data.terrain``."""

    def __init__(self, data):
        self._data = data
        self._heights = None

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
        self.add_to(plotter, **options)
        plotter.view_vector((0.0, -0.82, 0.57), viewup=(0.0, 0.0, 1.0))
        if screenshot:
            plotter.screenshot(screenshot)
            plotter.close()
            return None
        return plotter.show(jupyter_backend=jupyter_backend)
