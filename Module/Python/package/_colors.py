# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colour maps by their names: matplotlib's, those of packages of colour maps, and the module's own schemes."""
import difflib
import importlib
import importlib.util

import numpy as np
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

from .vtkTerrain import vtkTerrainColors

# Packages of colour maps, in the order in which they are asked, and where each has its maps by name.
_PACKAGES = {"matplotlib": "colormaps", "colorcet": "cm", "cmocean": "cm.cmap_d", "cmcrameri": "cm.cmaps"}
# Prefixes of the names under which packages tell matplotlib of their maps.
_PREFIXES = {"cmo": "cmocean", "cmc": "cmcrameri", "cet": "colorcet"}


def scheme_names():
    """Names of the module's own schemes."""
    return [vtkTerrainColors.GetSchemeName(index) for index in range(vtkTerrainColors.GetNumberOfSchemes())]


def _maps_of(package):
    """The colour maps of a package by name; none of one that is not installed."""
    if not importlib.util.find_spec(package):
        return {}
    maps = importlib.import_module(package)
    for part in _PACKAGES[package].split("."):
        maps = getattr(maps, part)
    return maps


def find_color_map(name):
    """The matplotlib colour map of a name, or None where no package that is installed has it.

    A prefix names the package, as in "cmocean.deep" or "cmo.deep".
    """
    prefix, _, rest = name.rpartition(".")
    only = _PREFIXES.get(prefix, prefix)
    for package in [only] if only in _PACKAGES else _PACKAGES:
        maps = _maps_of(package)
        wanted = rest if only in _PACKAGES else name
        if wanted in maps:
            return maps[wanted]
    return None


def _of_scheme(name, count):
    """Colours of one of the module's schemes, count x 3 numbers from 0 to 1; None where it has none of that name."""
    scheme = name.removesuffix("_r")
    if scheme not in scheme_names():
        return None
    colors, table = vtkTerrainColors(), vtkColorTransferFunction()
    colors.SetScheme(scheme)
    # Sea and land each have half of the colours, as in the packages' maps. A relief is of land.
    low, high = (1.0, 2.0) if scheme == "relief" else (-1.0, 1.0)
    colors.FillTable(table, low, high)
    rows = np.array([table.GetColor(value) for value in np.linspace(low, high, count)])
    return rows if scheme == name else rows[::-1]


def _why_unknown(name):
    known = [*scheme_names(), *(one for package in _PACKAGES for one in _maps_of(package))]
    near = difflib.get_close_matches(name, known, n=3)
    missing = [package for package in _PACKAGES if not importlib.util.find_spec(package)]
    return (f"there is no colour map {name!r}" + (f", but {', '.join(map(repr, dict.fromkeys(near)))}" if near else "")
            + (f": more are had by pip install {' '.join(missing)}" if missing else
               f": names are those of {', '.join(_PACKAGES)}, and {', '.join(scheme_names())}"))


def sample_colors(name, count=256):
    """Colours of a name, from the lowest value to the highest: count x 3 numbers from 0 to 1.

    Maps of packages go first: they have all 256 colours, the module's schemes of the same names a few
    between which it mixes. Raises ValueError with a sentence that names the remedy.
    """
    color_map = find_color_map(name)
    if color_map is not None:
        return np.asarray(color_map(np.linspace(0.0, 1.0, count)))[:, :3]
    colors = _of_scheme(name, count)
    if colors is None:
        raise ValueError(_why_unknown(name))
    return colors
