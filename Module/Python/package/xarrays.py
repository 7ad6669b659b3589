# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""xarray's DataArrays as terrain, as rioxarray, odc-geo and CF conventions describe them.

Importing this module gives every DataArray ``.terrain``:

>>> import vtkterrain.xarrays
>>> rioxarray.open_rasterio("dem.tif", masked=True).terrain.plot(exaggeration=1.5)
"""
import numpy as np
import xarray

from .heights import heights_from_array
from .vtkTerrain import vtkTerrainGeoreference, vtkTerrainReproject

_NAMES_OF_X = ("x", "lon", "longitude", "easting")
_NAMES_OF_Y = ("y", "lat", "latitude", "northing")
_LARGEST_UNEVENNESS = 1e-3  # of a step: coordinates as float32 are that uneven at UTM northings


def _dimension(data, names):
    for dimension in data.dims:
        if str(dimension).lower() in names:
            return dimension
    raise ValueError(f"no dimension of {data.dims} is one of {', '.join(names)}")


def _axis(data, dimension):
    """First coordinate and signed step of an evenly spaced axis."""
    if dimension not in data.coords:
        return 0.0, 1.0
    places = np.asarray(data.coords[dimension].values, dtype=np.float64)
    if places.size < 2:
        raise ValueError(f"{dimension} must have at least two coordinates")
    step = (places[-1] - places[0]) / (places.size - 1)
    even = places[0] + step * np.arange(places.size)
    if not step or not np.abs(places - even).max() <= _LARGEST_UNEVENNESS * abs(step):
        raise ValueError(f"the coordinates of {dimension} are not evenly spaced")
    return places[0], step


def _coordinate_system(data, dimension_x):
    """CRS of a DataArray as text; None if it has none."""
    mapping = data.coords.get(data.encoding.get("grid_mapping", data.attrs.get("grid_mapping")))
    for attributes in [data.coords[name].attrs for name in ("spatial_ref", "crs")
                       if name in data.coords] + ([mapping.attrs] if mapping is not None else []):
        for key in ("crs_wkt", "spatial_ref"):
            if attributes.get(key):
                return str(attributes[key])
    system = data.attrs.get("crs")
    if system is not None:
        return system.to_wkt() if hasattr(system, "to_wkt") else str(system)
    return "EPSG:4326" if str(dimension_x).lower() in ("lon", "longitude") else None


def _mask_fill_values(data, samples):
    fills = [data.attrs[key] for key in ("_FillValue", "missing_value", "nodatavals")
             if key in data.attrs]
    fills = np.unique([np.ravel(fill)[0] for fill in fills if np.ravel(fill)[0] is not None])
    return np.ma.masked_array(samples, np.isin(samples, fills)) if fills.size else samples


def _is_metric_grid(coordinate_system, extent):
    """Whether x and y are metres; an error if the system is none or contradicts the extent."""
    place = vtkTerrainGeoreference()
    place.SetCoordinateSystem(coordinate_system)
    place.SetExtent(*extent)
    if place.GetWhyNot():
        raise ValueError(place.GetWhyNot())
    place.SetFrame(vtkTerrainGeoreference.FrameType.Grid)
    return not place.GetWhyNot() and bool(place.GetSceneCoordinateSystem())


def heights_from_dataarray(data):
    """A ``vtkImageData`` of heights from an ``xarray.DataArray``.

    The array has a dimension called x, lon, longitude or easting, one called y, lat, latitude or
    northing, and other dimensions of length 1 at most. Coordinates along both are evenly spaced,
    rising or falling; without coordinates samples lie 1 apart. Its coordinate reference system is
    the attribute ``crs_wkt`` or ``spatial_ref`` of the coordinate ``spatial_ref`` (rioxarray), of the
    grid mapping (CF), or the attribute ``crs``; for longitude and latitude without any, WGS84.
    ``_FillValue``, ``missing_value`` and NaN are places without a height.

    Heights of a system in degrees, or in another unit than metres, are resampled onto a metric grid
    round their middle (``vtkTerrainReproject``). Others share the memory of the array where
    ``heights_from_array`` can.
    """
    dimension_x, dimension_y = _dimension(data, _NAMES_OF_X), _dimension(data, _NAMES_OF_Y)
    data = data.squeeze([name for name in data.dims
                         if name not in (dimension_x, dimension_y) and data.sizes[name] == 1])
    if data.ndim != 2:
        raise ValueError(f"heights must have two dimensions, not {data.dims}: select one of the others")
    data = data.transpose(dimension_y, dimension_x)
    (x, step_x), (y, step_y) = _axis(data, dimension_x), _axis(data, dimension_y)
    samples = _mask_fill_values(data, data.values)[::1 if step_y > 0 else -1,
                                                   ::1 if step_x > 0 else -1]
    rows, columns = samples.shape
    low = (min(x, x + (columns - 1) * step_x), min(y, y + (rows - 1) * step_y))
    spacing = (abs(step_x), abs(step_y))
    system = _coordinate_system(data, dimension_x)
    image = heights_from_array(samples, spacing, low, name=str(data.name or "Elevation"),
                               coordinate_system=system)
    extent = (low[0], low[0] + (columns - 1) * spacing[0], low[1], low[1] + (rows - 1) * spacing[1])
    if system is None or _is_metric_grid(system, extent):
        return image
    reproject = vtkTerrainReproject()
    reproject.SetInputData(image)
    reproject.Update()
    if reproject.GetErrorMessage():
        raise ValueError(reproject.GetErrorMessage())
    return reproject.GetOutput()


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

        terrain = add_terrain(plotter, self.heights, **options)
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
