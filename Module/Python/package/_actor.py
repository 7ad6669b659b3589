# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""A terrain with the attributes that PyVista's actors have."""
import numbers
import sys

import numpy as np
import pyvista
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_DOUBLE, VTK_FLOAT
from vtkmodules.vtkCommonCore import vtkWeakReference
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes

from .heights import array_from_heights, heights_from_array, to_array
from .vtkTerrain import vtkTerrainActor, vtkTerrainLook

# What draws triangles, which have edges and corners to show.
_WITH_MESH = (vtkTerrainLook.Techniques.Mesh, vtkTerrainLook.Techniques.Strips)


def check_opacity(opacity):
    """Raises a ValueError for what is no opacity of a whole terrain."""
    if not (isinstance(opacity, numbers.Real) and 0.0 <= opacity <= 1.0):
        raise ValueError(f"opacity must be a number from 0, not seen, to 1, opaque, not {opacity!r}")


def weak_reference(terrain):
    """A reference to the object in VTK, whose wrapper in Python comes and goes with who holds it."""
    reference = vtkWeakReference()
    reference.Set(terrain)
    return reference


def _refuse_cells_of_heights():
    """Raises for the one consumer of PyVista that brings ids of cells which are not those of the mesh."""
    frame = sys._getframe(2)
    while frame is not None and "pyvista" in frame.f_code.co_filename:
        if frame.f_code.co_name == "visible_pick_callback":
            raise TypeError("what is seen of a terrain is cells of its heights, not of the mesh it hands out: use "
                            "enable_rectangle_through_picking, or a vtkHardwareSelector for ids of the heights' cells")
        frame = frame.f_back


class TerrainProperty(pyvista.Property):
    """The ``pyvista.Property`` of a terrain, which refuses what rays cannot show."""

    _reference = None

    def watch(self, terrain):
        """From here on its style and edges must be those that the terrain's technique has."""
        self._reference = weak_reference(terrain)

    def _terrain(self):
        return self._reference and self._reference.Get()

    @property
    def style(self):
        """"surface"; "wireframe" and "points" of the techniques that draw a mesh."""
        return pyvista.Property.style.fget(self)

    @style.setter
    def style(self, style):
        refuse_style(self._terrain(), style)
        pyvista.Property.style.fset(self, style)

    @property
    def show_edges(self):
        """Whether edges are drawn, of the techniques that draw a mesh."""
        return pyvista.Property.show_edges.fget(self)

    @show_edges.setter
    def show_edges(self, show):
        if show and _casts_rays(self._terrain()):
            raise ValueError('show_edges needs technique="mesh", which has all cells, or "strips": rays have no edges')
        pyvista.Property.show_edges.fset(self, show)


def _casts_rays(terrain):
    return terrain is not None and terrain.GetTechnique() not in _WITH_MESH


def refuse_style(terrain, style):
    """Raises a ValueError for lines or points of a terrain that is drawn by rays, which have none."""
    if _casts_rays(terrain) and str(style).lower() in ("wireframe", "points"):
        raise ValueError(f'style={style!r} needs technique="mesh", which has all cells, or "strips": rays have neither '
                         "lines nor points")


class SurfaceMapper:
    """What PyVista asks of an actor's mapper: the terrain as a mesh, made when it is asked for.

    All else is the ``vtkOpenGLTerrainMapper``'s, which ``GetTerrainMapper`` gives as it is.
    """

    def __init__(self, terrain):
        self._reference = weak_reference(terrain)

    def _terrain(self):
        return self._reference.Get()

    @property
    def dataset(self):
        """The surface as ``pyvista.PolyData``, see ``vtkTerrainActor.GetSurface``."""
        return self._terrain().surface

    def __setattr__(self, name, value):
        if not name.startswith("_") and not hasattr(type(self), name):
            raise AttributeError(f"a terrain's mapper has no attribute {name!r} to set; it has lookup_table and "
                                 "scalar_range")
        super().__setattr__(name, value)

    @property
    def lookup_table(self):
        """The colours in use."""
        return self._terrain().GetLookupTable()

    @lookup_table.setter
    def lookup_table(self, table):
        self._terrain().SetLookupTable(table)

    @property
    def scalar_range(self):
        """Values of the first and the last colour."""
        return tuple(self.lookup_table.GetRange())

    @scalar_range.setter
    def scalar_range(self, clim):
        self.lookup_table.SetRange(*clim)

    def __getattr__(self, name):
        return getattr(self._terrain().GetTerrainMapper(), name)

    def _get_dataset(self):
        _refuse_cells_of_heights()
        return self.dataset

    GetInput = GetDataSetInput = GetInputAsDataSet = _get_dataset

    def GetInputAlgorithm(self):  # noqa: N802
        """What makes the mesh; None without an image of heights, and on a globe."""
        surface = self._terrain().GetSurfaceActor()
        return surface and surface.GetMapper().GetInputAlgorithm()


