# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes type hints of the wrapped classes: generate_hints.py FILE.pyi

VTK's wrapping begins each docstring with the signatures of the method, each followed by its
declaration in C++. They become the declarations of a stub file; other classes of VTK are imported
from the modules they are in, types that VTK does not tell are Any.
"""
import keyword
import re
import sys

import vtkterrain.vtkTerrain as wrapped

_HEADER = '''"""Type hints of vtkterrain. Generated from the docstrings of the wrapped classes."""
from typing import Any, MutableSequence, Sequence, Tuple, overload
'''
_PLAIN_TYPES = {"None", "bool", "bytes", "float", "int", "object", "str", "type",
                "Sequence", "MutableSequence", "Tuple"}


def signatures(name, docstring):
    """The signatures a docstring begins with, each on one line."""
    text = ""
    for line in (docstring or "").splitlines():
        if line.startswith("C++:") or not line.strip():
            if text:
                yield text
            if not line.strip():
                return
            text = ""
        elif text or line.startswith(f"{name}("):
            text += " " + line.strip() if text else line


def split(text):
    """Parts of a text between commas that are in no brackets."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


class Scope:
    """What names mean inside of a class."""

    def __init__(self, cls):
        self.class_name = cls.__name__
        self.own_types = {name for name, member in vars(cls).items() if isinstance(member, type)}
        self.mentioned = set()

    def name(self, name):
        """A name as it reads outside of the class; Any if it is no type of VTK's."""
        if name in _PLAIN_TYPES or name == "...":
            return name
        if name in self.own_types:
            return f"{self.class_name}.{name}"
        if not name.startswith("vtk"):
            return "Any"
        self.mentioned.add(name.split(".")[0])
        return name

    def hint(self, text, is_argument):
        """A type in the words of Python's typing.

        VTK 9.1 writes (float, float) for two numbers, and [float, float] for two that the method
        fills in."""
        text = text.strip()
        if text[:1] in "([" and text[-1:] in ")]":
            parts = [self.hint(part, is_argument) for part in split(text[1:-1])] or ["Any"]
            if text[0] == "[":
                return f"MutableSequence[{parts[0]}]"
            return f"Sequence[{parts[0]}]" if is_argument else f"Tuple[{', '.join(parts)}]"
        return re.sub(r"\.\.\.|[A-Za-z_][\w.]*", lambda match: self.name(match[0]), text) or "Any"


def declaration(signature, scope):
    """One signature as (is it static, text of its declaration)."""
    head, _, result = signature.rpartition(" -> ")
    if not head:
        head, result = signature, "None"
    name, _, arguments = head.partition("(")
    declared = []
    for place, argument in enumerate(split(arguments.rpartition(")")[0])):
        label, _, kind = (part.strip() for part in argument.partition(":"))
        kind, has_default, _ = kind.partition("=")
        if label == "self":
            declared.append(label)
            continue
        if keyword.iskeyword(label) or not label.isidentifier():
            label = f"argument{place}"
        declared.append(f"{label}: {scope.hint(kind, True)}{' = ...' if has_default else ''}")
    is_static = declared[:1] != ["self"]
    return is_static, f"def {name}({', '.join(declared)}) -> {scope.hint(result, False)}: ..."


def method_lines(name, docstring, scope):
    """Declarations of a method and its overloads."""
    found = list(dict.fromkeys(declaration(text, scope) for text in signatures(name, docstring)))
    if not found:
        return [f"    def {name}(self, *arguments: Any) -> Any: ..."]
    lines = []
    for is_static, text in found:
        lines += ["    @overload"] * (len(found) > 1) + ["    @staticmethod"] * is_static
        lines.append("    " + text)
    return lines


def class_lines(cls, scope):
    """The stub of a class: its constants, its enumerations, its methods."""
    lines = [f"class {cls.__name__}({scope.name(cls.__mro__[1].__name__)}):"]
    for name, member in sorted(vars(cls).items()):
        if name.startswith("_"):
            continue
        if isinstance(member, type):
            values = [key for key, value in vars(member).items() if isinstance(value, member)]
            lines.append(f"    class {name}(int):")
            lines += [f"        {key}: {scope.name(name)}" for key in values] or ["        ..."]
        elif callable(member):
            lines += method_lines(name, member.__doc__, scope)
        else:
            lines.append(f"    {name}: {type(member).__name__}")
    return lines if len(lines) > 1 else [*lines, "    ..."]


def import_lines(names):
    """Imports of the classes of VTK that the hints mention; Any for those in none of its modules."""
    homes = {}
    for module_name, module in sorted(sys.modules.items()):
        if re.fullmatch(r"vtkmodules\.vtk\w+", module_name):
            homes.update((name, module_name) for name in names & set(vars(module)))
    lines = [f"from {homes[name]} import {name}" for name in sorted(homes)]
    return lines + [f"{name} = Any" for name in sorted(names - set(homes))]


def main():
    """Writes the file."""
    classes = [member for member in vars(wrapped).values()
               if isinstance(member, type) and member.__module__ == wrapped.__name__]
    body, mentioned = [], set()
    for cls in sorted(classes, key=lambda cls: (len(cls.__mro__), cls.__name__)):
        scope = Scope(cls)
        body += ["", *class_lines(cls, scope)]
        mentioned |= scope.mentioned
    imports = import_lines(mentioned - {cls.__name__ for cls in classes})
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write("\n".join([_HEADER.rstrip(), *imports, *body, ""]))


main()
