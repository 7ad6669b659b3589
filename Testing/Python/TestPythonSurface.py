# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mesh that a terrain hands out to exporters and VTK's pickers, and that it makes for nobody else."""
import json
import pathlib
import re
import unittest

import numpy as np
import vtkTerrainTesting
from vtkmodules import vtkIOExport
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkRenderingCore import (
    vtkAssembly,
    vtkCellPicker,
    vtkPointPicker,
    vtkPropPicker,
    vtkRenderer,
    vtkRenderWindow,
)

from vtkterrain import heights_from_array, vtkTerrainActor, vtkTerrainPeaks, vtkTerrainPicker

ROWS, COLUMNS = 61, 81
SHIFT = (1000.0, 2000.0, 30.0)
EXAGGERATION = 2.0
_BETWEEN_SAMPLES = 0.3  # of a range of 46, at an error of 0.05 at samples: folds of the mesh cross cells


def hills():
    x, y = np.meshgrid(np.linspace(0.0, 9.0, COLUMNS), np.linspace(0.0, 7.0, ROWS))
    heights = (20.0 * np.sin(x) * np.cos(y) + 3.0 * np.sin(5.0 * x + y)).astype(np.float32)
    heights[20:24, 30:36] = np.nan
    return heights


class Scene:
    def __init__(self, first_row="south"):
        self.terrain = vtkTerrainActor()
        self.image = heights_from_array(hills(), (10.0, 10.0), first_row=first_row)
        self.terrain.SetInputData(self.image)
        self.terrain.SetVerticalExaggeration(EXAGGERATION)
        self.terrain.SetPosition(*SHIFT)
        self.renderer = vtkRenderer()
        self.renderer.AddActor(self.terrain)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetSize(300, 200)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.0, -1.0, 0.7)
        camera.SetViewUp(0.0, 0.0, 1.0)
        self.renderer.ResetCamera()
        camera.Zoom(1.7)
        self.window.Render()

    def mesh_that_was_made(self):
        """What has been made of the mesh so far; asking for the actor makes none."""
        return self.terrain.GetSurfaceActor().GetMapper().GetInputAlgorithm().GetOutput()


def vertical_distances(points):
    """Of points of the world from the bilinear surface; NaN off it."""
    local = (points - SHIFT) / (10.0, 10.0, EXAGGERATION)
    i = np.clip(np.floor(local[:, 0]).astype(int), 0, COLUMNS - 2)
    j = np.clip(np.floor(local[:, 1]).astype(int), 0, ROWS - 2)
    u, v = local[:, 0] - i, local[:, 1] - j
    h = hills().astype(float)
    south = h[j, i] * (1 - u) + h[j, i + 1] * u
    north = h[j + 1, i] * (1 - u) + h[j + 1, i + 1] * u
    return local[:, 2] - (south * (1 - v) + north * v)


class TestSurface(unittest.TestCase):
    def test_it_is_the_surface(self):
        for first_row in ("south", "north"):
            scene = Scene(first_row)
            scene.terrain.SetSurfaceError(0.0)
            points = vtk_to_numpy(scene.terrain.GetSurface().GetPoints().GetData())
            expected = hills() if first_row == "south" else hills()[::-1]
            self.assertEqual(len(points), np.isfinite(expected).sum())  # all samples, none in the hole
            at = np.rint(points[:, :2] / 10.0).astype(int)
            np.testing.assert_allclose(points[:, 2], EXAGGERATION * expected[at[:, 1], at[:, 0]], rtol=1e-6)
            scene.terrain.SetSurfaceError(1.0)
            self.assertLess(scene.terrain.GetSurface().GetNumberOfPoints(), 0.5 * len(points))
            self.assertLessEqual(scene.terrain.GetSurface().GetFieldData().GetArray("MeshError").GetValue(0), 1.0)
            scene.terrain.SetSurfaceError(-1.0)
            low, high = np.nanmin(expected), np.nanmax(expected)
            self.assertAlmostEqual(scene.terrain.GetUsedSurfaceError(), (high - low) / 1000.0, 5)

    def test_it_follows_the_terrain(self):
        scene = Scene()
        before = scene.terrain.GetSurface().GetBounds()
        self.assertAlmostEqual(before[5], EXAGGERATION * float(np.nanmax(hills())), 3)
        scene.terrain.SetVerticalExaggeration(3.0)
        self.assertAlmostEqual(scene.terrain.GetSurface().GetBounds()[5], 1.5 * before[5], 3)
        scene.terrain.SetInputData(heights_from_array(np.zeros((5, 5)), nodata="none"))
        self.assertEqual(scene.terrain.GetSurface().GetBounds(), (0.0, 4.0, 0.0, 4.0, 0.0, 0.0))
        scene.terrain.SetVisibility(False)
        self.assertFalse(scene.terrain.GetSurfaceActor().GetVisibility())

    def test_nobody_asks_nothing_is_made(self):
        scene = Scene()
        scene.window.Render()
        for picker in (vtkTerrainPicker(), vtkPropPicker()):
            picker.Pick(150, 100, 0, scene.renderer)
            self.assertEqual(picker.GetActor(), scene.terrain)
        assembly = vtkAssembly()
        assembly.AddPart(scene.terrain)
        scene.renderer.AddActor(assembly)
        scene.window.Render()
        self.assertEqual(scene.mesh_that_was_made().GetNumberOfPoints(), 0)


