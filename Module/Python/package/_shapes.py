# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's kinds of regular grids as heights, and why others are none."""
import numpy as np
import pyvista
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject,
    vtkDataSetAttributes,
    vtkImageData,
    vtkRectilinearGrid,
    vtkStructuredGrid,
)

from .heights import heights_from_array

_KINDS = ("an array of rows and columns, a pyvista.ImageData, RectilinearGrid or StructuredGrid on a regular grid, an "
          "xarray.DataArray, or the name of a file")


def even_step(values, what):
    """First value and step of evenly spaced coordinates; raises a ValueError that names them."""
    values = np.asarray(values, dtype=float)
    steps = np.diff(values)
    if values.ndim != 1 or not steps.size or not steps[0] or not np.allclose(steps, steps[0], rtol=1e-3, atol=0.0):
        raise ValueError(f"{what} must be evenly spaced: resample the heights onto a regular grid first")
    return values[0], steps[0]


def lines_of(x, y):
    """Coordinates of columns and of rows from two arrays of the grid's shape, as ``numpy.meshgrid`` makes them."""
    x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    reach = max(np.ptp(x), np.ptp(y), 1e-300)
    if np.abs(x - x[:1]).max() > 1e-6 * reach or np.abs(y - y[:, :1]).max() > 1e-6 * reach:
        raise ValueError("x and y are no regular grid along the axes: resample the heights onto one first")
    return x[0], y[:, 0]


def _check_coordinates(x, y, shape, place):
    """Raises a ValueError where x and y are not those of an array of a shape, or others tell its place, too."""
    beside = [name for name in ("spacing", "origin") if name in place]
    if y is not None and place.get("first_row") is not None:
        beside.append("first_row")
    if beside:
        raise ValueError(f"x and y tell where the heights lie: leave out {', '.join(beside)}, or x and y")
    if np.ndim(x) == 2 and np.shape(x) == np.shape(y) == shape:
        return
    for values, what, count, of in ((x, "x", shape[-1], "columns"), (y, "y", shape[0], "rows")):
        if np.ndim(values) == 2:
            raise ValueError(f"x and y must both be of the shape of the heights, {' x '.join(map(str, shape))}, or one "
                             f"number a column and a row: {what} is {' x '.join(map(str, np.shape(values)))}")
        if values is not None and np.size(values) != count:
            raise ValueError(f"{what} has {np.size(values)} numbers, the heights have {count} {of}")


def take_coordinates(place, shape):
    """Puts x and y, coordinates of columns and rows of an array, in the words of ``heights_from_array``."""
    x, y = (place.pop(axis, None) for axis in "xy")
    if x is None and y is None:
        return
    if len(shape) == 2:
        _check_coordinates(x, y, shape, place)
    if x is None or y is None:
        given, missing = "yx" if x is None else "xy"
        raise ValueError(f"{given} needs {missing}: give the coordinates of both columns and rows, or spacing and "
                         "origin")
    if np.ndim(x) == 2 and np.shape(x) == np.shape(y):
        x, y = lines_of(x, y)
    origin, spacing = [0.0, 0.0], [1.0, 1.0]
    for k, (values, what) in enumerate(((x, "x"), (y, "y"))):
        first, step = even_step(values, what)
        if k == 0 and step < 0:
            raise ValueError("x must rise: turn the columns round")
        if k == 1 and step < 0:
            place["first_row"] = "north"
        origin[k], spacing[k] = np.min(values), abs(step)
    place.update(origin=tuple(origin), spacing=tuple(spacing))


def _with_holes(grid, samples):
    """Point values as numbers, NaN where the grid hides its points."""
    ghosts = grid.GetPointGhostArray()
    if ghosts is None:
        return samples
    return np.where(vtk_to_numpy(ghosts) & vtkDataSetAttributes.HIDDENPOINT, np.nan, samples)


