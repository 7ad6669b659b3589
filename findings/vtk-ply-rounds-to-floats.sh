#!/bin/sh
# Guess:   a mesh with 64-bit points, written by vtkPLYWriter under a name, is in a file of that name with
#          its coordinates: PLY knows the type double, and vtkOBJWriter keeps every digit.
# Happens: positions become the type float, 0.5 m apart at a UTM northing, without a word and without a
#          setting; and where the name does not end in .ply the file is called NAME.ply, so that whoever
#          writes to a temporary name first and renames it finds nothing there.
# Where:   a terrain in projected coordinates that is saved for another program shows steps and merged
#          vertices, as if it were coarse.
# Seen:    vtk 9.6.2 from PyPI, 2026-11-29; Debian 12's 9.1.0 does the same.
set -eu
python=${PYTHON:-python3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$python" -m venv "$folder/venv"
"$folder/venv/bin/pip" -q install 'vtk==9.6.2'
"$folder/venv/bin/python" - "$folder" <<'PYTHON'
import os
import sys
import vtk

folder = sys.argv[1]
northing = 5101235.125
points = vtk.vtkPoints()
points.SetDataTypeToDouble()
for dx, dy in ((0, 0), (1, 0), (0, 0.125)):
    points.InsertNextPoint(412345.25 + dx, northing + dy, 812.375)
triangles = vtk.vtkCellArray()
triangles.InsertNextCell(3, (0, 1, 2))
mesh = vtk.vtkPolyData()
mesh.SetPoints(points)
mesh.SetPolys(triangles)
writer = vtk.vtkPLYWriter()
writer.SetInputData(mesh)
writer.SetFileName(folder + "/mesh.partial")
writer.SetFileTypeToASCII()
writer.Write()
files = sorted(name for name in os.listdir(folder) if name.startswith("mesh"))
print("VTK", vtk.vtkVersion.GetVTKVersion())
print("asked for mesh.partial, got", files)
reader = vtk.vtkPLYReader()
reader.SetFileName(folder + "/" + files[0])
reader.Update()
with open(folder + "/" + files[0], errors="replace") as lines:
    types = [line.split()[1] for line in lines if line.startswith("property") and line.split()[-1] in "xyz"]
read = [reader.GetOutput().GetPoint(k)[1] for k in range(3)]
print("types of x, y, z:", types)
print("northings", northing, "and", northing + 0.125, "come back as", sorted(set(read)))
same = files == ["mesh.partial.ply"] and types == ["float"] * 3 and len(set(read)) == 1
print("as described" if same else "CHANGED: the header of this file is out of date")
sys.exit(0 if same else 1)
PYTHON
