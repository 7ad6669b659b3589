# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of terrain-render in PyVista's plotters.

>>> import pyvista
>>> from vtkterrain.scenes import add_scene
>>> plotter = pyvista.Plotter()
>>> terrain = add_scene(plotter, "view.toml")
>>> plotter.show()
"""
import os
import warnings

import numpy as np
import pyvista

from ._colors import sample_colors
from ._strata import add_strata
from .plotting import add_terrain, terrain_scene
from .vtkTerrain import vtkTerrainViewpoint

_FILES = ("heights", "drape", "track", "polygons", "labels", "output", "depth", "stats")
_FILES_OR_WORDS = ("colors", "detail", "flight", "color-by", "track-colors", "polygon-colors")
# Of the files that terrain-render writes, and of how it draws: nothing of them is seen.
_OF_THE_PROGRAM = ("output", "depth", "stats", "frames", "piece", "dpi", "window", "memory", "largest-texture",
                   "no-cache", "legend", "size")
_OF_TERRAIN = {"technique": "technique", "exaggeration": "exaggeration", "shadows": "shadows", "sun-angle": "sun_angle",
               "contours": "contours", "contour-index": "contour_index", "strata": "strata", "hillshade": "hillshade",
               "drape": "drape", "crs": "crs", "band": "band", "part": "part", "nodata": "nodata",
               "height-unit": "height_unit", "flip": "flip"}


def read_scene(path):
    """The options of a scene of terrain-render, as ``--save-scene`` writes it: a dict by their names.

    Values are as in the file: text, numbers, bools, and lists; names of files are those that open from here.
    Raises OSError if the file cannot be read, ValueError with its line if it is no scene.
    """
    try:
        import tomllib
    except ImportError:  # Python 3.10
        try:
            import tomli as tomllib
        except ImportError as error:
            raise ImportError("scenes are read by Python 3.11 and later, or with the package tomli") from error
    path = os.fspath(path)
    with open(path, "rb") as file:
        try:
            options = tomllib.load(file)
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
            raise ValueError(f"{path!r} is no scene: {error}") from error
    tables = [key for key, value in options.items() if isinstance(value, dict)]
    if tables:
        raise ValueError(f"{path!r} is no scene: it has a section [{tables[0]}]")
    return {key: _from_scene(key, value, os.path.dirname(path)) for key, value in options.items()}


def _from_scene(key, value, folder):
    """A value whose names of files are not relative to the scene any more."""
    if isinstance(value, list):
        return [_from_scene(key, one, folder) for one in value]
    there = os.path.join(folder, value) if isinstance(value, str) else ""
    is_file = key in _FILES and isinstance(value, str) and ":" not in value
    return there if is_file or (key in (*_FILES, *_FILES_OR_WORDS) and os.path.exists(there)) else value


def _numbers(options, key, counts):
    """The numbers of an option, with commas between them in the scene."""
    try:
        numbers = [float(number) for number in str(options[key]).split(",")]
    except ValueError:
        numbers = []
    if len(numbers) not in counts:
        raise ValueError(f"{key} of the scene must be {' or '.join(map(str, counts))} numbers, not {options[key]!r}")
    return numbers


def _colors(scene, left):
    """Words of ``add_terrain`` for the colours of a scene; what PyVista has no colours for is left."""
    words = {}
    if scene.get("colors", "relief") != "relief":
        try:
            sample_colors(scene["colors"])
            words["cmap"] = scene["colors"]
        except ValueError:
            left.append(f"colors={scene['colors']}")
    if "range" in scene:
        words["clim"] = _numbers(scene, "range", (2,))
    if scene.get("reverse"):
        words["flip_scalars"] = True
    return words


def _set_sun(plotter, viewpoint, sun):
    """The light of a sun by its azimuth and altitude, or of a time, in place of all but headlights."""
    light = pyvista.Light(light_type="scene light", positional=False)
    if vtkTerrainViewpoint.GetWhyNoTime(sun):
        azimuth, altitude = np.radians(_numbers({"sun": sun}, "sun", (2,)))
        light.position = (np.sin(azimuth) * np.cos(altitude), np.cos(azimuth) * np.cos(altitude), np.sin(altitude))
        light.focal_point = (0.0, 0.0, 0.0)
    else:
        why_not = viewpoint.SetSun(sun, light)
        if why_not:
            raise ValueError(f"sun of the scene: {why_not}")
    for other in list(plotter.renderer.lights):
        if not other.is_headlight:
            plotter.renderer.RemoveLight(other)
    plotter.add_light(light)


def _set_camera(plotter, viewpoint, options):
    """Whether the scene says where the eye is."""
    camera = plotter.camera
    if "view-angle" in options:
        camera.view_angle = float(options["view-angle"])
    if "camera" in options:
        numbers = _numbers(options, "camera", (6, 9))
        camera.position, camera.focal_point = numbers[:3], numbers[3:6]
        camera.up = numbers[6:] or (0.0, 0.0, 1.0)
    elif "look-from" in options and "look-at" in options:
        why_not = viewpoint.Look(options["look-from"], options["look-at"], camera)
        if why_not:
            raise ValueError(f"look-from of the scene: {why_not}")
    else:
        return False
    camera.is_set = True
    plotter.reset_camera_clipping_range()
    return True


def _set_background(plotter, background):
    low, _, high = background.partition(",")
    plotter.set_background(low, top=high or None)


def add_scene(plotter, path, **options):
    """Draws a scene of terrain-render in a plotter; returns the terrain, as ``add_terrain`` does.

    Heights with their place, colours, contours, hillshade, block, drape, sun, shadows, sky, camera, background, title,
    caption and legend are those of the scene; one warning names its options that are not drawn here. ``size`` becomes
    the window's. What terrain-render writes (``output``, ``stats``, ...) is left alone.

    Parameters
    ----------
    plotter : pyvista.Plotter
        What draws it.
    path : str or path
        A file of ``terrain-render --save-scene``.
    **options
        Options of ``add_terrain`` that win over those of the scene.
    """
    scene = read_scene(path)
    if "heights" not in scene:
        raise ValueError(f"{os.fspath(path)!r} names no heights: the landscape that is built into terrain-render is "
                         "not drawn here")
    given = {_OF_TERRAIN[key]: value for key, value in scene.items() if key in _OF_TERRAIN}
    if "nodata" in given:
        given["nodata"] = given["nodata"] if given["nodata"] == "none" else float(given["nodata"])
    if "sky-light" in scene:
        given["sky_light"] = 0.35 if scene["sky-light"] is True else float(scene["sky-light"])
    if scene.get("color-by") in ("slope", "aspect"):
        given["scalars"] = scene["color-by"]
    drawn = {"heights", "sky-light", "colors", "range", "reverse", "block", "sun", "camera", "look-from", "look-at",
             "view-angle", "background", "title", "caption", *_OF_TERRAIN, *_OF_THE_PROGRAM}
    left = [key for key in scene if key not in drawn and not (key == "color-by" and "scalars" in given)]
    given.update(_colors(scene, left))
    if scene.get("background") in ("sky", "transparent"):
        left.append(f"background={scene['background']}")
    if left:
        warnings.warn(f"of the scene {os.fspath(path)!r} this is not drawn: {', '.join(left)}", stacklevel=2)
    given["show_scalar_bar"] = "legend" in scene
    if isinstance(scene.get("legend"), str):
        given["scalar_bar_args"] = {"title": scene["legend"]}
    if "contours" in given:
        given.setdefault("contour_index", 5)  # as terrain-render has it
    words = {**given, **options, "render": False}
    strata = None if "block" in options else words.pop("strata", None)
    terrain = add_terrain(plotter, scene["heights"], **words)
    mapper = terrain.GetTerrainMapper()
    if "block" in scene and "block" not in options:
        heights = [0.0, 0.0]
        mapper.GetHeightRange(heights)
        mapper.SetBlockBase(heights[0] - float(scene["block"]))
        mapper.SetBlock(True)
    if strata is not None:
        add_strata(plotter, terrain, strata)
    _set_view(plotter, terrain, scene)
    if options.get("render", True):
        plotter.render()
    return terrain


def _set_view(plotter, terrain, scene):
    """What is around the terrain, and from where it is seen."""
    viewpoint = vtkTerrainViewpoint()
    viewpoint.SetGeoreference(terrain_scene(plotter))
    viewpoint.SetHeights(terrain.GetHeights())
    viewpoint.SetExaggeration(terrain.GetVerticalExaggeration())
    if "size" in scene:
        plotter.window_size = [int(side) for side in scene["size"].split("x")]
    if "sun" in scene:
        _set_sun(plotter, viewpoint, scene["sun"].partition("/")[0])
    if scene.get("background") not in (None, "sky", "transparent"):
        _set_background(plotter, scene["background"])
    for key, edge in (("title", "upper_edge"), ("caption", "lower_edge")):
        if scene.get(key):
            plotter.add_text(scene[key], position=edge, font_size=18 if key == "title" else 9)
    _set_camera(plotter, viewpoint, scene)
