#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lists what a compiler is given of some source files, each with a checksum of all that it reaches.

    python3 Testing/list-lint-units.py BUILD_DIR... -- FILE...

BUILD_DIR has a compile_commands.json. Prints a line for each unit that has one of the files: BUILD_DIR, the unit,
the checksum. A unit is a source file, or the file of a unity build that includes several. What no build compiles is
named on standard error.

An include is looked for by the end of its path, so that no include directories need to be known: of
several headers that fit, all count.
"""

import functools
import hashlib
import json
import pathlib
import re
import subprocess
import sys

INCLUDE = re.compile(rb'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


@functools.cache
def own_files() -> frozenset[pathlib.Path]:
    """The files of the repository."""
    listed = subprocess.run(["git", "ls-files"], check=True, capture_output=True, text=True)
    return frozenset(pathlib.Path(line) for line in listed.stdout.splitlines())


@functools.cache
def headers_by_name() -> dict[str, list[pathlib.Path]]:
    """The repository's headers, by the last part of their paths."""
    by_name: dict[str, list[pathlib.Path]] = {}
    for path in own_files():
        if path.suffix == ".h":
            by_name.setdefault(path.name, []).append(path)
    return by_name


@functools.cache
def included(path: pathlib.Path) -> tuple[pathlib.Path, ...]:
    """The repository's headers that the file itself includes."""
    names = [name.decode() for name in INCLUDE.findall(path.read_bytes())]
    return tuple(
        header
        for name in names
        for header in headers_by_name().get(pathlib.Path(name).name, [])
        if header.as_posix().endswith(name.removeprefix("../"))
    )


def reached(path: pathlib.Path) -> list[pathlib.Path]:
    """The file and all headers of the repository that it reaches, sorted."""
    seen = {path}
    waiting = [path]
    while waiting:
        for header in included(waiting.pop()):
            if header not in seen:
                seen.add(header)
                waiting.append(header)
    return sorted(seen)


def members(unit: pathlib.Path) -> list[pathlib.Path]:
    """The repository's source files of a unit."""
    files = [unit]
    if "Unity" in unit.parts:
        files = [pathlib.Path(name.decode()) for name in INCLUDE.findall(unit.read_bytes())]
    root = pathlib.Path.cwd()
    inside = [file.relative_to(root) for file in files if file.is_relative_to(root)]
    return [file for file in inside if file in own_files()]


def checksum(files: list[pathlib.Path]) -> str:
    """Of the files, and of all headers that they reach."""
    digest = hashlib.sha1(usedforsecurity=False)
    for path in sorted({path for file in files for path in reached(file)}):
        digest.update(path.as_posix().encode() + path.read_bytes())
    return digest.hexdigest()


def main() -> None:
    """Prints the lines."""
    split = sys.argv.index("--")
    missing = {pathlib.Path(name) for name in sys.argv[split + 1 :]}
    for build in sys.argv[1:split]:
        commands = pathlib.Path(build, "compile_commands.json")
        entries = json.loads(commands.read_text(encoding="utf-8")) if commands.exists() else []
        for unit in dict.fromkeys(entry["file"] for entry in entries):
            files = members(pathlib.Path(unit))
            if missing.intersection(files):
                missing.difference_update(files)
                print(build, unit, checksum(files))
    for path in sorted(missing):
        print(f"not compiled here, not linted: {path}", file=sys.stderr)


if __name__ == "__main__":
    main()
