# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""How a terrain looks: options of ``add_terrain``, in PyVista's words and a few of its own."""
import numbers
import os
import warnings

import numpy as np
import pyvista
from matplotlib.colors import ListedColormap
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData

from ._actor import check_opacity
from ._bars import has_minus_zero, label_format
from ._colors import find_color_map, sample_colors
from ._intake import _run
from .heights import array_from_heights, to_array
from .vtkTerrain import vtkTerrainImageWarp, vtkTerrainLook, vtkTerrainValues

_NUMBER_OF_COLORS = 256
_MAP_SCALARS = 1  # VTK_COLOR_MODE_MAP_SCALARS
_SOURCES = vtkTerrainLook.ColorSources
# Colours of what the surface itself tells: source, title of the bar, first and last value; None for those of the data.
_OF_THE_SURFACE = {"slope": (_SOURCES.Slope, "Slope (degrees)", None),
                   "aspect": (_SOURCES.Aspect, "Aspect (degrees)", (0.0, 360.0))}
_PROPERTY = ("lighting", "ambient", "diffuse", "specular", "specular_power", "style", "culling", "line_width",
             "point_size", "show_edges", "edge_color", "edge_opacity", "metallic", "roughness")


def check_clim(clim):
    """Two numbers, the second above the first, of what PyVista takes for clim."""
    if isinstance(clim, numbers.Real):
        clim = (-clim, clim)
    try:
        low, high = (float(value) for value in clim)
    except (TypeError, ValueError) as error:
        raise ValueError(f"clim must be a number or two, not {clim!r}") from error
    if not (np.isfinite(low) and np.isfinite(high) and low < high):
        raise ValueError(f"clim must be two finite numbers, the second above the first, not {clim!r}")
    return low, high


def _is_visible(heights):
    samples = array_from_heights(heights)
    return np.isfinite(samples) & (np.abs(samples) < 1e30)


def _range(values, visible=None):
    values = values[np.isfinite(values) & (np.abs(values) < 1e30) & (True if visible is None else visible)]
    if not values.size:
        raise ValueError("scalars have no finite value where there is terrain")
    low, high = float(values.min()), float(values.max())
    return (low, high) if low < high else (low, low + 1.0)


def _attach(terrain, scalars, name="scalars"):
    """Adds an array of the heights' shape, rows from the south, to them; returns its name."""
    heights = terrain.GetHeights()
    rows, columns = (0, 0) if heights is None else heights.GetDimensions()[1::-1]
    if scalars.shape[:2] != (rows, columns) or scalars.ndim not in (2, 3):
        raise ValueError(f"{name} must have the shape of the heights as drawn, {rows} x {columns}, "
                         f"not {' x '.join(map(str, scalars.shape))}")
    if heights.GetDirectionMatrix().GetElement(1, 1) < 0:
        scalars = scalars[::-1]
    if scalars.dtype == bool:
        scalars = scalars.astype(np.uint8)
    array = numpy_to_vtk(np.ascontiguousarray(scalars).reshape(rows * columns, -1))
    array.SetName(name)
    image = heights.NewInstance()
    image.ShallowCopy(heights)  # the caller's image stays as it is
    image.GetPointData().AddArray(array)
    terrain.SetInputData(image)
    return name


def _attach_raster(terrain, path, scene):
    """Adds the values or classes of a raster file to the heights; returns the array's name and its title."""
    values = vtkTerrainValues()
    values.SetInputData(terrain.GetHeights())
    values.SetGeoreference(scene)
    values.SetFileName(path)
    _run(values, values.Update)
    if values.GetErrorMessage():
        raise ValueError(f"scalars: {values.GetErrorMessage()}")
    terrain.SetInputData(values.GetOutput())
    return "Values", f"{values.GetTitle()} ({values.GetUnit()})" if values.GetUnit() else values.GetTitle()


def _holds_colors(array):
    """Whether it has 3 or 4 bytes a tuple; one byte is a value."""
    return array.GetDataType() == VTK_UNSIGNED_CHAR and array.GetNumberOfComponents() in (3, 4)


def _is_raster(terrain, scalars):
    """Whether scalars are the name of a file, and of no array of the heights."""
    heights = terrain.GetHeights()
    if not isinstance(scalars, (str, os.PathLike)) or heights is None:
        return False
    data = (heights.GetPointData(), heights.GetCellData())
    return os.path.isfile(scalars) and not any(one.HasArray(os.fspath(scalars)) for one in data)


