# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeoPandas frames as tracks and points on a terrain of PyVista's plotters."""
import numpy as np
import pyvista

from ._ground import add_labels, lift_of
from .places import Placement
from .vtkTerrain import vtkTerrainDrape

_POINT, _LINES, _POLYGON = 0, (1, 2), 3  # shapely's numbers of types


def _parts(frame):
    """Single geometries in longitude and latitude, or as they are without a CRS, and their rows."""
    import shapely

    geometry = frame.geometry
    if frame.crs is not None:
        geometry = geometry.to_crs(4326)
    parts, rows = shapely.get_parts(geometry.to_numpy(), return_index=True)
    kinds = shapely.get_type_id(parts)
    parts = np.where(kinds == _POLYGON, shapely.boundary(parts), parts)
    parts, deeper = shapely.get_parts(parts, return_index=True)
    return parts, rows[deeper]


def _in_scene(terrain, frame, coordinates):
    placement = Placement(terrain.GetHeights())
    if placement.globe_radius is not None:
        return placement.on_globe(coordinates, "file" if frame.crs is None else "places")
    on_map = placement.from_places if frame.crs is not None else placement.from_coordinates
    return np.column_stack([on_map(coordinates), np.zeros(len(coordinates))])


def _drape(terrain, mesh, offset):
    heights = terrain.GetHeights()
    drape = vtkTerrainDrape()
    drape.SetInputData(mesh)
    drape.SetHeightsData(heights)
    drape.SetExaggeration(terrain.GetVerticalExaggeration())
    drape.SetOffset(lift_of(terrain) if offset is None else offset)
    drape.Update()
    return pyvista.wrap(drape.GetOutput())


def tracks_from_frame(terrain, frame, offset=None):
    """Lines, and outlines of polygons, of a GeoDataFrame on a terrain, as ``pyvista.PolyData``.

    They follow the surface cell by cell and end where there is none. A frame with a coordinate system
    is brought into that of the heights; one without any has the coordinates of the heights. ``offset``
    is added to the heights, in their unit; 0.2 cells by default. The cell array "row" has the place of
    each line's row in the frame.
    """
    import shapely

    parts, rows = _parts(frame)
    is_line = np.isin(shapely.get_type_id(parts), _LINES)
    parts, rows = parts[is_line], rows[is_line]
    if not len(parts):
        raise ValueError("there is no line in the frame")
    coordinates, line = shapely.get_coordinates(parts, return_index=True)
    points = _in_scene(terrain, frame, coordinates)
    is_placed = np.isfinite(points).all(axis=1)
    points, line = points[is_placed], line[is_placed]
    lines, kept = [], []
    for number in range(len(parts)):
        members = np.flatnonzero(line == number)
        if len(members) > 1:
            lines.append([len(members), *members])
            kept.append(rows[number])
    if not lines:
        raise ValueError("no line of the frame is on the map of the heights")
    mesh = pyvista.PolyData()
    mesh.points = points
    mesh.lines = np.concatenate(lines)
    mesh.cell_data["row"] = kept
    return _drape(terrain, mesh, offset)


def points_from_frame(terrain, frame, offset=None):
    """Points of a GeoDataFrame on a terrain, as ``pyvista.PolyData`` with the point array "row".

    As ``tracks_from_frame`` for the rest; points off the surface are left out.
    """
    import shapely

    parts, rows = _parts(frame)
    is_point = shapely.get_type_id(parts) == _POINT
    if not is_point.any():
        raise ValueError("there is no point in the frame")
    points = _in_scene(terrain, frame, shapely.get_coordinates(parts[is_point]))
    is_placed = np.isfinite(points).all(axis=1)
    mesh = pyvista.PolyData(points[is_placed])
    mesh.point_data["row"] = rows[is_point][is_placed]
    return _drape(terrain, mesh, offset)


def add_tracks(plotter, terrain, frame, *, offset=None, color="firebrick", line_width=3.0, **options):
    """Draws the lines of a GeoDataFrame on a terrain; returns PyVista's actor.

    ``terrain`` is what ``add_terrain`` returned; ``offset`` as in ``tracks_from_frame``; the rest are
    options of ``pyvista.Plotter.add_mesh``.
    """
    return plotter.add_mesh(tracks_from_frame(terrain, frame, offset), color=color, line_width=line_width,
                            **{"lighting": False, "reset_camera": False, **options})


def add_points(plotter, terrain, frame, *, labels=None, offset=None, color="white", point_size=12.0, **options):
    """Draws the points of a GeoDataFrame on a terrain; returns PyVista's actor.

    ``labels`` is a column of the frame to write beside them; the rest as in ``add_tracks``.
    """
    points = points_from_frame(terrain, frame, offset)
    if labels is not None and points.n_points:
        texts = [str(frame[labels].iloc[row]) for row in points.point_data["row"]]
        add_labels(plotter, terrain, points.points, texts)
    return plotter.add_mesh(points, color=color, point_size=point_size, style="points",
                            **{"render_points_as_spheres": True, "reset_camera": False, **options})
