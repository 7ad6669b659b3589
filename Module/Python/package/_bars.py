# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bars of colours that belong to one terrain each."""
import itertools
import weakref

import numpy as np

from ._actor import weak_reference


def label_format(low, high):
    """A printf format that tells five labels of a range apart, without digits that say nothing."""
    decimals = 1 - int(np.floor(np.log10(max(high - low, 1e-30) / 4.0)))
    size = max(abs(low), abs(high))
    if size >= 1e7 or size < 1e-4:
        return "%.3g"
    return f"%.{min(max(decimals if high - low < 40.0 else 0, 0), 9)}f"


def has_minus_zero(label):
    """Whether a label is that of 0 with a sign, as in "-0.00"."""
    return label.startswith("-") and float(label) == 0.0


def _free_title(plotter, title, name):
    """The title itself, or one that tells this terrain's bar from another's, which has it."""
    of_others = plotter.scalar_bars.keys()
    if title in of_others and name:
        title = f"{title} of {name}"
    titles = itertools.chain([title], (f"{title} {number}" for number in itertools.count(2)))
    return next(free for free in titles if free not in of_others)


def _remove_with(terrain, plotter, title):
    """Lets a bar go when its terrain is no longer in the renderer.

    PyVista looks at the first bar alone when it removes an actor.
    """
    plotter, renderer, terrain = weakref.ref(plotter), weakref.ref(plotter.renderer), weak_reference(terrain)
    has_gone = False

    def look(*_):
        # It stays an observer when the bar has gone: one that removes itself is freed while it runs.
        nonlocal has_gone
        here, drawn = renderer(), terrain.Get()
        if has_gone or (here is not None and drawn is not None and here.HasViewProp(drawn)):
            return
        has_gone = True
        bars = plotter() and plotter().scalar_bars
        if drawn is not None and bars and drawn.mapper in bars._scalar_bar_mappers.get(title, ()):
            plotter().remove_scalar_bar(title, render=False)

    renderer().GetViewProps().AddObserver("ModifiedEvent", look)


def add_bar(plotter, terrain, table, title, name, options):
    """Adds the bar of a terrain that is in the plotter already; ``name`` is that of the terrain or None."""
    options = dict(options or {})
    title = _free_title(plotter, options.pop("title", title), name)
    low, high = table.scalar_range
    options.setdefault("fmt", label_format(low, high))
    bar = plotter.add_scalar_bar(**{**options, "title": title, "mapper": terrain.mapper})
    if not bar.GetOrientation() and not title.endswith("\n"):
        bar.SetTitle(title + "\n")  # keeps the title off the numbers
    terrain._bar = weakref.ref(bar)  # hidden while a texture is in place of the colours
    _remove_with(terrain, plotter, title)
