# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""What arrays and files are taken for: the C++ reader decides, as it does for files by name."""
import re
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkFieldData

from .vtkTerrain import vtkTerrainGeoreference, vtkTerrainGlobe, vtkTerrainRasterReader, vtkTerrainReproject

_ARRAY = "array"  # what the reader calls samples in memory
_OF_DEGREES = "look like degrees"
_OF_RELIEF = "three times as high as it is wide"
_READ_TYPES = "BhHiIfd"  # of samples in memory


def _texts(name, pairs):
    array = vtkStringArray()
    array.SetName(name)
    for key, value in pairs.items():
        is_list = isinstance(value, (list, tuple, np.ndarray))
        first = next(iter(np.ravel(value)), "") if is_list else value
        if key == "valid_range":
            first = ",".join(str(number) for number in np.ravel(value))
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
        reader.SetFileName(_ARRAY)
    else:
        reader.SetFileName(source)
    reader.SetCoordinateSystem(crs or "")
    reader.SetBand(band or 0)
    reader.SetPart(str(part or ""))
    reader.SetHeightUnit(str(height_unit if height_unit is not None else ""))
    reader.SetFlip(bool(flip))
    reader.SetDetectNoData(nodata is None)
    if nodata is not None and nodata != "none":
        try:
            reader.SetNoDataValue(float(nodata))
        except (TypeError, ValueError) as error:
            raise ValueError(f'nodata must be a number or "none", not {nodata!r}') from error
        reader.SetUseNoDataValue(True)
    return reader


def _run(algorithm, update):
    """Updates without VTK's own messages; what there is to warn of becomes warnings of Python."""
    algorithm.GlobalWarningDisplayOff()
    try:
        update()
    finally:
        algorithm.GlobalWarningDisplayOn()


def _option(match):
    """An option of the programs as one of Python, with its value if one follows."""
    name, value = match.group(1).replace("-", "_"), match.group(2)
    if value is None or value in ("names", "chooses", "if"):
        return name + (f" {value}" if value else "")
    is_bare = value in ("NAME", "N") or re.fullmatch(r"-?[\d.]+(e[-+]?\d+)?", value)
    return f"{name}={value}" if is_bare else f'{name}="{value}"'


def in_words_of_python(text):
    """What the reader says, with its options as those of ``add_terrain``; an array is no file."""
    text = re.sub(r"--(nodata|crs|height-unit|part|band|flip)\b(?: ([^\s,;)]+))?", _option, text)
    if text.startswith(f"'{_ARRAY}'"):
        text = text.replace(f"'{_ARRAY}'", "heights", 1).replace(", which the file does not declare", "")
    return text


def tell(algorithm, of_place=True):
    """Warnings of Python for those of an algorithm; those of the place only if it is not the caller's own."""
    for line in (algorithm.GetWarningMessage() or "").splitlines():
        if of_place or _OF_DEGREES not in line:
            warnings.warn(in_words_of_python(line), stacklevel=4)


def tell_of_samples(reader, of_place=True):
    """Warnings of samples that are heights as they are, which nobody has to read.

    Samples without a place are not judged by how far apart they are: 1, mostly.
    """
    for line in reader.Describe().splitlines():
        kind, _, text = line.partition(": ")
        if kind == "warning" and (of_place or not any(words in text for words in (_OF_DEGREES, _OF_RELIEF))):
            warnings.warn("heights: " + in_words_of_python(text), stacklevel=4)


def read(reader, error=OSError, of_place=True):
    """Heights that a reader gives; raises ``error``."""
    _run(reader, reader.Update)
    if reader.GetErrorMessage():
        raise error(in_words_of_python(reader.GetErrorMessage()))
    tell(reader, of_place)
    return reader.GetOutput()


def knows_its_place(path):
    """Whether a picture is georeferenced, as far as GDAL, if there is one, can tell."""
    reader = make_reader(path, band=1)
    _run(reader, reader.UpdateInformation)
    facts = "" if reader.GetErrorMessage() else reader.Describe()
    return any(line.startswith("place: ") and not line.startswith("place: none") for line in facts.splitlines())


def lay_on_globe(image):
    """Heights in longitude and latitude as those of a globe (``vtkTerrainGlobe``)."""
    if image.GetFieldData().GetArray("GlobeLatitudes"):
        return image
    globe = vtkTerrainGlobe()
    globe.SetInputData(image)
    _run(globe, globe.Update)
    if globe.GetErrorMessage():
        raise ValueError(globe.GetErrorMessage())
    return globe.GetOutput()


