# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compiles the wrapping of a finished build for another CPython: wrap.py BUILD FOLDER HEADERS

HEADERS is a folder called by the version, such as 3.12. The commands by which the build made its own
wrapping are run once more with these headers, another name of the result, and, in place of VTK's
library for that CPython, an empty one of its name: Python has loaded the real one by then.
"""
import pathlib
import re
import shlex
import subprocess
import sys

_TARGET = "vtkTerrainPython"


def commands(build):
    """What the build runs to compile and link the wrapping, as lists of words."""
    listed = subprocess.run(["ninja", "-C", build, "-t", "commands", _TARGET], check=True,
                            capture_output=True, text=True).stdout
    mine = [line for line in listed.splitlines() if f"{_TARGET}.dir/" in line and "++" in line]
    return [shlex.split(re.sub(r"^: && | && :$", "", line)) for line in mine]


def stub(folder, version):
    """An empty library in the name of VTK's for a CPython."""
    name = f"libvtkWrappingPythonCore{version}.so"
    path = folder / name
    subprocess.run(["gcc", "-shared", "-x", "c", "/dev/null", "-o", path, f"-Wl,-soname,{name}"], check=True)
    return path


def main():
    """Compiles, and links."""
    build, folder, headers = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    version = headers.name
    tag = f"cpython-{version.replace('.', '')}-x86_64-linux-gnu"
    scratch = folder / tag
    scratch.mkdir()
    core = stub(scratch, version)
    objects = {}
    running = []
    for command in commands(build):
        words = [f"{headers}" if re.search(r"/include/python3\.\d+$", word) else word for word in command]
        words = ["-Os" if re.match(r"-O\d$", word) else word for word in words]  # it only hands calls on
        result = words.index("-o") + 1
        if "-c" in words:
            objects[words[result]] = str(scratch / pathlib.Path(words[result]).name)
            for option in ("-MF", "-MT"):
                del words[words.index(option):words.index(option) + 2]
            compile_one = [objects.get(word, word) for word in words if word != "-MD"]
            running.append(subprocess.Popen(compile_one, cwd=build))
        else:
            words[result] = str(folder / f"vtkTerrain.{tag}.so")
            link = [objects.get(word, word) for word in words if "libvtkWrappingPythonCore" not in word]
            link += ["-Wl,--no-as-needed", core]  # it has no symbol that is asked for
    if any(process.wait() for process in running):
        sys.exit(f"the wrapping does not compile for CPython {version}")
    subprocess.run(link, check=True, cwd=build)


main()
