# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Classes of VTK that meet a terrain as they meet any actor; the judge is a plain actor of all samples."""
import json
import pathlib
import unittest

import numpy as np
import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkTerrainTesting
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTerrain
from vtkmodules.vtkInteractionWidgets import (
    vtkContourWidget,
    vtkDistanceRepresentation3D,
    vtkDistanceWidget,
    vtkImplicitPlaneRepresentation,
    vtkImplicitPlaneWidget2,
    vtkOrientedGlyphContourRepresentation,
    vtkPointHandleRepresentation3D,
    vtkTerrainDataPointPlacer,
)
from vtkmodules.vtkIOExport import vtkGLTFExporter, vtkOBJExporter, vtkVRMLExporter, vtkX3DExporter
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkRenderingAnnotation import vtkCubeAxesActor, vtkLegendBoxActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkLODProp3D,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
    vtkWindowToImageFilter,
)

from vtkterrain import heights_from_array, vtkTerrainActor, vtkTerrainLook, vtkTerrainMesh

SIZE = (400, 300)
CLICKS = ((150, 130), (250, 160))


def hills():
    y, x = np.mgrid[0:1:61j, 0:1:81j]
    return (18.0 * np.exp(-8.0 * ((x - 0.5)**2 + (y - 0.4)**2)) + 3.0 * np.sin(9.0 * x) * np.cos(7.0 * y)
            + 4.0).astype(np.float32)


def make_terrain():
    terrain = vtkTerrainActor()
    terrain.SetInputData(heights_from_array(hills()))
    return terrain


def make_plain():
    """The full mesh as an actor of VTK's own, coloured as terrain is."""
    mesh, mapper, actor = vtkTerrainMesh(), vtkPolyDataMapper(), vtkActor()
    mesh.SetInputData(heights_from_array(hills()))
    mesh.SetMaximumError(0.0)
    mapper.SetInputConnection(mesh.GetOutputPort())
    actor.SetMapper(mapper)
    return actor


class Scene:
    def __init__(self, prop):
        self.prop = prop
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SIZE)
        self.window.AddRenderer(self.renderer)
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.renderer.AddViewProp(prop)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.2, -0.8, 0.6)
        camera.SetViewUp(0.0, 0.0, 1.0)
        self.renderer.ResetCamera(0.0, 80.0, 0.0, 60.0, 0.0, 25.0)
        self.window.Render()

    def picture(self):
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(*SIZE[::-1], 3).astype(int)

    def drag(self, begin, end):
        self.interactor.SetEventInformation(*begin, 0, 0)
        self.interactor.MouseMoveEvent()
        self.interactor.LeftButtonPressEvent()
        self.interactor.SetEventInformation(*end, 0, 0)
        self.interactor.MouseMoveEvent()
        self.interactor.LeftButtonReleaseEvent()


def is_drawn(picture):
    return (picture != 255).any(axis=2)


class TestProps(unittest.TestCase):
    def setUp(self):
        self.terrain = make_terrain()
        self.expected = Scene(self.terrain).picture()
        self.assertGreater(is_drawn(self.expected).mean(), 0.15)

    def test_level_of_detail_prop(self):
        terrain = make_terrain()
        surface = terrain.GetSurfaceActor()  # brings colours and heights up to date
        for mapper, largest in ((terrain.GetTerrainMapper(), 0.0), (surface.GetMapper(), 0.01)):
            prop = vtkLODProp3D()
            prop.AddLOD(mapper, terrain.GetProperty(), 0.0)
            differ = (np.abs(Scene(prop).picture() - self.expected) > 24).any(axis=2).mean()
            self.assertLessEqual(differ, largest)

    def test_assembly(self):
        pictures, bounds, files = [], [], []
        for part in (self.terrain, make_plain()):
            assembly = vtkAssembly()
            part.SetPosition(10.0, 0.0, 0.0)
            assembly.AddPart(part)
            assembly.RotateZ(30.0)
            assembly.SetScale(1.0, 1.0, 1.5)
            scene = Scene(assembly)
            pictures.append(is_drawn(scene.picture()))
            bounds.append(assembly.GetBounds())
            exporter, reader = vtkOBJExporter(), vtkOBJReader()
            path = pathlib.Path(vtkTerrainTesting.output_path("assembly"))
            exporter.SetRenderWindow(scene.window)
            exporter.SetFilePrefix(str(path))
            exporter.Write()
            reader.SetFileName(str(path.with_suffix(".obj")))
            reader.Update()
            files.append(reader.GetOutput().GetBounds())
        np.testing.assert_allclose(bounds[0], bounds[1], atol=1e-4)
        np.testing.assert_allclose(files[0], files[1], atol=0.05)
        self.assertLess((pictures[0] != pictures[1]).mean(), 0.002)
        self.terrain.SetPosition(0.0, 0.0, 0.0)
        np.testing.assert_array_equal(Scene(self.terrain).picture(), self.expected)  # nothing of it is left

    def test_axes_and_a_legend(self):
        scene = Scene(self.terrain)
        axes, legend = vtkCubeAxesActor(), vtkLegendBoxActor()
        axes.SetBounds(self.terrain.GetBounds())
        axes.SetCamera(scene.renderer.GetActiveCamera())
        scene.renderer.AddActor(axes)
        legend.SetNumberOfEntries(1)
        legend.SetEntry(0, self.terrain.GetSurface(), "terrain", (0.0, 0.0, 0.0))
        legend.UseBackgroundOn()
        legend.SetBackgroundColor(0.0, 0.0, 1.0)
        scene.renderer.AddActor(legend)
        picture = scene.picture()
        self.assertGreater((picture == (0, 0, 255)).all(axis=2).sum(), 1000)
        self.assertLess((picture != self.expected).any(axis=2).mean(), 0.3)


