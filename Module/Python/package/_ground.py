# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tracks and places that lie on a terrain, and a plane that cuts it."""
import numpy as np
import pyvista
from vtkmodules.vtkCommonDataModel import vtkPlane

from .places import Placement
from .vtkTerrain import vtkTerrainDrape

_LIFT = 0.2  # of a cell: keeps what lies on the surface visible
_MOST_LIFT = 1e-3  # of a globe's radius
_HIDDEN = 0.05  # of a globe's radius: labels of what lies so far behind what is seen are hidden


def _points(terrain, points, coordinates):
    """x, y, 0 in the heights of scene, file or world coordinates."""
    if terrain.GetHeights() is None:
        raise ValueError("strips of a prepared file have no heights to lie on: draw it with another technique")
    points = np.atleast_2d(np.asarray(points, dtype=float))
    if points.ndim != 2 or points.shape[1] not in (2, 3) or not len(points):
        raise ValueError(f"points must be N x 2 or N x 3 numbers, not of shape {np.shape(points)}")
    if coordinates not in ("scene", "file", "places"):
        raise ValueError(f'coordinates must be "scene", "file" or "places", not {coordinates!r}')
    on_map = points[:, :2]
    placement = Placement(terrain.GetHeights())
    if placement.globe_radius is not None:
        return placement.on_globe(points, coordinates)
    if coordinates != "scene":
        on_map = (placement.from_places if coordinates == "places" else placement.from_coordinates)(on_map)
    return np.column_stack([on_map, np.zeros(len(points))])


def lift_of(terrain):
    """What keeps a line above a terrain visible, in the unit of its heights as drawn."""
    heights = terrain.GetHeights()
    cell = min(heights.GetSpacing()[:2])
    radius = Placement(heights).globe_radius
    return _LIFT * cell if radius is None else min(_LIFT * np.radians(cell), _MOST_LIFT) * radius


def add_labels(plotter, terrain, points, texts):
    """Texts beside points; on a globe those of points behind it are hidden."""
    radius = Placement(terrain.GetHeights()).globe_radius
    labels = plotter.add_point_labels(points, texts, show_points=False, always_visible=radius is None,
                                      reset_camera=False)
    if radius is not None:
        visible = labels.GetMapper().GetInputAlgorithm().GetInputAlgorithm()
        visible.SetTolerance(0.0)  # of the depth buffer, whose steps differ with the view
        visible.SetToleranceWorld(_HIDDEN * radius)


def _lay(terrain, mesh, offset):
    """A mesh on the surface, as it is drawn."""
    heights = terrain.GetHeights()
    drape = vtkTerrainDrape()
    drape.SetInputData(mesh)
    drape.SetHeightsData(heights)
    drape.SetExaggeration(terrain.GetVerticalExaggeration())
    drape.SetOffset(lift_of(terrain) / terrain.GetVerticalExaggeration() if offset is None else float(offset))
    drape.Update()
    laid = pyvista.wrap(drape.GetOutput())
    if not laid.n_points:
        raise ValueError("nothing of it lies on the terrain: its coordinates are elsewhere, or where no heights are")
    laid.transform(pyvista.array_from_vtkmatrix(terrain.GetMatrix()), inplace=True)
    return laid


def track_on(terrain, points, *, coordinates="scene", offset=None):
    """A line through points, on the surface cell by cell, as ``pyvista.PolyData``; see ``add_track``."""
    if isinstance(points, pyvista.PolyData):
        _points(terrain, points.points, "scene")
        mesh = points.copy()
    else:
        mesh = pyvista.PolyData(_points(terrain, points, coordinates))
        if mesh.n_points < 2:
            raise ValueError("a track needs two points")
        mesh.verts = np.empty(0, dtype=int)
        mesh.lines = [mesh.n_points, *range(mesh.n_points)]
    return _lay(terrain, mesh, offset)


def add_track(plotter, terrain, points, *, coordinates="scene", offset=None, color="firebrick", line_width=3.0,
              **options):
    """Draws a line on a terrain; returns PyVista's actor.

    It follows the surface cell by cell and ends where there is none. It stays where it is when the
    terrain is moved or exaggerated later.

    Parameters
    ----------
    terrain : Terrain
        What ``add_terrain`` returned.
    points : array_like of N x 2 or N x 3, or pyvista.PolyData
        Its corners, or lines of any number in the scene; z does not matter, except in the scene of a
        globe, where points are geocentric.
    coordinates : {"scene", "file", "places"}
        What x and y are: those of the heights as drawn, of the heights' own coordinate system, or
        longitude and latitude in degrees on WGS84, on a globe of another world its own.
    offset : float, optional
        Added to the heights, in their unit; 0.2 cells by default, on a globe at most 0.001 radii.
    color, line_width, **options
        As those of ``pyvista.Plotter.add_mesh``.
    """
    return plotter.add_mesh(track_on(terrain, points, coordinates=coordinates, offset=offset), color=color,
                            line_width=line_width, **{"lighting": False, "reset_camera": False, **options})


def add_places(plotter, terrain, places, *, labels=None, coordinates="scene", offset=None, color="white",
               point_size=12.0, **options):
    """Draws points on a terrain; returns PyVista's actor.

    ``places`` are N x 2 or N x 3 numbers, ``labels`` N texts to write beside them, on a globe of those that
    are not behind it. Places off the surface are left out with their labels. All else as in ``add_track``.
    """
    points = _points(terrain, places, coordinates)
    if labels is not None and len(labels) != len(points):
        raise ValueError(f"labels must be one for each of the {len(points)} places, not {len(labels)}")
    mesh = pyvista.PolyData(points)
    mesh.point_data["place"] = np.arange(len(points))
    laid = _lay(terrain, mesh, offset)
    if labels is not None:
        texts = [str(labels[int(place)]) for place in np.rint(laid.point_data["place"])]
        add_labels(plotter, terrain, laid.points, texts)
    return plotter.add_mesh(laid, color=color, point_size=point_size, style="points",
                            **{"render_points_as_spheres": True, "reset_camera": False, **options})


def add_clip_plane(plotter, terrain, *, normal="x", **options):
    """Adds a plane to drag, which cuts a terrain as drawn; returns PyVista's widget.

    What lies on the side that ``normal`` points to is left out, or on the other with ``invert=True``.
    ``options`` are those of ``pyvista.Plotter.add_plane_widget``.
    """
    plane = vtkPlane()
    terrain.GetTerrainMapper().AddClippingPlane(plane)
    sign = 1.0 if options.pop("invert", False) else -1.0

    def move(direction, origin):
        plane.SetNormal(*(sign * np.asarray(direction)))
        plane.SetOrigin(*origin)

    options = {"bounds": terrain.bounds, "interaction_event": "always", **options}
    return plotter.add_plane_widget(move, normal=normal, **options)
