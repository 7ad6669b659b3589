#!/bin/sh
# The ParaView plugin for the newest ParaView of Debian, inside of a lane:
#   bash Testing/Lanes/debian-testing.sh sh Testing/Lanes/paraview.sh
# There ParaView can be installed beside VTK's headers. Changes the system that it runs in: for lanes alone.
set -eu
cd "$(dirname "$0")/../.."
sh Module/packages.sh openmpi-bin xvfb paraview-dev python3-paraview
# ParaView's CMake files name its Python modules without the tag that Debian's have.
find /usr/lib/python3/dist-packages/paraview -name '*.cpython-*.so' | while read -r module; do
  [ -e "${module%%.cpython*}.so" ] || ln -s "$(basename "$module")" "${module%%.cpython*}.so"
done
VTKTERRAIN_PARAVIEW_BUILD_DIR=${VTKTERRAIN_BUILD_DIR:-build}/paraview
export VTKTERRAIN_PARAVIEW_BUILD_DIR
exec sh Testing/ParaView/run.sh /usr
