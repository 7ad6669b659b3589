# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in one process, run by pvbatch."""
import pathlib
import sys
import unittest

import numpy as np

sys.path.append(str(pathlib.Path(__file__).parents[1] / "Python"))
import terrainScene  # noqa: E402
import vtkTerrainTesting  # noqa: E402
from paraview import simple  # noqa: E402

terrainScene.load_plugin()
# ParaView 5.13 renamed it
TRANSLATION = "Position" if simple.GetParaViewVersion() < (5, 13) else "Translation"


def picture(view, name):
    path = vtkTerrainTesting.output_path(f"{name}.png")
    terrainScene.save(view, path)
    return vtkTerrainTesting.read_picture(path).astype(int)


def share_of_difference(one, other, visible=8):
    return (np.abs(one - other) > visible).any(axis=2).mean()


def write_hill(name, height=12.0, west=0):
    j, i = np.mgrid[0:48, 0:64]
    path = vtkTerrainTesting.output_path(name)
    hill = height * np.exp(-((i - 40) ** 2 + (j - 30) ** 2) / 120.0)
    vtkTerrainTesting.write_ascii_grid(path, hill, west)
    return path


def delete_all():
    """Removes all sources, displays and views."""
    for source in list(simple.GetSources().values())[::-1]:
        simple.Delete(source)
    for view in simple.GetRenderViews():
        simple.Delete(view)


