# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights between numpy and VTK."""
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData

from ._intake import describe_samples, make_reader, read, tell_of_samples

_CODES_OF_VTK_TYPES = "bBhHiIlLqQfd"
_FILL = 1e30  # from here on no height, declared or not


def to_array(values, what="heights"):
    """Values as an array; lists whose rows differ in length are a ValueError."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # old numpy's of the same
            array = np.asanyarray(values)
        is_ragged = array.dtype == object and array.ndim == 1 and any(np.ndim(row) for row in array)
    except ValueError:
        is_ragged = True
    if is_ragged:
        raise ValueError(f"{what} must be an array of rows and columns: these rows differ in length")
    return array


def _fill_masked(array):
    """An array without a mask: floats with NaN in place of masked samples."""
    samples = np.ma.getdata(array)
    if not np.ma.is_masked(array):
        return samples
    mask = np.ma.getmaskarray(array)
    is_exact_as_float = samples.dtype.kind == "f" or samples.dtype.itemsize <= 2
    samples = samples.astype(np.promote_types(samples.dtype, np.float32) if is_exact_as_float
                             else np.float64)
    samples[mask] = np.nan
    return samples


def _to_vtk_type(samples):
    """The array in a type that VTK has and in the machine's byte order, itself if it is so already."""
    if samples.dtype.kind not in "biuf":
        raise TypeError(f"heights must be real numbers, this array holds {samples.dtype}")
    target = samples.dtype.newbyteorder("=")
    if samples.dtype == bool:
        target = np.uint8
    elif samples.dtype.char not in _CODES_OF_VTK_TYPES:
        target = np.float32 if samples.dtype.itemsize < 4 else np.float64
    return samples.astype(target, copy=False)


def _numbers(values):
    """As an array of floats; empty where they are none."""
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        return np.empty(0)


def _without_fill(samples):
    """The samples with NaN for infinities and for what is too large to be a height, themselves without any."""
    if samples.dtype.kind != "f":
        return samples
    if max(np.fmax.reduce(samples, axis=None), -np.fmin.reduce(samples, axis=None)) < _FILL:
        return samples
    return np.where(np.abs(samples) < _FILL, samples, np.nan).astype(samples.dtype)


def _check_place(spacing, origin):
    steps, start = _numbers(spacing), _numbers(origin)
    if steps.shape != (2,) or not (np.isfinite(steps) & (steps > 0)).all():
        raise ValueError(f"spacing must be two numbers above 0, not {spacing!r}")
    if start.shape not in ((2,), (3,)) or not np.isfinite(start).all():
        raise ValueError(f"origin must be two or three finite numbers, not {origin!r}")


def _is_from_north(samples):
    """Whether rows from the south lie in memory from the north, so that they need no copy that way."""
    return not samples.flags.c_contiguous and samples[::-1].flags.c_contiguous


def _take_in(samples, spacing, nodata, height_unit):
    """Samples from the south as heights in metres, NaN for fill: themselves if they are so already."""
    has_place = min(samples.shape) > 1
    axes = [(name, {}, step * np.arange(size)) if has_place else None
            for name, step, size in zip("yx", spacing[::-1], samples.shape)]
    in_memory = samples
    if has_place and _is_from_north(samples):
        in_memory = samples[::-1]
        axes[0] = (*axes[0][:2], axes[0][2][::-1])
    described = describe_samples(in_memory, None, rows=axes[0], columns=axes[1])
    reader = make_reader(described, nodata=nodata, height_unit=height_unit)
    if reader.GetSamplesAreHeights():
        tell_of_samples(reader, of_place=False)
        return samples
    if "is not found" in reader.Describe() and nodata is None and height_unit is None:
        return samples  # without GDAL there is nobody to ask
    heights = array_from_heights(read(reader, ValueError, of_place=False))
    return heights if has_place else heights[::-1]