class Scalars:
    """What colours a terrain: its heights, its slope or aspect, or an array of the heights' image.

    Attributes: ``title`` of a bar, ``clim`` by default, ``is_color`` for colours as they are.
    """

    def __init__(self, terrain, scalars=None, *, component=None, rgb=False, scene=None):
        self.title = "Elevation"
        self.is_color = bool(rgb)
        if rgb and scalars is None:
            raise ValueError("rgb needs scalars: an array of 3 or 4 bytes a sample, or the name of one")
        self.name, self.values, self.is_of_points = None, None, True
        mapper = terrain.GetTerrainMapper()
        if scalars is None:
            if component is not None:
                raise ValueError("component needs scalars: heights have one")
            self.clim = tuple(terrain.GetLookupTable().GetRange())
            return
        if isinstance(scalars, str) and scalars in _OF_THE_SURFACE:
            source, self.title, clim = _OF_THE_SURFACE[scalars]
            self.clim = clim or (0.0, terrain.SuggestSteepestSlope(terrain.GetHeights()))
            mapper.SetColorSource(source)
            return
        title = None
        if _is_raster(terrain, scalars):
            name, title = _attach_raster(terrain, os.fspath(scalars), scene)
        else:
            name = scalars if isinstance(scalars, str) else _attach(terrain, np.asarray(to_array(scalars, "scalars")))
        array = terrain.GetHeights().GetPointData().GetArray(name) if terrain.GetHeights() else None
        of_cells = terrain.GetHeights().GetCellData().GetArray(name) if array is None and terrain.GetHeights() else None
        if array is None and of_cells is None:
            raise ValueError(f"the heights have no array {name!r}: scalars is the name of one or of a raster file, "
                             "\"slope\", \"aspect\", or an array of their shape")
        self.title = title or name
        if of_cells is None:
            mapper.SetScalarModeToUsePointFieldData()
        else:
            mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(name)
        mapper.SetColorSource(_SOURCES.Array)
        chosen = array if of_cells is None else of_cells
        self.is_color = self.is_color or (component is None and _holds_colors(chosen))
        if self.is_color:
            if not _holds_colors(chosen):
                raise ValueError(f"rgb needs 3 or 4 bytes (uint8) a sample, the array {name!r} has "
                                 f"{chosen.GetNumberOfComponents()} of {chosen.GetDataTypeAsString()}")
            mapper.SetColorModeToDirectScalars()
            self.clim = (0.0, 255.0)
            return
        mapper.SetColorModeToMapScalars()  # bytes are values, too
        self.is_magnitude = component is None and chosen.GetNumberOfComponents() > 1
        mapper.SetArrayComponent(-1)  # the table's
        self.component = component
        self.name, self.is_of_points = name, of_cells is None
        self.clim = self._find_range(array if of_cells is None else of_cells, terrain, of_cells is None, component)

    def _find_range(self, array, terrain, is_of_points, component):
        values = vtk_to_numpy(array)
        count = array.GetNumberOfComponents()
        if component is not None and not (isinstance(component, numbers.Integral) and 0 <= component < count):
            raise ValueError(f"component must be 0 to {count - 1} of the array {array.GetName()!r}, not {component!r}")
        if values.ndim > 1:
            values = np.linalg.norm(values.astype(float), axis=1) if component is None else values[:, component]
        self.values = values
        if not is_of_points:
            return _range(values)
        heights = terrain.GetHeights()
        visible = _is_visible(heights)
        if heights.GetDirectionMatrix().GetElement(1, 1) < 0:
            visible = visible[::-1]
        return _range(values, visible.ravel())


def _number_of_categories(terrain, scalars, categories):
    if categories is not True:
        return int(categories)
    values = scalars.values
    if values is None and scalars.title != "Elevation":
        raise ValueError("categories are those of the heights or of an array, not of a slope or an aspect")
    if values is None:
        values = array_from_heights(terrain.GetHeights())
    return len(np.unique(values[np.isfinite(values)]))


def _check_colors(n_colors):
    if not isinstance(n_colors, numbers.Integral) or not 0 < n_colors <= 65536:
        raise ValueError(f"n_colors must be a whole number from 1 to 65536, not {n_colors!r}")


