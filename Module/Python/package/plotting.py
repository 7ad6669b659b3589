# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrain in PyVista's plotters.

>>> import pyvista
>>> from vtkterrain.plotting import add_terrain
>>> plotter = pyvista.Plotter()
>>> terrain = add_terrain(plotter, "dem.tif", exaggeration=1.5)
>>> plotter.show()

Where PyVista has components of plotters (0.48 and later), importing this module also makes
``plotter.terrain.add(heights, ...)`` and ``plotter.terrain.enable_picking(callback)``.
"""
import importlib.util
import numbers
import os
import sys
import warnings

import numpy as np
import pyvista
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData

from . import _supply
from ._actor import Terrain
from ._bars import add_bar
from ._ground import add_clip_plane, add_places, add_track, track_on  # noqa: F401
from ._intake import _run, join_as_it_is, knows_its_place, lay_on_globe, lay_out, make_reader, read, tell_of_apart
from ._looks import Scalars, color_terrain, is_covered, is_see_through, tell_of_open_walls
from ._looks import apply as apply_look
from ._shapes import check_plotter, take_coordinates, to_heights
from ._strata import add_strata
from .heights import array_from_heights, heights_from_array, to_array
from .vtkTerrain import vtkTerrainActor, vtkTerrainGeoreference, vtkTerrainHierarchy, vtkTerrainPicker

# Samples a side that every graphics driver takes; larger rasters are drawn at a level.
_LARGEST_TEXTURE = 16384
_SPECK = 0.1  # of the diagonal of all sites: smaller ones are not seen in one view of all
_OF_ARRAYS = ("spacing", "origin", "first_row", "coordinate_system", "x", "y")
_OF_FILES = ("band", "part")
_OF_PLACE = (*_OF_ARRAYS, *_OF_FILES, "crs", "nodata", "height_unit", "flip")


def _is_prepared(heights):
    return isinstance(heights, (str, os.PathLike)) and vtkTerrainHierarchy.IsPreparedFile(os.fspath(heights))


def _is_large(heights):
    """True for a file that is drawn from tiles."""
    if not isinstance(heights, (str, os.PathLike)):
        return False
    reader = make_reader(os.fspath(heights))
    reader.UseLevelsOn()
    reader.SetMaximumSize(_LARGEST_TEXTURE)
    _run(reader, reader.UpdateInformation)
    return reader.GetLevel() > 0


def heights_from(heights, *, scene=None, **place):
    """Heights as a ``vtkImageData``, from all that ``add_terrain`` takes.

    ``place`` are its options ``crs``, ``nodata``, ``height_unit``, ``flip``, ``band`` and ``part``, and
    those of ``heights_from_array``, which only plain arrays have.
    """
    if isinstance(heights, _LaidOut):
        return heights.image
    is_file = isinstance(heights, (str, os.PathLike))
    is_grid = isinstance(heights, vtkDataSet)
    is_array = not (is_file or is_grid or hasattr(heights, "dims"))
    wrong = [name for name in place if (name in _OF_ARRAYS and not is_array)
             or (name in _OF_FILES and not is_file) or is_grid]
    if wrong:
        kind = "plain arrays" if wrong[0] in _OF_ARRAYS else "files and arrays"
        raise TypeError(f"{', '.join(wrong)} can only be given for {kind}: "
                        f"{type(heights).__name__} tells where it lies")
    heights = to_heights(heights)
    if is_array:
        if "crs" in place:
            place.setdefault("coordinate_system", place.pop("crs"))
        take_coordinates(place, to_array(heights).shape)
        return lay_out(heights_from_array(heights, **place), scene)
    if isinstance(heights, vtkImageData):
        return lay_out(heights, scene)
    if is_file:
        return lay_out(read(_reader_of_file(heights, **place)), scene)
    from .xarrays import heights_from_dataarray

    return heights_from_dataarray(heights, scene=scene, **place)


class _LaidOut:
    """Heights in their scene, and the range of all that share their colours, if others do."""

    def __init__(self, image):
        self.image = image
        self.range = None


def _is_folder(heights):
    return isinstance(heights, (str, os.PathLike)) and os.path.isdir(heights)


def _reader_of_file(heights, **place):
    reader = make_reader(os.fspath(heights), **place)
    reader.UseLevelsOn()
    reader.SetMaximumSize(_LARGEST_TEXTURE)
    return reader


def _heights_of_sites(heights, scene, place):
    """Heights of all sites of a folder, that which covers most first; those that cannot join it warn."""
    reader = _reader_of_file(heights, **place)
    reader.WarnOfSitesOff()
    images = [_LaidOut(lay_out(read(reader), scene))]
    if reader.GetNumberOfSites() > 1:
        warnings.warn(f"the tiles of '{heights}' lie at {reader.GetNumberOfSites()} sites far from each other, a "
                      "terrain each (part=1 and so on draws one alone)", stacklevel=3)
    for site in range(1, reader.GetNumberOfSites() + 1):
        if site == reader.GetSite():
            continue
        try:
            images.append(_LaidOut(lay_out(read(_reader_of_file(heights, **place, part=site)), scene)))
        except (OSError, ValueError) as error:
            warnings.warn(f"site {site} of '{heights}' is not drawn (part={site} draws it alone): {error}",
                          stacklevel=3)
    return images


def _relief_of(heights):
    """The colours of a relief map between two heights."""
    actor = vtkTerrainActor()
    actor.SetInputData(heights_from_array(np.repeat([heights], 2, axis=0).astype(float), nodata="none"))
    return actor.GetLookupTable()


def _share_range(sites):
    """Lowest and highest of all heights, which each is told."""
    arrays = [array_from_heights(each.image) for each in sites]
    ranges = np.array([[np.nanmin(array), np.nanmax(array)] for array in arrays], dtype=float)
    for each in sites:
        each.range = ranges[:, 0].min(), ranges[:, 1].max()
    return sites[0].range


def _frame_one(plotter, actor):
    """Looks at one of several sites where a view of all would make specks of them."""
    def diagonal(bounds):
        return float(np.linalg.norm(np.diff(np.reshape(bounds, (3, 2)))))

    if diagonal(actor.GetBounds()) < _SPECK * diagonal(plotter.bounds):
        warnings.warn("they are too far from each other for one view, which shows the one that covers most "
                      "(plotter.reset_camera() shows all)", stacklevel=3)
        plotter.camera_position = plotter.get_default_cam_pos()
        plotter.reset_camera(render=False, bounds=actor.GetBounds())
        plotter.renderer.camera_set = True


def terrain_scene(plotter):
    """The ``vtkTerrainGeoreference`` of all terrain in a plotter's active renderer.

    The first heights of a known place set its frame and origin; later ones are brought into it.
    ``PlacesToScene`` brings longitude, latitude and height of anything else into it.
    """
    renderer = plotter.renderer
    if not hasattr(renderer, "_terrain_scene"):
        renderer._terrain_scene = vtkTerrainGeoreference()
    return renderer._terrain_scene


def _open(actor, path):
    """Draws a file; without VTK's own messages."""
    actor.GlobalWarningDisplayOff()
    try:
        return actor.SetFileName(path)
    finally:
        actor.GlobalWarningDisplayOn()


