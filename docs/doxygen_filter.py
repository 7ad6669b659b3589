#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints a header as Doxygen takes it: what every class of VTK has refers to VTK's own documentation.

Those are New, PrintSelf, overridden methods, constructors, destructors and what is deleted, where no comment
precedes them. A member that follows another without an empty line, such as a getter behind its setter, refers to
that one. Lines keep their numbers.
"""

import re
import sys

STANDARD = re.compile(
    r"\boverride\b|=\s*delete|^static \w+\* New\(\)|^~?(vtk\w+)\(\)( = default)?;$"
)


def annotate(text):
    """Puts a comment before each standard declaration of a header's text that has none."""
    statement_open = False
    commented = False
    lines = text.split("\n")
    for k, line in enumerate(lines):
        code = line.strip()
        if not statement_open and code and not code.startswith(("/", "*", "#")):
            statement = code
            for following in lines[k + 1 :]:
                if re.search(r"[;{}:]$", statement):
                    break
                statement += " " + following.strip()
            follows = re.match(r"  \S", line) and re.search(r"[;}]$", lines[k - 1])
            if not commented and (STANDARD.search(statement) or follows):
                words = "As VTK documents it." if STANDARD.search(statement) else "See the member before."
                lines[k] = line.replace(code, f"/** {words} */ {code}")
        statement_open = bool(code) and not re.search(r"[;{}:/]$", code) and not code.startswith(("/", "*", "#"))
        commented = code.startswith("///") and code != "///@}"
    return "\n".join(lines)


with open(sys.argv[1], encoding="utf-8") as header:
    print(annotate(header.read()), end="")