def lay_out(image, scene=None):
    """Heights in metres: resampled where their own grid is none, or not that of the scene.

    ``scene`` is the ``vtkTerrainGeoreference`` of all that is drawn together; one that is empty takes
    its frame and origin from these heights. Heights that cannot join it stay where they are, and a
    warning says why.
    """
    if scene is not None and scene.GetFrame() == vtkTerrainGeoreference.FrameType.Globe:
        globe = lay_on_globe(image)
        if not scene.GetCoordinateSystem():
            scene.SetFromHeights(globe)
        return globe
    place = vtkTerrainGeoreference()
    place.SetFromHeights(image)
    if not place.GetCoordinateSystem():
        _tell_apart(scene, "these heights have no coordinate system (crs= names one)")
        return image
    frame = place.SuggestFrame(image)
    place.SetFrame(frame)
    is_grid = frame == vtkTerrainGeoreference.FrameType.Grid
    if place.GetWhyNot() or not place.IsOnEarth():
        if place.IsGeographic() and not is_grid:
            raise ValueError(place.GetWhyNot())
        return _join_grid(image, place, scene)
    if scene is None:
        if is_grid:
            return image
        scene = vtkTerrainGeoreference()
        edge = 0.0
    else:
        edge = 1.0  # neighbours that are added one by one meet
        if not scene.GetCoordinateSystem():
            _begin(scene, place, frame)
        if is_grid and is_grid_of(place, scene):
            return image
    if scene.GetCoordinateSystem() and not scene.IsOnEarth():
        _tell_apart(scene, f"these heights are in '{place.GetCoordinateSystemName()}'")
        return lay_out(image)
    reproject = vtkTerrainReproject()
    reproject.SetInputData(image)
    reproject.SetGeoreference(scene)
    reproject.SetEdgeCells(edge)
    _run(reproject, reproject.Update)
    if reproject.GetErrorMessage():
        raise ValueError(reproject.GetErrorMessage())
    tell(reproject)
    return reproject.GetOutput()


def is_grid_of(place, scene):
    """Whether the own grid of a place is that of a scene."""
    return scene.GetFrame() == vtkTerrainGeoreference.FrameType.Grid and (
        scene.GetSceneCoordinateSystem() == place.GetSceneCoordinateSystem())


def _begin(scene, place, frame):
    scene.SetCoordinateSystem(place.GetCoordinateSystem())
    scene.SetExtent(*place.GetExtent())
    scene.SetFrame(frame)
    origin = [0.0, 0.0, 0.0]
    scene.GetOrigin(origin)
    if np.isfinite(origin).all():
        scene.SetOrigin(*origin)


def _tell_apart(scene, why):
    """Warns that something does not lie where it should beside what a scene holds, if that holds anything."""
    if scene is not None and scene.GetCoordinateSystem():
        warnings.warn(f"{why}, the scene is of '{scene.GetCoordinateSystemName()}': they lie at their own coordinates, "
                      "not in their place beside the others", stacklevel=5)


def _join_grid(image, place, scene):
    """Heights of another world or of a local grid, in the scene of others of the same system."""
    grid = vtkTerrainGeoreference.FrameType.Grid
    place.SetFrame(grid)
    if scene is None:
        return image
    own = [_pair(image, name) for name in ("LayoutOrigin", "LayoutScale")]
    if not scene.GetCoordinateSystem():
        _begin(scene, place, grid)
        scene.layout = own
        return image
    layout = getattr(scene, "layout", None)
    if layout is None or place.GetCoordinateSystem() != scene.GetCoordinateSystem():
        _tell_apart(scene, f"these heights are in '{place.GetCoordinateSystemName()}'")
        return image
    if any(pair is None for pair in own + layout):
        return image
    # Degrees are laid out in metres round the middle of each file: brought into the layout of the first.
    moved = image.NewInstance()
    moved.ShallowCopy(image)
    factor = layout[1] / own[1]
    shift = (own[0] - layout[0]) * layout[1]
    moved.SetSpacing(*(np.array(image.GetSpacing()[:2]) * factor), image.GetSpacing()[2])
    moved.SetOrigin(*(np.array(image.GetOrigin()[:2]) * factor + shift), image.GetOrigin()[2])
    for name, pair in zip(("LayoutOrigin", "LayoutScale"), layout):
        moved.GetFieldData().RemoveArray(name)
        array = numpy_to_vtk(pair.reshape(1, 2).copy(), deep=True)
        array.SetName(name)
        moved.GetFieldData().AddArray(array)
    return moved


def _pair(image, name):
    array = image.GetFieldData().GetArray(name)
    return None if array is None else np.array(array.GetTuple(0))


def join_as_it_is(scene, actor, name):
    """Begins a scene with a file that is drawn as it stands, or says in one warning that it lies apart.

    Prepared files, and rasters that are drawn from tiles, are not resampled.
    """
    place = vtkTerrainGeoreference()
    place.SetFrame(vtkTerrainGeoreference.FrameType.Grid)
    if actor.GetHeights() is not None:
        place.SetFromHeights(actor.GetHeights())
    else:
        place.SetCoordinateSystem(actor.GetHierarchy().GetCoordinateSystem())
    if place.IsGeographic():
        if not scene.GetCoordinateSystem():
            scene.apart = name
        _tell_apart(scene, f"the heights of '{name}' are drawn as they stand, in degrees laid out round their middle "
                    "(gdalwarp brings them into metres)")
    elif not place.GetCoordinateSystem():
        _tell_apart(scene, f"the heights of '{name}' have no coordinate system")
    elif not scene.GetCoordinateSystem():
        _begin(scene, place, vtkTerrainGeoreference.FrameType.Grid)
    elif not is_grid_of(place, scene):
        _tell_apart(scene, f"the heights of '{name}' are drawn as they stand, in '{place.GetCoordinateSystemName()}' "
                    "(gdalwarp brings them into another system)")


def tell_of_apart(scene):
    """Warns, once, beside what lies apart since it came before there was a scene."""
    name = getattr(scene, "apart", None)
    if name:
        scene.apart = None
        warnings.warn(f"'{name}', which was added before, is drawn as it stands, in degrees laid out round its middle: "
                      "other terrain does not lie in its place beside it (gdalwarp brings it into metres)",
                      stacklevel=4)