def _to_texture(texture):
    if isinstance(texture, (str, os.PathLike)):
        picture = pyvista.read_texture(texture)
        if knows_its_place(os.fspath(texture)):
            hides = ", which is not seen where the picture is transparent," if is_see_through(picture) else ""
            warnings.warn(f"texture '{os.fspath(texture)}' knows its place, but is drawn from border to border of the "
                          f"terrain{hides}: drape={os.fspath(texture)!r} lays it where it belongs", stacklevel=3)
        return picture
    if isinstance(texture, pyvista.Texture):
        return texture
    picture = np.asarray(texture)
    if picture.ndim != 3 or picture.shape[2] not in (3, 4):
        raise ValueError("texture must be a file, a pyvista.Texture or an array of rows, columns and 3 or 4 colours, "
                         f"not of shape {picture.shape}")
    return pyvista.Texture(picture)


def _check_words(scalar_bar_args, name, sun_angle, sky_light, scene):
    """What would else fail in other people's words."""
    if scalar_bar_args is not None and not isinstance(scalar_bar_args, dict):
        raise TypeError(f"scalar_bar_args must be a dict, as {{'title': 'Height'}}, not {scalar_bar_args!r}")
    if name is not None and not isinstance(name, str):
        raise TypeError(f"name must be a text, not {name!r}")
    if scene is not None and not isinstance(scene, vtkTerrainGeoreference):
        raise TypeError(f"scene must be a vtkTerrainGeoreference, not {type(scene).__name__}")
    for what, value, highest in (("sun_angle", sun_angle, 90), ("sky_light", sky_light, np.inf)):
        if not (isinstance(value, numbers.Real) and 0 <= value <= highest and np.isfinite(value)):
            raise ValueError(f"{what} must be a number from 0 to {highest}, not {value!r}")


