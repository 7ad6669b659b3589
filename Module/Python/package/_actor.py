# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""A terrain with the attributes that PyVista's actors have."""
import weakref

import numpy as np
import pyvista

from .heights import heights_from_array
from .vtkTerrain import vtkTerrainActor


class SurfaceMapper:
    """What PyVista asks of an actor's mapper: the terrain as a mesh, made when it is asked for.

    All else is the ``vtkOpenGLTerrainMapper``'s, which ``GetTerrainMapper`` gives as it is.
    """

    def __init__(self, terrain):
        self._terrain = weakref.ref(terrain)

    @property
    def dataset(self):
        """The surface as ``pyvista.PolyData``, see ``vtkTerrainActor.GetSurface``."""
        return self._terrain().surface

    @property
    def lookup_table(self):
        """The colours in use."""
        return self._terrain().GetLookupTable()

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
        return self.dataset

    GetInput = GetDataSetInput = GetInputAsDataSet = _get_dataset

    def GetInputAlgorithm(self):  # noqa: N802
        """What makes the mesh; None without an image of heights."""
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
        prop = pyvista.Property(interpolation="Gouraud", ambient=0.0, diffuse=1.0, specular=0.0)
        self.SetProperty(prop)
        self._prop = prop

    def __setattr__(self, name, value):
        if not name.startswith("_") and not hasattr(type(self), name):
            known = ", ".join(sorted(key for key, member in vars(Terrain).items() if isinstance(member, property)))
            raise AttributeError(f"a terrain has no attribute {name!r} to set; it has {known}")
        super().__setattr__(name, value)

    @property
    def prop(self):
        """The ``pyvista.Property``: colour, light, style."""
        return self._prop

    @prop.setter
    def prop(self, prop):
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
        """Drawn height over true height, above 0."""
        return self.GetVerticalExaggeration()

    @exaggeration.setter
    def exaggeration(self, factor):
        if not 0.0 < factor < np.inf:
            raise ValueError(f"exaggeration must be a number above 0, not {factor}")
        self.SetVerticalExaggeration(factor)

    @property
    def opacity(self):
        """1 is opaque, 0 not seen."""
        return self.GetProperty().GetOpacity()

    @opacity.setter
    def opacity(self, opacity):
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
    def heights(self):
        """The ``pyvista.ImageData`` that is drawn; None for strips of a prepared file alone."""
        heights = self.GetHeights()
        return None if heights is None else pyvista.wrap(heights)

    def set_heights(self, heights):
        """Takes other heights of the same rows and columns, for loops; place and look stay.

        An array with rows from the south, and columns. Colours keep their range.
        """
        old = self.GetHeights()
        if np.shape(heights) != old.GetDimensions()[1::-1]:
            raise ValueError(f"heights must be {old.GetDimensions()[1]} x {old.GetDimensions()[0]}, "
                             f"not of shape {np.shape(heights)}")
        bounds = old.GetBounds()
        image = heights_from_array(heights, old.GetSpacing()[:2], (bounds[0], bounds[2], bounds[4]), nodata="none",
                                   name=old.GetPointData().GetScalars().GetName())
        image.GetFieldData().ShallowCopy(old.GetFieldData())
        self.SetInputData(image)
