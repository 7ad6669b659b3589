# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""From an array of heights to the first complete picture, in Python and in C++, by turns.

  FirstPicture.py PROGRAM [SIDE [TIMES]]     default 4096, 7

PROGRAM is BenchmarkFirstPicture. Prints the medians in milliseconds, with the smallest and the
largest, and their ratio.
"""
import statistics
import subprocess
import sys
import time


def draw(side):
    """Draws once and prints the milliseconds."""
    import numpy as np
    from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

    import vtkterrain

    waves = (10.0 * np.sin(0.01 * np.arange(side))).astype(np.float32)
    field = waves[:, None] + waves
    begin = time.perf_counter()
    terrain = vtkterrain.vtkTerrainActor()
    terrain.SetInputData(vtkterrain.heights_from_array(field))
    renderer = vtkRenderer()
    renderer.AddActor(terrain)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(640, 480)
    window.AddRenderer(renderer)
    window.Render()
    window.WaitForCompletion()
    print(1e3 * (time.perf_counter() - begin))


def compare(program, side, times):
    """Runs both by turns, each in a process of its own."""
    commands = {"C++": [program, side], "Python": [sys.executable, __file__, "--draw", side]}
    took = {name: [] for name in commands}
    for _ in range(times):
        for name, command in commands.items():
            took[name].append(float(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout))
    for name, all_times in took.items():
        print(f"{name}: {statistics.median(all_times):.0f} ms ({min(all_times):.0f} to "
              f"{max(all_times):.0f})")
    ratios = [python / cxx for cxx, python in zip(took["C++"], took["Python"])]
    print(f"Python over C++: {statistics.median(ratios):.3f}")


if __name__ == "__main__":
    if sys.argv[1] == "--draw":
        draw(int(sys.argv[2]))
    else:
        compare(sys.argv[1], *(sys.argv[2:3] or ["4096"]), int((sys.argv[3:4] or ["7"])[0]))
