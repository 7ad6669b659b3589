#!/bin/sh
# Guess:   where a mapper interpolates scalars before it maps them (InterpolateScalarsBeforeMappingOn), the fragment
#          shader has the coordinate into the colour map in tcoordVCVSOutput, as coordinates of textures are named
#          there; code put in by vtkShaderProperty may read it.
# Happens: so it is up to VTK 9.2. From 9.3 on that coordinate is colorTCoordVCVSOutput, and tcoordVCVSOutput is
#          declared only if the data have texture coordinates besides. Neither class documents the name, and the
#          change is in no list of deprecated things: a shader replacement that was right does not compile, and the
#          actor vanishes with an error of the driver.
# Where:   whoever changes colours by position on the colour map (contour lines, fading, custom lights), and who
#          decides by vtkOpenGLPolyDataMapper::HaveTextures(), which counts the colour map in both versions.
# Seen:    vtk 9.2.6 and 9.6.2 from PyPI, under Xvfb, 2026-11-30.
set -eu
python=${PYTHON:-python3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/names.py" <<'PYTHON'
import re
import sys
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import VTK_OBJECT, vtkVersion
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

sphere = vtkSphereSource()
elevation = vtkElevationFilter()
elevation.SetInputConnection(sphere.GetOutputPort())
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(elevation.GetOutputPort())
mapper.InterpolateScalarsBeforeMappingOn()
actor = vtkActor()
actor.SetMapper(mapper)
texts = []


@calldata_type(VTK_OBJECT)
def note(_caller, _event, program):
    texts.append(program.GetFragmentShader().GetSource())


mapper.AddObserver("UpdateShaderEvent", note)
renderer = vtkRenderer()
renderer.AddActor(actor)
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.AddRenderer(renderer)
window.Render()
names = re.findall(r"in (?:float|vec2) (\w*[tT][cC]oord\w*);", texts[0])
print("VTK", vtkVersion.GetVTKVersion(), "declares", *names)
sys.exit(0 if names == [sys.argv[1]] else 1)
PYTHON
status=0
for pair in 9.2.6:tcoordVCVSOutput 9.6.2:colorTCoordVCVSOutput; do
  version=${pair%%:*}
  "$python" -m venv "$folder/$version"
  "$folder/$version/bin/pip" -q install "vtk==$version"
  xvfb-run -a "$folder/$version/bin/python" "$folder/names.py" "${pair#*:}" || status=1
done
[ "$status" = 0 ] && echo "as described" || echo "CHANGED: the header of this file is out of date"
exit "$status"
