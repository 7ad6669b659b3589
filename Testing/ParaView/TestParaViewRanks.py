# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Any number of ranks draws the picture that one rank draws. TestParaViewRanks.py PVBATCH MPIEXEC"""
import os
import pathlib
import subprocess
import sys
import unittest

import numpy as np

sys.path.append(str(pathlib.Path(__file__).parents[1] / "Python"))
import vtkTerrainTesting  # noqa: E402

PVBATCH, MPIEXEC = sys.argv[1:3]
# Share of pixels that may differ by more than 1/255. The steps of Equidistant and Exponential depend
# on the coarse mesh, and that on the size of a piece.
LARGEST_SHARES = {"Pyramid": 1e-4, "Linear": 1e-4, "Mesh": 1e-4, "Translucent": 1e-3,
                  "Equidistant": 2e-3, "Exponential": 2e-3}


def draw(ranks):
    prefix = vtkTerrainTesting.output_path(f"ranks{ranks}")
    launcher = [MPIEXEC, "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)]
    subprocess.run([*(launcher if ranks > 1 else []), PVBATCH, "--force-offscreen-rendering",
                    str(pathlib.Path(__file__).with_name("drawRanks.py")), prefix],
                   check=True, env={**os.environ, "OMP_NUM_THREADS": "1", "LP_NUM_THREADS": "1"})
    return {case: vtkTerrainTesting.read_picture(f"{prefix}-{case}.png").astype(int)
            for case in LARGEST_SHARES}


class TestRanks(unittest.TestCase):
    def test_ranks_draw_the_same_picture(self):
        alone = draw(1)
        self.assertGreater((alone["Pyramid"] != alone["Pyramid"][0, 0]).any(axis=2).mean(), 0.1)
        self.assertTrue((alone["Pyramid"] != alone["Translucent"]).any())
        for ranks in (2, 3, 4):
            together = draw(ranks)
            for case, largest_share in LARGEST_SHARES.items():
                with self.subTest(ranks=ranks, case=case):
                    off = (np.abs(together[case] - alone[case]) > 1).any(axis=2)
                    self.assertLessEqual(off.mean(), largest_share)


if __name__ == "__main__":
    sys.argv[1:] = []
    vtkTerrainTesting.run()
