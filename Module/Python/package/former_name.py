# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkTerrain, the former name of the package vtkterrain: the same package, with a warning."""
import importlib
import importlib.abc
import importlib.util
import sys
import warnings

import vtkterrain

_FORMER = "vtkTerrain"


class _SameModules(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Finds vtkTerrain.X as the module vtkterrain.X itself."""

    def find_spec(self, name, path=None, target=None):
        is_below = name.startswith(f"{_FORMER}.")
        return importlib.util.spec_from_loader(name, self) if is_below else None

    def create_module(self, spec):
        module = importlib.import_module(spec.name.replace(_FORMER, "vtkterrain", 1))
        spec.loader_state = module.__spec__
        return module

    def exec_module(self, module):
        module.__spec__ = module.__spec__.loader_state


warnings.warn("the package vtkTerrain is called vtkterrain now: import vtkterrain", FutureWarning, stacklevel=2)
sys.meta_path.insert(0, _SameModules())
sys.modules[_FORMER] = vtkterrain
