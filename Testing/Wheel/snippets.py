# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python snippets of docs/install.md, each by itself: snippets.py SOURCE FOLDER

They run in FOLDER, where dem.tif is a terrain, and draw without a window.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

source, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
shutil.copy(source / "Examples/Places/heights.tif", folder / "dem.tif")
snippets = re.findall(r"^```python\n(.*?)^```$", (source / "docs/install.md").read_text(), re.S | re.M)
assert len(snippets) >= 3, "there are three snippets at least"
for number, snippet in enumerate(snippets):
    subprocess.run([sys.executable, "-c", snippet], check=True, cwd=folder,
                   env={**os.environ, "PYVISTA_OFF_SCREEN": "true"})
    print(f"Snippet {number + 1}: ran")
