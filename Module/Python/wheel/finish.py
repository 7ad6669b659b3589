# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts pip's libraries of VTK under the names of Debian's: finish.py SDK VTKMODULES

The linker writes down the name that a library has for itself, which is pip's. One that pip's VTK lacks
becomes an empty file: CMake sees that it is there, and nothing can be linked to it.
"""
import pathlib
import re
import sys

sdk, modules = (pathlib.Path(argument) for argument in sys.argv[1:])
own = next(modules.glob("libvtkWrappingPythonCore3.*.so"))
for library in (sdk / "usr/lib/x86_64-linux-gnu").glob("libvtk*-[0-9]*.so*"):
    name = re.sub(r"-\d+\.\d+\.so.*", "", library.name)
    real = own if name.startswith("libvtkWrappingPythonCore") else modules / f"{name}.so"
    library.unlink()
    if real.exists():
        library.symlink_to(real)
    else:
        library.touch()