def heights_from_array(array, spacing=(1.0, 1.0), origin=(0.0, 0.0), *, first_row="south",
                       name="Elevation", coordinate_system=None, nodata=None, height_unit=None,
                       flip=False):
    """A ``vtkImageData`` of heights from a numpy array.

    The image shares the memory of the array, and keeps it alive, if the array is contiguous, VTK has
    its type, no sample is masked or fill and the heights are metres. Otherwise the samples are copied.
    Where memory begins in the north, the image does so too: its origin is the north-western sample, and
    its direction matrix is diag(1, -1, 1). After a change of shared samples call
    ``image.GetPointData().GetScalars().Modified()``.

    Parameters
    ----------
    array : array_like of shape (rows, columns)
        Heights of any real type. NaN, infinities and masked samples are places without a height.
    spacing : (float, float)
        Distance of samples east and north, each above 0, in the unit of the heights.
    origin : (float, float) or (float, float, float)
        Where the south-western sample lies; the third number is added to all heights.
    first_row : {"south", "north"}
        The side at which ``array[0]`` lies. Rasters in files begin in the north as a rule.
    name : str
        Name of the image's array of heights.
    coordinate_system : str, optional
        Coordinate reference system of x and y, in metres, as WKT, "EPSG:n" or PROJ string; kept as
        the field data "CRS", as ``vtkTerrainRasterReader`` does.
    nodata : float or "none", optional
        A value that is no height. By default values that programs fill with (-32768, -9999, 1e20, ...)
        are none if they lie far from all other samples, and a warning says so; "none" takes them for
        heights.
    height_unit : str or float, optional
        Unit of the heights ("ft"; "-m" for depths) or metres per unit; metres by default.
    flip : bool
        Whether the first row lies at the other side than ``first_row`` says.
    """
    if first_row not in ("south", "north"):
        raise ValueError(f'first_row must be "south" or "north", not {first_row!r}')
    _check_place(spacing, origin)
    samples = _to_vtk_type(_fill_masked(to_array(array)))
    if samples.ndim != 2 or 0 in samples.shape:
        raise ValueError(f"heights must be an array of rows and columns, not of shape {samples.shape}")
    if (first_row == "north") != bool(flip):
        samples = samples[::-1]
    samples = _without_fill(_take_in(samples, spacing, nodata, height_unit))
    rows, columns = samples.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.SetSpacing(*spacing, 1.0)
    x, y, z = (*origin, *([0.0] * (3 - len(origin))))
    if _is_from_north(samples):
        samples = samples[::-1]
        y += (rows - 1) * spacing[1]
        image.SetDirectionMatrix(1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0)
    image.SetOrigin(x, y, z)
    scalars = numpy_to_vtk(np.ascontiguousarray(samples).reshape(-1))
    scalars.SetName(name)
    image.GetPointData().SetScalars(scalars)
    if coordinate_system:
        text = vtkStringArray()
        text.SetName("CRS")
        text.InsertNextValue(coordinate_system)
        image.GetFieldData().AddArray(text)
    return image


def array_from_heights(image):
    """The heights of a ``vtkImageData`` as an array of rows, from the south, and columns.

    A view of the image's memory; a copy, with NaN in their place, if points have no height.
    """
    columns, rows, layers = image.GetDimensions()
    scalars = image.GetPointData().GetScalars()
    if layers != 1 or scalars is None or scalars.GetNumberOfComponents() != 1:
        raise ValueError("heights must be an image of W x H x 1 points with one scalar each")
    step = -1 if image.GetDirectionMatrix().GetElement(1, 1) < 0 else 1
    samples = vtk_to_numpy(scalars).reshape(rows, columns)[::step]
    ghosts = image.GetPointGhostArray()
    if ghosts is None:
        return samples
    is_hidden = vtk_to_numpy(ghosts).reshape(rows, columns)[::step] & vtkDataSetAttributes.HIDDENPOINT != 0
    return _fill_masked(np.ma.masked_array(samples, is_hidden))
