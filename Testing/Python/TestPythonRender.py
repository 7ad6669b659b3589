# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures drawn from Python, without a display."""
import os
import pathlib
import subprocess
import sys
import unittest

import numpy as np
import vtkTerrainTesting

EXAMPLE = pathlib.Path(__file__).parents[2] / "Examples" / "Python" / "render.py"


def hill():
    """A round hill."""
    j, i = np.mgrid[0:48, 0:64]
    return 12.0 * np.exp(-((i - 30.0) ** 2 + (j - 20.0) ** 2) / 120.0)


class TestRender(unittest.TestCase):
    def test_example_draws_what_the_program_in_cxx_draws(self):
        path = vtkTerrainTesting.output_path("hill.asc")
        vtkTerrainTesting.write_ascii_grid(path, hill())
        from_python = vtkTerrainTesting.output_path("hill-python.png")
        from_cxx = vtkTerrainTesting.output_path("hill-cxx.png")
        subprocess.run([sys.executable, EXAMPLE, path, from_python], check=True)
        picture = vtkTerrainTesting.read_picture(from_python)
        self.assertEqual(picture.shape, (720, 1280, 3))
        surface = (picture != picture[0, 0]).any(axis=2).mean()
        self.assertGreater(surface, 0.15)
        self.assertLess(surface, 0.95)
        program = os.environ.get("VTKTERRAIN_PIPELINE_PROGRAM")
        if not program:
            self.skipTest("the program terrain-pipeline is not built")
        subprocess.run([program, path, from_cxx], check=True)
        np.testing.assert_array_equal(picture, vtkTerrainTesting.read_picture(from_cxx))

    def test_example_leaves_no_picture_of_what_cannot_be_read(self):
        picture = pathlib.Path(vtkTerrainTesting.output_path("nothing.png"))
        picture.unlink(missing_ok=True)
        result = subprocess.run([sys.executable, EXAMPLE, "/nowhere.tif", picture], check=False, capture_output=True,
                                text=True)
        self.assertEqual(result.returncode, 1)
        self.assertIn("'/nowhere.tif'", result.stderr)
        self.assertFalse(picture.exists())

    def test_window_without_a_display(self):
        from vtkmodules.vtkCommonCore import vtkVersion
        from vtkmodules.vtkRenderingCore import vtkRenderWindow

        import vtkterrain  # noqa: F401, registers the windows

        window = vtkRenderWindow()
        self.assertIn("EGL", window.GetClassName(), vtkVersion.GetVTKVersionFull())
        window.SetOffScreenRendering(1)
        window.Render()
        self.assertTrue(window.SupportsOpenGL())


if __name__ == "__main__":
    vtkTerrainTesting.run()
