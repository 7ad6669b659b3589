#!/bin/sh
# Guess:   the matrix that vtkImageData::GetDirectionMatrix() hands out is the image's own: whoever changes
#          it, as one does with an actor's or a transform's matrix, turns the image.
# Happens: points stay where the matrix was when it was set: the image keeps products of direction,
#          spacing and origin that only SetDirectionMatrix() makes anew. No message. Bounds stay with the
#          points in 9.6, while in 9.1 they follow the matrix, so that bounds and points disagree.
# Where:   a raster whose rows are turned (or turned back) by its direction matrix is drawn, picked and
#          probed upside down, and code that is right by 9.1's bounds turns wrong on a newer VTK.
# Seen:    vtk 9.6.2 from PyPI, 2026-11-30; bounds of Debian 12's 9.1.0 as said.
set -eu
python=${PYTHON:-python3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$python" -m venv "$folder/venv"
"$folder/venv/bin/pip" -q install 'vtk==9.6.2'
"$folder/venv/bin/python" - <<'PYTHON'
import sys
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData

turned = (1, 0, 0, 0, -1, 0, 0, 0, 1)


def rows():
    image = vtkImageData()
    image.SetDimensions(3, 4, 1)
    return image


def told(image):
    return image.GetPoint(11)[1], image.GetBounds()[2:4]


by_setter, in_place, back = rows(), rows(), rows()
by_setter.SetDirectionMatrix(*turned)
in_place.GetDirectionMatrix().SetElement(1, 1, -1.0)
back.SetDirectionMatrix(*turned)
back.GetDirectionMatrix().Identity()
print("VTK", vtkVersion.GetVTKVersion())
print("last row and bounds in y")
print("  set by SetDirectionMatrix:       ", *told(by_setter))
print("  turned in place:                 ", *told(in_place))
print("  set, then made identity in place:", *told(back))
same = (told(by_setter) == (-3.0, (-3.0, 0.0)) and told(in_place) == (3.0, (0.0, 3.0))
        and told(back) == (-3.0, (-3.0, 0.0)))
print("as described" if same else "CHANGED: the header of this file is out of date")
sys.exit(0 if same else 1)
PYTHON