class TestColors(unittest.TestCase):
    """What consumers see of the colours."""

    def test_exporters_leave_the_range_as_it_is(self):
        for exporter in (vtkVRMLExporter(), vtkX3DExporter()):
            table = vtkLookupTable()
            table.SetRange(2.0, 30.0)
            table.Build()
            terrain = make_terrain()
            terrain.SetLookupTable(table)
            scene = Scene(terrain)
            before = scene.picture()
            exporter.SetRenderWindow(scene.window)
            exporter.SetFileName(vtkTerrainTesting.output_path("range"))
            exporter.Write()
            self.assertEqual(table.GetRange(), (2.0, 30.0))
            np.testing.assert_array_equal(scene.picture(), before)

    def test_slopes(self):
        heights = np.add.outer(np.arange(40.0), 2.0 * np.arange(50.0))  # 1 a row, 2 a column
        terrain = vtkTerrainActor()
        terrain.SetInputData(heights_from_array(heights, spacing=(2.0, 4.0)))
        terrain.SetVerticalExaggeration(3.0)
        mapper, sources = terrain.GetTerrainMapper(), vtkTerrainLook.ColorSources
        self.assertFalse(terrain.GetSurface().GetPointData().HasArray("Slope"))
        for source, name, value in ((sources.Slope, "Slope", np.degrees(np.arctan(np.hypot(1.0, 0.25)))),
                                    (sources.Aspect, "Aspect", np.degrees(np.arctan2(-1.0, -0.25)) + 360.0)):
            mapper.SetColorSource(source)
            values = vtk_to_numpy(terrain.GetSurface().GetPointData().GetArray(name))
            np.testing.assert_allclose(values, value, rtol=1e-5)
            self.assertEqual(terrain.GetSurfaceActor().GetMapper().GetArrayName(), name)

    def test_slopes_look_as_drawn(self):
        terrain, table = make_terrain(), vtkLookupTable()
        table.SetRange(0.0, 60.0)
        table.Build()
        terrain.SetLookupTable(table)
        terrain.SetSurfaceError(0.0)
        terrain.GetTerrainMapper().SetColorSource(vtkTerrainLook.ColorSources.Slope)
        self.check_mesh(terrain)

    def check_mesh(self, terrain, share=0.95):
        """The mesh's picture against that of the rays."""
        drawn, mesh = Scene(terrain).picture(), Scene(terrain.GetSurfaceActor()).picture()
        shown = is_drawn(drawn) & is_drawn(mesh)
        self.assertGreater(len(np.unique(mesh[shown], axis=0)), 100)
        self.assertGreater((np.abs(drawn - mesh).max(axis=2)[shown] < 40).mean(), share)

    def test_a_drape_is_the_texture(self):
        picture = vtkImageData()
        picture.SetDimensions(160, 120, 1)
        y, x = np.mgrid[0:120, 0:160]
        texels = np.dstack([x, 2 * y, 100 + 0 * x, np.where((x > 40) & (y > 30), 255, 0)]).astype(np.uint8)
        picture.GetPointData().SetScalars(numpy_to_vtk(texels.reshape(-1, 4), deep=True))
        for bounds in ((0.0, 80.0, 0.0, 60.0), (20.0, 110.0, -10.0, 40.0)):
            terrain = make_terrain()
            terrain.GetTerrainMapper().SetDrape(picture, bounds)
            self.check_mesh(terrain)
            texture = terrain.GetSurfaceActor().GetTexture()
            self.assertIs(texture, terrain.GetSurfaceActor().GetTexture())  # made once
            scene = Scene(terrain)
            path = pathlib.Path(vtkTerrainTesting.output_path("drape.gltf"))
            exporter = vtkGLTFExporter()
            exporter.SetRenderWindow(scene.window)
            exporter.SetFileName(str(path))
            exporter.InlineDataOn()
            exporter.Write()
            document = json.loads(path.read_text())
            self.assertEqual(len(document["images"]), 1)
            self.assertIn("TEXCOORD_0", document["meshes"][0]["primitives"][0]["attributes"])
            terrain.GetTerrainMapper().SetDrape(None)
            self.assertIsNone(terrain.GetSurfaceActor().GetTexture())
            self.assertTrue(terrain.GetSurfaceActor().GetMapper().GetScalarVisibility())