class Terrain(vtkTerrainActor):
    """A ``vtkTerrainActor`` with attributes as those of ``pyvista.Actor``; unknown ones are refused.

    ``add_terrain`` returns it. What PyVista or VTK asks for as a mesh is made on demand, within
    ``surface_error`` of every sample.
    """

    def __init__(self):
        self._mapper = SurfaceMapper(self)
        self._name = None
        self._surface = None
        self._file = None
        self._own_color = None  # of the property, while a texture is in place of colours
        self._bar = None  # of its colours, in the plotter
        prop = TerrainProperty(interpolation="Gouraud", ambient=0.0, diffuse=1.0, specular=0.0)
        prop.watch(self)
        self.SetProperty(prop)
        self._prop = prop

    def __setattr__(self, name, value):
        if not name.startswith("_") and not hasattr(type(self), name):
            known = ", ".join(sorted(key for key, member in vars(Terrain).items() if isinstance(member, property)))
            raise AttributeError(f"a terrain has no attribute {name!r} to set; it has {known}")
        super().__setattr__(name, value)

    @property
    def prop(self):
        """The ``pyvista.Property``: colour, light, style.

        A style or edges that the technique cannot show are a ValueError: rays have neither lines nor
        points. Another property that is set here is asked once, when it is set.
        """
        return self._prop

    @prop.setter
    def prop(self, prop):
        refuse_style(self, getattr(prop, "style", "surface"))
        self.SetProperty(prop)
        self._prop = prop

    @property
    def name(self):
        """Its key in ``plotter.actors``."""
        return self._name

    @name.setter
    def name(self, name):
        self._name = name

    @property
    def mapper(self):
        """What PyVista asks of a mapper: ``dataset``, ``lookup_table``, ``scalar_range``."""
        return self._mapper

    def GetMapper(self):  # noqa: N802
        """The same, for those who ask in VTK's words."""
        return self._mapper

    @property
    def surface(self):
        """The surface as ``pyvista.PolyData``, within ``surface_error`` of every sample, exaggerated."""
        self.own_surface()
        return None if self.GetSurface() is None else self._surface

    def own_surface(self):
        """Lets the mesh, which is not made by that, be PyVista's, so that its pickers hand out one of theirs."""
        actor = self.GetSurfaceActor()
        if actor is not None and self._surface is None:
            self._surface = pyvista.PolyData()
            actor.GetMapper().GetInputAlgorithm().GetExecutive().SetOutputData(0, self._surface)

    @property
    def surface_error(self):
        """Largest vertical distance of a sample from ``surface``, in the unit of the heights."""
        return self.GetUsedSurfaceError()

    @surface_error.setter
    def surface_error(self, error):
        self.SetSurfaceError(float(error))

    @property
    def exaggeration(self):
        """Drawn height over true height, above 0; set "auto" to choose it so that relief is seen."""
        return self.GetVerticalExaggeration()

    @exaggeration.setter
    def exaggeration(self, factor):
        if isinstance(factor, str) and factor == "auto":
            factor = self.SuggestExaggeration(self.GetHeights())
        if not isinstance(factor, numbers.Real) or not 0.0 < factor < np.inf:
            raise ValueError(f"exaggeration must be 'auto' or a number above 0, not {factor!r}")
        self.SetVerticalExaggeration(factor)
        self.Modified()  # layers of a block follow

    @property
    def opacity(self):
        """1 is opaque, 0 not seen."""
        return self.GetProperty().GetOpacity()

    @opacity.setter
    def opacity(self, opacity):
        check_opacity(opacity)
        self.GetProperty().SetOpacity(opacity)

    @property
    def visibility(self):
        """Whether it is drawn."""
        return bool(self.GetVisibility())

    @visibility.setter
    def visibility(self, visible):
        self.SetVisibility(bool(visible))

    @property
    def pickable(self):
        """Whether pickers find it."""
        return bool(self.GetPickable())

    @pickable.setter
    def pickable(self, pickable):
        self.SetPickable(bool(pickable))

    @property
    def use_bounds(self):
        """Whether its bounds count for those of the renderer."""
        return bool(self.GetUseBounds())

    @use_bounds.setter
    def use_bounds(self, use):
        self.SetUseBounds(bool(use))

    @property
    def texture(self):
        """The picture that spans it, None for none; in place of the colours of heights while it is there."""
        return self.GetTexture()

    @texture.setter
    def texture(self, texture):
        if texture is not None and self.GetColorByHeight():
            self._own_color = self.prop.color
            self.SetColorByHeight(False)
            self.prop.color = "white"  # which the picture is multiplied with
        elif texture is None and self._own_color is not None:
            self.prop.color = self._own_color
            self.SetColorByHeight(True)
            self._own_color = None
        self.SetTexture(texture)
        bar = self._bar and self._bar()
        if bar is not None:
            bar.SetVisibility(self.GetColorByHeight())

    @property
    def backface_prop(self):
        """The property of its lower side, None for that of the upper."""
        return self.GetBackfaceProperty()

    @backface_prop.setter
    def backface_prop(self, prop):
        self.SetBackfaceProperty(prop)

    @property
    def memory_address(self):
        """Of the object in VTK."""
        return self.GetAddressAsString("")

    @property
    def position(self):
        """Shift of the whole, x, y, z."""
        return self.GetPosition()

    @position.setter
    def position(self, position):
        self.SetPosition(*position)

    @property
    def scale(self):
        """Factors along x, y, z; one number is all three."""
        return self.GetScale()

    @scale.setter
    def scale(self, scale):
        self.SetScale(*np.broadcast_to(scale, 3).astype(float))

    @property
    def orientation(self):
        """Turns round x, y, z in degrees."""
        return self.GetOrientation()

    @orientation.setter
    def orientation(self, orientation):
        self.SetOrientation(*orientation)

    @property
    def origin(self):
        """Point that it is scaled and turned round."""
        return self.GetOrigin()

    @origin.setter
    def origin(self, origin):
        self.SetOrigin(*origin)

    def rotate_x(self, angle):
        """Turns it round x by degrees more, as ``pyvista.Actor`` does."""
        self.RotateX(angle)

    def rotate_y(self, angle):
        """Turns it round y by degrees more."""
        self.RotateY(angle)

    def rotate_z(self, angle):
        """Turns it round z by degrees more."""
        self.RotateZ(angle)

    def transform(self, trans, multiply_mode="post", *, inplace=False):
        """Multiplies the user matrix, after it or before ("pre"); of a copy unless ``inplace``."""
        changed = self if inplace else self.copy()
        old = np.eye(4) if self.user_matrix is None else self.user_matrix
        new = np.asarray(pyvista.Transform(trans).matrix if hasattr(pyvista, "Transform") else trans, dtype=float)
        changed.user_matrix = new @ old if multiply_mode == "post" else old @ new
        return changed

    @property
    def user_matrix(self):
        """A further 4 x 4 matrix of the whole, None for none."""
        return None if self.GetUserMatrix() is None else pyvista.array_from_vtkmatrix(self.GetUserMatrix())

    @user_matrix.setter
    def user_matrix(self, matrix):
        if matrix is not None and not hasattr(matrix, "GetElement"):
            matrix = pyvista.vtkmatrix_from_array(np.asarray(matrix, dtype=float))
        self.SetUserMatrix(matrix)

    @property
    def bounds(self):
        """As drawn: x, y and z from and to."""
        return tuple(self.GetBounds())

    @property
    def center(self):
        """Middle of the bounds."""
        return tuple(np.reshape(self.GetBounds(), (3, 2)).mean(axis=1))

    @property
    def length(self):
        """Diagonal of the bounds."""
        return self.GetLength()

    @property
    def bounds_size(self):
        """Lengths of the bounds along x, y, z."""
        return tuple(np.reshape(self.GetBounds(), (3, 2)) @ (-1.0, 1.0))

    @property
    def axes_ranges(self):
        """What axes round it should say: its bounds in x and y, and true heights, without exaggeration.

        ``plotter.show_bounds(mesh=terrain, axes_ranges=terrain.axes_ranges)``. It is that of the heights
        themselves: position, scale and matrix are not in it.
        """
        self.GetBounds()
        low_high = [0.0, 0.0]
        self.GetHeightRange(low_high)
        bounds = self.GetHeights().GetBounds() if self.GetHeights() else self.GetBounds()
        return (*bounds[:4], *(bounds[4] + height for height in low_high))

    @property
    def heights(self):
        """The ``pyvista.ImageData`` that is drawn; None for strips of a prepared file alone.

        Integers with places without a height come as floats with NaN there, as filters want them; all
        else shares the memory of what is drawn.
        """
        heights = self.GetHeights()
        if heights is None:
            return None
        scalars = heights.GetPointData().GetScalars()
        if heights.GetPointGhostArray() is None or scalars.GetDataType() in (VTK_FLOAT, VTK_DOUBLE):
            return pyvista.wrap(heights)
        image = pyvista.ImageData()
        image.ShallowCopy(heights)
        samples = array_from_heights(heights)
        if heights.GetDirectionMatrix().GetElement(1, 1) < 0:
            samples = samples[::-1]
        image.point_data.set_array(np.ascontiguousarray(samples).ravel(), scalars.GetName())
        image.set_active_scalars(scalars.GetName())
        image.GetPointData().RemoveArray(vtkDataSetAttributes.GhostArrayName())
        return image

    def copy(self, deep=True):
        """Another terrain of the same heights, place and look; not ``deep`` it shares mapper and property."""
        other = type(self)()
        if not deep:
            other.ShallowCopy(self)
            other._prop = self._prop
            other._own_color = self._own_color
            return other
        if self._file:
            other.SetFileName(self._file)
            other._file = self._file
        elif self.GetHeights() is not None:
            other.SetInputConnection(self.GetTerrainMapper().GetInputConnection(1, 0))
        other.CopyLook(self)
        _copy_colors(self, other)
        other.prop.DeepCopy(self.prop)
        other.own_surface()
        for name in ("position", "orientation", "scale", "origin", "user_matrix", "visibility", "pickable", "texture",
                     "backface_prop"):
            setattr(other, name, getattr(self, name))
        other._own_color = self._own_color
        return other

    def plot(self, **options):
        """Shows it in a plotter of its own; ``options`` are those of ``pyvista.Plotter.show``."""
        plotter = pyvista.Plotter()
        plotter.add_actor(self)
        return plotter.show(**options)

    def set_heights(self, heights, *, follow=False, nodata=None):
        """Takes other heights of the same rows and columns, for loops; place and look stay.

        An array with rows from the south, and columns. Colours keep their range, or ``follow`` the
        heights from the lowest to the highest, with their bar; those of other scalars keep it anyway.
        ``nodata`` is as in ``add_terrain``: a value that is no height; by default what looks like fill is
        none, with a warning; "none" takes all for heights.
        """
        old = self.GetHeights()
        heights = to_array(heights)
        if np.shape(heights) != old.GetDimensions()[1::-1]:
            raise ValueError(f"heights must be {old.GetDimensions()[1]} x {old.GetDimensions()[0]}, "
                             f"not of shape {np.shape(heights)}")
        bounds = old.GetBounds()
        image = heights_from_array(heights, old.GetSpacing()[:2], (bounds[0], bounds[2], bounds[4]), nodata=nodata,
                                   name=old.GetPointData().GetScalars().GetName())
        image.GetFieldData().ShallowCopy(old.GetFieldData())
        _keep_arrays(old, image)
        self.SetInputData(image)
        if follow and self._shows_heights():
            low_high = [0.0, 0.0]
            self.GetHeightRange(low_high)
            self.mapper.scalar_range = low_high


    def _shows_heights(self):
        """Whether the colours are those of the heights, and not of other scalars."""
        mapper = self.GetTerrainMapper()
        if mapper.GetColorSource() != vtkTerrainLook.ColorSources.Array:
            return mapper.GetColorSource() == vtkTerrainLook.ColorSources.Height
        named = mapper.GetArrayName()
        return not named or named == self.GetHeights().GetPointData().GetScalars().GetName()


