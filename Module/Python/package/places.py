# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where heights lie: between the image that is drawn, its coordinate system, and longitude, latitude."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from .vtkTerrain import vtkTerrainGeoreference


class Placement:
    """The place of a ``vtkImageData`` of heights.

    Its field data, as ``vtkTerrainRasterReader`` and ``heights_from_array`` write them, say in which
    coordinate system it lies, and how its x and y come from those of the system:
    ``x = (coordinate - LayoutOrigin) * LayoutScale``, without these arrays ``x = coordinate``.
    """

    def __init__(self, heights):
        self._georeference = vtkTerrainGeoreference()
        self._georeference.SetFromHeights(heights)
        self._origin = self._pair(heights, "LayoutOrigin", 0.0)
        self._scale = self._pair(heights, "LayoutScale", 1.0)
        radii = heights.GetFieldData().GetArray("GlobeRadii")
        self._radius = None if radii is None else radii.GetComponent(0, 0)
        if radii is not None:
            self._georeference.SetFrame(vtkTerrainGeoreference.FrameType.Globe)

    @staticmethod
    def _pair(heights, name, default):
        array = heights.GetFieldData().GetArray(name)
        return np.full(2, default) if array is None else vtk_to_numpy(array).reshape(2).astype(float)

    @property
    def is_on_earth(self):
        """Whether longitudes and latitudes can be told."""
        return not self._georeference.GetWhyNot() and self._georeference.IsOnEarth()

    @property
    def globe_radius(self):
        """The equatorial one of the globe that the heights lie on, in metres; None where they lie flat."""
        return self._radius

    def on_globe(self, points, coordinates):
        """Geocentric points, N x 3, of those of a globe's scene, of its coordinate system or of its own places.

        ``points`` are N x 2 or N x 3 numbers, ``coordinates`` "scene", "file" or "places" (longitude and
        latitude in degrees, on other worlds their own). Heights of places are 0.
        """
        points = np.asarray(points, dtype=float)
        if coordinates == "scene":
            if points.shape[1] != 3:
                raise ValueError('points of the scene of a globe are N x 3: coordinates="places" takes longitudes and '
                                 'latitudes')
            return points
        flat = np.column_stack([points[:, :2], np.zeros(len(points))]).ravel()
        bring = self._georeference.PlacesToScene if coordinates == "places" else self._georeference.FileToScene
        if not bring(flat, flat, len(points)):
            raise ValueError(self._georeference.GetWhyNot() or "the heights have no coordinate system")
        return flat.reshape(-1, 3)

    def from_places(self, places):
        """x and y in the image, N x 2, of longitudes and latitudes in degrees on WGS84, N x 2.

        NaN where a place has no image. Raises ValueError if the heights have no coordinate system.
        """
        places = np.asarray(places, dtype=float)
        points = np.zeros((len(places), 3))
        points[:, :2] = places
        flat = points.ravel()
        if not self.is_on_earth or not self._georeference.PlacesToFile(flat, flat, len(points)):
            raise ValueError(self._georeference.GetWhyNot() or "the heights have no coordinate system")
        return self.from_coordinates(flat.reshape(-1, 3)[:, :2])

    def from_coordinates(self, coordinates):
        """x and y in the image of coordinates in the heights' own system, both N x 2."""
        return (np.asarray(coordinates, dtype=float) - self._origin) * self._scale

    def to_coordinates(self, points):
        """The reverse of ``from_coordinates``."""
        return np.asarray(points, dtype=float) / self._scale + self._origin

    def place(self, where):
        """x and y in the image, N x 2, of a GeoPandas frame or series of points, or of N x 2 coordinates."""
        if not hasattr(where, "geometry"):
            coordinates = np.atleast_2d(np.asarray(where, dtype=float))
            if coordinates.ndim != 2 or coordinates.shape[1] not in (2, 3):
                raise ValueError(f"places must be N x 2 coordinates, not of shape {coordinates.shape}")
            return self.from_coordinates(coordinates[:, :2])
        points = where.geometry
        if points.crs is None:
            return self.from_coordinates(np.column_stack([points.x, points.y]))
        points = points.to_crs(4326)
        return self.from_places(np.column_stack([points.x, points.y]))

    def describe(self, x, y, height):
        """A point of the image in words, each with its name: height, place, UTM and MGRS, or x, y, height.

        Heights are in metres, the place is in degrees; UTM tells zone and hemisphere, then metres east and north.
        x, y and height of heights without a coordinate system have the units of the data.
        """
        coordinates = self.to_coordinates([x, y])
        point = np.array([*coordinates, height], dtype=float)
        if self.is_on_earth and self._georeference.FileToScene(point, point, 1):
            place, *others = self._georeference.GetReadout(point).split("  ")
            texts = zip(("Height", "Place", "UTM", "MGRS"), (*others[:1], place, *others[1:]))
            return "  ".join(f"{name} {text}" for name, text in texts)
        return f"x {coordinates[0]:.9g}  y {coordinates[1]:.9g}  height {height:.2f}"