def _follow_theme(theme, technique, options):
    """Edges, where a theme has them and nothing else is said."""
    if not theme.show_edges or options.get("show_edges") is not None:
        return
    if technique in ("mesh", "strips"):
        options["show_edges"] = True
        options.setdefault("edge_color", theme.edge_color)
    else:
        warnings.warn('the theme shows edges, and rays have none: technique="mesh" draws those of all cells, '
                      "show_edges=False ends this warning", stacklevel=3)


def _check_frame(frame, given, options):
    if frame not in (None, "globe"):
        raise ValueError(f"frame must be \"globe\" or None, not {frame!r}")
    if frame is None:
        return
    if given["technique"] != "pyramid":
        raise ValueError(f"a globe is drawn with the technique \"pyramid\", not {given['technique']!r}")
    unwanted = [word for word in ("sky_light", "silhouette", "block", "extract", "detail")
                if {**given, **options}.get(word)]
    if unwanted:
        raise ValueError(f"a globe has no {unwanted[0]}: leave it out, or draw the heights flat (frame=None)")


def _check_size(rows, columns):
    """Arrays are drawn whole or not at all."""
    if max(columns, rows) > _LARGEST_TEXTURE:
        raise ValueError(f"{rows} x {columns} samples are more than the {_LARGEST_TEXTURE} a side that drivers take: "
                         "write them to a file and give its name, which is drawn from tiles, or every second one")


