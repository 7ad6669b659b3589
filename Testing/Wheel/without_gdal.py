# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""What must work, and what must be said, where no GDAL is installed."""
import numpy as np

import vtkterrain

reader = vtkterrain.vtkTerrainRasterReader()
reader.GlobalWarningDisplayOff()
reader.SetFileName("dem.tif")
reader.Update()
message = reader.GetErrorMessage()
if vtkterrain.vtkTerrainRasterReader.GetGDALFile():
    print("A GDAL of the system is there: nothing to see")
elif "pip install rasterio" not in message:
    raise SystemExit(f"the reader does not name the remedy: {message}")
heights = vtkterrain.heights_from_array(np.outer(np.arange(33.0), np.arange(33.0)))
mesh = vtkterrain.vtkTerrainCoarseMesh()
mesh.SetInputData(heights)
mesh.Update()
assert mesh.GetOutput().GetNumberOfPoints() > 4
print(f"Without GDAL: {message}")
