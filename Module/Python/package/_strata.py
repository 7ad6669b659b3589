# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers on the sides of a block of terrain, as those of ``terrain-render --strata``."""
import itertools
import weakref

import numpy as np
import pyvista
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes

from ._actor import weak_reference

_AMBIENT = 0.35  # layers are told apart on sides that turn away from the sun, too


def read_strata(strata):
    """Colours and thicknesses from the surface down, the last one without end: a list of (Color, float)."""
    if isinstance(strata, str):
        strata = [tuple(layer.split("=")) for layer in strata.split(",")]
    layers = []
    for layer in strata:
        color, *thickness = (layer,) if isinstance(layer, str) else layer
        try:
            metres = float(thickness[0]) if thickness else np.inf
        except (TypeError, ValueError):
            metres = np.nan
        if len(thickness) > 1 or not metres > 0.0:
            raise ValueError("strata must be (color, thickness above 0) from the surface down, the last one a color "
                             f"alone, not {layer!r}")
        layers.append((pyvista.Color(color), metres))
    if not layers or any(np.isinf(metres) for _, metres in layers[:-1]):
        raise ValueError("strata must be layers from the surface down, and none but the last one without a thickness")
    return layers


def _cells(heights, samples):
    """Which cells have four heights."""
    known = np.isfinite(samples)
    ghosts = heights.GetPointGhostArray()
    if ghosts is not None:
        known &= (vtk_to_numpy(ghosts).reshape(samples.shape) & vtkDataSetAttributes.HIDDENPOINT) == 0
    return known[:-1, :-1] & known[1:, :-1] & known[:-1, 1:] & known[1:, 1:]


def _sides(cells):
    """Samples at the ends of the sides at which cells end: row, column of the first and the last."""
    padded = np.pad(cells, 1)
    ends = []
    for beside, first, last in ((padded[:-2, 1:-1], (0, 0), (0, 1)), (padded[1:-1, 2:], (0, 1), (1, 1)),
                                (padded[2:, 1:-1], (1, 1), (1, 0)), (padded[1:-1, :-2], (1, 0), (0, 0))):
        rows, columns = np.nonzero(cells & ~beside)
        ends.append((rows + first[0], columns + first[1], rows + last[0], columns + last[1]))
    return [np.concatenate(part) for part in zip(*ends)]


def _runs(cells):
    """Row, first column, and the column after the last of cells in a row."""
    steps = np.diff(np.pad(cells.astype(np.int8), ((0, 0), (1, 1))), axis=1)
    rows, firsts = np.nonzero(steps == 1)
    return rows, firsts, np.nonzero(steps == -1)[1]


def make_strata(heights, base, layers):
    """The sides of a block down to ``base`` and its floor: ``pyvista.PolyData`` of quads with colours."""
    columns, rows, _ = heights.GetDimensions()
    samples = vtk_to_numpy(heights.GetPointData().GetScalars()).reshape(rows, columns).astype(float)
    origin, spacing = np.array(heights.GetOrigin()), heights.GetSpacing()
    direction = heights.GetDirectionMatrix()

    def points(row, column, z):
        return np.stack([origin[0] + column * spacing[0] * direction.GetElement(0, 0),
                         origin[1] + row * spacing[1] * direction.GetElement(1, 1), origin[2] + z], axis=-1)

    cells = _cells(heights, samples)
    from_row, from_column, to_row, to_column = _sides(cells)
    quads, colors, top = [], [], 0.0
    for color, metres in layers if len(from_row) else ():
        bottom = top + metres
        first, last = samples[from_row, from_column], samples[to_row, to_column]
        here = np.maximum(first, last) - top > base
        z = [np.maximum(height - depth, base)[here] for height, depth in
             ((first, bottom), (last, bottom), (last, top), (first, top))]
        ends = ((from_row, from_column), (to_row, to_column), (to_row, to_column), (from_row, from_column))
        quads.append(np.stack([points(row[here], column[here], height)
                               for (row, column), height in zip(ends, z)], axis=1))
        colors.append(np.tile(color.int_rgb, (int(here.sum()), 1)))
        top = bottom
    row, first, last = _runs(cells)
    floor = np.full(len(row), base)
    quads.append(np.stack([points(row, first, floor), points(row, last, floor), points(row + 1, last, floor),
                           points(row + 1, first, floor)], axis=1))
    colors.append(np.tile(layers[-1][0].int_rgb, (len(row), 1)))
    corners = np.concatenate(quads)
    faces = np.insert(np.arange(4 * len(corners)).reshape(-1, 4), 0, 4, axis=1)
    block = pyvista.PolyData(corners.reshape(-1, 3), faces.ravel())
    block.cell_data["Color"] = np.concatenate(colors).astype(np.uint8)
    return block


def add_strata(plotter, terrain, strata):
    """Puts layers in the place of the plain sides of a terrain's block; they go with the terrain."""
    layers = read_strata(strata)
    mapper = terrain.GetTerrainMapper()
    if not mapper.GetBlock():
        raise ValueError("strata are on the sides of a block: give block, too")
    if terrain.GetHeights() is None or mapper.GetNumberOfTiles():
        raise ValueError("strata need heights that are in memory: draw a smaller raster")
    block = make_strata(terrain.GetHeights(), mapper.GetBlockBase(), layers)
    mapper.SetBlock(False)
    sides = pyvista.Actor(mapper=pyvista.DataSetMapper(block))
    sides.mapper.set_scalars(block.cell_data["Color"], "Color", rgb=True, preference="cell")
    sides.prop.interpolation = "flat"
    sides.prop.ambient, sides.prop.diffuse, sides.prop.specular = _AMBIENT, 1.0 - _AMBIENT, 0.0
    sides.PickableOff()
    terrain.PlaceAsDrawn(sides)
    names = (f"{terrain.name or 'terrain'}-strata{number or ''}" for number in itertools.count())
    plotter.add_actor(sides, name=next(name for name in names if name not in plotter.actors), pickable=False,
                      reset_camera=False, render=False)
    _follow(terrain, sides, plotter.renderer)
    return sides


def _follow(terrain, sides, renderer):
    """Keeps the sides where their terrain is, and takes them away with it."""
    terrain, renderer = weak_reference(terrain), weakref.ref(renderer)

    def place(*_):
        drawn = terrain.Get()
        if drawn is not None:
            drawn.PlaceAsDrawn(sides)

    def look(*_):
        here, drawn = renderer(), terrain.Get()
        if here is not None and (drawn is None or not here.HasViewProp(drawn)) and here.HasViewProp(sides):
            here.RemoveViewProp(sides)

    terrain.Get().AddObserver("ModifiedEvent", place)
    renderer().GetViewProps().AddObserver("ModifiedEvent", look)
