# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package as a whole: its names, and what it says where VTK, GDAL or OpenGL is missing."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import vtkTerrainTesting

READ = """
import vtkterrain
reader = vtkterrain.vtkTerrainRasterReader()
reader.GlobalWarningDisplayOff()
reader.SetFileName({!r})
reader.Update()
print(reader.GetErrorMessage() or 'read')
print(vtkterrain.vtkTerrainRasterReader.GetGDALFile())
"""


def run(code, path=(), **environment):
    """Runs code in a Python of its own; returns what it printed, and its errors."""
    paths = [*map(str, path), *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False,
                            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths), **environment})
    return result.stdout.strip(), result.stderr.strip()


class TestNames(unittest.TestCase):
    def test_a_star_import_hides_nothing(self):
        printed, errors = run("""
import vtkterrain
package = vtkterrain
from vtkterrain import *
assert vtkterrain is package
assert callable(heights_from_array) and callable(array_from_heights)
print(vtkTerrainActor.__name__, "vtkTerrain" in globals())
""")
        self.assertEqual((printed, errors), ("vtkTerrainActor False", ""))

    def test_all_names_are_there(self):
        import vtkterrain

        self.assertEqual([name for name in vtkterrain.__all__ if not hasattr(vtkterrain, name)], [])
        self.assertRegex(vtkterrain.__version__, r"^\d+\.\d+\.\d+$")

    def test_the_former_name_is_the_same_package_and_warns(self):
        printed, errors = run("""
from vtkTerrain import *
import vtkTerrain
import vtkterrain
import vtkTerrain.heights
assert vtkTerrain is vtkterrain
assert vtkTerrain.heights is vtkterrain.heights
from vtkTerrain.vtkTerrain import vtkTerrainSource
assert vtkTerrainSource is vtkterrain.vtkTerrainSource
assert vtkterrain.heights.__spec__.name == "vtkterrain.heights"
vtkTerrain.heights_from_array([[1.0, 2.0]])
try:
    import vtkTerrain.nothing
except ModuleNotFoundError as error:
    print(error)
""")
        self.assertIn("vtkterrain.nothing", printed)
        self.assertEqual(errors.count("FutureWarning"), 1)
        self.assertIn("import vtkterrain", errors)


class TestSupply(unittest.TestCase):
    def test_another_vtk_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            fake = pathlib.Path(folder, "vtkmodules")
            fake.mkdir()
            (fake / "__init__.py").touch()
            for version in ("9.5.2", "9.0.3", "9.70.1"):
                (fake / "vtkCommonCore.py").write_text(
                    f"class vtkVersion:\n    GetVTKVersion = staticmethod(lambda: {version!r})\n")
                errors = run("import vtkterrain", [folder])[1].splitlines()[-1]
                self.assertIn(f"imports {version} from {fake}", errors)
                self.assertIn("pip install 'vtk>=9.", errors)
            (fake / "vtkCommonCore.py").write_text("raise ImportError('libvtk.so: no such file')\n")
            errors = run("import vtkterrain", [folder])[1].splitlines()[-1]
            self.assertIn("cannot import any (libvtk.so: no such file)", errors)

    def test_without_opengl_it_warns_before_a_window_ends_the_process(self):
        code = """
import ctypes
original = ctypes.CDLL.__init__
def missing(self, name, *arguments, **options):
    if name and name.startswith(("libEGL", "libOSMesa")):
        raise OSError(name)
    original(self, name, *arguments, **options)
ctypes.CDLL.__init__ = missing
import vtkterrain
"""
        self.assertIn("libgl1-mesa-dri", run(code, DISPLAY="")[1])
        self.assertEqual(run(code, DISPLAY=":99")[1], "")
        self.assertEqual(run("import vtkterrain", DISPLAY="")[1], "")

    def test_without_a_driver_it_warns_who_asks_for_what_draws(self):
        code = """
import ctypes
original = ctypes.CDLL.__init__
def missing(self, name, *arguments, **options):
    if name and name.startswith("libOSMesa"):
        raise OSError(name)
    original(self, name, *arguments, **options)
ctypes.CDLL.__init__ = missing
import vtkterrain
print("imported", file=__import__("sys").stderr)
from vtkterrain import vtkTerrainActor
assert vtkterrain.vtkTerrainActor is vtkTerrainActor and "vtkOpenGLTerrainMapper" in dir(vtkterrain)
"""
        self.assertEqual(run(code, DISPLAY="")[1], "imported")
        alone = {"__EGL_VENDOR_LIBRARY_DIRS": "/nowhere"}  # libEGL without any driver
        before, _, after = run(code, DISPLAY="", **alone)[1].partition("imported")
        self.assertEqual(before, "")
        self.assertEqual(after.count("RuntimeWarning"), 1)
        self.assertRegex(after, "libEGL finds no driver .* libegl1 libgl1-mesa-dri")
        self.assertEqual(run(code, DISPLAY=":99", **alone)[1], "imported")

    def test_grids_of_geoids_in_share_are_found(self):
        code = "import os, sys\nsys.prefix = {!r}\nimport vtkterrain\nprint(os.environ.get('GEOGRAPHICLIB_DATA'))"
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(run(code.format(folder))[0], "None")
            pathlib.Path(folder, "share", "GeographicLib", "geoids").mkdir(parents=True)
            self.assertEqual(run(code.format(folder))[0], f"{folder}/share/GeographicLib")


