# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pickers of VTK and PyVista against vtkTerrainPicker, which is exact.

A picker of the mesh sees a surface that lies nowhere farther from the heights than a bound. So heights
that are raised and lowered by the bound tell for each ray whether it must hit, and between which
distances. Rays about which the two do not agree pass a silhouette: they are few.
"""
import unittest
import warnings

import numpy as np
import vtkTerrainTesting
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkSelectionNode
from vtkmodules.vtkRenderingCore import (
    vtkAreaPicker,
    vtkAssembly,
    vtkCellPicker,
    vtkHardwareSelector,
    vtkPointPicker,
    vtkPropPicker,
    vtkRenderedAreaPicker,
    vtkRenderer,
    vtkRenderWindow,
)

from vtkterrain import heights_from_array, vtkTerrainActor, vtkTerrainPicker

try:
    import pyvista

    from vtkterrain import plotting
except ImportError:
    pyvista = None

ROWS, COLUMNS = 41, 51
EXAGGERATION = 2.0
SIZE = (300, 200)
CLICKS = np.random.default_rng(3).integers((1, 1), (299, 199), (1000, 2)).astype(float)
LARGEST_SHARE_OF_SILHOUETTES = 0.02


def hill():
    y, x = np.mgrid[0:1:ROWS * 1j, 0:1:COLUMNS * 1j]
    return (8.0 * np.exp(-8.0 * ((x - 0.5)**2 + (y - 0.4)**2)) + np.sin(9.0 * x) + x + 1.0).astype(np.float32)


def camera_of(renderer):
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(25.0, 20.0, 8.0)
    camera.SetPosition(38.0, -55.0, 32.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCameraClippingRange()


def make_scene(heights, assembly=None):
    terrain = vtkTerrainActor()
    terrain.SetInputData(heights_from_array(heights))
    terrain.SetVerticalExaggeration(EXAGGERATION)
    renderer, window = vtkRenderer(), vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    if assembly is None:
        renderer.AddActor(terrain)
    else:
        assembly.AddPart(terrain)
        renderer.AddActor(assembly)
    camera_of(renderer)
    window.Render()
    return terrain, renderer, window


def exact_picks(renderer, clicks):
    """Position of each click on the surface, NaN beside it."""
    picker = vtkTerrainPicker()
    picker.SetTolerance(0.0)
    found = np.full((len(clicks), 3), np.nan)
    for k, (x, y) in enumerate(clicks):
        picker.Pick(x, y, 0.0, renderer)
        if picker.IsTerrainPicked():
            found[k] = picker.GetPickPosition()
    return found


def bound_of(surface):
    """Largest vertical distance of the mesh from the bilinear heights, in their unit, between samples, too."""
    fine = 8
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    h = hill().astype(float)
    worst = 0.0
    for a, b, c in points[triangles]:
        low, high = np.floor(np.min([a, b, c], axis=0)), np.ceil(np.max([a, b, c], axis=0))
        x, y = np.meshgrid(np.arange(low[0], high[0] + 1e-9, 1 / fine), np.arange(low[1], high[1] + 1e-9, 1 / fine))
        area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
        v = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area
        w = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area
        inside = (v >= -1e-9) & (w >= -1e-9) & (v + w <= 1 + 1e-9)
        x, y, v, w = x[inside], y[inside], v[inside], w[inside]
        i, j = np.minimum(x.astype(int), COLUMNS - 2), np.minimum(y.astype(int), ROWS - 2)
        s, t = x - i, y - j
        height = ((1 - t) * ((1 - s) * h[j, i] + s * h[j, i + 1]) + t * ((1 - s) * h[j + 1, i] + s * h[j + 1, i + 1]))
        z = (a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2])) / EXAGGERATION
        worst = max(worst, np.abs(z - height).max(initial=0.0))
    return 1.05 * worst  # samples of an eighth of a cell


class PicksTest(unittest.TestCase):
    def setUp(self):
        self.terrain, self.renderer, self.window = make_scene(hill())
        self.eye = np.array(self.renderer.GetActiveCamera().GetPosition())

    def limits(self, clicks):
        """Which clicks must hit (1), must miss (0) or may do either (-1), and from where to where."""
        bound = bound_of(self.terrain.GetSurface())
        self.assertLess(bound, 0.12)  # of a range of 9
        scenes = [make_scene((hill() + shift).astype(np.float32)) for shift in (bound, 0.0, -bound)]
        picks = [exact_picks(renderer, clicks) for _, renderer, _ in scenes]
        distances = np.linalg.norm(np.array(picks) - self.eye, axis=2)
        hits = np.isfinite(distances).sum(axis=0)
        verdict = np.where(hits == 3, 1, np.where(hits == 0, 0, -1))
        return verdict, np.nanmin(np.nan_to_num(distances, nan=np.inf), axis=0), np.nan_to_num(distances).max(axis=0)

    def check(self, found, clicks, name):
        """Positions, NaN for none, of a picker of the mesh."""
        verdict, near, far = self.limits(clicks)
        is_hit = np.isfinite(found[:, 0])
        self.assertGreater((verdict == 1).sum(), 0.2 * len(clicks), name)
        self.assertGreater((verdict == 0).sum(), 0.2 * len(clicks), name)
        self.assertLess((verdict == -1).mean(), LARGEST_SHARE_OF_SILHOUETTES, name)
        np.testing.assert_array_equal(is_hit[verdict >= 0], verdict[verdict >= 0] == 1, name)
        distance = np.linalg.norm(found - self.eye, axis=1)
        sure = verdict == 1
        self.assertTrue((distance[sure] >= near[sure] - 1e-3).all(), name)
        self.assertTrue((distance[sure] <= far[sure] + 1e-3).all(), name)


class TestVTK(PicksTest):
    def test_cell_picker(self):
        picker = vtkCellPicker()
        picker.SetTolerance(0.0)
        found = np.full((len(CLICKS), 3), np.nan)
        for k, (x, y) in enumerate(CLICKS):
            if picker.Pick(x, y, 0.0, self.renderer):
                self.assertIs(picker.GetActor(), self.terrain)
                found[k] = picker.GetPickPosition()
        self.check(found, CLICKS, "vtkCellPicker")

    def test_point_picker_gives_points_of_the_mesh(self):
        picker = vtkPointPicker()
        picker.SetTolerance(0.005)
        points = vtk_to_numpy(self.terrain.GetSurface().GetPoints().GetData())
        hits = 0
        for x, y in CLICKS:
            if picker.Pick(x, y, 0.0, self.renderer):
                hits += 1
                position = np.array(picker.GetPickPosition())
                np.testing.assert_allclose(position, points[picker.GetPointId()], atol=1e-4)
                self.renderer.SetWorldPoint(*position, 1.0)
                self.renderer.WorldToDisplay()
                shown = np.array(self.renderer.GetDisplayPoint()[:2])
                self.assertLess(np.linalg.norm(shown - (x, y)), 0.01 * np.hypot(*SIZE) + 1.0)
        self.assertGreater(hits, 100)

    def test_prop_picker_sees_what_is_drawn(self):
        picker = vtkPropPicker()
        clicks = CLICKS[:300]
        corners = [exact_picks(self.renderer, clicks + shift) for shift in ((0, 0), (1, 0), (0, 1), (1, 1))]
        hits = np.isfinite(np.array(corners)[..., 0]).sum(axis=0)
        self.assertLess(((hits > 0) & (hits < 4)).mean(), 2.0 * LARGEST_SHARE_OF_SILHOUETTES)
        for k, (x, y) in enumerate(clicks):
            is_hit = bool(picker.Pick(x, y, 0.0, self.renderer))
            if hits[k] in (0, 4):
                self.assertEqual(is_hit, hits[k] == 4)
            if is_hit:
                self.assertIs(picker.GetActor(), self.terrain)

    def test_areas_and_the_selector(self):
        for picker in (vtkAreaPicker(), vtkRenderedAreaPicker()):
            self.assertTrue(picker.AreaPick(120, 60, 180, 120, self.renderer))
            self.assertIs(picker.GetProp3D(), self.terrain)
            self.assertFalse(picker.AreaPick(1, 190, 9, 198, self.renderer))
        selector = vtkHardwareSelector()
        selector.SetRenderer(self.renderer)
        selector.SetArea(120, 60, 180, 120)
        selector.SetFieldAssociation(1)
        node = selector.Select().GetNode(0)
        self.assertIs(node.GetProperties().Get(vtkSelectionNode.PROP()), self.terrain)
        ids = set(vtk_to_numpy(node.GetSelectionList()).tolist())
        x, y = np.meshgrid(np.arange(120, 181) + 0.5, np.arange(60, 121) + 0.5)
        at = exact_picks(self.renderer, np.column_stack([x.ravel(), y.ravel()]))
        at = at[np.isfinite(at[:, 0]), :2].astype(int)
        self.assertEqual(ids, set((at[:, 0] + (COLUMNS - 1) * at[:, 1]).tolist()))

    def test_parts_of_an_assembly(self):
        assembly = vtkAssembly()
        assembly.SetPosition(3.0, -2.0, 1.0)
        assembly.SetScale(1.0, 1.0, 0.8)
        terrain, renderer, window = make_scene(hill(), assembly)
        self.assertEqual(terrain.GetSurfaceActor().GetMapper().GetInputAlgorithm().GetOutput().GetNumberOfPoints(), 0)
        exact = exact_picks(renderer, CLICKS)
        self.assertEqual(terrain.GetSurfaceActor().GetMapper().GetInputAlgorithm().GetOutput().GetNumberOfPoints(), 0)
        self.assertGreater(np.isfinite(exact[:, 0]).sum(), 200)
        picker = vtkCellPicker()
        picker.SetTolerance(0.0)
        differ, distances = 0, []
        for click, position in zip(CLICKS, exact):
            is_hit = bool(picker.Pick(*click, 0.0, renderer))
            differ += is_hit != np.isfinite(position[0])
            if is_hit and np.isfinite(position[0]):
                self.assertIs(picker.GetProp3D(), assembly)
                distances.append(np.linalg.norm(position - picker.GetPickPosition()))
        self.assertLess(differ, LARGEST_SHARE_OF_SILHOUETTES * len(CLICKS))
        self.assertLess(np.quantile(distances, 0.95), 0.3)
        np.testing.assert_allclose(assembly.GetBounds()[4:], 1.0 + 0.8 * np.array(terrain.GetBounds()[4:]), rtol=1e-6)
        terrain.VisibilityOff()
        self.assertFalse(picker.Pick(150.0, 90.0, 0.0, renderer))
        window.Finalize()


class TestCuts(unittest.TestCase):
    """A mesh has what rays draw of a terrain that is cut."""

    def check(self, cut, bounds, walls=False):
        terrain, renderer, window = make_scene(hill())
        cut(terrain.GetTerrainMapper())
        renderer.ResetCameraClippingRange()
        window.Render()
        np.testing.assert_allclose(terrain.GetSurface().GetBounds(), bounds, atol=0.05)
        drawn = terrain.GetBounds()  # the heights of all samples are between the last two
        np.testing.assert_allclose(drawn[:4], bounds[:4], atol=0.05)
        self.assertTrue(drawn[4] < bounds[4] + 0.05 and drawn[5] > bounds[5] - 0.05)
        exact, found = exact_picks(renderer, CLICKS), np.full((len(CLICKS), 3), np.nan)
        picker = vtkCellPicker()
        picker.SetTolerance(0.0)
        for k, (x, y) in enumerate(CLICKS):
            if picker.Pick(x, y, 0.0, renderer):
                found[k] = picker.GetPickPosition()
        hits = np.isfinite(exact[:, 0])
        self.assertGreater(hits.sum(), 80)
        self.assertGreater((~hits).sum(), 80)
        self.assertLess((np.isfinite(found[:, 0]) != hits).sum(), LARGEST_SHARE_OF_SILHOUETTES * len(CLICKS))
        distances = np.linalg.norm(found - exact, axis=1)
        self.assertLess(np.nanquantile(distances, 0.95), 0.3)
        self.assertEqual(bool((exact[hits, 2] < EXAGGERATION * hill().min() - 0.1).any()), walls)
        return terrain

    def test_an_extract(self):
        part = EXAGGERATION * hill()[8:31, 12:41].astype(float)
        bounds = (12.0, 40.0, 8.0, 30.0, part.min(), part.max())
        terrain, _, _ = make_scene(hill())
        whole = terrain.GetSurface().GetNumberOfPoints()
        terrain = self.check(lambda mapper: mapper.SetExtract((12, 8), (40, 30)), bounds)
        points = vtk_to_numpy(terrain.GetSurface().GetPoints().GetData())
        places = vtk_to_numpy(terrain.GetSurface().GetPointData().GetTCoords())
        np.testing.assert_allclose(places, (points[:, :2] + 0.5) / (COLUMNS, ROWS), rtol=1e-5)  # of the whole
        terrain.GetTerrainMapper().ExtractAll()
        self.assertEqual(terrain.GetSurface().GetNumberOfPoints(), whole)

    def test_a_block(self):
        def cut(mapper):
            mapper.SetBlockBase(-3.0)
            mapper.SetBlock(True)

        whole = EXAGGERATION * hill().astype(float)
        self.check(cut, (0.0, COLUMNS - 1.0, 0.0, ROWS - 1.0, -3.0 * EXAGGERATION, whole.max()), walls=True)

    def test_a_block_of_an_extract(self):
        def cut(mapper):
            mapper.SetExtract((12, 8), (40, 30))
            mapper.SetBlockBase(-3.0)
            mapper.SetBlock(True)

        part = EXAGGERATION * hill()[8:31, 12:41].astype(float)
        self.check(cut, (12.0, 40.0, 8.0, 30.0, -3.0 * EXAGGERATION, part.max()), walls=True)

    def test_clipping_planes_cut_what_is_picked(self):
        terrain, renderer, window = make_scene(hill())
        plane = vtkPlane()
        plane.SetOrigin(25.0, 0.0, 0.0)
        plane.SetNormal(1.0, 0.0, 0.0)
        terrain.GetTerrainMapper().AddClippingPlane(plane)
        window.Render()
        exact, picker = exact_picks(renderer, CLICKS), vtkCellPicker()
        picker.SetTolerance(0.0)
        found = np.array([bool(picker.Pick(x, y, 0.0, renderer)) for x, y in CLICKS])
        self.assertLess((found != np.isfinite(exact[:, 0])).mean(), LARGEST_SHARE_OF_SILHOUETTES)


@unittest.skipIf(pyvista is None, "PyVista is not installed")
class TestPyVista(PicksTest):
    def setUp(self):
        super().setUp()
        warnings.simplefilter("ignore")
        self.plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
        self.addCleanup(self.plotter.close)
        self.plotter.disable_anti_aliasing()
        self.drawn = plotting.add_terrain(self.plotter, hill(), exaggeration=EXAGGERATION, show_scalar_bar=False)
        self.plotter.view_xy()
        camera_of(self.plotter.renderer)
        self.plotter.screenshot(return_img=True)

    def click(self, enable, clicks, to_point):
        found, got = np.full((len(clicks), 3), np.nan), []
        enable(callback=lambda what, *_: got.append(what), left_clicking=True, show_message=False)
        for k, (x, y) in enumerate(clicks):
            got.clear()
            self.plotter.iren._mouse_left_button_press(int(x), int(y))
            self.plotter.iren._mouse_left_button_release(int(x), int(y))
            if got and got[-1] is not None:
                found[k] = to_point(got[-1])
        return found

    def test_surface_points(self):
        def enable(**options):
            self.plotter.enable_surface_point_picking(show_point=False, tolerance=0.0, picker="cell", **options)

        self.check(self.click(enable, CLICKS, np.array), CLICKS, "surface")

    def test_points_of_cells(self):
        def enable(**options):
            self.plotter.enable_point_picking(show_point=False, tolerance=0.0, picker="cell", **options)

        self.check(self.click(enable, CLICKS[:300], np.array), CLICKS[:300], "point, cell")

    def test_elements(self):
        for mode in ("cell", "face", "edge", "point", "mesh"):
            self.plotter.disable_picking()

            def enable(mode=mode, **options):
                self.plotter.enable_element_picking(mode=mode, show=False, tolerance=0.0, picker="cell", **options)

            clicks = CLICKS[:200]
            found = self.click(enable, clicks, lambda element: element.center)
            verdict, _, _ = self.limits(clicks)
            self.assertEqual(np.isfinite(found[verdict == 0, 0]).sum(), 0, mode)
            self.assertGreaterEqual(np.isfinite(found[verdict == 1, 0]).mean(), 0.99, mode)
            if mode != "mesh":
                exact = exact_picks(self.renderer, clicks)
                both = (verdict == 1) & np.isfinite(found[:, 0])
                self.assertLess(np.median(np.linalg.norm(found[both] - exact[both], axis=1)), 2.0, mode)

    def test_rectangles(self):
        cells = []
        self.plotter.enable_rectangle_through_picking(callback=cells.append, show=False, show_message=False, start=True)
        self.drag()
        self.assertGreater(cells[0].n_cells, 50)
        corners = exact_picks(self.renderer, [(120.0, 60.0), (180.0, 60.0), (150.0, 90.0)])
        for corner in corners:
            self.assertTrue((np.array(cells[0].bounds[::2]) <= corner + 2.0).all())
            self.assertTrue((np.array(cells[0].bounds[1::2]) >= corner - 2.0).all())

    def test_what_is_seen_in_a_rectangle_is_refused(self):
        cells = []
        del self.drawn  # the plotter holds it
        self.plotter.enable_rectangle_visible_picking(callback=cells.append, show=False, show_message=False, start=True)
        with self.assertWarnsRegex(UserWarning, "use enable_rectangle_through_picking"):
            self.drag()
        self.assertEqual(cells, [])

    def drag(self):
        warnings.simplefilter("always")
        warnings.simplefilter("ignore", DeprecationWarning)  # of others
        self.plotter.iren._mouse_left_button_press(120, 60)
        self.plotter.iren._mouse_move(180, 120)
        self.plotter.iren._mouse_left_button_release(180, 120)


if __name__ == "__main__":
    vtkTerrainTesting.run()