class TestPickers(unittest.TestCase):
    """VTK's pickers against our own, which is exact."""

    def test_cells_and_points(self):
        scene = Scene()
        scene.terrain.SetSurfaceError(0.05)
        exact, cells, points = vtkTerrainPicker(), vtkCellPicker(), vtkPointPicker()
        exact.SetTolerance(0.0)
        cells.SetTolerance(0.0)
        generator = np.random.default_rng(11)
        agree = hits = nearest = 0
        for x, y in generator.uniform((0, 0), (300, 200), (1000, 2)):
            exact.Pick(x, y, 0, scene.renderer)
            cells.Pick(x, y, 0, scene.renderer)
            is_hit = cells.GetCellId() >= 0
            agree += is_hit == bool(exact.IsTerrainPicked())
            if is_hit and exact.IsTerrainPicked():
                hits += 1
                self.assertEqual(cells.GetActor(), scene.terrain)
                distance = vertical_distances(np.array([cells.GetPickPosition()]))[0]
                self.assertTrue(abs(distance) <= _BETWEEN_SAMPLES or np.isnan(distance), distance)
                points.Pick(x, y, 0, scene.renderer)
                nearest += points.GetPointId() >= 0
        self.assertGreater(hits, 300)
        self.assertGreaterEqual(agree, 995)  # silhouettes of a mesh are not those of the surface
        self.assertGreater(nearest, 0.9 * hits)

    def test_beside_the_terrain(self):
        scene = Scene()
        picker = vtkCellPicker()
        self.assertEqual(picker.Pick(3, 197, 0, scene.renderer), 0)


class TestExporters(unittest.TestCase):
    def setUp(self):
        self.scene = Scene()
        self.bounds = np.array(self.scene.terrain.GetBounds()).reshape(3, 2)

    def check(self, points, name):
        points = np.asarray(points, dtype=float).reshape(-1, 3)
        self.assertGreater(len(points), 1000, name)
        np.testing.assert_allclose(np.column_stack([points.min(axis=0), points.max(axis=0)]), self.bounds, atol=0.2,
                                   err_msg=name)
        distances = vertical_distances(points)
        self.assertLess(np.nanmax(np.abs(distances)), 0.2, name)

    def write(self, kind, name):
        path = pathlib.Path(vtkTerrainTesting.output_path(name))
        exporter = getattr(vtkIOExport, kind)()
        exporter.SetRenderWindow(self.scene.window)
        if hasattr(exporter, "SetFilePrefix"):
            exporter.SetFilePrefix(str(path.with_suffix("")))
        else:
            exporter.SetFileName(str(path))
        if hasattr(exporter, "InlineDataOn"):
            exporter.InlineDataOn()
        exporter.Write()
        return path

    def test_obj(self):
        reader = vtkOBJReader()
        reader.SetFileName(str(self.write("vtkOBJExporter", "surface.obj")))
        reader.Update()
        self.check(vtk_to_numpy(reader.GetOutput().GetPoints().GetData()), "obj")

    def test_gltf(self):
        document = json.loads(self.write("vtkGLTFExporter", "surface.gltf").read_text())
        positions = document["accessors"][document["meshes"][0]["primitives"][0]["attributes"]["POSITION"]]
        self.assertGreater(positions["count"], 1000)
        node = next(node for node in document["nodes"] if "mesh" in node)
        matrix = np.array(node["matrix"]).reshape(4, 4).T
        corners = np.array([positions["min"], positions["max"]]) @ matrix[:3, :3].T + matrix[:3, 3]
        np.testing.assert_allclose(corners.T, self.bounds, atol=0.2)

    def test_vrml_and_x3d(self):
        text = self.write("vtkVRMLExporter", "surface.wrl").read_text()
        points = re.search(r"point \[(.*?)\]", text, re.S)[1]
        shift = [float(part) for part in re.search(r"translation (\S+) (\S+) (\S+)", text).groups()]
        self.check(np.array(re.findall(r"[-\d.e+]+", points), dtype=float).reshape(-1, 3) + shift, "vrml")
        text = self.write("vtkX3DExporter", "surface.x3d").read_text()
        self.assertGreater(len(re.search(r'<Coordinate[^>]*point="([^"]*)"', text)[1].split()), 3000)

    def test_hidden_terrain_is_not_written(self):
        self.scene.terrain.VisibilityOff()
        document = json.loads(self.write("vtkGLTFExporter", "hidden.gltf").read_text())
        self.assertEqual(document.get("meshes") or [], [])


class TestPeaks(unittest.TestCase):
    def test_most_prominent_first(self):
        x, y = np.meshgrid(np.arange(60.0), np.arange(40.0))
        heights = sum(top * np.exp(-((x - i) ** 2 + (y - j) ** 2) / 20.0)
                      for top, i, j in ((30.0, 15, 10), (50.0, 40, 25), (20.0, 20, 30)))
        peaks = vtkTerrainPeaks()
        peaks.SetInputData(heights_from_array(heights, spacing=(2.0, 3.0), origin=(100.0, 200.0)))
        peaks.SetNumberOfPeaks(2)
        peaks.SetExaggeration(3.0)
        peaks.Update()
        found = peaks.GetOutput()
        np.testing.assert_allclose(vtk_to_numpy(found.GetPoints().GetData()),
                                   [(180, 275, 150), (130, 230, 90)], atol=0.5)
        np.testing.assert_allclose(vtk_to_numpy(found.GetPointData().GetArray("Height")), (50, 30), atol=0.2)
        prominences = vtk_to_numpy(found.GetPointData().GetArray("Prominence"))
        self.assertTrue(49 < prominences[0] <= 50.5 and 25 < prominences[1] < 30.5, prominences)
        peaks.SetMinimumProminence(40.0)
        peaks.Update()
        self.assertEqual(peaks.GetOutput().GetNumberOfPoints(), 1)


if __name__ == "__main__":
    vtkTerrainTesting.run()
