# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws heightfields in VTK without building their full mesh.

The classes are those of the C++ module, wrapped by VTK's own tools, so that they mix with all of
``vtkmodules``; ``help(vtkTerrain.vtkOpenGLTerrainMapper)`` shows their documentation. On VTK before
9.4, importing the package also lets ``vtkRenderWindow()`` give a window that draws without a
display. ``heights_from_array`` makes heights of numpy arrays.
"""
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, registers how VTK draws

from .heights import array_from_heights, heights_from_array
from .vtkTerrain import *  # noqa: F403
