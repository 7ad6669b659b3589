#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Breaks shaders/ and src/ on purpose, one line at a time, and sees whether the tests notice.

    python3 Testing/Mutations/run.py BUILD_DIR [--only REGEX] [--check]

mutations.ini beside this file names the mutations and the tests that have to notice each. Files are changed in
place and restored, so the tree must be clean; BUILD_DIR is a configured build with tests, which pass there without
a mutation. Prints a row of a table for each mutation. Fails if more than 5 % of them pass unnoticed. --check only
looks whether each text stands once in its file.
"""

import argparse
import configparser
import pathlib
import re
import subprocess
import sys
import textwrap
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]


def read_mutations():
    """The mutations: dictionaries of name, file, find, replace, tests."""
    parser = configparser.ConfigParser(interpolation=None, delimiters=("=",), comment_prefixes=("#",))
    parser.optionxform = str
    parser.read(pathlib.Path(__file__).with_name("mutations.ini"), encoding="utf-8")
    return [{"name": name, **parser[name]} for name in parser.sections()]


def lines_of(text):
    """Lines of a text without what they are indented by."""
    return [line.strip() for line in textwrap.dedent(text).splitlines() if line.strip()]


def mutate(mutation):
    """The mutated text of the file; None unless what to find stands in it once."""
    source = (ROOT / mutation["file"]).read_text(encoding="utf-8").split("\n")
    find = lines_of(mutation["find"])
    count = len(find)
    places = [
        k
        for k in range(len(source) - count + 1)
        if all(
            (part in line if count == 1 else part == line.strip())
            for part, line in zip(find, source[k : k + count])
        )
    ]
    if len(places) != 1:
        return None
    at = places[0]
    if count == 1:
        source[at] = source[at].replace(find[0], mutation["replace"].strip())
    else:
        source[at : at + count] = lines_of(mutation["replace"])
    return "\n".join(source)


def run(command, directory, seconds):
    """Exit status of a command, and its output; 124 where it takes longer."""
    try:
        done = subprocess.run(
            command,
            check=False,
            cwd=directory,
            timeout=seconds,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
    except subprocess.TimeoutExpired:
        return 124, ""
    return done.returncode, done.stdout


def targets_of(tests, build_dir):
    """Targets that make the tests of a regular expression."""
    listed = run(["ctest", "-N", "-R", tests], build_dir, 60)[1]
    names = re.findall(r"^ *Test +#\d+: (.*)$", listed, re.MULTILINE)
    return sorted(
        {name.rsplit("-", 1)[0] if name.startswith("Test") else "vtkTerrainUnitTests" for name in names}
    )


def judge(mutation, build_dir):
    """What becomes of a mutation: noticed, unnoticed, does not build, took too long, or no such text or tests."""
    mutated = mutate(mutation)
    targets = targets_of(mutation["tests"], build_dir)
    if mutated is None or not targets:
        return "no such text" if mutated is None else "no such tests"
    path = ROOT / mutation["file"]
    original = path.read_text(encoding="utf-8")
    try:
        path.write_text(mutated, encoding="utf-8")
        if run(["cmake", "--build", str(build_dir), "--target", *targets], ROOT, 1200)[0] != 0:
            return "does not build"
        status, words = run(["ctest", "--stop-on-failure", "-R", mutation["tests"]], build_dir, 1200)
        if status == 124 or "***Timeout" in words:
            return "took too long"
        return "noticed" if status != 0 else "**unnoticed**"
    finally:
        path.write_text(original, encoding="utf-8")


def why_not_ready(mutations, build_dir):
    """Why the mutations cannot be judged: the tests that fail without any; empty if all pass."""
    if run(["cmake", "--build", str(build_dir), "--target", "vtkTerrainUnitTests"], ROOT, 3600)[0] != 0:
        return f"The unit tests do not build in {build_dir}: cmake --build {build_dir} tells why"
    tests = sorted({mutation["tests"] for mutation in mutations})
    targets = sorted({target for each in tests for target in targets_of(each, build_dir)})
    if run(["cmake", "--build", str(build_dir), "--target", *targets], ROOT, 3600)[0] != 0:
        return f"The tests do not build in {build_dir}: cmake --build {build_dir} tells why"
    status, words = run(["ctest", "-R", "|".join(tests)], build_dir, 3600)
    return "" if status == 0 else f"Tests fail without any mutation:\n{words}"


def main():
    """Runs the mutations that the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build_dir", type=pathlib.Path)
    parser.add_argument("--only", default="", help="mutations whose name this regular expression finds")
    parser.add_argument("--check", action="store_true", help="look for the texts, build nothing")
    options = parser.parse_args()
    mutations = [mutation for mutation in read_mutations() if re.search(options.only, mutation["name"])]
    if options.check:
        lost = [mutation["name"] for mutation in mutations if mutate(mutation) is None]
        for name in lost:
            print(f"No such text, or several: {name}")
        sys.exit(1 if lost else 0)
    if run(["git", "status", "--porcelain", "src", "shaders"], ROOT, 60)[1]:
        sys.exit("The tree is changed in src/ or shaders/: commit first, for files are changed in place")
    why = why_not_ready(mutations, options.build_dir.resolve())
    if why:
        sys.exit(why)
    print("| mutation | file | tests | result | s |\n| --- | --- | --- | --- | ---: |")
    bad = 0
    for mutation in mutations:
        began = time.monotonic()
        result = judge(mutation, options.build_dir.resolve())
        bad += result != "noticed"
        tests = mutation["tests"].replace("|", ", ")
        print(
            f"| {mutation['name']} | {mutation['file']} | {tests} | {result} | {time.monotonic() - began:.0f} |",
            flush=True,
        )
    print(f"\n{len(mutations) - bad} of {len(mutations)} noticed")
    sys.exit(1 if bad > 0.05 * len(mutations) else 0)


if __name__ == "__main__":
    main()