def _image_of(grid, lines, samples, name, to_rows):
    """Heights on lines of coordinates; ``to_rows`` brings an array of all points to rows and columns."""
    kind = type(grid).__name__
    turns = []
    for line, axis in zip(lines, "xy"):
        first, step = even_step(line, f"the {axis} coordinates of this {kind}")
        turns.append((min(first, line[-1]), abs(line[-1] - first) / (len(line) - 1),
                      slice(None, None, -1 if step < 0 else 1)))
    (west, width, columns), (south, height, rows) = turns

    def from_the_south(values):
        return np.ascontiguousarray(to_rows(values)[rows, columns])

    image = pyvista.wrap(heights_from_array(from_the_south(_with_holes(grid, samples)), (width, height),
                                            (west, south), name=name or "Elevation"))
    for key in pyvista.wrap(grid).point_data:
        if key not in (image.GetPointData().GetScalars().GetName(), vtkDataSetAttributes.GhostArrayName()):
            values = from_the_south(vtk_to_numpy(grid.GetPointData().GetArray(key)))
            image.point_data[key] = values.reshape(image.GetNumberOfPoints(), -1).squeeze()
    return image


def _sizes(grid):
    """Points along each axis. From VTK 9.6 on GetDimensions() of a structured grid wants an argument."""
    extent = grid.GetExtent()
    return tuple(high - low + 1 for low, high in zip(extent[::2], extent[1::2], strict=True))


def _from_rectilinear(grid):
    columns, rows, layers = _sizes(grid)
    scalars = grid.GetPointData().GetScalars()
    _check_layers(grid, layers)
    _check_scalars(grid, scalars)
    lines = [vtk_to_numpy(axis) for axis in (grid.GetXCoordinates(), grid.GetYCoordinates())]
    return _image_of(grid, lines, vtk_to_numpy(scalars), scalars.GetName(),
                     lambda values: values.reshape(rows, columns, *values.shape[1:]))


def _from_structured(grid):
    inner, outer, layers = _sizes(grid)
    _check_layers(grid, layers)

    def as_stored(values):
        return values.reshape(outer, inner, *values.shape[1:])

    def turned(values):  # pyvista.StructuredGrid(x, y, z) has its columns run first
        return as_stored(values).swapaxes(0, 1)

    points = vtk_to_numpy(grid.GetPoints().GetData())
    corner = as_stored(points)[[0, -1, 0], [0, 0, -1], 0]
    to_rows = turned if abs(corner[1] - corner[0]) > abs(corner[2] - corner[0]) else as_stored
    lines = lines_of(to_rows(points[:, 0]), to_rows(points[:, 1]))
    return _image_of(grid, lines, points[:, 2], "Elevation", to_rows)


def _check_layers(grid, layers):
    if layers != 1:
        sizes = " x ".join(map(str, _sizes(grid)))
        raise ValueError(f"heights are one layer in x and y, this {type(grid).__name__} has {sizes} points: extract a "
                         "layer")


def _check_scalars(grid, scalars):
    kind = type(grid).__name__
    if scalars is None:
        of_cells = grid.GetCellData().GetNumberOfArrays() > 0
        raise ValueError(f"this {kind} has no active point scalars to take for heights: "
                         + ("its arrays are of cells, cell_data_to_point_data() makes them" if of_cells
                            else "set_active_scalars(name) chooses them"))
    if scalars.GetNumberOfComponents() != 1:
        raise ValueError(f"heights are one number a point, the array {scalars.GetName()!r} of this {kind} has "
                         f"{scalars.GetNumberOfComponents()}: set_active_scalars(name) chooses another")


def check_image(image):
    """Raises the reason why an image holds no heights, as far as its shape tells."""
    _check_layers(image, image.GetDimensions()[2])
    _check_scalars(image, image.GetPointData().GetScalars())
    return image


def to_heights(heights):
    """Grids of PyVista as images; what is no heights at all raises an error that names its type."""
    if isinstance(heights, vtkImageData):
        return check_image(heights)
    if isinstance(heights, vtkRectilinearGrid):
        return _from_rectilinear(heights)
    if isinstance(heights, vtkStructuredGrid):
        return _from_structured(heights)
    is_dataset = hasattr(heights, "data_vars")
    if is_dataset or heights is None or isinstance(heights, (vtkDataObject, pyvista.BasePlotter, bytes, dict, set)):
        hint = ": choose one of its variables, dataset[name]" if is_dataset else ""
        raise TypeError(f"heights must be {_KINDS}, not {type(heights).__name__}{hint}")
    return heights


def check_plotter(plotter):
    """Raises a TypeError where the first argument is no plotter."""
    if not isinstance(plotter, pyvista.BasePlotter):
        raise TypeError(f"add_terrain(plotter, heights): the plotter is a {type(plotter).__name__}, not a "
                        "pyvista.Plotter")