def _tidy_range(low, high, labels=5):
    """A range none of whose labels is "-0": what is rounded to 0 becomes 0, by less than a label tells.

    So far below 0 there is the overshoot of a resampling, or the middle of values that are as far below 0 as above.
    """
    text = label_format(low, high)
    for share in np.linspace(0.0, 1.0, labels):
        if not has_minus_zero(text % (low + share * (high - low))):
            continue
        if share == 1.0:
            return low, 0.0
        # The lowest value moves; a trifle more, for VTK's own sum of the same is not to end below 0 again.
        return -high * share / (1.0 - share) * (1.0 - 1e-12), high
    return low, high


def _to_color_map(cmap):
    """What PyVista takes for a cmap, of the name of any that is known here."""
    if not isinstance(cmap, str):
        return cmap
    found = find_color_map(cmap)
    return ListedColormap(sample_colors(cmap), name=cmap) if found is None else found


def make_table(terrain, scalars, theme, *, cmap=None, clim=None, n_colors=_NUMBER_OF_COLORS, flip_scalars=False,
               log_scale=False, nan_color=None, nan_opacity=1.0, above_color=None, below_color=None, opacity=None,
               categories=False, annotations=None):
    """The ``pyvista.LookupTable`` of a terrain's colours; a relief map's for heights without a cmap.

    A theme whose cmap is not PyVista's own one gives its cmap to heights, too.
    """
    clim = _tidy_range(*scalars.clim) if clim is None else check_clim(clim)
    _check_colors(n_colors)
    if categories:
        n_colors = _number_of_categories(terrain, scalars, categories)
    if cmap == "relief" and scalars.title == "Elevation":
        cmap = None
    elif cmap is None and theme.cmap != type(pyvista.global_theme)().cmap:
        cmap = theme.cmap
    if log_scale and not clim[0] > 0.0:
        raise ValueError(f"log_scale needs values above 0, these begin at {clim[0]:g}: give clim")
    if cmap is None and scalars.title == "Elevation":
        relief = terrain.GetLookupTable()
        at = np.geomspace(*clim, n_colors) if log_scale else np.linspace(*clim, n_colors)
        table = pyvista.LookupTable(n_values=n_colors)
        table.values = [[*(round(255 * part) for part in relief.GetColor(height)), 255] for height in at]
        if flip_scalars:
            table.values = table.values[::-1]
    else:
        table = pyvista.LookupTable(theme.cmap if cmap is None else _to_color_map(cmap), n_values=n_colors,
                                    flip=flip_scalars)
    table.scalar_range = clim
    table.log_scale = bool(log_scale)
    table.nan_color = pyvista.Color(theme.nan_color if nan_color is None else nan_color, opacity=nan_opacity)
    if annotations is not None:
        table.annotations = annotations
    if above_color is not None:
        table.above_range_color = above_color
    if below_color is not None:
        table.below_range_color = below_color
    if opacity is not None:
        table.apply_opacity(opacity)
    component = getattr(scalars, "component", None)
    if component is not None:
        table.SetVectorModeToComponent()
        table.SetVectorComponent(component)
    elif getattr(scalars, "is_magnitude", False):
        table.SetVectorModeToMagnitude()
    return table


def is_of_samples(opacity, terrain):
    """Whether an opacity is one of samples: the name of an array of the heights, or an array of their shape."""
    if isinstance(opacity, str):
        heights = terrain.GetHeights()
        return heights is not None and heights.GetPointData().HasArray(opacity) > 0
    return to_array(opacity, "opacity").ndim > 1


