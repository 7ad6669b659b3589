# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""The light of the sky beside vtkSSAOPass: cost of a frame, and error of what is drawn.

  SkyPeers.py [SIDE [TIMES]]                  default 1024 samples, 9 frames

White terrain that nothing else lights, 640 x 480 pixels. The truth is the sky view factor by horizons in 64
directions, at the sample nearest to what a pixel shows. The pass is tried with several radii, and its grey is
fitted to the truth by a straight line first, for it has no unit: its error is the least it can be. Times are
processor time of all threads, by turns.
"""
import statistics
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAOPass

import vtkterrain
from vtkterrain import analysis

_SIZE = (640, 480)
_RADII = (100.0, 300.0, 1000.0, 3000.0)


def make_scene(side):
    """Heights of the procedural landscape, the window, the actor and its renderer."""
    source = vtkterrain.vtkTerrainSource()
    source.SetDimensions(side, side)
    source.Update()
    actor = vtkterrain.vtkTerrainActor()
    actor.SetInputData(source.GetOutput())
    actor.GetProperty().SetColor(1.0, 1.0, 1.0)
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    dark = vtkLight()  # without any, VTK draws unlit
    dark.SetIntensity(0.0)
    renderer.AddLight(dark)
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(20000.0, -18000.0, 16000.0)
    camera.SetFocalPoint(20000.0, 18000.0, 0.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*_SIZE)
    window.AddRenderer(renderer)
    window.Render()
    actor.SetColorByHeight(False)
    renderer.ResetCameraClippingRange()
    return source.GetOutput(), window, renderer, actor


def grey(window):
    """The picture, 0 to 1, rows from below."""
    pixels = vtkUnsignedCharArray()
    window.Render()
    window.GetPixelData(0, 0, _SIZE[0] - 1, _SIZE[1] - 1, 0, pixels, 0)
    return vtk_to_numpy(pixels).reshape(_SIZE[1], _SIZE[0], -1)[..., 0] / 255.0


def places(window, renderer):
    """World x and y of the pixels, and which show terrain."""
    depths = vtkFloatArray()
    window.GetZbufferData(0, 0, _SIZE[0] - 1, _SIZE[1] - 1, depths)
    depth = vtk_to_numpy(depths).reshape(_SIZE[1], _SIZE[0]).astype(float)
    camera = renderer.GetActiveCamera()
    matrix = camera.GetCompositeProjectionTransformMatrix(_SIZE[0] / _SIZE[1], -1.0, 1.0)
    inverse = np.linalg.inv([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    row, column = np.mgrid[0 : _SIZE[1], 0 : _SIZE[0]]
    clip = np.stack([2 * (column + 0.5) / _SIZE[0] - 1, 2 * (row + 0.5) / _SIZE[1] - 1, 2 * depth - 1,
                     np.ones_like(depth)], axis=-1)
    world = clip @ inverse.T
    return world[..., 0] / world[..., 3], world[..., 1] / world[..., 3], depth < 1.0


def set_pass(renderer, radius):
    """Draws with vtkSSAOPass; plainly for None."""
    if radius is None:
        renderer.SetPass(None)
        return
    ssao = vtkSSAOPass()
    ssao.SetDelegatePass(vtkRenderStepsPass())
    ssao.SetRadius(radius)
    ssao.SetBias(0.01 * radius)
    ssao.SetKernelSize(128)
    ssao.BlurOn()
    renderer.SetPass(ssao)


def errors(heights, window, renderer, actor):
    """Prints mean errors against the truth, and the correlation with it."""
    truth = analysis.sky_view(heights, 64)
    actor.SetSkyLight(1.0)
    ours = grey(window)
    x, y, shown = places(window, renderer)
    step = heights.GetSpacing()[0]
    truth = truth[np.clip(np.rint(y / step), 0, truth.shape[0] - 1).astype(int),
                  np.clip(np.rint(x / step), 0, truth.shape[1] - 1).astype(int)][shown]
    ours = ours[shown]
    print(f"truth: {truth.mean():.3f} in the mean, spread {truth.std():.3f}")
    print(f"sky light: mean error {np.abs(ours - truth).mean():.4f}, correlation {np.corrcoef(ours, truth)[0, 1]:.4f}")
    actor.SetSkyLight(0.0)
    actor.GetProperty().LightingOff()
    for radius in _RADII:
        set_pass(renderer, radius)
        theirs = grey(window)[shown]
        fitted = np.polyval(np.polyfit(theirs, truth, 1), theirs)
        print(f"vtkSSAOPass, {radius:g} m: mean error {np.abs(fitted - truth).mean():.4f} fitted, "
              f"correlation {np.corrcoef(theirs, truth)[0, 1]:.3f}")
    set_pass(renderer, None)


def times(window, renderer, actor, count):
    """Prints milliseconds of a frame: plain, with the light of the sky, with the pass."""
    actor.GetProperty().LightingOn()
    took = {"plain": [], "sky light": [], "vtkSSAOPass": []}
    for turn in range(count + 2):
        for name, taken in took.items():
            actor.SetSkyLight(1.0 if name == "sky light" else 0.0)
            set_pass(renderer, 300.0 if name == "vtkSSAOPass" else None)
            window.Render()  # programs
            begin = time.process_time()
            window.Render()
            window.WaitForCompletion()
            if turn > 1:
                taken.append(1e3 * (time.process_time() - begin))
    plain = statistics.median(took["plain"])
    for name, taken in took.items():
        print(f"{name}: {statistics.median(taken):.1f} ms ({min(taken):.1f} to {max(taken):.1f}), "
              f"{statistics.median(taken) / plain:.2f} times plain")


def main():
    """Compares."""
    heights, window, renderer, actor = make_scene(int((sys.argv[1:2] or ["1024"])[0]))
    errors(heights, window, renderer, actor)
    times(window, renderer, actor, int((sys.argv[2:3] or ["9"])[0]))


if __name__ == "__main__":
    main()