def add_terrain(plotter, heights, *, technique="pyramid", exaggeration=1.0, scalars=None, cmap=None, clim=None,
                color=None, texture=None, opacity=1.0, show_scalar_bar=None, scalar_bar_args=None, name=None,
                reset_camera=None, pickable=True, render=True, label=None, scene=None, frame=None, shadows=False,
                sun_angle=0.53, sky_light=0.0, component=None, rgb=False, n_colors=256, flip_scalars=False,
                log_scale=False, nan_color=None, nan_opacity=1.0, above_color=None, below_color=None,
                categories=False, annotations=None, silhouette=None, **options):
    """Adds a heightfield to a plotter; returns the ``vtkterrain.plotting.Terrain``, a ``vtkTerrainActor``.

    Parameters
    ----------
    plotter : pyvista.Plotter
        What draws it.
    heights : array_like, pyvista.ImageData or other regular grid, xarray.DataArray, str or path
        Heights: an array of rows, from the south, and columns; an image of W x H x 1 points with one
        scalar each; a RectilinearGrid that is evenly spaced, whose scalars are heights, or a
        StructuredGrid on a regular grid, whose z are; a DataArray (see ``vtkterrain.xarrays``); or the
        name of any raster that GDAL opens, of any size, of a folder of tiles, or of a file of
        terrain-prepare. A folder of sites far from each other gives a terrain for each; that of the one
        that covers most is returned. A raster of more than 16384 samples a side is drawn from tiles, as
        far as a view needs them, after one pass over the file on first use.
    technique : {"pyramid", "linear", "exponential", "equidistant", "mesh", "strips"}
        How the surface is found. "pyramid" is exact; "mesh" draws all cells as triangles, "strips"
        as few as the view needs. Of a prepared file, "strips" reads no more than it draws.
    exaggeration : float or "auto"
        Drawn height over true height, above 0; "auto" chooses it so that a view of all shows the relief.
    scalars : str, path or array_like, optional
        What the colours show instead of the heights: "slope" or "aspect", the name of an array of the
        heights' image, that of a raster file of any coordinate system (``vtkTerrainValues``; classes are
        not mixed), or an array of the heights' shape, rows from the south. Arrays of 3 or 4 bytes a sample
        are colours as they are; all others are mapped by cmap, single bytes and bools, too.
    cmap : str, list or matplotlib colormap, optional
        Colours of the heights; those of a relief map by default, from the lowest to the highest, or
        those of a theme that has another cmap than PyVista's own. For other scalars the theme's. A name is
        one of matplotlib, of colorcet, cmocean or cmcrameri where they are installed ("topo", "cmocean.topo"),
        or of ``vtkTerrainColors`` ("oleron", "bukavu", "batlow", ...); "_r" behind it turns it round.
    clim : (float, float) or float, optional
        Values of the first and last colour; the lowest and the highest that are seen by default.
    n_colors, flip_scalars, log_scale, nan_color, nan_opacity, above_color, below_color, component, rgb, \
    categories, annotations, silhouette
        As those of ``pyvista.Plotter.add_mesh``. A silhouette is that of the mesh ``surface``.
    color : ColorLike, optional
        One colour for all, instead of colours of the heights.
    texture : pyvista.Texture, array_like, str or path, optional
        A picture that spans the terrain, its upper edge in the north, instead of colours of the
        heights, unless there is a color, which it is multiplied with. One that knows its place is a
        ``drape``; here it gives a warning.
    opacity : float, str or array_like
        1 is opaque, 0 not seen; the name of a transfer function or a list is the opacity of the colours,
        as in ``add_mesh``; an array of the heights' shape, or the name of one of the image's arrays, is
        that of each sample, 0 to 1.
    show_scalar_bar : bool, optional
        Whether to show a bar of the colours; the theme's setting by default, and not where a drape hides
        them all. The bar is this terrain's
        alone and goes with it. Where its title is taken, it has the terrain's name or a number beside it.
    scalar_bar_args : dict, optional
        Options of ``pyvista.Plotter.add_scalar_bar``.
    name, reset_camera, pickable, render, label
        As those of ``pyvista.Plotter.add_mesh``.
    scene : vtkTerrainGeoreference, optional
        Frame and origin that the heights are brought into; by default those of the plotter
        (``terrain_scene``), so that tiles that are added one by one meet.
    frame : {"globe"}, optional
        "globe" draws heights in longitude and latitude on the ellipsoid of their coordinate system, of
        any planet (``vtkTerrainGlobe``): the scene of the plotter is then geocentric, in metres. It
        needs the technique "pyramid", and goes without sky_light, silhouette, block, extract and detail.
    shadows : bool
        Whether the surface lies in its own shadow, of all lights of the plotter but a headlight.
    sun_angle : float
        Angular diameter in degrees, 0 to 90, of lights far away, for the edges of shadows; 0 for hard
        ones, which those on a globe always are.
    sky_light : float
        Light of the sky over that of a light of intensity 1, as far as it is seen over the surface.
    **options
        Of the look: ``contours`` (True or their distance), ``contour_index`` (every n-th line is twice as
        wide; 0 for none), ``hillshade`` (True, or azimuth and altitude of its sun in degrees), ``block``
        (True or the height of its floor), ``strata`` (layers on its sides from the surface down,
        ``[("sienna", 150.0), ("tan", 250.0), "grey"]`` or ``"sienna=150,tan=250,grey"``), ``drape`` (the name of a
        picture that knows its place, brought there by GDAL), ``extract`` (((first, last) column,
        (first, last) row)), ``detail`` (an image of ``vtkTerrainDetailSource``), ``user_matrix``, and
        those of ``pyvista.Property``: ``lighting``, ``ambient``, ``diffuse``, ``specular``,
        ``specular_power``, ``culling``, ``pbr``, ``metallic``, ``roughness``, and of the techniques
        "mesh" and "strips", for rays have neither edges nor lines nor points: ``style``,
        ``line_width``, ``point_size``, ``show_edges``, ``edge_color``, ``edge_opacity``.
        Of the place, what the heights do not say, or say wrongly: ``crs``, ``nodata`` (a value, or
        "none"), ``height_unit`` ("ft", "-m", 0.3048), ``flip``, of files also ``band`` and ``part``. For
        a plain array: ``spacing``, ``origin``, ``first_row``, ``coordinate_system``, as
        ``vtkterrain.heights_from_array`` takes them, or ``x`` and ``y``, even coordinates, one a column
        and a row or as ``numpy.meshgrid`` gives them, without ``spacing``, ``origin`` and ``first_row``.
    """
    given = dict(locals())
    check_plotter(plotter)
    _supply.warn_without_opengl()
    _check_words(scalar_bar_args, name, sun_angle, sky_light, scene)
    actor = Terrain()
    techniques = {key.lower(): value for key, value in vars(type(actor.GetTechnique())).items()
                  if key[0] != "_"}
    if technique not in techniques:
        raise ValueError(f"technique must be one of {', '.join(techniques)}, not {technique!r}")
    is_auto = isinstance(exaggeration, str) and exaggeration == "auto"
    actor.exaggeration = 1.0 if is_auto else exaggeration
    actor.SetTechnique(techniques[technique])
    has_rays = technique not in ("mesh", "strips")
    if has_rays and isinstance(heights, np.ndarray) and heights.ndim == 2:
        _check_size(*heights.shape)  # before it is looked through
    place = {key: options.pop(key) for key in tuple(options) if key in _OF_PLACE}
    _check_frame(frame, given, options)
    scene = scene or terrain_scene(plotter)
    tell_of_apart(scene)
    is_drawn_as_it_is = not place and frame is None and (_is_prepared(heights) or _is_large(heights))
    if frame == "globe":
        scene.SetFrame(vtkTerrainGeoreference.FrameType.Globe)
    others = []
    if not is_drawn_as_it_is and _is_folder(heights) and "part" not in place:
        heights, *others = _heights_of_sites(heights, scene, place)
        place = {}
        if others and not any(given[word] is not None for word in ("clim", "scalars", "color", "texture")):
            clim = _share_range([heights, *others])
    if frame == "globe":
        actor.SetInputData(lay_on_globe(heights_from(heights, scene=scene, **place)))
    elif not is_drawn_as_it_is:
        actor.SetInputData(heights_from(heights, scene=scene, **place))
    elif _open(actor, os.fspath(heights)):
        actor._file = os.fspath(heights)
    else:
        raise OSError(actor.GetErrorMessage())
    if actor.GetHeights() is not None and has_rays:
        _check_size(*actor.GetHeights().GetDimensions()[1::-1])
    if isinstance(heights, _LaidOut) and heights.range:
        actor.SetLookupTable(_relief_of(heights.range))
    if not actor.HasSurface():
        raise ValueError("there is no surface to draw: no four neighbouring samples all have heights")
    if is_drawn_as_it_is:
        join_as_it_is(scene, actor, os.fspath(heights))
    if is_auto:
        actor.exaggeration = "auto"
    actor.SetSunShadows(bool(shadows))
    actor.SetSunAngle(sun_angle)
    actor.SetSkyLight(sky_light)
    actor.own_surface()
    colors = {"cmap": cmap, "clim": clim, "n_colors": n_colors, "flip_scalars": flip_scalars, "log_scale": log_scale,
              "nan_color": nan_color, "nan_opacity": nan_opacity, "above_color": above_color,
              "below_color": below_color, "categories": categories, "annotations": annotations}
    texture = texture if texture is None else _to_texture(texture)
    shown = None
    if color is None and texture is None:
        shown = Scalars(actor, scalars, component=component, rgb=rgb, scene=scene)
    _follow_theme(plotter.theme, technique, options)
    strata = options.pop("strata", None)
    apply_look(actor, scene, **options)
    if strata is None:
        tell_of_open_walls(actor)
    table = color_terrain(actor, shown, plotter.theme, color, texture, opacity, colors)
    plotter.add_actor(actor, name=name, reset_camera=reset_camera, pickable=pickable, render=False)
    if show_scalar_bar is None:
        show_scalar_bar = plotter.theme.show_scalar_bar and not is_covered(actor)
    if table is not None and show_scalar_bar and not shown.is_color:
        add_bar(plotter, actor, table, shown.title, name, scalar_bar_args)
    plotter.mapper = actor.mapper
    if strata is not None:
        add_strata(plotter, actor, strata)
    if silhouette:
        plotter.add_silhouette(actor.surface, **({} if silhouette is True else silhouette))
    for number, site in enumerate(others, 2):
        is_named = {} if name is None else {"name": f"{name} {number}"}
        words = {**given, **options, **is_named, "scene": scene, "exaggeration": actor.exaggeration,
                 "clim": clim, "show_scalar_bar": False,
                 "label": None, "render": False}
        add_terrain(heights=site, **{key: word for key, word in words.items() if key not in ("heights", "options")})
    if others and reset_camera is None and not plotter.renderer.camera_set:
        _frame_one(plotter, actor)
    if label is not None:
        plotter.renderer._labels[actor.GetAddressAsString("")] = (
            pyvista.Rectangle(), label, pyvista.Color(color or "tan"))
    if render:
        plotter.render()
    return actor