def apply_opacity(terrain, scalars, table, opacity):
    """Gives each sample the colour of the table and an opacity of its own, 0 to 1."""
    if scalars.is_color or not scalars.is_of_points or (scalars.name is None and scalars.title != "Elevation"):
        raise ValueError("an opacity of samples needs colours of the heights or of a point array")
    heights = terrain.GetHeights()
    if isinstance(opacity, str):
        alpha = vtk_to_numpy(heights.GetPointData().GetArray(opacity)).astype(float)
        shape = heights.GetDimensions()[1::-1]
        alpha = alpha.reshape(shape) if alpha.ndim == 1 else None
        if alpha is not None and heights.GetDirectionMatrix().GetElement(1, 1) < 0:
            alpha = alpha[::-1]
    else:
        alpha = np.asarray(opacity, dtype=float)
    if alpha is not None and alpha.shape != heights.GetDimensions()[1::-1]:
        raise ValueError(f"opacity must have the shape of the heights as drawn, {heights.GetDimensions()[1]} x "
                         f"{heights.GetDimensions()[0]}, not {' x '.join(map(str, alpha.shape))}")
    if alpha is None or not (np.nanmin(alpha) >= 0.0 and np.nanmax(alpha) <= 1.0):
        raise ValueError("an opacity of samples must be one number each, from 0 to 1")
    array = heights.GetPointData().GetArray(scalars.name) if scalars.name else heights.GetPointData().GetScalars()
    component = getattr(scalars, "component", None)
    colors = table.MapScalars(array, _MAP_SCALARS, -1 if component is None else component)
    colors = vtk_to_numpy(colors).reshape(*alpha.shape, 4)
    if heights.GetDirectionMatrix().GetElement(1, 1) < 0:
        colors = colors[::-1]
    colors = np.concatenate([colors[..., :3], np.rint(255 * np.nan_to_num(alpha))[..., None].astype(np.uint8)], axis=2)
    name = _attach(terrain, colors, "opacity")
    mapper = terrain.GetTerrainMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    mapper.SetColorSource(_SOURCES.Array)
    mapper.SetColorModeToDirectScalars()
    terrain.prop.opacity = 1.0
    terrain.ForceTranslucentOn()


def color_terrain(terrain, scalars, theme, color, texture, opacity, options):
    """Sets the colours; returns their table, or None where they are no table's (``scalars`` is None then)."""
    opacity = 1.0 if opacity is None else opacity
    is_number = isinstance(opacity, numbers.Real)
    if is_number:
        check_opacity(opacity)
    table = None
    terrain.SetColorByHeight(scalars is not None)
    if scalars is not None:
        is_own = not is_number and is_of_samples(opacity, terrain)
        table = make_table(terrain, scalars, theme, opacity=None if is_number or is_own else opacity, **options)
        terrain.SetLookupTable(table)
        if is_own:
            apply_opacity(terrain, scalars, table, opacity)
    elif not is_number:
        raise ValueError(f"opacity must be a number where there is a color or a texture, not {opacity!r}")
    if is_number:
        terrain.opacity = opacity
    if color is not None:
        terrain.prop.color = color
    elif texture is not None:
        terrain.prop.color = "white"  # which the picture is multiplied with
    if texture is not None:
        terrain.SetTexture(texture)
    return table


def _set_contour_index(mapper, index):
    if not isinstance(index, numbers.Integral) or isinstance(index, bool) or index < 0:
        raise ValueError(f"contour_index must be 0 or a number of lines above it, not {index!r}")
    mapper.SetContourIndex(int(index))


def _set_contours(mapper, contours, heights):
    if contours is True:
        from .viewer import round_interval

        contours = round_interval(np.ptp(heights))
    if not (isinstance(contours, numbers.Real) and 0.0 < contours < np.inf):
        raise ValueError(f"contours must be True or a distance of heights above 0, not {contours!r}")
    mapper.SetContourInterval(contours)
    mapper.SetContours(True)


def _set_hillshade(mapper, hillshade):
    if hillshade is not True:
        try:
            azimuth, altitude = hillshade
        except TypeError as error:
            raise ValueError(f"hillshade must be True or (azimuth, altitude) in degrees, not {hillshade!r}") from error
        mapper.SetHillshadeAzimuth(azimuth)
        mapper.SetHillshadeAltitude(altitude)
    mapper.SetHillshade(True)


def _set_block(mapper, block, heights):
    if block is True:
        block = heights[0] - 0.1 * max(np.ptp(heights), 1e-9)
    if not (isinstance(block, numbers.Real) and block < heights[0]):
        raise ValueError(f"block must be True or a height below the lowest, {heights[0]:g}, not {block!r}")
    mapper.SetBlockBase(block)
    mapper.SetBlock(True)


def _set_drape(terrain, drape, scene):
    """A picture of a file, brought to its place."""
    if not isinstance(drape, (str, os.PathLike)):
        raise TypeError("drape must be the name of a picture that knows its place; texture spans the terrain")
    warp = vtkTerrainImageWarp()
    warp.SetInputData(terrain.GetHeights())
    warp.SetGeoreference(scene)
    warp.SetFileName(os.fspath(drape))
    _run(warp, warp.Update)
    if warp.GetErrorMessage():
        raise ValueError(f"drape {os.fspath(drape)!r}: {warp.GetErrorMessage()}")
    terrain.GetTerrainMapper().SetDrape(warp.GetOutput())