class TestWidgets(unittest.TestCase):
    def both(self, act):
        """What the same deed gives on a terrain and on a plain actor."""
        return [act(Scene(prop)) for prop in (make_terrain(), make_plain())]

    def test_plane(self):
        scene = Scene(make_terrain())
        before = is_drawn(scene.picture())
        shape, widget, plane = vtkImplicitPlaneRepresentation(), vtkImplicitPlaneWidget2(), vtkPlane()
        shape.PlaceWidget(scene.prop.GetBounds())
        shape.SetNormal(1.0, 0.0, 0.0)
        shape.SetOrigin(40.0, 30.0, 8.0)
        widget.SetInteractor(scene.interactor)
        widget.SetRepresentation(shape)
        widget.On()
        shape.GetPlane(plane)
        widget.Off()
        scene.prop.GetTerrainMapper().AddClippingPlane(plane)
        after = is_drawn(scene.picture())
        self.assertFalse((after & ~before).any())
        self.assertTrue(0.3 < after.sum() / before.sum() < 0.7)

    def test_distance(self):
        def act(scene):
            widget, shape, placer = vtkDistanceWidget(), vtkDistanceRepresentation3D(), vtkTerrainDataPointPlacer()
            placer.AddProp(scene.prop)
            shape.SetHandleRepresentation(vtkPointHandleRepresentation3D())
            widget.SetInteractor(scene.interactor)
            widget.SetRepresentation(shape)
            widget.On()
            shape.InstantiateHandleRepresentation()
            shape.GetPoint1Representation().SetPointPlacer(placer)
            shape.GetPoint2Representation().SetPointPlacer(placer)
            for click in CLICKS:
                scene.drag(click, click)
            return shape.GetDistance()

        measured, expected = self.both(act)
        self.assertGreater(expected, 40.0)
        self.assertAlmostEqual(measured, expected, delta=0.1)

    def test_contour(self):
        def act(scene):
            widget, shape = vtkContourWidget(), vtkOrientedGlyphContourRepresentation()
            placer, position = vtkTerrainDataPointPlacer(), [0.0, 0.0, 0.0]
            placer.AddProp(scene.prop)
            shape.SetPointPlacer(placer)
            widget.SetInteractor(scene.interactor)
            widget.SetRepresentation(shape)
            widget.On()
            for click in CLICKS:
                scene.drag(click, click)
            nodes = []
            for k in range(shape.GetNumberOfNodes()):
                shape.GetNthNodeWorldPosition(k, position)
                nodes.append(list(position))
            return nodes

        nodes, expected = self.both(act)
        self.assertEqual(len(expected), 2)
        np.testing.assert_allclose(nodes, expected, atol=0.05)

    def test_style(self):
        def act(scene):
            style = vtkInteractorStyleTerrain()
            scene.interactor.SetInteractorStyle(style)
            scene.interactor.Initialize()
            scene.drag((200, 150), (260, 170))
            camera = scene.renderer.GetActiveCamera()
            return (*camera.GetPosition(), *camera.GetFocalPoint(), *camera.GetViewUp())

        moved, expected = self.both(act)
        np.testing.assert_allclose(moved, expected, rtol=1e-6)


if __name__ == "__main__":
    vtkTerrainTesting.run()
