# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""What arrays and files are taken for: the C++ reader decides, as it does for files by name."""
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkFieldData

from .vtkTerrain import vtkTerrainGeoreference, vtkTerrainRasterReader, vtkTerrainReproject

_READ_TYPES = "BhHiIfd"  # of samples in memory


def _texts(name, pairs):
    array = vtkStringArray()
    array.SetName(name)
    for key, value in pairs.items():
        is_list = isinstance(value, (list, tuple, np.ndarray))
        first = next(iter(np.ravel(value)), "") if is_list else value
        array.InsertNextValue(f"{key}={first}")
    return array


def _numbers(name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values, dtype=np.float64).reshape(-1))
    array.SetName(name)
    return array


def describe_samples(samples, name, *, crs=None, attributes=None, rows=None, columns=None, fields=(),
                     grid_mapping=None):
    """Samples and what is known of them as ``vtkTerrainRasterReader.SetSamples`` takes them.

    ``rows``, ``columns`` and each of ``fields`` are (name, attributes, values or None).
    """
    described = vtkFieldData()
    if samples.dtype.char not in _READ_TYPES:
        samples = samples.astype(np.int16 if samples.dtype.itemsize == 1 else np.float64)
    heights = numpy_to_vtk(np.ascontiguousarray(samples).reshape(-1))
    heights.SetName("Samples")
    described.AddArray(heights)
    described.AddArray(_numbers("Size", samples.shape[::-1]))
    named = {"name": name, "crs": crs}
    described.AddArray(_texts("Names", {key: text for key, text in named.items() if text}))
    described.AddArray(_texts("Attributes", attributes or {}))
    described.AddArray(_texts("GridMapping", grid_mapping or {}))
    axes = {"Rows": rows, "Columns": columns, **{f"Field{k}": field for k, field in enumerate(fields)}}
    for key, axis in axes.items():
        if axis is None:
            continue
        described.AddArray(_texts(f"{key}Attributes", {**axis[1], "name": axis[0]}))
        if axis[2] is not None:
            described.AddArray(_numbers(key, axis[2]))
    return described


def make_reader(source, *, crs=None, band=None, part=None, nodata=None, height_unit=None, flip=False):
    """A reader of a file by name or of described samples, with what the caller says of it."""
    reader = vtkTerrainRasterReader()
    if isinstance(source, vtkFieldData):
        reader.SetSamples(source)
        reader.SetFileName("array")
    else:
        reader.SetFileName(source)
    reader.SetCoordinateSystem(crs or "")
    reader.SetBand(band or 0)
    reader.SetPart(str(part or ""))
    reader.SetHeightUnit(str(height_unit if height_unit is not None else ""))
    reader.SetFlip(bool(flip))
    reader.SetDetectNoData(nodata is None)
    if nodata is not None and nodata != "none":
        reader.SetUseNoDataValue(True)
        reader.SetNoDataValue(float(nodata))
    return reader


def _run(algorithm, update):
    """Updates without VTK's own messages; what there is to warn of becomes warnings of Python."""
    algorithm.GlobalWarningDisplayOff()
    try:
        update()
    finally:
        algorithm.GlobalWarningDisplayOn()


def tell(algorithm):
    for line in (algorithm.GetWarningMessage() or "").splitlines():
        warnings.warn(line, stacklevel=4)


def read(reader, error=OSError):
    """Heights that a reader gives; raises ``error``."""
    _run(reader, reader.Update)
    if reader.GetErrorMessage():
        raise error(reader.GetErrorMessage())
    tell(reader)
    return reader.GetOutput()


def lay_out(image, scene=None):
    """Heights in metres: resampled where their own grid is none, or not that of the scene.

    ``scene`` is the ``vtkTerrainGeoreference`` of all that is drawn together; one that is empty takes
    its frame and origin from these heights.
    """
    place = vtkTerrainGeoreference()
    place.SetFromHeights(image)
    if not place.GetCoordinateSystem():
        return image
    frame = place.SuggestFrame(image)
    place.SetFrame(frame)
    is_grid = frame == vtkTerrainGeoreference.FrameType.Grid
    if place.GetWhyNot() or not place.IsOnEarth():
        if place.IsGeographic() and not is_grid:
            raise ValueError(place.GetWhyNot())
        return image
    if scene is None:
        if is_grid:
            return image
        scene = vtkTerrainGeoreference()
        edge = 0.0
    else:
        edge = 1.0  # neighbours that are added one by one meet
        if not scene.GetCoordinateSystem():
            _begin(scene, place, frame)
        if is_grid and scene.GetFrame() == frame and (
                scene.GetSceneCoordinateSystem() == place.GetSceneCoordinateSystem()):
            return image
    reproject = vtkTerrainReproject()
    reproject.SetInputData(image)
    reproject.SetGeoreference(scene)
    reproject.SetEdgeCells(edge)
    _run(reproject, reproject.Update)
    if reproject.GetErrorMessage():
        raise ValueError(reproject.GetErrorMessage())
    tell(reproject)
    return reproject.GetOutput()


def _begin(scene, place, frame):
    scene.SetCoordinateSystem(place.GetCoordinateSystem())
    scene.SetExtent(*place.GetExtent())
    scene.SetFrame(frame)
    origin = [0.0, 0.0, 0.0]
    scene.GetOrigin(origin)
    if np.isfinite(origin).all():
        scene.SetOrigin(*origin)