def _keep_arrays(old, image):
    """Gives an image the point arrays of another beside the heights, whichever way the rows of each run."""
    columns, rows, _ = image.GetDimensions()
    steps = {of.GetDirectionMatrix().GetElement(1, 1) for of in (old, image)}
    left_out = (old.GetPointData().GetScalars().GetName(), vtkDataSetAttributes.GhostArrayName())
    for k in range(old.GetPointData().GetNumberOfArrays()):
        array = old.GetPointData().GetArray(k)
        if array is None or array.GetName() in left_out:
            continue
        if len(steps) > 1:
            turned = vtk_to_numpy(array).reshape(rows, columns, -1)[::-1].reshape(rows * columns, -1)
            turned = numpy_to_vtk(np.ascontiguousarray(turned), deep=True)
            turned.SetName(array.GetName())
            array = turned
        image.GetPointData().AddArray(array)


def _copy_colors(terrain, other):
    """What CopyLook leaves out."""
    other.SetColorByHeight(terrain.GetColorByHeight())
    table = terrain.GetLookupTable()
    if isinstance(table, pyvista.LookupTable):
        copied = pyvista.LookupTable()
        copied.DeepCopy(table)
        other.SetLookupTable(copied)
    mapper, copied = terrain.GetTerrainMapper(), other.GetTerrainMapper()
    copied.SetScalarMode(mapper.GetScalarMode())
    copied.SetColorMode(mapper.GetColorMode())
    copied.SetArrayComponent(mapper.GetArrayComponent())
    if mapper.GetArrayName():
        copied.SelectColorArray(mapper.GetArrayName())
    copied.SetColorSource(mapper.GetColorSource())