def _has_holes(image):
    """Whether a picture, of bytes, is transparent anywhere."""
    colors = image and image.GetPointData().GetScalars()
    return bool(colors) and colors.GetNumberOfComponents() in (2, 4) and bool((vtk_to_numpy(colors)[:, -1] < 255).any())


def is_see_through(texture):
    """Whether a texture is transparent anywhere."""
    return _has_holes(texture.GetInput())


def is_covered(terrain):
    """Whether a drape hides all colours below it."""
    look = terrain.GetTerrainMapper().GetLook()
    drape, heights = look.GetDrape(), terrain.GetHeights()
    if drape is None or heights is None:
        return False
    bounds = [0.0] * 4
    look.GetDrapeBounds(bounds)
    west, east, south, north = heights.GetBounds()[:4]
    across, along = drape.GetSpacing()[:2]  # as much may its border be off
    return (bounds[0] <= west + across and bounds[1] >= east - across and bounds[2] <= south + along
            and bounds[3] >= north - along and not _has_holes(drape))


def tell_of_open_walls(terrain):
    """Warns where a block has samples without a height along its sides, where it has no wall."""
    mapper, heights = terrain.GetTerrainMapper(), terrain.GetHeights()
    if not mapper.GetBlock() or heights is None:
        return
    known = _is_visible(heights)
    first, last = [0, 0], [0, 0]
    if mapper.GetExtract(first, last):
        known = known[max(first[1], 0):last[1] + 1, max(first[0], 0):last[0] + 1]
    sides = np.concatenate([known[0], known[-1], known[:, 0], known[:, -1]])
    if not sides.all():
        warnings.warn("the block has no wall where there is no height along its sides, "
                      f"{100.0 * (1.0 - sides.mean()):.2g} % of them: extract can leave that border out, strata closes "
                      "blocks round holes, too", stacklevel=3)


def _check_facets(smooth_shading):
    if smooth_shading is not None and not smooth_shading:
        raise ValueError("smooth_shading=False is not to be had: terrain has the normals of its surface, not of facets")


def apply(terrain, scene, *, contours=None, contour_index=0, hillshade=None, block=None, drape=None, extract=None,
          detail=None, user_matrix=None, lighting=None, smooth_shading=None, pbr=False, **properties):
    """Sets what is given; raises an error that names the option."""
    _check_facets(smooth_shading)
    unknown = [name for name in properties if name not in _PROPERTY]
    if unknown:
        hint = "; a sun is that of hillshade=(azimuth, altitude) or a light of the plotter" if "sun" in unknown else ""
        raise TypeError(f"add_terrain has no option {', '.join(unknown)}{hint}")
    mapper = terrain.GetTerrainMapper()
    heights = [0.0, 0.0]
    mapper.GetHeightRange(heights)
    if lighting is None:
        lighting = not hillshade
    terrain.prop.lighting = bool(lighting)
    for name, value in properties.items():
        if value is not None:
            setattr(terrain.prop, name, value)
    for option, setter in ((contours, _set_contours), (block, _set_block)):
        if option is not None and option is not False:
            setter(mapper, option, heights)
    _set_contour_index(mapper, contour_index)
    if hillshade is not None and hillshade is not False:
        _set_hillshade(mapper, hillshade)
    if drape is not None:
        _set_drape(terrain, drape, scene)
    if pbr:
        terrain.prop.interpolation = "Physically based rendering"
    if extract is not None:
        try:
            (west, east), (south, north) = extract
        except (TypeError, ValueError) as error:
            raise ValueError("extract must be ((first, last) column, (first, last) row), "
                             f"not {extract!r}") from error
        mapper.SetExtract((west, south), (east, north))
    if detail is not None:
        if not isinstance(detail, vtkImageData):
            raise TypeError(f"detail must be an image of vtkTerrainDetailSource, not {type(detail).__name__}")
        mapper.SetDetailData(detail)
    if user_matrix is not None:
        if not hasattr(user_matrix, "GetElement") and np.shape(user_matrix) not in ((3, 3), (4, 4)):
            raise ValueError(f"user_matrix must be 4 x 4 or 3 x 3 numbers, not {user_matrix!r}")
        terrain.user_matrix = user_matrix