def enable_terrain_picking(plotter, callback, *, side="right"):
    """Calls ``callback(point, picker)`` for each click on a terrain.

    ``point`` is where on the surface it was, as drawn, an array of three numbers; ``picker`` is a
    ``vtkTerrainPicker`` that tells the rest (``GetHeight``, ``GetGridPosition``, ``GetValue``,
    ``GetPickNormal``, ``GetActor``). ``side`` is the button of the mouse, "left" or "right".
    """
    picker = vtkTerrainPicker()

    def pick(_):
        column, row = plotter.iren.get_event_position()
        picker.Pick(column, row, 0.0, plotter.iren.get_poked_renderer(column, row))
        if picker.IsTerrainPicked():
            callback(np.array(picker.GetPickPosition()), picker)

    plotter.iren.track_click_position(pick, side=side, viewport=True)


class TerrainComponent:
    """Terrain as ``plotter.terrain``."""

    def __init__(self, plotter):
        self._plotter = plotter

    def add(self, heights, **options):
        """``add_terrain`` for this plotter."""
        return add_terrain(self._plotter, heights, **options)

    def enable_picking(self, callback, **options):
        """``enable_terrain_picking`` for this plotter."""
        enable_terrain_picking(self._plotter, callback, **options)


def _view_in_browsers():
    """The view of trame that is brought up to date, and whether the server renders it; (None, False) for none."""
    frame = sys._getframe(2)
    while frame is not None:
        view = frame.f_locals.get("self")
        if hasattr(view, "update_geometry") or type(view).__name__.endswith("LocalView"):
            plotter = view._plotter() if hasattr(view, "_plotter") else None
            key = f"{getattr(plotter, '_id_name', None)}_use_server_rendering"
            is_update = frame.f_code.co_name == "update_geometry"
            return view, is_update and bool(view.server.state[key] if view.server.state.has(key) else False)
        frame = frame.f_back
    return None, False


