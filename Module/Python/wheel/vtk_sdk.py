# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unpacks Debian's VTK for building beside pip's: vtk_sdk.py SDK PACKAGES SERIES

PACKAGES is a folder with libvtk9-dev, libvtkSERIES, vtk9, python3-vtk9 and libc6. SDK gets their headers
and CMake package, changed to name no package of Debian's that pip's VTK does without, and their tools
for wrapping, which run with the C library that they came with. finish.py, which is put beside them,
replaces the libraries by those of pip's VTK.
"""
import pathlib
import re
import shutil
import subprocess
import sys

_TRIPLET = "usr/lib/x86_64-linux-gnu"
_TOOLS = ("vtkWrapHierarchy", "vtkWrapPython", "vtkWrapPythonInit")


def unpack(packages, folder):
    """All packages, into an empty folder."""
    shutil.rmtree(folder, ignore_errors=True)
    for package in sorted(packages.glob("*.deb")):
        if not package.name.startswith("libpython"):
            subprocess.run(["dpkg", "-x", package, folder], check=True)


def edit(path, *changes):
    """Replaces texts, each of which must be there."""
    text = path.read_text()
    for pattern, replacement in changes:
        text, count = re.subn(pattern, replacement, text)
        if not count:
            sys.exit(f"{path}: there is no {pattern}")
    path.write_text(text)


def use_tools(sdk, tools, series):
    """Tools as scripts that run the real ones with the loader and libraries unpacked beside them."""
    libraries = tools / _TRIPLET
    for name in _TOOLS:
        script = sdk / "usr/bin" / f"{name}-{series}"
        script.write_text(f'#!/bin/sh\nexec "{libraries}/ld-linux-x86-64.so.2" --library-path "{libraries}" '
                          f'"{tools}/usr/bin/{script.name}" "$@"\n')


def change_cmake_package(cmake):
    """Targets of other packages become empty ones: the wheels bring what is behind them."""
    others = sorted({name for name in re.findall(r"\b\w+::\w+", (cmake / "VTK-targets.cmake").read_text())
                     if not name.startswith(("VTK::", "Python3::", "Threads::"))})
    (cmake / "others.cmake").write_text("".join(
        f"if (NOT TARGET {name})\n  add_library({name} INTERFACE IMPORTED)\nendif ()\n" for name in others))
    (cmake / "VTK-vtk-module-find-packages.cmake").write_text(
        "find_package(Threads QUIET)\nfind_package(Python3 QUIET COMPONENTS Interpreter Development.Module)\n")
    edit(cmake / "vtk-config.cmake",
         (r'(_(?:HAS_VISKORES|HAS_VTKm|WRAP_JAVA)") "ON"', r'\1 "OFF"'),
         (r'(?m)^include\("\$\{CMAKE_CURRENT_LIST_DIR\}/vtkCMakeBackports\.cmake"\)$',
          r'\g<0>\ninclude("${CMAKE_CURRENT_LIST_DIR}/others.cmake")'))


def main():
    """Unpacks and changes."""
    sdk, packages, series = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), sys.argv[3]
    tools = sdk / "tools"
    unpack(packages, sdk)
    unpack(packages, tools)
    use_tools(sdk, tools, series)
    change_cmake_package(sdk / _TRIPLET / "cmake" / f"vtk-{series}")
    # pip's VTK has no TBB, and threads of its own.
    edit(sdk / "usr/include" / f"vtk-{series}" / "vtkSMP.h",
         (r"(#define VTK_SMP_(?:ENABLE|DEFAULT_IMPLEMENTATION)_TBB) 1", r"\1 0"),
         (r"#define VTK_SMP_TBB\b", "#define VTK_SMP_Sequential"),
         (r'BACKEND "TBB"', 'BACKEND "Sequential"'),
         (r"(DEFAULT_IMPLEMENTATION_SEQUENTIAL) 0", r"\1 1"))
    shutil.copy(pathlib.Path(__file__).with_name("finish.py"), sdk)


main()
