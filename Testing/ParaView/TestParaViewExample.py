# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example for ParaView draws a terrain: TestParaViewExample.py PVBATCH EXAMPLES"""
import os
import pathlib
import subprocess
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).parents[1] / "Python"))
import vtkTerrainTesting  # noqa: E402

PVBATCH, EXAMPLES = sys.argv[1:3]


class Example(unittest.TestCase):
    def test_draws_a_terrain(self):
        picture = vtkTerrainTesting.output_path("example.png")
        pathlib.Path(picture).unlink(missing_ok=True)
        subprocess.run([PVBATCH, "--force-offscreen-rendering", f"{EXAMPLES}/ParaView/render.py",
                        os.environ["VTKTERRAIN_PARAVIEW_PLUGIN"],
                        f"{EXAMPLES}/Places/heights.tif", picture], check=True)
        pixels = vtkTerrainTesting.read_picture(picture)
        self.assertEqual(pixels.shape, (720, 1280, 3))
        self.assertGreater((pixels != pixels[-1, 0]).any(axis=2).mean(), 0.1)


if __name__ == "__main__":
    sys.argv[1:] = []
    vtkTerrainTesting.run()