class TestGDAL(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.path = vtkTerrainTesting.output_path("package.asc")
        vtkTerrainTesting.write_ascii_grid(cls.path, np.arange(12.0).reshape(3, 4))
        cls.answer, _, cls.gdal = run(READ.format(cls.path))[0].partition("\n")
        if cls.answer != "read":
            raise unittest.SkipTest(cls.answer)

    def test_it_is_loaded_when_it_is_needed(self):
        printed, _ = run("import vtkterrain\nprint(repr(vtkterrain.vtkTerrainRasterReader.GetGDALFile()))")
        self.assertEqual(printed, "''")
        self.assertIn("libgdal", self.gdal)

    def test_none_is_told_with_the_remedy(self):
        printed, _ = run(READ.format(self.path), VTKTERRAIN_GDAL="/nowhere/libgdal.so")
        self.assertIn(f"'{self.path}'", printed)
        self.assertIn("/nowhere/libgdal.so", printed)

    def test_a_library_that_is_no_gdal_is_told(self):
        printed, _ = run(READ.format(self.path), VTKTERRAIN_GDAL="libm.so.6")
        self.assertIn("it has no function", printed)

    def test_the_gdal_of_an_imported_package_is_taken_and_goes_on_working(self):
        bringers = {"rasterio": "rasterio.open({0!r}).read(1).sum()",
                    "pyogrio": "int(pyogrio.__gdal_version__[0] >= 3) and 66",
                    "osgeo": "gdal.Open({0!r}).ReadAsArray().sum()"}
        found = set()
        for package, use in bringers.items():
            importing = f"import {package}\n" if package != "osgeo" else "from osgeo import gdal\n"
            if run(importing)[1]:
                continue
            printed, errors = run(importing + READ.format(self.path) +
                                  f"print({use.format(self.path)})\n")
            answer, file, total = printed.split("\n")
            self.assertEqual((answer, float(total)), ("read", 66.0), errors)
            if package != "osgeo":
                self.assertIn(f"{package}.libs", file)
            found.add(file)
        if not found:
            self.skipTest("no package of Python brings GDAL")

    def test_two_in_a_process(self):
        printed, errors = run("import pyogrio, rasterio\n" + READ.format(self.path) + f"""
import numpy as np
place = vtkterrain.vtkTerrainGeoreference()
place.SetCoordinateSystem("EPSG:32645")
place.SetExtent(478000.0, 502000.0, 3088000.0, 3108000.0)
print(repr(place.GetWhyNot()), rasterio.open({self.path!r}).read(1).sum())
""")
        if "ModuleNotFoundError" in errors:
            self.skipTest("rasterio and pyogrio are not both installed")
        answer, file, last = printed.split("\n")
        self.assertEqual((answer, last), ("read", "'' 66.0"), errors)
        self.assertRegex(file, r"(rasterio|pyogrio)\.libs")


if __name__ == "__main__":
    vtkTerrainTesting.run()