def _warn_of_browsers(text):
    """Warns once a view that a browser renders, each time that one is shown."""
    view, is_of_server = _view_in_browsers()
    if is_of_server or getattr(view, "_is_told_of_terrain", False):
        return
    if view is not None:
        view._is_told_of_terrain = True
    # A registry of its own: Python says the same words at the same place once only.
    warnings.warn_explicit(f"a browser that renders by itself (mode \"client\") cannot show {text}: use the mode "
                           "\"server\"", RuntimeWarning, __file__, 0, registry={})


def _serialize_surface(parent, terrain, terrain_id, context, depth):
    """What a browser that renders by itself (PyVista's mode "client") gets in place of a terrain: a mesh."""
    from trame_vtk.modules.vtk.serializers.registry import SERIALIZERS

    surface = terrain.GetSurfaceActor()
    if surface is None:
        _warn_of_browsers("strips of a prepared file, nor a globe")
        return None
    _warn_of_browsers(f"terrain, only a mesh of it, within {terrain.GetUsedSurfaceError():.3g} of each height")
    terrain.GetSurface()
    return SERIALIZERS["vtkOpenGLActor"](parent, surface, terrain_id, context, depth)


def _prepare_for_browsers():
    """Lets trame's serializer, if there is one, say what a browser cannot do, instead of showing nothing."""
    if importlib.util.find_spec("trame_vtk"):
        from trame_vtk.modules.vtk.serializers import registry

        for name in ("vtkTerrainActor", "Terrain"):
            registry.register_instance_serializer(name, _serialize_surface)


_prepare_for_browsers()
if hasattr(pyvista, "register_plotter_component"):
    pyvista.register_plotter_component("terrain")(TerrainComponent)
