# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws heightfields in VTK without building their full mesh.

The classes are those of the C++ module, wrapped by VTK's own tools, so that they mix with all of
``vtkmodules``; ``help(vtkterrain.vtkOpenGLTerrainMapper)`` shows their documentation. On VTK before
9.4, importing the package also lets ``vtkRenderWindow()`` give a window that draws without a
display. ``heights_from_array`` makes heights of numpy arrays. ``vtkterrain.plotting`` is for PyVista,
``vtkterrain.xarrays`` for xarray, ``python -m vtkterrain FILE`` shows a file in a browser.
"""
from . import _supply

_supply.check_vtk()

import vtkmodules.vtkRenderingOpenGL2  # noqa: E402, F401, registers how VTK draws

from . import vtkTerrain as _wrapped  # noqa: E402
from ._built_with import VERSION as __version__  # noqa: E402
from .heights import array_from_heights, heights_from_array  # noqa: E402
from .vtkTerrain import *  # noqa: E402, F403

# Without it a star import would bind the name of the inner module, and hide what is called the same.
__all__ = ["__version__", "array_from_heights", "heights_from_array"]
__all__ += [name for name, member in vars(_wrapped).items()
            if isinstance(member, type) and name.startswith("vtk")]

_supply.offer_gdal(vtkTerrainRasterReader)  # noqa: F405
_supply.find_geoids()
_supply.warn_without_opengl(with_driver=False)

# What draws is given when it is asked for: only who draws waits until a driver of OpenGL has been tried.
_DRAWING = {name: globals().pop(name) for name in __all__ if name.endswith(("Actor", "Mapper"))}


def __getattr__(name):
    if name not in _DRAWING:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    _supply.warn_without_opengl()
    globals().update(_DRAWING)
    return _DRAWING[name]


def __dir__():
    return sorted({*globals(), *_DRAWING})
