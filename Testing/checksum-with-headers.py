#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints a checksum of each source file with all headers of the repository that it reaches.

    python3 Testing/checksum-with-headers.py FILE...

An include is looked for by the end of its path, so that no include directories need to be known: of
several headers that fit, all count.
"""

import functools
import hashlib
import pathlib
import re
import subprocess
import sys

INCLUDE = re.compile(rb'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


@functools.cache
def headers_by_name() -> dict[str, list[pathlib.Path]]:
    """The repository's headers, by the last part of their paths."""
    listed = subprocess.run(["git", "ls-files", "*.h"], check=True, capture_output=True, text=True)
    by_name: dict[str, list[pathlib.Path]] = {}
    for line in listed.stdout.splitlines():
        by_name.setdefault(pathlib.Path(line).name, []).append(pathlib.Path(line))
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


def main() -> None:
    """Prints a line for each file: its checksum and its name."""
    for name in sys.argv[1:]:
        digest = hashlib.sha1(usedforsecurity=False)
        for path in reached(pathlib.Path(name)):
            digest.update(path.as_posix().encode() + path.read_bytes())
        print(digest.hexdigest(), name)


if __name__ == "__main__":
    main()
