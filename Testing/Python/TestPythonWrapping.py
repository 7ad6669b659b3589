# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""The classes of the module as Python sees them."""
import ast
import pathlib
import re
import unittest

import vtkTerrainTesting
from vtkmodules.vtkCommonCore import reference

import vtkterrain


def wrapped_classes():
    return [member for name, member in vars(vtkterrain).items()
            if isinstance(member, type) and name.startswith("vtk")]


class TestWrapping(unittest.TestCase):
    def test_every_public_class_is_there(self):
        source = pathlib.Path(__file__).parents[2] / "src"
        exported = {name for header in source.glob("*.h")
                    for name in re.findall(r"^class VTKTERRAIN_EXPORT (\w+)", header.read_text(), re.M)}
        names = {cls.__name__ for cls in wrapped_classes()}
        self.assertGreater(len(names), 15)
        self.assertEqual(names - exported, set())
        old_windows = {name for name in exported if name.endswith(("Window", "WindowFactory"))}
        self.assertLessEqual(exported - names, old_windows)

    def test_every_class_can_be_made_and_tells_of_itself(self):
        for cls in wrapped_classes():
            instance = cls()
            self.assertEqual(instance.GetClassName(), cls.__name__)
            self.assertIn(cls.__name__, str(instance))
            summary = cls.__doc__.splitlines()[0]
            self.assertRegex(summary, f"^{cls.__name__} - ..........")

    def test_every_method_of_one_signature_has_a_docstring(self):
        self.assertIn("exaggerat", vtkterrain.vtkOpenGLTerrainMapper.SetVerticalExaggeration.__doc__)
        self.assertIn("zone", vtkterrain.vtkTerrainGeoreference.SetZone.__doc__)

    def test_properties_of_all_types(self):
        mapper = vtkterrain.vtkOpenGLTerrainMapper()
        for technique in ("Mesh", "Linear", "Exponential", "Equidistant", "Pyramid", "Strips"):
            value = getattr(vtkterrain.vtkTerrainLook.Techniques, technique)
            mapper.SetTechnique(value)
            self.assertEqual(mapper.GetTechnique(), value)
        self.assertRaises(TypeError, mapper.SetTechnique, "Mesh")
        mapper.SetShowCrossings(True)
        self.assertIs(mapper.GetShowCrossings(), True)
        source = vtkterrain.vtkTerrainSource()
        source.SetDimensions(65, 33)
        self.assertEqual(source.GetDimensions(), (65, 33))
        reader = vtkterrain.vtkTerrainRasterReader()
        reader.SetFileName(pathlib.Path("/a/b.tif"))
        self.assertEqual(reader.GetFileName(), "/a/b.tif")

    def test_arrays_in_and_out(self):
        place = vtkterrain.vtkTerrainGeoreference()
        place.SetCoordinateSystem("EPSG:32645")
        place.SetExtent(478000.0, 502000.0, 3088000.0, 3108000.0)
        self.assertEqual(place.GetExtent(), (478000.0, 502000.0, 3088000.0, 3108000.0))
        places = [86.9, 27.95, 100.0, 86.95, 28.0, 200.0]
        scene, back = [0.0] * 6, [0.0] * 6
        self.assertTrue(place.PlacesToScene(places, scene, 2))
        self.assertTrue(place.SceneToPlaces(scene, back, 2))
        for expected, actual in zip(places, back):
            self.assertAlmostEqual(expected, actual, 7)
        self.assertRaises(TypeError, place.PlacesToScene, places, scene, 3)
        horizontal, vertical = reference(0.0), reference(0.0)
        place.GetFlatError(horizontal, vertical)
        self.assertGreater(float(vertical), 1.0)

    def test_a_hierarchy_from_image_to_strips(self):
        from vtkmodules.vtkRenderingCore import vtkCamera

        source = vtkterrain.vtkTerrainSource()
        source.SetDimensions(65, 65)
        source.Update()
        hierarchy = vtkterrain.vtkTerrainHierarchy()
        self.assertFalse(hierarchy.SetHeights(None))
        self.assertTrue(hierarchy.GetErrorMessage())
        self.assertTrue(hierarchy.SetHeights(source.GetOutput()), hierarchy.GetErrorMessage())
        path = pathlib.Path(vtkTerrainTesting.output_path("python.hierarchy"))
        self.assertTrue(hierarchy.WriteFile(path), hierarchy.GetErrorMessage())
        opened = vtkterrain.vtkTerrainHierarchy()
        self.assertTrue(opened.OpenFile(path, True), opened.GetErrorMessage())
        self.assertTrue(vtkterrain.vtkTerrainHierarchy.IsPreparedFile(path))
        reader = vtkterrain.vtkTerrainRasterReader()
        reader.SetFileName(str(path))
        reader.Update()
        self.assertEqual(reader.GetErrorMessage(), "")
        self.assertEqual(reader.GetOutput().GetDimensions(), (65, 65, 1))
        camera = vtkCamera()
        camera.SetPosition(20000.0, -60000.0, 30000.0)
        camera.SetFocalPoint(20000.0, 20000.0, 0.0)
        strips = vtkterrain.vtkTerrainStrips()
        strips.SetHierarchy(opened)
        strips.SetCamera(camera)
        strips.Update()
        self.assertGreater(strips.GetNumberOfTriangles(), 10)

    def test_errors_are_told(self):
        reader = vtkterrain.vtkTerrainRasterReader()
        reader.SetFileName("/nowhere.tif")
        reader.GlobalWarningDisplayOff()
        reader.Update()
        reader.GlobalWarningDisplayOn()
        self.assertIn("/nowhere.tif", reader.GetErrorMessage())

    def test_type_hints_cover_the_classes(self):
        package = pathlib.Path(vtkterrain.__file__).parent
        self.assertTrue((package / "py.typed").exists())
        stub = ast.parse((package / "vtkTerrain.pyi").read_text())
        hinted = {node.name: {part.name for part in node.body if isinstance(part, ast.FunctionDef)}
                  for node in stub.body if isinstance(node, ast.ClassDef)}
        for cls in wrapped_classes():
            methods = {name for name, member in vars(cls).items()
                       if callable(member) and not isinstance(member, type) and name[0] != "_"}
            self.assertEqual(hinted[cls.__name__], methods)
        text = ast.unparse(stub)
        self.assertIn("def SetTechnique(self, technique: vtkTerrainLook.Techniques) -> None",
                      text)
        self.assertIn("def GetExtent(self) -> Tuple[float, float, float, float]", text)


if __name__ == "__main__":
    vtkTerrainTesting.run()
