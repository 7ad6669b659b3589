#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lets the Python package and terrain-view be used at random for a while, and sees that they stay well.

    python3 Testing/Soak/run.py [MINUTES] [--build DIR] [--seed N] [--only python|view]

MINUTES, 30 by default, are those of each. DIR is a build with examples, `build`
by default. Fails on any word that a session says on its standard error, errors of OpenGL among them
(Mesa tells them there), on an exit status other than 0, and on memory that grows: sessions rest now and then, with
nothing but a small terrain open, and say their resident memory. After the first quarter of the time its median in the
first third of the rests and in the last one may differ by 5 %, and by 2 MB for each window that the viewer has opened
between: a window of VTK 9.1 on an X server leaves 0.9 MB behind with a cone alone in it.
"""

import argparse
import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
WARM_UP = 0.25
MOST_GROWTH = 0.05
MOST_OF_A_WINDOW = 2048  # kB


def python_of(build):
    """The Python of the environment for the tests, if it has been made, else this one."""
    environment = build / "python-env"
    return str(environment / "bin" / "python") if (environment / "made-of").exists() else sys.executable


def environment_of(build):
    """What the sessions see of the build, of EGL and of Mesa's errors."""
    packages = sorted(build.glob("**/vtkterrain/__init__.py"), key=lambda path: len(path.parts))
    if not packages:
        sys.exit(f"There is no Python package in {build}: cmake --build {build}, or --build DIR for another")
    found = dict(os.environ)
    found.update(
        PYTHONPATH=os.pathsep.join([str(packages[0].parents[1]), found.get("PYTHONPATH", "")]),
        PYTHONDONTWRITEBYTECODE="1",
        VTK_DEFAULT_OPENGL_WINDOW="vtkEGLRenderWindow",
        MESA_DEBUG="1",
        MALLOC_ARENA_MAX="2",  # else each thread keeps what it once needed
        XDG_CACHE_HOME=str(build / "soak" / "cache"),
    )
    found.pop("DISPLAY", None)
    return found


def has_positive_control(python, environment):
    """Whether an error of OpenGL is told on standard error here."""
    done = subprocess.run(
        [python, str(HERE / "scene.py"), "--break"], env=environment, capture_output=True, text=True, check=False
    )
    return "GL_INVALID_ENUM" in done.stderr


def growth_of(rests, minutes):
    """What times in minutes, resident memory in kB and windows at rests say: words, and whether it is flat."""
    settled = [rest for rest in rests if rest[0] >= WARM_UP * minutes]
    if len(settled) < 6:
        return f"only {len(settled)} rests after {WARM_UP * minutes:.1f} minutes: give it more minutes", False
    third = len(settled) // 3
    _, first, opened = (statistics.median(column) for column in zip(*settled[:third]))
    _, last, opened_last = (statistics.median(column) for column in zip(*settled[-third:]))
    allowed = MOST_GROWTH * first + MOST_OF_A_WINDOW * (opened_last - opened)
    words = (
        f"{len(settled)} rests after the warm-up: {first / 1024:.1f} MB, then {last / 1024:.1f} MB "
        f"({allowed / 1024:.1f} MB more are allowed)"
    )
    return words, last - first <= allowed


def soak(name, command, environment, folder, minutes):
    """Runs a session; what is wrong with it, empty if nothing is."""
    began = time.monotonic()
    errors = folder / f"{name}.errors"
    rests = []
    with open(folder / f"{name}.log", "w", encoding="utf-8") as log, open(errors, "wb") as stream:
        with subprocess.Popen(
            command, env=environment, cwd=folder, stdout=subprocess.PIPE, stderr=stream, text=True
        ) as session:
            for line in session.stdout:
                log.write(line)
                log.flush()
                rest = re.match(r"rest (\d+)(?: (\d+))?$", line)
                if rest:
                    rests.append(((time.monotonic() - began) / 60.0, int(rest[1]), int(rest[2] or 0)))
                if errors.stat().st_size:
                    session.kill()
        status = session.returncode
    words, is_flat = growth_of(rests, minutes)
    print(f"{name}: {words}", flush=True)
    if errors.stat().st_size:
        return f"{name} said: {errors.read_text(encoding='utf-8', errors='replace')[:2000]}"
    if status != 0:
        return f"{name} ended with status {status}; {folder / name}.log has its last steps"
    return "" if is_flat else f"{name}: the memory is not flat; {folder / name}.log has the numbers"


def main():
    """Runs the sessions that the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("minutes", type=float, nargs="?", default=30.0, help="of each, default 30")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=("python", "view"))
    options = parser.parse_args()
    build = options.build.resolve()
    folder = build / "soak"
    folder.mkdir(parents=True, exist_ok=True)
    python = python_of(build)
    environment = environment_of(build)
    if not has_positive_control(python, environment):
        print("Errors of OpenGL are not told here: only Mesa does so")
    subprocess.run([python, str(HERE / "files.py"), str(folder)], env=environment, check=True)
    words = ["--minutes", str(options.minutes), "--seed", str(options.seed)]
    sessions = {
        "python": [python, str(HERE / "scene.py"), str(folder), *words],
        "view": [
            *(str(build / "bin" / name) for name in ("SoakTerrainView", "terrain-view")),
            *(str(folder), str(options.minutes), str(options.seed)),
        ],
    }
    wrong = [
        soak(name, command, environment, folder, options.minutes)
        for name, command in sessions.items()
        if options.only in (None, name)
    ]
    for each in wrong:
        print(each, end="\n" if each else "")
    sys.exit(any(wrong))


if __name__ == "__main__":
    main()
