#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints which files of src/ the tests run too little of.

    python3 Testing/Coverage/report.py COVERAGE.json [--lines FILE]

COVERAGE.json is what gcovr --json writes. A table of the files under 80 % of their lines, and the total; fails under
92 %. --lines prints the lines of a file that no test runs.
"""

import argparse
import json
import sys

LOW = 80.0
LEAST = 92.0


def share(lines):
    """Per cent of lines that were run; 100 without any."""
    return 100.0 * sum(count > 0 for count in lines.values()) / len(lines) if lines else 100.0


def read(path):
    """Counts of each line of each file. gcovr has one entry a compilation of a line: they are added up."""
    with open(path, encoding="utf-8") as stream:
        entries = json.load(stream)["files"]
    files = {}
    for entry in entries:
        lines = files.setdefault(entry.get("file") or entry["filename"], {})
        for line in entry["lines"]:
            if not line.get("gcovr/noncode"):
                number = line["line_number"]
                lines[number] = lines.get(number, 0) + line["count"]
    return files


def main():
    """Prints what the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("coverage")
    parser.add_argument("--lines", default="", help="the lines of this file that no test runs")
    options = parser.parse_args()
    files = read(options.coverage)
    if options.lines:
        print(*(number for number, count in sorted(files[options.lines].items()) if count == 0))
        return
    print("| file | lines | run |\n| --- | ---: | ---: |")
    for name, lines in sorted(files.items(), key=lambda item: share(item[1])):
        if share(lines) < LOW:
            print(f"| {name} | {len(lines)} | {share(lines):.1f} % |")
    total = {(name, number): count for name, lines in files.items() for number, count in lines.items()}
    print(f"\n{share(total):.1f} % of {len(total)} lines in {len(files)} files")
    sys.exit(share(total) < LEAST)


if __name__ == "__main__":
    main()