class TestPlugin(unittest.TestCase):
    def setUp(self):
        self.view = terrainScene.new_view()
        self.source = simple.TerrainLandscape(Dimensions=[101, 76])
        terrainScene.look_from_the_south(self.view)

    def tearDown(self):
        delete_all()

    def test_terrain_is_a_representation_of_images(self):
        display = simple.Show(self.source, self.view)
        self.assertIn("Terrain", display.GetProperty("Representation").GetAvailable())

    def test_techniques_draw_the_same_surface(self):
        display = terrainScene.show_terrain(self.source, self.view)
        exact = picture(self.view, "technique-Pyramid")
        self.assertGreater((exact != exact[0, 0]).any(axis=2).mean(), 0.2)
        for technique in ("Mesh", "Linear", "Exponential", "Equidistant", "Strips"):
            display.TerrainTechnique = technique
            other = picture(self.view, f"technique-{technique}")
            self.assertLess(share_of_difference(exact, other), 0.03, technique)

    def test_properties_change_the_picture(self):
        display = terrainScene.show_terrain(self.source, self.view)
        plain = picture(self.view, "plain")
        for name, default, value, least in (
                ("TerrainVerticalExaggeration", 1.0, 2.0, 0.1), ("Opacity", 1.0, 0.4, 0.2),
                ("TerrainContours", 0, 1, 0.005), ("TerrainHillshade", 0, 1, 0.1),
                ("TerrainBlock", 0, 1, 0.0005), ("TerrainSkyLight", 0.0, 0.5, 0.1),
                ("TerrainColorSource", "Array", "Slope", 0.1),
                (TRANSLATION, [0.0, 0.0, 0.0], [5000.0, 0.0, 0.0], 0.1)):
            setattr(display, name, value)
            changed = picture(self.view, f"property-{name}")
            self.assertGreater(share_of_difference(plain, changed), least, name)
            setattr(display, name, default)
            self.assertEqual(share_of_difference(plain, picture(self.view, "again")), 0.0, name)

    def test_without_an_array_the_surface_has_one_colour(self):
        display = terrainScene.show_terrain(self.source, self.view)
        simple.ColorBy(display, None)
        display.DiffuseColor = [1.0, 0.0, 0.0]
        drawn = picture(self.view, "red")
        surface = (drawn != drawn[0, 0]).any(axis=2)
        self.assertEqual(drawn[surface][:, 1:].max(initial=0), 0)

    def test_any_array_colours_the_surface(self):
        calculator = simple.Calculator(self.source, ResultArrayName="east", Function="coordsX")
        display = terrainScene.show_terrain(calculator, self.view)
        display.TerrainHeights = ["POINTS", "Elevation"]
        simple.ColorBy(display, ("POINTS", "east"))
        colors = simple.GetColorTransferFunction("east")
        colors.RGBPoints = [0.0, 1.0, 0.0, 0.0, 40960.0, 0.0, 0.0, 1.0]
        colors.ColorSpace = "RGB"
        drawn = picture(self.view, "east")
        west, east = drawn[75:95, 60:80], drawn[75:95, 160:180]
        self.assertGreater((west[..., 0] - west[..., 2]).mean(), 30)
        self.assertGreater((east[..., 2] - east[..., 0]).mean(), 30)

    def test_heights_stay_when_filters_add_arrays(self):
        calculator = simple.Calculator(self.source, ResultArrayName="temperature", Function="15-0.0065*Elevation")
        calculator.UpdatePipeline()
        display = simple.Show(calculator, self.view)
        display.SetRepresentationType("Terrain")
        self.assertEqual(list(display.TerrainHeights), ["POINTS", "Elevation"])
        source = simple.Show(self.source, self.view)
        source.SetRepresentationType("Terrain")
        terrainScene.look_from_the_south(self.view)
        for shown in (display, source):
            simple.ColorBy(shown, None)
        simple.Hide(self.source, self.view)
        lifted = picture(self.view, "calculator")
        simple.Hide(calculator, self.view)
        simple.Show(self.source, self.view)
        self.assertEqual(share_of_difference(lifted, picture(self.view, "calculator-source")), 0.0)

    def test_selected_cells_lie_on_the_surface(self):
        display = terrainScene.show_terrain(self.source, self.view, TerrainVerticalExaggeration=4.0)
        before = picture(self.view, "selection-none")
        area = [100, 60, 140, 90]
        simple.SelectSurfaceCells(Rectangle=area, View=self.view)
        selected = picture(self.view, "selection-cells")
        simple.ClearSelection(self.source)
        changed = (np.abs(before - selected) > 8).any(axis=2)
        self.assertGreater(changed.sum(), 200)
        inside = changed[area[1] - 8:area[3] + 8, area[0] - 8:area[2] + 8]
        self.assertEqual(changed.sum(), inside.sum())  # the plane of the data lies elsewhere in the picture
        self.assertEqual(share_of_difference(before, picture(self.view, "selection-cleared")), 0.0)
        display.SetRepresentationType("Slice")
        flat = picture(self.view, "selection-flat-none")
        simple.SelectSurfaceCells(Rectangle=area, View=self.view)
        changed = (np.abs(flat - picture(self.view, "selection-flat")) > 8).any(axis=2)
        inside = changed[area[1] - 8:area[3] + 8, area[0] - 8:area[2] + 8]
        self.assertEqual(changed.sum(), inside.sum())
        simple.ClearSelection(self.source)

    def test_slopes_have_colours_of_their_own(self):
        display = terrainScene.show_terrain(self.source, self.view, TerrainColorSource="Slope")
        first = picture(self.view, "slope")
        colors = simple.GetColorTransferFunction("Elevation")
        colors.RGBPoints = [0.0, 1.0, 0.0, 0.0, 2500.0, 1.0, 0.0, 0.0]
        self.assertEqual(share_of_difference(first, picture(self.view, "slope-other-table")), 0.0)
        background = first[-1, -1]
        display.TerrainColorSource = "Array"
        bar = (first != picture(self.view, "slope-none")) & (picture(self.view, "slope-none") == background)
        self.assertGreater(bar.any(axis=2).sum(), 50)  # beside the terrain

    def test_parts(self):
        display = terrainScene.show_terrain(self.source, self.view)
        whole = picture(self.view, "part-whole")
        background = whole[0, 0]
        display.TerrainClipOrigin, display.TerrainClipNormal = [20480.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        display.TerrainClip = 1
        east = (picture(self.view, "part-east") != background).any(axis=2)
        display.TerrainClip = 0
        display.TerrainExtract = [50, 100, 0, -1]
        columns = (picture(self.view, "part-columns") != background).any(axis=2)
        self.assertLess((east != columns).mean(), 0.01)
        self.assertFalse(east[:, :115].any())
        self.assertGreater(east[:, 125:].mean(), 0.2)
        display.TerrainExtract = [500, 600, 0, -1]
        self.assertTrue((picture(self.view, "part-none") == background).all())
        display.TerrainExtract = [0, -1, 0, -1]
        self.assertEqual(share_of_difference(whole, picture(self.view, "part-all")), 0.0)

    def test_refused_numbers_go_back(self):
        display = terrainScene.show_terrain(self.source, self.view, TerrainVerticalExaggeration=2.0)
        before = picture(self.view, "refused-before")
        for refused in (0.0, -1.0, float("nan")):
            display.TerrainVerticalExaggeration = refused
            self.assertEqual(display.TerrainVerticalExaggeration, 2.0)
        self.assertEqual(share_of_difference(before, picture(self.view, "refused-after")), 0.0)

    def test_put_on_terrain(self):
        lines = simple.Contour(self.source, ContourBy=["POINTS", "Elevation"], Isosurfaces=[1000.0])
        put = simple.PutOnTerrain(Input=lines, Heights=self.source, Exaggeration=2.0, Offset=5.0)
        put.UpdatePipeline()
        bounds = put.GetDataInformation().GetBounds()
        # contours of linear triangles, on the bilinear surface
        self.assertGreater(bounds[4], 1900.0)
        self.assertLess(bounds[5], 2150.0)
        self.assertGreater(put.GetDataInformation().GetNumberOfPoints(), 100)

    def test_heights_of_cells(self):
        cells = simple.PointDatatoCellData(self.source)
        display = simple.Show(cells, self.view)
        display.SetRepresentationType("Terrain")
        display.TerrainHeights = ["CELLS", "Elevation"]
        simple.ColorBy(display, None)
        drawn = picture(self.view, "cells")
        display = terrainScene.show_terrain(self.source, self.view)
        simple.Hide(cells, self.view)
        simple.ColorBy(display, None)
        self.assertLess(share_of_difference(drawn, picture(self.view, "points"), 40), 0.05)

    def test_tiles_in_one_dataset(self):
        terrainScene.show_terrain(self.source, self.view, TerrainHillshade=1)
        whole = picture(self.view, "whole")
        simple.Hide(self.source, self.view)
        halves = [simple.ExtractSubset(self.source, VOI=[*columns, 0, 75, 0, 0])
                  for columns in ((0, 50), (50, 100))]
        tiles = simple.GroupDatasets(Input=halves)
        display = terrainScene.show_terrain(tiles, self.view, TerrainHillshade=1)
        together = picture(self.view, "tiles")
        self.assertLess(share_of_difference(whole, together), 0.01)  # normals at the border
        simple.Hide(tiles, self.view)
        hidden = picture(self.view, "tiles-hidden")
        self.assertTrue((hidden == hidden[0, 0]).all())
        simple.Show(tiles, self.view)
        display.SetRepresentationType("Outline")
        self.assertGreater(share_of_difference(whole, picture(self.view, "tiles-outline")), 0.1)

    def test_poly_data_are_drawn_as_before(self):
        ball = simple.Sphere(Radius=10000.0, Center=[20000.0, 15000.0, 0.0])
        display = simple.Show(ball, self.view)
        display.ColorArrayName = [None, ""]
        drawn = picture(self.view, "ball")
        self.assertGreater((drawn != drawn[0, 0]).any(axis=2).mean(), 0.05)

    def test_poly_data_are_terrain_too(self):
        mesh = simple.ExtractSurface(simple.WarpByScalar(self.source, Scalars=["POINTS", "Elevation"]))
        terrainScene.show_terrain(mesh, self.view, Representation="Surface")
        surface = picture(self.view, "surface")
        display = simple.GetDisplayProperties(mesh, self.view)
        display.Ambient, display.Diffuse, display.Specular = 0.0, 1.0, 0.0
        surface = picture(self.view, "surface")
        display.SetRepresentationType("Terrain")
        drawn = picture(self.view, "surface-terrain")
        self.assertLess(share_of_difference(surface, drawn), 0.01)
        display.TerrainVerticalExaggeration = 2.0
        self.assertGreater(share_of_difference(drawn, picture(self.view, "surface-high")), 0.1)
        display.TerrainVerticalExaggeration = 1.0
        simple.Hide(mesh, self.view)
        hidden = picture(self.view, "surface-hidden")
        self.assertTrue((hidden == hidden[0, 0]).all())

    def test_strips_follow_the_view(self):
        display = terrainScene.show_terrain(self.source, self.view, TerrainTechnique="Strips")
        for tolerance, least, most in ((0.25, 0.0, 0.02), (16.0, 0.05, 1.0)):
            display.TerrainStripsTolerance = tolerance
            for height in (0.8, 0.2):
                self.view.CameraPosition = [0.5 * 40960.0, -40960.0, height * 40960.0]
                display.TerrainTechnique = "Strips"
                strips = picture(self.view, f"strips-{tolerance}-{height}")
                display.TerrainTechnique = "Mesh"
                mesh = picture(self.view, f"mesh-{tolerance}-{height}")
                share = share_of_difference(strips, mesh)
                self.assertLessEqual(least, share)
                self.assertLess(share, most)

    def test_searches_take_their_steps(self):
        display = terrainScene.show_terrain(self.source, self.view, TerrainTechnique="Equidistant")
        whole = picture(self.view, "steps-all")
        display.TerrainSteps, display.TerrainStepLength = [1, 0, 1], 50.0
        self.assertGreater(share_of_difference(whole, picture(self.view, "steps-one")), 0.01)

    def test_moved_views_are_allotted_little_time(self):
        terrainScene.show_terrain(self.source, self.view)
        actors = self.view.SMProxy.GetClientSideObject().GetRenderer().GetActors()
        allotted = []
        for render in (self.view.SMProxy.StillRender, self.view.SMProxy.InteractiveRender):
            render()
            actors.InitTraversal()
            every = [actors.GetNextActor() for _ in range(actors.GetNumberOfItems())]
            terrain, = [actor for actor in every if actor.GetClassName() == "vtkTerrainActor"]
            allotted.append(terrain.GetAllocatedRenderTime())
        longest = 1.0  # seconds, from which on vtkTerrainActor draws everything
        self.assertGreater(allotted[0], longest)
        self.assertLess(allotted[1], longest)

    def test_hidden_terrain_is_not_drawn(self):
        terrainScene.show_terrain(self.source, self.view)
        simple.Render(self.view)
        simple.Hide(self.source, self.view)
        drawn = picture(self.view, "hidden")
        self.assertTrue((drawn == drawn[0, 0]).all())

    def test_files_open(self):
        path = write_hill("paraview-hill.asc")
        reader = simple.OpenDataFile(path)
        self.assertEqual(reader.GetXMLName(), "DEMRasterReader")
        reader.UpdatePipeline()
        self.assertEqual(reader.GetDataInformation().GetExtent(), (0, 63, 0, 47, 0, 0))
        reader.MaximumSize = 32
        reader.UpdatePipeline()
        self.assertEqual(reader.GetDataInformation().GetExtent()[1], 31)

    def test_files_of_heights_open_with_the_reader(self):
        for name in ("paraview-names.asc", "paraview-names.dem", "paraview-names.tif", "paraview-names.hgt"):
            reader = simple.OpenDataFile(write_hill(name))  # GDAL looks into files, not at names
            self.assertEqual(reader.GetXMLName(), "DEMRasterReader", name)

    def test_places_without_a_height(self):
        j, i = np.mgrid[0:20, 0:30]
        heights = 100 + i + j
        heights[5:9, 10:14] = -9999
        path = vtkTerrainTesting.output_path("paraview-hole.asc")
        rows = "\n".join(" ".join(map(str, row)) for row in heights)  # whole numbers, which are read as such
        pathlib.Path(path).write_text("ncols 30\nnrows 20\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
                                      f"NODATA_value -9999\n{rows}\n", encoding="ascii")
        for is_nan in (0, 1):
            reader = simple.TerrainRasterReader(FileName=path, NoDataAsNaN=is_nan)
            reader.UpdatePipeline()
            self.assertEqual(reader.PointData["Elevation"].GetRange(), (100.0, 148.0))
            image = simple.servermanager.Fetch(reader)
            values = [image.GetPointData().GetArray("Elevation").GetValue(k) for k in range(600)]
            self.assertEqual(np.isnan(values).sum(), 16 * is_nan)

    def test_files_are_time_steps(self):
        paths = [write_hill(f"paraview-series{k}.asc", 12.0 + k) for k in range(3)]
        reader = simple.TerrainRasterReader(FileName=paths)
        reader.UpdatePipeline()
        self.assertEqual(len(reader.TimestepValues), 3)
        for k, time in enumerate(reader.TimestepValues):
            reader.UpdatePipeline(time)
            highest = reader.GetPointDataInformation()["Elevation"].GetRange()[1]
            self.assertAlmostEqual(highest, 12.0 + k, places=2)

    def test_bands_are_time_steps(self):
        path = vtkTerrainTesting.output_path("paraview-bands.vrt")
        band = "<SourceFilename>{}</SourceFilename><SourceBand>1</SourceBand>"
        bands = "".join(
            f'<VRTRasterBand dataType="Float32" band="{k + 1}"><SimpleSource>'
            + band.format(write_hill(f"paraview-band{k}.asc", 20.0 + k))
            + "</SimpleSource></VRTRasterBand>" for k in range(2))
        pathlib.Path(path).write_text(
            f'<VRTDataset rasterXSize="64" rasterYSize="48">{bands}</VRTDataset>', encoding="ascii")
        reader = simple.TerrainRasterReader(FileName=path, BandsAsTimeSteps=1)
        reader.UpdatePipeline(2.0)
        self.assertEqual(list(reader.TimestepValues), [1.0, 2.0])
        self.assertAlmostEqual(
            reader.GetPointDataInformation()["Elevation"].GetRange()[1], 21.0, places=2)

    def test_directory_of_tiles_opens(self):
        folder = vtkTerrainTesting.output_path("paraview-tiles")
        pathlib.Path(folder).mkdir(exist_ok=True)
        write_hill("paraview-tiles/west.asc")
        write_hill("paraview-tiles/east.asc", west=64)
        reader = simple.TerrainRasterReader(FileName=folder)
        reader.UpdatePipeline()
        self.assertEqual(reader.GetDataInformation().GetExtent(), (0, 127, 0, 47, 0, 0))

    def test_what_a_file_does_not_say(self):
        path = write_hill("paraview-options.asc", 30.0)
        as_it_is = simple.TerrainRasterReader(FileName=path)
        as_it_is.UpdatePipeline()
        highest = as_it_is.GetPointDataInformation()["Elevation"].GetRange()[1]
        in_feet = simple.TerrainRasterReader(FileName=path, HeightUnit="ft")
        in_feet.UpdatePipeline()
        self.assertAlmostEqual(in_feet.GetPointDataInformation()["Elevation"].GetRange()[1], 0.3048 * highest, places=3)
        depths = simple.TerrainRasterReader(FileName=path, HeightUnit="-1", Flip=1, CoordinateSystem="EPSG:32631")
        depths.UpdatePipeline()
        self.assertAlmostEqual(depths.GetPointDataInformation()["Elevation"].GetRange()[0], -highest, places=3)
        self.assertEqual(depths.GetDataInformation().GetBounds()[:4], as_it_is.GetDataInformation().GetBounds()[:4])

    def test_strips(self):
        heights = {"CameraPosition": [20480.0, -40960.0, 32768.0],
                   "CameraFocalPoint": [20480.0, 18432.0, 0.0], "CameraViewUp": [0.0, 0.0, 1.0],
                   "ViewportSize": list(terrainScene.SIZE)}
        strips = simple.TerrainStrips(self.source, Tolerance=0.25, **heights)
        strips.UpdatePipeline()
        finest = strips.GetDataInformation().GetNumberOfPoints()
        strips.Tolerance = 2.0
        strips.UpdatePipeline()
        coarsest = strips.GetDataInformation().GetNumberOfPoints()
        self.assertLess(2 * coarsest, finest)
        strips.Tolerance = 0.25
        shown = simple.Show(strips, self.view)
        shown.ColorArrayName = [None, ""]
        drawn = picture(self.view, "strips")
        simple.Hide(strips, self.view)
        display = terrainScene.show_terrain(self.source, self.view)
        simple.ColorBy(display, None)
        surface = [(image != image[0, 0]).any(axis=2)
                   for image in (drawn, picture(self.view, "strips-terrain"))]
        self.assertLess((surface[0] != surface[1]).mean(), 0.005)

    def test_strips_of_the_view(self):
        strips = simple.TerrainStrips(self.source)  # no view shows anything
        strips.UpdatePipeline()
        self.assertGreater(strips.GetDataInformation().GetNumberOfPoints(), 50)
        simple.Delete(strips)
        simple.SetActiveView(self.view)
        terrainScene.show_terrain(self.source, self.view)
        strips = simple.TerrainStrips(self.source)
        self.assertEqual(list(strips.CameraPosition), list(self.view.CameraPosition))
        self.assertEqual(list(strips.ViewportSize), list(self.view.ViewSize))
        strips.UpdatePipeline()
        self.assertGreater(strips.GetDataInformation().GetNumberOfPoints(), 50)

    def test_camera_sees_all_of_the_terrain(self):
        terrainScene.show_terrain(self.source, self.view, TerrainVerticalExaggeration=2.0,
                                  **{TRANSLATION: [1e6, 0.0, 0.0]})
        simple.Render(self.view)
        self.view.ResetCamera()
        camera = self.view.GetActiveCamera()
        self.assertAlmostEqual(camera.GetFocalPoint()[0], 1e6 + 20480.0, delta=1.0)
        self.assertLess(camera.GetDistance(), 4 * 40960.0)

    def test_filters(self):
        mesh = simple.TerrainCoarseMesh(self.source, CellsPerQuad=16)
        mesh.UpdatePipeline()
        self.assertGreater(mesh.GetDataInformation().GetNumberOfCells(), 50)
        reproject = simple.TerrainReproject(self.source, CoordinateSystem="EPSG:32645", Spacing=400.0)
        reproject.UpdatePipeline()
        self.assertGreater(reproject.GetDataInformation().GetNumberOfPoints(), 5000)
        tiles = [simple.TerrainRasterReader(FileName=write_hill(f"paraview-tile{west}.asc", west=west))
                 for west in (0, 64)]
        both = simple.TerrainReproject(Input=tiles, CoordinateSystem="EPSG:32645", Spacing=1.0)
        both.UpdatePipeline()
        self.assertGreater(both.GetDataInformation().GetExtent()[1], 120)

    def test_state_files(self):
        terrainScene.show_terrain(
            self.source, self.view, TerrainVerticalExaggeration=2.0, TerrainTechnique="Equidistant",
            TerrainContours=1)
        before = picture(self.view, "state-before")
        path = vtkTerrainTesting.output_path("state.pvsm")
        simple.SaveState(path)
        delete_all()
        simple.LoadState(path)
        view = simple.GetRenderViews()[0]
        view.UseFXAA = 0  # a setting of the user, not of the state
        self.assertEqual(share_of_difference(before, picture(view, "state-after")), 0.0)
        display = simple.GetDisplayProperties(list(simple.GetSources().values())[0], view)
        self.assertEqual(display.TerrainTechnique, "Equidistant")
        self.assertEqual(display.TerrainVerticalExaggeration, 2.0)

    def test_states_of_before_name_the_reader_otherwise(self):
        simple.TerrainRasterReader(FileName=write_hill("paraview-state.asc"), MaximumSize=32)
        path = pathlib.Path(vtkTerrainTesting.output_path("state-before.pvsm"))
        simple.SaveState(str(path))
        text = path.read_text(encoding="utf-8")
        self.assertIn('type="DEMRasterReader"', text)
        path.write_text(text.replace('type="DEMRasterReader"', 'type="TerrainRasterReader"'), encoding="utf-8")
        delete_all()
        simple.LoadState(str(path))
        reader = next(source for source in simple.GetSources().values()
                      if source.GetXMLName() == "TerrainRasterReader")
        reader.UpdatePipeline()
        self.assertEqual(reader.GetDataInformation().GetExtent()[1], 31)


if __name__ == "__main__":
    sys.argv[1:] = []
    vtkTerrainTesting.run()
